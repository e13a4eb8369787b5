package org.cellgauge.cli;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.concurrent.Callable;
import org.cellgauge.cell.Cell;
import org.cellgauge.cell.InputRefusedException;
import org.cellgauge.cell.ObjectMarker;
import org.cellgauge.desktop.ResultFolder;
import org.cellgauge.desktop.WholeFiles;
import org.cellgauge.desktop.render.Backdrop;
import org.cellgauge.desktop.render.CellSimulation;
import org.cellgauge.desktop.render.GreyJpeg;
import org.cellgauge.desktop.render.GreyPng;
import org.cellgauge.desktop.render.Misprints;
import org.cellgauge.desktop.render.Scene;
import org.cellgauge.desktop.render.SceneTruth;
import org.cellgauge.desktop.render.Sensor;
import org.cellgauge.desktop.render.TruthFile;
import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.light.ToneCurve;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;

/** {@code cellgauge simulate}: renders photos of a cell with known truth. */
@Command(name = "simulate", mixinStandardHelpOptions = true, sortOptions = false,
        versionProvider = Main.Version.class,
        description = {"Renders photos of a cell with known truth: NAME.png (NAME.jpg with --jpeg) and, beside it, "
                + "NAME.truth.json.", "", "Examples:",
            "  cellgauge simulate --cell cell.yaml --out photos \\",
            "      --object 5=370,295,0,0,0,20",
            "  cellgauge simulate --cell cell.yaml --out photos \\",
            "      --look-at 250,190,0 --camera-position 250,-400,900",
            ""},
        footer = {"",
            "Angles are in degrees, as in the cell file, unless they end in 'rad';",
            "psi, theta, phi turn about x, y, z: R = Rz(phi) Ry(theta) Rx(psi).",
            "The written files are named on standard output.",
            "Exit codes: 0 done, 1 internal error, 2 usage, 3 input refused."})
public final class SimulateCommand implements Callable<Integer> {

    private static final double WHITE_GREY = 255;

    @Spec
    private CommandSpec spec;

    @Option(names = "--cell", required = true, paramLabel = "CELL", description = "The cell file.")
    private Path cellFile;

    @Option(names = "--out", required = true, paramLabel = "DIR",
            description = "Folder for the photos; made if it is missing. Files of the same names are replaced.")
    private Path out;

    @Option(names = "--object", paramLabel = "ID=X,Y,Z[,PSI,THETA,PHI]",
            description = "Pose of an object of the cell in the world, mm and degrees. Repeat it for every object "
                    + "to be seen; the others stay out of the photo.")
    private List<String> objects = new ArrayList<>();

    @Mixin
    private Viewpoint viewpoint = new Viewpoint();

    @Option(names = "--camera-jitter", paramLabel = "MM,DEG", defaultValue = "0,0",
            preprocessor = PoseArgument.MayBeNegative.class,
            description = "Standard deviation of the camera's pose from photo to photo: position per axis in mm, "
                    + "rotation per axis in degrees (${DEFAULT-VALUE}).")
    private String cameraJitter;

    @Option(names = "--placement-errors", paramLabel = "none|draw", defaultValue = "none",
            description = "'draw': every photo has its references off their nominal places by a draw from the "
                    + "placement that the cell file states. 'none': they stand exactly there "
                    + "(${DEFAULT-VALUE}).")
    private String placementErrors;

    @Option(names = "--count", paramLabel = "N", defaultValue = "1",
            description = "Number of photos, 1 to 100000 (${DEFAULT-VALUE}).")
    private int count;

    @Option(names = "--seed", paramLabel = "SEED", defaultValue = "1",
            description = "Seed of everything random; the same seed gives the same bytes (${DEFAULT-VALUE}).")
    private long seed;

    @Option(names = "--name", paramLabel = "NAME", defaultValue = "photo",
            description = "Base name of the files; with several photos -1, -2, ... is added (${DEFAULT-VALUE}).")
    private String name;

    @Option(names = "--blur-px", paramLabel = "PX", defaultValue = "0.7",
            description = "Standard deviation of the Gaussian blur, px (${DEFAULT-VALUE}).")
    private double blurPx;

    @Option(names = "--noise", paramLabel = "GREY", defaultValue = "2",
            description = "Standard deviation of the noise in grey levels of 255 (${DEFAULT-VALUE}).")
    private double noiseGrey;

