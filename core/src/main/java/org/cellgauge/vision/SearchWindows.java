package org.cellgauge.vision;

import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;

/**
 * Where the next frame of a camera is searched: all of it, or only about the squares that were read as markers of the
 * cell in the frames before, whether they were accepted or refused. So a frame that is searched in windows shows each
 * of them as the whole search would, to the last bit, and the same is said of it.
 *
 * <p>The whole frame is searched every tenth time, for what is new; where the frame before showed no marker; and at
 * once where a marker of the frame before is found in none of the windows ({@link #missMarkers}). One that is missing
 * even then is not asked for again, so that a marker that left the view costs no more than that one search; but its
 * window stays for some frames more, since markers near the limit of blur are found in one frame and not in the next.
 * Squares whose cells turned out to be no marker's have windows too, but are never asked for: textures show some in one
 * frame and others in the next.
 *
 * <p>Windows reach as far about a square as the camera may have gone on: one and a half times what the square moved by
 * from the frame before, and an eightieth of the image's width, which from rest is 0.75 degrees of a camera that sees
 * 60. They are made of the tiles of {@link LocalMeanThreshold}, do not touch each other, and are the whole image where
 * they would be more than half of it. Not thread-safe.
 */
final class SearchWindows {
    /** A third of a second of a camera with 30 frames a second. */
    static final int WHOLE_EVERY = 10;
    private static final int TILE = LocalMeanThreshold.TILE;
    private static final double MARGIN_PER_WIDTH = 1 / 80.0;
    private static final double MARGIN_PER_MOTION = 1.5;
    /** What moves towards the camera grows. */
    private static final double MARGIN_PER_SIZE = 0.25;

    private final List<Place> places = new ArrayList<>();
    private final Rectangles rectangles = new Rectangles();
    private boolean whole;
    private int framesSinceWhole;

    /** Shows whole images, as long as it is told of no squares. */
    SearchWindows() {
        showWhole();
    }

    /** Chooses where the next frame is searched. */
    void begin(int widthPx, int heightPx) {
        framesSinceWhole++;
        for (Place place : places) {
            place.seen = false;
            place.kept = false;
        }
        if (markers() == 0 || framesSinceWhole >= WHOLE_EVERY) {
            showWhole();
            return;
        }
        whole = false;
        rectangles.clear();
        for (Place place : places) {
            double margin = MARGIN_PER_WIDTH * widthPx
                    + MARGIN_PER_SIZE * Math.max(place.right - place.left, place.bottom - place.top);
            double across = margin + MARGIN_PER_MOTION * Math.abs(place.du);
            double down = margin + MARGIN_PER_MOTION * Math.abs(place.dv);
            rectangles.add(tiles(place.left - across, 0, widthPx), tiles(place.top - down, 0, heightPx),
                    tiles(place.right + across, 1, widthPx), tiles(place.bottom + down, 1, heightPx));
        }
        long area = 0;
        for (int i = 0; i < count(); i++) {
            area += (long) (right(i) - left(i)) * (bottom(i) - top(i));
        }
        if (2 * area > (long) widthPx * heightPx) {
            showWhole();
        }
    }

    /** The border of the tile about a pixel, or the one after it, within the image. */
    private static int tiles(double px, int after, int end) {
        return (int) Math.max(0, Math.min(end, (Math.floor(px / TILE) + after) * TILE));
    }

    /** Has this frame searched as a whole. */
    void showWhole() {
        whole = true;
        framesSinceWhole = 0;
        rectangles.clear();
        rectangles.add(0, 0, Integer.MAX_VALUE, Integer.MAX_VALUE);
    }

    /** Whether a frame is searched as a whole: then it has one window, which may be larger. */
    boolean areWhole() {
        return whole;
    }

    /** How many markers the frame before had. */
    int markers() {
        int markers = 0;
        for (Place place : places) {
            markers += place.isAskedFor() ? 1 : 0;
        }
        return markers;
    }

    /** The same windows. */
    Rectangles rectangles() {
        return rectangles;
    }

    /** How many there are. */
    int count() {
        return rectangles.count();
    }

    /** First column, px. */
    int left(int window) {
        return rectangles.left(window);
    }

