package org.cellgauge.check;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import org.apache.commons.math3.random.RandomGenerator;
import org.cellgauge.cell.Cell;
import org.cellgauge.cell.MarkerFamily;
import org.cellgauge.cell.ObjectMarker;
import org.cellgauge.cell.Placement;
import org.cellgauge.cell.Reference;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.internal.geometry.MarkerGeometry;
import org.cellgauge.vision.Detections;
import org.cellgauge.vision.MarkerObservation;

/** The scene of the thesis as projected corners: f = 581 px, camera at (418, 106, 1070), 47 mm markers. */
public final class ThesisScene {
    public static final double SIZE_MM = 47;
    public static final RigidTransform WORLD_FROM_CAMERA = RigidTransform.ofEuler(418, 106, 1070, 3.08, 0.10, 0.02);
    public static final PinholeCamera CAMERA = PinholeCamera.ideal(1280, 720, 581, 581, 640, 360);

    private final Map<Integer, RigidTransform> references = new LinkedHashMap<>();
    private final Map<Integer, RigidTransform> objects = new LinkedHashMap<>();
    private final Map<Integer, double[]> grips = new LinkedHashMap<>();
    private Placement placement = new Placement(5, 5, 5, 0.01);
    private final Map<Integer, Placement> placements = new LinkedHashMap<>();
    private final Map<Integer, double[]> shifts = new LinkedHashMap<>();
    private double pixelStdPx = 0.3;
    private OptionalDouble target = OptionalDouble.empty();
    private PinholeCamera camera = CAMERA;
    private RigidTransform worldFromCamera = WORLD_FROM_CAMERA;

    /** References in the plane: 1234, 911, 944, 22, then the fifth and sixth; beyond these, six more between them. */
    public static ThesisScene inPlane(int count) {
        double[][] places = {{1234, 0, 380, 0}, {911, 492, 0, 0}, {944, 492, 380, 0}, {22, 0, 0, 0}, {7, 246, 380, 0},
            {8, 246, 0, 0}, {9, 0, 190, 0}, {10, 492, 190, 0}, {11, 123, 380, 0}, {12, 369, 0, 0}, {13, 369, 380, 0},
            {14, 123, 0, 0}};
        return of(places, count);
    }

    /** The other pair of a reference in the plane and the raised one: 944 in place of 1234. */
    public static ThesisScene otherRaisedPair() {
        return of(new double[][] {{944, 492, 380, 0}, {22, 0, -36, 165}}, 2);
    }

    public static ThesisScene oneRaised(int count) {
        double[][] two = {{1234, 0, 380, 0}, {22, 0, -36, 165}};
        double[][] three = {{1234, 0, 380, 0}, {911, 492, 0, 0}, {22, 0, -36, 165}};
        double[][] more = {{944, 492, 380, 0}, {1234, 0, 380, 0}, {911, 492, 0, 0}, {22, 0, -36, 165},
            {7, 246, 380, 0}, {8, 246, 0, 0}};
        return of(count == 2 ? two : count == 3 ? three : more, count);
    }

    private static ThesisScene of(double[][] places, int count) {
        ThesisScene scene = new ThesisScene();
        for (int i = 0; i < count; i++) {
            scene.references.put((int) places[i][0],
                    RigidTransform.ofEuler(places[i][1], places[i][2], places[i][3], 0, 0, 0));
        }
        return scene.planeObjects();
    }

    public ThesisScene planeObjects() {
        objects.clear();
        objects.put(5, RigidTransform.ofEuler(370, 295, 0, 0, 0, 0.95));
        objects.put(20, RigidTransform.ofEuler(240, -44, 0, 0, 0, 2.29));
        objects.put(30, RigidTransform.ofEuler(0, 232, 0, 0, 0, 3.1));
        return this;
    }

    public ThesisScene object(int id, RigidTransform worldFromObject) {
        objects.put(id, worldFromObject);
        return this;
    }

    public ThesisScene noObjects() {
        objects.clear();
        return this;
    }

    public ThesisScene grip(int id, double x, double y, double z) {
        grips.put(id, new double[] {x, y, z});
        return this;
    }

    public ThesisScene placement(double stdMm, double stdRad) {
        placement = new Placement(stdMm, stdMm, stdMm, stdRad);
        return this;
    }

    /** Precision of one reference alone, stated; its drawn errors are those of all. */
    public ThesisScene placementOf(int id, double stdMm, double stdRad) {
        placements.put(id, new Placement(stdMm, stdMm, stdMm, stdRad));
        return this;
    }

    public ThesisScene pixelStd(double px) {
        pixelStdPx = px;
        return this;
    }

    public ThesisScene target(double stdMm) {
        target = OptionalDouble.of(stdMm);
        return this;
    }

    public ThesisScene camera(PinholeCamera other) {
        camera = other;
        return this;
    }

    public ThesisScene cameraAt(RigidTransform other) {
        worldFromCamera = other;
        return this;
    }

