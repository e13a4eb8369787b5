package org.cellgauge.vision;

import boofcv.alg.distort.LensDistortionNarrowFOV;
import boofcv.alg.fiducial.square.FoundFiducial;
import boofcv.factory.distort.LensDistortionFactory;
import boofcv.factory.fiducial.ConfigFiducialBinary;
import boofcv.factory.fiducial.ConfigFiducialHammingDetector;
import boofcv.factory.shape.ConfigPolygonDetector;
import boofcv.struct.ConfigLength;
import boofcv.struct.calib.CameraPinholeBrown;
import boofcv.struct.image.GrayU8;
import georegression.struct.point.Point2D_F64;
import georegression.struct.shapes.Quadrilateral_F64;
import java.util.ArrayList;
import java.util.Collection;
import java.util.Collections;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import java.util.TreeMap;
import java.util.concurrent.Executor;
import org.cellgauge.cell.Cell;
import org.cellgauge.cell.CellRefusal;
import org.cellgauge.cell.InputRefusedException;
import org.cellgauge.cell.MarkerFamily;
import org.cellgauge.geometry.BrownLens;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.internal.cell.CellPhrase;
import org.cellgauge.internal.vision.BoofThreads;
import org.cellgauge.internal.warning.CheckPhrase;
import org.cellgauge.internal.warning.Decimal;
import org.cellgauge.internal.warning.Listing;
import org.cellgauge.light.ToneCurve;
import org.cellgauge.warning.Warning;
import org.jspecify.annotations.Nullable;

/**
 * Finds markers among BoofCV's quadrilaterals, sharpens their corners and judges what was found.
 *
 * <p>BoofCV finds the squares, and {@link SquareSearch} reads them. {@link MarkerEdges} then fits the sides to the
 * light behind the grey values, and {@link LightFit} the tone curve and the noise to all of them: BoofCV's own
 * refinement leaves several times the error, most of all under a lens that distorts, whose image it resamples half a
 * pixel off. {@link PatternReader} reads the cells again with the blur that the sides were found to have. Only ids of
 * the cell are reported; a quadrilateral that no pose of a square explains is left out, and so is an id seen at two
 * places, each with a warning. Where the sides cannot be fitted, the corners are BoofCV's and come with a warning, in
 * families with a checksum; a square-binary reading is then left out.
 *
 * <p>Not thread-safe: work space is kept between calls, results are not. Whether BoofCV spreads its work over threads
 * is one setting for the whole process, so no detector touches it: see {@link BoofThreads}.
 */
public final class BoofMarkerDetector implements MarkerDetector {
    private static final int NONE = -1;
    private static final byte[] NO_PIXELS = new byte[0];
    /**
     * Beyond it the margin is no white to measure edges by: with margins of a fifth and a tenth of sides of 24 px it is
     * at most 1.01, with 0.05 at least 1.07.
     */
    private static final double WHITEST_OVER_MARGIN = 1.06;
    /**
     * Standard deviation of what such a margin moves all sides by, px for a white that is twice as bright: with margins
     * of 0.05 and 0.02 of sides of 25 px whites are 1.1 and 1.5 times as bright, and sides lie 0.05 and 0.13 px
     * outwards.
     */
    private static final double DOUBT_BY_MARGIN_PX = 1;
    private static final double MOST_DOUBT_PX = 0.3;
    /** Costs faint markers, whose black is more than 0.6 times as bright as their white; 80 those above 0.5. */
    private static final int USUAL_PERCENT = 85;
    /** Where markers are missing. */
    private static final int FAINT_PERCENT = 98;
    /** Deviation of a corner that is still believed: several times the 0.4 px of real footage. */
    private static final double RESIDUAL_LIMIT_PX = 1.5;
    /**
     * Usual growth of that limit with a marker's side in the image: so grows what prints that are not quite square,
     * paper that is not quite flat and lenses that are not quite known leave.
     */
    public static final double RESIDUAL_LIMIT_PER_SIDE = 0.02;

