package org.cellgauge.internal.pose;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import org.cellgauge.check.ThesisScene;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.internal.geometry.MarkerGeometry;
import org.cellgauge.internal.sampling.RandomStreams;
import org.cellgauge.vision.Detections;
import org.cellgauge.vision.MarkerObservation;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

class InitialPoseTest {
    static final PinholeCamera STRONG = PinholeCamera.of(1280, 720,
            new double[] {581, 590, 640.5, 359.5, 0.5, -0.25, 0.1, -0.02, 0.004, -0.006});

    static List<Arguments> setUps() {
        List<Arguments> all = new ArrayList<>();
        for (PinholeCamera camera : new PinholeCamera[] {ThesisScene.CAMERA, STRONG}) {
            for (int n = 2; n <= 6; n++) {
                all.add(Arguments.of(n, false, camera));
                all.add(Arguments.of(n, true, camera));
            }
        }
        return all;
    }

    static ThesisScene scene(int references, boolean raised, PinholeCamera camera) {
        return (raised ? ThesisScene.oneRaised(references) : ThesisScene.inPlane(references)).camera(camera);
    }

    static ReferenceView view(ThesisScene scene, Detections detections) {
        return ReferenceView.of(scene.cell().references(), detections);
    }

    private static void assertPose(RigidTransform expected, RigidTransform found, double mm, double rad) {
        assertNotNull(found);
        double[] a = expected.translationMm();
        double[] b = found.translationMm();
        double distance = Math.sqrt((a[0] - b[0]) * (a[0] - b[0]) + (a[1] - b[1]) * (a[1] - b[1])
                + (a[2] - b[2]) * (a[2] - b[2]));
        assertTrue(distance < mm, "off by " + distance + " mm");
        assertTrue(expected.angleRadTo(found) < rad, "off by " + expected.angleRadTo(found) + " rad");
    }

    @ParameterizedTest
    @MethodSource("setUps")
    void exactCornersGiveTheExactPose(int references, boolean raised, PinholeCamera camera) {
        ThesisScene scene = scene(references, raised, camera);
        ReferenceView view = view(scene, scene.exactDetections());
        assertPose(scene.worldFromCamera(), InitialPose.PNP.estimate(view, camera), 1e-5, 1e-8);
        assertPose(scene.worldFromCamera(), InitialPose.AVERAGE.estimate(view, camera), 1e-3, 1e-6);
        // a consensus of few corners, not refined: the solver's own precision
        assertPose(scene.worldFromCamera(), InitialPose.RANSAC.estimate(view, camera), 0.1, 1e-4);
    }

    /** The thesis' scene with one reference 60 mm off its stated place, along x. */
    private static Detections oneMoved(ThesisScene scene, int moved, double byMm) {
        List<MarkerObservation> markers = new ArrayList<>();
        scene.cell().references().forEach(r -> {
            RigidTransform pose = r.worldFromMarker();
            if (r.id() == moved) {
                pose = RigidTransform.ofEuler(byMm, 0, 0, 0, 0, 0).compose(pose);
            }
            double[] corners = MarkerGeometry.cornersMm(scene.worldFromCamera().inverse().compose(pose), r.sizeMm());
            double[] px = new double[8];
            for (int k = 0; k < 4; k++) {
                double[] uv = scene.cell().camera().project(corners[3 * k], corners[3 * k + 1], corners[3 * k + 2]);
                px[2 * k] = uv[0];
                px[2 * k + 1] = uv[1];
            }
            markers.add(new MarkerObservation(r.id(), px));
        });
        return new Detections("moved", 1280, 720, markers);
    }

    @Test
    void consensusIgnoresAMisplacedReferenceThatTheMeanIsPulledBy() {
        ThesisScene scene = ThesisScene.inPlane(5);
        ReferenceView view = view(scene, oneMoved(scene, 22, 60));
        assertPose(scene.worldFromCamera(), InitialPose.RANSAC.estimate(view, ThesisScene.CAMERA), 1, 1e-3);
        RigidTransform mean = InitialPose.AVERAGE.estimate(view, ThesisScene.CAMERA);
        // the moved one alone sees the camera 60 mm off in x, the four others where it is
        assertEquals(418 - 60.0 / 5, mean.translationMm()[0], 1e-3);
        assertEquals(106, mean.translationMm()[1], 1e-3);
    }

    @Test
    void referenceReadWithAWrongIdDoesNotSpoilTheStart() {
        ThesisScene scene = ThesisScene.inPlane(4);
        List<MarkerObservation> markers = new ArrayList<>();
        for (MarkerObservation m : scene.exactDetections().markers()) {
            // what carries the id 22 is another marker, elsewhere in the image and turned
            markers.add(m.id() != 22 ? m : new MarkerObservation(22,
                    new double[] {900, 600, 925, 605, 920, 630, 895, 625}));
        }
        ReferenceView view = view(scene, new Detections("wrong id", 1280, 720, markers));
        assertPose(scene.worldFromCamera(), InitialPose.PNP.estimate(view, ThesisScene.CAMERA), 1e-3, 1e-6);
    }

    @Test
    void meanOfAnglesToBothSidesOfAHalfTurnStaysThere() {
        // camera looking straight down: psi of the single estimates scatters around pi
        ThesisScene scene = ThesisScene.inPlane(4).cameraAt(RigidTransform.ofEuler(246, 190, 1070, Math.PI, 0.02,
                0.01));
        ReferenceView view = view(scene, scene.detections(0.01, RandomStreams.of(1), 0, 0));
        RigidTransform mean = InitialPose.AVERAGE.estimate(view, ThesisScene.CAMERA);
        assertTrue(scene.worldFromCamera().angleRadTo(mean) < 0.2, mean::toString);
    }

    @Test
    void meanOfNegativeAnglesIsNegative() {
        ThesisScene scene = ThesisScene.inPlane(4)
                .cameraAt(RigidTransform.ofEuler(300, 150, 1070, -3.08, -0.10, -2.5));
        ReferenceView view = view(scene, scene.exactDetections());
        assertPose(scene.worldFromCamera(), InitialPose.AVERAGE.estimate(view, ThesisScene.CAMERA), 1e-3, 1e-6);
    }

    @Test
    void sameCornersGiveTheSameConsensus() {
        ThesisScene scene = ThesisScene.inPlane(4);
        ReferenceView view = view(scene, scene.detections(0.3, RandomStreams.of(2), 5, 0.01));
        assertEquals(InitialPose.RANSAC.estimate(view, ThesisScene.CAMERA).toString(),
                InitialPose.RANSAC.estimate(view, ThesisScene.CAMERA).toString());
    }
}
