package org.cellgauge.desktop.render;

import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.internal.vision.MarkerPattern;

/**
 * A marker with its paper as one camera sees it: the map from a ray to a place on the paper, and the colours there.
 *
 * <p>With the marker's axes r0, r1 and its centre t in the camera frame, a ray (x, y, z) meets the marker's plane at
 * (X, Y) where {@code [r0 r1 t] (X, Y, 1)^T = distance (x, y, z)^T}, the distance in lengths of the ray; the inverse of
 * that matrix is a homography (Hartley and Zisserman, "Multiple View Geometry", 2nd edition, section 8.1.1) whose third
 * row gives 1/distance.
 */
final class PlanarMarker {
    /** No paper here: the ray goes on to what lies behind. */
    static final double NOTHING = -1;
    static final double WHITE = 0.85;
    static final double BLACK = 0.05;
    /** Of the light on a surface this share does not depend on its tilt. */
    private static final double AMBIENT = 0.6;
    private static final double[] LIGHT = {0.24, 0.16, 0.957};
    private static final int OUTLINE_POINTS_PER_EDGE = 24;

    private final double[] fromRay = new double[9];
    private final double halfMm;
    private final double paperMm;
    private final double cellMm;
    private final int cells;
    /**
     * Colours over the bands nothing, paper, cells…, paper, nothing in both directions; rows from the top. With a print
     * gain a band about each border between cells stands between the bands of these.
     */
    private final double[] colour;
    /** How far the band about a border reaches to each side, mm. */
    private final double strayMm;
    private final int bands;
    /** Bounding box of the paper in the image, px; the whole plane where it cannot be bounded. */
    private final double[] boundsPx = new double[4];

    /**
     * Prepares a marker for a camera.
     *
     * @param marker the marker
     * @param quietZone width of the paper around it as a share of its size
     * @param printGainMm by how much its dark regions grow on all sides, mm
     * @param cameraFromWorld inverse pose of the camera
     * @param camera intrinsics
     * @return null if the marker's plane is seen edge-on
     */
    static PlanarMarker of(SceneMarker marker, double quietZone, double printGainMm, RigidTransform cameraFromWorld,
            PinholeCamera camera) {
        RigidTransform cameraFromMarker = cameraFromWorld.compose(marker.worldFromMarker());
        double[] r = cameraFromMarker.rotation();
        double[] t = cameraFromMarker.translationMm();
        double facing = -(r[2] * t[0] + r[5] * t[1] + r[8] * t[2]);
        double distance = Math.sqrt(t[0] * t[0] + t[1] * t[1] + t[2] * t[2]);
        return Math.abs(facing) <= 1e-9 * distance ? null
                : new PlanarMarker(marker, quietZone, printGainMm, cameraFromMarker, facing > 0, camera);
    }

    private PlanarMarker(SceneMarker marker, double quietZone, double printGainMm, RigidTransform cameraFromMarker,
            boolean front, PinholeCamera camera) {
        halfMm = marker.sizeMm() / 2;
        paperMm = halfMm + quietZone * marker.sizeMm();
        cells = marker.pattern().cells();
        cellMm = marker.sizeMm() / cells;
        strayMm = Math.abs(printGainMm);
        bands = strayMm == 0 ? cells + 4 : 2 * cells + 5;
        colour = colours(marker, front, printGainMm > 0);
        invert(cameraFromMarker);
        bound(cameraFromMarker, camera);
    }

    private double[] colours(SceneMarker marker, boolean front, boolean darkGrows) {
        double[] r = marker.worldFromMarker().rotation();
        double sign = front ? 1 : -1;
        double cosine = sign * (r[2] * LIGHT[0] + r[5] * LIGHT[1] + r[8] * LIGHT[2]);
        // the wall's own share is 1, so that paper flat on it is as bright as the wall's light makes it
        double light = AMBIENT + (1 - AMBIENT) * Math.min(Math.max(0, cosine / LIGHT[2]), 1);
        double[] out = new double[bands * bands];
        for (int row = 0; row < bands; row++) {
            for (int column = 0; column < bands; column++) {
                double value;
                if (row == 0 || column == 0 || row == bands - 1 || column == bands - 1) {
                    value = NOTHING;
                } else if (!front) {
                    value = WHITE * light;
                } else {
                    value = light * (isDark(marker.pattern(), row, column, darkGrows)
                            ? marker.inkReflectance() : WHITE);
                }
                out[row * bands + column] = value;
            }
        }
        return out;
    }

