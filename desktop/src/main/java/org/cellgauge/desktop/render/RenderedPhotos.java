package org.cellgauge.desktop.render;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.Queue;
import java.util.concurrent.ConcurrentLinkedQueue;
import org.apache.commons.math3.random.RandomGenerator;
import org.cellgauge.cell.Cell;
import org.cellgauge.cell.InputRefusedException;
import org.cellgauge.cell.ObjectMarker;
import org.cellgauge.cell.Reference;
import org.cellgauge.internal.validation.DetectionSource;
import org.cellgauge.internal.validation.SimulatedCell;
import org.cellgauge.vision.BoofMarkerDetector;
import org.cellgauge.vision.Detections;
import org.cellgauge.vision.GreyImage;
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
     */
    public RenderedPhotos(Sensor sensor, int jpegQuality, double printGainMm) {
        this.sensor = sensor;
        this.jpegQuality = jpegQuality;
        this.printGainMm = printGainMm;
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

    /**
     * The photo of a cell.
     *
     * @param simulated the cell with its truth
     * @param random source of the noise
     * @return the photo as decoded from its file
     */
    public GreyImage photo(SimulatedCell simulated, RandomGenerator random) {
        Cell cell = simulated.cell();
        String family = cell.family().familyName();
        Scene.Builder scene = Scene.of(simulated.truth().camera(cell), simulated.truth().worldFromCamera())
                .printGainMm(printGainMm);
        for (Reference r : cell.references()) {
            scene.marker(family, r.id(), r.sizeMm(), simulated.worldFromReferences().get(r.id()));
        }
        for (ObjectMarker o : cell.objects()) {
            scene.marker(family, o.id(), o.sizeMm(), simulated.truth().worldFromObjects().get(o.id()));
        }
        Scene built;
        try {
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
