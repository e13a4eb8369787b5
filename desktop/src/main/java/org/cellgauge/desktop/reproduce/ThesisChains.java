package org.cellgauge.desktop.reproduce;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.cellgauge.cell.Cell;
import org.cellgauge.cell.ObjectMarker;
import org.cellgauge.check.CellCheck;
import org.cellgauge.check.CellEstimate;
import org.cellgauge.check.CheckResult;
import org.cellgauge.estimate.IntrinsicsEstimate;
import org.cellgauge.estimate.ObjectEstimate;
import org.cellgauge.estimate.PoseEstimate;
import org.cellgauge.sampling.AcceptanceCount;
import org.cellgauge.sampling.Quantity;
import org.cellgauge.sampling.Quantity.Axis;
import org.cellgauge.settings.CheckSettings;
import org.cellgauge.statistics.ChainDiagnostics;
import org.cellgauge.vision.Detections;

/**
 * The thesis' algorithm run on one photo with many seeds: what one chain says depends on which one it is.
 *
 * <p>Figures, a row for each seed: {@code camera}, {@code object.ID} and {@code focal}, each with {@code .mean} and
 * {@code .std} (x, y, z in mm, psi, theta, phi in rad; fx, fy in px); {@code accepted.PROPOSAL} (accepted, rejected)
 * and {@code accepted.all}; {@code turned} (1 where the camera has turned at all among the kept draws). A row for
 * each four of them: {@code rhat.camera} and {@code rhat.objects} (the largest of any position), {@code ess.camera} and
 * {@code ess.objects} (the smallest, per chain).
 */
final class ThesisChains {
    /** Chains that are compared with each other. */
    private static final int GROUP = 4;
    private static final List<Axis> POSITION = List.of(Axis.X, Axis.Y, Axis.Z);

    private final Figures.Builder figures = new Figures.Builder();
    private final Map<Quantity, List<double[]>> group = new LinkedHashMap<>();

    private ThesisChains() {
    }

    /**
     * Runs them.
     *
     * @param cell the cell
     * @param detections its photo
     * @param settings the algorithm, but for the seed
     * @param seeds number of chains, a multiple of four
     */
    static Figures run(Cell cell, Detections detections, CheckSettings.Builder settings, int seeds) {
        ThesisChains chains = new ThesisChains();
        for (int seed = 1; seed <= seeds; seed++) {
            chains.add(cell, CellCheck.run(cell, detections, settings.seed(seed).threads(1).build()));
            if (seed % GROUP == 0) {
                chains.compareGroup();
            }
        }
        return chains.figures.build();
    }

    private void add(Cell cell, CheckResult result) {
        putEstimate(figures, "", result.estimate());
        double accepted = 0;
        double rejected = 0;
        for (AcceptanceCount count : result.acceptance()) {
            figures.append("accepted." + count.proposal(), count.accepted(), count.rejected());
            accepted += count.accepted();
            rejected += count.rejected();
        }
        figures.append("accepted.all", accepted, rejected);
        double[] std = result.estimate().camera().std();
        figures.append("turned", std[3] + std[4] + std[5] > 0 ? 1 : 0);
        for (Axis axis : POSITION) {
            keep(result, Quantity.camera(axis));
            for (ObjectMarker object : cell.objects()) {
                keep(result, Quantity.object(object.id(), axis));
            }
        }
    }

    private void keep(CheckResult result, Quantity quantity) {
        group.computeIfAbsent(quantity, q -> new ArrayList<>())
                .add(result.draws().get(0).series(result.layout().indexOf(quantity)));
    }

    /** What four chains say of each other. */
    private void compareGroup() {
        double[] rHat = new double[2];
        double[] ess = {Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY};
        group.forEach((quantity, series) -> {
            ChainDiagnostics found = ChainDiagnostics.of(series.toArray(new double[0][]));
            int whose = quantity.kind() == Quantity.Kind.CAMERA ? 0 : 1;
            rHat[whose] = Math.max(rHat[whose], found.rHat());
            ess[whose] = Math.min(ess[whose], found.essBulk() / GROUP);
        });
        figures.append("rhat.camera", rHat[0]).append("ess.camera", ess[0]);
        if (rHat[1] > 0) {
            figures.append("rhat.objects", rHat[1]).append("ess.objects", ess[1]);
        }
        group.clear();
    }

    /** Adds means and deviations of camera, focal lengths and objects. */
    static void putEstimate(Figures.Builder figures, String prefix, CellEstimate estimate) {
        putPose(figures, prefix + "camera", estimate.camera());
        IntrinsicsEstimate intrinsics = estimate.intrinsics();
        if (intrinsics != null) {
            double[] mean = intrinsics.mean();
            double[][] covariance = intrinsics.covariance();
            figures.append(prefix + "focal.mean", mean[0], mean[1]);
            figures.append(prefix + "focal.std", Math.sqrt(covariance[0][0]), Math.sqrt(covariance[1][1]));
        }
        for (ObjectEstimate object : estimate.objects()) {
            putPose(figures, prefix + "object." + object.id(), object.pose());
        }
    }

    private static void putPose(Figures.Builder figures, String name, PoseEstimate pose) {
        figures.append(name + ".mean", pose.mean()).append(name + ".std", pose.std());
    }
}
