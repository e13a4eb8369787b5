package org.cellgauge.settings;

import java.util.List;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import java.util.function.Predicate;
import org.cellgauge.settings.Setting.Part;

/**
 * All settings of a check, in the order in which files hold them. Options, ranges, files, reports and the command that
 * repeats a result are made from these rows: a new setting is a row here and whoever asks for its value.
 */
public final class SettingTable {
    /** Likelihood of the references' corners. */
    public static final Setting<LikelihoodModel> MODEL = Setting.of(Part.MODEL, "model",
            SettingForm.choice(LikelihoodModel.values()), LikelihoodModel.RIGID_MARKER,
            "How placement errors move corners: each reference as a rigid whole, or every corner on its own as in the "
                    + "thesis");

    /** Half extent of corner-cube's box in placement deviations. */
    public static final Setting<Double> KAPPA = Setting.of(Part.MODEL, "kappa", SettingForm.number("K"), 0.5,
            "Half extent of corner-cube's box in standard deviations")
            .within(positive(), SettingRefusal.NOT_POSITIVE);

    /** How the camera pose is sampled. */
    public static final Setting<SamplerKind> SAMPLER = Setting.of(Part.SAMPLING, "sampler",
            SettingForm.choice(SamplerKind.values()), SamplerKind.INDEPENDENCE, "How the camera pose is sampled");

    /** Number of chains. */
    public static final Setting<Integer> CHAINS = Setting.of(Part.SAMPLING, "chains", SettingForm.whole("N"), 4,
            "Number of chains")
            .within(n -> n >= 1 && n <= 1000, SettingRefusal.NOT_BETWEEN, 1, 1000);

    /** Iterations of each chain, warm-up included, where they are fixed. */
    public static final Setting<OptionalInt> ITERATIONS = Setting.of(Part.SAMPLING, "iterations",
            SettingForm.wholeOrOpen("N"), OptionalInt.empty(),
            "Iterations of each chain, warm-up included; without a number, as many as the wanted precision takes")
            .within(n -> n.orElse(CheckSettings.FEWEST_ITERATIONS) >= CheckSettings.FEWEST_ITERATIONS,
                    SettingRefusal.TOO_SMALL, CheckSettings.FEWEST_ITERATIONS);

    /** Monte Carlo error of every standard deviation, relative to it, at which sampling stops. */
    public static final Setting<Double> PRECISION = Setting.of(Part.SAMPLING, "target_mcse_std_rel",
            SettingForm.number("SHARE"), 0.02,
            "Chains run until the Monte Carlo error of every standard deviation is below this share of it")
            .named("precision").where(SettingTable::ofOpenLength)
            .within(share -> share > 0 && share < 1, SettingRefusal.NOT_BELOW_ALL);

    /** Cap on the iterations of each chain where they are not fixed. */
    public static final Setting<Integer> MAX_ITERATIONS = Setting.of(Part.SAMPLING, "max_iterations",
            SettingForm.whole("N"), 50_000,
            "Cap on the iterations of each chain, warm-up included, whatever the precision is by then; a warning says "
                    + "if it was not reached")
            .where(SettingTable::ofOpenLength)
            .within(n -> n >= CheckSettings.FEWEST_ITERATIONS,
                    SettingRefusal.TOO_SMALL, CheckSettings.FEWEST_ITERATIONS);

    /** Iterations of each chain that are not kept, where they are fixed. */
    public static final Setting<OptionalInt> WARMUP = Setting.of(Part.SAMPLING, "warmup",
            SettingForm.wholeOrOpen("N"), OptionalInt.empty(), "Iterations of each chain that are not kept")
            .usually("independence 200, adaptive 5000, thesis-mixture half of them");

    /** Seed of all randomness. */
    public static final Setting<Long> SEED = Setting.of(Part.SAMPLING, "seed", SettingForm.longWhole("SEED"), 1L,
            "Seed of everything random, the same seed gives the same figures; each photo has random numbers of its "
                    + "own, named by the seed and by the corners of its markers");

    /** Which intrinsics are sampled. */
    public static final Setting<Estimate> ESTIMATE = Setting.of(Part.MODEL, "estimate",
            SettingForm.choice(Estimate.values()), Estimate.NONE,
            "What of the camera is estimated along with its pose");

    /** Standard deviation of the prior of the focal length about the camera file's. */
    public static final Setting<Double> FOCAL_PRIOR_STD_PX = Setting.of(Part.MODEL, "focal_prior_std_px",
            SettingForm.numberOr("PX", "flat"), 200.0,
            "Where focal lengths are estimated: standard deviation of what is known of the focal length beforehand, "
                    + "about the camera file's fx, px; flat for nothing at all, which takes references that stand out "
                    + "of one plane")
            .in("px").where(SettingTable::focalUnknown).within(px -> px > 0, SettingRefusal.NOT_POSITIVE_IN, "px");

