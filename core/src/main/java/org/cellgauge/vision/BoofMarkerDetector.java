package org.cellgauge.vision;

import boofcv.alg.distort.LensDistortionNarrowFOV;
import boofcv.alg.fiducial.square.BaseDetectFiducialSquare;
import boofcv.alg.fiducial.square.FoundFiducial;
import boofcv.factory.distort.LensDistortionFactory;
import boofcv.factory.fiducial.ConfigFiducialBinary;
import boofcv.factory.fiducial.ConfigFiducialHammingDetector;
import boofcv.factory.fiducial.ConfigHammingMarker;
import boofcv.factory.fiducial.FactoryFiducial;
import boofcv.factory.fiducial.HammingDictionary;
import boofcv.factory.filter.binary.ConfigThreshold;
import boofcv.factory.filter.binary.ThresholdType;
import boofcv.factory.shape.ConfigPolygonDetector;
import boofcv.factory.shape.ConfigRefinePolygonLineToImage;
import boofcv.struct.calib.CameraPinholeBrown;
import boofcv.struct.image.GrayU8;
import georegression.struct.point.Point2D_F64;
import georegression.struct.shapes.Quadrilateral_F64;
import java.util.ArrayList;
import java.util.Collection;
import java.util.Comparator;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import org.cellgauge.cell.Cell;
import org.cellgauge.cell.InputRefusedException;
import org.cellgauge.cell.MarkerFamily;
import org.cellgauge.geometry.PinholeCamera;

/**
 * Finds markers with BoofCV's square detectors, sharpens their corners and judges what was found.
 *
 * <p>BoofCV finds and reads the squares. {@link EdgeRefiner} then fits the sides to the grey values, since BoofCV's own
 * refinement samples an image of a distorting lens half a pixel off. Only ids of the cell are reported; a
 * quadrilateral that no pose of a square explains is left out, and so is an id seen at two places, each with a warning.
 *
 * <p>Not thread-safe: work space is kept between calls, results are not. Whether BoofCV spreads its work over threads
 * is one setting for the whole process, so no detector touches it: see {@link BoofThreads}.
 */
public final class BoofMarkerDetector implements MarkerDetector {
    /** Sides below this many pixels are found unreliably once the image is a little blurred. */
    public static final double SMALL_SIDE_PX = 25;
    private static final double ADVISED_SIDE_PX = 32;
    /** Deviation of a corner that is still believed: several times the 0.4 px of real footage. */
    private static final double RESIDUAL_LIMIT_PX = 1.5;
    /** Prints that are not quite square, paper that is not quite flat and lenses that are not quite known grow so. */
    private static final double RESIDUAL_LIMIT_PER_SIDE = 0.02;

    private final PinholeCamera camera;
    private final Set<Integer> ids;
    private final BaseDetectFiducialSquare<GrayU8> squares;
    private final EdgeRefiner refiner;
    private final SquareResidual residual;
    private final GrayU8 view = new GrayU8();

    /**
     * A detector for one camera and its markers. With a distorting lens this takes some 0.1 to 0.3 s and, for
     * 1280 x 720 px, 50 MB: the lens is tabulated for every pixel.
     *
     * @param camera camera of the images to come
     * @param family family of the markers
     * @param ids ids to report; all others are ignored
     */
    public BoofMarkerDetector(PinholeCamera camera, MarkerFamily family, Collection<Integer> ids) {
        this.camera = camera;
        this.ids = new HashSet<>(ids);
        this.squares = family.isSquareBinary() ? squareBinary() : squareHamming(family);
        if (camera.hasDistortion()) {
            squares.configure(boofLens(camera), camera.widthPx(), camera.heightPx(), true);
        } else {
            squares.configure(null, camera.widthPx(), camera.heightPx(), false);
        }
        this.refiner = new EdgeRefiner(camera, squares.getBorderWidthFraction());
        this.residual = new SquareResidual(camera);
        view.subImage = true;
    }

