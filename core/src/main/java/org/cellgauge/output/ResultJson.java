package org.cellgauge.output;

import com.google.gson.FormattingStyle;
import com.google.gson.stream.JsonWriter;
import java.io.IOException;
import java.io.StringWriter;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import org.cellgauge.cell.Cell;
import org.cellgauge.cell.ObjectMarker;
import org.cellgauge.cell.Reference;
import org.cellgauge.check.CellEstimate;
import org.cellgauge.check.CheckResult;
import org.cellgauge.check.Diagnostics;
import org.cellgauge.check.NoiseEstimate;
import org.cellgauge.check.Verdict;
import org.cellgauge.estimate.IntrinsicsEstimate;
import org.cellgauge.estimate.ModeEstimate;
import org.cellgauge.estimate.ObjectEstimate;
import org.cellgauge.estimate.PoseEstimate;
import org.cellgauge.estimate.VarianceBudget;
import org.cellgauge.estimate.VarianceSource;
import org.cellgauge.geometry.BrownLens;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.internal.statistics.Angles;
import org.cellgauge.placement.MisplacedReference;
import org.cellgauge.placement.NoiseFit;
import org.cellgauge.placement.ReferenceCheck;
import org.cellgauge.placement.ReferenceFit;
import org.cellgauge.placement.WithoutMisplaced;
import org.cellgauge.sampling.AcceptanceCount;
import org.cellgauge.sampling.Quantity;
import org.cellgauge.sampling.QuantityLayout;
import org.cellgauge.settings.CheckSettings;
import org.cellgauge.settings.Setting;
import org.cellgauge.settings.SettingTable;
import org.cellgauge.statistics.ChainDiagnostics;
import org.cellgauge.statistics.Ellipse;
import org.cellgauge.vision.PhotoLight;
import org.cellgauge.warning.Warning;

/**
 * The result file of a check, {@code NAME.result.json}.
 *
 * <p>Numbers keep every digit; what is not a number (a diagnostic that does not exist) is {@code null}, since JSON has
 * no NaN. There is no time stamp and no thread count in it: the same inputs, settings and seed give the same bytes. All
 * of it is ASCII (other characters are escaped), so that no setting of a terminal can spoil it.
 */
public final class ResultJson {
    /** Version of the format, the value of the key {@code schema}. */
    public static final int SCHEMA = 1;

    private static final List<String> POSE_ORDER = List.of("x_mm", "y_mm", "z_mm", "psi_rad", "theta_rad", "phi_rad");
    private static final List<String> TANGENT_ORDER = List.of("x_mm", "y_mm", "z_mm", "wx_rad", "wy_rad", "wz_rad");

    private static final int[] QUANTILE_PERCENT = {5, 50, 95};

    private final StringWriter text = new StringWriter();
    private final JsonWriter json = new JsonWriter(text);
    private final CheckResult result;
    private final Cell cell;
    private final boolean trusted;

    private ResultJson(CheckResult result) {
        this.result = result;
        this.cell = result.cell();
        this.trusted = result.verdict() != Verdict.NOT_CONVERGED && result.verdict() != Verdict.AMBIGUOUS;
        json.setFormattingStyle(FormattingStyle.PRETTY);
    }

    /**
     * The JSON of a result.
     *
     * @param result what a check found
     * @param inputName name of the photo or detections file, without its folder
     * @param inputSha256 SHA-256 of the file's bytes, hexadecimal; null where the input was no file
     * @param version version of this program
     * @return JSON in ASCII, ended by a line feed
     */
    public static String of(CheckResult result, String inputName, String inputSha256, String version) {
        return of(result, inputName, inputSha256, version, null);
    }

    /**
     * The JSON of a result with the command that makes it again.
     *
     * @param result what a check found
     * @param inputName name of the photo or detections file, without its folder
     * @param inputSha256 SHA-256 of the file's bytes, hexadecimal; null where the input was no file
     * @param version version of this program
     * @param command what makes the same figures again, or null where nothing does
     * @return JSON in ASCII, ended by a line feed
     */
    public static String of(CheckResult result, String inputName, String inputSha256, String version, String command) {
        ResultJson writer = new ResultJson(result);
        try {
            writer.write(inputName, inputSha256, version, command);
        } catch (IOException e) {
            throw new IllegalStateException("writing into memory cannot fail", e);
        }
        return ascii(writer.text.toString()) + "\n";
    }