    /** The same as a share of the focal length, in place of px. */
    public static final Setting<OptionalDouble> FOCAL_PRIOR_SHARE = Setting.of(Part.MODEL, "focal_prior_share",
            SettingForm.numberOrOpen("SHARE"), OptionalDouble.empty(),
            "Where focal lengths are estimated: the same as a share of the focal length, in place of a number of px")
            .where(SettingTable::focalUnknown)
            .within(share -> positive().test(share.orElse(1)), SettingRefusal.NOT_ABOVE_NOTHING);

    /** Horizontal field of view that the prior of the focal length is about, in place of the camera file's fx. */
    public static final Setting<OptionalDouble> FIELD_OF_VIEW_DEG = Setting.of(Part.MODEL, "field_of_view_deg",
            SettingForm.numberOrOpen("DEG"), OptionalDouble.empty(),
            "Where focal lengths are estimated: horizontal field of view by the camera's data sheet, degrees; the "
                    + "focal length is about what it gives in place of the camera file's fx")
            .in("deg").where(SettingTable::focalUnknown)
            .within(deg -> deg.orElse(60) >= 1 && deg.orElse(60) <= 170, SettingRefusal.NOT_BETWEEN, 1, 170);

    /** Standard deviation of the prior of the aspect ratio fy / fx, as a share of the camera file's. */
    public static final Setting<Double> ASPECT_PRIOR_STD = Setting.of(Part.MODEL, "aspect_prior_std",
            SettingForm.numberOr("SHARE", "independent"), 0.005,
            "Where focal lengths are estimated: standard deviation of what is known of fy / fx beforehand, as a share "
                    + "of the camera file's; independent for two focal lengths that know nothing of each other, as in "
                    + "the thesis")
            .where(SettingTable::focalUnknown)
            .within(share -> share > 0, SettingRefusal.NOT_ABOVE_NOTHING);

    /** Standard deviation of the prior of each coordinate of the principal point. */
    public static final Setting<Double> PRINCIPAL_PRIOR_STD_PX = Setting.of(Part.MODEL, "principal_prior_std_px",
            SettingForm.number("PX"), 20.0,
            "Where all intrinsics are estimated: standard deviation of what is known of each coordinate of the "
                    + "principal point beforehand, about the camera file's, px")
            .in("px").where(SettingTable::allUnknown).within(positive(), SettingRefusal.NOT_POSITIVE_IN, "px");

    /** Standard deviation of the prior of the first two radial coefficients. */
    public static final Setting<Double> RADIAL_PRIOR_STD = Setting.of(Part.MODEL, "radial_prior_std",
            SettingForm.number("STD"), 0.1,
            "Where all intrinsics are estimated: standard deviation of what is known of the radial coefficients k1 and "
                    + "k2 beforehand, about the camera file's")
            .where(SettingTable::allUnknown).within(positive(), SettingRefusal.NOT_POSITIVE);

    /** Standard deviation of the prior of further radial coefficients; they are exact where there is none. */
    public static final Setting<OptionalDouble> HIGHER_RADIAL_PRIOR_STD = Setting.of(Part.MODEL,
            "higher_radial_prior_std", SettingForm.numberOrOpen("STD"), OptionalDouble.empty(),
            "Where all intrinsics are estimated: takes the radial coefficients from k3 on as unknown, too, with this "
                    + "standard deviation of what is known of each beforehand, about the camera file's")
            .where(SettingTable::allUnknown)
            .within(std -> positive().test(std.orElse(1)), SettingRefusal.NOT_POSITIVE);

    /** Standard deviation of the prior of the tangential coefficients; they are exact where there is none. */
    public static final Setting<OptionalDouble> TANGENTIAL_PRIOR_STD = Setting.of(Part.MODEL, "tangential_prior_std",
            SettingForm.numberOrOpen("STD"), OptionalDouble.empty(),
            "Where all intrinsics are estimated: takes the tangential coefficients p1 and p2 as unknown, too, with "
                    + "this standard deviation of what is known of each beforehand, about the camera file's")
            .where(SettingTable::allUnknown)
            .within(std -> positive().test(std.orElse(1)), SettingRefusal.NOT_POSITIVE);

    /** Whether the covariance that comes with a camera file counts. */
    public static final Setting<CalibrationUse> CALIBRATION = Setting.of(Part.MODEL, "calibration_use",
            SettingForm.choice(CalibrationUse.values()), CalibrationUse.UNCERTAIN,
            "Whether intrinsics are as uncertain as the calibration in the camera file says, or count as exact");

    /** Whether the camera is scaled to photos of another size. */
    public static final Setting<Boolean> SCALE_CAMERA = Setting.of(Part.MODEL, "scale_camera", SettingForm.flag(),
            false,
            "Whether the camera is scaled to photos of another size than it is calibrated for, which holds where they "
                    + "show the whole image, binned or scaled; other shapes are refused all the same");

