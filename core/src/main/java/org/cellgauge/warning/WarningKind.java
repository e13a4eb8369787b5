package org.cellgauge.warning;

/** What a warning, or a part of one, says. */
public interface WarningKind extends MessageKind {
}
