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
     * @param outlinesDrawn whether the outlines of all markers of a photo lie, alike, off where their inner edges say by
     *     a draw from what a check allows for ({@link PhotoLight#usualOutlineStdPx(double, double)}), as references are off
     *     their places by draws from their placement; else prints are exact
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

    private double outlineStdPx() {
        double white = 255 * sensor.toneCurve().grey(sensor.exposure() * PlanarMarker.WHITE) + sensor.blackLevelGrey();
        return PhotoLight.usualOutlineStdPx(sensor.blurPx(), Math.min(255, white));
    }

    /**
     * Size of a print whose sides are seen so many pixels outside of where they belong: with what is printed inside, or
     * the inner edges would tell.
     */
    private static double printedMm(SimulatedCell simulated, int id, double sizeMm, double outlinePx) {
        double[] corners = outlinePx == 0 ? null : simulated.cornersPx(id);
        if (corners == null) {
            return sizeMm;
        }
        double around = 0;
        for (int i = 0; i < 8; i += 2) {
            around += Math.hypot(corners[(i + 2) % 8] - corners[i], corners[(i + 3) % 8] - corners[i + 1]);
        }
        return sizeMm * (1 + 8 * outlinePx / around);
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
        double outlinePx = outlinesDrawn ? outlineStdPx() * random.nextGaussian() : 0;
        Scene built;
        try {
            for (Reference r : cell.references()) {
                scene.marker(family, r.id(), printedMm(simulated, r.id(), r.sizeMm(), outlinePx),
                        simulated.worldFromReferences().get(r.id()));
            }
            for (ObjectMarker o : cell.objects()) {
                scene.marker(family, o.id(), printedMm(simulated, o.id(), o.sizeMm(), outlinePx),
                        simulated.truth().worldFromObjects().get(o.id()));
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
