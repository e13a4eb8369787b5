package org.cellgauge.vision;

import java.util.Arrays;
import org.cellgauge.internal.geometry.Cholesky;
import org.cellgauge.internal.vision.SideBand;
import org.jspecify.annotations.Nullable;

/**
 * The edge of the paper beside a side of a marker: a dark step, blurred as the marker's own. The light's profile
 * outwards, a mean over seven places along the side, is fitted by white, ground and the place of the edge
 * (Gauss-Newton).
 *
 * <p>Not thread-safe; work space is kept between sides.
 */
final class PaperEdge {
    /** How far outwards it is looked for. */
    private static final int STEPS = 24;
    private static final double STEP_PX = 0.5;
    private static final int LINES = 3;
    private static final int ROUNDS = 4;
    /** Beyond so many deviations of the blur from the band it need not be known well. */
    private static final double FAR_BLURS = 4;
    /** Variance that interpolating between pixels adds to the blur. */
    private static final double INTERPOLATION_VARIANCE = 1.0 / 6;
    /** A drop of the light by less than this share of the difference of white and black is no edge of the paper. */
    private static final double CONTRAST = 0.06;

    /** Distance from the side, outwards, px; infinite where there is none. */
    double px;
    /** How much darker the ground is than the paper, as a share of the difference of white and black. */
    double share;

    private final double[] light = new double[STEPS];
    /** What is seen of the side itself at the places of the profile. */
    private final double[] ofMarker = new double[STEPS];
    private final double[] normal = new double[9];
    private final double[] gradient = new double[3];
    private final double[] point = new double[2];

    /**
     * Looks for it.
     *
     * @param image the image
     * @param levels grey values to be taken instead of the image's; null for none
     * @param plane where the side is straight
     * @param scale tone curve
     * @param side place and direction of the side
     * @param std blur of its edge, the pixel's own extent among it, px
     * @param borderPx depth of the inner edge of the border, px: half of it is where a new side is dark
     */
    void find(GreyImage image, @Nullable Unsharpened levels, StraightPlane plane, GreyScale scale, SideFit side,
            double std, double borderPx) {
        px = Double.POSITIVE_INFINITY;
        share = 0;
        setProfile(image, levels, plane, scale, side);
        double most = Double.NEGATIVE_INFINITY;
        int mostAt = 0;
        for (int k = 0; k < STEPS && distance(k) < 2 + 2.5 * std; k++) {
            if (light[k] > most) {
                most = light[k];
                mostAt = k;
            }
        }
        double least = Double.POSITIVE_INFINITY;
        int leastAt = mostAt;
        for (int k = mostAt; k < STEPS; k++) {
            if (light[k] < least) {
                least = light[k];
                leastAt = k;
            } else if (light[k] > least + 0.3 * (most - least)) {
                break;
            }
        }
        double dark;
        if (side.started()) {
            dark = scale.light(side.unknowns[SideFit.DARK]);
        } else {
            double inside = borderPx / 2;
            plane.toImage(side.middleX - side.normalX * inside, side.middleY - side.normalY * inside, point, 0);
            dark = scale.tabulatedLight(interpolate(image, levels, point[0], point[1]));
        }
        if (!(most > dark) || most - least < CONTRAST * (most - dark)) {
            return;
        }
        double half = (most + least) / 2;
        double edge = Double.NaN;
        for (int k = mostAt + 1; k <= leastAt; k++) {
            if (light[k] < half) {
                edge = distance(k - 1) + STEP_PX * (light[k - 1] - half) / (light[k - 1] - light[k]);
                break;
            }
        }
        if (Double.isNaN(edge)) {
            return;
        }
        px = edge;
        share = Math.min(1.2, (most - least) / (most - dark));
        if (edge < FAR_BLURS * std + SideBand.HALF_WIDTH_PX) {
            fit(dark, most, least, edge, leastAt, Math.sqrt(std * std + INTERPOLATION_VARIANCE));
        }
    }

    private static double distance(int step) {
        return 0.5 + STEP_PX * step;
    }

