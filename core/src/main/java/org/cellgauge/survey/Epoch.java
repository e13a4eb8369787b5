package org.cellgauge.survey;

import java.util.Arrays;
import java.util.List;
import org.cellgauge.geometry.RigidTransform;

/**
 * Where the references, objects and camera of a cell were at the time of a survey, and how well that is known of all
 * of them together: what a later survey is held against; immutable.
 */
public final class Epoch {
    /** Numbers of a pose's error: shift along world x, y, z in mm, turn about its origin in world axes in rad. */
    public static final int ERRORS = 6;

    /** What a pose is of. */
    public enum Kind {
        /** A reference. */
        REFERENCE("reference"),
        /** An object that stands still. */
        OBJECT("object"),
        /** The camera as it took the last photo. */
        CAMERA("camera");

        private final String word;

        Kind(String word) {
            this.word = word;
        }

        /**
         * As it stands in files.
         *
         * @return a word
         */
        public String word() {
            return word;
        }
    }

    /**
     * Something that has a pose.
     *
     * @param kind what it is
     * @param id of its marker; 0 of the camera
     * @param worldFromBody its pose, mm
     */
    public record Body(Kind kind, int id, RigidTransform worldFromBody) {
        /**
         * Whether another one is the same thing, wherever it stands.
         *
         * @param other of another epoch
         * @return true where kind and id are the same
         */
        public boolean isSameAs(Body other) {
            return kind == other.kind && id == other.id;
        }

        /**
         * How it is called.
         *
         * @return {@code reference 22}, {@code the camera}
         */
        public String words() {
            return kind == Kind.CAMERA ? "the camera" : kind.word() + " " + id;
        }
    }

    private final List<Body> bodies;
    private final double[] covariance;

    /**
     * An epoch.
     *
     * @param bodies in the order of rows and columns
     * @param covariance {@value #ERRORS} rows and columns for each, row by row, mm and rad; positive semidefinite;
     *     copied
     * @throws IllegalArgumentException if it is of another size, not finite, or a variance is not positive
     */
    public Epoch(List<Body> bodies, double[] covariance) {
        int n = ERRORS * bodies.size();
        if (covariance.length != n * n) {
            throw new IllegalArgumentException("needs " + n + " rows and columns");
        }
        for (int i = 0; i < n; i++) {
            if (!(covariance[i * (n + 1)] > 0)) {
                throw new IllegalArgumentException("a variance is not positive");
            }
            for (int j = 0; j < i; j++) {
                double largest = Math.sqrt(covariance[i * (n + 1)] * covariance[j * (n + 1)]);
                if (!(Math.abs(covariance[i * n + j] - covariance[j * n + i]) <= 1e-6 * largest)
                        || !(Math.abs(covariance[i * n + j]) <= 1.000001 * largest)) {
                    throw new IllegalArgumentException("this is no covariance");
                }
            }
        }
        this.bodies = List.copyOf(bodies);
        this.covariance = covariance.clone();
    }

    /**
     * What has a pose.
     *
     * @return references first, then objects, then the camera; unmodifiable
     */
    public List<Body> bodies() {
        return bodies;
    }

    /**
     * The joint covariance of all poses.
     *
     * @return a copy, {@value #ERRORS} rows and columns for each body, row by row, mm and rad
     */
    public double[] covariance() {
        return covariance.clone();
    }

    @Override
    public boolean equals(Object other) {
        return other instanceof Epoch that && bodies.equals(that.bodies)
                && Arrays.equals(covariance, that.covariance);
    }

    @Override
    public int hashCode() {
        return 31 * bodies.hashCode() + Arrays.hashCode(covariance);
    }
}
