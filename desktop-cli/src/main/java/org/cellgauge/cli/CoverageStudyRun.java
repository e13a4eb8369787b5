package org.cellgauge.cli;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.function.BiFunction;
import java.util.function.IntConsumer;
import org.cellgauge.cell.Cell;
import org.cellgauge.cell.InputRefusedException;
import org.cellgauge.cell.MarkerFamily;
import org.cellgauge.cell.ObjectMarker;
import org.cellgauge.cell.Reference;
import org.cellgauge.desktop.CheckText;
import org.cellgauge.desktop.render.RenderedPhotos;
import org.cellgauge.desktop.render.Sensor;
import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.internal.geometry.MarkerGeometry;
import org.cellgauge.internal.settings.SettingsJson;
import org.cellgauge.internal.validation.CellSource;
import org.cellgauge.internal.validation.CellTruth;
import org.cellgauge.internal.validation.CoverageFigures;
import org.cellgauge.internal.validation.CoverageStudy;
import org.cellgauge.internal.validation.DetectionSource;
import org.cellgauge.internal.validation.DrawnCorners;
import org.cellgauge.internal.validation.OneCell;
import org.cellgauge.internal.validation.RandomLayouts;
import org.cellgauge.internal.validation.TruthPrior;
import org.cellgauge.internal.vision.BoofThreads;
import org.cellgauge.settings.CheckSettings;
import org.cellgauge.settings.Estimate;
import org.cellgauge.warning.Refusal;
import picocli.CommandLine;
import picocli.CommandLine.ParameterException;

/** {@code validate} with {@code --photos} or {@code --random-layouts}. */
final class CoverageStudyRun {
    /** More photos without a figure than this share of all say that coverage of the others means little. */
    private static final double MOST_WITHOUT_FIGURE = 0.05;

    private final CommandLine command;
    private final StudyOptions options;
    private final StudySettings study;
    private final CheckSettings check;
    private final String repeating;

    CoverageStudyRun(CommandLine command, StudyOptions options, StudySettings study, CheckSettings check,
            String repeating) {
        this.command = command;
        this.options = options;
        this.study = study;
        this.check = check;
        this.repeating = repeating;
        // each simulation is one thread's; BoofCV would spread its part over all cores
        BoofThreads.useOne();
    }

    // ---- one cell

    /**
     * Photos of one cell.
     *
     * @param given the cell
     * @param nominal poses of the camera and of every object
     * @param priors makes the prior of the truths of a cell and nominal poses
     * @param json whether figures are printed as JSON
     * @param progress told what is done
     * @return the exit code
     */
    int oneCell(Cell given, CellTruth nominal, BiFunction<Cell, CellTruth, TruthPrior> priors, boolean json,
            IntConsumer progress) {
        PhotoOptions.requirePrintable(command, given, study.printGainMm());
        Cell cell = study.stated(given);
        OptionalDouble side = study.get(StudyTable.MARKER_PX);
        CellTruth seen = side.isEmpty() ? nominal : atSide(cell, nominal, side.getAsDouble());
        Sensor sensor = study.sensor();
        TruthPrior prior = priors.apply(cell, seen);
        CoverageFigures figures = run(OneCell.inFullView(prior),
                new RenderedPhotos(sensor, study.jpegQuality(), study.printGainMm(), study.outlinesDrawn()),
                progress);
        Map<String, Object> settings = study.plain();
        addTruth(settings, cell, seen, prior);
        addSensor(settings, sensor, study.jpegQuality(), study.printGainMm());
        addPoses(settings, seen);
        return print(figures, settings, json, String.format(Locale.ROOT, "photos with %s, blur %s px, light times %s, "
                + "markers of %.1f px, seed %d", sensor.toneCurve().words(), CheckText.plain(sensor.blurPx()),
                CheckText.plain(sensor.exposure()), meanSidePx(cell, seen), check.sampling().seed()));
    }

