/** How the device itself is doing. */
package org.cellgauge.android.device;
