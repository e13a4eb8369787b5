package org.cellgauge.internal.overlay;

/** How what a shape stands for was judged; a painter maps it to a colour, and a {@link Mark} says it without colour. */
public enum Status {
    /** Within the target. */
    PASS,
    /** Beyond the target, or not usable. */
    FAIL,
    /** No figure of it can be trusted, or none can yet. */
    NOT_CONVERGED,
    /** Two poses explain it. */
    AMBIGUOUS,
    /** Not judged. */
    NEUTRAL
}
