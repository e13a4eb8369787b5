package org.cellgauge.internal.survey;

import java.util.Arrays;
import java.util.List;
import org.cellgauge.cell.Placement;
import org.cellgauge.cell.Reference;
import org.cellgauge.cell.SurveyedPlacement;
import org.cellgauge.geometry.Lens;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.internal.geometry.Cholesky;
import org.cellgauge.internal.geometry.MarkerGeometry;
import org.cellgauge.internal.geometry.Rotations;
import org.jspecify.annotations.Nullable;

/**
 * The joint posterior of all photos of a cell: minus its logarithm up to a constant, and its normal equations.
 *
 * <p>Errors of placement are unknowns here and not integrated out as they are of one photo: a block of all that photos
 * show of one reference would grow with their number, and its cost with the cube of that. As unknowns they leave every
 * photo independent of the others, so that photos are eliminated one by one (Schur complement: B. Triggs et al.,
 * "Bundle adjustment - a modern synthesis", 2000, section 6.1) and the cost is linear in their number.
 *
 * <p>A pose has a flat prior of its position and is uniform over rotations. An instance is for one thread; instances
 * that share views and layout give the same figures.
 */
final class SurveyModel {
    private static final int POSE = SurveyLayout.POSE;
    private static final int TRANSFORM = SurveyState.TRANSFORM;
    private static final int ROWS = 8;
    private static final int POINTS = 4;

    final SurveyLayout layout;
    final List<SurveyView> views;
    /** About which cameras turn, world, mm. */
    final double[] centreMm;
    /** Factor of the deviations of each reference's placement: above 1 where it is not trusted. */
    private final double[] trust;
    private final double @Nullable [] jointInformation;
    private final SharedMeasurements measured;
    private final Lens lens;
    private final double[] referenceRotations;
    private final double[] referencePlaces;
    private final double[] groupCentres;

    // work: where references and objects are, and what moves them
    private final double[] corners;
    private final double[] rotations;
    private final double[] places;
    private final double[] ownTurn;
    private final double[] byGroupPlace;
    private final double[] byGroupTurn;
    private final double[] groupTurn = new double[9];
    private final double[] jacobian = new double[9];
    private final double[] a9 = new double[9];
    private final double[] b9 = new double[9];
    private final double[] offset = new double[3];
    private final double[] turned = new double[3];
    private final double[] uv = new double[2];
    private final double[] byPoint = new double[6];
    private final double[] byLens;
    private final double[] residual = new double[ROWS];
    private final double[] white = new double[ROWS];
    private final double[] raw;
    private final double[] block;
    private final int[] columns;

    SurveyModel(SurveyLayout layout, List<SurveyView> views, double[] trust) {
        this.layout = layout;
        this.views = views;
        this.trust = trust;
        lens = layout.cell.camera().lens();
        int n = layout.references.size();
        referenceRotations = new double[9 * n];
        referencePlaces = new double[3 * n];
        centreMm = new double[3];
        for (int r = 0; r < n; r++) {
            RigidTransform pose = layout.references.get(r).worldFromMarker();
            System.arraycopy(pose.rotation(), 0, referenceRotations, 9 * r, 9);
            System.arraycopy(pose.translationMm(), 0, referencePlaces, 3 * r, 3);
            for (int i = 0; i < 3; i++) {
                centreMm[i] += pose.translationMm()[i] / n;
            }
        }
        groupCentres = new double[3 * layout.groups.size()];
        int[] members = new int[layout.groups.size()];
        for (int r = 0; r < n; r++) {
            int group = layout.groupOf[r];
            if (group >= 0) {
                members[group]++;
                for (int i = 0; i < 3; i++) {
                    double before = groupCentres[3 * group + i];
                    groupCentres[3 * group + i] += (referencePlaces[3 * r + i] - before) / members[group];
                }
            }
        }
        SurveyedPlacement surveyed = layout.cell.joint().surveyed();
        jointInformation = surveyed == null ? null : information(layout, surveyed);
        measured = new SharedMeasurements(layout, referencePlaces);
        int bodies = n + layout.objects.size();
        corners = new double[3 * POINTS * bodies];
        rotations = new double[9 * n];
        places = new double[3 * n];
        ownTurn = new double[9 * n];
        byGroupPlace = new double[9 * n];
        byGroupTurn = new double[9 * n];
        byLens = new double[2 * lens.parameterCount()];
        int most = 4 * POSE + layout.intrinsics.count() + 1;
        for (SurveyView view : views) {
            most = Math.max(most, 4 * POSE + layout.intrinsics.count() + 1 + view.edges);
        }
        raw = new double[ROWS * most];
        block = new double[ROWS * most];
        columns = new int[most];
    }

