package org.cellgauge.check;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import org.cellgauge.cell.Cell;
import org.cellgauge.cell.InputRefusedException;
import org.cellgauge.cell.ObjectMarker;
import org.cellgauge.cell.Reference;
import org.cellgauge.estimate.ObjectEstimate;
import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.internal.geometry.MarkerGeometry;
import org.cellgauge.internal.vision.CornerForecast;
import org.cellgauge.plan.CellPlanner;
import org.cellgauge.plan.Forecast;
import org.cellgauge.plan.Layout;
import org.cellgauge.plan.PlanOptions;
import org.cellgauge.settings.CheckSettings;
import org.cellgauge.vision.Detections;
import org.cellgauge.vision.MarkerObservation;
import org.cellgauge.vision.PhotoLight;
import org.jspecify.annotations.Nullable;

/**
 * A forecast held against chains: a check of the corners that a photo of the layout would have, exactly where they
 * would be and as precise as forecast, each object standing where it is worst; immutable.
 *
 * @param converged whether the chains have, on one pose of everything; without that no figure means anything
 * @param sampledStdMm largest deviation of any object and gripping point along any axis by the chains, mm
 * @param forecastStdMm the deviation that was forecast of the same point along the same axis, mm
 */
public record SampledForecast(boolean converged, double sampledStdMm, double forecastStdMm) {
    /** Up to this share of the forecast the two agree. */
    public static final double AGREE = 0.05;

    private static final double DEGREES_OF_FREEDOM = 1000;

    /**
     * Samples a layout.
     *
     * @param layout what stands where; of several poses of the camera the first
     * @param options what to reckon with
     * @param settings how the chains go about it
     * @return what they say; null where a check knows no such layout (plates, measured distances, more photos), and
     *     where there is nothing to sample because the photo would not show enough
     */
    public static @Nullable SampledForecast of(Layout layout, PlanOptions options, CheckSettings settings) {
        if (!layout.isOnePhoto()) {
            return null;
        }
        Layout worst = worst(layout, options);
        RigidTransform cameraFromWorld = worst.worldFromCameras().get(0).inverse();
        Cell cell = worst.cell().withTarget(OptionalDouble.empty());
        List<MarkerObservation> seen = new ArrayList<>();
        CornerForecast corners = new CornerForecast(options.toneCurve(), options.blurPx(), options.noiseGrey());
        for (Reference r : cell.references()) {
            add(cell, r.id(), cameraFromWorld.compose(r.worldFromMarker()), r.sizeMm(), corners, seen);
        }
        for (ObjectMarker o : cell.objects()) {
            List<RigidTransform> places = worst.worldFromObjects().get(o.id());
            if (places != null) {
                add(cell, o.id(), cameraFromWorld.compose(places.get(0)), o.sizeMm(), corners, seen);
            }
        }
        Detections photo = new Detections("layout", cell.camera().widthPx(), cell.camera().heightPx(), seen, List.of(),
                cell.pixelStdPx().isPresent() ? null : new PhotoLight(options.toneCurve(), true, options.blurPx(),
                        options.noiseGrey(), DEGREES_OF_FREEDOM, CornerForecast.EDGE_SHIFT_STD_PX));
        try {
            return compared(CellCheck.run(cell, photo, settings), CellPlanner.forecast(worst, options));
        } catch (InputRefusedException e) {
            return null;
        }
    }

    private static SampledForecast compared(CheckResult result, Forecast forecast) {
        double most = 0;
        double same = 0;
        for (Forecast.Row row : forecast.rows()) {
            ObjectEstimate object = result.estimate().object(row.object());
            double[] std = object == null ? null : row.grip() && object.grip() != null ? object.grip().stdMm()
                    : object.pose().std();
            for (int axis = 0; axis < Forecast.AXES && std != null; axis++) {
                if (std[axis] > most) {
                    most = std[axis];
                    same = row.axis(axis);
                }
            }
        }
        return new SampledForecast(result.verdict().isTrusted(), most, same);
    }

    private static void add(Cell cell, int id, RigidTransform cameraFromMarker, double sizeMm, CornerForecast corners,
            List<MarkerObservation> to) {
        double[] px = MarkerGeometry.seenPx(cell.camera(), cameraFromMarker, sizeMm);
        if (px != null) {
            to.add(cell.pixelStdPx().isPresent() ? new MarkerObservation(id, px) : corners.of(id, px));
        }
    }

    /** The same with each object only where it is worst. */
    private static Layout worst(Layout layout, PlanOptions options) {
        Layout one = layout.withCameras(layout.worldFromCameras().subList(0, 1));
        Map<Integer, List<RigidTransform>> places = new LinkedHashMap<>();
        for (Map.Entry<Integer, List<RigidTransform>> e : layout.worldFromObjects().entrySet()) {
            RigidTransform worst = e.getValue().get(0);
            double most = 0;
            for (RigidTransform place : e.getValue().size() > 1 ? e.getValue() : List.<RigidTransform>of()) {
                double ratio = CellPlanner.forecast(new Layout(one.cell(), one.worldFromCameras(),
                        Map.of(e.getKey(), List.of(place))), options).ratio();
                if (ratio > most && Double.isFinite(ratio)) {
                    most = ratio;
                    worst = place;
                }
            }
            places.put(e.getKey(), List.of(worst));
        }
        return new Layout(one.cell(), one.worldFromCameras(), places);
    }

    /**
     * By how much the chains are beyond the forecast.
     *
     * @return a share of the forecast, negative where they are below
     */
    public double difference() {
        return sampledStdMm / forecastStdMm - 1;
    }

    /**
     * Whether chains confirm the forecast.
     *
     * @return true where they have converged to within {@link #AGREE} of it
     */
    public boolean confirms() {
        return converged && Math.abs(difference()) <= AGREE;
    }
}
