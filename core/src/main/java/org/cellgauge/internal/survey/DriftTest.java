package org.cellgauge.internal.survey;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.apache.commons.math3.distribution.ChiSquaredDistribution;
import org.apache.commons.math3.linear.Array2DRowRealMatrix;
import org.apache.commons.math3.linear.ArrayRealVector;
import org.apache.commons.math3.linear.EigenDecomposition;
import org.apache.commons.math3.linear.LUDecomposition;
import org.apache.commons.math3.linear.MatrixUtils;
import org.apache.commons.math3.linear.RealMatrix;
import org.apache.commons.math3.linear.RealVector;
import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.internal.geometry.Cholesky;
import org.cellgauge.internal.geometry.Rotations;
import org.cellgauge.internal.statistics.ChiSquare;
import org.cellgauge.survey.Drift;
import org.cellgauge.survey.Epoch;
import org.jspecify.annotations.Nullable;

/**
 * Has anything moved between two surveys of a cell? The congruency test of deformation analysis (H. Pelzer, "Zur
 * Analyse geodätischer Deformationsmessungen", 1971), with what the earlier survey knows as prior of the later one.
 *
 * <p>Both surveys rest on what is stated of placement, so that their poses err alike, and the difference of the two is
 * no measure. What is compared is the earlier posterior, of covariance C about poses x0, with what the later photos
 * alone say: information I and score y of the poses at x0. If nothing has moved, y has the covariance I + I C I. A move
 * d of some bodies E adds I E d to it; the best d and its information are those of linear regression, with
 * {@code W = I - I (C^-1 + I)^-1 I}:
 *
 * <pre>
 * (E' W E) d = E' (y - I (C^-1 + I)^-1 y)
 * </pre>
 *
 * <p>The body that moved most against its own deviations is named first, and the others are tested with its move
 * unknown. Errors of the lens and of sizes of prints, which are alike in both surveys, count as independent ones, which
 * errs to the side of naming less.
 */
final class DriftTest {
    /** Chance that of unmoved bodies any is named, by all photos together, and as much by single ones. */
    private static final double LEVEL = 0.0025;
    private static final int POSE = Epoch.ERRORS;
    private static final int STEPS = 20;
    /** mm and rad, far below what corners tell. */
    private static final double SMALL_STEP = 1e-9;
    /** Share of its information that must be left of a direction where all else is unknown, for it to be tested. */
    private static final double LEAST_SHARE = 1e-6;

    private final SurveyFit fit;
    private final SurveyLayout layout;
    private final Epoch earlier;
    private final RealMatrix before;
    /** Where photos are linearised: all where it stood, but for what has moved. */
    private SurveyState at;
    /** Factor of chi-square by which corners are noisier than their squareness tells. */
    private final double noise;

    private DriftTest(SurveyFit fit, Epoch earlier, double noise) {
        this.fit = fit;
        this.earlier = earlier;
        this.noise = noise;
        layout = fit.model.layout;
        int n = POSE * earlier.bodies().size();
        before = matrix(earlier.covariance(), n, n);
        at = linearisedAt(List.of());
    }

    /**
     * Compares.
     *
     * @param cameraStands whether all photos, earlier ones and later ones, are of a camera that should not move
     */
    static Drift of(SurveyFit fit, Epoch earlier, double noise, boolean cameraStands) {
        return new DriftTest(fit, earlier, noise).compared(cameraStands);
    }

