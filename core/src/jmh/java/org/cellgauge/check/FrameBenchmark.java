package org.cellgauge.check;

import boofcv.concurrency.BoofConcurrency;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.TimeUnit;
import org.cellgauge.cell.Cell;
import org.cellgauge.cell.MarkerFamily;
import org.cellgauge.estimate.ObjectEstimate;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.internal.estimate.ImageEllipses;
import org.cellgauge.internal.laplace.CameraFit;
import org.cellgauge.internal.laplace.LinearModel;
import org.cellgauge.internal.laplace.ObjectFit;
import org.cellgauge.internal.overlay.CellOverlay;
import org.cellgauge.internal.overlay.ImageOrientation;
import org.cellgauge.internal.overlay.Overlay;
import org.cellgauge.internal.overlay.OverlayStyle;
import org.cellgauge.internal.pose.CornerErrors;
import org.cellgauge.internal.pose.InitialPose;
import org.cellgauge.internal.pose.IntrinsicsPrior;
import org.cellgauge.internal.pose.MarkerPoseFinder;
import org.cellgauge.internal.pose.PoseMode;
import org.cellgauge.internal.pose.ReferenceView;
import org.cellgauge.internal.pose.RigidMarkerNoise;
import org.cellgauge.live.MovingCamera;
import org.cellgauge.settings.CheckSettings;
import org.cellgauge.statistics.Ellipse;
import org.cellgauge.vision.BoofMarkerDetector;
import org.cellgauge.vision.Detections;
import org.cellgauge.vision.DrawnMarkers;
import org.cellgauge.vision.GreyImage;
import org.cellgauge.vision.MarkerObservation;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.TearDown;
import org.openjdk.jmh.annotations.Warmup;

/**
 * What one frame of a live check costs before any chain: four references and three objects in 1280 x 720 px, one
 * thread where nothing else is said; and what a second of a moving camera costs as a live check has it, in 1920 x 1080
 * px.
 */
@State(Scope.Thread)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.MICROSECONDS)
@Fork(1)
@Warmup(iterations = 4, time = 2)
@Measurement(iterations = 5, time = 2)
public class FrameBenchmark {
    private static final PinholeCamera CAMERA = ThesisScene.CAMERA;
    private static final double PIXEL_STD = 0.1;
    private static final OverlayStyle PORTRAIT =
            OverlayStyle.PHOTO.withOrientation(ImageOrientation.of(1, false)).withoutPanels();
    private static final int PROCESSORS = Runtime.getRuntime().availableProcessors();
    private static final int FRAMES_OF_A_SECOND = 30;

    private final CheckSettings settings = CheckSettings.builder().threads(1).build();
    private Cell cell;
    private GreyImage image;
    private BoofMarkerDetector detector;
    private BoofMarkerDetector frames;
    private BoofMarkerDetector spreadFrames;
    private ExecutorService helpers;
    private Detections detections;
    private ReferenceView view;
    private CameraFit unfitted;
    private RigidTransform initial;
    private RigidTransform lastFrame;
    private CameraFit camera;
    private List<ObjectFit> objects;
    private final MarkerPoseFinder finder = new MarkerPoseFinder();
    private QuickLooks looks;
    private QuickLook quickLook;
    private MovingCamera moving;

    /** Draws the frame and does each step once, for the next one to start from. */
    @Setup
    public void prepare() {
        BoofConcurrency.setMaxThreads(1);
        ThesisScene scene = ThesisScene.inPlane(4).placement(1, 0.003).pixelStd(PIXEL_STD).target(3)
                .grip(20, 0, 0, 100);
        cell = scene.cell();
        DrawnMarkers picture = new DrawnMarkers(CAMERA.widthPx(), CAMERA.heightPx(), 130);
        List<Integer> ids = new ArrayList<>();
        for (MarkerObservation marker : scene.exactDetections().markers()) {
            picture.draw(MarkerFamily.SQUARE_BINARY, marker.id(), marker.cornersPx());
            ids.add(marker.id());
        }
        image = picture.image();
        detector = new BoofMarkerDetector(CAMERA, MarkerFamily.SQUARE_BINARY, ids);
        helpers = Executors.newFixedThreadPool(PROCESSORS);
        frames = BoofMarkerDetector.forFrames(cell);
        spreadFrames = BoofMarkerDetector.forFrames(cell).spread(helpers, PROCESSORS);
        detections = detection();
        if (detections.markers().size() != ids.size()) {
            throw new IllegalStateException("only " + detections.markers().size() + " markers were found");
        }
        CornerErrors errors = CornerErrors.of(cell, detections);
        view = ReferenceView.of(cell.references(), errors);
        unfitted = new CameraFit(CAMERA, settings, view, IntrinsicsPrior.KNOWN, null, errors, 0);
        initial = initialPose();
        lastFrame = RigidTransform.ofEuler(423, 104, 1072, 3.085, 0.098, 0.023);
        camera = unfitted.at(modeFromInitialPose(), initial);
        objects = new ArrayList<>();
        for (List<PoseMode> modes : objectModes()) {
            objects.add(new ObjectFit(cell.objects().get(objects.size()), errors, camera.mode().state(), modes));
        }
        looks = new QuickLooks(cell, settings);
        quickLook = quickLookFromLastFrame();
        moving = new MovingCamera();
    }

