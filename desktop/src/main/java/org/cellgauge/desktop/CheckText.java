package org.cellgauge.desktop;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.OptionalDouble;
import org.cellgauge.cell.Target;
import org.cellgauge.check.Conformity;
import org.cellgauge.check.Verdict;
import org.cellgauge.estimate.VarianceSource;
import org.cellgauge.internal.warning.Decimal;
import org.cellgauge.light.ToneCurve;
import org.cellgauge.output.BudgetShare;
import org.cellgauge.output.ChainsView;
import org.cellgauge.output.LaplaceView;
import org.cellgauge.output.ModeView;
import org.cellgauge.output.MovedObject;
import org.cellgauge.output.NoiseView;
import org.cellgauge.output.ReferenceFitView;
import org.cellgauge.output.ReferencesView;
import org.cellgauge.output.ResultRow;
import org.cellgauge.output.ResultView;
import org.cellgauge.output.RunView;
import org.cellgauge.output.WarningView;
import org.cellgauge.output.WithoutView;
import org.cellgauge.sampling.AcceptanceCount;
import org.cellgauge.vision.PhotoLight;

/** A result in words and aligned columns, for people; ASCII, so that every terminal shows it. */
public final class CheckText {
    private static final int WIDTH = 100;
    private static final double NEGLIGIBLE_SHARE = 0.005;
    private static final int MOST_GAINS = 3;

    private static final String EXACT_CAMERA = "Camera: its intrinsics are taken as exact; with a camera file of "
            + "cellgauge calibrate their uncertainty is in the figures";

    private CheckText() {
    }

    /** The word of a verdict as people read it; what asks for attention stands in capitals. */
    public static String word(Verdict verdict) {
        switch (verdict) {
            case PASS:
                return "pass";
            case FAIL:
                return "FAIL";
            case NOT_CONVERGED:
                return "NOT CONVERGED";
            case AMBIGUOUS:
                return "AMBIGUOUS";
            case CONTRADICTED:
                return "CONTRADICTED";
            default:
                return "no target";
        }
    }

    /** Words that stand beside every figure that must not be trusted; empty where all may be. */
    public static String caution(Verdict verdict) {
        return verdict == Verdict.NOT_CONVERGED ? "not converged" : verdict == Verdict.AMBIGUOUS ? "ambiguous"
                : verdict == Verdict.CONTRADICTED ? "contradicted" : "";
    }

    /** Whether one row's deviations are within the target: a word, or a caution where no figure can be trusted. */
    public static String mark(ResultRow row) {
        switch (row.verdict()) {
            case PASS:
                return "pass";
            case FAIL:
                return "FAIL";
            default:
                return caution(row.verdict());
        }
    }

    /** What a row of objects and gripping points is called. */
    public static String name(ResultRow row) {
        return row.kind() == ResultRow.Kind.GRIP ? "its gripping point" : "object " + row.id().getAsInt();
    }

    /**
     * The whole result.
     *
     * @param view what a result says
     * @return lines of text, each ended by a line feed
     */
    public static String of(ResultView view) {
        StringBuilder text = new StringBuilder();
        String caution = caution(view.verdict());
        String beside = caution.isEmpty() ? "" : " - " + caution.toUpperCase(Locale.ROOT);
        if (view.showsFigures()) {
            camera(view, beside, text);
            if (!view.objects().isEmpty()) {
                objects(view, beside, text);
            }
            if (view.objects().stream().anyMatch(ResultRow::seen)) {
                budgets(view, text);
            }
            modes(view, text);
        }
        advice(view, text);
        references(view, text);
        text.append('\n').append(diagnosticsLine(view)).append('\n').append(acceptanceLine(view)).append('\n')
                .append(laplaceLine(view)).append('\n');
        if (view.light() != null) {
            text.append(wrap("Light: " + light(view), "        "));
        }
        for (String line : noiseLines(view).split("\n")) {
            text.append(wrap(line, "        "));
        }
        if (view.intrinsics().isEmpty()) {
            text.append(wrap(EXACT_CAMERA, "        "));
        }
        if (!view.warnings().isEmpty()) {
            text.append("\nWarnings\n");
            for (WarningView warning : view.warnings()) {
                text.append(wrap("  - " + warning.text(), "    "));
            }
        }
        return text.toString();
    }

    private static void advice(ResultView view, StringBuilder text) {
        if (!view.advice().isEmpty()) {
            text.append("\nWhat would meet the target, cheapest first (forecast; cellgauge plan tells more)\n");
            view.advice().forEach(a -> text.append(wrap("  - " + a.line(), "    ")));
        }
    }

