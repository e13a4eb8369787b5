package org.cellgauge.vision;

import boofcv.abst.fiducial.calib.ConfigECoCheckDetector;
import boofcv.abst.fiducial.calib.ConfigECoCheckMarkers;
import boofcv.abst.fiducial.calib.ConfigGridDimen;
import boofcv.abst.geo.calibration.DetectSingleFiducialCalibration;
import boofcv.alg.fiducial.calib.ecocheck.ECoCheckDetector;
import boofcv.alg.fiducial.calib.ecocheck.ECoCheckFound;
import boofcv.factory.fiducial.FactoryFiducial;
import boofcv.factory.fiducial.FactoryFiducialCalibration;
import boofcv.struct.geo.PointIndex2D_F64;
import boofcv.struct.image.GrayF32;
import georegression.struct.point.Point2D_F64;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.cellgauge.cell.CalibrationTarget;
import org.cellgauge.cell.Reference;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.internal.geometry.MarkerGeometry;

/**
 * Finds a calibration target in photos: chessboards, ECoCheck and circle grids by BoofCV's detectors, markers by this
 * project's. Not thread-safe: every thread takes one of its own.
 */
public final class TargetDetector {
    /** Finds the points of one kind of target. */
    private interface Finder {
        void find(GreyImage image, String name, List<Integer> points, List<Double> uvPx);
    }

    /** Markers of a lens that is not known yet miss squares by more. */
    private static final double WIDE_RESIDUAL_PER_SIDE = 0.1;

    private final TargetPoints points;
    private final Finder finder;

    private TargetDetector(TargetPoints points, Finder finder) {
        this.points = points;
        this.finder = finder;
    }

    /**
     * A detector.
     *
     * @param target what to find
     * @param camera what is known of the camera so far, in the size of the photos: the sides of markers are fitted with
     *     its distortion; other targets do without
     * @return the detector
     */
    public static TargetDetector of(CalibrationTarget target, PinholeCamera camera) {
        if (target instanceof CalibrationTarget.Markers markers) {
            return ofMarkers(markers, camera);
        }
        CalibrationTarget.Grid grid = (CalibrationTarget.Grid) target;
        if (grid.pattern() == CalibrationTarget.Pattern.ECOCHECK) {
            return ofEcoCheck(grid);
        }
        DetectSingleFiducialCalibration detector = boofDetector(grid);
        return new TargetDetector(TargetPoints.flat(xy(detector.getLayout())), (image, name, found, uvPx) -> {
            if (detector.process(grey(image))) {
                for (PointIndex2D_F64 p : detector.getDetectedPoints().points) {
                    found.add(p.index);
                    uvPx.add(p.p.x);
                    uvPx.add(p.p.y);
                }
            }
        });
    }

    private static DetectSingleFiducialCalibration boofDetector(CalibrationTarget.Grid grid) {
        switch (grid.pattern()) {
            case CIRCLE_GRID:
                return FactoryFiducialCalibration.circleRegularGrid(null,
                        new ConfigGridDimen(grid.rows(), grid.columns(), grid.sizeMm(), grid.spacingMm()));
            case HEXAGONAL_CIRCLE_GRID:
                return FactoryFiducialCalibration.circleHexagonalGrid(null,
                        new ConfigGridDimen(grid.rows(), grid.columns(), grid.sizeMm(), grid.spacingMm()));
            default:
                return FactoryFiducialCalibration.chessboardX(null,
                        new ConfigGridDimen(grid.rows(), grid.columns(), grid.sizeMm()));
        }
    }

    private static TargetDetector ofEcoCheck(CalibrationTarget.Grid grid) {
        ConfigECoCheckMarkers config = ConfigECoCheckMarkers.singleShape(grid.rows(), grid.columns(), 1, grid.sizeMm());
        // not through BoofCV's adapter, which needs a library of collections for nothing
        ECoCheckDetector<GrayF32> detector = FactoryFiducial.ecocheck(new ConfigECoCheckDetector(), config,
                GrayF32.class).getDetector();
        double[] layout = xy(detector.getUtils().createCornerList(0, grid.sizeMm()));
        return new TargetDetector(TargetPoints.flat(layout), (image, name, found, uvPx) -> {
            detector.process(grey(image));
            for (ECoCheckFound board : detector.getUtils().mergeAndRemoveUnknown(detector.getFound().toList())) {
                for (PointIndex2D_F64 p : board.corners.toList()) {
                    found.add(p.index);
                    uvPx.add(p.p.x);
                    uvPx.add(p.p.y);
                }
            }
        });
    }

    private static TargetDetector ofMarkers(CalibrationTarget.Markers target, PinholeCamera camera) {
        List<Reference> markers = target.markers();
        double[] xyz = new double[12 * markers.size()];
        List<TargetPoints.Patch> patches = new ArrayList<>();
        Map<Integer, Integer> firstOf = new HashMap<>();
        List<Integer> ids = new ArrayList<>();
        for (int i = 0; i < markers.size(); i++) {
            Reference marker = markers.get(i);
            System.arraycopy(MarkerGeometry.cornersMm(marker.worldFromMarker(), marker.sizeMm()), 0, xyz, 12 * i, 12);
            patches.add(new TargetPoints.Patch(marker.worldFromMarker(), 4 * i, 4));
            firstOf.put(marker.id(), 4 * i);
            ids.add(marker.id());
        }
        if (target.isFlat()) {
            patches = List.of(new TargetPoints.Patch(RigidTransform.IDENTITY, 0,
                    4 * markers.size()));
        }
        MarkerDetector detector = new BoofMarkerDetector(camera, target.family(), ids, WIDE_RESIDUAL_PER_SIDE);
        return new TargetDetector(new TargetPoints(xyz, patches, true), (image, name, found, uvPx) -> {
            for (MarkerObservation marker : detector.detect(image, name).markers()) {
                double[] corners = marker.cornersPx();
                int first = firstOf.getOrDefault(marker.id(), 0);
                for (int k = 0; k < 4; k++) {
                    found.add(first + k);
                    uvPx.add(corners[2 * k]);
                    uvPx.add(corners[2 * k + 1]);
                }
            }
        });
    }

    private static double[] xy(List<Point2D_F64> layout) {
        double[] xy = new double[2 * layout.size()];
        for (int i = 0; i < layout.size(); i++) {
            xy[2 * i] = layout.get(i).x;
            xy[2 * i + 1] = layout.get(i).y;
        }
        return xy;
    }

    private static GrayF32 grey(GreyImage image) {
        GrayF32 out = new GrayF32(image.widthPx(), image.heightPx());
        for (int y = 0; y < image.heightPx(); y++) {
            int row = y * image.widthPx();
            for (int x = 0; x < image.widthPx(); x++) {
                out.data[row + x] = image.get(x, y);
            }
        }
        return out;
    }

    /**
     * The points that observations refer to.
     *
     * @return in the target's frame
     */
    public TargetPoints points() {
        return points;
    }

    /**
     * Looks for the target.
     *
     * @param image a photo
     * @param name its name for messages
     * @return what it shows; no points where it does not show the target
     */
    public TargetObservation find(GreyImage image, String name) {
        List<Integer> found = new ArrayList<>();
        List<Double> uvPx = new ArrayList<>();
        finder.find(image, name, found, uvPx);
        return new TargetObservation(name, image.widthPx(), image.heightPx(),
                found.stream().mapToInt(Integer::intValue).toArray(),
                uvPx.stream().mapToDouble(Double::doubleValue).toArray());
    }
}
