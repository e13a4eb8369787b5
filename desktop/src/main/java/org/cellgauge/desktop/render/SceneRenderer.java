package org.cellgauge.desktop.render;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import org.apache.commons.math3.random.RandomGenerator;
import org.cellgauge.geometry.Lens;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.vision.GreyImage;

/**
 * Renders a {@link Scene} as a {@link Sensor} sees it.
 *
 * <p>Light is averaged over areas: where paper is near, every pixel is cut into 4x4 parts; a part that one colour fills
 * takes it, any other averages 55 rays on a Fibonacci lattice (I. H. Sloan and S. Joe, "Lattice Methods for Multiple
 * Integration", 1994, section 4.6), each sent through the exact inverse of the lens model. A straight edge so lies
 * within 0.0023 px of its place in each part (parallel to the pixel grid, the worst case) and far closer on average.
 * The point spread function then acts on the parts, not on whole pixels: blurring whole pixels would make an edge's
 * profile depend on where it falls within its pixel. What follows is the {@link Sensor}'s part.
 *
 * <p>The result does not depend on the number of threads: tiles share nothing, and noise is drawn in the order of
 * pixels.
 *
 * <p>{@link #renderNearMarkers} is for those who need thousands of pictures: all that a detector looks at closely is as
 * above, but that a part with one straight border through it has the share of its area on each side, exactly; the rest
 * is the wall in its mean grey.
 */
public final class SceneRenderer {
    private static final int PARTS = 4;
    private static final int TILE_PX = 32;
    private static final int LATTICE_POINTS = 55;
    private static final int LATTICE_STEP = 34;
    /** Beyond this many standard deviations the point spread function is cut off. */
    private static final double BLUR_REACH = 4;
    /** Covers the change of a part's size in normalised coordinates within a tile. */
    private static final double REACH_MARGIN = 1.2;
    private static final int REACH_STEP_PX = 8;
    private static final int SURROUNDINGS_PX = 10;
    private static final int BLOCK_PX = 8;
    private static final int NOISE_TABLE = 4096;
    /** Side of the square of noise that a sharpened wall is tiled with, px. */
    private static final int NOISE_PATCH = 192;

    private SceneRenderer() {
    }

    /**
     * Takes a picture.
     *
     * @param scene what stands where
     * @param sensor how it is taken
     * @param random source of the noise; not used by a sensor without noise
     * @return the picture, of the camera's image size
     */
    public static GreyImage render(Scene scene, Sensor sensor, RandomGenerator random) {
        int width = scene.camera().widthPx();
        int height = scene.camera().heightPx();
        float[] light = light(scene, sensor);
        byte[] grey = new byte[light.length];
        Exposure exposure = new Exposure(sensor, random);
        if (sensor.unsharpAmount() == 0) {
            for (int i = 0; i < light.length; i++) {
                grey[i] = rounded(exposure.grey(light[i]));
            }
        } else {
            for (int i = 0; i < light.length; i++) {
                light[i] = (float) exposure.grey(light[i]);
            }
            UnsharpMask.of(sensor).apply(light, width, height, grey);
        }
        return GreyImage.packed(grey, width, height);
    }

