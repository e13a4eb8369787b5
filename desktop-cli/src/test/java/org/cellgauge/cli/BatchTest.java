package org.cellgauge.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.google.gson.JsonParser;
import java.io.BufferedReader;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.concurrent.TimeUnit;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.cellgauge.desktop.BatchCheck;
import org.cellgauge.desktop.BatchListener;
import org.cellgauge.desktop.BatchOutcome;
import org.cellgauge.desktop.CellFile;
import org.cellgauge.desktop.CheckInput;
import org.cellgauge.desktop.ResultFolder;
import org.cellgauge.desktop.StopSignal;
import org.cellgauge.settings.CheckSettings;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Many inputs: what is kept of earlier runs, what is left of runs that end early, and who may write where. */
class BatchTest {
    @TempDir
    private Path folder;
    private Path cell;
    private Path out;

    @BeforeEach
    void writeCell() throws IOException {
        cell = SmallCell.write(folder);
        out = folder.resolve("out");
    }

    /** Short chains, whose figures are not to be trusted: what matters here is what becomes of them. */
    private CommandCall check(Object... args) {
        List<String> all = new ArrayList<>(List.of("check", "--cell", cell.toString(), "--iterations", "60", "--warmup",
                "20", "--chains", "2", "--out", out.toString()));
        for (Object arg : args) {
            all.add(arg.toString());
        }
        return CommandCall.of(all.toArray(new String[0]));
    }

    private List<Path> corners(int count) throws IOException {
        List<Path> files = new ArrayList<>();
        for (int i = 1; i <= count; i++) {
            files.add(SmallCell.writeDetections(folder.resolve("d" + i + ".json"), i));
        }
        return files;
    }

    private static Object[] detections(List<Path> files, Object... more) {
        List<Object> args = new ArrayList<>(List.of(more));
        args.add("--detections");
        args.addAll(files);
        return args.toArray();
    }

    private static Map<String, String> contents(Path folder) throws IOException {
        Map<String, String> contents = new TreeMap<>();
        try (Stream<Path> files = Files.list(folder)) {
            for (Path file : files.toList()) {
                contents.put(file.getFileName().toString(),
                        new String(Files.readAllBytes(file), StandardCharsets.ISO_8859_1));
            }
        }
        return contents;
    }

    private static List<String> kept(CommandCall call) {
        return call.err().lines().filter(line -> line.endsWith("(kept)")).map(line -> line.replaceAll(".*\\] |:.*", ""))
                .toList();
    }

    private static String verdict(Path result) throws IOException {
        return JsonParser.parseString(Files.readString(result)).getAsJsonObject().get("verdict").getAsString();
    }

    // ---- what is kept

    @Test
    void aSecondRunDoesOnlyWhatIsMissingOrChanged() throws IOException {
        List<Path> files = corners(3);
        CommandCall first = check(detections(files));
        assertEquals(List.of(), kept(first));
        Map<String, String> before = contents(out);
        CommandCall second = check(detections(files));
        assertEquals(List.of("d1", "d2", "d3"), kept(second));
        assertTrue(second.err().contains("3 kept from an earlier run; --again"), second.err());
        assertEquals(first.code(), second.code());
        assertEquals(first.out().lines().limit(4).toList(), second.out().lines().limit(4).toList());
        Map<String, String> after = contents(out);
        // pictures of the report are taken from the stored ones, which JPEG shows
        String picture = "data:image/jpeg;base64,[^\"]*";
        assertEquals(before.put("report.html", "").replaceAll(picture, ""), after.put("report.html", "")
                .replaceAll(picture, "").replace(" (3 kept from an earlier run)", ""));
        assertEquals(before, after);
        // another photo under the same name, and a picture that is gone
        SmallCell.writeDetections(files.get(1), 9);
        Files.delete(out.resolve("d3.overlay.png"));
        assertEquals(List.of("d1"), kept(check(detections(files))));
        assertTrue(Files.exists(out.resolve("d3.overlay.png")));
        assertNotEquals(before.get("d2.result.json"), contents(out).get("d2.result.json"));
        assertEquals(List.of(), kept(check(detections(files, "--again"))));
        List<Path> two = files.subList(0, 2);
        assertEquals(List.of(), kept(check(detections(two, "--seed", 2))));
        Files.writeString(cell, SmallCell.YAML.replace("[0, 300, 100]", "[0, 300, 101]"));
        assertEquals(List.of(), kept(check(detections(two, "--seed", 2))));
        Files.writeString(out.resolve("d1.result.json"), "{");
        assertEquals(List.of("d2"), kept(check(detections(two, "--seed", 2))));
    }

