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
    void fits() {
        for (int[] size : new int[][] {{4, 2, 3}, {6, 3, 10}, {12, 5, 30}, {12, 5, 50}}) {
            Cell cell = cell(size[0], size[1], 5);
            SimulatedSurvey simulated = SimulatedSurvey.of(cell, CheckSettings.builder().build(), size[2], 7, 0);
            long t0 = System.nanoTime();
            CheckSettings settings = CheckSettings.builder().set(SettingTable.ITERATIONS, OptionalInt.of(1000)).build();
            Survey survey = Survey.of(cell, simulated.photos(), settings);
            long t1 = System.nanoTime();
            survey = Survey.of(cell, simulated.photos(), settings);
            long t2 = System.nanoTime();
            SurveyResult e = survey.estimate();
            long t3 = System.nanoTime();
            SurveyResult s = survey.sampled();
            long t4 = System.nanoTime();
            System.out.println(size[2] + " photos used " + survey.used() + " fit " + (t1 - t0) / 1000000 + " warm "
                    + (t2 - t1) / 1000000 + " estimate "
                    + (t3 - t2) / 1000000 + " sampled " + (t4 - t3) / 1000000 + " " + s.run() + " ess/1000 "
                    + s.run().essPerThousand());
            System.out.println(s.warnings());
        }
    }
}
