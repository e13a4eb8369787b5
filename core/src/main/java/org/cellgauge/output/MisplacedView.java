package org.cellgauge.output;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import org.jspecify.annotations.Nullable;

/** A reference that stands farther off than its stated precision allows; immutable. */
public final class MisplacedView extends Value {
    private final int id;
    private final double[] offset;
    private final double statistic;
    private final double limit;
    private final List<Integer> orInstead;

    MisplacedView(int id, double[] offset, double statistic, double limit, List<Integer> orInstead) {
        this.id = id;
        this.offset = Figures.finite(offset);
        this.statistic = Figures.finite(statistic);
        this.limit = Figures.finite(limit);
        this.orInstead = Collections.unmodifiableList(new ArrayList<>(orInstead));
    }

    /**
     * The reference.
     *
     * @return marker id
     */
    public int id() {
        return id;
    }

    /**
     * By how much it seems off.
     *
     * @return shift along world x, y, z in mm, turn about world x, y, z in rad; a new array
     */
    public double[] offset() {
        return offset.clone();
    }

    /**
     * The test that it failed.
     *
     * @return standard normal if the reference stood as stated
     */
    public double statistic() {
        return statistic;
    }

    /**
     * The size of that test that raises an alarm.
     *
     * @return positive
     */
    public double limit() {
        return limit;
    }

    /**
     * Other references, any one of which may be the one that is off.
     *
     * @return marker ids, the likelier first; mostly none
     */
    public List<Integer> orInstead() {
        return orInstead;
    }

    @Override
    @Nullable Object[] figures() {
        return new @Nullable Object[] {id, offset, statistic, limit, orInstead};
    }
}
