package org.cellgauge.cli;

import java.nio.file.Path;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Objects;
import java.util.OptionalDouble;
import java.util.stream.Collectors;
import org.cellgauge.cell.Cell;
import org.cellgauge.desktop.render.Sensor;
import org.cellgauge.light.ToneCurve;
import picocli.CommandLine;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;

/** Options of {@code validate} that ask for rendered photos or random layouts. */
final class StudyOptions {
    /** Default of {@code --blur-px}. */
    static final double BLUR_PX = 0.7;

    /** Exposures by name: what light is multiplied by; white paper has a reflectance of 0.85, black print 0.05. */
    enum Exposure {
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

        String word() {
            return name().toLowerCase(Locale.ROOT);
        }
    }

    @Option(names = "--photos",
            description = "Renders a photo of every simulated cell and runs the whole way, detection included.")
    private boolean photos;

    @Option(names = "--random-layouts",
            description = "A new layout for every simulation in place of one cell: 2 to 12 references anywhere in "
                    + "view, tilted and raised, sizes 30 to 120 mm, focal lengths 400 to 2000 px, with and without "
                    + "distortion, placement drawn, too.")
    private boolean randomLayouts;

    @Option(names = "--grid",
            description = "With --photos: a row for each combination of tone curve, blur, size of markers and "
                    + "exposure, and some for JPEG, uneven light, prints and AprilTags, as a table in Markdown.")
    private boolean grid;

    @Option(names = "--corners-only",
            description = "With --photos: finds the markers and compares their corners with the truth, but checks "
                    + "nothing: some three times as fast.")
    private boolean cornersOnly;

    @Option(names = "--only", paramLabel = "WORDS",
            description = "With --grid: only rows whose name holds all these words, as in \"srgb 24px\".")
    private String only;

    @Option(names = "--out", paramLabel = "FILE",
            description = "With --grid: adds each row to this file once it is done, and skips those that stand in it.")
    private Path out;

    @Option(names = "--tone-curve", paramLabel = "srgb|linear|\"gamma G\"",
            description = "With --photos: tone curve of the camera (srgb).")
    private String toneCurve;

    @Option(names = "--blur-px", paramLabel = "PX",
            description = "With --photos: standard deviation of the blur, px (" + BLUR_PX + ").")
    private Double blurPx;

    @Option(names = "--marker-px", paramLabel = "N",
            description = "With --photos: moves the camera along its line of sight until the sides of the cell's "
                    + "markers are N px long on average.")
    private Double markerPx;

    @Option(names = "--exposure", paramLabel = "normal|clipped|dark",
            description = "With --photos: light times 1 (white paper at 0.85 of full scale), 1.95 (paper and wall "
                    + "clipped) or 0.1 (normal).")
    private String exposure;

    @Option(names = "--jpeg", paramLabel = "QUALITY", description = "With --photos: through a JPEG file (none).")
    private Integer jpegQuality;

    @Option(names = "--unsharp", paramLabel = "AMOUNT,RADIUS_PX",
            description = "With --photos: through an unsharp mask (none).")
    private String unsharp;

    @Option(names = "--print-gain", paramLabel = "MM", preprocessor = PoseArgument.MayBeNegative.class,
            description = "With --photos: dark regions of prints are larger by MM on all sides (0).")
    private Double printGainMm;

    @Option(names = "--gradient", paramLabel = "SHARE",
            description = "With --photos: change of the light from left to right (0.1).")
    private Double gradient;

    @Option(names = "--noise", paramLabel = "GREY",
            description = "With --photos: standard deviation of the noise in grey levels of 255 (2).")
    private Double noiseGrey;

    @Option(names = "--shot-noise", paramLabel = "ELECTRONS",
            description = "With --photos: adds shot noise of so many electrons at full scale (none).")
    private Double fullWellElectrons;

    @Option(names = "--state-pixel-std", paramLabel = "auto|PX",
            description = "With --photos: what the check is told of the corner noise, where it is to differ from the "
                    + "cell file (for --random-layouts: auto).")
    private String statedPixelStd;

    /** Whether anything but the validation of one cell from drawn corners is asked for. */
    boolean asked() {
        return photos || randomLayouts;
    }

    boolean photos() {
        return photos;
    }

    boolean randomLayouts() {
        return randomLayouts;
    }

    boolean grid() {
        return grid;
    }

    boolean cornersOnly() {
        return cornersOnly;
    }

    /** Words that the names of the grid's rows must hold, perhaps none. */
    List<String> onlyWords() {
        return only == null || only.isBlank() ? List.of() : List.of(only.trim().toLowerCase(Locale.ROOT).split("\\s+"));
    }

    /** File for the grid's rows, or null. */
    Path out() {
        return out;
    }

    /** Side of the markers asked for, px, or null. */
    Double markerPx() {
        return markerPx;
    }

    int jpegQuality() {
        return jpegQuality == null ? 0 : jpegQuality;
    }

    double printGainMm() {
        return printGainMm == null ? 0 : printGainMm;
    }

