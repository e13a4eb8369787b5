package org.cellgauge.internal.sampling;

import java.util.List;
import org.cellgauge.sampling.AcceptanceCount;
import org.cellgauge.sampling.QuantityLayout;

/** What one chain of a job advances, and the quantities that a draw of it has. Used by one thread at a time. */
public interface ChainProcess {
    /** Advances by one iteration. */
    void step();

    /** Called once, after the last iteration of the warm-up and before the first kept draw. */
    void warmedUp();

    /**
     * The quantities of the current draw. Allocates nothing.
     *
     * @param out receives one value per quantity of the job's {@link QuantityLayout}
     */
    void read(double[] out);

    /**
     * What became of the suggestions of each proposal since the start, warm-up included.
     *
     * @return one count per named proposal
     */
    List<AcceptanceCount> acceptance();
}
