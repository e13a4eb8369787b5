package org.cellgauge.internal.validation;

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
import org.cellgauge.internal.sampling.RandomStreams;
import org.cellgauge.warning.Refusal;

/** The same cell again and again, built anew each time: placement errors, camera and objects are drawn. Immutable. */
public final class OneCell implements CellSource {
    private static final int ATTEMPTS = 1000;
    /** White paper by the marker's size, and a little. */
    private static final double PAPER = 1.45;

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
            references.put(r.id(), r.drawn(placement));
        }
        for (int i = 0; i < ATTEMPTS; i++) {
            SimulatedCell cell = new SimulatedCell(prior.cell(), prior.draw(truths), references);
            if (!inFullView || isInFullView(cell)) {
                return cell;
            }
        }
        throw new InputRefusedException(Refusal.of(ValidationRefusal.MARKERS_HIDDEN, ValidationRefusal.FARTHER_APART));
    }

    private static boolean isInFullView(SimulatedCell simulated) {
        Cell cell = simulated.cell();
        List<double[]> papers = new ArrayList<>();
        cell.references().forEach(r -> papers.add(paper(simulated.cornersPx(r.id()))));
        cell.objects().forEach(o -> papers.add(paper(simulated.cornersPx(o.id()))));
        double width = cell.camera().widthPx();
        double height = cell.camera().heightPx();
        double[] image = {0, 0, width, 0, width, height, 0, height};
        for (int a = 0; a < papers.size(); a++) {
            double[] px = papers.get(a);
            for (int i = 0; px != null && i < 8; i += 2) {
                px = px[i] > 0 && px[i] < image[2] && px[i + 1] > 0 && px[i + 1] < image[5] ? px : null;
            }
            if (px == null) {
                return false;
            }
            for (int b = 0; b < a; b++) {
                if (!apart(px, papers.get(b)) && !apart(papers.get(b), px)) {
                    return false;
                }
            }
        }
        return true;
    }

    /** Outline of a marker's paper, 8 values, or null without corners. */
    private static double[] paper(double[] px) {
        if (px == null) {
            return null;
        }
        double u = (px[0] + px[2] + px[4] + px[6]) / 4;
        double v = (px[1] + px[3] + px[5] + px[7]) / 4;
        double[] paper = new double[8];
        for (int i = 0; i < 8; i += 2) {
            paper[i] = u + PAPER * (px[i] - u);
            paper[i + 1] = v + PAPER * (px[i + 1] - v);
        }
        return paper;
    }

    /** Whether a side of one quadrilateral lies between it and the other. */
    private static boolean apart(double[] one, double[] other) {
        for (int k = 0; k < 4; k++) {
            int next = (k + 1) % 4;
            double nx = one[2 * next + 1] - one[2 * k + 1];
            double ny = one[2 * k] - one[2 * next];
            double least = Double.POSITIVE_INFINITY;
            double most = Double.NEGATIVE_INFINITY;
            double own = 0;
            for (int i = 0; i < 4; i++) {
                double along = nx * (other[2 * i] - one[2 * k]) + ny * (other[2 * i + 1] - one[2 * k + 1]);
                least = Math.min(least, along);
                most = Math.max(most, along);
                double inside = nx * (one[2 * i] - one[2 * k]) + ny * (one[2 * i + 1] - one[2 * k + 1]);
                own = Math.abs(inside) > Math.abs(own) ? inside : own;
            }
            if (own > 0 ? most < 0 : least > 0) {
                return true;
            }
        }
        return false;
    }

    @Override
    public String nameOf(ObjectMarker object) {
        return "object " + object.id();
    }
}