    /**
     * Largest blur in cells, for no border and more for each cell of it: beyond it the light on the two sides of the
     * border runs into one, and what the fit takes as given of it is no longer good to a hundredth of a pixel.
     */
    private static final double BLUR_LIMIT = 0.14;
    private static final double BLUR_LIMIT_PER_BORDER_CELL = 0.17;
    /**
     * Near that limit sides hang on each other, since blur brings the light of one into the band of the next: in
     * rendered photos their variance is 1.06 times what each fit says of itself at 0.83 of the limit, 1.2 at 0.9, 1.3
     * at 0.94 and 1.5 at 0.98, whatever the noise.
     */
    private static final double NOISE_AT_BLUR_LIMIT = 0.55;
    private static final double NOISE_BY_BLUR_POWER = 9;
    /** As a share of that: the overshoot of one edge reaches the next one sooner than its blur does. */
    private static final double BLUR_LIMIT_OF_SHARPENED = 0.8;

    private final PinholeCamera camera;
    private final MarkerFamily family;
    /** Patterns of the ids to report. */
    private final Map<Integer, boolean[]> patterns = new TreeMap<>();
    private final FamilyPatterns familyPatterns;
    private final boolean hasChecksum;
    private final double residualLimitPerSide;
    private final SquareSearch squares;
    /** Whether markers that are missing are looked for again, and their reasons, at several times the cost. */
    private final boolean looksTwice;
    /** Where each image is searched; all of it where it looks twice. */
    private final DarkBits dark = new DarkBits();
    private final SearchWindows windows = new SearchWindows();
    /** Finds faint markers; null until one is missing. */
    private @Nullable SquareSearch faintSquares;
    /** Says why markers are missing; null until one is. */
    private @Nullable MarkerSurvey survey;
    /** Looks at the bent image of a wide lens as well; null for others. */
    private final @Nullable SquareSearch bentSquares;
    private final @Nullable ToneCurve statedCurve;
    private final GreyScale scale = new GreyScale();
    private final SharedLoop loop = new SharedLoop();
    private final LightFit light = new LightFit(scale, loop);
    /** For the squares of one image, each read by its own; used anew for the next. */
    private final List<Reader> readers = new ArrayList<>();
    /** Ids that the frame before showed: none of them was a square of another grid. */
    private final Set<Integer> ownGrid = new HashSet<>();
    /** Work space for the markers of one image, used anew for the next. */
    private final List<MarkerEdges> edges = new ArrayList<>();
    private int edgesUsed;
    private final MarkerGrid grid;
    private final EdgeWork.Pool works;
    private final SquareResidual residual;
    private final GrayU8 view = new GrayU8();

    /**
     * A detector for one camera and its markers. Once it has seen an image it keeps one to two bytes a pixel.
     *
     * @param camera camera of the images to come
     * @param family family of the markers
     * @param ids ids to report; all others are ignored
     */
    public BoofMarkerDetector(PinholeCamera camera, MarkerFamily family, Collection<Integer> ids) {
        this(camera, family, ids, RESIDUAL_LIMIT_PER_SIDE);
    }

    /**
     * A detector with another limit on what a marker's corners may miss a square by. Where the focal length is to be
     * estimated, true markers miss the squares of the wrong one: at 0.43 of the true focal length, markers of 100 mm at
     * 400 mm by up to 17 px and two in three by more than the usual limit. A wider limit keeps them, and lets more
     * false ones pass.
     *
     * @param camera camera of the images to come
     * @param family family of the markers
     * @param ids ids to report; all others are ignored
     * @param residualLimitPerSide growth of the limit with the marker's shortest side in the image, px per px, at least
     *     0; {@link #RESIDUAL_LIMIT_PER_SIDE} where the camera is calibrated
     */
    public BoofMarkerDetector(PinholeCamera camera, MarkerFamily family, Collection<Integer> ids,
            double residualLimitPerSide) {
        this(camera, family, ids, residualLimitPerSide, null);
    }

    /**
     * A detector for images of a known tone curve.
     *
     * @param camera camera of the images
     * @param family family of the markers
     * @param ids ids to report; all others are ignored
     * @param residualLimitPerSide as above
     * @param toneCurve how the camera makes grey of light; null: estimated from each image, starting from what the
     *     image says of itself
     */
    public BoofMarkerDetector(PinholeCamera camera, MarkerFamily family, Collection<Integer> ids,
            double residualLimitPerSide, @Nullable ToneCurve toneCurve) {
        this(camera, family, ids, residualLimitPerSide, toneCurve, true);
    }

