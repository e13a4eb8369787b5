package org.cellgauge.internal.overlay;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Locale;
import org.apache.commons.math3.random.Well19937c;
import org.cellgauge.cell.Cell;
import org.cellgauge.check.CellCheck;
import org.cellgauge.check.CellEstimate;
import org.cellgauge.check.CheckResult;
import org.cellgauge.check.CheckUpdate;
import org.cellgauge.check.ThesisScene;
import org.cellgauge.check.Verdict;
import org.cellgauge.estimate.ObjectEstimate;
import org.cellgauge.geometry.BrownLens;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.internal.geometry.MarkerGeometry;
import org.cellgauge.settings.CheckSettings;
import org.cellgauge.statistics.Ellipse;
import org.cellgauge.vision.Detections;
import org.cellgauge.vision.MarkerObservation;
import org.junit.jupiter.api.Test;

class CellOverlayTest {
    private static final CheckSettings SETTINGS = CheckSettings.builder().threads(1).build();

    private static CheckUpdate quickLook(Cell cell, Detections detections) {
        return CellCheck.stream(cell, detections, SETTINGS).blockingFirst();
    }

    private static Overlay overlay(ThesisScene scene) {
        Cell cell = scene.cell();
        Detections detections = scene.exactDetections();
        return CellOverlay.of(cell, detections, quickLook(cell, detections).estimate());
    }

    private static ThesisScene fine() {
        return ThesisScene.inPlane(4).placement(1, 0.003).pixelStd(0.05).grip(20, 0, 0, 100);
    }

    private static List<String> texts(Overlay overlay, Role role) {
        List<String> texts = new ArrayList<>();
        for (Shape s : overlay.shapes(role)) {
            if (s instanceof TextShape) {
                texts.add(((TextShape) s).text());
            }
        }
        return texts;
    }

    private static PinholeCamera distorted() {
        double[] v = ThesisScene.CAMERA.intrinsics();
        v[BrownLens.K1] = -0.3;
        v[BrownLens.K2] = 0.1;
        v[BrownLens.P1] = 0.001;
        v[BrownLens.P2] = -0.0008;
        return PinholeCamera.of(1280, 720, v);
    }

    @Test
    void labelsSpeakTheLanguageTheyAreGiven() {
        Cell cell = fine().cell();
        Detections detections = fine().exactDetections();
        LabelWords german = new LabelWords(Locale.GERMAN, "ausgelassen", "steht falsch", "nicht gesehen",
                "nicht in der Zelldatei", "nicht konvergiert", "noch nicht konvergiert", "mehrdeutig", "Greifpunkt");
        CheckUpdate update = quickLook(cell, detections);
        OverlayStyle bare = OverlayStyle.PHOTO.withoutPanels();
        List<String> english = texts(CellOverlay.of(cell, detections, update, bare), Role.LABEL);
        List<String> translated = texts(CellOverlay.of(cell, detections, update, bare.withLabels(german)), Role.LABEL);
        assertEquals(english.size(), translated.size());
        assertTrue(translated.contains("noch nicht konvergiert"));
        assertFalse(translated.contains("not converged yet"));
        for (int i = 0; i < english.size(); i++) {
            // figures are the same, with a comma and, so that figures stay apart, semicolons between them
            assertEquals(english.get(i).replace(", ", "; ").replace('.', ',').replace("grip", "Greifpunkt")
                    .replace("not converged yet", "noch nicht konvergiert"), translated.get(i));
        }
    }

    @Test
    void lengthsDoNotDependOnHowTheImageIsTurned() {
        assertEquals(Overlay.unitPx(1280, 720), Overlay.unitPx(720, 1280));
        assertEquals(1, Overlay.unitPx(640, 480));
        assertEquals(1, Overlay.unitPx(480, 640));
        assertEquals(1.5, Overlay.unitPx(1280, 720));
    }

