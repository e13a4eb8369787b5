package org.cellgauge.android.shipped;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertNotNull;
import static org.robolectric.Shadows.shadowOf;

import android.app.Activity;
import android.os.Looper;
import android.view.View;
import android.view.ViewGroup;
import android.widget.TextView;
import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.Collections;
import java.util.HashSet;
import java.util.function.BooleanSupplier;
import org.junit.Test;
import org.junit.runner.JUnitCore;
import org.junit.runner.Result;
import org.junit.runner.RunWith;
import org.robolectric.Robolectric;
import org.robolectric.RobolectricTestRunner;
import org.robolectric.RuntimeEnvironment;
import org.robolectric.annotation.Config;
import org.robolectric.annotation.GraphicsMode;

/**
 * Leads the app whose classes are on the class path, whatever they were made from, by what a user sees: first start,
 * the example, its verdict, Save. Knows nothing of the app but what the manifest and the resources name. A process of
 * its own: the class path must hold no other classes of the app.
 */
@RunWith(RobolectricTestRunner.class)
@Config(qualifiers = "w1280dp-h800dp-land-notnight-mdpi")
@GraphicsMode(GraphicsMode.Mode.NATIVE)
public class ShippedApp {
    private static final String PACKAGE = "org.cellgauge.android";
    private static final long PATIENCE_MS = 120_000;

    private Activity activity;

    /**
     * Runs it.
     *
     * @param arguments folder for what the app keeps
     */
    public static void main(String[] arguments) {
        System.setProperty("cellgauge.shipped.out", arguments[0]);
        Result result = JUnitCore.runClasses(ShippedApp.class);
        result.getFailures().forEach(failure -> System.out.println(failure.getTrace()));
        System.exit(result.wasSuccessful() && result.getRunCount() == 1 ? 0 : 1);
    }

    /** From the first start to a kept result. */
    @Test
    public void exampleIsCheckedAndKept() throws Exception {
        Class<? extends Activity> main = Class.forName(PACKAGE + ".screen.MainActivity").asSubclass(Activity.class);
        // of one place alone, else it could be any
        System.out.println("classes from " + new HashSet<>(Collections.list(ShippedApp.class.getClassLoader()
                .getResources(main.getName().replace('.', '/') + ".class"))));
        activity = Robolectric.buildActivity(main).setup().get();
        click(button(activity.getWindow().getDecorView(), string("try_example")));
        String pass = string("head_pass");
        until("verdict", () -> pass.contentEquals(this.<TextView>find("banner_headline").getText()));
        click(find("save"));
        File results = new File(RuntimeEnvironment.getApplication().getFilesDir(), "results");
        until("kept files", () -> kept(results) != null && kept(results).listFiles().length >= 4);
        Path out = Paths.get(System.getProperty("cellgauge.shipped.out"));
        for (File file : kept(results).listFiles()) {
            Files.copy(file.toPath(), out.resolve(file.getName()));
        }
        System.out.println("verdict " + this.<TextView>find("banner_headline").getText());
    }

    /** The whole result: while the app writes one, its folder has a name that begins with a dot. */
    private static File kept(File results) {
        File[] folders = results.listFiles(file -> file.isDirectory() && !file.getName().startsWith("."));
        return folders == null || folders.length == 0 ? null : folders[0];
    }

    private static String string(String name) {
        int id = RuntimeEnvironment.getApplication().getResources().getIdentifier(name, "string", PACKAGE);
        return RuntimeEnvironment.getApplication().getString(id);
    }

    private <T extends View> T find(String name) {
        T view = activity.findViewById(activity.getResources().getIdentifier(name, "id", PACKAGE));
        assertNotNull(name, view);
        return view;
    }

    private static View button(View in, String text) {
        if (in.isClickable() && in instanceof TextView && text.contentEquals(((TextView) in).getText())) {
            return in;
        }
        if (in instanceof ViewGroup) {
            for (int i = 0; i < ((ViewGroup) in).getChildCount(); i++) {
                View found = button(((ViewGroup) in).getChildAt(i), text);
                if (found != null) {
                    return found;
                }
            }
        }
        return null;
    }

    private static void click(View view) {
        assertNotNull("a button to tap", view);
        assertEquals(View.VISIBLE, view.getVisibility());
        view.performClick();
    }

    private void until(String what, BooleanSupplier holds) throws IOException, InterruptedException {
        long end = System.nanoTime() + PATIENCE_MS * 1_000_000;
        while (true) {
            shadowOf(Looper.getMainLooper()).idle();
            if (holds.getAsBoolean()) {
                return;
            }
            if (System.nanoTime() > end) {
                throw new IOException("no " + what + "; the banner says "
                        + this.<TextView>find("banner_headline").getText() + ", "
                        + this.<TextView>find("banner_next").getText());
            }
            Thread.sleep(20);
        }
    }
}
