package org.cellgauge.survey;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import org.cellgauge.cell.Cell;
import org.cellgauge.cell.MarkerFamily;
import org.cellgauge.cell.ObjectMarker;
import org.cellgauge.cell.Placement;
import org.cellgauge.cell.PrintPrecision;
import org.cellgauge.cell.Reference;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.internal.validation.SimulatedSurvey;
import org.cellgauge.internal.validation.SurveyStudy;
import org.cellgauge.settings.CheckSettings;
import org.cellgauge.settings.SettingTable;
import org.junit.jupiter.api.Test;

class SurveyTest {
    private static final PinholeCamera CAMERA = PinholeCamera.ideal(1280, 720, 900, 900, 640, 360);

    static Cell cell(int references, int objects, double stdMm) {
        List<Reference> placed = new ArrayList<>();
        for (int i = 0; i < references; i++) {
            double angle = 2 * Math.PI * i / references;
            placed.add(new Reference(100 + i, 60, RigidTransform.ofEuler(350 * Math.cos(angle),
                    250 * Math.sin(angle), i % 3 == 0 ? 100 : 0, 0, 0, 0),
                    new Placement(stdMm, stdMm, stdMm, Math.toRadians(0.5))));
        }
        List<ObjectMarker> seen = new ArrayList<>();
        for (int i = 0; i < objects; i++) {
            seen.add(new ObjectMarker(i + 1, 60, i % 2 == 0 ? new double[] {0, 0, 100} : null));
        }
        return new Cell(CAMERA, MarkerFamily.SQUARE_BINARY, placed, seen, OptionalDouble.of(0.3),
                OptionalDouble.of(1), new PrintPrecision(0, 0, 0));
    }

    @Test
    void study() {
        for (int k : new int[] {3, 10}) {
            long t = System.nanoTime();
            System.out.println(k + " " + SurveyStudy.of(cell(4, 2, 5), CheckSettings.builder().build(), k, k == 3 ? 100 : 40, 1, 2, false)
                    + " ms " + (System.nanoTime() - t) / 1000000);
        }
    }
}
