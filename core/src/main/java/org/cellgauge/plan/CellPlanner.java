package org.cellgauge.plan;

import java.util.Collections;
import java.util.List;
import org.cellgauge.internal.plan.PlanSearch;

/**
 * Finds what a set-up would reach, and which change of it reaches the target, without a photo.
 *
 * <p>Deviations come from the Fisher information of the model of the cell at the true poses: Laplace's approximation,
 * which chains confirm where placement errors are small beside the distance. Nothing is said about poses that a photo
 * could confuse, and a reference counts where it is seen whole; whether it is read is left to the photo.
 */
public final class CellPlanner {
    private CellPlanner() {
    }

    /**
     * What a photo of a layout would tell.
     *
     * @param layout the cell, the camera and the objects
     * @param options what to reckon with
     * @return deviations of every object and gripping point
     */
    public static Forecast forecast(Layout layout, PlanOptions options) {
        return new PlanSearch(layout, options).forecast();
    }

    /**
     * What a layout would reach and what would reach its target.
     *
     * @param layout the cell, the camera and the objects, at least one of them
     * @param options what to reckon with
     * @return the plan
     * @throws IllegalArgumentException if there is no object in the layout, or references err together in it already
     */
    public static Plan plan(Layout layout, PlanOptions options) {
        require(layout);
        return new PlanSearch(layout, options).plan();
    }

    /**
     * The cheapest changes that meet a target which is missed, found within some milliseconds: fewer sizes, places and
     * combinations are tried than by {@link #plan}.
     *
     * @param layout the cell, the camera and the objects, at least one of them
     * @param options what to reckon with
     * @return at most three proposals, cheapest first; none where the target is met as it is, where there is none, and
     *     where nothing that was tried meets it
     * @throws IllegalArgumentException as {@link #plan}
     */
    public static List<Proposal> advice(Layout layout, PlanOptions options) {
        require(layout);
        return layout.cell().target().isAny()
                ? new PlanSearch(layout, options).advice() : Collections.emptyList();
    }

    private static void require(Layout layout) {
        if (layout.worldFromObjects().isEmpty()) {
            throw new IllegalArgumentException("there is no object whose place could be asked for");
        }
        if (!layout.isOnePhoto()) {
            throw new IllegalArgumentException("plates, distances and more photos are what a plan proposes");
        }
    }
}
