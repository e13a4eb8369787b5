package org.cellgauge.check;

import io.reactivex.rxjava3.core.Flowable;
import java.util.function.Function;
import java.util.function.IntSupplier;

/**
 * The first part of a check: the poses that explain a photo best, with Laplace's approximation of their uncertainty;
 * and the way from there to the chains. Immutable.
 */
public final class QuickLook {
    private final CheckUpdate update;
    private final double pixelStdPx;
    private final Function<IntSupplier, Flowable<CheckUpdate>> sampling;

    QuickLook(CheckUpdate update, double pixelStdPx, Function<IntSupplier, Flowable<CheckUpdate>> sampling) {
        this.update = update;
        this.pixelStdPx = pixelStdPx;
        this.sampling = sampling;
    }

    /**
     * What it says.
     *
     * @return an update of the phase {@link CheckUpdate.Phase#QUICK_LOOK}; its camera pose is the heaviest mode
     */
    public CheckUpdate update() {
        return update;
    }

    /**
     * Standard deviation of each corner coordinate that was assumed or estimated.
     *
     * @return px
     */
    public double pixelStdPx() {
        return pixelStdPx;
    }

    /**
     * The rest of the check: running statistics, the result last.
     *
     * <dl>
     * <dt><b>Backpressure:</b></dt>
     * <dd>Latest value: a slow subscriber misses updates but always gets the newest and the result.</dd>
     * <dt><b>Scheduler:</b></dt>
     * <dd>Works on the thread that subscribes; chains step on threads of their own.</dd>
     * <dt><b>Error handling:</b></dt>
     * <dd>{@link org.cellgauge.cell.InputRefusedException} where no chain can start; anything else is a fault of the
     * program. Cancelling stops the chains at once.</dd>
     * </dl>
     *
     * @param threads asked again and again how many threads to step the chains on, at least 1; no figure depends on it
     * @return updates; each subscription runs the chains anew, with the same draws
     */
    public Flowable<CheckUpdate> chains(IntSupplier threads) {
        return Flowable.defer(() -> sampling.apply(threads)).onBackpressureLatest();
    }
}
