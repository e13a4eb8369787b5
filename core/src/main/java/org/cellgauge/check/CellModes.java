package org.cellgauge.check;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import org.cellgauge.cell.Cell;
import org.cellgauge.cell.InputRefusedException;
import org.cellgauge.cell.ObjectMarker;
import org.cellgauge.cell.Reference;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.internal.laplace.CameraFit;
import org.cellgauge.internal.laplace.LinearModel;
import org.cellgauge.internal.laplace.ObjectFit;
import org.cellgauge.internal.pose.AddedNoise;
import org.cellgauge.internal.pose.CameraState;
import org.cellgauge.internal.pose.CornerErrors;
import org.cellgauge.internal.pose.InitialPose;
import org.cellgauge.internal.pose.IntrinsicsPrior;
import org.cellgauge.internal.pose.MarkerPoseFinder;
import org.cellgauge.internal.pose.NoiseBelief;
import org.cellgauge.internal.pose.PoseMode;
import org.cellgauge.internal.pose.PosePrior;
import org.cellgauge.internal.pose.ReferenceView;
import org.cellgauge.internal.pose.StateLayout;
import org.cellgauge.internal.statistics.CoverageRegion;
import org.cellgauge.internal.warning.CheckPhrase;
import org.cellgauge.internal.warning.Decimal;
import org.cellgauge.internal.warning.Listing;
import org.cellgauge.placement.Cause;
import org.cellgauge.placement.Contradiction;
import org.cellgauge.placement.Explanation;
import org.cellgauge.placement.Overlap;
import org.cellgauge.placement.ReferenceCheck;
import org.cellgauge.placement.WrongCorner;
import org.cellgauge.settings.CheckSettings;
import org.cellgauge.settings.InitialEstimate;
import org.cellgauge.settings.LikelihoodModel;
import org.cellgauge.settings.ObjectNoise;
import org.cellgauge.vision.Detections;
import org.cellgauge.vision.MarkerObservation;
import org.cellgauge.warning.CheckRefusal;
import org.cellgauge.warning.CheckWarning;
import org.cellgauge.warning.Warning;
import org.jspecify.annotations.Nullable;

/**
 * The second stage of a check: the poses of camera and objects that explain the photo best; immutable.
 */
final class CellModes {
    /** A mode with less than this share by Laplace's method is not followed. */
    private static final double NEGLIGIBLE_SHARE = 1e-4;
    /**
     * Mean square of whitened residuals (8 per reference) beyond which a reference is no misplaced one but a wrong one.
     */
    private static final double FOREIGN_MEAN_SQUARE = 50;
    /** Nodes of the grid of the added noise from one fit of the camera pose to the next. */
    private static final int NOISE_STRIDE = 5;
    /** Logarithm of the mass, against the most, at which the noise is followed no further. */
    private static final double NEGLIGIBLE_LOG_NOISE = 12;
    /** Quantile of chi-square within which the residuals at a mode must be for a given start to count as a good one. */
    private static final double EXPLAINED = 0.999;
    private static final double SMALLEST_SIDE_PX = 25;
    private static final double ADVISED_SIDE_PX = 32;
    /**
     * Side in px times squared deviation of the turn in rad over corner noise in px: simulated cells of four references
     * cover as stated to 22, and no longer at 60.
     */
    private static final double LARGEST_BEND = 20;
    /** Length of stated deviations, as a share of the distance from the camera, from which on it is said. */
    private static final double WIDE_SHARE = 0.05;
    /**
     * The same from which on nothing is said but that: simulated cells of four references cover as stated to 12 %, hold
     * the camera in 91 % at 15 % (one in 200 is off by 8 deviations), in 87 % at 19 % and in 77 % at 28 %.
     */
    private static final double LARGEST_SHARE = 0.12;
    /** Deviation of a focal length, as a share of it, beyond which nothing may be left open of it beforehand. */
    private static final double LARGEST_FOCAL_SHARE = 0.2;
    /** Share of the pose prior in any direction above which the result is said to lean on it. */
    private static final double LEANING_SHARE = 0.01;