    @Test
    void gridPointsLookedBackOntoThePlaneLieOnTheGrid() {
        for (PinholeCamera camera : new PinholeCamera[] {ThesisScene.CAMERA, distorted()}) {
            ThesisScene scene = fine().camera(camera);
            Cell cell = scene.cell();
            Detections detections = scene.exactDetections();
            CellEstimate estimate = quickLook(cell, detections).estimate();
            // a legend has a sample of the grid
            Overlay overlay = CellOverlay.of(cell, detections, estimate, OverlayStyle.PHOTO.withoutPanels());
            assertEquals(100, overlay.gridSpacingMm());
            RigidTransform pose = estimate.camera().meanTransform();
            int lines = 0;
            for (Shape s : overlay.shapes(Role.WORLD_GRID)) {
                double[] p = ((Polyline) s).pointsPx();
                lines++;
                for (int i = 0; i < p.length; i += 2) {
                    assertEquals(0, offGridMm(camera, pose, p[i], p[i + 1]), 1e-6);
                    if (i > 0) {
                        // straight in between, where the image of a line is bent: a twentieth of a pixel is 0.1 mm
                        assertEquals(0, offGridMm(camera, pose, (p[i - 2] + p[i]) / 2, (p[i - 1] + p[i + 1]) / 2),
                                0.15);
                    }
                }
            }
            assertTrue(lines >= 12, lines + " lines");
        }
    }

    /** How far a point of the plane, as it is seen in the image, is from the nearest line of a grid of 100 mm. */
    private static double offGridMm(PinholeCamera camera, RigidTransform worldFromCamera, double u, double v) {
        double[] ray = new double[2];
        assertTrue(camera.toNormalised(u, v, ray));
        double[] eye = worldFromCamera.translationMm();
        double[] far = worldFromCamera.apply(ray[0], ray[1], 1);
        double t = eye[2] / (eye[2] - far[2]);
        assertTrue(t > 0, "behind the camera");
        double x = eye[0] + t * (far[0] - eye[0]);
        double y = eye[1] + t * (far[1] - eye[1]);
        return Math.min(Math.abs(x - 100 * Math.rint(x / 100)), Math.abs(y - 100 * Math.rint(y / 100)));
    }

    @Test
    void ellipsesAreThoseOfTheCheckTimesOneMagnification() {
        ThesisScene scene = fine();
        Cell cell = scene.cell();
        Detections detections = scene.exactDetections();
        CellEstimate estimate = quickLook(cell, detections).estimate();
        Overlay overlay = CellOverlay.of(cell, detections, estimate);
        List<Shape> drawn = new ArrayList<>(overlay.shapes(Role.OBJECT_ELLIPSE));
        drawn.addAll(overlay.shapes(Role.GRIP_ELLIPSE));
        double m = overlay.magnification();
        assertTrue(m > 1, "small ellipses are magnified");
        double largest = 0;
        double side = Double.POSITIVE_INFINITY;
        for (ObjectEstimate o : estimate.objects()) {
            assertTrue(contains(drawn, o.ellipse95Px(), m), "position of " + o.id());
            largest = Math.max(largest, o.ellipse95Px().semiMajor());
            if (o.grip() != null) {
                assertTrue(contains(drawn, o.gripEllipse95Px(), m), "grip of " + o.id());
                largest = Math.max(largest, o.gripEllipse95Px().semiMajor());
            }
            Box box = Box.around(Collections.singletonList(detections.find(o.id()).cornersPx()));
            side = Math.min(side, Math.max(box.width(), box.height()));
        }
        // as large as the marker, and the next number of the series would be larger
        assertTrue(m * largest <= side && 2.5 * m * largest > side, m + " x " + largest + " against " + side);
        assertTrue(String.join(" ", texts(overlay, Role.LEGEND)).contains(String.format("magnified %.0f\u00d7", m)));
    }

    private static boolean contains(List<Shape> drawn, Ellipse e, double m) {
        for (Shape s : drawn) {
            Ellipse d = ((EllipseShape) s).ellipse();
            if (Math.abs(d.centreX() - e.centreX()) + Math.abs(d.centreY() - e.centreY())
                    + Math.abs(d.semiMajor() - m * e.semiMajor()) + Math.abs(d.semiMinor() - m * e.semiMinor())
                    + Math.abs(d.angleRad() - e.angleRad()) < 1e-9) {
                return true;
            }
        }
        return false;
    }

