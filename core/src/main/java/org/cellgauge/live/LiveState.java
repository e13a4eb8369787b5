package org.cellgauge.live;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import org.cellgauge.check.CheckUpdate;
import org.cellgauge.vision.Detections;
import org.cellgauge.warning.Refusal;
import org.jspecify.annotations.Nullable;

/**
 * What a live check knows at one moment; immutable.
 *
 * <p>Figures belong to the key frame, not to the newest frame: draw the overlay of {@link #update()} with the markers
 * of {@link #keyFrame()}, moved by {@link #shiftXPx()} and {@link #shiftYPx()}: while the camera is held still, it lies
 * on the newest frame so.
 */
public final class LiveState {
    /** How far the check has come. */
    public enum Phase {
        /** No reference is in view; there are no figures. */
        SEARCHING,
        /** Laplace's approximation of the key frame; its figures are preliminary. */
        QUICK_LOOK,
        /** Chains are running on the key frame; figures are preliminary. */
        SAMPLING,
        /** The check of the key frame has ended; {@code update().result()} has the verdict. */
        RESULT,
        /** The frame cannot be estimated; {@link LiveState#refusal()} says why; there are no figures. */
        REFUSED
    }

    private final Phase phase;
    private final Detections detections;
    private final long frameNumber;
    private final @Nullable Detections keyFrame;
    private final long keyFrameNumber;
    private final @Nullable CheckUpdate update;
    private final List<Integer> missingReferences;
    private final List<Integer> missingObjects;
    private final double displacementPx;
    private final double shiftXPx;
    private final double shiftYPx;
    private final @Nullable Refusal refusal;

    LiveState(Phase phase, Detections detections, long frameNumber, @Nullable Detections keyFrame,
            long keyFrameNumber, @Nullable CheckUpdate update, List<Integer> missingReferences,
            List<Integer> missingObjects, double displacementPx, double shiftXPx, double shiftYPx,
            @Nullable Refusal refusal) {
        this.phase = phase;
        this.detections = detections;
        this.frameNumber = frameNumber;
        this.keyFrame = keyFrame;
        this.keyFrameNumber = keyFrameNumber;
        this.update = update;
        this.missingReferences = Collections.unmodifiableList(new ArrayList<>(missingReferences));
        this.missingObjects = Collections.unmodifiableList(new ArrayList<>(missingObjects));
        this.displacementPx = displacementPx;
        this.shiftXPx = shiftXPx;
        this.shiftYPx = shiftYPx;
        this.refusal = refusal;
    }

    /**
     * How far the check has come.
     *
     * @return the phase
     */
    public Phase phase() {
        return phase;
    }

    /**
     * Markers of the newest frame.
     *
     * @return never null
     */
    public Detections detections() {
        return detections;
    }

    /**
     * Which frame is the newest: 1 for the first one, frames that were dropped counted.
     *
     * @return the number
     */
    public long frameNumber() {
        return frameNumber;
    }

    /**
     * Markers of the key frame, which the figures belong to.
     *
     * @return null while {@link Phase#SEARCHING} or {@link Phase#REFUSED}
     */
    public @Nullable Detections keyFrame() {
        return keyFrame;
    }

    /**
     * Which frame is the key frame.
     *
     * @return its number, counted as {@link #frameNumber()}, or 0 where there is none
     */
    public long keyFrameNumber() {
        return keyFrameNumber;
    }

    /**
     * The newest figures of the key frame.
     *
     * @return null while {@link Phase#SEARCHING} or {@link Phase#REFUSED}
     */
    public @Nullable CheckUpdate update() {
        return update;
    }

    /**
     * Markers of the cell that the newest frame does not show.
     *
     * @return references, then objects, in the order of the cell; unmodifiable
     */
    public List<Integer> missingIds() {
        List<Integer> all = new ArrayList<>(missingReferences);
        all.addAll(missingObjects);
        return Collections.unmodifiableList(all);
    }

    /**
     * References that the newest frame does not show.
     *
     * @return marker ids in the order of the cell; unmodifiable
     */
    public List<Integer> missingReferences() {
        return missingReferences;
    }

    /**
     * Objects that the newest frame does not show.
     *
     * @return marker ids in the order of the cell; unmodifiable
     */
    public List<Integer> missingObjects() {
        return missingObjects;
    }

    /**
     * How far the newest frame is from the key frame: root mean square distance of corresponding corners, of the marker
     * of the cell that moved most.
     *
     * @return px; NaN where there is no key frame or the two have no marker of the cell in common
     */
    public double displacementPx() {
        return displacementPx;
    }

    /**
     * How far the newest frame's view has moved to the right of the key frame's as a whole: where what is drawn lies on
     * the newest frame.
     *
     * @return px; 0 where there is no key frame or nothing in common
     */
    public double shiftXPx() {
        return shiftXPx;
    }

    /**
     * How far it has moved downwards.
     *
     * @return px, as {@link #shiftXPx()}
     */
    public double shiftYPx() {
        return shiftYPx;
    }

    /**
     * Why the frame was refused.
     *
     * @return what is wrong and the remedy, or null where it was not
     */
    public @Nullable Refusal refusal() {
        return refusal;
    }
}
