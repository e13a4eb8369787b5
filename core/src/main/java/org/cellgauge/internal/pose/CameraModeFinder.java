package org.cellgauge.internal.pose;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.function.Predicate;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.geometry.RigidTransform;
import org.jspecify.annotations.Nullable;

/**
 * Modes of the camera's pose, or of its poses in several views, given all references: damped Gauss-Newton with the
 * placement errors of the references linearised, and the residual covariances frozen, at the mode itself; repeated
 * until all agree. Placement errors and unknown intrinsics are the same in all views.
 *
 * <p>Not thread-safe: it holds work space, so that all starts are followed in the same arrays. A mode does not depend
 * on those found before it, but for where a search is given up.
 */
public final class CameraModeFinder {
    private static final int MAX_FREEZES = 100;
    private static final double AGREEMENT = 1e-6;
    /** A mode with less than this share of the heaviest one's mass cannot change any figure shown. */
    private static final double NEGLIGIBLE_LOG_WEIGHT = -20;
    private static final double SAME_MODE_STDS = 1e-2;
    /** A search that comes this near to a known mode is taken to end there. */
    private static final double SAME_BASIN_STDS = 0.3;
    /** Half a chi-square more than the best mode's by this much, and no determinant makes up for it. */
    private static final double HOPELESS = 40;
    /** A start is in the basin of a pose at most this far, where the reference has only one pose, rad. */
    private static final double REACH_RAD = 0.1;
    /** Length in stated deviations beyond which a reference's placement error is not followed. */
    private static final double FARTHEST_STDS = 6;
    private static final double SMALLEST_SHARE = 0.25;
    private static final int ERROR = StateLayout.POSE;
    private static final double[] IDENTITY = {1, 0, 0, 0, 1, 0, 0, 0, 1};

    private final Observations view;
    private final PinholeCamera camera;
    private final ReferenceNoise noise;
    private final IntrinsicsPrior intrinsicsPrior;
    private final @Nullable PosePrior posePrior;
    private @Nullable Linearisation linearisation;
    private @Nullable ReprojectionFit fit;
    private @Nullable CameraState before;

    /**
     * A finder.
     *
     * @param view references seen, in one view or several
     * @param camera intrinsics; unknown ones start at these values
     * @param noise covariance of the residuals
     * @param intrinsicsPrior unknown intrinsics
     * @param posePrior prior of the pose, or null for a flat one
     */
    public CameraModeFinder(Observations view, PinholeCamera camera, ReferenceNoise noise,
            IntrinsicsPrior intrinsicsPrior, @Nullable PosePrior posePrior) {
        this.view = view;
        this.camera = camera;
        this.noise = noise;
        this.intrinsicsPrior = intrinsicsPrior;
        this.posePrior = posePrior;
    }

    /**
     * What residuals are weighed with.
     *
     * @return the noise about the nominal places
     */
    public ReferenceNoise noise() {
        return noise;
    }

    /**
     * Finds the modes.
     *
     * <p>Starts are the one given; the pose mirrored about the plane that fits all corners best (a set of references
     * that is nearly flat and small in the image may be seen mirrored: Schweighofer and Pinz, PAMI 2006); and the one
     * or two poses of every reference alone. A start that leads where another one has led is not followed.
     *
     * @param worldFromCamera start, of the only view
     * @return the modes with any weight, the heaviest first; empty if the start does not lead to a mode
     * @throws IllegalArgumentException if there are several views
     */
    public List<PoseMode> modes(RigidTransform worldFromCamera) {
        return modes(worldFromCamera, new MarkerPoseFinder());
    }

    /**
     * The same with a finder for the poses of every reference alone.
     *
     * @param worldFromCamera start, of the only view
     * @param alone of the caller's thread
     * @return the modes with any weight, the heaviest first; empty if the start does not lead to a mode
     * @throws IllegalArgumentException if there are several views
     */
    public List<PoseMode> modes(RigidTransform worldFromCamera, MarkerPoseFinder alone) {
        return modes(Collections.singletonList(worldFromCamera), alone);
    }