    /**
     * A detector for all markers of a cell.
     *
     * @param cell the cell
     * @return a new detector
     */
    public static BoofMarkerDetector forCell(Cell cell) {
        Set<Integer> ids = new HashSet<>();
        cell.references().forEach(r -> ids.add(r.id()));
        cell.objects().forEach(o -> ids.add(o.id()));
        return new BoofMarkerDetector(cell.camera(), cell.family(), ids);
    }

    private static BaseDetectFiducialSquare<GrayU8> squareBinary() {
        ConfigFiducialBinary config = new ConfigFiducialBinary(1);
        refineTightly(config.squareDetector);
        return FactoryFiducial.squareBinary(config, threshold(), GrayU8.class).getAlgorithm();
    }

    private static BaseDetectFiducialSquare<GrayU8> squareHamming(MarkerFamily family) {
        ConfigHammingMarker markers = ConfigHammingMarker.loadDictionary(
                HammingDictionary.valueOf(family.dictionaryName()));
        ConfigFiducialHammingDetector config = new ConfigFiducialHammingDetector();
        config.configThreshold = threshold();
        refineTightly(config.squareDetector);
        return FactoryFiducial.squareHamming(markers, config, GrayU8.class).getAlgorithm();
    }

    /** Local mean with a margin: plain grounds and weak textures then give no contours to follow. */
    private static ConfigThreshold threshold() {
        ConfigThreshold threshold = ConfigThreshold.local(ThresholdType.LOCAL_MEAN, 21);
        threshold.scale = 0.80;
        return threshold;
    }

    private static void refineTightly(ConfigPolygonDetector squareDetector) {
        ConfigRefinePolygonLineToImage refine = new ConfigRefinePolygonLineToImage();
        refine.convergeTolPixels = 0.01;
        refine.maxIterations = 30;
        refine.lineSamples = 60;
        refine.cornerOffset = 1;
        refine.sampleRadius = 2;
        squareDetector.refineGray = refine;
    }

    private static LensDistortionNarrowFOV boofLens(PinholeCamera camera) {
        CameraPinholeBrown lens = new CameraPinholeBrown(3);
        lens.fsetK(camera.get(PinholeCamera.FX), camera.get(PinholeCamera.FY), camera.get(PinholeCamera.SKEW),
                camera.get(PinholeCamera.CX), camera.get(PinholeCamera.CY), camera.widthPx(), camera.heightPx());
        lens.fsetRadial(camera.get(PinholeCamera.K1), camera.get(PinholeCamera.K2), camera.get(PinholeCamera.K3));
        lens.fsetTangential(camera.get(PinholeCamera.P1), camera.get(PinholeCamera.P2));
        return LensDistortionFactory.narrow(lens);
    }

    @Override
    public Detections detect(GreyImage image, String imageName) {
        if (image.widthPx() != camera.widthPx() || image.heightPx() != camera.heightPx()) {
            throw new InputRefusedException(String.format(Locale.ROOT, "%s: the image is %d x %d px, but the camera is "
                    + "calibrated for %d x %d px; take the photo at that size or calibrate the camera at this one",
                    imageName, image.widthPx(), image.heightPx(), camera.widthPx(), camera.heightPx()));
        }
        view.data = image.luminance();
        view.startIndex = image.offset();
        view.stride = image.rowStride();
        view.width = image.widthPx();
        view.height = image.heightPx();
        Map<Integer, List<Candidate>> byId = new TreeMap<>();
        try {
            squares.process(view);
            for (int i = 0; i < squares.getFound().size(); i++) {
                FoundFiducial found = squares.getFound().get(i);
                int id = (int) found.id;
                if (ids.contains(id)) {
                    byId.computeIfAbsent(id, k -> new ArrayList<>()).add(candidate(image, id, found));
                }
            }
        } finally {
            view.data = NO_PIXELS;
        }
        List<MarkerObservation> accepted = new ArrayList<>();
        List<String> warnings = new ArrayList<>();
        byId.forEach((id, candidates) -> judge(id, candidates, accepted, warnings));
        return new Detections(imageName, image.widthPx(), image.heightPx(), accepted, warnings);
    }

