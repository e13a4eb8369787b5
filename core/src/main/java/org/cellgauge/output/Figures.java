package org.cellgauge.output;

/** Numbers as files hold them: what is not finite is no number there. */
final class Figures {
    private Figures() {
    }

    static double finite(double value) {
        return Double.isFinite(value) ? value : Double.NaN;
    }

    static double[] finite(double[] values) {
        return ownFinite(values.clone());
    }

    /** The same in an array that is the caller's own. */
    static double[] ownFinite(double[] values) {
        for (int i = 0; i < values.length; i++) {
            values[i] = finite(values[i]);
        }
        return values;
    }

    static double[][] ownFinite(double[][] rows) {
        for (double[] row : rows) {
            ownFinite(row);
        }
        return rows;
    }

    static double[][] finite(double[][] rows) {
        double[][] out = new double[rows.length][];
        for (int i = 0; i < out.length; i++) {
            out[i] = finite(rows[i]);
        }
        return out;
    }

    /** Roots of a covariance's diagonal. */
    static double[] std(double[][] covariance) {
        double[] std = new double[covariance.length];
        for (int i = 0; i < std.length; i++) {
            std[i] = Math.sqrt(covariance[i][i]);
        }
        return std;
    }
}