    private BoofMarkerDetector(PinholeCamera camera, MarkerFamily family, Collection<Integer> ids,
            double residualLimitPerSide, @Nullable ToneCurve toneCurve, boolean looksTwice) {
        this.looksTwice = looksTwice;
        this.statedCurve = toneCurve;
        this.residualLimitPerSide = residualLimitPerSide;
        this.camera = camera;
        this.family = family;
        this.familyPatterns = new FamilyPatterns(family);
        this.hasChecksum = familyPatterns.correctable() > 0;
        ids.forEach(id -> patterns.put(id, familyPatterns.white(id)));
        this.squares = squares(familyPatterns, USUAL_PERCENT, windows, dark, loop);
        this.bentSquares = camera.lens().isWide() ? squares(familyPatterns, USUAL_PERCENT, windows, dark, loop) : null;
        configure(squares, camera.isDistorting());
        if (bentSquares != null) {
            configure(bentSquares, false);
        }
        this.grid = familyPatterns.grid();
        this.works = new EdgeWork.Pool(grid);
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
        return forCell(cell, true);
    }

    /**
     * A detector for the frames of a camera: a marker that is missing costs no second look, as long as another of the
     * cell is seen. It finds faint markers less often than {@link #forCell} and gives fewer reasons. Where nothing says
     * the tone curve, that of the frame before is where to start, so that corners hang on it by thousandths of a
     * pixel; and an unsharp mask, blocks of a JPEG file, or that there are none, are taken as they were. All is looked
     * for anew where edges say otherwise, and every thirtieth frame.
     *
     * <p>It searches a frame near the markers of the frame before, all of it where one of them is not found there, and
     * every tenth time: a marker that comes into the view is seen by then. Where a marker is found its corners are
     * those of a search of all of the frame, to the last bit.
     *
     * @param cell the cell
     * @return a new detector
     */
    public static BoofMarkerDetector forFrames(Cell cell) {
        return forCell(cell, false);
    }

    /**
     * Searches several parts of an image, and fits several markers, at once from now on: for frames that are waited
     * for, and not where each thread has a photo of its own. Corners are the same either way.
     *
     * @param helpers on what threads, beside the one that detects; where none is free, that one does all
     * @param threads how many threads at most, that one among them, at least 1
     * @return this detector
     */
    public BoofMarkerDetector spread(Executor helpers, int threads) {
        loop.spread(helpers, threads);
        return this;
    }

    private static BoofMarkerDetector forCell(Cell cell, boolean looksTwice) {
        Set<Integer> ids = new HashSet<>();
        cell.references().forEach(r -> ids.add(r.id()));
        cell.objects().forEach(o -> ids.add(o.id()));
        return new BoofMarkerDetector(cell.camera(), cell.family(), ids, RESIDUAL_LIMIT_PER_SIDE, cell.toneCurve(),
                looksTwice);
    }

    /** The usual search for squares, not yet prepared for a camera. */
    static SquareSearch squares(MarkerFamily family) {
        return squares(new FamilyPatterns(family), USUAL_PERCENT, new SearchWindows(), new DarkBits(),
                new SharedLoop());
    }

    private static SquareSearch squares(FamilyPatterns patterns, int percent, SearchWindows windows,
            DarkBits dark, SharedLoop loop) {
        ConfigFiducialBinary ofGrids = new ConfigFiducialBinary(1);
        ConfigFiducialHammingDetector ofCodes = new ConfigFiducialHammingDetector();
        boolean grid = patterns.dictionary() == null;
        LocalMeanThreshold threshold = new LocalMeanThreshold(percent, windows, dark, loop);
        ConfigPolygonDetector polygons = grid ? ofGrids.squareDetector : ofCodes.squareDetector;
        polygons.detector.minimumContour = ConfigLength.fixed(SquareSearch.LEAST_OUTLINE_PX);
        return new SquareSearch(threshold, WindowContours.polygons(polygons, threshold),
                patterns.grid(), grid ? ofGrids.minimumBlackBorderFraction : ofCodes.minimumBlackBorderFraction,
                new SquareCode(patterns));
    }

