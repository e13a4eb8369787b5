package org.cellgauge.vision;

/** One marker as seen in an image: its id and where its four corners are; immutable. */
public final class MarkerObservation {
    private final int id;
    private final double[] cornersPx;

    /**
     * An observation.
     *
     * @param id marker id
     * @param cornersPx 8 values: u, v of top-left, top-right, bottom-right, bottom-left corner of the marker in its own
     *     frame, px with pixel centres at +0.5, distorted as in the image; copied
     * @throws IllegalArgumentException if there are not 8 finite values
     */
    public MarkerObservation(int id, double[] cornersPx) {
        if (cornersPx.length != 8) {
            throw new IllegalArgumentException("marker " + id + ": 4 corners take 8 values, not " + cornersPx.length);
        }
        for (double v : cornersPx) {
            if (!Double.isFinite(v)) {
                throw new IllegalArgumentException("marker " + id + ": a corner is not finite");
            }
        }
        this.id = id;
        this.cornersPx = cornersPx.clone();
    }

    /**
     * Marker id.
     *
     * @return the id within the family
     */
    public int id() {
        return id;
    }

    /**
     * The corners.
     *
     * @return a copy of the 8 values u, v of top-left, top-right, bottom-right, bottom-left, px
     */
    public double[] cornersPx() {
        return cornersPx.clone();
    }

    /**
     * Length of the shortest side in the image: what decides whether the marker is large enough.
     *
     * @return px
     */
    public double shortestSidePx() {
        double shortest = Double.POSITIVE_INFINITY;
        for (int i = 0; i < 4; i++) {
            int j = (i + 1) % 4;
            shortest = Math.min(shortest, Math.hypot(cornersPx[2 * j] - cornersPx[2 * i],
                    cornersPx[2 * j + 1] - cornersPx[2 * i + 1]));
        }
        return shortest;
    }
}
