package org.cellgauge.desktop;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.image.BufferedImage;
import java.io.File;
import java.net.URISyntaxException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import org.cellgauge.internal.overlay.Box;
import org.cellgauge.internal.overlay.EllipseShape;
import org.cellgauge.internal.overlay.Mark;
import org.cellgauge.internal.overlay.MarkShape;
import org.cellgauge.internal.overlay.Overlay;
import org.cellgauge.internal.overlay.PanelShape;
import org.cellgauge.internal.overlay.Polyline;
import org.cellgauge.internal.overlay.Role;
import org.cellgauge.internal.overlay.Status;
import org.cellgauge.internal.overlay.TextShape;
import org.cellgauge.statistics.Ellipse;
import org.cellgauge.vision.GreyImage;
import org.junit.jupiter.api.Test;

class OverlayPainterTest {
    private static Overlay sample() {
        return new Overlay(640, 480, Status.PASS, 1, 100, List.of(
                new Polyline(Role.OBJECT_OUTLINE, Status.PASS, 5, false, 20, 50.5, 100, 50.5),
                new Polyline(Role.OBJECT_OUTLINE, Status.FAIL, 5, false, 20, 80.5, 100, 80.5),
                new Polyline(Role.WORLD_AXIS_X, Status.NEUTRAL, 5, true, 20, 100, 300, 100),
                new EllipseShape(Role.OBJECT_ELLIPSE, Status.PASS, 2, false, new Ellipse(200, 60, 30, 20, 0)),
                new PanelShape(Role.BANNER, Status.PASS, 1, new Box(10, 150, 310, 230)),
                new MarkShape(Role.BANNER, Status.PASS, 3, Mark.CHECK, 40, 190, 12),
                new TextShape(Role.BANNER, Status.NEUTRAL, 0.15, 60, 200, 20, "\u03c3 0.5 mm")));
    }

    private static GreyImage grey(int value, int width, int height) {
        byte[] pixels = new byte[width * height];
        Arrays.fill(pixels, (byte) value);
        return GreyImage.packed(pixels, width, height);
    }

    @Test
    void pixelsAwayFromShapesStayAsInThePhoto() {
        BufferedImage image = OverlayPainter.paint(grey(200, 640, 480), sample());
        assertEquals(0xFFC8C8C8, image.getRGB(5, 5));
        assertEquals(0xFFC8C8C8, image.getRGB(310, 130));
    }

    @Test
    void linesShowOnBrightAndOnDarkPhotosAndStatusesDiffer() {
        for (int value : new int[] {0, 255}) {
            BufferedImage image = OverlayPainter.paint(grey(value, 640, 480), sample());
            int pass = image.getRGB(60, 50);
            int fail = image.getRGB(60, 80);
            assertNotEquals(pass, fail);
            assertTrue(luminance(pass) > 60 && luminance(fail) > 60, "on dark");
            // the rim beside the line is darker than a bright photo
            assertTrue(luminance(image.getRGB(60, 47)) < 130, "rim");
        }
    }

    private static double luminance(int rgb) {
        return 0.299 * (rgb >> 16 & 255) + 0.587 * (rgb >> 8 & 255) + 0.114 * (rgb & 255);
    }

    @Test
    void lettersAreLightOnADarkPanelWhateverThePhoto() {
        for (int value : new int[] {0, 255}) {
            BufferedImage image = OverlayPainter.paint(grey(value, 640, 480), sample());
            int light = 0;
            int dark = 0;
            for (int y = 180; y < 204; y++) {
                for (int x = 60; x < 160; x++) {
                    light += luminance(image.getRGB(x, y)) > 200 ? 1 : 0;
                    dark += luminance(image.getRGB(x, y)) < 80 ? 1 : 0;
                }
            }
            assertTrue(light > 150, light + " light pixels");
            assertTrue(dark > 800, dark + " dark pixels");
        }
    }

    @Test
    void withoutAPhotoTheCanvasIsPlain() {
        BufferedImage image = OverlayPainter.paint((GreyImage) null, sample());
        assertEquals(640, image.getWidth());
        assertEquals(480, image.getHeight());
        assertEquals(image.getRGB(5, 5), image.getRGB(315, 5));
        assertTrue(luminance(image.getRGB(5, 5)) < 100);
    }

    @Test
    void aPhotoInColourIsNotChanged() {
        BufferedImage photo = new BufferedImage(640, 480, BufferedImage.TYPE_INT_RGB);
        photo.setRGB(60, 50, 0x123456);
        photo.setRGB(5, 5, 0x123456);
        BufferedImage image = OverlayPainter.paint(photo, sample());
        assertEquals(0xFF123456, photo.getRGB(60, 50));
        assertEquals(0xFF123456, image.getRGB(5, 5));
        assertNotEquals(0xFF123456, image.getRGB(60, 50));
    }

    @Test
    void aPhotoOfAnotherSizeIsRefused() {
        assertThrows(IllegalArgumentException.class, () -> OverlayPainter.paint(grey(0, 641, 480), sample()));
        assertThrows(IllegalArgumentException.class,
                () -> OverlayPainter.paint(new BufferedImage(640, 481, BufferedImage.TYPE_INT_RGB), sample()));
    }

    /** Machines without a window system often have no fonts, and Java fails when it looks for them. */
    @Test
    void fontsAreNeverTouched() throws Exception {
        String java = Path.of(System.getProperty("java.home"), "bin", "java").toString();
        String classes = String.join(File.pathSeparator, place(PaintOnce.class), place(OverlayPainter.class),
                place(Overlay.class));
        Process process = new ProcessBuilder(java, "-Djava.awt.headless=true", "-Xlog:class+load", "-cp", classes,
                PaintOnce.class.getName()).redirectErrorStream(true).start();
        String log = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
        assertEquals(0, process.waitFor(), log.substring(Math.max(0, log.length() - 2000)));
        assertTrue(log.contains("org.cellgauge.desktop.OverlayPainter "), "the log names loaded classes");
        assertFalse(log.contains(" sun.font.FontManager"), "a font manager was loaded");
        assertFalse(log.contains(" sun.awt.FontConfiguration"), "fonts were looked for");
    }

    private static String place(Class<?> type) throws URISyntaxException {
        return Path.of(type.getProtectionDomain().getCodeSource().getLocation().toURI()).toString();
    }

    /** Paints the sample in a process of its own. */
    public static final class PaintOnce {
        private PaintOnce() {
        }

        /**
         * Paints.
         *
         * @param args none
         */
        public static void main(String[] args) {
            OverlayPainter.paint((GreyImage) null, sample());
        }
    }
}
