package org.cellgauge.internal.cell;

import java.math.BigDecimal;
import java.math.MathContext;
import java.math.RoundingMode;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.TreeMap;
import java.util.stream.Collectors;
import org.cellgauge.cell.Area;
import org.cellgauge.cell.CameraCalibration;
import org.cellgauge.cell.CameraRange;
import org.cellgauge.cell.Cell;
import org.cellgauge.cell.CellReader;
import org.cellgauge.cell.ObjectMarker;
import org.cellgauge.cell.Placement;
import org.cellgauge.cell.Planning;
import org.cellgauge.cell.PrintPrecision;
import org.cellgauge.cell.Reference;
import org.cellgauge.cell.Requirement;
import org.cellgauge.cell.SurveyedPlacement;
import org.cellgauge.geometry.RigidTransform;

/**
 * Writes cells as cell files (YAML, version 1) with the camera inline, so that one file says all of it.
 *
 * <p>{@link CellReader} reads back the same cell: sizes, positions, deviations and intrinsics digit by digit. So do
 * rotations and their deviations that were read from a file (psi and phi from -180 to 180, theta between -90 and 90
 * degrees, at most {@value #MAX_DECIMALS} decimals); others to the rounding of an angle.
 */
public final class CellWriter {
    /** Decimals of degrees tried, the fewest first: people write few of them. */
    private static final int MAX_DECIMALS = 12;

    private CellWriter() {
    }

    /**
     * The text of a cell file.
     *
     * @param cell what stands in the cell; what the reader refuses, such as a placement without any deviation, is
     *     written as it is
     * @param remarks lines of comment above it, without the sign of a comment; control characters become spaces
     * @return YAML, ended by a line feed
     */
    public static String text(Cell cell, List<String> remarks) {
        StringBuilder out = new StringBuilder();
        for (String remark : remarks) {
            out.append("# ").append(remark.replaceAll("[\\p{Cntrl}\u0085\u2028\u2029]", " ")).append('\n');
        }
        out.append("cellgauge: ").append(CellReader.VERSION).append('\n');
        out.append("camera:\n").append(camera(cell));
        // every marker states its own size and placement: what was common to them in the original is not known here
        out.append("markers: {family: ").append(cell.family().familyName());
        if (cell.family().isHalfTurned()) {
            out.append(", orientation: opencv");
        }
        print(out, "size_std_mm", cell.prints().sizeStdMm(), PrintPrecision.USUAL.sizeStdMm());
        print(out, "flatness_mm", cell.prints().flatnessMm(), PrintPrecision.USUAL.flatnessMm());
        print(out, "print_gain_std_mm", cell.prints().printGainStdMm(), PrintPrecision.USUAL.printGainStdMm());
        out.append("}\n");
        out.append("pixel_std_px: ").append(cell.pixelStdPx().isPresent()
                ? CameraWriter.number(cell.pixelStdPx().getAsDouble()) : "auto").append('\n');
        if (cell.toneCurve() != null) {
            out.append(CameraWriter.toneCurve(cell.toneCurve()));
        }
        out.append("references:\n");
        for (Reference reference : cell.references()) {
            out.append("  ").append(reference.id()).append(":\n");
            out.append("    position_mm: ").append(numbers(reference.worldFromMarker().translationMm())).append('\n');
            out.append("    rotation_deg: ").append(rotation(reference.worldFromMarker())).append('\n');
            Placement placement = reference.placement();
            out.append("    placement: {std_mm: ").append(numbers(placement.stdMm(0), placement.stdMm(1),
                    placement.stdMm(2))).append(", std_deg: ").append(degrees(placement.stdRad())).append("}\n");
            out.append("    size_mm: ").append(CameraWriter.number(reference.sizeMm())).append('\n');
        }
        if (!cell.objects().isEmpty()) {
            out.append("objects:\n");
            for (ObjectMarker object : cell.objects()) {
                out.append("  ").append(object.id()).append(": {size_mm: ")
                        .append(CameraWriter.number(object.sizeMm()));
                double[] grip = object.gripMm();
                if (grip != null) {
                    out.append(", grip_mm: ").append(numbers(grip));
                }
                Requirement own = cell.target().own().get(object.id());
                out.append(own == null ? "" : ", target: " + requirement(own))
                        .append(object.moves() ? ", moves: true}\n" : "}\n");
            }
        }
        SurveyedPlacement surveyed = cell.joint().surveyed();
        if (surveyed != null) {
            surveyed(surveyed, out);
        }
        if (cell.target().general().isAny()) {
            out.append("target: ").append(requirement(cell.target().general())).append('\n');
        }
        planning(cell.planning(), out);
        return out.toString();
    }

    private static String camera(Cell cell) {
        CameraCalibration calibration = cell.calibration();
        return CameraWriter.text(cell.camera(), "  ") + (calibration == null ? ""
                : CameraExport.calibration(calibration).replaceAll("(?m)^(?=.)", "  "))
                + (cell.focusDistanceM().isPresent()
                        ? "  " + CameraWriter.focusDistance(cell.focusDistanceM().getAsDouble()) : "");
    }

    private static void surveyed(SurveyedPlacement surveyed, StringBuilder out) {
        int n = SurveyedPlacement.ERRORS * surveyed.ids().size();
        double[] covariance = surveyed.covariance();
        out.append("surveyed:\n  references: ").append(surveyed.ids()).append("\n  covariance:\n");
        for (int i = 0; i < n; i++) {
            out.append("  - [");
            for (int j = 0; j < n; j++) {
                // nine digits keep a covariance of references that stand to each other better than in the world
                out.append(j == 0 ? "" : ", ").append(CameraWriter.number(
                        new BigDecimal(covariance[i * n + j]).round(new MathContext(9)).doubleValue()));
            }
            out.append("]\n");
        }
    }

