package org.cellgauge.android.apk;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.File;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Pattern;
import org.codehaus.mojo.animal_sniffer.SignatureBuilder;
import org.codehaus.mojo.animal_sniffer.SignatureChecker;
import org.codehaus.mojo.animal_sniffer.logging.Logger;
import org.junit.jupiter.api.Test;

/**
 * Everything that the app reaches exists on Android 8 (API level 26), libraries included.
 *
 * <p>Looked at are the class files that R8 leaves when it shrinks by the app's rules, after D8 has put its replacements
 * into them for methods that Android 8 lacks (List.of, String.isBlank and the like): what is still missing then is
 * missing on the tablet. They are compared with the signatures of that Android.
 */
class ApiLevelTest {

    /** What is missing and yet no fault: place and reference as reported, and why. */
    private static final Map<String, String> HARMLESS = new LinkedHashMap<>();

    static {
        HARMLESS.put("org\\.ejml\\.(data\\.[DF]MatrixRMaj|simple\\.SimpleBase)"
                        + ": String java\\.io\\.ByteArrayOutputStream\\.toString\\(java\\.nio\\.charset\\.Charset\\)",
                "the text of a matrix, for debugging: in toString(), which nothing here calls");
        HARMLESS.put("org\\.cellgauge\\.android\\.camera\\.(CameraTraits|RequestSettings): "
                        + "android\\.hardware\\.camera2\\.Ca\\w+\\.Key android\\.hardware\\.camera2\\.Ca\\w+\\."
                        + "(LENS_DISTORTION|DISTORTION_CORRECTION_\\w+|"
                        + "SCALER_(AVAILABLE_)?ROTATE_AND_CROP(_MODES)?)",
                "keys of Android 9 and 12: read behind a question for the version");
        HARMLESS.put("org\\.cellgauge\\.android\\.screen\\.SystemBars: .*"
                        + "(android\\.view\\.Window(Insets|InsetsController|Manager\\.LayoutParams)?\\b"
                        + "|android\\.graphics\\.Insets).*",
                "the screen filled to its edges, from Android 11 on: asked for behind a question for the version");
        HARMLESS.put("org\\.cellgauge\\.android\\.screen\\.BackGesture.* .*android\\.window\\.OnBack.*",
                "back as Android 13 has it: asked for behind a question for the version");
        HARMLESS.put("org\\.cellgauge\\.android\\.device\\.ThermalWatch.* android\\.os\\.PowerManager\\..*",
                "warmth as Android 10 tells it: asked for behind a question for the version");
    }

    /** Code against signatures and its own classes, since what it inherits from Android is called by its own names. */
    private static Set<String> missing(File code) throws IOException {
        Messages messages = new Messages();
        ByteArrayOutputStream known = new ByteArrayOutputStream();
        try (InputStream android = Files.newInputStream(Path.of(System.getProperty("cellgauge.api.signature")))) {
            SignatureBuilder builder = new SignatureBuilder(new InputStream[] {android}, known, messages);
            builder.process(code);
            builder.close();
        }
        SignatureChecker checker =
                new SignatureChecker(new ByteArrayInputStream(known.toByteArray()), new HashSet<>(), messages);
        checker.setSourcePath(List.of());
        checker.process(code);
        Set<String> missing = new TreeSet<>();
        for (String error : messages.errors) {
            missing.add(readable(error));
        }
        return missing;
    }

    /** Class and reference of "some.jar:org/some/Type.class:12: Undefined reference: …". */
    private static String readable(String error) {
        String place = error.substring(0, error.indexOf(".class:"));
        return place.replaceFirst("^.*\\.jar:", "").replaceFirst("^.*/(?=org/cellgauge/)", "").replace('/', '.')
                + error.substring(error.indexOf(": ", place.length())).replaceFirst("Undefined reference: ", "");
    }

    @Test
    void whatTheAppReachesExistsOnAndroid8() throws IOException {
        Set<String> faults = missing(new File(System.getProperty("cellgauge.shrunk.jar")));
        for (Map.Entry<String, String> harmless : HARMLESS.entrySet()) {
            Pattern pattern = Pattern.compile(harmless.getKey());
            assertTrue(faults.removeIf(f -> pattern.matcher(f).matches()),
                    "no longer found, so no longer to be excused: " + harmless);
        }
        assertEquals(Set.of(), faults, "is missing on Android 8");
    }

    /** Calls what came with Android 13, once under its own name and once through a class of its own. */
    static final class TooNew extends ByteArrayOutputStream {
        String text() {
            return toString(StandardCharsets.UTF_8);
        }

        static String text(ByteArrayOutputStream bytes) {
            return bytes.toString(StandardCharsets.UTF_8);
        }
    }

    /** A check that finds nothing may be blind. */
    @Test
    void callsThatAndroid8LacksAreFound() throws Exception {
        Path file = Path.of(TooNew.class.getResource("ApiLevelTest$TooNew.class").toURI());
        Set<String> found = missing(file.toFile());
        String own = TooNew.class.getName();
        assertEquals(Set.of(own + ": String java.io.ByteArrayOutputStream.toString(java.nio.charset.Charset)",
                own + ": String " + own.replace('$', '.') + ".toString(java.nio.charset.Charset)"), found);
    }

    private static final class Messages implements Logger {
        private final List<String> errors = new ArrayList<>();

        @Override
        public void error(String message) {
            errors.add(message);
        }

        @Override
        public void error(String message, Throwable t) {
            errors.add(message);
        }

        @Override
        public void warn(String message) {
            errors.add(message);
        }

        @Override
        public void warn(String message, Throwable t) {
            errors.add(message);
        }

        @Override
        public void info(String message) {
            // counts of classes
        }

        @Override
        public void info(String message, Throwable t) {
            // counts of classes
        }

        @Override
        public void debug(String message) {
            // names of files
        }

        @Override
        public void debug(String message, Throwable t) {
            // names of files
        }
    }
}
