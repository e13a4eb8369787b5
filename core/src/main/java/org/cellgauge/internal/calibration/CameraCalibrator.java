package org.cellgauge.internal.calibration;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;
import org.cellgauge.calibration.CalibrationOptions;
import org.cellgauge.calibration.CalibrationRefusal;
import org.cellgauge.calibration.CalibrationResult;
import org.cellgauge.calibration.CalibrationWarning;
import org.cellgauge.cell.InputRefusedException;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.geometry.RationalLens;
import org.cellgauge.internal.geometry.Cholesky;
import org.cellgauge.internal.geometry.Lenses;
import org.cellgauge.internal.warning.Decimal;
import org.cellgauge.internal.warning.Listing;
import org.cellgauge.vision.TargetObservation;
import org.cellgauge.vision.TargetPoints;
import org.cellgauge.warning.Refusal;
import org.cellgauge.warning.Warning;
import org.jspecify.annotations.Nullable;

/** From points of a target in photos to a calibrated camera, and what its figures are held against. */
public final class CameraCalibrator {
    /** Photos that a calibration takes at least. */
    static final int FEWEST_PHOTOS = 3;
    /** Photos from which odd and even ones can be calibrated apart. */
    static final int FEWEST_FOR_HALVES = 8;
    private static final int FEWEST_POINTS = 6;
    private static final int USUAL_WARP = 2;
    private static final double MOST_OUTLIERS = 0.03;
    private static final double GOOD_RATIO = 1;
    private static final double MODEL_ERROR_RATIO = 2;
    private static final double LARGEST_RMS_PX = 10;
    private static final double MOST_UNSURE_FOCAL = 0.05;
    private static final double TILTED_DEG = 20;
    private static final int ENOUGH_TILTED = 3;
    private static final double ONE_DISTANCE = 1.3;
    private static final double LITTLE_GAIN = 0.1;
    private static final double LEAST_COVERED = 0.75;
    private static final double CONTRADICTING = 2.5;
    private static final double TURNED_DEG = 45;
    private static final double MUCH_WEIGHT = 0.2;
    /** Deviation of a coefficient of a quotient above which it is not told. */
    private static final double MOST_OF_A_COEFFICIENT = 1;

    private final TargetPoints points;
    private final List<TargetObservation> given;
    private final List<TargetObservation> seen = new ArrayList<>();
    private final CalibrationOptions options;
    private final List<Warning> warnings = new ArrayList<>();
    /** Lenses and boards that the choice was among. */
    private final List<ModelAverage.Trial> trials = new ArrayList<>();
    /** Errors in photos held out by lens, px, with the chosen board; empty where none was tried. */
    private final Map<LensChoice, Double> ladder = new LinkedHashMap<>();

    /**
     * A calibration to be made.
     *
     * @param points the target
     * @param photos what photos show of it
     * @param options how
     */
    public CameraCalibrator(TargetPoints points, List<TargetObservation> photos, CalibrationOptions options) {
        this.points = points;
        this.given = photos;
        this.options = options;
    }

    /**
     * Names of the lenses that can be chosen.
     *
     * @return from the leanest to the richest
     */
    public static List<String> lenses() {
        return LensChoice.all().stream().map(LensChoice::name).toList();
    }

