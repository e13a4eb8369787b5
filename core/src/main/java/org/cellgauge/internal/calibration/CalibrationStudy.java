package org.cellgauge.internal.calibration;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import java.util.function.IntConsumer;
import java.util.stream.IntStream;
import org.cellgauge.calibration.CalibrationOptions;
import org.cellgauge.calibration.CalibrationResult;
import org.cellgauge.calibration.CalibrationWarning;
import org.cellgauge.cell.CameraCalibration;
import org.cellgauge.cell.Cell;
import org.cellgauge.cell.InputRefusedException;
import org.cellgauge.geometry.BrownLens;
import org.cellgauge.geometry.Lens;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.internal.geometry.Rotations;
import org.cellgauge.vision.TargetObservation;
import org.cellgauge.vision.TargetPoints;
import org.jspecify.annotations.Nullable;

/**
 * Are stated deviations of calibrations right? Calibrations simulated with a known camera: errors of every parameter
 * and of the projection at nine places of the image, over what was stated of them. Corners are drawn, not photos.
 */
public final class CalibrationStudy {
    /** A choice of photos, a board and what is modelled of it. */
    public enum Scene {
        /** 20 photos all over the image, tilted by 15 to 45 degrees to all sides, near and far. */
        GOOD("good photos", 0, 20, false, 0, 0),
        /** The same, lens and board chosen by the photos. */
        GOOD_CHOSEN("good, all chosen", 0, 20, false, 0, CalibrationOptions.BY_PHOTOS),
        /** 8 photos in the middle of the image, tilted by at most 20 degrees, from one distance. */
        POOR("poor photos", 1, 8, true, 0, 0),
        /** The same, lens and board chosen by the photos. */
        POOR_CHOSEN("poor, all chosen", 1, 8, true, 0, CalibrationOptions.BY_PHOTOS),
        /** The good photos of a board that is bent by 0.5 mm over 300 mm, taken for flat. */
        BENT_TAKEN_FOR_FLAT("bent, taken for flat", 2, 20, false, 0.5, 0),
        /** The same with two coefficients of warp unknown. */
        BENT("bent, warp unknown", 3, 20, false, 0.5, 2);

        private final String words;
        /** Which random numbers are its own. */
        private final long stream;
        private final int photos;
        private final boolean poor;
        private final double warpMm;
        private final int modelled;

        Scene(String words, long stream, int photos, boolean poor, double warpMm, int modelled) {
            this.words = words;
            this.stream = stream;
            this.photos = photos;
            this.poor = poor;
            this.warpMm = warpMm;
            this.modelled = modelled;
        }

        /**
         * The scene in a few words.
         *
         * @return as headers of tables have it
         */
        public String words() {
            return words;
        }
    }

    /**
     * What came of one scene.
     *
     * @param names of the parameters
     * @param ratios root mean square error of each over root mean square stated deviation
     * @param places the same of the projection at nine places, row by row
     * @param meanStdPx stated deviation of the projection, mean over the nine places, px
     * @param beyondTwo share of calibrations whose odd and even photos differ by more than 2 deviations
     * @param bent share of calibrations that call the board bent in a way that is not modelled
     * @param failed calibrations without a covariance
     */
    public record Outcome(List<String> names, List<Double> ratios, List<Double> places, double meanStdPx,
            double beyondTwo, double bent, int failed) {
    }

    private static final int ROWS = 8;
    private static final int COLUMNS = 11;
    private static final double SQUARE_MM = 30;
    /** Of a camera whose image is as wide as 1280 px are with 900 px of focal length; others go nearer or farther. */
    private static final double FOCAL_SHARE = 900.0 / 1280;
    private static final PinholeCamera CAMERA = PinholeCamera.of(BrownLens.MODEL, 1280, 720,
            new double[] {900, 902, 649, 354, 0, -0.2, 0.08, 0, 5e-4, -3e-4});
    private static final int[] PLACE_COLUMNS = {1, ProjectionMap.COLUMNS / 2, ProjectionMap.COLUMNS - 2};
    private static final int[] PLACE_ROWS = {1, ProjectionMap.ROWS / 2, ProjectionMap.ROWS - 2};

