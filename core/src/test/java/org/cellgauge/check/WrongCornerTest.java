package org.cellgauge.check;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import org.apache.commons.math3.random.RandomGenerator;
import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.internal.sampling.RandomStreams;
import org.cellgauge.settings.CheckSettings;
import org.cellgauge.vision.Detections;
import org.cellgauge.vision.MarkerObservation;
import org.junit.jupiter.api.Test;

/** One corner of one reference is wrong, and its marker as square as any that is seen at a slant. */
class WrongCornerTest {
    private static final CheckSettings SETTINGS = CheckSettings.builder().threads(1).build();
    private static final double NOISE_PX = 0.05;
    private static final double STD_MM = 1;
    private static final double STD_RAD = Math.toRadians(0.2);
    private static final int PHOTOS = 300;

    private final ThesisScene scene = ThesisScene.inPlane(4).placement(STD_MM, STD_RAD).pixelStd(NOISE_PX).noObjects();

    /** Squares of the camera's errors along x, y, z in stated deviations, and which markers are called outlying. */
    private final List<Double> squares = new ArrayList<>();
    private final List<Integer> outlying = new ArrayList<>();

    private CellModes look(Detections seen) {
        CellModes modes = new QuickLooks(scene.cell(), SETTINGS).of(seen, null).modes;
        double[] mean = modes.camera.worldFromCamera().translationMm();
        double[] truth = ThesisScene.WORLD_FROM_CAMERA.translationMm();
        double[] std = QuickLook.of(modes).estimate().camera().std();
        for (int c = 0; c < 3; c++) {
            squares.add((mean[c] - truth[c]) * (mean[c] - truth[c]) / (std[c] * std[c]));
        }
        outlying.addAll(modes.observed.noiseFit.outliers());
        return modes;
    }

    private double meanSquare() {
        return squares.stream().mapToDouble(s -> s).average().orElseThrow();
    }

    private static Detections withCornerOff(Detections seen, int id, int corner, double du, double dv) {
        List<MarkerObservation> markers = new ArrayList<>();
        for (MarkerObservation m : seen.markers()) {
            double[] px = m.cornersPx();
            if (m.id() == id) {
                px[2 * corner] += du;
                px[2 * corner + 1] += dv;
            }
            markers.add(m.id() == id ? new MarkerObservation(id, px) : m);
        }
        return new Detections(seen.imageName(), seen.widthPx(), seen.heightPx(), markers);
    }

    /**
     * Off by 20 deviations in any direction. A side of 25 px then seems turned by 15 degrees, and the mean square was
     * 2.1 while how square a marker is was all that was asked.
     */
    @Test
    void theOtherReferencesSayWhichMarkerHasIt() {
        int found = 0;
        for (int i = 0; i < PHOTOS; i++) {
            RandomGenerator random = RandomStreams.of(6, i);
            Detections seen = scene.detections(NOISE_PX, random, STD_MM, STD_RAD);
            double towards = 2 * Math.PI * random.nextDouble();
            outlying.clear();
            look(withCornerOff(seen, 22, i % 4, 20 * NOISE_PX * Math.cos(towards), 20 * NOISE_PX * Math.sin(towards)));
            found += outlying.equals(List.of(22)) ? 1 : 0;
        }
        // the rest is off in a direction that hardly shows, and does no harm; 0.87 to 0.89 by seeds, of which half hold
        assertTrue(found > 0.88 * PHOTOS, found + " of " + PHOTOS);
        // the mean of squares of x, y and z, which are not independent, is good to 0.08: less than 1.3 by far
        assertEquals(1, meanSquare(), 0.3);
    }

    /** The chance of it is 2 in 10 000, that of markers that are not square 20. */
    @Test
    void noCornerIsWrongWhereAllIsAsStated() {
        for (int i = 0; i < PHOTOS; i++) {
            look(scene.detections(NOISE_PX, RandomStreams.of(6, i), STD_MM, STD_RAD));
        }
        assertTrue(outlying.size() <= 3, outlying.size() + " of " + PHOTOS);
        assertEquals(1, meanSquare(), 0.3);
    }

    /** By ten to thirty times what is stated of it: then it is the reference that is named, not a corner. */
    @Test
    void aReferenceThatStandsElsewhereHasNoWrongCorner() {
        int accused = 0;
        for (int i = 0; i < PHOTOS; i++) {
            RandomGenerator random = RandomStreams.of(7, i);
            double size = 10 + 20 * random.nextDouble();
            double z = 2 * random.nextDouble() - 1;
            double turn = 2 * Math.PI * random.nextDouble();
            double across = Math.sqrt(1 - z * z);
            ThesisScene off = ThesisScene.inPlane(4).placement(STD_MM, STD_RAD).pixelStd(NOISE_PX).noObjects()
                    .shifted(22, size * across * Math.cos(turn), size * across * Math.sin(turn), size * z);
            CellModes modes = look(off.detections(NOISE_PX, random, STD_MM, STD_RAD));
            accused += modes.references().misplaced().stream().anyMatch(m -> m.id() == 22) ? 1 : 0;
        }
        assertTrue(outlying.size() <= 3, outlying + " of " + PHOTOS);
        assertTrue(accused > 0.9 * PHOTOS, accused + " of " + PHOTOS);
    }

    /** So is one that is turned about an axis in its plane, which moves its corners as two wrong ones would. */
    @Test
    void norHasOneThatIsTurned() {
        for (int i = 0; i < PHOTOS; i++) {
            RandomGenerator random = RandomStreams.of(8, i);
            Detections seen = scene.detections(NOISE_PX, random, STD_MM, STD_RAD);
            double angle = 2 * Math.PI * random.nextDouble();
            double size = Math.toRadians(2 + 4 * random.nextDouble());
            RigidTransform turn = RigidTransform.ofRotationVector(
                    new double[] {size * Math.cos(angle), size * Math.sin(angle), 0}, new double[3]);
            double[] px = ThesisScene.inPlane(4).turned(22, turn).noObjects().exactDetections().find(22).cornersPx();
            double[] straight = scene.exactDetections().find(22).cornersPx();
            double[] noisy = seen.find(22).cornersPx();
            Detections turned = seen;
            for (int k = 0; k < 4; k++) {
                turned = withCornerOff(turned, 22, k, px[2 * k] - straight[2 * k], px[2 * k + 1] - straight[2 * k + 1]);
            }
            assertEquals(noisy[0] + px[0] - straight[0], turned.find(22).cornersPx()[0], 1e-9);
            look(turned);
        }
        // a turn by thirty deviations and seen at a slant is not linear any more: two in a hundred may be taken for one
        assertTrue(outlying.size() <= 0.02 * PHOTOS, outlying + " of " + PHOTOS);
    }
}