    /**
     * Finds the modes of several views. Other starts are tried in one view at a time, with the other views where the
     * first mode has them.
     *
     * @param worldFromCameras start, by view
     * @return the modes with any weight, the heaviest first; empty if the start does not lead to a mode
     * @throws IllegalArgumentException if there are not as many starts as views
     */
    public List<PoseMode> modes(List<RigidTransform> worldFromCameras) {
        return modes(worldFromCameras, new MarkerPoseFinder());
    }

    private List<PoseMode> modes(List<RigidTransform> worldFromCameras, MarkerPoseFinder alone) {
        if (worldFromCameras.size() != view.views()) {
            throw new IllegalArgumentException("needs a start for each of " + view.views() + " views");
        }
        List<RigidTransform> start = new ArrayList<>();
        for (RigidTransform worldFromCamera : worldFromCameras) {
            start.add(view.cameraFromSet(worldFromCamera));
        }
        PoseMode first = fitFrom(start, Collections.emptyList());
        if (first == null) {
            return Collections.emptyList();
        }
        List<PoseMode> found = new ArrayList<>();
        found.add(first);
        List<List<RigidTransform>> visited = new ArrayList<>();
        visited.add(poses(first));
        RigidTransform planeFromSet = NearestPlane.planeFromPoints(view.points());
        for (int v = 0; v < view.views(); v++) {
            RigidTransform cameraFromPlane = visited.get(0).get(v).compose(planeFromSet.inverse());
            follow(v, MarkerPoseFinder.mirrored(cameraFromPlane).compose(planeFromSet), found, visited);
            for (int m = 0; m < view.size(); m++) {
                List<RigidTransform> poses = posesOf(m, v, alone);
                double reach = poses.size() < 2 ? REACH_RAD : poses.get(0).angleRadTo(poses.get(1)) / 4;
                for (RigidTransform pose : poses) {
                    if (!near(v, pose, visited, reach)) {
                        follow(v, pose, found, visited);
                    }
                }
            }
        }
        found.sort((a, b) -> Double.compare(b.logWeight(), a.logWeight()));
        List<PoseMode> modes = new ArrayList<>();
        for (PoseMode mode : found) {
            if (mode.logWeight() - found.get(0).logWeight() > NEGLIGIBLE_LOG_WEIGHT) {
                modes.add(mode);
            }
        }
        return modes;
    }

    /**
     * The mode that one start leads to, and no other.
     *
     * @param worldFromCamera start, of the only view
     * @param hopeless half the chi-square beyond which it is not followed to its end
     * @return null where it leads to none
     */
    public @Nullable PoseMode mode(RigidTransform worldFromCamera, double hopeless) {
        return converged(state(Collections.singletonList(view.cameraFromSet(worldFromCamera))),
                linearisedAt(view.nominal()), Collections.emptyList(), hopeless, Collections.emptyList());
    }

    /**
     * The modes that are found from modes of another noise, for instance of the same references with more of it: each
     * mode is followed from where it was, and no other start is tried.
     *
     * @param others modes of the same view and unknowns
     * @return the modes that they lead to, the heaviest first; empty if none leads to a mode
     */
    public List<PoseMode> refined(List<PoseMode> others) {
        List<PoseMode> found = new ArrayList<>();
        for (PoseMode other : others) {
            CameraState state = other.state();
            state.noise = noise.noise();
            PoseMode mode = converged(state, linearisedAt(other.placed()), Collections.emptyList(),
                    Double.POSITIVE_INFINITY, found);
            if (mode != null) {
                found.add(mode);
            }
        }
        found.sort((a, b) -> Double.compare(b.logWeight(), a.logWeight()));
        return found;
    }

    /**
     * The mode of corners that are exactly where poses have them, references at their nominal places: nothing is
     * searched for.
     *
     * @param worldFromCameras camera in world, by view
     * @return the mode, or null where a corner is not in front of a camera, or the poses are not determined
     */
    public @Nullable PoseMode at(List<RigidTransform> worldFromCameras) {
        List<RigidTransform> poses = new ArrayList<>();
        for (RigidTransform worldFromCamera : worldFromCameras) {
            poses.add(view.cameraFromSet(worldFromCamera));
        }
        CameraState state = state(poses);
        Linearisation errors = linearisedAt(view.nominal());
        ReprojectionFit fit = fit(errors);
        return errors.freeze(state) && fit.freeze(errors.noise, state) ? fit.modeAt(state, view.nominal()) : null;
    }

