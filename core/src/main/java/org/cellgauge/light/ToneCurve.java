package org.cellgauge.light;

import java.util.Locale;

/**
 * How a camera makes grey values of light: {@code grey = curve(light)}, both from 0 (black) to 1 (white); immutable.
 *
 * <p>Optics blur light and the curve comes after it, so half of a blurred edge's grey is not half of its light: 0.22 of
 * it at gamma 2.2. Whoever looks for edges in grey values finds them too far on the dark side.
 */
public final class ToneCurve {
    /** Grey is light, as raw and machine-vision formats have it. */
    public static final ToneCurve LINEAR = new ToneCurve(Kind.GAMMA, 1);
    /** The curve of sRGB (IEC 61966-2-1): a straight toe, then a power of 2.4. */
    public static final ToneCurve SRGB = new ToneCurve(Kind.SRGB, 2.4);
    /** Smallest gamma that is believed of a camera. */
    public static final double LEAST_GAMMA = 0.2;
    /** Largest gamma that is believed of a camera. */
    public static final double LARGEST_GAMMA = 5;

    private static final double SRGB_TOE_GREY = 0.04045;
    private static final double SRGB_OFFSET = 0.055;

    private enum Kind { GAMMA, SRGB }

    private final Kind kind;
    private final double gamma;
    /** Light at which the straight toe ends. */
    private final double toeLight;

    private ToneCurve(Kind kind, double gamma) {
        this.kind = kind;
        this.gamma = gamma;
        toeLight = Math.pow((SRGB_TOE_GREY + SRGB_OFFSET) / (1 + SRGB_OFFSET), gamma);
    }

    /**
     * A power: grey = light^(1/gamma).
     *
     * @param gamma {@value #LEAST_GAMMA} to {@value #LARGEST_GAMMA}; 1 is {@link #LINEAR}
     * @return the curve
     * @throws IllegalArgumentException if gamma is outside its range
     */
    public static ToneCurve gamma(double gamma) {
        if (!(gamma >= LEAST_GAMMA && gamma <= LARGEST_GAMMA)) {
            throw new IllegalArgumentException("gamma must be between " + LEAST_GAMMA + " and " + LARGEST_GAMMA
                    + ", not " + gamma);
        }
        return gamma == 1 ? LINEAR : new ToneCurve(Kind.GAMMA, gamma);
    }

    /**
     * A curve like sRGB's with another power: what cameras make that follow sRGB more or less.
     *
     * @param power {@value #LEAST_GAMMA} to {@value #LARGEST_GAMMA}; 2.4 is {@link #SRGB}
     * @return the curve, with a straight toe where sRGB has one
     * @throws IllegalArgumentException if the power is outside its range
     */
    public static ToneCurve srgb(double power) {
        if (!(power >= LEAST_GAMMA && power <= LARGEST_GAMMA)) {
            throw new IllegalArgumentException("power must be between " + LEAST_GAMMA + " and " + LARGEST_GAMMA
                    + ", not " + power);
        }
        return power == SRGB.gamma ? SRGB : new ToneCurve(Kind.SRGB, power);
    }

    /**
     * The curve of its words in files and options.
     *
     * @param words {@code srgb}, {@code linear}, {@code gamma G} or {@code srgb G}, G a number
     * @return the curve
     * @throws IllegalArgumentException if the words are none of these; the message says what may stand there
     */
    public static ToneCurve of(String words) {
        String text = words.trim().toLowerCase(Locale.ROOT);
        if (text.equals("srgb")) {
            return SRGB;
        }
        if (text.equals("linear")) {
            return LINEAR;
        }
        boolean likeSrgb = text.startsWith("srgb ");
        if (text.startsWith("gamma ") || likeSrgb) {
            try {
                double value = Double.parseDouble(text.substring(text.indexOf(' ')).trim());
                return likeSrgb ? srgb(value) : gamma(value);
            } catch (NumberFormatException e) {
                // said below
            }
        }
        throw new IllegalArgumentException("'" + words + "' is no tone curve; write srgb, linear or gamma G, for "
                + "instance gamma 2.2");
    }