    /**
     * Makes it.
     *
     * @return the camera and all about it
     * @throws InputRefusedException if the photos give none, with what to photograph
     */
    public CalibrationResult run() {
        List<Object> without = new ArrayList<>();
        for (TargetObservation photo : given) {
            if (photo.count() >= FEWEST_POINTS || points.areCornersOfMarkers() && photo.count() >= 4) {
                seen.add(photo);
            } else {
                without.add(photo.name());
            }
        }
        if (!without.isEmpty()) {
            warnings.add(Warning.of(CalibrationWarning.NOT_FOUND, Listing.and(without)));
        }
        if (seen.size() < FEWEST_PHOTOS) {
            throw refused(CalibrationRefusal.TOO_FEW_PHOTOS, seen.size(), given.size(), FEWEST_PHOTOS);
        }
        TargetObservation first = seen.get(0);
        for (TargetObservation photo : seen) {
            if (photo.widthPx() != first.widthPx() || photo.heightPx() != first.heightPx()) {
                throw refused(CalibrationRefusal.SIZES_DIFFER, first.name(), first.widthPx(), first.heightPx(),
                        photo.name(), photo.widthPx(), photo.heightPx());
            }
        }
        LensChoice choice = LensChoice.all().stream().filter(c -> c.name().equals(options.lens())).findFirst()
                .orElse(LensChoice.usual());
        int warp = points.isFlat() ? Math.max(0, options.warp()) : 0;
        boolean aspect = points.isFlat() && options.aspect() == CalibrationOptions.Aspect.UNKNOWN;
        CalibrationFit fit = CalibrationFit.of(choice, points, seen, warp, aspect);
        requireSure(fit);
        if (points.isFlat() && options.aspect() == CalibrationOptions.Aspect.BY_PHOTOS && isTurned(fit)) {
            fit = fit.ofPhotos(choice, new BoardShape(points, warp, true), all(fit));
        }
        CalibrationFit usual = fit;
        fit = byHeldOut(usual, true);
        if (fit.choice.lens() == RationalLens.MODEL && options.lens().equals(CalibrationOptions.AUTO)
                && Double.isNaN(cross(anew(fit)).ratio())) {
            // nothing could be held against it, however well it does
            trials.clear();
            ladder.clear();
            fit = byHeldOut(usual, false);
        }
        // what the adjustment itself takes, all of it once
        long start = System.nanoTime();
        fit = anew(fit);
        return result(fit, (System.nanoTime() - start) * 1e-6);
    }

    private static InputRefusedException refused(CalibrationRefusal kind, Object... arguments) {
        return new InputRefusedException(Refusal.of(kind, arguments));
    }

    /** Whether the target was turned about the line of sight between photos, which tells its sides apart. */
    private static boolean isTurned(CalibrationFit fit) {
        double largest = 0;
        for (TargetPhoto a : fit.photos) {
            double turn = Math.toDegrees(Math.atan2(a.rotation[3], a.rotation[0]));
            double first = Math.toDegrees(Math.atan2(fit.photos.get(0).rotation[3], fit.photos.get(0).rotation[0]));
            // a half turn shows the same sides
            double apart = (turn - first + 720) % 180;
            largest = Math.max(largest, Math.min(apart, 180 - apart));
        }
        return largest > TURNED_DEG;
    }

    private void requireSure(CalibrationFit fit) {
        double rms = rms(fit);
        if (!(rms < LARGEST_RMS_PX)) {
            throw refused(CalibrationRefusal.NOTHING_FITS, Decimal.of(rms, 1));
        }
        double unsure = fit.covariance == null ? Double.POSITIVE_INFINITY
                : Math.sqrt(fit.covariance[0]) / fit.values[PinholeCamera.FX];
        if (unsure <= MOST_UNSURE_FOCAL) {
            return;
        }
        double tilt = fit.photos.stream().mapToDouble(p -> tiltDeg(fit, p)).max().orElse(0);
        if (points.isFlat() && tilt < TILTED_DEG || fit.covariance == null) {
            throw refused(CalibrationRefusal.FOCAL_UNKNOWN, Decimal.of(tilt, 0));
        }
        Warning next = next(fit);
        throw refused(CalibrationRefusal.FOCAL_TOO_UNSURE, Decimal.of(100 * unsure, 0),
                next == null ? Warning.of(CalibrationWarning.FEW_TILTS, 0) : next);
    }

    private @Nullable Warning next(CalibrationFit fit) {
        return NextPhoto.of(fit, map(fit), fit.information, seen.get(0).widthPx(), seen.get(0).heightPx());
    }