    /** Information of the errors of all references, those that the survey had not with their own placement. */
    private static double[] information(SurveyLayout layout, SurveyedPlacement surveyed) {
        int n = POSE * layout.references.size();
        double[] covariance = new double[n * n];
        double[] known = surveyed.covariance();
        int k = POSE * surveyed.ids().size();
        for (int r = 0; r < layout.references.size(); r++) {
            Reference reference = layout.references.get(r);
            int at = surveyed.ids().indexOf(reference.id());
            for (int i = 0; i < POSE; i++) {
                int row = POSE * r + i;
                if (at < 0) {
                    double std = i < 3 ? reference.placement().stdMm(i) : reference.placement().stdRad();
                    covariance[row * (n + 1)] = std * std;
                    continue;
                }
                for (int s = 0; s < layout.references.size(); s++) {
                    int other = surveyed.ids().indexOf(layout.references.get(s).id());
                    for (int j = 0; j < POSE && other >= 0; j++) {
                        covariance[row * n + POSE * s + j] = known[(POSE * at + i) * k + POSE * other + j];
                    }
                }
                // a covariance that went through a file is no longer positive definite to the last digit
                covariance[row * (n + 1)] *= 1 + 1e-9;
            }
        }
        double[] inverse = Cholesky.inverse(covariance, n);
        if (inverse == null) {
            throw new IllegalArgumentException("the covariance of the survey is not positive definite");
        }
        return inverse;
    }

    /** Another instance of the same, for another thread. */
    SurveyModel another() {
        return new SurveyModel(layout, views, trust);
    }

    /** Number of unknowns that all photos share. */
    int shared() {
        return layout.size;
    }

    /** Deviation of an error of a reference beforehand; i as in {@link SurveyLayout}. */
    private double priorStd(int reference, int i) {
        Placement placement = layout.references.get(reference).placement();
        double std = i < 3 ? placement.stdMm(i) : placement.stdRad();
        return Math.max(std, 1e-9) * trust[reference];
    }

    // ---- where things are

    /** Corners of references and objects in the world. */
    private void place(SurveyState state, boolean withDerivatives) {
        int n = layout.references.size();
        for (int r = 0; r < n; r++) {
            int at = POSE * r;
            Rotations.exp(state.values[at + 3], state.values[at + 4], state.values[at + 5], a9);
            System.arraycopy(referenceRotations, 9 * r, b9, 0, 9);
            int group = layout.groupOf[r];
            for (int i = 0; i < 3; i++) {
                places[3 * r + i] = referencePlaces[3 * r + i] + state.values[at + i];
            }
            if (group >= 0) {
                int g = layout.firstGroup + POSE * group;
                Rotations.exp(state.values[g + 3], state.values[g + 4], state.values[g + 5], groupTurn);
                Rotations.multiply(groupTurn, b9, jacobian);
                System.arraycopy(jacobian, 0, b9, 0, 9);
                for (int i = 0; i < 3; i++) {
                    offset[i] = referencePlaces[3 * r + i] - groupCentres[3 * group + i];
                }
                turn(groupTurn, offset, turned);
                for (int i = 0; i < 3; i++) {
                    places[3 * r + i] += turned[i] - offset[i] + state.values[g + i];
                }
                if (withDerivatives) {
                    Rotations.leftJacobian(state.values[g + 3], state.values[g + 4], state.values[g + 5], jacobian);
                    cross(turned, jacobian, byGroupPlace, 9 * r);
                    Rotations.multiply(a9, jacobian, groupTurn);
                    System.arraycopy(groupTurn, 0, byGroupTurn, 9 * r, 9);
                }
            }
            Rotations.multiply(a9, b9, jacobian);
            System.arraycopy(jacobian, 0, rotations, 9 * r, 9);
            corners(rotations, 9 * r, places, 3 * r, layout.references.get(r).sizeMm(), r);
            if (withDerivatives) {
                Rotations.leftJacobian(state.values[at + 3], state.values[at + 4], state.values[at + 5], jacobian);
                System.arraycopy(jacobian, 0, ownTurn, 9 * r, 9);
            }
        }
        for (int o = 0; o < layout.objects.size(); o++) {
            corners(state.objects, TRANSFORM * o, state.objects, TRANSFORM * o + 9, layout.objects.get(o).sizeMm(),
                    n + o);
        }
    }

