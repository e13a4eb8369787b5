package org.cellgauge.desktop;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;
import java.util.SplittableRandom;
import org.apache.commons.math3.random.Well19937c;
import org.cellgauge.calibration.CalibrationOptions;
import org.cellgauge.calibration.CalibrationResult;
import org.cellgauge.cell.CalibrationTarget;
import org.cellgauge.cell.CalibrationTargetReader;
import org.cellgauge.cell.CameraFile;
import org.cellgauge.cell.CameraFormat;
import org.cellgauge.cell.CameraReader;
import org.cellgauge.cell.Reference;
import org.cellgauge.desktop.render.GreyPng;
import org.cellgauge.desktop.render.Scene;
import org.cellgauge.desktop.render.SceneMarker;
import org.cellgauge.desktop.render.SceneRenderer;
import org.cellgauge.desktop.render.Sensor;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.internal.cell.CameraExport;
import org.cellgauge.internal.vision.MarkerPattern;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** A plate of markers, rendered through a lens that is known, with a tone curve that moves their sides. */
class MarkerPlateCalibrationTest {
    @TempDir
    private Path folder;

    @Test
    void plateOfMarkersGivesTheCamera() throws IOException {
        PinholeCamera truth = PinholeCamera.of(480, 360, new double[] {465, 467, 244, 177, 0, -0.15, 0.05, 0, 0, 0});
        CalibrationTarget.Markers plate = (CalibrationTarget.Markers) CalibrationTargetReader.read(Files.writeString(
                folder.resolve("plate.yaml"), "cellgauge_target: 1\nmarker_plate: {family: apriltag-36h11, "
                        + "size_mm: 40, positions_mm: {0: [-60, 40], 1: [0, 40], 2: [60, 40], 3: [-60, -40], "
                        + "4: [0, -40], 5: [60, -40]}}\n"));
        List<Path> photos = new ArrayList<>();
        SplittableRandom random = new SplittableRandom(3);
        for (int p = 0; p < 5; p++) {
            RigidTransform pose = RigidTransform.ofEuler(30 * (2 * random.nextDouble() - 1),
                    25 * (2 * random.nextDouble() - 1), 330 + 150 * random.nextDouble(),
                    Math.PI + 0.7 * (2 * random.nextDouble() - 1), 0.7 * (2 * random.nextDouble() - 1),
                    0.7 * (2 * random.nextDouble() - 1));
            Scene.Builder scene = Scene.of(truth, pose.inverse());
            for (Reference marker : plate.markers()) {
                scene.marker(new SceneMarker(marker.id(), marker.sizeMm(),
                        MarkerPattern.of(plate.family(), marker.id()), marker.worldFromMarker()));
            }
            photos.add(Files.write(folder.resolve("p" + p + ".png"), GreyPng.encode(SceneRenderer.render(scene.build(),
                    new Sensor(0.7, 2, 0, 2.2, 0.1, 0.1), new Well19937c(p)))));
        }
        CalibrationResult result = new CalibrationRun(plate, CalibrationOptions.USUAL.withLens("radial-2"), 2,
                (number, count, seen) -> assertEquals(24, seen.count())).of(photos);
        for (int k = 0; k < 4; k++) {
            CalibrationResult.Parameter p = result.parameters().get(k);
            assertEquals(truth.get(k), p.value(), 5 * p.std(), p.name());
            assertTrue(p.std() < 0.5, p.name() + " +- " + p.std());
        }
        for (CameraFormat format : CameraExport.FORMS.values()) {
            CameraFile near = CameraReader.file(CalibrationJson.cameraFile(result, format, OptionalDouble.of(0.4)),
                    "camera.yaml", null);
            assertEquals(OptionalDouble.of(0.4), near.focusDistanceM());
            assertNotNull(near.calibration());
            assertEquals(OptionalDouble.empty(), CameraReader.file(CalibrationJson.cameraFile(result, format,
                    OptionalDouble.empty()), "camera.yaml", null).focusDistanceM());
        }
    }
}
