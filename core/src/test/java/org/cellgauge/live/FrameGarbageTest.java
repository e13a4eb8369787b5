package org.cellgauge.live;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.cellgauge.Allocated;
import org.cellgauge.internal.vision.BoofThreads;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;

/** What a second of a moving camera leaves to the garbage collector. */
class FrameGarbageTest {
    private static final int ROUNDS = 3;
    /** A good second. */
    private static final int FRAMES = 3 * MovingCamera.PLACES;

    @BeforeAll
    static void staysOnThisThread() {
        BoofThreads.useOne();
    }

    @Test
    void aMovingCameraLeavesLittle() {
        MovingCamera camera = new MovingCamera();
        camera.move(FRAMES);
        camera.forget();
        long bytes = Allocated.leastBytes(ROUNDS, () -> camera.move(FRAMES)) / FRAMES;
        assertEquals(LiveState.Phase.QUICK_LOOK, camera.phase());
        assertTrue(camera.looks() >= 4 * ROUNDS, "looks in three seconds: " + camera.looks());
        assertTrue(camera.drawn() > 10_000, "points drawn: " + camera.drawn());
        // a look at every frame, and its overlay in lists of boxed numbers, were 2300 kB
        assertTrue(bytes < 100_000, bytes + " bytes a frame");
    }
}
