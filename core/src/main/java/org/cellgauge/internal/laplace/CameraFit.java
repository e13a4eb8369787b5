package org.cellgauge.internal.laplace;

import java.util.List;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.internal.pose.CameraModeFinder;
import org.cellgauge.internal.pose.CameraState;
import org.cellgauge.internal.pose.CornerErrors;
import org.cellgauge.internal.pose.IntrinsicsPrior;
import org.cellgauge.internal.pose.NoiseBelief;
import org.cellgauge.internal.pose.PoseMode;
import org.cellgauge.internal.pose.PosePrior;
import org.cellgauge.internal.pose.ReferenceNoise;
import org.cellgauge.internal.pose.ReferenceView;
import org.cellgauge.settings.CheckSettings;
import org.jspecify.annotations.Nullable;

/**
 * The camera of one photo fitted to its references: what they show, how it is modelled, and the modes that came of it;
 * immutable.
 */
public final class CameraFit {
    /** The camera as calibrated. */
    public final PinholeCamera lens;
    /** Where the search for unknown intrinsics starts; the others are as calibrated. */
    private final PinholeCamera start;
    /** How the cell is modelled. */
    public final CheckSettings settings;
    /** The references seen. */
    public final ReferenceView view;
    /** Prior of the unknown intrinsics. */
    public final IntrinsicsPrior intrinsicsPrior;
    /** Prior of the camera pose; null where it is flat. */
    public final @Nullable PosePrior posePrior;
    /** Errors of the corners, px. */
    public final CornerErrors errors;
    /** The added noise that the modes are found at: the u of {@link org.cellgauge.internal.pose.AddedNoise}. */
    public final double noiseLevel;
    /** Heaviest first; empty before they are found. */
    public final List<PoseMode> modes;
    /** The initial estimate, x_world = worldFromCamera · x_camera, mm; null before the modes are found. */
    private final @Nullable RigidTransform initialWorldFromCamera;
    /** What is known of the added noise; null where it is stated. */
    public final @Nullable NoiseBelief belief;
    /** The same without what the references say, by node; null where it is stated. */
    public final double @Nullable [] logNoise;

    /**
     * A camera whose modes are yet to be found.
     *
     * @param lens the camera as calibrated
     * @param settings how the cell is modelled
     * @param view the references seen
     * @param posePrior prior of the pose; null where it is flat
     * @param errors errors of the corners
     * @param noiseLevel the added noise to fit at
     */
    public CameraFit(PinholeCamera lens, CheckSettings settings, ReferenceView view, IntrinsicsPrior intrinsicsPrior,
            @Nullable PosePrior posePrior, CornerErrors errors, double noiseLevel) {
        this(lens, IntrinsicsPrior.start(lens, settings), settings, view, intrinsicsPrior, posePrior, errors,
                noiseLevel, List.of(), null, null, null);
    }

    private CameraFit(PinholeCamera lens, PinholeCamera start, CheckSettings settings, ReferenceView view,
            IntrinsicsPrior intrinsicsPrior, @Nullable PosePrior posePrior, CornerErrors errors, double noiseLevel,
            List<PoseMode> modes, @Nullable RigidTransform initialWorldFromCamera, @Nullable NoiseBelief belief,
            double @Nullable [] logNoise) {
        this.lens = lens;
        this.start = start;
        this.settings = settings;
        this.view = view;
        this.intrinsicsPrior = intrinsicsPrior;
        this.posePrior = posePrior;
        this.errors = errors;
        this.noiseLevel = noiseLevel;
        this.modes = modes;
        this.initialWorldFromCamera = initialWorldFromCamera;
        this.belief = belief;
        this.logNoise = logNoise;
    }

    /** The same camera at its modes, found from an initial estimate. */
    public CameraFit at(List<PoseMode> found, RigidTransform initial) {
        return new CameraFit(lens, start, settings, view, intrinsicsPrior, posePrior, errors, noiseLevel, found,
                initial, belief, logNoise);
    }

    /** The same camera at other modes, the initial estimate being what it was. */
    public CameraFit at(List<PoseMode> found) {
        return new CameraFit(lens, start, settings, view, intrinsicsPrior, posePrior, errors, noiseLevel, found,
                initialWorldFromCamera, belief, logNoise);
    }

    /** The same camera from other references, at the modes found for them. */
    public CameraFit with(ReferenceView other, List<PoseMode> otherModes) {
        return new CameraFit(lens, start, settings, other, intrinsicsPrior, posePrior, errors, noiseLevel,
                otherModes, initialWorldFromCamera, belief, logNoise);
    }

    /** The same camera with what is known of the added noise; its modes are yet to be found again. */
    public CameraFit with(NoiseBelief known, double level, double[] logWithoutReferences) {
        return new CameraFit(lens, start, settings, view, intrinsicsPrior, posePrior, errors, level, modes,
                initialWorldFromCamera, known, logWithoutReferences);
    }

    /** The same camera with other errors of the corners, as if they were stated. */
    public CameraFit with(CornerErrors other) {
        return new CameraFit(lens, start, settings, view, intrinsicsPrior, posePrior, other, noiseLevel, modes,
                initialWorldFromCamera, null, null);
    }

    /** How far the corners of references may be off, at an added noise. */
    public ReferenceNoise noise(ReferenceView of, double level) {
        return ReferenceNoise.of(settings.model(), of, errors, level);
    }

    /** Finds the modes from some references, at an added noise. */
    public CameraModeFinder finder(ReferenceView from, double level) {
        return new CameraModeFinder(from, start, noise(from, level), intrinsicsPrior, posePrior);
    }

    /** Finds the modes from some references, at the added noise of this fit. */
    public CameraModeFinder finder(ReferenceView from) {
        return finder(from, noiseLevel);
    }

    /** The heaviest mode. */
    public PoseMode mode() {
        return modes.get(0);
    }

    /** Where the camera stands by the heaviest mode. */
    public RigidTransform worldFromCamera() {
        return view.worldFromCamera(mode().state().cameraFromSet());
    }

    /** The initial estimate as a state; its intrinsics are those that the search starts at. */
    public CameraState initialState() {
        if (initialWorldFromCamera == null) {
            throw new IllegalStateException("the modes are yet to be found");
        }
        CameraState state = modes.get(0).state();
        RigidTransform cameraFromSet = view.cameraFromSet(initialWorldFromCamera);
        System.arraycopy(cameraFromSet.rotation(), 0, state.rotation, 0, 9);
        System.arraycopy(cameraFromSet.translationMm(), 0, state.offset, 0, 3);
        for (int i = 0; i < intrinsicsPrior.count(); i++) {
            state.intrinsics[intrinsicsPrior.index(i)] = start.get(intrinsicsPrior.index(i));
        }
        return state;
    }
}