    /**
     * The same JSON in ASCII, so that no setting of a terminal can spoil it.
     *
     * @param json JSON
     * @return JSON of the same meaning, other characters escaped
     */
    public static String ascii(String json) {
        StringBuilder out = new StringBuilder(json.length());
        for (int i = 0; i < json.length(); i++) {
            char c = json.charAt(i);
            if (c < 0x7F) {
                out.append(c);
            } else {
                out.append(String.format(Locale.ROOT, "\\u%04x", (int) c));
            }
        }
        return out.toString();
    }

    private void write(String inputName, String inputSha256, String version, String command) throws IOException {
        json.beginObject();
        json.name("schema").value(SCHEMA);
        json.name("verdict").value(result.verdict().key());
        json.name("decided").value(result.decided());
        json.name("reason").value(result.reason());
        json.name("input").beginObject();
        json.name("name").value(inputName);
        json.name("sha256").value(inputSha256);
        json.endObject();
        json.name("target");
        json.beginObject();
        number("std_mm", cell.targetStdMm().orElse(Double.NaN));
        json.endObject();
        json.name("settings");
        settings();
        if (result.detections().light() != null) {
            json.name("light");
            light(result.detections().light());
        }
        CellEstimate estimate = result.estimate();
        json.name("camera").beginObject();
        poseMembers(estimate.camera());
        modes(estimate.cameraModes());
        json.endObject();
        if (estimate.intrinsics() != null) {
            json.name("intrinsics");
            intrinsics(estimate.intrinsics());
        }
        json.name("objects").beginObject();
        for (ObjectEstimate object : estimate.objects()) {
            json.name(String.valueOf(object.id()));
            object(object);
        }
        json.endObject();
        noise(result.noise(), result.noiseFit(), result.referenceCheck());
        json.name("references").beginObject();
        for (Reference reference : cell.references()) {
            json.name(String.valueOf(reference.id()));
            fit(result.referenceCheck().fit(reference.id()));
        }
        json.endObject();
        json.name("misplaced_references").beginArray();
        for (MisplacedReference reference : result.referenceCheck().misplaced()) {
            misplaced(reference);
        }
        json.endArray();
        if (result.referenceCheck().without() != null) {
            json.name("without_misplaced");
            without(result.referenceCheck().without());
        }
        json.name("laplace");
        laplace();
        json.name("diagnostics");
        diagnostics();
        json.name("acceptance").beginObject();
        for (AcceptanceCount count : result.acceptance()) {
            json.name(count.proposal()).beginObject();
            json.name("accepted").value(count.accepted());
            json.name("rejected").value(count.rejected());
            json.endObject();
        }
        json.endObject();
        json.name("warnings").beginArray();
        for (Warning warning : result.warnings()) {
            json.value(warning.toString());
        }
        json.endArray();
        if (command != null) {
            json.name("command").value(command);
        }
        json.name("version").value(version);
        json.endObject();
        json.flush();
    }

    /** Noise of the corners and shift of the photo's edges. */
    private void noise(NoiseEstimate noise, NoiseFit fit, ReferenceCheck references) throws IOException {
        json.name("noise").beginObject();
        json.name("stated").value(noise.stated());
        number("added_std_px", noise.addedMeanStdPx());
        if (noise.addedQuantilesStdPx() != null) {
            double[] quantiles = noise.addedQuantilesStdPx();
            number("added_std_px_q2_5", quantiles[0]);
            number("added_std_px_q50", quantiles[1]);
            number("added_std_px_q97_5", quantiles[2]);
        }
        json.name("fit").beginObject();
        json.name("holds");
        if (fit.tested()) {
            json.value(fit.holds());
        } else {
            json.nullValue();
        }
        number("chi_square", fit.chiSquare());
        json.name("degrees_of_freedom").value(fit.degreesOfFreedom());
        number("p", fit.pValue());
        number("shown_std_px", fit.shownStdPx());
        json.name("references").beginObject();
        json.name("holds");
        if (references.degreesOfFreedom() > 0) {
            json.value(references.fitTogether());
        } else {
            json.nullValue();
        }
        number("chi_square", references.chiSquare());
        json.name("degrees_of_freedom").value(references.degreesOfFreedom());
        number("p", references.pValue());
        json.endObject();
        json.endObject();
        json.name("markers").beginObject();
        for (Map.Entry<Integer, Double> marker : noise.markerStdPx().entrySet()) {
            json.name(String.valueOf(marker.getKey())).beginObject();
            number("std_px", marker.getValue());
            Double times = noise.setAside().get(marker.getKey());
            number("times_stated", fit.times(marker.getKey()));
            number("set_aside_times", times == null ? Double.NaN : times);
            json.endObject();
        }
        json.endObject();
        json.endObject();
        double[] edges = noise.edgeShiftPx();
        if (edges != null) {
            json.name("edges").beginObject();
            number("shift_prior_std_px", edges[0]);
            number("shift_by_inner_edges_px", edges[1]);
            number("shift_by_inner_edges_std_px", edges[2]);
            number("shift_px", edges[3]);
            number("shift_std_px", edges[4]);
            json.endObject();
        }
    }