    /** Local mean with a margin: plain grounds and weak textures then give no contours to follow. */
    static LocalMeanThreshold threshold(DarkBits dark) {
        return new LocalMeanThreshold(USUAL_PERCENT, new SearchWindows(), dark, new SharedLoop());
    }

    static LensDistortionNarrowFOV boofLens(PinholeCamera camera) {
        if (camera.lens() != BrownLens.MODEL) {
            return new LensPlane(camera);
        }
        CameraPinholeBrown lens = new CameraPinholeBrown(3);
        lens.fsetK(camera.get(PinholeCamera.FX), camera.get(PinholeCamera.FY), camera.get(PinholeCamera.SKEW),
                camera.get(PinholeCamera.CX), camera.get(PinholeCamera.CY), camera.widthPx(), camera.heightPx());
        lens.fsetRadial(camera.get(BrownLens.K1), camera.get(BrownLens.K2), camera.get(BrownLens.K3));
        lens.fsetTangential(camera.get(BrownLens.P1), camera.get(BrownLens.P2));
        return LensDistortionFactory.narrow(lens);
    }

    @Override
    public Detections detect(GreyImage image, String imageName) {
        try {
            return detected(image, imageName);
        } finally {
            loop.dismiss();
        }
    }

    private Detections detected(GreyImage image, String imageName) {
        if (image.widthPx() != camera.widthPx() || image.heightPx() != camera.heightPx()) {
            throw new InputRefusedException(imageName, CellRefusal.IMAGE_SIZE, image.widthPx(), image.heightPx(),
                    camera.widthPx(), camera.heightPx(), CellPhrase.PHOTO_SIZE);
        }
        view.data = image.luminance();
        view.startIndex = image.offset();
        view.stride = image.rowStride();
        view.width = image.widthPx();
        view.height = image.heightPx();
        Map<Integer, List<Candidate>> byId = new TreeMap<>();
        List<Warning> warnings = new ArrayList<>();
        light.start(statedCurve, image.toneCurve(), !looksTwice);
        List<Seen> seen = new ArrayList<>();
        try {
            windows.begin(view.width, view.height);
            if (!look(image, seen)) {
                windows.showWhole();
                seen.clear();
                look(image, seen);
            }
        } finally {
            view.data = NO_PIXELS;
        }
        List<MarkerEdges> fitted = new ArrayList<>();
        List<boolean[]> read = new ArrayList<>();
        for (Seen square : seen) {
            if (square.edges != null && patterns.containsKey(square.idRead)) {
                fitted.add(square.edges);
                read.add(patterns.get(square.idRead));
            }
        }
        light.fit(image, fitted, read);
        light.warn(fitted, warnings);
        readAll(image, seen);
        loop.dismiss();
        for (Seen square : seen) {
            Candidate candidate = candidate(square, warnings);
            if (!looksTwice && (candidate != null || patterns.containsKey(square.idRead))) {
                windows.keep(square.idRead, square.cornersPx, candidate != null);
            }
            if (candidate != null) {
                byId.computeIfAbsent(candidate.observation.id(), k -> new ArrayList<>()).add(candidate);
            }
        }
        windows.end();
        List<MarkerObservation> accepted = new ArrayList<>();
        byId.forEach((id, ofId) -> judge(id, ofId, accepted, warnings));
        if (accepted.isEmpty() || accepted.size() < patterns.size() && looksTwice) {
            survey(image, byId.keySet(), warnings);
        }
        ownGrid.clear();
        accepted.forEach(marker -> ownGrid.add(marker.id()));
        return new Detections(imageName, image.widthPx(), image.heightPx(), accepted, warnings,
                fitted.isEmpty() ? null : light.light());
    }

    /** Fills in the squares of this image. False where its windows do not show the markers they were made for. */
    private boolean look(GreyImage image, List<Seen> seen) {
        loop.gather();
        squares.process(view);
        int count = squares.found().size();
        if (bentSquares != null) {
            bentSquares.process(view);
            count += bentSquares.found().size();
        }
        if (!windows.areWhole() && count < windows.markers()) {
            return false;
        }
        seeAll(image, seen);
        if (bentSquares != null) {
            lookAgain(bentSquares, image, seen);
        }
        if (looksTwice && !showsAll(seen)) {
            loop.dismiss();
            faintSquares().process(view);
            lookAgain(faintSquares(), image, seen);
            loop.gather();
        }
        for (Seen square : seen) {
            if (square.edges != null && !patterns.containsKey(square.idRead)) {
                readAgain(image, square, square.edges);
            }
            windows.see(square.idRead, square.cornersPx);
        }
        return windows.areWhole() || !windows.missMarkers();
    }

