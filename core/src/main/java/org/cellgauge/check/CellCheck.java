package org.cellgauge.check;

import io.reactivex.rxjava3.core.Flowable;
import java.util.Objects;
import org.cellgauge.cell.Cell;
import org.cellgauge.cell.InputRefusedException;
import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.settings.CheckSettings;
import org.cellgauge.vision.Detections;
import org.jspecify.annotations.Nullable;

/**
 * The check of one photo: from its detections to camera and object poses with uncertainties and a verdict.
 *
 * <p>Modes first (damped Gauss-Newton), Laplace's approximation as a quick look, then chains until the Monte Carlo
 * error of every standard deviation is small enough. The same cell, detections, settings and seed give the same result
 * whatever the number of threads.
 */
public final class CellCheck {
    private CellCheck() { }

    /**
     * The check of one photo as a stream: the quick look, running statistics, the result last.
     *
     * <dl>
     * <dt><b>Backpressure:</b></dt>
     * <dd>Latest value: a slow subscriber misses updates but always gets the newest and the result.</dd>
     * <dt><b>Scheduler:</b></dt>
     * <dd>Works on the thread that subscribes; chains step on threads of their own.</dd>
     * <dt><b>Error handling:</b></dt>
     * <dd>{@link InputRefusedException} where the photo shows too little; anything else is a fault of the program.
     * Cancelling stops the chains at once.</dd>
     * </dl>
     *
     * @param cell the cell
     * @param detections markers seen in its photo; ids foreign to the cell are ignored
     * @param settings how to go about it
     * @return updates; each subscription runs the whole check anew
     */
    public static Flowable<CheckUpdate> stream(Cell cell, Detections detections, CheckSettings settings) {
        return Flowable.defer(() -> {
            QuickLook quickLook = quickLook(cell, detections, settings, null);
            return Flowable.just(quickLook.update()).concatWith(quickLook.chains(settings.sampling()::threads));
        }).onBackpressureLatest();
    }

    /**
     * The first part of the check of one photo: modes and Laplace's approximation, without chains.
     *
     * @param cell the cell
     * @param detections markers seen in its photo; ids foreign to the cell are ignored
     * @param settings how to go about it
     * @param worldFromCameraStart where the search for the mode starts, for instance at the mode of a similar photo, or
     *     null for the initial estimate of the settings. It is used only where it leads to a mode that explains the
     *     corners as well as their noise lets expect, and never where two references or fewer need a weak prior, which
     *     is about the initial estimate
     * @return the quick look, from which the chains can be run
     * @throws InputRefusedException as {@link #run}
     */
    public static QuickLook quickLook(Cell cell, Detections detections, CheckSettings settings,
            @Nullable RigidTransform worldFromCameraStart) {
        return new QuickLooks(cell, settings).of(detections, worldFromCameraStart);
    }

    /**
     * Runs the check to its end.
     *
     * @param cell the cell
     * @param detections markers seen in its photo
     * @param settings how to go about it
     * @return the result
     * @throws InputRefusedException if the photo shows no reference, or corners that no camera pose explains
     */
    public static CheckResult run(Cell cell, Detections detections, CheckSettings settings) {
        return Objects.requireNonNull(stream(cell, detections, settings).blockingLast().result(),
                "the last update has the result");
    }
}
