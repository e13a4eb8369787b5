package org.cellgauge.vision;

import boofcv.alg.fiducial.square.BaseDetectFiducialSquare;
import boofcv.alg.shapes.polygon.DetectPolygonBinaryGrayRefine;
import boofcv.factory.fiducial.ConfigHammingMarker;
import boofcv.factory.shape.ConfigPolygonDetector;
import boofcv.struct.image.GrayF32;
import boofcv.struct.image.GrayU8;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import org.cellgauge.cell.MarkerFamily;
import org.cellgauge.internal.warning.Decimal;
import org.cellgauge.internal.warning.Listing;
import org.cellgauge.warning.Warning;
import org.jspecify.annotations.Nullable;

/**
 * Looks for what is in an image in place of the markers that a cell asks for: markers printed white on black or
 * mirrored, other ids, markers of other families, an image too dark, too bright or too blurred to show any.
 *
 * <p>It reads squares coarsely and exactly: a code must be some family's to the last cell. Nothing that it finds is
 * measured; it only gives reasons. Not thread-safe: tables and work space are kept.
 */
final class MarkerSurvey {
    /** Widths of 6 to 16 cells go into it with little left over. */
    private static final int SQUARE_PX = 144;
    /** Border that every family has, share of the width. */
    private static final double BORDER_SHARE = 0.1;
    private static final double BLACK_BORDER_SHARE = 0.65;
    /** Share of a cell's inner part that is on one side of the threshold, where the code proves little. */
    private static final double PURE_SHARE = 0.9;
    /** Fewer bits than these are no proof of a family: any square may have them. */
    private static final int PROVING_BITS = 20;
    private static final int MOST_NAMED = 12;

    /** The brightest and darkest hundredth of the image are left out, so that a lamp or a hole decides nothing. */
    private static final double TAIL_SHARE = 0.01;
    private static final int NEARLY_BLACK = 40;
    private static final int NEARLY_WHITE = 225;
    /** Grey values so many pixels apart tell how steep the steepest steps are, and how high. */
    private static final int STEEP_PX = 2;
    private static final int HIGH_PX = 16;
    /** Of all differences the largest in a thousand. */
    private static final double LARGEST_SHARE = 0.001;
    /** Steps that are lower tell nothing of blur, grey levels. */
    private static final int LEAST_STEP = 20;
    private static final double BLURRED_PX = 2.5;
    private static final double LARGEST_BLUR_PX = 20;

    private final MarkerFamily family;
    private final Set<Integer> ids;
    private final Squares squares;
    private final List<Codes> families = new ArrayList<>();
    private final GrayU8 negative = new GrayU8(1, 1);
    private final List<Reading> readings = new ArrayList<>();

    /**
     * A survey.
     *
     * @param family family of the cell
     * @param ids ids of the cell
     * @param polygons what finds quadrilaterals
     * @param dark work space
     */
    MarkerSurvey(MarkerFamily family, Set<Integer> ids, ConfigPolygonDetector polygons, DarkBits dark) {
        this.family = family;
        this.ids = ids;
        LocalMeanThreshold threshold = BoofMarkerDetector.threshold(dark);
        this.squares = new Squares(threshold, WindowContours.polygons(polygons, threshold));
    }

    /** The detector underneath, to be configured for the lens. */
    BaseDetectFiducialSquare<GrayU8> squares() {
        return squares;
    }

