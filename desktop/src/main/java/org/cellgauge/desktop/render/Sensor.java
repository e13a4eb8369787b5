package org.cellgauge.desktop.render;

import org.cellgauge.light.ToneCurve;

/**
 * How a scene becomes a picture: blur of the lens, fall-off of the light, exposure, noise, tone curve and sharpening.
 *
 * <p>In this order: light is blurred, falls off towards the edges of the image, is multiplied by the exposure and gets
 * shot noise; the tone curve makes grey of it; black level and additive noise come on top; what is beyond black or
 * white is cut off there; the unsharp mask works on what is left, and its result is cut off and rounded to 8 bits.
 *
 * @param blurPx standard deviation of the Gaussian point spread function, px, 0 to 20; it acts on linear light, beside
 *     the averaging over each pixel's area
 * @param noiseGrey standard deviation of the additive noise, grey levels, at least 0; an unsharp mask amplifies it
 * @param fullWellElectrons electrons at full scale, which give shot noise of standard deviation {@code sqrt(electrons)}
 *     (Poisson's, in its normal approximation); 0: no shot noise
 * @param toneCurve grey of light
 * @param exposure what light is multiplied by, 0.001 to 1000; 1: a surface of reflectance 1 in full light is white, and
 *     what is brighter is white, too
 * @param unsharpAmount share of the difference to its own blurred copy that is added to the grey image, 0 to 10; 0: no
 *     unsharp mask
 * @param unsharpRadiusPx standard deviation of the Gaussian that makes this copy, px, positive and at most 20
 * @param vignetting share of the light lost in the corners of the image against its centre, 0 to 0.9 (quadratic)
 * @param gradient change of the light from the left edge of the image to the right as a share of its mean, -1 to 1;
 *     half as much from top to bottom
 * @param blackLevelGrey what is added to every grey value, grey levels, -100 to 100; below 0 the darkest is cut off
 * @param clipGrey grey value at which the sensor is full, 100 to 255
 */
