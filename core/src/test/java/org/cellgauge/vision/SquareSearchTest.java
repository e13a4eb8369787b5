package org.cellgauge.vision;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import boofcv.alg.fiducial.square.FoundFiducial;
import boofcv.struct.image.GrayU8;
import java.util.Arrays;
import org.cellgauge.cell.MarkerFamily;
import org.cellgauge.geometry.PinholeCamera;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class SquareSearchTest {
    private static final int WIDTH = 320;
    private static final int HEIGHT = 240;
    private static final int CELL_PX = 12;
    private static final int LEFT = 90;
    private static final int TOP = 30;

    private static GrayU8 drawn(MarkerFamily family, int id, int quarters) {
        FamilyPatterns patterns = new FamilyPatterns(family);
        boolean[] white = patterns.white(id);
        for (int i = 0; i < quarters; i++) {
            white = patterns.turnedClockwise(white);
        }
        MarkerGrid grid = patterns.grid();
        GrayU8 image = new GrayU8(WIDTH, HEIGHT);
        Arrays.fill(image.data, (byte) 220);
        for (int row = 0; row < grid.bands(); row++) {
            for (int column = 0; column < grid.bands(); column++) {
                for (int y = (int) (grid.line(row) * CELL_PX); y < grid.line(row + 1) * CELL_PX; y++) {
                    for (int x = (int) (grid.line(column) * CELL_PX); x < grid.line(column + 1) * CELL_PX; x++) {
                        image.set(LEFT + x, TOP + y, white[row * grid.bands() + column] ? 220 : 30);
                    }
                }
            }
        }
        return image;
    }

    private static SquareSearch search(MarkerFamily family) {
        SquareSearch search = BoofMarkerDetector.squares(family);
        search.configure(null, WIDTH, HEIGHT, false);
        return search;
    }

    /** Grids with half a cell of border, with many bits, and codes; whichever way they are turned. */
    @ParameterizedTest
    @CsvSource({"square-binary, 944", "square-binary-3x3, 19", "square-binary-5x5, 1234567",
            "square-binary-6x6, 2000000001", "apriltag-36h11, 42", "aruco-ocv-4x4-50, 17"})
    void aMarkerIsReadWithItsCornersFromItsOwnTopLeft(String family, int id) {
        SquareSearch search = search(MarkerFamily.of(family));
        double side = new FamilyPatterns(MarkerFamily.of(family)).grid().cells() * CELL_PX;
        double[][] corners = {{LEFT, TOP}, {LEFT + side, TOP}, {LEFT + side, TOP + side}, {LEFT, TOP + side}};
        for (int quarters = 0; quarters < 4; quarters++) {
            search.process(drawn(MarkerFamily.of(family), id, quarters));
            assertEquals(1, search.found().size(), "turned by " + quarters);
            FoundFiducial found = search.found().get(0);
            assertEquals(id, found.id, "turned by " + quarters);
            for (int i = 0; i < 4; i++) {
                double[] corner = corners[(i + quarters) % 4];
                assertEquals(0, found.distortedPixels.get(i).distance(corner[0], corner[1]), 1,
                        "corner " + i + " turned by " + quarters);
            }
        }
    }

    private static void fill(GrayU8 image, int cellLeft, int cellTop, int across, int down, int grey) {
        for (int y = 0; y < down * CELL_PX; y++) {
            for (int x = 0; x < across * CELL_PX; x++) {
                image.set(LEFT + cellLeft * CELL_PX + x, TOP + cellTop * CELL_PX + y, grey);
            }
        }
    }

    /** White holes in the border, which the outline does not see. */
    @Test
    void aThirdOfTheBorderMayBeWhiteAndNoMore() {
        MarkerFamily family = MarkerFamily.of("square-binary");
        SquareSearch search = search(family);
        GrayU8 image = drawn(family, 944, 0);
        // a ring one cell wide is 20 of the 48 cells of the border: the inner one
        fill(image, 1, 1, 6, 1, 220);
        fill(image, 1, 6, 6, 1, 220);
        search.process(image);
        assertEquals(1, search.found().size(), "12 of 48 cells");
        fill(image, 1, 2, 1, 4, 220);
        fill(image, 6, 2, 1, 4, 220);
        search.process(image);
        assertEquals(0, search.found().size(), "20 of 48 cells");
    }

    @Test
    void wrongCellsOfACodeAreAcceptedUpToTheSmallestDistance() {
        FamilyPatterns patterns = new FamilyPatterns(MarkerFamily.of("apriltag-36h11"));
        SquareCode code = new SquareCode(patterns);
        boolean[] white = patterns.white(42);
        int[] dark = new int[36];
        for (int i = 0; i < dark.length; i++) {
            dark[i] = white[(1 + i / 6) * 8 + 1 + i % 6] ? 0 : 36;
        }
        assertTrue(code.read(dark, 36));
        assertEquals(42, code.id());
        for (int i = 0; i < 5; i++) {
            dark[7 * i] = 36 - dark[7 * i];
        }
        assertTrue(code.read(dark, 36));
        assertEquals(42, code.id());
        // the distance is 11; cells neither black nor white count half: thirteen of these are too many with five wrong
        for (int i = 1; i < 16; i++) {
            dark[i] = i % 7 == 0 ? dark[i] : dark[i] == 0 ? 9 : 27;
        }
        assertFalse(code.read(dark, 36));
    }

    @Test
    void aPlainSquareIsNoCode() {
        SquareCode code = new SquareCode(new FamilyPatterns(MarkerFamily.of("aruco-ocv-4x4-1000")));
        int[] dark = new int[16];
        assertFalse(code.read(dark, 36));
        Arrays.fill(dark, 36);
        assertFalse(code.read(dark, 36));
    }

    /** At the rim of a lens that bends lines by some pixels over a marker. */
    @Test
    void underALensCellsAreLookedAtWhereItShowsThem() {
        MarkerFamily family = MarkerFamily.of("square-binary-8x8");
        PinholeCamera camera = PinholeCamera.of(WIDTH, HEIGHT,
                new double[] {150, 150, 159.5, 119.5, 0, -0.3, 0.08, 0, 0, 0});
        GrayU8 straight = drawn(family, 123456789, 1);
        GrayU8 bent = new GrayU8(WIDTH, HEIGHT);
        double[] ray = new double[3];
        for (int y = 0; y < HEIGHT; y++) {
            for (int x = 0; x < WIDTH; x++) {
                assertTrue(camera.toRay(x, y, ray));
                int u = (int) Math.round(159.5 + 150 * ray[0] / ray[2]);
                int v = (int) Math.round(119.5 + 150 * ray[1] / ray[2]);
                bent.set(x, y, straight.isInBounds(u, v) ? straight.get(u, v) : 220);
            }
        }
        SquareSearch search = BoofMarkerDetector.squares(family);
        search.configure(BoofMarkerDetector.boofLens(camera), WIDTH, HEIGHT, false);
        search.process(bent);
        assertEquals(1, search.found().size());
        assertEquals(123456789, search.found().get(0).id);
    }
}
