package org.cellgauge.cli;

import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.Callable;
import org.cellgauge.desktop.ResultFolder;
import org.cellgauge.desktop.StopSignal;
import org.cellgauge.desktop.reproduce.Reproduction;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.ParentCommand;
import picocli.CommandLine.Spec;

/** {@code cellgauge reproduce}: the experiments of the thesis, as it ran them and as they should be. */
@Command(name = "reproduce", mixinStandardHelpOptions = true, sortOptions = false,
        versionProvider = Main.Version.class,
        description = {"Runs the experiments of the thesis again: with its own algorithm and settings, its posterior "
                + "until the chains have converged, and the default. Writes a page with pictures.", "", "Examples:",
            "  cellgauge reproduce",
            "  cellgauge reproduce 8.8",
            "  cellgauge reproduce 9.1 conclusions --quick",
            "  cellgauge reproduce --list",
            ""},
        footer = {"",
            "A run that was stopped goes on where it was: figures are kept in DIR/thesis/figures, by what made them.",
            "Exit codes: 0 done, 1 internal error, 2 usage, 3 input refused."})
public final class ReproduceCommand implements Callable<Integer> {
    private static final Path DEFAULT_FOLDER = Path.of("cellgauge-out");

    @Spec
    private CommandSpec spec;

    @ParentCommand
    private Main main;

    @Parameters(paramLabel = "TABLE", arity = "0..*",
            description = "Tables by their numbers, or other parts (--list): printed on standard output, and nothing "
                    + "else run than what they rest on. Without any, the whole page is written.")
    private List<String> tables = new ArrayList<>();

    @Option(names = "--quick",
            description = "Four chains in place of twenty, exact corners in place of rendered photos, and deviations "
                    + "to 20 %% in place of 2 %%: a look.")
    private boolean quick;

    @Option(names = "--out", paramLabel = "DIR",
            description = "Folder for thesis.md, its pictures and the figures that are kept. Default: cellgauge-out")
    private Path out = DEFAULT_FOLDER;

    @Option(names = "--threads", paramLabel = "N",
            description = "Number of threads; no figure depends on it. Default: all cores")
    private int threads = Runtime.getRuntime().availableProcessors();

    @Option(names = "--list", description = "Lists what can be asked for, and runs nothing.")
    private boolean list;

    /**
     * Runs the experiments.
     *
     * @return the exit code
     */
    @Override
    public Integer call() {
        Reproduction reproduction = new Reproduction(quick, out, Main.version());
        Map<String, String> parts = reproduction.parts();
        PrintWriter stdout = spec.commandLine().getOut();
        if (list) {
            parts.forEach((id, title) -> stdout.println(String.format(Locale.ROOT, "%-15s %s", id, title)));
            stdout.flush();
            return ExitCodes.OK;
        }
        if (threads < 1) {
            throw new ParameterException(spec.commandLine(), "--threads: must be at least 1, not " + threads);
        }
        for (String table : tables) {
            if (!parts.containsKey(table)) {
                throw new ParameterException(spec.commandLine(), "'" + table
                        + "' is no table of chapters 7 to 9, nor another part; --list names them all");
            }
        }
        StopSignal stop = new StopSignal();
        StopOnShutdown onShutdown = new StopOnShutdown(stop);
        try (onShutdown) {
            return run(reproduction, stop, stdout);
        } catch (ResultFolder.UnwritableException e) {
            return main.report(e, ExitCodes.INPUT_REFUSED, spec.commandLine());
        }
    }

    private int run(Reproduction reproduction, StopSignal stop, PrintWriter stdout) {
        Optional<String> printed;
        if (tables.isEmpty()) {
            printed = reproduction.page(threads, stop, this::progress).map(page -> page + System.lineSeparator());
        } else {
            printed = reproduction.text(tables, threads, stop, this::progress);
        }
        stdout.print(printed.orElse(""));
        stdout.flush();
        if (printed.isEmpty()) {
            spec.commandLine().getErr().println("Stopped; the same command does the rest.");
            spec.commandLine().getErr().flush();
        }
        return ExitCodes.OK;
    }

    private void progress(String name, int number, int count, double seconds) {
        PrintWriter err = spec.commandLine().getErr();
        err.println("[" + number + "/" + count + "] " + name
                + (seconds == 0 ? " (kept)" : String.format(Locale.ROOT, " (%.1f s)", seconds)));
        err.flush();
    }
}
