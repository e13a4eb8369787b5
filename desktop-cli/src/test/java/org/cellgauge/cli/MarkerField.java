package org.cellgauge.cli;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.apache.commons.math3.random.RandomGenerator;
import org.apache.commons.math3.random.Well19937c;
import org.cellgauge.cell.MarkerFamily;
import org.cellgauge.desktop.render.Backdrop;
import org.cellgauge.desktop.render.Scene;
import org.cellgauge.desktop.render.SceneRenderer;
import org.cellgauge.desktop.render.SceneTruth;
import org.cellgauge.desktop.render.Sensor;
import org.cellgauge.geometry.BrownLens;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.internal.geometry.Cholesky;
import org.cellgauge.light.ToneCurve;
import org.cellgauge.vision.BoofMarkerDetector;
import org.cellgauge.vision.Detections;
import org.cellgauge.vision.EdgeShift;
import org.cellgauge.vision.GreyImage;
import org.cellgauge.vision.MarkerObservation;

/** Forty markers, turned and tilted at random, rendered once, and how well a detector finds their corners. */
final class MarkerField {
    static final double FOCAL_PX = 581;
    private static final double DISTANCE_MM = 1070;
    /** Pixels per mm of a marker that faces the camera, in the mean over the heights at which they stand. */
    static final double PX_PER_MM = FOCAL_PX / (DISTANCE_MM - 30);
    private static final int COLUMNS = 8;
    private static final int ROWS = 5;
    private static final double TILT_RAD = 0.35;
    private static final double ALONG_RAD = Math.toRadians(0.2);
    private static final int FEW = 5;

    final PinholeCamera camera;
    final String family;
    final Scene scene;
    final List<SceneTruth.MarkerInImage> truth;

    private MarkerField(PinholeCamera camera, String family, Scene scene) {
        this.camera = camera;
        this.family = family;
        this.scene = scene;
        this.truth = SceneTruth.of(scene);
    }

    static MarkerField of(String family, double sizeMm) {
        return of(family, sizeMm, 0, 0, Backdrop.plain(), Scene.DEFAULT_QUIET_ZONE, 0);
    }

    /** Every fifth marker faces the camera upright but for a fifth of a degree: its sides lie along rows of pixels. */
    static MarkerField alongRows(String family, double sizeMm) {
        return of(family, sizeMm, 0, 0, Backdrop.plain(), Scene.DEFAULT_QUIET_ZONE, 0, FEW);
    }

    static MarkerField of(String family, double sizeMm, double k1, double k2, Backdrop backdrop, double quietZone,
            double printGainMm) {
        return of(family, sizeMm, k1, k2, backdrop, quietZone, printGainMm, COLUMNS * ROWS);
    }

    private static MarkerField of(String family, double sizeMm, double k1, double k2, Backdrop backdrop,
            double quietZone, double printGainMm, int everyAlong) {
        double[] values = PinholeCamera.ideal(1280, 720, FOCAL_PX, FOCAL_PX, 640, 360).intrinsics();
        values[BrownLens.K1] = k1;
        values[BrownLens.K2] = k2;
        PinholeCamera camera = PinholeCamera.of(1280, 720, values);
        RandomGenerator random = new Well19937c(17);
        RigidTransform above = RigidTransform.ofEuler(0, 0, DISTANCE_MM, Math.PI, 0, 0);
        Scene.Builder scene = Scene.of(camera, above).backdrop(backdrop).quietZone(quietZone).printGainMm(printGainMm);
        for (int i = 0; i < COLUMNS * ROWS; i++) {
            double x = (i % COLUMNS - (COLUMNS - 1) / 2.0) * 230 + 20 * random.nextDouble();
            double y = (i / COLUMNS - (ROWS - 1) / 2.0) * 210 + 20 * random.nextDouble();
            boolean along = (i + 1) % everyAlong == 0 && everyAlong < COLUMNS * ROWS;
            double tilt = along ? 0 : TILT_RAD;
            double turn = along ? ALONG_RAD : 2 * Math.PI;
            scene.marker(family, 20 + 7 * i % 30 + 30 * (i / 30), sizeMm, RigidTransform.ofEuler(x, y,
                    20 + 20 * random.nextDouble(), tilt * (2 * random.nextDouble() - 1),
                    tilt * (2 * random.nextDouble() - 1), turn * random.nextDouble()));
        }
        return new MarkerField(camera, family, scene.build());
    }

    GreyImage photo(Sensor sensor) {
        return SceneRenderer.renderNearMarkers(scene, sensor, new Well19937c(18));
    }