    final Observed observed;
    final CameraFit camera;
    /** The objects seen, in the order of the cell. */
    final List<ObjectFit> objects;
    /** All warnings so far. */
    final List<Warning> warnings;
    /** What was found where no pose makes sense of the references as stated; null where one does. */
    private final @Nullable Contradiction contradiction;

    private CellModes(Observed observed, CameraFit camera, List<ObjectFit> objects, List<Warning> warnings,
            @Nullable Contradiction contradiction) {
        this.observed = observed;
        this.contradiction = contradiction;
        this.camera = camera;
        this.objects = Collections.unmodifiableList(objects);
        this.warnings = Collections.unmodifiableList(warnings);
    }

    /**
     * Finds the modes.
     *
     * @param observed what the photo shows
     * @param worldFromCameraStart where to look first; null for the initial estimate of the settings
     * @param finder of the caller's thread
     * @return the modes
     * @throws InputRefusedException if no pose explains the corners
     */
    static CellModes of(Observed observed, @Nullable RigidTransform worldFromCameraStart, MarkerPoseFinder finder) {
        Observed as = observed;
        CellModes found = new Search(as, worldFromCameraStart, finder).found();
        for (int k = 1; k < found.camera.view.size(); k++) {
            WrongCorner wrong = found.wrongCorner();
            if (wrong == null) {
                break;
            }
            as = as.without(wrong);
            found = new Search(as, worldFromCameraStart, finder).found();
        }
        return found;
    }

    private @Nullable WrongCorner wrongCorner() {
        return contradiction != null || observed.settings.model().likelihood() != LikelihoodModel.RIGID_MARKER
                ? null : WrongCorner.in(camera);
    }

    /** What the weak prior of the camera pose is called; null where there is none. */
    @Nullable String posePriorText() {
        return camera.posePrior == null ? null : weakPrior().toString();
    }

    /** What is said where the result leans on the weak prior of the camera pose; null where it does not. */
    @Nullable Warning directionOpen() {
        if (camera.posePrior == null || contradiction != null) {
            return null;
        }
        double share = LinearModel.priorShare(camera.mode(), PosePrior.WEAK_STD_MM, PosePrior.WEAK_STD_RAD);
        return share < LEANING_SHARE ? null
                : Warning.of(CheckWarning.DIRECTION_OPEN, Decimal.of(100 * share, 0), weakPrior());
    }

    /** Tests whether references and corners are as stated; no chains are needed for it. */
    ReferenceCheck references() {
        return ReferenceCheck.of(atNoise(camera, observed), objects, observed.noiseFit,
                Overlap.among(observed.cell, observed.detections), contradiction);
    }

    /** The camera as it is fitted where corners are noisier than stated, so that no reference is accused for them. */
    private static CameraFit atNoise(CameraFit camera, Observed observed) {
        Map<Integer, Double> inflation = observed.noiseFit.inflation();
        if (inflation.isEmpty() || observed.settings.model().likelihood() != LikelihoodModel.RIGID_MARKER) {
            return camera;
        }
        CameraFit noisier = camera.with(observed.errors.inflated(inflation));
        if (camera.modes.isEmpty()) {
            return noisier;
        }
        List<PoseMode> modes = noisier.finder(camera.view).refined(camera.modes);
        return modes.isEmpty() ? camera : noisier.at(modes);
    }

    private static Warning weakPrior() {
        return Warning.of(CheckPhrase.WEAK_PRIOR, Decimal.of(PosePrior.WEAK_STD_MM, 0),
                Decimal.of(PosePrior.WEAK_STD_RAD, 1));
    }

    /** The ids of some references. */
    static List<Integer> ids(ReferenceView view) {
        List<Integer> ids = new ArrayList<>();
        view.references().forEach(r -> ids.add(r.id()));
        return ids;
    }

    private static List<PoseMode> notNegligible(List<PoseMode> modes) {
        List<PoseMode> kept = new ArrayList<>();
        for (PoseMode mode : modes) {
            if (Math.exp(mode.logWeight() - modes.get(0).logWeight()) > NEGLIGIBLE_SHARE) {
                kept.add(mode);
            }
        }
        return kept;
    }