    // ---- settings

    private void settings() throws IOException {
        CheckSettings s = result.settings();
        json.beginObject();
        for (Setting<?> setting : SettingTable.all()) {
            if (!setting.determinesFigures()) {
                continue;
            }
            json.name(setting.key());
            plain(setting == SettingTable.WARMUP ? Integer.valueOf(result.warmup()) : setting.plain(s));
            if (setting == SettingTable.SAMPLER) {
                json.name("sampler_used").value(result.samplerUsed().word());
            } else if (setting == SettingTable.MAX_ITERATIONS) {
                json.name("iterations_run").value(result.iterationsPerChain());
            } else if (setting == SettingTable.POSE_PRIOR_ALLOWED) {
                json.name("pose_prior").value(result.posePrior());
            }
        }
        number("pixel_std_px", result.pixelStdPx());
        json.name("pixel_std_px_from").value(cell.pixelStdPx().isPresent() ? "cell file" : "photo");
        json.name("tone_curve").value(cell.toneCurve() == null ? "auto" : cell.toneCurve().words());
        json.name("prints").beginObject();
        number("size_std_mm", cell.prints().sizeStdMm());
        number("flatness_mm", cell.prints().flatnessMm());
        number("print_gain_std_mm", cell.prints().printGainStdMm());
        json.endObject();
        json.name("marker_family").value(cell.family().familyName());
        json.name("camera_intrinsics");
        cameraIntrinsics();
        json.name("references").beginObject();
        for (Reference reference : cell.references()) {
            json.name(String.valueOf(reference.id()));
            reference(reference);
        }
        json.endObject();
        json.name("object_markers").beginObject();
        for (ObjectMarker marker : cell.objects()) {
            json.name(String.valueOf(marker.id())).beginObject();
            number("size_mm", marker.sizeMm());
            if (marker.hasGrip()) {
                numbers("grip_mm", marker.gripMm());
            }
            json.endObject();
        }
        json.endObject();
        json.endObject();
    }

    /** What was found out about the photo's light. */
    private void light(PhotoLight light) throws IOException {
        json.beginObject();
        json.name("tone_curve").value(light.toneCurve().words());
        json.name("tone_curve_estimated").value(light.toneCurveEstimated());
        number("blur_px", light.blurPx());
        number("noise_grey", light.noiseGrey());
        number("noise_degrees_of_freedom", light.noiseDegreesOfFreedom());
        number("edge_shift_std_px", light.edgeShiftStdPx());
        json.endObject();
    }

    static String word(Enum<?> value) {
        return value.name().toLowerCase(Locale.ROOT).replace('_', '-');
    }

    /** A value as settings have it. */
    private void plain(Object value) throws IOException {
        if (value instanceof Number) {
            json.value((Number) value);
        } else if (value instanceof Boolean) {
            json.value((Boolean) value);
        } else {
            json.value((String) value);
        }
    }

    private void cameraIntrinsics() throws IOException {
        PinholeCamera camera = cell.camera();
        json.beginObject();
        json.name("width_px").value(camera.widthPx());
        json.name("height_px").value(camera.heightPx());
        if (camera.lens() != BrownLens.MODEL) {
            // without the key it is the lens that all files of this format had before there was another
            json.name("lens").value(camera.lens().modelName());
        }
        List<String> names = camera.lens().parameterNames();
        for (int i = 0; i < names.size(); i++) {
            number(names.get(i), camera.get(i));
        }
        json.endObject();
    }

