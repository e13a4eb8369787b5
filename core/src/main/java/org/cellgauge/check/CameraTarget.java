package org.cellgauge.check;

import java.util.List;
import java.util.function.Function;
import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.pose.CameraModeFinder;
import org.cellgauge.pose.CameraState;
import org.cellgauge.pose.IntrinsicsPrior;
import org.cellgauge.pose.PoseMode;
import org.cellgauge.pose.PosePrior;
import org.cellgauge.pose.ReferenceView;
import org.cellgauge.posterior.CameraChart;
import org.cellgauge.posterior.CameraPosterior;
import org.cellgauge.posterior.CentredChart;
import org.cellgauge.posterior.EulerChart;

/** The camera posterior of one photo, as the samplers need it; immutable. */
final class CameraTarget {
    final ReferenceView view;
    final CheckSettings settings;
    final IntrinsicsPrior intrinsicsPrior;
    final PosePrior posePrior;
    final List<PoseMode> modes;
    final RigidTransform initialWorldFromCamera;
    private final Function<ReferenceView, CameraModeFinder> finders;

    CameraTarget(ReferenceView view, CheckSettings settings, IntrinsicsPrior intrinsicsPrior, PosePrior posePrior,
            List<PoseMode> modes, RigidTransform initialWorldFromCamera,
            Function<ReferenceView, CameraModeFinder> finders) {
        this.view = view;
        this.settings = settings;
        this.intrinsicsPrior = intrinsicsPrior;
        this.posePrior = posePrior;
        this.modes = modes;
        this.initialWorldFromCamera = initialWorldFromCamera;
        this.finders = finders;
    }

    /** The same camera from other references, at the modes found for them. */
    CameraTarget with(ReferenceView other, List<PoseMode> otherModes) {
        return new CameraTarget(other, settings, intrinsicsPrior, posePrior, otherModes,
                initialWorldFromCamera, finders);
    }

    /** Finds the modes as they were found for this target, from other references. */
    CameraModeFinder finder(ReferenceView other) {
        return finders.apply(other);
    }

    /** The posterior in the centred chart about the heaviest mode, a new instance for one thread. */
    CameraPosterior centred() {
        return posterior(new CentredChart(modes.get(0).state(), intrinsicsPrior));
    }

    /** The posterior in the thesis' coordinates, a new instance for one thread. */
    CameraPosterior euler() {
        return posterior(new EulerChart(view.centroidMm(), modes.get(0).state(), intrinsicsPrior));
    }

    private CameraPosterior posterior(CameraChart chart) {
        return new CameraPosterior(chart, settings.model().likelihood(view, modes, settings.kappa()),
                settings.rotationPrior(), intrinsicsPrior, posePrior);
    }

    /** The initial estimate as a state; its intrinsics are the prior means. */
    CameraState initialState() {
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
