package org.cellgauge.android.screen;

import android.graphics.Bitmap;
import android.graphics.Canvas;
import android.graphics.DashPathEffect;
import android.graphics.Paint;
import android.graphics.Path;
import android.graphics.PathEffect;
import java.util.ArrayList;
import java.util.List;
import org.cellgauge.internal.overlay.Box;
import org.cellgauge.internal.overlay.Overlay;
import org.cellgauge.internal.overlay.PanelShape;
import org.cellgauge.internal.overlay.Pen;
import org.cellgauge.internal.overlay.Shape;
import org.cellgauge.internal.overlay.ShapePaint;
import org.cellgauge.vision.GreyImage;

/**
 * Paints an overlay with Android's graphics, as the command line's pictures are.
 *
 * <p>{@link #prepare(Overlay)} turns shapes into paths once; {@link #draw(Canvas)} then allocates nothing. One painter
 * belongs to one thread.
 */
public final class OverlayPainter {
    private static final int OPAQUE = 0xFF000000;

    private final Paint fill = new Paint(Paint.ANTI_ALIAS_FLAG);
    private final Paint line = new Paint(Paint.ANTI_ALIAS_FLAG);
    private final List<Item> items = new ArrayList<>();
    private int count;
    private PathEffect dashes;
    private double dashesUnitPx = Double.NaN;

    /** One shape as it is drawn, in a path that is used again for the next overlay. */
    private static final class Item implements Pen {
        private final Path path = new Path();
        private ShapePaint paint;
        private boolean dashed;

        @Override
        public void moveTo(double u, double v) {
            path.moveTo((float) u, (float) v);
        }

        @Override
        public void lineTo(double u, double v) {
            path.lineTo((float) u, (float) v);
        }
    }

    /** A painter without an overlay. */
    public OverlayPainter() {
        fill.setStyle(Paint.Style.FILL);
        line.setStyle(Paint.Style.STROKE);
        line.setStrokeJoin(Paint.Join.ROUND);
    }

    /**
     * Paints an overlay over a grey photo.
     *
     * @param photo the photo, of the overlay's size
     * @param overlay what to draw
     * @return a new bitmap of the overlay's size
     * @throws IllegalArgumentException if the photo is of another size
     */
    public static Bitmap paint(GreyImage photo, Overlay overlay) {
        if (photo.widthPx() != overlay.widthPx() || photo.heightPx() != overlay.heightPx()) {
            throw new IllegalArgumentException("the photo is " + photo.widthPx() + " x " + photo.heightPx()
                    + " px, the overlay " + overlay.widthPx() + " x " + overlay.heightPx());
        }
        Bitmap bitmap = bitmap(photo, 1);
        OverlayPainter painter = new OverlayPainter();
        painter.prepare(overlay);
        painter.draw(new Canvas(bitmap));
        return bitmap;
    }

    /**
     * A grey photo as a bitmap.
     *
     * @param photo the photo
     * @param step every how many pixels of a row, and every how many rows, one is taken: 1 for all
     * @return a new mutable bitmap
     */
    static Bitmap bitmap(GreyImage photo, int step) {
        int width = (photo.widthPx() + step - 1) / step;
        int height = (photo.heightPx() + step - 1) / step;
        Bitmap bitmap = Bitmap.createBitmap(width, height, Bitmap.Config.ARGB_8888);
        byte[] luminance = photo.luminance();
        int[] row = new int[width];
        for (int y = 0; y < height; y++) {
            int from = photo.offset() + y * step * photo.rowStride();
            for (int x = 0; x < width; x++) {
                row[x] = OPAQUE | 0x010101 * (luminance[from + x * step] & 0xFF);
            }
            bitmap.setPixels(row, 0, width, 0, y, width, 1);
        }
        return bitmap;
    }

    /**
     * Takes over what to draw.
     *
     * @param overlay the overlay, or null for nothing
     */
    public void prepare(Overlay overlay) {
        count = 0;
        if (overlay == null) {
            return;
        }
        double unit = overlay.unitPx();
        if (unit != dashesUnitPx) {
            dashes = new DashPathEffect(ShapePaint.dashesPx(unit), 0);
            dashesUnitPx = unit;
        }
        for (Shape shape : overlay.shapes()) {
            if (count == items.size()) {
                items.add(new Item());
            }
            prepare(items.get(count++), shape, unit);
        }
    }

    private static void prepare(Item item, Shape shape, double unit) {
        item.path.rewind();
        item.paint = ShapePaint.of(shape, unit);
        item.dashed = shape.dashed();
        if (shape instanceof PanelShape) {
            Box b = shape.bounds();
            float radius = (float) ShapePaint.panelRadiusPx(unit);
            item.path.addRoundRect((float) b.left(), (float) b.top(), (float) b.right(), (float) b.bottom(), radius,
                    radius, Path.Direction.CW);
            return;
        }
        shape.draw(item);
    }

    /**
     * Draws the prepared overlay in the coordinates of its image.
     *
     * @param canvas where to draw, its matrix taking image px to where they belong
     */
    public void draw(Canvas canvas) {
        for (int i = 0; i < count; i++) {
            Item item = items.get(i);
            ShapePaint paint = item.paint;
            if (paint.fillArgb() != 0) {
                fill.setColor(paint.fillArgb());
                canvas.drawPath(item.path, fill);
            }
            line.setPathEffect(item.dashed ? dashes : null);
            line.setStrokeCap(item.dashed ? Paint.Cap.BUTT : Paint.Cap.ROUND);
            if (paint.rimArgb() != 0) {
                drawLine(canvas, item.path, paint.rimArgb(), paint.rimPx());
            }
            drawLine(canvas, item.path, paint.lineArgb(), paint.linePx());
        }
    }

    private void drawLine(Canvas canvas, Path path, int argb, double widthPx) {
        line.setColor(argb);
        line.setStrokeWidth((float) widthPx);
        canvas.drawPath(path, line);
    }
}
