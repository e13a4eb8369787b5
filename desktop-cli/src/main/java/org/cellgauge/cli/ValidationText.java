package org.cellgauge.cli;

import com.google.gson.Gson;
import com.google.gson.GsonBuilder;
import com.google.gson.JsonArray;
import com.google.gson.JsonElement;
import com.google.gson.JsonNull;
import com.google.gson.JsonObject;
import com.google.gson.JsonPrimitive;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.function.Function;
import java.util.function.Predicate;
import java.util.stream.DoubleStream;
import org.cellgauge.desktop.CheckText;
import org.cellgauge.desktop.TextTable;
import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.internal.settings.SettingsJson;
import org.cellgauge.internal.statistics.BinomialBand;
import org.cellgauge.internal.validation.RankedQuantity;
import org.cellgauge.internal.validation.RegionCoverage;
import org.cellgauge.internal.validation.TruthPrior;
import org.cellgauge.internal.validation.Validation;
import org.cellgauge.internal.validation.ValidationResult;
import org.cellgauge.internal.validation.ValidationSettings;
import org.cellgauge.output.ResultJson;
import org.cellgauge.settings.CheckSettings;
import org.cellgauge.settings.LikelihoodModel;

/** A validation in tables for people, and as JSON. */
final class ValidationText {
    private static final List<String> FOCAL = List.of("fx_px", "fy_px");
    /** The level that the exit code goes by. */
    static final double JUDGED = 0.95;
    private static final double[] LEVELS = {0.5, 0.8, 0.95};
    /** One in a hundred: of some thousand draws a few dozen, fewer than a rank is taken among. */
    private static final double LEAST_EFFECTIVE_SHARE = 0.01;
    private static final double SUSPICIOUS = 0.01;
    /** Where the band of an honest 95 % reaches below this share, passing says little. */
    private static final double TELLING = 0.85;

    private final TruthPrior prior;
    private final ValidationSettings settings;
    private final ValidationResult result;

    ValidationText(TruthPrior prior, ValidationSettings settings, ValidationResult result) {
        this.prior = prior;
        this.settings = settings;
        this.result = result;
    }

    // ---- text

    /** Tables and what they mean, ended by a line feed. */
    String text() {
        StringBuilder text = new StringBuilder();
        CheckSettings check = settings.check();
        text.append(CheckText.wrap(String.format(Locale.ROOT, "%d simulated cells, %s, seed %d; %s. %d not converged, "
                + "%d refused, %d ambiguous%s.", result.simulations(), model(check), check.sampling().seed(), truth(),
                result.notConverged(), result.refused(), result.ambiguous(), falseAlarms(check)), ""));
        int stated = result.simulations() - result.notConverged() - result.refused();
        if (stated == 0) {
            return text.append("No check stated a figure: there is nothing to count.\n").toString();
        }
        text.append("\nPer cent of the stated regions that hold the truth\n");
        TextTable table = new TextTable(1);
        table.row("", "dim", "50 %", "80 %", "95 %", "honest 95 %", "", "Gaussian 95 %", "");
        for (RegionCoverage region : result.regions()) {
            BinomialBand band = region.band(JUDGED);
            table.row(region.name(), String.valueOf(region.dimension()), percent(region.hits(0.5), region),
                    percent(region.hits(0.8), region), percent(region.hits(JUDGED), region),
                    percent(band.lower(), region) + " - " + percent(band.upper(), region),
                    word(region.hits(JUDGED), band), percent(region.gaussianHits(JUDGED), region),
                    word(region.gaussianHits(JUDGED), band));
        }
        text.append(table.text("  "));
        text.append(CheckText.wrap("Stated region: the ellipsoid about the mean with the shape of the covariance that "
                + "holds the share of the draws; Gaussian: sized by the chi-square quantile. Honest: where all counts "
                + "lie together 99 times in 100 if every 95 % is right. Counted under the flat prior of a check.", ""));
        errors(text);
        ranks(text);
        text.append('\n').append(verdict());
        return text.toString();
    }

    /** Only where placement is tested at all. */
    private String falseAlarms(CheckSettings check) {
        return check.model().likelihood() == LikelihoodModel.RIGID_MARKER
                ? "; in " + result.falseAlarms() + " a reference was called misplaced although none was, in "
                + result.noiseMisfits() + " corners do not fit the stated noise, in " + result.referenceMisfits()
                + " the references together do not fit" : "";
    }

    private static String model(CheckSettings check) {
        return check.model().likelihood().word() + (check.model().likelihood() == LikelihoodModel.CORNER_CUBE
                ? " with kappa " + CheckText.plain(check.model().kappa()) : "");
    }

