package org.cellgauge.internal.overlay;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.HashSet;
import java.util.Set;
import org.cellgauge.statistics.Ellipse;
import org.junit.jupiter.api.Test;

class ShapePaintTest {
    private static final double UNIT_PX = 1.5;

    private static Polyline line(Role role, Status status) {
        return new Polyline(role, status, 2, false, 0, 0, 10, 0);
    }

    private static EllipseShape ellipse(boolean dashed) {
        return new EllipseShape(Role.OBJECT_ELLIPSE, Status.PASS, 2, dashed, new Ellipse(5, 5, 3, 2, 0));
    }

    @Test
    void everyVerdictHasAColourOfItsOwn() {
        Set<Integer> colours = new HashSet<>();
        for (Status status : Status.values()) {
            int argb = ShapePaint.of(line(Role.OBJECT_OUTLINE, status), UNIT_PX).lineArgb();
            assertEquals(0xFF, argb >>> 24, status + " is opaque");
            assertTrue(colours.add(argb), status.toString());
        }
    }

    @Test
    void aReferenceThatIsWrongDiffersFromOneThatIsNot() {
        assertTrue(ShapePaint.of(line(Role.REFERENCE_OUTLINE, Status.FAIL), UNIT_PX).lineArgb()
                != ShapePaint.of(line(Role.REFERENCE_OUTLINE, Status.NEUTRAL), UNIT_PX).lineArgb());
    }

    @Test
    void linesLieOnADarkRimThatIsWider() {
        for (Role role : Role.values()) {
            ShapePaint paint = ShapePaint.of(line(role, Status.NEUTRAL), UNIT_PX);
            assertEquals(0, paint.rimArgb() & 0xFFFFFF, role.toString());
            assertTrue(paint.rimArgb() != 0 && paint.rimPx() > paint.linePx(), role.toString());
            assertEquals(2, paint.linePx(), 0);
            assertEquals(0, paint.fillArgb());
        }
    }

    @Test
    void ellipsesAreFilledSoThatThePhotoShowsThroughAndPreliminaryOnesFainter() {
        int fill = ShapePaint.of(ellipse(false), UNIT_PX).fillArgb();
        int dashed = ShapePaint.of(ellipse(true), UNIT_PX).fillArgb();
        assertEquals(ShapePaint.of(ellipse(false), UNIT_PX).lineArgb() & 0xFFFFFF, fill & 0xFFFFFF);
        assertTrue((dashed >>> 24) > 0 && (dashed >>> 24) < (fill >>> 24) && (fill >>> 24) < 0x80);
    }

    @Test
    void panelsAreDarkAndHaveNoRim() {
        ShapePaint panel = ShapePaint.of(new PanelShape(Role.LABEL, Status.PASS, 1, new Box(0, 0, 9, 9)), UNIT_PX);
        assertEquals(0, panel.rimArgb());
        for (int shift = 0; shift < 24; shift += 8) {
            assertTrue((panel.fillArgb() >> shift & 0xFF) < 0x30);
        }
        assertTrue((panel.fillArgb() >>> 24) > 0xA0);
    }
}
