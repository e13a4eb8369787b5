package org.cellgauge.vision;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import boofcv.abst.filter.binary.BinaryContourFinder;
import boofcv.abst.filter.binary.BinaryContourFinderLinearExternal;
import boofcv.alg.filter.binary.ContourPacked;
import boofcv.struct.ConfigLength;
import boofcv.struct.ConnectRule;
import boofcv.struct.image.GrayU8;
import georegression.struct.point.Point2D_I32;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.ddogleg.struct.DogArray;
import org.junit.jupiter.api.Test;

class WindowContoursTest {
    private static final int WIDTH = 640;
    private static final int HEIGHT = 480;

    /** Patches of all sizes, with a border of a pixel. */
    private static GrayU8 patches() {
        GrayU8 image = new GrayU8(WIDTH + 2, HEIGHT + 2);
        Random random = new Random(5);
        for (int patch = 0; patch < 1500; patch++) {
            int left = 1 + random.nextInt(WIDTH);
            int top = 1 + random.nextInt(HEIGHT);
            int right = Math.min(WIDTH + 1, left + 1 + random.nextInt(12));
            int bottom = Math.min(HEIGHT + 1, top + 1 + random.nextInt(12));
            for (int y = top; y < bottom; y++) {
                for (int x = left; x < right; x++) {
                    image.set(x, y, 1);
                }
            }
        }
        return image;
    }

    /** Four windows, of which two are beside each other and one ends with the image. */
    private static SearchWindows windows() {
        SearchWindows windows = new SearchWindows();
        windows.begin(WIDTH, HEIGHT);
        int[][] middles = {{100, 120}, {300, 130}, {620, 300}, {330, 400}};
        for (int i = 0; i < middles.length; i++) {
            int u = middles[i][0];
            int v = middles[i][1];
            windows.keep(i, new double[] {u - 15, v - 15, u + 15, v - 15, u + 15, v + 15, u - 15, v + 15}, true);
        }
        windows.end();
        windows.begin(WIDTH, HEIGHT);
        assertEquals(4, windows.count());
        return windows;
    }

    private static List<List<Point2D_I32>> contours(BinaryContourFinder finder, ConfigLength least) {
        finder.setConnectRule(ConnectRule.FOUR);
        finder.setMinContour(least);
        finder.setMaxContour(ConfigLength.fixed(200));
        finder.process(patches());
        List<List<Point2D_I32>> contours = new ArrayList<>();
        for (ContourPacked contour : finder.getContours()) {
            DogArray<Point2D_I32> points = new DogArray<>(Point2D_I32::new);
            finder.loadContour(contour.externalIndex, points);
            List<Point2D_I32> copy = new ArrayList<>();
            points.forEach(p -> copy.add(p.copy()));
            contours.add(copy);
        }
        return contours;
    }

    private static List<List<Point2D_I32>> boof(ConfigLength least) {
        BinaryContourFinderLinearExternal boof = new BinaryContourFinderLinearExternal();
        boof.setCreatePaddedCopy(false);
        boof.setCoordinateAdjustment(1, 1);
        return contours(boof, least);
    }

    private static List<List<Point2D_I32>> own(SearchWindows windows, ConfigLength least) {
        WindowContours own = new WindowContours(windows, windows.rectangles());
        own.setCreatePaddedCopy(false);
        return contours(own, least);
    }

    /** Whether a pixel is in the window and not at a border of it where the image goes on. */
    private static boolean isInside(SearchWindows windows, int i, Point2D_I32 p) {
        return (windows.left(i) == 0 ? p.x >= 0 : p.x > windows.left(i))
                && (windows.top(i) == 0 ? p.y >= 0 : p.y > windows.top(i))
                && (windows.right(i) == WIDTH ? p.x < WIDTH : p.x < windows.right(i) - 1)
                && (windows.bottom(i) == HEIGHT ? p.y < HEIGHT : p.y < windows.bottom(i) - 1);
    }

    /** In the same order; a relative least length is one of the whole image's size. */
    @Test
    void contoursOfWindowsAreThoseOfTheImageThatLieInThem() {
        for (ConfigLength least : List.of(ConfigLength.fixed(3), ConfigLength.relative(0.03, 0))) {
            SearchWindows windows = windows();
            List<List<Point2D_I32>> all = boof(least);
            List<List<Point2D_I32>> expected = new ArrayList<>();
            for (List<Point2D_I32> contour : all) {
                for (int i = 0; i < windows.count(); i++) {
                    int window = i;
                    if (contour.stream().allMatch(p -> isInside(windows, window, p))) {
                        expected.add(contour);
                    }
                }
            }
            assertTrue(expected.size() > 10, expected.size() + " of " + all.size());
            assertEquals(expected, own(windows, least));
        }
    }

    @Test
    void ofAWholeImageTheyAreItsOwn() {
        assertEquals(boof(ConfigLength.fixed(3)), own(new SearchWindows(), ConfigLength.fixed(3)));
    }
}
