package org.cellgauge.check;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import org.cellgauge.cell.Target;
import org.cellgauge.estimate.VarianceSource;
import org.cellgauge.internal.warning.Decimal;
import org.cellgauge.internal.warning.Listing;
import org.cellgauge.placement.Misfit;
import org.cellgauge.placement.Misplacement;
import org.cellgauge.sampling.Quantity;
import org.cellgauge.statistics.ChainDiagnostics;
import org.jspecify.annotations.Nullable;

/**
 * Why a check ended as it did, in parts that any language can make a sentence of; immutable.
 *
 * <p>Which parts are given depends on the {@link Kind}; a part that does not belong to it is empty.
 */
public final class Reason {
    /** What a reason is about. */
    public enum Kind {
        /**
         * The largest standard deviation of any object or gripping point, and what causes most of it: all of
         * {@link #objectId()}, {@link #axis()}, {@link #stdMm()}, {@link #source()} and {@link #share()};
         * {@link #targetMm()} where there is a target.
         */
        LARGEST_DEVIATION,
        /** The chains have not converged: {@link #worstParameter()}, {@link #rHat()}, {@link #effectiveDraws()}. */
        NOT_CONVERGED,
        /** At least one chain never moved: {@link #worstParameter()}. */
        NEVER_MOVED,
        /** A chain left the finite numbers: {@link #worstParameter()}. */
        NON_FINITE,
        /** Chains of fewer than {@link ChainDiagnostics#MIN_DRAWS} draws. */
        TOO_SHORT,
        /** The references contradict each other: {@link #misfit()}. */
        CONTRADICTED,
        /** Two camera poses explain the references: {@link #share()} is the second one's. */
        TWO_CAMERA_POSES,
        /** Two poses explain the corners of {@link #objectId()}: {@link #share()} is the second one's. */
        TWO_OBJECT_POSES,
        /**
         * Objects of the cell are not in the photo: {@link #missingObjects()}. Besides, the parts of
         * {@link #LARGEST_DEVIATION} where any object is in it.
         */
        OBJECT_NOT_SEEN,
        /** No object is in the photo; {@link #targetMm()} where there is a target. */
        NO_OBJECT
    }

    private final Parts p;

    /** The parts, while they are put together. */
    private static final class Parts {
        private final Kind kind;
        private List<Integer> missingObjects = Collections.emptyList();
        private Target target = Target.NONE;
        private @Nullable Conformity conformity;
        private boolean conformityOfGrip;
        private int conformityOf;
        private OptionalInt objectId = OptionalInt.empty();
        private boolean grip;
        private OptionalInt axis = OptionalInt.empty();
        private OptionalDouble stdMm = OptionalDouble.empty();
        private @Nullable VarianceSource source;
        private OptionalDouble share = OptionalDouble.empty();
        private @Nullable Quantity worstParameter;
        private double rHat = Double.NaN;
        private double effectiveDraws = Double.NaN;
        private @Nullable Misplacement misplacement;
        private @Nullable Misfit misfit;
        private OptionalDouble undecidedMm = OptionalDouble.empty();

        Parts(Kind kind) {
            this.kind = kind;
        }

        /** The tolerance that is kept least, by its margin in Monte Carlo errors. */
        private void tell(List<JudgedObject> objects) {
            double least = Double.POSITIVE_INFINITY;
            for (JudgedObject object : objects) {
                for (JudgedPoint point : object.points()) {
                    for (Conformity c : point.conformities()) {
                        if (conformity == null || c.margin() < least) {
                            least = c.margin();
                            conformity = c;
                            conformityOf = object.id();
                            conformityOfGrip = point == object.grip();
                        }
                    }
                }
            }
        }
    }

    private Reason(Parts parts) {
        this.p = parts;
    }

