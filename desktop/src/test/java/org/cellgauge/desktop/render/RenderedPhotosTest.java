package org.cellgauge.desktop.render;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.LinkedHashMap;
import java.util.Map;
import org.apache.commons.math3.random.RandomGenerator;
import org.cellgauge.cell.Cell;
import org.cellgauge.cell.CellReader;
import org.cellgauge.cell.Reference;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.internal.pose.CornerErrors;
import org.cellgauge.internal.sampling.RandomStreams;
import org.cellgauge.internal.validation.CellTruth;
import org.cellgauge.internal.validation.SimulatedCell;
import org.cellgauge.vision.Detections;
import org.cellgauge.vision.EdgeShift;
import org.cellgauge.vision.PhotoLight;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Photos of simulated cells. */
class RenderedPhotosTest {
    private static final Sensor SENSOR = Sensor.USUAL.withBlurPx(1.5).withNoiseGrey(0.5);
    private static final double WHITE_GREY = 255 * PlanarMarker.WHITE;
    /** Markers of 40 mm in 8 cells, at 480 mm and 600 px. */
    private static final double CELL_PX = 40 * 600.0 / 480 / 8;
    private static final int PHOTOS = 12;

    /**
     * Sides lie, as a check takes them, corrected for what inner edges show, by the draw outside of where exact prints
     * have them: the first number of the stream times the deviation that a check allows for.
     */
    @ParameterizedTest
    @ValueSource(longs = {1, 2})
    void sidesAreOffByTheDraw(long seed) {
        RenderedPhotos exact = new RenderedPhotos(SENSOR, 0, 0, false);
        RenderedPhotos drawn = new RenderedPhotos(SENSOR, 0, 0, true);
        SimulatedCell cell = cell();
        double byDraw = 0;
        double draws = 0;
        for (int i = 0; i < PHOTOS; i++) {
            double draw = RandomStreams.of(seed, i).nextGaussian();
            double moved = outwardPx(cell, drawn, RandomStreams.of(seed, i))
                    - outwardPx(cell, exact, RandomStreams.of(seed, i));
            byDraw += draw * moved;
            draws += draw * draw;
        }
        double std = PhotoLight.usualOutlineStdPx(SENSOR.blurPx(), WHITE_GREY, CELL_PX);
        // noise of 0.5 grey levels moves the mean of twelve markers' sides by some 0.001 px in a photo
        assertEquals(std, byDraw / draws, 4 * 0.001 * Math.sqrt(2 / draws));
    }

    /** How far the sides of all markers lie outside of their true places, on average. */
    private static double outwardPx(SimulatedCell cell, RenderedPhotos photos, RandomGenerator random) {
        Detections seen = photos.detect(cell, random);
        CornerErrors taken = CornerErrors.of(cell.cell(), seen);
        double along = 0;
        double length = 0;
        for (Reference r : cell.cell().references()) {
            double[] truth = cell.cornersPx(r.id());
            double[] corners = taken.cornersPx(r.id());
            double[] inward = EdgeShift.ofCorners(truth);
            for (int k = 0; k < 8; k++) {
                along -= inward[k] * (corners[k] - truth[k]);
                length += inward[k] * inward[k];
            }
        }
        return along / length;
    }

    private static SimulatedCell cell() {
        StringBuilder text = new StringBuilder("cellgauge: 1\nmarkers: {family: square-binary, size_mm: 40}\n"
                + "placement: {std_mm: [1, 1, 1], std_deg: 0.1}\npixel_std_px: auto\nreferences:\n");
        Map<Integer, RigidTransform> places = new LinkedHashMap<>();
        for (int i = 0; i < 12; i++) {
            double x = 90 * (i % 4) - 135;
            double y = 90 * (i / 4) - 90;
            double turn = 10 + 7 * i;
            text.append("  ").append(20 + i).append(": {position_mm: [").append(x).append(", ").append(y)
                    .append(", 0], rotation_deg: [0, 0, ").append(turn).append("]}\n");
            places.put(20 + i, RigidTransform.ofEuler(x, y, 0, 0, 0, Math.toRadians(turn)));
        }
        Cell cell = CellReader.read(text.toString(), "cell", PinholeCamera.ideal(640, 480, 600, 600, 320, 240));
        CellTruth truth = new CellTruth(RigidTransform.ofEuler(5, -8, 480, Math.PI, 0.05, 0.02), Map.of());
        return new SimulatedCell(cell, truth, places);
    }
}
