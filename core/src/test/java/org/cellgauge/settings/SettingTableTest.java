package org.cellgauge.settings;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.google.gson.GsonBuilder;
import com.google.gson.JsonObject;
import com.google.gson.JsonParser;
import java.lang.reflect.Field;
import java.lang.reflect.Method;
import java.lang.reflect.Modifier;
import java.math.BigDecimal;
import java.util.Arrays;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;
import org.cellgauge.internal.settings.SettingsJson;
import org.cellgauge.internal.warning.Listing;
import org.cellgauge.warning.Refusal;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;

class SettingTableTest {
    private static final CheckSettings USUAL = CheckSettings.builder().build();

    static List<Setting<?>> rows() {
        return SettingTable.all();
    }

    /** A value other than the default, as a user would write it. */
    private static String other(Setting<?> row) {
        String usual = row.text(USUAL);
        String words = row.form().isFlag() ? "true|false" : row.form().placeholder();
        for (String word : words.split("\\|")) {
            if (word.equals(word.toLowerCase()) && !word.equals(usual)) {
                return word;
            }
        }
        return usual.isEmpty() ? "40"
                : new BigDecimal(usual).multiply(BigDecimal.valueOf(2)).stripTrailingZeros().toPlainString();
    }

    /** Settings of which one differs from its default, with what it needs to mean anything. */
    private static CheckSettings changed(Setting<?> row) {
        CheckSettings.Builder builder = CheckSettings.builder();
        if (!row.appliesTo(USUAL)) {
            builder.estimate(Estimate.INTRINSICS);
        }
        row.read(other(row), builder);
        return builder.build();
    }

    private static JsonObject written(CheckSettings settings) {
        return JsonParser.parseString(new GsonBuilder().serializeNulls().create().toJson(SettingsJson.plain(settings)))
                .getAsJsonObject();
    }

    @Test
    void everySettingThatHasAConstantStandsInTheTable() throws ReflectiveOperationException {
        Set<Object> constants = new HashSet<>();
        for (Field field : SettingTable.class.getDeclaredFields()) {
            if (field.getType() == Setting.class && Modifier.isPublic(field.getModifiers())) {
                constants.add(field.get(null));
            }
        }
        assertEquals(constants, new HashSet<>(SettingTable.all()));
        assertEquals(constants.size(), SettingTable.all().size(), "each once");
        assertTrue(constants.size() > 10, "they were found at all");
    }

    /** Values are kept by row alone: a field beside them would be written nowhere. */
    @Test
    void settingsHoldNothingBesideTheValuesOfRows() {
        for (Class<?> type : List.of(CheckSettings.class, ModelSettings.class, SamplingSettings.class,
                CheckSettings.Builder.class)) {
            Set<String> kept = Arrays.stream(type.getDeclaredFields())
                    .filter(field -> !Modifier.isStatic(field.getModifiers())).map(Field::getName)
                    .collect(Collectors.toSet());
            kept.removeAll(Set.of("values", "model", "sampling"));
            assertEquals(Set.of(), kept, type.getSimpleName());
        }
    }

    /** Each named method of the builder sets a row, and each half tells of its own rows alone. */
    @Test
    void everyMethodOfTheBuilderSetsARow() throws ReflectiveOperationException {
        for (Method method : CheckSettings.Builder.class.getDeclaredMethods()) {
            if (!Modifier.isPublic(method.getModifiers()) || method.getParameterCount() != 1
                    || method.getReturnType() != CheckSettings.Builder.class) {
                continue;
            }
            Class<?> type = method.getParameterTypes()[0];
            Object value = type == int.class ? (Object) 4000 : type == long.class ? (Object) 4000L
                    : type == double.class ? (Object) 0.25 : type == boolean.class ? (Object) false
                            : type.getEnumConstants()[type == InitialEstimate.class ? 0 : 1];
            CheckSettings.Builder builder = CheckSettings.builder();
            method.invoke(builder, value);
            CheckSettings settings = method.getName().equals("chains") ? CheckSettings.builder().chains(7).build()
                    : builder.build();
            assertNotEquals(USUAL, settings, method.getName());
        }
        assertThrows(IllegalArgumentException.class, () -> USUAL.model().get(SettingTable.SEED));
        assertThrows(IllegalArgumentException.class, () -> USUAL.sampling().get(SettingTable.KAPPA));
        assertEquals(0.5, USUAL.model().get(SettingTable.KAPPA));
    }

    @Test
    void namesAndKeysTellRowsApart() {
        assertEquals(rows().size(), rows().stream().map(Setting::name).distinct().count());
        assertEquals(rows().size(), rows().stream().map(Setting::key).distinct().count());
        for (Setting<?> row : rows()) {
            assertTrue(row.key().matches("[a-z]+(_[a-z]+)*"), row.key());
            assertTrue(row.name().matches("[a-z]+(-[a-z]+)*"), row.name());
            assertTrue(row.unit().isEmpty() || row.key().endsWith("_" + row.unit()), row.key());
            assertTrue(row.description().matches("[A-Z].*[^.]"), row.description());
            assertFalse(row.description().contains("--"), "no option of a command line: " + row.description());
        }
    }

