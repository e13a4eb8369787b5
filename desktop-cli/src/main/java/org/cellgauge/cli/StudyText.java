package org.cellgauge.cli;

import com.google.gson.Gson;
import com.google.gson.GsonBuilder;
import com.google.gson.JsonArray;
import com.google.gson.JsonElement;
import com.google.gson.JsonNull;
import com.google.gson.JsonObject;
import com.google.gson.JsonPrimitive;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.stream.Collectors;
import org.cellgauge.check.Verdict;
import org.cellgauge.desktop.CheckText;
import org.cellgauge.desktop.TextTable;
import org.cellgauge.internal.statistics.BinomialBand;
import org.cellgauge.internal.validation.CoverageFigures;
import org.cellgauge.output.ResultJson;

/** Figures of a coverage study in tables for people, as a row of a table in Markdown, and as JSON. */
final class StudyText {
    /** Columns of {@link #markdownRow}. */
    static final List<String> COLUMNS = List.of("photos", "camera 95 %", "objects 95 %", "camera NEES", "objects NEES",
            "camera z, mm", "no figure", "ambiguous", "accused", "noise misfit", "references misfit", "found",
            "corners e'S⁻¹e/8", "outward, px", "outward, std", "rms, px");

    /** Columns of {@link #markdownRowOfCorners}. */
    static final List<String> CORNER_COLUMNS = List.of("photos", "refused", "found", "corners e'S⁻¹e/8", "outward, px",
            "outward, std", "rms, px", "as stated e'S⁻¹e/8");

    private final CoverageFigures figures;

    StudyText(CoverageFigures figures) {
        this.figures = figures;
    }

    /** Whether every 95 % region held the truth as often as it claims, within chance. */
    static boolean covers(CoverageFigures figures) {
        return !figures.regions().isEmpty()
                && figures.regions().stream().allMatch(r -> r.band().contains(r.held()));
    }

    /** Share of the photos of which no figure came. */
    static double withoutFigure(CoverageFigures figures) {
        return (double) (figures.refused() + figures.count(Verdict.NOT_CONVERGED)) / figures.simulations();
    }

    // ---- text

    /** Tables and what they mean, ended by a line feed. */
    String text(String what) {
        StringBuilder text = new StringBuilder();
        text.append(CheckText.wrap(String.format(Locale.ROOT, "%d simulated cells, %s. %d refused, %d not converged, "
                + "%d ambiguous; %d accuse a reference although all stand as stated, corners of %d do not fit the "
                + "stated noise, references of %d together do not fit; %.1f %% have one or another of these false "
                + "alarms. Of %d markers %d were found; in %d photos one was missing.", figures.simulations(), what,
                figures.refused(), figures.count(Verdict.NOT_CONVERGED), figures.count(Verdict.AMBIGUOUS),
                figures.falseAlarms(), figures.noiseMisfits(), figures.referenceMisfits(),
                100.0 * figures.alarmed() / figures.simulations(), figures.markers(), figures.markersFound(),
                figures.photosWithMarkersMissing()), ""));
        if (figures.count(Verdict.PASS) + figures.count(Verdict.FAIL) > 0) {
            text.append("  target met by ").append(figures.count(Verdict.PASS)).append(", missed by ")
                    .append(figures.count(Verdict.FAIL)).append('\n');
        }
        figures.refusals().forEach((reason, count) -> text.append("  refused ").append(count).append(": ")
                .append(reason).append('\n'));
        figures.warnings().forEach((kind, count) -> text.append("  warned ").append(count).append(": ").append(kind)
                .append('\n'));
        if (figures.verdicts().isEmpty() && figures.refused() < figures.simulations()) {
            text.append("Corners only: nothing was checked.\n");
        } else if (figures.regions().isEmpty()) {
            text.append("No check stated a figure: there is nothing to count.\n");
        } else {
            regions(text);
        }
        corners(text);
        return text.toString();
    }

