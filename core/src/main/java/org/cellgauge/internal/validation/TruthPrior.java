package org.cellgauge.internal.validation;

import java.util.LinkedHashMap;
import java.util.Locale;
import java.util.Map;
import java.util.Objects;
import org.apache.commons.math3.random.RandomGenerator;
import org.cellgauge.cell.Cell;
import org.cellgauge.cell.InputRefusedException;
import org.cellgauge.cell.ObjectMarker;
import org.cellgauge.cell.Reference;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.internal.geometry.MarkerGeometry;
import org.cellgauge.internal.geometry.Rotations;
import org.cellgauge.internal.pose.IntrinsicsPrior;
import org.cellgauge.warning.Refusal;

/**
 * Where true poses come from: a proper prior about nominal poses, independent for the camera and for each object before
 * the camera; immutable.
 *
 * <p>A pose is moved by {@code dp ~ N(0, stdMm^2 I)} and turned by {@code exp(w)}, {@code w ~ N(0, stdRad^2 I)}: for
 * the camera p is the place of the references' centroid in the camera frame and R its rotation from the world, so that
 * it swings about the scene and keeps looking at it; for an object p is its place in the camera frame, so that it moves
 * with the camera. Both are truncated to poses from which the markers concerned (references where the cell file has
 * them; the object) are seen from the front with all corners in the image. Deviations of 0 make it a single point: the
 * nominal poses.
 *
 * <p>Where a check is to find intrinsics too, true ones are drawn from its prior of them, before the pose; where
 * references are out of sight with both, both are drawn anew.
 */
public final class TruthPrior {
    private static final int ATTEMPTS = 10_000;

    private final Cell cell;
    private final double stdMm;
    private final double stdRad;
    private final double[] centroid = new double[3];
    private final IntrinsicsPrior intrinsicsPrior;
    private final RigidTransform cameraFromWorld;
    private final double[] centroidInCamera;
    private final Map<Integer, RigidTransform> cameraFromObjects = new LinkedHashMap<>();

    /**
     * A prior.
     *
     * @param cell the cell
     * @param nominal mean poses; of every object of the cell
     * @param stdMm standard deviation of each component of a place, mm, not negative and at most the distance from the
     *     nominal camera to the centroid of the references: with more, one truth in six would have them behind the
     *     camera, and what truncation leaves would be another cell than the nominal one
     * @param stdRad standard deviation of each component of a rotation vector, rad, not negative and below 1
     * @throws IllegalArgumentException if a deviation is out of range or only one of them is 0, or an object has no
     *     pose
     * @throws InputRefusedException if a marker is not in the image at the nominal poses
     */
    public TruthPrior(Cell cell, CellTruth nominal, double stdMm, double stdRad) {
        this(cell, nominal, stdMm, stdRad, IntrinsicsPrior.KNOWN);
    }

    /**
     * A prior with unknown intrinsics.
     *
     * @param cell the cell
     * @param nominal mean poses; of every object of the cell
     * @param stdMm as above
     * @param stdRad as above
     * @param intrinsicsPrior where true intrinsics are drawn from: what the check takes for known of them
     * @throws IllegalArgumentException if a deviation is out of range or only one of them is 0, or an object has no
     *     pose
     * @throws InputRefusedException if a marker is not in the image at the nominal poses
     */
    public TruthPrior(Cell cell, CellTruth nominal, double stdMm, double stdRad, IntrinsicsPrior intrinsicsPrior) {
        if (!(stdMm >= 0 && stdRad >= 0 && stdRad < 1 && Double.isFinite(stdMm)) || (stdMm == 0) != (stdRad == 0)) {
            throw new IllegalArgumentException("the spread takes two positive values (rotations below 57 degrees), "
                    + "or 0 twice");
        }
        if (intrinsicsPrior.isFlat()) {
            throw new InputRefusedException(Refusal.of(ValidationRefusal.FLAT_PRIOR));
        }
        this.cell = cell;
        this.stdMm = stdMm;
        this.stdRad = stdRad;
        this.intrinsicsPrior = intrinsicsPrior;
        for (Reference r : cell.references()) {
            for (int i = 0; i < 3; i++) {
                centroid[i] += r.worldFromMarker().translationMm()[i] / cell.references().size();
            }
        }
        cameraFromWorld = nominal.worldFromCamera().inverse();
        centroidInCamera = cameraFromWorld.apply(centroid);
        double distanceMm = Math.sqrt(centroidInCamera[0] * centroidInCamera[0]
                + centroidInCamera[1] * centroidInCamera[1] + centroidInCamera[2] * centroidInCamera[2]);
        if (stdMm > distanceMm) {
            throw new IllegalArgumentException(String.format(Locale.ROOT, "the spread takes at most the distance from "
                    + "camera to references, %.0f mm here, not %s mm: with more the camera hardly ever sees this cell",
                    distanceMm, stdMm));
        }
        for (Reference r : cell.references()) {
            requireSeen(Refusal.of(ValidationRefusal.REFERENCE, r.id()),
                    cameraFromWorld.compose(r.worldFromMarker()), r.sizeMm());
        }
        for (ObjectMarker o : cell.objects()) {
            RigidTransform pose = nominal.worldFromObjects().get(o.id());
            if (pose == null) {
                throw new IllegalArgumentException("object " + o.id() + " has no pose");
            }
            cameraFromObjects.put(o.id(), cameraFromWorld.compose(pose));
            requireSeen(Refusal.of(ValidationRefusal.OBJECT, o.id()), cameraFromObjects.get(o.id()), o.sizeMm());
        }
    }

