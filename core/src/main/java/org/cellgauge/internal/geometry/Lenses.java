package org.cellgauge.internal.geometry;

import org.cellgauge.geometry.BrownLens;
import org.cellgauge.geometry.KannalaBrandtLens;
import org.cellgauge.geometry.Lens;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.geometry.RationalLens;
import org.jspecify.annotations.Nullable;

/** The lens models there are, by their names. */
public final class Lenses {
    /** Index of the first coefficient of radial distortion among the parameters, of every lens there is. */
    public static final int FIRST_RADIAL = PinholeCamera.SKEW + 1;

    private Lenses() {
    }

    /**
     * A lens model.
     *
     * @param modelName {@link Lens#modelName()}
     * @return the model; null where there is none of that name
     */
    public static @Nullable Lens named(String modelName) {
        for (Lens lens : new Lens[] {BrownLens.MODEL, KannalaBrandtLens.MODEL, RationalLens.MODEL}) {
            if (lens.modelName().equals(modelName)) {
                return lens;
            }
        }
        return null;
    }
}
