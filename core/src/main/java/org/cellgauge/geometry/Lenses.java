package org.cellgauge.geometry;

/** The lens models there are, by their names. */
public final class Lenses {
    private Lenses() {
    }

    /**
     * A lens model.
     *
     * @param modelName {@link Lens#modelName()}
     * @return the model; null where there is none of that name
     */
    public static Lens named(String modelName) {
        for (Lens lens : new Lens[] {BrownLens.MODEL, KannalaBrandtLens.MODEL}) {
            if (lens.modelName().equals(modelName)) {
                return lens;
            }
        }
        return null;
    }
}