    /**
     * Chooses lens and warp by photos held out: every unknown more has to earn the logarithm of the number of errors
     * there (G. Schwarz, "Estimating the dimension of a model", 1978). What the options state is not chosen.
     *
     * @param withRational whether a quotient of polynomials is among the lenses
     */
    private CalibrationFit byHeldOut(CalibrationFit usual, boolean withRational) {
        if (seen.size() < FEWEST_FOR_HALVES) {
            return usual;
        }
        List<LensChoice> lenses = LensChoice.ladder().stream().anyMatch(c -> c.name().equals(usual.choice.name()))
                ? LensChoice.ladder() : List.of(usual.choice);
        List<BoardShape> boards = new ArrayList<>(List.of(usual.board));
        if (points.isFlat() && options.warp() == CalibrationOptions.BY_PHOTOS) {
            boards.add(new BoardShape(points, USUAL_WARP, usual.board.aspect));
        }
        double[][] errors = new double[boards.size()][lenses.size()];
        double least = Double.POSITIVE_INFINITY;
        for (int b = 0; b < boards.size(); b++) {
            for (int l = 0; l < lenses.size(); l++) {
                errors[b][l] = withRational || lenses.get(l).lens() != RationalLens.MODEL
                        ? heldOut(usual, lenses.get(l), boards.get(b)) : Double.POSITIVE_INFINITY;
                least = Math.min(least, errors[b][l]);
            }
        }
        int freedom = heldOutFreedom(usual);
        int board = 0;
        int lens = lenses.indexOf(lenses.stream().filter(c -> c.name().equals(usual.choice.name())).findFirst()
                .orElseThrow());
        int stated = lens;
        double best = Double.POSITIVE_INFINITY;
        for (int b = 0; b < boards.size(); b++) {
            for (int l = stated; l < lenses.size(); l++) {
                if (l != stated && !(options.lens().equals(CalibrationOptions.AUTO)
                        && Double.isFinite(errors[b][l]))) {
                    continue;
                }
                double deviance = freedom * errors[b][l] * errors[b][l] / (least * least);
                trials.add(new ModelAverage.Trial(lenses.get(l), boards.get(b), deviance));
                double score = deviance
                        + (lenses.get(l).unknowns() + boards.get(b).unknowns()) * Math.log(freedom);
                if (score < best) {
                    best = score;
                    board = b;
                    lens = l;
                }
            }
        }
        for (int l = 0; l < lenses.size(); l++) {
            ladder.put(lenses.get(l), errors[board][l]);
        }
        return usual.ofPhotos(lenses.get(lens), boards.get(board), all(usual));
    }

    private static List<Integer> all(CalibrationFit fit) {
        return IntStream.range(0, fit.photos.size()).boxed().toList();
    }

    private static int heldOutFreedom(CalibrationFit fit) {
        return Math.max(1, fit.photos.stream().filter(p -> p.activeCount() >= 4)
                .mapToInt(p -> 2 * p.activeCount() - 6).sum());
    }

    private static List<Integer> half(CalibrationFit fit, int parity) {
        return IntStream.range(0, fit.photos.size()).filter(i -> i % 2 == parity).boxed().toList();
    }

    /** Deviation of a coordinate in photos that the fit has not seen, px. */
    private double heldOut(CalibrationFit fit, LensChoice choice, BoardShape board) {
        double sum = 0;
        for (int parity = 0; parity < 2; parity++) {
            List<TargetPhoto> others = half(fit, 1 - parity).stream().map(fit.photos::get)
                    .filter(p -> p.activeCount() >= 4).toList();
            CalibrationFit part = fit.ofPhotos(choice, board, half(fit, parity));
            // what half of the photos do not tell, nothing could be held against
            sum += part.covariance == null || hasPole(part) || isUntold(part) ? Double.POSITIVE_INFINITY
                    : part.heldOut(others);
        }
        return Math.sqrt(sum / heldOutFreedom(fit));
    }

    /** The same lens and board from nothing. */
    private CalibrationFit anew(CalibrationFit fit) {
        return CalibrationFit.of(fit.choice, points, seen, fit.board.warp, fit.board.aspect);
    }

    private CrossValidation cross(CalibrationFit fit) {
        return CrossValidation.of(fit, map(fit), half(fit, 0), half(fit, 1));
    }

