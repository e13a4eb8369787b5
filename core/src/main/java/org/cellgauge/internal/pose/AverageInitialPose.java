package org.cellgauge.internal.pose;

import org.cellgauge.cell.Reference;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.geometry.RigidTransform;
import org.jspecify.annotations.Nullable;

/** Mean position and mean direction of each Euler angle over the camera poses that each reference gives alone. */
final class AverageInitialPose implements InitialPose {
    @Override
    public @Nullable RigidTransform estimate(ReferenceView view, PinholeCamera camera) {
        double[] position = new double[3];
        double[] sine = new double[3];
        double[] cosine = new double[3];
        int found = 0;
        MarkerPoseFinder finder = new MarkerPoseFinder();
        for (int m = 0; m < view.size(); m++) {
            RigidTransform worldFromCamera = ofOneReference(view, m, camera, finder);
            if (worldFromCamera == null) {
                continue;
            }
            found++;
            double[] t = worldFromCamera.translationMm();
            double[] e = worldFromCamera.eulerRad();
            for (int i = 0; i < 3; i++) {
                position[i] += t[i];
                sine[i] += Math.sin(e[i]);
                cosine[i] += Math.cos(e[i]);
            }
        }
        if (found == 0) {
            return null;
        }
        return RigidTransform.ofEuler(position[0] / found, position[1] / found, position[2] / found,
                Math.atan2(sine[0], cosine[0]), Math.atan2(sine[1], cosine[1]), Math.atan2(sine[2], cosine[2]));
    }

    /** Camera pose that one reference gives alone, or null. */
    static @Nullable RigidTransform ofOneReference(ReferenceView view, int marker, PinholeCamera camera,
            MarkerPoseFinder finder) {
        Reference reference = view.references().get(marker);
        double[] observed = new double[8];
        System.arraycopy(view.observed(), 8 * marker, observed, 0, 8);
        RigidTransform cameraFromMarker = finder.best(observed, reference.sizeMm(), camera);
        return cameraFromMarker == null ? null : reference.worldFromMarker().compose(cameraFromMarker.inverse());
    }
}
