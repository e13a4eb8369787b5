package org.cellgauge.internal.survey;

import java.util.Arrays;
import org.cellgauge.internal.geometry.Cholesky;

/**
 * Normal equations of one photo: its own unknowns, what they have to do with those that all photos share, and the way
 * back to them once those are known; mutable, for inner loops.
 */
final class ViewEquations {
    private static final int ROWS = 8;

    final int locals;
    private final int shared;
    /** Information of its own unknowns, then its Cholesky factor L. */
    final double[] own;
    final double[] ownGradient;
    /** Rows: own unknowns; columns: shared ones. After elimination {@code L^-1} times that. */
    final double[] cross;
    /** Whether a shared unknown has to do with this photo. */
    private final boolean[] seen;
    private final int[] active;
    private int activeCount;
    private final double[] dense;
    private final double[] row;

    ViewEquations(int locals, int shared) {
        this.locals = locals;
        this.shared = shared;
        own = new double[locals * locals];
        ownGradient = new double[locals];
        cross = new double[locals * shared];
        seen = new boolean[shared];
        active = new int[shared];
        dense = new double[locals * shared];
        row = new double[shared];
    }

    void clear() {
        Arrays.fill(own, 0);
        Arrays.fill(ownGradient, 0);
        Arrays.fill(cross, 0);
        Arrays.fill(seen, false);
        activeCount = 0;
    }

    /** Adds the rows of one marker. */
    void add(double[] block, int[] columns, int count, double[] residual, int n, double[] information,
            double[] gradient) {
        for (int a = 0; a < count; a++) {
            int ca = columns[a];
            double g = 0;
            for (int i = 0; i < ROWS; i++) {
                g += block[i * count + a] * residual[i];
            }
            boolean ofAll = ca < n;
            if (ofAll) {
                gradient[ca] += g;
                if (!seen[ca]) {
                    seen[ca] = true;
                    active[activeCount++] = ca;
                }
            } else {
                ownGradient[ca - n] += g;
            }
            for (int b = 0; b <= a; b++) {
                int cb = columns[b];
                double h = 0;
                for (int i = 0; i < ROWS; i++) {
                    h += block[i * count + a] * block[i * count + b];
                }
                if (ofAll && cb < n) {
                    information[Math.max(ca, cb) * n + Math.min(ca, cb)] += h;
                } else if (!ofAll && cb >= n) {
                    own[Math.max(ca - n, cb - n) * locals + Math.min(ca - n, cb - n)] += h;
                } else {
                    int local = ofAll ? cb - n : ca - n;
                    cross[local * n + (ofAll ? ca : cb)] += h;
                }
            }
        }
    }

    /** Takes the photo's own unknowns out; false where they are not determined. */
    boolean eliminate(int n, double[] information, double[] gradient) {
        if (!Cholesky.factor(own, locals)) {
            return false;
        }
        Cholesky.solveLower(own, locals, ownGradient);
        for (int i = 0; i < locals; i++) {
            double pivot = own[i * locals + i];
            for (int k = 0; k < i; k++) {
                double f = own[i * locals + k];
                for (int s = 0; s < activeCount && f != 0; s++) {
                    cross[i * n + active[s]] -= f * cross[k * n + active[s]];
                }
            }
            for (int s = 0; s < activeCount; s++) {
                cross[i * n + active[s]] /= pivot;
            }
        }
        for (int s = 0; s < activeCount; s++) {
            int a = active[s];
            for (int i = 0; i < locals; i++) {
                gradient[a] -= cross[i * n + a] * ownGradient[i];
            }
        }
        // gathered, so that the innermost loop runs over neighbours: most of a survey's time is spent here
        Arrays.sort(active, 0, activeCount);
        for (int i = 0; i < locals; i++) {
            for (int s = 0; s < activeCount; s++) {
                dense[i * shared + s] = cross[i * n + active[s]];
            }
        }
        for (int s = 0; s < activeCount; s++) {
            Arrays.fill(row, 0, s + 1, 0);
            for (int i = 0; i < locals; i++) {
                double y = dense[i * shared + s];
                int from = i * shared;
                for (int t = 0; t <= s; t++) {
                    row[t] += y * dense[from + t];
                }
            }
            int to = active[s] * n;
            for (int t = 0; t <= s; t++) {
                information[to + active[t]] -= row[t];
            }
        }
        return true;
    }

    /**
     * The step of its own unknowns that goes with one of all others.
     *
     * @param step of the shared unknowns
     * @param withGradient whether towards the minimum; else only what follows from the others
     * @param noise standard normal numbers to add in units of its own deviations; may be all zeros
     * @param out receives the step from {@code at} on
     */
    void follow(double[] step, boolean withGradient, double[] noise, int noiseAt, double[] out, int at,
            double[] work) {
        for (int i = 0; i < locals; i++) {
            double s = noise[noiseAt + i] - (withGradient ? ownGradient[i] : 0);
            for (int a = 0; a < activeCount; a++) {
                s -= cross[i * shared + active[a]] * step[active[a]];
            }
            work[i] = s;
        }
        Cholesky.solveUpper(own, locals, work);
        System.arraycopy(work, 0, out, at, locals);
    }
}
