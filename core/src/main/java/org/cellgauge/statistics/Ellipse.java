package org.cellgauge.statistics;

import org.cellgauge.internal.statistics.CovarianceChecks;
import org.cellgauge.internal.statistics.CoverageRegion;

/**
 * An ellipse in the plane, with everything needed to draw it.
 *
 * <p>The unit is the caller's, say image px; angles run from the x towards the y axis, so in an image with y down they
 * turn clockwise on the screen. An axis may have length zero: the ellipse is then a line or a point. Immutable.
 */
public final class Ellipse {
    /** How far beyond the boundary, relative to the sizes involved, still passes for rounding. */
    private static final double ROUNDING = 1e-12;

    private final double centreX;
    private final double centreY;
    private final double semiMajor;
    private final double semiMinor;
    private final double angleRad;

    /**
     * An ellipse from its axes.
     *
     * @param centreX x of the centre
     * @param centreY y of the centre
     * @param semiMajor half the longer axis, at least {@code semiMinor}
     * @param semiMinor half the shorter axis, at least 0
     * @param angleRad angle of the longer axis, rad; kept in (-pi/2, pi/2]
     * @throws IllegalArgumentException if a number is not finite, or the axes are out of order or negative
     */
    public Ellipse(double centreX, double centreY, double semiMajor, double semiMinor, double angleRad) {
        CovarianceChecks.requireFinite(new double[] {centreX, centreY, semiMajor, semiMinor, angleRad}, "ellipse");
        if (!(semiMinor >= 0 && semiMajor >= semiMinor)) {
            throw new IllegalArgumentException("semi-axes must be in order and not negative, were " + semiMajor
                    + " and " + semiMinor);
        }
        this.centreX = centreX;
        this.centreY = centreY;
        this.semiMajor = semiMajor;
        this.semiMinor = semiMinor;
        // An axis has no sense of direction: half a turn is none
        double wrapped = angleRad > -Math.PI / 2 && angleRad <= Math.PI / 2
                ? angleRad
                : Math.IEEEremainder(angleRad, Math.PI);
        this.angleRad = wrapped <= -Math.PI / 2 ? Math.PI / 2 : wrapped;
    }

    /**
     * The ellipse that holds a normally distributed point with a stated probability. The squared coverage factor is the
     * chi-square quantile of two degrees of freedom, -2 ln(1 - p) (JCGM 102:2011, section 6.5).
     *
     * @param mean x and y
     * @param covariance 2 by 2, symmetric and positive semi-definite, to within rounding
     * @param probability that the ellipse holds, in (0, 1)
     * @return the ellipse; its angle is 0 if both axes are equal
     * @throws IllegalArgumentException if shapes differ, a number is not finite, the covariance is not symmetric and
     *     positive semi-definite, or the probability is outside (0, 1)
     */
    public static Ellipse ofNormal(double[] mean, double[][] covariance, double probability) {
        if (mean.length != 2) {
            throw new IllegalArgumentException("expected a mean of 2 components, got " + mean.length);
        }
        CovarianceChecks.standardDeviations(covariance, 2);
        double factorSquared = CoverageRegion.chiSquareQuantile(probability, 2);
        double a = covariance[0][0];
        double c = covariance[1][1];
        double b = (covariance[0][1] + covariance[1][0]) / 2;
        double radius = Math.hypot((a - c) / 2, b);
        double major = (a + c) / 2 + radius;
        // The product of the eigenvalues keeps the digits that their difference would lose in a narrow ellipse.
        // Division first, because a product of two tiny variances may underflow
        double minor = major > 0 ? Math.max(0, a * (c / major) - b * (b / major)) : 0;
        double angle = radius > 0 ? Math.atan2(2 * b, a - c) / 2 : 0;
        return new Ellipse(mean[0], mean[1], Math.sqrt(factorSquared * major),
                Math.sqrt(factorSquared * Math.min(minor, major)), angle);
    }

    /**
     * x of the centre.
     *
     * @return the coordinate
     */
    public double centreX() {
        return centreX;
    }

    /**
     * y of the centre.
     *
     * @return the coordinate
     */
    public double centreY() {
        return centreY;
    }

    /**
     * Half the longer axis.
     *
     * @return the length, at least {@link #semiMinor()}
     */
    public double semiMajor() {
        return semiMajor;
    }

    /**
     * Half the shorter axis.
     *
     * @return the length, not negative
     */
    public double semiMinor() {
        return semiMinor;
    }

    /**
     * Angle of the longer axis, from the x towards the y axis.
     *
     * @return the angle in (-pi/2, pi/2], rad
     */
    public double angleRad() {
        return angleRad;
    }

    /**
     * Whether a point lies within the ellipse or on its boundary, to within rounding (1e-12 of the sizes involved).
     *
     * @param x x of the point
     * @param y y of the point
     * @return true if it does; false for a point that is not finite
     */
    public boolean contains(double x, double y) {
        double dx = x - centreX;
        double dy = y - centreY;
        double cos = Math.cos(angleRad);
        double sin = Math.sin(angleRad);
        double along = Math.abs(cos * dx + sin * dy);
        double across = Math.abs(-sin * dx + cos * dy);
        double rounding = ROUNDING * Math.max(semiMajor, Math.max(Math.abs(centreX), Math.abs(centreY)));
        if (!(along <= semiMajor + rounding && across <= semiMinor + rounding)) {
            return false;
        }
        double u = along <= rounding ? 0 : along / (semiMajor + rounding);
        double v = across <= rounding ? 0 : across / (semiMinor + rounding);
        return u * u + v * v <= 1 + ROUNDING;
    }

    /**
     * Points along the boundary, evenly spaced in the parametric angle, beginning at the end of the longer axis.
     *
     * @param n number of points, at least 3; the first is not repeated at the end
     * @return {@code [point][x, y]}
     * @throws IllegalArgumentException if n is below 3
     */
    public double[][] boundary(int n) {
        if (n < 3) {
            throw new IllegalArgumentException("a boundary needs at least 3 points, asked for " + n);
        }
        double cos = Math.cos(angleRad);
        double sin = Math.sin(angleRad);
        double[][] points = new double[n][2];
        for (int i = 0; i < n; i++) {
            double t = 2 * Math.PI * i / n;
            double along = semiMajor * Math.cos(t);
            double across = semiMinor * Math.sin(t);
            points[i][0] = centreX + cos * along - sin * across;
            points[i][1] = centreY + sin * along + cos * across;
        }
        return points;
    }
}
