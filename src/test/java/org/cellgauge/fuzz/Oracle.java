package org.cellgauge.fuzz;

import dev.harrel.jsonschema.Validator;
import dev.harrel.jsonschema.ValidatorFactory;
import dev.harrel.jsonschema.providers.GsonNode;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.net.URI;
import java.nio.file.Files;
import java.nio.file.Path;
import org.cellgauge.cell.Cell;
import org.cellgauge.cell.ObjectMarker;
import org.cellgauge.cell.Reference;
import org.cellgauge.check.CheckResult;
import org.cellgauge.check.Verdict;
import org.cellgauge.estimate.ObjectEstimate;
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
    /** Factor between deviations that nobody takes for chance: twice, by which no target is met, and short chains. */
    private static final double MOST_APART = 2.5;
    private static final double ROUNDING = 1e-9;

    private static final URI SCHEMA_NAME = URI.create("urn:result");
    private static final Validator SCHEMA = schema();

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

    /** A result file must be what docs/result.schema.json says. */
    static void fitsSchema(String json) {
        Validator.Result valid = SCHEMA.validate(SCHEMA_NAME, json);
        require(valid.isValid(), "not of the schema: " + valid.getErrors().stream()
                .map(e -> e.getInstanceLocation() + ": " + e.getError()).findFirst().orElse("?"));
    }

    private static Validator schema() {
        try {
            Validator validator = new ValidatorFactory().withJsonNodeFactory(new GsonNode.Factory()).createValidator();
            validator.registerSchema(SCHEMA_NAME, Files.readString(
                    Path.of(System.getProperty("cellgauge.root", "."), "docs", "result.schema.json")));
            return validator;
        } catch (IOException e) {
            throw new UncheckedIOException(e);
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
        likeLaplace(result);
        ResultRow camera = view.camera();
        for (Reference reference : cell.references()) {
            MarkerObservation seen = detections.find(reference.id());
            if (seen != null) {
                double movedMm = Math.max(reference.placement().stdMm(0), Math.max(reference.placement().stdMm(1),
                        reference.placement().stdMm(2))) + reference.placement().stdRad() * reference.sizeMm();
                residual(cell, "reference " + reference.id(), reference.worldFromMarker(), reference.sizeMm(), movedMm,
                        seen, camera);
            }
        }
        for (ObjectMarker object : cell.objects()) {
            MarkerObservation seen = detections.find(object.id());
            ResultRow row = view.object(object.id());
            if (seen != null && row.seen()) {
                double[] std = row.std();
                residual(cell, "object " + object.id(), pose(row), object.sizeMm(), Math.max(std[0], Math.max(std[1],
                        std[2])) + Math.max(std[3], Math.max(std[4], std[5])) * object.sizeMm(), seen, camera);
            }
        }
    }

    /** Standard deviations of positions by two ways: draws, and the Gaussian at the mode. */
    private static void likeLaplace(CheckResult result) {
        for (ObjectEstimate object : result.estimate().objects()) {
            ObjectEstimate laplace = result.quickLook().object(object.id());
            if (laplace == null || object.modes().size() > 1) {
                continue;
            }
            for (int i = 0; i < 3; i++) {
                double ratio = object.pose().std()[i] / laplace.pose().std()[i];
                require(ratio < MOST_APART && ratio > 1 / MOST_APART, "pass with object " + object.id() + " at " + ratio
                        + " times the deviation of Laplace's approximation");
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

    private static RigidTransform pose(ResultRow row) {
        double[] m = row.mean();
        return RigidTransform.ofEuler(m[0], m[1], m[2], m[3], m[4], m[5]);
    }

    /** Corners of a marker where the means show them, against all that may have moved them. */
    private static void residual(Cell cell, String of, RigidTransform worldFromMarker, double sizeMm, double movedMm,
            MarkerObservation seen, ResultRow camera) {
        RigidTransform cameraFromMarker = pose(camera).inverse().compose(worldFromMarker);
        double[] px = MarkerGeometry.cornersPx(cell.camera(), cameraFromMarker, sizeMm);
        require(px != null, "pass with " + of + " behind the camera");
        double z = Math.max(1, cameraFromMarker.translationMm()[2]);
        double[] std = camera.std();
        double seenFromMm = 0;
        for (int i = 0; i < 3; i++) {
            seenFromMm = Math.max(seenFromMm, std[i] + z * std[3 + i]);
        }
        double allowed = MOST_DEVIATIONS
                * (cell.pixelStdPx().orElse(1) + cell.camera().get(0) / z * (movedMm + seenFromMm));
        for (int i = 0; i < 8; i++) {
            double off = Math.abs(px[i] - seen.cornersPx()[i]);
            require(off <= allowed, "pass with " + of + " off by " + off + " px where " + allowed
                    + " px are explained");
        }
    }
}
