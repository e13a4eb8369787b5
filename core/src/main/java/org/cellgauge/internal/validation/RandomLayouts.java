package org.cellgauge.internal.validation;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.Set;
import org.apache.commons.math3.random.RandomGenerator;
import org.cellgauge.cell.Cell;
import org.cellgauge.cell.InputRefusedException;
import org.cellgauge.cell.MarkerFamily;
import org.cellgauge.cell.ObjectMarker;
import org.cellgauge.cell.Placement;
import org.cellgauge.cell.Reference;
import org.cellgauge.geometry.BrownLens;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.internal.geometry.MarkerGeometry;
import org.cellgauge.internal.sampling.RandomStreams;
import org.jspecify.annotations.Nullable;

/**
 * A new layout for every simulation; immutable.
 *
 * <p>Camera: 1280 x 720 px, focal length 400 to 2000 px (uniform in its logarithm), principal point off the middle by
 * 10 px (std), in every other layout a lens that moves the corners of the image by -12 to +6 % of their distance from
 * the middle. It looks at the plane z = 0 of the world from a slant of up to 40 degrees, turned about its axis any way,
 * from where a marker of the layout's usual size is 28 to 80 px wide. Markers: {@value #FEWEST} to {@value #MOST}
 * references and one or two objects, sizes 30 to 120 mm (uniform in the logarithm; in every other layout all are of one
 * size), centres anywhere in view where they do not hide each other, every other one raised over the plane by up to a
 * quarter of the camera's distance, every other one tilted by 20 degrees (std), all turned any way, each side at least
 * {@value #LEAST_SIDE_PX} px long and none seen from more than 60 degrees off its normal. Placement: 0.3 to 10 mm (std)
 * per axis and 0.1 to 3 degrees (std), uniform in the logarithm, the same for all references of a layout. Corner noise:
 * where none is stated for all, 0.05 to 0.5 px, uniform in the logarithm.
 *
 * <p>References stand off their nominal places by a draw from that placement; objects and camera are where they are.
 */
public final class RandomLayouts implements CellSource {
    private static final int FEWEST = 2;
    private static final int MOST = 12;
    private static final double LEAST_SIDE_PX = 24;
    private static final double LARGEST_SIDE_PX = 300;
    private static final int WIDTH_PX = 1280;
    private static final int HEIGHT_PX = 720;
    private static final int ATTEMPTS = 300;
    private static final int LAYOUTS = 1000;
    private static final double LEAST_COSINE = 0.5;
    /** Of a marker's side: half its diagonal, its white paper, and what blur and detection need. */
    private static final double ROOM = 1.1;
    private static final long STREAM_LAYOUT = 121;

    private final MarkerFamily family;
    private final boolean noiseIsUnknown;
    private final OptionalDouble pixelStdPx;

    private RandomLayouts(MarkerFamily family, boolean noiseIsUnknown, OptionalDouble pixelStdPx) {
        this.family = family;
        this.noiseIsUnknown = noiseIsUnknown;
        this.pixelStdPx = pixelStdPx;
    }

    /**
     * Layouts that state a corner noise, which is drawn for each.
     *
     * @param family family of the markers
     * @return the source
     */
    public static RandomLayouts withDrawnNoise(MarkerFamily family) {
        return new RandomLayouts(family, false, OptionalDouble.empty());
    }

    /**
     * Layouts that all state the same of their corner noise.
     *
     * @param family family of the markers
     * @param pixelStdPx standard deviation, px; empty: not known
     * @return the source
     */
    public static RandomLayouts withNoise(MarkerFamily family, OptionalDouble pixelStdPx) {
        return new RandomLayouts(family, pixelStdPx.isEmpty(), pixelStdPx);
    }

    @Override
    public String nameOf(ObjectMarker object) {
        return "objects";
    }

    @Override
    public SimulatedCell cell(long seed, int index) {
        RandomGenerator random = RandomStreams.of(seed, STREAM_LAYOUT, index);
        for (int i = 0; i < LAYOUTS; i++) {
            SimulatedCell cell = layout(random);
            if (cell != null) {
                return cell;
            }
        }
        throw new InputRefusedException("simulated", ValidationRefusal.NO_LAYOUT);
    }