    static Reason notConverged(Diagnostics diagnostics) {
        Quantity parameter = Objects.requireNonNull(diagnostics.worstParameter(),
                "chains that converged have no reason");
        ChainDiagnostics worst = diagnostics.of(parameter);
        Parts parts = new Parts(kindOf(worst.status()));
        parts.worstParameter = parameter;
        parts.rHat = worst.rHat();
        parts.effectiveDraws = Math.min(worst.essBulk(), worst.essTail());
        return new Reason(parts);
    }

    private static Kind kindOf(ChainDiagnostics.Status status) {
        switch (status) {
            case CONSTANT:
                return Kind.NEVER_MOVED;
            case NON_FINITE:
                return Kind.NON_FINITE;
            case TOO_SHORT:
                return Kind.TOO_SHORT;
            default:
                return Kind.NOT_CONVERGED;
        }
    }

    static Reason contradicted(Misfit misfit) {
        Parts parts = new Parts(Kind.CONTRADICTED);
        parts.misfit = misfit;
        return new Reason(parts);
    }

    static Reason twoCameraPoses(double secondShare) {
        Parts parts = new Parts(Kind.TWO_CAMERA_POSES);
        parts.share = OptionalDouble.of(secondShare);
        return new Reason(parts);
    }

    static Reason twoObjectPoses(int objectId, double secondShare) {
        Parts parts = new Parts(Kind.TWO_OBJECT_POSES);
        parts.objectId = OptionalInt.of(objectId);
        parts.share = OptionalDouble.of(secondShare);
        return new Reason(parts);
    }

    /**
     * The reason that looks for the largest deviation.
     *
     * @param objects the objects seen
     * @param missingObjects ids of objects that count as a failure because they are not seen; empty where none does
     * @param target what is asked of the objects
     * @param misplacement what misplaced references add, or null
     * @param misfit what of the figures' foundations the photo contradicts, or null
     * @param undecidedMm Monte Carlo error because of which the target is neither met nor missed; empty where it is
     */
    static Reason largestDeviation(List<JudgedObject> objects, List<Integer> missingObjects, Target target,
            @Nullable Misplacement misplacement, @Nullable Misfit misfit, OptionalDouble undecidedMm) {
        Kind kind = !missingObjects.isEmpty() ? Kind.OBJECT_NOT_SEEN
                : objects.isEmpty() ? Kind.NO_OBJECT : Kind.LARGEST_DEVIATION;
        Parts parts = new Parts(kind);
        parts.missingObjects = Collections.unmodifiableList(new ArrayList<>(missingObjects));
        parts.target = target;
        parts.tell(objects);
        parts.misplacement = misplacement;
        parts.misfit = misfit;
        parts.undecidedMm = undecidedMm;
        boolean limited = objects.stream().anyMatch(object -> target.of(object.id()).stdMm().isAny());
        double most = -1;
        double std = -1;
        JudgedPoint largest = null;
        for (JudgedObject object : objects) {
            for (int axis = 0; axis < 3; axis++) {
                // where limits differ, the largest is that which is most of its own
                double limit = limited ? target.of(object.id()).stdMm().of(axis) : 1;
                for (JudgedPoint point : object.points()) {
                    if (point.stdMm(axis) / limit > most) {
                        most = point.stdMm(axis) / limit;
                        parts.objectId = OptionalInt.of(object.id());
                        parts.grip = point == object.grip();
                        parts.axis = OptionalInt.of(axis);
                        std = point.stdMm(axis);
                        largest = point;
                    }
                }
            }
        }
        if (largest != null) {
            parts.stdMm = OptionalDouble.of(std);
            double share = -1;
            for (Map.Entry<VarianceSource, Double> e : largest.shares(parts.axis.getAsInt()).entrySet()) {
                if (e.getValue() > share) {
                    share = e.getValue();
                    parts.source = e.getKey();
                }
            }
            parts.share = OptionalDouble.of(share);
        }
        return new Reason(parts);
    }

    /**
     * What it is about.
     *
     * @return the kind
     */
    public Kind kind() {
        return p.kind;
    }

