package org.cellgauge.internal.survey;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.cellgauge.cell.Measurement;
import org.cellgauge.cell.ObjectMarker;
import org.cellgauge.cell.Placement;
import org.cellgauge.cell.Reference;
import org.cellgauge.cell.Requirement;
import org.cellgauge.cell.SurveyedPlacement;
import org.cellgauge.check.Conformities;
import org.cellgauge.check.Conformity;
import org.cellgauge.estimate.PointEstimate;
import org.cellgauge.estimate.PoseEstimate;
import org.cellgauge.estimate.VarianceSource;
import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.internal.geometry.Cholesky;
import org.cellgauge.internal.laplace.LinearModel;
import org.cellgauge.internal.statistics.ChiSquare;
import org.cellgauge.internal.warning.Decimal;
import org.cellgauge.internal.warning.Listing;
import org.cellgauge.sampling.Draws;
import org.cellgauge.sampling.Quantity;
import org.cellgauge.sampling.QuantityLayout;
import org.cellgauge.settings.SamplingSettings;
import org.cellgauge.survey.Drift;
import org.cellgauge.survey.Epoch;
import org.cellgauge.survey.SurveyResult;
import org.cellgauge.survey.SurveyRun;
import org.cellgauge.survey.SurveyWarning;
import org.cellgauge.survey.SurveyedMeasurement;
import org.cellgauge.survey.SurveyedObject;
import org.cellgauge.survey.SurveyedPhoto;
import org.cellgauge.survey.SurveyedReference;
import org.cellgauge.warning.Warning;
import org.jspecify.annotations.Nullable;

/** What the mode of a survey says: what does not fit, where variance comes from, what more photos would bring. */
final class SurveyAnalysis {
    private static final int POSE = SurveyLayout.POSE;
    /** Chance that anything of one kind (references, photos, measurements) is named although nothing is wrong. */
    private static final double LEVEL = 0.0025;
    /** Factor of the deviations of a reference that does not stand as stated. */
    private static final double UNTRUSTED = 100;
    /** A deviation from which on nothing tells of an object, mm. */
    private static final double UNKNOWN_MM = 1e4;
    /** Information of what nothing tells of, as a share of what is told in the end. */
    private static final double NEXT_TO_NOTHING = 1e-12;
    /** Cost by which one pose must be better than another for it to count alone. */
    private static final double AMBIGUOUS = 7;
    private static final double NOTEWORTHY = 0.1;
    private static final int FIRST_DRAWS = 1000;
    private static final List<Quantity.Axis> AXES = List.of(Quantity.Axis.X, Quantity.Axis.Y, Quantity.Axis.Z,
            Quantity.Axis.WX, Quantity.Axis.WY, Quantity.Axis.WZ);

    final SurveyProgress progress;
    final SurveyFit fit;
    private final SurveyLayout layout;
    private final boolean[] misplaced;
    private final double[] referenceChance;
    private final double[] photoChance;
    /** Factor of chi-square by which corners are noisier than stated; 1 where somebody states their noise. */
    private double noise = 1;

    private SurveyAnalysis(SurveyProgress progress, SurveyFit fit, boolean[] misplaced, double[] referenceChance) {
        this.progress = progress;
        this.fit = fit;
        this.misplaced = misplaced;
        this.referenceChance = referenceChance;
        layout = fit.model.layout;
        photoChance = photoChances();
    }

    /**
     * Tests references one after another: the one that is off most is not trusted any more, and the others are tested
     * without what it said.
     */
    static SurveyAnalysis of(SurveyProgress progress) {
        SurveyFit fit = Objects.requireNonNull(progress.fit, "there is a mode");
        int n = fit.model.layout.references.size();
        boolean[] misplaced = new boolean[n];
        double[] named = new double[n];
        double[] chance = chances(fit);
        double[] trust = new double[n];
        Arrays.fill(trust, 1);
        for (int found = 0; found < (n - 1) / 2; found++) {
            int worst = -1;
            for (int r = 0; r < n; r++) {
                if (!misplaced[r] && chance[r] < LEVEL / n && (worst < 0 || chance[r] < chance[worst])) {
                    worst = r;
                }
            }
            if (worst < 0) {
                break;
            }
            trust[worst] = UNTRUSTED;
            SurveyModel model = new SurveyModel(fit.model.layout, fit.views(), trust.clone());
            SurveyState start = new SurveyState(fit.model.layout, fit.views());
            start.copyFrom(fit.mode);
            SurveyFit freed = SurveyFit.of(model, start);
            if (freed == null) {
                break;
            }
            misplaced[worst] = true;
            named[worst] = chance[worst];
            fit = freed;
            chance = chances(fit);
        }
        for (int r = 0; r < n; r++) {
            chance[r] = misplaced[r] ? named[r] : chance[r];
        }
        return new SurveyAnalysis(progress, fit, misplaced, chance);
    }

