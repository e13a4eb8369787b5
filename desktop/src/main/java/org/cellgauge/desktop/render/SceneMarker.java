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
 */
public record SceneMarker(int id, double sizeMm, MarkerPattern pattern, RigidTransform worldFromMarker) {
    /**
     * Checks the size.
     *
     * @throws IllegalArgumentException if the size is not positive and finite
     */
    public SceneMarker {
        if (!(sizeMm > 0) || !Double.isFinite(sizeMm)) {
            throw new IllegalArgumentException("marker " + id + ": size must be positive, not " + sizeMm);
        }
    }
}