    private static List<RigidTransform> poses(PoseMode mode) {
        List<RigidTransform> poses = new ArrayList<>();
        for (int v = 0; v < mode.layout().views(); v++) {
            poses.add(mode.cameraFromSet(v));
        }
        return poses;
    }

    /** Follows another pose in one view. */
    private void follow(int inView, RigidTransform pose, List<PoseMode> found, List<List<RigidTransform>> visited) {
        List<RigidTransform> start = new ArrayList<>(visited.get(0));
        start.set(inView, pose);
        visited.add(start);
        PoseMode mode = pose.translationMm()[2] > 0 ? fitFrom(start, found) : null;
        if (mode != null) {
            found.add(mode);
            visited.add(poses(mode));
        }
    }

    private static boolean near(int inView, RigidTransform pose, List<List<RigidTransform>> visited, double reachRad) {
        for (List<RigidTransform> other : visited) {
            if (pose.angleRadTo(other.get(inView)) < reachRad) {
                return true;
            }
        }
        return false;
    }

    /** The poses of the set in one view that explain one marker alone; none where it is not in it or is no marker. */
    private List<RigidTransform> posesOf(int marker, int inView, MarkerPoseFinder finder) {
        Body body = view.bodies().get(marker);
        List<RigidTransform> poses = new ArrayList<>();
        BlockLayout blocks = view.blocks();
        for (int time = 0; time < blocks.timesSeen(marker); time++) {
            if (blocks.view(marker, time) == inView && !Double.isNaN(body.markerSizeMm())) {
                RigidTransform markerFromSet = body.worldFromBody().inverse()
                        .compose(RigidTransform.of(IDENTITY, view.centroidMm()));
                int first = blocks.firstRow(marker) + 2 * blocks.points(marker) * time;
                double[] corners = Arrays.copyOfRange(view.observed(), first, first + 2 * blocks.points(marker));
                for (RigidTransform cameraFromMarker : finder.poses(corners, body.markerSizeMm(), camera)) {
                    poses.add(cameraFromMarker.compose(markerFromSet));
                }
            }
        }
        return poses;
    }

    private static boolean isKnown(CameraState state, List<PoseMode> known, double stds) {
        for (PoseMode mode : known) {
            if (mode.squaredStdsTo(state) < stds * stds) {
                return true;
            }
        }
        return false;
    }

    /**
     * The joint mode of pose, intrinsics and placement errors that a start leads to.
     *
     * <p>Placement errors d are linearised at d_m: {@code observed = projection(d_m) + J (d - d_m) + noise}. Integrated
     * out they leave residuals {@code projection(d_m) - J d_m - observed} with the covariance {@code J S J^T + C}; the
     * pose is fitted to these, and {@code d_m = -S J^T (J S J^T + C)^-1 residual} is what the residuals say of the
     * errors; what markers share is part of the residuals. Where both agree they are the mode of the joint
     * posterior, and the mass around it is that of Laplace's method with the errors as unknowns (matrix determinant
     * lemma).
     *
     * @param known modes found; the search is given up where it comes to one of these or lies hopelessly above them
     * @return null if there is none, it is one of those known, or the search is given up
     */
    private @Nullable PoseMode fitFrom(List<RigidTransform> cameraFromSets, List<PoseMode> known) {
        double hopeless = Double.POSITIVE_INFINITY;
        for (PoseMode mode : known) {
            hopeless = Math.min(hopeless, mode.halfChiSquare() + HOPELESS);
        }
        return converged(state(cameraFromSets), linearisedAt(view.nominal()), known, hopeless, known);
    }

    private CameraState state(List<RigidTransform> cameraFromSets) {
        CameraState state = CameraState.of(cameraFromSets, camera);
        state.unknowns = new double[view.unknowns()];
        state.noise = noise.noise();
        return state;
    }

