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
import boofcv.struct.image.GrayU8;
import georegression.struct.point.Point2D_I32;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import org.ddogleg.struct.DogArray;

/**
 * Follows contours in some windows of a binary image only, each by BoofCV's own algorithm: they are those of the whole
 * image that lie in a window, in the same order, to the last pixel. A contour at a window's border is left out, since
 * it may be that of a part: a window cuts straight sides into whatever is dark. Not thread-safe.
 */
final class WindowContours extends BinaryContourFinderLinearExternal {
    private static final Comparator<ContourPacked> BY_FIRST_PIXEL = Comparator.comparingInt(contour -> contour.id);

    private final SearchWindows windows;
    /** One for each window, as each keeps the points it has found until the next image. */
    private final List<LinearExternalContours> ofWindows = new ArrayList<>();
    private final DogArray<ContourPacked> contours = new DogArray<>(ContourPacked::new);
    private final List<ContourPacked> inOrder = new ArrayList<>();
    private final DogArray<Point2D_I32> points = new DogArray<>(Point2D_I32::new);
    private final GrayU8 view = new GrayU8();

    /** Where they are looked for. */
    WindowContours(SearchWindows windows) {
        this.windows = windows;
    }

    /** BoofCV's detector of polygons, as its factory makes it, but for these contours. */
    static DetectPolygonBinaryGrayRefine<GrayU8> polygons(ConfigPolygonDetector config, SearchWindows windows) {
        config.checkValidity();
        ConfigPolygonFromContour ofContour = config.detector;
        WindowContours contours = new WindowContours(windows);
        contours.setConnectRule(ofContour.contourRule);
        contours.setMinContour(ofContour.minimumContour);
        contours.setMaxContour(ofContour.maximumContour);
        return new DetectPolygonBinaryGrayRefine<>(
                new DetectPolygonFromContour<>(FactoryPointsToPolyline.create(ofContour.contourToPoly),
                        ofContour.clockwise, ofContour.canTouchBorder, ofContour.minimumEdgeIntensity,
                        ofContour.tangentEdgeIntensity, contours, GrayU8.class),
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
        for (int i = 0; i < windows.count(); i++) {
            if (i == ofWindows.size()) {
                ofWindows.add(new LinearExternalContours(getConnectRule()));
            }
            LinearExternalContours window = ofWindows.get(i);
            window.setMinContourLength(least);
            window.setMaxContourLength(most);
            int left = windows.left(i);
            int top = windows.top(i);
            int right = Math.min(width, windows.right(i));
            int bottom = Math.min(height, windows.bottom(i));
            // with a pixel on each side, which the algorithm sets to zero
            binary.subimage(left, top, right + 2, bottom + 2, view);
            window.process(view, 1 - left, 1 - top);
            for (int k = 0; k < window.getExternalContours().size(); k++) {
                ContourPacked contour = contours.grow();
                contour.externalIndex = k * windows.count() + i;
                if (!windows.areWhole()) {
                    window.getExternalContours().getSet(k, points);
                    if (isCut(left > 0 ? left : -1, top > 0 ? top : -1, right < width ? right - 1 : width,
                            bottom < height ? bottom - 1 : height)) {
                        continue;
                    }
                    contour.id = points.get(0).y * width + points.get(0).x;
                }
                inOrder.add(contour);
            }
        }
        if (windows.count() > 1) {
            inOrder.sort(BY_FIRST_PIXEL);
        }
    }

    /** Whether a contour has a pixel in one of these columns and rows. */
    private boolean isCut(int left, int top, int right, int bottom) {
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
        ofWindows.get(contourID % windows.count()).getExternalContours().getSet(contourID / windows.count(), storage);
    }

    @Override
    public void writeContour(int contourID, List<Point2D_I32> storage) {
        ofWindows.get(contourID % windows.count()).getExternalContours()
                .writeOverSet(contourID / windows.count(), storage);
    }
}