    /** Where the last image was searched. */
    SearchWindows windows() {
        return windows;
    }

    /** Whether every marker of the cell is among the squares, as they were read at first. */
    private boolean showsAll(List<Seen> seen) {
        Set<Integer> read = new HashSet<>();
        seen.forEach(square -> read.add(square.idRead));
        return read.containsAll(patterns.keySet());
    }

    /**
     * A search that follows weaker contours too, for markers whose black is nearly as bright as their white. On a
     * textured ground it takes many times as long as the usual one.
     */
    private SquareSearch faintSquares() {
        if (faintSquares == null) {
            faintSquares = squares(familyPatterns, FAINT_PERCENT, windows, dark, loop);
            configure(faintSquares, straightensOnePlane());
        }
        return faintSquares;
    }

    /** Whether the lens bends lines, and one plane shows them all straight. */
    private boolean straightensOnePlane() {
        return camera.isDistorting() && !camera.lens().isWide();
    }

    /**
     * Prepares for the camera. Without tables of the lens for every pixel: with them the corners are the same to the
     * last bit, and they would take 50 MB and 0.4 s for 1280 x 720 px, 670 MB and 15 s for 4000 x 3000 px.
     */
    private void configure(SquareSearch search, boolean straightened) {
        search.configure(straightened ? boofLens(camera) : null, camera.widthPx(), camera.heightPx(), false);
    }

    private void survey(GreyImage image, Set<Integer> found, List<Warning> warnings) {
        if (survey == null) {
            survey = new MarkerSurvey(family, patterns.keySet(), new ConfigFiducialBinary(1).squareDetector, dark);
            survey.squares().configure(straightensOnePlane() ? boofLens(camera) : null, camera.widthPx(),
                    camera.heightPx(), false);
        }
        view.data = image.luminance();
        try {
            survey.look(view, found, warnings);
        } finally {
            view.data = NO_PIXELS;
        }
    }

    /**
     * Adds the squares that another search has shown as markers of the cell: in the bent image of a wide lens, far off
     * the axis, where {@link LensPlane} is not straight or stretches a marker out of shape; or with weaker contours.
     */
    private void lookAgain(SquareSearch again, GreyImage image, List<Seen> seen) {
        int straight = seen.size();
        for (int i = 0; i < again.found().size(); i++) {
            FoundFiducial found = again.found().get(i);
            if (!isOfFamily(found)) {
                continue;
            }
            int at = 0;
            while (at < straight && !seen.get(at).isAt(found.distortedPixels)) {
                at++;
            }
            if (at == straight) {
                seen.add(seen(image, (int) found.id, found.distortedPixels));
            } else if (seen.get(at).edges == null || !patterns.containsKey(seen.get(at).idRead)) {
                seen.set(at, seen(image, (int) found.id, found.distortedPixels));
            }
        }
    }

    /** Large grids have more ids than fit a family's numbers. */
    private boolean isOfFamily(FoundFiducial found) {
        return found.id >= 0 && found.id < family.size();
    }

    /** A square that was read once, with its sides fitted where that was possible. */
    private static final class Seen {
        int idRead;
        final double[] cornersPx;
        final @Nullable MarkerEdges edges;
        /** Of the marker of the cell that it is, in the photo's light; {@link #NONE} for none. */
        int id = NONE;
        /** See {@link PatternReader#whiteOverMargin}. */
        double whiteOverMargin;

        Seen(int idRead, double[] cornersPx, @Nullable MarkerEdges edges) {
            this.idRead = idRead;
            this.cornersPx = cornersPx;
            this.edges = edges;
        }