    /**
     * Takes a picture on the calling thread in a fraction of the time. Around the paper of every marker, as far as blur
     * and unsharp mask reach and {@value #SURROUNDINGS_PX} px more, it has the light of {@link #render}; beyond, the
     * wall's light is that of every eighth pixel, and its noise is taken from a table of {@value #NOISE_TABLE} draws,
     * or, where a mask makes it blue, from a square of {@value #NOISE_PATCH} px. Noise differs from that of
     * {@link #render}. A scene whose wall has a texture is rendered as a whole.
     *
     * @param scene what stands where
     * @param sensor how it is taken
     * @param random source of the noise
     * @return the picture, of the camera's image size
     */
    public static GreyImage renderNearMarkers(Scene scene, Sensor sensor, RandomGenerator random) {
        if (!scene.backdrop().isPlain()) {
            return render(scene, sensor, random);
        }
        int width = scene.camera().widthPx();
        int height = scene.camera().heightPx();
        byte[] grey = new byte[width * height];
        Exposure exposure = new Exposure(sensor, random);
        UnsharpMask mask = sensor.unsharpAmount() == 0 ? null : UnsharpMask.of(sensor);
        wall(scene, sensor, random, mask, grey);
        PlanarMarker[] markers = markers(scene);
        int reach = (int) Math.ceil(BLUR_REACH * sensor.blurPx()) + SURROUNDINGS_PX
                + (mask == null ? 0 : mask.reachPx());
        for (int[] area : areas(markers, reach, width, height)) {
            Tile tile = new Tile(scene, sensor, markers, area, true);
            float[] light = new float[tile.columns * tile.rows];
            tile.renderInto(light, tile.columns, area[0], area[1]);
            byte[] own = new byte[light.length];
            for (int i = 0; i < light.length; i++) {
                double level = exposure.grey(light[i]);
                own[i] = rounded(level);
                light[i] = (float) level;
            }
            if (mask != null) {
                mask.apply(light, tile.columns, tile.rows, own);
            }
            for (int row = 0; row < tile.rows; row++) {
                System.arraycopy(own, row * tile.columns, grey, (area[1] + row) * width + area[0], tile.columns);
            }
        }
        return GreyImage.packed(grey, width, height);
    }

    private static PlanarMarker[] markers(Scene scene) {
        RigidTransform cameraFromWorld = scene.worldFromCamera().inverse();
        return scene.markers().stream()
                .map(m -> PlanarMarker.of(m, scene.quietZone(), scene.printGainMm(), cameraFromWorld, scene.camera()))
                .filter(m -> m != null).toArray(PlanarMarker[]::new);
    }

    private static byte rounded(double level) {
        return (byte) Math.min(255, Math.max(0, Math.round(level)));
    }

    /** The wall alone, block by block. */
    private static void wall(Scene scene, Sensor sensor, RandomGenerator random, UnsharpMask mask, byte[] grey) {
        int width = scene.camera().widthPx();
        int height = scene.camera().heightPx();
        double[] noise = new double[NOISE_TABLE];
        for (int i = 0; i < noise.length; i++) {
            noise[i] = random.nextGaussian();
        }
        // on an even ground the mask leaves the mean as it is, makes more of the noise, and makes it blue
        float[] sharpened = mask == null ? null : sharpenedNoise(mask, random);
        int shift = mask == null ? 0 : random.nextInt(NOISE_PATCH * NOISE_PATCH);
        Lamp lamp = new Lamp(scene.camera(), sensor);
        int across = (width + BLOCK_PX - 1) / BLOCK_PX;
        double[] level = new double[across];
        double[] std = new double[across];
        for (int row = 0; row < height; row++) {
            if (row % BLOCK_PX == 0) {
                for (int block = 0; block < across; block++) {
                    double light = sensor.exposure() * Backdrop.MEAN_REFLECTANCE
                            * lamp.at((block + 0.5) * BLOCK_PX, row + 0.5 * BLOCK_PX);
                    level[block] = 255 * sensor.toneCurve().grey(light) + sensor.blackLevelGrey();
                    std[block] = noiseGrey(sensor, light);
                }
            }
            int at = random.nextInt(NOISE_TABLE);
            for (int column = 0; column < width; column++) {
                int block = column / BLOCK_PX;
                double here = sharpened == null ? noise[at++ & NOISE_TABLE - 1]
                        : sharpened[(row + shift / NOISE_PATCH) % NOISE_PATCH * NOISE_PATCH
                                + (column + shift) % NOISE_PATCH];
                grey[row * width + column] = rounded(sensor.cutOff(level[block] + std[block] * here));
            }
        }
    }

