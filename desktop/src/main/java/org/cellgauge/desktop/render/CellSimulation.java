package org.cellgauge.desktop.render;

import java.util.LinkedHashMap;
import java.util.Map;
import org.apache.commons.math3.random.RandomGenerator;
import org.apache.commons.math3.random.Well19937c;
import org.cellgauge.cell.Cell;
import org.cellgauge.cell.ObjectMarker;
import org.cellgauge.cell.Reference;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.vision.GreyImage;

/**
 * Photos of a cell with a known truth. Photo i of a seed is always the same one, whichever others are taken; what is
 * random about it (placement of the references, camera, noise) is drawn from separate streams, so that changing one
 * leaves the others as they were.
 */
public final class CellSimulation {
    /** Share of the half image that markers may fill in {@link #overview}. */
    private static final double OVERVIEW_FILL = 0.75;
    private static final int PLACEMENT_STREAM = 0;
    private static final int CAMERA_STREAM = 1;
    private static final int NOISE_STREAM = 2;

    private final Cell cell;
    private final RigidTransform worldFromCamera;
    private final Map<Integer, RigidTransform> worldFromObjects;
    private final Settings settings;

    /**
     * How the photos differ from each other and from the cell file.
     *
     * @param seed of everything random
     * @param placementErrors whether references stand off their nominal places by a draw from their stated placement
     * @param jitterMm standard deviation of the camera's position per axis, mm, at least 0
     * @param jitterRad standard deviation of each component of the camera's small rotation about itself, rad, at least
     * 0
     * @param textureContrast as in {@link Backdrop#textured}
     * @param quietZone as in {@link Scene#quietZone}
     * @param printGainMm as in {@link Scene#printGainMm}
     * @param misprints what is wrong with the prints
     */
    public record Settings(long seed, boolean placementErrors, double jitterMm, double jitterRad,
            double textureContrast, double quietZone, double printGainMm, Misprints misprints) {
        /**
         * Prints without a gain.
         *
         * @param seed as above
         * @param placementErrors as above
         * @param jitterMm as above
         * @param jitterRad as above
         * @param textureContrast as above
         * @param quietZone as above
         */
        public Settings(long seed, boolean placementErrors, double jitterMm, double jitterRad,
                double textureContrast, double quietZone) {
            this(seed, placementErrors, jitterMm, jitterRad, textureContrast, quietZone, 0, Misprints.NONE);
        }
    }

    /**
     * One photo and all that is true of it.
     *
     * @param scene what was rendered, with the true poses
     * @param worldFromReferences true poses of the references, by id
     * @param worldFromObjects true poses of the objects, by id
     * @param image the picture
     */
    public record Photo(Scene scene, Map<Integer, RigidTransform> worldFromReferences,
            Map<Integer, RigidTransform> worldFromObjects, GreyImage image) {
    }

    /**
     * A simulation.
     *
     * @param cell the cell
     * @param worldFromCamera mean pose of the camera
     * @param worldFromObjects poses of the objects to be seen, by id; each id must be an object of the cell
     * @param settings how photos differ
     * @throws IllegalArgumentException if an id is not an object of the cell
     */
    public CellSimulation(Cell cell, RigidTransform worldFromCamera, Map<Integer, RigidTransform> worldFromObjects,
            Settings settings) {
        for (int id : worldFromObjects.keySet()) {
            if (cell.objects().stream().noneMatch(o -> o.id() == id)) {
                throw new IllegalArgumentException("marker " + id + " is no object of the cell");
            }
        }
        this.cell = cell;
        this.worldFromCamera = worldFromCamera;
        this.worldFromObjects = new LinkedHashMap<>(worldFromObjects);
        this.settings = settings;
    }

    /**
     * A pose from which all markers are in the image: straight at the wall, image x along world x, above the middle of
     * the markers, from as far away as they need.
     *
     * @param cell references and camera
     * @param worldFromObjects poses of objects
     * @return worldFromCamera
     */
    public static RigidTransform overview(Cell cell, Map<Integer, RigidTransform> worldFromObjects) {
        double[] low = {Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY};
        double[] high = {Double.NEGATIVE_INFINITY, Double.NEGATIVE_INFINITY, Double.NEGATIVE_INFINITY};
        for (Reference r : cell.references()) {
            enclose(low, high, r.worldFromMarker().translationMm(), r.sizeMm());
        }
        for (ObjectMarker o : cell.objects()) {
            if (worldFromObjects.containsKey(o.id())) {
                enclose(low, high, worldFromObjects.get(o.id()).translationMm(), o.sizeMm());
            }
        }
        PinholeCamera camera = cell.camera();
        double cx = camera.get(PinholeCamera.CX);
        double cy = camera.get(PinholeCamera.CY);
        double halfWidth = OVERVIEW_FILL * Math.max(1, Math.min(cx, camera.widthPx() - cx));
        double halfHeight = OVERVIEW_FILL * Math.max(1, Math.min(cy, camera.heightPx() - cy));
        double distance = Math.max((high[0] - low[0]) / 2 * camera.get(PinholeCamera.FX) / halfWidth,
                (high[1] - low[1]) / 2 * camera.get(PinholeCamera.FY) / halfHeight);
        return RigidTransform.ofEuler((low[0] + high[0]) / 2, (low[1] + high[1]) / 2, high[2] + distance, Math.PI, 0,
                0);
    }