    /** The search for the modes of one photo. */
    private static final class Search {
        private final Observed observed;
        private final Cell cell;
        private final Detections detections;
        private final CheckSettings settings;
        private final CornerErrors errors;
        private final @Nullable RigidTransform worldFromCameraStart;
        private final List<Warning> warnings;
        private final MarkerPoseFinder finder;
        private @Nullable Contradiction contradiction;

        Search(Observed observed, @Nullable RigidTransform worldFromCameraStart, MarkerPoseFinder finder) {
            this.finder = finder;
            this.observed = observed;
            this.worldFromCameraStart = worldFromCameraStart;
            cell = observed.cell;
            detections = observed.detections;
            settings = observed.settings;
            errors = observed.errors;
            warnings = new ArrayList<>(observed.warnings);
        }

        CellModes found() {
            ReferenceView view = ReferenceView.of(cell.references(), errors);
            CameraFit camera = withNoise(cameraFit(view, IntrinsicsPrior.stated(cell, settings.model())));
            requireFocalLength(camera);
            CameraState atMode = camera.mode().state();
            List<ObjectFit> objects = new ArrayList<>();
            List<Integer> missing = new ArrayList<>();
            for (ObjectMarker marker : cell.objects()) {
                if (errors.has(marker.id())) {
                    objects.add(objectFit(marker, atMode));
                } else {
                    missing.add(marker.id());
                }
            }
            if (!missing.isEmpty()) {
                warnings.add(Warning.of(CheckWarning.OBJECTS_NOT_SEEN, Listing.and(missing)));
            }
            warnOfSmallMarkers();
            if (contradiction == null) {
                // of a camera that makes no sense, distances say nothing
                judgePlacements(camera);
            }
            return new CellModes(observed, camera, objects, warnings, contradiction);
        }

        /**
         * A flat prior leaves a tail that no mode shows: as the focal length goes to infinity, and the distance with
         * it, the image becomes that of a parallel projection, and the likelihood does not go to zero.
         */
        private void requireFocalLength(CameraFit camera) {
            if (!camera.intrinsicsPrior.isFlat() || contradiction != null) {
                return;
            }
            PoseMode mode = camera.mode();
            double std = Math.sqrt(mode.covariance()[StateLayout.POSE * (mode.dimension() + 1)]);
            double share = std / mode.state().intrinsics[PinholeCamera.FX];
            if (share > LARGEST_FOCAL_SHARE) {
                throw new InputRefusedException(detections.imageName(), CheckRefusal.FLAT_FOCAL_OPEN,
                        Decimal.of(100 * share, 0));
            }
        }

        /** One warning for all markers of the cell that the image shows too small. */
        private void warnOfSmallMarkers() {
            List<Warning> small = new ArrayList<>();
            Set<Integer> ofCell = new HashSet<>();
            cell.references().forEach(reference -> ofCell.add(reference.id()));
            cell.objects().forEach(object -> ofCell.add(object.id()));
            for (MarkerObservation m : detections.markers()) {
                if (ofCell.contains(m.id()) && m.shortestSidePx() < SMALLEST_SIDE_PX) {
                    small.add(Warning.of(CheckPhrase.SMALL_MARKER, m.id(), Decimal.of(m.shortestSidePx(), 1)));
                }
            }
            if (!small.isEmpty()) {
                warnings.add(Warning.of(CheckWarning.SMALL_MARKERS, Listing.comma(small),
                        Decimal.of(SMALLEST_SIDE_PX, 0), Decimal.of(ADVISED_SIDE_PX, 0)));
            }
        }

        /** What a model that is linear in placement errors cannot say, or not for sure. */
        private void judgePlacements(CameraFit camera) {
            if (settings.model().likelihood() == LikelihoodModel.RIGID_MARKER) {
                warnOfWidePlaces(camera);
                warnOfLooseTurns(camera);
            }
        }