    /** Whether the place where two bands cross is printed: about a border, as the cells on both sides let it be. */
    private boolean isDark(MarkerPattern pattern, int row, int column, boolean darkGrows) {
        boolean any = false;
        boolean all = true;
        for (int r = cellBefore(row); r <= cellAfter(row); r++) {
            for (int c = cellBefore(column); c <= cellAfter(column); c++) {
                boolean within = r >= 0 && c >= 0 && r < cells && c < cells;
                boolean dark = within ? !pattern.isWhite(r, c) : !pattern.isWhiteAround();
                any |= dark;
                all &= dark;
            }
        }
        return darkGrows ? any : all;
    }

    private int cellBefore(int band) {
        return strayMm == 0 ? band - 2 : Math.floorDiv(band - 1, 2) - 1;
    }

    private int cellAfter(int band) {
        return strayMm == 0 ? band - 2 : Math.floorDiv(band, 2) - 1;
    }

    private void invert(RigidTransform cameraFromMarker) {
        double[] r = cameraFromMarker.rotation();
        double[] t = cameraFromMarker.translationMm();
        double[] m = {r[0], r[1], t[0], r[3], r[4], t[1], r[6], r[7], t[2]};
        double[] adjoint = {m[4] * m[8] - m[5] * m[7], m[2] * m[7] - m[1] * m[8], m[1] * m[5] - m[2] * m[4],
            m[5] * m[6] - m[3] * m[8], m[0] * m[8] - m[2] * m[6], m[2] * m[3] - m[0] * m[5],
            m[3] * m[7] - m[4] * m[6], m[1] * m[6] - m[0] * m[7], m[0] * m[4] - m[1] * m[3]};
        double determinant = m[0] * adjoint[0] + m[1] * adjoint[3] + m[2] * adjoint[6];
        for (int i = 0; i < 9; i++) {
            fromRay[i] = adjoint[i] / determinant;
        }
    }

    private void bound(RigidTransform cameraFromMarker, PinholeCamera camera) {
        boundsPx[0] = Double.POSITIVE_INFINITY;
        boundsPx[1] = Double.POSITIVE_INFINITY;
        boundsPx[2] = Double.NEGATIVE_INFINITY;
        boundsPx[3] = Double.NEGATIVE_INFINITY;
        for (int i = 0; i < 4 * OUTLINE_POINTS_PER_EDGE; i++) {
            double along = paperMm * (2.0 * (i % OUTLINE_POINTS_PER_EDGE) / OUTLINE_POINTS_PER_EDGE - 1);
            double x = switch (i / OUTLINE_POINTS_PER_EDGE) {
                case 0 -> along;
                case 1 -> paperMm;
                case 2 -> -along;
                default -> -paperMm;
            };
            double y = switch (i / OUTLINE_POINTS_PER_EDGE) {
                case 0 -> -paperMm;
                case 1 -> along;
                case 2 -> paperMm;
                default -> -along;
            };
            double[] p = cameraFromMarker.apply(x, y, 0);
            double[] uv = camera.image(p[0], p[1], p[2]);
            // a point that the camera cannot see bounds nothing
            if (uv == null) {
                boundsPx[0] = Double.NEGATIVE_INFINITY;
                boundsPx[1] = Double.NEGATIVE_INFINITY;
                boundsPx[2] = Double.POSITIVE_INFINITY;
                boundsPx[3] = Double.POSITIVE_INFINITY;
                return;
            }
            boundsPx[0] = Math.min(boundsPx[0], uv[0]);
            boundsPx[1] = Math.min(boundsPx[1], uv[1]);
            boundsPx[2] = Math.max(boundsPx[2], uv[0]);
            boundsPx[3] = Math.max(boundsPx[3], uv[1]);
        }
        // between two outline points a distorted edge bulges a little beyond them
        double slack = 2 + 0.02 * Math.max(boundsPx[2] - boundsPx[0], boundsPx[3] - boundsPx[1]);
        boundsPx[0] -= slack;
        boundsPx[1] -= slack;
        boundsPx[2] += slack;
        boundsPx[3] += slack;
    }

