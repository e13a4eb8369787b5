package org.cellgauge.vision;

import boofcv.abst.filter.binary.InputToBinary;
import boofcv.struct.image.GrayU8;
import boofcv.struct.image.ImageType;
import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;

/**
 * Marks pixels that are darker than a share of the {@linkplain CellMeans mean} about them, as BoofCV's local mean does,
 * in those tiles that {@linkplain TileContrast may have} such. BoofCV's own blurs the whole image twice first, which
 * takes half of the time to find markers in a plain scene.
 *
 * <p>Outside of the {@link SearchWindows} of a frame nothing is looked at; inside, all is as in the whole image. What
 * is dark lies in some {@linkplain #places() places}, outside of which pixels are cleared or left as they were. Rows of
 * large windows are gone through by several threads where the loop has them; the same is dark either way. Not
 * thread-safe: sums are kept.
 */
final class LocalMeanThreshold implements InputToBinary<GrayU8> {
    /** Width and height of a tile, px. */
    static final int TILE = 16;
    /** Width and height of a cell, px. */
    static final int CELL = 4;
    /** Cells on each side of a cell that its mean is over; at the border, those that there are. In the tiles beside. */
    static final int REACH = 2;
    /** More places than these are gone through as their window: each keeps its contours. */
    private static final int MOST_PLACES = 32;
    /** Rows of tiles that a thread takes at least: what lies about their borders is gone through twice. */
    private static final int LEAST_OF_BAND = 6;
    /** Bands for each thread: one that comes late leaves some to the others. */
    private static final int BANDS_PER_THREAD = 2;

    private final int percent;
    private final SearchWindows windows;
    private final SharedLoop loop;
    private final TileContrast contrast;
    private final DarkBits dark;
    private @Nullable Specks specks;
    /** Of each band of rows of tiles that are gone through at a time. */
    private final List<CellMeans> means = new ArrayList<>();
    private final Rectangles places = new Rectangles();
    private final Rectangles ofWindow = new Rectangles();
    private int width;
    private int height;

    /**
     * A threshold.
     *
     * @param percent of the mean at which black begins, below 100
     * @param windows where pixels are asked for
     * @param dark work space, which those may share that are not used at a time
     * @param loop what goes through large images
     */
    LocalMeanThreshold(int percent, SearchWindows windows, DarkBits dark, SharedLoop loop) {
        this.percent = percent;
        this.windows = windows;
        this.dark = dark;
        this.loop = loop;
        this.contrast = new TileContrast(percent);
    }

    /** Where pixels are asked for. */
    SearchWindows windows() {
        return windows;
    }

    /** Has specks taken out of what is dark. */
    void takeOut(Specks ofContours) {
        specks = ofContours;
    }

    /** Parts of the last image that have all dark pixels in them. */
    Rectangles places() {
        return places;
    }

    @Override
    public void process(GrayU8 input, GrayU8 output) {
        if (input.width != width || input.height != height) {
            width = input.width;
            height = input.height;
            contrast.reshape(width, height);
        }
        output.reshape(width, height);
        dark.reshape(width, height);
        places.clear();
        for (int i = 0; i < windows.count(); i++) {
            int left = windows.left(i) / TILE;
            int top = windows.top(i) / TILE;
            int right = tiles(Math.min(width, windows.right(i)));
            int bottom = tiles(Math.min(height, windows.bottom(i)));
            mark(input, left, top, right, bottom);
            findPlaces(output, left, top, right, bottom);
        }
    }

    /** How many tiles cover so many pixels, px. */
    static int tiles(int px) {
        return (px + TILE - 1) / TILE;
    }

    /** Marks what is dark in a window of tiles, the last ones not with it, but for specks. */
    private void mark(GrayU8 input, int left, int top, int right, int bottom) {
        int tilesAcross = tiles(width);
        int tilesDown = tiles(height);
        int bands = Math.max(1, Math.min((bottom - top) / LEAST_OF_BAND,
                loop.threads() == 1 ? 1 : BANDS_PER_THREAD * loop.threads()));
        while (means.size() < bands) {
            means.add(new CellMeans(percent, contrast, dark));
        }
        int[] rows = new int[bands + 1];
        for (int i = 0; i <= bands; i++) {
            rows[i] = top + (bottom - top) * i / bands;
        }
        loop.each(bands, i -> contrast.look(input, Math.max(0, left - 1), i == 0 ? Math.max(0, top - 1) : rows[i],
                Math.min(tilesAcross, right + 1), i == bands - 1 ? Math.min(tilesDown, bottom + 1) : rows[i + 1]));
        contrast.find(input, left, top, right, bottom);
        Specks of = specks;
        if (of == null) {
            loop.each(bands, i -> means.get(i).mark(input, left, rows[i], right, rows[i + 1]));
            return;
        }
        int end = Math.min(width, TILE * right);
        int[] starts = new int[bands + 1];
        for (int i = 0; i <= bands; i++) {
            starts[i] = Math.min(height, TILE * rows[i]);
        }
        of.begin(dark, TILE * left, end, starts);
        loop.each(bands, i -> {
            means.get(i).mark(input, left, rows[i], right, rows[i + 1]);
            of.takeOut(i);
        });
        of.end();
    }

    /** Finds the places of a window of tiles that was gone through, and writes them. */
    private void findPlaces(GrayU8 output, int left, int top, int right, int bottom) {
        ofWindow.clear();
        for (int down = top; down < bottom; down++) {
            int from = left;
            for (int across = left; across <= right; across++) {
                // mostly it is noise that may be dark, and is not
                if (across == right || !contrast.mayBeDark(across, down)
                        || !dark.isAnyDark(TILE * across, TILE * down, TILE)) {
                    ofWindow.add(TILE * from, TILE * down, Math.min(width, TILE * across),
                            Math.min(height, TILE * (down + 1)));
                    from = across + 1;
                }
            }
        }
        if (ofWindow.count() > MOST_PLACES) {
            ofWindow.clear();
            ofWindow.add(TILE * left, TILE * top, Math.min(width, TILE * right), Math.min(height, TILE * bottom));
        }
        for (int i = 0; i < ofWindow.count(); i++) {
            dark.write(ofWindow.left(i), ofWindow.top(i), ofWindow.right(i), ofWindow.bottom(i), output);
            places.add(ofWindow.left(i), ofWindow.top(i), ofWindow.right(i), ofWindow.bottom(i));
        }
    }

    @Override
    public ImageType<GrayU8> getInputType() {
        return ImageType.SB_U8;
    }
}
