package org.cellgauge.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.google.gson.JsonObject;
import com.google.gson.JsonParser;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.cellgauge.cell.Cell;
import org.cellgauge.cell.CellReader;
import org.cellgauge.desktop.render.Sensor;
import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.internal.validation.CellTruth;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** {@code validate} with {@code --photos} and {@code --random-layouts}. */
class ValidatePhotosTest {
    @TempDir
    private Path folder;
    private Path cell;

    @BeforeEach
    void writeCell() throws IOException {
        cell = SmallCell.write(folder);
    }

    private CommandCall validate(String... args) {
        List<String> all = new ArrayList<>(List.of("validate", "--cell", cell.toString(), "--iterations", "500",
                "--object", "5=290,150,0", "--object", "20=110,150,0"));
        all.addAll(List.of(args));
        return CommandCall.of(all.toArray(new String[0]));
    }

    private static JsonObject json(CommandCall call) {
        return JsonParser.parseString(call.out()).getAsJsonObject();
    }

    /** In linear photos edges are where they belong; 0.01 px is the detector's promise at this size and noise. */
    @Test
    void cornersOfLinearPhotosAreWhereTheyWereRendered() {
        JsonObject result = json(validate("--photos", "--tone-curve", "linear", "--simulations", "4", "--noise", "1",
                "--json"));
        JsonObject corners = result.getAsJsonObject("corners");
        assertEquals(24, corners.get("markers").getAsInt(), result.toString());
        assertEquals(24, result.get("markers_found").getAsInt());
        assertTrue(result.get("photos_with_alarm").getAsInt() <= result.get("false_alarms").getAsInt()
                + result.get("noise_misfits").getAsInt() + result.get("reference_misfits").getAsInt());
        assertTrue(corners.get("rms_px").getAsDouble() < 0.03, corners.toString());
        assertEquals(0, corners.getAsJsonObject("outward_px").get("mean").getAsDouble(), 0.01);
        JsonObject settings = result.getAsJsonObject("settings");
        assertEquals("linear", settings.get("tone_curve").getAsString());
        assertEquals(0.7, settings.get("blur_px").getAsDouble());
        assertTrue(settings.keySet().containsAll(Set.of("simulations", "spread_mm", "spread_rad", "camera_pose",
                "object_poses", "seed", "kappa", "target_mcse_std_rel", "rotation_prior")), settings.toString());
        assertTrue(settings.get("target_mcse_std_rel").isJsonNull(), "chains of a fixed length aim at no precision");
        String command = result.get("command").getAsString();
        assertEquals("cellgauge validate --cell " + cell + " --simulations 4 --photos --tone-curve linear --noise 1 "
                + "--object 5=290,150,0 --object 20=110,150,0 --iterations 500", command);
        Set<String> regions = new HashSet<>();
        result.getAsJsonArray("regions").forEach(r -> regions.add(r.getAsJsonObject().get("part").getAsString() + " "
                + r.getAsJsonObject().get("name").getAsString()));
        if (!regions.isEmpty()) {
            assertEquals(Set.of("camera position", "camera pose", "object 5 position", "object 5 pose",
                    "object 20 position", "object 20 pose", "object 20 grip"), regions);
        }
    }

    /** Ink that spreads by 0.5 mm, at 600 px / 900 mm, is a third of a pixel: inner edges show 97 % of it. */
    @Test
    void spreadingInkIsTakenOutOfTheCornersThatTheCheckTakes() {
        JsonObject result = json(validate("--photos", "--tone-curve", "linear", "--simulations", "2", "--print-gain",
                "0.5", "--spread", "0,0", "--camera-pose", "200,150,900,180,0,0", "--json"));
        JsonObject outward = result.getAsJsonObject("corners").getAsJsonObject("outward_px");
        assertEquals(0, outward.get("mean").getAsDouble(), 0.03 * 0.5 * 600 / 900);
    }

    @Test
    void tablesTellRegionsReasonsAndCorners() {
        CommandCall call = validate("--photos", "--tone-curve", "linear", "--simulations", "3", "--jpeg", "90");
        assertTrue(call.out().startsWith("3 simulated cells, photos with linear, blur 0.7 px, light times 1, markers "
                + "of "), call.out() + call.err());
        assertTrue(call.out().contains("Corners of 18 markers: rms 0.0"), call.out());
        assertTrue(call.err().contains("[3/3] cells simulated and checked"), call.err());
        call.out().lines().forEach(l -> assertTrue(l.length() <= 120, l.length() + ": " + l));
    }

    /** In light of a hundredth nothing is seen: all are refused, and the reason is counted. */
    @Test
    void photosThatShowNothingAreRefusedAndEndWithFive() {
        CommandCall call = validate("--photos", "--exposure", "dark", "--tone-curve", "linear", "--noise", "60",
                "--simulations", "2");
        assertEquals(5, call.code(), call.out() + call.err());
        assertTrue(call.out().contains("  refused 2: none of the references # is in the photo"), call.out());
        assertTrue(call.out().contains("No check stated a figure"), call.out());
    }

