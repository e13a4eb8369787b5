package org.cellgauge.desktop;

import org.cellgauge.calibration.CalibrationResult;

/** A calibration as tables for a terminal. */
public final class CalibrationText {
    private CalibrationText() {
    }

    /**
     * All that people read first.
     *
     * @param result a calibration
     * @return lines
     */
    public static String of(CalibrationResult result) {
        CalibrationResult.Figures f = result.figures();
        StringBuilder out = new StringBuilder();
        out.append("lens ").append(result.lens()).append(", ").append(result.photos().size()).append(" photos, ")
                .append(f.points()).append(" corners, reprojection error ").append(CheckText.fixed(f.rmsPx(), 3))
                .append(" px rms, noise of a coordinate ").append(CheckText.fixed(f.noisePx(), 3)).append(" px\n");
        TextTable table = new TextTable(1);
        table.row("  parameter", "value", "std");
        result.parameters().forEach(p -> table.row("  " + p.name(), value(p.value()), value(p.std())));
        result.board().forEach(p -> table.row("  board " + p.name(), value(p.value()), value(p.std())));
        out.append(table.text(""));
        out.append("field of view ").append(CheckText.fixed(f.horizontalDeg(), 1)).append(" x ")
                .append(CheckText.fixed(f.verticalDeg(), 1)).append(" deg, ")
                .append(CheckText.fixed(100 * f.coveredShare(), 0)).append(" % of the image covered\n");
        out.append("odd against even photos: ").append(Double.isNaN(f.crossRatio()) ? "too few photos"
                : CheckText.fixed(f.crossRatio(), 1) + " times the stated deviation (up to 1 is good, beyond 2 is not)")
                .append('\n');
        out.append("projection, px").append(" (and mm at ").append(CheckText.fixed(f.distanceMm(), 0))
                .append(" mm): ").append(projection(result)).append('\n');
        if (!result.ladder().isEmpty()) {
            TextTable ladder = new TextTable(1);
            ladder.row("  lens", "unknowns", "error in photos held out, px", "weight, %");
            result.ladder().forEach(t -> ladder.row("  " + t.lens(), String.valueOf(t.unknowns()),
                    CheckText.fixed(t.heldOutRmsPx(), 4), CheckText.fixed(100 * t.weight(), 0)));
            out.append(ladder.text(""));
        }
        return out.toString();
    }

    private static String projection(CalibrationResult result) {
        double[] std = result.places().stream().mapToDouble(CalibrationResult.Place::stdPx)
                .filter(Double::isFinite).sorted().toArray();
        double focal = result.parameters().get(0).value();
        double mm = result.figures().distanceMm() / focal;
        double median = std[std.length / 2];
        double worst = std[std.length - 1];
        return "std " + CheckText.fixed(median, 3) + " (" + CheckText.fixed(median * mm, 3) + ") in half of the image, "
                + CheckText.fixed(worst, 3) + " (" + CheckText.fixed(worst * mm, 3) + ") at worst";
    }

    /**
     * A number with five digits that count.
     *
     * @param value any
     * @return in words that are the same whatever the machine's language
     */
    public static String value(double value) {
        double size = Math.abs(value);
        int decimals = size == 0 ? 0 : (int) Math.max(0, Math.min(8, 4 - Math.floor(Math.log10(size))));
        return CheckText.fixed(value, decimals);
    }
}
