package org.cellgauge.internal.overlay;

import java.util.ArrayList;
import java.util.List;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.geometry.RigidTransform;
import org.jspecify.annotations.Nullable;

/**
 * The world as a camera sees it: points and lines of the world in px of the upright image, without what is behind the
 * camera, beyond the reach of its lens model or outside the image.
 */
final class WorldView {
    /** Points nearer to the camera's plane than this count as not in front of it; nearer to a fisheye, as too near. */
    static final double NEAR_MM = 1;
    /** Pieces a line is cut into, so that the lens bends it: 1/64 of the image bends by far less than a pixel. */
    private static final int PIECES = 64;

    private final PinholeCamera camera;
    private final RigidTransform cameraFromWorld;
    private final double reachRad;
    private final ImageOrientation orientation;
    private final double width;
    private final double height;

    WorldView(PinholeCamera camera, RigidTransform worldFromCamera, ImageOrientation orientation) {
        this.camera = camera;
        this.orientation = orientation;
        this.width = orientation.uprightWidthPx(camera.widthPx(), camera.heightPx());
        this.height = orientation.uprightHeightPx(camera.widthPx(), camera.heightPx());
        this.cameraFromWorld = worldFromCamera.inverse();
        this.reachRad = camera.lens().reachRad(camera.intrinsics());
    }

    /** The pixel position of a point of the world, perhaps outside the image; null where the camera cannot see it. */
    double @Nullable [] project(double[] worldMm) {
        double[] p = cameraFromWorld.apply(worldMm);
        double across = Math.hypot(p[0], p[1]);
        double near = camera.lens().isWide() ? Math.hypot(across, p[2]) : p[2];
        if (!(near > NEAR_MM) || !(Math.atan2(across, p[2]) < reachRad)) {
            return null;
        }
        double[] uv = camera.project(p[0], p[1], p[2]);
        return uv == null ? null : orientation.map(uv[0], uv[1], camera.widthPx(), camera.heightPx());
    }

    /** Whether a pixel position lies in the image. */
    boolean inImage(double @Nullable [] px) {
        return px != null && px[0] >= 0 && px[0] <= width && px[1] >= 0 && px[1] <= height;
    }

    /** The visible parts of a straight line of the world. */
    List<double[]> line(double[] fromMm, double[] toMm) {
        return path(PIECES, fromMm, toMm);
    }

    /** The visible parts of straight lines of the world through corners, each cut into pieces. */
    List<double[]> path(int pieces, double[]... cornersMm) {
        List<double[]> visible = new ArrayList<>();
        List<Double> run = new ArrayList<>();
        for (int c = 0; c + 1 < cornersMm.length; c++) {
            for (int i = c == 0 ? 0 : 1; i <= pieces; i++) {
                double t = (double) i / pieces;
                double[] p = new double[3];
                for (int k = 0; k < 3; k++) {
                    p[k] = (1 - t) * cornersMm[c][k] + t * cornersMm[c + 1][k];
                }
                double[] px = project(p);
                if (px == null) {
                    finish(run, visible);
                } else {
                    run.add(px[0]);
                    run.add(px[1]);
                }
            }
        }
        finish(run, visible);
        return visible;
    }

    private void finish(List<Double> run, List<double[]> visible) {
        if (run.size() >= 4) {
            visible.addAll(clip(run.stream().mapToDouble(Double::doubleValue).toArray(), width, height));
        }
        run.clear();
    }

    /**
     * The parts of a polyline within an image (Liang and Barsky, "A new concept and method for line clipping", 1984).
     *
     * @param points u0, v0, u1, v1, …
     * @param width of the image
     * @param height of the image
     * @return polylines within [0, width] x [0, height]
     */
    static List<double[]> clip(double[] points, double width, double height) {
        List<double[]> parts = new ArrayList<>();
        List<Double> part = new ArrayList<>();
        for (int i = 0; i + 3 < points.length; i += 2) {
            double u = points[i];
            double v = points[i + 1];
            double du = points[i + 2] - u;
            double dv = points[i + 3] - v;
            double from = 0;
            double to = 1;
            double[] steps = {-du, du, -dv, dv};
            double[] rooms = {u, width - u, v, height - v};
            for (int k = 0; k < 4; k++) {
                if (steps[k] < 0) {
                    from = Math.max(from, rooms[k] / steps[k]);
                } else if (steps[k] > 0) {
                    to = Math.min(to, rooms[k] / steps[k]);
                } else if (rooms[k] < 0) {
                    to = -1;
                }
            }
            if (!(from <= to)) {
                flush(part, parts);
                continue;
            }
            if (from > 0) {
                flush(part, parts);
            }
            if (part.isEmpty()) {
                add(part, u + from * du, v + from * dv, width, height);
            }
            add(part, u + to * du, v + to * dv, width, height);
            if (to < 1) {
                flush(part, parts);
            }
        }
        flush(part, parts);
        return parts;
    }

    /** Adds a point, rounding that carried it beyond the edge taken off. */
    private static void add(List<Double> part, double u, double v, double width, double height) {
        part.add(Math.min(Math.max(u, 0), width));
        part.add(Math.min(Math.max(v, 0), height));
    }

    private static void flush(List<Double> part, List<double[]> parts) {
        if (part.size() >= 4) {
            parts.add(part.stream().mapToDouble(Double::doubleValue).toArray());
        }
        part.clear();
    }
}