    /**
     * Requires that the options go together and are in range.
     *
     * @param command for the message
     * @throws ParameterException if they are not
     */
    void check(CommandLine command) {
        Map<String, Object> ofPhotos = new LinkedHashMap<>();
        ofPhotos.put("--grid", grid ? true : null);
        ofPhotos.put("--corners-only", cornersOnly ? true : null);
        ofPhotos.put("--tone-curve", toneCurve);
        ofPhotos.put("--blur-px", blurPx);
        ofPhotos.put("--marker-px", markerPx);
        ofPhotos.put("--exposure", exposure);
        ofPhotos.put("--jpeg", jpegQuality);
        ofPhotos.put("--unsharp", unsharp);
        ofPhotos.put("--print-gain", printGainMm);
        ofPhotos.put("--gradient", gradient);
        ofPhotos.put("--noise", noiseGrey);
        ofPhotos.put("--shot-noise", fullWellElectrons);
        ofPhotos.put("--state-pixel-std", statedPixelStd);
        String given = ofPhotos.entrySet().stream().filter(e -> e.getValue() != null).map(Map.Entry::getKey)
                .findFirst().orElse(null);
        if (given != null && !photos) {
            throw new ParameterException(command, given + " is about photos: give --photos, too");
        }
        if (!grid && (only != null || out != null)) {
            throw new ParameterException(command, (only != null ? "--only" : "--out") + " is about the rows of --grid");
        }
        if (randomLayouts && (grid || markerPx != null)) {
            throw new ParameterException(command, "--random-layouts draws the size of markers: leave out "
                    + (grid ? "--grid" : "--marker-px"));
        }
        List<String> set = List.of("--tone-curve", "--blur-px", "--marker-px", "--exposure", "--jpeg", "--unsharp",
                "--print-gain", "--gradient");
        if (grid && set.contains(Objects.requireNonNullElse(given(ofPhotos, set), ""))) {
            throw new ParameterException(command, "--grid goes through " + given(ofPhotos, set)
                    + " itself: leave it out, or pick rows with --only");
        }
        if (markerPx != null && !(markerPx > 0 && Double.isFinite(markerPx))) {
            throw new ParameterException(command, "--marker-px: must be positive, not " + markerPx);
        }
        if (jpegQuality != null && (jpegQuality < 1 || jpegQuality > 100)) {
            throw new ParameterException(command, "--jpeg: the quality must be between 1 and 100, not " + jpegQuality);
        }
        if (printGainMm != null && !Double.isFinite(printGainMm)) {
            throw new ParameterException(command, "--print-gain: must be a number of mm, not " + printGainMm);
        }
        sensor(command);
        statedPixelStd(command);
    }

    private static String given(Map<String, Object> options, List<String> among) {
        return among.stream().filter(name -> options.get(name) != null).findFirst().orElse(null);
    }

    /** How photos are taken. */
    Sensor sensor(CommandLine command) {
        Exposure chosen = Exposure.NORMAL;
        if (exposure != null) {
            chosen = Arrays.stream(Exposure.values()).filter(e -> e.word().equals(exposure)).findFirst()
                    .orElseThrow(() -> new ParameterException(command, "--exposure: '" + exposure + "' is not known; "
                            + "write " + Arrays.stream(Exposure.values()).map(Exposure::word)
                                    .collect(Collectors.joining(" or "))));
        }
        try {
            Sensor sensor = Sensor.USUAL.withBlurPx(blurPx == null ? BLUR_PX : blurPx)
                    .withToneCurve(toneCurve == null ? ToneCurve.SRGB : PhotoOptions.toneCurve(toneCurve, null))
                    .withExposure(chosen.factor)
                    .withFullWellElectrons(fullWellElectrons == null ? 0 : fullWellElectrons);
            sensor = noiseGrey == null ? sensor : sensor.withNoiseGrey(noiseGrey);
            sensor = gradient == null ? sensor : sensor.withUnevenLight(sensor.vignetting(), gradient);
            return PhotoOptions.unsharp(sensor, unsharp);
        } catch (IllegalArgumentException e) {
            throw new ParameterException(command, e.getMessage());
        }
    }

    /** What the check is told of the corner noise: null as the cell has it, empty if it is unknown. */
    OptionalDouble statedPixelStd(CommandLine command) {
        if (statedPixelStd == null) {
            return null;
        }
        if (statedPixelStd.equals("auto")) {
            return OptionalDouble.empty();
        }
        try {
            double px = Double.parseDouble(statedPixelStd.trim());
            if (px > 0 && Double.isFinite(px)) {
                return OptionalDouble.of(px);
            }
        } catch (NumberFormatException e) {
            // said below, as for numbers that are none
        }
        throw new ParameterException(command, "--state-pixel-std: write auto or a positive number of px, not '"
                + statedPixelStd + "'");
    }

    /**
     * A cell with what the check is to be told of the corner noise.
     *
     * @param command for messages
     * @param cell as its file has it
     * @return the cell, perhaps the same
     */
    Cell stated(CommandLine command, Cell cell) {
        OptionalDouble px = statedPixelStd(command);
        return px == null ? cell : new Cell(cell.camera(), cell.family(), cell.references(), cell.objects(), px,
                cell.targetStdMm());
    }
}
