package org.cellgauge.internal.sampling;

import org.apache.commons.math3.random.RandomGenerator;
import org.apache.commons.math3.random.Well19937c;

/**
 * Independent random streams of one seed, told apart by a path of numbers (purpose, chain, object): what a stream
 * yields depends on the seed and its path alone, not on threads or on how many other streams there are.
 */
public final class RandomStreams {
    private RandomStreams() {
    }

    /**
     * A stream.
     *
     * @param seed the user's seed
     * @param path numbers that name the stream
     * @return a new generator (WELL19937c; Panneton, L'Ecuyer, Matsumoto 2006; normal numbers by Box and Muller 1958)
     */
    public static RandomGenerator of(long seed, long... path) {
        long state = mix(seed + 0x9E3779B97F4A7C15L);
        for (long p : path) {
            state = mix(state ^ mix(p + 0x9E3779B97F4A7C15L) + 0x632BE59BD9B4E019L);
        }
        int[] words = new int[16];
        for (int i = 0; i < words.length; i += 2) {
            state += 0x9E3779B97F4A7C15L;
            long m = mix(state);
            words[i] = (int) m;
            words[i + 1] = (int) (m >>> 32);
        }
        return new Stream(words);
    }

    /**
     * The library's generator with its own numbers, but with the processor's logarithm, sine and cosine in place of the
     * library's slower ones, which differ in the last bit.
     */
    private static final class Stream extends Well19937c {
        private static final long serialVersionUID = 1;

        private double second = Double.NaN;

        Stream(int[] seed) {
            super(seed);
        }

        @Override
        public double nextGaussian() {
            double first = second;
            if (!Double.isNaN(first)) {
                second = Double.NaN;
                return first;
            }
            double angle = 2 * Math.PI * nextDouble();
            double length = Math.sqrt(-2 * Math.log(nextDouble()));
            second = length * Math.sin(angle);
            return length * Math.cos(angle);
        }

        @Override
        public void clear() {
            super.clear();
            second = Double.NaN;
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
