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
    /** How far a drawn line may be from the bent one, px: what a straight one has in between is not kept. */
    private static final double STRAIGHT_PX = 0.05;

    private final PinholeCamera camera;
    private final double[] intrinsics;
    private final double[] rotation;
    private final double[] translationMm;
    private final double reachRad;
    private final ImageOrientation orientation;
    private final double width;
    private final double height;
    // work space: a grid has thousands of points
    private final double[] px = new double[2];
    private final PointRun run = new PointRun(PIECES + 1);
    private final PointRun part = new PointRun(PIECES + 1);

    WorldView(PinholeCamera camera, RigidTransform worldFromCamera, ImageOrientation orientation) {
        this.camera = camera;
        this.orientation = orientation;
        this.width = orientation.uprightWidthPx(camera.widthPx(), camera.heightPx());
        this.height = orientation.uprightHeightPx(camera.widthPx(), camera.heightPx());
        RigidTransform cameraFromWorld = worldFromCamera.inverse();
        this.rotation = cameraFromWorld.rotation();
        this.translationMm = cameraFromWorld.translationMm();
        this.intrinsics = camera.intrinsics();
        this.reachRad = camera.lens().reachRad(intrinsics);
    }

    /** The pixel position of a point of the world, perhaps outside the image; null where the camera cannot see it. */
    double @Nullable [] project(double[] worldMm) {
        return project(worldMm[0], worldMm[1], worldMm[2]) ? px.clone() : null;
    }

    /** The same into {@link #px}; false where the camera cannot see it. */
    private boolean project(double worldX, double worldY, double worldZ) {
        double x = rotation[0] * worldX + rotation[1] * worldY + rotation[2] * worldZ + translationMm[0];
        double y = rotation[3] * worldX + rotation[4] * worldY + rotation[5] * worldZ + translationMm[1];
        double z = rotation[6] * worldX + rotation[7] * worldY + rotation[8] * worldZ + translationMm[2];
        double across = Math.hypot(x, y);
        double near = camera.lens().isWide() ? Math.hypot(across, z) : z;
        if (!(near > NEAR_MM) || !(Math.atan2(across, z) < reachRad)
                || !camera.lens().project(intrinsics, x, y, z, px, 0)) {
            return false;
        }
        orientation.map(px, 0, camera.widthPx(), camera.heightPx());
        return true;
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
        List<double[]> visible = new ArrayList<>(1);
        run.clear();
        for (int c = 0; c + 1 < cornersMm.length; c++) {
            double[] from = cornersMm[c];
            double[] to = cornersMm[c + 1];
            for (int i = c == 0 ? 0 : 1; i <= pieces; i++) {
                double t = (double) i / pieces;
                if (project((1 - t) * from[0] + t * to[0], (1 - t) * from[1] + t * to[1],
                        (1 - t) * from[2] + t * to[2])) {
                    run.add(px[0], px[1]);
                } else {
                    finish(visible);
                }
            }
        }
        finish(visible);
        return visible;
    }

    private void finish(List<double[]> visible) {
        run.straighten(STRAIGHT_PX);
        clip(run, part, width, height, visible);
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
        PointRun line = new PointRun(points.length / 2);
        for (int i = 0; i + 1 < points.length; i += 2) {
            line.add(points[i], points[i + 1]);
        }
        List<double[]> parts = new ArrayList<>(1);
        clip(line, new PointRun(points.length / 2 + 1), width, height, parts);
        return parts;
    }

    /** Adds the parts of a polyline within an image to a list, by means of a run of points for each part. */
    private static void clip(PointRun points, PointRun part, double width, double height, List<double[]> parts) {
        for (int i = 0; i + 3 < points.size(); i += 2) {
            double u = points.get(i);
            double v = points.get(i + 1);
            double du = points.get(i + 2) - u;
            double dv = points.get(i + 3) - v;
            double from = Math.max(Math.max(0, entry(-du, u)), Math.max(entry(du, width - u),
                    Math.max(entry(-dv, v), entry(dv, height - v))));
            double to = Math.min(Math.min(1, exit(-du, u)), Math.min(exit(du, width - u),
                    Math.min(exit(-dv, v), exit(dv, height - v))));
            if (!(from <= to)) {
                part.flush(parts);
                continue;
            }
            if (from > 0) {
                part.flush(parts);
            }
            if (part.isEmpty()) {
                add(part, u + from * du, v + from * dv, width, height);
            }
            add(part, u + to * du, v + to * dv, width, height);
            if (to < 1) {
                part.flush(parts);
            }
        }
        part.flush(parts);
    }

    /** Where along a piece it comes in over an edge, as a share of it, that it steps towards by less than its room. */
    private static double entry(double step, double room) {
        return step < 0 ? room / step : 0;
    }

    /** Where along a piece it goes out over an edge; before its beginning where it runs outside, beside the edge. */
    private static double exit(double step, double room) {
        return step > 0 ? room / step : step == 0 && room < 0 ? -1 : 1;
    }

    /** Adds a point, rounding that carried it beyond the edge taken off. */
    private static void add(PointRun part, double u, double v, double width, double height) {
        part.add(Math.min(Math.max(u, 0), width), Math.min(Math.max(v, 0), height));
    }
}
