package org.cellgauge.cell;

import java.util.ArrayList;
import java.util.List;
import org.cellgauge.geometry.RigidTransform;

/**
 * How far a camera that is held by hand or by a robot may be from where it is said to stand; immutable.
 *
 * @param xMm along world x, either way, mm, not negative
 * @param yMm along world y
 * @param zMm along world z
 * @param turnDeg about each of its own axes, either way, degrees, not negative
 */
public record CameraRange(double xMm, double yMm, double zMm, double turnDeg) {
    /** It stands where it is said to. */
    public static final CameraRange NONE = new CameraRange(0, 0, 0, 0);

    /**
     * A range.
     *
     * @throws IllegalArgumentException if a bound is negative
     */
    public CameraRange {
        if (!(xMm >= 0 && yMm >= 0 && zMm >= 0 && turnDeg >= 0)) {
            throw new IllegalArgumentException("a range must not be negative");
        }
    }

    /**
     * Poses that stand for the range: the middle, the corners of the box of positions, the ends of each axis and of
     * each turn.
     *
     * @param worldFromCamera the middle
     * @return at least one, at most 21, the middle first
     */
    public List<RigidTransform> poses(RigidTransform worldFromCamera) {
        List<RigidTransform> poses = new ArrayList<>();
        poses.add(worldFromCamera);
        double[] mm = {xMm, yMm, zMm};
        for (int i = 0; i < 27; i++) {
            double[] shift = {(i % 3 - 1) * mm[0], (i / 3 % 3 - 1) * mm[1], (i / 9 - 1) * mm[2]};
            int ways = 0;
            boolean open = true;
            for (int axis = 0; axis < 3; axis++) {
                int way = axis == 0 ? i % 3 - 1 : axis == 1 ? i / 3 % 3 - 1 : i / 9 - 1;
                ways += Math.abs(way);
                open &= way == 0 || mm[axis] > 0;
            }
            int axes = (xMm > 0 ? 1 : 0) + (yMm > 0 ? 1 : 0) + (zMm > 0 ? 1 : 0);
            if (open && ways > 0 && (ways == 1 || ways == axes)) {
                poses.add(RigidTransform.ofEuler(shift[0], shift[1], shift[2], 0, 0, 0).compose(worldFromCamera));
            }
        }
        for (int axis = 0; axis < 3 && turnDeg > 0; axis++) {
            for (int sign = -1; sign <= 1; sign += 2) {
                double[] turn = new double[3];
                turn[axis] = sign * Math.toRadians(turnDeg);
                poses.add(worldFromCamera.compose(RigidTransform.ofRotationVector(turn, new double[3])));
            }
        }
        return poses;
    }
}
