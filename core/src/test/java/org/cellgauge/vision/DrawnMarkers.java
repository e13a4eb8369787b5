package org.cellgauge.vision;

import java.util.Arrays;
import org.apache.commons.math3.linear.Array2DRowRealMatrix;
import org.apache.commons.math3.linear.ArrayRealVector;
import org.apache.commons.math3.linear.LUDecomposition;
import org.apache.commons.math3.random.RandomGenerator;
import org.apache.commons.math3.random.Well19937c;
import org.cellgauge.cell.MarkerFamily;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.internal.geometry.MarkerGeometry;
import org.cellgauge.internal.vision.MarkerPattern;

/** A picture of markers drawn into given quadrilaterals, by averaging 8x8 points per pixel; for undistorted cameras. */
public final class DrawnMarkers {
    private static final int SUB = 8;
    private static final double QUIET = 0.2;

    private final int widthPx;
    private final int heightPx;
    private final double[] grey;

    public DrawnMarkers(int widthPx, int heightPx, double background) {
        this.widthPx = widthPx;
        this.heightPx = heightPx;
        this.grey = new double[widthPx * heightPx];
        Arrays.fill(grey, background);
    }

    /** Corners of a marker of a pose, undistorted camera. */
    public static double[] corners(PinholeCamera camera, RigidTransform cameraFromMarker, double sizeMm) {
        double[] points = MarkerGeometry.cornersMm(cameraFromMarker, sizeMm);
        double[] corners = new double[8];
        for (int i = 0; i < 4; i++) {
            double[] uv = camera.project(points[3 * i], points[3 * i + 1], points[3 * i + 2]);
            corners[2 * i] = uv[0];
            corners[2 * i + 1] = uv[1];
        }
        return corners;
    }

    public DrawnMarkers draw(MarkerFamily family, int id, double[] corners) {
        return draw(family, id, corners, 20, 220);
    }

    /** Draws a marker with its quiet zone; corners: top-left, top-right, bottom-right, bottom-left of the marker. */
    public DrawnMarkers draw(MarkerFamily family, int id, double[] corners, double black, double white) {
        return draw(MarkerPattern.of(family, id), corners, black, white);
    }

    public DrawnMarkers draw(MarkerPattern pattern, double[] corners, double black, double white) {
        return draw(pattern, corners, black, white, QUIET);
    }

    /** With a margin that is a share of the side. */
    DrawnMarkers draw(MarkerPattern pattern, double[] corners, double black, double white, double margin) {
        int n = pattern.cells();
        double[] h = imageToSquare(corners);
        int[] box = {widthPx, heightPx, 0, 0};
        double reach = 0;
        for (int i = 0; i < 8; i++) {
            reach = Math.max(reach, Math.abs(corners[i] - corners[(i + 4) % 8]));
        }
        for (int i = 0; i < 4; i++) {
            box[0] = (int) Math.max(0, Math.min(box[0], corners[2 * i] - reach));
            box[1] = (int) Math.max(0, Math.min(box[1], corners[2 * i + 1] - reach));
            box[2] = (int) Math.min(widthPx, Math.max(box[2], corners[2 * i] + reach));
            box[3] = (int) Math.min(heightPx, Math.max(box[3], corners[2 * i + 1] + reach));
        }
        for (int y = box[1]; y < box[3]; y++) {
            for (int x = box[0]; x < box[2]; x++) {
                double sum = 0;
                boolean touched = false;
                for (int k = 0; k < SUB * SUB; k++) {
                    double u = x + (k % SUB + 0.5) / SUB;
                    double v = y + (k / SUB + 0.5) / SUB;
                    double w = h[6] * u + h[7] * v + 1;
                    double s = (h[0] * u + h[1] * v + h[2]) / w;
                    double t = (h[3] * u + h[4] * v + h[5]) / w;
                    if (s < -margin || t < -margin || s > 1 + margin || t > 1 + margin) {
                        sum += grey[y * widthPx + x];
                        continue;
                    }
                    touched = true;
                    boolean inside = s >= 0 && t >= 0 && s < 1 && t < 1;
                    boolean isWhite = inside ? pattern.isWhite((int) (t * n), (int) (s * n)) : pattern.isWhiteAround();
                    sum += isWhite ? white : black;
                }
                if (touched) {
                    grey[y * widthPx + x] = sum / (SUB * SUB);
                }
            }
        }
        return this;
    }

    byte[] bytes(double noise, long seed) {
        RandomGenerator random = new Well19937c(seed);
        byte[] out = new byte[grey.length];
        for (int i = 0; i < out.length; i++) {
            double value = grey[i] + (noise > 0 ? noise * random.nextGaussian() : 0);
            out[i] = (byte) Math.max(0, Math.min(255, Math.round(value)));
        }
        return out;
    }

    public GreyImage image() {
        return GreyImage.packed(bytes(1, 1), widthPx, heightPx);
    }

    /** The homography from the image to the unit square (y down), as the solution of its eight linear equations. */
    private static double[] imageToSquare(double[] c) {
        double[][] target = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
        double[][] a = new double[8][];
        double[] b = new double[8];
        for (int i = 0; i < 4; i++) {
            double u = c[2 * i];
            double v = c[2 * i + 1];
            double s = target[i][0];
            double t = target[i][1];
            a[2 * i] = new double[] {u, v, 1, 0, 0, 0, -u * s, -v * s};
            a[2 * i + 1] = new double[] {0, 0, 0, u, v, 1, -u * t, -v * t};
            b[2 * i] = s;
            b[2 * i + 1] = t;
        }
        return new LUDecomposition(new Array2DRowRealMatrix(a)).getSolver().solve(new ArrayRealVector(b)).toArray();
    }
}