    @Option(names = "--shot-noise", paramLabel = "ELECTRONS", defaultValue = "0",
            description = "Adds shot noise: electrons at full scale, for instance 10000; 0 is none (${DEFAULT-VALUE}).")
    private double fullWellElectrons;

    @Option(names = "--tone-curve", paramLabel = "srgb|linear|\"gamma G\"",
            description = "Tone curve: grey values of light, as the camera makes them (linear).")
    private String toneCurve;

    @Option(names = "--gamma", paramLabel = "GAMMA",
            description = "Short for --tone-curve \"gamma GAMMA\": grey = 255 light^(1/gamma); 1 is a linear sensor.")
    private Double gamma;

    @Option(names = "--exposure", paramLabel = "X", defaultValue = "1",
            description = "What light is multiplied by before the tone curve; above 1.2 white paper is clipped, 0.1 is "
                    + "a dark photo (${DEFAULT-VALUE}).")
    private double exposure;

    @Option(names = "--unsharp", paramLabel = "AMOUNT,RADIUS_PX",
            description = "Unsharp mask, as phones have it, on the grey values: AMOUNT times the difference to a copy "
                    + "blurred by RADIUS_PX is added, for instance 0.6,1.2 (none).")
    private String unsharp;

    @Option(names = "--jpeg", paramLabel = "QUALITY",
            description = "Writes a JPEG file of this quality, 1 to 100, in place of a PNG.")
    private Integer jpegQuality;

    @Option(names = "--no-profile",
            description = "Leaves out the note on the tone curve that PNG files of cameras carry.")
    private boolean noProfile;

    @Option(names = "--print-gain", paramLabel = "MM", defaultValue = "0",
            preprocessor = PoseArgument.MayBeNegative.class,
            description = "Ink spreads: every dark region of a print is larger by MM on all sides, below 0 smaller "
                    + "(${DEFAULT-VALUE}).")
    private double printGainMm;

    @Option(names = "--vignetting", paramLabel = "SHARE", defaultValue = "0.15",
            description = "Share of the light that the image's corners lose (${DEFAULT-VALUE}).")
    private double vignetting;

    @Option(names = "--gradient", paramLabel = "SHARE", defaultValue = "0.1",
            description = "Change of the light from left to right (${DEFAULT-VALUE}).")
    private double gradient;

    @Option(names = "--texture", paramLabel = "CONTRAST", defaultValue = "0.08",
            description = "Contrast of the wall's texture, 0 to 0.4; 0 is plain grey (${DEFAULT-VALUE}).")
    private double texture;

    @Option(names = "--quiet-zone", paramLabel = "SHARE", defaultValue = "" + Scene.DEFAULT_QUIET_ZONE,
            description = "White paper on each side of a marker as a share of its size (${DEFAULT-VALUE}).")
    private double quietZone;

    @Option(names = "--black-level", paramLabel = "GREY", defaultValue = "0",
            preprocessor = PoseArgument.MayBeNegative.class,
            description = "What the camera adds to every grey value; below 0 blacks are cut off (${DEFAULT-VALUE}).")
    private double blackLevelGrey;

    @Option(names = "--clip", paramLabel = "GREY", defaultValue = "255",
            description = "Grey value at which the sensor is full: what is brighter has it (${DEFAULT-VALUE}).")
    private double clipGrey;

    @Option(names = "--ink", paramLabel = "SHARE",
            description = "Light that the prints' black throws back, 0 to 1; paper throws back 0.85. 0.43 makes faint "
                    + "markers (0.05).")
    private Double ink;

    @Option(names = "--mirrored", paramLabel = "all|ID[,ID...]",
            description = "Markers that are printed with left and right exchanged (none).")
    private String mirrored;

    @Option(names = "--inverted", paramLabel = "all|ID[,ID...]",
            description = "Markers that are printed white on black (none).")
    private String inverted;

    @Option(names = "--turned", paramLabel = "all|ID=QUARTERS", preprocessor = PoseArgument.MayBeNegative.class,
            description = "Prints turned in their places by quarters clockwise; all=2 is how OpenCV draws AprilTags. "
                    + "Repeat it for more (none).")
    private List<String> turned = new ArrayList<>();

