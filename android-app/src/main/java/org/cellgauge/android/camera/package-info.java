/**
 * The device's camera as a stream of grey frames, and what is known of how it sees.
 *
 * <p>What is decided about a camera (which one, which sizes, which model, which settings of a request) is decided in
 * classes that see only {@link org.cellgauge.android.camera.CameraTraits}; only
 * {@link org.cellgauge.android.camera.Camera2Feed} and its run touch a camera.
 */
package org.cellgauge.android.camera;
