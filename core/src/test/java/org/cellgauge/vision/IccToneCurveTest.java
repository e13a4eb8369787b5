package org.cellgauge.vision;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.function.DoubleUnaryOperator;
import org.cellgauge.light.ToneCurve;
import org.junit.jupiter.api.Test;

/** Curves of colour profiles, made here byte by byte after the standard. */
class IccToneCurveTest {
    /** A profile with one curve; the header says nothing that matters here. */
    private static byte[] profile(String tag, byte[] curve, String description) {
        byte[] desc = ("desc\0\0\0\0\0\0\0" + (char) description.length() + description)
                .getBytes(StandardCharsets.ISO_8859_1);
        ByteBuffer out = ByteBuffer.allocate(156 + curve.length + desc.length);
        out.putInt(0, out.capacity()).position(128);
        out.putInt(2).put(tag.getBytes(StandardCharsets.US_ASCII)).putInt(156).putInt(curve.length);
        out.put("desc".getBytes(StandardCharsets.US_ASCII)).putInt(156 + curve.length).putInt(desc.length);
        return out.put(curve).put(desc).array();
    }

    private static byte[] table(int count, DoubleUnaryOperator light) {
        ByteBuffer out = ByteBuffer.allocate(12 + 2 * count).put("curv\0\0\0\0".getBytes(StandardCharsets.US_ASCII));
        out.putInt(count);
        for (int i = 0; i < count; i++) {
            out.putShort((short) Math.round(65535 * light.applyAsDouble(i / (count - 1.0))));
        }
        return out.array();
    }

    private static byte[] parametric(int kind, double... parameters) {
        ByteBuffer out = ByteBuffer.allocate(12 + 4 * parameters.length);
        out.put("para\0\0\0\0".getBytes(StandardCharsets.US_ASCII)).putShort((short) kind).putShort((short) 0);
        for (double p : parameters) {
            out.putInt((int) Math.round(65536 * p));
        }
        return out.array();
    }

    private static String curve(byte[] profile) {
        ToneCurve curve = IccToneCurve.of(profile);
        return curve == null ? "-" : curve.words();
    }

    /** Kinds of curves as ICC.1:2022, 10.6 and 10.18, define them. */
    @Test
    void curvesOfProfiles() {
        assertEquals("linear", curve(profile("gTRC", table(0, x -> x), "")));
        // 2.19921875 as Adobe RGB has it: 563 / 256
        byte[] adobe = table(1, x -> 0);
        adobe[12] = 2;
        adobe[13] = 51;
        assertEquals("gamma 2.2", curve(profile("gTRC", adobe, "")));
        for (int count : new int[] {2, 17, 256, 4096}) {
            assertEquals("linear", curve(profile("kTRC", table(count, x -> x), "")), "" + count);
        }
        assertEquals("gamma 2.2", curve(profile("kTRC", table(1024, x -> Math.pow(x, 2.2)), "")));
        assertEquals("gamma 2.2", curve(profile("kTRC", parametric(0, 2.2), "")));
        double[] srgb = {2.4, 1 / 1.055, 0.055 / 1.055, 1 / 12.92, 0.04045, 0, 0};
        assertEquals("srgb", curve(profile("gTRC", parametric(3, Arrays.copyOf(srgb, 5)), "")));
        assertEquals("srgb", curve(profile("gTRC", parametric(4, srgb), "")));
        assertEquals("gamma 1.8", curve(profile("gTRC", parametric(1, 1.8, 1, 0), "")));
        assertEquals("gamma 1.8", curve(profile("gTRC", parametric(2, 1.8, 1, 0, 0), "")));
        // no power: a negative, and a curve of another kind
        assertEquals("-", curve(profile("kTRC", table(256, x -> 1 - x), "")));
        assertEquals("-", curve(profile("kTRC", "mft1\0\0\0\0\0\0\0\0".getBytes(StandardCharsets.US_ASCII), "")));
        assertEquals("srgb", curve(profile("A2B0", new byte[12], "sRGB v4")));
        assertEquals("-", curve(profile("A2B0", new byte[12], "Printer")));
    }
}
