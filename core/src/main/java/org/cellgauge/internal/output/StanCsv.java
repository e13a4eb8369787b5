package org.cellgauge.internal.output;

import java.io.IOException;
import java.util.List;
import org.cellgauge.check.CheckResult;
import org.cellgauge.internal.statistics.Angles;
import org.cellgauge.sampling.Draws;
import org.cellgauge.sampling.QuantityLayout;
import org.cellgauge.settings.CheckSettings;

/**
 * The kept draws of a chain as Stan's command line writes them ("Stan CSV", CmdStan User's Guide, chapter "Stan CSV
 * File Format"): comment lines, a line of names, one line per draw, comment lines about time. Tools of the field read
 * it: CmdStanPy by {@code from_csv}, of which ArviZ takes draws by {@code from_cmdstanpy}, and older ArviZ by itself by
 * {@code from_cmdstan}.
 */
public final class StanCsv {
    private StanCsv() {
    }

    /**
     * Writes one chain. Angles are within half a turn of their reference direction, which is the same for all chains:
     * draws to both sides of half a turn stay together, beyond pi where need be, so that their mean and deviation are
     * those of plain numbers. Numbers keep every digit. Of more draws than asked for every second, third, … is written,
     * as Stan thins; the result's figures rest on all of them.
     *
     * @param result what a check found
     * @param chain which chain, from 1
     * @param inputName name of the photo or detections file
     * @param version version of this program
     * @param mostDraws how many draws are written at most, positive
     * @param out receives the text; not closed
     * @throws IOException if {@code out} throws it
     * @throws IndexOutOfBoundsException if there is no such chain
     */
    public static void write(CheckResult result, int chain, String inputName, String version, int mostDraws,
            Appendable out) throws IOException {
        Draws draws = result.draws().get(chain - 1);
        CheckSettings settings = result.settings();
        int thin = thin(draws.count(), mostDraws);
        comment(out, "program = cellgauge");
        comment(out, "program_version = " + version);
        comment(out, "model = " + settings.model().likelihood().word());
        comment(out, "method = sample (Default)");
        comment(out, "  sample");
        comment(out, "    num_samples = " + draws.count());
        comment(out, "    num_warmup = " + result.warmup());
        comment(out, "    save_warmup = false (Default)");
        comment(out, "    thin = " + thin + (thin == 1 ? " (Default)" : ""));
        // to its readers, all that Stan does not adapt itself: others are to report steps and metric of its own sampler
        comment(out, "    algorithm = fixed_param");
        comment(out, "id = " + chain);
        comment(out, "data");
        comment(out, "  file = " + inputName);
        comment(out, "random");
        comment(out, "  seed = " + settings.sampling().seed());
        if (thin > 1) {
            comment(out, "every " + thin + ". draw is written; the figures of the result rest on all");
        }
        comment(out, "sampler = " + result.samplerUsed().word());
        comment(out, "verdict = " + result.verdict().key());
        QuantityLayout layout = result.layout();
        List<String> names = layout.names();
        out.append(String.join(",", names)).append('\n');
        StringBuilder line = new StringBuilder();
        for (int i = 0; i < draws.count(); i += thin) {
            line.setLength(0);
            for (int q = 0; q < names.size(); q++) {
                double value = draws.get(q, i);
                line.append(q == 0 ? "" : ",")
                        .append(number(layout.isAngle(q) ? unwrapped(value, layout.referenceRad(q)) : value));
            }
            out.append(line.append('\n'));
        }
        // readers know by these lines that a file is whole; times are not measured, since files are the same each time
        comment(out, "");
        comment(out, " Elapsed Time: 0 seconds (Warm-up)");
        comment(out, "               0 seconds (Sampling)");
        comment(out, "               0 seconds (Total)");
        comment(out, "");
    }

    /**
     * How a chain is thinned.
     *
     * @param draws how many it has
     * @param mostDraws how many are written at most, positive
     * @return every how-manieth is written
     */
    public static int thin(int draws, int mostDraws) {
        return Math.max(1, (int) (((long) draws + mostDraws - 1) / mostDraws));
    }

    /** An angle within half a turn of a direction, rad; one that is there as it is in (-pi, pi] keeps its digits. */
    static double unwrapped(double angleRad, double directionRad) {
        double angle = Angles.wrapToPi(angleRad);
        double off = angle - Angles.wrapToPi(directionRad);
        return off > Math.PI ? angle - 2 * Math.PI : off <= -Math.PI ? angle + 2 * Math.PI : angle;
    }

    private static void comment(Appendable out, String text) throws IOException {
        out.append("# ").append(text.replaceAll("\\p{Cntrl}", " ")).append('\n');
    }

    private static String number(double value) {
        if (Double.isNaN(value)) {
            return "nan";
        }
        return Double.isInfinite(value) ? value > 0 ? "inf" : "-inf" : Double.toString(value);
    }
}