    private void requireSeen(Refusal name, RigidTransform cameraFromMarker, double sizeMm) {
        if (!seen(cell.camera(), cameraFromMarker, sizeMm)) {
            throw new InputRefusedException(
                    Refusal.of(ValidationRefusal.NOT_SEEN, name, ValidationRefusal.OTHER_POSES));
        }
    }

    /**
     * Whether all truths are the nominal one.
     *
     * @return true if the prior has no width
     */
    public boolean isPoint() {
        return stdMm == 0;
    }

    /**
     * Draws a truth.
     *
     * @param random source of randomness
     * @return poses of camera and objects
     * @throws InputRefusedException if nearly all poses that the deviations suggest lose a marker from sight
     */
    public CellTruth draw(RandomGenerator random) {
        RigidTransform camera = cameraFromWorld;
        PinholeCamera lens = lens(random);
        if (!isPoint()) {
            camera = suggested(random);
            for (int i = 0; !referencesSeen(lens, camera); i++) {
                refuseIfHopeless(i, Refusal.of(ValidationRefusal.THE_REFERENCES));
                lens = lens(random);
                camera = suggested(random);
            }
        }
        RigidTransform worldFromCamera = camera.inverse();
        Map<Integer, RigidTransform> objects = new LinkedHashMap<>();
        for (ObjectMarker o : cell.objects()) {
            RigidTransform pose = cameraFromObject(o);
            if (!isPoint()) {
                RigidTransform nominal = pose;
                pose = moved(nominal, random);
                for (int i = 0; !seen(lens, pose, o.sizeMm()); i++) {
                    refuseIfHopeless(i, Refusal.of(ValidationRefusal.OBJECT, o.id()));
                    pose = moved(nominal, random);
                }
            }
            objects.put(o.id(), worldFromCamera.compose(pose));
        }
        return new CellTruth(worldFromCamera, objects, lens);
    }

    private RigidTransform suggested(RandomGenerator random) {
        RigidTransform moved = moved(RigidTransform.of(cameraFromWorld.rotation(), centroidInCamera), random);
        double[] g = RigidTransform.of(moved.rotation(), new double[3]).apply(centroid);
        double[] p = moved.translationMm();
        return RigidTransform.of(moved.rotation(), new double[] {p[0] - g[0], p[1] - g[1], p[2] - g[2]});
    }

    private RigidTransform cameraFromObject(ObjectMarker object) {
        return Objects.requireNonNull(cameraFromObjects.get(object.id()), "every object of the cell has a pose");
    }

    private PinholeCamera lens(RandomGenerator random) {
        if (intrinsicsPrior.count() == 0) {
            return cell.camera();
        }
        double[] intrinsics = cell.camera().intrinsics();
        double[] rows = new double[intrinsicsPrior.count()];
        do {
            for (int i = 0; i < rows.length; i++) {
                rows[i] = random.nextGaussian();
            }
            intrinsicsPrior.setWhitened(rows, intrinsics);
        } while (!(intrinsics[PinholeCamera.FX] > 0 && intrinsics[PinholeCamera.FY] > 0));
        return cell.camera().withIntrinsics(intrinsics);
    }

