package org.cellgauge.vision;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.apache.commons.math3.random.RandomGenerator;
import org.apache.commons.math3.random.Well19937c;
import org.cellgauge.cell.MarkerFamily;
import org.junit.jupiter.api.Test;

/** The light of many pixels at once; that it is the light of the pattern is what {@link MarkerEdgesTest} asks. */
class PatternLightTest {
    private static final FamilyPatterns FAMILY = new FamilyPatterns(MarkerFamily.SQUARE_BINARY);
    private static final double[] CORNERS = {22.3, 14.6, 55.9, 24.7, 46.2, 57.8, 12.4, 48.1};
    private static final double SHIFT_PX = 0.07;
    private static final double PER_LENGTH = 0.05;

    private static double std(double blur) {
        return Math.sqrt(blur * blur + MarkerEdges.PIXEL_VARIANCE);
    }

    private static SideFit side(int i) {
        SideFit side = new SideFit(new SideFit.Work());
        int j = (i + 1) % 4;
        double dx = CORNERS[2 * j] - CORNERS[2 * i];
        double dy = CORNERS[2 * j + 1] - CORNERS[2 * i + 1];
        side.lengthPx = Math.hypot(dx, dy);
        side.tangentX = dx / side.lengthPx;
        side.tangentY = dy / side.lengthPx;
        side.normalX = side.tangentY;
        side.normalY = -side.tangentX;
        side.middleX = CORNERS[2 * i] + dx / 2;
        side.middleY = CORNERS[2 * i + 1] + dy / 2;
        return side;
    }

    private static PatternLight turned(int i, SideFit side) {
        double[] homography = new double[8];
        assertTrue(Homography.ofUnitSquare(CORNERS, homography));
        PatternLight light = new PatternLight(FAMILY.grid());
        light.turnTo(i, side, homography, FAMILY.white(944), SHIFT_PX);
        return light;
    }

    @Test
    void pixelsAmongOthersSeeWhatEachSeesAlone() {
        RandomGenerator random = new Well19937c(3);
        int count = 300;
        double[] along = new double[count];
        double[] depths = new double[count];
        for (double blur : new double[] {0.3, 0.8, 1.7}) {
            for (int i = 0; i < 4; i++) {
                SideFit side = side(i);
                for (int k = 0; k < count; k++) {
                    along[k] = side.lengthPx * (random.nextDouble() - 0.5);
                    depths[k] = 0.7 * side.lengthPx * random.nextDouble();
                }
                EdgeProfile profile = new EdgeProfile();
                profile.turn(side.normalX, side.normalY);
                PatternLight light = turned(i, side);
                light.see(along, depths, count, profile, blur, std(blur), PER_LENGTH);
                PatternLight alone = turned(i, side);
                int seeing = 0;
                for (int k = 0; k < count; k++) {
                    alone.see(new double[] {along[k]}, new double[] {depths[k]}, 1, profile, blur, std(blur),
                            PER_LENGTH);
                    assertEquals(alone.share[0], light.share[k]);
                    assertEquals(alone.bySlide[0], light.bySlide[k]);
                    assertEquals(alone.byShift[0], light.byShift[k]);
                    assertEquals(alone.byBlur[0], light.byBlur[k]);
                    seeing += light.share[k] > 0.1 && light.share[k] < 0.9 ? 1 : 0;
                }
                assertTrue(seeing > 20, seeing + " see an edge");
            }
        }
    }

    /** The derivative by the blur takes the depths at which ends are seen as given: by that little it may be off. */
    @Test
    void changeByTheBlurIsTheDifference() {
        double blur = 0.8;
        double h = 1e-4;
        SideFit side = side(1);
        EdgeProfile profile = new EdgeProfile();
        profile.turn(side.normalX, side.normalY);
        PatternLight light = turned(1, side);
        int count = 40;
        double[] along = new double[count];
        double[] depths = new double[count];
        for (int k = 0; k < count; k++) {
            along[k] = side.lengthPx * (k % 8 - 3.5) / 12;
            depths[k] = light.borderPx() + 1.5 * (k / 8 - 1);
        }
        light.see(along, depths, count, profile, blur + h, std(blur + h), 0);
        double[] after = light.share.clone();
        light.see(along, depths, count, profile, blur - h, std(blur - h), 0);
        double[] before = light.share.clone();
        light.see(along, depths, count, profile, blur, std(blur), 0);
        double largest = 0;
        for (int k = 0; k < count; k++) {
            assertEquals((after[k] - before[k]) / (2 * h), light.byBlur[k], 0.02);
            largest = Math.max(largest, Math.abs(light.byBlur[k]));
        }
        assertTrue(largest > 0.1, "largest " + largest);
    }
}
