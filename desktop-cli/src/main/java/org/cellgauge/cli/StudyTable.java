package org.cellgauge.cli;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import org.cellgauge.light.ToneCurve;
import org.cellgauge.settings.Setting;
import org.cellgauge.settings.SettingForm;
import org.cellgauge.settings.SettingForm.UnreadableException;
import org.cellgauge.settings.SettingRefusal;
import org.cellgauge.settings.SettingSource;
import org.cellgauge.settings.Word;

/**
 * What determines the figures of {@code validate} besides the cell, its nominal poses and the settings of the checks:
 * options, ranges, JSON and the command that repeats them are made from these rows.
 */
final class StudyTable {
    /** Number of simulated cells. */
    static final Setting<Integer> SIMULATIONS = Setting.of("simulations", SettingForm.whole("N"), 200,
            "Number of simulated cells")
            .within(n -> n >= 1 && n <= 1_000_000, SettingRefusal.NOT_BETWEEN, 1, 1_000_000);

    /** Whether photos are rendered. */
    static final Setting<Boolean> PHOTOS = Setting.of("photos", SettingForm.flag(), false,
            "Renders a photo of every simulated cell and runs the whole way, detection included");

    /** Whether every simulation has a layout of its own. */
    static final Setting<Boolean> RANDOM_LAYOUTS = Setting.of("random_layouts", SettingForm.flag(), false,
            "A new layout for every simulation in place of one cell: 2 to 12 references anywhere in view, tilted and "
                    + "raised, sizes 30 to 120 mm, focal lengths 400 to 2000 px, with and without distortion, "
                    + "placement drawn, too");

    /** Standard deviation of the true poses, mm and degrees. */
    static final Setting<NumberPair> SPREAD = Setting.of("spread_mm_deg",
            SettingForm.of("MM,DEG", text -> pair(text, StudyRefusal.NO_SPREAD), NumberPair::toString,
                    NumberPair::toString), new NumberPair(50, 10),
            "Standard deviation of the true poses about the nominal ones, from simulation to simulation: the camera "
                    + "swings about the references, objects move before the camera; with 0,0 the truth is the same in "
                    + "all; at most the distance from camera to references, and below 57 degrees")
            .named("spread").where(settings -> !settings.get(RANDOM_LAYOUTS))
            .within(pair -> pair.first() >= 0 && pair.second() >= 0, StudyRefusal.NEGATIVE_SPREAD);

    /** Corner noise that is simulated without photos. */
    static final Setting<OptionalDouble> PIXEL_STD_PX = Setting.of("pixel_std_px", SettingForm.numberOrOpen("PX"),
            OptionalDouble.empty(),
            "Corner noise that is simulated, where it is to differ from the pixel_std_px of the cell file, or "
                    + "that is auto")
            .in("px").where(settings -> !settings.get(PHOTOS)).within(StudyTable::positive,
                    SettingRefusal.NOT_POSITIVE_IN, "px");

    /** Photos of a board that the camera of every simulated cell is calibrated from. */
    static final Setting<OptionalInt> CALIBRATION_PHOTOS = Setting.of("calibration_photos",
            SettingForm.wholeOrOpen("N"), OptionalInt.empty(),
            "Calibrates the camera of every simulated cell from N simulated photos of a board, and checks with what "
                    + "comes of it; the true camera is the cell file's in all, and what that says of a calibration "
                    + "does not count")
            .usually("none").where(settings -> !settings.get(PHOTOS) && !settings.get(RANDOM_LAYOUTS))
            .within(n -> n.orElse(8) >= 8 && n.orElse(8) <= 200, SettingRefusal.NOT_BETWEEN, 8, 200);

    /** Corners that are far off: their share, and by how many deviations of the corner noise. */
    static final Setting<Optional<NumberPair>> OUTLIERS = Setting.of("outliers",
            SettingForm.of("SHARE,DEVIATIONS", text -> Optional.of(pair(text, StudyRefusal.NO_OUTLIERS)),
                    pair -> pair.map(NumberPair::toString).orElse(null),
                    pair -> pair.map(NumberPair::toString).orElse("")), Optional.<NumberPair>empty(),
            "Corners that are far off, as by a smudge or a glint: which share of all, and by how many deviations of "
                    + "the corner noise, in any direction; ranks are not counted then")
            .usually("none").where(settings -> !settings.get(PHOTOS))
            .within(pair -> pair.isEmpty() || pair.get().first() >= 0 && pair.get().first() <= 1
                    && pair.get().second() >= 0, StudyRefusal.OUTLIERS_OUT_OF_RANGE);

