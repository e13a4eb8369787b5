package org.cellgauge.output;

import com.google.gson.FormattingStyle;
import com.google.gson.stream.JsonWriter;
import java.io.IOException;
import java.io.StringWriter;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Objects;
import java.util.OptionalInt;
import java.util.Set;
import org.cellgauge.check.CheckResult;
import org.cellgauge.check.Conformity;
import org.cellgauge.geometry.BrownLens;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.internal.output.TargetJson;
import org.cellgauge.placement.Misfit;
import org.cellgauge.sampling.AcceptanceCount;
import org.cellgauge.settings.CheckSettings;
import org.cellgauge.settings.Setting;
import org.cellgauge.settings.SettingTable;
import org.cellgauge.statistics.Ellipse;
import org.cellgauge.vision.PhotoLight;
import org.cellgauge.warning.Place;
import org.jspecify.annotations.Nullable;

/**
 * The result file of a check, {@code NAME.result.json}: all of a {@link ResultView}, as {@link ResultReader} reads it
 * back.
 *
 * <p>Numbers keep every digit; what is not a number (a diagnostic that does not exist) is {@code null}, since JSON has
 * no NaN. There is no time but the day, and no thread count in it: on one day the same inputs, settings and seed give
 * the same bytes. All of it is ASCII (other characters are escaped), so that no setting of a terminal can spoil it.
 */
public final class ResultJson {
    /** Version of the format, the value of the key {@code schema}. */
    public static final int SCHEMA = 1;
    /** What stands in place of a verdict where an input was refused. */
    public static final String REFUSED = "refused";

    private static final List<String> POSE_ORDER = List.of("x_mm", "y_mm", "z_mm", "psi_rad", "theta_rad", "phi_rad");
    private static final List<String> TANGENT_ORDER = List.of("x_mm", "y_mm", "z_mm", "wx_rad", "wy_rad", "wz_rad");
    private static final String[] AXES = {"x", "y", "z"};

    private final StringWriter text = new StringWriter();
    private final JsonWriter json = new JsonWriter(text);

    private ResultJson(FormattingStyle style) {
        json.setFormattingStyle(style);
    }

    /**
     * The JSON of a result.
     *
     * @param result what a check found
     * @param record what it is of
     * @return JSON in ASCII, ended by a line feed
     */
    public static String of(CheckResult result, ResultRecord record) {
        return of(new StoredResult(ResultView.of(result), record));
    }

    /**
     * The JSON of a result.
     *
     * @param result what it says, and what it is of
     * @return JSON in ASCII, ended by a line feed
     */
    public static String of(StoredResult result) {
        return new ResultJson(FormattingStyle.PRETTY).text(result);
    }

    /**
     * The same JSON in one line, as one of many that follow each other (JSON Lines).
     *
     * @param result what it says, and what it is of
     * @return JSON in ASCII, ended by a line feed
     */
    public static String line(StoredResult result) {
        return new ResultJson(FormattingStyle.COMPACT).text(result);
    }

    /**
     * What stands in place of a result, in one line, where an input was refused: {@code verdict} is {@value #REFUSED},
     * {@code reason} says why, and {@code refusal} has the code of the reason and the place of the fault.
     *
     * @param record what was refused, and by which program
     * @param code of the reason ({@link org.cellgauge.warning.MessageKind#code()})
     * @param reason in English
     * @param place of the fault, or null
     * @return JSON in ASCII, ended by a line feed
     */
    public static String refused(ResultRecord record, String code, String reason, @Nullable Place place) {
        return new ResultJson(FormattingStyle.COMPACT).refusal(record, code, reason, place);
    }

    private String text(StoredResult result) {
        try {
            write(result.view(), result.record());
        } catch (IOException e) {
            throw new IllegalStateException("writing into memory cannot fail", e);
        }
        return ascii(text.toString()) + "\n";
    }

