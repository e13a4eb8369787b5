package org.cellgauge.desktop;

import com.google.gson.Gson;
import com.google.gson.GsonBuilder;
import com.google.gson.JsonArray;
import com.google.gson.JsonObject;
import java.util.OptionalDouble;
import org.cellgauge.calibration.CalibrationResult;
import org.cellgauge.cell.CameraFormat;
import org.cellgauge.cell.InputRefusedException;
import org.cellgauge.internal.cell.CalibratedCameraText;
import org.cellgauge.internal.cell.CameraExport;
import org.cellgauge.internal.cell.CameraWriter;
import org.cellgauge.warning.Warning;

/** A calibration for programs and as a camera file. */
public final class CalibrationJson {
    private static final Gson GSON = new GsonBuilder().disableHtmlEscaping().create();

    private CalibrationJson() {
    }

    /** Name of a parameter without its unit, as camera files have it. */
    private static String bare(String name) {
        return name.replaceFirst("_px$", "");
    }

    /**
     * The camera file.
     *
     * @param result a calibration
     * @param format BoofCV, OpenCV or ROS
     * @param focusDistanceM distance that the lens was focused at in the photos, m; empty where that is not known
     * @return YAML
     * @throws InputRefusedException if that program has no such camera
     */
    public static String cameraFile(CalibrationResult result, CameraFormat format,
            OptionalDouble focusDistanceM) {
        return CameraExport.text(result.camera(), format)
                + (focusDistanceM.isPresent() ? CameraWriter.focusDistance(focusDistanceM.getAsDouble()) : "")
                + CalibratedCameraText.block(
                result.parameters().stream().map(p -> bare(p.name())).toList(), result.covariance(),
                result.photos().size(), result.figures().rmsPx(), result.widenedBy());
    }

    /**
     * All figures in one line of JSON.
     *
     * @param result a calibration
     * @param version of this program
     * @param command that makes it again
     * @return JSON, ended by a line feed
     */
    public static String line(CalibrationResult result, String version, String command) {
        CalibrationResult.Figures f = result.figures();
        JsonObject out = new JsonObject();
        out.addProperty("schema", 1);
        out.addProperty("lens", result.lens());
        out.addProperty("width_px", result.camera().widthPx());
        out.addProperty("height_px", result.camera().heightPx());
        out.add("parameters", parameters(result.parameters()));
        out.add("covariance", GSON.toJsonTree(result.covariance()));
        out.addProperty("widened_by", result.widenedBy());
        out.add("board", parameters(result.board()));
        out.addProperty("points", f.points());
        out.addProperty("outliers", f.outliers());
        out.addProperty("rms_px", f.rmsPx());
        out.addProperty("noise_px", f.noisePx());
        out.addProperty("in_question", result.inQuestion());
        out.addProperty("cross_validation_ratio", finite(f.crossRatio()));
        out.addProperty("covered_share", f.coveredShare());
        out.addProperty("horizontal_field_of_view_deg", finite(f.horizontalDeg()));
        out.addProperty("vertical_field_of_view_deg", finite(f.verticalDeg()));
        out.addProperty("distance_mm", f.distanceMm());
        out.addProperty("adjustment_ms", f.iterationsMs());
        JsonArray photos = new JsonArray();
        for (CalibrationResult.Photo p : result.photos()) {
            JsonObject one = new JsonObject();
            one.addProperty("name", p.name());
            one.addProperty("points", p.points());
            one.addProperty("outliers", p.outliers());
            one.addProperty("rms_px", p.rmsPx());
            one.addProperty("tilt_deg", p.tiltDeg());
            one.addProperty("distance_mm", p.distanceMm());
            one.addProperty("gain", finite(p.gain()));
            one.addProperty("contradicts", p.contradicts());
            one.addProperty("adds_little", p.addsLittle());
            photos.add(one);
        }
        out.add("photos", photos);
        JsonArray places = new JsonArray();
        for (CalibrationResult.Place p : result.places()) {
            JsonObject one = new JsonObject();
            one.addProperty("u_px", p.u());
            one.addProperty("v_px", p.v());
            one.addProperty("std_px", finite(p.stdPx()));
            one.addProperty("cross_px", finite(p.crossPx()));
            one.addProperty("cross_ratio", finite(p.crossRatio()));
            places.add(one);
        }
        out.add("places", places);
        JsonArray ladder = new JsonArray();
        for (CalibrationResult.LensTrial t : result.ladder()) {
            JsonObject one = new JsonObject();
            one.addProperty("lens", t.lens());
            one.addProperty("unknowns", t.unknowns());
            one.addProperty("held_out_rms_px", finite(t.heldOutRmsPx()));
            one.addProperty("weight", finite(t.weight()));
            ladder.add(one);
        }
        out.add("ladder", ladder);
        JsonArray warnings = new JsonArray();
        for (Warning w : result.warnings()) {
            JsonObject one = new JsonObject();
            one.addProperty("code", w.kind().code());
            one.addProperty("text", w.toString());
            warnings.add(one);
        }
        out.add("warnings", warnings);
        if (result.nextPhoto() != null) {
            out.addProperty("next_photo", result.nextPhoto().toString());
        }
        out.addProperty("command", command);
        out.addProperty("version", version);
        return GSON.toJson(out) + "\n";
    }

    /** JSON has neither NaN nor infinities: null stands for what there is not. */
    private static Double finite(double value) {
        return Double.isFinite(value) ? value : null;
    }

    private static JsonArray parameters(Iterable<CalibrationResult.Parameter> parameters) {
        JsonArray out = new JsonArray();
        for (CalibrationResult.Parameter p : parameters) {
            JsonObject one = new JsonObject();
            one.addProperty("name", p.name());
            one.addProperty("value", p.value());
            one.addProperty("std", p.std());
            out.add(one);
        }
        return out;
    }
}
