package org.cellgauge.desktop.render;

import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.internal.vision.MarkerPattern;

/**
 * A printed marker of a scene.
 *
 * @param id marker id
 * @param sizeMm outer edge of the black border, mm, positive
 * @param pattern its cells
 * @param worldFromMarker where it really is
 * @param inkReflectance light that its dark cells throw back as a share of what falls on them, 0 to 1; white paper
 *     throws back {@value PlanarMarker#WHITE}
 */
public record SceneMarker(int id, double sizeMm, MarkerPattern pattern, RigidTransform worldFromMarker,
        double inkReflectance) {
    /**
     * Checks size and ink.
     *
     * @throws IllegalArgumentException if the size is not positive and finite, or the reflectance out of its range
     */
    public SceneMarker {
        if (!(sizeMm > 0) || !Double.isFinite(sizeMm)) {
            throw new IllegalArgumentException("marker " + id + ": size must be positive, not " + sizeMm);
        }
        if (!(inkReflectance >= 0 && inkReflectance <= 1)) {
            throw new IllegalArgumentException("ink must throw back 0 to 1 of the light, not " + inkReflectance);
        }
    }

    /**
     * A marker in black ink.
     *
     * @param id as above
     * @param sizeMm as above
     * @param pattern as above
     * @param worldFromMarker as above
     */
    public SceneMarker(int id, double sizeMm, MarkerPattern pattern, RigidTransform worldFromMarker) {
        this(id, sizeMm, pattern, worldFromMarker, PlanarMarker.BLACK);
    }
}
