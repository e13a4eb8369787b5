package org.cellgauge.android.screen;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.File;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import javax.xml.parsers.DocumentBuilderFactory;
import org.cellgauge.internal.overlay.StrokeFont;
import org.junit.jupiter.api.Test;
import org.w3c.dom.Element;
import org.w3c.dom.NodeList;

/** Both languages say everything, with the same arguments, and each string is used. */
class StringsTest {
    private static final File MAIN = new File(System.getProperty("cellgauge.root"), "android-app/src/main");
    private static final Pattern ARGUMENT = Pattern.compile("%(?:(\\d+)\\$([sd])|%|(.))");

    /** Texts by name; a plural's by name and quantity. */
    private static Map<String, String> strings(String folder) throws Exception {
        Map<String, String> found = new TreeMap<>();
        Element root = DocumentBuilderFactory.newInstance().newDocumentBuilder()
                .parse(new File(MAIN, "res/" + folder + "/strings.xml")).getDocumentElement();
        NodeList simple = root.getElementsByTagName("string");
        for (int i = 0; i < simple.getLength(); i++) {
            Element e = (Element) simple.item(i);
            found.put(e.getAttribute("name"), e.getTextContent());
        }
        NodeList plurals = root.getElementsByTagName("plurals");
        for (int i = 0; i < plurals.getLength(); i++) {
            Element e = (Element) plurals.item(i);
            NodeList items = e.getElementsByTagName("item");
            for (int k = 0; k < items.getLength(); k++) {
                Element item = (Element) items.item(k);
                found.put(e.getAttribute("name") + "/" + item.getAttribute("quantity"), item.getTextContent());
            }
        }
        return found;
    }

    private static TreeSet<String> arguments(String text) {
        TreeSet<String> found = new TreeSet<>();
        Matcher m = ARGUMENT.matcher(text);
        while (m.find()) {
            if (m.group(1) != null) {
                found.add(m.group(1) + m.group(2));
            }
        }
        return found;
    }

    @Test
    void germanHasEveryStringWithTheSameArguments() throws Exception {
        Map<String, String> english = strings("values");
        Map<String, String> german = strings("values-de");
        assertTrue(english.size() > 150, english.size() + " strings");
        assertEquals(english.keySet(), german.keySet());
        english.forEach((name, text) -> {
            assertEquals(arguments(text), arguments(german.get(name)), name);
            assertFalse(german.get(name).trim().isEmpty(), name);
        });
    }

    @Test
    void patternsAreWellFormed() throws Exception {
        for (String folder : new String[] {"values", "values-de"}) {
            strings(folder).forEach((name, text) -> {
                Matcher m = ARGUMENT.matcher(text);
                // a text without arguments is taken as it is
                while (!arguments(text).isEmpty() && m.find()) {
                    assertTrue(m.group(3) == null, folder + " " + name + ": " + m.group());
                }
            });
        }
    }

    @Test
    void germanIsNoCopyOfEnglish() throws Exception {
        Map<String, String> german = strings("values-de");
        List<String> same = new ArrayList<>();
        strings("values").forEach((name, text) -> {
            // what has no words, or the same ones
            String wordless = "(?:\\W|\\d|\\\\u00A0|%\\d\\$[sd]|[xyzd]|mm|px|CellGauge)*";
            if (text.equals(german.get(name)) && !text.matches(wordless)) {
                same.add(name);
            }
        });
        assertEquals(new ArrayList<>(), same);
    }

    /** Labels, legend, headlines, and whatever a reason is put together from. */
    @Test
    void textsInThePictureHaveLettersThere() throws Exception {
        String painted = "label_.*|legend_.*|head_.*|largest.*|of_.*|source_.*|no_object|no_target|not_seen/.*|"
                + "not_converged|never_moved|non_finite|chains_too_short|two_.*|misplaced.*|undefined|list_.*";
        for (String folder : new String[] {"values", "values-de"}) {
            strings(folder).forEach((name, text) -> {
                if (name.matches(painted)) {
                    for (char c : text.replace("\\u00A0", "\u00A0").toCharArray()) {
                        assertTrue(StrokeFont.has(c), folder + " " + name + ": " + c);
                    }
                }
            });
        }
    }

    @Test
    void everyStringIsUsed() throws Exception {
        StringBuilder all = new StringBuilder();
        read(new File(MAIN, "java"), all);
        read(new File(MAIN, "res/layout"), all);
        read(new File(MAIN, "res/layout-land"), all);
        read(new File(MAIN, "AndroidManifest.xml"), all);
        List<String> unused = new ArrayList<>();
        for (String key : strings("values").keySet()) {
            String name = key.replaceAll("/.*", "");
            if (!Pattern.compile("(?:R\\.(?:string|plurals)\\.|@string/)" + name + "\\b").matcher(all).find()) {
                unused.add(name);
            }
        }
        assertEquals(new ArrayList<>(), unused);
    }

    private static void read(File file, StringBuilder into) throws Exception {
        if (file.isDirectory()) {
            for (File child : file.listFiles()) {
                read(child, into);
            }
        } else {
            into.append(new String(Files.readAllBytes(file.toPath()),
                    StandardCharsets.UTF_8));
        }
    }
}
