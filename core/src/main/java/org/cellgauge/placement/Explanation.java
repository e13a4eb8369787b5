package org.cellgauge.placement;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import org.cellgauge.internal.warning.CheckPhrase;
import org.cellgauge.internal.warning.Decimal;
import org.cellgauge.internal.warning.Listing;
import org.cellgauge.warning.CheckWarning;
import org.cellgauge.warning.Warning;

/** A cause that explains why references do not fit together, by how much, and what it may be instead; immutable. */
public final class Explanation {
    private final Cause cause;
    private final List<Integer> references;
    private final int axis;
    private final double[] size;
    private final double std;
    private final double statedMm;
    private final double evidence;
    private final List<Explanation> orInstead;

    private Explanation(Cause cause, List<Integer> references, int axis, double[] size, double std, double statedMm,
            double evidence, List<Explanation> orInstead) {
        this.cause = cause;
        this.references = Collections.unmodifiableList(new ArrayList<>(references));
        this.axis = axis;
        this.size = size.clone();
        this.std = std;
        this.statedMm = statedMm;
        this.evidence = evidence;
        this.orInstead = Collections.unmodifiableList(new ArrayList<>(orInstead));
    }

    /** A cause that has a size of its own, as in {@link Cause}. */
    static Explanation ofSize(Cause cause, List<Integer> references, int axis, double[] size, double std,
            double statedMm, double evidence) {
        return new Explanation(cause, references, axis, size, std, statedMm, evidence, Collections.emptyList());
    }

    /** A cause that is or is not. */
    static Explanation outright(Cause cause, List<Integer> references, int axis, double size, double evidence) {
        return new Explanation(cause, references, axis, new double[] {size}, Double.NaN, Double.NaN, evidence,
                Collections.emptyList());
    }

    /** The same with others that the photo speaks for hardly less. */
    Explanation orInstead(List<Explanation> others) {
        return new Explanation(cause, references, axis, size, std, statedMm, evidence, others);
    }

    /**
     * The same with others, and with what is one and the same to every photo: markers that are larger, and positions
     * that are closer together.
     */
    Explanation orAlsoInstead(List<Explanation> others) {
        List<Explanation> all = new ArrayList<>(others);
        if (cause == Cause.MARKER_SIZE) {
            all.add(ofSize(Cause.POSITION_SCALE, references, -1, new double[] {1 / (1 + size[0])}, std, Double.NaN,
                    evidence));
        }
        return orInstead(all);
    }

    /** How much speaks for it: twice a logarithm, to be compared with that of others of one photo. */
    double evidence() {
        return evidence;
    }

    /**
     * The cause.
     *
     * @return never null
     */
    public Cause cause() {
        return cause;
    }

    /**
     * The references that it is about.
     *
     * @return marker ids, unmodifiable; empty where it is about all
     */
    public List<Integer> references() {
        return references;
    }

    /**
     * The world axis that it is about.
     *
     * @return 0, 1, 2 for x, y, z; -1 for none
     */
    public int axis() {
        return axis;
    }

    /**
     * How large it is, as {@link Cause} says; positive where what is real is larger than what is stated.
     *
     * @return a copy: one value, of {@link Cause#PRINCIPAL_POINT} two; 0 where a cause has no size
     */
    public double[] size() {
        return size.clone();
    }

    /**
     * Standard deviation of that size.
     *
     * @return in its unit, of {@link Cause#PRINCIPAL_POINT} along its direction; NaN where it is not estimated
     */
    public double std() {
        return std;
    }

    /**
     * Other causes that the photo speaks for less than twenty times less clearly.
     *
     * @return the likelier first; unmodifiable
     */
    public List<Explanation> orInstead() {
        return orInstead;
    }