    /** What a fit knows of all poses. */
    static Epoch epoch(SurveyFit fit) {
        SurveyLayout layout = fit.model.layout;
        int n = layout.size;
        int references = layout.references.size();
        int objects = layout.objects.size();
        int camera = fit.views().size() - 1;
        List<Epoch.Body> bodies = new ArrayList<>();
        double[] rows = new double[POSE * (references + objects + 1) * n];
        double[] one = new double[POSE * n];
        double[] own = new double[POSE * POSE];
        fit.model.measurementRows(fit.mode);
        for (int r = 0; r < references; r++) {
            fit.model.referenceRows(r, one);
            System.arraycopy(one, 0, rows, r * one.length, one.length);
        }
        for (int r = 0; r < references; r++) {
            bodies.add(new Epoch.Body(Epoch.Kind.REFERENCE, layout.references.get(r).id(),
                    fit.model.worldFromReference(fit.mode, r)));
        }
        for (int o = 0; o < objects; o++) {
            for (int i = 0; i < POSE; i++) {
                rows[(POSE * (references + o) + i) * n + layout.firstObject + POSE * o + i] = 1;
            }
            bodies.add(new Epoch.Body(Epoch.Kind.OBJECT, layout.objects.get(o).id(),
                    SurveyState.get(fit.mode.objects, SurveyState.TRANSFORM * o)));
        }
        Arrays.fill(one, 0);
        fit.cameraRows(camera, one, own);
        System.arraycopy(one, 0, rows, POSE * (references + objects) * n, one.length);
        bodies.add(new Epoch.Body(Epoch.Kind.CAMERA, 0, fit.worldFromCamera(camera)));
        int size = POSE * bodies.size();
        double[] covariance = fit.sandwich(rows, size);
        int at = size - POSE;
        for (int i = 0; i < POSE; i++) {
            for (int j = 0; j < POSE; j++) {
                covariance[(at + i) * size + at + j] += own[i * POSE + j];
            }
        }
        for (int i = 0; i < size; i++) {
            for (int j = 0; j < i; j++) {
                covariance[i * size + j] = covariance[j * size + i];
            }
        }
        return new Epoch(bodies, covariance);
    }

    private Drift compared(boolean cameraStands) {
        int photos = fit.views().size();
        Regression together = new Regression(evidence(IntStream.range(0, photos).toArray(), false));
        int count = together.bodies.size() + (cameraStands ? 1 : 0);
        List<Integer> moved = together.moved(LEVEL / Math.max(1, count));
        if (!moved.isEmpty()) {
            // a move that is no small one is measured from where the body is now
            List<Integer> free = new ArrayList<>();
            for (int b : moved) {
                free.add(together.bodies.get(b));
            }
            at = linearisedAt(free);
            together = new Regression(evidence(IntStream.range(0, photos).toArray(), false));
            moved = together.moved(LEVEL / Math.max(1, count));
        }
        List<Drift.Displacement> all = new ArrayList<>(together.displacements(moved, LEVEL / Math.max(1, count)));
        List<Integer> named = new ArrayList<>();
        for (int b : moved) {
            named.add(together.bodies.get(b));
        }
        List<Regression> single = new ArrayList<>();
        int tests = 0;
        for (int v = 0; v < photos; v++) {
            Regression one = new Regression(evidence(new int[] {v}, cameraStands));
            single.add(one);
            tests += one.bodies.size();
        }
        double level = LEVEL / Math.max(1, tests);
        List<Drift.OfPhoto> out = new ArrayList<>();
        Drift.Displacement camera = null;
        for (int v = 0; v < photos; v++) {
            Regression one = single.get(v);
            List<Integer> free = IntStream.range(0, one.bodies.size())
                    .filter(b -> named.contains(one.bodies.get(b))).boxed().collect(Collectors.toList());
            List<Drift.Displacement> found = one.displacements(free, level);
            out.add(new Drift.OfPhoto(fit.views().get(v).detections.imageName(), found));
            for (Drift.Displacement d : found) {
                if (d.body().kind() == Epoch.Kind.CAMERA && (camera == null || d.chance() < camera.chance())) {
                    camera = d;
                }
            }
        }
        if (camera != null) {
            double chance = Math.min(1, camera.chance() * photos);
            all.add(new Drift.Displacement(camera.body(), camera.shiftMm(), camera.stdMm(), camera.turnDeg(),
                    camera.chiSquare(), chance, chance < LEVEL / count));
        }
        return new Drift(all, out,
                new ChiSquaredDistribution(null, POSE).inverseCumulativeProbability(1 - level));
    }