    /** The corners of a square of a marker; as {@link MarkerGeometry#cornersMm} has them. */
    private void corners(double[] r, int ofR, double[] t, int ofT, double sizeMm, int body) {
        double h = sizeMm / 2;
        for (int k = 0; k < POINTS; k++) {
            double x = k == 0 || k == 3 ? -h : h;
            double y = k < 2 ? h : -h;
            for (int i = 0; i < 3; i++) {
                corners[3 * (POINTS * body + k) + i] = r[ofR + 3 * i] * x + r[ofR + 3 * i + 1] * y + t[ofT + i];
            }
        }
    }

    private static void turn(double[] r, double[] x, double[] out) {
        for (int i = 0; i < 3; i++) {
            out[i] = r[3 * i] * x[0] + r[3 * i + 1] * x[1] + r[3 * i + 2] * x[2];
        }
    }

    /** {@code -[x]J}: how a point at x from the origin moves where a rotation vector changes. */
    private static void cross(double[] x, double[] j, double[] out, int at) {
        for (int c = 0; c < 3; c++) {
            out[at + c] = x[2] * j[3 + c] - x[1] * j[6 + c];
            out[at + 3 + c] = x[0] * j[6 + c] - x[2] * j[c];
            out[at + 6 + c] = x[1] * j[c] - x[0] * j[3 + c];
        }
    }

    /** The pose of a reference at a state. */
    RigidTransform worldFromReference(SurveyState state, int reference) {
        place(state, false);
        return RigidTransform.of(Arrays.copyOfRange(rotations, 9 * reference, 9 * reference + 9),
                Arrays.copyOfRange(places, 3 * reference, 3 * reference + 3));
    }

    /**
     * Derivative of a reference's place and turn in the world by what all photos share: six rows, position then a
     * rotation vector in world axes. Of the state last linearised at.
     *
     * @param rows receives 6 x {@link #shared()} values
     */
    void referenceRows(int reference, double[] rows) {
        int n = layout.size;
        Arrays.fill(rows, 0, POSE * n, 0);
        int group = layout.groupOf[reference];
        for (int i = 0; i < 3; i++) {
            rows[i * n + POSE * reference + i] = 1;
            for (int c = 0; c < 3; c++) {
                rows[(3 + i) * n + POSE * reference + 3 + c] = ownTurn[9 * reference + 3 * i + c];
            }
            if (group >= 0) {
                int g = layout.firstGroup + POSE * group;
                rows[i * n + g + i] = 1;
                for (int c = 0; c < 3; c++) {
                    rows[i * n + g + 3 + c] = byGroupPlace[9 * reference + 3 * i + c];
                    rows[(3 + i) * n + g + 3 + c] = byGroupTurn[9 * reference + 3 * i + c];
                }
            }
        }
    }

    // ---- what is known beforehand

    private double priorCost(SurveyState state) {
        double sum = 0;
        int n = layout.references.size();
        if (jointInformation != null) {
            int k = POSE * n;
            for (int i = 0; i < k; i++) {
                double row = 0;
                for (int j = 0; j < k; j++) {
                    row += jointInformation[i * k + j] * state.values[j] / trust[j / POSE];
                }
                sum += row * state.values[i] / trust[i / POSE];
            }
        } else {
            for (int i = 0; i < POSE * n; i++) {
                double w = state.values[i] / priorStd(i / POSE, i % POSE);
                sum += w * w;
            }
        }
        for (int i = layout.firstGroup; i < layout.firstObject; i++) {
            double w = state.values[i] / groupStd(i - layout.firstGroup);
            sum += w * w;
        }
        for (int i = 0; i < layout.intrinsics.count(); i++) {
            double w = layout.intrinsics.whitened(i, state.lens);
            sum += w * w;
        }
        for (int i = layout.firstSize; i < layout.firstRobot; i++) {
            sum += state.values[i] * state.values[i];
        }
        return 0.5 * sum;
    }

