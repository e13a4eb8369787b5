@echo off
rem Starts CellGauge from its installation: this file's folder is beside lib\.
rem
rem   JAVA_HOME               the Java to use (17 or newer); else the one on the PATH
rem   CELLGAUGE_JVM_OPTIONS   more options for the virtual machine, such as -Xmx4g
setlocal
set "lib=%~dp0..\lib"
set "java=java.exe"
if defined JAVA_HOME set "java=%JAVA_HOME%\bin\java.exe"
"%java%" -version >nul 2>&1
if errorlevel 1 (
    echo cellgauge: needs Java 17 or newer. Install it, or point JAVA_HOME at it. 1>&2
    exit /b 1
)
"%java%" -XX:+UseSerialGC -Xlog:disable -Xlog:all=error:stderr -Djava.awt.headless=true %CELLGAUGE_JVM_OPTIONS% ^
    -cp "%lib%\*" org.cellgauge.cli.Main %*
exit /b %errorlevel%
