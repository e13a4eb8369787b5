package org.cellgauge.android.camera;

import java.util.Collections;
import java.util.EnumSet;
import java.util.Set;
import org.cellgauge.geometry.PinholeCamera;

/** How an opened camera delivers its frames; immutable. */
public final class CameraSetup {
    private final PinholeCamera camera;
    private final CameraModelSource source;
    private final int sensorOrientationDeg;
    private final boolean frontFacing;
    private final boolean torch;
    private final Set<CameraNote> notes;

    /**
     * A set-up without a lamp.
     *
     * @param camera intrinsics for the frames as they come, in sensor orientation; its size is theirs
     * @param source where the intrinsics come from
     * @param sensorOrientationDeg clockwise angle by which a frame is turned to stand upright on a device in its
     *     natural orientation: 0, 90, 180 or 270
     * @param frontFacing whether the camera looks at the user, so that its preview is mirrored
     * @param notes what the user should know
     */
    public CameraSetup(PinholeCamera camera, CameraModelSource source, int sensorOrientationDeg, boolean frontFacing,
            Set<CameraNote> notes) {
        this(camera, source, sensorOrientationDeg, frontFacing, false, notes);
    }

    /**
     * A set-up.
     *
     * @param camera intrinsics for the frames as they come, in sensor orientation; its size is theirs
     * @param source where the intrinsics come from
     * @param sensorOrientationDeg clockwise angle by which a frame is turned to stand upright on a device in its
     *     natural orientation: 0, 90, 180 or 270
     * @param frontFacing whether the camera looks at the user, so that its preview is mirrored
     * @param torch whether there is a lamp beside it
     * @param notes what the user should know
     */
    public CameraSetup(PinholeCamera camera, CameraModelSource source, int sensorOrientationDeg, boolean frontFacing,
            boolean torch, Set<CameraNote> notes) {
        this.torch = torch;
        this.camera = camera;
        this.source = source;
        this.sensorOrientationDeg = sensorOrientationDeg;
        this.frontFacing = frontFacing;
        Set<CameraNote> copy = EnumSet.noneOf(CameraNote.class);
        copy.addAll(notes);
        this.notes = Collections.unmodifiableSet(copy);
    }

    /**
     * Intrinsics for the frames as they come.
     *
     * @return in sensor orientation; width and height are those of the frames
     */
    public PinholeCamera camera() {
        return camera;
    }

    /**
     * Where the intrinsics come from.
     *
     * @return the source; {@link CameraModelSource#FIELD_OF_VIEW} asks for the focal length to be sampled
     */
    public CameraModelSource source() {
        return source;
    }

    /**
     * Clockwise angle by which a frame is turned to stand upright on a device in its natural orientation.
     *
     * @return 0, 90, 180 or 270 degrees
     */
    public int sensorOrientationDeg() {
        return sensorOrientationDeg;
    }

    /**
     * Whether the camera looks at the user.
     *
     * @return true where the preview is mirrored
     */
    public boolean frontFacing() {
        return frontFacing;
    }

    /**
     * Whether there is a lamp beside the camera.
     *
     * @return true where {@link CameraFeed#torch} has an effect
     */
    public boolean hasTorch() {
        return torch;
    }

    /**
     * The same with other notes.
     *
     * @param others what the user should know
     * @return a copy
     */
    CameraSetup withNotes(Set<CameraNote> others) {
        return new CameraSetup(camera, source, sensorOrientationDeg, frontFacing, torch, others);
    }

    /**
     * What the user should know.
     *
     * @return unmodifiable
     */
    public Set<CameraNote> notes() {
        return notes;
    }
}