    private void regions(StringBuilder text) {
        text.append("\nStated 95 % regions, and squared distances of the truth from the mean (NEES, of one mode)\n");
        TextTable table = new TextTable(1);
        table.row("", "dim", "stated", "hold", "honest", "", "NEES", "+-", "two modes", "hold");
        for (CoverageFigures.Region r : figures.regions()) {
            BinomialBand band = r.band();
            CoverageFigures.Mean squared = r.squaredDistance();
            table.row(r.part() + " " + r.name(), String.valueOf(r.dimension()), String.valueOf(r.trials()),
                    percent(r.held(), r.trials()) + " %",
                    percent(band.lower(), r.trials()) + " - " + percent(band.upper(), r.trials()),
                    band.contains(r.held()) ? "ok" : r.held() < band.lower() ? "TOO RARE" : "TOO OFTEN",
                    plain(squared.value(), 2), plain(squared.standardError(), 2), String.valueOf(r.severalModes()),
                    r.severalModes() == 0 ? "" : percent(r.heldOfSeveralModes(), r.severalModes()) + " %");
        }
        text.append(table.text("  "));
        text.append("Bias of z, mm:");
        figures.biasZMm().forEach((part, mean) -> text.append(String.format(Locale.ROOT, "  %s %+.2f +- %.2f", part,
                mean.value(), mean.standardError())));
        text.append('\n');
    }

    private void corners(StringBuilder text) {
        CoverageFigures.Corners corners = figures.corners();
        if (corners.markers() == 0) {
            return;
        }
        text.append(String.format(Locale.ROOT,
                "%nCorners of %d markers: rms %.4f px, sides outward by %+.4f +- %.4f px",
                corners.markers(), corners.rmsPx(), corners.outwardPx().value(), corners.outwardPx().standardError()));
        if (corners.squaredStated().count() == 0) {
            text.append(".\nNo observation states a covariance.\n");
            return;
        }
        text.append(String.format(Locale.ROOT, ", %+.2f stated deviations.%ne' S^-1 e / 8 is %.3f +- %.3f on average "
                + "(honest: 1), beyond the 99.9 %% quantile in %.1f %%", corners.outwardInStds().value(),
                corners.squaredStated().value(), corners.squaredStated().standardError(),
                100 * corners.outlyingShare()));
        if (corners.squaredAsTaken().count() > 0) {
            text.append(String.format(Locale.ROOT, ";%nas the check takes them %.3f +- %.3f",
                    corners.squaredAsTaken().value(), corners.squaredAsTaken().standardError()));
        }
        text.append(".\n");
    }

    private static String percent(int count, int trials) {
        return CheckText.fixed(100.0 * count / trials, 1);
    }

    private static String plain(double value, int decimals) {
        return Double.isNaN(value) ? "-" : String.format(Locale.ROOT, Math.abs(value) >= 1000 ? "%.3g"
                : "%." + decimals + "f", value);
    }

    // ---- Markdown

    /** Cells of a row, in the order of {@link #COLUMNS}; ranges go over the objects, positions left out. */
    List<String> markdownRow() {
        List<CoverageFigures.Region> objects = figures.regions().stream()
                .filter(r -> !r.part().equals("camera") && r.name().equals("pose")).toList();
        CoverageFigures.Region camera = figures.regions().stream()
                .filter(r -> r.part().equals("camera") && r.name().equals("pose")).findFirst().orElse(null);
        CoverageFigures.Corners corners = figures.corners();
        CoverageFigures.Mean z = figures.biasZMm().get("camera");
        return List.of(String.valueOf(figures.simulations()),
                camera == null ? "-" : percent(camera.held(), camera.trials()),
                range(objects.stream().map(r -> 100.0 * r.held() / r.trials()).toList(), 1),
                camera == null ? "-" : plain(camera.squaredDistance().value(), 1),
                range(objects.stream().map(r -> r.squaredDistance().value()).toList(), 1),
                z == null ? "-" : String.format(Locale.ROOT, "%+.2f", z.value()),
                String.valueOf(figures.refused() + figures.count(Verdict.NOT_CONVERGED)),
                String.valueOf(figures.count(Verdict.AMBIGUOUS)), String.valueOf(figures.falseAlarms()),
                String.valueOf(figures.noiseMisfits()), String.valueOf(figures.referenceMisfits()),
                percent(figures.markersFound(), figures.markers()) + " %", plain(corners.squaredAsTaken().value(), 2),
                signed(corners.outwardPx().value(), 4), signed(corners.outwardInStds().value(), 2),
                plain(corners.rmsPx(), 4));
    }

    /** Cells of a row, in the order of {@link #CORNER_COLUMNS}. */
    List<String> markdownRowOfCorners() {
        CoverageFigures.Corners corners = figures.corners();
        return List.of(String.valueOf(figures.simulations()), String.valueOf(figures.refused()),
                percent(figures.markersFound(), figures.markers()) + " %", plain(corners.squaredAsTaken().value(), 2),
                signed(corners.outwardPx().value(), 4), signed(corners.outwardInStds().value(), 2),
                plain(corners.rmsPx(), 4), plain(corners.squaredStated().value(), 2));
    }

