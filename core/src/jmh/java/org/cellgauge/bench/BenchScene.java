package org.cellgauge.bench;

import java.util.List;
import java.util.OptionalDouble;
import org.cellgauge.cell.Cell;
import org.cellgauge.check.ThesisScene;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.internal.pose.CameraModeFinder;
import org.cellgauge.internal.pose.CameraState;
import org.cellgauge.internal.pose.CornerErrors;
import org.cellgauge.internal.pose.IntrinsicsPrior;
import org.cellgauge.internal.pose.PoseMode;
import org.cellgauge.internal.pose.ReferenceView;
import org.cellgauge.internal.pose.RigidMarkerNoise;
import org.cellgauge.internal.sampling.RandomStreams;
import org.cellgauge.light.ToneCurve;
import org.cellgauge.vision.Detections;
import org.cellgauge.vision.PhotoLight;

/**
 * The thesis' scene with three references in the plane, 5 mm and 0.01 rad of placement error, 0.3 px of corner
 * noise.
 */
final class BenchScene {
    static final double PIXEL_STD = 0.3;
    private static final PinholeCamera DISTORTED = PinholeCamera.of(1280, 720,
            new double[] {581, 581, 640, 360, 0, -0.25, 0.1, 0, 0.001, -0.001});

    final ThesisScene scene;
    final Detections detections;
    final PinholeCamera camera;
    final ReferenceView view;
    /** Null where the noise is stated. */
    final CornerErrors errors;

    BenchScene(boolean distorted) {
        camera = distorted ? DISTORTED : ThesisScene.CAMERA;
        scene = ThesisScene.inPlane(3).camera(camera);
        detections = scene.detections(PIXEL_STD, RandomStreams.of(1), 5, 0.01);
        view = ReferenceView.of(scene.cell().references(), detections);
        errors = null;
    }

    private BenchScene(BenchScene other, CornerErrors errors) {
        camera = other.camera;
        scene = other.scene;
        detections = other.detections;
        this.errors = errors;
        view = ReferenceView.of(scene.cell().references(), errors);
    }

    /** The same in a light that leaves edges in doubt, with a noise that nobody states. */
    BenchScene withSharedErrors() {
        Cell cell = scene.cell();
        Cell unstated = new Cell(camera, cell.family(), cell.references(), cell.objects(), OptionalDouble.empty(),
                OptionalDouble.empty());
        return new BenchScene(this, CornerErrors.of(unstated, new Detections("shared", detections.widthPx(),
                detections.heightPx(), detections.markers(), List.of(),
                new PhotoLight(ToneCurve.SRGB, true, 0.7, 1, 100, 0.05))));
    }

    CameraModeFinder finder() {
        RigidMarkerNoise noise = errors == null ? new RigidMarkerNoise(view, PIXEL_STD)
                : new RigidMarkerNoise(view, errors, errors.squarenessBelief().mean());
        return new CameraModeFinder(view, camera, noise, IntrinsicsPrior.KNOWN, null);
    }

    PoseMode mode() {
        return finder().modes(scene.worldFromCamera()).get(0);
    }

    /** 64 states within a deviation of the mode, so that no branch of a likelihood sees the same numbers for ever. */
    static CameraState[] around(PoseMode mode) {
        var random = RandomStreams.of(2);
        CameraState[] states = new CameraState[64];
        for (int i = 0; i < states.length; i++) {
            double[] step = new double[6];
            for (int k = 0; k < 6; k++) {
                step[k] = Math.sqrt(mode.covariance()[(mode.dimension() + 1) * k]) * random.nextGaussian();
            }
            states[i] = new CameraState();
            states[i].setMoved(mode.state(), step, 0);
            states[i].noise += 0.2 * random.nextGaussian();
        }
        return states;
    }
}