    private double groupStd(int i) {
        Placement placement = layout.groups.get(i / POSE).placement();
        return Math.max(i % POSE < 3 ? placement.stdMm(i % POSE) : placement.stdRad(), 1e-9);
    }

    /** Adds what priors say. */
    private void addPriors(SurveyState state, double[] information, double[] gradient) {
        int n = layout.size;
        int k = POSE * layout.references.size();
        if (jointInformation != null) {
            for (int i = 0; i < k; i++) {
                for (int j = 0; j < k; j++) {
                    double p = jointInformation[i * k + j] / (trust[i / POSE] * trust[j / POSE]);
                    information[i * n + j] += p;
                    gradient[i] += p * state.values[j];
                }
            }
        } else {
            for (int i = 0; i < k; i++) {
                double std = priorStd(i / POSE, i % POSE);
                information[i * (n + 1)] += 1 / (std * std);
                gradient[i] += state.values[i] / (std * std);
            }
        }
        for (int i = layout.firstGroup; i < layout.firstObject; i++) {
            double std = groupStd(i - layout.firstGroup);
            information[i * (n + 1)] += 1 / (std * std);
            gradient[i] += state.values[i] / (std * std);
        }
        for (int i = 0; i < layout.intrinsics.count(); i++) {
            int row = layout.firstIntrinsic + i;
            for (int j = 0; j < layout.intrinsics.count(); j++) {
                double p = layout.intrinsics.information(i, j);
                int column = layout.firstIntrinsic + j;
                information[row * n + column] += p;
                gradient[row] += p * (state.values[column] - layout.intrinsics.mean(j));
            }
        }
        for (int i = layout.firstSize; i < layout.firstRobot; i++) {
            information[i * (n + 1)] += 1;
            gradient[i] += state.values[i];
        }
    }

    /**
     * Adds what one source says: a prior's own information, as a share of the whole.
     *
     * @param source which
     * @param index of the reference or group
     * @param information receives its part, {@link #shared()} squared, zeros elsewhere
     */
    void priorInformation(Source source, int index, double[] information) {
        int n = layout.size;
        Arrays.fill(information, 0);
        switch (source) {
            case REFERENCE -> {
                for (int i = 0; i < POSE; i++) {
                    double std = priorStd(index, i);
                    information[(POSE * index + i) * (n + 1)] = 1 / (std * std);
                }
            }
            case GROUP -> {
                for (int i = POSE * index; i < POSE * (index + 1); i++) {
                    information[(layout.firstGroup + i) * (n + 1)] = 1 / (groupStd(i) * groupStd(i));
                }
            }
            case SURVEY -> {
                int k = POSE * layout.references.size();
                for (int i = 0; i < k; i++) {
                    for (int j = 0; j < k && jointInformation != null; j++) {
                        information[i * n + j] = jointInformation[i * k + j] / (trust[i / POSE] * trust[j / POSE]);
                    }
                }
            }
            case CALIBRATION -> {
                for (int i = 0; i < layout.intrinsics.count(); i++) {
                    for (int j = 0; j < layout.intrinsics.count(); j++) {
                        information[(layout.firstIntrinsic + i) * n + layout.firstIntrinsic + j] =
                                layout.intrinsics.information(i, j);
                    }
                }
            }
            case SIZES -> {
                for (int i = layout.firstSize; i < layout.firstRobot; i++) {
                    information[i * (n + 1)] = 1;
                }
            }
            case MEASUREMENTS -> {
                double[] gradient = new double[n];
                measured.add(places, this::referenceRow, null, information, gradient);
            }
            default -> throw new IllegalArgumentException(source + " is no prior");
        }
    }

    /** What an unknown is known by, beside photos. */
    enum Source {
        /** Where one reference was placed. */
        REFERENCE,
        /** Where a plate was placed. */
        GROUP,
        /** All references, by an earlier survey. */
        SURVEY,
        /** The lens. */
        CALIBRATION,
        /** Sizes of prints. */
        SIZES,
        /** What was measured besides. */
        MEASUREMENTS
    }