    private ProjectionMap map(CalibrationFit fit) {
        int width = seen.get(0).widthPx();
        int height = seen.get(0).heightPx();
        return new ProjectionMap(fit.choice, fit.values, width, height, new Coverage(fit.photos, width, height));
    }

    /** Whether a quotient of polynomials folds the image, as it readily does where few photos tell its coefficients. */
    private boolean hasPole(CalibrationFit fit) {
        return fit.choice.lens() == RationalLens.MODEL && Lenses.foldWithin(camera(fit)) != null;
    }

    /**
     * Whether photos leave a coefficient of a quotient of polynomials open, by a deviation above
     * {@link #MOST_OF_A_COEFFICIENT}: numerator and denominator then cancel over all of the image, values run off along
     * a bent ridge (k1 and k4 of -17 each for a lens of -0.2), and no covariance at the mode describes that.
     */
    private static boolean isUntold(CalibrationFit fit) {
        double[] covariance = fit.covariance;
        if (fit.choice.lens() != RationalLens.MODEL || covariance == null) {
            return false;
        }
        List<String> names = fit.choice.lens().parameterNames();
        for (int u = 0; u < fit.choice.unknowns(); u++) {
            if (names.get(fit.choice.parameter(u)).startsWith("k")
                    && !(covariance[u * (fit.globals + 1)] < MOST_OF_A_COEFFICIENT * MOST_OF_A_COEFFICIENT)) {
                return true;
            }
        }
        return false;
    }

    private PinholeCamera camera(CalibrationFit fit) {
        return PinholeCamera.of(fit.choice.lens(), seen.get(0).widthPx(), seen.get(0).heightPx(),
                Arrays.copyOf(fit.values, fit.choice.lens().parameterCount()));
    }

    private static double rms(CalibrationFit fit) {
        double sum = 0;
        int n = 0;
        for (TargetPhoto photo : fit.photos) {
            double[] e = fit.residuals(photo);
            for (int i = 0; i < photo.count; i++) {
                if (photo.active[i]) {
                    sum += e[2 * i] * e[2 * i] + e[2 * i + 1] * e[2 * i + 1];
                    n++;
                }
            }
        }
        return Math.sqrt(sum / n);
    }

    private static double[] middleInCamera(CalibrationFit fit, TargetPhoto photo) {
        double[] sum = new double[3];
        double[] point = new double[3];
        for (int index : photo.points) {
            fit.board.point(index, fit.values, fit.choice.lens().parameterCount(), point);
            for (int k = 0; k < 3; k++) {
                sum[k] += point[k] / photo.count;
            }
        }
        double[] out = new double[3];
        for (int k = 0; k < 3; k++) {
            out[k] = photo.rotation[3 * k] * sum[0] + photo.rotation[3 * k + 1] * sum[1]
                    + photo.rotation[3 * k + 2] * sum[2] + photo.translation[k];
        }
        return out;
    }

    private static double distanceMm(CalibrationFit fit, TargetPhoto photo) {
        double[] middle = middleInCamera(fit, photo);
        return Math.sqrt(middle[0] * middle[0] + middle[1] * middle[1] + middle[2] * middle[2]);
    }

    private static double tiltDeg(CalibrationFit fit, TargetPhoto photo) {
        double[] middle = middleInCamera(fit, photo);
        double cosine = (photo.rotation[2] * middle[0] + photo.rotation[5] * middle[1] + photo.rotation[8] * middle[2])
                / distanceMm(fit, photo);
        return Math.toDegrees(Math.acos(Math.min(1, Math.abs(cosine))));
    }

    // ---- the result

