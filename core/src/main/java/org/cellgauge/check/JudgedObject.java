package org.cellgauge.check;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import org.cellgauge.estimate.ObjectEstimate;
import org.cellgauge.estimate.VarianceBudget;
import org.cellgauge.estimate.VarianceSource;
import org.cellgauge.placement.WithoutMisplaced;
import org.cellgauge.sampling.Quantity;
import org.cellgauge.sampling.Quantity.Axis;
import org.cellgauge.statistics.ChainDiagnostics;
import org.jspecify.annotations.Nullable;

/** What a target is held against of one object: its position, and its gripping point where it has one; immutable. */
public final class JudgedObject {
    static final List<Axis> AXES = Collections.unmodifiableList(Arrays.asList(Axis.X, Axis.Y, Axis.Z));

    private final int id;
    private final JudgedPoint position;
    private final @Nullable JudgedPoint grip;

    /**
     * An object.
     *
     * @param id marker id
     * @param position its position
     * @param grip its gripping point, or null
     */
    public JudgedObject(int id, JudgedPoint position, @Nullable JudgedPoint grip) {
        this.id = id;
        this.position = position;
        this.grip = grip;
    }

    /** An object of which nothing was sampled, and whose references are not questioned. */
    static JudgedObject of(ObjectEstimate object) {
        double[] none = new double[3];
        Arrays.fill(none, Double.NaN);
        return new JudgedObject(object.id(),
                new JudgedPoint(object.pose().std(), none, none, null, shares(object.budget()),
                        Collections.emptyList()),
                object.grip() == null ? null
                        : new JudgedPoint(object.grip().stdMm(), none, none, null,
                                shares(Objects.requireNonNull(object.gripBudget(), "of its grip")),
                                Collections.emptyList()));
    }

    /** An object as the chains have it. */
    static JudgedObject of(ObjectEstimate object, Diagnostics diagnostics, @Nullable WithoutMisplaced without,
            Conformities conformities) {
        int id = object.id();
        WithoutMisplaced.ObjectWithout moved = without == null ? null : without.object(id);
        Quantity[] position = new Quantity[AXES.size()];
        Quantity[] grip = new Quantity[AXES.size()];
        for (int i = 0; i < AXES.size(); i++) {
            position[i] = Quantity.object(id, AXES.get(i));
            grip[i] = Quantity.grip(id, AXES.get(i));
        }
        double @Nullable [] errorMm = moved == null ? null : moved.errorMm();
        double @Nullable [] gripErrorMm = moved == null ? null : moved.gripErrorMm();
        return new JudgedObject(id,
                point(object.pose().std(), diagnostics, position, errorMm, object.budget(),
                        conformities.ofPosition(id, errorMm)),
                object.grip() == null ? null : point(object.grip().stdMm(), diagnostics, grip, gripErrorMm,
                        Objects.requireNonNull(object.gripBudget(), "of its grip"),
                        conformities.ofGrip(id, gripErrorMm)));
    }

    private static JudgedPoint point(double[] std, Diagnostics diagnostics, Quantity[] quantities,
            double @Nullable [] errorMm, VarianceBudget budget, List<Conformity> conformities) {
        double[] sampled = new double[quantities.length];
        double[] mcse = new double[quantities.length];
        for (int i = 0; i < quantities.length; i++) {
            ChainDiagnostics d = diagnostics.of(quantities[i]);
            sampled[i] = d.std();
            mcse[i] = d.mcseSd();
        }
        return new JudgedPoint(Arrays.copyOf(std, 3), sampled, mcse, errorMm, shares(budget), conformities);
    }

    private static List<Map<VarianceSource, Double>> shares(VarianceBudget budget) {
        List<Map<VarianceSource, Double>> shares = new ArrayList<>();
        for (int axis = 0; axis < 3; axis++) {
            shares.add(budget.shares(axis));
        }
        return shares;
    }

    /**
     * The object.
     *
     * @return marker id
     */
    public int id() {
        return id;
    }

    /**
     * Its position.
     *
     * @return never null
     */
    public JudgedPoint position() {
        return position;
    }

    /**
     * Its gripping point.
     *
     * @return null where it has none
     */
    public @Nullable JudgedPoint grip() {
        return grip;
    }

    /** Its position, and its gripping point where it has one. */
    List<JudgedPoint> points() {
        return grip == null ? Collections.singletonList(position) : Arrays.asList(position, grip);
    }

    /** The largest error of position and gripping point if references are misplaced, mm. */
    double largestErrorMm() {
        return grip == null ? position.largestErrorMm() : Math.max(position.largestErrorMm(), grip.largestErrorMm());
    }
}