    private void reference(Reference reference) throws IOException {
        json.beginObject();
        json.name("used").value(result.referencesUsed().contains(reference.id()));
        number("size_mm", reference.sizeMm());
        numbers("position_mm", reference.worldFromMarker().translationMm());
        numbers("rotation_rad", wrapped(reference.worldFromMarker().eulerRad()));
        json.name("placement").beginObject();
        numbers("std_mm", new double[] {reference.placement().stdMm(0), reference.placement().stdMm(1),
            reference.placement().stdMm(2)});
        number("std_rad", reference.placement().stdRad());
        json.endObject();
        json.endObject();
    }

    private static double[] wrapped(double[] anglesRad) {
        double[] out = new double[anglesRad.length];
        for (int i = 0; i < out.length; i++) {
            out[i] = Angles.wrapToPi(anglesRad[i]);
        }
        return out;
    }

    // ---- estimates

    /** The members of a pose; the object around them may hold more. */
    private void poseMembers(PoseEstimate pose) throws IOException {
        json.name("frame").value(pose.frame());
        strings("order", POSE_ORDER);
        double[] mean = pose.mean();
        for (int i = 3; i < 6; i++) {
            mean[i] = Angles.wrapToPi(mean[i]);
        }
        numbers("mean", mean);
        numbers("std", pose.std());
        matrix("covariance", pose.covariance());
        strings("tangent_order", TANGENT_ORDER);
        numbers("tangent_base", wrapped(pose.meanTransform().eulerRad()));
        matrix("tangent_covariance", pose.tangentCovariance());
    }

    /** The modes of a pose where it is ambiguous; nothing where it is not. */
    private void modes(List<ModeEstimate> modes) throws IOException {
        if (!ModeEstimate.areAmbiguous(modes)) {
            return;
        }
        json.name("modes").beginArray();
        for (ModeEstimate mode : modes) {
            json.beginObject();
            number("weight", mode.weight());
            poseMembers(mode.pose());
            json.endObject();
        }
        json.endArray();
    }

    private void intrinsics(IntrinsicsEstimate intrinsics) throws IOException {
        json.beginObject();
        strings("names", intrinsics.names());
        numbers("mean", intrinsics.mean());
        double[][] covariance = intrinsics.covariance();
        numbers("std", std(covariance));
        matrix("covariance", covariance);
        json.endObject();
    }

    private static double[] std(double[][] covariance) {
        double[] std = new double[covariance.length];
        for (int i = 0; i < std.length; i++) {
            std[i] = Math.sqrt(covariance[i][i]);
        }
        return std;
    }

    private void object(ObjectEstimate object) throws IOException {
        json.beginObject();
        json.name("within_target");
        if (trusted && cell.targetStdMm().isPresent()) {
            json.value(result.verdict(object.id()) == Verdict.PASS);
        } else {
            json.nullValue();
        }
        number("worst_std_mm", object.worstStdMm());
        ReferenceCheck references = result.referenceCheck();
        json.name("position_verdict").value(ResultView.rowVerdict(result, references.judgedMm(object)).key());
        if (object.grip() != null) {
            json.name("grip_verdict").value(ResultView.rowVerdict(result, references.gripJudgedMm(object)).key());
        }
        json.name("pose").beginObject();
        poseMembers(object.pose());
        json.endObject();
        if (object.grip() != null) {
            json.name("grip").beginObject();
            numbers("mean", object.grip().meanMm());
            numbers("std", object.grip().stdMm());
            matrix("covariance", object.grip().covarianceMm2());
            json.endObject();
        }
        budget("budget", object.budget());
        if (object.gripBudget() != null) {
            budget("grip_budget", object.gripBudget());
        }
        json.name("ellipse95_px");
        ellipse(object.ellipse95Px());
        if (object.grip() != null) {
            json.name("grip_ellipse95_px");
            ellipse(object.gripEllipse95Px());
        }
        modes(object.modes());
        json.endObject();
    }

    private void budget(String name, VarianceBudget budget) throws IOException {
        json.name(name);
        shares(budget.shares());
        json.name(name + "_axes").beginObject();
        for (int axis = 0; axis < 3; axis++) {
            json.name("xyz".substring(axis, axis + 1));
            shares(budget.shares(axis));
        }
        json.endObject();
        json.name(name + "_gain");
        shares(budget.gains());
        json.name(name + "_gain_axes").beginObject();
        for (int axis = 0; axis < 3; axis++) {
            json.name("xyz".substring(axis, axis + 1));
            shares(budget.gains(axis));
        }
        json.endObject();
    }

