package org.cellgauge.cli;

import java.io.IOException;
import java.io.InputStream;
import java.io.PrintWriter;
import java.io.UncheckedIOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Properties;
import java.util.concurrent.Callable;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.cellgauge.cell.InputRefusedException;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.IVersionProvider;
import picocli.CommandLine.MissingParameterException;
import picocli.CommandLine.Model.UsageMessageSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.ScopeType;
import picocli.CommandLine.UnmatchedArgumentException;

/** Entry point of the command {@code cellgauge}. */
@Command(name = "cellgauge", mixinStandardHelpOptions = true, versionProvider = Main.Version.class,
        description = "Honest uncertainties of camera and object poses in a robot cell.",
        subcommands = {CheckCommand.class, SimulateCommand.class, ValidateCommand.class, FamiliesCommand.class,
            CommandLine.HelpCommand.class},
        footer = {"", "A first call, from a clone:",
            "  cellgauge check --cell fixtures/lifted-4/cell.yaml \\",
            "      fixtures/lifted-4/photo.png",
            "'cellgauge help COMMAND' shows a command's options."})
public final class Main implements Callable<Integer> {
    /** Columns of help where no terminal says how many it has, and the most of one that does. */
    private static final int HELP_WIDTH = 80;
    private static final int NARROWEST = 60;
    private static final Pattern UNKNOWN_OPTION = Pattern.compile("Unknown option: '([^']*)'");

    @Option(names = "--debug", scope = ScopeType.INHERIT,
            description = "Shows stack traces of internal errors and how long the stages take.")
    private boolean debug;

    private CommandLine commandLine;

    /**
     * Without a command there is nothing to do: shows what there is.
     *
     * @return the code of a usage error, since a script that calls so has lost its words
     */
    @Override
    public Integer call() {
        commandLine.usage(commandLine.getErr());
        return ExitCodes.USAGE;
    }

    /**
     * Runs the command line and ends the process with its exit code.
     *
     * @param args the arguments as typed
     */
    public static void main(String[] args) {
        System.exit(commandLine().execute(args));
    }

    /**
     * The command line, ready to execute.
     *
     * @return a new command line that answers every error with one message and an exit code
     */
    public static CommandLine commandLine() {
        Main main = new Main();
        main.commandLine = new CommandLine(main);
        main.commandLine.setUsageHelpWidth(helpWidth(System.getenv("COLUMNS")));
        main.commandLine.setColorScheme(CommandLine.Help.defaultColorScheme(ansi(System.getenv())));
        // examples tell more than a list of all options
        main.commandLine.getSubcommands().values().forEach(Main::examplesFirst);
        // a mistyped option after "--detections FILE" must not pass for one more file
        main.commandLine.setUnmatchedOptionsAllowedAsOptionParameters(false);
        main.commandLine.setParameterExceptionHandler(Main::usage);
        main.commandLine.setExecutionExceptionHandler((e, command, parsed) -> main.report(e,
                e instanceof InputRefusedException ? ExitCodes.INPUT_REFUSED : ExitCodes.INTERNAL_ERROR, command));
        return main.commandLine;
    }

    private static int usage(ParameterException e, String[] args) {
        CommandLine command = e.getCommandLine();
        PrintWriter err = command.getErr();
        String unknown = unknownOption(e, args);
        if (unknown != null) {
            // what else picocli has to say follows from the unknown option, and hides its suggestions
            err.println("Unknown option: '" + unknown + "'");
            UnmatchedArgumentException.printSuggestions(
                    new UnmatchedArgumentException(command, List.of(unknown)), err);
        } else if (command.getParent() == null && e instanceof UnmatchedArgumentException unmatched) {
            err.println("Unknown command: '" + unmatched.getUnmatched().get(0) + "'");
            UnmatchedArgumentException.printSuggestions(e, err);
        } else {
            err.println(e.getMessage());
            UnmatchedArgumentException.printSuggestions(e, err);
        }
        err.println("Try '" + command.getCommandSpec().qualifiedName() + " --help'.");
        err.flush();
        return ExitCodes.USAGE;
    }

