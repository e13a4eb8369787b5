package org.cellgauge.cli;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import org.cellgauge.cell.Cell;
import org.cellgauge.cell.MarkerFamily;
import org.cellgauge.cell.ObjectMarker;
import org.cellgauge.cell.Reference;
import org.cellgauge.desktop.render.Sensor;
import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.light.ToneCurve;

/** The rows of {@code validate --photos --grid}. */
final class PhotoGrid {
    private static final double[] BLURS_PX = {0.3, 0.7, 1.2, 2.0};
    private static final int[] MARKERS_PX = {24, 32, 48};
    private static final double UNSHARP_AMOUNT = 0.6;
    private static final double UNSHARP_RADIUS_PX = 1.0;
    private static final double PRINT_GAIN_MM = 0.2;
    private static final double GRADIENT = 0.6;
    private static final double VIGNETTING = 0.4;

    private PhotoGrid() {
    }

    /**
     * One row.
     *
     * @param curve word for the tone curve
     * @param blurPx blur
     * @param markerPx average side of the markers
     * @param exposure which exposure
     * @param other what else is special, or empty
     * @param sensor how photos are taken
     * @param jpegQuality 0: no JPEG
     * @param printGainMm gain of the prints
     * @param aprilTags whether markers are of {@code apriltag-36h11} in place of the cell's family
     */
    record Row(String curve, double blurPx, int markerPx, StudyTable.Exposure exposure, String other, Sensor sensor,
            int jpegQuality, double printGainMm, boolean aprilTags) {
        /** First cells of the row, by which it is found again in a file. */
        List<String> cells() {
            return List.of(curve, String.valueOf(blurPx), String.valueOf(markerPx), exposure.word(), other);
        }

        /** What {@code --only} looks at. */
        String name() {
            return (curve.replace(" ", "") + " blur" + blurPx + " " + markerPx + "px " + exposure.word() + " " + other)
                    .toLowerCase(Locale.ROOT);
        }
    }

    /** Titles of {@link Row#cells}. */
    static List<String> titles() {
        return List.of("tone curve", "blur, px", "marker, px", "exposure", "besides");
    }

    /**
     * All rows.
     *
     * @param base noise of the sensor
     * @return the table of tone curve, blur, marker and exposure, then the special ones
     */
    static List<Row> rows(Sensor base) {
        Map<String, Sensor> curves = new LinkedHashMap<>();
        curves.put("linear", base.withToneCurve(ToneCurve.LINEAR));
        curves.put("sRGB", base.withToneCurve(ToneCurve.SRGB));
        curves.put("gamma 1.8", base.withGamma(1.8));
        curves.put("gamma 2.2", base.withGamma(2.2));
        curves.put("sRGB, unsharp", base.withToneCurve(ToneCurve.SRGB).withUnsharp(UNSHARP_AMOUNT,
                UNSHARP_RADIUS_PX));
        List<Row> rows = new ArrayList<>();
        curves.forEach((word, sensor) -> {
            for (double blur : BLURS_PX) {
                for (int marker : MARKERS_PX) {
                    for (StudyTable.Exposure exposure : StudyTable.Exposure.values()) {
                        rows.add(new Row(word, blur, marker, exposure, "",
                                sensor.withBlurPx(blur).withExposure(exposure.factor), 0, 0, false));
                    }
                }
            }
        });
        Sensor usual = curves.get("sRGB").withBlurPx(StudyTable.BLUR_PX.usual());
        for (int quality : new int[] {95, 85, 70}) {
            rows.add(special("JPEG " + quality, usual, 32, quality, 0, false));
        }
        rows.add(special("uneven light", usual.withUnevenLight(VIGNETTING, GRADIENT), 32, 0, 0, false));
        rows.add(special("print gain " + PRINT_GAIN_MM + " mm", usual, 32, 0, PRINT_GAIN_MM, false));
        rows.add(special("apriltag-36h11", usual, 32, 0, 0, true));
        rows.add(special("apriltag-36h11", usual, 48, 0, 0, true));
        return rows;
    }

    /**
     * Which row of the whole table one is.
     *
     * @param base noise of the sensor
     * @param row one of {@link #rows}
     * @return from 0 on
     */
    static int number(Sensor base, Row row) {
        return rows(base).stream().map(Row::cells).toList().indexOf(row.cells());
    }

    private static Row special(String other, Sensor sensor, int markerPx, int jpegQuality, double printGainMm,
            boolean aprilTags) {
        return new Row("sRGB", sensor.blurPx(), markerPx, StudyTable.Exposure.NORMAL, other, sensor, jpegQuality,
                printGainMm, aprilTags);
    }

    /** The same cell with AprilTags of the same sizes, numbered from 0 in the order of the file. */
    static Cell withAprilTags(Cell cell) {
        List<Reference> references = new ArrayList<>();
        List<ObjectMarker> objects = new ArrayList<>();
        int id = 0;
        for (Reference r : cell.references()) {
            references.add(new Reference(id++, r.sizeMm(), r.worldFromMarker(), r.placement()));
        }
        for (ObjectMarker o : cell.objects()) {
            objects.add(new ObjectMarker(id++, o.sizeMm(), o.gripMm()));
        }
        return new Cell(cell.camera(), MarkerFamily.of("apriltag-36h11"), references, objects, cell.pixelStdPx(),
                cell.targetStdMm());
    }

    /** Poses of the objects of {@link #withAprilTags}. */
    static Map<Integer, RigidTransform> renumbered(Cell cell, Map<Integer, RigidTransform> poses) {
        Map<Integer, RigidTransform> renumbered = new LinkedHashMap<>();
        int id = cell.references().size();
        for (ObjectMarker o : cell.objects()) {
            renumbered.put(id++, poses.get(o.id()));
        }
        return renumbered;
    }
}