    /**
     * Corners drawn of one cell, some of them far off.
     *
     * @param prior of the truths of the cell
     * @param pixelStdPx standard deviation of the noise of the others, px
     * @param json whether figures are printed as JSON
     * @param progress told what is done
     * @return the exit code
     */
    int drawnCorners(TruthPrior prior, double pixelStdPx, boolean json, IntConsumer progress) {
        Map<String, Object> settings = study.plain();
        settings.put("simulated_pixel_std_px", pixelStdPx);
        addTruth(settings, prior.cell(), prior.nominal(), prior);
        addPoses(settings, prior.nominal());
        return print(run(OneCell.of(prior), withOutliers(DrawnCorners.of(pixelStdPx)), progress), settings, json,
                String.format(Locale.ROOT, "one cell, corners drawn with %s px%s, seed %d",
                        CheckText.plain(pixelStdPx), outliers(), check.sampling().seed()));
    }

    private DrawnCorners withOutliers(DrawnCorners corners) {
        return study.get(StudyTable.OUTLIERS).map(of -> corners.withOutliers(of.first(), of.second())).orElse(corners);
    }

    private String outliers() {
        return study.get(StudyTable.OUTLIERS).map(of -> ", " + CheckText.plain(100 * of.first())
                + " % of them off by " + CheckText.plain(of.second()) + " deviations").orElse("");
    }

    // ---- random layouts

    int randomLayouts(boolean json, IntConsumer progress) {
        if (check.model().estimate() != Estimate.NONE) {
            throw new ParameterException(command, "--random-layouts draws cameras that the check knows; leave out "
                    + "--estimate, or give a --cell");
        }
        CellSource cells;
        DetectionSource detections;
        String what;
        Map<String, Object> settings = study.plain();
        if (study.photos()) {
            Sensor sensor = study.sensor();
            cells = RandomLayouts.withNoise(MarkerFamily.SQUARE_BINARY,
                    study.get(StudyTable.STATED_PIXEL_STD_PX).orElse(OptionalDouble.empty()));
            detections = new RenderedPhotos(sensor, study.jpegQuality(), study.printGainMm(),
                    study.outlinesDrawn());
            what = "a layout for each, photos with " + sensor.toneCurve().words() + ", blur "
                    + CheckText.plain(sensor.blurPx()) + " px";
            addSensor(settings, sensor, study.jpegQuality(), study.printGainMm());
        } else {
            OptionalDouble px = study.get(StudyTable.PIXEL_STD_PX);
            cells = px.isEmpty() ? RandomLayouts.withDrawnNoise(MarkerFamily.SQUARE_BINARY)
                    : RandomLayouts.withNoise(MarkerFamily.SQUARE_BINARY, px);
            detections = withOutliers(DrawnCorners.asStated());
            settings.put("simulated_pixel_std_px", px.isEmpty() ? "drawn" : px.getAsDouble());
            what = "a layout for each, corners drawn with the stated noise" + outliers();
        }
        return print(run(cells, detections, progress), settings, json, what + ", seed " + check.sampling().seed());
    }

    // ---- grid

