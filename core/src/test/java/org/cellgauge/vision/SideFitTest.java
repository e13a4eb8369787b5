package org.cellgauge.vision;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.function.Consumer;
import org.apache.commons.math3.random.RandomGenerator;
import org.apache.commons.math3.random.Well19937c;
import org.cellgauge.light.ToneCurve;
import org.junit.jupiter.api.Test;

/** A side keeps what it evaluated last: in another light it must be found anew. */
class SideFitTest {
    private static final double BLUR_PX = 0.7;

    private final GreyScale scale = new GreyScale();
    private final EdgeProfile profile = new EdgeProfile();

    /** An edge from nearly black to nearly white, so that noise reaches both ends of the scale. */
    private SideFit side() {
        RandomGenerator random = new Well19937c(5);
        EdgeProfile seen = new EdgeProfile();
        seen.turn(0.28, 0.96);
        SideFit side = new SideFit(new SideFit.Work());
        side.halfLengthPx = 8;
        side.restart(BLUR_PX);
        side.clear(BLUR_PX);
        for (int i = 0; i < 200; i++) {
            double t = 16 * random.nextDouble() - 8;
            double d = 6 * random.nextDouble() - 3;
            seen.at(d - 0.2 - 0.01 * t, BLUR_PX);
            double grey = Math.round(4 + 247 * seen.share + random.nextGaussian());
            // every third sees a little light from elsewhere, and tells nothing of power
            side.add(t, d, Math.max(0, Math.min(255, grey)), 0, 255, 1, i % 3 == 0 ? 0.01 : 0, 0);
        }
        return side;
    }

    private void changedLightIsLookedAtAnew(Consumer<GreyScale> change) {
        profile.turn(0.28, 0.96);
        scale.set(ToneCurve.SRGB);
        scale.setNoise(1.5);
        SideFit side = side();
        assertTrue(side.fit(scale, profile, SideFit.SETTLED_PX));
        assertTrue(side.conclude(scale, profile, true));
        double squares = side.squares;
        double score = side.powerScore;

        change.accept(scale);
        assertTrue(side.conclude(scale, profile, true));
        SideFit fresh = side();
        System.arraycopy(side.unknowns, 0, fresh.unknowns, 0, SideFit.UNKNOWNS);
        assertTrue(fresh.conclude(scale, profile, true));

        assertEquals(fresh.squares, side.squares);
        assertEquals(fresh.powerScore, side.powerScore);
        assertEquals(fresh.powerInformation, side.powerInformation);
        assertEquals(fresh.covariance(SideFit.OFFSET, SideFit.OFFSET),
                side.covariance(SideFit.OFFSET, SideFit.OFFSET));
        assertNotEquals(squares, side.squares);
        assertNotEquals(score, side.powerScore);
    }

    @Test
    void moreNoiseIsAnotherLight() {
        changedLightIsLookedAtAnew(changed -> changed.setNoise(4));
    }

    @Test
    void lessNoiseIsAnotherLightNearTheEndsOfTheScale() {
        changedLightIsLookedAtAnew(changed -> changed.setNoise(0.5));
    }

    @Test
    void anotherCurveIsAnotherLight() {
        changedLightIsLookedAtAnew(changed -> changed.set(ToneCurve.gamma(1.9)));
    }

    @Test
    void pixelsThatAreAddedCount() {
        profile.turn(0.28, 0.96);
        scale.set(ToneCurve.SRGB);
        SideFit side = side();
        assertTrue(side.fit(scale, profile, SideFit.SETTLED_PX));
        assertTrue(side.conclude(scale, profile, false));
        double squares = side.squares;
        side.add(0, 0.2, 200, 0, 255, 1, 0, 0);
        assertTrue(side.conclude(scale, profile, false));
        assertTrue(side.squares > squares + 1, "an outlier in the middle of the edge");
    }
}
