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

/**
 * The camera of one photo fitted to its references: what they show, how it is modelled, and the modes that came of it;
 * immutable.
 */
public final class CameraFit {
    /** The camera as calibrated. */
    public final PinholeCamera lens;
    /** How the cell is modelled. */
    public final CheckSettings settings;
    /** The references seen. */
    public final ReferenceView view;
    /** Prior of the unknown intrinsics. */
    public final IntrinsicsPrior intrinsicsPrior;
    /** Prior of the camera pose; null where it is flat. */
    public final PosePrior posePrior;
    /** Errors of the corners, px. */
    public final CornerErrors errors;
    /** The added noise that the modes are found at: the u of {@link org.cellgauge.internal.pose.AddedNoise}. */
    public final double noiseLevel;
    /** Heaviest first; empty before they are found. */
    public final List<PoseMode> modes;
    /** The initial estimate, x_world = worldFromCamera · x_camera, mm; null before the modes are found. */
    public final RigidTransform initialWorldFromCamera;
    /** What is known of the added noise; null where it is stated. */
    public final NoiseBelief belief;
    /** The same without what the references say, by node; null where it is stated. */
    public final double[] logNoise;

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
            PosePrior posePrior, CornerErrors errors, double noiseLevel) {
        this(lens, settings, view, intrinsicsPrior, posePrior, errors, noiseLevel, List.of(), null, null, null);
    }

    private CameraFit(PinholeCamera lens, CheckSettings settings, ReferenceView view, IntrinsicsPrior intrinsicsPrior,
            PosePrior posePrior, CornerErrors errors, double noiseLevel, List<PoseMode> modes,
            RigidTransform initialWorldFromCamera, NoiseBelief belief, double[] logNoise) {
        this.lens = lens;
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
        return new CameraFit(lens, settings, view, intrinsicsPrior, posePrior, errors, noiseLevel, found, initial,
                belief, logNoise);
    }

    /** The same camera from other references, at the modes found for them. */
    public CameraFit with(ReferenceView other, List<PoseMode> otherModes) {
        return new CameraFit(lens, settings, other, intrinsicsPrior, posePrior, errors, noiseLevel, otherModes,
                initialWorldFromCamera, belief, logNoise);
    }

    /** The same camera with what is known of the added noise; its modes are yet to be found again. */
    public CameraFit with(NoiseBelief known, double level, double[] logWithoutReferences) {
        return new CameraFit(lens, settings, view, intrinsicsPrior, posePrior, errors, level, modes,
                initialWorldFromCamera, known, logWithoutReferences);
    }

    /** The same camera with other errors of the corners, as if they were stated. */
    public CameraFit with(CornerErrors other) {
        return new CameraFit(lens, settings, view, intrinsicsPrior, posePrior, other, noiseLevel, modes,
                initialWorldFromCamera, null, null);
    }

    /** How far the corners of references may be off, at an added noise. */
    public ReferenceNoise noise(ReferenceView of, double level) {
        return ReferenceNoise.of(settings.model(), of, errors, level);
    }

    /** Finds the modes from some references, at an added noise. */
    public CameraModeFinder finder(ReferenceView from, double level) {
        return new CameraModeFinder(from, lens, noise(from, level), intrinsicsPrior, posePrior);
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

    /** The initial estimate as a state; its intrinsics are the prior means. */
    public CameraState initialState() {
        CameraState state = modes.get(0).state();
        RigidTransform cameraFromSet = view.cameraFromSet(initialWorldFromCamera);
        System.arraycopy(cameraFromSet.rotation(), 0, state.rotation, 0, 9);
        System.arraycopy(cameraFromSet.translationMm(), 0, state.offset, 0, 3);
        for (int i = 0; i < intrinsicsPrior.count(); i++) {
            state.intrinsics[intrinsicsPrior.index(i)] = intrinsicsPrior.mean(i);
        }
        return state;
    }
}