    private final TargetPoints points;
    private final LensChoice choice = LensChoice.ladder().get(2);
    private final PinholeCamera camera;
    private final double[] truth;
    private final double noisePx;
    private final long seed;

    /**
     * A study of a usual camera.
     *
     * @param noisePx deviation of a corner's coordinate, px
     * @param seed of all that is drawn
     */
    public CalibrationStudy(double noisePx, long seed) {
        this(CAMERA, noisePx, seed);
    }

    private CalibrationStudy(PinholeCamera camera, double noisePx, long seed) {
        this.camera = camera;
        truth = camera.intrinsics();
        this.noisePx = noisePx;
        this.seed = seed;
        double[] xy = new double[2 * ROWS * COLUMNS];
        for (int i = 0; i < ROWS * COLUMNS; i++) {
            int row = i / COLUMNS;
            xy[2 * i] = (i % COLUMNS - (COLUMNS - 1) / 2.0) * SQUARE_MM;
            xy[2 * i + 1] = (row - (ROWS - 1) / 2.0) * SQUARE_MM;
        }
        points = TargetPoints.flat(xy);
    }

    /**
     * A cell whose camera has been calibrated as users do it: from simulated photos of a board, all over the image,
     * lens and board chosen by the photos.
     *
     * @param cell with the true camera, of a lens that is not wide
     * @param photos how many photos the calibration takes
     * @param noisePx deviation of a corner's coordinate, px
     * @param seed of all that is drawn
     * @return the cell with the camera that was found and with what the calibration leaves open of it
     * @throws InputRefusedException if the photos determine no camera
     */
    public static Cell calibrated(Cell cell, int photos, double noisePx, long seed) {
        CalibrationStudy study = new CalibrationStudy(cell.camera(), noisePx, seed);
        CalibrationResult result = new CameraCalibrator(study.points, study.photos(Scene.GOOD, photos, 0),
                CalibrationOptions.USUAL).run();
        List<String> names = result.parameters().stream().map(p -> CameraCalibration.name(p.name())).toList();
        return cell.withCamera(result.camera())
                .withCalibration(new CameraCalibration(names, flat(result.covariance()), photos));
    }

    private static double[] flat(List<List<Double>> rows) {
        return rows.stream().flatMap(List::stream).mapToDouble(v -> v).toArray();
    }

