package org.cellgauge.internal.sampling;

import org.apache.commons.math3.random.BitsStreamGenerator;
import org.apache.commons.math3.random.RandomGenerator;

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
     * WELL19937c with the numbers of Commons Math's, which keeps five tables of indices beside each generator's words:
     * many generators in turn, one per object and chain, then come from memory and not from the processor's cache.
     * Normal numbers are with the processor's logarithm, sine and cosine in place of that library's slower ones, which
     * differ in the last bit.
     */
    private static final class Stream extends BitsStreamGenerator {
        private static final long serialVersionUID = 2;
        /** Words of 32 bits, and which of them are mixed (Panneton, L'Ecuyer, Matsumoto 2006, table II). */
        private static final int WORDS = 624;
        private static final int M1 = 70;
        private static final int M2 = 179;
        private static final int M3 = 449;
        private static final long SPREAD = 1812433253L;

        private final int[] words = new int[WORDS];
        private int index;
        private double second = Double.NaN;

        Stream(int[] seed) {
            setWords(seed);
        }

        private void setWords(int[] seed) {
            System.arraycopy(seed, 0, words, 0, Math.min(seed.length, WORDS));
            for (int i = seed.length; i < WORDS; i++) {
                long word = words[i - seed.length];
                words[i] = (int) (SPREAD * (word ^ (word >> 30)) + i);
            }
            index = 0;
        }

        @Override
        public void setSeed(int seed) {
            setSeed(new int[] {seed});
        }

        @Override
        public void setSeed(long seed) {
            setSeed(new int[] {(int) (seed >>> 32), (int) seed});
        }

        @Override
        public void setSeed(int[] seed) {
            setWords(seed);
            clear();
        }

        @Override
        protected int next(int bits) {
            int before = index == 0 ? WORDS - 1 : index - 1;
            int twoBefore = before == 0 ? WORDS - 1 : before - 1;
            int v0 = words[index];
            int v1 = words[index < WORDS - M1 ? index + M1 : index + M1 - WORDS];
            int v2 = words[index < WORDS - M2 ? index + M2 : index + M2 - WORDS];
            int v3 = words[index < WORDS - M3 ? index + M3 : index + M3 - WORDS];
            int z0 = 0x80000000 & words[before] ^ 0x7FFFFFFF & words[twoBefore];
            int z1 = v0 ^ v0 << 25 ^ v1 ^ v1 >>> 27;
            int z2 = v2 >>> 9 ^ v3 ^ v3 >>> 1;
            int z3 = z1 ^ z2;
            int z4 = z0 ^ z1 ^ z1 << 9 ^ z2 ^ z2 << 21 ^ z3 ^ z3 >>> 21;
            words[index] = z3;
            words[before] = z4;
            words[twoBefore] &= 0x80000000;
            index = before;
            // tempering by Matsumoto and Kurita
            z4 ^= z4 << 7 & 0xe46e1700;
            z4 ^= z4 << 15 & 0x9b868000;
            return z4 >>> 32 - bits;
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
