@echo off
rem Starts CellGauge from its installation: this file's folder is beside lib\.
rem
rem   JAVA_HOME               the Java to use (17 or newer); else the one on the PATH
rem   CELLGAUGE_JVM_OPTIONS   more options for the virtual machine, such as -Xmx4g
rem
rem Paths stand between quotes wherever they are put in: they may hold blanks, (x86), an ampersand.
setlocal EnableExtensions DisableDelayedExpansion
set "lib=%~dp0..\lib"
if not "%lib:;=%" == "%lib%" (
    echo cellgauge: it is installed in "%lib%", and Java finds nothing in a folder with a semicolon in its name. 1>&2
    echo cellgauge: Move it, or give the folder another name. 1>&2
    exit /b 1
)
set "java=java.exe"
if defined JAVA_HOME set "java=%JAVA_HOME:"=%\bin\java.exe"
if not exist "%java%" set "java=java.exe"
rem The option is one that Java knows from 17 on: with an older one this fails as it does without any.
"%java%" --enable-native-access=ALL-UNNAMED -version >nul 2>&1
if errorlevel 1 (
    echo cellgauge: needs Java 17 or newer. Install it, or point JAVA_HOME at it. 1>&2
    exit /b 1
)
"%java%" -XX:+UseSerialGC -Xlog:disable -Xlog:all=error:stderr -Djava.awt.headless=true %CELLGAUGE_JVM_OPTIONS% ^
    -cp "%lib%\*" org.cellgauge.cli.Main %*
exit /b %errorlevel%
