package org.cellgauge.vision;

import boofcv.abst.filter.binary.BinaryContourFinder;
import boofcv.abst.filter.binary.BinaryContourHelper;
import boofcv.abst.filter.binary.InputToBinary;
import boofcv.alg.distort.LensDistortionNarrowFOV;
import boofcv.alg.distort.PixelTransformCached_F32;
import boofcv.alg.fiducial.square.FoundFiducial;
import boofcv.alg.shapes.polygon.DetectPolygonBinaryGrayRefine;
import boofcv.alg.shapes.polygon.DetectPolygonFromContour;
import boofcv.struct.ConfigLength;
import boofcv.struct.distort.PixelTransform;
import boofcv.struct.distort.Point2Transform2_F64;
import boofcv.struct.distort.PointToPixelTransform_F32;
import boofcv.struct.image.GrayU8;
import georegression.struct.point.Point2D_F32;
import georegression.struct.point.Point2D_F64;
import georegression.struct.shapes.Polygon2D_F64;
import java.util.ArrayList;
import java.util.List;
import org.ddogleg.struct.DogArray;
import org.jspecify.annotations.Nullable;

/**
 * Finds quadrilaterals with BoofCV and reads those that may be markers, as BoofCV's own square detectors do and with
 * their limits. Those make an upright picture of every quadrilateral first, of 80 x 80 px and more, which takes longer
 * than all else of a search in a plain scene; here only the places that are looked at are taken from the image. Their
 * pictures also begin half a pixel off, to one corner of the marker; places here lie evenly about its middle.
 *
 * <p>The reading is a first one, by whether a place is darker than the middle between the grey values on both sides of
 * the outline. Not thread-safe: work space is kept.
 */
final class SquareSearch {
    /** Places across a cell of the code: the middle ones of ten, since edges and blur reach into the others. */
    private static final int CODE_PLACES = 6;
    private static final int CELL_PLACES = 10;
    /** Places across a cell of the border; even, since borders may end with half a cell. */
    private static final int BORDER_PLACES = 4;
    /** Shortest side that shows cells, px. */
    private static final double LEAST_SIDE_PX = 10;
    /** Pixels about the smallest square with such sides: blur takes up to two of a side's dark ones. */
    static final int LEAST_OUTLINE_PX = 30;
    /** Shortest side as a share of the longest: beyond it a square is too much tilted. */
    private static final double LEAST_SIDE_RATIO = 0.05;
    /** BoofCV's limit on how near a lens is to none, px at the image's corner. */
    private static final double NO_LENS_PX = 5e-4;

    private final InputToBinary<GrayU8> threshold;
    private final DetectPolygonBinaryGrayRefine<GrayU8> polygons;
    private final BinaryContourHelper binary;
    private final double leastBlackOfBorder;
    private final SquareCode code;
    private final int codeCells;
    private final double[] codePlaces;
    private final double[] borderPlaces;
    /** How many of these lie in the border on each side. */
    private final int inBorder;
    private final DogArray<FoundFiducial> found = new DogArray<>(FoundFiducial::new);
    private final List<Polygon2D_F64> candidates = new ArrayList<>();
    private final List<DetectPolygonFromContour.Info> infos = new ArrayList<>();
    private final double[] cornersPx = new double[8];
    private final double[] homography = new double[8];
    private final double[] u;
    private final double[] v;
    /** What the lens moves three places of a row by, px. */
    private final double[] bentU = new double[3];
    private final double[] bentV = new double[3];
    private final int[] dark;
    /** From where lines are straight into the image; null where they are in the image itself. */
    private @Nullable Point2Transform2_F64 lens;
    private final Point2D_F64 inImage = new Point2D_F64();

