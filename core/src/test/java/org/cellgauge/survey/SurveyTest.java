package org.cellgauge.survey;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;
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
        return new Cell(CAMERA, MarkerFamily.find("square-binary"), placed, seen, OptionalDouble.of(0.3),
                OptionalDouble.of(1), new PrintPrecision(0, 0, 0));
    }

    @Test
    void speed() {
        for (int[] size : new int[][] {{4, 2, 3}, {6, 3, 10}, {12, 5, 30}, {12, 5, 50}}) {
            Cell cell = cell(size[0], size[1], 5);
            SimulatedSurvey simulated = SimulatedSurvey.of(cell, CheckSettings.DEFAULT, size[2], 7, 0);
            long t0 = System.nanoTime();
            Survey survey = Survey.of(cell, simulated.photos(), CheckSettings.DEFAULT);
            long t1 = System.nanoTime();
            SurveyResult e = survey.estimate();
            long t2 = System.nanoTime();
            SurveyResult s = survey.sampled();
            long t3 = System.nanoTime();
            System.out.println(size[2] + " photos used " + survey.used() + " fit " + (t1 - t0) / 1000000 + " estimate "
                    + (t2 - t1) / 1000000 + " sampled " + (t3 - t2) / 1000000 + " " + s.run() + " ess/1000 " + s.run().essPerThousand());
            System.out.println(s.warnings());
            for (SurveyedObject o : s.objects()) {
                RigidTransform truth = simulated.objects().get(o.marker().id());
                double[] a = truth.translationMm();
                double[] b = o.pose().meanTransform().translationMm();
                System.out.println(o.marker().id() + " error " + (b[0] - a[0]) + " " + (b[1] - a[1]) + " " + (b[2] - a[2])
                        + " std " + java.util.Arrays.toString(o.pose().std()) + o.shares() + o.worstStdMmByPhotos());
            }
            for (SurveyedReference r : s.references()) {
                double[] a = simulated.references().get(r.stated().id()).translationMm();
                double[] b = r.pose().meanTransform().translationMm();
                System.out.println(r.stated().id() + " error " + (b[0] - a[0]) + " " + (b[1] - a[1]) + " " + (b[2] - a[2])
                        + " std " + r.pose().std()[0]+ " off " + r.offMm() + " p " + r.chance());
            }
        }
    }
}
