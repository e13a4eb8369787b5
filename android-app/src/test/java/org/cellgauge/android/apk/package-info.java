/**
 * Tests of what is built from the app: its APKs, and its code after shrinking. The build makes those first, unless
 * {@code -Ptests} leaves out every class of this package.
 */
package org.cellgauge.android.apk;
