package org.cellgauge.internal.geometry;

import org.cellgauge.geometry.BrownLens;
import org.cellgauge.geometry.KannalaBrandtLens;
import org.cellgauge.geometry.Lens;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.geometry.RationalLens;
import org.jspecify.annotations.Nullable;

/** The lens models there are, by their names. */
public final class Lenses {
    /** Index of the first coefficient of radial distortion among the parameters, of every lens there is. */
    public static final int FIRST_RADIAL = PinholeCamera.SKEW + 1;

    private static final int BORDER_POINTS = 16;
    private static final int STEPS_FROM_CENTRE = 32;

    private Lenses() {
    }

    /**
     * A lens model.
     *
     * @param modelName {@link Lens#modelName()}
     * @return the model; null where there is none of that name
     */
    public static @Nullable Lens named(String modelName) {
        for (Lens lens : new Lens[] {BrownLens.MODEL, KannalaBrandtLens.MODEL, RationalLens.MODEL}) {
            if (lens.modelName().equals(modelName)) {
                return lens;
            }
        }
        return null;
    }

    /**
     * A pixel of the image's border that shows two directions, or none: the camera has no inverse there.
     *
     * @param camera a camera whose lens is not wide
     * @return u, v, px; null where every pixel shows one direction, as far as the border and the ways there tell
     */
    public static double @Nullable [] foldWithin(PinholeCamera camera) {
        double[] point = new double[2];
        for (int i = 0; i < BORDER_POINTS; i++) {
            double s = i / (double) BORDER_POINTS;
            double w = camera.widthPx();
            double h = camera.heightPx();
            double[][] border = {{s * w, 0}, {w, s * h}, {w - s * w, h}, {0, h - s * h}};
            for (double[] uv : border) {
                if (!camera.toNormalised(uv[0], uv[1], point) || foldsBefore(camera, point)) {
                    return uv;
                }
            }
        }
        return null;
    }

    private static boolean foldsBefore(PinholeCamera camera, double[] point) {
        double[] uv = new double[2];
        double[] d = new double[6];
        for (int i = 1; i <= STEPS_FROM_CENTRE; i++) {
            double s = i / (double) STEPS_FROM_CENTRE;
            camera.lens().projectWithDerivatives(camera.intrinsics(), s * point[0], s * point[1], 1, uv, d, null);
            // rows of the 2x3 derivative; at z = 1 the first two columns are those by the normalised point
            if (!(d[0] * d[4] - d[1] * d[3] > 0)) {
                return true;
            }
        }
        return false;
    }
}