    @Option(names = "--exchanged", paramLabel = "ID,ID",
            description = "Two markers that stand in each other's places. Repeat it for more (none).")
    private List<String> exchanged = new ArrayList<>();

    /**
     * Renders the photos.
     *
     * @return the exit code
     * @throws IOException if this Java cannot encode images
     */
    @Override
    public Integer call() throws IOException {
        Sensor sensor = sensor();
        settings(Misprints.NONE);
        if (count < 1 || count > 100_000) {
            throw usage("--count: must be between 1 and 100000, not " + count);
        }
        if (name.isEmpty() || name.startsWith(".") || name.contains("/") || name.contains("\\")) {
            throw usage("--name: '" + name + "' is no file name; folders go to --out");
        }
        viewpoint.requireOne(spec.commandLine());
        Map<Integer, RigidTransform> poses = ObjectPoses.parse(spec.commandLine(), objects);
        PrintWriter err = spec.commandLine().getErr();
        try {
            Cell cell = StandardInput.cell(cellFile);
            ObjectPoses.requireKnown(spec.commandLine(), cell, cellFile, poses);
            PhotoOptions.requirePrintable(spec.commandLine(), cell, printGainMm);
            RigidTransform camera = viewpoint.pose(spec.commandLine(), cell, poses);
            if (Files.exists(out) && !Files.isDirectory(out)) {
                throw usage("--out: " + out + " is a file, not a folder");
            }
            Misprints misprints = PrintArguments.misprints(spec.commandLine(), cell, inverted, mirrored, turned,
                    exchanged, ink);
            ResultFolder output = ResultFolder.into(out);
            run(cell, new CellSimulation(cell, camera, poses, settings(misprints)), poses, sensor, output);
            return CommandLine.ExitCode.OK;
        } catch (InputRefusedException | ResultFolder.UnwritableException e) {
            err.println(CommandWords.of(e));
            return ExitCodes.INPUT_REFUSED;
        }
    }

    private void run(Cell cell, CellSimulation simulation, Map<Integer, RigidTransform> poses, Sensor sensor,
            ResultFolder output) throws IOException {
        PrintWriter err = spec.commandLine().getErr();
        PrintWriter stdout = spec.commandLine().getOut();
        int digits = Integer.toString(count).length();
        for (int i = 0; i < count; i++) {
            String base = count == 1 ? name : name + String.format(Locale.ROOT, "-%0" + digits + "d", i + 1);
            CellSimulation.Photo photo = simulation.photo(i, sensor);
            String imageName = base + (jpegQuality == null ? ".png" : ".jpg");
            String truth = TruthFile.json(cell, photo, imageName, seed, i, settingsByName(photo, sensor), command());
            byte[] image = jpegQuality == null
                    ? GreyPng.encode(photo.image(), noProfile ? ToneCurve.LINEAR : sensor.toneCurve())
                    : GreyJpeg.encode(photo.image(), jpegQuality);
            Map<String, WholeFiles.Content> files = new LinkedHashMap<>();
            files.put(base + ".truth.json", bytes -> bytes.write(truth.getBytes(StandardCharsets.UTF_8)));
            files.put(imageName, bytes -> bytes.write(image));
            output.write(files);
            files.keySet().forEach(file -> stdout.println(out.resolve(file)));
            stdout.flush();
            if (count > 1) {
                err.println("[" + (i + 1) + "/" + count + "] " + imageName);
                err.flush();
            }
            for (SceneTruth.MarkerInImage marker : SceneTruth.of(photo.scene())) {
                if (!marker.whollyInside()) {
                    err.println(base + ": marker " + marker.id() + " is not wholly inside the image.");
                } else if (marker.visibleShare() < 1) {
                    err.println(base + ": marker " + marker.id() + " is partly hidden.");
                }
            }
        }
        for (ObjectMarker object : cell.objects()) {
            if (!poses.containsKey(object.id())) {
                err.println("Object " + object.id() + " is not in the photos: no --object " + object.id()
                        + "=... given.");
            }
        }
        err.flush();
    }

    private Sensor sensor() {
        try {
            return PhotoOptions.unsharp(new Sensor(blurPx, noiseGrey, fullWellElectrons,
                    PhotoOptions.toneCurve(toneCurve, gamma), exposure, 0, 1, vignetting, gradient, blackLevelGrey,
                    clipGrey), unsharp);
        } catch (IllegalArgumentException e) {
            throw usage(e.getMessage());
        }
    }

