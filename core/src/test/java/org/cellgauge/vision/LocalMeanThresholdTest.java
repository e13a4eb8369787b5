package org.cellgauge.vision;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import boofcv.factory.filter.binary.ConfigThreshold;
import boofcv.factory.filter.binary.FactoryThresholdBinary;
import boofcv.factory.filter.binary.ThresholdType;
import boofcv.struct.image.GrayU8;
import java.util.Arrays;
import java.util.Random;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class LocalMeanThresholdTest {
    private static GrayU8 noise(int width, int height) {
        GrayU8 image = new GrayU8(width, height);
        new Random(7).nextBytes(image.data);
        return image;
    }

    /** 85 % of the mean of the 20 x 20 px about the cell of 4 x 4 px with a place, as far as they lie in the image. */
    private static double ofCell(GrayU8 image, int x, int y) {
        int left = Math.max(0, Math.min((image.width - 1) / 4, x)) * 4;
        int top = Math.max(0, Math.min((image.height - 1) / 4, y)) * 4;
        double sum = 0;
        int count = 0;
        for (int v = Math.max(0, top - 8); v < Math.min(image.height, top + 12); v++) {
            for (int u = Math.max(0, left - 8); u < Math.min(image.width, left + 12); u++) {
                sum += image.get(u, v);
                count++;
            }
        }
        return 0.85 * sum / count;
    }

    /** The same between the middles of cells, in the middle of a pair of pixels beside each other. */
    private static double limit(GrayU8 image, int x, int y) {
        double u = (x / 2 * 2 + 1 - 2) / 4.0;
        double v = (y + 0.5 - 2) / 4.0;
        int left = (int) Math.floor(u);
        int top = (int) Math.floor(v);
        double right = u - left;
        double bottom = v - top;
        return (1 - bottom) * ((1 - right) * ofCell(image, left, top) + right * ofCell(image, left + 1, top))
                + bottom * ((1 - right) * ofCell(image, left, top + 1) + right * ofCell(image, left + 1, top + 1));
    }

    /** In images smaller than the window too, and of sizes that no cell or tile divides; limits by parts of 1/8. */
    @ParameterizedTest
    @CsvSource({"60, 40", "64, 48", "61, 50", "25, 7", "3, 50", "1, 1", "200, 150"})
    void darkIsWhatIsBelowTheShareOfTheMean(int width, int height) {
        GrayU8 image = noise(width, height);
        GrayU8 found = new GrayU8(1, 1);
        new LocalMeanThreshold(85, new SearchWindows(), new DarkBits(), new SharedLoop()).process(image, found);
        for (int y = 0; y < height; y++) {
            for (int x = 0; x < width; x++) {
                double above = image.get(x, y) - limit(image, x, y);
                if (above > 0 || above < -0.126) {
                    assertEquals(above < 0 ? 1 : 0, found.get(x, y), x + ", " + y);
                }
            }
        }
    }

    /** Rows of tiles are gone through in runs that begin and end anywhere, and the next image has others. */
    @Test
    void runsOfTilesHaveTheLimitsOfTheWholeImage() {
        Random random = new Random(8);
        LocalMeanThreshold threshold = new LocalMeanThreshold(85, new SearchWindows(), new DarkBits(),
                new SharedLoop());
        for (int image = 0; image < 12; image++) {
            GrayU8 grey = patches(random, 9);
            GrayU8 found = new GrayU8(1, 1);
            threshold.process(grey, found);
            GrayU8 dark = new GrayU8(grey.width, grey.height);
            Rectangles places = threshold.places();
            for (int i = 0; i < places.count(); i++) {
                for (int y = places.top(i); y < places.bottom(i); y++) {
                    for (int x = places.left(i); x < places.right(i); x++) {
                        dark.set(x, y, found.get(x, y));
                    }
                }
            }
            for (int y = 0; y < grey.height; y++) {
                for (int x = 0; x < grey.width; x++) {
                    double above = grey.get(x, y) - limit(grey, x, y);
                    if (above > 0 || above < -0.126) {
                        assertEquals(above < 0 ? 1 : 0, dark.get(x, y), image + ": " + x + ", " + y);
                    }
                }
            }
        }
    }

    @Test
    void theSameTilesOfAnotherImageHaveItsLimits() {
        LocalMeanThreshold threshold = new LocalMeanThreshold(85, new SearchWindows(), new DarkBits(),
                new SharedLoop());
        for (int brightness = 0; brightness <= 90; brightness += 45) {
            GrayU8 grey = new GrayU8(96, 16);
            Arrays.fill(grey.data, (byte) (100 + brightness));
            Random random = new Random(9);
            for (int y = 3; y < 14; y++) {
                for (int x = 35; x < 60; x++) {
                    grey.set(x, y, 20 + brightness + random.nextInt(130));
                }
            }
            GrayU8 found = new GrayU8(1, 1);
            GrayU8 expected = new GrayU8(1, 1);
            threshold.process(grey, found);
            new LocalMeanThreshold(85, new SearchWindows(), new DarkBits(), new SharedLoop()).process(grey, expected);
            assertArrayEquals(expected.data, found.data);
        }
    }

    /** Plain ground with patches of noise. */
    private static GrayU8 patches(Random random, int count) {
        GrayU8 image = new GrayU8(333, 222);
        Arrays.fill(image.data, (byte) 150);
        for (int patch = 0; patch < count; patch++) {
            int left = random.nextInt(300);
            int top = random.nextInt(200);
            int right = Math.min(333, left + 4 + random.nextInt(60));
            int bottom = Math.min(222, top + 4 + random.nextInt(40));
            for (int y = top; y < bottom; y++) {
                for (int x = left; x < right; x++) {
                    image.set(x, y, 60 + random.nextInt(150));
                }
            }
        }
        return image;
    }

    /** Nine pixels of 169 among 200: 85 % of the mean about them is 169.4, and of the brightest 170. */
    @Test
    void littleContrastIsEnough() {
        GrayU8 image = new GrayU8(64, 64);
        Arrays.fill(image.data, (byte) 200);
        for (int i = 0; i < 9; i++) {
            image.set(32 + i % 3, 32 + i / 3, 169);
        }
        GrayU8 found = new GrayU8(1, 1);
        new LocalMeanThreshold(85, new SearchWindows(), new DarkBits(), new SharedLoop()).process(image, found);
        assertEquals(1, found.get(33, 33));
    }

    /** A share of a plain ground is that share of it: 85 % of 100 are 85. */
    @Test
    void whatIsAtTheLimitIsDark() {
        GrayU8 image = new GrayU8(64, 64);
        for (int y = 0; y < 64; y++) {
            for (int x = 0; x < 64; x++) {
                // every cell has one each of these
                int inCell = 4 * (y % 4) + x % 4;
                image.set(x, y, inCell == 9 ? 85 : inCell == 6 ? 115 : inCell == 0 ? 60 : inCell == 10 ? 140 : 100);
            }
        }
        GrayU8 found = new GrayU8(1, 1);
        new LocalMeanThreshold(85, new SearchWindows(), new DarkBits(), new SharedLoop()).process(image, found);
        assertEquals(1, found.get(33, 34));

        for (int i = 0; i < image.data.length; i++) {
            image.data[i] += image.data[i] == 85 ? 1 : image.data[i] == 115 ? -1 : 0;
        }
        new LocalMeanThreshold(85, new SearchWindows(), new DarkBits(), new SharedLoop()).process(image, found);
        assertEquals(0, found.get(33, 34));
    }

    /** Where the light changes slowly, as BoofCV's own mean about each pixel has it but for those near the limit. */
    @Test
    void agreesWithBoofCvWhereTheMeanHardlyChanges() {
        GrayU8 image = new GrayU8(200, 150);
        Random random = new Random(5);
        for (int y = 0; y < 150; y++) {
            for (int x = 0; x < 200; x++) {
                image.set(x, y, (random.nextInt(3) == 0 ? 60 : 150) + x / 4 + random.nextInt(9));
            }
        }
        GrayU8 own = new GrayU8(1, 1);
        GrayU8 boof = new GrayU8(200, 150);
        new LocalMeanThreshold(85, new SearchWindows(), new DarkBits(), new SharedLoop()).process(image, own);
        ConfigThreshold config = ConfigThreshold.local(ThresholdType.LOCAL_MEAN, 21);
        config.scale = 0.85;
        FactoryThresholdBinary.threshold(config, GrayU8.class).process(image, boof);
        assertArrayEquals(boof.data, own.data);
    }

    @Test
    void aViewOfALargerImageIsReadInItsOwnRows() {
        GrayU8 image = noise(80, 60);
        GrayU8 part = image.subimage(11, 7, 61, 47);
        GrayU8 found = new GrayU8(1, 1);
        GrayU8 ofCopy = new GrayU8(1, 1);
        new LocalMeanThreshold(85, new SearchWindows(), new DarkBits(), new SharedLoop()).process(part, found);
        new LocalMeanThreshold(85, new SearchWindows(), new DarkBits(), new SharedLoop()).process(part.clone(), ofCopy);
        for (int y = 0; y < 40; y++) {
            for (int x = 0; x < 50; x++) {
                assertEquals(ofCopy.get(x, y), found.get(x, y));
            }
        }
    }

    /** A texture all over, in a size that no band of rows divides. */
    @ParameterizedTest
    @ValueSource(ints = {2, 3, 8})
    void severalThreadsFindTheSame(int threads) {
        GrayU8 image = new GrayU8(330, 427);
        Random random = new Random(6);
        // blocks of four by four, of which many are no specks together
        for (int y = 0; y < image.height; y++) {
            for (int x = 0; x < image.width; x++) {
                image.set(x, y, x % 4 > 0 ? image.get(x - 1, y) : y % 4 > 0 ? image.get(x, y - 1)
                        : random.nextInt(5) < 2 ? 60 : 140);
                image.set(x, y, random.nextInt(40) == 0 ? 100 : image.get(x, y));
            }
        }
        GrayU8 one = new GrayU8(1, 1);
        LocalMeanThreshold alone = new LocalMeanThreshold(85, new SearchWindows(), new DarkBits(), new SharedLoop());
        alone.takeOut(new Specks(30, 56));
        alone.process(image, one);
        int dark = 0;
        for (byte pixel : one.data) {
            dark += pixel;
        }
        assertEquals(0.3, (double) dark / one.data.length, 0.15);
        ExecutorService helpers = Executors.newCachedThreadPool();
        try {
            SharedLoop loop = new SharedLoop();
            loop.spread(helpers, threads);
            LocalMeanThreshold several = new LocalMeanThreshold(85, new SearchWindows(), new DarkBits(), loop);
            several.takeOut(new Specks(30, 56));
            for (int time = 0; time < 20; time++) {
                GrayU8 found = new GrayU8(1, 1);
                loop.gather();
                several.process(image, found);
                loop.dismiss();
                assertArrayEquals(one.data, found.data);
            }
        } finally {
            helpers.shutdownNow();
        }
    }

    private static boolean isIn(Rectangles parts, int x, int y) {
        boolean in = false;
        for (int i = 0; i < parts.count(); i++) {
            in |= x >= parts.left(i) && x < parts.right(i) && y >= parts.top(i) && y < parts.bottom(i);
        }
        return in;
    }

    /** On flat grounds of several greys with some specks, whose tiles are known by limits only. */
    @Test
    void outsideOfItsPlacesNothingIsDark() {
        GrayU8 image = new GrayU8(640, 480);
        Random random = new Random(4);
        for (int i = 0; i < image.data.length; i++) {
            image.data[i] = (byte) (100 + i / 640 / 100 * 20 + random.nextInt(5));
        }
        for (int speck = 0; speck < 5; speck++) {
            int left = random.nextInt(620);
            int top = random.nextInt(460);
            int grey = 60 + 8 * speck;
            for (int y = top; y < top + 9; y++) {
                Arrays.fill(image.data, 640 * y + left, 640 * y + left + 9, (byte) grey);
            }
        }
        LocalMeanThreshold threshold = new LocalMeanThreshold(85, new SearchWindows(), new DarkBits(),
                new SharedLoop());
        threshold.process(image, new GrayU8(1, 1));
        assertTrue(threshold.places().count() > 1, threshold.places().count() + " places");
        int area = 0;
        for (int i = 0; i < threshold.places().count(); i++) {
            area += (threshold.places().right(i) - threshold.places().left(i))
                    * (threshold.places().bottom(i) - threshold.places().top(i));
        }
        assertTrue(area < 640 * 480 / 2, area + " px");
        for (int y = 0; y < 480; y++) {
            for (int x = 0; x < 640; x++) {
                assertTrue(image.get(x, y) > limit(image, x, y) || isIn(threshold.places(), x, y), x + ", " + y);
            }
        }
    }

    /**
     * Of tiles that are plain, so that all contrast is with the tiles beside, or only with those outside of a window;
     * after another image.
     */
    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void inWindowsAllIsAsInTheWholeImage(boolean plainInside) {
        SearchWindows windows = new SearchWindows();
        LocalMeanThreshold threshold = new LocalMeanThreshold(85, windows, new DarkBits(), new SharedLoop());
        GrayU8 plain = new GrayU8(640, 480);
        Arrays.fill(plain.data, (byte) 90);
        threshold.process(plain, new GrayU8(1, 1));
        windows.begin(640, 480);
        windows.keep(944, new double[] {110, 110, 150, 110, 150, 150, 110, 150}, true);
        windows.keep(5, new double[] {590, 430, 630, 430, 630, 470, 590, 470}, true);
        windows.end();
        windows.begin(640, 480);
        assertEquals(2, windows.count());
        byte[] tiles = new byte[40 * 30];
        new Random(3).nextBytes(tiles);
        GrayU8 image = new GrayU8(640, 480);
        for (int y = 0; y < 480; y++) {
            for (int x = 0; x < 640; x++) {
                image.set(x, y, plainInside && isIn(windows.rectangles(), x, y) ? 90 : tiles[y / 16 * 40 + x / 16]);
            }
        }
        GrayU8 found = new GrayU8(640, 480);
        Arrays.fill(found.data, (byte) 7);
        GrayU8 whole = new GrayU8(1, 1);
        threshold.process(image, found);
        new LocalMeanThreshold(85, new SearchWindows(), new DarkBits(), new SharedLoop()).process(image, whole);
        for (int y = 0; y < 480; y++) {
            for (int x = 0; x < 640; x++) {
                boolean set = isIn(threshold.places(), x, y);
                assertTrue(!set || isIn(windows.rectangles(), x, y), x + ", " + y);
                // outside of places pixels are as they were, or were looked at and are not dark
                assertTrue(found.get(x, y) == whole.get(x, y) || !set && found.get(x, y) == 7, x + ", " + y);
                assertTrue(found.get(x, y) == 7 || isIn(windows.rectangles(), x, y), x + ", " + y);
                assertTrue(set || !isIn(windows.rectangles(), x, y) || whole.get(x, y) == 0, x + ", " + y);
            }
        }
    }

    /** A speck of two by two pixels on plain ground, wherever in its tile: one of its pixels is always looked at. */
    @Test
    void aSpeckIsFoundWhereverItLies() {
        LocalMeanThreshold threshold = new LocalMeanThreshold(85, new SearchWindows(), new DarkBits(),
                new SharedLoop());
        GrayU8 found = new GrayU8(1, 1);
        for (int at = 0; at < 3 * LocalMeanThreshold.TILE; at++) {
            GrayU8 image = new GrayU8(90, 70);
            Arrays.fill(image.data, (byte) 200);
            int y = 7 * at % 60;
            image.set(at, y, 20);
            image.set(at + 1, y, 20);
            image.set(at, y + 1, 20);
            image.set(at + 1, y + 1, 20);
            threshold.process(image, found);
            assertEquals(1, found.get(at, y), "at " + at + ", " + y);
        }
    }

    /** Ground whose only bright pixels lie in the tile below or above; the dark ones near them are dark. */
    @Test
    void aTileIsSeenAgainstThoseAboutIt() {
        LocalMeanThreshold threshold = new LocalMeanThreshold(85, new SearchWindows(), new DarkBits(),
                new SharedLoop());
        GrayU8 found = new GrayU8(1, 1);
        for (boolean below : new boolean[] {false, true}) {
            GrayU8 image = new GrayU8(96, 96);
            Arrays.fill(image.data, (byte) 60);
            int border = below ? 4 * LocalMeanThreshold.TILE : 2 * LocalMeanThreshold.TILE;
            Arrays.fill(image.data, below ? border * 96 : 0, below ? 96 * 96 : border * 96, (byte) 200);
            threshold.process(image, found);
            assertEquals(1, found.get(50, below ? border - 1 : border), "bright below: " + below);
        }
    }

    /** Pixels of noise that are darker than the brightest about them allow, and not than their mean does. */
    @Test
    void noiseOnPlainGroundIsNoPlace() {
        GrayU8 image = new GrayU8(640, 480);
        Random random = new Random(8);
        for (int i = 0; i < image.data.length; i++) {
            image.data[i] = (byte) (random.nextInt(50) == 0 ? 114 : random.nextInt(50) == 0 ? 136 : 125);
        }
        for (int y = 200; y < 230; y++) {
            Arrays.fill(image.data, 640 * y + 300, 640 * y + 330, (byte) 40);
        }
        LocalMeanThreshold threshold = new LocalMeanThreshold(85, new SearchWindows(), new DarkBits(),
                new SharedLoop());
        GrayU8 found = new GrayU8(1, 1);
        threshold.process(image, found);
        assertEquals(1, threshold.places().count());
        assertTrue(threshold.places().right(0) - threshold.places().left(0) <= 30 + 2 * LocalMeanThreshold.TILE);
        for (int y = 200; y < 230; y++) {
            for (int x = 300; x < 330; x++) {
                assertTrue(isIn(threshold.places(), x, y) || found.get(x, y) == 0, x + ", " + y);
            }
        }
    }
}