    /** How well a camera is known stands in its file alone. */
    @Test
    void nothingIsKeptOfAnotherCalibration() throws IOException {
        List<Path> files = corners(2);
        Path camera = folder.resolve("camera.yaml");
        String exact = Files.readString(camera);
        String calibrated = exact + "cellgauge_calibration: {parameters: [fx], covariance: [[%s]], photos: 20}\n";
        check(detections(files));
        Files.writeString(camera, String.format(calibrated, "4"));
        assertEquals(List.of(), kept(check(detections(files))));
        assertEquals(List.of("d1", "d2"), kept(check(detections(files))));
        Files.writeString(camera, String.format(calibrated, "9"));
        assertEquals(List.of(), kept(check(detections(files))));
        Files.writeString(camera, exact);
        assertEquals(List.of(), kept(check(detections(files))));
    }

    @Test
    void whatIsKeptIsHeldAgainstTheTargetOfNow() throws IOException {
        Path corners = SmallCell.writeDetections(folder.resolve("a.json"), 1);
        String[] args = {"check", "--cell", cell.toString(), "--out", out.toString(), "--detections",
            corners.toString(), "--target"};
        assertEquals(0, CommandCall.of(Stream.concat(Stream.of(args), Stream.of("5")).toArray(String[]::new)).code());
        CommandCall call = CommandCall.of(Stream.concat(Stream.of(args), Stream.of("0.1")).toArray(String[]::new));
        assertEquals(4, call.code(), call.err());
        assertTrue(call.err().startsWith("1 kept"), call.err());
        assertEquals("fail", verdict(out.resolve("a.result.json")));
        assertTrue(Files.readString(out.resolve("summary.csv")).contains(",fail,"));
    }

    // ---- several at once

    @Test
    void theOrderIsThatOfTheInputsAndTheBytesThoseOfOneThread() throws IOException {
        List<Path> files = new ArrayList<>(corners(5));
        files.add(2, Files.writeString(folder.resolve("broken.json"), "{"));
        CommandCall alone = check(detections(files, "--threads", 1, "--json"));
        Path other = folder.resolve("other");
        Map<String, String> one = contents(out);
        Files.move(out, other);
        CommandCall several = check(detections(files, "--threads", 3, "--json"));
        assertTrue(alone.out().equals(several.out()), "lines of JSON");
        assertEquals(files.stream().map(f -> f.getFileName().toString()).toList(), several.out().lines()
                .map(line -> JsonParser.parseString(line).getAsJsonObject().getAsJsonObject("input").get("name")
                        .getAsString()).toList());
        assertEquals(one, contents(out));
    }

    // ---- the report

