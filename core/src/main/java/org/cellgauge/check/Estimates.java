package org.cellgauge.check;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.stream.IntStream;
import org.cellgauge.cell.Cell;
import org.cellgauge.estimate.IntrinsicsEstimate;
import org.cellgauge.estimate.ModeEstimate;
import org.cellgauge.estimate.ObjectEstimate;
import org.cellgauge.estimate.PointEstimate;
import org.cellgauge.estimate.PoseEstimate;
import org.cellgauge.estimate.VarianceBudget;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.internal.chains.CellQuantities;
import org.cellgauge.internal.chains.CellQuantities.PoseGroups;
import org.cellgauge.internal.estimate.ImageEllipses;
import org.cellgauge.internal.estimate.Matrices;
import org.cellgauge.internal.geometry.Rotations;
import org.cellgauge.internal.laplace.ObjectFit;
import org.cellgauge.internal.sampling.RunningSummary;
import org.cellgauge.sampling.Draws;
import org.cellgauge.sampling.Quantity;

/** Turns running statistics of draws into estimates. */
final class Estimates {
    private final Cell cell;
    private final CellQuantities quantities;
    private final CellEstimate quickLook;
    /** One draw; only what is asked for is filled in. */
    private final double[] values;

    /**
     * Estimates of one photo, for one thread.
     *
     * @param cell what stands in the cell
     * @param quantities what a draw says
     * @param quickLook budgets and the like, which no draw says anew
     */
    Estimates(Cell cell, CellQuantities quantities, CellEstimate quickLook) {
        this.cell = cell;
        this.quantities = quantities;
        this.quickLook = quickLook;
        values = new double[quantities.layout.size()];
    }

    /**
     * Estimates of a summary.
     *
     * @param draws all draws, for the share and the moments of each mode; empty while they are still being made
     */
    CellEstimate of(RunningSummary summary, List<Draws> draws) {
        PoseEstimate camera = pose(summary, quantities.cameraPose, "camera in world", quantities.cameraReference);
        IntrinsicsEstimate intrinsics = null;
        IntrinsicsEstimate quick = quickLook.intrinsics();
        if (quick != null) {
            intrinsics = quick.with(summary.mean(quantities.intrinsics), summary.covariance(quantities.intrinsics));
        }
        PinholeCamera lens = ImageEllipses.camera(cell.camera(), quantities.camera.intrinsicsPrior, intrinsics);
        List<ObjectEstimate> objects = new ArrayList<>();
        for (int o = 0; o < quantities.objects.size(); o++) {
            ObjectFit target = quantities.objects.get(o).fit;
            PoseGroups groups = quantities.objectPoses[o];
            double[] reference = quantities.objectReferences[o];
            PoseEstimate pose = pose(summary, groups, "object in world", reference);
            PointEstimate grip = target.marker.hasGrip()
                    ? new PointEstimate(summary.mean(quantities.grips[o]),
                            summary.covariance(quantities.grips[o])) : null;
            ObjectEstimate ofModes = quickLook.objects().get(o);
            VarianceBudget ofGrip = ofModes.gripBudget();
            objects.add(new ObjectEstimate(target.marker, pose, grip, ofModes.budget().workedOut(),
                    ofGrip == null ? null : ofGrip.workedOut(),
                    ImageEllipses.of(lens, camera, pose.meanTransform().translationMm(),
                            pose.positionCovarianceMm2()),
                    grip == null ? null
                            : ImageEllipses.of(lens, camera, grip.meanMm(), grip.covarianceMm2()),
                    modes(draws, Quantity.objectMode(target.marker.id()), groups, "object in world", reference,
                            target.modes.size(), pose)));
        }
        return new CellEstimate(camera, modes(draws, Quantity.CAMERA_MODE, quantities.cameraPose,
                "camera in world", quantities.cameraReference, quantities.camera.modes.size(), camera), intrinsics,
                objects);
    }

    private static PoseEstimate pose(RunningSummary summary, PoseGroups groups, String frame, double[] reference) {
        double[] tangentMean = summary.mean(groups.tangent);
        double[] turn = new double[9];
        Rotations.exp(tangentMean[3], tangentMean[4], tangentMean[5], turn);
        double[] rotation = new double[9];
        Rotations.multiply(turn, reference, rotation);
        RigidTransform mean = RigidTransform.of(rotation,
                new double[] {tangentMean[0], tangentMean[1], tangentMean[2]});
        // draws are rotation vectors v from the reference; from the mean rotation they are J (v - mean) to first order
        double[] byVector = new double[9];
        Rotations.leftJacobian(tangentMean[3], tangentMean[4], tangentMean[5], byVector);
        double[][] aboutMean = new double[6][6];
        for (int i = 0; i < 3; i++) {
            aboutMean[i][i] = 1;
            System.arraycopy(byVector, 3 * i, aboutMean[3 + i], 3, 3);
        }
        double[][] aboutReference = summary.covariance(groups.tangent);
        double[] flat = new double[36];
        for (int i = 0; i < 6; i++) {
            System.arraycopy(aboutReference[i], 0, flat, 6 * i, 6);
        }
        double[][] tangent = new double[6][6];
        Matrices.addSandwich(aboutMean, flat, 6, tangent);
        return new PoseEstimate(frame, summary.mean(groups.euler), summary.covariance(groups.euler), tangent, mean);
    }

    /** Moments of the draws near each mode. */
    private List<ModeEstimate> modes(List<Draws> draws, Quantity which, PoseGroups groups, String frame,
            double[] reference, int count, PoseEstimate all) {
        if (count < 2 || draws.isEmpty()) {
            return Collections.singletonList(new ModeEstimate(1, all));
        }
        int label = quantities.layout.indexOf(which);
        int[] read = IntStream.of(groups.euler, groups.tangent)
                .flatMap(g -> IntStream.of(quantities.layout.groups().get(g))).distinct().toArray();
        List<RunningSummary> split = new ArrayList<>();
        for (int k = 0; k < count; k++) {
            split.add(RunningSummary.ofGroups(quantities.layout, groups.euler, groups.tangent));
        }
        long total = 0;
        for (Draws chain : draws) {
            for (int i = 0; i < chain.count(); i++) {
                for (int q : read) {
                    values[q] = chain.get(q, i);
                }
                split.get((int) chain.get(label, i)).add(values);
                total++;
            }
        }
        List<ModeEstimate> modes = new ArrayList<>();
        for (RunningSummary part : split) {
            if (part.count() > 1) {
                modes.add(new ModeEstimate((double) part.count() / total, pose(part, groups, frame, reference)));
            }
        }
        modes.sort((a, b) -> Double.compare(b.weight(), a.weight()));
        return modes;
    }
}