    @Test
    void ellipsesThatAreSeenWellHaveTheirTrueSize() {
        Overlay overlay = overlay(fine().pixelStd(5));
        assertEquals(1, overlay.magnification());
        assertTrue(String.join(" ", texts(overlay, Role.LEGEND)).contains("true size"));
    }

    @Test
    void everythingLiesInTheImage() {
        for (Overlay overlay : overlays()) {
            Box image = new Box(-1e-9, -1e-9, overlay.widthPx() + 1e-9, overlay.heightPx() + 1e-9);
            for (Shape s : overlay.shapes()) {
                assertTrue(image.contains(s.bounds()), s.role() + " " + s.bounds() + " in " + image);
            }
        }
    }

    @Test
    void labelsCoverNeitherEachOtherNorMarkersNorPanels() {
        for (Overlay overlay : overlays()) {
            List<Shape> labels = new ArrayList<>();
            List<Box> others = new ArrayList<>();
            for (Shape s : overlay.shapes()) {
                boolean panel = s instanceof PanelShape;
                if (s.role() == Role.LABEL && (panel || s instanceof TextShape && !onPanel(overlay, s))) {
                    labels.add(s);
                } else if (panel || (s.role() == Role.REFERENCE_OUTLINE || s.role() == Role.OBJECT_OUTLINE)) {
                    others.add(s.bounds());
                }
            }
            assertEquals(7, labels.size(), "4 references, 3 objects");
            for (int i = 0; i < labels.size(); i++) {
                Box box = labels.get(i).bounds();
                for (int k = 0; k < i; k++) {
                    assertEquals(0, box.overlap(labels.get(k).bounds()), "labels " + i + " and " + k);
                }
                for (Box other : others) {
                    assertEquals(0, box.overlap(other), box + " and " + other);
                }
            }
        }
    }

    private static boolean onPanel(Overlay overlay, Shape text) {
        for (Shape s : overlay.shapes(Role.LABEL)) {
            if (s instanceof PanelShape && s.bounds().grown(1e-6).contains(text.bounds())) {
                return true;
            }
        }
        return false;
    }

    private static List<Overlay> overlays() {
        RigidTransform oblique = RigidTransform.ofEuler(280, -350, 900, 3.55, 0.05, 0.02);
        List<Overlay> overlays = new ArrayList<>();
        overlays.add(overlay(fine()));
        overlays.add(overlay(ThesisScene.oneRaised(4).grip(30, 20, 0, 60)));
        overlays.add(overlay(fine().camera(distorted())));
        overlays.add(overlay(fine().cameraAt(oblique)));
        overlays.add(overlay(fine().camera(PinholeCamera.ideal(640, 480, 380, 380, 320, 240))));
        overlays.add(overlay(fine().camera(PinholeCamera.ideal(4000, 3000, 2400, 2400, 2000, 1500))));
        overlays.add(overlay(lifted()));
        return overlays;
    }

    private static ThesisScene lifted() {
        return fine().object(5, RigidTransform.ofEuler(259, 276, 155, 0.4, 0, 0.2))
                .object(20, RigidTransform.ofEuler(261, 202, 147, 0.3, 0, 0.3))
                .object(30, RigidTransform.ofEuler(239, -27, 0, 0.3, 0, -0.5));
    }