    /** Whether the grid of photos is gone through. */
    static final Setting<Boolean> GRID = Setting.of("grid", SettingForm.flag(), false,
            "With --photos: a row for each combination of tone curve, blur, size of markers and exposure, and some "
                    + "for JPEG, uneven light, prints and AprilTags, as a table in Markdown")
            .where(StudyTable::ofPhotos);

    /** Whether corners are compared and nothing is checked. */
    static final Setting<Boolean> CORNERS_ONLY = Setting.of("corners_only", SettingForm.flag(), false,
            "With --photos: finds the markers and compares their corners with the truth, but checks nothing: some "
                    + "three times as fast")
            .where(StudyTable::ofPhotos);

    /** Whether prints are exact. */
    static final Setting<Boolean> EXACT_OUTLINES = Setting.of("exact_outlines", SettingForm.flag(), false,
            "With --photos: prints are exact. Else the sides of all markers of a photo lie off their places, alike, by "
                    + "a draw from what a check allows for that inner edges do not show")
            .where(StudyTable::ofPhotos);

    /** Tone curve of the camera. */
    static final Setting<ToneCurve> TONE_CURVE = Setting.of("tone_curve",
            SettingForm.of("srgb|linear|\"gamma G\"", StudyTable::toneCurve, ToneCurve::words, ToneCurve::words),
            ToneCurve.SRGB, "With --photos: tone curve of the camera")
            .usually("srgb").where(StudyTable::ofPhotos);

    /** Blur of the photos. */
    static final Setting<Double> BLUR_PX = Setting.of("blur_px", SettingForm.number("PX"), 0.7,
            "With --photos: standard deviation of the blur, px")
            .where(StudyTable::ofPhotos)
            .within(px -> px >= 0 && px <= 20, SettingRefusal.NOT_BETWEEN, 0, 20);

    /** Average side of the markers in the image. */
    static final Setting<OptionalDouble> MARKER_PX = Setting.of("marker_px", SettingForm.numberOrOpen("N"),
            OptionalDouble.empty(),
            "With --photos: moves the camera along its line of sight until the sides of the cell's markers are N px "
                    + "long on average")
            .where(StudyTable::ofPhotos).within(StudyTable::positive, SettingRefusal.NOT_POSITIVE_IN, "px");

    /** Exposures by name: what light is multiplied by; white paper has a reflectance of 0.85, black print 0.05. */
    enum Exposure implements Word {
        /** Paper at 0.85 of full scale. */
        NORMAL(1),
        /** Paper, and the wall of 0.55, far beyond full scale; black at 0.1 of it. */
        CLIPPED(1.95),
        /** Paper at 0.085 of full scale. */
        DARK(0.1);

        final double factor;

        Exposure(double factor) {
            this.factor = factor;
        }

        @Override
        public String word() {
            return name().toLowerCase(Locale.ROOT);
        }
    }

    /** Exposure of the photos. */
    static final Setting<Exposure> EXPOSURE = Setting.of("exposure", SettingForm.choice(Exposure.values()),
            Exposure.NORMAL,
            "With --photos: light times 1 (white paper at 0.85 of full scale), 1.95 (paper and wall clipped) or 0.1")
            .where(StudyTable::ofPhotos);

    /** Quality of a JPEG file that photos go through. */
    static final Setting<OptionalInt> JPEG_QUALITY = Setting.of("jpeg_quality", SettingForm.wholeOrOpen("QUALITY"),
            OptionalInt.empty(), "With --photos: through a JPEG file of this quality")
            .named("jpeg").usually("none").where(StudyTable::ofPhotos)
            .within(q -> q.orElse(1) >= 1 && q.orElse(1) <= 100, SettingRefusal.NOT_BETWEEN, 1, 100);

    /** Unsharp mask of the camera: amount, radius in px. */
    static final Setting<Optional<NumberPair>> UNSHARP = Setting.of("unsharp",
            SettingForm.of("AMOUNT,RADIUS_PX", text -> Optional.of(pair(text, StudyRefusal.NO_UNSHARP_MASK)),
                    pair -> pair.map(NumberPair::toString).orElse(null),
                    pair -> pair.map(NumberPair::toString).orElse("")), Optional.<NumberPair>empty(),
            "With --photos: through an unsharp mask")
            .usually("none").where(StudyTable::ofPhotos)
            .within(mask -> mask.isEmpty() || mask.get().first() >= 0 && mask.get().first() <= 10
                    && mask.get().second() > 0 && mask.get().second() <= 20, StudyRefusal.UNSHARP_MASK_TOO_STRONG);