    /** Adds a multiple of the derivative of a reference's place along a direction to a row. */
    private void referenceRow(int reference, double x, double y, double z, double[] row) {
        int at = POSE * reference;
        row[at] += x;
        row[at + 1] += y;
        row[at + 2] += z;
        int group = layout.groupOf[reference];
        if (group >= 0) {
            int g = layout.firstGroup + POSE * group;
            row[g] += x;
            row[g + 1] += y;
            row[g + 2] += z;
            for (int c = 0; c < 3; c++) {
                row[g + 3 + c] += x * byGroupPlace[9 * reference + c] + y * byGroupPlace[9 * reference + 3 + c]
                        + z * byGroupPlace[9 * reference + 6 + c];
            }
        }
    }

    /** Residuals of measurements in their deviations, and the rows of their derivatives. */
    SharedMeasurements.Rows measurementRows(SurveyState state) {
        place(state, true);
        return measured.rows(places, this::referenceRow, state.values);
    }

    // ---- the posterior

    /** Half of the sum of squares at a state; infinite where a marker is not before its camera. Allocates nothing. */
    double cost(SurveyState state) {
        place(state, false);
        double sum = priorCost(state) + measured.cost(places, state.values);
        for (int v = 0; v < views.size(); v++) {
            sum += ownCost(state, v);
        }
        return sum;
    }

    private double ownCost(SurveyState state, int v) {
        SurveyView view = views.get(v);
        double sum = 0;
        for (double e : state.edges[v]) {
            sum += e * e;
        }
        for (int m = 0; m < view.size(); m++) {
            if (!residuals(state, v, m)) {
                return Double.POSITIVE_INFINITY;
            }
            sum += whitened(view.whitening[m]);
        }
        return 0.5 * sum;
    }

    /** Whitens the residuals; the sum of their squares. */
    private double whitened(double[] w) {
        double sum = 0;
        for (int i = 0; i < ROWS; i++) {
            double d = 0;
            for (int j = 0; j <= i; j++) {
                d += w[ROWS * i + j] * residual[j];
            }
            white[i] = d;
            sum += d * d;
        }
        return sum;
    }

    /** Index among references, then objects that stand still; -1 for one that moves. */
    private int body(int id) {
        int reference = layout.reference(id);
        int object = layout.object(id);
        return reference >= 0 ? reference : object >= 0 ? layout.references.size() + object : -1;
    }

    /** A corner in the camera frame, into {@link #turned} (about the pose's centre) and {@link #offset}. */
    private void inCamera(SurveyState state, int v, int body, int moving, SurveyView view, int m, int k) {
        double[] pose = body >= 0 ? state.cameras[v] : state.moving[v];
        int at = body >= 0 ? 0 : TRANSFORM * moving;
        for (int i = 0; i < 3; i++) {
            offset[i] = body >= 0 ? corners[3 * (POINTS * body + k) + i] - centreMm[i] : view.pointsMm[m][3 * k + i];
        }
        for (int i = 0; i < 3; i++) {
            turned[i] = pose[at + 3 * i] * offset[0] + pose[at + 3 * i + 1] * offset[1]
                    + pose[at + 3 * i + 2] * offset[2];
        }
        for (int i = 0; i < 3; i++) {
            offset[i] = turned[i] + pose[at + 9 + i];
        }
    }

    private double nuisance(SurveyState state, int v, SurveyView view, int m, int row) {
        double sum = 0;
        int edges = view.edges;
        for (int j = 0; j < edges; j++) {
            sum += view.byEdges[m][row * edges + j] * state.edges[v][j];
        }
        int size = layout.sizesMm.indexOf(view.sizesMm[m]);
        return size < 0 ? sum : sum + view.bySize[m][row] * state.values[layout.firstSize + size];
    }

