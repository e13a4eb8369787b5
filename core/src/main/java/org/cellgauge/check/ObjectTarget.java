package org.cellgauge.check;

import java.util.List;
import org.cellgauge.cell.ObjectMarker;
import org.cellgauge.geometry.MarkerGeometry;
import org.cellgauge.pose.CameraState;
import org.cellgauge.pose.IntrinsicsPrior;
import org.cellgauge.pose.PoseMode;
import org.cellgauge.pose.ReprojectionFit;
import org.cellgauge.posterior.ObjectPosterior;
import org.cellgauge.sampling.StudentTMixture;

/** One object of a photo: its corners, the modes of its pose before the camera, and the proposal fitted to them. */
final class ObjectTarget {
    final ObjectMarker marker;
    final double[] cornersPx;
    final double pixelStdPx;
    final List<PoseMode> modes;
    final StudentTMixture proposal;

    ObjectTarget(ObjectMarker marker, double[] cornersPx, double pixelStdPx, List<PoseMode> modes,
            StudentTMixture proposal) {
        this.marker = marker;
        this.cornersPx = cornersPx;
        this.pixelStdPx = pixelStdPx;
        this.modes = modes;
        this.proposal = proposal;
    }

    ObjectTarget withProposal(StudentTMixture fitted) {
        return new ObjectTarget(marker, cornersPx, pixelStdPx, modes, fitted);
    }

    ObjectPosterior posterior() {
        return new ObjectPosterior(cornersPx, marker.sizeMm(), pixelStdPx, modes.get(0).state());
    }

    /** A fit of the pose at intrinsics of the caller's, for one thread. */
    ReprojectionFit fit() {
        ReprojectionFit fit = new ReprojectionFit(MarkerGeometry.cornersMm(marker.sizeMm()), cornersPx,
                IntrinsicsPrior.KNOWN, null);
        fit.setIsotropic(pixelStdPx);
        return fit;
    }

    /** Which of the modes a state is nearest to, in the deviations of that mode. */
    static int nearest(List<PoseMode> modes, CameraState state) {
        int nearest = 0;
        double least = Double.POSITIVE_INFINITY;
        for (int k = 0; k < modes.size(); k++) {
            double[] step = state.stepFrom(modes.get(k).state());
            // rotation alone tells mirrored poses apart
            double squared = step[3] * step[3] + step[4] * step[4] + step[5] * step[5];
            if (squared < least) {
                least = squared;
                nearest = k;
            }
        }
        return nearest;
    }
}