    @Test
    void aLongReportHasPagesAndAShorterOneLeavesNoneOfThem() throws IOException {
        List<Path> files = new ArrayList<>();
        for (int i = 1; i <= 103; i++) {
            files.add(Files.writeString(folder.resolve("d" + i + ".json"), "{"));
        }
        check(detections(files));
        assertEquals(List.of("report-001.html", "report-002.html", "report.html", "summary.csv"),
                List.copyOf(contents(out).keySet()));
        String main = Files.readString(out.resolve("report.html"));
        assertTrue(main.contains("<a href=\"report-002.html\">photos 101 to 103</a></td><td class=\"text\">3 refused"),
                main);
        assertTrue(main.contains("<a href=\"report-001.html#photo-7\">d7</a>") && main.contains("73 more"));
        assertTrue(main.contains("Signature") && main.contains("References as stated"));
        String page = Files.readString(out.resolve("report-002.html"));
        assertTrue(page.contains("<section id=\"photo-103\">") && page.contains("href=\"report-001.html\">"));
        assertFalse(page.contains("the next page"));
        assertEquals(104, Files.readAllLines(out.resolve("summary.csv")).size());
        check(detections(files.subList(0, 2)));
        assertEquals(List.of("report.html", "summary.csv"), List.copyOf(contents(out).keySet()));
    }

    // ---- runs that end early

    private BatchCheck.Builder batch(BatchListener listener) {
        return BatchCheck.of(CellFile.read(cell)).folder(ResultFolder.into(out)).listener(listener)
                .settings(CheckSettings.builder().iterations(60).warmup(20).chains(2).threads(1).build());
    }

    @Test
    void whatIsDoneIsLeftWhereARunIsStopped() throws IOException {
        StopSignal stop = new StopSignal();
        CheckInput.Inputs inputs = CheckInput.resolve(List.of(), corners(4));
        BatchOutcome outcome = batch(done -> {
            if (done.number() == 2) {
                stop.stop();
            }
        }).stop(stop).build().run(inputs);
        assertEquals("2 of 4 photos: 2 NOT CONVERGED", outcome.total());
        assertEquals(out, outcome.reportFolder().get());
        assertEquals(List.of("d1.overlay.png", "d1.result.json", "d2.overlay.png", "d2.result.json", "report.html",
                "summary.csv"), List.copyOf(contents(out).keySet()));
        assertTrue(Files.readString(out.resolve("report.html")).contains("2 of 4 photos"));
        assertTrue(Files.readString(out.resolve("report.html")).endsWith("</html>\n"));
        assertEquals(1 + 2 * 2, Files.readAllLines(out.resolve("summary.csv")).size());
    }

    @Test
    void aFolderThatIsRemovedEndsTheRunWithItsReport() throws IOException {
        CheckInput.Inputs inputs = CheckInput.resolve(List.of(), corners(4));
        BatchOutcome outcome = batch(done -> {
            if (done.number() == 2) {
                try (Stream<Path> files = Files.walk(out)) {
                    files.sorted(Comparator.reverseOrder()).forEach(file -> file.toFile().delete());
                } catch (IOException e) {
                    throw new IllegalStateException(e);
                }
            }
        }).build().run(inputs);
        assertTrue(outcome.unwritable().get().refusal().toString().contains("is gone"),
                outcome.unwritable().get().refusal().toString());
        assertEquals(2, outcome.done());
        assertEquals(List.of("report.html", "summary.csv"), List.copyOf(contents(out).keySet()));
        assertTrue(Files.readString(out.resolve("report.html")).contains("<section id=\"photo-2\">"));
        assertEquals(1 + 2 * 2, Files.readAllLines(out.resolve("summary.csv")).size());
    }