        private void warnOfWidePlaces(CameraFit camera) {
            double[] position = camera.worldFromCamera().translationMm();
            List<Integer> wide = new ArrayList<>();
            double most = 0;
            for (Reference reference : camera.view.references()) {
                double[] place = reference.worldFromMarker().translationMm();
                double stated = 0;
                double distance = 0;
                for (int i = 0; i < 3; i++) {
                    stated = Math.hypot(stated, reference.placement().stdMm(i));
                    distance = Math.hypot(distance, place[i] - position[i]);
                }
                double share = stated / distance;
                if (share > LARGEST_SHARE) {
                    throw new InputRefusedException(detections.imageName(), CheckRefusal.PLACE_UNKNOWN,
                            reference.id(), Decimal.of(stated, 0), Decimal.of(100 * share, 0),
                            Decimal.of(distance, 0), Decimal.of(100 * LARGEST_SHARE, 0));
                }
                if (share > WIDE_SHARE) {
                    wide.add(reference.id());
                    most = Math.max(most, share);
                }
            }
            if (!wide.isEmpty()) {
                warnings.add(Warning.of(CheckWarning.PLACES_WIDE, Listing.and(wide), Decimal.of(100 * most, 0)));
            }
        }

        /**
         * A reference turned by r shortens one side of its image by about {@code side r² / 2}: what no linear model of
         * the turn sees. Linearised at the turn that the photo shows, the rest of it is what the photo leaves open of
         * that turn.
         */
        private void warnOfLooseTurns(CameraFit camera) {
            List<Integer> loose = new ArrayList<>();
            double most = 0;
            for (Reference reference : camera.view.references()) {
                double std = reference.placement().stdRad();
                double sidePx = Objects.requireNonNull(detections.find(reference.id()), "what is fitted was seen")
                        .shortestSidePx();
                double bend = sidePx * std * std
                        / Math.sqrt(errors.meanVariancePx2(reference.id(), camera.noiseLevel));
                if (bend > LARGEST_BEND) {
                    loose.add(reference.id());
                    most = Math.max(most, bend);
                }
            }
            if (!loose.isEmpty()) {
                warnings.add(Warning.of(CheckWarning.TURNS_TOO_LOOSE, Listing.and(loose), Decimal.of(most, 0),
                        Decimal.of(LARGEST_BEND, 0)));
            }
        }

        /** The camera with what squareness and references say of the added noise, its modes at the mean of that. */
        private CameraFit withNoise(CameraFit fit) {
            if (errors.added() == null) {
                return fit;
            }
            List<Integer> others = errors.ids();
            // references that stay speak through their likelihood
            others.removeAll(ids(fit.view));
            double[] logNoise = errors.logNoise(others);
            int middle = AddedNoise.node(fit.noiseLevel);
            int count = AddedNoise.NODES;
            double[] log = new double[count];
            Arrays.fill(log, Double.NEGATIVE_INFINITY);
            log[middle] = logNoise[middle] + logMass(fit, middle);
            double most = log[middle];
            for (int direction = -1; direction <= 1; direction += 2) {
                int last = middle;
                double mass = log[middle] - logNoise[middle];
                for (int node = middle + direction * NOISE_STRIDE; node >= 0 && node < count;
                        node += direction * NOISE_STRIDE) {
                    if (!errors.isNegligible(AddedNoise.atNode(node))) {
                        mass = logMass(fit, node);
                    }
                    for (int k = 1; k <= NOISE_STRIDE; k++) {
                        // what references say is smooth in the noise; what is cheap to know is not interpolated
                        int between = last + direction * k;
                        double share = (double) k / NOISE_STRIDE;
                        log[between] = logNoise[between] + (1 - share) * (log[last] - logNoise[last]) + share * mass;
                    }
                    most = Math.max(most, log[node]);
                    last = node;
                    if (log[node] < most - NEGLIGIBLE_LOG_NOISE) {
                        break;
                    }
                }
            }
            NoiseBelief belief = new NoiseBelief(errors.added(), log);
            CameraFit noisy = fit.with(belief, belief.ofMeanVariance(), logNoise);
            List<PoseMode> modes = noisy.finder(fit.view).modes(fit.worldFromCamera(), finder);
            if (errors.fromNothing()) {
                warnings.add(Observed.noiseWarning(belief));
            }
            return noisy.at(notNegligible(modes.isEmpty() ? fit.modes : modes));
        }