    /** Chance of every reference's error, given what was stated of it. */
    private static double[] chances(SurveyFit fit) {
        SurveyLayout layout = fit.model.layout;
        int n = layout.size;
        double[] out = new double[layout.references.size()];
        for (int r = 0; r < out.length; r++) {
            Placement placement = layout.references.get(r).placement();
            double[] residuals = new double[POSE];
            double[] explained = new double[POSE * POSE];
            double[] std = new double[POSE];
            for (int i = 0; i < POSE; i++) {
                std[i] = Math.max(i < 3 ? placement.stdMm(i) : placement.stdRad(), 1e-9);
                residuals[i] = fit.mode.values[POSE * r + i] / std[i];
            }
            for (int i = 0; i < POSE; i++) {
                for (int j = 0; j < POSE; j++) {
                    explained[i * POSE + j] = fit.covariance[(POSE * r + i) * n + POSE * r + j] / (std[i] * std[j]);
                }
            }
            out[r] = Conflict.of(residuals, explained).chance();
        }
        return out;
    }

    // ---- photos

    /** What one photo says of all that photos share: information and gradient at the mode, both triangles. */
    private double view(int v, double[] information, double[] gradient) {
        int n = layout.size;
        Arrays.fill(information, 0);
        Arrays.fill(gradient, 0);
        ViewEquations own = new ViewEquations(fit.views().get(v).locals(), n);
        double cost = fit.model.lineariseView(fit.mode, v, own, information, gradient);
        SurveyAdjustment.mirror(information, n);
        for (double g : own.ownGradient) {
            cost -= 0.5 * g * g;
        }
        return cost;
    }

    /**
     * Chance of every photo given the others: twice what the fit's cost falls by where the photo is left out is
     * chi-square with as many degrees as it has coordinates less its own unknowns of which nothing is known beforehand.
     */
    private double[] photoChances() {
        int n = layout.size;
        int count = fit.views().size();
        double[] out = new double[count];
        Arrays.fill(out, Double.NaN);
        if (count < 2) {
            return out;
        }
        fit.model.linearisePriors(fit.mode, new double[n * n], new double[n]);
        double[] information = new double[n * n];
        double[] gradient = new double[n];
        double[] chiSquare = new double[count];
        int[] degrees = new int[count];
        double[] ratios = new double[count];
        for (int v = 0; v < count; v++) {
            double cost = view(v, information, gradient);
            double[] others = new double[n * n];
            for (int i = 0; i < n * n; i++) {
                others[i] = fit.information[i] - information[i];
            }
            for (int i = 0; i < n; i++) {
                others[i * (n + 1)] += NEXT_TO_NOTHING * fit.information[i * (n + 1)];
            }
            double[] by = gradient.clone();
            if (!Cholesky.factor(others, n)) {
                continue;
            }
            Cholesky.solveLower(others, n, by);
            double squares = 0;
            for (double b : by) {
                squares += b * b;
            }
            chiSquare[v] = 2 * cost + squares;
            degrees[v] = degrees(v);
            ratios[v] = degrees[v] > 0 ? chiSquare[v] / degrees[v] : 1;
        }
        // where nobody states the corners' noise, all photos may be somewhat noisier than squareness tells
        if (layout.cell.pixelStdPx().isEmpty()) {
            double[] sorted = ratios.clone();
            Arrays.sort(sorted);
            noise = Math.max(1, sorted[count / 2]);
        }
        for (int v = 0; v < count; v++) {
            out[v] = ChiSquare.pValue(chiSquare[v] / noise, degrees[v]);
        }
        return out;
    }

