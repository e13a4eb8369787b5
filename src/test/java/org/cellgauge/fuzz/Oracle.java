package org.cellgauge.fuzz;

import org.cellgauge.cell.Cell;
import org.cellgauge.cell.Reference;
import org.cellgauge.check.CheckResult;
import org.cellgauge.check.Verdict;
import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.internal.geometry.MarkerGeometry;
import org.cellgauge.output.ResultRow;
import org.cellgauge.output.ResultView;
import org.cellgauge.vision.Detections;
import org.cellgauge.vision.MarkerObservation;

/** What must hold of every result, whatever went in. */
final class Oracle {
    /** How far corners may miss where all that is known of them says they are, in standard deviations. */
    private static final double MOST_DEVIATIONS = 12;
    private static final double ROUNDING = 1e-9;

    private Oracle() {
    }

    /** A result that must not be. */
    static final class WrongException extends RuntimeException {
        private static final long serialVersionUID = 1L;

        WrongException(String message) {
            super(message);
        }
    }

    static void require(boolean holds, String otherwise) {
        if (!holds) {
            throw new WrongException(otherwise);
        }
    }

    static void judge(Cell cell, Detections detections, CheckResult result) {
        ResultView view = ResultView.of(result);
        if (view.trusted()) {
            for (ResultRow row : view.rows()) {
                if (row.seen()) {
                    covariance(row.covariance(), row.toString());
                }
            }
        }
        if (view.verdict() != Verdict.PASS) {
            return;
        }
        require(cell.targetStdMm().isPresent(), "pass without a target");
        boolean any = false;
        for (ResultRow row : view.objects()) {
            if (row.seen()) {
                any = true;
                require(view.worstStdMm(row) <= cell.targetStdMm().getAsDouble() * (1 + ROUNDING),
                        "pass above the target");
            }
        }
        require(any, "pass of no object");
        for (Reference reference : cell.references()) {
            MarkerObservation seen = detections.find(reference.id());
            if (seen != null) {
                residual(cell, reference, seen, view.camera());
            }
        }
    }

    private static void covariance(double[][] c, String of) {
        double[][] scaled = new double[c.length][c.length];
        for (int i = 0; i < c.length; i++) {
            require(c[i][i] > 0 && Double.isFinite(c[i][i]), of + ": a variance is " + c[i][i]);
            for (int j = 0; j < c.length; j++) {
                scaled[i][j] = c[i][j] / Math.sqrt(c[i][i] * c[j][j]);
                require(Math.abs(scaled[i][j]) <= 1 + ROUNDING, of + ": no correlation: " + scaled[i][j]);
                require(Math.abs(c[i][j] - c[j][i]) <= ROUNDING * Math.sqrt(c[i][i] * c[j][j]),
                        of + " is not symmetric");
            }
        }
        // Gauss elimination without exchanges: the pivots of a positive definite matrix are positive
        for (int k = 0; k < c.length; k++) {
            require(scaled[k][k] > 0, of + " is not positive definite");
            for (int i = k + 1; i < c.length; i++) {
                double factor = scaled[i][k] / scaled[k][k];
                for (int j = k; j < c.length; j++) {
                    scaled[i][j] -= factor * scaled[k][j];
                }
            }
        }
    }

    /** Corners of a reference where the camera's mean shows them, against all that may have moved them. */
    private static void residual(Cell cell, Reference reference, MarkerObservation seen, ResultRow camera) {
        double[] m = camera.mean();
        RigidTransform cameraFromWorld = RigidTransform.ofEuler(m[0], m[1], m[2], m[3], m[4], m[5]).inverse();
        double[] px = MarkerGeometry.cornersPx(cell.camera(), cameraFromWorld.compose(reference.worldFromMarker()),
                reference.sizeMm());
        require(px != null, "pass with reference " + reference.id() + " behind the camera");
        double z = Math.max(1, cameraFromWorld.apply(reference.worldFromMarker().translationMm())[2]);
        double[] std = camera.std();
        double moved = 0;
        for (int i = 0; i < 3; i++) {
            moved = Math.max(moved, reference.placement().stdMm(i) + std[i] + z * std[3 + i]);
        }
        moved += reference.placement().stdRad() * reference.sizeMm();
        double allowed = MOST_DEVIATIONS * (cell.pixelStdPx().orElse(1) + cell.camera().get(0) / z * moved);
        for (int i = 0; i < 8; i++) {
            double off = Math.abs(px[i] - seen.cornersPx()[i]);
            require(off <= allowed, "pass with reference " + reference.id() + " off by " + off + " px where " + allowed
                    + " px are explained");
        }
    }
}
