package org.cellgauge.internal.statistics;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotSame;
import static org.junit.jupiter.api.Assertions.assertSame;

import java.util.Random;
import org.cellgauge.statistics.ChainDiagnostics;
import org.junit.jupiter.api.Test;

class DrawsWorkTest {
    @Test
    void nobodyHasWhatAnotherHas() {
        DrawsWork.Pool works = new DrawsWork.Pool();
        DrawsWork one = works.take();
        DrawsWork other = works.take();
        assertNotSame(one, other);
        works.giveBack(one);
        assertSame(one, works.take());
        assertNotSame(other, works.take());
    }

    /** Series of other lengths, with ties, sticky, with a far draw, and of odd chains, one after the other. */
    private static double[][] chains(int number) {
        Random random = new Random(number);
        int count = number < 8 ? 200 : number < 14 ? 199 : 101;
        double[][] chains = new double[4][count];
        for (double[] chain : chains) {
            double x = 0;
            for (int i = 0; i < count; i++) {
                x = number % 4 == 1 ? 0.95 * x + random.nextGaussian() : random.nextGaussian();
                chain[i] = number % 5 == 2 ? Math.rint(2 * x) : x;
            }
        }
        chains[1][7] = number % 4 == 3 ? 1e9 : chains[1][7];
        return chains;
    }

    private static double[] figures(ChainDiagnostics d) {
        return new double[] {d.mean(), d.std(), d.rHatBulk(), d.rHatFolded(), d.essBulk(), d.essTail(), d.essMean(),
            d.essSd(), d.essSquaredDeviation(), d.essQuantile(0.3), d.mcseMean(), d.mcseSd(), d.mcseQuantile(0.05),
            d.mcseQuantile(0.6), d.quantile(0.9), d.paretoK()};
    }

    @Test
    void diagnosticsAreThoseOfEachByItself() {
        DrawsWork.Pool works = new DrawsWork.Pool();
        ChainDiagnostics[] shared = new ChainDiagnostics[20];
        for (int k = 0; k < shared.length; k++) {
            double[][] chains = chains(k);
            double[] joined = new double[4 * chains[0].length];
            for (int c = 0; c < 4; c++) {
                System.arraycopy(chains[c], 0, joined, c * chains[0].length, chains[0].length);
            }
            shared[k] = ChainDiagnostics.of(joined, 4, works);
        }
        for (int k = 0; k < shared.length; k++) {
            assertArrayEquals(figures(ChainDiagnostics.of(chains(k))), figures(shared[k]), "series " + k);
            assertEquals(ChainDiagnostics.Status.OK, shared[k].status());
        }
    }
}
