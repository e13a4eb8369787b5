package org.cellgauge.vision;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.StringReader;
import org.apache.commons.math3.random.RandomGenerator;
import org.apache.commons.math3.random.Well19937c;
import org.cellgauge.cell.CameraReader;
import org.cellgauge.cell.CellReader;
import org.cellgauge.cell.InputRefusedException;
import org.junit.jupiter.api.Test;

/** However a file is damaged, it is read or refused by name: no other error comes out of the readers. */
class DamagedInputTest {
    private static final String CAMERA = "model: pinhole_radial_tangential\n"
            + "pinhole: {fx: 581.0, fy: 582.0, cx: 640.5, cy: 360.5, width: 1280, height: 720, skew: 0.0}\n"
            + "radial_tangential:\n  radial:\n  - -0.05\n  - 0.01\n  t1: 0.001\n  t2: -0.002\n";
    private static final String CELL = "cellgauge: 1\ncamera: camera.yaml\n"
            + "markers: {family: apriltag-36h11, size_mm: 47}\nplacement: {std_mm: [5, 5, 5], std_deg: 0.5}\n"
            + "pixel_std_px: auto\nreferences:\n  94: {position_mm: [492, 380, 0], rotation_deg: [0, 0, 0]}\n"
            + "  22:\n    position_mm: [0, -36, 165]\n    placement: {std_mm: [1, 1, 1]}\n    size_mm: 100\n"
            + "objects:\n  5: {}\n  20: {grip_mm: [0, 0, 100]}\ntarget: {std_mm: 1.0}\n";
    private static final String DETECTIONS = "{\"image\": {\"width\": 1280, \"height\": 720, \"name\": \"a.png\"},\n"
            + " \"markers\": [{\"id\": 94, \"corners_px\": [[710.5, 110], [760, 111], [761, 160], [709, 161]]}]}\n";
    private static final String SIGNS = "{}[]:,-#&*!|>'\"%@`~?.0159eE \n\t\\\u0000\u00e9\uFEFFxn<";
    private static final int DAMAGES = 1500;

    /** Something that reads a text. */
    private interface Reading {
        void read(String text);
    }

    @Test
    void damagedCellFileIsReadOrRefused() {
        damage(CELL, 11, text -> CellReader.read(text, "input", name -> CAMERA));
    }

    @Test
    void damagedCameraFileIsReadOrRefused() {
        damage(CAMERA, 12, text -> CameraReader.read(text, "input"));
    }

    @Test
    void damagedDetectionsFileIsReadOrRefused() {
        damage(DETECTIONS, 13, text -> DetectionsFile.read(new StringReader(text), "input"));
    }

    private static void damage(String faultless, long seed, Reading reading) {
        reading.read(faultless);
        RandomGenerator random = new Well19937c(seed);
        int refused = 0;
        for (int i = 0; i < DAMAGES; i++) {
            StringBuilder text = new StringBuilder(faultless);
            for (int n = 1 + random.nextInt(3); n > 0 && text.length() > 0; n--) {
                int at = random.nextInt(text.length());
                char sign = SIGNS.charAt(random.nextInt(SIGNS.length()));
                switch (random.nextInt(4)) {
                    case 0:
                        text.insert(at, sign);
                        break;
                    case 1:
                        text.setCharAt(at, sign);
                        break;
                    case 2:
                        text.delete(at, Math.min(text.length(), at + 1 + random.nextInt(12)));
                        break;
                    default:
                        text.setLength(Math.max(1, at));
                }
            }
            try {
                reading.read(text.toString());
            } catch (InputRefusedException e) {
                refused++;
                assertTrue(e.getMessage().startsWith("input"), e.getMessage());
                assertEquals(-1, e.getMessage().indexOf('\n'), e.getMessage());
            } catch (RuntimeException | StackOverflowError e) {
                throw new AssertionError("damage " + i + " is not refused but breaks:\n" + text, e);
            }
        }
        assertTrue(refused > DAMAGES / 2, "most damage is noticed, not " + refused);
    }
}
