package org.cellgauge.desktop;

import java.awt.AlphaComposite;
import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.geom.Path2D;
import java.awt.geom.RoundRectangle2D;
import java.awt.image.BufferedImage;
import java.util.List;
import org.cellgauge.internal.overlay.Box;
import org.cellgauge.internal.overlay.Overlay;
import org.cellgauge.internal.overlay.PanelShape;
import org.cellgauge.internal.overlay.Shape;
import org.cellgauge.internal.overlay.ShapePaint;
import org.cellgauge.vision.GreyImage;

/** Paints an overlay over its photo, without a window system and without fonts. */
public final class OverlayPainter {
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
                // setRGB would pass every pixel through a colour model
                image.getRaster().setDataElements(0, y, row.length, 1, row);
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
        ShapePaint paint = ShapePaint.of(shape, unit);
        java.awt.Shape path = shape instanceof PanelShape ? panel(shape.bounds(), unit) : path(shape.strokes());
        if (paint.fillArgb() != 0) {
            g.setColor(new Color(paint.fillArgb(), true));
            g.fill(path);
        }
        if (paint.rimArgb() != 0) {
            g.setColor(new Color(paint.rimArgb(), true));
            g.setStroke(stroke(shape, paint.rimPx(), unit));
            g.draw(path);
        }
        g.setColor(new Color(paint.lineArgb(), true));
        g.setStroke(stroke(shape, paint.linePx(), unit));
        g.draw(path);
    }

    private static java.awt.Shape panel(Box b, double unit) {
        double diameter = 2 * ShapePaint.panelRadiusPx(unit);
        return new RoundRectangle2D.Double(b.left(), b.top(), b.width(), b.height(), diameter, diameter);
    }

    private static BasicStroke stroke(Shape shape, double width, double unit) {
        if (!shape.dashed()) {
            return new BasicStroke((float) width, BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND);
        }
        return new BasicStroke((float) width, BasicStroke.CAP_BUTT, BasicStroke.JOIN_ROUND, 10,
                ShapePaint.dashesPx(unit), 0);
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
}