    /**
     * Objects of the cell that are not in the photo.
     *
     * @return marker ids, unmodifiable; empty unless that is the reason
     */
    public List<Integer> missingObjects() {
        return p.missingObjects;
    }

    /**
     * The object concerned.
     *
     * @return its marker id, or empty
     */
    public OptionalInt objectId() {
        return p.objectId;
    }

    /**
     * Whether the object's gripping point is meant and not the object.
     *
     * @return true for the gripping point
     */
    public boolean grip() {
        return p.grip;
    }

    /**
     * The world axis of the largest deviation.
     *
     * @return 0, 1, 2 for x, y, z, or empty
     */
    public OptionalInt axis() {
        return p.axis;
    }

    /**
     * The largest standard deviation.
     *
     * @return mm, or empty
     */
    public OptionalDouble stdMm() {
        return p.stdMm;
    }

    /**
     * The standard deviation that is asked for along the axis of {@link #axis()}.
     *
     * @return mm; empty where none is, and where no object was seen and objects are asked for different ones
     */
    public OptionalDouble targetMm() {
        if (!p.objectId.isPresent()) {
            return p.target.oneStdMm();
        }
        double limit = p.target.of(p.objectId.getAsInt()).stdMm().of(p.axis.getAsInt());
        return limit < Double.POSITIVE_INFINITY ? OptionalDouble.of(limit) : OptionalDouble.empty();
    }

    /**
     * Whether anything is asked of any object.
     *
     * @return false where there is no target
     */
    public boolean hasTarget() {
        return p.target.isAny();
    }

    /**
     * The tolerance that is kept least surely.
     *
     * @return null where there is none
     */
    public @Nullable Conformity conformity() {
        return p.conformity;
    }

    /**
     * The object that {@link #conformity()} is of.
     *
     * @return marker id; of no meaning where there is no tolerance
     */
    public int conformityObjectId() {
        return p.conformityOf;
    }

    /**
     * Whether {@link #conformity()} is of its gripping point.
     *
     * @return false for its position and its turn
     */
    public boolean conformityOfGrip() {
        return p.conformityOfGrip;
    }

    /**
     * What causes most of the largest deviation's variance.
     *
     * @return the source, or null where there is no deviation
     */
    public @Nullable VarianceSource source() {
        return p.source;
    }

    /**
     * Share of the variance that comes from the {@link #source()}, or of the posterior that the second pose holds.
     *
     * @return between 0 and 1, or empty
     */
    public OptionalDouble share() {
        return p.share;
    }

    /**
     * What misplaced references add to a reason about deviations.
     *
     * @return null where no reference seems misplaced, or no figure is to be trusted anyway
     */
    public @Nullable Misplacement misplacement() {
        return p.misplacement;
    }

    /**
     * What the photo contradicts of what the figures rest on.
     *
     * @return null where it contradicts nothing, or no figure is to be trusted anyway
     */
    public @Nullable Misfit misfit() {
        return p.misfit;
    }

    /**
     * Where the target lies so near to a deviation that more draws might change the verdict.
     *
     * @return the Monte Carlo error of that deviation, mm; empty where the verdict stands
     */
    public OptionalDouble undecidedMm() {
        return p.undecidedMm;
    }

    /**
     * The quantity whose chains agree least.
     *
     * @return one of the diagnostics, or null
     */
    public @Nullable Quantity worstParameter() {
        return p.worstParameter;
    }

    /**
     * R-hat of that quantity.
     *
     * @return NaN where it is undefined or not the reason
     */
    public double rHat() {
        return p.rHat;
    }

    /**
     * Effective number of draws of that quantity, the smaller of bulk and tails.
     *
     * @return NaN where it is undefined or not the reason
     */
    public double effectiveDraws() {
        return p.effectiveDraws;
    }

