package org.cellgauge.estimate;

import java.util.OptionalInt;
import org.jspecify.annotations.Nullable;

/** What causes a part of a variance: a kind and, where the kind is about one reference, which; immutable. */
public final class VarianceSource {
    /** Noise in the references' corners. */
    public static final VarianceSource CORNER_NOISE_OF_REFERENCES = of(Kind.CORNER_NOISE_OF_REFERENCES);
    /** Noise in the object's own corners. */
    public static final VarianceSource CORNER_NOISE_OF_OBJECT = of(Kind.CORNER_NOISE_OF_OBJECT);
    /** Corners off the planes of their markers. */
    public static final VarianceSource FLATNESS_OF_PRINTS = of(Kind.FLATNESS_OF_PRINTS);
    /** Unknown intrinsics. */
    public static final VarianceSource INTRINSICS = of(Kind.INTRINSICS);
    /** Intrinsics as well as a calibration knows them. */
    public static final VarianceSource CALIBRATION = of(Kind.CALIBRATION);
    /** Edges that all lie too far in the dark or the light. */
    public static final VarianceSource EDGES = of(Kind.EDGES);
    /** Markers printed too large or too small. */
    public static final VarianceSource SIZE_OF_PRINTS = of(Kind.SIZE_OF_PRINTS);
    /** Where references stand together: on one plate, or as a survey knows them. */
    public static final VarianceSource COMMON_PLACEMENT = of(Kind.COMMON_PLACEMENT);
    /** The weak prior of the camera pose. */
    public static final VarianceSource POSE_PRIOR = of(Kind.POSE_PRIOR);

    /** What kinds of sources there are, each with its words. */
    public enum Kind {
        /** How precisely one reference was placed: the only kind with an id. */
        PLACEMENT_OF_REFERENCE("placement of reference ", "the placement of reference "),
        /** Noise in the references' corners. */
        CORNER_NOISE_OF_REFERENCES("corner noise of references", "noise in the references' corners"),
        /** Noise in the object's own corners. */
        CORNER_NOISE_OF_OBJECT("corner noise of object", "noise in the object's own corners"),
        /** Corners off the planes of their markers. */
        FLATNESS_OF_PRINTS("flatness of prints", "prints that are not flat"),
        /** Unknown intrinsics. */
        INTRINSICS("intrinsics", "the unknown intrinsics"),
        /** Intrinsics as well as a calibration knows them. */
        CALIBRATION("calibration", "the calibration of the camera"),
        /** Edges that all lie too far in the dark or the light. */
        EDGES("edges of the photo", "where the edges of the photo lie"),
        /** Markers printed too large or too small. */
        SIZE_OF_PRINTS("size of prints", "the size of prints"),
        /** Where references stand together. */
        COMMON_PLACEMENT("common placement", "where the references stand together"),
        /** The weak prior of the camera pose. */
        POSE_PRIOR("pose prior", "the pose prior");

        private final String key;
        private final String phrase;

        Kind(String key, String phrase) {
            this.key = key;
            this.phrase = phrase;
        }
    }

    private final Kind kind;
    private final OptionalInt referenceId;
    /** Budgets of many objects look each source up again and again. */
    private final int hash;

    private VarianceSource(Kind kind, OptionalInt referenceId) {
        this.kind = kind;
        this.referenceId = referenceId;
        hash = 31 * kind.hashCode() + referenceId.hashCode();
    }

    private static VarianceSource of(Kind kind) {
        return new VarianceSource(kind, OptionalInt.empty());
    }

    /**
     * The placement of one reference.
     *
     * @param referenceId its marker id
     * @return the source
     */
    public static VarianceSource placementOf(int referenceId) {
        return new VarianceSource(Kind.PLACEMENT_OF_REFERENCE, OptionalInt.of(referenceId));
    }

    /**
     * The source that a result file means by a key of a budget.
     *
     * @param key as {@link #key()} makes it
     * @return the source
     * @throws IllegalArgumentException if no source has that key
     */
    public static VarianceSource ofKey(String key) {
        for (Kind kind : Kind.values()) {
            if (kind != Kind.PLACEMENT_OF_REFERENCE) {
                if (kind.key.equals(key)) {
                    return of(kind);
                }
            } else if (key.startsWith(kind.key)) {
                return placementOf(Integer.parseInt(key.substring(kind.key.length())));
            }
        }
        throw new IllegalArgumentException("no source of variance is called " + key);
    }

    /**
     * What kind of source it is.
     *
     * @return the kind
     */
    public Kind kind() {
        return kind;
    }

    /**
     * The reference whose placement it is.
     *
     * @return its marker id; empty for every other kind
     */
    public OptionalInt referenceId() {
        return referenceId;
    }

    /**
     * Its name in tables and files, in English.
     *
     * @return such as {@code placement of reference 22}
     */
    public String key() {
        return kind.key + (referenceId.isPresent() ? String.valueOf(referenceId.getAsInt()) : "");
    }

    /**
     * Its name within a sentence, in English.
     *
     * @return such as {@code the placement of reference 22}
     */
    public String phrase() {
        return kind.phrase + (referenceId.isPresent() ? String.valueOf(referenceId.getAsInt()) : "");
    }

    @Override
    public boolean equals(@Nullable Object other) {
        return other instanceof VarianceSource && kind == ((VarianceSource) other).kind
                && referenceId.equals(((VarianceSource) other).referenceId);
    }

    @Override
    public int hashCode() {
        return hash;
    }

    @Override
    public String toString() {
        return key();
    }
}