    /**
     * The whole table.
     *
     * @param given the cell
     * @param nominal poses of the camera and of every object
     * @param priors makes the prior of the truths of a cell and nominal poses
     * @param json whether each row is printed as a JSON document in place of a line of a table
     * @return the exit code
     * @throws IOException if the file of the rows cannot be read or written
     */
    int grid(Cell given, CellTruth nominal, BiFunction<Cell, CellTruth, TruthPrior> priors, boolean json)
            throws IOException {
        List<PhotoGrid.Row> rows = new ArrayList<>();
        for (PhotoGrid.Row row : PhotoGrid.rows(study.sensor())) {
            if (options.onlyWords().stream().allMatch(row.name()::contains)) {
                rows.add(row);
            }
        }
        if (rows.isEmpty()) {
            throw new ParameterException(command, "--only: no row of the grid has all of these words; names are like '"
                    + PhotoGrid.rows(study.sensor()).get(0).name() + "'");
        }
        Path file = options.out();
        List<String> done = file != null && Files.exists(file) ? Files.readAllLines(file) : List.of();
        List<String> columns = done.isEmpty() ? columns() : columnsOf(done.get(0), file);
        PrintWriter out = command.getOut();
        PrintWriter err = command.getErr();
        if (!json) {
            out.print(head(columns));
        }
        if (file != null && done.isEmpty()) {
            Files.writeString(file, head(columns));
        }
        boolean covered = true;
        boolean told = true;
        int at = 0;
        for (PhotoGrid.Row row : rows) {
            at++;
            String start = "| " + String.join(" | ", row.cells()) + " | ";
            String known = done.stream().filter(line -> line.startsWith(start)).findFirst().orElse(null);
            if (known != null) {
                err.println("[" + at + "/" + rows.size() + "] " + row.name() + ": already in " + file);
                err.flush();
                if (!json) {
                    out.println(known);
                    out.flush();
                }
                continue;
            }
            RowResult found = row(row, given, nominal, priors);
            CoverageFigures figures = found == null ? null : found.figures;
            String line = start + (figures == null ? "refused |"
                    : String.join(" | ", cellsOfRow(figures, columns)) + " |");
            if (file != null) {
                Files.write(file, (line + "\n").getBytes(StandardCharsets.UTF_8), StandardOpenOption.APPEND);
            }
            if (json && figures != null) {
                Map<String, Object> settings = study.plain();
                settings.put("row", row.name());
                addSensor(settings, row.sensor(), row.jpegQuality(), row.printGainMm());
                addTruth(settings, found.cell, found.seen, found.prior);
                addPoses(settings, found.seen);
                addCheck(settings);
                out.print(new StudyText(figures).json(settings, repeating, Main.version()));
            } else if (!json) {
                out.println(line);
            }
            out.flush();
            covered &= figures != null && covers(figures);
            told &= figures != null && StudyText.withoutFigure(figures) <= MOST_WITHOUT_FIGURE;
            err.println("[" + at + "/" + rows.size() + "] " + row.name());
            err.flush();
        }
        return !told ? ExitCodes.NO_FIGURE : covered ? ExitCodes.OK : ExitCodes.TARGET_MISSED;
    }

    /** What a row of the grid was made from, and its figures. */
    private record RowResult(CoverageFigures figures, Cell cell, CellTruth seen, TruthPrior prior) {
    }

    /** One row; null, with a message, if its markers do not fit into the image. */
    private RowResult row(PhotoGrid.Row row, Cell given, CellTruth nominal,
            BiFunction<Cell, CellTruth, TruthPrior> priors) {
        Cell cell = study.stated(row.aprilTags() ? PhotoGrid.withAprilTags(given) : given);
        CellTruth named = row.aprilTags() ? new CellTruth(nominal.worldFromCamera(),
                PhotoGrid.renumbered(given, nominal.worldFromObjects())) : nominal;
        try {
            CellTruth seen = atSide(cell, named, row.markerPx());
            TruthPrior prior = priors.apply(cell, seen);
            RenderedPhotos photos = new RenderedPhotos(row.sensor(), row.jpegQuality(), row.printGainMm(),
                    study.outlinesDrawn());
            // a row has truths of its own, so that what chance does to one it does not do to all
            CheckSettings own = check.toBuilder()
                    .seed(check.sampling().seed() + PhotoGrid.number(study.sensor(), row)).build();
            return new RowResult(run(OneCell.inFullView(prior), photos, own, done -> { }), cell, seen, prior);
        } catch (InputRefusedException e) {
            command.getErr().println(row.name() + ": " + CommandWords.of(e));
            return null;
        }
    }

