package org.cellgauge.check;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.AbstractList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.Random;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import org.cellgauge.sampling.Draws;
import org.cellgauge.sampling.Quantity;
import org.cellgauge.sampling.QuantityLayout;
import org.junit.jupiter.api.Test;

class DiagnosticsTest {
    private static final int QUANTITIES = 40;

    /** Draws that note who reads them. */
    private static final class Watched extends AbstractList<Draws> {
        final Set<Thread> readers = ConcurrentHashMap.newKeySet();
        final QuantityLayout layout;
        private final Draws[] chains = new Draws[2];

        Watched() {
            QuantityLayout.Builder builder = new QuantityLayout.Builder();
            for (int q = 0; q < QUANTITIES; q++) {
                builder.add(Quantity.printSize(1 + q));
            }
            layout = builder.build();
            Random random = new Random(4);
            for (int c = 0; c < chains.length; c++) {
                chains[c] = new Draws(layout);
                for (int i = 0; i < 400; i++) {
                    chains[c].add(random.doubles(QUANTITIES).toArray());
                }
            }
        }

        @Override
        public Draws get(int chain) {
            readers.add(Thread.currentThread());
            return chains[chain];
        }

        @Override
        public int size() {
            return chains.length;
        }
    }

    private static Diagnostics of(Watched draws, int threads) {
        boolean[] all = new boolean[QUANTITIES];
        Arrays.fill(all, true);
        return Diagnostics.of(draws, draws.layout, all, all, threads).withTails(threads);
    }

    private static List<Object> figures(Diagnostics d) {
        return Arrays.asList(d.rHatMax(), d.essBulkMin(), d.essTailMin(), d.mcseStdRelMax(), d.worstParameter(),
                d.leastPreciseParameter(), d.paretoK(), d.heaviestParameter());
    }

    @Test
    void oneThreadIsTheCallersOwn() {
        Watched draws = new Watched();
        of(draws, 1);
        assertEquals(Collections.singleton(Thread.currentThread()), draws.readers);
    }

    @Test
    void severalThreadsFindTheSameAndAreNoneOfASharedPool() {
        Watched one = new Watched();
        Watched several = new Watched();
        assertEquals(figures(of(one, 1)), figures(of(several, 3)));
        several.readers.remove(Thread.currentThread());
        assertTrue(several.readers.size() <= 2);
        several.readers.forEach(reader -> assertEquals("cellgauge-worker", reader.getName()));
    }
}