    /**
     * The later photos' state with everything where the earlier survey has it, cameras fitted to that: along the lines
     * of sight of few cameras the later photos alone put bodies far off, and there their information is another one.
     *
     * @param moved bodies that stay where the later photos have them, by their index in the earlier survey
     */
    private SurveyState linearisedAt(List<Integer> moved) {
        SurveyState state = new SurveyState(layout, fit.views());
        state.copyFrom(fit.mode);
        for (int b = 0; b < earlier.bodies().size(); b++) {
            Epoch.Body body = earlier.bodies().get(b);
            if (moved.contains(b)) {
                continue;
            }
            if (body.kind() == Epoch.Kind.REFERENCE && layout.reference(body.id()) >= 0) {
                int r = layout.reference(body.id());
                double[] error = difference(layout.references.get(r).worldFromMarker(), body.worldFromBody());
                System.arraycopy(error, 0, state.values, POSE * r, POSE);
            } else if (body.kind() == Epoch.Kind.OBJECT && layout.object(body.id()) >= 0) {
                SurveyState.set(state.objects, SurveyState.TRANSFORM * layout.object(body.id()),
                        body.worldFromBody());
            }
        }
        // errors of plates are in those of their references now
        Arrays.fill(state.values, layout.firstGroup, layout.firstObject, 0);
        return fittedCameras(state);
    }

    private SurveyState fittedCameras(SurveyState start) {
        SurveyState state = start;
        int n = layout.size;
        for (int v = 0; v < fit.views().size(); v++) {
            ViewEquations own = new ViewEquations(fit.views().get(v).locals(), n);
            for (int step = 0; step < STEPS; step++) {
                fit.model.linearisePriors(state, new double[n * n], new double[n]);
                fit.model.gradient(state, v, own, new double[n * n], new double[n]);
                double[] by = own.ownGradient.clone();
                if (!Cholesky.factor(own.own, own.locals)) {
                    break;
                }
                Cholesky.solveLower(own.own, own.locals, by);
                Cholesky.solveUpper(own.own, own.locals, by);
                double largest = 0;
                for (int i = 0; i < by.length; i++) {
                    by[i] = -by[i];
                    largest = Math.max(largest, Math.abs(by[i]));
                }
                SurveyState next = new SurveyState(layout, fit.views());
                next.copyFrom(state);
                next.moveOwn(state, v, by, 0);
                state = next;
                if (largest < SMALL_STEP) {
                    break;
                }
            }
        }
        return state;
    }

    // ---- what later photos say

    /** Information and score of poses by some photos, about where the earlier survey has them. */
    private static final class Evidence {
        /** Index of each body in the earlier survey. */
        final List<Integer> bodies = new ArrayList<>();
        RealMatrix information = new Array2DRowRealMatrix(1, 1);
        RealVector score = new ArrayRealVector(1);
    }

    private Evidence evidence(int[] views, boolean withCamera) {
        int n = layout.size;
        int cameraAt = n;
        int size = withCamera ? n + POSE : n;
        double[] information = new double[n * n];
        double[] gradient = new double[n];
        fit.model.linearisePriors(at, new double[n * n], new double[n]);
        RealMatrix all = new Array2DRowRealMatrix(size, size);
        RealVector slope = new ArrayRealVector(size);
        for (int v : views) {
            ViewEquations own = new ViewEquations(fit.views().get(v).locals(), n);
            if (withCamera) {
                fit.model.gradient(at, v, own, information, gradient);
                keepCamera(own, all, slope);
            } else {
                fit.model.lineariseView(at, v, own, information, gradient);
            }
        }
        SurveyAdjustment.mirror(information, n);
        for (int i = 0; i < n; i++) {
            slope.addToEntry(i, gradient[i]);
            for (int j = 0; j < n; j++) {
                all.addToEntry(i, j, information[i * n + j]);
            }
        }
        addLens(all, slope);
        Evidence out = new Evidence();
        List<Integer> kept = new ArrayList<>();
        List<Integer> others = new ArrayList<>();
        for (int b = 0; b < earlier.bodies().size(); b++) {
            Epoch.Body body = earlier.bodies().get(b);
            int first = switch (body.kind()) {
                case REFERENCE -> POSE * layout.reference(body.id());
                case OBJECT -> layout.object(body.id()) < 0 ? -1
                        : layout.firstObject + POSE * layout.object(body.id());
                case CAMERA -> withCamera ? cameraAt : -1;
            };
            if (first >= 0 && all.getEntry(first, first) > 0) {
                out.bodies.add(b);
                for (int i = 0; i < POSE; i++) {
                    kept.add(first + i);
                }
            }
        }
        for (int i = layout.firstObject; i < layout.firstRobot; i++) {
            if (!kept.contains(i) && all.getEntry(i, i) > 0) {
                others.add(i);
            }
        }
        // a camera that is compared with none is any camera
        for (int i = n; i < size; i++) {
            if (!kept.contains(i)) {
                others.add(i);
            }
        }
        eliminate(all, slope, kept, others, out);
        aboutEarlier(out, views[0]);
        return out;
    }