    private CalibrationResult result(CalibrationFit fit, double milliseconds) {
        int width = seen.get(0).widthPx();
        int height = seen.get(0).heightPx();
        double[] own = fit.covariance;
        if (own == null) {
            throw refused(CalibrationRefusal.FOCAL_UNKNOWN, Decimal.of(0, 0));
        }
        Coverage coverage = new Coverage(fit.photos, width, height);
        ProjectionMap map = new ProjectionMap(fit.choice, fit.values, width, height, coverage);
        PinholeCamera camera = camera(fit);
        double[] fold = camera.isDistorting() && !camera.lens().isWide() ? Lenses.foldWithin(camera) : null;
        if (fold != null) {
            throw refused(CalibrationRefusal.LENS_FOLDS, fit.choice.name(), (int) fold[0], (int) fold[1]);
        }
        List<CalibrationResult.Residual> residuals = residuals(fit);
        int outliers = (int) residuals.stream().filter(CalibrationResult.Residual::outlier).count();
        List<CalibrationResult.Photo> photos = photos(fit, map, own);
        boolean inQuestion = warnOfOutliers(outliers, residuals.size(), photos);
        CrossValidation cross = CrossValidation.of(fit, map, half(fit, 0), half(fit, 1));
        double widened = warnOfModel(cross, fit);
        ModelAverage average = new ModelAverage(fit, own, trials, cross.ratio());
        LensChoice choice = average.choice;
        double[] covariance = average.covariance;
        ProjectionMap surety = choice == fit.choice ? map
                : new ProjectionMap(choice, fit.values, width, height, coverage);
        warnOfChoice(fit, average);
        warnOfPhotos(coverage, photos);
        warnOfBend(fit, cross.ratio());
        double[] field = {fieldDeg(camera, 0, height / 2.0, width, height / 2.0),
            fieldDeg(camera, width / 2.0, 0, width / 2.0, height)};
        if (field[0] < 5 || field[0] > 120 && !camera.lens().isWide()) {
            warnings.add(Warning.of(CalibrationWarning.ODD_FIELD_OF_VIEW, Decimal.of(field[0], 0)));
        }
        double distance = options.distanceMm() > 0 ? options.distanceMm()
                : photos.stream().mapToDouble(CalibrationResult.Photo::distanceMm).average().orElse(0);
        int lensUnknowns = choice.unknowns();
        List<List<Double>> exported = new ArrayList<>();
        List<CalibrationResult.Parameter> parameters = new ArrayList<>();
        for (int a = 0; a < lensUnknowns; a++) {
            List<Double> row = new ArrayList<>();
            for (int b = 0; b < lensUnknowns; b++) {
                row.add(widened * widened * covariance[a * lensUnknowns + b]);
            }
            exported.add(row);
            int index = choice.parameter(a);
            parameters.add(new CalibrationResult.Parameter(fit.choice.lens().parameterNames().get(index),
                    fit.values[index], Math.sqrt(row.get(a))));
        }
        List<CalibrationResult.Parameter> board = new ArrayList<>();
        for (int k = 0; k < fit.board.unknowns(); k++) {
            int g = fit.choice.unknowns() + k;
            board.add(new CalibrationResult.Parameter(k < fit.board.warp ? "warp_" + (k + 1) + "_mm" : "aspect",
                    fit.values[fit.choice.lens().parameterCount() + k],
                    widened * Math.sqrt(own[g * (fit.globals + 1)])));
        }
        CalibrationResult.Figures figures = new CalibrationResult.Figures(residuals.size() - outliers, outliers,
                rms(fit), fit.stdPx, milliseconds, coverage.share(), field[0], field[1], distance, cross.ratio());
        return new CalibrationResult(camera, fit.choice.name(), parameters, exported, widened, board, figures, photos,
                residuals, places(surety, covariance, lensUnknowns, widened, cross), ProjectionMap.COLUMNS,
                trials(average), warnings,
                NextPhoto.of(fit, map, fit.information, width, height), inQuestion);
    }

    private static double fieldDeg(PinholeCamera camera, double u0, double v0, double u1, double v1) {
        double[] a = new double[3];
        double[] b = new double[3];
        if (!camera.toRay(u0, v0, a) || !camera.toRay(u1, v1, b)) {
            return Double.NaN;
        }
        double x = a[1] * b[2] - a[2] * b[1];
        double y = a[2] * b[0] - a[0] * b[2];
        double z = a[0] * b[1] - a[1] * b[0];
        return Math.toDegrees(Math.atan2(Math.sqrt(x * x + y * y + z * z), a[0] * b[0] + a[1] * b[1] + a[2] * b[2]));
    }

