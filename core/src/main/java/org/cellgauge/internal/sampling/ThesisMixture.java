package org.cellgauge.internal.sampling;

import java.util.ArrayList;
import java.util.List;
import org.cellgauge.internal.pose.StateLayout;

/**
 * The thesis' proposals (section 7.2.1), for coordinates of
 * {@link org.cellgauge.internal.posterior.EulerChart}: translation only or rotation only, broad or narrow, and the
 * focal lengths where they are unknown.
 */
public final class ThesisMixture {
    private ThesisMixture() {
    }

    /**
     * The proposals, each to be chosen as often as the others.
     *
     * @param layout of the coordinates
     * @return rotation 0.1 rad, translation 10 mm, translation 1 mm, rotation 0.01 rad; where they are unknown, focal
     *     lengths 15 px; and where markers share unknowns, which the thesis does not know of, half a deviation of these
     */
    public static List<Proposal> proposals(StateLayout layout) {
        List<Proposal> list = new ArrayList<>();
        list.add(new GaussianStep("rotation 0.1 rad", 3, 3, 0.1, 2 * Math.PI));
        list.add(new GaussianStep("translation 10 mm", 0, 3, 10, 0));
        list.add(new GaussianStep("translation 1 mm", 0, 3, 1, 0));
        list.add(new GaussianStep("rotation 0.01 rad", 3, 3, 0.01, 2 * Math.PI));
        if (layout.intrinsicsCount() > 0) {
            list.add(new GaussianStep("focal length 15 px", layout.intrinsics(), layout.intrinsicsCount(), 15, 0));
        }
        // the added noise is standard normal beforehand as well
        int shared = layout.size() - layout.shared();
        if (shared > 0) {
            list.add(new GaussianStep("shared by markers 0.5", layout.shared(), shared, 0.5, 0));
        }
        return list;
    }
}
