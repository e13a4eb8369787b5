package org.cellgauge.internal.pose;

import org.cellgauge.cell.Placement;
import org.cellgauge.cell.Reference;
import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.internal.geometry.MarkerGeometry;

/**
 * Points that stand in the world together, off their stated place by one rigid error, and how precisely they were
 * placed; immutable. A reference marker is a body of four points.
 *
 * <p>The error is a shift along the world axes in mm and a rotation vector about the body's own origin in world axes in
 * rad, Gaussian about zero.
 */
public final class Body {
    private static final int POSE = StateLayout.POSE;

    private final int id;
    private final RigidTransform worldFromBody;
    private final double[] pointsMm;
    private final double[] root;
    private final boolean independent;
    private final double markerSizeMm;

    private Body(int id, RigidTransform worldFromBody, double[] pointsMm, double[] root, double markerSizeMm) {
        this.id = id;
        this.worldFromBody = worldFromBody;
        this.pointsMm = pointsMm;
        this.root = root;
        this.markerSizeMm = markerSizeMm;
        boolean diagonal = true;
        for (int i = 0; i < POSE; i++) {
            for (int j = 0; j < i; j++) {
                diagonal &= root[POSE * i + j] == 0;
            }
        }
        independent = diagonal;
    }

    /**
     * A reference marker: its four corners, placed as its cell file says.
     *
     * @param reference the reference
     * @return the body
     */
    public static Body of(Reference reference) {
        Placement placement = reference.placement();
        double[] root = new double[POSE * POSE];
        for (int i = 0; i < POSE; i++) {
            root[(POSE + 1) * i] = i < 3 ? placement.stdMm(i) : placement.stdRad();
        }
        return new Body(reference.id(), reference.worldFromMarker(),
                MarkerGeometry.cornersMm(reference.worldFromMarker(), reference.sizeMm()), root, reference.sizeMm());
    }

    /**
     * A body of any points.
     *
     * @param id a name
     * @param worldFromBody stated pose
     * @param pointsInBodyMm x, y, z of each point in the body's frame, mm
     * @param placement covariance of the placement error, 6x6 row by row; order and units above; rows and columns of
     *     zeros for what is exact
     * @return the body
     * @throws IllegalArgumentException if the covariance is no such matrix, or there is no point
     */
    public static Body of(int id, RigidTransform worldFromBody, double[] pointsInBodyMm, double[] placement) {
        if (pointsInBodyMm.length == 0 || pointsInBodyMm.length % 3 != 0 || placement.length != POSE * POSE) {
            throw new IllegalArgumentException("needs three values per point and " + POSE * POSE
                    + " of the covariance");
        }
        double[] world = new double[pointsInBodyMm.length];
        for (int k = 0; k < world.length; k += 3) {
            double[] point = {pointsInBodyMm[k], pointsInBodyMm[k + 1], pointsInBodyMm[k + 2]};
            System.arraycopy(worldFromBody.apply(point), 0, world, k, 3);
        }
        return new Body(id, worldFromBody, world, root(placement), Double.NaN);
    }

    /** Lower Cholesky factor of a covariance that may be zero in some coordinates. */
    private static double[] root(double[] covariance) {
        double[] l = new double[POSE * POSE];
        for (int j = 0; j < POSE; j++) {
            double d = covariance[(POSE + 1) * j];
            for (int k = 0; k < j; k++) {
                d -= l[POSE * j + k] * l[POSE * j + k];
            }
            boolean exact = covariance[(POSE + 1) * j] == 0;
            if (!exact && !(d > 0)) {
                throw new IllegalArgumentException("the covariance of a placement must be positive definite but for "
                        + "coordinates that are exact");
            }
            l[(POSE + 1) * j] = exact ? 0 : Math.sqrt(d);
            for (int i = j + 1; i < POSE; i++) {
                double s = covariance[POSE * i + j];
                for (int k = 0; k < j; k++) {
                    s -= l[POSE * i + k] * l[POSE * j + k];
                }
                l[POSE * i + j] = exact ? 0 : s / l[(POSE + 1) * j];
            }
        }
        return l;
    }

    /**
     * Its name.
     *
     * @return of a marker: its id
     */
    public int id() {
        return id;
    }

    /**
     * Where it is stated to stand.
     *
     * @return worldFromBody
     */
    public RigidTransform worldFromBody() {
        return worldFromBody;
    }

    /**
     * Number of its points.
     *
     * @return at least 1
     */
    public int points() {
        return pointsMm.length / 3;
    }

    /** Its points where it is stated to stand, three values each, world, mm; shared within the package. */
    double[] pointsMm() {
        return pointsMm;
    }

    /**
     * Outer edge of the marker that it is.
     *
     * @return mm; NaN for a body that is no single marker
     */
    public double markerSizeMm() {
        return markerSizeMm;
    }

    /**
     * Whether the six coordinates of its placement error are independent of each other.
     *
     * @return true for a placement stated by deviations alone
     */
    public boolean isIndependentlyPlaced() {
        return independent;
    }

    /**
     * An entry of the lower Cholesky factor L of its placement's covariance: {@code error = L e}, e standard normal.
     * Where coordinates are independent, its diagonal has their standard deviations.
     *
     * @param i row, 0 to 5: shift along world x, y, z in mm, rotation vector in rad
     * @param j column, 0 to 5
     * @return 0 above the diagonal
     */
    public double placementRoot(int i, int j) {
        return root[POSE * i + j];
    }
}