    /** Puts a reference off its nominal place along one world axis, in the place of its random error there. */
    public ThesisScene shifted(int id, int axis, double mm) {
        double[] shift = {Double.NaN, Double.NaN, Double.NaN};
        shift[axis] = mm;
        shifts.put(id, shift);
        return this;
    }

    /**
     * Puts a reference off its nominal place by (x, y, z), in the place of its random errors; NaN keeps an axis random.
     */
    public ThesisScene shifted(int id, double x, double y, double z) {
        shifts.put(id, new double[] {x, y, z});
        return this;
    }

    /** Turns a reference about its centre, in world axes. */
    public ThesisScene turned(int id, RigidTransform turn) {
        RigidTransform nominal = references.get(id);
        references.put(id, RigidTransform.of(turn.compose(nominal).rotation(), nominal.translationMm()));
        return this;
    }

    public Map<Integer, RigidTransform> objects() {
        return objects;
    }

    public RigidTransform worldFromCamera() {
        return worldFromCamera;
    }

    public Cell cell() {
        List<Reference> refs = new ArrayList<>();
        references.forEach((id, pose) -> refs.add(new Reference(id, SIZE_MM, pose,
                placements.getOrDefault(id, placement))));
        List<ObjectMarker> objs = new ArrayList<>();
        objects.keySet().forEach(id -> objs.add(new ObjectMarker(id, SIZE_MM, grips.get(id))));
        return new Cell(camera, MarkerFamily.SQUARE_BINARY, refs, objs, OptionalDouble.of(pixelStdPx), target);
    }

    /** Corners as the true poses project them. */
    public Detections exactDetections() {
        return detections(0, null, 0, 0);
    }

    /**
     * Corners with noise, references moved by placement errors of the stated size.
     *
     * @param noisePx standard deviation of each coordinate
     * @param random source of randomness; null for neither noise nor errors
     * @param stdMm placement error
     * @param stdRad placement error
     */
    public Detections detections(double noisePx, RandomGenerator random, double stdMm, double stdRad) {
        List<MarkerObservation> markers = new ArrayList<>();
        references.forEach((id, nominal) -> {
            RigidTransform pose = nominal;
            if (random != null) {
                double[] w = {stdRad * random.nextGaussian(), stdRad * random.nextGaussian(),
                    stdRad * random.nextGaussian()};
                double[] t = nominal.translationMm();
                RigidTransform turn = RigidTransform.ofRotationVector(w, new double[3]);
                double[] shift = shifts.get(id);
                for (int i = 0; i < 3; i++) {
                    double error = stdMm * random.nextGaussian();
                    t[i] += shift == null || Double.isNaN(shift[i]) ? error : shift[i];
                }
                pose = RigidTransform.of(turn.compose(nominal).rotation(), t);
            }
            markers.add(observe(id, pose, noisePx, random));
        });
        objects.forEach((id, pose) -> markers.add(observe(id, pose, noisePx, random)));
        return new Detections("scene", camera.widthPx(), camera.heightPx(), markers);
    }

    /** Corners with the errors of a single source of the variance, as the budget names it. */
    public Detections detectionsOf(String source, double noisePx, double stdMm, double stdRad, RandomGenerator random) {
        List<MarkerObservation> markers = new ArrayList<>();
        references.forEach((id, nominal) -> {
            RigidTransform pose = nominal;
            if (source.equals("placement of reference " + id)) {
                double[] w = {stdRad * random.nextGaussian(), stdRad * random.nextGaussian(),
                    stdRad * random.nextGaussian()};
                double[] t = nominal.translationMm();
                for (int i = 0; i < 3; i++) {
                    t[i] += stdMm * random.nextGaussian();
                }
                RigidTransform turn = RigidTransform.ofRotationVector(w, new double[3]);
                pose = RigidTransform.of(turn.compose(nominal).rotation(), t);
            }
            boolean noisy = source.equals("corner noise of references");
            markers.add(observe(id, pose, noisePx, noisy ? random : null));
        });
        boolean noisy = source.equals("corner noise of object");
        objects.forEach((id, pose) -> markers.add(observe(id, pose, noisePx, noisy ? random : null)));
        return new Detections("scene", camera.widthPx(), camera.heightPx(), markers);
    }

    private MarkerObservation observe(int id, RigidTransform worldFromMarker, double noisePx, RandomGenerator random) {
        double[] corners = MarkerGeometry.cornersMm(worldFromCamera.inverse().compose(worldFromMarker), SIZE_MM);
        double[] px = new double[8];
        for (int k = 0; k < 4; k++) {
            double[] uv = camera.project(corners[3 * k], corners[3 * k + 1], corners[3 * k + 2]);
            for (int i = 0; i < 2; i++) {
                px[2 * k + i] = uv[i] + (random == null ? 0 : noisePx * random.nextGaussian());
            }
        }
        return new MarkerObservation(id, px);
    }
}
