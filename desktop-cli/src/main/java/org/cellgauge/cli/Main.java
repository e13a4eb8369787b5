package org.cellgauge.cli;

import java.io.IOException;
import java.io.InputStream;
import java.io.PrintWriter;
import java.io.UncheckedIOException;
import java.time.Clock;
import java.time.DateTimeException;
import java.time.Instant;
import java.time.LocalDate;
import java.time.ZoneOffset;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Properties;
import java.util.concurrent.Callable;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.cellgauge.cell.InputRefusedException;
import org.cellgauge.desktop.BatchCheck;
import org.cellgauge.desktop.EarlyStart;
import org.cellgauge.desktop.LocalClock;
import org.cellgauge.desktop.MachineRefusal;
import picocli.CommandLine;
import picocli.CommandLine.IVersionProvider;
import picocli.CommandLine.MissingParameterException;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Model.OptionSpec;
import picocli.CommandLine.Model.UsageMessageSpec;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.ScopeType;
import picocli.CommandLine.UnmatchedArgumentException;

/** Entry point of the command {@code cellgauge}. */
public final class Main implements Callable<Integer> {
    /** Columns of help where no terminal says how many it has, and the most of one that does. */
    private static final int HELP_WIDTH = 80;
    private static final int NARROWEST = 60;
    private static final Pattern UNKNOWN_OPTION = Pattern.compile("Unknown option: '([^']*)'");
    /** The commands, in the order of the help. */
    private static final List<String> COMMANDS = List.of("check", "plan", "calibrate", "survey", "simulate", "validate",
            "reproduce", "camera", "families", "help");

    private final OptionSpec debug = OptionSpec.builder("--debug").type(boolean.class).scopeType(ScopeType.INHERIT)
            .description("Shows stack traces of internal errors and how long the stages take.").build();
    private CommandLine commandLine;