    @Test
    void nothingBehindTheCameraIsDrawn() {
        // 300 mm above the plane, in the middle of the cell, looking along +y and a bit down: half the grid is behind
        RigidTransform level = RigidTransform.ofEuler(246, 150, 300, -Math.PI / 2 - 0.3, 0, 0);
        ThesisScene scene = ThesisScene.inPlane(2).cameraAt(level).noObjects();
        Cell cell = scene.cell();
        List<MarkerObservation> seen = new ArrayList<>();
        double[] px = project(level, RigidTransform.ofEuler(0, 380, 0, 0, 0, 0));
        assertNotNull(px);
        seen.add(new MarkerObservation(1234, px));
        Detections detections = new Detections("level", 1280, 720, seen);
        CellEstimate estimate = quickLook(cell, detections).estimate();
        RigidTransform cameraFromWorld = estimate.camera().meanTransform().inverse();
        Overlay overlay = CellOverlay.of(cell, detections, estimate, OverlayStyle.PHOTO.withoutPanels());
        double[] down = cameraFromWorld.apply(0, 0, -1);
        double[] origin = cameraFromWorld.apply(0, 0, 0);
        int points = 0;
        for (Shape s : overlay.shapes(Role.WORLD_GRID)) {
            double[] p = ((Polyline) s).pointsPx();
            for (int i = 0; i < p.length; i += 2) {
                points++;
                // a ray to a visible point of the plane runs downwards; points behind would come out above the horizon
                double along = 0;
                double[] ray = {(p[i] - 640) / 581, (p[i + 1] - 360) / 581, 1};
                for (int k = 0; k < 3; k++) {
                    along += ray[k] * (down[k] - origin[k]);
                }
                assertTrue(along > 0, "above the horizon at " + p[i] + ", " + p[i + 1]);
            }
        }
        assertTrue(points > 0);
    }

    private static double[] project(RigidTransform worldFromCamera, RigidTransform worldFromMarker) {
        double[] c = MarkerGeometry.cornersMm(worldFromCamera.inverse().compose(worldFromMarker), ThesisScene.SIZE_MM);
        double[] px = new double[8];
        for (int k = 0; k < 4; k++) {
            double[] uv = ThesisScene.CAMERA.project(c[3 * k], c[3 * k + 1], c[3 * k + 2]);
            if (uv == null) {
                return null;
            }
            System.arraycopy(uv, 0, px, 2 * k, 2);
        }
        return px;
    }

    @Test
    void aQuickLookSaysThatItIsOne() {
        Overlay overlay = overlay(fine().target(3));
        assertEquals(Status.NEUTRAL, overlay.status());
        assertTrue(texts(overlay, Role.BANNER).contains("QUICK LOOK"));
        assertEquals(3, Collections.frequency(texts(overlay, Role.LABEL), "not converged yet"));
        for (Shape s : overlay.shapes(Role.OBJECT_ELLIPSE)) {
            assertTrue(s.dashed());
        }
        for (Shape s : overlay.shapes(Role.LABEL)) {
            assertFalse(s instanceof MarkShape, "not judged yet");
        }
    }

    @Test
    void aFinishedCheckShowsVerdictMarksAndFigures() {
        ThesisScene scene = lifted();
        Detections detections = scene.exactDetections();
        CheckResult passed = CellCheck.run(scene.target(100).cell(), detections, SETTINGS);
        Overlay overlay = CellOverlay.of(passed);
        assertEquals(Status.PASS, overlay.status());
        assertTrue(texts(overlay, Role.BANNER).contains("PASS"));
        assertEquals(passed.reason(), String.join(" ", texts(overlay, Role.BANNER).subList(1,
                texts(overlay, Role.BANNER).size())));
        assertEquals(3, marks(overlay, Mark.CHECK));
        for (Shape s : overlay.shapes(Role.OBJECT_ELLIPSE)) {
            assertFalse(s.dashed());
        }
        double[] std = passed.estimate().object(5).pose().std();
        String label = texts(overlay, Role.LABEL).get(0);
        assertTrue(label.startsWith("5: \u03c3 ") && label.endsWith(" mm"), label);
        String[] figures = label.substring(5, label.length() - 3).split(", ");
        for (int i = 0; i < 3; i++) {
            // two digits that count: off by 5 % at most
            assertEquals(std[i], Double.parseDouble(figures[i]), 0.051 * std[i]);
        }
        CheckResult missed = CellCheck.run(scene.target(0.01).cell(), detections, SETTINGS);
        assertTrue(texts(CellOverlay.of(missed), Role.BANNER).contains("TARGET MISSED"));
        assertEquals(3, marks(CellOverlay.of(missed), Mark.CROSS));
    }