    private static final byte[] NO_PIXELS = new byte[0];

    private Candidate candidate(GreyImage image, int id, FoundFiducial found) {
        Quadrilateral_F64 q = found.distortedPixels;
        double[] corners = new double[8];
        put(q.a, corners, 0);
        put(q.b, corners, 2);
        put(q.c, corners, 4);
        put(q.d, corners, 6);
        boolean refined = refiner.refine(image, corners);
        return new Candidate(new MarkerObservation(id, corners), residual.impliedStdPx(corners), refined);
    }

    private static void put(Point2D_F64 p, double[] corners, int at) {
        corners[at] = p.x;
        corners[at + 1] = p.y;
    }

    private static void judge(int id, List<Candidate> candidates, List<MarkerObservation> accepted,
            List<String> warnings) {
        List<Candidate> squares = new ArrayList<>();
        for (Candidate c : candidates) {
            double limit = RESIDUAL_LIMIT_PX + RESIDUAL_LIMIT_PER_SIDE * c.observation.shortestSidePx();
            if (c.impliedStdPx <= limit) {
                squares.add(c);
            } else {
                warnings.add(String.format(Locale.ROOT, "marker %d at (%.0f, %.0f) px is left out: its corners miss "
                        + "those of a square by %.1f px (limit %.1f); look for something that covers or bends it, or "
                        + "for another pattern taken for it", id, c.centre(0), c.centre(1), c.impliedStdPx, limit));
            }
        }
        squares.sort(Comparator.comparingDouble(c -> c.impliedStdPx));
        for (int i = 1; i < squares.size(); i++) {
            // outline and inner edge of one marker may both be followed: the same marker twice, not two markers
            if (!squares.get(i).isSamePlaceAs(squares.get(0))) {
                warnings.add(String.format(Locale.ROOT, "marker %d is seen at (%.0f, %.0f) px and at (%.0f, %.0f) px "
                        + "and is left out at both; an id may stand only once in view: remove or cover the other",
                        id, squares.get(0).centre(0), squares.get(0).centre(1), squares.get(i).centre(0),
                        squares.get(i).centre(1)));
                return;
            }
        }
        if (squares.isEmpty()) {
            return;
        }
        Candidate best = squares.get(0);
        accepted.add(best.observation);
        double side = best.observation.shortestSidePx();
        if (side < SMALL_SIDE_PX) {
            warnings.add(String.format(Locale.ROOT, "marker %d is small: its shortest side is %.1f px in the image, "
                    + "below %.0f px it is easily missed or misread; use a larger marker or a closer camera (%.0f px "
                    + "are good)", id, side, SMALL_SIDE_PX, ADVISED_SIDE_PX));
        }
        if (!best.refined) {
            warnings.add(String.format(Locale.ROOT, "marker %d: its edges are too blurred, short or covered to be "
                    + "measured finely; its corners are coarse", id));
        }
    }

    private static final class Candidate {
        private final MarkerObservation observation;
        private final double impliedStdPx;
        private final boolean refined;

        Candidate(MarkerObservation observation, double impliedStdPx, boolean refined) {
            this.observation = observation;
            this.impliedStdPx = impliedStdPx;
            this.refined = refined;
        }

        double centre(int axis) {
            double[] c = observation.cornersPx();
            return (c[axis] + c[2 + axis] + c[4 + axis] + c[6 + axis]) / 4;
        }

        boolean isSamePlaceAs(Candidate other) {
            return Math.hypot(centre(0) - other.centre(0), centre(1) - other.centre(1))
                    < 0.5 * other.observation.shortestSidePx();
        }
    }
}
