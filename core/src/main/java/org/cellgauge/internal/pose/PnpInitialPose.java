package org.cellgauge.internal.pose;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.settings.Estimate;
import org.jspecify.annotations.Nullable;

/**
 * Perspective-n-point over all references at once: candidates of EPnP and of each reference alone, each refined by
 * least squares with equal weights; the one that most references agree with, then the one with the smallest error,
 * wins. Of many references those alone are refined that agree best with a part of the others, so that the time grows
 * with their number and not with its square.
 */
final class PnpInitialPose implements InitialPose {
    /** A corner farther off than this from where a candidate puts it counts as this far off: a foreign marker, px. */
    private static final double OUTLIER_PX = 30;
    /** Candidates of one reference that are refined, and references by which they are chosen where there are more. */
    private static final int MOST_REFINED = 16;

    @Override
    public @Nullable RigidTransform estimate(ReferenceView view, PinholeCamera camera) {
        List<RigidTransform> candidates = new ArrayList<>();
        RigidTransform joint = new TargetPnp().general(camera, view.points(), view.observed());
        if (joint != null) {
            candidates.add(joint);
        }
        candidates.addAll(ofSingleReferences(view, camera));
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

    /** The poses of the references one by one; of many those that most of some all over the set agree with. */
    private static List<RigidTransform> ofSingleReferences(ReferenceView view, PinholeCamera camera) {
        List<RigidTransform> alone = new ArrayList<>();
        MarkerPoseFinder finder = new MarkerPoseFinder();
        for (int m = 0; m < view.size(); m++) {
            RigidTransform worldFromCamera = AverageInitialPose.ofOneReference(view, m, camera, finder);
            if (worldFromCamera != null) {
                alone.add(view.cameraFromSet(worldFromCamera));
            }
        }
        if (alone.size() <= MOST_REFINED) {
            return alone;
        }
        double[] costs = new double[alone.size()];
        for (int c = 0; c < costs.length; c++) {
            for (int i = 0; i < MOST_REFINED; i++) {
                costs[c] += truncatedCost(view, camera, alone.get(c), i * view.size() / MOST_REFINED);
            }
        }
        return IntStream.range(0, costs.length).boxed().sorted(Comparator.comparingDouble(c -> costs[c]))
                .limit(MOST_REFINED).map(alone::get).collect(Collectors.toList());
    }

    /** A candidate refined alike, and how far it leaves corners off, px². */
    static @Nullable Estimate refined(ReferenceView view, PinholeCamera camera, List<RigidTransform> worldFromCameras) {
        RigidTransform best = null;
        double least = Double.POSITIVE_INFINITY;
        for (RigidTransform candidate : worldFromCameras) {
            RigidTransform cameraFromSet = view.cameraFromSet(candidate);
            double cost = truncatedCost(view, camera, cameraFromSet);
            if (cost < least) {
                least = cost;
                best = cameraFromSet;
            }
        }
        if (best == null) {
            return null;
        }
        RigidTransform pose = refine(view, camera, best);
        return new Estimate(view.worldFromCamera(pose), truncatedCost(view, camera, pose));
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