    private static void refuseIfHopeless(int attempt, Refusal what) {
        if (attempt > ATTEMPTS) {
            throw new InputRefusedException(
                    Refusal.of(ValidationRefusal.SPREAD_TOO_WIDE, what, ValidationRefusal.SMALLER_SPREAD));
        }
    }

    private RigidTransform moved(RigidTransform pose, RandomGenerator random) {
        double[] shift = new double[3];
        for (int i = 0; i < 3; i++) {
            shift[i] = stdMm * random.nextGaussian();
        }
        double[] w = new double[3];
        do {
            for (int i = 0; i < 3; i++) {
                w[i] = stdRad * random.nextGaussian();
            }
        } while (w[0] * w[0] + w[1] * w[1] + w[2] * w[2] > Math.PI * Math.PI);
        return pose.displaced(shift, w);
    }

    /**
     * Logarithm of this prior's density of the camera pose by the measure that is flat in position and uniform over
     * rotations, up to a constant: what a flat posterior has to be weighted with to become that under this prior.
     *
     * @param lens intrinsics; their own prior is the check's, and not in here
     * @param worldFromCamera a pose
     * @return the logarithm; 0 for a prior without width
     */
    double logCamera(PinholeCamera lens, RigidTransform worldFromCamera) {
        if (isPoint()) {
            return 0;
        }
        RigidTransform pose = worldFromCamera.inverse();
        return referencesSeen(lens, pose)
                ? log(pose.rotation(), pose.apply(centroid), cameraFromWorld.rotation(), centroidInCamera)
                : Double.NEGATIVE_INFINITY;
    }

    /**
     * The same for an object's pose before the camera.
     *
     * @param lens intrinsics
     * @param object the object
     * @param cameraFromObject its pose in the camera frame
     * @return the logarithm
     */
    double logObject(PinholeCamera lens, ObjectMarker object, RigidTransform cameraFromObject) {
        if (isPoint()) {
            return 0;
        }
        RigidTransform nominal = cameraFromObject(object);
        return seen(lens, cameraFromObject, object.sizeMm())
                ? log(cameraFromObject.rotation(), cameraFromObject.translationMm(), nominal.rotation(),
                        nominal.translationMm())
                : Double.NEGATIVE_INFINITY;
    }

    private double log(double[] rotation, double[] place, double[] nominalRotation, double[] nominalPlace) {
        double[] turned = new double[9];
        double[] w = new double[3];
        Rotations.multiplyTransposed(rotation, nominalRotation, turned);
        Rotations.log(turned, w, 0);
        double sum = 0;
        for (int i = 0; i < 3; i++) {
            double d = (place[i] - nominalPlace[i]) / stdMm;
            double e = w[i] / stdRad;
            sum += d * d + e * e;
        }
        // w is normal by Lebesgue's measure; the posterior's measure is Haar's
        return -0.5 * sum - Rotations.logHaarDensity(w[0], w[1], w[2]);
    }

    private boolean referencesSeen(PinholeCamera lens, RigidTransform pose) {
        for (Reference r : cell.references()) {
            if (!seen(lens, pose.compose(r.worldFromMarker()), r.sizeMm())) {
                return false;
            }
        }
        return true;
    }

    private static boolean seen(PinholeCamera lens, RigidTransform cameraFromMarker, double sizeMm) {
        return MarkerGeometry.seenPx(lens, cameraFromMarker, sizeMm) != null;
    }

    /**
     * Nominal poses.
     *
     * @return mean of the prior
     */
    public CellTruth nominal() {
        Map<Integer, RigidTransform> objects = new LinkedHashMap<>();
        RigidTransform worldFromCamera = cameraFromWorld.inverse();
        for (Map.Entry<Integer, RigidTransform> e : cameraFromObjects.entrySet()) {
            objects.put(e.getKey(), worldFromCamera.compose(e.getValue()));
        }
        return new CellTruth(worldFromCamera, objects);
    }

    /**
     * The cell.
     *
     * @return references, objects and camera
     */
    public Cell cell() {
        return cell;
    }

    /**
     * Where true intrinsics are drawn from.
     *
     * @return the prior; of none where the camera is the cell's
     */
    public IntrinsicsPrior intrinsicsPrior() {
        return intrinsicsPrior;
    }

    /**
     * Standard deviation of places.
     *
     * @return mm
     */
    public double stdMm() {
        return stdMm;
    }

    /**
     * Standard deviation of rotation vectors.
     *
     * @return rad
     */
    public double stdRad() {
        return stdRad;
    }
}
