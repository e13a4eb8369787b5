package org.cellgauge.android.state;

import android.os.Bundle;
import org.cellgauge.android.files.AppMemory;
import org.cellgauge.android.files.TargetText;
import org.cellgauge.cell.Target;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.internal.geometry.Lenses;

/**
 * What of a session outlives its process: what was chosen, not what was computed. The same choices and the same seed
 * give the same figures again. Immutable.
 */
public final class SessionMemory {
    private static final String SEED = "seed";
    private static final String HAS_CELL = "has-cell";
    private static final String CELL = "cell";
    private static final String CALIBRATION = "calibration";
    private static final String TARGET_CHOSEN = "target-chosen";
    private static final String TARGET = "target-text";
    private static final String SOURCE = "source";
    private static final String PHOTO = "photo";
    private static final String CAMERA = "camera";
    private static final String CAMERA_LENS = "camera-lens";
    private static final String CAMERA_WIDTH = "camera-width";
    private static final String CAMERA_HEIGHT = "camera-height";
    private static final String LENS = "lens-estimated";

    private final long seed;
    private final boolean hasCell;
    private final String cellUri;
    private final String calibrationUri;
    private final boolean targetChosen;
    private final Target target;
    private final ImageSource source;
    private final String photoUri;
    private final PinholeCamera photoCamera;
    private final boolean lensEstimated;

    private SessionMemory(long seed, boolean hasCell, String cellUri, String calibrationUri, boolean targetChosen,
            Target target, ImageSource source, String photoUri, PinholeCamera photoCamera,
            boolean lensEstimated) {
        this.seed = seed;
        this.hasCell = hasCell;
        this.cellUri = cellUri;
        this.calibrationUri = calibrationUri;
        this.targetChosen = targetChosen;
        this.target = target;
        this.source = source;
        this.photoUri = photoUri;
        this.photoCamera = photoCamera;
        this.lensEstimated = lensEstimated;
    }

    /**
     * The memory of a session with a cell.
     *
     * @param seed of the chains
     * @param cellUri of the cell file; null for the bundled example
     * @param calibrationUri of a calibration file chosen with it, or null
     * @param targetChosen whether the target is the user's and not the cell file's
     * @param target that target
     * @param source what was shown
     * @param photoUri of the photo that was shown; null for the bundled one or none
     * @param photoCamera the camera of the photo or frozen frame, or null
     * @param lensEstimated whether its lens was not measured and is estimated along
     */
    SessionMemory(long seed, String cellUri, String calibrationUri, boolean targetChosen, Target target,
            ImageSource source, String photoUri, PinholeCamera photoCamera, boolean lensEstimated) {
        this(seed, true, cellUri, calibrationUri, targetChosen, target, source, photoUri, photoCamera,
                lensEstimated);
    }

    /**
     * The memory of a session in which nothing was chosen.
     *
     * @param seed of the chains
     * @return a memory without a cell
     */
    public static SessionMemory nothing(long seed) {
        return new SessionMemory(seed, false, null, null, false, Target.NONE, ImageSource.LIVE, null, null,
                false);
    }

    /**
     * The memory that a start of the app has of the last one.
     *
     * @param seed of the chains
     * @param last cell, calibration and target that were in use, or null
     * @return their cell, live and with that target, or the cell file's; without a cell where there are none
     */
    public static SessionMemory of(long seed, AppMemory.Choice last) {
        return last == null ? nothing(seed) : new SessionMemory(seed, last.cellUri(), last.calibrationUri(),
                last.target() != null, last.target() == null ? Target.NONE : last.target(), ImageSource.LIVE, null,
                null, false);
    }

    /**
     * Reads a memory.
     *
     * @param bundle what {@link #write(Bundle)} wrote, perhaps in another process
     * @return the memory
     */
    public static SessionMemory read(Bundle bundle) {
        Target target = TargetText.read(bundle.getString(TARGET));
        double[] intrinsics = bundle.getDoubleArray(CAMERA);
        PinholeCamera camera = intrinsics == null ? null
                : PinholeCamera.of(Lenses.named(bundle.getString(CAMERA_LENS)), bundle.getInt(CAMERA_WIDTH),
                        bundle.getInt(CAMERA_HEIGHT), intrinsics);
        return new SessionMemory(bundle.getLong(SEED), bundle.getBoolean(HAS_CELL), bundle.getString(CELL),
                bundle.getString(CALIBRATION), bundle.getBoolean(TARGET_CHOSEN) && target != null,
                target == null ? Target.NONE : target,
                ImageSource.valueOf(bundle.getString(SOURCE, ImageSource.LIVE.name())), bundle.getString(PHOTO), camera,
                bundle.getBoolean(LENS));
    }

    /**
     * Writes the memory.
     *
     * @param bundle gets it
     */
    public void write(Bundle bundle) {
        bundle.putLong(SEED, seed);
        bundle.putBoolean(HAS_CELL, hasCell);
        bundle.putString(CELL, cellUri);
        bundle.putString(CALIBRATION, calibrationUri);
        bundle.putBoolean(TARGET_CHOSEN, targetChosen);
        bundle.putString(TARGET, TargetText.of(target));
        bundle.putString(SOURCE, source.name());
        bundle.putString(PHOTO, photoUri);
        if (photoCamera != null) {
            bundle.putString(CAMERA_LENS, photoCamera.lens().modelName());
            bundle.putDoubleArray(CAMERA, photoCamera.intrinsics());
            bundle.putInt(CAMERA_WIDTH, photoCamera.widthPx());
            bundle.putInt(CAMERA_HEIGHT, photoCamera.heightPx());
        }
        bundle.putBoolean(LENS, lensEstimated);
    }

    long seed() {
        return seed;
    }

    boolean hasCell() {
        return hasCell;
    }

    String cellUri() {
        return cellUri;
    }

    String calibrationUri() {
        return calibrationUri;
    }

    boolean targetChosen() {
        return targetChosen;
    }

    Target target() {
        return target;
    }

    ImageSource source() {
        return source;
    }

    String photoUri() {
        return photoUri;
    }

    PinholeCamera photoCamera() {
        return photoCamera;
    }

    boolean lensEstimated() {
        return lensEstimated;
    }
}
