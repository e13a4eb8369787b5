package org.cellgauge.internal.validation;

import org.apache.commons.math3.random.RandomGenerator;
import org.cellgauge.vision.Detections;

/**
 * Where the detections of a simulated cell come from: corners drawn about their true places, or found in a rendered
 * photo. Implementations may be called by several threads at once.
 */
public interface DetectionSource {
    /**
     * What is seen of a cell.
     *
     * @param simulated the cell with its truth
     * @param random source of all noise
     * @return what a detector reports
     * @throws org.cellgauge.cell.InputRefusedException if nothing can be seen of it
     */
    Detections detect(SimulatedCell simulated, RandomGenerator random);
}
