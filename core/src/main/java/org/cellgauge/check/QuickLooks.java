package org.cellgauge.check;

import org.cellgauge.cell.Cell;
import org.cellgauge.cell.InputRefusedException;
import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.internal.pose.MarkerPoseFinder;
import org.cellgauge.settings.CheckSettings;
import org.cellgauge.vision.Detections;
import org.jspecify.annotations.Nullable;

/**
 * Quick looks at photos of one cell, one after another, as at the frames of a camera that moves. A look depends on its
 * own photo and start alone.
 *
 * <p>Not thread-safe: it holds work space, which all looks share.
 */
public final class QuickLooks {
    private final Cell cell;
    private final CheckSettings settings;
    private final MarkerPoseFinder finder = new MarkerPoseFinder();

    /**
     * Looks at a cell.
     *
     * @param cell the cell
     * @param settings how to go about it
     */
    public QuickLooks(Cell cell, CheckSettings settings) {
        this.cell = cell;
        this.settings = settings;
    }

    /**
     * The first part of the check of one photo: modes and Laplace's approximation, without chains; see
     * {@link CellCheck#quickLook}.
     *
     * @param detections markers seen in it; ids foreign to the cell are ignored
     * @param worldFromCameraStart where the search for the mode starts, or null for the initial estimate of the
     *     settings
     * @return the quick look, which may be kept and handed to other threads
     * @throws InputRefusedException if the photo shows no reference, or corners that no camera pose explains
     */
    public QuickLook of(Detections detections, @Nullable RigidTransform worldFromCameraStart) {
        return QuickLook.of(CellModes.of(Observed.of(cell, detections, settings, finder), worldFromCameraStart,
                finder));
    }
}