        /** Whether its middle lies within another square's, as far as half a side about its middle goes. */
        boolean isAt(Quadrilateral_F64 q) {
            double u = (q.a.x + q.b.x + q.c.x + q.d.x) / 4;
            double v = (q.a.y + q.b.y + q.c.y + q.d.y) / 4;
            double ownU = 0;
            double ownV = 0;
            double shortest = Double.POSITIVE_INFINITY;
            for (int i = 0; i < 8; i += 2) {
                ownU += cornersPx[i] / 4;
                ownV += cornersPx[i + 1] / 4;
                int next = (i + 2) % 8;
                shortest = Math.min(shortest,
                        Math.hypot(cornersPx[next] - cornersPx[i], cornersPx[next + 1] - cornersPx[i + 1]));
            }
            return Math.hypot(ownU - u, ownV - v) < shortest / 2;
        }
    }

    /** Fits the sides of all squares that were found. */
    private void seeAll(GreyImage image, List<Seen> seen) {
        List<Seen> found = new ArrayList<>();
        for (int i = 0; i < squares.found().size(); i++) {
            FoundFiducial one = squares.found().get(i);
            if (isOfFamily(one)) {
                found.add(new Seen((int) one.id, corners(one.distortedPixels), edges(found.size())));
            }
        }
        boolean[][] patternOf = new boolean[found.size()][];
        for (int i = 0; i < patternOf.length; i++) {
            patternOf[i] = pattern(found.get(i).idRead);
        }
        boolean[] fitted = new boolean[found.size()];
        loop.each(found.size(), i -> fitted[i] = edges.get(i).fit(image, found.get(i).cornersPx, patternOf[i]));
        edgesUsed = 0;
        for (int i = 0; i < fitted.length; i++) {
            if (fitted[i]) {
                seen.add(found.get(i));
                // those that could not be fitted stand behind, to be used next
                Collections.swap(edges, edgesUsed++, i);
            } else {
                seen.add(new Seen(found.get(i).idRead, found.get(i).cornersPx, null));
            }
        }
    }

    private Seen seen(GreyImage image, int idRead, Quadrilateral_F64 q) {
        double[] corners = corners(q);
        MarkerEdges own = edges(edgesUsed);
        if (!own.fit(image, corners, pattern(idRead))) {
            return new Seen(idRead, corners, null);
        }
        edgesUsed++;
        return new Seen(idRead, corners, own);
    }

    private MarkerEdges edges(int number) {
        if (number == edges.size()) {
            edges.add(new MarkerEdges(camera, grid, scale, works));
        }
        return edges.get(number);
    }

    private boolean[] pattern(int id) {
        boolean[] listed = patterns.get(id);
        return listed != null ? listed : familyPatterns.white(id);
    }

    private static double[] corners(Quadrilateral_F64 q) {
        double[] corners = new double[8];
        put(q.a, corners, 0);
        put(q.b, corners, 2);
        put(q.c, corners, 4);
        put(q.d, corners, 6);
        return corners;
    }

    /**
     * Reads a square again that was first taken for no marker of the cell, as happens where blur is near the limit.
     * Left for later, such a marker would say nothing of the photo's light, and would stay as it was fitted with the
     * cells of another: off by 0.35 px at a blur of 2 px in the dark.
     */
    private void readAgain(GreyImage image, Seen square, MarkerEdges own) {
        own.corners(square.cornersPx);
        boolean[] white = familyPatterns.white(square.idRead).clone();
        int turns = read(image, own, reader(0), square, white);
        if (turns == NONE) {
            return;
        }
        square.idRead = listedId(white);
        own.turn((4 - turns) % 4);
        own.refit(image, familyPatterns.white(square.idRead));
    }

    /**
     * Reads the cells of a fitted square.
     *
     * @param white the reading to start from; replaced by the one that was found, turned upright
     * @return by how many quarters it was turned until it was that of a marker of the cell; {@link #NONE} if it never
     *     is
     */
    private int read(GreyImage image, MarkerEdges marker, Reader reader, Seen square, boolean[] white) {
        double[] corners = square.cornersPx;
        if (!reader.cells.read(image, corners, scale, marker.darkGrey(), marker.brightGrey(), marker.blurPx(), white)) {
            return NONE;
        }
        boolean[] asSeen = white.clone();
        for (int turns = 0; turns < 4; turns++) {
            if (listedId(white) != NONE) {
                square.whiteOverMargin = reader.cells.whiteOverMargin(asSeen);
                if (light.isKept() && ownGrid.contains(listedId(white))) {
                    return turns;
                }
                double misfit = reader.cells.misfit(image, scale, marker.darkGrey(), marker.brightGrey(), asSeen);
                return reader.otherGrids.explainBetter(misfit, image, corners, scale, marker) ? NONE : turns;
            }
            System.arraycopy(familyPatterns.turnedClockwise(white), 0, white, 0, white.length);
        }
        return NONE;
    }