    /** First estimate of the camera pose. */
    public static final Setting<InitialEstimate> INITIAL = Setting.of(Part.SAMPLING, "initial",
            SettingForm.choice(InitialEstimate.values()), InitialEstimate.PNP, "First estimate of the camera pose");

    /** Focal length that the search for the camera starts at. */
    public static final Setting<OptionalDouble> INITIAL_FOCAL_PX = Setting.of(Part.SAMPLING, "initial_focal_px",
            SettingForm.numberOrOpen("PX"), OptionalDouble.empty(),
            "Where focal lengths are estimated: the one that the search for the camera starts at, px, in place of what "
                    + "is known beforehand; no figure depends on it but by chance")
            .in("px").where(SettingTable::focalUnknown)
            .within(px -> positive().test(px.orElse(1)), SettingRefusal.NOT_POSITIVE_IN, "px");

    /** Where random walks start. */
    public static final Setting<ChainStart> START = Setting.of(Part.SAMPLING, "start",
            SettingForm.choice(ChainStart.values()), ChainStart.DISPERSED,
            "Where the chains of thesis-mixture start: at draws around the mode, or at the first estimate of the pose "
                    + "as in the thesis");

    /** What is taken of the noise in an object's own corners. */
    public static final Setting<ObjectNoise> OBJECT_NOISE = Setting.of(Part.MODEL, "object_noise",
            SettingForm.choice(ObjectNoise.values()), ObjectNoise.DETECTION,
            "Whether the noise in an object's own corners counts, or the camera's part alone is wanted");

    /** Prior over the camera's rotation. */
    public static final Setting<RotationPrior> ROTATION_PRIOR = Setting.of(Part.MODEL, "rotation_prior",
            SettingForm.choice(RotationPrior.values()), RotationPrior.UNIFORM,
            "What is taken of the camera's rotation beforehand: every one alike, or flat in the angles as in the "
                    + "thesis");

    /** Whether a weak prior on the pose may be added where two or fewer references leave directions open. */
    public static final Setting<Boolean> POSE_PRIOR_ALLOWED = Setting.of(Part.MODEL, "pose_prior_allowed",
            SettingForm.yesOrNo(), true,
            "Whether a weak prior on the camera pose may be added where two or fewer references leave directions open");

    /** Largest standard deviation allowed on any axis of any object and gripping point, in place of the cell's. */
    public static final Setting<OptionalDouble> TARGET_STD_MM = Setting.of(Part.MODEL, "target_std_mm",
            SettingForm.numberOrOpen("MM"), OptionalDouble.empty(),
            "Largest standard deviation allowed on any axis of any object and gripping point, mm, in place of the "
                    + "cell file's")
            .in("mm").named("target")
            .within(mm -> positive().test(mm.orElse(1)), SettingRefusal.NOT_POSITIVE_IN, "mm");

    /** Number of threads. */
    public static final Setting<Integer> THREADS = Setting.of(Part.SAMPLING, "threads", SettingForm.whole("N"),
            Math.max(1, Runtime.getRuntime().availableProcessors()), "Number of threads; no figure depends on it")
            .usually("all cores").withoutEffectOnFigures().within(n -> n >= 1, SettingRefusal.TOO_SMALL, 1);

    private static final List<Setting<?>> ALL = List.of(MODEL, KAPPA, SAMPLER, CHAINS, ITERATIONS, PRECISION,
            MAX_ITERATIONS, WARMUP, SEED, ESTIMATE, FOCAL_PRIOR_STD_PX, FOCAL_PRIOR_SHARE, FIELD_OF_VIEW_DEG,
            ASPECT_PRIOR_STD, PRINCIPAL_PRIOR_STD_PX, RADIAL_PRIOR_STD, HIGHER_RADIAL_PRIOR_STD, TANGENTIAL_PRIOR_STD,
            CALIBRATION, SCALE_CAMERA, INITIAL, INITIAL_FOCAL_PX, START, OBJECT_NOISE,
            ROTATION_PRIOR, POSE_PRIOR_ALLOWED, TARGET_STD_MM, THREADS);

    private SettingTable() {
    }

    /**
     * All rows.
     *
     * @return in the order of files
     */
    public static List<Setting<?>> all() {
        return ALL;
    }

    private static Predicate<Double> positive() {
        return value -> value > 0 && Double.isFinite(value);
    }

    private static boolean ofOpenLength(SettingSource settings) {
        return !settings.get(ITERATIONS).isPresent();
    }

    private static boolean focalUnknown(SettingSource settings) {
        return settings.get(ESTIMATE) != Estimate.NONE;
    }

    private static boolean allUnknown(SettingSource settings) {
        return settings.get(ESTIMATE) == Estimate.INTRINSICS;
    }
}