    /** A square of white noise of deviation 1 after a mask, which goes on beyond each border as at the other one. */
    private static float[] sharpenedNoise(UnsharpMask mask, RandomGenerator random) {
        int reach = mask.reachPx();
        int side = NOISE_PATCH + 2 * reach;
        float[] white = new float[NOISE_PATCH * NOISE_PATCH];
        for (int i = 0; i < white.length; i++) {
            white[i] = (float) random.nextGaussian();
        }
        float[] around = new float[side * side];
        for (int row = 0; row < side; row++) {
            for (int column = 0; column < side; column++) {
                around[row * side + column] = white[Math.floorMod(row - reach, NOISE_PATCH) * NOISE_PATCH
                        + Math.floorMod(column - reach, NOISE_PATCH)];
            }
        }
        float[] sharpened = new float[around.length];
        mask.apply(around, side, side, sharpened);
        float[] patch = new float[white.length];
        for (int row = 0; row < NOISE_PATCH; row++) {
            System.arraycopy(sharpened, (row + reach) * side + reach, patch, row * NOISE_PATCH, NOISE_PATCH);
        }
        return patch;
    }

    /** Deviation of a grey value of an even ground to first order, grey levels. */
    private static double noiseGrey(Sensor sensor, double light) {
        double shot = 0;
        if (sensor.fullWellElectrons() > 0) {
            double step = 1e-4;
            double slope = (sensor.toneCurve().grey(light + step) - sensor.toneCurve().grey(light)) / step;
            shot = 255 * slope * Math.sqrt(light / sensor.fullWellElectrons());
        }
        return Math.hypot(shot, sensor.noiseGrey());
    }

    /** Rectangles {u0, v0, columns, rows} that hold all papers and their surroundings and do not overlap. */
    private static List<int[]> areas(PlanarMarker[] markers, int reach, int width, int height) {
        List<int[]> areas = new ArrayList<>();
        for (PlanarMarker marker : markers) {
            int[] area = marker.boundsWithin(reach, width, height);
            boolean grown = area != null;
            while (grown) {
                grown = false;
                for (int i = areas.size() - 1; i >= 0; i--) {
                    int[] other = areas.get(i);
                    if (area[0] < other[0] + other[2] && other[0] < area[0] + area[2]
                            && area[1] < other[1] + other[3] && other[1] < area[1] + area[3]) {
                        int right = Math.max(area[0] + area[2], other[0] + other[2]);
                        int bottom = Math.max(area[1] + area[3], other[1] + other[3]);
                        area[0] = Math.min(area[0], other[0]);
                        area[1] = Math.min(area[1], other[1]);
                        area[2] = right - area[0];
                        area[3] = bottom - area[1];
                        areas.remove(i);
                        grown = true;
                    }
                }
            }
            if (area != null) {
                areas.add(area);
            }
        }
        return areas;
    }

    /**
     * The light on the sensor before exposure, noise, tone curve and rounding.
     *
     * @param scene what stands where
     * @param sensor its blur and light fall-off are used
     * @return width x height values, row by row; 0 is dark, 1 full scale
     */
    public static float[] light(Scene scene, Sensor sensor) {
        PinholeCamera camera = scene.camera();
        PlanarMarker[] markers = markers(scene);
        float[] image = new float[camera.widthPx() * camera.heightPx()];
        int tilesAcross = (camera.widthPx() + TILE_PX - 1) / TILE_PX;
        int tilesDown = (camera.heightPx() + TILE_PX - 1) / TILE_PX;
        IntStream.range(0, tilesAcross * tilesDown).parallel().forEach(tile -> {
            int u0 = tile % tilesAcross * TILE_PX;
            int v0 = tile / tilesAcross * TILE_PX;
            int[] area = {u0, v0, Math.min(TILE_PX, camera.widthPx() - u0), Math.min(TILE_PX, camera.heightPx() - v0)};
            new Tile(scene, sensor, markers, area, false).renderInto(image, camera.widthPx(), 0, 0);
        });
        return image;
    }

    /** From light to grey values with noise, pixel by pixel. */
    private static final class Exposure {
        private final Sensor sensor;
        private final RandomGenerator random;

        Exposure(Sensor sensor, RandomGenerator random) {
            this.sensor = sensor;
            this.random = random;
        }

