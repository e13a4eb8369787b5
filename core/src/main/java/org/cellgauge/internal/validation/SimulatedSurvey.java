package org.cellgauge.internal.validation;

import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.apache.commons.math3.random.RandomGenerator;
import org.cellgauge.cell.Cell;
import org.cellgauge.cell.InputRefusedException;
import org.cellgauge.cell.ObjectMarker;
import org.cellgauge.cell.PlacementGroup;
import org.cellgauge.cell.Reference;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.internal.geometry.MarkerGeometry;
import org.cellgauge.internal.pose.IntrinsicsPrior;
import org.cellgauge.internal.sampling.RandomStreams;
import org.cellgauge.settings.CheckSettings;
import org.cellgauge.vision.Detections;
import org.cellgauge.vision.MarkerObservation;
import org.jspecify.annotations.Nullable;

/**
 * Photos of one cell from all around it, as a walk with a tablet gives them: the cell was built once, as precisely as
 * its file states, and every photo has its own camera pose and corner noise. Immutable.
 *
 * <p>Cameras stand on rings about the centroid of the references, a golden angle apart, tilted by 10 to 45 degrees off
 * the references' common normal, as far away as lets the references fill most of the image; they look at the centroid
 * but for a few degrees. A marker that does not lie within the image in full, or is seen at less than 20 degrees, is
 * not seen.
 */
public final class SimulatedSurvey {
    private static final long STREAM = 21;
    private static final long STREAM_AGAIN = 23;
    private static final long STREAM_PHOTO = 24;
    private static final double GOLDEN_RAD = Math.PI * (3 - Math.sqrt(5));
    private static final double LEAST_TILT_RAD = Math.toRadians(10);
    private static final double TILT_RANGE_RAD = Math.toRadians(35);
    private static final double AIM_STD_RAD = Math.toRadians(2);
    private static final double FILL = 1.35;
    private static final double GRAZING_COSINE = Math.sin(Math.toRadians(20));
    private static final int ATTEMPTS = 100;
    private static final int LATER_POSES = 1000;

    private final Cell cell;
    private final Map<Integer, RigidTransform> references;
    private final Map<Integer, RigidTransform> objects;
    private final PinholeCamera camera;
    private final List<RigidTransform> cameras;
    private final List<Detections> photos;

    private SimulatedSurvey(Cell cell, Map<Integer, RigidTransform> references, Map<Integer, RigidTransform> objects,
            PinholeCamera camera, List<RigidTransform> cameras, List<Detections> photos) {
        this.cell = cell;
        this.references = references;
        this.objects = objects;
        this.camera = camera;
        this.cameras = Collections.unmodifiableList(cameras);
        this.photos = Collections.unmodifiableList(photos);
    }

    /**
     * Builds a cell and takes photos of it.
     *
     * @param cell the cell; its corner noise, where it states none, is 0.3 px
     * @param settings what is unknown of the lens, of which the true lens is a draw
     * @param count number of photos, at least 1
     * @param seed seed of all that is drawn
     * @param index which cell of that seed
     * @return the cell and its photos
     */
    public static SimulatedSurvey of(Cell cell, CheckSettings settings, int count, long seed, int index) {
        RandomGenerator random = RandomStreams.of(seed, STREAM, index);
        Map<Integer, RigidTransform> references = placed(cell, random);
        Map<Integer, RigidTransform> objects = CellTruth.objectPoses(cell, Collections.emptyMap());
        IntrinsicsPrior prior = IntrinsicsPrior.stated(cell, settings.model());
        double[] lens = cell.camera().intrinsics();
        double[] white = new double[prior.count()];
        for (int i = 0; i < white.length; i++) {
            white[i] = random.nextGaussian();
        }
        prior.setWhitened(white, lens);
        PinholeCamera camera = cell.camera().withIntrinsics(lens);
        List<RigidTransform> cameras = new ArrayList<>();
        List<Detections> photos = new ArrayList<>();
        for (int k = 0; k < count; k++) {
            for (int attempt = 0; attempt < ATTEMPTS; attempt++) {
                RigidTransform pose = pose(cell, k, count, random);
                Detections seen = photo(cell, "photo-" + (k + 1), references, objects, camera, pose, random);
                if (seen != null) {
                    cameras.add(pose);
                    photos.add(seen);
                    break;
                }
            }
        }
        return new SimulatedSurvey(cell, references, objects, camera, cameras, photos);
    }

