package org.cellgauge.vision;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import boofcv.factory.fiducial.ConfigHammingMarker;
import boofcv.factory.fiducial.HammingDictionary;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.TreeSet;
import org.cellgauge.cell.MarkerFamily;
import org.cellgauge.internal.vision.MarkerPattern;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;

/** The table of families says what the image library holds, and its patterns are those of other tools. */
class MarkerFamilyTableTest {
    /**
     * SHA-256 over the patterns of a family, by OpenCV 5.0.0 (AprilTags by the AprilTag library's way up, half a turn
     * from OpenCV's): a line of ones and zeros, white and black, row by row from the top left, for each marker.
     * <pre>
     * d = cv2.aruco.getPredefinedDictionary(cv2.aruco.DICT_4X4_1000); h = hashlib.sha256()
     * for i in range(len(d.bytesList)):
     *     bits = cv2.aruco.Dictionary.getBitsFromByteList(d.bytesList[i:i + 1], d.markerSize)
     *     h.update("".join(map(str, bits.flatten())).encode() + b"\n")   # AprilTags: bits[::-1, ::-1]
     * </pre>
     * The last three, which OpenCV has not, by the code lists of js-aruco2 2.0.0 in the same form.
     */
    @ParameterizedTest
    @CsvSource({
        "DICT_ARUCO_ORIGINAL, d683f3de89701c83811948ec67f8860aa3eab32d3e238912a97eda91fe3854da",
        "DICT_ARUCO_MIP_36h12, 4dba5b6ec149ce60d1a2a4d5d50277861d56b179743bbc18c66d79ecc6651718",
        "DICT_4X4_1000, 215f7b71bc76eca5f0366aaef97a7c7f912dd247d893b0c337d14171b54889f8",
        "DICT_4X4_50, f713bf22a1da081b77c3c32b9a91751bee51a55fb901c2a1cae18990a423bba9",
        "DICT_5X5_1000, dd3e2dd4f89eb5c4d3805553fd12ab97d8bbd262d52a818410ab729b7e56c739",
        "DICT_6X6_1000, 47da5cdb624dc9f3c334655e82c7e16310e588a8ff9ebc9eae044cf6cc3b4cb1",
        "DICT_7X7_1000, b3f1751a59ca1000b308fa965531938532ff61f1d30aafd344c54f1044e1daf7",
        "tag16h5, af67f7e5c323e5ed024897bcadedc92a174047aafdd3d4cee4719d8ad8788d9c",
        "tag25h9, 2889b17f2d47a72b9628279e6a93aeafda642816a78650aa404da78f5fb08548",
        "tag36h10, 6f35bd327f06461f9bcd38ff11d3b800ea0d49bbcc7e9256e60877742112dbb0",
        "tag36h11, 6e9e8dab03e24635bd5764c5973eb544c2cad087a6d095ae77cd5282999d91b1",
        "aruco-mip-16h3, 1f814dfff9961703df64fb3e130fb7917c048990078d0aa453e6eff780bd6d66",
        "aruco-mip-25h7, 21c0d61e10272d6e3fe59c9655b7c9d7c014858466080391bdd5f6d5c70d1be6",
        "tag25h7, 3561f18a34a17e4668111d9baafb505b02c5b311a509788f88d519027fc6ef1d"})
    void patternsAreThoseOfOtherTools(String name, String digest) throws NoSuchAlgorithmException {
        MarkerFamily family = MarkerFamily.of(name);
        MessageDigest sha = MessageDigest.getInstance("SHA-256");
        FamilyPatterns patterns = new FamilyPatterns(family);
        int bands = patterns.grid().bands();
        for (int id = 0; id < family.size(); id++) {
            boolean[] white = patterns.white(id);
            for (int row = 1; row < bands - 1; row++) {
                for (int column = 1; column < bands - 1; column++) {
                    sha.update((byte) (white[row * bands + column] ? '1' : '0'));
                }
            }
            sha.update((byte) '\n');
        }
        StringBuilder hex = new StringBuilder();
        for (byte b : sha.digest()) {
            hex.append(String.format(Locale.ROOT, "%02x", b));
        }
        assertEquals(digest, hex.toString());
    }

    @ParameterizedTest
    @EnumSource(value = HammingDictionary.class, mode = EnumSource.Mode.EXCLUDE, names = "CUSTOM")
    void numberOfMarkersAndAmbiguousOnesAreTheDictionarys(HammingDictionary dictionary) {
        MarkerFamily family = MarkerFamily.of(dictionary.name());
        ConfigHammingMarker config = new FamilyPatterns(family).dictionary();
        assertEquals(dictionary.name(), family.dictionaryName());
        assertEquals(config.gridWidth, family.codeCells());
        assertEquals(ConfigHammingMarker.loadDictionary(dictionary).encoding.size, family.size());
        assertEquals(ambiguous(config), allAmbiguous(family));
    }