    /**
     * Simulates calibrations.
     *
     * @param scene which
     * @param simulations how many
     * @param progress told how many are done
     * @return errors over deviations
     */
    public Outcome run(Scene scene, int simulations, IntConsumer progress) {
        int unknowns = choice.unknowns();
        double[] errors = new double[unknowns];
        double[] variances = new double[unknowns];
        double[] placeErrors = new double[9];
        double[] placeVariances = new double[9];
        int beyond = 0;
        int bent = 0;
        int failed = 0;
        for (int s = 0; s < simulations; s++) {
            Estimate estimate = estimate(scene, photos(scene, s));
            progress.accept(s + 1);
            if (estimate == null) {
                failed++;
                continue;
            }
            for (int k = 0; k < unknowns; k++) {
                int i = estimate.choice.lens().parameterNames()
                        .indexOf(choice.lens().parameterNames().get(choice.parameter(k)));
                double error = estimate.values[i] - truth[choice.parameter(k)];
                errors[k] += error * error;
                int u = estimate.choice.unknown(i);
                variances[k] += u < 0 ? 0 : estimate.covariance[u * (estimate.size + 1)];
            }
            double[] shifts = estimate.map.difference(estimate.values, truth(estimate.choice.lens()));
            for (int k = 0; k < 9; k++) {
                int place = PLACE_ROWS[k / 3] * ProjectionMap.COLUMNS + PLACE_COLUMNS[k % 3];
                placeErrors[k] += shifts[2 * place] * shifts[2 * place] + shifts[2 * place + 1] * shifts[2 * place + 1];
                double[] c = estimate.map.covariance(place, estimate.covariance, estimate.size);
                placeVariances[k] += c[0] + c[2];
            }
            beyond += estimate.crossRatio > 2 ? 1 : 0;
            bent += estimate.bent ? 1 : 0;
        }
        List<String> names = new ArrayList<>();
        List<Double> ratios = new ArrayList<>();
        for (int k = 0; k < unknowns; k++) {
            names.add(BrownLens.MODEL.parameterNames().get(choice.parameter(k)));
            ratios.add(Math.sqrt(errors[k] / variances[k]));
        }
        List<Double> places = new ArrayList<>();
        double std = 0;
        for (int k = 0; k < 9; k++) {
            places.add(Math.sqrt(placeErrors[k] / placeVariances[k]));
            std += Math.sqrt(placeVariances[k] / 2 / (simulations - failed)) / 9;
        }
        return new Outcome(names, ratios, places, std, (double) beyond / simulations,
                (double) bent / simulations, failed);
    }

    /** The true values as a lens has them whose names are among its own. */
    private double[] truth(Lens lens) {
        return lens.parameterNames().stream().mapToInt(camera.lens().parameterNames()::indexOf)
                .mapToDouble(i -> i < 0 ? 0 : truth[i]).toArray();
    }

    /** What one calibration says: values of the lens first, covariance of the unknowns of a choice first. */
    private static final class Estimate {
        final LensChoice choice;
        final double[] values;
        final double[] covariance;
        final int size;
        final ProjectionMap map;
        final double crossRatio;
        final boolean bent;

        Estimate(LensChoice choice, double[] values, double[] covariance, int size, ProjectionMap map,
                double crossRatio, boolean bent) {
            this.choice = choice;
            this.values = values;
            this.covariance = covariance;
            this.size = size;
            this.map = map;
            this.crossRatio = crossRatio;
            this.bent = bent;
        }
    }

    /** The calibration of a scene's photos; null where they determine none. */
    private @Nullable Estimate estimate(Scene scene, List<TargetObservation> photos) {
        if (scene.modelled == CalibrationOptions.BY_PHOTOS) {
            return chosen(photos);
        }
        CalibrationFit fit = CalibrationFit.of(choice, points, photos, scene.modelled, false);
        double[] covariance = fit.covariance;
        if (covariance == null) {
            return null;
        }
        ProjectionMap map = new ProjectionMap(choice, fit.values, camera.widthPx(), camera.heightPx(),
                new Coverage(fit.photos, camera.widthPx(), camera.heightPx()));
        CrossValidation cross = CrossValidation.of(fit, map, half(scene, 0), half(scene, 1));
        BoardBend bend = BoardBend.of(fit, cross.ratio());
        return new Estimate(choice, fit.values, covariance, fit.globals, map, cross.ratio(),
                bend != null && bend.isThere());
    }

    private @Nullable Estimate chosen(List<TargetObservation> photos) {
        try {
            return estimate(new CameraCalibrator(points, photos, CalibrationOptions.USUAL).run(), photos);
        } catch (InputRefusedException e) {
            return null;
        }
    }

