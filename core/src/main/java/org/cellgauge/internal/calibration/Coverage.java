package org.cellgauge.internal.calibration;

import java.util.List;

/** Which parts of the image the target covered in some photo. */
final class Coverage {
    static final int COLUMNS = 12;
    static final int ROWS = 9;

    private final int widthPx;
    private final int heightPx;
    private final boolean[] covered = new boolean[COLUMNS * ROWS];

    Coverage(List<TargetPhoto> photos, int widthPx, int heightPx) {
        this.widthPx = widthPx;
        this.heightPx = heightPx;
        for (TargetPhoto photo : photos) {
            for (int i = 0; i < photo.count; i++) {
                if (photo.active[i]) {
                    // a point tells of its neighbourhood too
                    for (int k = 0; k < 9; k++) {
                        int cell = cell(photo.uv[2 * i] + (k % 3 - 1) * widthPx / (2.0 * COLUMNS),
                                photo.uv[2 * i + 1] + (k / 3 - 1) * heightPx / (2.0 * ROWS));
                        if (cell >= 0) {
                            covered[cell] = true;
                        }
                    }
                }
            }
        }
    }

    private int cell(double u, double v) {
        int column = (int) Math.floor(u * COLUMNS / widthPx);
        int row = (int) Math.floor(v * ROWS / heightPx);
        return column < 0 || column >= COLUMNS || row < 0 || row >= ROWS ? -1 : row * COLUMNS + column;
    }

    boolean covers(double u, double v) {
        int cell = cell(u, v);
        return cell >= 0 && covered[cell];
    }

    double share() {
        int n = 0;
        for (boolean c : covered) {
            n += c ? 1 : 0;
        }
        return n / (double) covered.length;
    }

    /** The ninth of the image, row by row from the upper left, of which least is covered. */
    int leastCoveredNinth() {
        int[] open = new int[9];
        for (int k = 0; k < covered.length; k++) {
            if (!covered[k]) {
                open[k / COLUMNS * 3 / ROWS * 3 + k % COLUMNS * 3 / COLUMNS]++;
            }
        }
        int most = 0;
        for (int k = 1; k < 9; k++) {
            most = open[k] > open[most] ? k : most;
        }
        return most;
    }
}
