package org.cellgauge.sampling;

import java.util.ArrayList;
import java.util.List;

/**
 * The thesis' proposals (section 7.2.1), for coordinates of {@link org.cellgauge.posterior.EulerChart}: translation
 * only or rotation only, broad or narrow, and the focal lengths where they are unknown.
 */
public final class ThesisMixture {
    private ThesisMixture() {
    }

    /**
     * The proposals, each to be chosen as often as the others.
     *
     * @param unknownIntrinsics number of unknown intrinsics; 0 leaves the last proposal out
     * @return rotation 0.1 rad, translation 10 mm, translation 1 mm, rotation 0.01 rad, focal lengths 15 px
     */
    public static List<Proposal> proposals(int unknownIntrinsics) {
        return proposals(unknownIntrinsics, 0);
    }

    /**
     * The same where markers share unknowns, which the thesis does not know of.
     *
     * @param unknownIntrinsics number of unknown intrinsics
     * @param shared number of coordinates after these, each standard normal beforehand; 0 leaves the last proposal out
     * @return the proposals, and a step of half a deviation in what is shared
     */
    public static List<Proposal> proposals(int unknownIntrinsics, int shared) {
        List<Proposal> list = new ArrayList<>();
        list.add(new GaussianStep("rotation 0.1 rad", 3, 3, 0.1, 2 * Math.PI));
        list.add(new GaussianStep("translation 10 mm", 0, 3, 10, 0));
        list.add(new GaussianStep("translation 1 mm", 0, 3, 1, 0));
        list.add(new GaussianStep("rotation 0.01 rad", 3, 3, 0.01, 2 * Math.PI));
        if (unknownIntrinsics > 0) {
            list.add(new GaussianStep("focal length 15 px", 6, unknownIntrinsics, 15, 0));
        }
        if (shared > 0) {
            list.add(new GaussianStep("shared by markers 0.5", 6 + unknownIntrinsics, shared, 0.5, 0));
        }
        return list;
    }
}
