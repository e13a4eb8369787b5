package org.cellgauge.check;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.function.Function;
import org.cellgauge.cell.Requirement;
import org.cellgauge.check.Conformity.Of;
import org.cellgauge.sampling.Draws;
import org.cellgauge.sampling.Quantity;
import org.cellgauge.sampling.Quantity.Axis;
import org.cellgauge.sampling.QuantityLayout;
import org.cellgauge.statistics.ChainDiagnostics;
import org.jspecify.annotations.Nullable;

/** Counts the draws of an object that keep its tolerances. */
public final class Conformities {
    private static final List<Of> ALONG = List.of(Of.X, Of.Y, Of.Z);
    private static final List<Axis> TURNS = List.of(Axis.WX, Axis.WY, Axis.WZ);

    private final List<Draws> chains;
    private final QuantityLayout layout;
    private final Requirement asked;

    /**
     * A count.
     *
     * @param chains draws of all chains
     * @param layout of their quantities
     * @param asked what is tolerated
     */
    public Conformities(List<Draws> chains, QuantityLayout layout, Requirement asked) {
        this.chains = chains;
        this.layout = layout;
        this.asked = asked;
    }

    /** Whether a draw keeps a tolerance. */
    private interface Kept {
        boolean is(int chain, int draw);
    }

    /**
     * Of the position of an object and of its orientation.
     *
     * @param id marker id
     * @param errorMm by how much it is off if references are misplaced, or null
     * @return one for each tolerance; empty where none is asked for
     */
    public List<Conformity> ofPosition(int id, double @Nullable [] errorMm) {
        if (!asked.asksForProbability()) {
            return List.of();
        }
        List<Conformity> found = ofPoint(series(JudgedObject.AXES, axis -> Quantity.object(id, axis)), errorMm);
        if (asked.toleranceDeg() < Double.POSITIVE_INFINITY) {
            double limit = Math.toRadians(asked.toleranceDeg());
            // rotation vectors from one rotation near all of them: their differences are turns
            double[][][] turns = series(TURNS, axis -> Quantity.object(id, axis));
            double[] centre = means(turns);
            found.add(of(Of.TURN, asked.toleranceDeg(), (c, d) -> square(turns, centre, c, d) <= limit * limit));
        }
        return found;
    }

    /**
     * Of the gripping point of an object that has one.
     *
     * @param id marker id
     * @param errorMm by how much it is off if references are misplaced, or null
     * @return one for each tolerance; empty where none is asked for
     */
    public List<Conformity> ofGrip(int id, double @Nullable [] errorMm) {
        return asked.asksForProbability()
                ? ofPoint(series(JudgedObject.AXES, axis -> Quantity.grip(id, axis)), errorMm) : List.of();
    }

    private double[][][] series(List<Axis> axes, Function<Axis, Quantity> of) {
        return axes.stream().map(axis -> {
            int column = layout.indexOf(of.apply(axis));
            return chains.stream().map(chain -> chain.series(column)).toArray(double[][]::new);
        }).toArray(double[][][]::new);
    }

    private static double[] means(double[][][] series) {
        return Arrays.stream(series).mapToDouble(all -> Arrays.stream(all).flatMapToDouble(Arrays::stream).average()
                .orElse(Double.NaN)).toArray();
    }

    private List<Conformity> ofPoint(double[][][] series, double @Nullable [] errorMm) {
        double[] meanMm = means(series);
        List<Conformity> found = new ArrayList<>();
        // whether references are right or not, the target must hold
        double[][] shifts = errorMm == null ? new double[1][3] : new double[][] {new double[3], errorMm};
        for (int i = 0; i < 3; i++) {
            double limit = asked.toleranceMm().of(i);
            if (limit < Double.POSITIVE_INFINITY) {
                double[][] along = series[i];
                double mean = meanMm[i];
                int axis = i;
                found.add(least(shifts, shift -> of(ALONG.get(axis), limit,
                        (c, d) -> Math.abs(along[c][d] - mean) + Math.abs(shift[axis]) <= limit)));
            }
        }
        double distance = asked.distanceMm();
        if (distance < Double.POSITIVE_INFINITY) {
            found.add(least(shifts, shift -> {
                double length = Math.sqrt(shift[0] * shift[0] + shift[1] * shift[1] + shift[2] * shift[2]);
                double left = Math.max(0, distance - length);
                return of(Of.DISTANCE, distance, (c, d) -> square(series, meanMm, c, d) <= left * left);
            }));
        }
        return found;
    }

    private static double square(double[][][] series, double[] mean, int chain, int draw) {
        double sum = 0;
        for (int i = 0; i < 3; i++) {
            double d = series[i][chain][draw] - mean[i];
            sum += d * d;
        }
        return sum;
    }

    private interface Shifted {
        Conformity by(double[] shiftMm);
    }

    private static Conformity least(double[][] shifts, Shifted shifted) {
        Conformity least = shifted.by(shifts[0]);
        for (int i = 1; i < shifts.length; i++) {
            Conformity other = shifted.by(shifts[i]);
            least = other.probability() < least.probability() ? other : least;
        }
        return least;
    }

    private Conformity of(Of of, double tolerance, Kept kept) {
        double[][] indicators = new double[chains.size()][];
        long count = 0;
        long total = 0;
        for (int c = 0; c < indicators.length; c++) {
            indicators[c] = new double[chains.get(c).count()];
            for (int d = 0; d < indicators[c].length; d++) {
                if (kept.is(c, d)) {
                    indicators[c][d] = 1;
                    count++;
                }
            }
            total += indicators[c].length;
        }
        ChainDiagnostics diagnostics = ChainDiagnostics.of(indicators);
        double effective = diagnostics.status() == ChainDiagnostics.Status.OK ? diagnostics.essMean() : total;
        double probability = (double) count / total;
        // two more of each, so that draws which all keep it do not say that all ever would (Agresti and Coull 1998)
        double careful = (probability * effective + 2) / (effective + 4);
        return new Conformity(of, tolerance, probability, Math.sqrt(careful * (1 - careful) / effective),
                asked.probability());
    }
}