    /** The unknown option that an error is about or that is behind it; null where there is none. */
    private static String unknownOption(ParameterException e, String[] args) {
        Matcher named = UNKNOWN_OPTION.matcher(e.getMessage());
        if (named.lookingAt()) {
            return named.group(1);
        }
        // an option that is missing may be there, mistyped
        return e instanceof MissingParameterException ? Arrays.stream(args)
                .filter(word -> word.startsWith("--") && word.length() > 2)
                .map(word -> word.replaceFirst("=.*", ""))
                .filter(word -> e.getCommandLine().getCommandSpec().findOption(word) == null)
                .findFirst().orElse(null) : null;
    }

    /** Whether stack traces and times are wanted. */
    boolean debug() {
        return debug;
    }

    /**
     * Tells the user about an error on standard error, in a line.
     *
     * @param e the error
     * @param exitCode what it means
     * @param command the command it happened in
     * @return the exit code
     */
    int report(Exception e, int exitCode, CommandLine command) {
        PrintWriter err = command.getErr();
        if (exitCode == ExitCodes.INTERNAL_ERROR) {
            err.println("Internal error: " + inShort(e)
                    + (debug ? "" : ". Run it again with --debug for the stack trace, and please report it."));
        } else {
            err.println(CommandWords.of(e));
        }
        if (debug) {
            e.printStackTrace(err);
        }
        err.flush();
        return exitCode;
    }

    /** An unexpected error in a line. */
    static String inShort(Throwable e) {
        String message = e.getMessage() == null ? "" : ": " + e.getMessage().replaceAll("\\p{Cntrl}", " ");
        return e.getClass().getSimpleName() + message;
    }

    /** Columns of help for what the environment says of the terminal's, which may be null or no number. */
    static int helpWidth(String columns) {
        try {
            return Math.max(NARROWEST, Math.min(HELP_WIDTH, Integer.parseInt(columns)));
        } catch (NumberFormatException e) {
            return HELP_WIDTH;
        }
    }

    /** Whether colours are shown: by a terminal that can, where the user has not asked for none. */
    static CommandLine.Help.Ansi ansi(Map<String, String> environment) {
        // picocli asks for a terminal itself, but takes a dumb one for able
        return environment.containsKey("NO_COLOR") || "dumb".equals(environment.get("TERM"))
                ? CommandLine.Help.Ansi.OFF : CommandLine.Help.Ansi.AUTO;
    }

    private static void examplesFirst(CommandLine command) {
        List<String> keys = new ArrayList<>(command.getHelpSectionKeys());
        keys.remove(UsageMessageSpec.SECTION_KEY_SYNOPSIS_HEADING);
        keys.remove(UsageMessageSpec.SECTION_KEY_SYNOPSIS);
        int description = keys.indexOf(UsageMessageSpec.SECTION_KEY_DESCRIPTION);
        keys.addAll(description + 1, List.of(UsageMessageSpec.SECTION_KEY_SYNOPSIS_HEADING,
                UsageMessageSpec.SECTION_KEY_SYNOPSIS));
        command.setHelpSectionKeys(keys);
        command.getCommandSpec().usageMessage().abbreviateSynopsis(true);
    }

    /** A word in the colour of its meaning, where a terminal shows it and the user has not asked for none. */
    static String coloured(String word, int exitCode) {
        String colour = exitCode == ExitCodes.OK ? "fg(green),bold"
                : exitCode == ExitCodes.TARGET_MISSED ? "fg(red),bold" : "fg(yellow),bold";
        return ansi(System.getenv()).string("@|" + colour + " " + word + "|@");
    }

    /**
     * The version the build wrote into the library.
     *
     * @return for instance {@code 0.1.0}
     */
    static String version() {
        Properties properties = new Properties();
        try (InputStream in = Main.class.getResourceAsStream("/org/cellgauge/version.properties")) {
            properties.load(in);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        return properties.getProperty("version");
    }

    /** The version as {@code --version} shows it. */
    static final class Version implements IVersionProvider {
        @Override
        public String[] getVersion() {
            return new String[] {"cellgauge " + version()};
        }
    }
}
