package org.cellgauge.vision;

import boofcv.abst.filter.binary.BinaryContourFinderLinearExternal;
import boofcv.alg.filter.binary.ContourPacked;
import boofcv.alg.filter.binary.LinearExternalContours;
import boofcv.alg.shapes.polygon.DetectPolygonBinaryGrayRefine;
import boofcv.alg.shapes.polygon.DetectPolygonFromContour;
import boofcv.alg.shapes.polygon.RefinePolygonToContour;
import boofcv.factory.shape.ConfigPolygonDetector;
import boofcv.factory.shape.ConfigPolygonFromContour;
import boofcv.factory.shape.FactoryPointsToPolyline;
import boofcv.factory.shape.FactoryShapeDetector;
import boofcv.struct.ConfigLength;
import boofcv.struct.distort.PixelTransform;
import boofcv.struct.image.GrayU8;
import georegression.struct.point.Point2D_F32;
import georegression.struct.point.Point2D_I32;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import org.ddogleg.struct.DogArray;
import org.jspecify.annotations.Nullable;

/**
 * Follows contours in some windows of a binary image only, each by BoofCV's own algorithm: they are those of the whole
 * image that lie in a window, in the same order, to the last pixel. A contour at a window's
 * border is left out, since it may be that of a part: a window cuts straight sides into whatever is dark. Of a window
 * only those places are gone through that have dark pixels: in a plain scene, looking at every pixel takes as long as
 * all the rest of finding quadrilaterals. Not thread-safe.
 */
final class WindowContours extends BinaryContourFinderLinearExternal {
    private static final Comparator<ContourPacked> BY_FIRST_PIXEL = (a, b) -> Integer.compare(a.id, b.id);

    /** Of a square as long, as BoofCV has it, squared length and area are so many times apart. */
    private static final double AREA_OF_CONTOUR = 16;

    private final SearchWindows windows;
    private final Rectangles places;
    /** One for each place, as each keeps the points it has found until the next image. */
    private final List<LinearExternalContours> ofPlaces = new ArrayList<>();
    private final DogArray<ContourPacked> contours = new DogArray<>(ContourPacked::new);
    private final List<ContourPacked> inOrder = new ArrayList<>();
    private final DogArray<Point2D_I32> points = new DogArray<>(Point2D_I32::new);
    private final GrayU8 view = new GrayU8();

    /**
     * Contours.
     *
     * @param windows where they are looked for
     * @param places parts of these windows that may have dark pixels, cut off at their borders only
     */
    WindowContours(SearchWindows windows, Rectangles places) {
        this.windows = windows;
        this.places = places;
    }

    /**
     * BoofCV's detector of polygons, as its factory makes it, but for the contours of what a threshold marks, which has
     * {@link Specks} taken out.
     */
    static DetectPolygonBinaryGrayRefine<GrayU8> polygons(ConfigPolygonDetector config, LocalMeanThreshold threshold) {
        config.checkValidity();
        ConfigPolygonFromContour ofContour = config.detector;
        int least = ofContour.minimumContour.computeI(0);
        Specks specks = new Specks(least, least * least / AREA_OF_CONTOUR);
        threshold.takeOut(specks);
        WindowContours contours = new WindowContours(threshold.windows(), threshold.places());
        contours.setConnectRule(ofContour.contourRule);
        contours.setMinContour(ofContour.minimumContour);
        contours.setMaxContour(ofContour.maximumContour);
        return new DetectPolygonBinaryGrayRefine<>(
                new DetectPolygonFromContour<>(FactoryPointsToPolyline.create(ofContour.contourToPoly),
                        ofContour.clockwise, ofContour.canTouchBorder, ofContour.minimumEdgeIntensity,
                        ofContour.tangentEdgeIntensity, contours, GrayU8.class) {
                    @Override
                    public void setLensDistortion(int width, int height,
                            @Nullable PixelTransform<Point2D_F32> straighten,
                            @Nullable PixelTransform<Point2D_F32> bend) {
                        super.setLensDistortion(width, height, straighten, bend);
                        specks.setPolygons(straighten == null);
                    }
                },
                config.refineContour ? new RefinePolygonToContour() : null,
                config.refineGray == null ? null : FactoryShapeDetector.refinePolygon(config.refineGray, GrayU8.class),
                config.minimumRefineEdgeIntensity, config.adjustForThresholdBias);
    }

    /**
     * Finds the contours.
     *
     * @param binary the image with a border of one pixel about it
     */
    @Override
    public void process(GrayU8 binary) {
        if (isCreatePaddedCopy()) {
            throw new IllegalStateException("only of images with a border");
        }
        int width = binary.width - 2;
        int height = binary.height - 2;
        double size = Math.sqrt(binary.width * binary.height);
        ConfigLength least = ConfigLength.fixed(getMinContour(null).computeNegMaxI(size));
        ConfigLength most = ConfigLength.fixed(getMaxContour(null).computeNegMaxI(size));
        contours.reset();
        inOrder.clear();
        for (int i = 0; i < places.count(); i++) {
            if (i == ofPlaces.size()) {
                ofPlaces.add(new LinearExternalContours(getConnectRule()));
            }
            LinearExternalContours place = ofPlaces.get(i);
            place.setMinContourLength(least);
            place.setMaxContourLength(most);
            int left = places.left(i);
            int top = places.top(i);
            // with a pixel on each side, which the algorithm sets to zero
            binary.subimage(left, top, Math.min(width, places.right(i)) + 2, Math.min(height, places.bottom(i)) + 2,
                    view);
            place.process(view, 1 - left, 1 - top);
            int window = windowAt(left, top);
            for (int k = 0; k < place.getExternalContours().size(); k++) {
                ContourPacked contour = contours.grow();
                contour.externalIndex = k * places.count() + i;
                place.getExternalContours().getSet(k, points);
                contour.id = points.get(0).y * width + points.get(0).x;
                if (windows.areWhole() || !isCut(window, width, height)) {
                    inOrder.add(contour);
                }
            }
        }
        if (places.count() > 1) {
            inOrder.sort(BY_FIRST_PIXEL);
        }
    }

    private int windowAt(int left, int top) {
        int window = 0;
        while (windows.right(window) <= left || windows.left(window) > left || windows.bottom(window) <= top
                || windows.top(window) > top) {
            window++;
        }
        return window;
    }

    /** Whether a contour has a pixel at a border of a window where the image goes on. */
    private boolean isCut(int window, int width, int height) {
        int left = windows.left(window) > 0 ? windows.left(window) : -1;
        int top = windows.top(window) > 0 ? windows.top(window) : -1;
        int right = windows.right(window) < width ? windows.right(window) - 1 : width;
        int bottom = windows.bottom(window) < height ? windows.bottom(window) - 1 : height;
        for (int i = 0; i < points.size; i++) {
            Point2D_I32 p = points.get(i);
            if (p.x == left || p.y == top || p.x == right || p.y == bottom) {
                return true;
            }
        }
        return false;
    }

    @Override
    public List<ContourPacked> getContours() {
        return inOrder;
    }

    @Override
    public void loadContour(int contourID, DogArray<Point2D_I32> storage) {
        ofPlaces.get(contourID % places.count()).getExternalContours().getSet(contourID / places.count(), storage);
    }

    @Override
    public void writeContour(int contourID, List<Point2D_I32> storage) {
        ofPlaces.get(contourID % places.count()).getExternalContours()
                .writeOverSet(contourID / places.count(), storage);
    }
}