    /** Words of no language, so that whatever is not one of them was left in English. */
    @Test
    void aKeptPictureSpeaksOneLanguage() {
        ThesisScene scene = lifted().target(100);
        CheckResult result = CellCheck.run(scene.cell(), scene.exactDetections(), SETTINGS);
        LegendWords legend = new LegendWords(Locale.GERMAN, "<a>", "<b>", "<c>", "<d %s>", "<e>", "<f>", "<g>", "<h>",
                "<i %s>", "<j %1$s %1$s>", "<k>");
        LabelWords labels = new LabelWords(Locale.GERMAN, "<l>", "<m>", "<n>", "<o>", "<p>", "<q>", "<r>", "<s>");
        Overlay english = CellOverlay.of(result);
        OverlayStyle style = OverlayStyle.PHOTO.withLabels(labels).withLegend(legend);
        Overlay other = CellOverlay.of(result, style, "<t>", "<u> <u>");
        assertEquals(english.status(), other.status());
        assertEquals(english.shapes(Role.BANNER).stream().filter(s -> s instanceof MarkShape).count(),
                other.shapes(Role.BANNER).stream().filter(s -> s instanceof MarkShape).count());
        assertEquals(List.of("<t>", "<u> <u>"), texts(other, Role.BANNER));
        assertEquals(texts(english, Role.LEGEND).size(), texts(other, Role.LEGEND).size());
        for (String text : texts(other, Role.LEGEND)) {
            assertTrue(text.matches("<[a-k]( [0-9,]+)*>"), text);
        }
        for (String text : texts(other, Role.LABEL)) {
            assertTrue(text.matches("\\d+|(\\d+|<s>): \u03c3 [0-9,]+; [0-9,]+; [0-9,]+ mm"), text);
        }
        assertEquals(english.shapes(Role.OBJECT_ELLIPSE).size(), other.shapes(Role.OBJECT_ELLIPSE).size());
    }

    @Test
    void legendOfTheDesktopIsEnglish() {
        LegendWords words = LegendWords.ENGLISH;
        assertEquals("95 % of positions, true size", words.ellipse(1, true));
        assertEquals("95 % of positions, magnified 20\u00d7", words.ellipse(20, true));
        assertEquals("95 % of positions, magnified 2.5\u00d7, not converged", words.ellipse(2.5, false));
        assertEquals("grid 1000 mm on z = 0", words.grid(1000, false));
        assertEquals("grid 0.5 mm on z = 0, axes 0.5 mm", words.grid(0.5, true));
    }

    private static int marks(Overlay overlay, Mark mark) {
        int count = 0;
        for (Shape s : overlay.shapes(Role.LABEL)) {
            count += s instanceof MarkShape && ((MarkShape) s).mark() == mark ? 1 : 0;
        }
        return count;
    }

    @Test
    void withoutConvergenceNoFigureIsShown() {
        ThesisScene scene = fine().target(3);
        CheckResult result = CellCheck.run(scene.cell(), scene.exactDetections(),
                CheckSettings.thesis().iterations(2000).warmup(1000).threads(1).build());
        assertEquals(Verdict.NOT_CONVERGED, result.verdict());
        Overlay overlay = CellOverlay.of(result);
        assertEquals(Status.NOT_CONVERGED, overlay.status());
        assertTrue(texts(overlay, Role.BANNER).get(0).startsWith("NOT CONVERGED"));
        assertTrue(texts(overlay, Role.LABEL).contains("5: not converged"));
        for (String text : texts(overlay, Role.LABEL)) {
            assertFalse(text.contains("mm") || text.contains("\u03c3"), text);
        }
        for (Role role : new Role[] {Role.OBJECT_ELLIPSE, Role.GRIP_ELLIPSE}) {
            for (Shape s : overlay.shapes(role)) {
                assertTrue(s.dashed());
            }
        }
        assertEquals(3, marks(overlay, Mark.WARNING));
    }

