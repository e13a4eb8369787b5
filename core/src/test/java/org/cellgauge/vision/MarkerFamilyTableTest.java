package org.cellgauge.vision;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import boofcv.alg.fiducial.square.DetectFiducialSquareBinary;
import boofcv.factory.fiducial.ConfigFiducialBinary;
import boofcv.factory.fiducial.ConfigHammingMarker;
import boofcv.factory.fiducial.HammingDictionary;
import boofcv.factory.filter.binary.FactoryThresholdBinary;
import boofcv.factory.shape.FactoryShapeDetector;
import boofcv.struct.image.GrayU8;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.TreeSet;
import java.util.stream.Collectors;
import org.cellgauge.cell.MarkerFamily;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** The table of families says what the image library holds. */
class MarkerFamilyTableTest {
    @Test
    void everyPredefinedDictionaryIsAFamily() {
        List<String> dictionaries = Arrays.stream(HammingDictionary.values()).filter(d -> d != HammingDictionary.CUSTOM)
                .map(Enum::name).collect(Collectors.toList());
        List<String> families = MarkerFamily.all().stream().filter(f -> !f.isSquareBinary())
                .map(MarkerFamily::dictionaryName).collect(Collectors.toList());
        assertEquals(dictionaries, families);
    }

    @ParameterizedTest
    @EnumSource(value = HammingDictionary.class, mode = EnumSource.Mode.EXCLUDE, names = "CUSTOM")
    void numberOfMarkersAndAmbiguousOnesAreTheDictionarys(HammingDictionary dictionary) {
        MarkerFamily family = MarkerFamily.of(dictionary.name().toLowerCase(Locale.ROOT).replace('_', '-'));
        ConfigHammingMarker config = ConfigHammingMarker.loadDictionary(dictionary);
        assertEquals(config.encoding.size, family.size());
        assertEquals(ambiguous(config), allAmbiguous(family));
    }

    @Test
    void squareBinaryHasAnIdForEveryPatternOfItsGrid() {
        ConfigFiducialBinary config = new ConfigFiducialBinary(1);
        // a 4x4 grid whose 4 corners tell the orientation leaves 12 squares for the number
        int squares = config.gridWidth * config.gridWidth - 4;
        assertEquals(1 << squares, MarkerFamily.SQUARE_BINARY.size());
        DetectFiducialSquareBinary<GrayU8> detector = new DetectFiducialSquareBinary<>(config.gridWidth,
                config.borderWidthFraction, config.minimumBlackBorderFraction,
                FactoryThresholdBinary.globalFixed(100, true, GrayU8.class),
                FactoryShapeDetector.polygon(config.squareDetector, GrayU8.class), GrayU8.class);
        assertEquals(detector.getNumberOfDistinctFiducials(), MarkerFamily.SQUARE_BINARY.size());
    }

    @Test
    void unknownNameIsRefusedWithTheNearest() {
        assertTrue(assertThrows(IllegalArgumentException.class, () -> MarkerFamily.of("apriltag_36h11")).getMessage()
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