    private static Estimate estimate(CalibrationResult result, List<TargetObservation> photos) {
        PinholeCamera camera = result.camera();
        int n = result.parameters().size();
        double[] covariance = flat(result.covariance());
        LensChoice of = LensChoice.ladder().stream().filter(c -> c.unknowns() == n
                && c.lens() == result.camera().lens()).findFirst().orElseThrow();
        double[] values = result.camera().intrinsics();
        Coverage coverage = new Coverage(photos.stream().map(p -> new TargetPhoto(p, false)).toList(),
                camera.widthPx(), camera.heightPx());
        ProjectionMap map = new ProjectionMap(of, values, camera.widthPx(), camera.heightPx(), coverage);
        return new Estimate(of, values, covariance, n, map,
                result.figures().crossRatio(), result.warnings().stream().anyMatch(w -> w.kind()
                        == CalibrationWarning.BENT || w.kind() == CalibrationWarning.BENT_OTHERWISE));
    }

    private static List<Integer> half(Scene scene, int parity) {
        return IntStream.range(0, scene.photos).filter(i -> i % 2 == parity).boxed().toList();
    }

    TargetPoints points() {
        return points;
    }

    /** The camera's true values. */
    double[] truth() {
        return truth.clone();
    }

    /** The photos of one simulated calibration. */
    List<TargetObservation> photos(Scene scene, int simulation) {
        return photos(scene, scene.photos, simulation);
    }

    private List<TargetObservation> photos(Scene scene, int count, int simulation) {
        SplittableRandom random = new SplittableRandom(seed * 1_000_003 + scene.stream * 100_003L + simulation);
        List<TargetObservation> photos = new ArrayList<>();
        for (int p = 0; p < count; p++) {
            photos.add(photo(scene, random, "photo " + p));
        }
        return photos;
    }

    private TargetObservation photo(Scene scene, SplittableRandom random, String name) {
        double[] uv = new double[2 * points.count()];
        double[] rotation = new double[9];
        while (true) {
            double tilt = Math.toRadians(scene.poor ? 20 * random.nextDouble() : 15 + 30 * random.nextDouble());
            double axis = 2 * Math.PI * random.nextDouble();
            double[] tilted = new double[9];
            double[] turned = new double[9];
            Rotations.exp(tilt * Math.cos(axis), tilt * Math.sin(axis), 0, tilted);
            Rotations.exp(0, 0, Math.toRadians(scene.poor ? 20 : 90) * (2 * random.nextDouble() - 1), turned);
            TargetPhoto.multiply(tilted, turned, rotation);
            double z = scene.poor ? 700 * (0.97 + 0.06 * random.nextDouble()) : 350 + 600 * random.nextDouble();
            double focal = truth[PinholeCamera.FX];
            z *= focal / camera.widthPx() / FOCAL_SHARE;
            double reach = scene.poor ? 0.1 : 0.45;
            double[] t = {z * reach * camera.widthPx() / focal * (2 * random.nextDouble() - 1),
                z * reach * camera.heightPx() / focal * (2 * random.nextDouble() - 1), z};
            if (project(scene, rotation, t, uv)) {
                break;
            }
        }
        for (int i = 0; i < uv.length; i++) {
            uv[i] += noisePx * random.nextGaussian();
        }
        return new TargetObservation(name, camera.widthPx(), camera.heightPx(),
                IntStream.range(0, points.count()).toArray(), uv);
    }

    /** Images of all corners; false unless all are in the image. */
    private boolean project(Scene scene, double[] r, double[] t, double[] uv) {
        double[] xyz = points.xyzMm();
        for (int i = 0; i < points.count(); i++) {
            double x = xyz[3 * i];
            double y = xyz[3 * i + 1];
            double across = 2 * x / ((COLUMNS - 1) * SQUARE_MM);
            double z = scene.warpMm * (1 - across * across);
            if (!camera.lens().project(truth, r[0] * x + r[1] * y + r[2] * z + t[0],
                    r[3] * x + r[4] * y + r[5] * z + t[1], r[6] * x + r[7] * y + r[8] * z + t[2], uv, 2 * i)
                    || uv[2 * i] < 0 || uv[2 * i] > camera.widthPx() || uv[2 * i + 1] < 0
                    || uv[2 * i + 1] > camera.heightPx()) {
                return false;
            }
        }
        return true;
    }
}