    private int degrees(int v) {
        SurveyView view = fit.views().get(v);
        int degrees = 8 * view.size() - POSE * (1 + view.moving.size());
        for (int id : view.ids) {
            boolean elsewhere = false;
            for (SurveyView other : fit.views()) {
                elsewhere |= other != view && Arrays.stream(other.ids).anyMatch(i -> i == id);
            }
            degrees -= layout.object(id) >= 0 && !elsewhere ? POSE : 0;
        }
        return Math.max(0, degrees);
    }

    /** Index of the photo that fits least, among those that do not fit; -1 where all do. */
    int worstMisfit() {
        int worst = -1;
        for (int v = 0; v < photoChance.length; v++) {
            if (photoChance[v] < LEVEL / photoChance.length && (worst < 0 || photoChance[v] < photoChance[worst])) {
                worst = v;
            }
        }
        return worst;
    }

    /** What is said of a photo that does not fit. */
    Warning misfit(int v) {
        SurveyView view = fit.views().get(v);
        int worst = 0;
        double most = -1;
        for (int m = 0; m < view.size(); m++) {
            double off = fit.model.markerChiSquare(fit.mode, v, m);
            if (off > most) {
                most = off;
                worst = m;
            }
        }
        return Warning.of(SurveyWarning.PHOTO_DOES_NOT_FIT, view.detections.imageName(),
                Decimal.of(100 * photoChance[v], 4), view.ids[worst]);
    }

    // ---- measurements

    private List<SurveyedMeasurement> measurements() {
        List<SurveyedMeasurement> out = new ArrayList<>();
        SharedMeasurements.Rows rows = fit.model.measurementRows(fit.mode);
        for (int k = 0; k < layout.measurements.size(); k++) {
            int which = k;
            int[] of = IntStream.range(0, rows.residuals.length).filter(r -> rows.measurements[r] == which)
                    .toArray();
            double[] flat = new double[of.length * layout.size];
            double[] residuals = new double[of.length];
            for (int i = 0; i < of.length; i++) {
                residuals[i] = rows.residuals[of[i]];
                System.arraycopy(rows.rows[of[i]], 0, flat, i * layout.size, layout.size);
            }
            Conflict conflict = Conflict.of(residuals, fit.sandwich(flat, of.length));
            out.add(new SurveyedMeasurement(layout.measurements.get(k), Math.sqrt(conflict.chiSquare()),
                    conflict.chance()));
        }
        return out;
    }

    static String words(Measurement m) {
        if (m instanceof Measurement.Distance d) {
            return "distance between " + d.from() + " and " + d.to();
        }
        if (m instanceof Measurement.Height h) {
            return "height of " + h.above() + " above " + h.below();
        }
        if (m instanceof Measurement.Touched t) {
            return "touched " + t.id();
        }
        return "plane of " + m.members();
    }

    // ---- objects

    /** Shares of the variance of an object's position, by source. */
    private Map<String, Double> shares(int object) {
        int n = layout.size;
        double[] part = new double[n * n];
        double total = 0;
        double[][] z = new double[3][n];
        for (int axis = 0; axis < 3; axis++) {
            int row = layout.firstObject + POSE * object + axis;
            System.arraycopy(fit.covariance, row * n, z[axis], 0, n);
            total += z[axis][row];
        }
        Map<String, Double> shares = new LinkedHashMap<>();
        boolean surveyed = layout.cell.joint().surveyed() != null;
        if (surveyed) {
            fit.model.priorInformation(SurveyModel.Source.SURVEY, 0, part);
            shares.put("earlier survey", quadratic(part, z) / total);
        }
        for (int r = 0; r < layout.references.size() && !surveyed; r++) {
            fit.model.priorInformation(SurveyModel.Source.REFERENCE, r, part);
            shares.put(VarianceSource.placementOf(layout.references.get(r).id()).key(), quadratic(part, z) / total);
        }
        for (int g = 0; g < layout.groups.size(); g++) {
            fit.model.priorInformation(SurveyModel.Source.GROUP, g, part);
            shares.put("placement of group " + layout.groups.get(g).name(), quadratic(part, z) / total);
        }
        if (!layout.measurements.isEmpty()) {
            fit.model.measurementRows(fit.mode);
            fit.model.priorInformation(SurveyModel.Source.MEASUREMENTS, 0, part);
            shares.put("measurements", quadratic(part, z) / total);
        }
        if (layout.intrinsics.count() > 0) {
            fit.model.priorInformation(SurveyModel.Source.CALIBRATION, 0, part);
            shares.put(VarianceSource.CALIBRATION.key(), quadratic(part, z) / total);
        }
        if (!layout.sizesMm.isEmpty()) {
            fit.model.priorInformation(SurveyModel.Source.SIZES, 0, part);
            shares.put(VarianceSource.SIZE_OF_PRINTS.key(), quadratic(part, z) / total);
        }
        double edges = 0;
        boolean any = false;
        double[] work = new double[Math.max(1, fit.mostLocals())];
        double[] zero = new double[work.length];
        double[] own = new double[work.length];
        for (int v = 0; v < fit.own.length; v++) {
            int count = fit.views().get(v).edges;
            any |= count > 0;
            for (int axis = 0; axis < 3 && count > 0; axis++) {
                fit.own[v].follow(z[axis], false, zero, 0, own, 0, work);
                for (int j = 0; j < count; j++) {
                    edges += own[POSE + j] * own[POSE + j];
                }
            }
        }
        if (any) {
            shares.put(VarianceSource.EDGES.key(), edges / total);
        }
        double sum = shares.values().stream().mapToDouble(Double::doubleValue).sum();
        shares.put("corner noise", Math.max(0, 1 - sum));
        return shares;
    }

