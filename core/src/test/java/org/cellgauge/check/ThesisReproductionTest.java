package org.cellgauge.check;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Arrays;
import java.util.List;
import org.cellgauge.sampling.AcceptanceCount;
import org.cellgauge.settings.CheckSettings;
import org.cellgauge.settings.Estimate;
import org.junit.jupiter.api.Test;

/**
 * Acceptance of the thesis' sampler against an independent implementation of it: three references in the plane placed
 * to 20 mm, exact corners, 10 000 iterations.
 */
class ThesisReproductionTest {
    /** Accepted of each proposal, by seed; objects have no part in it and are left out. */
    private static long[][] accepted(Estimate estimate, int seeds, String... proposals) {
        ThesisScene scene = ThesisScene.inPlane(3).placement(20, 0.01).noObjects();
        long[][] accepted = new long[seeds][];
        for (int s = 0; s < seeds; s++) {
            CheckResult result = CellCheck.run(scene.cell(), scene.exactDetections(),
                    CheckSettings.thesis().estimate(estimate).seed(1000 + s).threads(1).build());
            List<AcceptanceCount> counts = result.acceptance();
            assertEquals(Arrays.asList(proposals),
                    Arrays.asList(counts.stream().map(AcceptanceCount::proposal).toArray()));
            assertEquals(10_000, counts.stream().mapToLong(c -> c.accepted() + c.rejected()).sum());
            assertEquals(5_000, result.draws().get(0).count());
            // effective draws are a handful: never a figure without the word
            assertEquals(Verdict.NOT_CONVERGED, result.verdict(), "seed " + s);
            accepted[s] = counts.stream().mapToLong(AcceptanceCount::accepted).toArray();
        }
        return accepted;
    }

    private static double median(double[] values) {
        double[] sorted = values.clone();
        Arrays.sort(sorted);
        return (sorted[(sorted.length - 1) / 2] + sorted[sorted.length / 2]) / 2;
    }

    private static double medianTotal(long[][] accepted) {
        return median(Arrays.stream(accepted).mapToDouble(a -> Arrays.stream(a).sum()).toArray());
    }

    @Test
    void acceptedStepsAndTheirSplitAreThoseOfTheReferenceImplementation() {
        long[][] accepted = accepted(Estimate.NONE, 24, "rotation 0.1 rad", "translation 10 mm",
                "translation 1 mm", "rotation 0.01 rad");
        // both sides are medians that scatter by about 0.5 %; the rest is for the start, which may be read in two ways
        assertEquals(2858, medianTotal(accepted), 0.04 * 2858);
        double[] expected = {1, 401, 2130, 323};
        for (int p = 0; p < expected.length; p++) {
            int proposal = p;
            double found = median(Arrays.stream(accepted).mapToDouble(a -> a[proposal]).toArray());
            // counts of a Markov chain scatter somewhat more than Poisson's; two medians of 24 are compared, each good
            // to 1.25 / sqrt(24) deviations: 0.36 deviations, times three, and 3 % as above
            assertEquals(expected[p], found, 0.03 * expected[p] + 1.5 * Math.sqrt(expected[p]), "proposal " + p);
        }
    }

    @Test
    void focalLengthAsFifthProposalAcceptsAsManyAsTheReferenceImplementation() {
        long[][] accepted = accepted(Estimate.FOCAL, 12, "rotation 0.1 rad", "translation 10 mm",
                "translation 1 mm", "rotation 0.01 rad", "focal length 15 px");
        assertEquals(2991, medianTotal(accepted), 0.04 * 2991);
    }
}
