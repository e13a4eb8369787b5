package org.cellgauge.desktop.reproduce;

import java.util.function.Supplier;

/**
 * A piece of work whose figures are kept.
 *
 * @param name of it, as progress shows it and sections ask for it
 * @param identity everything besides the program that its figures depend on
 * @param figures does it; the same figures each time, in any thread
 */
record Work(String name, String identity, Supplier<Figures> figures) {
}
