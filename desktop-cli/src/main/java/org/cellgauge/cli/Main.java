package org.cellgauge.cli;

import java.io.IOException;
import java.io.InputStream;
import java.util.Properties;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.IVersionProvider;

/** Entry point of the command {@code cellgauge}. */
@Command(name = "cellgauge", mixinStandardHelpOptions = true, versionProvider = Main.Version.class,
        description = "Honest uncertainties of camera and object poses in a robot cell.",
        subcommands = {SimulateCommand.class})
public final class Main implements Runnable {

    /** Prints the usage: the program needs a command to do anything. */
    @Override
    public void run() {
        CommandLine.usage(this, System.err);
    }

    /**
     * Runs the command line and ends the process with its exit code.
     *
     * @param args the arguments as typed
     */
    public static void main(String[] args) {
        System.exit(new CommandLine(new Main()).execute(args));
    }

    /** Reads the version the build wrote into the library. */
    static final class Version implements IVersionProvider {
        @Override
        public String[] getVersion() throws IOException {
            Properties properties = new Properties();
            try (InputStream in = Main.class.getResourceAsStream("/org/cellgauge/version.properties")) {
                properties.load(in);
            }
            return new String[] {"cellgauge " + properties.getProperty("version")};
        }
    }
}
