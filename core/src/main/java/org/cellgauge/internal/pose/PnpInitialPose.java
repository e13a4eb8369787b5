package org.cellgauge.internal.pose;

import java.util.ArrayList;
import java.util.List;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.geometry.RigidTransform;

/**
 * Perspective-n-point over all references at once: candidates of EPnP and of each reference alone, each refined by
 * least squares with equal weights; the one that most references agree with, then the one with the smallest error,
 * wins.
 */
final class PnpInitialPose implements InitialPose {
    /** A corner farther off than this from where a candidate puts it counts as this far off: a foreign marker, px. */
    private static final double OUTLIER_PX = 30;

    @Override
    public RigidTransform estimate(ReferenceView view, PinholeCamera camera) {
        List<RigidTransform> candidates = new ArrayList<>();
        RigidTransform joint = TargetPnp.general(camera, view.points(), view.observed());
        if (joint != null) {
            candidates.add(joint);
        }
        for (int m = 0; m < view.size(); m++) {
            RigidTransform alone = AverageInitialPose.ofOneReference(view, m, camera);
            if (alone != null) {
                candidates.add(view.cameraFromSet(alone));
            }
        }
        RigidTransform best = null;
        double bestCost = Double.POSITIVE_INFINITY;
        for (RigidTransform candidate : candidates) {
            RigidTransform refined = refine(view, camera, candidate);
            double cost = truncatedCost(view, camera, refined);
            if (cost < bestCost) {
                bestCost = cost;
                best = refined;
            }
        }
        return best == null ? null : view.worldFromCamera(best);
    }

    /** Least squares over the references that a candidate nearly explains, twice, so that foreign markers drop out. */
    private static RigidTransform refine(ReferenceView view, PinholeCamera camera, RigidTransform start) {
        RigidTransform pose = start;
        for (int round = 0; round < 2; round++) {
            List<Integer> near = new ArrayList<>();
            for (int m = 0; m < view.size(); m++) {
                if (truncatedCost(view, camera, pose, m) < 4 * OUTLIER_PX * OUTLIER_PX) {
                    near.add(m);
                }
            }
            if (near.isEmpty()) {
                return pose;
            }
            double[] points = new double[12 * near.size()];
            double[] observed = new double[8 * near.size()];
            for (int i = 0; i < near.size(); i++) {
                System.arraycopy(view.points(), 12 * near.get(i), points, 12 * i, 12);
                System.arraycopy(view.observed(), 8 * near.get(i), observed, 8 * i, 8);
            }
            ReprojectionFit fit = new ReprojectionFit(points, observed, IntrinsicsPrior.KNOWN, null);
            fit.setIsotropic(1);
            CameraState state = CameraState.of(pose, camera);
            if (Double.isNaN(fit.fit(state))) {
                return pose;
            }
            pose = state.cameraFromSet();
        }
        return pose;
    }

    private static double truncatedCost(ReferenceView view, PinholeCamera camera, RigidTransform cameraFromSet) {
        double cost = 0;
        for (int m = 0; m < view.size(); m++) {
            cost += truncatedCost(view, camera, cameraFromSet, m);
        }
        return cost;
    }

    private static double truncatedCost(ReferenceView view, PinholeCamera camera, RigidTransform cameraFromSet,
            int marker) {
        double[] points = view.points();
        double[] observed = view.observed();
        double cost = 0;
        for (int k = 0; k < 4; k++) {
            int at = 12 * marker + 3 * k;
            double[] p = cameraFromSet.apply(points[at], points[at + 1], points[at + 2]);
            double[] uv = camera.project(p[0], p[1], p[2]);
            double error = uv == null ? OUTLIER_PX
                    : Math.hypot(uv[0] - observed[8 * marker + 2 * k], uv[1] - observed[8 * marker + 2 * k + 1]);
            cost += Math.min(error * error, OUTLIER_PX * OUTLIER_PX);
        }
        return cost;
    }
}