    /** Reads all squares in the photo's light, and fits those anew that were taken for another marker before. */
    private void readAll(GreyImage image, List<Seen> seen) {
        for (int i = 0; i < seen.size(); i++) {
            reader(i);
        }
        loop.each(seen.size(), i -> {
            Seen square = seen.get(i);
            if (square.edges == null) {
                square.id = square.idRead;
            } else {
                readLast(image, square, square.edges, readers.get(i));
            }
        });
    }

    private void readLast(GreyImage image, Seen square, MarkerEdges marker, Reader reader) {
        boolean[] listed = patterns.get(square.idRead);
        if (listed == null) {
            listed = familyPatterns.white(square.idRead);
            light.refit(image, marker, listed);
        }
        marker.corners(square.cornersPx);
        boolean[] white = listed.clone();
        int turns = read(image, marker, reader, square, white);
        square.id = turns == NONE ? NONE : listedId(white);
        if (turns > 0) {
            // undoes the turn: a pattern that was turned so far lies upright after the rest of a full turn
            marker.turn(4 - turns);
        }
        if (square.id != NONE && (square.id != square.idRead || turns > 0)) {
            // read as another marker, or turned: the light from its cells was not what the sides were fitted with
            light.refit(image, marker, pattern(square.id));
        }
    }

    private Reader reader(int number) {
        if (number == readers.size()) {
            readers.add(new Reader(camera, grid));
        }
        return readers.get(number);
    }

    /** Work space for reading one square. */
    private static final class Reader {
        final PatternReader cells;
        final OtherGrids otherGrids;

        Reader(PinholeCamera camera, MarkerGrid grid) {
            cells = new PatternReader(camera, grid);
            otherGrids = new OtherGrids(camera, grid);
        }
    }

    /** One square that was read, judged in the photo's light; null where it is no marker of the cell. */
    private @Nullable Candidate candidate(Seen square, List<Warning> warnings) {
        int id = square.id;
        MarkerEdges marker = square.edges;
        double[] corners = square.cornersPx;
        // without its edges there is the first reading alone, and only a code with a checksum can stand on that
        if (!patterns.containsKey(id) || marker == null && !hasChecksum) {
            if (patterns.containsKey(square.idRead)) {
                warnings.add(Warning.of(marker != null ? DetectionWarning.CELLS_DO_NOT_MATCH
                        : DetectionWarning.EDGES_NOT_MEASURED, square.idRead, pixel(mean(corners, 0)),
                        pixel(mean(corners, 1))));
            }
            return null;
        }
        if (marker == null) {
            return new Candidate(new MarkerObservation(id, corners), residual.impliedStdPx(corners), false);
        }
        int glare = light.glarePercent(marker);
        if (glare > 0) {
            warnings.add(Warning.of(DetectionWarning.GLARE, id, glare));
        }
        // of a sharpened photo the code's white is brighter whatever the margin
        double whiteOverMargin = square.whiteOverMargin;
        boolean thinMargin = whiteOverMargin > WHITEST_OVER_MARGIN && !light.undoesMask();
        if (thinMargin) {
            warnings.add(Warning.of(DetectionWarning.MARGIN_TOO_THIN, id,
                    (int) Math.round(100 * (whiteOverMargin - 1))));
        }
        double blurPx = light.blurInPhotoPx(marker);
        double limit = (BLUR_LIMIT + BLUR_LIMIT_PER_BORDER_CELL * grid.borderCells()) * marker.cellPx();
        if (blurPx > (light.isSharpened() ? BLUR_LIMIT_OF_SHARPENED : 1) * limit) {
            warnings.add(Warning.of(DetectionWarning.TOO_BLURRED, id, Decimal.of(blurPx, 1),
                    Decimal.of(marker.cellPx(), 1)));
            return null;
        }
        if (light.isOdd(marker)) {
            warnings.add(Warning.of(DetectionWarning.EDGES_NOT_MEASURED, id, pixel(mean(corners, 0)),
                    pixel(mean(corners, 1))));
            return null;
        }
        double[] noise = light.noiseOfSides(marker);
        double lessKnown = Math.sqrt(1 + NOISE_AT_BLUR_LIMIT * Math.pow(blurPx / limit, NOISE_BY_BLUR_POWER));
        for (int i = 0; i < noise.length; i++) {
            noise[i] *= lessKnown;
        }
        MarkerObservation observation = marker.observation(id, noise, light.shiftStdPx(), light.inDarkPx());
        if (thinMargin) {
            observation = withSidesInDoubt(observation,
                    Math.min(MOST_DOUBT_PX, DOUBT_BY_MARGIN_PX * (whiteOverMargin - 1)));
        }
        return new Candidate(observation, residual.impliedStdPx(observation.cornersPx()), true);
    }

