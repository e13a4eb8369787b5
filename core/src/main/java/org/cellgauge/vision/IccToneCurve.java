package org.cellgauge.vision;

import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import org.cellgauge.light.ToneCurve;

/**
 * The tone curve of a colour profile, from its tone reproduction curves.
 *
 * <p>Format: ICC.1:2022 (profile version 4.4), sections 7.2 (header), 7.3 (tag table), 9.2 (tags), 10.6
 * (curveType) and 10.18 (parametricCurveType); version 2 profiles are alike in all that is read here.
 */
public final class IccToneCurve {
    private static final int HEADER_BYTES = 128;
    private static final int TAG_BYTES = 12;
    private static final int MAX_TAGS = 1000;
    private static final int GREY_CURVE = 0x6B545243;
    private static final int GREEN_CURVE = 0x67545243;
    private static final int DESCRIPTION = 0x64657363;
    private static final int TABLE = 0x63757276;
    private static final int PARAMETRIC = 0x70617261;
    private static final int CURVE_DATA = 12;
    /** Parameters of the parametric curves of each kind. */
    private static final int[] PARAMETERS = {1, 3, 4, 5, 7};
    private static final int SAMPLES = 256;
    /** Largest distance in light from sRGB's curve; a plain gamma of 2.2 is 0.008 away. */
    private static final double SRGB_TOLERANCE = 0.002;
    /** Largest distance in light of a curve that a power may stand for, as a start. */
    private static final double POWER_TOLERANCE = 0.05;
    private static final double LEAST_GREY = 0.1;
    private static final double LARGEST_GREY = 0.95;

    private IccToneCurve() {
    }

    /**
     * The curve of a profile.
     *
     * @param profile bytes of the profile
     * @return the curve of grey, or of green where there are colours: sRGB's, or the power nearest to it; null where
     *     there is none, or none that a power comes near
     * @throws RuntimeException if the profile is damaged
     */
    public static ToneCurve of(byte[] profile) {
        ByteBuffer data = ByteBuffer.wrap(profile);
        int tags = Math.min(data.getInt(HEADER_BYTES), MAX_TAGS);
        ToneCurve grey = null;
        ToneCurve green = null;
        boolean named = false;
        for (int i = 0; i < tags; i++) {
            int at = HEADER_BYTES + 4 + TAG_BYTES * i;
            int offset = data.getInt(at + 4);
            int length = data.getInt(at + 8);
            int tag = data.getInt(at);
            if (tag == GREY_CURVE) {
                grey = curve(slice(profile, offset, length));
            } else if (tag == GREEN_CURVE) {
                green = curve(slice(profile, offset, length));
            } else if (tag == DESCRIPTION) {
                named = isNamedSrgb(profile, offset, length);
            }
        }
        if (grey == null && green == null) {
            // tables of many dimensions only, as the "preference" profile of sRGB has them
            return named ? ToneCurve.SRGB : null;
        }
        return grey != null ? grey : green;
    }

    private static ByteBuffer slice(byte[] profile, int offset, int length) {
        return ByteBuffer.wrap(profile, offset, length).slice();
    }

    /** Names are ASCII in version 2 and UTF-16 in version 4; without its zeros either is readable. */
    private static boolean isNamedSrgb(byte[] profile, int offset, int length) {
        return new String(profile, offset, length, StandardCharsets.ISO_8859_1).replace("\0", "").contains("sRGB");
    }

    private static ToneCurve curve(ByteBuffer data) {
        int type = data.getInt(0);
        if (type == TABLE) {
            int count = data.getInt(8);
            if (count == 0) {
                return ToneCurve.LINEAR;
            }
            if (count == 1) {
                return gamma((data.getShort(CURVE_DATA) & 0xFFFF) / 256.0);
            }
            return nearest(table(data, count));
        }
        if (type == PARAMETRIC) {
            int kind = data.getShort(8);
            double[] p = new double[PARAMETERS[kind]];
            for (int i = 0; i < p.length; i++) {
                p[i] = data.getInt(CURVE_DATA + 4 * i) / 65536.0;
            }
            return kind == 0 ? gamma(p[0]) : nearest(parametric(kind, p));
        }
        return null;
    }

    /** Light at equal steps of grey, of a table of 16-bit values. */
    private static double[] table(ByteBuffer data, int count) {
        double[] light = new double[SAMPLES];
        for (int i = 0; i < SAMPLES; i++) {
            double at = i * (count - 1.0) / (SAMPLES - 1);
            int below = Math.min((int) at, count - 2);
            double low = data.getShort(CURVE_DATA + 2 * below) & 0xFFFF;
            double high = data.getShort(CURVE_DATA + 2 * below + 2) & 0xFFFF;
            light[i] = (low + (at - below) * (high - low)) / 65535;
        }
        return light;
    }

    /** Light at equal steps of grey, of the curves of Table 68: g, a, b, c, d, e, f in this order. */
    private static double[] parametric(int kind, double[] p) {
        double g = p[0];
        double a = p[1];
        double b = p[2];
        double toe = kind >= 3 ? p[3] : 0;
        double from = kind >= 3 ? p[4] : -b / a;
        double above = kind == 2 ? p[3] : kind == 4 ? p[5] : 0;
        double below = kind == 2 ? p[3] : kind == 4 ? p[6] : 0;
        double[] light = new double[SAMPLES];
        for (int i = 0; i < SAMPLES; i++) {
            double grey = i / (SAMPLES - 1.0);
            light[i] = grey >= from ? Math.pow(a * grey + b, g) + above : toe * grey + below;
        }
        return light;
    }

    /** sRGB's curve where it is that, else the power that comes nearest. */
    private static ToneCurve nearest(double[] light) {
        double fromSrgb = 0;
        double logs = 0;
        double squares = 0;
        for (int i = 0; i < SAMPLES; i++) {
            double grey = i / (SAMPLES - 1.0);
            fromSrgb = Math.max(fromSrgb, Math.abs(light[i] - ToneCurve.SRGB.light(grey)));
            if (grey > LEAST_GREY && grey < LARGEST_GREY) {
                // log light = gamma log grey, each value with the weight that its error in light has
                double weight = light[i] * light[i];
                logs += weight * Math.log(light[i]) * Math.log(grey);
                squares += weight * Math.log(grey) * Math.log(grey);
            }
        }
        if (fromSrgb < SRGB_TOLERANCE) {
            return ToneCurve.SRGB;
        }
        ToneCurve power = gamma(logs / squares);
        for (int i = 0; power != null && i < SAMPLES; i++) {
            if (!(Math.abs(light[i] - power.light(i / (SAMPLES - 1.0))) < POWER_TOLERANCE)) {
                return null;
            }
        }
        return power;
    }

    /**
     * A power as files mean it: fixed-point numbers such as 2.19922 or 1/0.45455 stand for 2.2.
     *
     * @param gamma light = grey^gamma
     * @return the curve, or null where no camera has it
     */
    public static ToneCurve gamma(double gamma) {
        double meant = Math.rint(100 * gamma) / 100;
        return meant >= ToneCurve.LEAST_GAMMA && meant <= ToneCurve.LARGEST_GAMMA ? ToneCurve.gamma(meant) : null;
    }
}
