package org.cellgauge.internal.geometry;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.ejml.dense.row.RandomMatrices_DDRM;
import org.ejml.simple.SimpleMatrix;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class CholeskyTest {
    private static SimpleMatrix positiveDefinite(int n) {
        return SimpleMatrix.wrap(RandomMatrices_DDRM.symmetricPosDef(n, new java.util.Random(n)));
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 2, 6, 8, 11})
    void factorSolvesAndInvertsAsEjmlDoes(int n) {
        SimpleMatrix a = positiveDefinite(n);
        double[] l = a.getDDRM().data.clone();
        assertTrue(Cholesky.factor(l, n));
        SimpleMatrix lower = new SimpleMatrix(n, n, true, l.clone());
        assertArrayEquals(a.getDDRM().data, lower.mult(lower.transpose()).getDDRM().data, 1e-12);
        for (int i = 0; i < n; i++) {
            for (int j = i + 1; j < n; j++) {
                assertEquals(0, l[i * n + j], 0);
            }
        }
        assertEquals(0.5 * Math.log(a.determinant()), Cholesky.halfLogDeterminant(l, n), 1e-11);

        double[] x = new double[n];
        SimpleMatrix b = new SimpleMatrix(n, 1);
        for (int i = 0; i < n; i++) {
            b.set(i, i - 1.5);
            x[i] = i - 1.5;
        }
        Cholesky.solveLower(l, n, x);
        assertArrayEquals(lower.solve(b).getDDRM().data, x, 1e-10);
        Cholesky.solveUpper(l, n, x);
        assertArrayEquals(a.solve(b).getDDRM().data, x, 1e-10);

        double[] k = new double[n * n];
        java.util.Arrays.fill(k, 99);
        Cholesky.invertLower(l, n, k);
        assertArrayEquals(lower.invert().getDDRM().data, k, 1e-10);
        double[] before = a.getDDRM().data.clone();
        double[] inverse = Cholesky.inverse(a.getDDRM().data, n);
        assertNotNull(inverse);
        assertArrayEquals(a.invert().getDDRM().data, inverse, 1e-9);
        assertArrayEquals(before, a.getDDRM().data, 0);
    }

    @Test
    void matricesThatAreNotPositiveDefiniteAreRefused() {
        double[][] bad = {{1, 2, 2, 1}, {0, 0, 0, 1}, {1, 0, 0, -1}, {Double.NaN, 0, 0, 1}, {1, 0, 0, Double.NaN},
            {1, 0, Double.NaN, 1}, {Double.POSITIVE_INFINITY, 0, 0, 1}, {1, 1, 1, 1}};
        for (double[] a : bad) {
            assertNull(Cholesky.inverse(a, 2));
            assertFalse(Cholesky.factor(a.clone(), 2));
        }
    }
}
