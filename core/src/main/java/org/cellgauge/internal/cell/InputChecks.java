package org.cellgauge.internal.cell;

import org.cellgauge.cell.Cell;
import org.cellgauge.cell.CellRefusal;
import org.cellgauge.cell.InputRefusedException;

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
        ofSize(cell, widthPx, heightPx, name, false);
    }

    /**
     * The cell as its camera shows it in images of a size.
     *
     * @param cell the cell
     * @param widthPx image width, px
     * @param heightPx image height, px
     * @param name the image's or detections file's name for the message
     * @param scale whether the camera may be scaled to images of the calibrated shape
     * @return the cell itself where the size is the calibrated one, else its camera scaled
     * @throws InputRefusedException if the sizes differ and may not, or the shapes do
     */
    public static Cell ofSize(Cell cell, int widthPx, int heightPx, String name, boolean scale) {
        int width = cell.camera().widthPx();
        int height = cell.camera().heightPx();
        if (widthPx == width && heightPx == height) {
            return cell;
        }
        CellPhrase remedy;
        if (widthPx == height && heightPx == width) {
            remedy = CellPhrase.IMAGE_TURNED;
        } else if (cell.camera().hasShape(widthPx, heightPx)) {
            if (scale) {
                return cell.scaledTo(widthPx, heightPx);
            }
            remedy = CellPhrase.IMAGE_SCALED;
        } else {
            remedy = CellPhrase.OTHER_SIZE;
        }
        throw new InputRefusedException(name, CellRefusal.IMAGE_SIZE, widthPx, heightPx, width, height, remedy);
    }
}
