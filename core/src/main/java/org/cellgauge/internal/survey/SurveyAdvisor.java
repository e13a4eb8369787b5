package org.cellgauge.internal.survey;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.function.DoubleFunction;
import org.cellgauge.cell.ChangeKind;
import org.cellgauge.cell.ObjectMarker;
import org.cellgauge.cell.Placement;
import org.cellgauge.cell.Reference;
import org.cellgauge.cell.Requirement;
import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.internal.geometry.Cholesky;
import org.cellgauge.internal.plan.Asked;
import org.cellgauge.internal.warning.Decimal;
import org.cellgauge.survey.SurveyAdvice;
import org.cellgauge.survey.SurveyWarning;
import org.cellgauge.warning.Warning;

/**
 * What would meet a target that a survey misses: more photos like those there are, one reference measured again, all of
 * them placed more precisely. Information adds up over photos and what is known beforehand, so that each is a sum made
 * anew; mode and linearisation stay.
 */
final class SurveyAdvisor {
    private static final int POSE = SurveyLayout.POSE;
    /** What proposals leave of the target. */
    private static final double MARGIN = 0.85;
    /** The most that measuring again brings, as for a plan. */
    private static final double FINEST = 0.05;
    private static final int MOST_PHOTOS = 50;
    private static final int HALVINGS = 20;

    private final SurveyFit fit;
    private final SurveyLayout layout;
    private final double[] photos;

    /**
     * An advisor.
     *
     * @param photos information that the photos together give of what they share; both triangles
     */
    SurveyAdvisor(SurveyFit fit, double[] photos) {
        this.fit = fit;
        this.photos = photos;
        layout = fit.model.layout;
    }

    /** How much of what is asked is taken at an information, and the largest deviation, mm. */
    private double[] taken(double[] information) {
        int n = layout.size;
        double[] factor = information.clone();
        if (!Cholesky.factor(factor, n)) {
            return new double[] {Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY};
        }
        double most = 0;
        double worst = 0;
        double[][] rows = new double[POSE][n];
        for (int o = 0; o < layout.objects.size(); o++) {
            ObjectMarker marker = layout.objects.get(o);
            Requirement asked = layout.cell.target().of(marker.id());
            for (int i = 0; i < POSE; i++) {
                Arrays.fill(rows[i], 0);
                rows[i][layout.firstObject + POSE * o + i] = 1;
            }
            double[] position = covariance(factor, rows[0], rows[1], rows[2]);
            double[] turn = covariance(factor, rows[3], rows[4], rows[5]);
            Asked limits = new Asked(asked);
            most = Math.max(most, asked.isAny() ? limits.ratio(position, turn) : 0);
            worst = Math.max(worst, largest(position));
            double[] grip = marker.gripMm();
            if (grip != null) {
                RigidTransform pose = SurveyState.get(fit.mode.objects, SurveyState.TRANSFORM * o);
                double[] at = pose.apply(grip);
                double[] d = {at[0] - pose.translationMm()[0], at[1] - pose.translationMm()[1],
                    at[2] - pose.translationMm()[2]};
                int first = layout.firstObject + POSE * o;
                for (int i = 0; i < 3; i++) {
                    int j = (i + 1) % 3;
                    int k = (i + 2) % 3;
                    // a turn w moves the point by w x d
                    rows[i][first + 3 + j] = d[k];
                    rows[i][first + 3 + k] = -d[j];
                }
                double[] ofGrip = covariance(factor, rows[0], rows[1], rows[2]);
                most = Math.max(most, asked.isAny() ? limits.ratio(ofGrip, null) : 0);
                worst = Math.max(worst, largest(ofGrip));
            }
        }
        return new double[] {most, worst};
    }

    private static double largest(double[] covariance) {
        return Math.sqrt(Math.max(covariance[0], Math.max(covariance[4], covariance[8])));
    }

    /** Covariance of three linear functions. */
    private double[] covariance(double[] factor, double[]... rows) {
        int n = layout.size;
        double[][] half = new double[3][];
        for (int i = 0; i < 3; i++) {
            half[i] = rows[i].clone();
            Cholesky.solveLower(factor, n, half[i]);
        }
        double[] out = new double[9];
        for (int i = 0; i < 3; i++) {
            for (int j = 0; j < 3; j++) {
                for (int k = 0; k < n; k++) {
                    out[3 * i + j] += half[i][k] * half[j][k];
                }
            }
        }
        return out;
    }

    /** Information with references placed to a share of what is stated; -1 for all of them. */
    private double[] placed(int reference, double share) {
        double[] information = fit.information.clone();
        double[] own = new double[information.length];
        for (int r = 0; r < layout.references.size(); r++) {
            if (reference >= 0 && reference != r) {
                continue;
            }
            fit.model.priorInformation(SurveyModel.Source.REFERENCE, r, own);
            for (int i = 0; i < own.length; i++) {
                information[i] += (1 / (share * share) - 1) * own[i];
            }
        }
        return information;
    }

    private double[] withPhotos(double more) {
        double[] information = fit.information.clone();
        double each = more / fit.views().size();
        for (int i = 0; i < information.length; i++) {
            information[i] += each * photos[i];
        }
        return information;
    }

    /** The cheapest first, in the order of what they usually cost. */
    List<SurveyAdvice> advice() {
        List<SurveyAdvice> out = new ArrayList<>();
        if (!layout.cell.target().isAny() || layout.objects.isEmpty() || !(taken(fit.information)[0] > 1)) {
            return out;
        }
        for (int more = 1; more <= MOST_PHOTOS; more++) {
            double[] found = taken(withPhotos(more));
            if (found[0] <= MARGIN) {
                out.add(new SurveyAdvice(Warning.of(SurveyWarning.MORE_PHOTOS, more), found[1]));
                break;
            }
        }
        if (layout.cell.joint().surveyed() != null) {
            return out;
        }
        int best = -1;
        double least = MARGIN;
        for (int r = 0; r < layout.references.size(); r++) {
            double ratio = taken(placed(r, FINEST))[0];
            if (ratio <= least) {
                best = r;
                least = ratio;
            }
        }
        if (best >= 0) {
            int r = best;
            double share = coarsest(s -> placed(r, s));
            Reference reference = layout.references.get(r);
            out.add(new SurveyAdvice(Warning.of(ChangeKind.MEASURE_REFERENCE, reference.id(),
                    std(reference.placement(), share), turn(reference.placement(), share)),
                    taken(placed(r, share))[1]));
        }
        if (taken(placed(-1, FINEST))[0] <= MARGIN) {
            double share = coarsest(s -> placed(-1, s));
            Placement placement = layout.references.get(0).placement();
            out.add(new SurveyAdvice(Warning.of(ChangeKind.PLACE_PRECISELY, std(placement, share),
                    turn(placement, share)), taken(placed(-1, share))[1]));
        }
        return out;
    }

    private static Decimal std(Placement placement, double share) {
        return Decimal.of(share * Math.max(placement.stdMm(0), Math.max(placement.stdMm(1), placement.stdMm(2))), 2);
    }

    private static Decimal turn(Placement placement, double share) {
        return Decimal.of(share * Math.toDegrees(placement.stdRad()), 3);
    }

    /** The largest share of what is stated that still meets the target with its margin. */
    private double coarsest(DoubleFunction<double[]> information) {
        double fine = FINEST;
        double coarse = 1;
        for (int k = 0; k < HALVINGS; k++) {
            double middle = Math.sqrt(fine * coarse);
            if (taken(information.apply(middle))[0] <= MARGIN) {
                fine = middle;
            } else {
                coarse = middle;
            }
        }
        return fine;
    }
}