    private void shares(Map<VarianceSource, Double> shares) throws IOException {
        json.beginObject();
        for (Map.Entry<VarianceSource, Double> e : shares.entrySet()) {
            number(e.getKey().key(), e.getValue());
        }
        json.endObject();
    }

    private void ellipse(Ellipse ellipse) throws IOException {
        if (ellipse == null) {
            json.nullValue();
            return;
        }
        json.beginObject();
        numbers("centre", new double[] {ellipse.centreX(), ellipse.centreY()});
        numbers("semi_axes", new double[] {ellipse.semiMajor(), ellipse.semiMinor()});
        number("angle_rad", ellipse.angleRad());
        json.endObject();
    }

    // ---- references

    /** How a reference fits the others; only that it was not used where it was not seen or left out. */
    private void fit(ReferenceFit fit) throws IOException {
        json.beginObject();
        json.name("used").value(fit != null);
        if (fit != null) {
            json.name("misplaced").value(fit.misplaced());
            number("chi_square", fit.chiSquare());
            json.name("degrees_of_freedom").value(fit.degreesOfFreedom());
            number("p_value", fit.pValue());
            number("normalised_residual", fit.normalisedResidual());
            if (fit.tested()) {
                strings("order", TANGENT_ORDER);
                numbers("statistic", fit.statistic());
                numbers("limit", fit.limit());
                numbers("offset", fit.offset());
                numbers("offset_std", fit.offsetStd());
                numbers("detectable", fit.detectable());
            }
        }
        json.endObject();
    }

    private void misplaced(MisplacedReference reference) throws IOException {
        json.beginObject();
        json.name("id").value(reference.id());
        strings("order", TANGENT_ORDER);
        numbers("offset", reference.offset());
        number("statistic", reference.statistic());
        number("limit", reference.limit());
        json.name("or_instead").beginArray();
        for (int id : reference.orInstead()) {
            json.value(id);
        }
        json.endArray();
        json.endObject();
    }

    /** Camera and objects without the misplaced references, by Laplace's approximation. */
    private void without(WithoutMisplaced without) throws IOException {
        json.beginObject();
        json.name("left_out").beginArray();
        for (int id : without.leftOut()) {
            json.value(id);
        }
        json.endArray();
        json.name("camera").beginObject();
        poseMembers(without.camera());
        numbers("move_mm", without.cameraMoveMm());
        json.endObject();
        json.name("objects").beginObject();
        for (WithoutMisplaced.ObjectWithout object : without.objects()) {
            json.name(String.valueOf(object.id())).beginObject();
            json.name("pose").beginObject();
            poseMembers(object.pose());
            json.endObject();
            numbers("move_mm", object.moveMm());
            numbers("error_mm", object.errorMm());
            if (object.grip() != null) {
                json.name("grip").beginObject();
                numbers("mean", object.grip().meanMm());
                numbers("std", object.grip().stdMm());
                matrix("covariance", object.grip().covarianceMm2());
                numbers("move_mm", object.gripMoveMm());
                numbers("error_mm", object.gripErrorMm());
                json.endObject();
            }
            json.endObject();
        }
        json.endObject();
        json.endObject();
    }

    // ---- Laplace

    /**
     * The quick look: Laplace's approximation, how far the chains' means are from it and how large their deviations.
     */
    private void laplace() throws IOException {
        json.beginObject();
        json.name("camera").beginObject();
        comparison(result.quickLook().camera().mean(), result.quickLook().camera().std(),
                result.estimate().camera().mean(), result.estimate().camera().std(), "");
        json.endObject();
        json.name("objects").beginObject();
        for (ObjectEstimate sampled : result.estimate().objects()) {
            ObjectEstimate quick = result.quickLook().object(sampled.id());
            json.name(String.valueOf(sampled.id())).beginObject();
            comparison(quick.pose().mean(), quick.pose().std(), sampled.pose().mean(), sampled.pose().std(), "");
            if (sampled.grip() != null) {
                comparison(quick.grip().meanMm(), quick.grip().stdMm(), sampled.grip().meanMm(),
                        sampled.grip().stdMm(), "grip_");
            }
            json.endObject();
        }
        json.endObject();
        json.endObject();
    }