    private static Map<Integer, RigidTransform> placed(Cell cell, RandomGenerator random) {
        Map<Integer, RigidTransform> poses = new LinkedHashMap<>();
        for (Reference r : cell.references()) {
            poses.put(r.id(), r.worldFromMarker());
        }
        for (PlacementGroup group : cell.joint().groups()) {
            double[] centre = new double[3];
            for (int id : group.members()) {
                for (int i = 0; i < 3; i++) {
                    centre[i] += pose(poses, id).translationMm()[i] / group.members().size();
                }
            }
            double[] shift = new double[3];
            double[] turn = new double[3];
            for (int i = 0; i < 3; i++) {
                shift[i] = group.placement().stdMm(i) * random.nextGaussian();
                turn[i] = group.placement().stdRad() * random.nextGaussian();
            }
            RigidTransform about = RigidTransform.ofRotationVector(turn, centre)
                    .compose(RigidTransform.ofRotationVector(new double[3], centre).inverse());
            for (int id : group.members()) {
                poses.put(id, about.compose(pose(poses, id)).displaced(shift, new double[3]));
            }
        }
        for (Reference r : cell.references()) {
            poses.put(r.id(), new Reference(r.id(), r.sizeMm(), pose(poses, r.id()), r.placement()).drawn(random));
        }
        return Collections.unmodifiableMap(poses);
    }

    private static RigidTransform pose(Map<Integer, RigidTransform> poses, int id) {
        RigidTransform pose = poses.get(id);
        if (pose == null) {
            throw new IllegalArgumentException("no pose of marker " + id);
        }
        return pose;
    }

    /** A camera on one of the rings. */
    private static RigidTransform pose(Cell cell, int k, int count, RandomGenerator random) {
        double[] centre = new double[3];
        double[] normal = new double[3];
        int n = cell.references().size();
        for (Reference r : cell.references()) {
            for (int i = 0; i < 3; i++) {
                centre[i] += r.worldFromMarker().translationMm()[i] / n;
                normal[i] += r.worldFromMarker().rotation()[3 * i + 2];
            }
        }
        double radius = 0;
        for (Reference r : cell.references()) {
            double[] t = r.worldFromMarker().translationMm();
            radius = Math.max(radius, r.sizeMm() + Math.sqrt((t[0] - centre[0]) * (t[0] - centre[0])
                    + (t[1] - centre[1]) * (t[1] - centre[1]) + (t[2] - centre[2]) * (t[2] - centre[2])));
        }
        double focal = cell.camera().get(PinholeCamera.FX);
        double half = 0.5 * Math.min(cell.camera().widthPx(), cell.camera().heightPx());
        double distance = FILL * radius * focal / half * (0.85 + 0.3 * random.nextDouble());
        double tilt = LEAST_TILT_RAD + TILT_RANGE_RAD * ((k * 0.618 + random.nextDouble() / count) % 1);
        double turn = GOLDEN_RAD * k + 0.3 * random.nextGaussian();
        double[] up = unit(normal);
        double[] side = unit(cross(up, Math.abs(up[0]) < 0.9 ? new double[] {1, 0, 0} : new double[] {0, 1, 0}));
        double[] other = cross(up, side);
        double[] from = new double[3];
        for (int i = 0; i < 3; i++) {
            from[i] = Math.cos(tilt) * up[i] + Math.sin(tilt) * (Math.cos(turn) * side[i] + Math.sin(turn) * other[i]);
        }
        double[] forward = {-from[0], -from[1], -from[2]};
        double roll = 2 * Math.PI * random.nextDouble();
        double[] right = unit(cross(forward, Math.abs(forward[0]) < 0.9 ? new double[] {1, 0, 0}
                : new double[] {0, 1, 0}));
        double[] down = cross(forward, right);
        double[] rotation = new double[9];
        for (int i = 0; i < 3; i++) {
            double x = Math.cos(roll) * right[i] + Math.sin(roll) * down[i];
            double y = -Math.sin(roll) * right[i] + Math.cos(roll) * down[i];
            rotation[3 * i] = x;
            rotation[3 * i + 1] = y;
            rotation[3 * i + 2] = forward[i];
        }
        double[] place = new double[3];
        for (int i = 0; i < 3; i++) {
            place[i] = centre[i] + distance * from[i];
        }
        double[] off = {AIM_STD_RAD * random.nextGaussian(), AIM_STD_RAD * random.nextGaussian(),
            AIM_STD_RAD * random.nextGaussian()};
        return RigidTransform.of(rotation, place).displaced(new double[3], off);
    }