    /**
     * A search, yet to be prepared for a camera.
     *
     * @param threshold what finds dark pixels
     * @param polygons what finds quadrilaterals among them
     * @param grid lattice of the markers
     * @param leastBlackOfBorder share of a marker's border that has to be black
     * @param code what tells a marker by its cells
     */
    SquareSearch(InputToBinary<GrayU8> threshold, DetectPolygonBinaryGrayRefine<GrayU8> polygons, MarkerGrid grid,
            double leastBlackOfBorder, SquareCode code) {
        this.threshold = threshold;
        this.polygons = polygons;
        this.leastBlackOfBorder = leastBlackOfBorder;
        this.code = code;
        polygons.getDetector().setOutputClockwiseUpY(false);
        polygons.getDetector().setConvex(true);
        polygons.getDetector().setNumberOfSides(4, 4);
        this.binary = new BinaryContourHelper(polygons.getDetector().getContourFinder(), false);
        this.codeCells = grid.codeCells();
        this.codePlaces = new double[codeCells * CODE_PLACES];
        for (int i = 0; i < codePlaces.length; i++) {
            double inCell = (i % CODE_PLACES + 0.5 * (1 + CELL_PLACES - CODE_PLACES)) / CELL_PLACES;
            int cell = i / CODE_PLACES;
            codePlaces[i] = (grid.borderCells() + cell + inCell) / grid.cells();
        }
        this.borderPlaces = new double[(int) Math.round(grid.cells() * BORDER_PLACES)];
        for (int i = 0; i < borderPlaces.length; i++) {
            borderPlaces[i] = (i + 0.5) / borderPlaces.length;
        }
        this.inBorder = (int) Math.round(grid.borderCells() * BORDER_PLACES);
        int most = Math.max(codePlaces.length, borderPlaces.length);
        this.u = new double[most];
        this.v = new double[most];
        this.dark = new int[codeCells * codeCells];
    }

    /**
     * Prepares for a camera.
     *
     * @param distortion the lens, with lines straight where it undistorts; null where they are straight in the image
     * @param widthPx width of the images
     * @param heightPx height of the images
     * @param tables whether to keep what the lens does to every pixel
     */
    void configure(@Nullable LensDistortionNarrowFOV distortion, int widthPx, int heightPx, boolean tables) {
        lens = null;
        polygons.setLensDistortion(widthPx, heightPx, null, null);
        if (distortion == null) {
            return;
        }
        Point2D_F32 atCorner = new Point2D_F32();
        distortion.undistort_F32(true, true).compute(0, 0, atCorner);
        if (atCorner.norm() <= NO_LENS_PX) {
            return;
        }
        PixelTransform<Point2D_F32> straighten = new PointToPixelTransform_F32(distortion.undistort_F32(true, true));
        PixelTransform<Point2D_F32> bend = new PointToPixelTransform_F32(distortion.distort_F32(true, true));
        if (tables) {
            straighten = new PixelTransformCached_F32(widthPx, heightPx, straighten);
            bend = new PixelTransformCached_F32(widthPx, heightPx, bend);
        }
        polygons.setLensDistortion(widthPx, heightPx, straighten, bend);
        lens = distortion.distort_F64(true, true);
    }

    /**
     * Searches an image.
     *
     * @param image the image
     */
    void process(GrayU8 image) {
        BinaryContourFinder contours = polygons.getDetector().getContourFinder();
        // as long as the outline of a square that fills the image
        contours.setMaxContour(ConfigLength.fixed(4 * Math.min(image.width, image.height)));
        contours.setSaveInnerContour(false);
        binary.reshape(image.width, image.height);
        threshold.process(image, binary.withoutPadding());
        polygons.process(image, binary.padded());
        polygons.refineAll();
        polygons.getPolygons(candidates, infos);
        found.reset();
        for (int i = 0; i < candidates.size(); i++) {
            double middle = (infos.get(i).edgeInside + infos.get(i).edgeOutside) / 2;
            if (canBeRead(candidates.get(i)) && hasBlackBorder(image, middle)) {
                readCode(image, middle);
                if (code.read(dark, CODE_PLACES * CODE_PLACES)) {
                    add(candidates.get(i));
                }
            }
        }
    }

    /** The squares of the last image that read as markers, corners from the top left of the pattern clockwise. */
    DogArray<FoundFiducial> found() {
        return found;
    }

    /** Whether cells of a quadrilateral are large enough; prepares for looking at it. */
    private boolean canBeRead(Polygon2D_F64 square) {
        double shortest = Double.POSITIVE_INFINITY;
        double longest = 0;
        for (int i = 0; i < 4; i++) {
            double side = square.getSideLength(i);
            shortest = Math.min(shortest, side);
            longest = Math.max(longest, side);
            cornersPx[2 * i] = square.get(i).x;
            cornersPx[2 * i + 1] = square.get(i).y;
        }
        return shortest >= LEAST_SIDE_PX && shortest >= LEAST_SIDE_RATIO * longest
                && Homography.ofUnitSquare(cornersPx, homography);
    }

