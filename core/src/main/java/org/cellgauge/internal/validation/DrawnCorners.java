package org.cellgauge.internal.validation;

import java.util.ArrayList;
import java.util.List;
import org.apache.commons.math3.random.RandomGenerator;
import org.cellgauge.cell.Cell;
import org.cellgauge.cell.InputRefusedException;
import org.cellgauge.cell.ObjectMarker;
import org.cellgauge.cell.Reference;
import org.cellgauge.vision.Detections;
import org.cellgauge.vision.MarkerObservation;
import org.cellgauge.warning.Refusal;

/**
 * Corners about their true places, each coordinate off by independent Gaussian noise. They may lie outside the image:
 * whether a detector would find them is not the question here. Immutable.
 */
public final class DrawnCorners implements DetectionSource {
    private final double pixelStdPx;
    private final double outlierShare;
    private final double outlierStds;

    private DrawnCorners(double pixelStdPx, double outlierShare, double outlierStds) {
        this.pixelStdPx = pixelStdPx;
        this.outlierShare = outlierShare;
        this.outlierStds = outlierStds;
    }

    /**
     * Noise of one size for all cells.
     *
     * @param pixelStdPx standard deviation of each coordinate, px, positive
     * @return the source
     * @throws IllegalArgumentException if the deviation is not positive and finite
     */
    public static DrawnCorners of(double pixelStdPx) {
        if (!(pixelStdPx > 0 && Double.isFinite(pixelStdPx))) {
            throw new IllegalArgumentException("corner noise must be positive, not " + pixelStdPx);
        }
        return new DrawnCorners(pixelStdPx, 0, 0);
    }

    /**
     * Noise as every cell states it.
     *
     * @return the source; it refuses cells that state none
     */
    public static DrawnCorners asStated() {
        return new DrawnCorners(Double.NaN, 0, 0);
    }

    /**
     * The same noise with corners that are far off besides, as by a smudge, a finger or a glint.
     *
     * @param share chance that a corner is one, 0 to 1
     * @param stds how far off it is, in standard deviations of the noise, in any direction of the image; not negative
     * @return the source
     * @throws IllegalArgumentException if a number is out of range
     */
    public DrawnCorners withOutliers(double share, double stds) {
        if (!(share >= 0 && share <= 1 && stds >= 0 && Double.isFinite(stds))) {
            throw new IllegalArgumentException("no share of outliers and size: " + share + ", " + stds);
        }
        return new DrawnCorners(pixelStdPx, share, stds);
    }

    @Override
    public Detections detect(SimulatedCell simulated, RandomGenerator random) {
        Cell cell = simulated.cell();
        double std = Double.isNaN(pixelStdPx)
                ? cell.pixelStdPx().orElseThrow(() -> new InputRefusedException(
                        Refusal.of(ValidationRefusal.NO_CORNER_NOISE)))
                : pixelStdPx;
        List<MarkerObservation> markers = new ArrayList<>();
        for (Reference r : cell.references()) {
            markers.add(observation(simulated, r.id(), std, random));
        }
        for (ObjectMarker o : cell.objects()) {
            markers.add(observation(simulated, o.id(), std, random));
        }
        return new Detections("simulated", cell.camera().widthPx(), cell.camera().heightPx(), markers);
    }

    private MarkerObservation observation(SimulatedCell simulated, int id, double std, RandomGenerator random) {
        double[] px = simulated.cornersPx(id);
        if (px == null) {
            throw new InputRefusedException("simulated", ValidationRefusal.MARKER_BEHIND_CAMERA);
        }
        for (int i = 0; i < 8; i++) {
            px[i] += std * random.nextGaussian();
        }
        for (int k = 0; k < 4 && outlierShare > 0; k++) {
            double towards = 2 * Math.PI * random.nextDouble();
            if (random.nextDouble() < outlierShare) {
                px[2 * k] += outlierStds * std * Math.cos(towards);
                px[2 * k + 1] += outlierStds * std * Math.sin(towards);
            }
        }
        return new MarkerObservation(id, px);
    }
}
