package org.cellgauge.fuzz;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import org.cellgauge.cell.CalibrationTargetReader;
import org.cellgauge.cell.CameraReader;
import org.cellgauge.cell.Cell;
import org.cellgauge.cell.CellReader;
import org.cellgauge.cell.InputRefusedException;
import org.cellgauge.check.CellCheck;
import org.cellgauge.check.CheckResult;
import org.cellgauge.desktop.EpochJson;
import org.cellgauge.desktop.ImageFiles;
import org.cellgauge.desktop.ImageRefusal;
import org.cellgauge.internal.cell.CellPhrase;
import org.cellgauge.internal.cell.InputChecks;
import org.cellgauge.internal.cell.InputFiles;
import org.cellgauge.internal.overlay.CellOverlay;
import org.cellgauge.output.ResultJson;
import org.cellgauge.output.ResultReader;
import org.cellgauge.output.ResultRecord;
import org.cellgauge.output.ResultRefusal;
import org.cellgauge.output.ResultView;
import org.cellgauge.settings.CheckSettings;
import org.cellgauge.survey.SurveyRefusal;
import org.cellgauge.vision.Detections;
import org.cellgauge.vision.DetectionsFile;

/**
 * What inputs are tried on: each reader of files, and checks as a whole. That no reader is missing is held by
 * {@code ArchitectureTest}.
 */
public enum Target {
    /** Cell files with the camera in them. */
    CELL("cell.CellReader") {
        @Override
        List<byte[]> corpus(Path root) throws IOException {
            List<byte[]> cells = new ArrayList<>();
            for (String scene : new String[] {"lifted-4", "distorted-4", "plane-3", "apriltag-4", "raised-3"}) {
                cells.add(Scenes.cellWithCamera(root, scene).getBytes(StandardCharsets.UTF_8));
            }
            return cells;
        }

        @Override
        void read(byte[] input) {
            String text = InputFiles.text(input, "a.yaml", CellPhrase.CELL_FILE, CellReader.MAX_BYTES);
            CellReader.read(text, "a.yaml", name -> "");
        }
    },

    /** Camera files of BoofCV. */
    CAMERA("cell.CameraReader") {
        @Override
        List<byte[]> corpus(Path root) throws IOException {
            return List.of(Files.readAllBytes(root.resolve("fixtures/distorted-4/camera.yaml")),
                    Files.readAllBytes(root.resolve("fixtures/plane-3/camera.yaml")), Scenes.FISHEYE.getBytes(
                            StandardCharsets.UTF_8));
        }

        @Override
        void read(byte[] input) {
            readCamera(input);
        }
    },

    /** Camera files of other programs as YAML and JSON. */
    CAMERA_OTHERS("cell.CameraText") {
        @Override
        List<byte[]> corpus(Path root) throws IOException {
            return Scenes.cameras(root);
        }

        @Override
        void read(byte[] input) {
            readCamera(input);
        }
    },

    /** Camera files of OpenCV as XML. */
    CAMERA_XML {
        @Override
        List<byte[]> corpus(Path root) throws IOException {
            return List.of(Files.readAllBytes(root.resolve(Scenes.CAMERAS + "opencv-12.xml")));
        }

        @Override
        void read(byte[] input) {
            readCamera(input);
        }
    },

    /** Files of calibration targets. */
    TARGET("cell.CalibrationTargetReader") {
        private Path file;

        @Override
        List<byte[]> corpus(Path root) throws IOException {
            file = Files.createTempFile("cellgauge-fuzz", ".yaml");
            file.toFile().deleteOnExit();
            Files.writeString(file.resolveSibling(file.getFileName() + ".cell"), Scenes.surveyed(root));
            file.resolveSibling(file.getFileName() + ".cell").toFile().deleteOnExit();
            return Scenes.targets(file.getFileName() + ".cell");
        }

        @Override
        void read(byte[] input) {
            try {
                Files.write(file, input);
            } catch (IOException e) {
                throw new UncheckedIOException(e);
            }
            CalibrationTargetReader.read(file);
        }
    },

    /** Detections files. */
    DETECTIONS("vision.DetectionsFile") {
        @Override
        List<byte[]> corpus(Path root) throws IOException {
            return List.of(Scenes.detections().getBytes(StandardCharsets.UTF_8),
                    Scenes.PRECISE_DETECTIONS.getBytes(StandardCharsets.UTF_8));
        }

        @Override
        void read(byte[] input) {
            DetectionsFile.read(input, "a.json");
        }
    },