    /** The same corners if all sides may lie elsewhere by the same, which the inner edges do not see. */
    private static MarkerObservation withSidesInDoubt(MarkerObservation of, double stdPx) {
        double[] covariance = Objects.requireNonNull(of.covariancePx2(), "corners of a fit have one");
        double[] byShift = EdgeShift.ofCorners(of.cornersPx());
        for (int i = 0; i < 64; i++) {
            covariance[i] += stdPx * stdPx * byShift[i / 8] * byShift[i % 8];
        }
        return new MarkerObservation(of.id(), of.cornersPx(), covariance, of.edgeShift());
    }

    private int listedId(boolean[] white) {
        for (Map.Entry<Integer, boolean[]> listed : patterns.entrySet()) {
            if (FamilyPatterns.differences(listed.getValue(), white) <= familyPatterns.correctable()) {
                return listed.getKey();
            }
        }
        return NONE;
    }

    private static double mean(double[] corners, int axis) {
        return (corners[axis] + corners[2 + axis] + corners[4 + axis] + corners[6 + axis]) / 4;
    }

    /** A place as warnings name it. */
    private static int pixel(double px) {
        return (int) Math.round(px);
    }

    private static void put(Point2D_F64 p, double[] corners, int at) {
        corners[at] = p.x;
        corners[at + 1] = p.y;
    }

    private void judge(int id, List<Candidate> candidates, List<MarkerObservation> accepted,
            List<Warning> warnings) {
        List<Candidate> squares = new ArrayList<>();
        for (Candidate c : candidates) {
            double limit = RESIDUAL_LIMIT_PX + residualLimitPerSide * c.observation.shortestSidePx();
            if (c.impliedStdPx <= limit) {
                squares.add(c);
            } else {
                warnings.add(Warning.of(DetectionWarning.NOT_SQUARE, id, pixel(c.centre(0)), pixel(c.centre(1)),
                        Decimal.of(c.impliedStdPx, 1), Decimal.of(limit, 1)));
            }
        }
        squares.sort((a, b) -> Double.compare(a.impliedStdPx, b.impliedStdPx));
        // outline and inner edge of one marker may both be followed: the same marker twice, not two markers
        List<Candidate> apart = new ArrayList<>();
        for (Candidate c : squares) {
            if (apart.stream().noneMatch(c::isSamePlaceAs)) {
                apart.add(c);
            }
        }
        if (apart.size() > 1) {
            List<Warning> places = new ArrayList<>();
            apart.forEach(c -> places.add(Warning.of(CheckPhrase.PLACE, pixel(c.centre(0)), pixel(c.centre(1)))));
            warnings.add(Warning.of(DetectionWarning.SEEN_TWICE, id, places.size(), Listing.and(places)));
            return;
        }
        if (squares.isEmpty()) {
            return;
        }
        Candidate best = squares.get(0);
        accepted.add(best.observation);
        if (!best.refined) {
            warnings.add(Warning.of(DetectionWarning.COARSE_CORNERS, id));
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
            return mean(observation.cornersPx(), axis);
        }

        boolean isSamePlaceAs(Candidate other) {
            return Math.hypot(centre(0) - other.centre(0), centre(1) - other.centre(1))
                    < 0.5 * other.observation.shortestSidePx();
        }
    }
}
