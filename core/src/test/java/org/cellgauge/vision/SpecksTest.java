package org.cellgauge.vision;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import boofcv.alg.filter.binary.LinearExternalContours;
import boofcv.struct.ConfigLength;
import boofcv.struct.ConnectRule;
import boofcv.struct.PackedSetsPoint2D_I32;
import boofcv.struct.image.GrayU8;
import georegression.fitting.polygon.ConvexHullAndrewMonotone_F64;
import georegression.metric.Area2D_F64;
import georegression.struct.point.Point2D_F64;
import georegression.struct.point.Point2D_I32;
import georegression.struct.shapes.Polygon2D_F64;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import org.ddogleg.struct.DogArray;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class SpecksTest {
    /** Pixels that are dark by chance, in a part of a larger image whose width is no multiple of eight. */
    private static GrayU8 noise(double darkShare, boolean coarse) {
        Random random = new Random(3);
        GrayU8 whole = new GrayU8(260, 150);
        for (int y = 0; y < whole.height; y++) {
            for (int x = 0; x < whole.width; x++) {
                if (random.nextDouble() < darkShare) {
                    whole.set(x, y, 1);
                    if (coarse && x + 1 < whole.width && y + 1 < whole.height) {
                        whole.set(x + 1, y, 1);
                        whole.set(x, y + 1, 1);
                    }
                }
            }
        }
        return whole.subimage(13, 9, 244, 142);
    }

    private static List<List<Point2D_I32>> contours(GrayU8 binary, int least) {
        LinearExternalContours finder = new LinearExternalContours(ConnectRule.FOUR);
        finder.setMinContourLength(ConfigLength.fixed(least));
        finder.setMaxContourLength(ConfigLength.fixed(-1));
        finder.process(binary.clone(), 0, 0);
        PackedSetsPoint2D_I32 found = finder.getExternalContours();
        DogArray<Point2D_I32> points = new DogArray<>(Point2D_I32::new);
        List<List<Point2D_I32>> contours = new ArrayList<>();
        for (int i = 0; i < found.size(); i++) {
            found.getSet(i, points);
            List<Point2D_I32> contour = new ArrayList<>();
            points.forEach(p -> contour.add(p.copy()));
            contours.add(contour);
        }
        return contours;
    }

    private static DarkBits bits(GrayU8 binary) {
        DarkBits bits = new DarkBits();
        bits.reshape(binary.width, binary.height);
        mark(binary, 0, binary.height, bits);
        return bits;
    }

    /** As specks take them out: within a pixel of the border, since a contour at a border is none. */
    private static void mark(GrayU8 binary, int top, int bottom, DarkBits bits) {
        for (int y = Math.max(1, top); y < Math.min(binary.height - 1, bottom); y++) {
            for (int x = 1; x < binary.width - 1; x++) {
                if (binary.get(x, y) != 0) {
                    bits.words()[bits.indexOf(x, y)] |= 1L << x;
                }
            }
        }
    }

    private static void takeOut(Specks specks, GrayU8 binary) {
        takeOut(specks, binary, true, 0, binary.height);
    }

    /** In bands, of which the others are not yet marked when one is gone through, or are done. */
    private static void takeOut(Specks specks, GrayU8 binary, boolean downwards, int... rows) {
        DarkBits bits = new DarkBits();
        bits.reshape(binary.width, binary.height);
        specks.begin(bits, 0, binary.width, rows);
        for (int i = 0; i < rows.length - 1; i++) {
            int band = downwards ? i : rows.length - 2 - i;
            mark(binary, rows[band], rows[band + 1], bits);
            specks.takeOut(band);
        }
        specks.end();
        bits.write(0, 0, binary.width, binary.height, binary);
    }

    private static int dark(GrayU8 binary) {
        int dark = 0;
        for (int y = 1; y < binary.height - 1; y++) {
            for (int x = 1; x < binary.width - 1; x++) {
                dark += binary.get(x, y);
            }
        }
        return dark;
    }

    @ParameterizedTest
    @CsvSource({"0.1, false, 20", "0.25, false, 20", "0.4, false, 30", "0.12, true, 30"})
    void contoursThatAreLongEnoughStay(double darkShare, boolean coarse, int least) {
        GrayU8 binary = noise(darkShare, coarse);
        List<List<Point2D_I32>> before = contours(binary, least);
        int darkBefore = dark(binary);
        takeOut(new Specks(least, 0), binary);
        assertEquals(before, contours(binary, least));
        assertTrue(dark(binary) < 0.9 * darkBefore, dark(binary) + " of " + darkBefore);
    }

    /** What BoofCV would make of them has its corners among their pixels, and so no more area than their hull. */
    @ParameterizedTest
    @CsvSource({"0.25, false", "0.12, true", "0.2, true"})
    void otherContoursThatGoAreTooSmallForAPolygon(double darkShare, boolean coarse) {
        double leastArea = 40;
        GrayU8 binary = noise(darkShare, coarse);
        List<List<Point2D_I32>> before = contours(binary, 20);
        takeOut(new Specks(20, leastArea), binary);
        List<List<Point2D_I32>> after = contours(binary, 20);
        int gone = 0;
        for (List<Point2D_I32> contour : before) {
            if (!after.contains(contour)) {
                gone++;
                assertTrue(hullArea(contour) < leastArea, contour.toString());
            }
        }
        assertEquals(before.size() - gone, after.size());
        assertTrue(gone > before.size() / 5, gone + " of " + before.size());
    }

    /** Pixels that touch each other at their sides, by the first of them in rows. */
    private static Map<Integer, Set<Integer>> blobs(GrayU8 binary) {
        GrayU8 left = binary.clone();
        Map<Integer, Set<Integer>> blobs = new TreeMap<>();
        for (int y = 1; y < binary.height - 1; y++) {
            for (int x = 1; x < binary.width - 1; x++) {
                if (left.get(x, y) != 0) {
                    Set<Integer> blob = new TreeSet<>();
                    take(left, x, y, blob);
                    blobs.put(1000 * y + x, blob);
                }
            }
        }
        return blobs;
    }

    private static void take(GrayU8 left, int x, int y, Set<Integer> into) {
        if (x >= 1 && y >= 1 && x < left.width - 1 && y < left.height - 1 && left.get(x, y) != 0) {
            left.set(x, y, 0);
            into.add(1000 * y + x);
            take(left, x + 1, y, into);
            take(left, x - 1, y, into);
            take(left, x, y + 1, into);
            take(left, x, y - 1, into);
        }
    }

    /** All of up to ten pixels, as their contours are below 20; and no blob in part. */
    @ParameterizedTest
    @CsvSource({"0.1, false", "0.3, false", "0.12, true"})
    void blobsGoAsAWholeAndAllShortOnesDo(double darkShare, boolean coarse) {
        GrayU8 binary = noise(darkShare, coarse);
        Map<Integer, Set<Integer>> before = blobs(binary);
        takeOut(new Specks(20, 0), binary);
        Map<Integer, Set<Integer>> after = blobs(binary);
        after.forEach((at, blob) -> assertEquals(before.get(at), blob));
        before.forEach((at, blob) -> assertTrue(blob.size() > 10 == after.containsKey(at), blob.toString()));
    }

    @ParameterizedTest
    @CsvSource({"0.1, false", "0.3, false", "0.45, false", "0.12, true", "0.2, true"})
    void bandsOfRowsLeaveTheSame(double darkShare, boolean coarse) {
        GrayU8 whole = noise(darkShare, coarse).clone();
        GrayU8 expected = whole.clone();
        takeOut(new Specks(30, 56), expected);
        for (boolean downwards : new boolean[] {true, false}) {
            GrayU8 inBands = whole.clone();
            takeOut(new Specks(30, 56), inBands, downwards, 0, 40, 90, whole.height);
            assertArrayEquals(expected.data, inBands.data);
            GrayU8 inNarrowBands = whole.clone();
            takeOut(new Specks(30, 56), inNarrowBands, downwards, 0, 8, 19, 27, 50, 58, whole.height);
            assertArrayEquals(expected.data, inNarrowBands.data);
        }
    }

    /** What another part of the image has in the same numbers is not cut off where this part ends. */
    @Test
    void blobsBesideAPartStayOrGoAsAWhole() {
        GrayU8 binary = noise(0.3, false).clone();
        for (int y = 0; y < binary.height; y++) {
            binary.set(100, y, 0);
            // this part's own pixels do not go on above and below it
            for (int x = 100; x < 200; x++) {
                binary.set(x, y, y > 40 && y < 99 ? binary.get(x, y) : 0);
            }
        }
        Map<Integer, Set<Integer>> before = blobs(binary);
        DarkBits bits = bits(binary);
        Specks specks = new Specks(20, 0);
        specks.begin(bits, 101, 200, new int[] {40, 70, 100});
        specks.takeOut(0);
        specks.takeOut(1);
        specks.end();
        bits.write(0, 0, binary.width, binary.height, binary);
        Map<Integer, Set<Integer>> after = blobs(binary);
        after.forEach((at, blob) -> assertEquals(before.get(at), blob));
        before.forEach((at, blob) -> {
            if (at % 1000 > 100 && at % 1000 < 200 && at / 1000 > 40 && at / 1000 < 99) {
                assertTrue(blob.size() > 10 == after.containsKey(at), blob.toString());
            }
        });
    }

    private static double hullArea(List<Point2D_I32> contour) {
        DogArray<Point2D_F64> points = new DogArray<>(Point2D_F64::new);
        contour.forEach(p -> points.grow().setTo(p.x, p.y));
        Polygon2D_F64 hull = new Polygon2D_F64();
        new ConvexHullAndrewMonotone_F64().process(points, hull);
        return hull.size() < 3 ? 0 : Area2D_F64.polygonSimple(hull);
    }

    private static GrayU8 row(int length) {
        GrayU8 binary = new GrayU8(40, 5);
        for (int x = 0; x < length; x++) {
            binary.set(3 + x, 2, 1);
        }
        return binary;
    }

    @Test
    void ofPixelsInARowTheOutlineIsTheLongest() {
        GrayU8 binary = row(10);
        takeOut(new Specks(20, 0), binary);
        assertEquals(0, dark(binary), "18 steps about");
        binary = row(11);
        takeOut(new Specks(20, 0), binary);
        assertEquals(11, dark(binary), "20 steps about");
        assertEquals(1, contours(binary, 20).size());
    }

    @Test
    void underALensAreaIsNoReason() {
        Specks specks = new Specks(20, 1000);
        specks.setPolygons(false);
        GrayU8 binary = row(11);
        takeOut(specks, binary);
        assertEquals(11, dark(binary));
        specks.setPolygons(true);
        takeOut(specks, binary);
        assertEquals(0, dark(binary));
    }
}
