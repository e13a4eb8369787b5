package org.cellgauge.android.screen;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import android.content.Context;
import android.graphics.Bitmap;
import java.io.IOException;
import java.time.Clock;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.OptionalDouble;
import org.cellgauge.android.files.FolderArchive;
import org.cellgauge.android.files.Photo;
import org.cellgauge.cell.Cell;
import org.cellgauge.check.CellCheck;
import org.cellgauge.check.CheckResult;
import org.cellgauge.internal.overlay.Overlay;
import org.cellgauge.internal.overlay.Role;
import org.cellgauge.internal.overlay.Shape;
import org.cellgauge.internal.overlay.StrokeFont;
import org.cellgauge.internal.overlay.TextShape;
import org.cellgauge.settings.CheckSettings;
import org.cellgauge.vision.BoofMarkerDetector;
import org.cellgauge.vision.GreyImage;
import org.junit.Test;
import org.junit.runner.RunWith;
import org.robolectric.RobolectricTestRunner;
import org.robolectric.RuntimeEnvironment;

/** The picture that the app's archive keeps, in the language of the screen. */
@RunWith(RobolectricTestRunner.class)
public class KeptPictureTest {
    private static final Fixture FIXTURE = Fixture.LIFTED;

    private final Context context = RuntimeEnvironment.getApplication();
    private final List<Overlay> painted = new ArrayList<>();
    private String name;

    /** As the app does, and leaves the picture for people to look at. */
    private Bitmap paint(GreyImage photo, Overlay overlay) {
        painted.add(overlay);
        Bitmap bitmap = OverlayPainter.paint(photo, overlay);
        Screen.write(name, bitmap);
        return bitmap;
    }

    private static CheckResult check(Cell cell) {
        Photo photo = FIXTURE.photo();
        return CellCheck.run(cell, BoofMarkerDetector.forCell(cell).detect(photo.luminance(), photo.name()),
                CheckSettings.builder().build());
    }

    private static String texts(Overlay overlay, Role role) {
        List<String> texts = new ArrayList<>();
        for (Shape shape : overlay.shapes(role)) {
            if (shape instanceof TextShape) {
                texts.add(((TextShape) shape).text());
            }
        }
        return String.join(" ", texts);
    }

    private static void assertDrawable(Overlay overlay) {
        for (Shape shape : overlay.shapes()) {
            if (shape instanceof TextShape) {
                for (char c : ((TextShape) shape).text().toCharArray()) {
                    assertTrue(((TextShape) shape).text(), StrokeFont.has(c));
                }
            }
        }
    }

    @Test
    public void bannerLegendAndLabelsFollowTheLanguage() throws IOException {
        FolderArchive archive = new FolderArchive(context, this::paint, new ScreenWords(context),
                Clock.systemUTC(), "1");
        CheckResult failed = check(FIXTURE.doubtful().withTarget(OptionalDouble.of(0.3)));
        RuntimeEnvironment.setQualifiers("de");
        name = "kept-picture-german";
        archive.save(FIXTURE.photo(), failed, "kitchen.yaml");
        Overlay german = painted.get(0);
        Wording words = new Wording(context.getResources());
        assertEquals("Ziel verfehlt " + words.reason(failed.finding()), texts(german, Role.BANNER));
        assertTrue(texts(german, Role.BANNER), texts(german, Role.BANNER).contains("Größte Abweichung")
                || texts(german, Role.BANNER).contains("nicht gesehen"));
        String legend = texts(german, Role.LEGEND);
        assertTrue(legend, legend.contains("wo die Kameralage sie erwarten lässt")
                && legend.contains("95 % der Positionen, " + (german.magnification() == 1 ? "wahre Größe"
                        : String.format(Locale.ROOT, "%.0f-fach vergrößert", german.magnification())))
                && legend.contains("Gitter "));
        String labels = texts(german, Role.LABEL);
        assertTrue(labels, labels.contains("22 scheint versetzt") && labels.contains("Greifpunkt: σ "));
        for (String english : new String[] {"reference", "position", "object", "grid", "mm in x of"}) {
            assertFalse(english, (texts(german, Role.BANNER) + legend + labels).contains(english));
        }
        assertDrawable(german);

        // the language is changed while the app runs
        RuntimeEnvironment.setQualifiers("en");
        name = "kept-picture-english";
        archive.save(FIXTURE.photo(), failed, "kitchen.yaml");
        Overlay english = painted.get(1);
        assertEquals("Target missed " + new Wording(context.getResources()).reason(failed.finding()),
                texts(english, Role.BANNER));
        assertTrue(texts(english, Role.LEGEND), texts(english, Role.LEGEND).contains("95 % of positions, "
                + (english.magnification() == 1 ? "true size" : "magnified ")));
        assertDrawable(english);
        assertEquals(german.shapes(Role.OBJECT_ELLIPSE).size(), english.shapes(Role.OBJECT_ELLIPSE).size());
    }
}
