package org.cellgauge.warning;

/** Why an input is refused, or a part of the sentence that says it. */
public interface RefusalKind extends MessageKind {
}