    /** A process of its own, since a signal ends all of it; while it goes on, nobody else may write to its folder. */
    @Test
    void aSignalEndsARunWithItsReportAndMeanwhileTheFolderIsItsOwn() throws Exception {
        List<String> command = new ArrayList<>(List.of(Path.of(System.getProperty("java.home"), "bin", "java")
                .toString(), "-XX:TieredStopAtLevel=1", "-XX:+UseSerialGC", "-Djava.awt.headless=true", "-cp",
                System.getProperty("java.class.path"), Main.class.getName(), "check", "--cell", cell.toString(),
                "--out", out.toString(), "--threads", "1", "--detections"));
        corners(30).forEach(file -> command.add(file.toString()));
        Process run = new ProcessBuilder(command).redirectOutput(folder.resolve("stdout").toFile()).start();
        try (BufferedReader err = run.errorReader()) {
            assertTrue(err.readLine().startsWith("[1/30] d1: "));
            CommandCall second = check(detections(corners(1)));
            assertEquals(3, second.code());
            assertTrue(second.err().contains("another run writes its results here (process " + run.pid())
                    && second.err().contains("--out"), second.err());
            // of the process alone: that of Process would close its streams as well
            run.toHandle().destroy();
            String last = err.lines().collect(Collectors.joining("\n"));
            assertTrue(run.waitFor(20, TimeUnit.SECONDS));
            assertEquals(128 + 15, run.exitValue());
            assertTrue(last.matches("(?s).*Stopped: \\d+ of 30 photos are done; summary and report of these are in .*"),
                    last);
        } finally {
            run.destroyForcibly();
        }
        Map<String, String> left = contents(out);
        long results = left.keySet().stream().filter(name -> name.endsWith(".result.json")).count();
        assertTrue(results >= 1 && results < 30, left.keySet().toString());
        assertEquals(1 + 2 * results, left.get("summary.csv").lines().count());
        assertTrue(left.get("report.html").endsWith("</html>\n"));
        assertTrue(left.keySet().stream().noneMatch(name -> name.startsWith(".")), left.keySet().toString());
        assertTrue(Files.readString(folder.resolve("stdout")).contains(" of 30 photos: "));
    }

    /** Of a run that was killed: the system has let go of its lock, and nobody of its unfinished files. */
    @Test
    void whatAKilledRunLeftIsInNobodysWay() throws IOException {
        Files.createDirectories(out);
        Files.writeString(out.resolve(".cellgauge.lock"), "process 4194305, since yesterday");
        Files.writeString(out.resolve(".cellgauge-4194305-0123456789abcdef.part"), "half");
        check(detections(corners(1)));
        assertEquals(List.of("d1.chain-1.csv", "d1.chain-2.csv", "d1.overlay.png", "d1.result.json", "report.html",
                "summary.csv"), List.copyOf(contents(out).keySet()));
    }

    @Test
    void aFolderThatNothingWasWrittenToIsNotLeft() {
        assertEquals(3, check(folder.resolve("missing.png")).code());
        assertFalse(Files.exists(out));
    }

    // ---- draws

    @Test
    void drawsAreBoundedForOnePhotoAndOnRequestForSeveral() throws IOException {
        List<Path> files = corners(2);
        Path draws = out.resolve("d1.chain-1.csv");
        CommandCall one = CommandCall.of("check", "--cell", cell.toString(), "--iterations", "2520", "--warmup", "20",
                "--chains", "1", "--out", out.toString(), "--detections", files.get(0).toString());
        assertTrue(one.err().contains("hold every 3. draw; --draws writes all"), one.err());
        List<String> lines = Files.readAllLines(draws);
        assertTrue(lines.contains("#     thin = 3"), lines.toString());
        // the line of names, and every third of 2500
        assertEquals(1 + 834, lines.stream().filter(line -> !line.startsWith("#")).count());
        CommandCall all = CommandCall.of("check", "--cell", cell.toString(), "--iterations", "2520", "--warmup", "20",
                "--chains", "1", "--draws", "--out", out.toString(), "--detections", files.get(0).toString());
        assertFalse(all.err().contains("kept"), all.err());
        assertEquals(1 + 2500, Files.readAllLines(draws).stream().filter(line -> !line.startsWith("#")).count());
        assertTrue(Files.readString(out.resolve("report.html")).contains("--warmup 20 --draws --detections"));
        check(detections(files));
        assertFalse(Files.exists(draws), "draws of another result");
        assertEquals(List.of(), kept(check(detections(files, "--draws"))));
        assertTrue(Files.exists(draws) && Files.exists(out.resolve("d2.chain-2.csv")));
        assertEquals(List.of("d1", "d2"), kept(check(detections(files))));
        assertTrue(Files.exists(draws), "draws of this result");
        assertEquals(List.of("d1", "d2"), kept(check(detections(files, "--no-draws"))));
        assertFalse(Files.exists(draws));
    }

