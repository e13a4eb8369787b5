package org.cellgauge.desktop.render;

import com.google.gson.Gson;
import com.google.gson.GsonBuilder;
import com.google.gson.JsonArray;
import com.google.gson.JsonObject;
import java.util.List;
import java.util.Map;
import java.util.regex.Pattern;
import org.cellgauge.cell.Cell;
import org.cellgauge.cell.ObjectMarker;
import org.cellgauge.cell.Reference;
import org.cellgauge.geometry.BrownLens;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.geometry.RigidTransform;

/**
 * The truth of a rendered photo as JSON: {@code NAME.truth.json}. Its keys {@code image} and {@code markers} are those
 * of a detections file, with the true corners of every marker that is wholly inside the image.
 */
public final class TruthFile {
    /** Value of the key {@code schema}. */
    public static final int SCHEMA = 1;
    private static final Pattern NUMBERS = Pattern.compile("\\[\\s+([-+0-9.eE,\\s]+?)\\s+\\]");
    private static final Pattern GAPS = Pattern.compile("\\s*,\\s*");

    private TruthFile() {
    }

    /**
     * Describes a photo.
     *
     * @param cell the cell it shows
     * @param photo the photo
     * @param imageName file name of the picture
     * @param seed of everything random
     * @param index which photo of the series
     * @param settings all options that determine the photo, by name
     * @param command the command line as typed
     * @return JSON text, ending in a line feed
     */
    public static String json(Cell cell, CellSimulation.Photo photo, String imageName, long seed, int index,
            Map<String, Object> settings, List<String> command) {
        List<SceneTruth.MarkerInImage> truth = SceneTruth.of(photo.scene());
        Gson gson = new GsonBuilder().setPrettyPrinting().disableHtmlEscaping().create();
        JsonObject root = new JsonObject();
        root.addProperty("schema", SCHEMA);
        JsonObject image = new JsonObject();
        image.addProperty("width", photo.image().widthPx());
        image.addProperty("height", photo.image().heightPx());
        image.addProperty("name", imageName);
        root.add("image", image);
        root.addProperty("seed", seed);
        root.addProperty("photo", index);
        root.add("settings", gson.toJsonTree(settings));
        root.add("command", gson.toJsonTree(command));
        root.addProperty("euler_order", "psi, theta, phi about x, y, z: R = Rz(phi) Ry(theta) Rx(psi)");
        root.add("camera", camera(cell.camera(), photo.scene().worldFromCamera()));
        root.add("references", references(cell, photo, truth));
        root.add("objects", objects(cell, photo, truth));
        root.add("markers", markers(truth));
        // a line per number makes corners and poses unreadable: arrays of numbers go on one line
        return NUMBERS.matcher(gson.toJson(root))
                .replaceAll(m -> "[" + GAPS.matcher(m.group(1)).replaceAll(", ") + "]") + "\n";
    }

    private static JsonObject camera(PinholeCamera camera, RigidTransform worldFromCamera) {
        JsonObject intrinsics = new JsonObject();
        intrinsics.addProperty("width", camera.widthPx());
        intrinsics.addProperty("height", camera.heightPx());
        intrinsics.addProperty("fx", camera.get(PinholeCamera.FX));
        intrinsics.addProperty("fy", camera.get(PinholeCamera.FY));
        intrinsics.addProperty("cx", camera.get(PinholeCamera.CX));
        intrinsics.addProperty("cy", camera.get(PinholeCamera.CY));
        intrinsics.addProperty("skew", camera.get(PinholeCamera.SKEW));
        if (camera.lens() == BrownLens.MODEL) {
            addBrown(intrinsics, camera);
        } else {
            addLens(intrinsics, camera);
        }
        JsonObject out = new JsonObject();
        out.add("intrinsics", intrinsics);
        out.add("pose", pose("camera in world", worldFromCamera));
        return out;
    }

    /** Name and coefficients of any lens. */
    private static void addLens(JsonObject intrinsics, PinholeCamera camera) {
        intrinsics.addProperty("lens", camera.lens().modelName());
        List<String> names = camera.lens().parameterNames();
        for (int i = PinholeCamera.SKEW + 1; i < names.size(); i++) {
            intrinsics.addProperty(names.get(i), camera.get(i));
        }
    }

    /** The coefficients as BoofCV has them. */
    private static void addBrown(JsonObject intrinsics, PinholeCamera camera) {
        intrinsics.add("radial", array(camera.get(BrownLens.K1), camera.get(BrownLens.K2),
                camera.get(BrownLens.K3)));
        intrinsics.addProperty("t1", camera.get(BrownLens.P1));
        intrinsics.addProperty("t2", camera.get(BrownLens.P2));
    }

    private static JsonObject references(Cell cell, CellSimulation.Photo photo,
            List<SceneTruth.MarkerInImage> truth) {
        JsonObject out = new JsonObject();
        for (Reference reference : cell.references()) {
            JsonObject entry = new JsonObject();
            entry.addProperty("size_mm", reference.sizeMm());
            entry.add("nominal", pose("reference in world", reference.worldFromMarker()));
            entry.add("actual", pose("reference in world", photo.worldFromReferences().get(reference.id())));
            addImage(entry, truth, reference.id());
            out.add(Integer.toString(reference.id()), entry);
        }
        return out;
    }

    private static JsonObject objects(Cell cell, CellSimulation.Photo photo, List<SceneTruth.MarkerInImage> truth) {
        JsonObject out = new JsonObject();
        for (ObjectMarker object : cell.objects()) {
            RigidTransform worldFromObject = photo.worldFromObjects().get(object.id());
            if (worldFromObject == null) {
                continue;
            }
            JsonObject entry = new JsonObject();
            entry.addProperty("size_mm", object.sizeMm());
            entry.add("pose", pose("object in world", worldFromObject));
            if (object.hasGrip()) {
                entry.add("grip_in_world_mm", array(worldFromObject.apply(object.gripMm())));
            }
            addImage(entry, truth, object.id());
            out.add(Integer.toString(object.id()), entry);
        }
        return out;
    }

    private static void addImage(JsonObject entry, List<SceneTruth.MarkerInImage> truth, int id) {
        for (SceneTruth.MarkerInImage marker : truth) {
            if (marker.id() == id) {
                entry.addProperty("wholly_inside", marker.whollyInside());
                entry.addProperty("visible_share", marker.visibleShare());
                if (marker.whollyInside()) {
                    entry.add("corners_px", corners(marker));
                }
            }
        }
    }

    private static JsonArray markers(List<SceneTruth.MarkerInImage> truth) {
        JsonArray out = new JsonArray();
        for (SceneTruth.MarkerInImage marker : truth) {
            if (marker.whollyInside()) {
                JsonObject entry = new JsonObject();
                entry.addProperty("id", marker.id());
                entry.add("corners_px", corners(marker));
                out.add(entry);
            }
        }
        return out;
    }

    private static JsonArray corners(SceneTruth.MarkerInImage marker) {
        JsonArray out = new JsonArray();
        for (double[] corner : marker.cornersPx()) {
            out.add(array(corner));
        }
        return out;
    }

    private static JsonObject pose(String frame, RigidTransform pose) {
        JsonObject out = new JsonObject();
        out.addProperty("frame", frame);
        out.add("position_mm", array(pose.translationMm()));
        out.add("euler_rad", array(pose.eulerRad()));
        return out;
    }

    private static JsonArray array(double... values) {
        JsonArray out = new JsonArray();
        for (double value : values) {
            out.add(value == 0 ? 0.0 : value);
        }
        return out;
    }
}