    private CellSimulation.Settings settings(Misprints misprints) {
        if (!placementErrors.equals("none") && !placementErrors.equals("draw")) {
            throw usage("--placement-errors: must be 'none' or 'draw', not '" + placementErrors + "'");
        }
        if (!(quietZone >= 0 && quietZone <= 10)) {
            throw usage("--quiet-zone: must be between 0 and 10, not " + quietZone);
        }
        try {
            Backdrop.textured(texture, seed);
        } catch (IllegalArgumentException e) {
            throw usage("--texture: " + e.getMessage());
        }
        if (jpegQuality != null && (jpegQuality < 1 || jpegQuality > 100)) {
            throw usage("--jpeg: the quality must be between 1 and 100, not " + jpegQuality);
        }
        if (!Double.isFinite(printGainMm)) {
            throw usage("--print-gain: must be a number of mm, not " + printGainMm);
        }
        String[] jitter = cameraJitter.split(",", -1);
        try {
            double mm = Double.parseDouble(jitter[0].trim());
            double degrees = Double.parseDouble(jitter[jitter.length - 1].trim());
            if (jitter.length == 2 && mm >= 0 && degrees >= 0 && Double.isFinite(mm + degrees)) {
                return new CellSimulation.Settings(seed, placementErrors.equals("draw"), mm, Math.toRadians(degrees),
                        texture, quietZone, printGainMm, misprints);
            }
        } catch (NumberFormatException e) {
            // said below, as for negative values
        }
        throw usage("--camera-jitter: '" + cameraJitter + "' is not MM,DEG with two values of at least 0, as in 5,0.5");
    }

    /** What is as it was before there was a choice is left out, so that older truths stay what they were. */
    private Map<String, Object> settingsByName(CellSimulation.Photo photo, Sensor sensor) {
        Map<String, Object> settings = new LinkedHashMap<>();
        settings.put("placement_errors", placementErrors);
        settings.put("camera_jitter_mm_deg", cameraJitter);
        settings.put("blur_px", blurPx);
        settings.put("noise_grey", noiseGrey);
        settings.put("full_well_electrons", fullWellElectrons);
        if (sensor.toneCurve() != ToneCurve.SRGB) {
            settings.put("gamma", gamma != null ? gamma : PhotoOptions.gamma(sensor.toneCurve()));
        }
        if (!sensor.toneCurve().isLinear()) {
            settings.put("tone_curve", sensor.toneCurve().words());
        }
        if (exposure != 1) {
            settings.put("exposure", exposure);
        }
        if (unsharp != null) {
            settings.put("unsharp_amount", sensor.unsharpAmount());
            settings.put("unsharp_radius_px", sensor.unsharpRadiusPx());
        }
        if (jpegQuality != null) {
            settings.put("jpeg_quality", jpegQuality);
        }
        if (printGainMm != 0) {
            settings.put("print_gain_mm", printGainMm);
        }
        if (blackLevelGrey != 0) {
            settings.put("black_level_grey", blackLevelGrey);
        }
        if (clipGrey != WHITE_GREY) {
            settings.put("clip_grey", clipGrey);
        }
        if (ink != null) {
            settings.put("ink_reflectance", ink);
        }
        if (mirrored != null) {
            settings.put("mirrored", mirrored);
        }
        if (inverted != null) {
            settings.put("inverted", inverted);
        }
        if (!turned.isEmpty()) {
            settings.put("turned", String.join(" ", turned));
        }
        if (!exchanged.isEmpty()) {
            settings.put("exchanged", String.join(" ", exchanged));
        }
        settings.put("vignetting", vignetting);
        settings.put("gradient", gradient);
        settings.put("texture_contrast", texture);
        settings.put("quiet_zone", photo.scene().quietZone());
        return settings;
    }

    private List<String> command() {
        List<String> command = new ArrayList<>(List.of("cellgauge"));
        // of a command within the program the arguments it was given begin with its name
        CommandLine root = spec.root().commandLine();
        if (root == spec.commandLine()) {
            command.add(spec.name());
        }
        command.addAll(root.getParseResult().originalArgs());
        return command;
    }

    private ParameterException usage(String message) {
        return new ParameterException(spec.commandLine(), message);
    }
}