    private void comparison(double[] mean, double[] laplace, double[] sampledMean, double[] sampled, String prefix)
            throws IOException {
        double[] ratio = new double[laplace.length];
        double[] shift = new double[laplace.length];
        for (int i = 0; i < ratio.length; i++) {
            ratio[i] = sampled[i] / laplace[i];
            double moved = sampledMean[i] - mean[i];
            shift[i] = (i < 3 ? moved : Angles.wrapToPi(moved)) / laplace[i];
        }
        numbers(prefix + "mean", mean);
        numbers(prefix + "std", laplace);
        numbers(prefix + "mean_shift_by_std", shift);
        numbers(prefix + "sampled_by_laplace", ratio);
    }

    // ---- diagnostics

    private void diagnostics() throws IOException {
        Diagnostics d = result.diagnostics();
        json.beginObject();
        json.name("converged").value(d.converged());
        json.name("convergence").value(word(d.convergence()));
        number("r_hat_max", d.rHatMax());
        number("ess_bulk_min", d.essBulkMin());
        number("ess_tail_min", d.essTailMin());
        number("mcse_std_rel_max", d.mcseStdRelMax());
        number("pareto_k_max", d.paretoKMax());
        json.name("precision_reached");
        if (result.settings().sampling().iterations().isPresent()) {
            json.nullValue();
        } else {
            json.value(d.mcseStdRelMax() < result.settings().sampling().targetMcseStdRel() && !d.heavyTails());
        }
        json.name("camera_evaluations").beginObject();
        json.name("tuning").value(result.tuningEvaluations());
        json.name("chains").value((long) result.settings().sampling().chains() * result.iterationsPerChain());
        json.endObject();
        json.name("worst_parameter").value(d.worstParameter() == null ? null : d.worstParameter().name());
        json.name("parameters").beginObject();
        QuantityLayout layout = result.layout();
        for (Map.Entry<Quantity, ChainDiagnostics> e : d.parameters().entrySet()) {
            ChainDiagnostics p = e.getValue();
            boolean angle = layout.isAngle(layout.indexOf(e.getKey()));
            json.name(e.getKey().name()).beginObject();
            json.name("status").value(word(p.status()));
            number("mean", angle && Double.isFinite(p.mean()) ? Angles.wrapToPi(p.mean()) : p.mean());
            number("std", p.std());
            number("r_hat", p.rHat());
            number("ess_bulk", p.essBulk());
            number("ess_tail", p.essTail());
            number("mcse_mean", p.mcseMean());
            number("mcse_std", p.mcseSd());
            number("pareto_k", d.paretoK().getOrDefault(e.getKey(), Double.NaN));
            for (int percent : QUANTILE_PERCENT) {
                double quantile = p.quantile(percent / 100.0);
                number("q" + percent, angle && Double.isFinite(quantile) ? Angles.wrapToPi(quantile) : quantile);
            }
            for (int percent : QUANTILE_PERCENT) {
                number("mcse_q" + percent, p.mcseQuantile(percent / 100.0));
            }
            json.endObject();
        }
        json.endObject();
        json.endObject();
    }

    // ---- numbers

    private void number(String name, double value) throws IOException {
        json.name(name);
        if (Double.isFinite(value)) {
            json.value(value);
        } else {
            json.nullValue();
        }
    }

    private void numbers(String name, double[] values) throws IOException {
        json.name(name);
        row(values);
    }

    private void matrix(String name, double[][] rows) throws IOException {
        json.name(name).beginArray();
        for (double[] row : rows) {
            row(row);
        }
        json.endArray();
    }

    /** A vector or a row of a matrix stays on its line. */
    private void row(double[] values) throws IOException {
        StringBuilder row = new StringBuilder("[");
        for (int i = 0; i < values.length; i++) {
            row.append(i == 0 ? "" : ", ").append(Double.isFinite(values[i]) ? Double.toString(values[i]) : "null");
        }
        json.jsonValue(row.append(']').toString());
    }

    /** Plain names, without anything to escape. */
    private void strings(String name, List<String> values) throws IOException {
        json.name(name).jsonValue("[\"" + String.join("\", \"", values) + "\"]");
    }
}