    /** Finds them; curve null: to be estimated. */
    Found find(GreyImage photo, ToneCurve curve) {
        List<Integer> ids = new ArrayList<>();
        truth.forEach(m -> ids.add(m.id()));
        return new Found(new BoofMarkerDetector(camera, MarkerFamily.of(family), ids,
                BoofMarkerDetector.RESIDUAL_LIMIT_PER_SIDE, curve).detect(photo, "rendered"));
    }

    /** Detections against what was rendered. */
    final class Found {
        final Detections detections;
        final int markers;
        /** Root mean square and largest error of a coordinate as it was found, px. */
        final double rmsPx;
        final double worstPx;
        /** Mean over the markers of the measured shift of their edges, and its scatter about that mean, px. */
        final double shiftPx;
        final double shiftScatterPx;
        /** How far sides lie inside the true ones, mean over all markers, as found and less the shift, px. */
        final double insidePx;
        final double leftPx;
        /** Mean of e' S^-1 e / 8 of the corners as they were found. */
        final double chiSquarePerValue;
        /** The same of the corners less the shift that the inner edges measure, which shares errors with them. */
        final double chiSquareLessShift;

        private Found(Detections detections) {
            this.detections = detections;
            double sum = 0;
            double worst = 0;
            double shifts = 0;
            double shiftSquares = 0;
            int n = 0;
            for (SceneTruth.MarkerInImage marker : truth) {
                MarkerObservation seen = detections.find(marker.id());
                if (seen == null) {
                    continue;
                }
                n++;
                for (double e : errors(seen, marker)) {
                    sum += e * e;
                    worst = Math.max(worst, Math.abs(e));
                }
                shifts += seen.edgeShift().shiftPx();
                shiftSquares += seen.edgeShift().shiftPx() * seen.edgeShift().shiftPx();
            }
            markers = n;
            rmsPx = Math.sqrt(sum / (8 * n));
            worstPx = worst;
            shiftPx = shifts / n;
            shiftScatterPx = Math.sqrt(Math.max(0, shiftSquares / n - shiftPx * shiftPx));
            double inside = 0;
            double chiSquare = 0;
            double lessShift = 0;
            for (SceneTruth.MarkerInImage marker : truth) {
                MarkerObservation seen = detections.find(marker.id());
                if (seen == null) {
                    continue;
                }
                double[] e = errors(seen, marker);
                double[] byShift = EdgeShift.ofCorners(seen.cornersPx());
                double along = 0;
                double squares = 0;
                for (int k = 0; k < 8; k++) {
                    along += e[k] * byShift[k];
                    squares += byShift[k] * byShift[k];
                }
                inside += along / squares / n;
                chiSquare += mahalanobis(seen.covariancePx2(), e) / (8 * n);
                double[] covariance = seen.covariancePx2();
                double[] with = seen.edgeShift().covarianceWithCornersPx2();
                for (int r = 0; r < 8; r++) {
                    e[r] -= byShift[r] * seen.edgeShift().shiftPx();
                    for (int c = 0; c < 8; c++) {
                        covariance[8 * r + c] += byShift[r] * byShift[c] * seen.edgeShift().variancePx2()
                                - byShift[r] * with[c] - with[r] * byShift[c];
                    }
                }
                lessShift += mahalanobis(covariance, e) / (8 * n);
            }
            insidePx = inside;
            leftPx = inside - shiftPx;
            chiSquarePerValue = chiSquare;
            chiSquareLessShift = lessShift;
        }

        private double[] errors(MarkerObservation seen, SceneTruth.MarkerInImage marker) {
            double[] e = seen.cornersPx();
            for (int k = 0; k < 8; k++) {
                e[k] -= marker.cornersPx()[k / 2][k % 2];
            }
            return e;
        }

        private double mahalanobis(double[] covariance, double[] e) {
            double[] inverse = Cholesky.inverse(covariance, 8);
            double sum = 0;
            for (int r = 0; r < 8; r++) {
                for (int c = 0; c < 8; c++) {
                    sum += e[r] * inverse[8 * r + c] * e[c];
                }
            }
            return sum;
        }

        @Override
        public String toString() {
            return String.format(Locale.ROOT, "%d markers, rms %.4f px, worst %.3f; shift %.4f (scatter %.4f)"
                    + ", inside by %.4f, left %.4f px; e'S^-1e/8 %.3f, "
                    + "less shift %.3f; %s, blur %.2f, noise %.2f; %s",
                    markers, rmsPx, worstPx, shiftPx, shiftScatterPx, insidePx, leftPx, chiSquarePerValue,
                    chiSquareLessShift,
                    detections.light().toneCurve(), detections.light().blurPx(), detections.light().noiseGrey(),
                    detections.warnings());
        }
    }
}
