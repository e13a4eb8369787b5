package org.cellgauge.cli;

import java.awt.AlphaComposite;
import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.geom.Path2D;
import java.awt.geom.RoundRectangle2D;
import java.awt.image.BufferedImage;
import java.util.List;
import org.cellgauge.overlay.Box;
import org.cellgauge.overlay.EllipseShape;
import org.cellgauge.overlay.Overlay;
import org.cellgauge.overlay.PanelShape;
import org.cellgauge.overlay.Role;
import org.cellgauge.overlay.Shape;
import org.cellgauge.overlay.Status;
import org.cellgauge.overlay.TextShape;
import org.cellgauge.vision.GreyImage;

/**
 * Paints an overlay over its photo, without a window system and without fonts.
 *
 * <p>Colours are those of Okabe and Ito ("Color Universal Design", 2008), which people with any of the common colour
 * vision deficiencies tell apart, the green and the blue a little lighter for dark photos. Every line lies on a dark
 * rim, so that it shows on bright and on dark photos.
 */
public final class OverlayPainter {
    private static final Color ORANGE = new Color(0xE69F00);
    private static final Color SKY_BLUE = new Color(0x56B4E9);
    private static final Color GREEN = new Color(0x14B98A);
    private static final Color YELLOW = new Color(0xF0E442);
    private static final Color VERMILLION = new Color(0xD55E00);
    private static final Color PURPLE = new Color(0xCC79A7);
    private static final Color BLUE = new Color(0x2E93D8);
    private static final Color GRID = new Color(255, 255, 255, 110);
    private static final Color GRID_RIM = new Color(0, 0, 0, 35);
    private static final Color RIM = new Color(0, 0, 0, 190);
    private static final Color PANEL = new Color(16, 18, 22, 205);
    private static final Color CANVAS = new Color(58, 60, 64);

    private OverlayPainter() {
    }

    /**
     * Paints an overlay over a grey photo.
     *
     * @param photo the photo, of the overlay's size, or null: a plain dark canvas takes its place
     * @param overlay what to draw
     * @return a new image in RGB of the overlay's size
     * @throws IllegalArgumentException if the photo is of another size
     */
    public static BufferedImage paint(GreyImage photo, Overlay overlay) {
        BufferedImage image = new BufferedImage(overlay.widthPx(), overlay.heightPx(), BufferedImage.TYPE_INT_RGB);
        if (photo == null) {
            Graphics2D g = image.createGraphics();
            g.setColor(CANVAS);
            g.fillRect(0, 0, image.getWidth(), image.getHeight());
            g.dispose();
        } else {
            requireSize(photo.widthPx(), photo.heightPx(), overlay);
            int[] row = new int[photo.widthPx()];
            for (int y = 0; y < photo.heightPx(); y++) {
                for (int x = 0; x < row.length; x++) {
                    row[x] = 0x010101 * photo.get(x, y);
                }
                image.setRGB(0, y, row.length, 1, row, 0, row.length);
            }
        }
        draw(image, overlay);
        return image;
    }

    /**
     * Paints an overlay over a photo in colour.
     *
     * @param photo the photo, of the overlay's size; it is not changed
     * @param overlay what to draw
     * @return a new image in RGB
     * @throws IllegalArgumentException if the photo is of another size
     */
    public static BufferedImage paint(BufferedImage photo, Overlay overlay) {
        requireSize(photo.getWidth(), photo.getHeight(), overlay);
        BufferedImage image = new BufferedImage(overlay.widthPx(), overlay.heightPx(), BufferedImage.TYPE_INT_RGB);
        Graphics2D g = image.createGraphics();
        g.setColor(Color.WHITE);
        g.fillRect(0, 0, image.getWidth(), image.getHeight());
        g.drawImage(photo, 0, 0, null);
        g.dispose();
        draw(image, overlay);
        return image;
    }