    /**
     * What to tell the user.
     *
     * @return one sentence: as if what, and what to do
     */
    public Warning warning() {
        Object or = or(orInstead);
        switch (cause) {
            case MARKER_SIZE:
                return Warning.of(CheckWarning.AS_IF_MARKERS, percent(),
                        size[0] < 0 ? CheckPhrase.SMALLER : CheckPhrase.LARGER, mm(), percentStd(), or);
            case SIZE_OF_SOME:
                return Warning.of(CheckWarning.AS_IF_SOME_MARKERS, Listing.and(references), percent(),
                        size[0] < 0 ? CheckPhrase.SMALLER : CheckPhrase.LARGER, mm(), percentStd(), or);
            case EDGE_SHIFT:
                return Warning.of(CheckWarning.AS_IF_EDGES, Decimal.of(Math.abs(size[0]), 2), Decimal.of(std, 2),
                        size[0] < 0 ? CheckPhrase.OUTWARDS : CheckPhrase.INWARDS, or);
            case FOCAL_LENGTH:
                return Warning.of(CheckWarning.AS_IF_FOCAL_LENGTH, percent(),
                        size[0] < 0 ? CheckPhrase.SHORTER : CheckPhrase.LONGER, percentStd(), or);
            case PRINCIPAL_POINT:
                return Warning.of(CheckWarning.AS_IF_PRINCIPAL_POINT, Decimal.of(size[0], 1), Decimal.of(size[1], 1),
                        Decimal.of(std, 1), or);
            case DISTORTION:
                return Warning.of(CheckWarning.AS_IF_DISTORTION, Decimal.of(size[0], 3), Decimal.of(std, 3), or);
            case STRETCH:
                return Warning.of(CheckWarning.AS_IF_STRETCHED, axisName(), percent(), size[0] < 0
                        ? CheckPhrase.CLOSER_TOGETHER : CheckPhrase.FARTHER_APART, percentStd(), or);
            case POSITION_SCALE:
                return Warning.of(CheckWarning.AS_IF_SCALED, Decimal.of(size[0], 3), or);
            case POSITION_UNIT:
                return Warning.of(CheckWarning.POSITIONS_IN_ANOTHER_UNIT, Decimal.shortest(size[0]), or);
            case SIZE_UNIT:
                return Warning.of(CheckWarning.SIZES_IN_ANOTHER_UNIT, Decimal.shortest(size[0]), or);
            case EXCHANGED:
                return Warning.of(CheckWarning.REFERENCES_EXCHANGED, Listing.and(references), or);
            case TURNED:
                return Warning.of(CheckWarning.REFERENCE_TURNED_ABOUT, references.get(0), degrees(), or);
            case ALL_TURNED:
                return Warning.of(CheckWarning.ALL_TURNED_ABOUT, degrees(), or);
            case MIRRORED:
                return Warning.of(CheckWarning.AXIS_MIRRORED, axisName(), or);
            case RADIANS:
                return Warning.of(CheckWarning.ROTATIONS_IN_RADIANS, or);
            default:
                return Warning.of(CheckWarning.REFERENCE_ELSEWHERE, references.get(0), or);
        }
    }

    /**
     * Its name among others.
     *
     * @return a part of a sentence
     */
    public Warning phrase() {
        switch (cause) {
            case MARKER_SIZE:
                return Warning.of(CheckPhrase.CAUSE_MARKER_SIZE);
            case SIZE_OF_SOME:
                return Warning.of(CheckPhrase.CAUSE_SIZE_OF_SOME, Listing.and(references));
            case EDGE_SHIFT:
                return Warning.of(CheckPhrase.CAUSE_EDGE_SHIFT);
            case FOCAL_LENGTH:
                return Warning.of(CheckPhrase.CAUSE_FOCAL_LENGTH);
            case PRINCIPAL_POINT:
                return Warning.of(CheckPhrase.CAUSE_PRINCIPAL_POINT);
            case DISTORTION:
                return Warning.of(CheckPhrase.CAUSE_DISTORTION);
            case STRETCH:
                return Warning.of(CheckPhrase.CAUSE_STRETCH, axisName());
            case POSITION_SCALE:
            case POSITION_UNIT:
                return Warning.of(CheckPhrase.CAUSE_POSITION_SCALE);
            case SIZE_UNIT:
                return Warning.of(CheckPhrase.CAUSE_SIZE_UNIT);
            case EXCHANGED:
                return Warning.of(CheckPhrase.CAUSE_EXCHANGED, Listing.and(references));
            case TURNED:
                return Warning.of(CheckPhrase.CAUSE_TURNED, references.get(0), degrees());
            case ALL_TURNED:
                return Warning.of(CheckPhrase.CAUSE_ALL_TURNED, degrees());
            case MIRRORED:
                return Warning.of(CheckPhrase.CAUSE_MIRRORED, axisName());
            case RADIANS:
                return Warning.of(CheckPhrase.CAUSE_RADIANS);
            default:
                return Warning.of(CheckPhrase.CAUSE_REFERENCE, references.get(0));
        }
    }

    /** What it may be instead, as the end of a sentence; nothing where nothing else is likely. */
    static Object or(List<Explanation> others) {
        if (others.isEmpty()) {
            return "";
        }
        List<Warning> phrases = new ArrayList<>();
        others.forEach(other -> phrases.add(other.phrase()));
        return Warning.of(CheckPhrase.OR_CAUSE, Listing.or(phrases));
    }

    private Decimal percent() {
        return Decimal.of(Math.abs(100 * size[0]), 1);
    }

    private Decimal percentStd() {
        return Decimal.of(100 * std, 1);
    }

    private Warning mm() {
        return Double.isNaN(statedMm) ? Warning.of(CheckPhrase.STATED)
                : Warning.of(CheckPhrase.STD_MM, Decimal.shortest(statedMm));
    }

    private Decimal degrees() {
        return Decimal.of(90 * size[0], 0);
    }

    private String axisName() {
        return "xyz".substring(axis, axis + 1);
    }

    @Override
    public String toString() {
        return cause.key() + " " + references + " " + Arrays.toString(size);
    }
}