    /**
     * A camera that looks at a point.
     *
     * @param fromMm where it stands, in the world, mm
     * @param targetMm what is in the middle of its image, in the world, mm
     * @return worldFromCamera; z of the world points up in the image, or y of the world where the camera looks straight
     *     up or down (within a degree), where z has no direction in the image
     * @throws IllegalArgumentException if the two are one point
     */
    public static RigidTransform lookingAt(double[] fromMm, double[] targetMm) {
        double[] forward = unit(new double[] {targetMm[0] - fromMm[0], targetMm[1] - fromMm[1],
            targetMm[2] - fromMm[2]});
        double[] up = Math.abs(forward[2]) > Math.cos(Math.toRadians(1)) ? new double[] {0, 1, 0}
                : new double[] {0, 0, 1};
        double[] right = unit(cross(forward, up));
        double[] down = cross(forward, right);
        return RigidTransform.of(new double[] {right[0], down[0], forward[0], right[1], down[1], forward[1], right[2],
            down[2], forward[2]}, fromMm);
    }

    private static double[] unit(double[] v) {
        double length = Math.sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
        if (!(length > 0)) {
            throw new IllegalArgumentException("the camera stands in the point itself");
        }
        return new double[] {v[0] / length, v[1] / length, v[2] / length};
    }

    private static double[] cross(double[] a, double[] b) {
        return new double[] {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
    }

    private static void enclose(double[] low, double[] high, double[] centre, double sizeMm) {
        for (int axis = 0; axis < 3; axis++) {
            // a marker turned any way stays within its half diagonal
            double reach = axis == 2 ? 0 : sizeMm * Math.sqrt(0.5);
            low[axis] = Math.min(low[axis], centre[axis] - reach);
            high[axis] = Math.max(high[axis], centre[axis] + reach);
        }
    }

    /**
     * Takes a photo.
     *
     * @param index which of the endless series that the seed starts, from 0 on
     * @param sensor how it is taken
     * @return the photo with its truth
     * @throws IllegalArgumentException if the print gain is half a cell of some marker or more
     */
    public Photo photo(int index, Sensor sensor) {
        Map<Integer, RigidTransform> references = new LinkedHashMap<>();
        RandomGenerator placement = stream(index, PLACEMENT_STREAM);
        RandomGenerator motion = stream(index, CAMERA_STREAM);
        Scene.Builder scene = Scene.of(cell.camera(), jittered(motion))
                .backdrop(settings.textureContrast() > 0
                        ? Backdrop.textured(settings.textureContrast(), settings.seed()) : Backdrop.plain())
                .quietZone(settings.quietZone()).printGainMm(settings.printGainMm());
        for (Reference reference : cell.references()) {
            RigidTransform actual = settings.placementErrors() ? reference.drawn(placement)
                    : reference.worldFromMarker();
            references.put(reference.id(), actual);
        }
        Misprints misprints = settings.misprints();
        Map<Integer, RigidTransform> objects = new LinkedHashMap<>(worldFromObjects);
        misprints.exchange(references, objects);
        for (Reference reference : cell.references()) {
            scene.marker(misprints.print(cell.family(), reference.id(), reference.sizeMm(),
                    references.get(reference.id())));
        }
        for (ObjectMarker object : cell.objects()) {
            if (objects.containsKey(object.id())) {
                scene.marker(misprints.print(cell.family(), object.id(), object.sizeMm(), objects.get(object.id())));
            }
        }
        Scene built = scene.build();
        return new Photo(built, references, objects,
                SceneRenderer.render(built, sensor, stream(index, NOISE_STREAM)));
    }

    private RandomGenerator stream(int index, int which) {
        return new Well19937c(new int[] {(int) (settings.seed() >>> 32), (int) settings.seed(), index, which});
    }

    private RigidTransform jittered(RandomGenerator random) {
        double[] shift = gaussian(random, settings.jitterMm());
        double[] turn = gaussian(random, settings.jitterRad());
        return worldFromCamera.displaced(shift, turn);
    }

    private static double[] gaussian(RandomGenerator random, double std) {
        return new double[] {std * random.nextGaussian(), std * random.nextGaussian(), std * random.nextGaussian()};
    }
}