        /**
         * Logarithm of the mass of the camera's posterior at an added noise, by Laplace's method: about the modes known
         * already, since the noise moves modes and weighs them and hardly makes any.
         */
        private static double logMass(CameraFit fit, int node) {
            List<PoseMode> modes = fit.finder(fit.view, AddedNoise.atNode(node)).refined(fit.modes);
            if (modes.isEmpty()) {
                return Double.NEGATIVE_INFINITY;
            }
            double sum = 0;
            for (PoseMode mode : modes) {
                sum += Math.exp(mode.logWeight() - modes.get(0).logWeight());
            }
            return modes.get(0).logWeight() + Math.log(sum);
        }

        private CameraFit cameraFit(ReferenceView all, IntrinsicsPrior intrinsics) {
            CameraFit fit = searched(all, intrinsics);
            if (fit.modes.isEmpty()) {
                return asExplained(fit);
            }
            boolean foreign = foreignReference(fit) >= 0;
            if (settings.model().likelihood() == LikelihoodModel.RIGID_MARKER && Contradiction.isSuspected(fit)) {
                Contradiction found = Contradiction.of(atNoise(fit, observed));
                if (found == null) {
                    // corners that are noisier than stated explain it, and have a warning of their own
                    return fit;
                }
                Explanation best = found.explanation();
                if (best != null && best.cause() == Cause.REFERENCE_ELSEWHERE && best.orInstead().isEmpty()) {
                    if (!foreign) {
                        return fit;
                    }
                    int id = best.references().get(0);
                    warnings.add(Warning.of(CheckWarning.REFERENCE_LEFT_OUT, id));
                    return cameraFitOf(without(all, indexOf(all, id)), intrinsics);
                }
                if (best != null && (foreign || best.cause().isOutright())) {
                    contradiction = found;
                    CameraFit explained = found.asExplained(fit);
                    return explained != fit ? explained : agreeing(fit, intrinsics);
                }
            }
            return foreign ? withoutForeign(fit, intrinsics) : fit;
        }

        /** Leaves out what lies far off, one reference after another, while most of them stay. */
        private CameraFit withoutForeign(CameraFit all, IntrinsicsPrior intrinsics) {
            CameraFit fit = all;
            int foreign = foreignReference(fit);
            while (foreign >= 0) {
                if (fit.view.size() < 3 || 2 * (fit.view.size() - 1) <= all.view.size()) {
                    boolean rigid = settings.model().likelihood() == LikelihoodModel.RIGID_MARKER;
                    contradiction = rigid ? Contradiction.UNEXPLAINED : null;
                    return rigid ? agreeing(fit, intrinsics) : fit;
                }
                warnings.add(Warning.of(CheckWarning.REFERENCE_LEFT_OUT, fit.view.references().get(foreign).id()));
                fit = cameraFitOf(without(fit.view, foreign), intrinsics);
                foreign = foreignReference(fit);
            }
            return fit;
        }

        /**
         * What the chains of references in contradiction run on, so that they can start at all, where they are not as
         * something explains: those that make sense together. No figure of theirs is shown, so that none is said to be
         * left out.
         */
        private CameraFit agreeing(CameraFit all, IntrinsicsPrior intrinsics) {
            CameraFit fit = all;
            for (int foreign = foreignReference(fit); foreign >= 0 && fit.view.size() > 1;
                    foreign = foreignReference(fit)) {
                CameraFit fewer = searched(without(fit.view, foreign), intrinsics);
                if (fewer.modes.isEmpty()) {
                    return fit;
                }
                fit = fewer;
            }
            return fit;
        }

        private static int indexOf(ReferenceView view, int id) {
            int m = 0;
            while (view.references().get(m).id() != id) {
                m++;
            }
            return m;
        }

        /** The references but for one. */
        private static ReferenceView without(ReferenceView view, int leftOut) {
            List<Integer> kept = new ArrayList<>();
            for (int m = 0; m < view.size(); m++) {
                if (m != leftOut) {
                    kept.add(m);
                }
            }
            return view.only(kept);
        }