    private boolean residuals(SurveyState state, int v, int m) {
        SurveyView view = views.get(v);
        int body = body(view.ids[m]);
        int moving = body >= 0 ? -1 : view.moving.indexOf(view.ids[m]);
        for (int k = 0; k < POINTS; k++) {
            inCamera(state, v, body, moving, view, m, k);
            if (!lens.project(state.lens, offset[0], offset[1], offset[2], uv, 0)) {
                return false;
            }
            for (int i = 0; i < 2; i++) {
                int row = 2 * k + i;
                residual[row] = uv[i] + nuisance(state, v, view, m, row) - view.cornersPx[m][row];
            }
        }
        return true;
    }

    /** Sum of squares of a marker's residuals in a photo, in their deviations; not finite where it is not seen. */
    double markerChiSquare(SurveyState state, int v, int m) {
        place(state, false);
        return residuals(state, v, m) ? whitened(views.get(v).whitening[m]) : Double.POSITIVE_INFINITY;
    }

    // ---- normal equations

    /** What priors and measurements say, by all that photos share. */
    double linearisePriors(SurveyState state, double[] information, double[] gradient) {
        place(state, true);
        addPriors(state, information, gradient);
        measured.add(places, this::referenceRow, state.values, information, gradient);
        return priorCost(state) + measured.cost(places, state.values);
    }

    /**
     * What one photo says, its own unknowns eliminated; after {@link #linearisePriors} at the same state.
     *
     * @param own receives what is needed to find its own unknowns again
     * @param information what it says of all that photos share is added here; the lower triangle of unknowns it shows
     * @param gradient likewise
     * @return half of its sum of squares; infinite where there is none
     */
    double lineariseView(SurveyState state, int v, ViewEquations own, double[] information, double[] gradient) {
        double cost = equations(state, v, own, information, gradient);
        return cost < Double.POSITIVE_INFINITY && own.eliminate(layout.size, information, gradient) ? cost
                : Double.POSITIVE_INFINITY;
    }

    /** The same with nothing eliminated: derivatives of the photo's part of the cost by its own unknowns. */
    double[] gradient(SurveyState state, int v, ViewEquations own, double[] information, double[] gradient) {
        equations(state, v, own, information, gradient);
        return own.ownGradient.clone();
    }

    private double equations(SurveyState state, int v, ViewEquations own, double[] information, double[] gradient) {
        SurveyView view = views.get(v);
        int n = layout.size;
        int locals = view.locals();
        own.clear();
        double cost = 0;
        for (int j = 0; j < view.edges; j++) {
            double e = state.edges[v][j];
            own.own[(POSE + j) * (locals + 1)] += 1;
            own.ownGradient[POSE + j] += e;
            cost += e * e;
        }
        for (int m = 0; m < view.size(); m++) {
            int count = rows(state, v, m);
            if (count < 0) {
                return Double.POSITIVE_INFINITY;
            }
            cost += whitened(view.whitening[m]);
            whiten(view.whitening[m], count);
            own.add(block, columns, count, white, n, information, gradient);
        }
        return 0.5 * cost;
    }

    private void whiten(double[] w, int count) {
        for (int i = ROWS - 1; i >= 0; i--) {
            for (int c = 0; c < count; c++) {
                double d = 0;
                for (int j = 0; j <= i; j++) {
                    d += w[ROWS * i + j] * raw[j * count + c];
                }
                block[i * count + c] = d;
            }
        }
    }