    /** A layout, or null if its markers found no room. */
    private @Nullable SimulatedCell layout(RandomGenerator random) {
        PinholeCamera camera = camera(random);
        double usualMm = logUniform(random, 30, 120);
        boolean oneSize = random.nextBoolean();
        double distanceMm = camera.get(PinholeCamera.FX) * usualMm / logUniform(random, 28, 80);
        RigidTransform worldFromCamera = viewpoint(random, distanceMm);
        int references = FEWEST + random.nextInt(MOST - FEWEST + 1);
        int objects = 1 + random.nextInt(2);
        List<double[]> taken = new ArrayList<>();
        List<RigidTransform> poses = new ArrayList<>();
        List<Double> sizes = new ArrayList<>();
        for (int m = 0; m < references + objects; m++) {
            RigidTransform pose = null;
            double size = 0;
            for (int i = 0; i < ATTEMPTS && pose == null; i++) {
                size = oneSize ? usualMm : logUniform(random, 30, 120);
                pose = marker(random, camera, worldFromCamera, distanceMm, size, taken);
            }
            if (pose == null) {
                return null;
            }
            poses.add(pose);
            sizes.add(size);
        }
        return built(random, camera, worldFromCamera, references, poses, sizes);
    }

    private static PinholeCamera camera(RandomGenerator random) {
        double focal = logUniform(random, 400, 2000);
        double[] values = PinholeCamera.ideal(WIDTH_PX, HEIGHT_PX, focal, focal, WIDTH_PX / 2.0
                + 10 * random.nextGaussian(), HEIGHT_PX / 2.0 + 10 * random.nextGaussian()).intrinsics();
        double bend = -0.12 + 0.18 * random.nextDouble();
        if (random.nextBoolean()) {
            double corner = Math.hypot(WIDTH_PX, HEIGHT_PX) / 2 / focal;
            values[BrownLens.K1] = bend / (corner * corner);
        }
        return PinholeCamera.of(WIDTH_PX, HEIGHT_PX, values);
    }

    /** A camera that looks at the world's origin from a slant. */
    private static RigidTransform viewpoint(RandomGenerator random, double distanceMm) {
        double slant = Math.toRadians(40) * Math.sqrt(random.nextDouble());
        double towards = 2 * Math.PI * random.nextDouble();
        double[] axis = {slant * Math.cos(towards), slant * Math.sin(towards), 0};
        RigidTransform turned = RigidTransform.ofRotationVector(axis, new double[3])
                .compose(RigidTransform.ofEuler(0, 0, 0, Math.PI, 0, 0))
                .compose(RigidTransform.ofEuler(0, 0, 0, 0, 0, 2 * Math.PI * random.nextDouble()));
        double[] r = turned.rotation();
        return RigidTransform.of(r, new double[] {-distanceMm * r[2], -distanceMm * r[5], -distanceMm * r[8]});
    }

    /** A marker somewhere in view, or null if the place drawn is none. */
    private static @Nullable RigidTransform marker(RandomGenerator random, PinholeCamera camera,
            RigidTransform worldFromCamera, double distanceMm, double sizeMm, List<double[]> taken) {
        double[] ray = new double[2];
        boolean seen = camera.toNormalised(WIDTH_PX * random.nextDouble(), HEIGHT_PX * random.nextDouble(), ray);
        double raised = random.nextBoolean() ? 0.25 * distanceMm * random.nextDouble() : 0;
        double tilt = random.nextBoolean() ? Math.toRadians(20) : 0;
        double[] w = {tilt * random.nextGaussian(), tilt * random.nextGaussian(), 0};
        double turn = 2 * Math.PI * random.nextDouble();
        double[] r = worldFromCamera.rotation();
        double[] c = worldFromCamera.translationMm();
        double depth = (raised - c[2]) / (r[6] * ray[0] + r[7] * ray[1] + r[8]);
        if (!seen || !(depth > 0.1 * distanceMm)) {
            return null;
        }
        RigidTransform rotation = RigidTransform.ofRotationVector(w, new double[3])
                .compose(RigidTransform.ofEuler(0, 0, 0, 0, 0, turn));
        RigidTransform pose = RigidTransform.of(rotation.rotation(),
                worldFromCamera.apply(depth * ray[0], depth * ray[1], depth));
        double[] circle = circle(camera, worldFromCamera.inverse().compose(pose), sizeMm);
        if (circle == null) {
            return null;
        }
        for (double[] other : taken) {
            if (Math.hypot(circle[0] - other[0], circle[1] - other[1]) < circle[2] + other[2]) {
                return null;
            }
        }
        taken.add(circle);
        return pose;
    }

