package org.cellgauge;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

/** What users of the library compile against changes only on purpose. */
class ApiTest {
    private static final Path FILE = Path.of(System.getProperty("cellgauge.root", "."), "core/api/cellgauge-core.api");

    @Test
    void typesForUsersAreAsTheFileOfTheApiHasThem() throws Exception {
        List<String> written = Files.readAllLines(FILE, StandardCharsets.UTF_8);
        List<String> now = ApiListing.text(types()).lines().toList();
        assertEquals("", difference(written, now),
                "the API has changed; if that is meant: ./build :core:api, and commit core/api/cellgauge-core.api");
    }

    /** Who writes a program against the library never has to name an internal type. */
    @Test
    void typesForUsersMentionNoInternalOnes() throws Exception {
        List<String> listing = ApiListing.text(types()).lines().toList();
        List<String> mentioned = listing.subList(listing.indexOf("mentioned above") + 1, listing.size());
        assertTrue(mentioned.stream().anyMatch(type -> type.contains("rxjava3")), "streams are mentioned");
        assertEquals(List.of(), mentioned.stream().filter(type -> type.contains("internal.")).toList());
    }

    private static List<Class<?>> types() throws Exception {
        return ApiListing.typesForUsers(Path.of(System.getProperty("cellgauge.api")));
    }

    /** Lines that only one of both has, under the type that they belong to. */
    private static String difference(List<String> before, List<String> after) {
        List<String> lines = new ArrayList<>();
        addMissing("- ", before, after, lines);
        addMissing("+ ", after, before, lines);
        return String.join("\n", lines);
    }

    private static void addMissing(String sign, List<String> of, List<String> in, List<String> lines) {
        List<String> known = withTypes(in);
        withTypes(of).stream().filter(line -> !known.contains(line)).forEach(line -> lines.add(sign + line));
    }

    private static List<String> withTypes(List<String> listing) {
        List<String> lines = new ArrayList<>();
        String type = "";
        for (String line : listing) {
            type = line.startsWith(" ") ? type : line;
            lines.add(line.startsWith(" ") ? type + ": " + line.trim() : line);
        }
        return lines;
    }

    @Test
    void differenceNamesTheTypeWithTheMember() {
        assertEquals("- class A: int b()\n+ class A: long b()",
                difference(List.of("class A", "    int b()", "class B", "    long b()"),
                        List.of("class A", "    long b()", "class B", "    long b()")));
    }
}