    /** Derivatives of a marker's residuals; places of a photo's own unknowns follow those of the shared ones. */
    private int rows(SurveyState state, int v, int m) {
        SurveyView view = views.get(v);
        int n = layout.size;
        int references = layout.references.size();
        int body = body(view.ids[m]);
        int moving = body >= 0 ? -1 : view.moving.indexOf(view.ids[m]);
        int group = body >= 0 && body < references ? layout.groupOf[body] : -1;
        int size = layout.sizesMm.indexOf(view.sizesMm[m]);
        int count = 0;
        int firstBody = count;
        if (body >= 0) {
            int at = body < references ? POSE * body : layout.firstObject + POSE * (body - references);
            count = block(at, POSE, count);
        }
        int firstOfGroup = count;
        if (group >= 0) {
            count = block(layout.firstGroup + POSE * group, POSE, count);
        }
        int firstLens = count;
        count = block(layout.firstIntrinsic, layout.intrinsics.count(), count);
        int ofSize = count;
        count = size < 0 ? count : block(layout.firstSize + size, 1, count);
        int firstPose = count;
        count = block(n + (body >= 0 ? 0 : POSE + view.edges + POSE * moving), POSE, count);
        int firstEdge = count;
        count = block(n + POSE, view.edges, count);
        for (int k = 0; k < POINTS; k++) {
            inCamera(state, v, body, moving, view, m, k);
            if (!lens.projectWithDerivatives(state.lens, offset[0], offset[1], offset[2], uv, byPoint, byLens)) {
                return -1;
            }
            for (int i = 0; i < 2; i++) {
                int row = 2 * k + i;
                int at = row * count;
                residual[row] = uv[i] + nuisance(state, v, view, m, row) - view.cornersPx[m][row];
                double px = byPoint[3 * i];
                double py = byPoint[3 * i + 1];
                double pz = byPoint[3 * i + 2];
                raw[at + firstPose] = px;
                raw[at + firstPose + 1] = py;
                raw[at + firstPose + 2] = pz;
                raw[at + firstPose + 3] = pz * turned[1] - py * turned[2];
                raw[at + firstPose + 4] = px * turned[2] - pz * turned[0];
                raw[at + firstPose + 5] = py * turned[0] - px * turned[1];
                if (body >= 0) {
                    double[] r = state.cameras[v];
                    double wx = px * r[0] + py * r[3] + pz * r[6];
                    double wy = px * r[1] + py * r[4] + pz * r[7];
                    double wz = px * r[2] + py * r[5] + pz * r[8];
                    byBody(state, body, k, wx, wy, wz, at + firstBody, group >= 0 ? at + firstOfGroup : -1);
                }
                for (int j = 0; j < layout.intrinsics.count(); j++) {
                    raw[at + firstLens + j] = byLens[i * lens.parameterCount() + layout.intrinsics.index(j)];
                }
                if (size >= 0) {
                    raw[at + ofSize] = view.bySize[m][row];
                }
                for (int j = 0; j < view.edges; j++) {
                    raw[at + firstEdge + j] = view.byEdges[m][row * view.edges + j];
                }
            }
        }
        return count;
    }

    private int block(int first, int length, int count) {
        for (int i = 0; i < length; i++) {
            columns[count + i] = first + i;
        }
        return count + length;
    }

    /** A row's derivatives by the pose of its marker, and of its plate, from those by the corner's place. */
    private void byBody(SurveyState state, int body, int k, double wx, double wy, double wz, int at, int ofGroup) {
        int references = layout.references.size();
        boolean reference = body < references;
        int o = TRANSFORM * (body - references) + 9;
        int c = 3 * (POINTS * body + k);
        double x = corners[c] - (reference ? places[3 * body] : state.objects[o]);
        double y = corners[c + 1] - (reference ? places[3 * body + 1] : state.objects[o + 1]);
        double z = corners[c + 2] - (reference ? places[3 * body + 2] : state.objects[o + 2]);
        double tx = wz * y - wy * z;
        double ty = wx * z - wz * x;
        double tz = wy * x - wx * y;
        raw[at] = wx;
        raw[at + 1] = wy;
        raw[at + 2] = wz;
        for (int i = 0; i < 3; i++) {
            raw[at + 3 + i] = !reference ? i == 0 ? tx : i == 1 ? ty : tz
                    : tx * ownTurn[9 * body + i] + ty * ownTurn[9 * body + 3 + i] + tz * ownTurn[9 * body + 6 + i];
        }
        if (ofGroup >= 0) {
            raw[ofGroup] = wx;
            raw[ofGroup + 1] = wy;
            raw[ofGroup + 2] = wz;
            for (int i = 0; i < 3; i++) {
                int g = 9 * body + i;
                raw[ofGroup + 3 + i] = wx * byGroupPlace[g] + wy * byGroupPlace[g + 3] + wz * byGroupPlace[g + 6]
                        + tx * byGroupTurn[g] + ty * byGroupTurn[g + 3] + tz * byGroupTurn[g + 6];
            }
        }
    }

    /** The camera's focal lengths are positive: a condition of the posterior. */
    static boolean isCamera(SurveyState state) {
        return state.lens[PinholeCamera.FX] > 0 && state.lens[PinholeCamera.FY] > 0;
    }
}