    private String truth() {
        String poses = prior.isPoint() ? "the same true poses in all"
                : String.format(Locale.ROOT, "true poses spread by %s mm and %s degrees",
                        CheckText.plain(prior.stdMm()),
                        CheckText.plain(Math.round(Math.toDegrees(prior.stdRad()) * 1e6) / 1e6));
        if (settings.calibrationPhotos() > 0) {
            return poses + ", the camera calibrated from " + settings.calibrationPhotos()
                    + " simulated photos of a board, lens and board chosen by these";
        }
        return prior.intrinsicsPrior().count() == 0 ? poses : poses + ", true focal lengths by what is known of them";
    }

    private static String percent(int count, RegionCoverage region) {
        return CheckText.fixed(100.0 * count / region.trials(), 1);
    }

    private static String word(int hits, BinomialBand band) {
        return band.contains(hits) ? "ok" : hits < band.lower() ? "TOO RARE" : "TOO OFTEN";
    }

    private void errors(StringBuilder text) {
        text.append("\nErrors in stated standard deviations: root mean square (1 is right) and mean (0 is right)\n");
        TextTable table = new TextTable(1);
        table.row(header(List.of("", "x", "y", "z", "wx", "wy", "wz"), "grip x", "grip y", "grip z"));
        byPart().forEach((part, quantities) -> {
            List<String> row = new ArrayList<>();
            List<String> mean = new ArrayList<>();
            row.add(part);
            mean.add("  mean");
            for (RankedQuantity q : quantities) {
                if (!Double.isNaN(q.rmsError()) && !FOCAL.contains(q.name())) {
                    row.add(CheckText.fixed(q.rmsError(), 2));
                    mean.add(String.format(Locale.ROOT, "%+.2f", q.meanError()));
                }
            }
            table.row(row.toArray(new String[0]));
            table.row(mean.toArray(new String[0]));
        });
        text.append(table.text("  "));
        ofFocalLengths(text, "focal lengths", q -> FOCAL.contains(q.name()),
                q -> q.name() + String.format(Locale.ROOT, " %.2f, mean %+.2f", q.rmsError(), q.meanError()));
    }

    /** A line on the camera's focal lengths, where they were sampled. */
    private void ofFocalLengths(StringBuilder text, String title, Predicate<RankedQuantity> which,
            Function<RankedQuantity, String> figures) {
        List<String> words = new ArrayList<>();
        result.quantities().stream().filter(which).forEach(q -> words.add(figures.apply(q)));
        if (!words.isEmpty()) {
            text.append("  ").append(title).append(": ").append(String.join("; ", words)).append('\n');
        }
    }

    private void ranks(StringBuilder text) {
        text.append("\nRanks of the truth among " + Validation.RANKED_DRAWS
                + " draws: p-value of their being uniform\n");
        TextTable table = new TextTable(1);
        table.row(header(List.of("", "x", "y", "z", "wx", "wy", "wz", "density", "distance", "norm"),
                "grip x", "grip y", "grip z", "its norm"));
        byPart().forEach((part, quantities) -> {
            Map<String, String> p = new LinkedHashMap<>();
            for (RankedQuantity q : quantities) {
                p.put(q.name(), CheckText.fixed(q.ranks().pValue(), 3));
            }
            List<String> row = new ArrayList<>();
            row.add(part);
            for (String name : List.of("x_mm", "y_mm", "z_mm", "wx_rad", "wy_rad", "wz_rad", "log_density",
                    "distance_mm", "norm", "grip_x_mm", "grip_y_mm", "grip_z_mm", "grip_norm")) {
                row.add(p.getOrDefault(name, ""));
            }
            table.row(row.toArray(new String[0]));
        });
        text.append(table.text("  "));
        ofFocalLengths(text, "focal lengths", q -> FOCAL.contains(q.name()) || q.name().equals("focal_norm"),
                q -> q.name() + " " + CheckText.fixed(q.ranks().pValue(), 3));
        text.append(CheckText.wrap((prior.isPoint()
                ? "At fixed true poses uniform ranks are an approximation that holds where uncertainties are small; "
                        + "with a --spread it is exact."
                : "Draws are weighted to the spread of the true poses, so uniform ranks are exact if likelihood, "
                        + "sampler and object poses are right together; at least "
                        + CheckText.fixed(100 * result.weightShareMin(), 1) + " % of the draws stayed effective.")
                + " All together: p = " + CheckText.fixed(result.rankPValue(), 3)
                + verdictOnRanks() + (prior.intrinsicsPrior().count() == 0 ? "" : " Ranks of objects are an "
                + "approximation where the focal length is unknown: their corners say nothing of it."), ""));
    }

    /** Ranks among draws of which hardly any has weight are those of a handful of values, uniform or not. */
    private String verdictOnRanks() {
        if (!prior.isPoint() && result.weightShareMin() < LEAST_EFFECTIVE_SHARE) {
            return "; so few draws stayed effective somewhere that this says little either way.";
        }
        return result.rankPValue() < SUSPICIOUS ? ", they are not uniform." : ".";
    }

    /** Columns of every part, and those of gripping points where an object has one. */
    private String[] header(List<String> always, String... ofGrips) {
        List<String> header = new ArrayList<>(always);
        if (result.quantities().stream().anyMatch(q -> q.name().equals("grip_norm"))) {
            header.addAll(List.of(ofGrips));
        }
        return header.toArray(new String[0]);
    }