    /** Whether the paper may reach into the rectangle of pixel positions. */
    boolean mayTouch(double u0, double v0, double u1, double v1) {
        return boundsPx[0] <= u1 && boundsPx[2] >= u0 && boundsPx[1] <= v1 && boundsPx[3] >= v0;
    }

    /**
     * The pixels that hold the paper and some pixels around it.
     *
     * @param reachPx how many pixels around it
     * @param widthPx image width
     * @param heightPx image height
     * @return first column, first row, columns, rows; null if the image holds none of them
     */
    int[] boundsWithin(int reachPx, int widthPx, int heightPx) {
        int left = (int) Math.max(0, Math.floor(boundsPx[0] - reachPx));
        int top = (int) Math.max(0, Math.floor(boundsPx[1] - reachPx));
        int right = (int) Math.min(widthPx, Math.ceil(boundsPx[2] + reachPx));
        int bottom = (int) Math.min(heightPx, Math.ceil(boundsPx[3] + reachPx));
        return left < right && top < bottom ? new int[] {left, top, right - left, bottom - top} : null;
    }

    /** 1/distance where the ray meets the marker's plane; not positive: on its way backwards. */
    double inverseDistance(double x, double y, double z) {
        return fromRay[6] * x + fromRay[7] * y + fromRay[8] * z;
    }

    /** Reflectance where the ray meets the paper, or {@link #NOTHING}. */
    double colourAt(double x, double y, double z) {
        double w = inverseDistance(x, y, z);
        if (!(w > 0)) {
            return NOTHING;
        }
        double placeX = (fromRay[0] * x + fromRay[1] * y + fromRay[2] * z) / w;
        double placeY = (fromRay[3] * x + fromRay[4] * y + fromRay[5] * z) / w;
        return colour[band(-placeY) * bands + band(placeX)];
    }

    /**
     * The one colour of all places that rays near one meet.
     *
     * @param ray the middle ray
     * @param reach largest deviations of its three coordinates
     * @param times by how much the deviations are to be multiplied
     * @return the reflectance, {@link #NOTHING}, or NaN if there may be more than one
     */
    double uniformColour(double[] ray, double[] reach, double times) {
        double x = ray[0];
        double y = ray[1];
        double z = ray[2];
        double reachX = times * reach[0];
        double reachY = times * reach[1];
        double reachZ = times * reach[2];
        double w = inverseDistance(x, y, z);
        double wReach = Math.abs(fromRay[6]) * reachX + Math.abs(fromRay[7]) * reachY
                + Math.abs(fromRay[8]) * reachZ;
        if (w < -wReach) {
            return NOTHING;
        }
        double wLeast = w - wReach;
        if (!(wLeast > 0)) {
            return Double.NaN;
        }
        double placeX = (fromRay[0] * x + fromRay[1] * y + fromRay[2] * z) / w;
        double placeY = (fromRay[3] * x + fromRay[4] * y + fromRay[5] * z) / w;
        // |dX| <= (|a - X g| dx + |b - X h| dy + |c - X i| dz) / w, exact for a homography if w is the least in reach
        double spanX = (Math.abs(fromRay[0] - placeX * fromRay[6]) * reachX
                + Math.abs(fromRay[1] - placeX * fromRay[7]) * reachY
                + Math.abs(fromRay[2] - placeX * fromRay[8]) * reachZ) / wLeast;
        double spanY = (Math.abs(fromRay[3] - placeY * fromRay[6]) * reachX
                + Math.abs(fromRay[4] - placeY * fromRay[7]) * reachY
                + Math.abs(fromRay[5] - placeY * fromRay[8]) * reachZ) / wLeast;
        int left = band(placeX - spanX);
        int right = band(placeX + spanX);
        int top = band(-placeY - spanY);
        int bottom = band(-placeY + spanY);
        double first = colour[top * bands + left];
        for (int row = top; row <= bottom; row++) {
            for (int column = left; column <= right; column++) {
                if (colour[row * bands + column] != first) {
                    return Double.NaN;
                }
            }
        }
        return first;
    }