    /** What is known of the corners themselves. */
    public static String noiseLines(ResultView view) {
        NoiseView noise = view.noise();
        StringBuilder text = new StringBuilder();
        text.append(String.format(Decimal.POINT, "Corners: %.3f px", noise.usualStdPx()));
        double[] added = noise.addedQuantilesStdPx();
        if (noise.stated()) {
            text.append(" as stated");
            if (noise.holds() != null) {
                text.append(String.format(Decimal.POINT, "; markers are square to %.3f px (chi-square %.1f of %d, p "
                        + "%s)%s", noise.shownStdPx(), noise.chiSquare(), noise.degreesOfFreedom(), p(noise.pValue()),
                        noise.holds() ? "" : ": NOT AS STATED"));
            }
        } else if (added != null) {
            text.append(String.format(Decimal.POINT,
                    ", of which not told by the detector %.3f px (95 %%: %.3f to %.3f)",
                    added[1], added[0], added[2]));
        } else {
            text.append(" as this photo tells");
        }
        text.append('\n');
        ReferencesView references = view.references();
        if (references.fitTogether() != null) {
            text.append(String.format(Decimal.POINT, "References together: chi-square %.1f of %d, p %s%s\n",
                    references.chiSquare(), references.degreesOfFreedom(), p(references.pValue()),
                    references.fitTogether() ? "" : ": NOT AS STATED"));
        }
        double[] edges = noise.edgeShiftPx();
        if (edges != null) {
            text.append(String.format(Decimal.POINT, "Edges: %s px into the dark, std %.3f px; by inner edges alone %s "
                    + "px, std %.3f px\n", signed3(edges[3]), edges[4], signed3(edges[1]), edges[2]));
        }
        return text.toString();
    }

    private static String p(double value) {
        return value < 0.001 ? "below 0.001" : fixed(value, 3);
    }

    private static String signed3(double value) {
        return String.format(Decimal.POINT, "%+.3f", value);
    }

    private static void camera(ResultView view, String beside, StringBuilder text) {
        text.append("\nCamera in world").append(beside).append('\n');
        TextTable table = new TextTable(1);
        table.row("", "x mm", "y mm", "z mm", "psi deg", "theta deg", "phi deg");
        String[] mean = {"mean", "", "", "", "", "", ""};
        String[] std = {"std", "", "", "", "", "", ""};
        double[] m = view.camera().mean();
        double[] s = view.camera().std();
        for (int i = 0; i < 6; i++) {
            mean[i + 1] = i < 3 ? fixed(m[i], 2) : fixed(Math.toDegrees(m[i]), 3);
            std[i + 1] = i < 3 ? fixed(s[i], 2) : fixed(Math.toDegrees(s[i]), 3);
        }
        text.append(table.row(mean).row(std).text("  "));
        if (!view.intrinsics().isEmpty()) {
            text.append("\nIntrinsics").append(beside).append('\n');
            TextTable intrinsics = new TextTable(1).row("", "mean", "std", "mean before", "std before", "");
            for (ResultView.Intrinsic intrinsic : view.intrinsics()) {
                intrinsics.row(intrinsic.name(), significant(intrinsic.mean(), 6), significant(intrinsic.std(), 3),
                        significant(intrinsic.priorMean(), 6), priorStd(intrinsic), intrinsic.restsOn());
            }
            text.append(intrinsics.text("  "));
        }
    }

    /** How well an intrinsic was known before the photo was seen. */
    static String priorStd(ResultView.Intrinsic intrinsic) {
        return Double.isNaN(intrinsic.priorStd()) ? "flat" : significant(intrinsic.priorStd(), 3);
    }

    private static void objects(ResultView view, String beside, StringBuilder text) {
        Target target = view.target();
        text.append("\nObjects in world, mm").append(against(target)).append(beside).append('\n');
        TextTable table = new TextTable(1);
        table.row("", "x", "y", "z", "std x", "std y", "std z", target.isAny() ? "target" : "");
        for (ResultRow row : view.points()) {
            String name = row.kind() == ResultRow.Kind.GRIP ? "  " + name(row) : name(row);
            if (!row.seen()) {
                table.row(name, "-", "-", "-", "-", "-", "-", "not seen");
                continue;
            }
            double[] mean = row.mean();
            double[] std = row.std();
            table.row(name, fixed(mean[0], 2), fixed(mean[1], 2), fixed(mean[2], 2), fixed(std[0], 2),
                    fixed(std[1], 2), fixed(std[2], 2), mark(row));
        }
        text.append(table.text("  "));
        tolerances(view, text);
    }