    /** The work space with placement errors as they are at some place. */
    private Linearisation linearisedAt(PlacedReferences placed) {
        if (linearisation == null) {
            linearisation = new Linearisation();
        }
        linearisation.start(placed);
        return linearisation;
    }

    private ReprojectionFit fit(Linearisation errors) {
        if (fit == null) {
            fit = new ReprojectionFit(view.blocks(), errors.points, errors.observed, view.columns(), view.unknowns(),
                    intrinsicsPrior, posePrior);
        }
        return fit;
    }

    /** The same from a state; {@code same} are modes that it must not be one of. */
    private @Nullable PoseMode converged(CameraState state, Linearisation errors, List<PoseMode> known,
            double hopeless, List<PoseMode> same) {
        ReprojectionFit fit = fit(errors);
        if (before == null) {
            before = state.copy();
        }
        Predicate<CameraState> inBasin = known.isEmpty() ? null : at -> isKnown(at, known, SAME_BASIN_STDS);
        double cost = Double.NaN;
        for (int i = 0; i < MAX_FREEZES; i++) {
            before.copyFrom(state);
            if (!errors.freeze(state) || !fit.freeze(errors.noise, state)) {
                return null;
            }
            cost = fit.fit(state, inBasin);
            if (Double.isNaN(cost) || (i > 0 && cost > hopeless) || isKnown(state, known, SAME_BASIN_STDS)) {
                return null;
            }
            double squared = squaredStep(before, state, fit);
            if (squared < AGREEMENT * AGREEMENT && errors.agree(fit)) {
                break;
            }
            errors.move(fit);
        }
        return isKnown(state, same, SAME_MODE_STDS) ? null : PoseMode.of(fit, state, cost, errors.placed.copy());
    }

    private double squaredStep(CameraState before, CameraState state, ReprojectionFit fit) {
        double[] step = state.stepFrom(before);
        StateLayout layout = fit.layout();
        double squared = 0;
        for (int k = 0; k < layout.poses(); k++) {
            squared += step[k] * step[k] * fit.information()[k * fit.columns() + k];
        }
        for (int k = 0; k < layout.intrinsicsCount(); k++) {
            double d = state.intrinsics[intrinsicsPrior.index(k)] - before.intrinsics[intrinsicsPrior.index(k)];
            squared += d * d * fit.information()[(layout.intrinsics() + k) * (fit.columns() + 1)];
        }
        for (int k = 0; k < layout.sharedCount(); k++) {
            double d = state.unknowns[k] - before.unknowns[k];
            squared += d * d * fit.information()[(layout.shared() + k) * (fit.columns() + 1)];
        }
        return squared;
    }

    /** Placement errors on their way to those of a mode. */
    private final class Linearisation {
        final double[] points = view.pointsMm();
        final double[] observed = view.observedPx();
        /** Of its own, and moved. */
        final PlacedReferences placed = view.nominal().copy();
        final ReferenceNoise noise = CameraModeFinder.this.noise.about(placed);
        private final boolean rigid = CameraModeFinder.this.noise.hasRigidPlacement();
        private final BlockLayout blocks = view.blocks();
        private final int size = rigid ? ERROR * view.size() : 0;
        private final double[] jacobian = new double[rigid ? ERROR * blocks.firstRow(view.size()) : 0];
        private final double[] one = new double[rigid ? ERROR * blocks.mostRows() : 0];
        private final double[] byPlain = new double[blocks.mostRows()];
        private final double[] errors = new double[ERROR * view.size()];
        private final double[] byError = new double[ERROR];
        /** The errors in their stated deviations (the e of {@link Body#placementRoot}), and what residuals say. */
        private final double[] stated = new double[size];
        private final double[] wanted = new double[size];
        private double lastChange;
        private double share;

