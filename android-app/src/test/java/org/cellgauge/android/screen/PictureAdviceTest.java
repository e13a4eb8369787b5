package org.cellgauge.android.screen;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import android.view.Surface;
import android.view.View;
import java.util.Arrays;
import org.cellgauge.android.R;
import org.cellgauge.android.camera.CameraNote;
import org.cellgauge.vision.GreyImage;
import org.junit.Test;
import org.junit.runner.RunWith;
import org.robolectric.RobolectricTestRunner;
import org.robolectric.annotation.Config;

/** What is wrong with light and sharpness is said in words of action, and the lamp is at hand. */
@RunWith(RobolectricTestRunner.class)
@Config(application = TestApp.class, qualifiers = Screen.TABLET_LANDSCAPE, minSdk = 27)
public class PictureAdviceTest {
    private static final Fixture FIXTURE = Fixture.LIFTED;

    private static TestApp.FakeFeed feed() {
        return Screen.app().feed;
    }

    private static Screen live() {
        Screen.turnDisplay(Surface.ROTATION_90);
        return Screen.live(FIXTURE.document(), 90, false);
    }

    /** What the banner says to do about a frame. */
    private static String next(Screen screen, GreyImage frame) {
        long before = screen.state().live() == null ? 0 : screen.state().live().frameNumber();
        feed().frame(frame);
        screen.until("look", () -> screen.state().live() != null && screen.state().live().frameNumber() > before);
        return screen.text(R.id.banner_next);
    }

    private static GreyImage even(int grey) {
        GreyImage image = FIXTURE.blank();
        Arrays.fill(image.luminance(), (byte) grey);
        return image;
    }


    /** The fixture with a lamp mirrored in a part of it. */
    private static GreyImage glareIn(int left, int top, int right, int bottom) {
        GreyImage image = FIXTURE.image();
        for (int y = top; y < bottom; y++) {
            for (int x = left; x < right; x++) {
                int at = y * image.widthPx() + x;
                image.luminance()[at] = (byte) Math.min(255, (image.luminance()[at] & 0xFF) * 5 / 2);
            }
        }
        return image;
    }

    /** The fixture out of focus or moved: means of so many pixels to either side, along rows and then along columns. */
    private static GreyImage smeared(int px) {
        GreyImage image = FIXTURE.image();
        smear(image.luminance(), 1, px);
        smear(image.luminance(), image.widthPx(), px);
        return image;
    }

    private static void smear(byte[] grey, int step, int px) {
        byte[] from = grey.clone();
        for (int i = px * step; i < grey.length - px * step; i++) {
            int sum = 0;
            for (int d = -px; d <= px; d++) {
                sum += from[i + d * step] & 0xFF;
            }
            grey[i] = (byte) (sum / (2 * px + 1));
        }
    }

    @Test
    public void darknessAsksForLightAndForTheLampWhereThereIsOne() {
        try (Screen screen = live()) {
            assertEquals("Too dark: give more light.", next(screen, even(3)));
            assertEquals("Too bright: take away light, or tilt the tablet until nothing glares.",
                    next(screen, even(250)));
            assertEquals(View.GONE, screen.find(R.id.torch).getVisibility());
        }
        feed().hasTorch = true;
        try (Screen screen = live()) {
            assertEquals("Too dark: switch the light on, or give more.", next(screen, even(3)));
            screen.tap(R.id.torch);
            assertTrue(feed().torch);
            assertEquals("Switch the light off", screen.find(R.id.torch).getContentDescription());
            assertEquals("Too dark: give more light.", next(screen, even(3)));
            screen.tap(R.id.torch);
            assertFalse(feed().torch);
        }
    }

    @Test
    public void theLampGoesOutWithTheAppAndStaysOnThroughATurn() {
        feed().hasTorch = true;
        try (Screen screen = live()) {
            screen.tap(R.id.torch);
            screen.turn(Screen.TABLET_PORTRAIT, Surface.ROTATION_0);
            assertTrue(screen.state().torch());
            assertTrue(feed().torch);
        }
        assertFalse(feed().torch);
    }

    @Test
    public void glareIsSaidOfItsMarker() {
        try (Screen screen = live()) {
            // 944 is at (745, 171)
            assertEquals("Glare on marker 944: tilt the tablet.", next(screen, glareIn(760, 100, 830, 215)));
        }
    }

    @Test
    public void aSmearedPictureAsksForASteadyHand() {
        try (Screen screen = live()) {
            assertEquals("Blurred: hold the tablet steadier.", next(screen, smeared(3)));
            assertEquals("Blurred: hold the tablet steadier.", next(screen, smeared(10)));
        }
    }

    @Test
    public void aFocusThatWasNotFoundIsSaid() {
        try (Screen screen = live()) {
            feed().opened(FIXTURE.cell().camera(), 90, false, CameraNote.FOCUS_NOT_FOUND);
            screen.settle();
            assertTrue(next(screen, FIXTURE.blank()).startsWith("Nothing is sharp: step back"));
        }
    }

    @Test
    public void tooLittleLightForShortExposuresIsSaid() {
        try (Screen screen = live()) {
            feed().opened(FIXTURE.cell().camera(), 90, false, CameraNote.LIGHT_SHORT);
            screen.settle();
            assertEquals("Too dark: give more light.", next(screen, FIXTURE.blank()));
        }
    }

    @Test
    public void whereTheFocusIsTheCalibrationsDistanceIsAWayOutOfBlur() {
        try (Screen screen = live()) {
            feed().opened(FIXTURE.cell().camera(), 90, false, CameraNote.FOCUS_AS_CALIBRATED);
            screen.settle();
            assertEquals("Blurred: hold the tablet steadier, or look from the distance that it was calibrated at.",
                    next(screen, smeared(3)));
        }
    }

    @Test
    public void nothingIsSaidOfAPictureThatIsAsItShouldBe() {
        try (Screen screen = live()) {
            assertEquals("Hold the camera still for a moment.", next(screen, FIXTURE.image()));
        }
    }

    @Test
    public void aLensThatMovesByItselfTakesTheFiguresAway() {
        try (Screen screen = live()) {
            screen.holdStillUntilResult(FIXTURE);
            feed().listener().onFocusing();
            screen.settle();
            assertEquals("Focusing…", screen.text(R.id.banner_headline));
            feed().frame(FIXTURE.image());
            screen.until("figures", () -> !screen.state().awaitsFrame());
        }
    }
}