    @ParameterizedTest
    @MethodSource("rows")
    void whatIsWrittenIsReadBack(Setting<?> row) {
        CheckSettings settings = changed(row);
        assertNotEquals(USUAL, settings);
        assertEquals(other(row), row.text(settings));
        assertEquals(row.determinesFigures(), row.isTold(settings), row.name());
        CheckSettings read = SettingsJson.read(written(settings));
        assertEquals(row.determinesFigures() ? settings : USUAL, read);
        assertEquals(SettingsJson.plain(settings), SettingsJson.plain(read));
    }

    @Test
    void settingsOfTheThesisAreReadBack() {
        CheckSettings thesis = CheckSettings.thesis().estimate(Estimate.FOCAL).build();
        assertEquals(thesis, SettingsJson.read(written(thesis)));
        assertEquals(thesis.hashCode(), SettingsJson.read(written(thesis)).hashCode());
        // two focal lengths that are known: how they would hang together means nothing, and is not written
        CheckSettings known = CheckSettings.thesis().build();
        assertTrue(written(known).get("aspect_prior_std").isJsonNull());
        assertEquals(SettingsJson.plain(known), SettingsJson.plain(SettingsJson.read(written(known))));
    }

    @Test
    void whatAFileDoesNotNameIsTheDefault() {
        assertEquals(USUAL, SettingsJson.read(new JsonObject()));
        assertEquals(USUAL, SettingsJson.read(
                JsonParser.parseString("{\"sampler_used\": \"adaptive\", \"references\": {}}").getAsJsonObject()));
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {
        "{\"kappa\": -1}                  | kappa: must be positive, not -1",
        "{\"kappa\": \"much\"}            | kappa: 'much' is no number",
        "{\"chains\": 2.5}                | chains: '2.5' is no whole number",
        "{\"sampler\": \"gibbs\"}         | sampler: 'gibbs' is not known; write independence, adaptive or thesis",
        "{\"pose_prior_allowed\": 1}      | pose_prior_allowed: '1' is not known; write true or false",
        "{\"model\": [1]}                 | model: must be a single value",
        "{\"iterations\": 20, \"warmup\": 13} | warmup: must be at least 0 and leave at least 8 of the 20 iterations"})
    void aFaultyFileIsRefused(String json, String message) {
        JsonObject object = JsonParser.parseString(json).getAsJsonObject();
        String said = assertThrows(IllegalArgumentException.class, () -> SettingsJson.read(object)).getMessage();
        assertTrue(said.startsWith(message), said);
    }

    /** Each range at its ends, by the table of the command line's help. */
    @Test
    void valuesOutOfRangeAreRefused() {
        refused("kappa: must be positive, not 0", CheckSettings.builder().kappa(0));
        refused("kappa: must be positive, not Infinity", CheckSettings.builder().kappa(Double.POSITIVE_INFINITY));
        refused("chains: must be between 1 and 1000, not 1001", CheckSettings.builder().chains(1001));
        refused("iterations: must be at least 8, not 7", CheckSettings.builder().iterations(7));
        refused("max_iterations: must be at least 8, not 7", CheckSettings.builder().maxIterations(7));
        refused("target_mcse_std_rel: must be a share between 0 and 1, such as 0.02 for 2 %, not 1",
                CheckSettings.builder().targetMcseStdRel(1));
        refused("focal_prior_std_px: must be a positive number of px, not NaN",
                CheckSettings.builder().focalPriorStdPx(Double.NaN));
        refused("aspect_prior_std: must be a share above 0, such as 0.005 for half a per cent, not 0",
                CheckSettings.builder().aspectPriorStd(0));
        refused("target_std_mm: must be a positive number of mm, not -1", CheckSettings.builder().targetStdMm(-1));
        refused("threads: must be at least 1, not 0", CheckSettings.builder().threads(0));
        refused("warmup: must be at least 0", CheckSettings.builder().warmup(-1));
        refused("warmup: must be at least 0", CheckSettings.builder().iterations(20).warmup(13));
        assertEquals(12, CheckSettings.builder().iterations(20).warmup(12).build().sampling().warmup());
        assertNull(SettingTable.CHAINS.refusal(1000));
    }

    private static void refused(String message, CheckSettings.Builder builder) {
        String said = assertThrows(SettingRefusedException.class, builder::build).getMessage();
        assertTrue(said.startsWith(message), said);
    }

    /** Kind and arguments, of which any language makes its words. */
    @Test
    void aRefusalIsData() {
        SettingRefusedException tooMany = assertThrows(SettingRefusedException.class,
                () -> SettingTable.CHAINS.read("1001"));
        assertEquals(SettingTable.CHAINS, tooMany.setting());
        assertEquals(Refusal.of(SettingRefusal.NOT_BETWEEN, 1, 1000, "1001"), tooMany.refusal());
        SettingRefusedException unknown = assertThrows(SettingRefusedException.class,
                () -> SettingTable.MODEL.read("cube"));
        assertEquals(Refusal.of(SettingRefusal.NOT_KNOWN, "cube", Listing.or(List.of("rigid-marker", "corner-cube"))),
                unknown.refusal());
        SettingRefusedException together = assertThrows(SettingRefusedException.class,
                () -> CheckSettings.builder().iterations(20).warmup(13).build());
        assertEquals(SettingTable.WARMUP, together.setting());
        assertEquals(Refusal.of(SettingRefusal.TOO_FEW_LEFT, 8, 20, 13), together.refusal());
    }
}