        /** Grey levels, not rounded yet. */
        double grey(double light) {
            double level = sensor.exposure() == 1 ? light : sensor.exposure() * light;
            if (sensor.fullWellElectrons() > 0) {
                level += Math.sqrt(Math.max(0, level) / sensor.fullWellElectrons()) * random.nextGaussian();
            }
            if (!sensor.toneCurve().isLinear()) {
                level = sensor.toneCurve().grey(level);
            }
            level = 255 * level + sensor.blackLevelGrey();
            if (sensor.noiseGrey() > 0) {
                level += sensor.noiseGrey() * random.nextGaussian();
            }
            return sensor.cutOff(level);
        }
    }

    /** How much of the light reaches each place of the image. */
    private static final class Lamp {
        private final int widthPx;
        private final int heightPx;
        private final double vignetting;
        private final double gradient;

        Lamp(PinholeCamera camera, Sensor sensor) {
            widthPx = camera.widthPx();
            heightPx = camera.heightPx();
            vignetting = sensor.vignetting();
            gradient = sensor.gradient();
        }

        double at(double u, double v) {
            double x = 2 * u / widthPx - 1;
            double y = 2 * v / heightPx - 1;
            return (1 - vignetting * (x * x + y * y) / 2) * (1 + gradient * (x / 2 + y / 4));
        }
    }

    /** A rectangle of pixels, rendered with as much of its surroundings as blur brings into it. */
    private static final class Tile {
        private final Scene scene;
        private final Sensor sensor;
        private final Lens lens;
        private final double[] intrinsics;
        private final boolean distorted;
        private final PlanarMarker[] markers;
        private final Backdrop.Sampler wall;
        private final Lamp lamp;
        private final boolean raysInterpolated;
        private final boolean bordersStraight;
        private final int u0;
        private final int v0;
        private final int columns;
        private final int rows;
        private final int margin;
        private final double[] rotation;
        private final double[] centre;
        private final double[] ray = new double[3];
        /** x, y of the rays through the corners of the part at hand, where rays between them are interpolated. */
        private final double[] cornerRays = new double[8];
        private final double[] border = new double[5];
        /** The markers whose paper reaches into the part at hand. */
        private final PlanarMarker[] here;
        private int hereCount;

        /**
         * @param area u0, v0, columns, rows
         * @param quick whether rays within a part are interpolated between those through its corners, and a border
         *     through it is straight: right to 1e-6 px under any lens that is not a fisheye
         */
        Tile(Scene scene, Sensor sensor, PlanarMarker[] all, int[] area, boolean quick) {
            this.scene = scene;
            this.sensor = sensor;
            this.lens = scene.camera().lens();
            this.intrinsics = scene.camera().intrinsics();
            this.distorted = scene.camera().isDistorting();
            this.wall = scene.backdrop().sampler();
            this.lamp = new Lamp(scene.camera(), sensor);
            this.raysInterpolated = quick && distorted && !lens.isWide();
            this.bordersStraight = quick && !(distorted && lens.isWide());
            this.u0 = area[0];
            this.v0 = area[1];
            this.columns = area[2];
            this.rows = area[3];
            this.margin = (int) Math.ceil(BLUR_REACH * sensor.blurPx());
            this.rotation = scene.worldFromCamera().rotation();
            this.centre = scene.worldFromCamera().translationMm();
            this.markers = Arrays.stream(all)
                    .filter(m -> m.mayTouch(u0 - margin, v0 - margin, u0 + columns + margin, v0 + rows + margin))
                    .toArray(PlanarMarker[]::new);
            this.here = new PlanarMarker[markers.length];
        }

        /** Writes the tile's light into an image whose first pixel is (left, top) of the camera's. */
        void renderInto(float[] image, int width, int left, int top) {
            float[] own = markers.length == 0 ? backdropAlone() : gather(parts());
            for (int row = 0; row < rows; row++) {
                for (int column = 0; column < columns; column++) {
                    image[(v0 - top + row) * width + u0 - left + column] =
                            (float) (own[row * columns + column] * lamp.at(u0 + column + 0.5, v0 + row + 0.5));
                }
            }
        }