    private Map<String, List<RankedQuantity>> byPart() {
        Map<String, List<RankedQuantity>> parts = new LinkedHashMap<>();
        for (RankedQuantity q : result.quantities()) {
            parts.computeIfAbsent(q.part(), k -> new ArrayList<>()).add(q);
        }
        return parts;
    }

    private String verdict() {
        if (!result.covers(JUDGED)) {
            return "A stated 95 % is not right 95 times in 100 here.\n";
        }
        RegionCoverage region = result.regions().get(0);
        double least = (double) region.band(JUDGED).lower() / region.trials();
        return CheckText.wrap("A stated 95 % is right 95 times in 100 here, within chance." + (least < TELLING
                ? " So few simulated cells would not tell it from " + Math.round(100 * least)
                + " times in 100: give more --simulations." : ""), "");
    }

    // ---- JSON

    /**
     * All counts and ranks.
     *
     * @param study what was simulated, by key
     * @param command what makes them again
     * @param version of this program
     * @return JSON in ASCII, ended by a line feed
     */
    String json(Map<String, ?> study, String command, String version) {
        CheckSettings check = settings.check();
        JsonObject root = new JsonObject();
        root.addProperty("schema", 1);
        root.addProperty("covers_95", result.covers(JUDGED));
        Gson gson = new GsonBuilder().setPrettyPrinting().serializeNulls().create();
        JsonObject used = gson.toJsonTree(study).getAsJsonObject();
        used.addProperty("simulated_pixel_std_px", settings.pixelStdPx());
        used.addProperty("spread_mm", prior.stdMm());
        used.addProperty("spread_rad", prior.stdRad());
        used.add("camera_pose", pose(prior.nominal().worldFromCamera()));
        JsonObject objects = new JsonObject();
        prior.nominal().worldFromObjects().forEach((id, p) -> objects.add(String.valueOf(id), pose(p)));
        used.add("object_poses", objects);
        SettingsJson.plain(check).forEach((key, value) -> used.add(key, gson.toJsonTree(value)));
        root.add("settings", used);
        root.addProperty("not_converged", result.notConverged());
        root.addProperty("refused", result.refused());
        root.addProperty("ambiguous", result.ambiguous());
        root.addProperty("false_alarms", result.falseAlarms());
        root.addProperty("noise_misfits", result.noiseMisfits());
        root.addProperty("reference_misfits", result.referenceMisfits());
        root.add("effective_share_min", number(result.weightShareMin()));
        root.add("rank_p_value", number(result.rankPValue()));
        JsonArray regions = new JsonArray();
        for (RegionCoverage region : result.regions()) {
            JsonObject r = new JsonObject();
            r.addProperty("name", region.name());
            r.addProperty("dimension", region.dimension());
            r.addProperty("trials", region.trials());
            JsonArray levels = new JsonArray();
            for (double level : region.trials() == 0 ? new double[0] : LEVELS) {
                BinomialBand band = region.band(level);
                JsonObject l = new JsonObject();
                l.addProperty("probability", level);
                l.addProperty("hits", region.hits(level));
                l.addProperty("gaussian_hits", region.gaussianHits(level));
                l.addProperty("band_lower", band.lower());
                l.addProperty("band_upper", band.upper());
                l.addProperty("covers", region.covers(level));
                l.addProperty("gaussian_covers", region.gaussianCovers(level));
                levels.add(l);
            }
            r.add("levels", levels);
            regions.add(r);
        }
        root.add("regions", regions);
        JsonArray quantities = new JsonArray();
        for (RankedQuantity q : result.quantities()) {
            JsonObject o = new JsonObject();
            o.addProperty("part", q.part());
            o.addProperty("name", q.name());
            o.add("mean_error", number(q.meanError()));
            o.add("rms_error", number(q.rmsError()));
            JsonArray counts = new JsonArray();
            for (int count : q.ranks().counts()) {
                counts.add(count);
            }
            o.add("rank_counts", counts);
            o.add("p_value", number(q.ranks().pValue()));
            quantities.add(o);
        }
        root.add("ranks", quantities);
        root.addProperty("command", command);
        root.addProperty("version", version);
        return ResultJson.ascii(gson.toJson(root)) + "\n";
    }

    private static JsonElement number(double value) {
        return Double.isFinite(value) ? new JsonPrimitive(value) : JsonNull.INSTANCE;
    }

    private static JsonArray pose(RigidTransform pose) {
        JsonArray values = new JsonArray();
        poseValues(pose).forEach(values::add);
        return values;
    }

    /** Position in mm, then the angles in radians. */
    static List<Double> poseValues(RigidTransform pose) {
        return DoubleStream.concat(Arrays.stream(pose.translationMm()), Arrays.stream(pose.eulerRad())).boxed()
                .toList();
    }
}
