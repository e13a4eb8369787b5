package org.cellgauge.desktop.render;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Queue;
import java.util.concurrent.ConcurrentLinkedQueue;
import org.apache.commons.math3.random.RandomGenerator;
import org.cellgauge.cell.Cell;
import org.cellgauge.cell.InputRefusedException;
import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.internal.validation.DetectionSource;
import org.cellgauge.internal.validation.SimulatedCell;
import org.cellgauge.internal.vision.MarkerPattern;
import org.cellgauge.vision.BoofMarkerDetector;
import org.cellgauge.vision.Detections;
import org.cellgauge.vision.GreyImage;
import org.cellgauge.vision.PhotoLight;
import org.cellgauge.warning.Place;
import org.cellgauge.warning.Refusal;
import org.cellgauge.warning.RefusalKind;

/**
 * A photo of every simulated cell, rendered by {@link SceneRenderer#renderNearMarkers} before a plain wall, and what
 * the detector finds in it. May be called by several threads at once.
 */
public final class RenderedPhotos implements DetectionSource {
    private final Sensor sensor;
    private final int jpegQuality;
    private final double printGainMm;
    private final boolean outlinesDrawn;
    /** Detectors that are not at work: making one takes a while where the lens distorts. */
    private final Queue<Held> idle = new ConcurrentLinkedQueue<>();

    /** Why a photo cannot be rendered. */
    private enum Unrendered implements RefusalKind {
        /** What the scene says. */
        SCENE("%s");

        private final String english;

        Unrendered(String english) {
            this.english = english;
        }

        @Override
        public String english() {
            return english;
        }
    }

    private record Held(Cell cell, BoofMarkerDetector detector) {
    }

    /**
     * A source of photos.
     *
     * @param sensor how they are taken
     * @param jpegQuality quality of the JPEG file that they pass through, 1 to 100; 0: none
     * @param printGainMm as {@link Scene#printGainMm}
     * @param outlinesDrawn whether the outlines of all markers of a photo lie, alike, off where their inner edges say
     *     by a draw from what a check allows for ({@link PhotoLight#usualOutlineStdPx}), as references are off their
     *     places by draws from their placement; else prints are exact
     */
    public RenderedPhotos(Sensor sensor, int jpegQuality, double printGainMm, boolean outlinesDrawn) {
        this.sensor = sensor;
        this.jpegQuality = jpegQuality;
        this.printGainMm = printGainMm;
        this.outlinesDrawn = outlinesDrawn;
    }

    @Override
    public Detections detect(SimulatedCell simulated, RandomGenerator random) {
        GreyImage image = photo(simulated, random);
        Held held = idle.poll();
        if (held == null || held.cell() != simulated.cell()) {
            held = new Held(simulated.cell(), BoofMarkerDetector.forCell(simulated.cell()));
        }
        Detections found = held.detector().detect(image, "simulated");
        idle.add(held);
        return found;
    }

    private double outlineStdPx(SimulatedCell simulated) {
        double white = 255 * sensor.toneCurve().grey(sensor.exposure() * PlanarMarker.WHITE) + sensor.blackLevelGrey();
        double sides = 0;
        int count = 0;
        int cells = 1;
        for (MarkerSize marker : sizes(simulated.cell())) {
            double sidePx = sidePx(simulated, marker.id());
            sides += sidePx;
            count += sidePx > 0 ? 1 : 0;
            cells = MarkerPattern.of(simulated.cell().family(), marker.id()).cells();
        }
        return PhotoLight.usualOutlineStdPx(sensor.blurPx(), Math.min(255, white), sides / Math.max(1, count) / cells);
    }

    private record MarkerSize(int id, double sizeMm) {
    }

    private static List<MarkerSize> sizes(Cell cell) {
        List<MarkerSize> all = new ArrayList<>();
        cell.references().forEach(r -> all.add(new MarkerSize(r.id(), r.sizeMm())));
        cell.objects().forEach(o -> all.add(new MarkerSize(o.id(), o.sizeMm())));
        return all;
    }

    /** Mean side of a marker in the image, px; 0 where it is not in front of the camera. */
    private static double sidePx(SimulatedCell simulated, int id) {
        double[] corners = simulated.cornersPx(id);
        double around = 0;
        for (int i = 0; corners != null && i < 8; i += 2) {
            around += Math.hypot(corners[(i + 2) % 8] - corners[i], corners[(i + 3) % 8] - corners[i + 1]);
        }
        return around / 4;
    }

    /**
     * The photo of a cell.
     *
     * @param simulated the cell with its truth
     * @param random source of the noise
     * @return the photo as decoded from its file
     */
    public GreyImage photo(SimulatedCell simulated, RandomGenerator random) {
        Cell cell = simulated.cell();
        Scene.Builder scene = Scene.of(simulated.truth().camera(cell), simulated.truth().worldFromCamera())
                .printGainMm(printGainMm);
        String family = cell.family().familyName();
        double outlinePx = outlinesDrawn ? outlineStdPx(simulated) * random.nextGaussian() : 0;
        Scene built;
        try {
            for (MarkerSize marker : sizes(cell)) {
                // with what is printed inside, or the inner edges would tell
                double sidePx = outlinePx == 0 ? 0 : sidePx(simulated, marker.id());
                double larger = sidePx > 0 ? 1 + 2 * outlinePx / sidePx : 1;
                RigidTransform reference = simulated.worldFromReferences().get(marker.id());
                scene.marker(family, marker.id(), larger * marker.sizeMm(),
                        reference != null ? reference : simulated.truth().worldFromObject(marker.id()));
            }
            built = scene.build();
        } catch (IllegalArgumentException e) {
            throw new InputRefusedException(
                    Refusal.at(Place.of("simulated"), Unrendered.SCENE, String.valueOf(e.getMessage())), e);
        }
        GreyImage image = SceneRenderer.renderNearMarkers(built, sensor, random);
        try {
            return jpegQuality == 0 ? image : GreyJpeg.roundTrip(image, jpegQuality);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }
}