    private static List<CalibrationResult.Residual> residuals(CalibrationFit fit) {
        List<CalibrationResult.Residual> out = new ArrayList<>();
        for (int p = 0; p < fit.photos.size(); p++) {
            TargetPhoto photo = fit.photos.get(p);
            double[] e = fit.residuals(photo);
            for (int i = 0; i < photo.count; i++) {
                out.add(new CalibrationResult.Residual(p, photo.uv[2 * i], photo.uv[2 * i + 1], e[2 * i],
                        e[2 * i + 1], !photo.active[i]));
            }
        }
        return out;
    }

    private List<CalibrationResult.LensTrial> trials(ModelAverage average) {
        List<CalibrationResult.LensTrial> out = new ArrayList<>();
        ladder.forEach((lens, error) -> out.add(new CalibrationResult.LensTrial(lens.name(), lens.unknowns(), error,
                average.weight(lens))));
        return out;
    }

    private static List<CalibrationResult.Place> places(ProjectionMap map, double[] covariance, int size,
            double widened, CrossValidation cross) {
        List<CalibrationResult.Place> out = new ArrayList<>();
        for (int k = 0; k < map.u.length; k++) {
            out.add(new CalibrationResult.Place(map.u[k], map.v[k],
                    map.seen[k] ? widened * map.stdPx(k, covariance, size) : Double.NaN, cross.differencePx(k),
                    cross.ratio(k)));
        }
        return out;
    }

    private static List<CalibrationResult.Photo> photos(CalibrationFit fit, ProjectionMap map, double[] covariance) {
        double variance = map.meanVariance(covariance, fit.globals);
        int count = fit.photos.size();
        double[] rms = new double[count];
        double[] gain = new double[count];
        for (int p = 0; p < count; p++) {
            TargetPhoto photo = fit.photos.get(p);
            double[] e = fit.residuals(photo);
            double sum = 0;
            for (int i = 0; i < photo.count; i++) {
                sum += photo.active[i] ? e[2 * i] * e[2 * i] + e[2 * i + 1] * e[2 * i + 1] : 0;
            }
            rms[p] = Math.sqrt(sum / Math.max(1, photo.activeCount()));
            double[] rest = fit.information.clone();
            for (int i = 0; i < rest.length; i++) {
                rest[i] -= photo.reduced[i];
            }
            gain[p] = map.meanVariance(Cholesky.inverse(rest, fit.globals), fit.globals) / variance - 1;
        }
        double[] sorted = rms.clone();
        Arrays.sort(sorted);
        double median = sorted[count / 2];
        List<CalibrationResult.Photo> out = new ArrayList<>();
        for (int p = 0; p < count; p++) {
            TargetPhoto photo = fit.photos.get(p);
            int left = photo.count - photo.activeCount();
            out.add(new CalibrationResult.Photo(photo.name, photo.count, left, rms[p], tiltDeg(fit, photo),
                    distanceMm(fit, photo), gain[p], rms[p] > CONTRADICTING * median || left > photo.count / 4,
                    gain[p] < LITTLE_GAIN / count));
        }
        return out;
    }

    private boolean warnOfOutliers(int outliers, int all, List<CalibrationResult.Photo> photos) {
        if (outliers > 0) {
            List<CalibrationResult.Photo> most = photos.stream().filter(p -> p.outliers() > 0)
                    .sorted(Comparator.comparingInt(CalibrationResult.Photo::outliers).reversed()).limit(5).toList();
            warnings.add(Warning.of(CalibrationWarning.OUTLIERS, outliers, all,
                    Listing.and(most.stream().map(CalibrationResult.Photo::name).toList())));
        }
        boolean inQuestion = outliers > MOST_OUTLIERS * all;
        if (inQuestion) {
            warnings.add(Warning.of(CalibrationWarning.IN_QUESTION, Decimal.of(100.0 * outliers / all, 1)));
        }
        return inQuestion;
    }

