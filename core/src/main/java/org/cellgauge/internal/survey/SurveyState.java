package org.cellgauge.internal.survey;

import java.util.Arrays;
import java.util.List;
import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.internal.geometry.Rotations;

/** Values of all unknowns of a survey; mutable, for inner loops. */
final class SurveyState {
    private static final int POSE = SurveyLayout.POSE;
    /** A rotation matrix and a translation. */
    static final int TRANSFORM = 12;

    final SurveyLayout layout;
    /** By {@link SurveyLayout}; places of objects' poses are not used. */
    final double[] values;
    /** Poses of objects that stand still, worldFromObject, {@value #TRANSFORM} values each. */
    final double[] objects;
    /** All parameters of the lens. */
    final double[] lens;
    /** cameraFromWorld about the centre, by photo. */
    final double[][] cameras;
    final double[][] edges;
    /** cameraFromObject of objects that move, by photo. */
    final double[][] moving;

    private final double[] turn = new double[9];
    private final double[] product = new double[9];
    private final double[] old = new double[9];

    SurveyState(SurveyLayout layout, List<SurveyView> views) {
        this.layout = layout;
        values = new double[layout.size];
        objects = new double[TRANSFORM * layout.objects.size()];
        lens = layout.cell.camera().intrinsics();
        for (int i = 0; i < layout.intrinsics.count(); i++) {
            values[layout.firstIntrinsic + i] = lens[layout.intrinsics.index(i)];
        }
        cameras = new double[views.size()][TRANSFORM];
        edges = new double[views.size()][];
        moving = new double[views.size()][];
        for (int v = 0; v < views.size(); v++) {
            edges[v] = new double[views.get(v).edges];
            moving[v] = new double[TRANSFORM * views.get(v).moving.size()];
        }
    }

    static void set(double[] to, int at, RigidTransform pose) {
        System.arraycopy(pose.rotation(), 0, to, at, 9);
        System.arraycopy(pose.translationMm(), 0, to, at + 9, 3);
    }

    static RigidTransform get(double[] from, int at) {
        return RigidTransform.of(Arrays.copyOfRange(from, at, at + 9), Arrays.copyOfRange(from, at + 9, at + 12));
    }

    /** Takes over from an earlier mode what is known of references, lens and prints, and of photos that were there. */
    void warm(SurveyState before, List<SurveyView> then, List<SurveyView> now) {
        System.arraycopy(before.values, 0, values, 0, layout.firstObject);
        System.arraycopy(before.values, before.layout.firstIntrinsic, values, layout.firstIntrinsic,
                layout.size - layout.firstIntrinsic);
        System.arraycopy(before.lens, 0, lens, 0, lens.length);
        for (int v = 0; v < now.size(); v++) {
            int at = then.indexOf(now.get(v));
            if (at >= 0) {
                System.arraycopy(before.edges[at], 0, edges[v], 0, edges[v].length);
                System.arraycopy(before.moving[at], 0, moving[v], 0, moving[v].length);
            }
        }
    }

    void copyFrom(SurveyState other) {
        System.arraycopy(other.values, 0, values, 0, values.length);
        System.arraycopy(other.objects, 0, objects, 0, objects.length);
        System.arraycopy(other.lens, 0, lens, 0, lens.length);
        for (int v = 0; v < cameras.length; v++) {
            System.arraycopy(other.cameras[v], 0, cameras[v], 0, TRANSFORM);
            System.arraycopy(other.edges[v], 0, edges[v], 0, edges[v].length);
            System.arraycopy(other.moving[v], 0, moving[v], 0, moving[v].length);
        }
    }

    /** This becomes another state a step further, in what all photos share. */
    void moveShared(SurveyState from, double[] step) {
        for (int i = 0; i < values.length; i++) {
            values[i] = from.values[i] + step[i];
        }
        for (int o = 0; o < layout.objects.size(); o++) {
            move(from.objects, objects, TRANSFORM * o, step, layout.firstObject + POSE * o);
        }
        System.arraycopy(from.lens, 0, lens, 0, lens.length);
        for (int i = 0; i < layout.intrinsics.count(); i++) {
            lens[layout.intrinsics.index(i)] = values[layout.firstIntrinsic + i];
        }
    }

    /** This becomes another state a step further, in what one photo has of its own. */
    void moveOwn(SurveyState from, int view, double[] step, int at) {
        move(from.cameras[view], cameras[view], 0, step, at);
        for (int i = 0; i < edges[view].length; i++) {
            edges[view][i] = from.edges[view][i] + step[at + POSE + i];
        }
        int first = at + POSE + edges[view].length;
        for (int k = 0; TRANSFORM * k < moving[view].length; k++) {
            move(from.moving[view], moving[view], TRANSFORM * k, step, first + POSE * k);
        }
    }

    private void move(double[] from, double[] to, int at, double[] step, int firstStep) {
        Rotations.exp(step[firstStep + 3], step[firstStep + 4], step[firstStep + 5], turn);
        System.arraycopy(from, at, old, 0, 9);
        Rotations.multiply(turn, old, product);
        System.arraycopy(product, 0, to, at, 9);
        for (int i = 0; i < 3; i++) {
            to[at + 9 + i] = from[at + 9 + i] + step[firstStep + i];
        }
    }
}