        /** The ray through a place of the image; without distortion Newton's steps would end where they begin. */
        private boolean seen(double u, double v) {
            if (distorted) {
                return lens.toRay(intrinsics, u, v, ray);
            }
            ray[1] = (v - intrinsics[PinholeCamera.CY]) / intrinsics[PinholeCamera.FY];
            ray[0] = (u - intrinsics[PinholeCamera.CX] - intrinsics[PinholeCamera.SKEW] * ray[1])
                    / intrinsics[PinholeCamera.FX];
            ray[2] = 1;
            return true;
        }

        private float[] backdropAlone() {
            float[] out = new float[rows * columns];
            if (scene.backdrop().isPlain()) {
                Arrays.fill(out, (float) Backdrop.MEAN_REFLECTANCE);
                return out;
            }
            // the texture is smooth on the scale of a pixel: its average is taken by fading its short waves
            double softnessPx = Math.sqrt(sensor.blurPx() * sensor.blurPx() + 1.0 / 12);
            for (int row = 0; row < rows; row++) {
                for (int column = 0; column < columns; column++) {
                    boolean seen = seen(u0 + column + 0.5, v0 + row + 0.5);
                    out[row * columns + column] = (float) backdrop(seen, ray[0], ray[1], ray[2], softnessPx);
                }
            }
            return out;
        }

        /** Light of every part of every pixel of the tile and its margin. */
        private float[] parts() {
            int across = (columns + 2 * margin) * PARTS;
            float[] light = new float[across * (rows + 2 * margin) * PARTS];
            double[] reach = reachOfHalfAPart();
            for (int row = 0; row < rows + 2 * margin; row++) {
                for (int column = 0; column < columns + 2 * margin; column++) {
                    pixel(column * PARTS, row * PARTS, reach, light, across);
                }
            }
            return light;
        }

        /** The parts of one pixel, all at once where it has one colour. */
        private void pixel(int i0, int j0, double[] reach, float[] light, int across) {
            double colour = Double.NaN;
            if (seen(partU(i0 + PARTS / 2.0), partV(j0 + PARTS / 2.0))) {
                colour = colour(reach, PARTS);
                if (hereCount == 0 && scene.backdrop().isPlain()) {
                    colour = Backdrop.MEAN_REFLECTANCE;
                }
            }
            for (int j = j0; j < j0 + PARTS; j++) {
                for (int i = i0; i < i0 + PARTS; i++) {
                    light[j * across + i] = (float) (colour >= 0 ? colour : part(i, j, reach));
                }
            }
        }

        /** Largest change of x, of y and of z, with a margin, that half a part in u and half a part in v make. */
        private double[] reachOfHalfAPart() {
            double[] reach = new double[3];
            double[] before = new double[3];
            double[] change = new double[3];
            double part = 1.0 / PARTS;
            for (double v = v0 - margin; v <= v0 + rows + margin; v += REACH_STEP_PX) {
                for (double u = u0 - margin; u <= u0 + columns + margin; u += REACH_STEP_PX) {
                    // beyond the lens model's fold there is nothing to measure
                    if (!seen(u, v)) {
                        continue;
                    }
                    System.arraycopy(ray, 0, before, 0, 3);
                    if (!seen(u + part, v)) {
                        continue;
                    }
                    for (int k = 0; k < 3; k++) {
                        change[k] = Math.abs(ray[k] - before[k]);
                    }
                    if (!seen(u, v + part)) {
                        continue;
                    }
                    for (int k = 0; k < 3; k++) {
                        reach[k] = Math.max(reach[k], change[k] + Math.abs(ray[k] - before[k]));
                    }
                }
            }
            for (int k = 0; k < 3; k++) {
                reach[k] *= REACH_MARGIN / 2;
            }
            return reach;
        }

        private double partU(double i) {
            return u0 - margin + i / PARTS;
        }

        private double partV(double j) {
            return v0 - margin + j / PARTS;
        }