    private static double quadratic(double[] a, double[][] z) {
        int n = z[0].length;
        double sum = 0;
        for (int i = 0; i < n; i++) {
            for (int j = 0; j < n; j++) {
                double p = a[i * n + j];
                if (p != 0) {
                    for (double[] one : z) {
                        sum += p * one[i] * one[j];
                    }
                }
            }
        }
        return sum;
    }

    /** Largest deviation of every object's position after each number of photos; last if one more came. */
    private double[][] curve() {
        int n = layout.size;
        int count = fit.views().size();
        double[] sum = new double[n * n];
        double[] gradient = new double[n];
        fit.model.linearisePriors(fit.mode, sum, gradient);
        double[] priors = sum.clone();
        double[] one = new double[n * n];
        double[][] out = new double[layout.objects.size()][count + 1];
        for (int v = 0; v <= count; v++) {
            if (v < count) {
                view(v, one, gradient);
                for (int i = 0; i < n * n; i++) {
                    sum[i] += one[i];
                }
            } else {
                for (int i = 0; i < n * n; i++) {
                    sum[i] += (sum[i] - priors[i]) / count;
                }
            }
            double[] ridged = sum.clone();
            for (int i = 0; i < n; i++) {
                ridged[i * (n + 1)] += NEXT_TO_NOTHING * fit.information[i * (n + 1)];
            }
            boolean solved = Cholesky.factor(ridged, n);
            double[] unit = new double[n];
            for (int o = 0; o < out.length; o++) {
                double worst = 0;
                for (int axis = 0; axis < 3 && solved; axis++) {
                    Arrays.fill(unit, 0);
                    unit[layout.firstObject + POSE * o + axis] = 1;
                    Cholesky.solveLower(ridged, n, unit);
                    worst = Math.max(worst, Math.sqrt(Arrays.stream(unit).map(x -> x * x).sum()));
                }
                out[o][v] = solved && worst < UNKNOWN_MM ? worst : Double.NaN;
            }
        }
        return out;
    }

    /** Whether the mirrored pose of an object explains the photos about as well. */
    private boolean ambiguous(int object) {
        ObjectMarker marker = layout.objects.get(object);
        int at = SurveyState.TRANSFORM * object;
        RigidTransform here = SurveyState.get(fit.mode.objects, at);
        int seen = 0;
        RigidTransform other = null;
        for (int v = 0; v < fit.views().size(); v++) {
            SurveyView view = fit.views().get(v);
            for (int m = 0; m < view.size(); m++) {
                if (view.ids[m] == marker.id()) {
                    seen++;
                    for (RigidTransform alone : view.posesAlone(m)) {
                        RigidTransform world = fit.worldFromCamera(v).compose(alone);
                        boolean far = world.angleRadTo(here) > 0.1;
                        other = far && (other == null || world.angleRadTo(here) > other.angleRadTo(here)) ? world
                                : other;
                    }
                }
            }
        }
        // many photos from different sides leave no second pose
        if (seen > 3 || other == null) {
            return false;
        }
        SurveyState start = new SurveyState(layout, fit.views());
        start.copyFrom(fit.mode);
        SurveyState.set(start.objects, at, other);
        double cost = new SurveyAdjustment(fit.model, start).solve();
        return cost < fit.cost + AMBIGUOUS && SurveyState.get(start.objects, at).angleRadTo(here) > 0.02;
    }

