package org.cellgauge.vision;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.function.BiPredicate;
import org.cellgauge.cell.CalibrationTarget.Grid;
import org.cellgauge.cell.CalibrationTarget.Pattern;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.geometry.RigidTransform;
import org.junit.jupiter.api.Test;

/** Boards drawn here, by many rays a pixel: where their points are seen is known. */
class TargetDetectorTest {
    private static final int WIDTH = 400;
    private static final int HEIGHT = 300;
    private static final int RAYS = 4;
    private static final PinholeCamera CAMERA = PinholeCamera.ideal(WIDTH, HEIGHT, 420, 420, WIDTH / 2.0, HEIGHT / 2.0);
    /** A board's y goes up. */
    private static final RigidTransform CAMERA_FROM_BOARD =
            RigidTransform.ofEuler(6, -4, 420, Math.PI - 0.35, 0.3, 0.1);

    /** The photo of a plane whose dark places are known, in mm of the board's frame. */
    private static GreyImage photo(BiPredicate<Double, Double> dark) {
        RigidTransform boardFromCamera = CAMERA_FROM_BOARD.inverse();
        double[] eye = boardFromCamera.translationMm();
        double[] ray = new double[3];
        byte[] grey = new byte[WIDTH * HEIGHT];
        for (int k = 0; k < grey.length; k++) {
            int white = 0;
            for (int s = 0; s < RAYS * RAYS; s++) {
                CAMERA.toRay(k % WIDTH + (s % RAYS + 0.5) / RAYS, k / WIDTH + (s / RAYS + 0.5) / RAYS, ray);
                double[] on = boardFromCamera.apply(ray);
                double along = -eye[2] / (on[2] - eye[2]);
                white += dark.test(eye[0] + along * (on[0] - eye[0]), eye[1] + along * (on[1] - eye[1])) ? 0 : 1;
            }
            grey[k] = (byte) (40 + 180 * white / (RAYS * RAYS));
        }
        return GreyImage.packed(grey, WIDTH, HEIGHT);
    }

    /** Every point within so much of where it is, on average within a third of that: half a pixel would be seen. */
    private static void assertSeen(Grid grid, int points, GreyImage photo, double withinPx) {
        TargetDetector detector = TargetDetector.of(grid, CAMERA);
        TargetObservation seen = detector.find(photo, "photo");
        assertEquals(points, seen.count());
        // a board may look the same after half a turn, and a plane from behind is its own mirror image
        double[] errors = {Double.POSITIVE_INFINITY};
        for (int k = 0; k < 4; k++) {
            double[] turned = errors(detector.points(), seen, 1 - k % 2 * 2, 1 - k / 2 * 2);
            errors = turned[0] < errors[0] ? turned : errors;
        }
        assertEquals(0, errors[0], withinPx, "largest error");
        assertEquals(0, errors[1], withinPx / 3, "mean error in x");
        assertEquals(0, errors[2], withinPx / 3, "mean error in y");
    }

    private static double[] errors(TargetPoints points, TargetObservation seen, int signX, int signY) {
        double[] xyz = points.xyzMm();
        double[] uv = new double[2];
        double[] errors = new double[3];
        for (int i = 0; i < seen.count(); i++) {
            int index = seen.points()[i];
            double[] p = CAMERA_FROM_BOARD.apply(signX * xyz[3 * index], signY * xyz[3 * index + 1], 0);
            assertTrue(CAMERA.lens().project(CAMERA.intrinsics(), p[0], p[1], p[2], uv, 0));
            double du = seen.uvPx()[2 * i] - uv[0];
            double dv = seen.uvPx()[2 * i + 1] - uv[1];
            errors[0] = Math.max(errors[0], Math.hypot(du, dv));
            errors[1] += du / seen.count();
            errors[2] += dv / seen.count();
        }
        return errors;
    }

    @Test
    void chessboardCornersAreWhereTheyAre() {
        Grid grid = new Grid(Pattern.CHESSBOARD, 7, 6, 30, 30);
        GreyImage photo = photo((x, y) -> Math.abs(x) < 90 && Math.abs(y) < 105
                && (Math.floorMod((int) Math.floor(x / 30), 2) == Math.floorMod((int) Math.floor((y + 105) / 30), 2)));
        assertSeen(grid, 30, photo, 0.1);
    }

    @Test
    void circlesAreWhereTheyAre() {
        Grid grid = new Grid(Pattern.CIRCLE_GRID, 5, 6, 20, 36);
        double[] layout = TargetDetector.of(grid, CAMERA).points().xyzMm();
        GreyImage photo = photo((x, y) -> {
            double column = Math.rint((x + 90) / 36);
            double row = Math.rint((y + 72) / 36);
            return column >= 0 && column < 6 && row >= 0 && row < 5
                    && Math.hypot(x - (column * 36 - 90), y - (row * 36 - 72)) < 10;
        });
        assertSeen(grid, layout.length / 3, photo, 0.3);
    }

    @Test
    void shiftedCirclesAreWhereTheyAre() {
        Grid grid = new Grid(Pattern.HEXAGONAL_CIRCLE_GRID, 7, 6, 18, 42);
        double[] layout = TargetDetector.of(grid, CAMERA).points().xyzMm();
        GreyImage photo = photo((x, y) -> {
            for (int i = 0; i < layout.length; i += 3) {
                if (Math.abs(y - layout[i + 1]) < 9 && Math.hypot(x - layout[i], y - layout[i + 1]) < 9) {
                    return true;
                }
            }
            return false;
        });
        assertSeen(grid, layout.length / 3, photo, 0.3);
    }
}
