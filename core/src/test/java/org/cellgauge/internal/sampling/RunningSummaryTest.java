package org.cellgauge.internal.sampling;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.apache.commons.math3.random.RandomGenerator;
import org.cellgauge.sampling.Draws;
import org.cellgauge.sampling.Quantity;
import org.cellgauge.sampling.QuantityLayout;
import org.junit.jupiter.api.Assumptions;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class RunningSummaryTest {
    private static QuantityLayout layout(double reference) {
        QuantityLayout.Builder builder = new QuantityLayout.Builder();
        int x = builder.add(Quantity.camera(Quantity.Axis.X));
        int a = builder.addAngle(Quantity.camera(Quantity.Axis.PSI), reference);
        builder.add(Quantity.EDGE_SHIFT);
        builder.group(x, a);
        return builder.build();
    }

    @ParameterizedTest
    @ValueSource(doubles = {Math.PI, -Math.PI, 3.0, -3.0})
    void anglesToBothSidesOfAHalfTurnStayTogether(double reference) {
        RunningSummary summary = new RunningSummary(layout(reference));
        // 179, 181, 177 and 183 degrees, the second and fourth written as negative angles
        double[] degrees = {179, -179, 177, -177};
        for (int i = 0; i < 4; i++) {
            summary.add(new double[] {i, Math.toRadians(degrees[i]), 7});
        }
        assertEquals(4, summary.count());
        assertEquals(Math.PI, Math.abs(summary.mean(0)[1]), 1e-12);
        assertEquals(1.5, summary.mean(0)[0], 1e-14);
        // deviations -1, 1, -3, 3 degrees: variance 20/3; with x - 1.5 = -1.5, -0.5, 0.5, 1.5: covariance 4/3
        double degree = Math.toRadians(1);
        assertEquals(20.0 / 3 * degree * degree, summary.covariance(0)[1][1], 1e-12);
        assertEquals(4.0 / 3 * degree, summary.covariance(0)[0][1], 1e-12);
        double resultant = (Math.cos(degree) + Math.cos(3 * degree)) / 2;
        assertEquals(resultant, summary.direction(1).resultantLength(), 1e-12);
        assertNull(summary.direction(0));
    }

    @Test
    void mergedSummariesAreTheSummaryOfAll() {
        QuantityLayout layout = layout(3.1);
        RunningSummary all = new RunningSummary(layout);
        RunningSummary merged = new RunningSummary(layout);
        RandomGenerator random = RandomStreams.of(1);
        for (int part : new int[] {0, 1, 500, 37}) {
            RunningSummary one = new RunningSummary(layout);
            for (int i = 0; i < part; i++) {
                double[] draw = {1e4 + random.nextGaussian(),
                    org.cellgauge.internal.statistics.Angles.wrapToPi(3.1 + 0.1 * random.nextGaussian()), 0};
                one.add(draw);
                all.add(draw);
            }
            merged.merge(one);
            assertEquals(part, one.count());
        }
        assertEquals(538, merged.count());
        assertArrayEquals(all.mean(0), merged.mean(0), 1e-9);
        for (int i = 0; i < 2; i++) {
            assertArrayEquals(all.covariance(0)[i], merged.covariance(0)[i], 1e-10);
        }
        assertEquals(all.direction(1).meanDirectionRad(), merged.direction(1).meanDirectionRad(), 1e-12);
    }

    @Test
    void addingDrawsTakesLessMemoryThanKeepingThemWould() {
        var bean = java.lang.management.ManagementFactory.getThreadMXBean();
        Assumptions.assumeTrue(bean instanceof com.sun.management.ThreadMXBean);
        var threads = (com.sun.management.ThreadMXBean) bean;
        Assumptions.assumeTrue(threads.isThreadAllocatedMemorySupported() && threads.isThreadAllocatedMemoryEnabled());
        QuantityLayout.Builder builder = new QuantityLayout.Builder();
        int[] group = new int[60];
        for (int i = 0; i < group.length; i++) {
            group[i] = builder.add(Quantity.printSize(i));
        }
        builder.group(group);
        RunningSummary summary = new RunningSummary(builder.build());
        double[] draw = new double[60];
        for (int i = 0; i < 2000; i++) {
            summary.add(draw);
        }
        long before = threads.getThreadAllocatedBytes(Thread.currentThread().getId());
        int n = 20_000;
        for (int i = 0; i < n; i++) {
            draw[i % 60] = i;
            summary.add(draw);
        }
        long bytes = threads.getThreadAllocatedBytes(Thread.currentThread().getId()) - before;
        // a draw kept takes 480 bytes; what is allocated here is at most an iterator, garbage at once
        assertTrue(bytes < 200L * n, bytes / n + " bytes a draw");
    }

    @Test
    void drawsAreKeptQuantityByQuantityAndAnglesUnrolled() {
        Draws draws = new Draws(layout(Math.PI));
        for (int i = 0; i < 1000; i++) {
            draws.add(new double[] {i, i % 2 == 0 ? 3.1 : -3.1, -i});
        }
        assertEquals(1000, draws.count());
        assertEquals(-3.1, draws.get(1, 999), 0);
        double[] series = draws.series(1);
        assertEquals(1000, series.length);
        assertEquals(3.1, series[0], 1e-15);
        assertEquals(2 * Math.PI - 3.1, series[1], 1e-14);
        assertEquals(777, draws.series(0)[777], 0);
        assertEquals(-777, draws.series(2)[777], 0);
    }
}