    /** What the objects are held against, after what stands before it; empty where there is no target. */
    static String against(Target target) {
        OptionalDouble std = target.oneStdMm();
        return std.isPresent() ? ", against a target std of " + plain(std.getAsDouble()) + " mm"
                : target.isAny() ? ", against " + target : "";
    }

    private static void tolerances(ResultView view, StringBuilder text) {
        if (!view.target().asksForProbability()) {
            return;
        }
        text.append("\nProbability of being within tolerance\n");
        TextTable table = new TextTable(1);
        table.row("", "tolerance", "probability", "MC error", "asked", "");
        for (ResultRow row : view.points()) {
            for (Conformity c : row.conformities()) {
                table.row(name(row), tolerance(c), fixed(c.probability(), 4), fixed(c.mcse(), 4), plain(c.asked()),
                        standing(row, c));
            }
        }
        text.append(table.text("  "));
    }

    /** A tolerance in words. */
    static String tolerance(Conformity c) {
        return switch (c.of()) {
            case X, Y, Z -> c.of().key() + " within " + plain(c.tolerance()) + " mm";
            case DISTANCE -> "within " + plain(c.tolerance()) + " mm";
            case TURN -> "turned by " + plain(c.tolerance()) + " deg";
        };
    }

    /** How a probability stands against the one asked for: a guard band of twice its Monte Carlo error is left. */
    static String standing(ResultRow row, Conformity c) {
        String caution = caution(row.verdict());
        return !caution.isEmpty() ? caution : !c.isDecided() ? "undecided" : c.isKept() ? "pass" : "FAIL";
    }

    private static void budgets(ResultView view, StringBuilder text) {
        text.append("\nWhere the variance comes from\n");
        for (ResultRow row : view.points()) {
            if (row.seen()) {
                budget(row, text);
            }
        }
    }

    private static void budget(ResultRow row, StringBuilder text) {
        Map<VarianceSource, Double> shares = new LinkedHashMap<>();
        Map<VarianceSource, Double> gained = new LinkedHashMap<>();
        for (BudgetShare part : row.budget()) {
            shares.put(part.source(), part.share());
            if (!Double.isNaN(part.gain())) {
                gained.put(part.source(), part.gain());
            }
        }
        text.append(wrap("  " + name(row) + ": " + sources(shares), "    "));
        List<String> gains = new ArrayList<>();
        for (Map.Entry<VarianceSource, Double> e : falling(gained)) {
            if (gains.size() < MOST_GAINS && e.getValue() >= NEGLIGIBLE_SHARE) {
                gains.add((e.getKey().referenceId().isPresent()
                        ? "reference " + e.getKey().referenceId().getAsInt() + " placed exactly "
                        : "no " + e.getKey().key() + " ") + percent(e.getValue()));
            }
        }
        if (!gains.isEmpty()) {
            text.append(wrap("    what would take most off the deviation: " + String.join(", ", gains), "      "));
        }
    }

    /** Sources by falling share, those of one kind together, those below half a percent left out. */
    public static String sources(Map<VarianceSource, Double> shares) {
        Map<String, Double> kinds = new LinkedHashMap<>();
        Map<String, List<String>> parts = new LinkedHashMap<>();
        for (Map.Entry<VarianceSource, Double> e : falling(shares)) {
            String kind = e.getKey().key();
            if (e.getKey().referenceId().isPresent()) {
                kind = "placement of references";
                if (e.getValue() >= NEGLIGIBLE_SHARE) {
                    parts.computeIfAbsent(kind, k -> new ArrayList<>())
                            .add(e.getKey().referenceId().getAsInt() + ": " + percent(e.getValue()));
                }
            }
            kinds.merge(kind, e.getValue(), Double::sum);
        }
        List<String> words = new ArrayList<>();
        for (Map.Entry<String, Double> e : falling(kinds)) {
            if (e.getValue() >= NEGLIGIBLE_SHARE) {
                String detail = parts.containsKey(e.getKey())
                        ? " (" + String.join(", ", parts.get(e.getKey())) + ")" : "";
                words.add(e.getKey() + " " + percent(e.getValue()) + detail);
            }
        }
        return String.join(", ", words);
    }

    private static <K> List<Map.Entry<K, Double>> falling(Map<K, Double> shares) {
        List<Map.Entry<K, Double>> sorted = new ArrayList<>(shares.entrySet());
        sorted.sort((a, b) -> Double.compare(b.getValue(), a.getValue()));
        return sorted;
    }

    private static String percent(double share) {
        return Math.round(100 * share) + " %";
    }

