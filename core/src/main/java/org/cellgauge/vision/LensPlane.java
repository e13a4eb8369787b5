package org.cellgauge.vision;

import boofcv.alg.distort.LensDistortionNarrowFOV;
import boofcv.struct.distort.Point2Transform2_F32;
import boofcv.struct.distort.Point2Transform2_F64;
import georegression.struct.point.Point2D_F32;
import georegression.struct.point.Point2D_F64;
import org.cellgauge.geometry.PinholeCamera;

/**
 * A lens that BoofCV has not, as its square detector takes one: a plane without distortion for the whole image.
 *
 * <p>Of a lens that is not wide that plane is z = 1. No plane has that for a fisheye: up to {@value #STRAIGHT_DEGREES}
 * degrees off the axis, directions meet the plane z = 1, where lines are straight, so that markers of any size have
 * straight sides: on the bent image itself, a marker of 24 degrees is lost from 30 degrees off the axis on. Beyond,
 * where that plane would go on to infinity at 90 degrees, the distance from the middle grows with the angle at the rate
 * it has there. That far out the detector looks at the bent image as well, where small markers, whose sides hardly
 * bend, are found up to 90 degrees and beyond. Corners are of no account here: {@link MarkerEdges} finds them anew.
 * Immutable.
 */
final class LensPlane implements LensDistortionNarrowFOV {
    static final int STRAIGHT_DEGREES = 70;
    private static final double STRAIGHT_RAD = Math.toRadians(STRAIGHT_DEGREES);
    private static final double STRAIGHT_RADIUS = Math.tan(STRAIGHT_RAD);
    private static final double RATE = 1 + STRAIGHT_RADIUS * STRAIGHT_RADIUS;

    private final PinholeCamera camera;
    private final double fx;
    private final double fy;
    private final double cx;
    private final double cy;
    private final double largestRadius;

    LensPlane(PinholeCamera camera) {
        this.camera = camera;
        fx = camera.get(PinholeCamera.FX);
        fy = camera.get(PinholeCamera.FY);
        cx = camera.get(PinholeCamera.CX);
        cy = camera.get(PinholeCamera.CY);
        largestRadius = radius(camera.lens().reachRad(camera.intrinsics()));
    }

    private static double radius(double angle) {
        return angle <= STRAIGHT_RAD ? Math.tan(angle) : STRAIGHT_RADIUS + (angle - STRAIGHT_RAD) * RATE;
    }

    private static double angle(double radius) {
        return radius <= STRAIGHT_RADIUS ? Math.atan(radius) : STRAIGHT_RAD + (radius - STRAIGHT_RADIUS) / RATE;
    }

    /** The place on the plane of a pixel position; what shows nothing comes to lie at the plane's border. */
    private void toPlane(double u, double v, double[] ray, double[] out) {
        double x = (u - cx) / fx;
        double y = (v - cy) / fy;
        double radius = largestRadius;
        if (camera.toRay(u, v, ray)) {
            x = ray[0];
            y = ray[1];
            radius = radius(Math.atan2(Math.hypot(x, y), ray[2]));
        }
        double across = Math.hypot(x, y);
        out[0] = across > 0 ? radius * x / across : 0;
        out[1] = across > 0 ? radius * y / across : 0;
    }

    /** The pixel position of a place on the plane; of one beyond the border, that of the border. */
    private void toImage(double x, double y, double[] uv) {
        double radius = Math.hypot(x, y);
        double angle = angle(Math.min(radius, largestRadius));
        double across = radius > 0 ? Math.sin(angle) / radius : 0;
        if (!camera.lens().project(camera.intrinsics(), across * x, across * y, Math.cos(angle), uv, 0)) {
            uv[0] = cx;
            uv[1] = cy;
        }
    }

    /** One of the maps, with work space of its own. */
    private final class Map implements Point2Transform2_F32, Point2Transform2_F64 {
        private final boolean distorting;
        private final boolean pixelIn;
        private final boolean pixelOut;
        private final double[] ray = new double[3];
        private final double[] out = new double[2];

        Map(boolean distorting, boolean pixelIn, boolean pixelOut) {
            this.distorting = distorting;
            this.pixelIn = pixelIn;
            this.pixelOut = pixelOut;
        }

        private void map(double a, double b) {
            if (distorting) {
                toImage(pixelIn ? (a - cx) / fx : a, pixelIn ? (b - cy) / fy : b, out);
                if (!pixelOut) {
                    out[0] = (out[0] - cx) / fx;
                    out[1] = (out[1] - cy) / fy;
                }
            } else {
                toPlane(pixelIn ? a : fx * a + cx, pixelIn ? b : fy * b + cy, ray, out);
                if (pixelOut) {
                    out[0] = fx * out[0] + cx;
                    out[1] = fy * out[1] + cy;
                }
            }
        }

        @Override
        public void compute(float x, float y, Point2D_F32 result) {
            map(x, y);
            result.setTo((float) out[0], (float) out[1]);
        }

        @Override
        public void compute(double x, double y, Point2D_F64 result) {
            map(x, y);
            result.setTo(out[0], out[1]);
        }

        @Override
        public Map copyConcurrent() {
            return new Map(distorting, pixelIn, pixelOut);
        }
    }

    @Override
    public Point2Transform2_F32 distort_F32(boolean pixelIn, boolean pixelOut) {
        return new Map(true, pixelIn, pixelOut);
    }

    @Override
    public Point2Transform2_F64 distort_F64(boolean pixelIn, boolean pixelOut) {
        return new Map(true, pixelIn, pixelOut);
    }

    @Override
    public Point2Transform2_F32 undistort_F32(boolean pixelIn, boolean pixelOut) {
        return new Map(false, pixelIn, pixelOut);
    }

    @Override
    public Point2Transform2_F64 undistort_F64(boolean pixelIn, boolean pixelOut) {
        return new Map(false, pixelIn, pixelOut);
    }

    @Override
    public Point2Transform2_F32 normalized_F32() {
        return undistort_F32(true, false);
    }

    @Override
    public Point2Transform2_F64 normalized_F64() {
        return undistort_F64(true, false);
    }
}
