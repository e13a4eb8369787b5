package org.cellgauge.internal.cell;

import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.cellgauge.cell.CameraReader;
import org.cellgauge.geometry.BrownLens;
import org.cellgauge.geometry.KannalaBrandtLens;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.geometry.RationalLens;
import org.cellgauge.light.ToneCurve;

/**
 * Writes cameras as BoofCV's calibration files (YAML); those of a {@link RationalLens}, which BoofCV has not, likewise.
 * {@link CameraReader} reads them.
 *
 * <p>Every number comes back as it was: it is written with all its digits, with a point whatever the machine's
 * language.
 */
public final class CameraWriter {
    /** BoofCV's name for a {@link BrownLens} that does not distort. */
    public static final String WITHOUT_DISTORTION = "pinhole";

    private CameraWriter() {
    }

    /**
     * The text of a camera file.
     *
     * @param camera intrinsics and image size
     * @return YAML, ended by a line feed; the model {@code pinhole} where the lens does not distort
     */
    public static String text(PinholeCamera camera) {
        return text(camera, "");
    }

    /**
     * The text of a camera file that also states how the camera makes grey values of light.
     *
     * @param camera intrinsics and image size
     * @param toneCurve the tone curve, or null: {@code auto}
     * @return YAML, ended by a line feed
     */
    public static String text(PinholeCamera camera, ToneCurve toneCurve) {
        return text(camera, "") + toneCurve(toneCurve);
    }

    /** The line of a cell or camera file that states the tone curve. */
    static String toneCurve(ToneCurve toneCurve) {
        return CameraReader.TONE_CURVE + ": " + (toneCurve == null ? "auto" : toneCurve.words()) + "\n";
    }

    /**
     * The line of a camera file that states how the lens was focused.
     *
     * @param distanceM at calibration, m
     * @return YAML, ended by a line feed
     */
    public static String focusDistance(double distanceM) {
        return CameraReader.FOCUS_DISTANCE + ": " + number(distanceM) + "\n";
    }

    /**
     * The keys of a camera file, to stand in another file below a key of it.
     *
     * @param indent what every line begins with
     */
    static String text(PinholeCamera camera, String indent) {
        StringBuilder out = new StringBuilder();
        out.append(indent).append("model: ").append(
                camera.isDistorting() ? camera.lens().modelName() : WITHOUT_DISTORTION).append('\n');
        out.append(indent).append("pinhole: {fx: ").append(decimal(camera.get(PinholeCamera.FX)))
                .append(", fy: ").append(decimal(camera.get(PinholeCamera.FY)))
                .append(", cx: ").append(decimal(camera.get(PinholeCamera.CX)))
                .append(", cy: ").append(decimal(camera.get(PinholeCamera.CY)))
                .append(", skew: ").append(decimal(camera.get(PinholeCamera.SKEW)))
                .append(", width: ").append(camera.widthPx()).append(", height: ").append(camera.heightPx())
                .append("}\n");
        if (camera.lens() == KannalaBrandtLens.MODEL) {
            out.append(indent).append("symmetric: [1.0");
            for (int i = KannalaBrandtLens.K1; i <= KannalaBrandtLens.K4; i++) {
                out.append(", ").append(decimal(camera.get(i)));
            }
            out.append("]\n");
        } else if (camera.isDistorting() && camera.lens() == RationalLens.MODEL) {
            out.append(indent).append("rational: {radial: [").append(numbers(camera, RationalLens.K1, RationalLens.P1))
                    .append("], t1: ").append(decimal(camera.get(RationalLens.P1)))
                    .append(", t2: ").append(decimal(camera.get(RationalLens.P1 + 1)))
                    .append(", prism: [").append(numbers(camera, RationalLens.S1, RationalLens.PARAMETERS))
                    .append("]}\n");
        } else if (camera.isDistorting()) {
            out.append(indent).append("radial_tangential: {radial: [").append(decimal(camera.get(BrownLens.K1)))
                    .append(", ").append(decimal(camera.get(BrownLens.K2)))
                    .append(", ").append(decimal(camera.get(BrownLens.K3)))
                    .append("], t1: ").append(decimal(camera.get(BrownLens.P1)))
                    .append(", t2: ").append(decimal(camera.get(BrownLens.P2))).append("}\n");
        }
        return out.toString();
    }

    private static String numbers(PinholeCamera camera, int from, int to) {
        return IntStream.range(from, to).mapToObj(i -> decimal(camera.get(i))).collect(Collectors.joining(", "));
    }

    /** A number with all its digits and always a fraction: BoofCV's reader takes no whole numbers. */
    static String decimal(double value) {
        return value == 0 ? "0.0" : String.valueOf(value).replaceFirst("E(\\d)", "e+$1").replace('E', 'e');
    }

    /** A number with all its digits, without a fraction of 0. */
    static String number(double value) {
        if (value == 0) {
            return "0";
        }
        return CameraReader.plain(value);
    }
}