    /**
     * Columns of a table that stands in a file already: ours, or some of them, as where it was begun before there were
     * others.
     */
    private List<String> columnsOf(String head, Path file) {
        List<String> titles = Arrays.asList(head.replaceAll("^\\| | \\|$", "").split(" \\| "));
        int first = PhotoGrid.titles().size();
        if (titles.size() <= first || !titles.subList(0, first).equals(PhotoGrid.titles())
                || !columns().containsAll(titles.subList(first, titles.size()))) {
            throw new ParameterException(command, "--out: " + file + " is no table of these columns; write another");
        }
        List<String> columns = titles.subList(first, titles.size());
        List<String> missing = new ArrayList<>(columns());
        missing.removeAll(columns);
        if (!missing.isEmpty()) {
            command.getErr().println(file + " has no column for " + String.join(", ", missing)
                    + ": rows are added without; write another file to have them");
            command.getErr().flush();
        }
        return columns;
    }

    private static String head(List<String> columns) {
        List<String> titles = new ArrayList<>(PhotoGrid.titles());
        titles.addAll(columns);
        return "| " + String.join(" | ", titles) + " |\n" + "|---".repeat(titles.size()) + "|\n";
    }

    // ---- common

    private CoverageFigures run(CellSource cells, DetectionSource detections, IntConsumer progress) {
        return run(cells, detections, check, progress);
    }

    private CoverageFigures run(CellSource cells, DetectionSource detections, CheckSettings with,
            IntConsumer progress) {
        return study.cornersOnly()
                ? CoverageStudy.runCornersOnly(cells, detections, with.sampling().seed(), study.simulations(),
                        with.sampling().threads(), progress)
                : CoverageStudy.run(cells, detections, with, study.simulations(), with.sampling().threads(), progress);
    }

    /** Whether all regions held, where there is any to hold. */
    private boolean covers(CoverageFigures figures) {
        return study.cornersOnly() || StudyText.covers(figures);
    }

    private List<String> columns() {
        return study.cornersOnly() ? StudyText.CORNER_COLUMNS : StudyText.COLUMNS;
    }

    private List<String> cellsOfRow(CoverageFigures figures, List<String> columns) {
        StudyText text = new StudyText(figures);
        List<String> all = study.cornersOnly() ? text.markdownRowOfCorners() : text.markdownRow();
        List<String> cells = new ArrayList<>();
        columns.forEach(column -> cells.add(all.get(columns().indexOf(column))));
        return cells;
    }

    /** What check's settings hold besides. */
    private void addCheck(Map<String, Object> settings) {
        SettingsJson.plain(check).forEach(settings::putIfAbsent);
    }

    private static void addTruth(Map<String, Object> settings, Cell cell, CellTruth seen, TruthPrior prior) {
        settings.put("marker_px", meanSidePx(cell, seen));
        settings.put("spread_mm", prior.stdMm());
        settings.put("spread_rad", prior.stdRad());
    }

    private static void addPoses(Map<String, Object> settings, CellTruth seen) {
        settings.put("camera_pose", ValidationText.poseValues(seen.worldFromCamera()));
        Map<String, Object> objects = new LinkedHashMap<>();
        seen.worldFromObjects().forEach((id, pose) -> objects.put(String.valueOf(id), ValidationText.poseValues(pose)));
        settings.put("object_poses", objects);
    }

    private static void addSensor(Map<String, Object> settings, Sensor sensor, int jpegQuality, double printGainMm) {
        settings.put("tone_curve", sensor.toneCurve().words());
        settings.put("blur_px", sensor.blurPx());
        settings.put("exposure", sensor.exposure());
        settings.put("unsharp_amount", sensor.unsharpAmount());
        settings.put("unsharp_radius_px", sensor.unsharpRadiusPx());
        settings.put("noise_grey", sensor.noiseGrey());
        settings.put("full_well_electrons", sensor.fullWellElectrons());
        settings.put("vignetting", sensor.vignetting());
        settings.put("gradient", sensor.gradient());
        settings.put("jpeg_quality", jpegQuality);
        settings.put("print_gain_mm", printGainMm);
    }

