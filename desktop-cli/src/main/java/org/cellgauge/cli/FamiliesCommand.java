package org.cellgauge.cli;

import java.io.PrintWriter;
import java.util.concurrent.Callable;
import org.cellgauge.cell.MarkerFamily;
import org.cellgauge.desktop.TextTable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Spec;

/** {@code cellgauge families}: the marker families that a cell file may name. */
@Command(name = "families", mixinStandardHelpOptions = true, versionProvider = Main.Version.class,
        description = {"Lists the marker families that a cell file may name, with the ids of each.", "", "Example:",
            "  cellgauge families", ""})
public final class FamiliesCommand implements Callable<Integer> {
    @Spec
    private CommandSpec spec;

    /**
     * Prints the families.
     *
     * @return the exit code
     */
    @Override
    public Integer call() {
        TextTable table = new TextTable(2);
        table.row("family", "ids", "without");
        for (MarkerFamily family : MarkerFamily.all()) {
            int without = 0;
            for (int id = 0; id < family.size(); id++) {
                without += family.isAmbiguous(id) ? 1 : 0;
            }
            table.row(family.toString(), "0 to " + (family.size() - 1), without == 0 ? "" : String.valueOf(without));
        }
        PrintWriter out = spec.commandLine().getOut();
        out.print(table.text(""));
        out.println("Without: ids whose pattern another id has as well, which a cell may not use.");
        out.flush();
        return ExitCodes.OK;
    }
}
