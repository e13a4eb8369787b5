package org.cellgauge.cli;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import org.cellgauge.cell.Cell;
import org.cellgauge.desktop.render.Sensor;
import org.cellgauge.settings.Setting;
import org.cellgauge.settings.SettingSource;

/** Values of {@link StudyTable}: what is simulated; immutable. */
final class StudySettings implements SettingSource {
    /** All defaults. */
    static final StudySettings USUAL = new StudySettings(Map.of());

    private final Map<Setting<?>, Object> values;

    /** Values that were set, each of its row's type; copied. */
    StudySettings(Map<Setting<?>, Object> values) {
        this.values = Map.copyOf(values);
    }

    @Override
    @SuppressWarnings("unchecked")
    public <T> T get(Setting<T> setting) {
        return (T) values.getOrDefault(setting, setting.usual());
    }

    /** By key what files hold, of all rows; null for what is open or does not apply. */
    Map<String, Object> plain() {
        Map<String, Object> plain = new LinkedHashMap<>();
        StudyTable.all().forEach(row -> plain.put(row.key(), row.plain(this)));
        return plain;
    }

    boolean photos() {
        return get(StudyTable.PHOTOS);
    }

    boolean cornersOnly() {
        return photos() && get(StudyTable.CORNERS_ONLY);
    }

    int simulations() {
        return get(StudyTable.SIMULATIONS);
    }

    /** Quality of JPEG files; 0 for none. */
    int jpegQuality() {
        return get(StudyTable.JPEG_QUALITY).orElse(0);
    }

    boolean outlinesDrawn() {
        return !get(StudyTable.EXACT_OUTLINES);
    }

    double printGainMm() {
        return get(StudyTable.PRINT_GAIN_MM);
    }

    /** How photos are taken. */
    Sensor sensor() {
        Sensor sensor = Sensor.USUAL.withBlurPx(get(StudyTable.BLUR_PX)).withToneCurve(get(StudyTable.TONE_CURVE))
                .withExposure(get(StudyTable.EXPOSURE).factor)
                .withFullWellElectrons(get(StudyTable.FULL_WELL_ELECTRONS)).withNoiseGrey(get(StudyTable.NOISE_GREY))
                .withUnevenLight(Sensor.USUAL.vignetting(), get(StudyTable.GRADIENT));
        return get(StudyTable.UNSHARP).map(mask -> sensor.withUnsharp(mask.first(), mask.second())).orElse(sensor);
    }

    /** A cell with what the check is to be told of the corner noise, perhaps the same. */
    Cell stated(Cell cell) {
        Optional<OptionalDouble> px = get(StudyTable.STATED_PIXEL_STD_PX);
        return px.isEmpty() ? cell : cell.withPixelStdPx(px.get());
    }
}