    /** Gain of the prints. */
    static final Setting<Double> PRINT_GAIN_MM = Setting.of("print_gain_mm", SettingForm.number("MM"), 0.0,
            "With --photos: dark regions of prints are larger by MM on all sides")
            .in("mm").where(StudyTable::ofPhotos);

    /** Change of the light across the image. */
    static final Setting<Double> GRADIENT = Setting.of("gradient", SettingForm.number("SHARE"), 0.1,
            "With --photos: change of the light from left to right")
            .where(StudyTable::ofPhotos)
            .within(share -> share >= -1 && share <= 1, SettingRefusal.NOT_BETWEEN, -1, 1);

    /** Noise of the photos. */
    static final Setting<Double> NOISE_GREY = Setting.of("noise_grey", SettingForm.number("GREY"), 2.0,
            "With --photos: standard deviation of the noise in grey levels of 255")
            .named("noise").where(StudyTable::ofPhotos)
            .within(grey -> grey >= 0 && grey <= 255, SettingRefusal.NOT_BETWEEN, 0, 255);

    /** Full well, from which shot noise follows; 0 is none. */
    static final Setting<Double> FULL_WELL_ELECTRONS = Setting.of("full_well_electrons",
            SettingForm.number("ELECTRONS"), 0.0,
            "With --photos: adds shot noise of so many electrons at full scale")
            .named("shot-noise").usually("none").where(StudyTable::ofPhotos)
            .within(electrons -> electrons >= 0, SettingRefusal.TOO_SMALL, 0);

    /** What the check is told of the corner noise: outer empty as the cell has it, inner empty if it is unknown. */
    static final Setting<Optional<OptionalDouble>> STATED_PIXEL_STD_PX = Setting.of("stated_pixel_std_px",
            SettingForm.of("auto|PX", StudyTable::cornerNoise, StudyTable::stated,
                    px -> px.isEmpty() ? "" : String.valueOf(stated(px))), Optional.<OptionalDouble>empty(),
            "With --photos: what the check is told of the corner noise, where it is to differ from the cell file (for "
                    + "--random-layouts: auto)")
            .named("state-pixel-std").where(StudyTable::ofPhotos);

    private static final List<Setting<?>> ALL = List.of(SIMULATIONS, SPREAD, PIXEL_STD_PX, CALIBRATION_PHOTOS, OUTLIERS,
            PHOTOS, RANDOM_LAYOUTS, GRID, CORNERS_ONLY, EXACT_OUTLINES, TONE_CURVE, BLUR_PX, MARKER_PX, EXPOSURE,
            JPEG_QUALITY, UNSHARP, PRINT_GAIN_MM, GRADIENT, NOISE_GREY, FULL_WELL_ELECTRONS, STATED_PIXEL_STD_PX);

    private StudyTable() {
    }

    /** All rows, in the order of files. */
    static List<Setting<?>> all() {
        return ALL;
    }

    private static boolean ofPhotos(SettingSource settings) {
        return settings.get(PHOTOS);
    }

    private static boolean positive(OptionalDouble px) {
        return px.orElse(1) > 0;
    }

    private static NumberPair pair(String text, StudyRefusal refusal) {
        return NumberPair.of(text).orElseThrow(() -> new UnreadableException(refusal, text));
    }

    private static ToneCurve toneCurve(String words) {
        try {
            return ToneCurve.of(words);
        } catch (IllegalArgumentException e) {
            throw new UnreadableException(StudyRefusal.NO_TONE_CURVE, words, String.valueOf(ToneCurve.LEAST_GAMMA),
                    String.valueOf(ToneCurve.LARGEST_GAMMA));
        }
    }

    private static Optional<OptionalDouble> cornerNoise(String text) {
        if (text.equals("auto")) {
            return Optional.of(OptionalDouble.empty());
        }
        try {
            double px = Double.parseDouble(text.trim());
            if (px > 0 && Double.isFinite(px)) {
                return Optional.of(OptionalDouble.of(px));
            }
        } catch (NumberFormatException e) {
            // said below, as for numbers that are none
        }
        throw new UnreadableException(StudyRefusal.NO_CORNER_NOISE, text);
    }

    private static Object stated(Optional<OptionalDouble> px) {
        return px.isEmpty() ? null : px.get().isPresent() ? (Object) px.get().getAsDouble() : "auto";
    }
}
