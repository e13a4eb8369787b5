package org.cellgauge.internal.sampling;

import java.util.ArrayList;
import java.util.List;
import org.cellgauge.internal.pose.IntrinsicsPrior;
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
     * @param intrinsics which intrinsics these have, and what is known of them beforehand
     * @return rotation 0.1 rad, translation 10 mm, translation 1 mm, rotation 0.01 rad; where they are estimated, focal
     *     lengths 15 px; and what the thesis does not know of: other unknown intrinsics, and unknowns that markers
     *     share, by half of the deviation that they have beforehand
     */
    public static List<Proposal> proposals(StateLayout layout, IntrinsicsPrior intrinsics) {
        List<Proposal> list = new ArrayList<>();
        list.add(new GaussianStep("rotation 0.1 rad", 3, 3, 0.1, 2 * Math.PI));
        list.add(new GaussianStep("translation 10 mm", 0, 3, 10, 0));
        list.add(new GaussianStep("translation 1 mm", 0, 3, 1, 0));
        list.add(new GaussianStep("rotation 0.01 rad", 3, 3, 0.01, 2 * Math.PI));
        // the thesis knows of estimated focal lengths alone, which come first
        int focal = Math.min(2, intrinsics.estimatedCount());
        if (focal > 0) {
            list.add(new GaussianStep("focal length 15 px", layout.intrinsics(), focal, 15, 0));
        }
        for (int i = focal; i < intrinsics.count(); i++) {
            list.add(new GaussianStep("intrinsic " + i + " by half a deviation", layout.intrinsics() + i, 1,
                    intrinsics.std(i) / 2, 0));
        }
        // the added noise is standard normal beforehand as well
        int shared = layout.size() - layout.shared();
        if (shared > 0) {
            list.add(new GaussianStep("shared by markers 0.5", layout.shared(), shared, 0.5, 0));
        }
        return list;
    }
}