    @Test
    void theSameSeedGivesTheSameFiguresForAnyNumberOfThreads() {
        String[] args = {"--photos", "--simulations", "3", "--json", "--seed", "4", "--threads"};
        CommandCall one = validate(with(args, "1"));
        assertEquals(one.out(), validate(with(args, "3")).out());
        args[5] = "5";
        assertNotEquals(one.out(), validate(with(args, "3")).out());
    }

    private static String[] with(String[] args, String last) {
        List<String> all = new ArrayList<>(List.of(args));
        all.add(last);
        return all.toArray(new String[0]);
    }

    @Test
    void cameraMovesUntilMarkersAreAsWideAsAskedFor() {
        Cell read = CellReader.read(cell);
        CellTruth nominal = new CellTruth(SmallCell.WORLD_FROM_CAMERA, CellTruth.objectPoses(read, Map.of()));
        CellTruth moved = CoverageStudyRun.atSide(read, nominal, 40);
        assertEquals(40, CoverageStudyRun.meanSidePx(read, moved), 1e-3);
        assertEquals(0, moved.worldFromCamera().angleRadTo(nominal.worldFromCamera()), 1e-6);
        // flat markers of 100 mm, seen straight on from 900 mm with 600 px: 66.7 px
        Map<Integer, RigidTransform> flat = Map.of(5, RigidTransform.ofEuler(200, 150, 0, 0, 0, 0), 20,
                RigidTransform.ofEuler(100, 150, 0, 0, 0, 0));
        CellTruth straight = new CellTruth(RigidTransform.ofEuler(200, 150, 900, Math.PI, 0, 0), flat);
        // one of six stands 100 mm nearer
        assertEquals((5 * 60000 / 900.0 + 60000 / 800.0) / 6, CoverageStudyRun.meanSidePx(read, straight), 1e-6);
    }

    @Test
    void gridWritesARowOnceAndGoesOnWhereItStopped() throws IOException {
        Path file = folder.resolve("grid.md");
        String[] args = {"--photos", "--grid", "--only", "linear blur0.7 24px normal", "--simulations", "2", "--out",
            file.toString()};
        CommandCall first = validate(args);
        List<String> lines = Files.readAllLines(file);
        assertEquals(3, lines.size(), lines + first.err());
        assertTrue(lines.get(2).startsWith("| linear | 0.7 | 24 | normal |  | 2 | "), lines.get(2));
        assertEquals(lines, first.out().lines().toList());
        Files.writeString(file, lines.get(0) + "\n" + lines.get(1) + "\n" + lines.get(2).replace("| 2 |", "| 7 |")
                + "\n");
        CommandCall second = validate(args);
        assertTrue(second.err().contains("already in"), second.err());
        assertEquals(Files.readAllLines(file), second.out().lines().toList());
        assertEquals(3, Files.readAllLines(file).size());
    }

    /** A table begun before there were columns for every alarm goes on with the columns it has; others are refused. */
    @Test
    void gridGoesOnWithTheColumnsOfItsFile() throws IOException {
        Path file = folder.resolve("grid.md");
        String[] args = {"--photos", "--grid", "--only", "linear blur0.7 24px normal", "--simulations", "1", "--out",
            file.toString()};
        String head = "| tone curve | blur, px | marker, px | exposure | besides | photos | accused | found |";
        Files.writeString(file, head + "\n" + "|---".repeat(8) + "|\n");
        CommandCall call = validate(args);
        List<String> lines = Files.readAllLines(file);
        assertEquals(head, lines.get(0));
        assertEquals("| linear | 0.7 | 24 | normal |  | 1 | 0 | 100.0 % |", lines.get(2));
        assertEquals(lines, call.out().lines().toList());
        assertTrue(call.err().contains("noise misfit, references misfit"), call.err());
        Files.writeString(file, head.replace("accused", "blamed") + "\n");
        CommandCall other = validate(args);
        assertEquals(2, other.code());
        assertTrue(other.err().contains("is no table of these columns"), other.err());
    }

