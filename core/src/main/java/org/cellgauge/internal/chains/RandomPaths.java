package org.cellgauge.internal.chains;

/**
 * First numbers of the paths of the random streams of a check: see
 * {@link org.cellgauge.internal.sampling.RandomStreams}.
 */
public final class RandomPaths {
    /** The stream that tunes the camera's proposal. */
    public static final long TUNING = 1;
    /** The stream of a chain. */
    static final long CHAIN = 2;
    /** The stream of an object's chain. */
    static final long OBJECT = 3;
    /** The stream that tunes an object's proposal. */
    public static final long OBJECT_TUNING = 4;
    /** The stream from which a photo's own seed is drawn. */
    public static final long PHOTO = 5;

    private RandomPaths() { }
}
