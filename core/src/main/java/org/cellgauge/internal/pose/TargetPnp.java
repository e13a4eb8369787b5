package org.cellgauge.internal.pose;

import boofcv.abst.geo.Estimate1ofPnP;
import boofcv.factory.geo.ConfigPnP;
import boofcv.factory.geo.ConfigRansac;
import boofcv.factory.geo.EnumPNP;
import boofcv.factory.geo.FactoryMultiView;
import boofcv.factory.geo.FactoryMultiViewRobust;
import boofcv.struct.calib.CameraPinhole;
import boofcv.struct.geo.Point2D3D;
import georegression.struct.se.Se3_F64;
import java.util.ArrayList;
import java.util.List;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.internal.geometry.TangentPlane;
import org.ejml.data.DMatrixRMaj;
import org.ejml.dense.row.CommonOps_DDRM;
import org.ejml.dense.row.SingularOps_DDRM;
import org.ejml.dense.row.factory.DecompositionFactory_DDRM;
import org.ejml.interfaces.decomposition.SingularValueDecomposition_F64;
import org.jspecify.annotations.Nullable;

/** BoofCV's perspective-n-point solvers over this project's types; holds their work space, for one thread. */
final class TargetPnp {
    private static final int RANSAC_ITERATIONS = 500;
    private static final int SPACE = 3;

    private final List<Point2D3D> spare = new ArrayList<>();
    private final List<Point2D3D> pairs = new ArrayList<>();
    private final Se3_F64 found = new Se3_F64();
    private final SingularValueDecomposition_F64<DMatrixRMaj> svd =
            DecompositionFactory_DDRM.svd(SPACE, SPACE, true, true, false);
    private final DMatrixRMaj copy = new DMatrixRMaj(SPACE, SPACE);
    private final DMatrixRMaj left = new DMatrixRMaj(SPACE, SPACE);
    private final DMatrixRMaj right = new DMatrixRMaj(SPACE, SPACE);
    private final DMatrixRMaj nearest = new DMatrixRMaj(SPACE, SPACE);
    private @Nullable Estimate1ofPnP ofPlanes;

    /** The plane in which a wide lens's corners are looked at; null for other lenses, which have one for all. */
    private static @Nullable TangentPlane plane(PinholeCamera camera, double[] observed) {
        if (!camera.lens().isWide()) {
            return null;
        }
        TangentPlane plane = new TangentPlane(camera);
        // one that cannot be aimed shows no corner
        plane.aim(observed);
        return plane;
    }

    private static @Nullable RigidTransform inCamera(@Nullable TangentPlane plane, @Nullable RigidTransform pose) {
        return plane == null || pose == null ? pose : plane.inCamera(pose);
    }

    /** Pairs of undistorted normalised image point and point in space; corners beyond the lens model are left out. */
    private List<Point2D3D> pairs(PinholeCamera camera, @Nullable TangentPlane plane, double[] points,
            double[] observed) {
        pairs.clear();
        double[] normalised = new double[2];
        for (int k = 0; k < points.length / 3; k++) {
            double u = observed[2 * k];
            double v = observed[2 * k + 1];
            if (plane != null ? plane.toNormalised(u, v, normalised) : camera.toNormalised(u, v, normalised)) {
                if (pairs.size() == spare.size()) {
                    spare.add(new Point2D3D());
                }
                Point2D3D pair = spare.get(pairs.size());
                pair.observation.setTo(normalised[0], normalised[1]);
                pair.location.setTo(points[3 * k], points[3 * k + 1], points[3 * k + 2]);
                pairs.add(pair);
            }
        }
        return pairs;
    }

    /**
     * Pose of points in one plane z = 0 by infinitesimal plane-based pose estimation (Collins and Bartoli, IJCV 2014).
     *
     * @return cameraFromPlane, or null where none was found
     */
    @Nullable RigidTransform planar(PinholeCamera camera, double[] points, double[] observed) {
        if (ofPlanes == null) {
            ofPlanes = FactoryMultiView.pnp_1(EnumPNP.IPPE, -1, 0);
        }
        TangentPlane plane = plane(camera, observed);
        return inCamera(plane, single(ofPlanes, pairs(camera, plane, points, observed)));
    }

    /**
     * Pose of points in general position by EPnP (Lepetit, Moreno-Noguer, Fua, IJCV 2009).
     *
     * @return cameraFromPoints, or null where none was found
     */
    @Nullable RigidTransform general(PinholeCamera camera, double[] points, double[] observed) {
        TangentPlane plane = plane(camera, observed);
        return inCamera(plane, single(FactoryMultiView.pnp_1(EnumPNP.EPNP, 50, 0),
                pairs(camera, plane, points, observed)));
    }

    private @Nullable RigidTransform single(Estimate1ofPnP estimator, List<Point2D3D> of) {
        if (of.size() < 4) {
            return null;
        }
        return estimator.process(of, found) ? toTransform(found) : null;
    }

    /**
     * Pose by random sample consensus over single corners (Fischler and Bolles 1981), P3P inside.
     *
     * @param thresholdPx corners within this distance agree
     * @param seed seed of the sampling
     * @return cameraFromPoints, or null where no consensus was found
     */
    @Nullable RigidTransform ransac(PinholeCamera camera, double[] points, double[] observed, double thresholdPx,
            long seed) {
        TangentPlane plane = plane(camera, observed);
        if (pairs(camera, plane, points, observed).size() < 4) {
            return null;
        }
        ConfigRansac config = new ConfigRansac(RANSAC_ITERATIONS, thresholdPx);
        config.randSeed = seed;
        var matcher = FactoryMultiViewRobust.pnpRansac(new ConfigPnP(), config);
        matcher.setIntrinsic(0, new CameraPinhole(camera.get(PinholeCamera.FX), camera.get(PinholeCamera.FY), 0,
                camera.get(PinholeCamera.CX), camera.get(PinholeCamera.CY), camera.widthPx(), camera.heightPx()));
        return matcher.process(pairs) ? inCamera(plane, toTransform(matcher.getModelParameters())) : null;
    }

    private @Nullable RigidTransform toTransform(Se3_F64 pose) {
        double[] t = {pose.T.x, pose.T.y, pose.T.z};
        for (double v : t) {
            if (!Double.isFinite(v)) {
                return null;
            }
        }
        // solvers return matrices that are rotations only to rounding or worse: take the nearest rotation
        // a decomposition may destroy what it is given
        copy.setTo(pose.R);
        if (!svd.decompose(copy)) {
            return null;
        }
        CommonOps_DDRM.mult(svd.getU(left, false), svd.getV(right, true), nearest);
        if (CommonOps_DDRM.det(nearest) < 0 || SingularOps_DDRM.rank(svd, 1e-9) < SPACE) {
            return null;
        }
        return RigidTransform.of(nearest.data, t);
    }
}