    /** Adds a photo with its camera kept, its other unknowns eliminated. */
    private void keepCamera(ViewEquations own, RealMatrix all, RealVector slope) {
        int n = layout.size;
        int locals = own.locals;
        int rest = locals - POSE;
        RealMatrix cross = new Array2DRowRealMatrix(rest + 1, n + POSE);
        RealMatrix inner = MatrixUtils.createRealIdentityMatrix(rest + 1);
        RealVector score = new ArrayRealVector(rest + 1);
        for (int i = 0; i < locals; i++) {
            for (int j = 0; j <= i; j++) {
                double h = own.own[i * locals + j];
                if (i < POSE) {
                    all.addToEntry(n + i, n + j, h);
                    all.addToEntry(n + j, n + i, i == j ? 0 : h);
                } else if (j < POSE) {
                    cross.setEntry(i - POSE, n + j, h);
                } else {
                    inner.setEntry(i - POSE, j - POSE, h);
                    inner.setEntry(j - POSE, i - POSE, h);
                }
            }
            for (int a = 0; a < n; a++) {
                double h = own.cross[i * n + a];
                if (i < POSE) {
                    all.addToEntry(n + i, a, h);
                    all.addToEntry(a, n + i, h);
                } else {
                    cross.setEntry(i - POSE, a, h);
                }
            }
            if (i < POSE) {
                slope.addToEntry(n + i, own.ownGradient[i]);
            } else {
                score.setEntry(i - POSE, own.ownGradient[i]);
            }
        }
        RealMatrix solved = new LUDecomposition(inner).getSolver().solve(cross);
        RealMatrix less = cross.transpose().multiply(solved);
        RealVector lessSlope = solved.transpose().operate(score);
        for (int i = 0; i < n + POSE; i++) {
            slope.addToEntry(i, -lessSlope.getEntry(i));
            for (int j = 0; j < n + POSE; j++) {
                all.addToEntry(i, j, -less.getEntry(i, j));
            }
        }
    }

    /** What is known of lens and prints besides. */
    private void addLens(RealMatrix all, RealVector slope) {
        for (int i = 0; i < layout.intrinsics.count(); i++) {
            int row = layout.firstIntrinsic + i;
            for (int j = 0; j < layout.intrinsics.count(); j++) {
                int column = layout.firstIntrinsic + j;
                double p = layout.intrinsics.information(i, j);
                all.addToEntry(row, column, p);
                slope.addToEntry(row, p * (at.values[column] - layout.intrinsics.mean(j)));
            }
        }
        for (int i = layout.firstSize; i < layout.firstRobot; i++) {
            all.addToEntry(i, i, 1);
            slope.addToEntry(i, at.values[i]);
        }
    }

    private static void eliminate(RealMatrix all, RealVector slope, List<Integer> kept, List<Integer> others,
            Evidence out) {
        int[] k = kept.stream().mapToInt(Integer::intValue).toArray();
        int[] o = others.stream().mapToInt(Integer::intValue).toArray();
        RealVector score = new ArrayRealVector(k.length);
        for (int i = 0; i < k.length; i++) {
            score.setEntry(i, slope.getEntry(k[i]));
        }
        if (k.length == 0) {
            return;
        }
        RealMatrix information = all.getSubMatrix(k, k);
        if (o.length > 0) {
            RealMatrix cross = all.getSubMatrix(o, k);
            RealVector known = new ArrayRealVector(o.length);
            for (int i = 0; i < o.length; i++) {
                known.setEntry(i, slope.getEntry(o[i]));
            }
            RealMatrix solved = new LUDecomposition(all.getSubMatrix(o, o), 0).getSolver().solve(cross);
            information = information.subtract(cross.transpose().multiply(solved));
            score = score.subtract(solved.transpose().operate(known));
        }
        out.information = information;
        out.score = score;
    }