    private static void modes(ResultView view, StringBuilder text) {
        if (view.verdict() != Verdict.AMBIGUOUS) {
            return;
        }
        text.append("\nPoses that explain the photo\n");
        TextTable table = new TextTable(1);
        table.row("", "share", "x mm", "y mm", "z mm", "psi deg", "theta deg", "phi deg");
        for (ResultRow row : view.rows()) {
            for (ModeView mode : row.modes()) {
                double[] m = mode.pose().mean();
                table.row(row.kind() == ResultRow.Kind.CAMERA ? "camera" : name(row),
                        fixed(100 * mode.weight(), 1) + " %", fixed(m[0], 2), fixed(m[1], 2), fixed(m[2], 2),
                        fixed(Math.toDegrees(m[3]), 2), fixed(Math.toDegrees(m[4]), 2),
                        fixed(Math.toDegrees(m[5]), 2));
            }
        }
        text.append(table.text("  "));
    }

    private static void references(ResultView view, StringBuilder text) {
        ReferencesView references = view.references();
        if (references.fits().stream().anyMatch(ReferenceFitView::tested)) {
            text.append("\nReferences against each other: how far off they seem, from where on it would be ")
                    .append("noticed, mm\n");
            TextTable table = new TextTable(1);
            table.row("", "residual", "off x", "off y", "off z", "noticed x", "y", "z", "");
            for (ReferenceFitView fit : references.fits()) {
                if (!fit.used()) {
                    continue;
                }
                double[] off = fit.offset();
                double[] from = fit.detectable();
                table.row("reference " + fit.id(), fixed(fit.normalisedResidual(), 2), fixed(off[0], 1),
                        fixed(off[1], 1), fixed(off[2], 1), fixed(from[0], 1), fixed(from[1], 1), fixed(from[2], 1),
                        fit.misplaced() ? "SEEMS OFF" : "");
            }
            text.append(table.text("  ")).append(wrap("  " + references.noticeable(), "  "));
        }
        WithoutView without = references.without();
        if (without == null || without.objects().isEmpty()) {
            return;
        }
        text.append("\nWithout reference ").append(leftOut(without)).append(", by Laplace's approximation, mm\n");
        TextTable table = new TextTable(1);
        table.row("", "x", "y", "z", "moves x", "y", "z", "std x", "y", "z");
        for (MovedObject object : without.objects()) {
            withoutRow("object " + object.id(), object.pose().mean(), object.moveMm(), object.pose().std(), table);
            if (object.grip() != null) {
                withoutRow("  its gripping point", object.grip().meanMm(), object.grip().moveMm(),
                        object.grip().stdMm(), table);
            }
        }
        text.append(table.text("  "));
    }

    /** The references left out, in words. */
    public static String leftOut(WithoutView without) {
        StringBuilder ids = new StringBuilder();
        for (int i = 0; i < without.leftOut().size(); i++) {
            ids.append(i == 0 ? "" : i == without.leftOut().size() - 1 ? " and " : ", ")
                    .append(without.leftOut().get(i));
        }
        return ids.toString();
    }

    private static void withoutRow(String name, double[] mean, double[] move, double[] std, TextTable table) {
        table.row(name, fixed(mean[0], 2), fixed(mean[1], 2), fixed(mean[2], 2), signed(move[0]), signed(move[1]),
                signed(move[2]), fixed(std[0], 2), fixed(std[1], 2), fixed(std[2], 2));
    }

    /** A change, with its sign. */
    public static String signed(double value) {
        return Double.isFinite(value) ? String.format(Decimal.POINT, "%+.2f", value) : "-";
    }

    /** How the chains went, in one line. */
    public static String diagnosticsLine(ResultView view) {
        ChainsView chains = view.chains();
        RunView run = view.run();
        String word = chains.converged() ? "converged" : "not converged";
        return wrap(String.format(Decimal.POINT, "Chains: %s; %d x %d iterations (%d warm-up), R-hat %s, effective "
                + "draws %s (bulk), %s (tail), Monte Carlo error of any std %s %%", word,
                run.settings().sampling().chains(), run.iterationsPerChain(), run.warmup(),
                fixed(chains.rHatMax(), 4), fixed(chains.essBulkMin(), 0), fixed(chains.essTailMin(), 0),
                fixed(100 * chains.mcseStdRelMax(), 1)), "        ").stripTrailing();
    }