    private static double[] cross(double[] a, double[] b) {
        return new double[] {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
    }

    private static double[] unit(double[] a) {
        double length = Math.sqrt(a[0] * a[0] + a[1] * a[1] + a[2] * a[2]);
        return new double[] {a[0] / length, a[1] / length, a[2] / length};
    }

    private static @Nullable Detections photo(Cell cell, String name, Map<Integer, RigidTransform> references,
            Map<Integer, RigidTransform> objects, PinholeCamera camera, RigidTransform worldFromCamera,
            RandomGenerator random) {
        double std = cell.pixelStdPx().orElse(0.3);
        RigidTransform cameraFromWorld = worldFromCamera.inverse();
        List<MarkerObservation> seen = new ArrayList<>();
        int ofReferences = 0;
        for (Reference r : cell.references()) {
            double[] px = corners(camera, cameraFromWorld.compose(pose(references, r.id())), r.sizeMm());
            if (px != null) {
                seen.add(observed(r.id(), px, std, random));
                ofReferences++;
            }
        }
        for (ObjectMarker o : cell.objects()) {
            double[] px = corners(camera, cameraFromWorld.compose(pose(objects, o.id())), o.sizeMm());
            if (px != null) {
                seen.add(observed(o.id(), px, std, random));
            }
        }
        return ofReferences < Math.min(2, cell.references().size()) ? null
                : new Detections(name, camera.widthPx(), camera.heightPx(), seen);
    }

    private static MarkerObservation observed(int id, double[] px, double std, RandomGenerator random) {
        double[] noisy = px.clone();
        for (int i = 0; i < noisy.length; i++) {
            noisy[i] += std * random.nextGaussian();
        }
        return new MarkerObservation(id, noisy);
    }

    private static double @Nullable [] corners(PinholeCamera camera, RigidTransform cameraFromMarker, double sizeMm) {
        double[] t = cameraFromMarker.translationMm();
        double[] r = cameraFromMarker.rotation();
        double length = Math.sqrt(t[0] * t[0] + t[1] * t[1] + t[2] * t[2]);
        double cosine = -(t[0] * r[2] + t[1] * r[5] + t[2] * r[8]) / length;
        double[] px = cosine < GRAZING_COSINE ? null : MarkerGeometry.cornersPx(camera, cameraFromMarker, sizeMm);
        for (int i = 0; px != null && i < px.length; i += 2) {
            if (px[i] < 2 || px[i] > camera.widthPx() - 2 || px[i + 1] < 2 || px[i + 1] > camera.heightPx() - 2) {
                return null;
            }
        }
        return px;
    }

    /**
     * The same cell from the same places, as a source sees it: what it makes of photos in place of drawn corners.
     *
     * @param source makes photos and finds markers in them, say; photos that it refuses are left out
     * @param seed seed of all noise
     * @param index which cell of that seed
     * @return the cell and these photos
     */
    public SimulatedSurvey seenBy(DetectionSource source, long seed, int index) {
        List<RigidTransform> seenFrom = new ArrayList<>();
        List<Detections> seen = new ArrayList<>();
        for (int k = 0; k < cameras.size(); k++) {
            RandomGenerator random = RandomStreams.of(RandomStreams.of(seed, STREAM_PHOTO, index).nextLong(), k);
            try {
                seen.add(seen(source, cameras.get(k), photos.get(k).imageName(), random));
                seenFrom.add(cameras.get(k));
            } catch (InputRefusedException e) {
                // as one bad photo of a walk: the others are a survey without it
            }
        }
        return new SimulatedSurvey(cell, references, objects, camera, seenFrom, seen);
    }

    private Detections seen(DetectionSource source, RigidTransform worldFromCamera, String name,
            RandomGenerator random) {
        Detections found = source.detect(new SimulatedCell(cell, new CellTruth(worldFromCamera, objects, camera),
                references), random);
        return new Detections(name, found.widthPx(), found.heightPx(), found.markers(), found.warnings(),
                found.light());
    }

    /**
     * A further photo of the same cell, as a source sees it.
     *
     * @param source makes the photo and finds its markers, say
     * @param random where its pose and noise come from
     * @return what it shows
     * @throws InputRefusedException if the source sees nothing
     */
    public Detections later(DetectionSource source, RandomGenerator random) {
        return seen(source, pose(cell, random.nextInt(LATER_POSES), 1, random), "later", random);
    }

    /**
     * A further photo of the same cell.
     *
     * @param random where its pose and noise come from
     * @return what it shows
     */
    public Detections later(RandomGenerator random) {
        for (int attempt = 0; attempt < ATTEMPTS; attempt++) {
            Detections seen = photo(cell, "later", references, objects, camera,
                    pose(cell, random.nextInt(LATER_POSES), 1, random), random);
            if (seen != null) {
                return seen;
            }
        }
        throw new IllegalStateException("no camera sees the cell");
    }

    /**
     * More photos of the same cell at another time.
     *
     * @param count number of photos, at least 1
     * @param seed seed of cameras and noise
     * @param cameraStands whether the camera is where it took the last photo; else it goes round again
     * @param shiftsMm by how much markers have moved since, along world axes, by id; those that are missing stand
     * @param cameraShiftMm by how much a camera that stands has moved
     * @return the cell and these photos
     */
    public SimulatedSurvey again(int count, long seed, boolean cameraStands, Map<Integer, double[]> shiftsMm,
            double[] cameraShiftMm) {
        RandomGenerator random = RandomStreams.of(seed, STREAM_AGAIN);
        Map<Integer, RigidTransform> nowReferences = moved(references, shiftsMm);
        Map<Integer, RigidTransform> nowObjects = moved(objects, shiftsMm);
        List<RigidTransform> nowCameras = new ArrayList<>();
        List<Detections> nowPhotos = new ArrayList<>();
        for (int k = 0; k < count; k++) {
            for (int attempt = 0; attempt < ATTEMPTS; attempt++) {
                RigidTransform pose = cameraStands
                        ? cameras.get(cameras.size() - 1).displaced(cameraShiftMm, new double[3])
                        : pose(cell, k, count, random);
                Detections seen = photo(cell, "later-" + (k + 1), nowReferences, nowObjects, camera, pose, random);
                if (seen != null) {
                    nowCameras.add(pose);
                    nowPhotos.add(seen);
                    break;
                }
            }
        }
        return new SimulatedSurvey(cell, nowReferences, nowObjects, camera, nowCameras, nowPhotos);
    }

    private static Map<Integer, RigidTransform> moved(Map<Integer, RigidTransform> poses,
            Map<Integer, double[]> shiftsMm) {
        Map<Integer, RigidTransform> out = new LinkedHashMap<>(poses);
        shiftsMm.forEach((id, shift) -> out.computeIfPresent(id, (i, pose) -> pose.displaced(shift, new double[3])));
        return Collections.unmodifiableMap(out);
    }

    /**
     * The cell as it is stated.
     *
     * @return as given
     */
    public Cell cell() {
        return cell;
    }

    /**
     * Where references stand.
     *
     * @return true poses in the world by id, unmodifiable
     */
    public Map<Integer, RigidTransform> references() {
        return references;
    }

    /**
     * Where objects stand.
     *
     * @return true poses in the world by id
     */
    public Map<Integer, RigidTransform> objects() {
        return objects;
    }

    /**
     * Where cameras stood.
     *
     * @return true poses in the world, by photo
     */
    public List<RigidTransform> cameras() {
        return cameras;
    }

    /**
     * The photos.
     *
     * @return what they show, in the order of {@link #cameras}
     */
    public List<Detections> photos() {
        return photos;
    }
}