    /** The command without commands of its own, made by calls as {@link CheckCommand#spec} is. */
    private CommandSpec spec() {
        CommandSpec spec = CommandSpec.wrapWithoutInspection(this).name("cellgauge").versionProvider(new Version());
        spec.usageMessage().description("Honest uncertainties of camera and object poses in a robot cell.");
        spec.usageMessage().footer("", "A first call, from a clone:",
                "  cellgauge check --cell fixtures/lifted-4/cell.yaml \\",
                "      fixtures/lifted-4/photo.png",
                "'cellgauge help COMMAND' shows a command's options.");
        return StandardOptions.add(spec.addOption(debug));
    }

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
        // no option is a time or a database: to find out how such are read takes picocli a tenth of its start
        System.setProperty("picocli.converters.excludes", "java[.](time|sql)[.].*");
        List<String> words = Arrays.asList(args);
        if (words.contains("check")) {
            // names without this ending may be those of folders
            boolean decodes = words.stream().noneMatch(word -> word.toLowerCase(Locale.ROOT).endsWith(".png"));
            EarlyStart.begin(!words.contains("--json") || words.contains("--out"), decodes);
        }
        System.exit(run(commandLine(args), args));
    }

    /**
     * Executes a command line to its exit code: also where the virtual machine gives up, and where nobody takes what
     * was printed.
     *
     * @param commandLine of {@link #commandLine()}
     * @param args the arguments as typed
     * @return the exit code
     */
    static int run(CommandLine commandLine, String... args) {
        int code;
        try {
            code = commandLine.execute(args);
        } catch (Error e) {
            // picocli hands on no errors
            Main main = commandLine.getCommand();
            code = main.report(e, MachineRefusal.behind(e).isPresent() ? ExitCodes.INPUT_REFUSED
                    : ExitCodes.INTERNAL_ERROR, commandLine);
        }
        // a full disk or a closed pipe: print streams keep it to themselves
        if (commandLine.getOut().checkError() || System.out.checkError()) {
            commandLine.getErr().println("standard output: " + CommandRefusal.OUTPUT_LOST.english());
            commandLine.getErr().flush();
            return ExitCodes.moreSerious(code, ExitCodes.INPUT_REFUSED);
        }
        return code;
    }

    /**
     * The command line, ready to execute.
     *
     * @param args what it is to execute: where their first word is a command, the options of no other are made, which
     *     takes longer than anything else at the start
     * @return a new command line that answers every error with one message and an exit code
     */
    public static CommandLine commandLine(String... args) {
        Main main = new Main();
        main.commandLine = new CommandLine(main.spec());
        Optional<String> word = Arrays.stream(args).filter(arg -> !arg.startsWith("-")).findFirst();
        // help tells of all of them
        List<String> named = word.filter(COMMANDS::contains).filter(name -> !name.equals("help")).map(List::of)
                .orElse(COMMANDS);
        // a command line of its own, since only such a one asks what makes its settings' options
        named.forEach(name -> main.commandLine.addSubcommand(new CommandLine(command(name, main))));
        main.commandLine.setUsageHelpWidth(helpWidth(System.getenv("COLUMNS")));
        main.commandLine.setColorScheme(CommandLine.Help.defaultColorScheme(ansi(System.getenv())));
        // examples tell more than a list of all options
        main.commandLine.getSubcommands().values().forEach(Main::examplesFirst);
        // a photo may be called @args.png; its text is no option
        main.commandLine.setExpandAtFiles(false);
        // a mistyped option after "--detections FILE" must not pass for one more file
        main.commandLine.setUnmatchedOptionsAllowedAsOptionParameters(false);
        main.commandLine.setParameterExceptionHandler(new Errors(main));
        main.commandLine.setExecutionExceptionHandler(new Errors(main));
        return main.commandLine;
    }

    private static Object command(String name, Main main) {
        return switch (name) {
            case "check" -> CheckCommand.spec(main);
            case "plan" -> new PlanCommand();
            case "calibrate" -> new CalibrateCommand();
            case "survey" -> new SurveyCommand();
            case "simulate" -> new SimulateCommand();
            case "validate" -> new ValidateCommand();
            case "reproduce" -> new ReproduceCommand();
            case "camera" -> new CameraCommand();
            case "families" -> new FamiliesCommand();
            default -> new CommandLine.HelpCommand();
        };
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
        return Boolean.TRUE.equals(debug.getValue());
    }

    /**
     * Tells the user about an error on standard error, in a line.
     *
     * @param e the error
     * @param exitCode what it means
     * @param command the command it happened in
     * @return the exit code
     */
    int report(Throwable e, int exitCode, CommandLine command) {
        PrintWriter err = command.getErr();
        if (exitCode == ExitCodes.INTERNAL_ERROR) {
            err.println("Internal error: " + BatchCheck.inShort(e)
                    + (debug() ? "" : ". Run it again with --debug for the stack trace, and please report it."));
        } else {
            // one that is told of an input names it
            err.println(e instanceof InputRefusedException ? CommandWords.of(e)
                    : MachineRefusal.behind(e).map(CommandWords::of).orElseGet(() -> CommandWords.of(e)));
        }
        if (debug()) {
            e.printStackTrace(err);
        }
        err.flush();
        return exitCode;
    }

    /** Columns of help for what the environment says of the terminal's, which may be null or no number. */
    static int helpWidth(String columns) {
        return Math.max(NARROWEST, Math.min(HELP_WIDTH, columns(columns)));
    }

    /** Columns of the terminal for what the environment says of them, which may be null or no number. */
    static int columns(String columns) {
        try {
            return Math.max(NARROWEST, Integer.parseInt(columns));
        } catch (NumberFormatException e) {
            return HELP_WIDTH;
        }
    }

    /** Whether colours are shown: by a terminal that can, where the user has not asked for none. */
    static CommandLine.Help.Ansi ansi(Map<String, String> environment) {
        // picocli asks for a terminal itself, but takes a dumb one for able
        return environment.containsKey("NO_COLOR") || isDumb(environment) ? CommandLine.Help.Ansi.OFF
                : CommandLine.Help.Ansi.AUTO;
    }

    /** Whether standard error is a terminal on which a line can be rewritten; the start script knows, Java does not. */
    static boolean isTerminal(Map<String, String> environment) {
        return Boolean.getBoolean("cellgauge.terminal") && !isDumb(environment);
    }

    private static boolean isDumb(Map<String, String> environment) {
        return "dumb".equals(environment.get("TERM"));
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

    /**
     * The day of today, for results. Where {@code SOURCE_DATE_EPOCH} (seconds since 1970, UTC) is set, as builds that
     * are to be repeated set it, that day.
     *
     * @return as in {@code 2026-11-28}
     */
    static String day() {
        return day(System.getenv("SOURCE_DATE_EPOCH"), LocalClock.now());
    }

    static String day(String epochSeconds, Clock clock) {
        try {
            return epochSeconds == null ? LocalDate.now(clock).toString()
                    : LocalDate.ofInstant(Instant.ofEpochSecond(Long.parseLong(epochSeconds)), ZoneOffset.UTC)
                            .toString();
        } catch (NumberFormatException | DateTimeException e) {
            return LocalDate.now(clock).toString();
        }
    }

    /** Answers errors. A class, since lambdas of these interfaces keep picocli out of the archive of classes. */
    private record Errors(Main main) implements CommandLine.IParameterExceptionHandler,
            CommandLine.IExecutionExceptionHandler {
        @Override
        public int handleParseException(ParameterException e, String[] args) {
            return usage(e, args);
        }

        @Override
        public int handleExecutionException(Exception e, CommandLine command, CommandLine.ParseResult parsed) {
            return main.report(e, e instanceof InputRefusedException || MachineRefusal.behind(e).isPresent()
                    ? ExitCodes.INPUT_REFUSED : ExitCodes.INTERNAL_ERROR, command);
        }
    }

    /** The version as {@code --version} shows it. */
    static final class Version implements IVersionProvider {
        @Override
        public String[] getVersion() {
            return new String[] {"cellgauge " + version()};
        }
    }
}
