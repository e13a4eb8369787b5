package org.cellgauge.validation;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.apache.commons.math3.random.RandomGenerator;
import org.cellgauge.cell.Cell;
import org.cellgauge.cell.InputRefusedException;
import org.cellgauge.cell.ObjectMarker;
import org.cellgauge.cell.Reference;
import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.sampling.RandomStreams;

/** The same cell again and again, built anew each time: placement errors, camera and objects are drawn. Immutable. */
public final class OneCell implements CellSource {
    private static final int ATTEMPTS = 1000;
    /** Of a marker's longest side: half the diagonal of its white paper, and a little. */
    private static final double ROOM = 1.05;
    /** Of a marker's longest side, and in px: paper beyond the corners, and what blur needs. */
    private static final double PAPER = 0.2;
    private static final double BEYOND_PAPER_PX = 5;

    private final TruthPrior prior;
    private final boolean inFullView;

    private OneCell(TruthPrior prior, boolean inFullView) {
        this.prior = prior;
        this.inFullView = inFullView;
    }

    /**
     * Cells of which corners are drawn: it does not matter if markers hide each other.
     *
     * @param prior the cell and where its true poses come from
     * @return the source
     */
    public static OneCell of(TruthPrior prior) {
        return new OneCell(prior, false);
    }

    /**
     * Cells of which photos are taken: truths in which a marker's paper reaches over another's or out of the image are
     * drawn anew. That shortens the prior by places where markers are of no use, whatever a detector makes of them.
     *
     * @param prior the cell and where its true poses come from
     * @return the source; it refuses a cell whose markers hide each other in nearly all truths
     */
    public static OneCell inFullView(TruthPrior prior) {
        return new OneCell(prior, true);
    }

    @Override
    public SimulatedCell cell(long seed, int index) {
        RandomGenerator truths = RandomStreams.of(seed, Validation.STREAM_TRUTH, index);
        RandomGenerator placement = RandomStreams.of(seed, Validation.STREAM_PLACEMENT, index);
        Map<Integer, RigidTransform> references = new LinkedHashMap<>();
        for (Reference r : prior.cell().references()) {
            references.put(r.id(), SimulatedPhoto.misplaced(r, placement));
        }
        for (int i = 0; i < ATTEMPTS; i++) {
            SimulatedCell cell = new SimulatedCell(prior.cell(), prior.draw(truths), references);
            if (!inFullView || isInFullView(cell)) {
                return cell;
            }
        }
        throw new InputRefusedException("the markers hide each other, or reach out of the image, in nearly all true "
                + "poses; give --object poses farther apart, or a smaller --spread");
    }

    private static boolean isInFullView(SimulatedCell simulated) {
        Cell cell = simulated.cell();
        List<double[]> corners = new ArrayList<>();
        cell.references().forEach(r -> corners.add(simulated.cornersPx(r.id())));
        cell.objects().forEach(o -> corners.add(simulated.cornersPx(o.id())));
        for (int a = 0; a < corners.size(); a++) {
            double[] px = corners.get(a);
            if (px == null) {
                return false;
            }
            double beyond = PAPER * longestSide(px) + BEYOND_PAPER_PX;
            for (int i = 0; i < 8; i += 2) {
                if (!(px[i] > beyond && px[i + 1] > beyond && px[i] < cell.camera().widthPx() - beyond
                        && px[i + 1] < cell.camera().heightPx() - beyond)) {
                    return false;
                }
            }
            for (int b = 0; b < a; b++) {
                double[] other = corners.get(b);
                if (Math.hypot(mean(px, 0) - mean(other, 0), mean(px, 1) - mean(other, 1))
                        < ROOM * (longestSide(px) + longestSide(other))) {
                    return false;
                }
            }
        }
        return true;
    }

    private static double mean(double[] px, int axis) {
        return (px[axis] + px[axis + 2] + px[axis + 4] + px[axis + 6]) / 4;
    }

    private static double longestSide(double[] px) {
        double longest = 0;
        for (int k = 0; k < 4; k++) {
            int next = (k + 1) % 4;
            longest = Math.max(longest, Math.hypot(px[2 * next] - px[2 * k], px[2 * next + 1] - px[2 * k + 1]));
        }
        return longest;
    }

    @Override
    public String nameOf(ObjectMarker object) {
        return "object " + object.id();
    }
}
