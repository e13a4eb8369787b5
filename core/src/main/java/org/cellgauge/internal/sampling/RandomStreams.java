package org.cellgauge.internal.sampling;

import org.apache.commons.math3.random.RandomGenerator;
import org.apache.commons.rng.UniformRandomProvider;
import org.apache.commons.rng.core.source64.XoShiRo256PlusPlus;
import org.apache.commons.rng.sampling.distribution.NormalizedGaussianSampler;
import org.apache.commons.rng.sampling.distribution.ZigguratSampler;

/**
 * Independent random streams of one seed, told apart by a path of numbers (purpose, chain, object): what a stream
 * yields depends on the seed and its path alone, not on threads or on how many other streams there are.
 */
public final class RandomStreams {
    /** Step of SplitMix64, by which the words of a stream's state are apart: 2^64 over the golden ratio. */
    private static final long WEYL = 0x9E3779B97F4A7C15L;

    private RandomStreams() {
    }

    /**
     * A stream.
     *
     * @param seed the user's seed
     * @param path numbers that name the stream
     * @return a new generator (xoshiro256++; Blackman and Vigna, "Scrambled linear pseudorandom number generators",
     *     ACM Transactions on Mathematical Software 2021; normal numbers by McFarland, "A modified ziggurat algorithm
     *     for generating exponentially and normally distributed pseudorandom numbers", Journal of Statistical
     *     Computation and Simulation 2016), which cannot be seeded anew
     */
    public static RandomGenerator of(long seed, long... path) {
        long state = mix(seed + WEYL);
        for (long p : path) {
            state = mix(state ^ mix(p + WEYL) + 0x632BE59BD9B4E019L);
        }
        long[] words = new long[4];
        for (int i = 0; i < words.length; i++) {
            state += WEYL;
            words[i] = mix(state);
        }
        return new Stream(new XoShiRo256PlusPlus(words));
    }

    /** The library's generator under the interface that the rest of the code and its other library know. */
    private static final class Stream implements RandomGenerator {
        private final UniformRandomProvider bits;
        private final NormalizedGaussianSampler normal;

        Stream(UniformRandomProvider bits) {
            this.bits = bits;
            normal = ZigguratSampler.NormalizedGaussian.of(bits);
        }

        @Override
        public double nextDouble() {
            return bits.nextDouble();
        }

        @Override
        public double nextGaussian() {
            return normal.sample();
        }

        @Override
        public float nextFloat() {
            return bits.nextFloat();
        }

        @Override
        public boolean nextBoolean() {
            return bits.nextBoolean();
        }

        @Override
        public int nextInt() {
            return bits.nextInt();
        }

        @Override
        public int nextInt(int n) {
            return bits.nextInt(n);
        }

        @Override
        public long nextLong() {
            return bits.nextLong();
        }

        @Override
        public void nextBytes(byte[] bytes) {
            bits.nextBytes(bytes);
        }

        @Override
        public void setSeed(int seed) {
            throw seeded();
        }

        @Override
        public void setSeed(int[] seed) {
            throw seeded();
        }

        @Override
        public void setSeed(long seed) {
            throw seeded();
        }

        private static UnsupportedOperationException seeded() {
            return new UnsupportedOperationException("a stream is that of its seed and path");
        }
    }

    /**
     * The finaliser of SplitMix64 (Steele, Lea, Flood, OOPSLA 2014): every bit of the input changes half the output.
     */
    private static long mix(long z) {
        long a = (z ^ (z >>> 30)) * 0xBF58476D1CE4E5B9L;
        long b = (a ^ (a >>> 27)) * 0x94D049BB133111EBL;
        return b ^ (b >>> 31);
    }
}