    private static void planning(Planning plan, StringBuilder out) {
        if (plan.equals(Planning.NONE)) {
            return;
        }
        out.append("plan:\n");
        RigidTransform pose = plan.worldFromCamera();
        if (pose != null) {
            String at = numbers(pose.translationMm());
            out.append("  camera_pose: ").append(at, 0, at.length() - 1).append(", ")
                    .append(rotation(pose).substring(1)).append('\n');
        }
        CameraRange range = plan.cameraRange();
        if (!range.equals(CameraRange.NONE)) {
            out.append("  camera_range: {position_mm: ").append(numbers(range.xMm(), range.yMm(), range.zMm()))
                    .append(", turn_deg: ").append(CameraWriter.number(range.turnDeg())).append("}\n");
        }
        List<String> regions = new ArrayList<>();
        new TreeMap<>(plan.regions()).forEach((id, area) -> regions.add(id + ": " + area(area)));
        list(out, "regions_mm", '{', regions, '}');
        list(out, "free_mm", '[', plan.free().stream().map(CellWriter::area).collect(Collectors.toList()), ']');
        list(out, "walls_mm", '[', plan.walls().stream().map(w -> numbers(w.xFromMm(), w.yFromMm(), w.xToMm(),
                w.yToMm(), w.heightMm())).collect(Collectors.toList()), ']');
        if (plan.maxHeightMm().isPresent()) {
            out.append("  max_height_mm: ").append(CameraWriter.number(plan.maxHeightMm().getAsDouble())).append('\n');
        }
        List<String> costs = new ArrayList<>();
        new TreeMap<>(plan.costs()).forEach((kind, cost) -> costs.add(kind.code() + ": " + CameraWriter.number(cost)));
        list(out, "costs", '{', costs, '}');
    }

    private static String area(Area area) {
        return numbers(area.xLowMm(), area.yLowMm(), area.xHighMm(), area.yHighMm());
    }

    private static void list(StringBuilder out, String key, char open, List<String> items, char close) {
        if (!items.isEmpty()) {
            out.append("  ").append(key).append(": ").append(open).append(String.join(", ", items)).append(close)
                    .append('\n');
        }
    }

    private static String requirement(Requirement asked) {
        List<String> parts = new ArrayList<>();
        limits(parts, "std_mm", asked.stdMm());
        limits(parts, "tolerance_mm", asked.toleranceMm());
        limits(parts, "distance_mm", Requirement.Axes.all(asked.distanceMm()));
        limits(parts, "tolerance_deg", Requirement.Axes.all(asked.toleranceDeg()));
        if (asked.asksForProbability()) {
            parts.add("probability: " + CameraWriter.number(asked.probability()));
        }
        return "{" + String.join(", ", parts) + "}";
    }

    private static void limits(List<String> parts, String key, Requirement.Axes limits) {
        if (limits.isAny()) {
            parts.add(key + ": " + (limits.isUniform() ? CameraWriter.number(limits.x())
                    : numbers(limits.x(), limits.y(), limits.z())));
        }
    }

    private static void print(StringBuilder out, String key, double stdMm, double usualMm) {
        if (stdMm != usualMm) {
            out.append(", ").append(key).append(": ").append(CameraWriter.number(stdMm));
        }
    }

    private static String numbers(double... values) {
        StringBuilder out = new StringBuilder("[");
        for (int i = 0; i < values.length; i++) {
            out.append(i == 0 ? "" : ", ").append(CameraWriter.number(values[i]));
        }
        return out.append(']').toString();
    }

    /** The angles of a rotation in degrees: the shortest that give the same matrix, or else all their digits. */
    private static String rotation(RigidTransform worldFromMarker) {
        double[] rad = worldFromMarker.eulerRad();
        double[] exact = worldFromMarker.rotation();
        double[] deg = new double[3];
        for (int decimals = 0; decimals <= MAX_DECIMALS; decimals++) {
            for (int i = 0; i < 3; i++) {
                deg[i] = rounded(Math.toDegrees(rad[i]), decimals);
            }
            double[] again = RigidTransform.ofEuler(0, 0, 0, Math.toRadians(deg[0]), Math.toRadians(deg[1]),
                    Math.toRadians(deg[2])).rotation();
            if (equal(again, exact)) {
                return numbers(deg);
            }
        }
        return numbers(Arrays.stream(rad).map(Math::toDegrees).toArray());
    }

    private static boolean equal(double[] a, double[] b) {
        for (int i = 0; i < a.length; i++) {
            // 0 and -0 are the same here
            if (a[i] != b[i]) {
                return false;
            }
        }
        return true;
    }

    private static String degrees(double rad) {
        for (int decimals = 0; decimals <= MAX_DECIMALS; decimals++) {
            double deg = rounded(Math.toDegrees(rad), decimals);
            if (Math.toRadians(deg) == rad) {
                return CameraWriter.number(deg);
            }
        }
        return CameraWriter.number(Math.toDegrees(rad));
    }

    private static double rounded(double value, int decimals) {
        return new BigDecimal(value).setScale(decimals, RoundingMode.HALF_EVEN).doubleValue();
    }
}