    /** The same photos as with checks, so the same corners; columns of checks are left out, and files are not mixed. */
    @Test
    void cornersOnlyGivesTheFiguresOfTheCornersWithoutChecks() throws IOException {
        String[] args = {"--photos", "--tone-curve", "linear", "--simulations", "2", "--json"};
        CommandCall alone = validate(with(args, "--corners-only"));
        assertEquals(0, alone.code(), alone.err());
        JsonObject result = json(alone);
        assertEquals(json(validate(args)).getAsJsonObject("corners"), result.getAsJsonObject("corners"));
        assertEquals(12, result.getAsJsonObject("corners").get("markers").getAsInt());
        assertEquals(0, result.getAsJsonArray("regions").size());
        String[] grid = {"--photos", "--grid", "--only", "linear blur0.7 24px normal", "--simulations", "2", "--out",
            folder.resolve("corners.md").toString()};
        List<String> lines = validate(with(grid, "--corners-only")).out().lines().toList();
        assertEquals(lines.get(0).chars().filter(c -> c == '|').count(),
                lines.get(2).chars().filter(c -> c == '|').count(), lines.toString());
        assertTrue(lines.get(2).startsWith("| linear | 0.7 | 24 | normal |  | 2 | 0 | 100.0 % | "), lines.get(2));
        assertEquals(2, validate(grid).code());
    }

    /** Three curves, a sharpened one, four blurs, three sizes, three exposures; names are not given twice. */
    @Test
    void gridHasEveryCombinationOnce() {
        List<PhotoGrid.Row> rows = PhotoGrid.rows(Sensor.USUAL);
        assertEquals(5 * 4 * 3 * 3 + 7, rows.size());
        Set<List<String>> names = new HashSet<>();
        rows.forEach(r -> assertTrue(names.add(r.cells()), r.name()));
        assertEquals(1, rows.stream().filter(r -> r.name().contains("jpeg 85")).count());
        assertEquals(60, rows.stream().filter(r -> r.sensor().exposure() == 1.95).count());
        assertEquals(36, rows.stream().filter(r -> r.sensor().unsharpAmount() > 0).count());
    }

    @Test
    void randomLayoutsNeedNoCell() {
        CommandCall call = CommandCall.of("validate", "--random-layouts", "--simulations", "4", "--iterations", "500",
                "--json");
        JsonObject result = json(call);
        assertEquals(4, result.get("simulations").getAsInt(), call.err());
        assertTrue(result.getAsJsonObject("settings").get("random_layouts").getAsBoolean());
        assertFalse(result.getAsJsonObject("settings").get("photos").getAsBoolean());
        assertEquals(result.get("markers").getAsInt(), result.get("markers_found").getAsInt());
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {
        "--blur-px 1                                    | --blur-px is about photos: give --photos, too",
        "--grid                                         | --grid is about photos: give --photos, too",
        "--corners-only                                 | --corners-only is about photos: give --photos, too",
        "--exact-outlines                               | --exact-outlines is about photos: give --photos, too",
        "--photos --only srgb                           | --only is about the rows of --grid",
        "--photos --out x.md                            | --out is about the rows of --grid",
        "--photos --exposure bright                     | --exposure: 'bright' is not known; write normal, clipped",
        "--photos --tone-curve bright                   | --tone-curve: 'bright' is no tone curve; write srgb, linear",
        "--photos --jpeg 0                              | --jpeg: must be between 1 and 100, not 0",
        "--photos --marker-px -1                        | --marker-px: must be a positive number of px, not -1",
        "--photos --unsharp 1                           | --unsharp: '1' is not AMOUNT,RADIUS_PX, as in 0.6,1.2",
        "--photos --print-gain 9                        | --print-gain: must be below half a cell of every marker",
        "--photos --blur-px -1                          | --blur-px: must be between 0 and 20, not -1",
        "--photos --pixel-std 0.1                       | --pixel-std is the noise of drawn corners",
        "--photos --state-pixel-std some                | --state-pixel-std: write auto or a positive number of px",
        "--photos --grid --blur-px 1                    | --grid goes through --blur-px itself",
        "--photos --grid --only purple                  | --only: no row of the grid has all of these words",
        "--photos --random-layouts                      | --random-layouts makes its own cells and photos: leave out "
                + "--cell",
        "--photos --random-layouts --marker-px 32       | --random-layouts draws the size of markers: leave out",
        "--photos --noise 300                           | --noise: must be between 0 and 255, not 300",
        "--photos --gradient -2                         | --gradient: must be between -1 and 1, not -2",
        "--photos --unsharp 1,0                         | --unsharp: must have an amount between 0 and 10 and a radius",
        "--spread 5                                     | --spread: '5' is not MM,DEG, as in 50,10",
        "--photos --simulations 0                       | --simulations: must be between 1 and 1000000, not 0",
    })
    void optionsThatMakeNoSenseAreUsageErrors(String args, String message) {
        CommandCall call = validate(args.trim().split(" +"));
        assertEquals(2, call.code(), call.out() + call.err());
        assertTrue(call.err().contains(message), call.err());
        assertEquals("", call.out());
    }

    @Test
    void withoutACellThereIsNothingToValidate() {
        CommandCall call = CommandCall.of("validate", "--photos");
        assertEquals(2, call.code());
        assertTrue(call.err().contains("Missing required option: '--cell=CELL'"), call.err());
    }
}
