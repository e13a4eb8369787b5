package org.cellgauge.internal.geometry;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

class DampedGaussNewtonTest {
    /** Rosenbrock's valley as residuals 10 (y - x²) and 1 - x: its only minimum is 0 at (1, 1). */
    private static final class Valley implements DampedGaussNewton.Problem {
        double x = -1.2;
        double y = 1;
        private double nextX;
        private double nextY;

        @Override
        public double linearise(double[] information, double[] gradient) {
            double[][] rows = {{-20 * x, 10}, {-1, 0}};
            double[] r = {10 * (y - x * x), 1 - x};
            for (int i = 0; i < 2; i++) {
                gradient[i] = rows[0][i] * r[0] + rows[1][i] * r[1];
                for (int j = 0; j < 2; j++) {
                    information[2 * i + j] = rows[0][i] * rows[0][j] + rows[1][i] * rows[1][j];
                }
            }
            return cost(x, y);
        }

        private static double cost(double x, double y) {
            return 0.5 * (100 * (y - x * x) * (y - x * x) + (1 - x) * (1 - x));
        }

        @Override
        public double at(double[] step) {
            nextX = x + step[0];
            nextY = y + step[1];
            return cost(nextX, nextY);
        }

        @Override
        public void accept() {
            x = nextX;
            y = nextY;
        }

        @Override
        public boolean isEnough(double squaredStds, double before, double after, boolean accepted) {
            return squaredStds < 1e-20;
        }
    }

    @ParameterizedTest
    @EnumSource(DampedGaussNewton.Damping.class)
    void findsTheEndOfACurvedValley(DampedGaussNewton.Damping damping) {
        Valley valley = new Valley();
        DampedGaussNewton solver = new DampedGaussNewton(2, damping, 100);
        assertEquals(0, solver.minimise(valley), 1e-16);
        assertEquals(1, valley.x, 1e-7);
        assertEquals(1, valley.y, 1e-7);
        assertFalse(solver.isSingular());
    }

    @Test
    void aStartWithoutACostIsLeftAsItIs() {
        Valley valley = new Valley();
        valley.x = Double.NaN;
        DampedGaussNewton solver = new DampedGaussNewton(2, DampedGaussNewton.Damping.TENFOLD, 100);
        assertTrue(Double.isNaN(solver.minimise(valley)));
        assertEquals(1, valley.y);
        assertTrue(solver.isSingular());
    }
}
