package org.cellgauge.internal.overlay;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.apache.commons.math3.random.RandomGenerator;
import org.apache.commons.math3.random.Well19937c;
import org.cellgauge.geometry.BrownLens;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.geometry.RigidTransform;
import org.junit.jupiter.api.Test;

class WorldViewTest {
    private static final int WIDTH = 640;
    private static final int HEIGHT = 480;

    private static PinholeCamera barrel(double k1) {
        double[] v = PinholeCamera.ideal(WIDTH, HEIGHT, 300, 300, 320, 240).intrinsics();
        v[BrownLens.K1] = k1;
        return PinholeCamera.of(WIDTH, HEIGHT, v);
    }

    @Test
    void pointsBeyondTheFoldAreNotSeenThoughTheModelPutsThemIntoTheImage() {
        PinholeCamera camera = barrel(-0.3);
        WorldView view = new WorldView(camera, RigidTransform.IDENTITY, ImageOrientation.IDENTITY);
        double[] folded = camera.project(1.5 * 100, 0, 100);
        assertTrue(folded[0] > 0 && folded[0] < WIDTH, "the model alone would draw it at " + folded[0]);
        assertNull(view.project(new double[] {150, 0, 100}));
        assertNotNull(view.project(new double[] {90, 0, 100}));
    }

    @Test
    void pointsBehindTheCameraAreNotSeen() {
        WorldView view = new WorldView(barrel(0), RigidTransform.IDENTITY, ImageOrientation.IDENTITY);
        assertNull(view.project(new double[] {1, 1, -100}));
        assertNull(view.project(new double[] {1, 1, 0}));
        assertArrayEquals(new double[] {320 + 300 * 0.1, 240 - 300 * 0.2},
                view.project(new double[] {10, -20, 100}), 1e-9);
    }

    @Test
    void aLineThroughTheCameraPlaneIsDrawnInFrontOfItOnly() {
        WorldView view = new WorldView(barrel(0), RigidTransform.IDENTITY, ImageOrientation.IDENTITY);
        // below the optical axis in front, so below the middle of the image; behind it, the formula would put it above
        List<double[]> parts = view.line(new double[] {-5, 50, 1000}, new double[] {5, 50, -1000});
        assertEquals(1, parts.size());
        for (int i = 1; i < parts.get(0).length; i += 2) {
            assertTrue(parts.get(0)[i] > 240, "v " + parts.get(0)[i]);
        }
    }

    @Test
    void aBentLineFollowsTheLens() {
        PinholeCamera camera = barrel(-0.2);
        WorldView view = new WorldView(camera, RigidTransform.IDENTITY, ImageOrientation.IDENTITY);
        List<double[]> parts = view.line(new double[] {-60, 60, 100}, new double[] {60, 60, 100});
        assertEquals(1, parts.size());
        double[] out = new double[2];
        for (int i = 0; i < parts.get(0).length; i += 2) {
            assertTrue(camera.toNormalised(parts.get(0)[i], parts.get(0)[i + 1], out));
            assertEquals(0.6, out[1], 1e-9);
        }
    }

    @Test
    void aLineKeepsThePointsThatBendIt() {
        double[] from = {-90, 60, 100};
        double[] to = {90, 60, 100};
        assertEquals(4, new WorldView(barrel(0), RigidTransform.IDENTITY, ImageOrientation.IDENTITY).line(from, to)
                .get(0).length);
        PinholeCamera bending = barrel(-0.05);
        double[] kept = new WorldView(bending, RigidTransform.IDENTITY, ImageOrientation.IDENTITY).line(from, to)
                .get(0);
        assertTrue(kept.length >= 10 && kept.length < 2 * 40, kept.length / 2 + " points");
        double farthest = 0;
        for (int i = 0; i + 3 < kept.length; i += 2) {
            for (double x = -90; x <= 90; x += 0.5) {
                double[] px = bending.project(x, 60, 100);
                if (px[0] >= kept[i] && px[0] <= kept[i + 2]) {
                    double v = kept[i + 1] + (kept[i + 3] - kept[i + 1]) * (px[0] - kept[i]) / (kept[i + 2] - kept[i]);
                    farthest = Math.max(farthest, Math.abs(v - px[1]));
                }
            }
        }
        // 0.05 px beside the line through all of its 65 points, which is itself within a hundredth of the bent one
        assertTrue(farthest > 0.01 && farthest < 0.06, "off by " + farthest + " px");
    }

    @Test
    void aLineThroughTheImageIsCutAtItsEdges() {
        List<double[]> parts = WorldView.clip(new double[] {-100, 100, 300, 100, 300, -50, 400, -50, 400, 50}, WIDTH,
                HEIGHT);
        assertEquals(2, parts.size());
        assertArrayEquals(new double[] {0, 100, 300, 100, 300, 0}, parts.get(0), 1e-12);
        assertArrayEquals(new double[] {400, 0, 400, 50}, parts.get(1), 1e-12);
    }

    @Test
    void cuttingKeepsTheLengthThatLiesInTheImage() {
        RandomGenerator random = new Well19937c(11);
        int samples = 4000;
        for (int n = 0; n < 200; n++) {
            double[] p = new double[4];
            for (int i = 0; i < 4; i++) {
                p[i] = -300 + 1200 * random.nextDouble();
            }
            double length = Math.hypot(p[2] - p[0], p[3] - p[1]);
            int inside = 0;
            for (int k = 0; k < samples; k++) {
                double t = (k + 0.5) / samples;
                double u = p[0] + t * (p[2] - p[0]);
                double v = p[1] + t * (p[3] - p[1]);
                inside += u >= 0 && u <= WIDTH && v >= 0 && v <= HEIGHT ? 1 : 0;
            }
            double kept = 0;
            for (double[] part : WorldView.clip(p, WIDTH, HEIGHT)) {
                kept += Math.hypot(part[2] - part[0], part[3] - part[1]);
            }
            // counting is good to one sample at either end
            assertEquals(length * inside / samples, kept, 2 * length / samples + 1e-9);
        }
    }
}