    /** Photos of every format. */
    IMAGE("desktop.ImageFiles", "desktop.ImageFormat") {
        @Override
        List<byte[]> corpus(Path root) throws IOException {
            return Scenes.images();
        }

        @Override
        void read(byte[] input) {
            ImageFiles.decode(input, "a.png", (width, height) -> {
                // a cell's camera has one size; what is far larger than the corpus is refused like that
                if ((long) width * height > 1_000_000) {
                    throw new InputRefusedException("a.png", ImageRefusal.EMPTY);
                }
            });
        }
    },

    /** Stored results. */
    RESULT("output.ResultReader") {
        @Override
        List<byte[]> corpus(Path root) throws IOException {
            Cell cell = Scenes.cell(root, "lifted-4");
            CheckResult result = CellCheck.run(cell, DetectionsFile.read(
                    Scenes.detections().getBytes(StandardCharsets.UTF_8), "a.json"), SHORT);
            return List.of(ResultJson.of(result, RECORD).getBytes(StandardCharsets.UTF_8));
        }

        @Override
        void read(byte[] input) {
            ResultReader.of(InputFiles.text(input, "a.result.json", ResultRefusal.RESULT_FILE, ResultReader.MAX_BYTES),
                    "a.result.json");
        }
    },

    /** Earlier surveys. */
    SURVEY("desktop.EpochJson") {
        @Override
        List<byte[]> corpus(Path root) {
            return List.of(Scenes.SURVEY.getBytes(StandardCharsets.UTF_8));
        }

        @Override
        void read(byte[] input) {
            EpochJson.parse(InputFiles.text(input, "a.survey.json", SurveyRefusal.SURVEY_FILE, 1 << 20),
                    "a.survey.json");
        }
    },

    /** A cell and detections with other numbers in them, checked, drawn, written and read back. */
    CHECK {
        @Override
        List<byte[]> corpus(Path root) throws IOException {
            List<byte[]> pairs = new ArrayList<>();
            for (String noise : new String[] {"pixel_std_px: 0.3", "pixel_std_px: auto"}) {
                pairs.add((Scenes.cellWithCamera(root, "lifted-4").replace("target:", noise + "\ntarget:")
                        + Scenes.BETWEEN + Scenes.detections()).getBytes(StandardCharsets.UTF_8));
            }
            return pairs;
        }

        @Override
        byte[] mutated(byte[] input, Mutator mutator, List<byte[]> corpus) {
            return mutator.withOtherNumbers(new String(input, StandardCharsets.UTF_8), 3)
                    .getBytes(StandardCharsets.UTF_8);
        }

        @Override
        void read(byte[] input) {
            String[] parts = new String(input, StandardCharsets.UTF_8).split(Scenes.BETWEEN);
            Cell cell = CellReader.read(parts[0], "a.yaml", name -> "");
            Detections detections = DetectionsFile.read(parts[1].getBytes(StandardCharsets.UTF_8), "a.json");
            InputChecks.imageSize(cell, detections.widthPx(), detections.heightPx(), "a.json");
            CheckResult result = CellCheck.run(cell, detections, SHORT);
            Oracle.judge(cell, detections, result);
            CellOverlay.of(result);
            String json = ResultJson.of(result, RECORD);
            Oracle.fitsSchema(json);
            ResultView read = ResultReader.of(json, "a.result.json");
            Oracle.require(read.verdict() == result.verdict(), "another verdict is read than was written");
        }
    };

    private static final ResultRecord RECORD = ResultRecord.of("a.json", "0".repeat(64), "0");
    private static final CheckSettings SHORT = CheckSettings.builder().chains(2).iterations(1000)
            .targetMcseStdRel(0.05).build();

    private final Set<String> readers;

    private static void readCamera(byte[] input) {
        CameraReader.read(InputFiles.text(input, "a.yaml", CellPhrase.CAMERA_FILE, CameraReader.MAX_BYTES), "a.yaml");
    }

    Target(String... readers) {
        this.readers = Set.of(readers);
    }

    /**
     * Classes that take apart what is in a file, and that are tried here.
     *
     * @return their names without what all of them begin with, {@code org.cellgauge.}
     */
    public Set<String> readers() {
        return readers;
    }

    /** Inputs without a fault, of which mutations are made. */
    abstract List<byte[]> corpus(Path root) throws IOException;

    /**
     * Takes an input as the program does.
     *
     * @throws InputRefusedException if it is refused
     */
    abstract void read(byte[] input);

    byte[] mutated(byte[] input, Mutator mutator, List<byte[]> corpus) {
        return mutator.mutated(input, corpus);
    }
}