    /**
     * The reason in English.
     *
     * @return a sentence or two
     */
    public String english() {
        switch (p.kind) {
            case NOT_CONVERGED:
                return notConverged(String.format(Decimal.POINT, "worst: %s, R-hat %s, effective draws %s",
                        p.worstParameter, number(p.rHat, 3), number(p.effectiveDraws, 0)));
            case NEVER_MOVED:
                return notConverged(p.worstParameter + " never moved in at least one of them");
            case NON_FINITE:
                return notConverged(p.worstParameter + " became infinite or NaN");
            case TOO_SHORT:
                return notConverged("fewer than " + ChainDiagnostics.MIN_DRAWS + " draws each");
            case CONTRADICTED:
                return "No figure: " + Objects.requireNonNull(p.misfit, "contradicted by it").contradiction();
            case TWO_CAMERA_POSES:
                return String.format(Decimal.POINT,
                        "Two camera poses explain the references (the second holds %.0f %%): "
                        + "add a reference out of their plane.", 100 * p.share.getAsDouble());
            case TWO_OBJECT_POSES:
                return String.format(Decimal.POINT, "Two poses explain the corners of object %d (the second holds %.0f "
                        + "%%): use a larger marker, come closer or look at it from the side.", p.objectId.getAsInt(),
                        100 * p.share.getAsDouble());
            case OBJECT_NOT_SEEN:
                return "Object " + Listing.and(p.missingObjects) + " was not seen in the photo. " + deviation()
                        + besides();
            default:
                return (p.target.isAny() ? "" : "No target is set. ") + deviation() + besides();
        }
    }

    private static String notConverged(String why) {
        return "The chains have not converged (" + why + "): no accuracy can be read off them.";
    }

    private String besides() {
        return tolerance() + (p.undecidedMm.isPresent() ? String.format(Decimal.POINT,
                " Undecided: the target lies within twice the Monte Carlo error of a deviation (%.3f mm), so that a "
                        + "longer run might say otherwise.",
                p.undecidedMm.getAsDouble()) : "") + (p.misfit == null ? "" : p.misfit.english())
                + (p.misplacement == null ? "" : p.misplacement.english());
    }

    private String tolerance() {
        Conformity c = p.conformity;
        if (c == null) {
            return "";
        }
        String what = p.conformityOfGrip ? "the gripping point of object " + p.conformityOf
                : "object " + p.conformityOf;
        String where = c.of() == Conformity.Of.TURN ? "turned by at most " + plain(c.tolerance()) + " degrees"
                : "within " + plain(c.tolerance()) + " mm " + (c.of() == Conformity.Of.DISTANCE ? "of where it is said "
                        + "to be" : "in " + c.of().key());
        return String.format(Decimal.POINT, " Least sure tolerance: %s is %s with probability %.4f, asked for is %s, "
                + "with a guard band of twice the Monte Carlo error (%.4f)%s.", what, where, c.probability(),
                plain(c.asked()), c.mcse(), c.isDecided() ? "" : ", within which it is undecided");
    }

    private String deviation() {
        if (!p.stdMm.isPresent()) {
            return "There is nothing to judge: no object is in the photo.";
        }
        String target = targetMm().isPresent()
                ? String.format(Decimal.POINT, " against a target of %s mm", plain(targetMm().getAsDouble())) : "";
        return String.format(Decimal.POINT,
                "Largest deviation: %.2f mm in %s of %sobject %d%s; %.0f %% of this variance "
                + "comes from %s.", p.stdMm.getAsDouble(), "xyz".charAt(p.axis.getAsInt()),
                p.grip ? "the gripping point of " : "", p.objectId.getAsInt(), target, 100 * p.share.getAsDouble(),
                Objects.requireNonNull(p.source, "every deviation has a source").phrase());
    }

    private static String plain(double value) {
        return value == Math.rint(value) ? String.format(Decimal.POINT, "%.0f", value) : Double.toString(value);
    }

    private static String number(double value, int digits) {
        return Double.isNaN(value) ? "undefined" : String.format(Decimal.POINT, "%." + digits + "f", value);
    }

    @Override
    public String toString() {
        return english();
    }
}