    private String refusal(ResultRecord record, String code, String reason, @Nullable Place place) {
        try {
            json.beginObject();
            json.name("schema").value(SCHEMA);
            json.name("verdict").value(REFUSED);
            json.name("reason").value(reason);
            json.name("refusal").beginObject();
            json.name("code").value(code);
            if (place != null) {
                json.name("file").value(place.file());
                json.name("line").value(place.line() > 0 ? place.line() : null);
                json.name("column").value(place.column() > 0 ? place.column() : null);
                json.name("key").value(place.key().isEmpty() ? null : place.key());
            }
            json.endObject();
            files(record);
            json.name("version").value(record.version());
            json.endObject();
            json.flush();
        } catch (IOException e) {
            throw new IllegalStateException("writing into memory cannot fail", e);
        }
        return ascii(text.toString()) + "\n";
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

    private void write(ResultView view, ResultRecord record) throws IOException {
        NoiseView noise = Objects.requireNonNull(view.noise(), "this is preliminary");
        ReferencesView references = Objects.requireNonNull(view.references());
        ChainsView chains = Objects.requireNonNull(view.chains());
        json.beginObject();
        json.name("schema").value(SCHEMA);
        json.name("verdict").value(Objects.requireNonNull(view.verdict()).key());
        json.name("decided").value(view.decided());
        json.name("reason").value(view.reason());
        files(record);
        json.name("target");
        TargetJson.write(view.target(), json);
        json.name("settings");
        settings(Objects.requireNonNull(view.run()), view.cell(), noise, references);
        PhotoLight light = view.light();
        if (light != null) {
            json.name("light");
            light(light);
        }
        json.name("camera").beginObject();
        poseMembers(Objects.requireNonNull(view.camera().pose()));
        modes(view.camera());
        json.endObject();
        if (!view.intrinsics().isEmpty()) {
            json.name("intrinsics");
            intrinsics(view);
        }
        json.name("objects").beginObject();
        for (ResultRow object : view.objects()) {
            if (object.seen()) {
                json.name(String.valueOf(object.id().getAsInt()));
                object(view, object);
            }
        }
        json.endObject();
        noise(noise, references);
        json.name("references").beginObject();
        for (ReferenceFitView fit : references.fits()) {
            json.name(String.valueOf(fit.id()));
            fit(fit);
        }
        json.endObject();
        json.name("references_noticeable").value(references.noticeable());
        json.name("misplaced_references").beginArray();
        for (MisplacedView reference : references.misplaced()) {
            misplaced(reference);
        }
        json.endArray();
        json.name("causes").beginArray();
        for (CauseView cause : references.causes()) {
            cause(cause);
        }
        json.endArray();
        WithoutView without = references.without();
        if (without != null) {
            json.name("without_misplaced");
            without(without);
        }
        json.name("misfit");
        misfit(references.misfit());
        json.name("laplace");
        laplace(view);
        json.name("diagnostics");
        diagnostics(chains);
        json.name("acceptance").beginObject();
        for (AcceptanceCount count : chains.acceptance()) {
            json.name(count.proposal()).beginObject();
            json.name("accepted").value(count.accepted());
            json.name("rejected").value(count.rejected());
            json.endObject();
        }
        json.endObject();
        json.name("warnings").beginArray();
        for (WarningView warning : view.warnings()) {
            json.value(warning.text());
        }
        json.endArray();
        json.name("warning_codes").beginArray();
        for (WarningView warning : view.warnings()) {
            json.value(warning.code());
        }
        json.endArray();
        if (view.action() != null) {
            json.name("action").value(view.action());
        }
        advice(view.advice());
        if (record.command() != null) {
            json.name("command").value(record.command());
        }
        json.name("version").value(record.version());
        json.endObject();
        json.flush();
    }

    // ---- the target

    private void advice(List<AdviceView> advice) throws IOException {
        if (advice.isEmpty()) {
            return;
        }
        json.name("plan").beginArray();
        for (AdviceView a : advice) {
            json.beginObject();
            json.name("changes").beginArray();
            for (int i = 0; i < a.codes().size(); i++) {
                json.beginObject();
                json.name("code").value(a.codes().get(i));
                json.name("sentence").value(a.sentences().get(i));
                json.endObject();
            }
            json.endArray();
            number("cost", a.cost());
            json.name("object").value(a.objectId());
            json.name("point").value(a.grip() ? "grip" : "marker");
            json.name("axis").value("xyz".substring(a.axis(), a.axis() + 1));
            number("now_std_mm", a.nowStdMm());
            number("then_std_mm", a.thenStdMm());
            number("worst_std_mm", a.worstStdMm());
            json.endObject();
        }
        json.endArray();
    }

    private void conformity(String name, List<Conformity> all) throws IOException {
        if (all.isEmpty()) {
            return;
        }
        json.name(name).beginArray();
        for (Conformity c : all) {
            json.beginObject();
            json.name("of").value(c.of().key());
            number("tolerance_" + c.of().unit(), c.tolerance());
            number("probability", c.probability());
            number("mcse", c.mcse());
            number("asked", c.asked());
            json.endObject();
        }
        json.endArray();
    }

    // ---- what it is of

    private void files(ResultRecord record) throws IOException {
        json.name("input");
        file(record.inputName(), record.inputSha256());
        if (record.cellName() != null) {
            json.name("cell");
            file(record.cellName(), record.cellSha256());
        }
        if (record.cameraName() != null) {
            json.name("camera_file");
            file(record.cameraName(), record.cameraSha256());
        }
        if (record.date() != null) {
            json.name("date").value(record.date());
        }
        if (record.judgedOn() != null) {
            json.name("judged_on").value(record.judgedOn());
        }
    }

    private void file(String name, @Nullable String sha256) throws IOException {
        json.beginObject();
        json.name("name").value(name);
        json.name("sha256").value(sha256);
        json.endObject();
    }

    // ---- corners

    /** Noise of the corners and shift of the photo's edges. */
    private void noise(NoiseView noise, ReferencesView references) throws IOException {
        json.name("noise").beginObject();
        json.name("stated").value(noise.stated());
        number("added_std_px", noise.addedStdPx());
        double[] quantiles = noise.addedQuantilesStdPx();
        if (quantiles != null) {
            number("added_std_px_q2_5", quantiles[0]);
            number("added_std_px_q50", quantiles[1]);
            number("added_std_px_q97_5", quantiles[2]);
        }
        json.name("fit").beginObject();
        json.name("holds").value(noise.holds());
        number("chi_square", noise.chiSquare());
        json.name("degrees_of_freedom").value(noise.degreesOfFreedom());
        number("p", noise.pValue());
        number("shown_std_px", noise.shownStdPx());
        json.name("references").beginObject();
        json.name("holds").value(references.fitTogether());
        number("chi_square", references.chiSquare());
        json.name("degrees_of_freedom").value(references.degreesOfFreedom());
        number("p", references.pValue());
        json.endObject();
        json.endObject();
        json.name("markers").beginObject();
        for (MarkerNoise marker : noise.markers()) {
            json.name(String.valueOf(marker.id())).beginObject();
            number("std_px", marker.stdPx());
            number("times_stated", marker.timesStated());
            number("set_aside_times", marker.setAsideTimes());
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

    private void settings(RunView run, CellView cell, NoiseView noise, ReferencesView references) throws IOException {
        CheckSettings s = run.settings();
        json.beginObject();
        for (Setting<?> setting : SettingTable.all()) {
            if (!setting.determinesFigures()) {
                continue;
            }
            json.name(setting.key());
            plain(setting.plain(s));
            if (setting == SettingTable.SAMPLER) {
                json.name("sampler_used").value(run.samplerUsed());
            } else if (setting == SettingTable.MAX_ITERATIONS) {
                json.name("iterations_run").value(run.iterationsPerChain());
            } else if (setting == SettingTable.POSE_PRIOR_ALLOWED) {
                json.name("pose_prior").value(run.posePrior());
            }
        }
        number("pixel_std_px", noise.usualStdPx());
        json.name("pixel_std_px_from").value(cell.pixelStdPx().isPresent() ? "cell file" : "photo");
        json.name("tone_curve").value(cell.toneCurve() == null ? "auto" : cell.toneCurve().words());
        json.name("prints").beginObject();
        number("size_std_mm", cell.sizeStdMm());
        number("flatness_mm", cell.flatnessMm());
        number("print_gain_std_mm", cell.printGainStdMm());
        json.endObject();
        json.name("marker_family").value(cell.family());
        json.name("camera_intrinsics");
        cameraIntrinsics(cell.camera());
        json.name("references").beginObject();
        Set<Integer> used = new HashSet<>(references.used());
        for (StatedReference reference : cell.references()) {
            json.name(String.valueOf(reference.id())).beginObject();
            json.name("used").value(used.contains(reference.id()));
            number("size_mm", reference.sizeMm());
            numbers("position_mm", reference.positionMm());
            numbers("rotation_rad", reference.rotationRad());
            json.name("placement").beginObject();
            numbers("std_mm", reference.stdMm());
            number("std_rad", reference.stdRad());
            json.endObject();
            json.endObject();
        }
        json.endObject();
        json.name("object_markers").beginObject();
        for (StatedObject marker : cell.objects()) {
            json.name(String.valueOf(marker.id())).beginObject();
            number("size_mm", marker.sizeMm());
            double[] grip = marker.gripMm();
            if (grip != null) {
                numbers("grip_mm", grip);
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
        number("outline_std_px", light.outlineStdPx());
        json.endObject();
    }

    /** A value as settings have it. */
    private void plain(@Nullable Object value) throws IOException {
        if (value instanceof Number) {
            json.value((Number) value);
        } else if (value instanceof Boolean) {
            json.value((Boolean) value);
        } else {
            json.value((String) value);
        }
    }

    private void cameraIntrinsics(PinholeCamera camera) throws IOException {
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

    // ---- estimates

    /** The members of a pose; the object around them may hold more. */
    private void poseMembers(PoseView pose) throws IOException {
        json.name("frame").value(pose.frame());
        strings("order", POSE_ORDER);
        numbers("mean", pose.mean());
        numbers("std", pose.std());
        matrix("covariance", pose.covariance());
        strings("tangent_order", TANGENT_ORDER);
        numbers("tangent_base", pose.tangentBaseRad());
        matrix("tangent_covariance", pose.tangentCovariance());
    }

    /** The modes of a pose; those that make it ambiguous have a name of their own. */
    private void modes(ResultRow row) throws IOException {
        if (row.modes().isEmpty()) {
            return;
        }
        json.name(row.ambiguous() ? "modes" : "lesser_modes").beginArray();
        for (ModeView mode : row.modes()) {
            json.beginObject();
            number("weight", mode.weight());
            poseMembers(mode.pose());
            json.endObject();
        }
        json.endArray();
    }

    private void intrinsics(ResultView view) throws IOException {
        int size = view.intrinsics().size();
        double[] mean = new double[size];
        double[] std = new double[size];
        double[] priorMean = new double[size];
        double[] priorStd = new double[size];
        String[] names = new String[size];
        String[] restsOn = new String[size];
        for (int i = 0; i < size; i++) {
            names[i] = view.intrinsics().get(i).name();
            priorMean[i] = view.intrinsics().get(i).priorMean();
            priorStd[i] = view.intrinsics().get(i).priorStd();
            restsOn[i] = view.intrinsics().get(i).restsOn();
            mean[i] = view.intrinsics().get(i).mean();
            std[i] = view.intrinsics().get(i).std();
        }
        json.beginObject();
        strings("names", List.of(names));
        numbers("mean", mean);
        numbers("std", std);
        matrix("covariance", view.intrinsicsCovariance());
        numbers("prior_mean", priorMean);
        numbers("prior_std", priorStd);
        json.name("calibrated").beginArray();
        for (ResultView.Intrinsic intrinsic : view.intrinsics()) {
            json.value(intrinsic.calibrated());
        }
        json.endArray();
        strings("rests_on", List.of(restsOn));
        json.endObject();
    }

    private void object(ResultView view, ResultRow object) throws IOException {
        ResultRow grip = view.grip(object.id().getAsInt());
        json.beginObject();
        json.name("within_target").value(object.withinTarget());
        number("worst_std_mm", view.worstStdMm(object));
        verdict("position_verdict", object);
        if (grip != null) {
            verdict("grip_verdict", grip);
        }
        conformity("position_conformity", object.conformities());
        if (grip != null) {
            conformity("grip_conformity", grip.conformities());
        }
        json.name("pose").beginObject();
        poseMembers(Objects.requireNonNull(object.pose()));
        json.endObject();
        if (grip != null) {
            json.name("grip").beginObject();
            numbers("mean", Objects.requireNonNull(grip.mean()));
            numbers("std", Objects.requireNonNull(grip.std()));
            matrix("covariance", Objects.requireNonNull(grip.covariance()));
            json.endObject();
        }
        budget("budget", object.budget());
        if (grip != null) {
            budget("grip_budget", grip.budget());
        }
        json.name("ellipse95_px");
        ellipse(object.ellipse95Px());
        if (grip != null) {
            json.name("grip_ellipse95_px");
            ellipse(grip.ellipse95Px());
        }
        modes(object);
        json.endObject();
    }

    private void verdict(String name, ResultRow row) throws IOException {
        if (row.verdict() != null) {
            json.name(name).value(row.verdict().key());
        }
    }

    private void budget(String name, List<BudgetShare> budget) throws IOException {
        shares(name, budget, -1, false);
        json.name(name + "_axes").beginObject();
        for (int axis = 0; axis < AXES.length; axis++) {
            shares(AXES[axis], budget, axis, false);
        }
        json.endObject();
        shares(name + "_gain", budget, -1, true);
        json.name(name + "_gain_axes").beginObject();
        for (int axis = 0; axis < AXES.length; axis++) {
            shares(AXES[axis], budget, axis, true);
        }
        json.endObject();
    }

    /** Shares or gains, all axes together (-1) or along one; no gain of what cannot be taken away. */
    private void shares(String name, List<BudgetShare> budget, int axis, boolean gains) throws IOException {
        json.name(name).beginObject();
        for (BudgetShare part : budget) {
            double value = gains ? axis < 0 ? part.gain() : part.gain(axis)
                    : axis < 0 ? part.share() : part.share(axis);
            if (!gains || !Double.isNaN(value)) {
                number(part.source().key(), value);
            }
        }
        json.endObject();
    }

    private void ellipse(@Nullable Ellipse ellipse) throws IOException {
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
    private void fit(ReferenceFitView fit) throws IOException {
        json.beginObject();
        json.name("used").value(fit.used());
        if (fit.used()) {
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

    private void misplaced(MisplacedView reference) throws IOException {
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
    private void without(WithoutView without) throws IOException {
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
        for (MovedObject object : without.objects()) {
            json.name(String.valueOf(object.id())).beginObject();
            json.name("pose").beginObject();
            poseMembers(object.pose());
            json.endObject();
            numbers("move_mm", object.moveMm());
            numbers("error_mm", object.errorMm());
            MovedGrip grip = object.grip();
            if (grip != null) {
                json.name("grip").beginObject();
                numbers("mean", grip.meanMm());
                numbers("std", grip.stdMm());
                matrix("covariance", grip.covarianceMm2());
                numbers("move_mm", grip.moveMm());
                numbers("error_mm", grip.errorMm());
                json.endObject();
            }
            json.endObject();
        }
        json.endObject();
        json.endObject();
    }

    /** What the photo contradicts, so that no target counts as met. */
    /** What explains that references do not fit together. */
    private void cause(CauseView cause) throws IOException {
        json.beginObject();
        json.name("cause").value(cause.cause());
        json.name("references").beginArray();
        for (int id : cause.references()) {
            json.value(id);
        }
        json.endArray();
        if (cause.axis() >= 0) {
            json.name("axis").value("xyz".substring(cause.axis(), cause.axis() + 1));
        }
        numbers("size", cause.size());
        number("std", cause.std());
        json.name("sentence").value(cause.sentence());
        json.name("or_instead").beginArray();
        for (CauseView.Other other : cause.orInstead()) {
            json.beginObject();
            json.name("cause").value(other.cause());
            json.name("phrase").value(other.phrase());
            json.endObject();
        }
        json.endArray();
        json.endObject();
    }

    private void misfit(@Nullable Misfit misfit) throws IOException {
        if (misfit == null) {
            json.nullValue();
            return;
        }
        OptionalInt marker = misfit.markerId();
        OptionalInt other = misfit.otherId();
        json.beginObject();
        json.name("kind").value(QuantityView.word(misfit.kind()));
        json.name("marker").value(marker.isPresent() ? marker.getAsInt() : null);
        json.name("other_marker").value(other.isPresent() ? other.getAsInt() : null);
        number("times", misfit.times());
        number("stated_std_px", misfit.statedStdPx());
        number("shown_std_px", misfit.shownStdPx());
        json.name("cause").value(misfit.causeText());
        json.endObject();
    }

    // ---- Laplace

    /**
     * The quick look: Laplace's approximation, how far the chains' means are from it and how large their deviations.
     */
    private void laplace(ResultView view) throws IOException {
        json.beginObject();
        json.name("camera").beginObject();
        comparison(view.camera(), "");
        json.endObject();
        json.name("objects").beginObject();
        for (ResultRow object : view.objects()) {
            if (!object.seen()) {
                continue;
            }
            ResultRow grip = view.grip(object.id().getAsInt());
            json.name(String.valueOf(object.id().getAsInt())).beginObject();
            comparison(object, "");
            if (grip != null) {
                comparison(grip, "grip_");
            }
            json.endObject();
        }
        json.endObject();
        json.endObject();
    }

    private void comparison(ResultRow row, String prefix) throws IOException {
        LaplaceView laplace = Objects.requireNonNull(row.laplace());
        numbers(prefix + "mean", laplace.mean());
        numbers(prefix + "std", laplace.std());
        numbers(prefix + "mean_shift_by_std", laplace.meanShiftByStd());
        numbers(prefix + "sampled_by_laplace", laplace.sampledByLaplace());
    }

    // ---- diagnostics

    private void diagnostics(ChainsView chains) throws IOException {
        json.beginObject();
        json.name("converged").value(chains.converged());
        json.name("convergence").value(chains.convergence());
        double[] numbers = chains.numbers();
        for (int i = 0; i < numbers.length; i++) {
            number(ChainsView.KEYS[i], numbers[i]);
        }
        json.name("precision_reached").value(chains.precisionReached());
        json.name("camera_evaluations").beginObject();
        json.name("tuning").value(chains.tuningEvaluations());
        json.name("chains").value(chains.chainEvaluations());
        json.endObject();
        json.name("worst_parameter").value(chains.worstParameter());
        json.name("parameters").beginObject();
        for (QuantityView quantity : chains.quantities()) {
            json.name(quantity.name()).beginObject();
            json.name("status").value(quantity.status());
            for (String key : QuantityView.KEYS) {
                number(key, quantity.number(key));
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
