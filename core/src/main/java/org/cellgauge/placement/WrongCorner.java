package org.cellgauge.placement;

import java.util.Arrays;
import java.util.List;
import org.cellgauge.internal.laplace.CameraFit;
import org.cellgauge.internal.pose.PoseMode;
import org.cellgauge.internal.statistics.ChiSquare;
import org.jspecify.annotations.Nullable;

/**
 * A reference of which one corner lies where no placement within what is stated puts it: a smudge, a finger, a glint;
 * immutable.
 *
 * <p>A corner that is off by itself makes a small marker seem turned, and its corners are then as square as any: how
 * square they are ({@link NoiseFit}) does not tell. The other references do, since they say how it stands. Tested is a
 * shift of one corner in any direction of the image, in the model linearised at the mode (mean-shift outlier test: Cook
 * and Weisberg, "Residuals and Influence in Regression", 1982, section 2.2.2; two degrees of freedom). It is named
 * where more speaks for it than for any shift or turn of one reference, any common cause, and any corner of another.
 */
public final class WrongCorner {
    /** Chance that a photo as stated has one; with those of noise, of directions and of all together below 1 in 100. */
    static final double LEVEL = 0.0002;
    /**
     * A shift in the image has two numbers where one of a reference or a cause has one, and may be of a size within
     * some twenty deviations: so much more it must explain to be as likely, and again so much to be likelier beyond
     * doubt.
     */
    private static final double MARGIN = 2 * ReferenceCheck.DOUBT;

    private final int id;
    private final double chiSquare;

    private WrongCorner(int id, double chiSquare) {
        this.id = id;
        this.chiSquare = chiSquare;
    }

    /**
     * Looks for one.
     *
     * @param camera the camera from all references, with a mode, of the likelihood with rigid placements
     * @return the one for which most speaks; null where all are within what is stated or something else explains as
     *     much
     */
    public static @Nullable WrongCorner in(CameraFit camera) {
        PoseMode mode = camera.mode();
        int references = camera.view.size();
        if (references < 2) {
            return null;
        }
        double[] covariance = mode.covariance();
        double[] byPose = new double[2 * mode.dimension()];
        int worst = -1;
        double most = 0;
        double ofAnother = 0;
        for (int m = 0; m < references; m++) {
            double[] residual = mode.whitenedResiduals(m);
            double[] jacobian = mode.jacobian(m);
            double own = 0;
            for (int k = 0; k < 4; k++) {
                own = Math.max(own, squares(k, mode, m, residual, jacobian, covariance, byPose));
            }
            if (own > most) {
                ofAnother = most;
                most = own;
                worst = m;
            } else {
                ofAnother = Math.max(ofAnother, own);
            }
        }
        if (worst < 0 || ChiSquare.pValue(most, 2) * 4 * references > LEVEL
                || most - ofAnother < ReferenceCheck.DOUBT) {
            return null;
        }
        List<CausePattern> causes = CausePattern.of(camera, mode);
        double ofPlacements = DirectionScore.mostExplained(camera.view, causes,
                new PlacementScores(camera.view, mode, causes));
        return most - ofPlacements < MARGIN ? null
                : new WrongCorner(camera.view.references().get(worst).id(), most);
    }

    /**
     * How much of chi-square a shift of one corner takes: with d the whitened residuals' change by the shift along u
     * and v, J that by the pose and C the pose's covariance, {@code s' V^-1 s}, where {@code s = d' r} and
     * {@code V = d' d - d' J C J' d}.
     */
    private static double squares(int corner, PoseMode mode, int marker, double[] residual, double[] jacobian,
            double[] covariance, double[] byPose) {
        int unknowns = mode.dimension();
        Arrays.fill(byPose, 0);
        double scoreAlong = 0;
        double scoreDown = 0;
        double ofAlong = 0;
        double ofBoth = 0;
        double ofDown = 0;
        for (int i = 2 * corner; i < 8; i++) {
            double along = mode.whitening(marker, i, 2 * corner);
            double down = mode.whitening(marker, i, 2 * corner + 1);
            scoreAlong += along * residual[i];
            scoreDown += down * residual[i];
            ofAlong += along * along;
            ofBoth += along * down;
            ofDown += down * down;
            for (int p = 0; p < unknowns; p++) {
                byPose[p] += along * jacobian[i * unknowns + p];
                byPose[unknowns + p] += down * jacobian[i * unknowns + p];
            }
        }
        double least = 1e-9 * Math.max(ofAlong, ofDown);
        for (int p = 0; p < unknowns; p++) {
            for (int q = 0; q < unknowns; q++) {
                double c = covariance[p * unknowns + q];
                ofAlong -= byPose[p] * c * byPose[q];
                ofBoth -= byPose[p] * c * byPose[unknowns + q];
                ofDown -= byPose[unknowns + p] * c * byPose[unknowns + q];
            }
        }
        double determinant = ofAlong * ofDown - ofBoth * ofBoth;
        // what is left by rounding alone is nothing
        return !(determinant > least * least) ? 0 : (ofDown * scoreAlong * scoreAlong
                - 2 * ofBoth * scoreAlong * scoreDown + ofAlong * scoreDown * scoreDown) / determinant;
    }

    /**
     * Marker id of the reference.
     *
     * @return the id
     */
    public int id() {
        return id;
    }

    /**
     * How much of the misfit of all references goes if this corner is left out.
     *
     * @return chi-square distributed with 2 degrees of freedom if the corner is as precise as stated
     */
    public double chiSquare() {
        return chiSquare;
    }
}
