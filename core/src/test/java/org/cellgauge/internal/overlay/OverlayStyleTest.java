package org.cellgauge.internal.overlay;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import org.cellgauge.check.CellCheck;
import org.cellgauge.check.CheckResult;
import org.cellgauge.check.ThesisScene;
import org.cellgauge.settings.CheckSettings;
import org.junit.jupiter.api.Test;

/** The size of letters; what else a style says is held where overlays are turned and translated. */
class OverlayStyleTest {
    private static final OverlayStyle BARE = OverlayStyle.PHOTO.withoutPanels();
    private static final ThesisScene SCENE = ThesisScene.inPlane(4).placement(1, 0.003).pixelStd(0.05).target(3);
    private static final CheckResult RESULT =
            CellCheck.run(SCENE.cell(), SCENE.exactDetections(), CheckSettings.builder().threads(1).build());

    private static List<Double> capsPx(Overlay overlay) {
        List<Double> caps = new ArrayList<>();
        for (Shape s : overlay.shapes()) {
            if (s instanceof TextShape && ((TextShape) s).text().contains("\u03c3")) {
                caps.add(((TextShape) s).capHeightPx());
            }
        }
        return caps;
    }

    @Test
    void whereTheImageIsShownSmallLettersAreAsHighAsWanted() {
        ViewFit third = ViewFit.fit(1280, 720, 1280 / 3.0, 240);
        Overlay overlay = CellOverlay.of(RESULT, BARE.legible(1280, 720, third, 9));
        assertEquals(3, capsPx(overlay).size());
        for (double cap : capsPx(overlay)) {
            assertEquals(9, third.scale() * cap, 1e-9);
        }
    }

    @Test
    void whereTheImageIsShownLargeLettersStayInProportionToIt() {
        OverlayStyle style = BARE.legible(1280, 720, ViewFit.fit(1280, 720, 2560, 1440), 9);
        assertEquals(1, style.letterScale(), 0);
        assertEquals(capsPx(CellOverlay.of(RESULT, BARE)), capsPx(CellOverlay.of(RESULT, style)));
    }

    @Test
    void noLetterIsSoLargeThatFiguresDoNotFitOrLabelsFillTheImage() {
        for (int turns : new int[] {0, 1}) {
            int width = turns == 0 ? 1280 : 720;
            int height = turns == 0 ? 720 : 1280;
            OverlayStyle style = BARE.withOrientation(ImageOrientation.of(turns, false));
            Overlay overlay = CellOverlay.of(RESULT,
                    style.legible(width, height, ViewFit.fit(width, height, width / 20.0, height / 20.0), 9));
            assertEquals(3, capsPx(overlay).size());
            double largest = turns == 0 ? 720 / 26.0 : 720 / 24.0;
            capsPx(overlay).forEach(cap -> assertEquals(largest, cap, 1e-9));
            double covered = 0;
            for (Shape s : overlay.shapes(Role.LABEL)) {
                assertTrue(s.bounds().left() >= 0 && s.bounds().right() <= width, s.bounds().toString());
                covered += s instanceof PanelShape ? s.bounds().width() * s.bounds().height() : 0;
            }
            assertTrue(covered < 0.2 * width * height, covered + " px of " + width * height);
        }
    }

    @Test
    void linesAndEllipsesKnowNothingOfLetters() {
        Overlay small = CellOverlay.of(RESULT, BARE);
        Overlay large = CellOverlay.of(RESULT, BARE.legible(1280, 720, ViewFit.fit(1280, 720, 320, 180), 9));
        assertEquals(small.magnification(), large.magnification(), 0);
        for (Role role : new Role[] {Role.OBJECT_ELLIPSE, Role.OBJECT_OUTLINE, Role.REFERENCE_OUTLINE,
            Role.WORLD_AXIS_X}) {
            List<Shape> lines = small.shapes(role);
            lines.removeIf(s -> s instanceof TextShape);
            List<Shape> same = large.shapes(role);
            same.removeIf(s -> s instanceof TextShape);
            assertEquals(lines.size(), same.size(), role.toString());
            for (int i = 0; i < lines.size(); i++) {
                assertEquals(lines.get(i).strokePx(), same.get(i).strokePx(), 0, role.toString());
                assertEquals(lines.get(i).bounds().toString(), same.get(i).bounds().toString(), role.toString());
            }
        }
    }

    @Test
    void heightsThatAreNoneAreRefused() {
        ViewFit fit = ViewFit.fit(1280, 720, 640, 360);
        for (double height : new double[] {-1, Double.NaN, Double.POSITIVE_INFINITY}) {
            assertThrows(IllegalArgumentException.class, () -> BARE.legible(1280, 720, fit, height));
        }
    }
}
