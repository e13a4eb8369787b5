package org.cellgauge.cli.render;

import java.util.Arrays;
import java.util.stream.IntStream;
import org.apache.commons.math3.random.RandomGenerator;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.geometry.Projection;
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
 * profile depend on where it falls within its pixel. Order: area and blur in linear light, light fall-off, shot noise,
 * tone curve, additive noise, rounding to 8 bits.
 *
 * <p>The result does not depend on the number of threads: tiles share nothing, and noise is drawn in the order of
 * pixels.
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
        for (int i = 0; i < light.length; i++) {
            double level = light[i];
            if (sensor.fullWellElectrons() > 0) {
                level += Math.sqrt(Math.max(0, level) / sensor.fullWellElectrons()) * random.nextGaussian();
            }
            if (sensor.gamma() != 1) {
                level = Math.pow(Math.max(0, level), 1 / sensor.gamma());
            }
            level *= 255;
            if (sensor.noiseGrey() > 0) {
                level += sensor.noiseGrey() * random.nextGaussian();
            }
            grey[i] = (byte) Math.min(255, Math.max(0, Math.round(level)));
        }
        return GreyImage.packed(grey, width, height);
    }

    /**
     * The light on the sensor before noise, tone curve and rounding.
     *
     * @param scene what stands where
     * @param sensor its blur and light fall-off are used
     * @return width x height values, row by row; 0 is dark, 1 full scale
     */
    public static float[] light(Scene scene, Sensor sensor) {
        PinholeCamera camera = scene.camera();
        RigidTransform cameraFromWorld = scene.worldFromCamera().inverse();
        PlanarMarker[] markers = scene.markers().stream()
                .map(m -> PlanarMarker.of(m, scene.quietZone(), cameraFromWorld, camera))
                .filter(m -> m != null).toArray(PlanarMarker[]::new);
        float[] image = new float[camera.widthPx() * camera.heightPx()];
        int tilesAcross = (camera.widthPx() + TILE_PX - 1) / TILE_PX;
        int tilesDown = (camera.heightPx() + TILE_PX - 1) / TILE_PX;
        IntStream.range(0, tilesAcross * tilesDown).parallel().forEach(tile -> new Tile(scene, sensor, markers,
                tile % tilesAcross * TILE_PX, tile / tilesAcross * TILE_PX).renderInto(image));
        return image;
    }

    /** A square of pixels, rendered with as much of its surroundings as blur brings into it. */
    private static final class Tile {
        private final Scene scene;
        private final Sensor sensor;
        private final double[] intrinsics;
        private final PlanarMarker[] markers;
        private final int u0;
        private final int v0;
        private final int columns;
        private final int rows;
        private final int margin;
        private final double[] rotation;
        private final double[] centre;
        private final double[] ray = new double[2];
        /** The markers whose paper reaches into the part at hand. */
        private final PlanarMarker[] here;
        private int hereCount;

        Tile(Scene scene, Sensor sensor, PlanarMarker[] all, int u0, int v0) {
            this.scene = scene;
            this.sensor = sensor;
            this.intrinsics = scene.camera().intrinsics();
            this.u0 = u0;
            this.v0 = v0;
            this.columns = Math.min(TILE_PX, scene.camera().widthPx() - u0);
            this.rows = Math.min(TILE_PX, scene.camera().heightPx() - v0);
            this.margin = (int) Math.ceil(BLUR_REACH * sensor.blurPx());
            this.rotation = scene.worldFromCamera().rotation();
            this.centre = scene.worldFromCamera().translationMm();
            this.markers = Arrays.stream(all)
                    .filter(m -> m.mayTouch(u0 - margin, v0 - margin, u0 + columns + margin, v0 + rows + margin))
                    .toArray(PlanarMarker[]::new);
            this.here = new PlanarMarker[markers.length];
        }

        void renderInto(float[] image) {
            int width = scene.camera().widthPx();
            float[] own = markers.length == 0 ? backdropAlone() : gather(parts());
            for (int row = 0; row < rows; row++) {
                for (int column = 0; column < columns; column++) {
                    image[(v0 + row) * width + u0 + column] =
                            (float) (own[row * columns + column] * lamp(u0 + column + 0.5, v0 + row + 0.5));
                }
            }
        }

        private float[] backdropAlone() {
            float[] out = new float[rows * columns];
            // the texture is smooth on the scale of a pixel: its average is taken by fading its short waves
            double softnessPx = Math.sqrt(sensor.blurPx() * sensor.blurPx() + 1.0 / 12);
            for (int row = 0; row < rows; row++) {
                for (int column = 0; column < columns; column++) {
                    boolean seen = Projection.toNormalised(intrinsics, u0 + column + 0.5, v0 + row + 0.5, ray);
                    out[row * columns + column] = (float) backdrop(seen, ray[0], ray[1], softnessPx);
                }
            }
            return out;
        }

        /** Light of every part of every pixel of the tile and its margin. */
        private float[] parts() {
            int across = (columns + 2 * margin) * PARTS;
            int down = (rows + 2 * margin) * PARTS;
            double[] x = new double[across * down];
            double[] y = new double[across * down];
            double reachX = 0;
            double reachY = 0;
            for (int j = 0; j < down; j++) {
                for (int i = 0; i < across; i++) {
                    int k = j * across + i;
                    if (Projection.toNormalised(intrinsics, partU(i + 0.5), partV(j + 0.5), ray)) {
                        x[k] = ray[0];
                        y[k] = ray[1];
                    } else {
                        x[k] = Double.NaN;
                        y[k] = Double.NaN;
                    }
                    if (i > 0 && j > 0) {
                        // half a part in u and half a part in v; NaN beyond the lens model's fold leaves max unchanged
                        double dx = Math.abs(x[k] - x[k - 1]) + Math.abs(x[k] - x[k - across]);
                        double dy = Math.abs(y[k] - y[k - 1]) + Math.abs(y[k] - y[k - across]);
                        reachX = dx > reachX ? dx : reachX;
                        reachY = dy > reachY ? dy : reachY;
                    }
                }
            }
            reachX *= REACH_MARGIN / 2;
            reachY *= REACH_MARGIN / 2;
            float[] light = new float[across * down];
            for (int j = 0; j < down; j++) {
                for (int i = 0; i < across; i++) {
                    int k = j * across + i;
                    light[k] = (float) part(i, j, x[k], y[k], reachX, reachY);
                }
            }
            return light;
        }

        private double partU(double i) {
            return u0 - margin + i / PARTS;
        }

        private double partV(double j) {
            return v0 - margin + j / PARTS;
        }

        private double part(int i, int j, double x, double y, double reachX, double reachY) {
            if (Double.isNaN(x)) {
                return backdrop(false, 0, 0, 0);
            }
            hereCount = 0;
            double colour = PlanarMarker.NOTHING;
            for (PlanarMarker marker : markers) {
                double own = marker.uniformColour(x, y, reachX, reachY);
                if (own != PlanarMarker.NOTHING) {
                    colour = own;
                    here[hereCount++] = marker;
                }
            }
            if (hereCount == 0) {
                return backdrop(true, x, y, 0);
            }
            // several papers: which one is in front may change within the part
            return hereCount > 1 || Double.isNaN(colour) ? averageOfRays(i, j) : colour;
        }

        private double averageOfRays(int i, int j) {
            double sum = 0;
            for (int n = 0; n < LATTICE_POINTS; n++) {
                double along = (n + 0.5) / LATTICE_POINTS;
                // the second coordinate's centring keeps the mean of the points in the middle of the part
                double across = (n * LATTICE_STEP % LATTICE_POINTS + 0.5) / LATTICE_POINTS;
                boolean seen = Projection.toNormalised(intrinsics, partU(i + along), partV(j + across), ray);
                sum += seen ? nearest(ray[0], ray[1]) : backdrop(false, 0, 0, 0);
            }
            return sum / LATTICE_POINTS;
        }

        private double nearest(double x, double y) {
            double colour = PlanarMarker.NOTHING;
            double inverseDepth = 0;
            for (int m = 0; m < hereCount; m++) {
                PlanarMarker marker = here[m];
                double own = marker.colourAt(x, y);
                if (own != PlanarMarker.NOTHING && marker.inverseDepth(x, y) > inverseDepth) {
                    colour = own;
                    inverseDepth = marker.inverseDepth(x, y);
                }
            }
            return colour == PlanarMarker.NOTHING ? backdrop(true, x, y, 0) : colour;
        }

        /**
         * Reflectance of the plane z = 0 where the ray meets it; the mean where it does not or the lens sees
         * nothing.
         */
        private double backdrop(boolean seen, double x, double y, double softnessPx) {
            double fall = rotation[6] * x + rotation[7] * y + rotation[8];
            double depth = -centre[2] / fall;
            if (!seen || !(depth > 0) || Double.isInfinite(depth)) {
                return Backdrop.MEAN_REFLECTANCE;
            }
            double placeX = centre[0] + depth * (rotation[0] * x + rotation[1] * y + rotation[2]);
            double placeY = centre[1] + depth * (rotation[3] * x + rotation[4] * y + rotation[5]);
            // a pixel covers depth / f mm of the wall, and more by the cosine where it is seen at a slant
            double length = Math.sqrt(x * x + y * y + 1);
            double mmPerPx = depth / intrinsics[PinholeCamera.FX] * length / Math.abs(fall);
            return scene.backdrop().reflectance(placeX, placeY, softnessPx * mmPerPx);
        }

        private double lamp(double u, double v) {
            double x = 2 * u / scene.camera().widthPx() - 1;
            double y = 2 * v / scene.camera().heightPx() - 1;
            return (1 - sensor.vignetting() * (x * x + y * y) / 2) * (1 + sensor.gradient() * (x / 2 + y / 4));
        }

        /** Blurs the parts and sums them up to pixels, both at once: first along rows, then along columns. */
        private float[] gather(float[] parts) {
            double[] kernel = pixelKernel(sensor.blurPx(), margin);
            int across = (columns + 2 * margin) * PARTS;
            int down = (rows + 2 * margin) * PARTS;
            double[] narrow = new double[down * columns];
            for (int j = 0; j < down; j++) {
                for (int column = 0; column < columns; column++) {
                    double sum = 0;
                    int start = j * across + column * PARTS;
                    for (int k = 0; k < kernel.length; k++) {
                        sum += kernel[k] * parts[start + k];
                    }
                    narrow[j * columns + column] = sum;
                }
            }
            float[] out = new float[rows * columns];
            for (int row = 0; row < rows; row++) {
                for (int column = 0; column < columns; column++) {
                    double sum = 0;
                    for (int k = 0; k < kernel.length; k++) {
                        sum += kernel[k] * narrow[(row * PARTS + k) * columns + column];
                    }
                    out[row * columns + column] = (float) sum;
                }
            }
            return out;
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