    /**
     * Looks at an image and says what is there.
     *
     * @param view the image
     * @param found ids that were found; the others are looked for
     * @param warnings receives what there is to say
     */
    void look(GrayU8 view, Set<Integer> found, List<Warning> warnings) {
        if (families.isEmpty()) {
            addFamilies();
        }
        readings.clear();
        squares.inverted = false;
        squares.process(view);
        squares.inverted = true;
        squares.process(negativeOf(view));
        TreeSet<Integer> inverted = new TreeSet<>();
        TreeSet<Integer> mirrored = new TreeSet<>();
        TreeSet<Integer> others = new TreeSet<>();
        Map<String, TreeSet<Integer>> foreign = new TreeMap<>();
        for (Reading r : readings) {
            if (r.codes.family != family) {
                if (!r.inverted && !r.mirrored) {
                    foreign.computeIfAbsent(r.codes.family.familyName(), k -> new TreeSet<>()).add(r.id);
                }
            } else if (!ids.contains(r.id)) {
                if (!r.inverted && !r.mirrored) {
                    others.add(r.id);
                }
            } else if (!found.contains(r.id)) {
                if (r.inverted) {
                    inverted.add(r.id);
                }
                if (r.mirrored) {
                    mirrored.add(r.id);
                }
            }
        }
        say(DetectionWarning.INVERTED, inverted, warnings);
        say(DetectionWarning.MIRRORED, mirrored, warnings);
        say(DetectionWarning.OTHER_IDS, others, warnings);
        if (found.isEmpty() && inverted.isEmpty() && mirrored.isEmpty()) {
            foreign.forEach((name, seen) -> warnings.add(Warning.of(DetectionWarning.OTHER_FAMILY, seen.size(), name,
                    listing(seen), family.familyName())));
        }
        if (found.isEmpty() && readings.isEmpty()) {
            judge(view, warnings);
        }
    }

    private static void say(DetectionWarning kind, Set<Integer> seen, List<Warning> warnings) {
        if (!seen.isEmpty()) {
            warnings.add(Warning.of(kind, listing(seen)));
        }
    }

    private static Listing listing(Set<Integer> seen) {
        List<Integer> named = new ArrayList<>(seen);
        return named.size() <= MOST_NAMED ? Listing.and(named) : Listing.comma(named.subList(0, MOST_NAMED));
    }

    private GrayU8 negativeOf(GrayU8 view) {
        negative.reshape(view.width, view.height);
        for (int y = 0; y < view.height; y++) {
            int from = view.startIndex + y * view.stride;
            int to = y * view.width;
            for (int x = 0; x < view.width; x++) {
                negative.data[to + x] = (byte) ~view.data[from + x];
            }
        }
        return negative;
    }

    /** Says of an image without any marker what may be the matter with it. */
    private static void judge(GrayU8 view, List<Warning> warnings) {
        int[] greys = new int[256];
        for (int y = 0; y < view.height; y++) {
            for (int x = 0; x < view.width; x++) {
                greys[view.unsafe_get(x, y)]++;
            }
        }
        int bright = quantile(greys, 1 - TAIL_SHARE);
        int dark = quantile(greys, TAIL_SHARE);
        double blurPx = blurPx(quantile(differences(view, STEEP_PX), 1 - LARGEST_SHARE),
                quantile(differences(view, HIGH_PX), 1 - LARGEST_SHARE));
        if (bright < NEARLY_BLACK) {
            warnings.add(Warning.of(DetectionWarning.NEARLY_BLACK, bright));
        } else if (dark > NEARLY_WHITE) {
            warnings.add(Warning.of(DetectionWarning.NEARLY_WHITE, dark));
        } else if (blurPx > BLURRED_PX) {
            warnings.add(Warning.of(DetectionWarning.BLURRED, Decimal.of(blurPx, 1)));
        }
    }

    /** How often each difference of grey values occurs between pixels of a distance, along rows and columns. */
    private static int[] differences(GrayU8 view, int distancePx) {
        int[] counts = new int[256];
        for (int y = 0; y + distancePx < view.height; y++) {
            for (int x = 0; x + distancePx < view.width; x++) {
                int grey = view.unsafe_get(x, y);
                counts[Math.abs(view.unsafe_get(x + distancePx, y) - grey)]++;
                counts[Math.abs(view.unsafe_get(x, y + distancePx) - grey)]++;
            }
        }
        return counts;
    }

