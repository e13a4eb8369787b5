package org.cellgauge.cli;

import org.cellgauge.cell.Cell;
import org.cellgauge.cell.ObjectMarker;
import org.cellgauge.cell.Reference;
import org.cellgauge.desktop.render.Sensor;
import org.cellgauge.internal.vision.MarkerPattern;
import org.cellgauge.light.ToneCurve;
import picocli.CommandLine;
import picocli.CommandLine.ParameterException;

/** What the options of commands that render photos mean. */
final class PhotoOptions {
    private PhotoOptions() {
    }

    /**
     * The tone curve of {@code --tone-curve} and {@code --gamma}.
     *
     * @param words as {@link ToneCurve#of}, or null
     * @param gamma its short form, or null
     * @return the curve; linear if neither is given
     * @throws IllegalArgumentException if the words name no curve or both are given
     */
    static ToneCurve toneCurve(String words, Double gamma) {
        if (words != null && gamma != null) {
            throw new IllegalArgumentException("--gamma is short for --tone-curve: leave out one of them");
        }
        try {
            return words != null ? ToneCurve.of(words) : gamma != null ? ToneCurve.gamma(gamma) : ToneCurve.LINEAR;
        } catch (IllegalArgumentException e) {
            throw new IllegalArgumentException((words != null ? "--tone-curve: " : "--gamma: ") + e.getMessage(), e);
        }
    }

    /**
     * Gamma of a power curve.
     *
     * @param curve a curve grey = light^(1/gamma)
     * @return gamma
     */
    static double gamma(ToneCurve curve) {
        return curve.isLinear() ? 1 : Double.parseDouble(curve.words().substring("gamma ".length()));
    }

    /**
     * A sensor with the unsharp mask of {@code --unsharp}.
     *
     * @param sensor one without
     * @param text AMOUNT,RADIUS_PX, or null for none
     * @return the sensor
     * @throws IllegalArgumentException if the text is no such pair or out of range
     */
    static Sensor unsharp(Sensor sensor, String text) {
        if (text == null) {
            return sensor;
        }
        String[] parts = text.split(",", -1);
        try {
            if (parts.length == 2) {
                return sensor.withUnsharp(Double.parseDouble(parts[0].trim()), Double.parseDouble(parts[1].trim()));
            }
        } catch (NumberFormatException e) {
            // said below
        }
        throw new IllegalArgumentException("--unsharp: '" + text + "' is not AMOUNT,RADIUS_PX, as in 0.6,1.2");
    }

    /**
     * Requires that ink that spreads so far leaves something of every cell.
     *
     * @param command for the message
     * @param cell the cell
     * @param printGainMm by how much dark regions grow on all sides, mm
     * @throws ParameterException if it does not
     */
    static void requirePrintable(CommandLine command, Cell cell, double printGainMm) {
        if (printGainMm == 0) {
            return;
        }
        double leastMm = Double.POSITIVE_INFINITY;
        for (Reference r : cell.references()) {
            leastMm = Math.min(leastMm, r.sizeMm() / MarkerPattern.of(cell.family(), r.id()).cells());
        }
        for (ObjectMarker o : cell.objects()) {
            leastMm = Math.min(leastMm, o.sizeMm() / MarkerPattern.of(cell.family(), o.id()).cells());
        }
        if (!(Math.abs(printGainMm) < leastMm / 2)) {
            throw new ParameterException(command, "--print-gain: must be below half a cell of every marker, "
                    + leastMm / 2 + " mm here, not " + printGainMm + " mm");
        }
    }
}