        private double part(int i, int j, double[] reach) {
            if (!seen(partU(i + 0.5), partV(j + 0.5))) {
                return backdrop(false, 0, 0, 1, 0);
            }
            double colour = colour(reach, 1);
            if (hereCount == 0) {
                return backdrop(true, ray[0], ray[1], ray[2], 0);
            }
            if (!Double.isNaN(colour)) {
                return colour;
            }
            return bordersStraight && hereCount == 1 && here[0].singleBorder(ray, reach, border) && cornersSeen(i, j)
                    ? averageAtBorder() : averageOfRays(i, j);
        }

        /** The part's light where one border runs through it: the share of its square on each side, exactly. */
        private double averageAtBorder() {
            double topLeft = ofBorder(0);
            double topRight = ofBorder(1);
            double bottomLeft = ofBorder(2);
            double bottomRight = ofBorder(3);
            double along = Math.abs(topRight - topLeft + bottomRight - bottomLeft) / 2;
            double across = Math.abs(bottomLeft - topLeft + bottomRight - topRight) / 2;
            double middle = (topLeft + topRight + bottomLeft + bottomRight) / 4;
            double most = (along + across) / 2;
            double share;
            if (Math.abs(middle) >= most) {
                share = middle > 0 ? 1 : 0;
            } else if (Math.abs(middle) <= Math.abs(along - across) / 2) {
                share = 0.5 + middle / Math.max(along, across);
            } else {
                double triangle = (most - Math.abs(middle)) * (most - Math.abs(middle)) / (2 * along * across);
                share = middle > 0 ? 1 - triangle : triangle;
            }
            double first = border[3] == PlanarMarker.NOTHING ? backdrop(true, ray[0], ray[1], ray[2], 0) : border[3];
            double second = border[4] == PlanarMarker.NOTHING ? backdrop(true, ray[0], ray[1], ray[2], 0) : border[4];
            return first + share * (second - first);
        }

        private double ofBorder(int corner) {
            return border[0] * cornerRays[corner] + border[1] * cornerRays[4 + corner] + border[2];
        }

        /**
         * The one colour that paper has near the ray at hand: NOTHING if there is no paper, NaN if there may be several
         * colours.
         */
        private double colour(double[] reach, double times) {
            hereCount = 0;
            double colour = PlanarMarker.NOTHING;
            for (PlanarMarker marker : markers) {
                double own = marker.uniformColour(ray, reach, times);
                if (own != PlanarMarker.NOTHING) {
                    colour = own;
                    here[hereCount++] = marker;
                }
            }
            // several papers: which one is in front may change within reach
            return hereCount > 1 ? Double.NaN : colour;
        }

        private double averageOfRays(int i, int j) {
            boolean interpolated = raysInterpolated && cornersSeen(i, j);
            double sum = 0;
            for (int n = 0; n < LATTICE_POINTS; n++) {
                double along = (n + 0.5) / LATTICE_POINTS;
                // the second coordinate's centring keeps the mean of the points in the middle of the part
                double across = (n * LATTICE_STEP % LATTICE_POINTS + 0.5) / LATTICE_POINTS;
                if (interpolated) {
                    sum += nearest(between(0, along, across), between(1, along, across), 1);
                } else {
                    sum += seen(partU(i + along), partV(j + across)) ? nearest(ray[0], ray[1], ray[2])
                            : backdrop(false, 0, 0, 1, 0);
                }
            }
            return sum / LATTICE_POINTS;
        }

        private boolean cornersSeen(int i, int j) {
            for (int k = 0; k < 4; k++) {
                if (!seen(partU(i + k % 2), partV(j + k / 2))) {
                    return false;
                }
                cornerRays[k] = ray[0];
                cornerRays[4 + k] = ray[1];
            }
            return true;
        }

        private double between(int axis, double along, double across) {
            int k = 4 * axis;
            double top = cornerRays[k] + along * (cornerRays[k + 1] - cornerRays[k]);
            double bottom = cornerRays[k + 2] + along * (cornerRays[k + 3] - cornerRays[k + 2]);
            return top + across * (bottom - top);
        }