    /**
     * The blur of a step: between two pixels on both sides of it at distance d a step of height h that a Gaussian of
     * deviation s has smeared differs by h (2 F(d / 2s) - 1), F the normal distribution; so the ratio of two such
     * differences tells s.
     */
    private static double blurPx(int steep, int high) {
        if (high < LEAST_STEP) {
            return 0;
        }
        double least = 0;
        double most = LARGEST_BLUR_PX;
        while (most - least > 0.01) {
            double middle = (least + most) / 2;
            double ratio = (2 * EdgeProfile.cumulative(STEEP_PX / 2.0 / middle) - 1)
                    / (2 * EdgeProfile.cumulative(HIGH_PX / 2.0 / middle) - 1);
            if (ratio * high > steep) {
                least = middle;
            } else {
                most = middle;
            }
        }
        return most;
    }

    /** The value that a share of the pixels does not exceed. */
    private static int quantile(int[] counts, double share) {
        double left = 0;
        for (int count : counts) {
            left += share * count;
        }
        int value = 0;
        while (value < counts.length - 1 && left > counts[value]) {
            left -= counts[value++];
        }
        return value;
    }

    /** The cell's own family first; of the parts of a dictionary only the whole. */
    private void addFamilies() {
        families.add(new Codes(family));
        for (MarkerFamily other : MarkerFamily.all()) {
            boolean part = !other.isSquareBinary() && MarkerFamily.all().stream().anyMatch(f -> f.size() > other.size()
                    && !f.isSquareBinary() && f.dictionaryName().equals(other.dictionaryName()));
            boolean own = !other.isSquareBinary() && !family.isSquareBinary()
                    && other.dictionaryName().equals(family.dictionaryName());
            if (other != family && !part && !own && !other.isSquareBinary()) {
                families.add(new Codes(other));
            }
        }
        // without a checksum anything is a marker of theirs: they come last, the coarsest first
        for (int codeCells = 3; codeCells <= 8; codeCells++) {
            MarkerFamily grid = MarkerFamily.of("square-binary-" + codeCells + "x" + codeCells);
            if (grid != family) {
                families.add(new Codes(grid));
            }
        }
    }

    /** The codes of a family by their bits, row by row from the top left, the first the highest; 1 for white. */
    private static final class Codes {
        final MarkerFamily family;
        final MarkerGrid grid;
        final Map<Long, Integer> ids = new HashMap<>();

        Codes(MarkerFamily family) {
            FamilyPatterns patterns = new FamilyPatterns(family);
            this.family = family;
            this.grid = patterns.grid();
            ConfigHammingMarker dictionary = patterns.dictionary();
            for (int id = 0; dictionary != null && id < family.size(); id++) {
                long code = 0;
                for (int bit = family.codeCells() * family.codeCells() - 1; bit >= 0; bit--) {
                    code = code << 1 | dictionary.encoding.get(id).pattern.get(bit);
                }
                if (!family.isAmbiguous(id)) {
                    ids.put(code, id);
                }
            }
        }

        /** The id of a code, or -1. */
        int id(long code) {
            if (!family.isSquareBinary()) {
                return ids.getOrDefault(code, -1);
            }
            int n = family.codeCells();
            int bits = n * n;
            long corners = 1L << bits - 1 | 1L << bits - n | 1L << n - 1 | 1;
            // only the lower left is black
            if ((code & corners) != (corners & ~(1L << n - 1))) {
                return -1;
            }
            long id = 0;
            int at = 0;
            for (int row = n - 1; row >= 0; row--) {
                for (int column = 0; column < n; column++) {
                    if ((corners >> bits - 1 - row * n - column & 1) == 0) {
                        id |= (~code >> bits - 1 - row * n - column & 1) << at++;
                    }
                }
            }
            return id < family.size() ? (int) id : -1;
        }
    }

    /** A square that was read. */
    private static final class Reading {
        final Codes codes;
        final int id;
        final boolean mirrored;
        final boolean inverted;

        Reading(Codes codes, int id, boolean mirrored, boolean inverted) {
            this.codes = codes;
            this.id = id;
            this.mirrored = mirrored;
            this.inverted = inverted;
        }
    }