    // ---- the result

    SurveyResult result(boolean sampled) {
        int n = layout.size;
        double[] covariance = fit.covariance;
        double[] mean = new double[n];
        SurveyRun run = null;
        SurveyDraws drawn = null;
        double farthest = 0;
        if (sampled) {
            SurveyDraws draws = draws();
            drawn = draws;
            int known = layout.firstPlane;
            covariance = fit.covariance.clone();
            double[] ofDraws = draws.covariance();
            System.arraycopy(draws.mean(), 0, mean, 0, known);
            for (int i = 0; i < known; i++) {
                System.arraycopy(ofDraws, i * known, covariance, i * n, known);
            }
            double ratio = 1;
            for (int i = 0; i < layout.firstIntrinsic; i++) {
                double r = Math.sqrt(covariance[i * (n + 1)] / fit.covariance[i * (n + 1)]);
                ratio = Math.abs(Math.log(r)) > Math.abs(Math.log(ratio)) ? r : ratio;
            }
            farthest = Math.exp(Math.abs(Math.log(ratio))) - 1;
            run = new SurveyRun(draws.convergence(), draws.worstRHat(), draws.leastBulk(), draws.leastTail(),
                    progress.settings.sampling().chains(), draws.draws(), draws.evaluations(), draws.acceptance(),
                    ratio);
        }
        SurveyState at = new SurveyState(layout, fit.views());
        at.copyFrom(fit.mode);
        at.moveShared(fit.mode, mean);
        List<SurveyedReference> references = references(at, covariance);
        List<SurveyedObject> objects = objects(at, covariance, drawn);
        List<SurveyedMeasurement> measurements = measurements();
        return new SurveyResult(progress.cell, photos(), references, objects, measurements, placement(covariance),
                DriftTest.epoch(fit), new SurveyAdvisor(fit, ofPhotos()).advice(), run,
                warnings(references, objects, measurements, farthest));
    }

    /** Information of all photos of what they share; both triangles. */
    private double[] ofPhotos() {
        int n = layout.size;
        double[] gradient = new double[n];
        double[] one = new double[n * n];
        double[] sum = new double[n * n];
        fit.model.linearisePriors(fit.mode, new double[n * n], gradient);
        for (int v = 0; v < fit.views().size(); v++) {
            view(v, one, gradient);
            for (int i = 0; i < n * n; i++) {
                sum[i] += one[i];
            }
        }
        return sum;
    }

    /** What has moved since an earlier survey. */
    Drift against(Epoch earlier, boolean cameraStands) {
        return DriftTest.of(fit, earlier, noise, cameraStands);
    }

    private SurveyDraws draws() {
        SamplingSettings sampling = progress.settings.sampling();
        int atMost = sampling.iterations().orElse(sampling.maxIterations());
        int[] quantities = IntStream.range(0, layout.firstPlane).toArray();
        return SurveyDraws.of(fit, quantities, sampling.chains(), sampling.seed(), sampling.threads(),
                sampling.iterations().orElse(FIRST_DRAWS), atMost);
    }

    private double[] referenceRows() {
        int n = layout.size;
        int count = layout.references.size();
        fit.model.measurementRows(fit.mode);
        double[] rows = new double[POSE * count * n];
        double[] one = new double[POSE * n];
        for (int r = 0; r < count; r++) {
            fit.model.referenceRows(r, one);
            System.arraycopy(one, 0, rows, r * one.length, one.length);
        }
        return rows;
    }

    private SurveyedPlacement placement(double[] covariance) {
        double[] joint = SurveyFit.sandwich(referenceRows(), POSE * layout.references.size(), covariance, layout.size);
        int n = POSE * layout.references.size();
        for (int i = 0; i < n; i++) {
            for (int j = 0; j < i; j++) {
                joint[i * n + j] = joint[j * n + i];
            }
        }
        return new SurveyedPlacement(layout.references.stream().map(Reference::id).collect(Collectors.toList()), joint);
    }