        private double nearest(double x, double y, double z) {
            double colour = PlanarMarker.NOTHING;
            double inverseDistance = 0;
            for (int m = 0; m < hereCount; m++) {
                PlanarMarker marker = here[m];
                double own = marker.colourAt(x, y, z);
                if (own != PlanarMarker.NOTHING && marker.inverseDistance(x, y, z) > inverseDistance) {
                    colour = own;
                    inverseDistance = marker.inverseDistance(x, y, z);
                }
            }
            return colour == PlanarMarker.NOTHING ? backdrop(true, x, y, z, 0) : colour;
        }

        /**
         * Reflectance of the plane z = 0 where the ray meets it; the mean where it does not or the lens sees
         * nothing.
         */
        private double backdrop(boolean seen, double x, double y, double z, double softnessPx) {
            if (scene.backdrop().isPlain()) {
                return Backdrop.MEAN_REFLECTANCE;
            }
            double fall = rotation[6] * x + rotation[7] * y + rotation[8] * z;
            double depth = -centre[2] / fall;
            if (!seen || !(depth > 0) || Double.isInfinite(depth)) {
                return Backdrop.MEAN_REFLECTANCE;
            }
            double placeX = centre[0] + depth * (rotation[0] * x + rotation[1] * y + rotation[2] * z);
            double placeY = centre[1] + depth * (rotation[3] * x + rotation[4] * y + rotation[5] * z);
            // a pixel covers depth / f mm of the wall, and more by the cosine where it is seen at a slant
            double length = Math.sqrt(x * x + y * y + z * z);
            double mmPerPx = depth / intrinsics[PinholeCamera.FX] * length / Math.abs(fall);
            return wall.reflectance(placeX, placeY, softnessPx * mmPerPx);
        }

        /**
         * Blurs the parts and sums them up to pixels, both at once: first along rows, then along columns, weight by
         * weight for many pixels, so that a compiler can take several at a time.
         */
        private float[] gather(float[] parts) {
            double[] kernel = pixelKernel(sensor.blurPx(), margin);
            int wide = columns + 2 * margin;
            int down = (rows + 2 * margin) * PARTS;
            double[] narrow = new double[down * columns];
            double[] sums = new double[columns];
            double[][] everyFourth = new double[PARTS][wide];
            for (int j = 0; j < down; j++) {
                for (int k = 0; k < wide * PARTS; k++) {
                    everyFourth[k % PARTS][k / PARTS] = parts[j * wide * PARTS + k];
                }
                Arrays.fill(sums, 0);
                for (int k = 0; k < kernel.length; k++) {
                    addTimes(kernel[k], everyFourth[k % PARTS], k / PARTS, sums);
                }
                System.arraycopy(sums, 0, narrow, j * columns, columns);
            }
            float[] out = new float[rows * columns];
            for (int row = 0; row < rows; row++) {
                Arrays.fill(sums, 0);
                for (int k = 0; k < kernel.length; k++) {
                    addTimes(kernel[k], narrow, (row * PARTS + k) * columns, sums);
                }
                for (int column = 0; column < columns; column++) {
                    out[row * columns + column] = (float) sums[column];
                }
            }
            return out;
        }

        private static void addTimes(double weight, double[] values, int from, double[] sums) {
            for (int i = 0; i < sums.length; i++) {
                sums[i] += weight * values[from + i];
            }
        }
    }

    /**
     * Weights of the parts from {@code margin} pixels before a pixel to as many after it: Gaussian times pixel
     * area.
     */
    private static double[] pixelKernel(double blurPx, int margin) {
        double[] kernel = new double[(2 * margin + 1) * PARTS];
        double total = 0;
        for (int k = 0; k < kernel.length; k++) {
            for (int p = 0; p < PARTS; p++) {
                int distance = k - margin * PARTS - p;
                if (blurPx == 0) {
                    kernel[k] += distance == 0 ? 1 : 0;
                } else {
                    double z = distance / (PARTS * blurPx);
                    kernel[k] += Math.exp(-z * z / 2);
                }
            }
            total += kernel[k];
        }
        for (int k = 0; k < kernel.length; k++) {
            kernel[k] /= total;
        }
        return kernel;
    }
}
