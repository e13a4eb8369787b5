package org.cellgauge.vision;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.apache.commons.math3.random.RandomGenerator;
import org.apache.commons.math3.random.Well19937c;
import org.cellgauge.geometry.BrownLens;
import org.cellgauge.geometry.PinholeCamera;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Rows of pixels that a band spans, against every pixel of the image asked whether it lies in it. */
class BandPixelsTest {
    private static final int WIDTH = 160;
    private static final int HEIGHT = 120;

    private static PinholeCamera camera(double k1) {
        double[] values = PinholeCamera.ideal(WIDTH, HEIGHT, 140, 142, 81, 58).intrinsics();
        values[BrownLens.K1] = k1;
        return PinholeCamera.of(WIDTH, HEIGHT, values);
    }

    private static SideFit side(RandomGenerator random) {
        SideFit side = new SideFit(new SideFit.Work());
        double angle = random.nextInt(3) == 0 ? Math.PI / 2 * random.nextInt(4) : 6.28 * random.nextDouble();
        side.tangentX = Math.cos(angle);
        side.tangentY = Math.sin(angle);
        side.normalX = side.tangentY;
        side.normalY = -side.tangentX;
        // some reach beyond the image
        side.middleX = WIDTH * (1.2 * random.nextDouble() - 0.1);
        side.middleY = HEIGHT * (1.2 * random.nextDouble() - 0.1);
        return side;
    }

    @ParameterizedTest
    @ValueSource(doubles = {0, -0.25, 0.2})
    void allPixelsOfTheBandAreThereAndNoOthers(double k1) {
        PinholeCamera camera = camera(k1);
        StraightPlane plane = new StraightPlane(camera);
        byte[] grey = new byte[WIDTH * HEIGHT];
        RandomGenerator random = new Well19937c(7);
        random.nextBytes(grey);
        GreyImage image = GreyImage.packed(grey, WIDTH, HEIGHT);
        BandPixels band = new BandPixels();
        int all = 0;
        for (int trial = 0; trial < 400; trial++) {
            SideFit side = side(random);
            double half = 2 + 20 * random.nextDouble();
            double inner = 5 * random.nextDouble();
            double outer = 6 * random.nextDouble() - inner / 2;
            double u = Math.max(5, Math.min(WIDTH - 5, side.middleX));
            double v = Math.max(5, Math.min(HEIGHT - 5, side.middleY));
            assertTrue(plane.aim(new double[] {u - 4, v - 4, u + 4, v - 4, u + 4, v + 4, u - 4, v + 4}));
            band.gather(image, null, plane, side, half, inner, outer);
            int n = 0;
            double[] place = new double[2];
            for (int y = 0; y < HEIGHT; y++) {
                for (int x = 0; x < WIDTH; x++) {
                    assertTrue(plane.toPlane(x + 0.5, y + 0.5, place, 0));
                    double px = place[0] - side.middleX;
                    double py = place[1] - side.middleY;
                    double t = px * side.tangentX + py * side.tangentY;
                    double d = px * side.normalX + py * side.normalY;
                    if (d < -inner || d > outer || Math.abs(t) > half) {
                        continue;
                    }
                    assertTrue(n < band.count, "too few");
                    assertEquals(t, band.along[n]);
                    assertEquals(d, band.across[n]);
                    assertEquals(image.get(x, y), band.grey[n]);
                    assertEquals(0, band.floor[n]);
                    assertEquals(255, band.cap[n++]);
                }
            }
            assertEquals(n, band.count);
            all += n;
        }
        assertTrue(all > 20_000, all + " pixels");
    }
}