        /**
         * The camera where no pose fits the references as stated, if they are as something explains it: chains have
         * something to run on, and no figure of theirs is shown.
         */
        private CameraFit asExplained(CameraFit unfitted) {
            if (settings.model().likelihood() == LikelihoodModel.RIGID_MARKER) {
                contradiction = Contradiction.ofNoPose(atNoise(unfitted, observed));
            }
            if (contradiction == null) {
                throw noPose();
            }
            return contradiction.asExplained(unfitted);
        }

        private CameraFit cameraFitOf(ReferenceView view, IntrinsicsPrior intrinsics) {
            CameraFit fit = searched(view, intrinsics);
            if (fit.modes.isEmpty()) {
                throw noPose();
            }
            return fit;
        }

        /** The camera from some references; without modes where no pose fits them. */
        private CameraFit searched(ReferenceView view, IntrinsicsPrior intrinsics) {
            boolean needsPosePrior = settings.model().posePriorAllowed() && PosePrior.isNeededFor(view.size());
            if (worldFromCameraStart != null && !needsPosePrior) {
                CameraFit fromStart = fitFromStart(view, worldFromCameraStart, intrinsics);
                if (fromStart != null) {
                    return fromStart;
                }
            }
            PinholeCamera start = IntrinsicsPrior.start(cell.camera(), settings);
            RigidTransform initial = InitialPose.of(settings.sampling().initial()).estimate(view, start);
            if (initial == null) {
                initial = InitialPose.PNP.estimate(view, start);
                if (initial == null) {
                    throw noPose();
                }
                warnings.add(Warning.of(CheckWarning.INITIAL_ESTIMATE_FAILED, settings.sampling().initial().word()));
            }
            PosePrior posePrior = null;
            if (needsPosePrior) {
                posePrior = PosePrior.weak(CameraState.of(view.cameraFromSet(initial), start));
            }
            CameraFit fit = new CameraFit(cell.camera(), settings, view, intrinsics, posePrior, errors,
                    observed.noiseLevel);
            List<PoseMode> modes = fit.finder(view).modes(initial, finder);
            if (modes.isEmpty() && settings.sampling().initial() != InitialEstimate.PNP) {
                RigidTransform other = InitialPose.PNP.estimate(view, start);
                modes = other == null ? modes : fit.finder(view).modes(other, finder);
            }
            return modes.isEmpty() ? fit : fit.at(notNegligible(modes), initial);
        }

        /** The camera at the modes that the start leads to; null where they leave more unexplained than noise would. */
        private @Nullable CameraFit fitFromStart(ReferenceView view, RigidTransform start, IntrinsicsPrior intrinsics) {
            CameraFit fit = new CameraFit(cell.camera(), settings, view, intrinsics, null, errors, observed.noiseLevel);
            List<PoseMode> modes = fit.finder(view).modes(start, finder);
            if (modes.isEmpty() || 2 * modes.get(0).halfChiSquare()
                    > CoverageRegion.chiSquareQuantile(EXPLAINED, 8 * view.size() - 6)) {
                return null;
            }
            return fit.at(notNegligible(modes), start);
        }

        private InputRefusedException noPose() {
            return new InputRefusedException(detections.imageName(), CheckRefusal.NO_CAMERA_POSE);
        }

        private static int foreignReference(CameraFit fit) {
            PoseMode mode = fit.mode();
            int worst = -1;
            double most = 8 * FOREIGN_MEAN_SQUARE;
            for (int m = 0; m < fit.view.size(); m++) {
                if (mode.chiSquareOf(m) > most) {
                    most = mode.chiSquareOf(m);
                    worst = m;
                }
            }
            return worst;
        }

        private ObjectFit objectFit(ObjectMarker marker, CameraState atMode) {
            List<PoseMode> modes = ObjectFit.modes(marker, errors, atMode, finder);
            if (modes.isEmpty()) {
                throw new InputRefusedException(detections.imageName(), CheckRefusal.NO_OBJECT_POSE, marker.id());
            }
            boolean noisy = settings.model().objectNoise() == ObjectNoise.DETECTION;
            modes = noisy ? notNegligible(modes) : modes.subList(0, 1);
            return new ObjectFit(marker, errors, atMode, modes);
        }
    }
}