    // ---- names

    @Test
    void whatAFolderHasBesidesPhotosIsNamed() throws IOException {
        Path photos = Files.createDirectories(folder.resolve("photos"));
        Files.createDirectories(photos.resolve("more"));
        Files.writeString(photos.resolve("a.png"), "no picture");
        Files.write(photos.resolve("b.heic"), "\0\0\0\030ftypheic\0\0\0\0".getBytes(StandardCharsets.ISO_8859_1));
        Files.createSymbolicLink(photos.resolve("c.jpg"), photos.resolve("nowhere"));
        for (int i = 0; i < 7; i++) {
            Files.writeString(photos.resolve("raw" + i + ".dng"), "raw");
        }
        CommandCall call = check(photos);
        assertEquals(3, call.code());
        assertTrue(call.err().contains("a folder within it is not searched: more"), call.err());
        assertTrue(call.err().contains("7 files are not read, since no photos by their names: raw0.dng, raw1.dng, "
                + "raw2.dng, raw3.dng, raw4.dng and 2 more"), call.err());
        assertTrue(call.err().contains("c.jpg: it is a link that leads nowhere"), call.err());
        assertTrue(call.err().contains("b.heic: this is a HEIC"), call.err());
        assertTrue(call.out().contains("3 photos: 3 refused"), call.out());
        assertTrue(Files.readString(out.resolve("report.html")).contains("not searched: more"));
    }

    @Test
    void namesCommandNoTerminalAndAreNoOptions() throws IOException {
        Path photos = Files.createDirectories(folder.resolve("photos"));
        for (String name : List.of("a\u001b[2J.png", "b\n.png", "c\u009b2J.png", "d\u202egnp.png", "=cmd.png",
                "@args.png")) {
            Files.writeString(photos.resolve(name), "--seed\nx");
        }
        Files.createDirectories(photos.resolve("e\u001b[2J"));
        CommandCall call = check(photos);
        assertTrue(call.out().contains("6 photos: 6 refused"), call.out());
        String report = Files.readString(out.resolve("report.html"));
        CommandCall named = check(photos.resolve("@args.png"), photos.resolve("b\n.png"), photos.resolve("b\n.png"));
        assertTrue(report.contains("not searched: e [2J"), report);
        for (String text : List.of(call.out(), call.err(), named.out(), named.err(), report)) {
            assertTrue(text.chars().allMatch(c -> c == '\n' || c >= ' ' && (c < 0x7F || c > 0x9F) && c != 0x202E),
                    text);
        }
        check(photos);
        String summary = Files.readString(out.resolve("summary.csv"));
        assertTrue(summary.contains(",'=cmd,refused"), summary);
        assertEquals(7, summary.lines().count());
        CommandCall atFile = CommandCall.of("check", "--cell", cell.toString(), "--json", "@" + photos.resolve("a"));
        assertEquals(3, atFile.code(), "a file of that name is missing, and no options");
    }

    /** 228 bytes and ".result.json" are more than a name may have. */
    @Test
    void aNameThatIsTooLongForItsResultCostsTheOthersNothing() throws IOException {
        List<Path> files = new ArrayList<>(corners(2));
        files.add(1, Files.copy(files.get(0), folder.resolve("x".repeat(245) + ".json")));
        Files.createDirectories(out.resolve("d2.result.json"));
        CommandCall call = check(detections(files));
        assertEquals(3, call.code());
        assertTrue(call.out().contains("3 photos: 1 NOT CONVERGED, 2 refused"), call.out());
        assertEquals(1 + 2 + 1 + 1, Files.readAllLines(out.resolve("summary.csv")).size());
    }
}
