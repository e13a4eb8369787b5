package org.cellgauge.cli;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Random;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.internal.geometry.MarkerGeometry;
import org.cellgauge.vision.Detections;
import org.cellgauge.vision.DetectionsFile;
import org.cellgauge.vision.MarkerObservation;

/** A cell in a folder of a test: four references of 100 mm around two objects, one raised, 900 mm before the camera. */
final class SmallCell {
    static final int WIDTH = 640;
    static final int HEIGHT = 480;
    static final PinholeCamera CAMERA = PinholeCamera.ideal(WIDTH, HEIGHT, 600, 600, 320, 240);
    static final RigidTransform WORLD_FROM_CAMERA = RigidTransform.ofEuler(200, 150, 900, 3.1, 0.05, 0.02);
    static final String CAMERA_POSE = "200,150,900,3.1rad,0.05rad,0.02rad";
    static final String YAML = "cellgauge: 1\n"
            + "camera: camera.yaml\n"
            + "markers: {family: square-binary, size_mm: 100}\n"
            + "placement: {std_mm: [1, 1, 1], std_deg: 0.2}\n"
            + "pixel_std_px: 0.05\n"
            + "references:\n"
            + "  944: {position_mm: [400, 300, 0], rotation_deg: [0, 0, 0]}\n"
            + "  22: {position_mm: [0, 0, 0], rotation_deg: [0, 0, 0]}\n"
            + "  911: {position_mm: [400, 0, 0], rotation_deg: [0, 0, 0]}\n"
            + "  1234: {position_mm: [0, 300, 100], rotation_deg: [0, 0, 0]}\n"
            + "objects:\n"
            + "  5: {}\n"
            + "  20: {grip_mm: [0, 0, 100]}\n"
            + "target: {std_mm: 2.0}\n";
    static final String CAMERA_YAML = "model: pinhole\n"
            + "pinhole: {fx: 600, fy: 600, cx: 320, cy: 240, width: 640, height: 480}\n";

    private static final Map<Integer, RigidTransform> WORLD_FROM_MARKER = new LinkedHashMap<>();

    static {
        WORLD_FROM_MARKER.put(944, RigidTransform.ofEuler(400, 300, 0, 0, 0, 0));
        WORLD_FROM_MARKER.put(22, RigidTransform.ofEuler(0, 0, 0, 0, 0, 0));
        WORLD_FROM_MARKER.put(911, RigidTransform.ofEuler(400, 0, 0, 0, 0, 0));
        WORLD_FROM_MARKER.put(1234, RigidTransform.ofEuler(0, 300, 100, 0, 0, 0));
        WORLD_FROM_MARKER.put(5, RigidTransform.ofEuler(290, 150, 0, 0.4, 0, 0.3));
        WORLD_FROM_MARKER.put(20, RigidTransform.ofEuler(110, 150, 0, 0, 0.4, -0.2));
    }

    private SmallCell() {
    }

    /** Writes cell and camera file. */
    static Path write(Path folder) throws IOException {
        Files.createDirectories(folder);
        Files.writeString(folder.resolve("camera.yaml"), CAMERA_YAML);
        return Files.writeString(folder.resolve("cell.yaml"), YAML);
    }

    /** The corners of all markers as the camera sees them, each coordinate off by normal noise of 0.05 px. */
    static Detections detections(String imageName, long seed) {
        Random random = new Random(seed);
        List<MarkerObservation> markers = new ArrayList<>();
        WORLD_FROM_MARKER.forEach((id, pose) -> {
            double[] corners = MarkerGeometry.cornersMm(WORLD_FROM_CAMERA.inverse().compose(pose), 100);
            double[] pixels = new double[8];
            for (int i = 0; i < 4; i++) {
                double[] uv = CAMERA.project(corners[3 * i], corners[3 * i + 1], corners[3 * i + 2]);
                pixels[2 * i] = uv[0] + 0.05 * random.nextGaussian();
                pixels[2 * i + 1] = uv[1] + 0.05 * random.nextGaussian();
            }
            markers.add(new MarkerObservation(id, pixels));
        });
        return new Detections(imageName, WIDTH, HEIGHT, markers);
    }

    /** Writes these corners as a detections file. */
    static Path writeDetections(Path file, long seed) throws IOException {
        StringBuilder json = new StringBuilder();
        DetectionsFile.write(detections("none.png", seed), json);
        return Files.writeString(file, json);
    }

    /** Renders the cell as PNG files into a folder. */
    static void writePhotos(Path cell, Path folder, String name, int count) {
        CommandCall call = CommandCall.of("simulate", "--cell", cell.toString(), "--out", folder.toString(), "--object",
                "5=290,150,0,22.9,0,17.2", "--object", "20=110,150,0,0,22.9,-11.5", "--camera-pose", CAMERA_POSE,
                "--name", name, "--count", String.valueOf(count));
        if (call.code() != 0) {
            throw new IllegalStateException(call.err());
        }
    }
}