    /** First row, px. */
    int top(int window) {
        return rectangles.top(window);
    }

    /** Column after the last, px. */
    int right(int window) {
        return rectangles.right(window);
    }

    /** Row after the last, px. */
    int bottom(int window) {
        return rectangles.bottom(window);
    }

    /**
     * Says that a square of this frame was read as a marker of the cell.
     *
     * @param id the marker's
     * @param cornersPx where it is
     */
    void see(int id, double[] cornersPx) {
        Place place = nearest(id, middle(cornersPx, 0), middle(cornersPx, 1));
        if (place != null) {
            place.seen = true;
        }
    }

    /**
     * Whether a marker of the frame before was not seen in this one. Of two that read the same each has to be, so that
     * what is said of an id at two places stays true until a whole search.
     */
    boolean missMarkers() {
        for (Place place : places) {
            if (!place.seen && place.isAskedFor()) {
                return true;
            }
        }
        return false;
    }

    /**
     * Says the same for the frames to come.
     *
     * @param id the marker's
     * @param cornersPx where it is
     * @param marker whether it still was one when it was read in the light of the whole frame
     */
    void keep(int id, double[] cornersPx, boolean marker) {
        double left = cornersPx[0];
        double top = cornersPx[1];
        double right = left;
        double bottom = top;
        for (int i = 2; i < 8; i += 2) {
            left = Math.min(left, cornersPx[i]);
            right = Math.max(right, cornersPx[i]);
            top = Math.min(top, cornersPx[i + 1]);
            bottom = Math.max(bottom, cornersPx[i + 1]);
        }
        double u = middle(cornersPx, 0);
        double v = middle(cornersPx, 1);
        Place place = nearest(id, u, v);
        if (place == null || place.kept && !place.holds(u, v)) {
            place = new Place(id);
            places.add(place);
        } else if (place.kept) {
            // outline and inner edge of one marker
            place.include(left, top, right, bottom);
            place.marker |= marker;
            return;
        } else if (place.missedFor == 0) {
            place.du = u - place.u;
            place.dv = v - place.v;
        }
        place.kept = true;
        place.marker = marker;
        place.u = u;
        place.v = v;
        place.left = left;
        place.top = top;
        place.right = right;
        place.bottom = bottom;
    }

    /** Ends a frame: what was not read in it is kept for some more. */
    void end() {
        for (int i = places.size() - 1; i >= 0; i--) {
            Place place = places.get(i);
            if (place.kept) {
                place.missedFor = 0;
            } else if (++place.missedFor < WHOLE_EVERY) {
                place.goOn();
            } else {
                places.remove(i);
            }
        }
    }

    private static double middle(double[] cornersPx, int axis) {
        return (cornersPx[axis] + cornersPx[2 + axis] + cornersPx[4 + axis] + cornersPx[6 + axis]) / 4;
    }

    private @Nullable Place nearest(int id, double u, double v) {
        Place nearest = null;
        double least = Double.POSITIVE_INFINITY;
        for (Place place : places) {
            double away = Math.hypot(place.u - u, place.v - v);
            if (place.id == id && away < least) {
                nearest = place;
                least = away;
            }
        }
        return nearest;
    }

    /** Where a square was, px. */
    private static final class Place {
        final int id;
        double u;
        double v;
        double left;
        double top;
        double right;
        double bottom;
        /** What it moved by since the frame before. */
        double du;
        double dv;
        /** Frames since it was read. */
        int missedFor;
        boolean marker;
        boolean seen;
        boolean kept;

        Place(int id) {
            this.id = id;
        }

        boolean isAskedFor() {
            return marker && missedFor == 0;
        }

        boolean holds(double atU, double atV) {
            return atU > left && atU < right && atV > top && atV < bottom;
        }

        void include(double toLeft, double toTop, double toRight, double toBottom) {
            left = Math.min(left, toLeft);
            top = Math.min(top, toTop);
            right = Math.max(right, toRight);
            bottom = Math.max(bottom, toBottom);
        }

        void goOn() {
            u += du;
            v += dv;
            left += du;
            right += du;
            top += dv;
            bottom += dv;
        }
    }
}