    private int print(CoverageFigures figures, Map<String, Object> settings, boolean json, String what) {
        addCheck(settings);
        StudyText text = new StudyText(figures);
        PrintWriter out = command.getOut();
        out.print(json ? text.json(settings, repeating, Main.version()) : text.text(what));
        out.flush();
        return StudyText.withoutFigure(figures) > MOST_WITHOUT_FIGURE ? ExitCodes.NO_FIGURE
                : covers(figures) ? ExitCodes.OK : ExitCodes.TARGET_MISSED;
    }

    /**
     * The nominal poses with the camera moved along the line to the references' centroid until the markers' sides are
     * so long on average. Camera, layout and placement stay what they are, as when a user steps nearer: a longer focal
     * length would need a larger image, and be another camera. Objects keep their places in the world.
     *
     * @param cell the cell
     * @param nominal poses
     * @param sidePx average side, px
     * @return poses
     */
    static CellTruth atSide(Cell cell, CellTruth nominal, double sidePx) {
        double[] centroid = new double[3];
        for (Reference r : cell.references()) {
            for (int i = 0; i < 3; i++) {
                centroid[i] += r.worldFromMarker().translationMm()[i] / cell.references().size();
            }
        }
        RigidTransform camera = nominal.worldFromCamera();
        CellTruth moved = nominal;
        // sides go nearly as the inverse of the distance: a few rounds bring them there
        for (int round = 0; round < 20; round++) {
            double factor = meanSidePx(cell, moved) / sidePx;
            double[] t = camera.translationMm();
            for (int i = 0; i < 3; i++) {
                t[i] = centroid[i] + factor * (t[i] - centroid[i]);
            }
            camera = RigidTransform.of(camera.rotation(), t);
            moved = new CellTruth(camera, nominal.worldFromObjects());
            if (!(Math.abs(factor - 1) > 1e-6)) {
                break;
            }
        }
        if (!(Math.abs(meanSidePx(cell, moved) / sidePx - 1) < 0.01)) {
            throw new InputRefusedException(Refusal.of(CommandRefusal.NO_DISTANCE, CheckText.plain(sidePx)));
        }
        return moved;
    }

    /** Average side of the cell's markers as the nominal camera sees them, px; NaN if one is behind it. */
    static double meanSidePx(Cell cell, CellTruth nominal) {
        RigidTransform cameraFromWorld = nominal.worldFromCamera().inverse();
        double sum = 0;
        int sides = 0;
        for (Reference r : cell.references()) {
            sum += sidesPx(cell, cameraFromWorld.compose(r.worldFromMarker()), r.sizeMm());
            sides += MarkerGeometry.CORNERS;
        }
        for (ObjectMarker o : cell.objects()) {
            sum += sidesPx(cell, cameraFromWorld.compose(nominal.worldFromObjects().get(o.id())), o.sizeMm());
            sides += MarkerGeometry.CORNERS;
        }
        return sum / sides;
    }

    private static double sidesPx(Cell cell, RigidTransform cameraFromMarker, double sizeMm) {
        double[] corners = MarkerGeometry.cornersMm(cameraFromMarker, sizeMm);
        double[][] px = new double[MarkerGeometry.CORNERS][];
        double sum = 0;
        for (int k = 0; k < px.length; k++) {
            px[k] = cell.camera().project(corners[3 * k], corners[3 * k + 1], corners[3 * k + 2]);
            if (px[k] == null) {
                return Double.NaN;
            }
        }
        for (int k = 0; k < px.length; k++) {
            double[] next = px[(k + 1) % px.length];
            sum += Math.hypot(next[0] - px[k][0], next[1] - px[k][1]);
        }
        return sum;
    }
}
