package org.cellgauge.validation;

import java.util.LinkedHashMap;
import java.util.Map;
import org.apache.commons.math3.random.RandomGenerator;
import org.cellgauge.cell.ObjectMarker;
import org.cellgauge.cell.Reference;
import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.sampling.RandomStreams;

/** The same cell again and again, built anew each time: placement errors, camera and objects are drawn. Immutable. */
public final class OneCell implements CellSource {
    private final TruthPrior prior;

    /**
     * A source.
     *
     * @param prior the cell and where its true poses come from
     */
    public OneCell(TruthPrior prior) {
        this.prior = prior;
    }

    @Override
    public SimulatedCell cell(long seed, int index) {
        CellTruth truth = prior.draw(RandomStreams.of(seed, Validation.STREAM_TRUTH, index));
        RandomGenerator placement = RandomStreams.of(seed, Validation.STREAM_PLACEMENT, index);
        Map<Integer, RigidTransform> references = new LinkedHashMap<>();
        for (Reference r : prior.cell().references()) {
            references.put(r.id(), SimulatedPhoto.misplaced(r, placement));
        }
        return new SimulatedCell(prior.cell(), truth, references);
    }

    @Override
    public String nameOf(ObjectMarker object) {
        return "object " + object.id();
    }
}
