package org.cellgauge.internal.calibration;

import java.util.Arrays;
import org.cellgauge.internal.geometry.Rotations;
import org.cellgauge.vision.TargetObservation;
import org.jspecify.annotations.Nullable;

/** One photo of a target as the adjustment works on it: what was seen, what still counts, pose and equations. */
final class TargetPhoto {
    final String name;
    final int count;
    final int[] points;
    final double[] uv;
    /** Where each corner of a marker goes, px, when its sides move outwards by 1 px; null for other targets. */
    final double @Nullable [] outwards;
    final boolean[] active;

    /** cameraFromTarget. */
    final double[] rotation = new double[9];
    final double[] translation = new double[3];
    /** By how much the light moves sides of markers outwards in this photo, px. */
    double shift;

    final double[] trialRotation = new double[9];
    final double[] trialTranslation = new double[3];
    double trialShift;

    // equations: unknowns of the photo's own (pose, shift) and of all photos
    double[] own = {};
    double[] ownFactor = {};
    double[] shared = {};
    double[] ownGradient = {};
    double[] reduced = {};

    TargetPhoto(TargetObservation seen, boolean cornersOfMarkers) {
        name = seen.name();
        count = seen.count();
        points = seen.points();
        uv = seen.uvPx();
        active = new boolean[count];
        Arrays.fill(active, true);
        outwards = cornersOfMarkers ? outwards(uv) : null;
    }

    private TargetPhoto(TargetPhoto other) {
        name = other.name;
        count = other.count;
        points = other.points;
        uv = other.uv;
        outwards = other.outwards;
        active = other.active.clone();
        System.arraycopy(other.rotation, 0, rotation, 0, 9);
        System.arraycopy(other.translation, 0, translation, 0, 3);
        shift = other.shift;
    }

    /** The same photo at the same pose, to be adjusted apart from this one. */
    TargetPhoto copy() {
        return new TargetPhoto(this);
    }

    int activeCount() {
        int n = 0;
        for (boolean a : active) {
            n += a ? 1 : 0;
        }
        return n;
    }

    /**
     * How corners move with their sides: a corner stays on both sides next to it, each of which goes outwards by the
     * same distance.
     */
    private static double[] outwards(double[] uv) {
        double[] out = new double[uv.length];
        for (int first = 0; first + 8 <= uv.length; first += 8) {
            for (int k = 0; k < 4; k++) {
                double[] before = normal(uv, first, (k + 3) % 4);
                double[] after = normal(uv, first, k);
                double scale = 1 + before[0] * after[0] + before[1] * after[1];
                out[first + 2 * k] = (before[0] + after[0]) / scale;
                out[first + 2 * k + 1] = (before[1] + after[1]) / scale;
            }
        }
        return out;
    }

    /** Outward normal of the side that begins at a corner; corners run clockwise as seen. */
    private static double[] normal(double[] uv, int first, int corner) {
        int a = first + 2 * corner;
        int b = first + 2 * ((corner + 1) % 4);
        double dx = uv[b] - uv[a];
        double dy = uv[b + 1] - uv[a + 1];
        double length = Math.hypot(dx, dy);
        return new double[] {dy / length, -dx / length};
    }

    /** Goes a step from the pose, into the trial: a turn about the camera's axes, a shift, a shift of sides. */
    void tryStep(double[] step, boolean withShift) {
        double[] turn = new double[9];
        Rotations.exp(step[0], step[1], step[2], turn);
        multiply(turn, rotation, trialRotation);
        for (int i = 0; i < 3; i++) {
            trialTranslation[i] = translation[i] + step[3 + i];
        }
        trialShift = withShift ? shift + step[6] : shift;
    }

    void acceptTrial() {
        System.arraycopy(trialRotation, 0, rotation, 0, 9);
        System.arraycopy(trialTranslation, 0, translation, 0, 3);
        shift = trialShift;
    }

    static void multiply(double[] a, double[] b, double[] out) {
        for (int i = 0; i < 3; i++) {
            for (int j = 0; j < 3; j++) {
                out[3 * i + j] = a[3 * i] * b[j] + a[3 * i + 1] * b[3 + j] + a[3 * i + 2] * b[6 + j];
            }
        }
    }
}
