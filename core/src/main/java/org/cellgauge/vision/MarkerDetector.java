package org.cellgauge.vision;

/**
 * Finds the markers of one cell in images of one camera.
 *
 * <p>A detector is made once for a camera and its markers and reused for every frame. Unless an implementation says
 * otherwise it is not thread-safe: give every thread its own.
 */
public interface MarkerDetector {
    /**
     * Finds markers.
     *
     * @param image the image as the camera delivered it, distorted by its lens, of the size the camera is calibrated
     *     for; not changed, and not kept after the call
     * @param imageName name of the image for messages and results
     * @return at most one observation per id, in ascending order of ids, with warnings about what was left out or is
     *     doubtful; corners are distorted pixels
     * @throws org.cellgauge.cell.InputRefusedException if the image's size is not the camera's
     */
    Detections detect(GreyImage image, String imageName);
}