    @Test
    void bothPosesOfAnAmbiguousObjectAreDrawnWithTheirShares() {
        ThesisScene scene = ThesisScene.inPlane(4).noObjects().placement(1, 0.003)
                .cameraAt(RigidTransform.ofEuler(300, 180, 2200, 3.12, 0.03, 0.02))
                .object(5, RigidTransform.ofEuler(370, 295, 0, 0.05, 0.02, 0.9));
        Cell cell = scene.cell();
        Detections detections = scene.detections(0.3, new Well19937c(4), 1, 0.003);
        CheckUpdate update = quickLook(cell, detections);
        Overlay overlay = CellOverlay.of(cell, detections, update);
        int solid = 0;
        int dashed = 0;
        for (Shape s : overlay.shapes(Role.OBJECT_MODE)) {
            dashed += s.dashed() ? 1 : 0;
            solid += s.dashed() ? 0 : 1;
        }
        assertTrue(solid > 0 && dashed > 0);
        String label = texts(overlay, Role.LABEL).get(0);
        ObjectEstimate object = update.estimate().object(5);
        assertEquals(String.format("5: ambiguous, %.0f %% / %.0f %%", 100 * object.modes().get(0).weight(),
                100 * object.modes().get(1).weight()), label);
        assertEquals(1, marks(overlay, Mark.TWO));
    }

    @Test
    void referencesLeftOutOrNotSeenAreNamed() {
        ThesisScene scene = fine();
        List<MarkerObservation> markers = new ArrayList<>();
        for (MarkerObservation m : scene.exactDetections().markers()) {
            double[] px = m.cornersPx();
            if (m.id() == 944) {
                for (int i = 0; i < 8; i += 2) {
                    px[i] += 90;
                }
            }
            if (m.id() != 1234) {
                markers.add(new MarkerObservation(m.id(), px));
            }
        }
        ThesisScene six = ThesisScene.inPlane(6).placement(1, 0.003);
        six.exactDetections().markers().stream().filter(m -> m.id() == 7 || m.id() == 8).forEach(markers::add);
        CheckResult result = CellCheck.run(six.cell(), new Detections("scene", 1280, 720, markers), SETTINGS);
        Overlay overlay = CellOverlay.of(result);
        assertTrue(texts(overlay, Role.LABEL).contains("944 left out"), texts(overlay, Role.LABEL).toString());
        assertTrue(texts(overlay, Role.LABEL).contains("1234 not seen"));
        boolean dashed = false;
        for (Shape s : overlay.shapes(Role.REFERENCE_EXPECTED)) {
            dashed |= s.dashed();
        }
        assertTrue(dashed, "where the unseen reference should be");
    }

    @Test
    void aPhotoThatCouldNotBeCheckedShowsWhatWasDetected() {
        ThesisScene scene = fine();
        List<MarkerObservation> markers = new ArrayList<>(scene.exactDetections().markers());
        markers.add(new MarkerObservation(77, new double[] {900, 600, 930, 600, 930, 630, 900, 630}));
        Overlay overlay = CellOverlay.ofDetections(scene.cell(), new Detections("scene", 1280, 720, markers),
                Status.FAIL, "REFUSED", "No camera pose explains the corners.");
        assertEquals(4, overlay.shapes(Role.REFERENCE_OUTLINE).stream().filter(s -> s.bounds().width() > 20).count());
        assertTrue(texts(overlay, Role.BANNER).contains("REFUSED"));
        assertTrue(texts(overlay, Role.LABEL).contains("77 not in the cell file"));
        assertTrue(overlay.shapes(Role.WORLD_GRID).isEmpty());
    }

    @Test
    void sizesFollowTheImage() {
        Overlay small = overlay(fine().camera(PinholeCamera.ideal(640, 480, 300, 300, 320, 240)));
        Overlay large = overlay(fine().camera(PinholeCamera.ideal(2560, 1920, 1200, 1200, 1280, 960)));
        assertEquals(4 * small.unitPx(), large.unitPx(), 1e-12);
        assertEquals(4 * small.shapes(Role.BANNER).get(0).strokePx(),
                large.shapes(Role.BANNER).get(0).strokePx(), 1e-9);
    }
}