    private void setProfile(GreyImage image, @Nullable Unsharpened levels, StraightPlane plane, GreyScale scale,
            SideFit side) {
        double[] out = light;
        Arrays.fill(out, 0);
        for (int n = -LINES; n <= LINES; n++) {
            double t = 0.35 * n * side.lengthPx / LINES;
            double fromX = side.middleX + side.tangentX * t;
            double fromY = side.middleY + side.tangentY * t;
            if (levels == null && !plane.isDistorted()
                    && image.hasNeighbours(fromX + side.normalX * distance(0), fromY + side.normalY * distance(0))
                    && image.hasNeighbours(fromX + side.normalX * distance(STEPS - 1),
                            fromY + side.normalY * distance(STEPS - 1))) {
                addInside(image, scale, fromX, fromY, side.normalX, side.normalY);
                continue;
            }
            for (int k = 0; k < STEPS; k++) {
                double d = distance(k);
                plane.toImage(fromX + side.normalX * d, fromY + side.normalY * d, point, 0);
                out[k] += scale.tabulatedLight(interpolate(image, levels, point[0], point[1]));
            }
        }
        for (int k = 0; k < STEPS; k++) {
            out[k] /= 2 * LINES + 1;
        }
    }

    /** One line of the profile where nothing bends it and no end of the image is near. */
    private void addInside(GreyImage image, GreyScale scale, double fromX, double fromY, double normalX,
            double normalY) {
        for (int k = 0; k < STEPS; k++) {
            double d = distance(k);
            light[k] += scale.tabulatedLight(image.interpolateInside(fromX + normalX * d, fromY + normalY * d));
        }
    }

    private static double interpolate(GreyImage image, @Nullable Unsharpened levels, double u, double v) {
        return levels != null ? levels.interpolate(u, v) : image.interpolate(u, v);
    }

    /**
     * White, ground and place of the edge, by least squares over the profile as far as the ground is plain. So many
     * rounds and no trials of steps: two of the three unknowns are linear, and a fit that strays is dropped.
     */
    private void fit(double dark, double firstWhite, double firstGround, double firstEdge, int last, double std) {
        double bright = firstWhite;
        double ground = firstGround;
        double edge = firstEdge;
        double[] n = normal;
        double[] g = gradient;
        for (int k = 0; k <= last; k++) {
            ofMarker[k] = EdgeProfile.tabulated(distance(k) / std);
        }
        for (int round = 0; round < ROUNDS; round++) {
            double g0 = 0;
            double g1 = 0;
            double g2 = 0;
            double n00 = 0;
            double n10 = 0;
            double n11 = 0;
            double n20 = 0;
            double n21 = 0;
            double n22 = 0;
            for (int k = 0; k <= last; k++) {
                double marker = ofMarker[k];
                double z = (distance(k) - edge) / std;
                double beyond = EdgeProfile.tabulated(z);
                double residual = dark + (bright - dark) * marker - (bright - ground) * beyond - light[k];
                double byBright = marker - beyond;
                double byEdge = (bright - ground) * EdgeProfile.density(z) / std;
                g0 += byBright * residual;
                g1 += beyond * residual;
                g2 += byEdge * residual;
                n00 += byBright * byBright;
                n10 += beyond * byBright;
                n11 += beyond * beyond;
                n20 += byEdge * byBright;
                n21 += byEdge * beyond;
                n22 += byEdge * byEdge;
            }
            g[0] = g0;
            g[1] = g1;
            g[2] = g2;
            n[0] = 1.001 * n00;
            n[3] = n10;
            n[4] = 1.001 * n11;
            n[6] = n20;
            n[7] = n21;
            n[8] = 1.001 * n22;
            if (!Cholesky.factor(n, 3)) {
                return;
            }
            Cholesky.solveLower(n, 3, g);
            Cholesky.solveUpper(n, 3, g);
            bright -= g[0];
            ground -= g[1];
            edge -= g[2];
        }
        if (bright > dark && ground < bright && Math.abs(edge - firstEdge) < 1.5) {
            px = edge;
            share = (bright - ground) / (bright - dark);
        }
    }
}