    private boolean hasBlackBorder(GrayU8 image, double middle) {
        int across = borderPlaces.length;
        int black = 0;
        for (int row = 0; row < across; row++) {
            boolean whole = row < inBorder || row >= across - inBorder;
            place(borderPlaces[row], borderPlaces, 0, whole ? across : inBorder);
            black += darker(image, middle, 0, whole ? across : inBorder);
            if (!whole) {
                place(borderPlaces[row], borderPlaces, across - inBorder, across);
                black += darker(image, middle, across - inBorder, across);
            }
        }
        int inside = across - 2 * inBorder;
        return black >= leastBlackOfBorder * (across * across - inside * inside);
    }

    /** Counts the dark places of each cell of the code. */
    private void readCode(GrayU8 image, double middle) {
        for (int cell = 0; cell < dark.length; cell++) {
            dark[cell] = 0;
        }
        for (int row = 0; row < codePlaces.length; row++) {
            place(codePlaces[row], codePlaces, 0, codePlaces.length);
            int cells = row / CODE_PLACES * codeCells;
            for (int column = 0; column < codeCells; column++) {
                dark[cells + column] += darker(image, middle, column * CODE_PLACES, (column + 1) * CODE_PLACES);
            }
        }
    }

    /** Sets where places along a row of the square lie in the image. */
    private void place(double y, double[] x, int from, int to) {
        double[] h = homography;
        double[] toU = u;
        double[] toV = v;
        double startU = h[1] * y + h[2];
        double startV = h[4] * y + h[5];
        double startW = h[7] * y + 1;
        double stepU = h[0];
        double stepV = h[3];
        double stepW = h[6];
        for (int i = from; i < to; i++) {
            double w = 1 / (stepW * x[i] + startW);
            toU[i] = (stepU * x[i] + startU) * w;
            toV[i] = (stepV * x[i] + startV) * w;
        }
        if (lens != null) {
            bend(lens, y, x, from, to);
        }
    }

    /**
     * Bends a row as the lens does: by a parabola along it, through what the lens does at both ends and in the middle.
     * Every place by itself would take most of the time of a reading; the parabola is off by a fraction of a pixel, and
     * by a small part of a cell where a marker fills half of the image.
     */
    private void bend(Point2Transform2_F64 by, double y, double[] x, int from, int to) {
        double[] h = homography;
        for (int i = 0; i <= 2; i++) {
            double w = h[6] * i / 2 + h[7] * y + 1;
            double straightU = (h[0] * i / 2 + h[1] * y + h[2]) / w;
            double straightV = (h[3] * i / 2 + h[4] * y + h[5]) / w;
            by.compute(straightU, straightV, inImage);
            bentU[i] = inImage.x - straightU;
            bentV[i] = inImage.y - straightV;
        }
        addParabola(bentU, x, u, from, to);
        addParabola(bentV, x, v, from, to);
    }

    /** Adds a parabola that is given at 0, 1/2 and 1. */
    private static void addParabola(double[] at, double[] x, double[] out, int from, int to) {
        double start = at[0];
        double slope = 4 * at[1] - 3 * at[0] - at[2];
        double curve = 2 * (at[0] + at[2]) - 4 * at[1];
        for (int i = from; i < to; i++) {
            out[i] += start + x[i] * (slope + x[i] * curve);
        }
    }

    /** How many of these places are in pixels darker than that. */
    private int darker(GrayU8 image, double middle, int from, int to) {
        byte[] grey = image.data;
        int count = 0;
        for (int i = from; i < to; i++) {
            int x = Math.max(0, Math.min(image.width - 1, (int) u[i]));
            int y = Math.max(0, Math.min(image.height - 1, (int) v[i]));
            count += (grey[image.startIndex + y * image.stride + x] & 0xFF) < middle ? 1 : 0;
        }
        return count;
    }

    private void add(Polygon2D_F64 square) {
        FoundFiducial one = found.grow();
        one.id = code.id();
        one.encodingError = 0;
        for (int i = 0; i < 4; i++) {
            Point2D_F64 corner = square.get((i + 4 - code.turns()) % 4);
            Point2D_F64 out = one.distortedPixels.get(i);
            if (lens == null) {
                out.setTo(corner);
            } else {
                lens.compute(corner.x, corner.y, out);
            }
        }
    }
}