    /** Turns a gradient at the later mode, in its unknowns, into a score at the earlier poses, in those. */
    private void aboutEarlier(Evidence evidence, int view) {
        int n = POSE * evidence.bodies.size();
        if (n == 0) {
            return;
        }
        RealMatrix byPose = MatrixUtils.createRealIdentityMatrix(n);
        RealVector shift = new ArrayRealVector(n);
        double[] rows = new double[POSE * layout.size];
        fit.model.measurementRows(at);
        for (int k = 0; k < evidence.bodies.size(); k++) {
            Epoch.Body body = earlier.bodies().get(evidence.bodies.get(k));
            RealMatrix jacobian = null;
            if (body.kind() == Epoch.Kind.REFERENCE) {
                int r = layout.reference(body.id());
                fit.model.referenceRows(r, rows);
                jacobian = matrix(rows, POSE, layout.size)
                        .getSubMatrix(0, POSE - 1, POSE * r, POSE * r + POSE - 1);
            } else if (body.kind() == Epoch.Kind.CAMERA) {
                jacobian = matrix(SurveyFit.cameraJacobian(at.cameras[view]), POSE, POSE);
            }
            if (jacobian != null) {
                byPose.setSubMatrix(MatrixUtils.inverse(jacobian).getData(), POSE * k, POSE * k);
            }
        }
        for (int k = 0; k < evidence.bodies.size(); k++) {
            Epoch.Body body = earlier.bodies().get(evidence.bodies.get(k));
            shift.setSubVector(POSE * k, new ArrayRealVector(difference(body.worldFromBody(), now(body, view))));
        }
        evidence.information = byPose.transpose().multiply(evidence.information).multiply(byPose);
        evidence.score = evidence.information.operate(shift)
                .subtract(byPose.transpose().operate(evidence.score));
    }

    private RigidTransform now(Epoch.Body body, int view) {
        return switch (body.kind()) {
            case REFERENCE -> fit.model.worldFromReference(at, layout.reference(body.id()));
            case OBJECT -> SurveyState.get(at.objects, SurveyState.TRANSFORM * layout.object(body.id()));
            case CAMERA -> fit.worldFromCamera(at, view);
        };
    }

    /** Shift and turn from one pose to another, in world axes. */
    private static double[] difference(RigidTransform from, RigidTransform to) {
        double[] out = new double[POSE];
        double[] turn = new double[9];
        Rotations.multiplyTransposed(to.rotation(), from.rotation(), turn);
        Rotations.log(turn, out, 3);
        for (int i = 0; i < 3; i++) {
            out[i] = to.translationMm()[i] - from.translationMm()[i];
        }
        return out;
    }

    private static RealMatrix matrix(double[] rows, int count, int columns) {
        RealMatrix out = new Array2DRowRealMatrix(count, columns);
        for (int i = 0; i < count; i++) {
            for (int j = 0; j < columns; j++) {
                out.setEntry(i, j, rows[i * columns + j]);
            }
        }
        return out;
    }

    // ---- what has moved

    /** Moves of bodies, given what the earlier survey knows of all. */
    private final class Regression {
        /** Index of each body in the earlier survey. */
        final List<Integer> bodies;
        private final RealMatrix information;
        private final RealMatrix byMove;
        private final RealVector score;

        Regression(Evidence evidence) {
            bodies = evidence.bodies;
            information = evidence.information;
            int[] rows = bodies.stream().flatMapToInt(b -> IntStream.range(POSE * b, POSE * b + POSE)).toArray();
            if (rows.length == 0) {
                byMove = information;
                score = evidence.score;
                return;
            }
            RealMatrix covariance = before.getSubMatrix(rows, rows);
            // (C^-1 + I)^-1 without the inverse of C, which has directions that are known to a hair
            RealMatrix left = MatrixUtils.createRealIdentityMatrix(rows.length).add(information.multiply(covariance));
            RealMatrix after = covariance.multiply(new LUDecomposition(left, 0).getSolver().getInverse());
            RealMatrix explained = information.multiply(after);
            byMove = information.subtract(explained.multiply(information));
            score = evidence.score.subtract(explained.operate(evidence.score));
        }