    /** Centre and radius, px, of what a marker and its paper take of the image; null if it cannot be seen well. */
    private static double @Nullable [] circle(PinholeCamera camera, RigidTransform cameraFromMarker, double sizeMm) {
        double[] r = cameraFromMarker.rotation();
        double[] t = cameraFromMarker.translationMm();
        double distance = Math.sqrt(t[0] * t[0] + t[1] * t[1] + t[2] * t[2]);
        double cosine = -(r[2] * t[0] + r[5] * t[1] + r[8] * t[2]) / distance;
        double[] px = MarkerGeometry.cornersPx(camera, cameraFromMarker, sizeMm);
        if (px == null || cosine < LEAST_COSINE) {
            return null;
        }
        double u = 0;
        double v = 0;
        double longest = 0;
        for (int k = 0; k < 4; k++) {
            int next = (k + 1) % 4;
            double side = Math.hypot(px[2 * next] - px[2 * k], px[2 * next + 1] - px[2 * k + 1]);
            if (side < LEAST_SIDE_PX || side > LARGEST_SIDE_PX) {
                return null;
            }
            longest = Math.max(longest, side);
            u += px[2 * k] / 4;
            v += px[2 * k + 1] / 4;
        }
        double radius = ROOM * longest;
        boolean inside = u > radius && v > radius && u < WIDTH_PX - radius && v < HEIGHT_PX - radius;
        return inside ? new double[] {u, v, radius} : null;
    }

    private SimulatedCell built(RandomGenerator random, PinholeCamera camera, RigidTransform worldFromCamera,
            int references, List<RigidTransform> poses, List<Double> sizes) {
        double stdMm = logUniform(random, 0.3, 10);
        Placement placement = new Placement(stdMm, stdMm, stdMm, Math.toRadians(logUniform(random, 0.1, 3)));
        double drawnStdPx = logUniform(random, 0.05, 0.5);
        Set<Integer> ids = new LinkedHashSet<>();
        while (ids.size() < poses.size()) {
            int id = random.nextInt(family.size());
            if (!family.isAmbiguous(id)) {
                ids.add(id);
            }
        }
        List<Reference> nominal = new ArrayList<>();
        List<ObjectMarker> objects = new ArrayList<>();
        Map<Integer, RigidTransform> actual = new LinkedHashMap<>();
        Map<Integer, RigidTransform> worldFromObjects = new LinkedHashMap<>();
        int m = 0;
        for (int id : ids) {
            if (m < references) {
                Reference reference = new Reference(id, sizes.get(m), poses.get(m), placement);
                nominal.add(reference);
                actual.put(id, reference.drawn(random));
            } else {
                objects.add(new ObjectMarker(id, sizes.get(m), null));
                worldFromObjects.put(id, poses.get(m));
            }
            m++;
        }
        OptionalDouble stated = noiseIsUnknown || pixelStdPx.isPresent() ? pixelStdPx : OptionalDouble.of(drawnStdPx);
        return new SimulatedCell(new Cell(camera, family, nominal, objects, stated, OptionalDouble.empty()),
                new CellTruth(worldFromCamera, worldFromObjects), actual);
    }

    private static double logUniform(RandomGenerator random, double least, double most) {
        return least * Math.pow(most / least, random.nextDouble());
    }
}
