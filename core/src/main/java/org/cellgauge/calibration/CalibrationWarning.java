package org.cellgauge.calibration;

import org.cellgauge.warning.WarningKind;

/** What users of a calibration should know. */
public enum CalibrationWarning implements WarningKind {
    /** Photos without the target: names. */
    NOT_FOUND("the target was not found in %s"),
    /** Points were left out: how many, of how many, the photos with most of them. */
    OUTLIERS("%s of %s corners were left out because they are off by more than 4 standard deviations, most of them in "
            + "%s"),
    /** Too many points were left out: per cent. */
    IN_QUESTION("%s %% of the corners had to be left out, which is more than mistakes of detection account for: the "
            + "calibration is in question; look at the photos named"),
    /** Photos that contradict the others: names. */
    CONTRADICTS("the other photos contradict %s: the target moved or bent, or focus or zoom changed; leave out what is "
            + "named, or take it again"),
    /** Photos that tell next to nothing: names. */
    ADDS_LITTLE("next to nothing comes from %s to what the other photos tell"),
    /** Odd and even photos calibrate to different cameras: ratio, factor of the deviations. */
    MODEL_ERROR("calibrations of the odd and of the even photos differ by %s times what chance makes likely: lens "
            + "model or target are wrong by more than the corners' noise. The stated deviations are widened by %s"),
    /** Odd and even photos differ somewhat: ratio. */
    SOME_MODEL_ERROR("calibrations of the odd and of the even photos differ by %s times what chance makes likely: "
            + "chance is possible, a small error of lens model or target too"),
    /** The board is taken for flat and is bent: by how much, its deviation, mm. */
    BENT("the target is taken for flat and is bent, by %s mm (give or take %s mm): the stated deviations are far too "
            + "small; let its warp be unknown, or lay it on glass"),
    /** The board is bent otherwise than modelled: by how much, its deviation, mm. */
    BENT_OTHERWISE("the target is bent or twisted otherwise than its two coefficients of warp can follow, by %s mm "
            + "(give or take %s mm): the stated deviations are too small; let all five be unknown, or lay it on glass"),
    /** Other lenses explain photos held out about as well: the chosen lens, the others, their weight, %. */
    LENS_OPEN("the photos do not decide between %s and %s, which explain photos held out about as well (weight %s %%): "
            + "the stated deviations allow for both; name the lens model where it is known, or take more photos"),
    /** Too few photos for the gate: how many it takes. */
    NOT_CROSS_VALIDATED("too few photos to calibrate odd and even ones apart: nothing tells an error of the lens "
            + "model; take at least %s"),
    /** Half of the photos do not tell the lens: its name. */
    HALVES_DO_NOT_TELL("the odd or the even photos alone do not tell the coefficients of the lens %s, so nothing tells "
            + "an error of the lens model: take more photos, or name a leaner lens"),
    /** Parts of the image without any point: per cent, where the largest is. */
    NOT_COVERED("%s %% of the image were never covered by the target, most of it %s: what is said of these parts is "
            + "extrapolated"),
    /** All photos from one distance: ratio of the farthest to the nearest. */
    ONE_DISTANCE("all photos are from nearly one distance (farthest to nearest %s): take some from half and from twice "
            + "as far"),
    /** Few tilts: how many photos are tilted by more than 20 degrees. */
    FEW_TILTS("the target is tilted by more than 20 degrees in %s photos only: focal length and distance are hard to "
            + "tell apart; tilt it by 30 to 45 degrees to all sides"),
    /** A field of view no usual lens has: degrees. */
    ODD_FIELD_OF_VIEW("the field of view comes out as %s degrees, which hardly any lens has: check the target file"),

    /** What would help most: where in the image, how far, how it is tilted. */
    NEXT_PHOTO("take one more photo with the target %s, %s, %s");

    private final String english;

    CalibrationWarning(String english) {
        this.english = english;
    }

    @Override
    public String code() {
        return "calibration-" + WarningKind.super.code();
    }

    @Override
    public String english() {
        return english;
    }
}