        /** Chi-square of the moves of some bodies together, and the moves. */
        private @Nullable Fit fit(List<Integer> free) {
            int[] rows = free.stream().flatMapToInt(b -> IntStream.range(POSE * b, POSE * b + POSE)).toArray();
            if (rows.length == 0) {
                return new Fit(0, 0, new ArrayRealVector(0), new Array2DRowRealMatrix(1, 1));
            }
            int n = rows.length;
            double[] scale = new double[n];
            RealMatrix scaled = byMove.getSubMatrix(rows, rows);
            RealVector slope = new ArrayRealVector(n);
            for (int i = 0; i < n; i++) {
                scale[i] = Math.sqrt(information.getEntry(rows[i], rows[i]));
                slope.setEntry(i, score.getEntry(rows[i]) / scale[i]);
            }
            for (int i = 0; i < n; i++) {
                for (int j = 0; j <= i; j++) {
                    double both = 0.5 * (scaled.getEntry(i, j) + scaled.getEntry(j, i)) / (scale[i] * scale[j]);
                    scaled.setEntry(i, j, both);
                    scaled.setEntry(j, i, both);
                }
            }
            EigenDecomposition eigen = new EigenDecomposition(scaled);
            double chiSquare = 0;
            int degrees = 0;
            RealVector move = new ArrayRealVector(n);
            RealMatrix covariance = new Array2DRowRealMatrix(n, n);
            for (int k = 0; k < n; k++) {
                double share = eigen.getRealEigenvalue(k);
                RealVector direction = eigen.getEigenvector(k);
                if (share > LEAST_SHARE) {
                    double along = direction.dotProduct(slope);
                    chiSquare += along * along / share;
                    degrees++;
                    move = move.add(direction.mapMultiply(along / share));
                    covariance = covariance.add(direction.outerProduct(direction).scalarMultiply(1 / share));
                }
            }
            for (int i = 0; i < n; i++) {
                move.setEntry(i, move.getEntry(i) / scale[i]);
                for (int j = 0; j < n; j++) {
                    covariance.setEntry(i, j, covariance.getEntry(i, j) / (scale[i] * scale[j]));
                }
            }
            return new Fit(chiSquare, degrees, move, covariance);
        }

        /** One body's move, those of some others unknown. */
        private Drift.@Nullable Displacement displacement(int body, List<Integer> free, double level) {
            List<Integer> others = free.stream().filter(b -> b != body).collect(Collectors.toList());
            List<Integer> with = new ArrayList<>(List.of(body));
            with.addAll(others);
            Fit without = fit(others);
            Fit all = fit(with);
            if (without == null || all == null || all.degrees <= without.degrees) {
                return null;
            }
            double chiSquare = Math.max(0, all.chiSquare - without.chiSquare) / noise;
            double chance = ChiSquare.pValue(chiSquare, all.degrees - without.degrees);
            double turn = 0;
            List<Double> shift = new ArrayList<>();
            List<Double> std = new ArrayList<>();
            for (int i = 0; i < 3; i++) {
                shift.add(all.move.getEntry(i));
                std.add(Math.sqrt(noise * Math.max(0, all.covariance.getEntry(i, i))));
                turn += all.move.getEntry(3 + i) * all.move.getEntry(3 + i);
            }
            return new Drift.Displacement(earlier.bodies().get(bodies.get(body)), shift, std,
                    Math.toDegrees(Math.sqrt(turn)), chiSquare, chance, chance < level);
        }

        /** Bodies that have moved, one after another. */
        List<Integer> moved(double level) {
            List<Integer> free = new ArrayList<>();
            while (free.size() < bodies.size() / 2) {
                int worst = -1;
                double least = level;
                double most = 0;
                for (int b = 0; b < bodies.size(); b++) {
                    Drift.Displacement d = free.contains(b) ? null : displacement(b, free, level);
                    if (d != null && (d.chance() < least || d.chance() == least && d.chiSquare() > most)) {
                        worst = b;
                        least = d.chance();
                        most = d.chiSquare();
                    }
                }
                if (worst < 0) {
                    break;
                }
                free.add(worst);
            }
            return free;
        }

        List<Drift.Displacement> displacements(List<Integer> free, double level) {
            List<Drift.Displacement> out = new ArrayList<>();
            for (int b = 0; b < bodies.size(); b++) {
                Drift.Displacement d = displacement(b, free, level);
                if (d != null) {
                    out.add(d);
                }
            }
            return out;
        }
    }

    /** Moves of some bodies together. */
    private static final class Fit {
        final double chiSquare;
        final int degrees;
        final RealVector move;
        final RealMatrix covariance;

        Fit(double chiSquare, int degrees, RealVector move, RealMatrix covariance) {
            this.chiSquare = chiSquare;
            this.degrees = degrees;
            this.move = move;
            this.covariance = covariance;
        }
    }
}
