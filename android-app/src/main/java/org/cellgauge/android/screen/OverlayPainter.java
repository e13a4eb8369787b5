package org.cellgauge.android.screen;

import android.graphics.Bitmap;
import android.graphics.Canvas;
import android.graphics.DashPathEffect;
import android.graphics.Paint;
import android.graphics.Path;
import android.graphics.PathEffect;
import java.util.ArrayList;
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
 * Paints an overlay with Android's graphics, in the colours, strokes, rims and dashes of the command line's pictures.
 *
 * <p>Colours are those of Okabe and Ito ("Color Universal Design", 2008), which people with any of the common colour
 * vision deficiencies tell apart, the green and the blue a little lighter for dark photos. Every line lies on a dark
 * rim, so that it shows on bright and on dark photos.
 *
 * <p>{@link #prepare(Overlay)} turns shapes into paths once; {@link #draw(Canvas)} then allocates nothing. One painter
 * belongs to one thread.
 */
public final class OverlayPainter {
    static final int ORANGE = 0xFFE69F00;
    static final int SKY_BLUE = 0xFF56B4E9;
    static final int GREEN = 0xFF14B98A;
    static final int YELLOW = 0xFFF0E442;
    static final int VERMILLION = 0xFFD55E00;
    static final int PURPLE = 0xFFCC79A7;
    static final int BLUE = 0xFF2E93D8;
    static final int WHITE = 0xFFFFFFFF;
    private static final int GRID = 0x6EFFFFFF;
    private static final int GRID_RIM = 0x23000000;
    private static final int RIM = 0xBE000000;
    private static final int PANEL = 0xCD101216;
    private static final int OPAQUE = 0xFF000000;
    private static final int RGB = 0x00FFFFFF;
    private static final int FILL_ALPHA = 60;
    private static final int DASHED_FILL_ALPHA = 25;

    private final Paint fill = new Paint(Paint.ANTI_ALIAS_FLAG);
    private final Paint line = new Paint(Paint.ANTI_ALIAS_FLAG);
    private final List<Item> items = new ArrayList<>();
    private int count;
    private PathEffect dashes;
    private double dashesUnitPx = Double.NaN;

    /** One shape as it is drawn; used again for the next overlay. */
    private static final class Item {
        private final Path path = new Path();
        private int fillColour;
        private int rimColour;
        private float rimPx;
        private int colour;
        private float strokePx;
        private boolean dashed;
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
            dashes = new DashPathEffect(new float[] {(float) (4 * unit), (float) (3 * unit)}, 0);
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
        item.colour = colour(shape);
        item.strokePx = (float) shape.strokePx();
        item.dashed = shape.dashed();
        if (shape instanceof PanelShape) {
            Box b = shape.bounds();
            float round = (float) (3 * unit);
            item.path.addRoundRect((float) b.left(), (float) b.top(), (float) b.right(), (float) b.bottom(), round,
                    round, Path.Direction.CW);
            item.fillColour = PANEL;
            item.rimColour = 0;
            return;
        }
        for (double[] s : shape.strokes()) {
            item.path.moveTo((float) s[0], (float) s[1]);
            for (int i = 2; i < s.length; i += 2) {
                item.path.lineTo((float) s[i], (float) s[i + 1]);
            }
        }
        int alpha = shape.dashed() ? DASHED_FILL_ALPHA : FILL_ALPHA;
        item.fillColour = shape instanceof EllipseShape ? alpha << 24 | item.colour & RGB : 0;
        item.rimColour = shape.role() == Role.WORLD_GRID ? GRID_RIM : RIM;
        item.rimPx = (float) (shape.strokePx() + rim(shape) * unit);
    }

    /**
     * Draws the prepared overlay in the coordinates of its image.
     *
     * @param canvas where to draw, its matrix taking image px to where they belong
     */
    public void draw(Canvas canvas) {
        for (int i = 0; i < count; i++) {
            Item item = items.get(i);
            if (item.fillColour != 0) {
                fill.setColor(item.fillColour);
                canvas.drawPath(item.path, fill);
            }
            line.setPathEffect(item.dashed ? dashes : null);
            line.setStrokeCap(item.dashed ? Paint.Cap.BUTT : Paint.Cap.ROUND);
            if (item.rimColour != 0) {
                line.setColor(item.rimColour);
                line.setStrokeWidth(item.rimPx);
                canvas.drawPath(item.path, line);
            }
            line.setColor(item.colour);
            line.setStrokeWidth(item.strokePx);
            canvas.drawPath(item.path, line);
        }
    }

    /** By how much the dark rim is wider than the line, in units. */
    private static double rim(Shape shape) {
        if (shape.role() == Role.REFERENCE_EXPECTED) {
            return 0.6;     // narrow, so as not to hide the detected outline that it is to be compared with
        }
        return shape instanceof TextShape ? 2.6 : 2;
    }

    private static int colour(Shape shape) {
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
                return shape.status() == Status.FAIL ? VERMILLION : WHITE;
            case REFERENCE_EXPECTED:
                return YELLOW;
            default:
                break;
        }
        boolean plainText = shape instanceof TextShape && shape.status() == Status.NEUTRAL;
        return plainText ? WHITE : colour(shape.status());
    }

    private static int colour(Status status) {
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