public record Sensor(double blurPx, double noiseGrey, double fullWellElectrons, ToneCurve toneCurve, double exposure,
        double unsharpAmount, double unsharpRadiusPx, double vignetting, double gradient, double blackLevelGrey,
        double clipGrey) {
    private static final double WHITE_GREY = 255;
    /** Sharp, without noise, linear, evenly lit: the picture holds nothing but the scene's geometry. */
    public static final Sensor IDEAL = new Sensor(0, 0, 0, 1, 0, 0);
    /** A usual industrial camera in focus: blur 0.7 px, noise 2 grey levels, some fall-off of the light. */
    public static final Sensor USUAL = new Sensor(0.7, 2, 0, 1, 0.15, 0.1);

    /**
     * Checks the ranges.
     *
     * @throws IllegalArgumentException if a value is outside its range
     */
    public Sensor {
        require(blurPx >= 0 && blurPx <= 20, "blur must be between 0 and 20 px", blurPx);
        require(noiseGrey >= 0 && noiseGrey <= 255, "noise must be between 0 and 255 grey levels", noiseGrey);
        require(fullWellElectrons >= 0 && Double.isFinite(fullWellElectrons), "full well must be at least 0 electrons",
                fullWellElectrons);
        require(exposure >= 1e-3 && exposure <= 1e3, "exposure must be between 0.001 and 1000", exposure);
        require(unsharpAmount >= 0 && unsharpAmount <= 10, "amount of the unsharp mask must be between 0 and 10",
                unsharpAmount);
        require(unsharpRadiusPx > 0 && unsharpRadiusPx <= 20, "radius of the unsharp mask must be positive and at most "
                + "20 px", unsharpRadiusPx);
        require(vignetting >= 0 && vignetting <= 0.9, "vignetting must be between 0 and 0.9", vignetting);
        require(gradient >= -1 && gradient <= 1, "gradient must be between -1 and 1", gradient);
        require(blackLevelGrey >= -100 && blackLevelGrey <= 100, "black level must be between -100 and 100 grey levels",
                blackLevelGrey);
        require(clipGrey >= 100 && clipGrey <= 255, "clipping must be at a grey value between 100 and 255", clipGrey);
    }

    /**
     * A sensor of exposure 1 without an unsharp mask.
     *
     * @param blurPx as above
     * @param noiseGrey as above
     * @param fullWellElectrons as above
     * @param gamma tone curve: grey = light^(1/gamma); 1 is a linear sensor
     * @param vignetting as above
     * @param gradient as above
     * @throws IllegalArgumentException if a value is outside its range
     */
    public Sensor(double blurPx, double noiseGrey, double fullWellElectrons, double gamma, double vignetting,
            double gradient) {
        this(blurPx, noiseGrey, fullWellElectrons, ToneCurve.gamma(gamma), 1, 0, 1, vignetting, gradient, 0,
                WHITE_GREY);
    }

    private static void require(boolean holds, String rule, double value) {
        if (!holds) {
            throw new IllegalArgumentException(rule + ", not " + value);
        }
    }

    /**
     * The same sensor with another blur.
     *
     * @param px standard deviation of the point spread function, px
     * @return a new sensor
     */
    public Sensor withBlurPx(double px) {
        return new Sensor(px, noiseGrey, fullWellElectrons, toneCurve, exposure, unsharpAmount, unsharpRadiusPx,
                vignetting, gradient, blackLevelGrey, clipGrey);
    }

    /**
     * The same sensor with another noise.
     *
     * @param grey standard deviation, grey levels
     * @return a new sensor
     */
    public Sensor withNoiseGrey(double grey) {
        return new Sensor(blurPx, grey, fullWellElectrons, toneCurve, exposure, unsharpAmount, unsharpRadiusPx,
                vignetting, gradient, blackLevelGrey, clipGrey);
    }

    /**
     * The same sensor with shot noise.
     *
     * @param electrons at full scale; 0: none
     * @return a new sensor
     */
    public Sensor withFullWellElectrons(double electrons) {
        return new Sensor(blurPx, noiseGrey, electrons, toneCurve, exposure, unsharpAmount, unsharpRadiusPx,
                vignetting, gradient, blackLevelGrey, clipGrey);
    }

    /**
     * The same sensor with another tone curve.
     *
     * @param value gamma
     * @return a new sensor
     */
    public Sensor withGamma(double value) {
        return withToneCurve(ToneCurve.gamma(value));
    }

    /**
     * The same sensor with another tone curve.
     *
     * @param curve grey of light
     * @return a new sensor
     */
    public Sensor withToneCurve(ToneCurve curve) {
        return new Sensor(blurPx, noiseGrey, fullWellElectrons, curve, exposure, unsharpAmount, unsharpRadiusPx,
                vignetting, gradient, blackLevelGrey, clipGrey);
    }

    /**
     * The same sensor with another exposure.
     *
     * @param factor what light is multiplied by
     * @return a new sensor
     */
    public Sensor withExposure(double factor) {
        return new Sensor(blurPx, noiseGrey, fullWellElectrons, toneCurve, factor, unsharpAmount, unsharpRadiusPx,
                vignetting, gradient, blackLevelGrey, clipGrey);
    }

    /**
     * The same sensor with another unsharp mask.
     *
     * @param amount share of the difference to the blurred copy that is added; 0: none
     * @param radiusPx standard deviation of the Gaussian that makes this copy, px
     * @return a new sensor
     */
    public Sensor withUnsharp(double amount, double radiusPx) {
        return new Sensor(blurPx, noiseGrey, fullWellElectrons, toneCurve, exposure, amount, radiusPx, vignetting,
                gradient, blackLevelGrey, clipGrey);
    }

    /**
     * The same sensor in other light.
     *
     * @param corners share of the light that the image's corners lose
     * @param leftToRight change of the light from left to right as a share of its mean
     * @return a new sensor
     */
    public Sensor withUnevenLight(double corners, double leftToRight) {
        return new Sensor(blurPx, noiseGrey, fullWellElectrons, toneCurve, exposure, unsharpAmount, unsharpRadiusPx,
                corners, leftToRight, blackLevelGrey, clipGrey);
    }

    /**
     * The same sensor with other ends of its scale.
     *
     * @param blackGrey what is added to every grey value, grey levels
     * @param fullGrey grey value at which the sensor is full
     * @return a new sensor
     */
    public Sensor withScale(double blackGrey, double fullGrey) {
        return new Sensor(blurPx, noiseGrey, fullWellElectrons, toneCurve, exposure, unsharpAmount, unsharpRadiusPx,
                vignetting, gradient, blackGrey, fullGrey);
    }

    /** A grey value that a pixel can have: what is beyond the sensor's ends is cut off. */
    double cutOff(double grey) {
        return Math.min(clipGrey, Math.max(0, grey));
    }
}
