package org.cellgauge.fuzz;

import java.io.ByteArrayOutputStream;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.SplittableRandom;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** Changes inputs at random: as damage on the way does, and as people who type do. The same seed, the same changes. */
final class Mutator {
    private static final Pattern NUMBER = Pattern.compile("-?\\d+(\\.\\d+)?([eE]-?\\d+)?");
    private static final String[] NUMBERS = {"0", "-0", "1", "-1", "2", "0.5", "1e-9", "1e-300", "1e5", "1e6", "1e9",
        "1e15", "1e300", "1e308", "-1e308", "1e400", "2147483647", "2147483648", "-2147483649", "9223372036854775808",
        "NaN", "Infinity", ".inf", ".nan", "1e-400", "4095", "4096", "90", "179.999", "180", "360", "012", "0x10"};
    private static final String[] TOKENS = {"{", "}", "[", "]", ",", ":", ": ", "\n", "\n  ", "\t", "\"", "'", "#",
        "&a ", "*a", "!!", "!%20", "!!binary ", "? ", "- ", "---\n", "...\n", "<<: ", "|\n", ">\n", "~", "null",
        "true", "\\", "\\u", "\\x4", "\"\\UDDDDDDDD\"", "\ud83d\ude00", "\u0000", "\u0085", "\u2028", "\ufeff",
        "%YAML 1.3\n", "@", "`", "\u00ff\u00d8", "IDAT", "\u0000\u0000\u0000\u0000"};
    private static final int INTERESTING_BYTES = 6;

    private final SplittableRandom random;

    Mutator(SplittableRandom random) {
        this.random = random;
    }

    /** Between one and eight changes of any kind. */
    byte[] mutated(byte[] input, List<byte[]> corpus) {
        if (random.nextInt(3) == 0) {
            return withOtherNumbers(new String(input, StandardCharsets.ISO_8859_1), 3)
                    .getBytes(StandardCharsets.ISO_8859_1);
        }
        byte[] changed = input;
        int changes = 1 + random.nextInt(1 + random.nextInt(8));
        for (int i = 0; i < changes; i++) {
            changed = changed(changed, corpus);
        }
        return changed;
    }

    /** A text with a few of its numbers replaced: what stays readable as it was. */
    String withOtherNumbers(String text, int most) {
        String changed = text;
        for (int i = random.nextInt(1, most + 1); i > 0; i--) {
            changed = withOtherNumber(changed);
        }
        return changed;
    }

    /** The number at a random place or the next after it, so that a long text costs no more than a short one. */
    private String withOtherNumber(String text) {
        int from = random.nextInt(text.length() + 1);
        while (from > 0 && from < text.length() && isOfNumber(text.charAt(from - 1))) {
            from--;
        }
        Matcher numbers = NUMBER.matcher(text);
        if (!numbers.find(from) && !numbers.find(0)) {
            return text;
        }
        int[] place = {numbers.start(), numbers.end()};
        String old = text.substring(place[0], place[1]);
        String other;
        if (random.nextInt(3) == 0) {
            other = NUMBERS[random.nextInt(NUMBERS.length)];
        } else {
            double factor = random.nextInt(4) == 0 ? Math.pow(10, random.nextDouble(-3, 3))
                    : random.nextDouble(0.9, 1.1);
            other = Double.toString(Double.parseDouble(old) * factor);
        }
        return text.substring(0, place[0]) + other + text.substring(place[1]);
    }

    private static boolean isOfNumber(char c) {
        return c >= '0' && c <= '9' || c == '.' || c == '-' || c == '+' || c == 'e' || c == 'E';
    }

    private byte[] changed(byte[] in, List<byte[]> corpus) {
        int length = in.length;
        int at = random.nextInt(length + 1);
        int span = Math.min(length - at, 1 + random.nextInt(1 << random.nextInt(1, 8)));
        byte[] one = in.clone();
        switch (random.nextInt(9)) {
            case 0:
                if (at < length) {
                    one[at] ^= (byte) (1 << random.nextInt(8));
                }
                return one;
            case 1:
                if (at < length) {
                    int[] bytes = {0, 0xFF, 0x7F, 0x80, ' ', random.nextInt(256)};
                    one[at] = (byte) bytes[random.nextInt(INTERESTING_BYTES)];
                }
                return one;
            case 2:
                return joined(in, 0, at, new byte[0], in, at + span, length);
            case 3:
                return joined(in, 0, at + span, new byte[0], in, at, length);
            case 4:
                return joined(in, 0, at, TOKENS[random.nextInt(TOKENS.length)].getBytes(StandardCharsets.UTF_8), in, at,
                        length);
            case 5:
                return joined(in, 0, at, new byte[0], in, length, length);
            case 6:
                byte[] other = corpus.get(random.nextInt(corpus.size()));
                int from = random.nextInt(other.length + 1);
                return joined(in, 0, at, new byte[0], other, from, other.length);
            case 7:
                for (int i = at; i < at + span; i++) {
                    one[i] = (byte) random.nextInt(256);
                }
                return one;
            default:
                // Latin-1 keeps every byte as it is, of texts and images alike
                return withOtherNumber(new String(in, StandardCharsets.ISO_8859_1))
                        .getBytes(StandardCharsets.ISO_8859_1);
        }
    }

    private static byte[] joined(byte[] a, int fromA, int toA, byte[] middle, byte[] b, int fromB, int toB) {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        out.write(a, fromA, toA - fromA);
        out.writeBytes(middle);
        out.write(b, fromB, toB - fromB);
        return out.toByteArray();
    }
}
