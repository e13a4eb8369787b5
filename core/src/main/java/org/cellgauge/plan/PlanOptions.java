package org.cellgauge.plan;

import java.util.List;
import java.util.Map;
import org.cellgauge.cell.Area;
import org.cellgauge.cell.Cell;
import org.cellgauge.cell.ChangeKind;
import org.cellgauge.cell.Wall;
import org.cellgauge.light.ToneCurve;
import org.cellgauge.settings.CheckSettings;

/**
 * What a plan reckons with; immutable.
 *
 * @param settings how the cell is modelled
 * @param toneCurve of the camera; like blur and noise it counts where the cell states no noise of corners
 * @param blurPx standard deviation of the blur, px, positive
 * @param noiseGrey standard deviation of the noise, grey levels of 255, positive
 * @param freeAreas where references may be put; empty: anywhere
 * @param walls which references may hang on, and which hide what is behind them
 * @param maxHeightMm how far off the plane of the references they may be raised, mm, 0 for not at all
 * @param leastSidePx markers smaller than this are not counted on, px
 * @param costs what changes cost; those left out cost what is usual
 */
public record PlanOptions(CheckSettings settings, ToneCurve toneCurve, double blurPx, double noiseGrey,
        List<Area> freeAreas, List<Wall> walls, double maxHeightMm, double leastSidePx, Map<ChangeKind, Double> costs) {
    /** What is usual: a sharp sRGB photo, anywhere, up to 200 mm off the plane. */
    public static final PlanOptions USUAL = new PlanOptions(CheckSettings.builder().build(), ToneCurve.SRGB, 0.7, 2,
            List.of(), List.of(), 200, 20, Map.of());

    /**
     * Options.
     *
     * @throws IllegalArgumentException if a value is out of its range
     */
    public PlanOptions {
        if (!(blurPx > 0 && noiseGrey > 0 && maxHeightMm >= 0 && leastSidePx > 0)
                || !Double.isFinite(blurPx + noiseGrey + maxHeightMm + leastSidePx)) {
            throw new IllegalArgumentException("blur, noise, height and size must be positive");
        }
        freeAreas = List.copyOf(freeAreas);
        walls = List.copyOf(walls);
        costs = Map.copyOf(costs);
        costs.values().forEach(cost -> {
            if (!(cost >= 0) || cost.isInfinite()) {
                throw new IllegalArgumentException("a cost must not be negative, as " + cost);
            }
        });
    }

    /**
     * What is usual for a cell: with the free areas, walls, heights and costs that it states for planning.
     *
     * @param cell the cell
     * @param settings how it is modelled
     * @return options with its tone curve, where it states one
     */
    public static PlanOptions of(Cell cell, CheckSettings settings) {
        return new PlanOptions(settings, cell.toneCurve() == null ? USUAL.toneCurve() : cell.toneCurve(),
                USUAL.blurPx(), USUAL.noiseGrey(), cell.planning().free(), cell.planning().walls(),
                cell.planning().maxHeightMm().orElse(USUAL.maxHeightMm()), USUAL.leastSidePx(),
                cell.planning().costs());
    }

    /**
     * The same for photos of another light.
     *
     * @param curve of the camera
     * @param blurOfPx standard deviation of the blur, px, positive
     * @param noiseOfGrey standard deviation of the noise, grey levels of 255, positive
     * @return other options
     */
    public PlanOptions withLight(ToneCurve curve, double blurOfPx, double noiseOfGrey) {
        return new PlanOptions(settings, curve, blurOfPx, noiseOfGrey, freeAreas, walls, maxHeightMm, leastSidePx,
                costs);
    }

    /**
     * What a kind of change costs.
     *
     * @param kind the change
     * @return for each marker that has to be touched, or once
     */
    public double cost(ChangeKind kind) {
        return costs.getOrDefault(kind, kind.usualCost());
    }

    /**
     * Whether a reference may be put somewhere.
     *
     * @param x world x, mm
     * @param y world y, mm
     * @return true where it may
     */
    public boolean isFree(double x, double y) {
        return freeAreas.isEmpty() || freeAreas.stream().anyMatch(area -> area.has(x, y));
    }
}
