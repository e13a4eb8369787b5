package org.cellgauge.desktop.render;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import org.cellgauge.cell.MarkerFamily;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.internal.vision.MarkerPattern;

/**
 * What a rendered photo shows: printed markers on white paper in front of a wall (or on a table) in the plane z = 0 of
 * the world, and the camera that sees them; immutable. Nearer markers hide what lies behind them. Nothing casts a
 * shadow.
 */
public final class Scene {
    /** Width of the white paper around a marker that is used where none is given, as a share of the marker's size. */
    public static final double DEFAULT_QUIET_ZONE = 0.2;

    private final PinholeCamera camera;
    private final RigidTransform worldFromCamera;
    private final List<SceneMarker> markers;
    private final Backdrop backdrop;
    private final double quietZone;
    private final double printGainMm;

    private Scene(Builder builder) {
        this.camera = builder.camera;
        this.worldFromCamera = builder.worldFromCamera;
        this.markers = Collections.unmodifiableList(new ArrayList<>(builder.markers));
        this.backdrop = builder.backdrop;
        this.quietZone = builder.quietZone;
        this.printGainMm = builder.printGainMm;
    }

    /**
     * Starts a scene: no markers yet, a plain grey wall.
     *
     * @param camera intrinsics and image size
     * @param worldFromCamera pose of the camera in the world
     * @return a builder
     */
    public static Builder of(PinholeCamera camera, RigidTransform worldFromCamera) {
        return new Builder(camera, worldFromCamera);
    }

    /**
     * The camera.
     *
     * @return intrinsics and image size
     */
    public PinholeCamera camera() {
        return camera;
    }

    /**
     * Pose of the camera.
     *
     * @return worldFromCamera
     */
    public RigidTransform worldFromCamera() {
        return worldFromCamera;
    }

    /**
     * The markers.
     *
     * @return unmodifiable, in the order they were added
     */
    public List<SceneMarker> markers() {
        return markers;
    }

    /**
     * The wall or table behind the markers.
     *
     * @return the plane z = 0 of the world
     */
    public Backdrop backdrop() {
        return backdrop;
    }

    /**
     * Width of the white paper around every marker.
     *
     * @return share of the marker's size, on each side
     */
    public double quietZone() {
        return quietZone;
    }

    /**
     * By how much every dark region of a print is larger than its pattern has it.
     *
     * @return mm on each side; negative: smaller
     */
    public double printGainMm() {
        return printGainMm;
    }

    /** Collects the parts of a {@link Scene}. Not safe for several threads. */
    public static final class Builder {
        private final PinholeCamera camera;
        private final RigidTransform worldFromCamera;
        private final List<SceneMarker> markers = new ArrayList<>();
        private Backdrop backdrop = Backdrop.plain();
        private double quietZone = DEFAULT_QUIET_ZONE;
        private double printGainMm;

        private Builder(PinholeCamera camera, RigidTransform worldFromCamera) {
            this.camera = camera;
            this.worldFromCamera = worldFromCamera;
        }

        /**
         * Adds a marker.
         *
         * @param marker the marker with its true pose
         * @return this builder
         */
        public Builder marker(SceneMarker marker) {
            markers.add(marker);
            return this;
        }

        /**
         * Adds a marker of a family.
         *
         * @param familyName as in {@link MarkerFamily#of}
         * @param id marker id
         * @param sizeMm outer edge of the black border, mm
         * @param worldFromMarker its true pose
         * @return this builder
         * @throws IllegalArgumentException as {@link MarkerPattern#of} and {@link SceneMarker}
         */
        public Builder marker(String familyName, int id, double sizeMm, RigidTransform worldFromMarker) {
            return marker(new SceneMarker(id, sizeMm, MarkerPattern.of(MarkerFamily.of(familyName), id),
                    worldFromMarker));
        }

        /**
         * Sets the wall or table behind the markers.
         *
         * @param value the plane z = 0 of the world
         * @return this builder
         */
        public Builder backdrop(Backdrop value) {
            this.backdrop = value;
            return this;
        }

        /**
         * Sets the width of the white paper around every marker.
         *
         * @param value share of the marker's size on each side, at least 0
         * @return this builder
         * @throws IllegalArgumentException if the value is negative or not finite
         */
        public Builder quietZone(double value) {
            if (!(value >= 0) || !Double.isFinite(value)) {
                throw new IllegalArgumentException("quiet zone must be at least 0, not " + value);
            }
            this.quietZone = value;
            return this;
        }

        /**
         * Sets how far ink spreads: every dark region of every print grows by so much on all sides, so that white cells
         * shrink and the outer square has sides longer by twice as much. Where a marker should have its corners stays
         * what its size says.
         *
         * @param mm on each side, less than half a cell of every marker; negative: dark regions shrink
         * @return this builder
         */
        public Builder printGainMm(double mm) {
            this.printGainMm = mm;
            return this;
        }

        /**
         * Finishes the scene.
         *
         * @return the scene
         * @throws IllegalArgumentException if the print gain is not finite or half a cell or more of some marker
         */
        public Scene build() {
            for (SceneMarker marker : markers) {
                double mostMm = marker.sizeMm() / marker.pattern().cells() / 2;
                if (!(Math.abs(printGainMm) < mostMm)) {
                    throw new IllegalArgumentException("print gain must be below half a cell of every marker, "
                            + mostMm + " mm of marker " + marker.id() + ", not " + printGainMm + " mm");
                }
            }
            return new Scene(this);
        }
    }
}
