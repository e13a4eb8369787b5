package org.cellgauge.geometry;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import org.cellgauge.internal.geometry.MarkerGeometry;
import org.ejml.simple.SimpleMatrix;
import org.junit.jupiter.api.Test;

class RigidTransformTest {
    private static final RigidTransform A = RigidTransform.ofEuler(418, 106, 1070, 3.08, 0.10, 0.02);
    private static final RigidTransform B = RigidTransform.ofRotationVector(new double[] {0.3, -1.2, 0.5},
            new double[] {-20, 7, 300});

    private static SimpleMatrix homogeneous(RigidTransform t) {
        double[] r = t.rotation();
        double[] c = t.translationMm();
        return new SimpleMatrix(new double[][] {{r[0], r[1], r[2], c[0]}, {r[3], r[4], r[5], c[1]},
            {r[6], r[7], r[8], c[2]}, {0, 0, 0, 1}});
    }

    private static void assertSame(SimpleMatrix expected, RigidTransform actual) {
        assertArrayEquals(expected.getDDRM().data, homogeneous(actual).getDDRM().data, 1e-11);
    }

    @Test
    void compositionAndInverseAreThoseOfHomogeneousMatrices() {
        assertSame(homogeneous(A).mult(homogeneous(B)), A.compose(B));
        assertSame(homogeneous(A).invert(), A.inverse());
        assertSame(SimpleMatrix.identity(4), A.compose(A.inverse()));
        assertSame(homogeneous(B), RigidTransform.IDENTITY.compose(B));
    }

    @Test
    void pointsMoveAsByTheHomogeneousMatrix() {
        SimpleMatrix moved = homogeneous(A).mult(new SimpleMatrix(new double[][] {{1}, {-2}, {30}, {1}}));
        double[] expected = {moved.get(0), moved.get(1), moved.get(2)};
        assertArrayEquals(expected, A.apply(1, -2, 30), 1e-11);
        assertArrayEquals(expected, A.apply(new double[] {1, -2, 30}), 0);
    }

    @Test
    void cameraOfTheThesisLooksDownOnItsScene() {
        // psi near pi: the camera's z axis points to minus the world's z, its y axis to minus the world's y
        double[] axis = A.rotation();
        assertEquals(Math.cos(0.10) * Math.cos(3.08), axis[8], 1e-15);
        double[] inCamera = A.inverse().apply(418, 106, 0);
        assertEquals(1070 * -axis[8], inCamera[2], 1e-9);
        assertArrayEquals(new double[] {3.08, 0.10, 0.02}, A.eulerRad(), 1e-15);
    }

    @Test
    void rotationVectorAndAngleOfATurn() {
        assertArrayEquals(new double[] {0.3, -1.2, 0.5}, B.rotationVectorRad(), 1e-14);
        RigidTransform turned = RigidTransform.ofRotationVector(new double[] {0, 0, 0.7}, new double[3]).compose(A);
        assertEquals(0.7, turned.angleRadTo(A), 1e-14);
        assertEquals(0, A.angleRadTo(A), 1e-15);
    }

    @Test
    void whatIsNoRigidTransformIsRefused() {
        double[] zero = new double[3];
        double[] unit = {1, 0, 0, 0, 1, 0, 0, 0, 1};
        double[][] bad = {{1, 0, 0, 0, 1, 0, 0, 0, -1}, {0, 1, 0, 1, 0, 0, 0, 0, 1}, {1.001, 0, 0, 0, 1, 0, 0, 0, 1},
            {1, 0.001, 0, 0, 1, 0, 0, 0, 1}, {Double.NaN, 0, 0, 0, 1, 0, 0, 0, 1},
            {1, 0, 0, 0, Double.POSITIVE_INFINITY, 0, 0, 0, 1}, new double[9], new double[8]};
        for (double[] r : bad) {
            assertThrows(IllegalArgumentException.class, () -> RigidTransform.of(r, zero));
        }
        assertThrows(IllegalArgumentException.class, () -> RigidTransform.of(unit, new double[2]));
        for (double v : new double[] {Double.NaN, Double.NEGATIVE_INFINITY}) {
            assertThrows(IllegalArgumentException.class, () -> RigidTransform.of(unit, new double[] {0, v, 0}));
            assertThrows(IllegalArgumentException.class, () -> RigidTransform.ofEuler(0, 0, 0, v, 0, 0));
            assertThrows(IllegalArgumentException.class,
                    () -> RigidTransform.ofRotationVector(new double[] {v, 0, 0}, zero));
        }
    }

    @Test
    void arraysGivenAndTakenAreCopies() {
        double[] r = {1, 0, 0, 0, 1, 0, 0, 0, 1};
        double[] t = {1, 2, 3};
        RigidTransform transform = RigidTransform.of(r, t);
        r[0] = 5;
        t[0] = 5;
        transform.rotation()[0] = 7;
        transform.translationMm()[1] = 7;
        assertArrayEquals(new double[] {1, 2, 3}, transform.translationMm(), 0);
        assertEquals(1, transform.rotation()[0], 0);
    }

    @Test
    void cornersOfAMarkerRunFromTopLeftClockwiseInItsOwnFrame() {
        double h = 23.5;
        assertArrayEquals(new double[] {-h, h, 0, h, h, 0, h, -h, 0, -h, -h, 0}, MarkerGeometry.cornersMm(47), 0);
        // a marker turned by 90 degrees about z at (100, 0, 5): its x axis is the world's y
        double[] corners = MarkerGeometry.cornersMm(RigidTransform.ofEuler(100, 0, 5, 0, 0, Math.PI / 2), 47);
        assertArrayEquals(new double[] {100 - h, -h, 5, 100 - h, h, 5, 100 + h, h, 5, 100 + h, -h, 5}, corners, 1e-13);
    }
}