    /** The distances that OpenCV's documentation states as twice the correctable bits and one or two. */
    @ParameterizedTest
    @CsvSource({"50, 4", "100, 3", "250, 3", "1000, 2"})
    void smallDictionariesOfFourCellsAreToldApartAsFarAsTheyDiffer(int size, int distance) {
        ConfigHammingMarker config = new FamilyPatterns(MarkerFamily.of("DICT_4X4_" + size)).dictionary();
        assertEquals(size, config.encoding.size);
        assertEquals(distance, config.minimumHamming);
    }

    @ParameterizedTest
    @CsvSource({"DICT_4X4_50, aruco-ocv-4x4-50, 50", "dict_7x7_1000, aruco-ocv-7x7-1000, 1000",
        "aruco 5x5 100, aruco-ocv-5x5-100, 100", "tag36h11, apriltag-36h11, 587", "AprilTag 36h11, apriltag-36h11, 587",
        "DICT_APRILTAG_25h9, apriltag-25h9, 35", "DICT_APRILTAG_16H5, apriltag-16h5, 30",
        "DICT_ARUCO_MIP_36h12, aruco-mip-36h12, 250", "DICT_ARUCO_ORIGINAL, aruco-original, 1024",
        "square-binary-4x4, square-binary, 4096", "Square_Binary_3x3, square-binary-3x3, 32",
        "square-binary-5x5, square-binary-5x5, 2097152"})
    void familiesHaveTheNamesThatTheirToolsGiveThem(String name, String canonical, int size) {
        MarkerFamily family = MarkerFamily.of(name);
        assertEquals(canonical, family.familyName());
        assertEquals(size, family.size());
        assertEquals(family, MarkerFamily.of(family.familyName()));
    }

    /**
     * The pattern as BoofCV's documentation of its detector describes it: of the corners only the lower left is black,
     * the other cells are the number's bits, the lowest first, from the lower left along the rows upwards; 1 is black.
     */
    @ParameterizedTest
    @ValueSource(ints = {3, 4, 5, 6, 7, 8})
    void squareBinaryWritesItsNumberFromTheLowerLeft(int n) {
        MarkerFamily family = MarkerFamily.of("square-binary-" + n + "x" + n);
        assertEquals((long) Math.min(Integer.MAX_VALUE, Math.pow(2, n * n - 4)), family.size());
        int id = 0x2b5a_c6d3 % family.size();
        MarkerPattern pattern = MarkerPattern.of(family, id);
        int cell = n % 2 == 0 ? 1 : 2;
        assertEquals(2 * n * cell, pattern.cells());
        int border = n * cell / 2;
        int bit = 0;
        for (int row = n - 1; row >= 0; row--) {
            for (int column = 0; column < n; column++) {
                boolean corner = row % (n - 1) == 0 && column % (n - 1) == 0;
                boolean black = corner ? row == n - 1 && column == 0 : bit < 31 && (id >> bit & 1) == 1;
                bit += corner ? 0 : 1;
                for (int k = 0; k < cell * cell; k++) {
                    assertEquals(!black, pattern.isWhite(border + row * cell + k / cell,
                            border + column * cell + k % cell), row + " " + column);
                }
            }
        }
        for (int k = 0; k < pattern.cells(); k++) {
            assertFalse(pattern.isWhite(border - 1, k) || pattern.isWhite(k, border - 1)
                    || pattern.isWhite(pattern.cells() - border, k) || pattern.isWhite(k, pattern.cells() - border));
        }
    }

    @Test
    void unknownNameIsRefusedWithTheNearest() {
        assertTrue(assertThrows(IllegalArgumentException.class, () -> MarkerFamily.of("apriltag-36h11a")).getMessage()
                .contains("did you mean \"apriltag-36h11\"?"));
    }

    private static TreeSet<Integer> allAmbiguous(MarkerFamily family) {
        TreeSet<Integer> ids = new TreeSet<>();
        for (int id = 0; id < family.size(); id++) {
            if (family.isAmbiguous(id)) {
                ids.add(id);
            }
        }
        return ids;
    }

    /** Ids whose pattern is that of another id up to quarter turns, or that of itself turned. */
    private static TreeSet<Integer> ambiguous(ConfigHammingMarker config) {
        int width = config.gridWidth;
        TreeSet<Integer> ids = new TreeSet<>();
        Map<String, Integer> first = new HashMap<>();
        for (int id = 0; id < config.encoding.size; id++) {
            List<String> turned = new ArrayList<>();
            int[] bits = new int[width * width];
            for (int i = 0; i < bits.length; i++) {
                bits[i] = config.encoding.get(id).pattern.get(i);
            }
            for (int turn = 0; turn < 4; turn++) {
                turned.add(Arrays.toString(bits));
                int[] next = new int[bits.length];
                for (int row = 0; row < width; row++) {
                    for (int column = 0; column < width; column++) {
                        next[column * width + width - 1 - row] = bits[row * width + column];
                    }
                }
                bits = next;
            }
            Integer earlier = first.putIfAbsent(Collections.min(turned), id);
            if (earlier != null) {
                ids.add(earlier);
                ids.add(id);
            }
            if (new TreeSet<>(turned).size() < 4) {
                ids.add(id);
            }
        }
        return ids;
    }
}