    /** Ends the threads. */
    @TearDown
    public void end() {
        helpers.shutdown();
    }

    /** All markers of the frame. */
    @Benchmark
    public Detections detection() {
        return detector.detect(image, "frame");
    }

    /** Perspective-n-point over all references, and of each alone. */
    @Benchmark
    public RigidTransform initialPose() {
        return InitialPose.PNP.estimate(view, CAMERA);
    }

    /** Mode of the camera pose, placement errors integrated out, from the initial estimate. */
    @Benchmark
    public List<PoseMode> modeFromInitialPose() {
        return unfitted.finder(view).modes(initial);
    }

    /** The same from where the camera was some millimetres ago. */
    @Benchmark
    public List<PoseMode> modeFromLastFrame() {
        return unfitted.finder(view).modes(lastFrame, finder);
    }

    /** Both modes of each of three objects. */
    @Benchmark
    public List<List<PoseMode>> objectModes() {
        List<List<PoseMode>> all = new ArrayList<>();
        cell.objects().forEach(o -> all.add(
                finder.modes(detections.find(o.id()).cornersPx(), o.sizeMm(), CAMERA, PIXEL_STD)));
        return all;
    }

    /** Laplace covariances of camera and objects, with the budget of each. */
    @Benchmark
    public List<Object> laplace() {
        LinearModel linear = new LinearModel(camera);
        List<Object> out = new ArrayList<>();
        out.add(linear.cameraPose());
        for (ObjectFit object : objects) {
            LinearModel.ObjectLink link = linear.new ObjectLink(object, 0);
            out.add(link.poseEstimate());
            out.add(link.budget(new double[3], new RigidMarkerNoise(view, PIXEL_STD)));
            if (object.marker.hasGrip()) {
                out.add(link.grip());
                out.add(link.budget(object.marker.gripMm(), new RigidMarkerNoise(view, PIXEL_STD)));
            }
        }
        return out;
    }

    /** The ellipses of three objects and a gripping point. */
    @Benchmark
    public List<Ellipse> ellipses() {
        CellEstimate estimate = quickLook.update().estimate();
        List<Ellipse> out = new ArrayList<>();
        for (ObjectEstimate object : estimate.objects()) {
            out.add(ImageEllipses.of(CAMERA, estimate.camera(), object.pose().meanTransform().translationMm(),
                    object.pose().positionCovarianceMm2()));
            if (object.grip() != null) {
                out.add(ImageEllipses.of(CAMERA, estimate.camera(), object.grip().meanMm(),
                        object.grip().covarianceMm2()));
            }
        }
        return out;
    }

    /** Everything from corners to figures, from the initial estimate. */
    @Benchmark
    public QuickLook quickLook() {
        return CellCheck.quickLook(cell, detections, settings, null);
    }

    /** Everything from corners to figures, from the last mode, one look after another as a live check has them. */
    @Benchmark
    public QuickLook quickLookFromLastFrame() {
        return looks.of(detections, lastFrame);
    }

    /** The overlay with banner and legend. */
    @Benchmark
    public Overlay overlay() {
        return CellOverlay.of(cell, detections, quickLook.update());
    }

    /** The overlay for a tablet held upright, without panels. */
    @Benchmark
    public Overlay overlayOfTurnedDisplay() {
        return CellOverlay.of(cell, detections, quickLook.update(), PORTRAIT);
    }

    /** All markers of the frame, which is one of many. */
    @Benchmark
    public Detections detectionOfFrame() {
        return frames.detect(image, "frame");
    }

    /** A frame of a moving camera: markers, figures from the last mode, overlay. */
    @Benchmark
    public Overlay wholeFrame() {
        return lookedAt(detectionOfFrame());
    }

    /** The same, its markers fitted on all processors. */
    @Benchmark
    public Overlay wholeFrameSpread() {
        return lookedAt(spreadFrames.detect(image, "frame"));
    }

    private Overlay lookedAt(Detections seen) {
        CheckUpdate update = looks.of(seen, lastFrame).update();
        return CellOverlay.of(cell, seen, update, PORTRAIT);
    }

    /**
     * A second of a moving camera: markers of 30 frames of 1080p, looks when they are due, and the overlay of each
     * state.
     */
    @Benchmark
    public int secondOfMovingCamera() {
        moving.move(FRAMES_OF_A_SECOND);
        return moving.drawn();
    }
}
