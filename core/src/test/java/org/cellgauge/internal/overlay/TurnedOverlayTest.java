package org.cellgauge.internal.overlay;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.EnumSet;
import java.util.List;
import java.util.Set;
import java.util.stream.Stream;
import org.cellgauge.cell.Cell;
import org.cellgauge.check.CellCheck;
import org.cellgauge.check.CheckResult;
import org.cellgauge.check.CheckUpdate;
import org.cellgauge.check.ThesisScene;
import org.cellgauge.geometry.BrownLens;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.settings.CheckSettings;
import org.cellgauge.vision.Detections;
import org.cellgauge.vision.MarkerObservation;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * An overlay for a turned display: the same shapes, turned; texts upright, where the turned image has room for them.
 */
class TurnedOverlayTest {
    private static final CheckSettings SETTINGS = CheckSettings.builder().threads(1).build();
    private static final ThesisScene SCENE = ThesisScene.inPlane(4).placement(1, 0.003).pixelStd(0.05).target(3)
            .grip(20, 0, 0, 100).camera(distorted())
            .cameraAt(RigidTransform.ofEuler(280, -350, 900, 3.55, 0.05, 0.02));
    private static final Cell CELL = SCENE.cell();
    private static final CheckResult RESULT = CellCheck.run(CELL, withStranger(SCENE.exactDetections()), SETTINGS);

    /** Things that are part of the image and turn with it. */
    private static final Set<Role> IN_THE_IMAGE = EnumSet.of(Role.WORLD_GRID, Role.REFERENCE_OUTLINE,
            Role.REFERENCE_EXPECTED, Role.OBJECT_OUTLINE, Role.FOREIGN_OUTLINE, Role.OBJECT_AXIS_X, Role.OBJECT_AXIS_Y,
            Role.OBJECT_AXIS_Z, Role.OBJECT_ELLIPSE, Role.GRIP_ELLIPSE, Role.GRIP_LINE);

    private static PinholeCamera distorted() {
        double[] v = ThesisScene.CAMERA.intrinsics();
        v[BrownLens.K1] = -0.2;
        v[BrownLens.P1] = 0.001;
        return PinholeCamera.of(1280, 720, v);
    }

    private static Detections withStranger(Detections seen) {
        List<MarkerObservation> markers = new ArrayList<>(seen.markers());
        markers.add(new MarkerObservation(77, new double[] {900, 40, 930, 40, 930, 70, 900, 70}));
        return new Detections(seen.imageName(), seen.widthPx(), seen.heightPx(), markers);
    }

    static Stream<ImageOrientation> orientations() {
        return Stream.of(false, true).flatMap(m -> Stream.of(0, 1, 2, 3).map(q -> ImageOrientation.of(q, m)));
    }

    private static OverlayStyle bare(ImageOrientation orientation) {
        return OverlayStyle.PHOTO.withoutPanels().withOrientation(orientation);
    }

    private static List<double[]> strokes(Overlay overlay, Role role) {
        List<double[]> strokes = new ArrayList<>();
        for (Shape s : overlay.shapes(role)) {
            strokes.addAll(s.strokes());
        }
        return strokes;
    }

    @ParameterizedTest
    @MethodSource("orientations")
    void whatIsPartOfTheImageIsTurnedWithIt(ImageOrientation orientation) {
        Overlay plain = CellOverlay.of(RESULT, bare(ImageOrientation.IDENTITY));
        Overlay turned = CellOverlay.of(RESULT, bare(orientation));
        assertEquals(orientation.uprightWidthPx(1280, 720), turned.widthPx());
        assertEquals(orientation.uprightHeightPx(1280, 720), turned.heightPx());
        assertEquals(plain.status(), turned.status());
        for (Role role : IN_THE_IMAGE) {
            List<double[]> expected = strokes(plain, role);
            List<double[]> actual = strokes(turned, role);
            assertEquals(expected.size(), actual.size(), role.toString());
            assertTrue(!expected.isEmpty(), role.toString());
            if (role == Role.OBJECT_ELLIPSE || role == Role.GRIP_ELLIPSE) {
                continue;
            }
            for (int i = 0; i < expected.size(); i++) {
                assertArrayEquals(orientation.map(expected.get(i), 1280, 720), actual.get(i), 1e-6, role.toString());
            }
        }
    }

