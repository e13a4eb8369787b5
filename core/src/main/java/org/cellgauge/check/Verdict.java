package org.cellgauge.check;

/** What a check says of a photo. */
public enum Verdict {
    /** Every axis of every object and gripping point is within the target, by twice its Monte Carlo error. */
    PASS("pass"),
    /** An axis is beyond the target or nearer to it than twice its Monte Carlo error, or an object was not seen. */
    FAIL("fail"),
    /** The chains have not converged: no figure can be trusted. */
    NOT_CONVERGED("not-converged"),
    /** Two poses of the camera or an object explain the photo: no single figure describes it. */
    AMBIGUOUS("ambiguous"),
    /** References contradict each other: no figure that rests on them is to be trusted. */
    CONTRADICTED("contradicted"),
    /** Converged, and the cell file sets no target, or has no object, to judge by. */
    NO_TARGET("no-target");

    private final String key;

    Verdict(String key) {
        this.key = key;
    }

    /**
     * Whether there is any figure to trust.
     *
     * @return false where chains have not converged, two poses explain the photo, or references contradict each other
     */
    public boolean isTrusted() {
        return this == PASS || this == FAIL || this == NO_TARGET;
    }

    /**
     * The word of the result file.
     *
     * @return for instance {@code not-converged}
     */
    public String key() {
        return key;
    }
}