        /** Begins at a place. */
        void start(PlacedReferences start) {
            placed.set(start);
            System.arraycopy(view.points(), 0, points, 0, points.length);
            System.arraycopy(view.observed(), 0, observed, 0, observed.length);
            lastChange = Double.POSITIVE_INFINITY;
            share = 1;
            for (int k = 0; k < errors.length; k++) {
                errors[k] = start.error(k / ERROR, k % ERROR);
            }
            for (int m = 0; m < size / ERROR; m++) {
                Body body = view.bodies().get(m);
                for (int i = 0; i < ERROR; i++) {
                    double left = errors[ERROR * m + i];
                    for (int k = 0; k < i; k++) {
                        left -= body.placementRoot(i, k) * stated[ERROR * m + k];
                    }
                    // an error of no deviation is zero
                    stated[ERROR * m + i] = left == 0 ? 0 : left / body.placementRoot(i, i);
                }
            }
        }

        /** Linearises at the errors as they are, and at a state. */
        boolean freeze(CameraState state) {
            if (!rigid) {
                return true;
            }
            System.arraycopy(placed.points(), 0, points, 0, points.length);
            for (int m = 0; m < view.size(); m++) {
                if (!noise.placementJacobian(state, m, one)) {
                    return false;
                }
                int first = blocks.firstRow(m);
                System.arraycopy(one, 0, jacobian, ERROR * first, ERROR * blocks.rows(m));
                for (int i = 0; i < blocks.rows(m); i++) {
                    double moved = 0;
                    for (int c = 0; c < ERROR; c++) {
                        moved += one[ERROR * i + c] * errors[ERROR * m + c];
                    }
                    observed[first + i] = view.observed()[first + i] + moved;
                }
            }
            return true;
        }

        /** Whether the residuals of a fit say that the errors are what they are taken for. */
        boolean agree(ReprojectionFit fit) {
            return !rigid || change(fit) < AGREEMENT;
        }

        /** Length of the change that the residuals ask for, in stated deviations. */
        private double change(ReprojectionFit fit) {
            double squares = 0;
            for (int m = 0; m < view.size(); m++) {
                int rows = blocks.rows(m);
                int first = blocks.firstRow(m);
                Arrays.fill(byPlain, 0);
                for (int i = 0; i < rows; i++) {
                    for (int k = 0; k <= i; k++) {
                        byPlain[k] += fit.whitening()[blocks.firstEntry(m) + rows * i + k] * fit.residuals()[first + i];
                    }
                }
                for (int c = 0; c < ERROR; c++) {
                    double sum = 0;
                    for (int i = 0; i < rows; i++) {
                        sum -= jacobian[ERROR * (first + i) + c] * byPlain[i];
                    }
                    byError[c] = sum;
                }
                Body body = view.bodies().get(m);
                double length = 0;
                for (int c = 0; c < ERROR; c++) {
                    double e = 0;
                    for (int k = c; k < ERROR; k++) {
                        e += byError[k] * body.placementRoot(k, c);
                    }
                    wanted[ERROR * m + c] = e;
                    length += e * e;
                }
                // a foreign marker must not be followed wherever its corners are: any point of linearisation is valid
                double shrink = Math.min(1, FARTHEST_STDS / Math.sqrt(length));
                for (int c = ERROR * m; c < ERROR * (m + 1); c++) {
                    wanted[c] = length > 0 ? wanted[c] * shrink : 0;
                    squares += (wanted[c] - stated[c]) * (wanted[c] - stated[c]);
                }
            }
            return Math.sqrt(squares);
        }

        /** Moves the errors to where the residuals say they are; less far while that does not settle. */
        void move(ReprojectionFit fit) {
            if (!rigid) {
                return;
            }
            double change = change(fit);
            if (change > 0.5 * lastChange) {
                share = Math.max(SMALLEST_SHARE, share / 2);
            }
            lastChange = change;
            for (int k = 0; k < size; k++) {
                stated[k] += share * (wanted[k] - stated[k]);
            }
            for (int m = 0; m < view.size(); m++) {
                Body body = view.bodies().get(m);
                for (int i = 0; i < ERROR; i++) {
                    double error = 0;
                    for (int k = 0; k <= i; k++) {
                        error += stated[ERROR * m + k] * body.placementRoot(i, k);
                    }
                    errors[ERROR * m + i] = error;
                }
            }
            placed.set(view, errors);
        }
    }
}
