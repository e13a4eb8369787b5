package org.cellgauge.geometry;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.HashSet;
import java.util.List;
import java.util.stream.Stream;
import org.apache.commons.math3.random.RandomGenerator;
import org.apache.commons.math3.random.Well19937c;
import org.cellgauge.Allocated;
import org.cellgauge.internal.geometry.Lenses;
import org.junit.jupiter.api.Named;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** What {@link Lens} says of every lens. A new one is held to it by a line in {@link #lenses()}. */
class LensContractTest {
    private static final int POINTS = 200;

    /** A lens with values, and how far off its axis points are drawn. */
    private static final class Case {
        final Lens lens;
        final double[] values;
        final double widestRad;

        Case(Lens lens, double widestRad, double... values) {
            this.lens = lens;
            this.values = values;
            this.widestRad = widestRad;
        }

        /** A point up to the widest angle off the axis, some metres away. */
        double[] point(RandomGenerator random) {
            double t = widestRad * Math.sqrt(random.nextDouble());
            double phi = 2 * Math.PI * random.nextDouble();
            double d = 300 + 2000 * random.nextDouble();
            return new double[] {d * Math.sin(t) * Math.cos(phi), d * Math.sin(t) * Math.sin(phi), d * Math.cos(t)};
        }

        double[] project(double[] values, double[] p) {
            double[] uv = new double[2];
            assertTrue(lens.project(values, p[0], p[1], p[2], uv, 0));
            return uv;
        }
    }

    static Stream<Named<Case>> lenses() {
        return Stream.of(
                Named.of("ideal pinhole", new Case(BrownLens.MODEL, 0.9, 581, 590, 640.5, 359.5, 0, 0, 0, 0, 0, 0)),
                Named.of("skewed pinhole", new Case(BrownLens.MODEL, 0.9, 581, 590, 640.5, 359.5, 3, 0, 0, 0, 0, 0)),
                Named.of("Brown", new Case(BrownLens.MODEL, 0.7, 581, 590, 640.5, 359.5, 3, -0.3, 0.12, -0.02, 0.01,
                        -0.02)),
                Named.of("equidistant fisheye", new Case(KannalaBrandtLens.MODEL, 3, 300, 310, 640.5, 480.5, 0, 0, 0,
                        0, 0)),
                Named.of("fisheye", new Case(KannalaBrandtLens.MODEL, 1.7, 286, 287, 424, 400, 0.5, -0.008, 0.043,
                        -0.0399, 0.0069)),
                Named.of("strong fisheye", new Case(KannalaBrandtLens.MODEL, 1.2, 400, 390, 640, 480, -2, -0.15, 0.02,
                        -0.01, 0.001)),
                Named.of("rational", new Case(RationalLens.MODEL, 0.8, 605, 606, 640.5, 366.5, 1, 0.52, -2.4, 1.5, 0.4,
                        -2.3, 1.42, 0.0009, -0.0003, 0, 0, 0, 0)),
                Named.of("thin prism", new Case(RationalLens.MODEL, 0.6, 581, 590, 640.5, 359.5, 0, -0.3, 0.12, -0.02,
                        0.05, 0.02, 0.01, 0.003, -0.002, 0.006, -0.004, -0.005, 0.003)));
    }

    @ParameterizedTest
    @MethodSource("lenses")
    void parametersHaveNamesThatBeginWithTheFiveOfEveryCamera(Case c) {
        List<String> names = c.lens.parameterNames();
        assertEquals(Arrays.asList("fx_px", "fy_px", "cx_px", "cy_px", "skew_px"), names.subList(0, 5));
        assertEquals(c.lens.parameterCount(), names.size());
        assertEquals(names.size(), new HashSet<>(names).size(), "no name twice");
        assertThrows(UnsupportedOperationException.class, () -> names.set(0, "x"));
        // the axis goes to the principal point, and the five mean what they say: the image is linear in them
        double[] p = c.point(new Well19937c(1));
        assertArrayEquals(new double[] {c.values[2], c.values[3]}, c.project(c.values, new double[] {0, 0, 500}), 0);
        double[] plain = c.values.clone();
        System.arraycopy(new double[] {1, 1, 0, 0, 0}, 0, plain, 0, 5);
        double[] d = c.project(plain, p);
        assertArrayEquals(new double[] {c.values[0] * d[0] + c.values[4] * d[1] + c.values[2],
            c.values[1] * d[1] + c.values[3]}, c.project(c.values, p), 1e-9);
    }

    @ParameterizedTest
    @MethodSource("lenses")
    void derivativesAreThoseOfTheProjection(Case c) {
        RandomGenerator random = new Well19937c(2);
        int n = c.lens.parameterCount();
        double[] uv = new double[2];
        double[] byPoint = new double[6];
        double[] alone = new double[6];
        double[] byParameters = new double[2 * n];
        for (int k = 0; k < POINTS; k++) {
            double[] p = k == 0 ? new double[] {0, 0, 700} : c.point(random);
            double distance = Math.sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]);
            assertTrue(c.lens.projectWithDerivatives(c.values, p[0], p[1], p[2], uv, byPoint, byParameters));
            assertArrayEquals(c.project(c.values, p), uv, 1e-9);
            assertTrue(c.lens.projectWithDerivatives(c.values, p[0], p[1], p[2], uv, alone, null));
            assertArrayEquals(byPoint, alone, 0);
            for (int i = 0; i < 3; i++) {
                // the step's third-order error is some 1e-8 of the derivative, rounding 1e-9
                double h = 1e-4 * distance;
                double[] up = p.clone();
                double[] down = p.clone();
                up[i] += h;
                down[i] -= h;
                double[] above = c.project(c.values, up);
                double[] below = c.project(c.values, down);
                for (int r = 0; r < 2; r++) {
                    assertEquals((above[r] - below[r]) / 2e-4, byPoint[3 * r + i] * distance,
                            1e-6 * c.values[0] * (1 + 100 * Math.pow(Math.tan(Math.min(c.widestRad, 1)), 2)),
                            "by coordinate " + i);
                }
            }
            for (int i = 0; i < n; i++) {
                // the image is linear in each parameter; a larger step may leave the reach
                double h = i < 5 ? 1 : 1e-5;
                double[] up = c.values.clone();
                double[] down = c.values.clone();
                up[i] += h;
                down[i] -= h;
                double[] above = c.project(up, p);
                double[] below = c.project(down, p);
                for (int r = 0; r < 2; r++) {
                    assertEquals((above[r] - below[r]) / (2 * h), byParameters[n * r + i],
                            1e-6 * Math.max(1, Math.abs(byParameters[n * r + i])), c.lens.parameterNames().get(i));
                }
            }
        }
    }

    @ParameterizedTest
    @MethodSource("lenses")
    void rayOfAnImageLeadsToItsPoint(Case c) {
        RandomGenerator random = new Well19937c(3);
        double[] ray = new double[3];
        for (int k = 0; k < 2 * POINTS; k++) {
            double[] p = k == 0 ? new double[] {0, 0, 700} : c.point(random);
            double[] uv = c.project(c.values, p);
            assertTrue(c.lens.toRay(c.values, uv[0], uv[1], ray));
            double length = c.lens.isWide() ? Math.sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]) : p[2];
            assertArrayEquals(new double[] {p[0] / length, p[1] / length, p[2] / length}, ray, 1e-11);
            assertEquals(1, c.lens.isWide() ? Math.sqrt(ray[0] * ray[0] + ray[1] * ray[1] + ray[2] * ray[2]) : ray[2],
                    1e-12);
        }
    }

    @ParameterizedTest
    @MethodSource("lenses")
    void whatTheLensCannotSeeHasNoImage(Case c) {
        double[] uv = {7, 8};
        double[] byPoint = {1, 2, 3, 4, 5, 6};
        double[][] unseen = {{1, 2, Double.NaN}, {0, 0, -1}, {0, 0, 0}};
        for (double[] p : unseen) {
            assertFalse(c.lens.project(c.values, p[0], p[1], p[2], uv, 0), Arrays.toString(p));
            assertFalse(c.lens.projectWithDerivatives(c.values, p[0], p[1], p[2], uv, byPoint, null));
        }
        for (double z : c.lens.isWide() ? new double[0] : new double[] {0, -0.0, -1, Double.NEGATIVE_INFINITY}) {
            assertFalse(c.lens.project(c.values, 1, 2, z, uv, 0), "z " + z);
            assertFalse(c.lens.projectWithDerivatives(c.values, 1, 2, z, uv, byPoint, null), "z " + z);
        }
        assertArrayEquals(new double[] {7, 8}, uv, 0);
        assertArrayEquals(new double[] {1, 2, 3, 4, 5, 6}, byPoint, 0);
        assertNull(PinholeCamera.of(c.lens, 1280, 960, c.values).project(0, 0, -1));
        double[] ray = {1, 2, 3};
        assertFalse(c.lens.toRay(c.values, Double.NaN, 3, ray));
        assertFalse(c.lens.toRay(c.values, 3, Double.POSITIVE_INFINITY, ray));
        assertArrayEquals(new double[] {1, 2, 3}, ray, 0);
    }

    @ParameterizedTest
    @MethodSource("lenses")
    void imageMovesOutwardsUpToTheReachAndNothingIsSeenBeyond(Case c) {
        // decentring is left out of account by the reach
        double[] values = c.values.clone();
        if (c.lens == BrownLens.MODEL) {
            values[BrownLens.P1] = 0;
            values[BrownLens.P2] = 0;
        } else if (c.lens == RationalLens.MODEL) {
            Arrays.fill(values, RationalLens.P1, RationalLens.PARAMETERS, 0);
        }
        double reach = c.lens.reachRad(values);
        assertTrue(reach > c.widestRad && reach <= Math.PI, "reach " + reach);
        double before = -1;
        double[] ray = new double[3];
        for (int k = 0; k < POINTS; k++) {
            double t = reach * (k + 0.5) / POINTS;
            double[] uv = c.project(values, new double[] {Math.sin(t), 0, Math.cos(t)});
            assertTrue(uv[0] - values[2] > before);
            before = uv[0] - values[2];
            assertTrue(c.lens.toRay(values, uv[0], uv[1], ray));
            assertEquals(t, Math.atan2(ray[0], ray[2]), 1e-9);
        }
        if (reach < 1.5 || c.lens.isWide()) {
            assertFalse(c.lens.toRay(values, values[2] + 1.05 * before, values[3], ray), "beyond the last of them");
        }
    }

    @ParameterizedTest
    @MethodSource("lenses")
    void whatDoesNotDistortIsAPinhole(Case c) {
        RandomGenerator random = new Well19937c(4);
        double largest = 0;
        for (int k = 0; k < POINTS; k++) {
            double[] p = c.point(random);
            double x = p[0] / p[2];
            double y = p[1] / p[2];
            double[] uv = c.project(c.values, p);
            largest = Math.max(largest, Math.hypot(uv[0] - c.values[0] * x - c.values[4] * y - c.values[2],
                    uv[1] - c.values[1] * y - c.values[3]));
        }
        if (c.lens.isDistorting(c.values)) {
            assertTrue(largest > 1, "distorts by " + largest);
        } else {
            assertEquals(0, largest, 1e-9);
        }
    }

    @ParameterizedTest
    @MethodSource("lenses")
    void allocatesNothing(Case c) {
        double[] uv = new double[2];
        double[] ray = new double[3];
        double[] byPoint = new double[6];
        double[] byParameters = new double[2 * c.lens.parameterCount()];
        double[] p = c.point(new Well19937c(5));
        long least = Allocated.leastBytes(5, () -> {
            for (int k = 0; k < 100; k++) {
                c.lens.project(c.values, p[0], p[1], p[2], uv, 0);
                c.lens.projectWithDerivatives(c.values, p[0], p[1], p[2], uv, byPoint, byParameters);
                c.lens.toRay(c.values, uv[0], uv[1], ray);
                c.lens.isDistorting(c.values);
                c.lens.reachRad(c.values);
            }
        });
        assertTrue(least < 1000, "100 rounds allocated " + least + " bytes");
    }

    @Test
    void lensesAreToldApart() {
        assertSame(BrownLens.MODEL, Lenses.named("pinhole_radial_tangential"));
        assertSame(KannalaBrandtLens.MODEL, Lenses.named("kannala_brandt"));
        assertSame(RationalLens.MODEL, Lenses.named("pinhole_rational"));
        assertNull(Lenses.named("pinhole"));
        assertFalse(BrownLens.MODEL.isWide());
        assertFalse(RationalLens.MODEL.isWide());
        assertTrue(KannalaBrandtLens.MODEL.isWide());
    }
}
