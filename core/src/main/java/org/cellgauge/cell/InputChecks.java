package org.cellgauge.cell;

/** Judges inputs against the cell they are used with. */
public final class InputChecks {
    private InputChecks() {
    }

    /**
     * Refuses an image of another size than the camera was calibrated for: every figure would be wrong without notice.
     *
     * @param cell the cell
     * @param widthPx image width, px
     * @param heightPx image height, px
     * @param name the image's or detections file's name for the message
     * @throws InputRefusedException if the sizes differ
     */
    public static void imageSize(Cell cell, int widthPx, int heightPx, String name) {
        int width = cell.camera().widthPx();
        int height = cell.camera().heightPx();
        if (widthPx == width && heightPx == height) {
            return;
        }
        String remedy;
        if (widthPx == height && heightPx == width) {
            remedy = "the image is turned; store it as the camera took it";
        } else if ((long) widthPx * height == (long) heightPx * width) {
            remedy = "the image is scaled; take it in the calibrated size, or calibrate the camera in this size";
        } else {
            remedy = "take the image in the calibrated size, or calibrate the camera in this size";
        }
        throw new InputRefusedException(name + ": the image is " + widthPx + " x " + heightPx
                + " px, but the camera is calibrated for " + width + " x " + height + " px; " + remedy);
    }
}