    private double warnOfModel(CrossValidation cross, CalibrationFit fit) {
        if (Double.isNaN(cross.ratio())) {
            warnings.add(fit.photos.size() < FEWEST_FOR_HALVES
                    ? Warning.of(CalibrationWarning.NOT_CROSS_VALIDATED, FEWEST_FOR_HALVES)
                    : Warning.of(CalibrationWarning.HALVES_DO_NOT_TELL, fit.choice.name()));
            return 1;
        }
        Decimal ratio = Decimal.of(cross.ratio(), 1);
        if (cross.ratio() > MODEL_ERROR_RATIO) {
            warnings.add(Warning.of(CalibrationWarning.MODEL_ERROR, ratio, ratio));
            return cross.ratio();
        }
        if (cross.ratio() > (GOOD_RATIO + MODEL_ERROR_RATIO) / 2) {
            warnings.add(Warning.of(CalibrationWarning.SOME_MODEL_ERROR, ratio));
        }
        return 1;
    }

    private void warnOfChoice(CalibrationFit fit, ModelAverage average) {
        double others = 1 - average.weight(fit.choice);
        if (others > MUCH_WEIGHT) {
            warnings.add(Warning.of(CalibrationWarning.LENS_OPEN, fit.choice.name(),
                    Listing.and(ladder.keySet().stream().filter(l -> l != fit.choice
                            && average.weight(l) > MUCH_WEIGHT / ladder.size()).map(LensChoice::name).toList()),
                    Decimal.of(100 * others, 0)));
        }
    }

    private void warnOfBend(CalibrationFit fit, double crossRatio) {
        BoardBend bend = points.isFlat() ? BoardBend.of(fit, crossRatio) : null;
        if (bend != null && bend.isThere()) {
            // target files of others count in squares, of which a bend is a small part
            int decimals = (int) Math.max(2, 1 - Math.floor(Math.log10(bend.stdMm())));
            warnings.add(Warning.of(fit.board.warp == 0 ? CalibrationWarning.BENT : CalibrationWarning.BENT_OTHERWISE,
                    Decimal.of(bend.heightMm(), decimals), Decimal.of(bend.stdMm(), decimals)));
        }
    }

    private void warnOfPhotos(Coverage coverage, List<CalibrationResult.Photo> photos) {
        name(CalibrationWarning.CONTRADICTS, photos.stream().filter(CalibrationResult.Photo::contradicts).toList());
        name(CalibrationWarning.ADDS_LITTLE, photos.stream().filter(CalibrationResult.Photo::addsLittle).toList());
        if (coverage.share() < LEAST_COVERED) {
            warnings.add(Warning.of(CalibrationWarning.NOT_COVERED, Decimal.of(100 * (1 - coverage.share()), 0),
                    NextPhoto.ofNinth(coverage.leastCoveredNinth())));
        }
        if (!points.isFlat()) {
            return;
        }
        long tilted = photos.stream().filter(p -> p.tiltDeg() > TILTED_DEG).count();
        if (tilted < ENOUGH_TILTED) {
            warnings.add(Warning.of(CalibrationWarning.FEW_TILTS, (int) tilted));
        }
        double nearest = photos.stream().mapToDouble(CalibrationResult.Photo::distanceMm).min().orElse(1);
        double farthest = photos.stream().mapToDouble(CalibrationResult.Photo::distanceMm).max().orElse(1);
        if (farthest < ONE_DISTANCE * nearest) {
            warnings.add(Warning.of(CalibrationWarning.ONE_DISTANCE, Decimal.of(farthest / nearest, 2)));
        }
    }

    private void name(CalibrationWarning kind, List<CalibrationResult.Photo> photos) {
        if (!photos.isEmpty()) {
            warnings.add(Warning.of(kind, Listing.and(photos.stream().map(CalibrationResult.Photo::name).toList())));
        }
    }
}
