package org.cellgauge.output;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import org.jspecify.annotations.Nullable;

/** Camera and objects without the references that seem misplaced, by Laplace's approximation; immutable. */
public final class WithoutView extends Value {
    private final List<Integer> leftOut;
    private final PoseView camera;
    private final double[] cameraMoveMm;
    private final List<MovedObject> objects;

    WithoutView(List<Integer> leftOut, PoseView camera, double[] cameraMoveMm, List<MovedObject> objects) {
        this.leftOut = Collections.unmodifiableList(new ArrayList<>(leftOut));
        this.camera = camera;
        this.cameraMoveMm = Figures.finite(cameraMoveMm);
        this.objects = Collections.unmodifiableList(new ArrayList<>(objects));
    }

    /**
     * The references left out.
     *
     * @return marker ids, the worst first
     */
    public List<Integer> leftOut() {
        return leftOut;
    }

    /**
     * The camera from the others.
     *
     * @return camera in world
     */
    public PoseView camera() {
        return camera;
    }

    /**
     * How far the camera moves when they are left out.
     *
     * @return along world x, y, z, mm; a new array
     */
    public double[] cameraMoveMm() {
        return cameraMoveMm.clone();
    }

    /**
     * The objects seen.
     *
     * @return in the order of the cell
     */
    public List<MovedObject> objects() {
        return objects;
    }

    /**
     * One object.
     *
     * @param id marker id
     * @return what becomes of it, or null where it was not seen
     */
    public @Nullable MovedObject object(int id) {
        for (MovedObject object : objects) {
            if (object.id() == id) {
                return object;
            }
        }
        return null;
    }

    @Override
    @Nullable Object[] figures() {
        return new @Nullable Object[] {leftOut, camera, cameraMoveMm, objects};
    }
}
