package org.cellgauge.placement;

import org.cellgauge.internal.laplace.CameraFit;
import org.jspecify.annotations.Nullable;

/**
 * References that no camera pose makes sense of where the cell file has them, and what would explain it; immutable.
 * Figures that rest on them are worth nothing.
 */
public final class Contradiction {
    /** Nothing explains it. */
    public static final Contradiction UNEXPLAINED = new Contradiction(null, null);

    private final @Nullable Explanation explanation;
    private final @Nullable CameraFit asExplained;

    Contradiction(@Nullable Explanation explanation, @Nullable CameraFit asExplained) {
        this.explanation = explanation;
        this.asExplained = asExplained;
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
        return CauseSearch.isCalledFor(stated) ? CauseSearch.of(stated) : null;
    }

    /**
     * Looks for what explains that no camera pose fits at all.
     *
     * @param stated the camera from all references as stated, without modes, at a corner noise that the photo does not
     *     contradict
     * @return null where nothing explains it
     */
    public static @Nullable Contradiction ofNoPose(CameraFit stated) {
        return stated.view.size() > 1 ? CauseSearch.ofNoPose(stated) : null;
    }

    /**
     * What explains it.
     *
     * @return null where nothing does
     */
    public @Nullable Explanation explanation() {
        return explanation;
    }

    /**
     * The camera as it would be if references were as the explanation has them.
     *
     * @param otherwise the camera where nothing is explained, or by something that has a size
     * @return one of the two
     */
    public CameraFit asExplained(CameraFit otherwise) {
        return asExplained == null ? otherwise : asExplained;
    }
}