    /** What was found out about the photo's light, in words; empty where corners came without any. */
    public static String light(ResultView view) {
        PhotoLight light = view.light();
        if (light == null) {
            return "";
        }
        String blur = Double.isFinite(light.blurPx()) ? ", blur " + fixed(light.blurPx(), 2) + " px" : "";
        String noise = Double.isFinite(light.noiseGrey())
                ? ", noise " + fixed(light.noiseGrey(), 1) + " of 255 grey levels" : "";
        return "tone curve " + toneCurve(light.toneCurve()) + (light.toneCurveEstimated() ? " (estimated)" : "") + blur
                + noise + ", edges may be shifted by " + fixed(light.edgeShiftStdPx(), 3) + " px (std)";
    }

    /** A tone curve without needless digits; "auto" where none is stated. */
    public static String toneCurve(ToneCurve curve) {
        if (curve == null) {
            return "auto";
        }
        String[] words = curve.words().split(" ");
        return words.length == 1 ? words[0]
                : words[0] + " " + plain(Math.rint(100 * Double.parseDouble(words[1])) / 100);
    }

    private static String acceptanceLine(ResultView view) {
        Map<String, String> rates = new LinkedHashMap<>();
        for (AcceptanceCount count : view.chains().acceptance()) {
            rates.put(count.proposal(), fixed(100 * count.rate(), 0) + " %");
        }
        List<String> words = new ArrayList<>();
        rates.forEach((name, rate) -> words.add(name + " " + rate));
        return wrap("Accepted: " + String.join(", ", words), "        ").stripTrailing();
    }

    /**
     * By how much the chains correct Laplace's approximation: positions of objects and gripping points, or the
     * camera's.
     */
    public static String laplaceLine(ResultView view) {
        Correction correction = new Correction();
        for (ResultRow row : view.points()) {
            if (row.seen()) {
                correction.add(row.laplace(), row.kind() == ResultRow.Kind.GRIP
                        ? "the gripping point of object " + row.id().getAsInt() : name(row));
            }
        }
        if (view.points().stream().noneMatch(ResultRow::seen)) {
            correction.add(view.camera().laplace(), "the camera");
        }
        return wrap(correction.words(), "        ").stripTrailing();
    }

    /** The extremes of what chains make of Laplace's approximation. */
    private static final class Correction {
        private double least = Double.POSITIVE_INFINITY;
        private double most = Double.NEGATIVE_INFINITY;
        private double farthest = Double.NEGATIVE_INFINITY;
        private String whereLeast = "";
        private String whereMost = "";
        private String whereFarthest = "";

        void add(LaplaceView laplace, String name) {
            for (int i = 0; i < 3; i++) {
                String where = "xyz".charAt(i) + " of " + name;
                double ratio = laplace.sampledByLaplace()[i];
                double shift = Math.abs(laplace.meanShiftByStd()[i]);
                if (ratio < least) {
                    least = ratio;
                    whereLeast = where;
                }
                if (ratio > most) {
                    most = ratio;
                    whereMost = where;
                }
                if (shift > farthest) {
                    farthest = shift;
                    whereFarthest = where;
                }
            }
        }

        String words() {
            return String.format(Decimal.POINT, "Chains against Laplace's approximation: std %.2f (%s) to %.2f (%s) "
                    + "times as large, means up to %.2f std apart (%s)", least, whereLeast, most, whereMost, farthest,
                    whereFarthest);
        }
    }

    /** A number with fixed decimals; a dash where there is none. */
    public static String fixed(double value, int decimals) {
        return Double.isFinite(value) ? String.format(Decimal.POINT, "%." + decimals + "f", value) : "-";
    }

    static String significant(double value, int digits) {
        if (!Double.isFinite(value) || value == 0) {
            return fixed(value, 0);
        }
        int decimals = digits - 1 - (int) Math.floor(Math.log10(Math.abs(value)));
        return fixed(value, Math.max(0, Math.min(decimals, 9)));
    }

    /** A number without needless decimals. */
    public static String plain(double value) {
        return value == Math.rint(value) && Math.abs(value) < 1e9 ? String.format(Decimal.POINT, "%.0f", value)
                : Double.toString(value);
    }

    /** Breaks at spaces; every line ends with a line feed. */
    public static String wrap(String text, String indent) {
        StringBuilder out = new StringBuilder();
        String rest = text;
        while (rest.length() > WIDTH) {
            int at = rest.lastIndexOf(' ', WIDTH);
            if (rest.startsWith(" %", at)) {
                at = rest.lastIndexOf(' ', at - 1);     // a number and its sign stay together
            }
            if (at <= indent.length() + 1) {
                break;
            }
            out.append(rest, 0, at).append('\n');
            rest = indent + rest.substring(at + 1);
        }
        return out.append(rest).append('\n').toString();
    }
}
