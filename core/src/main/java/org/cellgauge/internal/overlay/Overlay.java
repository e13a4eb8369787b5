package org.cellgauge.internal.overlay;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;

/** What to draw over one photo: shapes in image px, the first at the bottom; immutable. */
public final class Overlay {
    private final int widthPx;
    private final int heightPx;
    private final double unitPx;
    private final Status status;
    private final double magnification;
    private final double gridSpacingMm;
    private final List<Shape> shapes;

    /**
     * An overlay.
     *
     * @param widthPx width of the image it lies over
     * @param heightPx height of the image
     * @param status the verdict on the whole photo
     * @param magnification of the ellipses, 1 for true size
     * @param gridSpacingMm distance between lines of the world grid
     * @param shapes in the order they are drawn; copied
     */
    public Overlay(int widthPx, int heightPx, Status status, double magnification, double gridSpacingMm,
            List<Shape> shapes) {
        this.widthPx = widthPx;
        this.heightPx = heightPx;
        this.unitPx = unitPx(widthPx, heightPx);
        this.status = status;
        this.magnification = magnification;
        this.gridSpacingMm = gridSpacingMm;
        this.shapes = Collections.unmodifiableList(new ArrayList<>(shapes));
    }

    /**
     * The length that line widths and texts are measured in: 1 px in a VGA image, growing with the image, the same
     * however the image is turned.
     *
     * @param widthPx image width
     * @param heightPx image height
     * @return px, at least 0.5
     */
    public static double unitPx(int widthPx, int heightPx) {
        return Math.max(0.5, Math.min(Math.min(widthPx, heightPx) / 480.0, Math.max(widthPx, heightPx) / 640.0));
    }

    /**
     * Width of the image.
     *
     * @return px
     */
    public int widthPx() {
        return widthPx;
    }

    /**
     * Height of the image.
     *
     * @return px
     */
    public int heightPx() {
        return heightPx;
    }

    /**
     * The length that line widths are measured in.
     *
     * @return px, see {@link #unitPx(int, int)}
     */
    public double unitPx() {
        return unitPx;
    }

    /**
     * The verdict on the whole photo.
     *
     * @return the status of the banner
     */
    public Status status() {
        return status;
    }

    /**
     * How many times larger than true the ellipses are drawn.
     *
     * @return 1, 2, 5, 10, 20, …
     */
    public double magnification() {
        return magnification;
    }

    /**
     * Distance between lines of the world grid.
     *
     * @return mm
     */
    public double gridSpacingMm() {
        return gridSpacingMm;
    }

    /**
     * All shapes.
     *
     * @return unmodifiable, the first at the bottom
     */
    public List<Shape> shapes() {
        return shapes;
    }

    /**
     * The shapes of one role.
     *
     * @param role the role
     * @return a new list, in the order they are drawn
     */
    public List<Shape> shapes(Role role) {
        List<Shape> found = new ArrayList<>();
        for (Shape s : shapes) {
            if (s.role() == role) {
                found.add(s);
            }
        }
        return found;
    }
}
