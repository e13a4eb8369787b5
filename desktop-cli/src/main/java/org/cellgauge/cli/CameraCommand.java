package org.cellgauge.cli;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import java.util.concurrent.Callable;
import org.cellgauge.cell.CameraCalibration;
import org.cellgauge.cell.CameraFile;
import org.cellgauge.cell.CameraFormat;
import org.cellgauge.cell.CameraReader;
import org.cellgauge.cell.InputRefusedException;
import org.cellgauge.desktop.CalibrationText;
import org.cellgauge.desktop.TextTable;
import org.cellgauge.desktop.WholeFiles;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.geometry.RationalLens;
import org.cellgauge.internal.cell.CameraExport;
import org.cellgauge.internal.cell.CameraWriter;
import org.cellgauge.warning.Place;
import org.cellgauge.warning.Refusal;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.ParentCommand;
import picocli.CommandLine.Spec;

/** {@code cellgauge camera}: what a camera file of any form says, and the same in another form. */
@Command(name = "camera", mixinStandardHelpOptions = true, sortOptions = false, versionProvider = Main.Version.class,
        description = {"Says what a camera file holds, or writes it in another program's form.", "", "Examples:",
            "  cellgauge camera camera.yaml", "  cellgauge camera camchain.yaml --name cam0",
            "  cellgauge camera camera.yaml --to ros --out camera_info.yaml", ""},
        footer = {"",
            "Read are BoofCV's files, OpenCV's (YAML, XML, JSON), ROS's camera_info, Kalibr's camchain, PhotonVision's",
            "and RealSense's JSON and mrcal's cameramodel; a cell file may name any of them. In all but BoofCV's the",
            "middle of the first pixel is (0, 0); here it is (0.5, 0.5), so 0.5 is added to cx and cy in reading and",
            "taken off in writing.",
            "",
            "Exit codes: 0 done, 1 internal error, 2 usage, 3 input refused or not writable."})
public final class CameraCommand implements Callable<Integer> {
    @Spec
    private CommandSpec spec;

    @ParentCommand
    private Main main;

    @Parameters(paramLabel = "FILE", description = "The camera file.")
    private Path file;

    @Option(names = "--name", paramLabel = "CAMERA", description = "Which camera, where the file holds several.")
    private String name;

    @Option(names = "--to", paramLabel = CameraForm.WORDS, description = "The form to write it in.")
    private String to;

    @Option(names = "--out", paramLabel = "FILE",
            description = "The file to write; without --to in BoofCV's form (standard output with --to alone).")
    private Path out;

    /**
     * Reads, and prints or writes.
     *
     * @return the exit code
     */
    @Override
    public Integer call() {
        CameraFormat format = to == null ? CameraFormat.BOOFCV : CameraForm.of(spec.commandLine(), to);
        try {
            CameraFile read = CameraReader.file(file, name);
            if (to == null && out == null) {
                print(table(read));
            } else {
                write(read, format);
            }
            return ExitCodes.OK;
        } catch (InputRefusedException e) {
            return main.report(e, ExitCodes.INPUT_REFUSED, spec.commandLine());
        }
    }

    private void print(String text) {
        PrintWriter stdout = spec.commandLine().getOut();
        stdout.print(text);
        stdout.flush();
    }

    private void write(CameraFile read, CameraFormat format) {
        CameraCalibration calibration = read.calibration();
        String text;
        try {
            text = CameraExport.text(read.camera(), format)
                    + (calibration == null ? "" : CameraExport.calibration(calibration))
                    + (read.focusDistanceM().isPresent()
                            ? CameraWriter.focusDistance(read.focusDistanceM().getAsDouble()) : "")
                    + (read.toneCurve() == null ? ""
                            : CameraReader.TONE_CURVE + ": " + read.toneCurve().words() + "\n");
        } catch (InputRefusedException e) {
            throw new InputRefusedException(e.refusal().withPlace(Place.of(file.toString())), e);
        }
        if (out == null) {
            print(text);
        } else {
            try {
                Files.createDirectories(out.toAbsolutePath().getParent());
                WholeFiles.writeContents(Map.of(out, to -> to.write(text.getBytes(StandardCharsets.UTF_8))));
            } catch (IOException e) {
                throw new InputRefusedException(Refusal.at(Place.of(out.toString()), CommandRefusal.CAMERA_NOT_WRITTEN,
                        String.valueOf(e.getMessage())), e);
            }
        }
        if (format == CameraFormat.BOOFCV && read.camera().lens() == RationalLens.MODEL) {
            spec.commandLine().getErr().println("BoofCV has no rational lens: this file is for cellgauge alone.");
        }
    }

    private static String table(CameraFile read) {
        PinholeCamera camera = read.camera();
        CameraCalibration calibration = read.calibration();
        StringBuilder text = new StringBuilder(read.format().words()).append(", ").append(camera.widthPx())
                .append(" x ").append(camera.heightPx()).append(" px, lens ")
                .append(camera.isDistorting() ? camera.lens().modelName() : "without distortion").append('\n');
        TextTable table = new TextTable(1);
        table.row("  parameter", "value", "std");
        for (int i = 0; i < camera.lens().parameterCount(); i++) {
            String parameter = camera.lens().parameterNames().get(i);
            int known = calibration == null ? -1 : calibration.parameters().indexOf(CameraCalibration.name(parameter));
            table.row("  " + parameter, CameraReader.plain(camera.get(i)),
                    known < 0 ? "" : CalibrationText.value(calibration.std(known)));
        }
        text.append(table.text(""));
        if (read.focusDistanceM().isPresent()) {
            text.append("The lens was focused at ").append(CameraReader.plain(read.focusDistanceM().getAsDouble()))
                    .append(" m when it was calibrated.\n");
        }
        if (read.format().principalPointShiftPx() != 0) {
            text.append("cx and cy stand with ").append(CameraReader.plain(read.format().principalPointShiftPx()))
                    .append(" px less in the file, which counts from the middle of the first pixel.\n");
        }
        if (read.deviationsAlone()) {
            text.append("The deviations in the file are not used: they come without their covariances.\n");
        }
        if (calibration == null) {
            text.append("These values count as exact; cellgauge calibrate makes a file that says how well they are ")
                    .append("known.\n");
        }
        return text.toString();
    }
}