    private static String signed(double value, int decimals) {
        return Double.isNaN(value) ? "-" : String.format(Locale.ROOT, "%+." + decimals + "f", value);
    }

    private static String range(List<Double> values, int decimals) {
        double[] known = values.stream().mapToDouble(v -> v).filter(v -> !Double.isNaN(v)).toArray();
        if (known.length == 0) {
            return "-";
        }
        double least = Arrays.stream(known).min().getAsDouble();
        double most = Arrays.stream(known).max().getAsDouble();
        return known.length == 1 ? plain(least, decimals) : plain(least, decimals) + " to " + plain(most, decimals);
    }

    // ---- JSON

    /**
     * All figures.
     *
     * @param settings all that determines them, by key
     * @param command what makes them again
     * @param version of this program
     * @return JSON in ASCII, ended by a line feed
     */
    String json(Map<String, ?> settings, String command, String version) {
        Gson gson = new GsonBuilder().setPrettyPrinting().serializeNulls().disableHtmlEscaping().create();
        JsonObject root = new JsonObject();
        root.addProperty("schema", 1);
        root.addProperty("covers_95", covers(figures));
        root.add("settings", gson.toJsonTree(settings));
        root.addProperty("simulations", figures.simulations());
        root.add("verdicts", gson.toJsonTree(figures.verdicts().entrySet().stream()
                .collect(Collectors.toMap(e -> e.getKey().key(), Map.Entry::getValue, (a, b) -> a,
                        java.util.TreeMap::new))));
        root.addProperty("refused", figures.refused());
        root.add("refusals", gson.toJsonTree(figures.refusals()));
        root.add("warnings", gson.toJsonTree(figures.warnings()));
        root.addProperty("false_alarms", figures.falseAlarms());
        root.addProperty("noise_misfits", figures.noiseMisfits());
        root.addProperty("reference_misfits", figures.referenceMisfits());
        root.addProperty("photos_with_alarm", figures.alarmed());
        root.addProperty("markers", figures.markers());
        root.addProperty("markers_found", figures.markersFound());
        root.addProperty("photos_with_markers_missing", figures.photosWithMarkersMissing());
        JsonArray regions = new JsonArray();
        for (CoverageFigures.Region r : figures.regions()) {
            JsonObject o = new JsonObject();
            o.addProperty("part", r.part());
            o.addProperty("name", r.name());
            o.addProperty("dimension", r.dimension());
            o.addProperty("trials", r.trials());
            o.addProperty("held_95", r.held());
            o.addProperty("band_lower", r.band().lower());
            o.addProperty("band_upper", r.band().upper());
            o.addProperty("several_modes", r.severalModes());
            o.addProperty("several_modes_held_95", r.heldOfSeveralModes());
            o.add("squared_distance", mean(r.squaredDistance()));
            regions.add(o);
        }
        root.add("regions", regions);
        JsonObject bias = new JsonObject();
        figures.biasZMm().forEach((part, mean) -> bias.add(part, mean(mean)));
        root.add("bias_z_mm", bias);
        CoverageFigures.Corners c = figures.corners();
        JsonObject corners = new JsonObject();
        corners.addProperty("markers", c.markers());
        corners.add("rms_px", number(c.rmsPx()));
        corners.add("outward_px", mean(c.outwardPx()));
        corners.add("outward_stds", mean(c.outwardInStds()));
        corners.add("squared_stated_per_8", mean(c.squaredStated()));
        corners.add("squared_as_taken_per_8", mean(c.squaredAsTaken()));
        corners.add("outlying_share", number(c.outlyingShare()));
        root.add("corners", corners);
        root.addProperty("command", command);
        root.addProperty("version", version);
        return ResultJson.ascii(gson.toJson(root)) + "\n";
    }

    private static JsonObject mean(CoverageFigures.Mean mean) {
        JsonObject o = new JsonObject();
        o.addProperty("count", mean.count());
        o.add("mean", number(mean.value()));
        o.add("standard_error", number(mean.standardError()));
        return o;
    }

    private static JsonElement number(double value) {
        return Double.isFinite(value) ? new JsonPrimitive(value) : JsonNull.INSTANCE;
    }
}
