/** Warnings to the user as data, from which any language can make sentences; knows no other package. */
package org.cellgauge.warning;
