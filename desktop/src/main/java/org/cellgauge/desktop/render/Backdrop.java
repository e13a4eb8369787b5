package org.cellgauge.desktop.render;

/**
 * The wall or table behind the markers: the reflectance of the plane z = 0 of the world; immutable.
 *
 * <p>The texture is value noise in five octaves: a hash of each lattice point, interpolated by the quintic
 * {@code 6t⁵ - 15t⁴ + 10t³} (K. Perlin, "Improving noise", 2002, for the polynomial). It depends on nothing but the
 * place on the wall and the seed, so the same wall can be seen by several cameras.
 */
public final class Backdrop {
    /** Mean reflectance of the wall. */
    public static final double MEAN_REFLECTANCE = 0.55;
    private static final int OCTAVES = 5;
    private static final double LONGEST_WAVE_MM = 240;
    private static final double OCTAVE_GAIN = 0.65;

    private final double contrast;
    private final long seed;

    private Backdrop(double contrast, long seed) {
        this.contrast = contrast;
        this.seed = seed;
    }

    /**
     * A wall of one grey.
     *
     * @return the wall
     */
    public static Backdrop plain() {
        return new Backdrop(0, 0);
    }

    /**
     * A wall with a random texture.
     *
     * @param contrast largest deviation of the reflectance from its mean, 0 to 0.4; plaster or wood has about 0.1
     * @param seed picks the texture
     * @return the wall
     * @throws IllegalArgumentException if the contrast is outside its range
     */
    public static Backdrop textured(double contrast, long seed) {
        if (!(contrast >= 0 && contrast <= 0.4)) {
            throw new IllegalArgumentException("texture contrast must be between 0 and 0.4, not " + contrast);
        }
        return new Backdrop(contrast, seed);
    }

    /**
     * Whether the wall has no texture.
     *
     * @return true if its reflectance is {@link #MEAN_REFLECTANCE} everywhere
     */
    public boolean isPlain() {
        return contrast == 0;
    }

    /**
     * Reflectance around a place on the wall.
     *
     * @param xMm world x, mm
     * @param yMm world y, mm
     * @param softnessMm standard deviation of the Gaussian over which it is averaged, mm, at least 0: each octave fades
     *     by the Gaussian's transfer function at its wavelength, which stands in for the true average
     * @return between 0 and 1
     */
    public double reflectance(double xMm, double yMm, double softnessMm) {
        return sampler().reflectance(xMm, yMm, softnessMm);
    }

    /**
     * A reader of this wall for one thread, quick for places that lie close to each other.
     *
     * @return a new reader
     */
    Sampler sampler() {
        return new Sampler();
    }

    /** Keeps the lattice points around the place it looked at last, octave by octave. */
    final class Sampler {
        private final long[] latticeX = new long[OCTAVES];
        private final long[] latticeY = new long[OCTAVES];
        private final double[] corners = new double[4 * OCTAVES];
        private final boolean[] known = new boolean[OCTAVES];

        private Sampler() {
        }

        /** As {@link Backdrop#reflectance}. */
        double reflectance(double xMm, double yMm, double softnessMm) {
            if (contrast == 0) {
                return MEAN_REFLECTANCE;
            }
            double sum = 0;
            double weights = 0;
            double weight = 1;
            double wave = LONGEST_WAVE_MM;
            for (int octave = 0; octave < OCTAVES; octave++) {
                weights += weight;
                double cycles = softnessMm / (2 * wave);
                double faded = weight;
                if (cycles > 0.02) {
                    faded *= Math.exp(-2 * Math.PI * Math.PI * cycles * cycles);
                }
                if (faded > 1e-4) {
                    sum += faded * lattice(xMm / wave, yMm / wave, octave);
                }
                weight *= OCTAVE_GAIN;
                wave /= 2;
            }
            return MEAN_REFLECTANCE + contrast * sum / weights;
        }

        private double lattice(double x, double y, int octave) {
            double floorX = Math.floor(x);
            double floorY = Math.floor(y);
            long ix = (long) floorX;
            long iy = (long) floorY;
            int k = 4 * octave;
            if (!known[octave] || latticeX[octave] != ix || latticeY[octave] != iy) {
                known[octave] = true;
                latticeX[octave] = ix;
                latticeY[octave] = iy;
                corners[k] = hash(ix, iy, octave);
                corners[k + 1] = hash(ix + 1, iy, octave);
                corners[k + 2] = hash(ix, iy + 1, octave);
                corners[k + 3] = hash(ix + 1, iy + 1, octave);
            }
            double fx = quintic(x - floorX);
            double fy = quintic(y - floorY);
            double top = mix(corners[k], corners[k + 1], fx);
            double bottom = mix(corners[k + 2], corners[k + 3], fx);
            return mix(top, bottom, fy);
        }
    }

    private static double quintic(double t) {
        return t * t * t * (t * (t * 6 - 15) + 10);
    }

    private static double mix(double a, double b, double share) {
        return a + share * (b - a);
    }

    /** A value in [-1, 1) for a lattice point: two rounds of multiply and xor-shift with odd 64-bit constants. */
    private double hash(long ix, long iy, int octave) {
        long h = seed + octave * 0x9E3779B97F4A7C15L;
        h ^= ix * 0xD6E8FEB86659FD93L;
        h = (h ^ (h >>> 32)) * 0xD6E8FEB86659FD93L;
        h ^= iy * 0xA0761D6478BD642FL;
        h = (h ^ (h >>> 32)) * 0xD6E8FEB86659FD93L;
        h ^= h >>> 32;
        return (h >> 11) * 0x1.0p-52;
    }
}
