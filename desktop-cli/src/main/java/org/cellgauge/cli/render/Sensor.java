package org.cellgauge.cli.render;

/**
 * How a scene becomes a picture: blur of the lens, fall-off of the light, noise and tone curve of the sensor.
 *
 * @param blurPx standard deviation of the Gaussian point spread function, px, 0 to 20; it acts on linear light, beside
 *     the averaging over each pixel's area
 * @param noiseGrey standard deviation of the additive noise, grey levels, at least 0
 * @param fullWellElectrons electrons at full scale, which give shot noise of standard deviation {@code sqrt(electrons)}
 *     (Poisson's, in its normal approximation); 0: no shot noise
 * @param gamma tone curve: grey = 255 light^(1/gamma), positive; 1 is a linear sensor
 * @param vignetting share of the light lost in the corners of the image against its centre, 0 to 0.9 (quadratic)
 * @param gradient change of the light from the left edge of the image to the right as a share of its mean, -1 to 1;
 *     half as much from top to bottom
 */
public record Sensor(double blurPx, double noiseGrey, double fullWellElectrons, double gamma, double vignetting,
        double gradient) {
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
        require(gamma >= 0.1 && gamma <= 10, "gamma must be between 0.1 and 10", gamma);
        require(vignetting >= 0 && vignetting <= 0.9, "vignetting must be between 0 and 0.9", vignetting);
        require(gradient >= -1 && gradient <= 1, "gradient must be between -1 and 1", gradient);
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
        return new Sensor(px, noiseGrey, fullWellElectrons, gamma, vignetting, gradient);
    }

    /**
     * The same sensor with another noise.
     *
     * @param grey standard deviation, grey levels
     * @return a new sensor
     */
    public Sensor withNoiseGrey(double grey) {
        return new Sensor(blurPx, grey, fullWellElectrons, gamma, vignetting, gradient);
    }

    /**
     * The same sensor with shot noise.
     *
     * @param electrons at full scale; 0: none
     * @return a new sensor
     */
    public Sensor withFullWellElectrons(double electrons) {
        return new Sensor(blurPx, noiseGrey, electrons, gamma, vignetting, gradient);
    }

    /**
     * The same sensor with another tone curve.
     *
     * @param value gamma
     * @return a new sensor
     */
    public Sensor withGamma(double value) {
        return new Sensor(blurPx, noiseGrey, fullWellElectrons, value, vignetting, gradient);
    }
}