    /**
     * Grey of light.
     *
     * @param light any value; below 0 counts as 0, above 1 the curve goes on
     * @return grey, 0 to 1 for light from 0 to 1
     */
    public double grey(double light) {
        if (!(light > 0)) {
            return 0;
        }
        if (kind == Kind.SRGB) {
            return light <= toeLight ? SRGB_TOE_GREY * light / toeLight
                    : (1 + SRGB_OFFSET) * Math.pow(light, 1 / gamma) - SRGB_OFFSET;
        }
        return gamma == 1 ? light : Math.pow(light, 1 / gamma);
    }

    /**
     * Light of grey: the inverse of {@link #grey(double)}.
     *
     * @param grey any value; below 0 counts as 0, above 1 the curve goes on
     * @return light, 0 to 1 for grey from 0 to 1
     */
    public double light(double grey) {
        if (!(grey > 0)) {
            return 0;
        }
        if (kind == Kind.SRGB) {
            return grey <= SRGB_TOE_GREY ? toeLight * grey / SRGB_TOE_GREY
                    : Math.pow((grey + SRGB_OFFSET) / (1 + SRGB_OFFSET), gamma);
        }
        return gamma == 1 ? grey : Math.pow(grey, gamma);
    }

    /**
     * How fast light changes with grey.
     *
     * @param grey any value; below 0 light does not change
     * @param light the light of it, as {@link #light} has it
     * @return derivative of the light by the grey; that of the toe where the toe ends
     */
    public double lightByGrey(double grey, double light) {
        if (!(grey > 0)) {
            return 0;
        }
        if (kind == Kind.SRGB) {
            return grey <= SRGB_TOE_GREY ? toeLight / SRGB_TOE_GREY : gamma * light / (grey + SRGB_OFFSET);
        }
        return gamma * light / grey;
    }

    /**
     * Whether a grey lies on a straight toe, where the curve is no power.
     *
     * @param grey any value
     * @return true for dark greys of sRGB and its kind
     */
    public boolean isToe(double grey) {
        return kind == Kind.SRGB && grey <= SRGB_TOE_GREY;
    }

    /**
     * How fast grey changes with the power of the curve while the grey of black and white stays: what an estimate of
     * the power goes by.
     *
     * @param darkGrey grey of black, above 0
     * @param brightGrey grey of white, above it
     * @param share of the light between black and white
     * @return grey per unit of {@link #power()}
     */
    public double greyByPower(double darkGrey, double brightGrey, double share) {
        double offset = offset();
        double dark = (darkGrey + offset) / (1 + offset);
        double bright = (brightGrey + offset) / (1 + offset);
        double lightDark = Math.pow(dark, gamma);
        double lightBright = Math.pow(bright, gamma);
        double light = Math.max(1e-7, lightDark + (lightBright - lightDark) * share);
        double change = lightDark * Math.log(dark) * (1 - share) + lightBright * Math.log(bright) * share;
        return (1 + offset) * Math.pow(light, 1 / gamma) * (change / (gamma * light)
                - Math.log(light) / (gamma * gamma));
    }

    /**
     * The power of the curve.
     *
     * @return gamma of a power; 2.4 of sRGB
     */
    public double power() {
        return gamma;
    }

    /**
     * What is added to grey before the power is taken, as a share of white.
     *
     * @return 0.055 of sRGB and its kind, 0 of a plain power
     */
    public double offset() {
        return kind == Kind.SRGB ? SRGB_OFFSET : 0;
    }

    /**
     * The curve of the same kind with another power.
     *
     * @param power {@value #LEAST_GAMMA} to {@value #LARGEST_GAMMA}
     * @return sRGB's kind for one of that kind, else a plain power
     */
    public ToneCurve withPower(double power) {
        return kind == Kind.SRGB ? srgb(power) : gamma(power);
    }

    /**
     * Whether grey is light.
     *
     * @return true for {@link #LINEAR}
     */
    public boolean isLinear() {
        return this == LINEAR;
    }

    /**
     * The curve in the words that {@link #of(String)} reads.
     *
     * @return for instance {@code gamma 2.2}
     */
    public String words() {
        if (isLinear()) {
            return "linear";
        }
        return kind == Kind.SRGB ? (this == SRGB ? "srgb" : "srgb " + gamma) : "gamma " + gamma;
    }

    @Override
    public String toString() {
        return words();
    }
}