    /**
     * Ellipses may be drawn larger or smaller where their unit of length differs, but in one magnification all of them.
     */
    @ParameterizedTest
    @MethodSource("orientations")
    void ellipsesAreTurnedWithTheImage(ImageOrientation orientation) {
        Overlay plain = CellOverlay.of(RESULT, bare(ImageOrientation.IDENTITY));
        Overlay turned = CellOverlay.of(RESULT, bare(orientation));
        double ratio = turned.magnification() / plain.magnification();
        for (Role role : EnumSet.of(Role.OBJECT_ELLIPSE, Role.GRIP_ELLIPSE)) {
            for (int i = 0; i < plain.shapes(role).size(); i++) {
                var a = ((EllipseShape) plain.shapes(role).get(i)).ellipse();
                var b = ((EllipseShape) turned.shapes(role).get(i)).ellipse();
                // the ends of the longer axis, in either order
                double[] tip = {a.centreX() + ratio * a.semiMajor() * Math.cos(a.angleRad()),
                    a.centreY() + ratio * a.semiMajor() * Math.sin(a.angleRad())};
                double[] mapped = orientation.map(tip[0], tip[1], 1280, 720);
                double du = Math.abs(mapped[0] - b.centreX());
                double dv = Math.abs(mapped[1] - b.centreY());
                assertEquals(b.semiMajor() * Math.abs(Math.cos(b.angleRad())), du, 1e-6);
                assertEquals(b.semiMajor() * Math.abs(Math.sin(b.angleRad())), dv, 1e-6);
                assertTrue(b.semiMinor() < b.semiMajor());
                double sense = (mapped[0] - b.centreX()) * Math.cos(b.angleRad())
                        + (mapped[1] - b.centreY()) * Math.sin(b.angleRad());
                assertEquals(b.semiMajor(), Math.abs(sense), 1e-6);
            }
        }
    }

    @ParameterizedTest
    @MethodSource("orientations")
    void everythingLiesInTheUprightImageAndLabelsCoverNothing(ImageOrientation orientation) {
        for (boolean panels : new boolean[] {true, false}) {
            OverlayStyle style = panels ? OverlayStyle.PHOTO.withOrientation(orientation) : bare(orientation);
            assertNothingIsCovered(CellOverlay.of(RESULT, style), orientation.toString());
        }
        // as on a phone held upright
        OverlayStyle large = bare(orientation).legible(720, 1280, ViewFit.fit(720, 1280, 240, 1280 / 3.0), 8.5);
        assertEquals(2, large.letterScale(), 1e-9);
        assertNothingIsCovered(CellOverlay.of(RESULT, large), orientation + ", large letters");
    }

    private static void assertNothingIsCovered(Overlay overlay, String what) {
        Box image = new Box(-1e-9, -1e-9, overlay.widthPx() + 1e-9, overlay.heightPx() + 1e-9);
        List<Box> labels = new ArrayList<>();
        List<Box> others = new ArrayList<>();
        for (Shape s : overlay.shapes()) {
            assertTrue(image.contains(s.bounds()), s.role() + " " + s.bounds() + " in " + image);
            boolean panel = s instanceof PanelShape;
            if (s.role() == Role.LABEL && panel) {
                labels.add(s.bounds());
            } else if (panel || s.role() == Role.OBJECT_OUTLINE) {
                others.add(s.bounds());
            }
        }
        assertEquals(3, labels.size());
        for (int i = 0; i < 3; i++) {
            for (int k = 0; k < i; k++) {
                assertEquals(0, labels.get(i).overlap(labels.get(k)));
            }
            for (Box other : others) {
                assertEquals(0, labels.get(i).overlap(other), what + ": " + labels.get(i) + " and " + other);
            }
        }
    }

    @ParameterizedTest
    @MethodSource("orientations")
    void textsAreTheSameHoweverTheImageIsTurned(ImageOrientation orientation) {
        List<String> expected = texts(CellOverlay.of(RESULT, bare(ImageOrientation.IDENTITY)));
        assertEquals(expected, texts(CellOverlay.of(RESULT, bare(orientation))));
        assertTrue(expected.stream().anyMatch(t -> t.startsWith("5: ")), expected.toString());
    }

    private static List<String> texts(Overlay overlay) {
        List<String> texts = new ArrayList<>();
        for (Shape s : overlay.shapes()) {
            if (s instanceof TextShape) {
                texts.add(((TextShape) s).text());
            }
        }
        return texts;
    }

    @Test
    void withoutPanelsThereIsNeitherBannerNorLegend() {
        CheckUpdate first = CellCheck.stream(CELL, RESULT.detections(), SETTINGS).blockingFirst();
        for (Overlay overlay : List.of(CellOverlay.of(RESULT, bare(ImageOrientation.of(1, false))),
                CellOverlay.of(CELL, RESULT.detections(), first, bare(ImageOrientation.IDENTITY)),
                CellOverlay.of(CELL, RESULT.detections(), first.estimate(), bare(ImageOrientation.of(3, true))),
                CellOverlay.ofDetections(CELL, RESULT.detections(), Status.FAIL, "REFUSED", "Why.",
                        bare(ImageOrientation.of(2, false))))) {
            assertEquals(List.of(), overlay.shapes(Role.BANNER));
            assertEquals(List.of(), overlay.shapes(Role.LEGEND));
            assertEquals(4, overlay.shapes(Role.REFERENCE_OUTLINE).size());
            assertEquals(1, overlay.shapes(Role.FOREIGN_OUTLINE).size());
        }
        Overlay with = CellOverlay.of(RESULT, OverlayStyle.PHOTO.withOrientation(ImageOrientation.of(1, false)));
        assertTrue(!with.shapes(Role.BANNER).isEmpty() && !with.shapes(Role.LEGEND).isEmpty());
    }
}