    private static void requireSize(int width, int height, Overlay overlay) {
        if (width != overlay.widthPx() || height != overlay.heightPx()) {
            throw new IllegalArgumentException("the photo is " + width + " x " + height + " px, the overlay "
                    + overlay.widthPx() + " x " + overlay.heightPx());
        }
    }

    private static void draw(BufferedImage image, Overlay overlay) {
        Graphics2D g = image.createGraphics();
        g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        g.setRenderingHint(RenderingHints.KEY_STROKE_CONTROL, RenderingHints.VALUE_STROKE_PURE);
        g.setComposite(AlphaComposite.SrcOver);
        for (Shape shape : overlay.shapes()) {
            draw(g, shape, overlay.unitPx());
        }
        g.dispose();
    }

    private static void draw(Graphics2D g, Shape shape, double unit) {
        Color colour = colour(shape);
        if (shape instanceof PanelShape) {
            Box b = shape.bounds();
            double round = 6 * unit;
            RoundRectangle2D panel = new RoundRectangle2D.Double(b.left(), b.top(), b.width(), b.height(), round,
                    round);
            g.setColor(PANEL);
            g.fill(panel);
            g.setColor(colour);
            g.setStroke(new BasicStroke((float) shape.strokePx()));
            g.draw(panel);
            return;
        }
        Path2D path = path(shape.strokes());
        if (shape instanceof EllipseShape) {
            g.setColor(new Color(colour.getRed(), colour.getGreen(), colour.getBlue(), shape.dashed() ? 25 : 60));
            g.fill(path);
        }
        g.setColor(shape.role() == Role.WORLD_GRID ? GRID_RIM : RIM);
        g.setStroke(stroke(shape, shape.strokePx() + rim(shape) * unit, unit));
        g.draw(path);
        g.setColor(colour);
        g.setStroke(stroke(shape, shape.strokePx(), unit));
        g.draw(path);
    }

    /** By how much the dark rim is wider than the line, in units. */
    private static double rim(Shape shape) {
        if (shape.role() == Role.REFERENCE_EXPECTED) {
            return 0.6;     // narrow, so as not to hide the detected outline that it is to be compared with
        }
        return shape instanceof TextShape ? 2.6 : 2;
    }

    private static BasicStroke stroke(Shape shape, double width, double unit) {
        if (!shape.dashed()) {
            return new BasicStroke((float) width, BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND);
        }
        return new BasicStroke((float) width, BasicStroke.CAP_BUTT, BasicStroke.JOIN_ROUND, 10,
                new float[] {(float) (4 * unit), (float) (3 * unit)}, 0);
    }

    private static Path2D path(List<double[]> strokes) {
        Path2D path = new Path2D.Double();
        for (double[] s : strokes) {
            path.moveTo(s[0], s[1]);
            for (int i = 2; i < s.length; i += 2) {
                path.lineTo(s[i], s[i + 1]);
            }
        }
        return path;
    }

    private static Color colour(Shape shape) {
        switch (shape.role()) {
            case WORLD_GRID:
                return GRID;
            case WORLD_AXIS_X:
            case OBJECT_AXIS_X:
                return VERMILLION;
            case WORLD_AXIS_Y:
            case OBJECT_AXIS_Y:
                return GREEN;
            case WORLD_AXIS_Z:
            case OBJECT_AXIS_Z:
                return BLUE;
            case REFERENCE_OUTLINE:
                return shape.status() == Status.FAIL ? VERMILLION : Color.WHITE;
            case REFERENCE_EXPECTED:
                return YELLOW;
            default:
                break;
        }
        boolean plainText = shape instanceof TextShape && shape.status() == Status.NEUTRAL;
        return plainText ? Color.WHITE : colour(shape.status());
    }

    private static Color colour(Status status) {
        switch (status) {
            case PASS:
                return GREEN;
            case FAIL:
                return VERMILLION;
            case NOT_CONVERGED:
                return PURPLE;
            case AMBIGUOUS:
                return ORANGE;
            default:
                return SKY_BLUE;
        }
    }
}
