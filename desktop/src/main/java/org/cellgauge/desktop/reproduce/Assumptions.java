package org.cellgauge.desktop.reproduce;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import org.cellgauge.cell.Placement;
import org.cellgauge.cell.Reference;
import org.cellgauge.desktop.render.Sensor;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.light.ToneCurve;
import org.cellgauge.settings.CheckSettings;
import org.cellgauge.settings.InitialEstimate;
import org.cellgauge.settings.RotationPrior;
import org.cellgauge.settings.Word;

/** What the experiments rest on, from {@code assumptions.yaml}; immutable. Lengths mm, angles rad, image px. */
final class Assumptions {
    private final DataNode data;

    private Assumptions(DataNode data) {
        this.data = data;
    }

    /** As the file has them. */
    static Assumptions usual() {
        return new Assumptions(DataNode.ofResource("assumptions.yaml"));
    }

    /**
     * One thing that the thesis does not say.
     *
     * @param about what is open
     * @param taken what is taken for it
     * @param because why
     */
    record Silence(String about, String taken, String because) {
    }

    List<Silence> silences() {
        return data.at("silent").items().stream()
                .map(s -> new Silence(s.at("about").text(), s.at("taken").text(), s.at("because").text())).toList();
    }

    /** Corners where they are and not where they are seen in a photo, and how noisy they are said to be, px. */
    Assumptions withExactCorners(double pixelStdPx) {
        Map<String, Object> exact = new LinkedHashMap<>();
        exact.put("photo", Map.of("rendered", false));
        exact.put("pixel_std_px", pixelStdPx);
        return with(new DataNode("exact corners", exact));
    }

    /** Noise of fine corners, px. */
    double finePixelStdPx() {
        return data.at("layouts").at("fine_pixel_std_px").number();
    }

    /** Noise of corners as a clean rendering has them, px. */
    double cleanPixelStdPx() {
        return data.at("layouts").at("clean_pixel_std_px").number();
    }

    /** Other assumptions, by what is changed. */
    Map<String, Assumptions> changes() {
        Map<String, Assumptions> changes = new LinkedHashMap<>();
        for (DataNode change : data.at("changes").items()) {
            changes.put(change.at("name").text(), with(change.at("with")));
        }
        return changes;
    }

    /** The same with other values. */
    Assumptions with(DataNode over) {
        return new Assumptions(data.with(over));
    }

    /** What stands under a key, for the experiments that have numbers of their own. */
    DataNode at(String key) {
        return data.at(key);
    }

    PinholeCamera camera() {
        DataNode camera = data.at("camera");
        double focal = camera.at("focal_px").number();
        double[] principal = camera.at("principal_px").numbers();
        return PinholeCamera.ideal((int) camera.at("width_px").number(), (int) camera.at("height_px").number(), focal,
                focal, principal[0], principal[1]);
    }

    double sizeMm() {
        return data.at("marker_size_mm").number();
    }

    RigidTransform worldFromCamera(String name) {
        return pose(data.at("camera_poses").at(name).numbers());
    }

    private static RigidTransform pose(double[] p) {
        return RigidTransform.ofEuler(p[0], p[1], p[2], p[3], p[4], p[5]);
    }

    /** References by their names, every one placed to the same deviation. */
    List<Reference> references(List<String> names, double stdMm) {
        List<Reference> references = new ArrayList<>();
        for (String name : names) {
            double[] place = data.at("references").at(name).numbers();
            references.add(new Reference((int) place[0], sizeMm(),
                    RigidTransform.ofEuler(place[1], place[2], place[3], 0, 0, 0), placement(stdMm)));
        }
        return references;
    }

    Placement placement(double stdMm) {
        return new Placement(stdMm, stdMm, stdMm, data.at("placement_std_rad").number());
    }

    /** Poses of objects in the world, by id. */
    Map<Integer, RigidTransform> objects(String name) {
        DataNode scene = data.at("objects").at(name);
        Map<Integer, RigidTransform> poses = new LinkedHashMap<>();
        scene.keys().forEach(id -> poses.put(Integer.valueOf(id), pose(scene.at(id).numbers())));
        return poses;
    }

    /** Corner noise as it is stated; empty where the photo is to tell it. */
    OptionalDouble pixelStdPx() {
        DataNode px = data.at("pixel_std_px");
        return px.text().equals("auto") ? OptionalDouble.empty() : OptionalDouble.of(px.number());
    }

    /** The thesis' algorithm with its settings. */
    CheckSettings.Builder asInThesis() {
        DataNode sampler = data.at("sampler");
        return CheckSettings.thesis().kappa(sampler.at("kappa").number())
                .initial(word(InitialEstimate.values(), sampler.at("initial").text()))
                .rotationPrior(word(RotationPrior.values(), sampler.at("rotation_prior").text()))
                .focalPriorStdPx(data.at("focal_prior_std_px").number());
    }

    private static <T extends Word> T word(T[] choices, String word) {
        for (T choice : choices) {
            if (choice.word().equals(word)) {
                return choice;
            }
        }
        throw new IllegalStateException("no choice is called " + word);
    }

    boolean rendered() {
        return (Boolean) data.at("photo").at("rendered").value();
    }

    boolean placementErrors() {
        return (Boolean) data.at("photo").at("placement_errors").value();
    }

    long photoSeed() {
        return (long) data.at("photo").at("seed").number();
    }

    Sensor sensor() {
        DataNode photo = data.at("photo");
        return new Sensor(photo.at("blur_px").number(), photo.at("noise_grey").number(), 0, ToneCurve.SRGB, 1, 0, 1,
                Sensor.USUAL.vignetting(), Sensor.USUAL.gradient(), 0, Sensor.USUAL.clipGrey());
    }

    /** All of it, the silences left out: figures of other assumptions are others. */
    String identity() {
        StringBuilder all = new StringBuilder();
        for (String key : data.keys()) {
            if (!key.equals("silent") && !key.equals("changes") && !key.equals("layouts")) {
                all.append(key).append('=').append(data.at(key).text()).append('\n');
            }
        }
        return all.toString();
    }
}