    /** BoofCV's search for squares with a black border, read in all families. */
    private final class Squares extends BaseDetectFiducialSquare<GrayU8> {
        private boolean inverted;

        Squares(LocalMeanThreshold threshold, DetectPolygonBinaryGrayRefine<GrayU8> polygons) {
            super(threshold, polygons, false, BORDER_SHARE, BLACK_BORDER_SHARE, SQUARE_PX, GrayU8.class);
        }

        @Override
        protected boolean processSquare(GrayF32 square, Result result, double edgeInside, double edgeOutside) {
            double threshold = (edgeInside + edgeOutside) / 2;
            Reading best = null;
            for (Codes codes : families) {
                Reading reading = read(square, threshold, codes);
                if (reading != null && (best == null || rank(reading) < rank(best))) {
                    best = reading;
                }
            }
            if (best != null) {
                readings.add(best);
            }
            return false;
        }

        /** What is read wins by being expected: the cell's own marker, upright, of a family with a checksum. */
        private int rank(Reading r) {
            boolean own = r.codes.family == family;
            return (own && ids.contains(r.id) ? 0 : 8) + (r.codes.family.isSquareBinary() ? 4 : 0)
                    + (r.mirrored ? 2 : 0) + (own ? 0 : 1);
        }

        private @Nullable Reading read(GrayF32 square, double threshold, Codes codes) {
            MarkerGrid grid = codes.grid;
            int n = grid.codeCells();
            boolean proves = n * n >= PROVING_BITS && !codes.family.isSquareBinary();
            long code = 0;
            for (int row = 0; row < grid.bands(); row++) {
                for (int column = 0; column < grid.bands(); column++) {
                    double white = whiteShare(square, threshold, grid, row, column);
                    boolean inCode = row >= grid.borderBands() && row < grid.borderBands() + n
                            && column >= grid.borderBands() && column < grid.borderBands() + n;
                    if (!inCode && white > 0.5 || !proves && Math.abs(white - 0.5) < PURE_SHARE - 0.5) {
                        return null;
                    }
                    if (inCode) {
                        code = code << 1 | (white > 0.5 ? 1 : 0);
                    }
                }
            }
            Reading first = null;
            for (int way = 0; way < 8; way++) {
                int id = codes.id(code);
                Reading reading = id < 0 ? null : new Reading(codes, id, way >= 4, inverted);
                if (reading != null && codes.family == family && ids.contains(id)) {
                    return reading;
                }
                if (first == null && (way < 4 || proves)) {
                    first = reading;
                }
                code = way == 3 ? mirrored(code, n) : turned(code, n);
            }
            return first;
        }

        private double whiteShare(GrayF32 square, double threshold, MarkerGrid grid, int row, int column) {
            int top = pixel(grid, row, 0.2);
            int bottom = pixel(grid, row, 0.8);
            int left = pixel(grid, column, 0.2);
            int right = pixel(grid, column, 0.8);
            int white = 0;
            for (int y = top; y <= bottom; y++) {
                for (int x = left; x <= right; x++) {
                    white += square.get(x, y) > threshold ? 1 : 0;
                }
            }
            return (double) white / ((bottom - top + 1) * (right - left + 1));
        }

        private int pixel(MarkerGrid grid, int band, double share) {
            double cells = grid.line(band) + share * (grid.line(band + 1) - grid.line(band));
            return (int) (cells / grid.cells() * SQUARE_PX);
        }
    }

    /** A code turned by a quarter. */
    private static long turned(long code, int n) {
        long turned = 0;
        for (int i = 0; i < n * n; i++) {
            int row = i / n;
            int column = i % n;
            turned = turned << 1 | code >> n * n - 1 - ((n - 1 - column) * n + row) & 1;
        }
        return turned;
    }

    /** A code seen in a mirror. */
    private static long mirrored(long code, int n) {
        long mirrored = 0;
        for (int i = 0; i < n * n; i++) {
            mirrored = mirrored << 1 | code >> n * n - 1 - (i / n * n + n - 1 - i % n) & 1;
        }
        return mirrored;
    }
}
