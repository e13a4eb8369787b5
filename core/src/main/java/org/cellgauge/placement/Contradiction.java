package org.cellgauge.placement;

import org.cellgauge.internal.laplace.CameraFit;
import org.jspecify.annotations.Nullable;

/**
 * References that no camera pose makes sense of where the cell file has them, and what would explain it; immutable.
 * Figures that rest on them are worth nothing.
 */
public final class Contradiction {
    /** Nothing explains it. */
    public static final Contradiction UNEXPLAINED = new Contradiction(null);

    private final @Nullable Explanation explanation;

    private Contradiction(@Nullable Explanation explanation) {
        this.explanation = explanation;
    }

    /**
     * Whether references fit so badly that it is worth looking for what explains it.
     *
     * @param stated the camera from all references as stated
     * @return mostly false
     */
    public static boolean isSuspected(CameraFit stated) {
        return CauseSearch.isCalledFor(stated);
    }

    /**
     * Looks for what explains a bad fit.
     *
     * @param stated the camera from all references as stated, at its modes and at a corner noise that the photo does
     *     not contradict
     * @return null where the references fit as well as many do by chance; one without an explanation where nothing
     *     explains why they do not
     */
    public static @Nullable Contradiction of(CameraFit stated) {
        return CauseSearch.isCalledFor(stated) ? new Contradiction(CauseSearch.of(stated)) : null;
    }

    /**
     * What explains it.
     *
     * @return null where nothing does
     */
    public @Nullable Explanation explanation() {
        return explanation;
    }
}
