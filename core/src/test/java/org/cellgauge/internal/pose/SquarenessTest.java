package org.cellgauge.internal.pose;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.cellgauge.check.ThesisScene;
import org.cellgauge.vision.MarkerObservation;
import org.junit.jupiter.api.Test;

class SquarenessTest {
    private static final double[] INFLATIONS = {9, 100, 1e4};

    /** A marker of which one corner is off. */
    private static Squareness squareness(double offPx) {
        MarkerObservation marker = ThesisScene.inPlane(1).exactDetections().markers().get(0);
        double[] corners = marker.cornersPx();
        corners[0] += offPx;
        double[] covariance = new double[64];
        for (int i = 0; i < 8; i++) {
            covariance[9 * i] = 0.01;
        }
        List<PoseMode> modes = new MarkerPoseFinder().modes(corners, ThesisScene.SIZE_MM, ThesisScene.CAMERA, 1);
        return new Squareness(modes, covariance);
    }

    @Test
    void meanLikelihoodIsTheMeanOfLikelihoods() {
        double[] logs = new double[INFLATIONS.length];
        for (double offPx : new double[] {0, 0.3, 3}) {
            Squareness squareness = squareness(offPx);
            double sum = 0;
            for (int k = 0; k < INFLATIONS.length; k++) {
                logs[k] = Math.log(INFLATIONS[k]);
                sum += Math.exp(squareness.logLikelihood(0.002, INFLATIONS[k]));
            }
            assertEquals(Math.log(sum / INFLATIONS.length), squareness.logMeanLikelihood(0.002, INFLATIONS, logs),
                    1e-12);
        }
    }

    @Test
    void likelihoodAtANodeIsThatOfItsVariance() {
        Squareness squareness = squareness(0.3);
        for (AddedNoise noise : new AddedNoise[] {AddedNoise.toFits(0.01), AddedNoise.toNothing()}) {
            for (int node = 0; node < AddedNoise.NODES; node += 10) {
                assertEquals(squareness.logLikelihood(noise.variancePx2(AddedNoise.atNode(node)), 1),
                        squareness.logLikelihood(noise, node), 0);
            }
        }
    }

    @Test
    void noNoiseExceedsTheLargestRatio() {
        double[] logs = new double[INFLATIONS.length];
        for (int k = 0; k < INFLATIONS.length; k++) {
            logs[k] = Math.log(INFLATIONS[k]);
        }
        AddedNoise noise = AddedNoise.toFits(0.01);
        for (double offPx : new double[] {0, 0.1, 0.3, 1, 3}) {
            Squareness squareness = squareness(offPx);
            double bound = squareness.largestRatio(noise.variancePx2AtNode(0), INFLATIONS);
            double most = 0;
            for (int node = 0; node < AddedNoise.NODES; node++) {
                most = Math.max(most, Math.exp(squareness.logMeanLikelihood(noise.variancePx2AtNode(node), INFLATIONS,
                        logs) - squareness.logLikelihood(noise, node)));
            }
            assertTrue(most <= bound * (1 + 1e-9), offPx + " px: " + most + " > " + bound);
        }
    }
}