    private List<SurveyedReference> references(SurveyState at, double[] covariance) {
        double[] rows = referenceRows();
        int n = layout.size;
        List<SurveyedReference> out = new ArrayList<>();
        for (int r = 0; r < layout.references.size(); r++) {
            Reference stated = layout.references.get(r);
            RigidTransform pose = fit.model.worldFromReference(at, r);
            double[] one = Arrays.copyOfRange(rows, r * POSE * n, (r + 1) * POSE * n);
            double[][] tangent = SurveyFit.square(SurveyFit.sandwich(one, POSE, covariance, n), POSE);
            double[] p = pose.translationMm();
            double[] s = stated.worldFromMarker().translationMm();
            double off = Math.sqrt((p[0] - s[0]) * (p[0] - s[0]) + (p[1] - s[1]) * (p[1] - s[1])
                    + (p[2] - s[2]) * (p[2] - s[2]));
            out.add(new SurveyedReference(stated, LinearModel.pose("reference in world", pose, tangent),
                    seen(stated.id()), off, referenceChance[r], misplaced[r]));
        }
        return out;
    }

    private int seen(int id) {
        int count = 0;
        for (SurveyView view : fit.views()) {
            count += Arrays.stream(view.ids).anyMatch(i -> i == id) ? 1 : 0;
        }
        return count;
    }

    private List<SurveyedObject> objects(SurveyState at, double[] covariance, @Nullable SurveyDraws drawn) {
        int n = layout.size;
        double[][] curve = curve();
        List<SurveyedObject> out = new ArrayList<>();
        for (int o = 0; o < layout.objects.size(); o++) {
            ObjectMarker marker = layout.objects.get(o);
            RigidTransform pose = SurveyState.get(at.objects, SurveyState.TRANSFORM * o);
            int first = layout.firstObject + POSE * o;
            double[][] tangent = new double[POSE][POSE];
            for (int i = 0; i < POSE; i++) {
                System.arraycopy(covariance, (first + i) * n + first, tangent[i], 0, POSE);
            }
            List<Double> byPhotos = new ArrayList<>();
            for (int v = 0; v + 1 < curve[o].length; v++) {
                byPhotos.add(curve[o][v]);
            }
            out.add(new SurveyedObject(marker, LinearModel.pose("object in world", pose, tangent),
                    grip(marker, pose, tangent), seen(marker.id()), shares(o), byPhotos,
                    curve[o][curve[o].length - 1],
                    drawn == null ? List.of() : conformities(o, drawn), ambiguous(o)));
        }
        return out;
    }

    /** How many draws keep what is tolerated of an object. */
    private List<Conformity> conformities(int object, SurveyDraws drawn) {
        ObjectMarker marker = layout.objects.get(object);
        Requirement asked = progress.cell.target().of(marker.id());
        if (!asked.asksForProbability()) {
            return List.of();
        }
        QuantityLayout.Builder quantities = new QuantityLayout.Builder();
        for (Quantity.Axis axis : AXES) {
            quantities.add(Quantity.object(marker.id(), axis));
        }
        double[] grip = marker.gripMm();
        for (int i = 0; i < 3 && grip != null; i++) {
            quantities.add(Quantity.grip(marker.id(), AXES.get(i)));
        }
        QuantityLayout of = quantities.build();
        RigidTransform mode = SurveyState.get(fit.mode.objects, SurveyState.TRANSFORM * object);
        double[] place = mode.translationMm();
        List<Draws> chains = new ArrayList<>();
        for (int c = 0; c < drawn.chains(); c++) {
            Draws chain = new Draws(of);
            double[] values = new double[of.size()];
            for (int d = 0; d < drawn.draws(); d++) {
                for (int i = 0; i < POSE; i++) {
                    double step = drawn.value(c, layout.firstObject + POSE * object + i, d);
                    values[i] = i < 3 ? place[i] + step : step;
                }
                if (grip != null) {
                    double[] at = mode.displaced(new double[] {values[0] - place[0], values[1] - place[1],
                        values[2] - place[2]}, new double[] {values[3], values[4], values[5]}).apply(grip);
                    System.arraycopy(at, 0, values, POSE, 3);
                }
                chain.add(values);
            }
            chains.add(chain);
        }
        Conformities count = new Conformities(chains, of, asked);
        List<Conformity> out = new ArrayList<>(count.ofPosition(marker.id(), null));
        if (grip != null) {
            out.addAll(count.ofGrip(marker.id(), null));
        }
        return out;
    }