    /**
     * The one straight border between two colours among all places that rays near one meet: as a function of the ray
     * that is linear, negative on the side of the first colour and not on that of the second.
     *
     * @param ray the middle ray
     * @param reach largest deviations of its three coordinates
     * @param border receives the function's three coefficients and the two colours
     * @return false where there are other borders, too, or none
     */
    boolean singleBorder(double[] ray, double[] reach, double[] border) {
        double w = inverseDistance(ray[0], ray[1], ray[2]);
        double wLeast = w - Math.abs(fromRay[6]) * reach[0] - Math.abs(fromRay[7]) * reach[1]
                - Math.abs(fromRay[8]) * reach[2];
        if (!(wLeast > 0)) {
            return false;
        }
        double placeX = (fromRay[0] * ray[0] + fromRay[1] * ray[1] + fromRay[2] * ray[2]) / w;
        double placeY = (fromRay[3] * ray[0] + fromRay[4] * ray[1] + fromRay[5] * ray[2]) / w;
        double spanX = span(0, placeX, reach) / wLeast;
        double spanY = span(3, placeY, reach) / wLeast;
        int left = band(placeX - spanX);
        int right = band(placeX + spanX);
        int top = band(-placeY - spanY);
        int bottom = band(-placeY + spanY);
        boolean acrossX = right == left + 1 && isAlike(top, bottom, left, right, bands, 1);
        if (!acrossX && !(bottom == top + 1 && isAlike(left, right, top, bottom, 1, bands))) {
            return false;
        }
        double at = acrossX ? borderAfter(left) : borderAfter(top);
        for (int k = 0; k < 3; k++) {
            border[k] = (acrossX ? fromRay[k] : -fromRay[3 + k]) - at * fromRay[6 + k];
        }
        border[3] = colour[top * bands + left];
        border[4] = colour[bottom * bands + right];
        return true;
    }

    private double span(int row, double place, double[] reach) {
        double sum = 0;
        for (int k = 0; k < 3; k++) {
            sum += Math.abs(fromRay[row + k] - place * fromRay[6 + k]) * reach[k];
        }
        return sum;
    }

    /** Whether the colours of two bands next to each other, of numbers apart, stay what they are along both. */
    private boolean isAlike(int from, int to, int first, int second, int stepAlong, int stepAcross) {
        for (int k = from + 1; k <= to; k++) {
            if (colour[k * stepAlong + first * stepAcross] != colour[from * stepAlong + first * stepAcross]
                    || colour[k * stepAlong + second * stepAcross] != colour[from * stepAlong + second * stepAcross]) {
                return false;
            }
        }
        return true;
    }

    /** Where a band ends and the next begins, mm: see {@link #band}. */
    private double borderAfter(int band) {
        if (band == 0 || band == bands - 2) {
            return band == 0 ? -paperMm : paperMm;
        }
        return strayMm == 0 ? (band - 1) * cellMm - halfMm
                : (band - 1) / 2 * cellMm - halfMm + (band % 2 == 0 ? strayMm : -strayMm);
    }

    private int band(double placeMm) {
        if (strayMm > 0) {
            return bandWithStrays(placeMm);
        }
        if (placeMm < -halfMm) {
            return placeMm < -paperMm ? 0 : 1;
        }
        if (placeMm >= halfMm) {
            return placeMm >= paperMm ? bands - 1 : bands - 2;
        }
        return 2 + Math.min(cells - 1, (int) ((placeMm + halfMm) / cellMm));
    }

    private int bandWithStrays(double placeMm) {
        if (placeMm < -paperMm || placeMm >= paperMm) {
            return placeMm < 0 ? 0 : bands - 1;
        }
        double along = placeMm + halfMm;
        int border = (int) Math.min(cells, Math.max(0, Math.rint(along / cellMm)));
        double off = along - border * cellMm;
        // the band about border k is number 2k + 2
        return 2 * border + (off < -strayMm ? 1 : off < strayMm ? 2 : 3);
    }
}