    private static @Nullable PointEstimate grip(ObjectMarker marker, RigidTransform pose, double[][] tangent) {
        double[] grip = marker.gripMm();
        if (grip == null) {
            return null;
        }
        double[] at = pose.apply(grip);
        double[] t = pose.translationMm();
        double[] d = {at[0] - t[0], at[1] - t[1], at[2] - t[2]};
        double[] rows = {1, 0, 0, 0, d[2], -d[1], 0, 1, 0, -d[2], 0, d[0], 0, 0, 1, d[1], -d[0], 0};
        double[] flat = new double[POSE * POSE];
        for (int i = 0; i < POSE; i++) {
            System.arraycopy(tangent[i], 0, flat, POSE * i, POSE);
        }
        return new PointEstimate(at, SurveyFit.square(SurveyFit.sandwich(rows, 3, flat, POSE), 3));
    }

    private List<SurveyedPhoto> photos() {
        List<SurveyedPhoto> out = new ArrayList<>();
        for (SurveyProgress.Entry entry : progress.entries) {
            int v = entry.view() == null ? -1 : fit.views().indexOf(entry.view());
            PoseEstimate camera = v < 0 ? null
                    : LinearModel.pose("camera in world", fit.worldFromCamera(v), fit.cameraCovariance(v));
            out.add(new SurveyedPhoto(entry.detections().imageName(), v >= 0, camera,
                    entry.view() == null ? 0 : entry.view().size(), v < 0 ? Double.NaN : photoChance[v]));
        }
        return out;
    }

    private List<Warning> warnings(List<SurveyedReference> references, List<SurveyedObject> objects,
            List<SurveyedMeasurement> measurements, double farthest) {
        List<Warning> out = new ArrayList<>();
        progress.entries.forEach(e -> {
            if (e.why() != null) {
                out.add(e.why());
            }
        });
        if (fit.views().size() == 1) {
            out.add(Warning.of(SurveyWarning.ONE_PHOTO));
        }
        for (int v = 0; v < photoChance.length; v++) {
            if (photoChance[v] < LEVEL / photoChance.length) {
                out.add(misfit(v));
            }
        }
        for (SurveyedReference r : references) {
            if (r.misplaced()) {
                out.add(Warning.of(SurveyWarning.REFERENCE_OFF, r.stated().id(), Decimal.of(r.offMm(), 1),
                        Decimal.of(100 * r.chance(), 4)));
            }
        }
        for (int k = 0; k < measurements.size(); k++) {
            SurveyedMeasurement m = measurements.get(k);
            if (m.chance() < LEVEL / measurements.size()) {
                out.add(Warning.of(SurveyWarning.MEASUREMENT_OFF, k + 1, words(m.measurement()),
                        Decimal.of(m.deviations(), 1), Decimal.of(100 * m.chance(), 4)));
            }
        }
        List<Integer> unseen = new ArrayList<>();
        progress.cell.objects().forEach(o -> {
            if (seen(o.id()) == 0) {
                unseen.add(o.id());
            }
        });
        if (!unseen.isEmpty()) {
            out.add(Warning.of(SurveyWarning.OBJECTS_NOT_SEEN, Listing.and(unseen)));
        }
        List<Integer> hidden = new ArrayList<>();
        references.forEach(r -> {
            if (r.photos() == 0) {
                hidden.add(r.stated().id());
            }
        });
        if (!hidden.isEmpty()) {
            out.add(Warning.of(SurveyWarning.REFERENCES_NOT_SEEN, Listing.and(hidden)));
        }
        objects.forEach(o -> {
            if (o.ambiguous()) {
                out.add(Warning.of(SurveyWarning.AMBIGUOUS, o.marker().id()));
            }
        });
        if (farthest > NOTEWORTHY) {
            out.add(Warning.of(SurveyWarning.FAR_FROM_GAUSSIAN, Decimal.of(100 * farthest, 0)));
        }
        return out;
    }
}
