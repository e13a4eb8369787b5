package org.cellgauge.placement;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import org.cellgauge.cell.Placement;
import org.cellgauge.cell.Reference;
import org.cellgauge.internal.warning.CheckPhrase;
import org.cellgauge.internal.warning.Decimal;
import org.cellgauge.internal.warning.Listing;
import org.cellgauge.warning.CheckWarning;
import org.cellgauge.warning.Warning;

/** A reference that stands farther off than its stated precision allows; immutable. */
public final class MisplacedReference {
    private final Reference reference;
    private final double[] offset;
    private final double statistic;
    private final double limit;
    private final List<Explanation> others;

    MisplacedReference(DirectionScore test, List<Explanation> others) {
        reference = test.reference();
        offset = test.offset();
        statistic = test.statistic();
        limit = test.limit();
        this.others = Collections.unmodifiableList(new ArrayList<>(others));
    }

    /**
     * The reference.
     *
     * @return marker id
     */
    public int id() {
        return reference.id();
    }

    /**
     * By how much it seems off from where the cell file has it.
     *
     * @return a copy: shift along world x, y, z in mm, turn about world x, y, z in rad; all but one or two are 0
     */
    public double[] offset() {
        return offset.clone();
    }

    /**
     * The test that it failed.
     *
     * @return its statistic, standard normal if the reference stood as stated
     */
    public double statistic() {
        return statistic;
    }

    /**
     * The size of that statistic that a cell as stated reaches, in any of its tests, less than once in a hundred
     * photos.
     *
     * @return the limit
     */
    public double limit() {
        return limit;
    }

    /**
     * Other references, any one of which may be the one that is off: the photo speaks for this one less than twenty
     * times as clearly.
     *
     * @return marker ids, the likelier first; mostly none
     */
    public List<Integer> orInstead() {
        List<Integer> ids = new ArrayList<>();
        others.forEach(other -> ids.addAll(other.cause() == Cause.REFERENCE_OFF ? other.references()
                : Collections.emptyList()));
        return ids;
    }

    /**
     * The same with causes that move the corners of all references.
     *
     * @return the likelier first; mostly none
     */
    public List<Explanation> others() {
        return others;
    }

    /**
     * What to tell the user.
     *
     * @return one sentence
     */
    public Warning warning() {
        Placement placement = reference.placement();
        List<Warning> by = new ArrayList<>();
        List<Warning> stated = new ArrayList<>();
        boolean turned = false;
        for (int c = 0; c < offset.length; c++) {
            if (offset[c] == 0) {
                continue;
            }
            String axis = "xyz".substring(c % 3, c % 3 + 1);
            Warning std;
            if (c < 3) {
                by.add(Warning.of(CheckPhrase.SHIFT, Decimal.of(offset[c], 1), axis));
                std = Warning.of(CheckPhrase.STD_MM, Decimal.of(placement.stdMm(c), 1));
            } else {
                turned = true;
                by.add(Warning.of(CheckPhrase.TURN, Decimal.of(Math.toDegrees(offset[c]), 1), axis));
                std = Warning.of(CheckPhrase.STD_DEGREES, Decimal.of(Math.toDegrees(placement.stdRad()), 2));
            }
            if (!stated.contains(std)) {
                stated.add(std);
            }
        }
        return Warning.of(turned ? CheckWarning.REFERENCE_TURNED : CheckWarning.REFERENCE_OFF, id(), Listing.and(by),
                Listing.and(stated),
                orInstead().size() < others.size() ? Explanation.or(others)
                        : others.isEmpty() ? "" : Warning.of(CheckPhrase.OR_INSTEAD, Listing.or(orInstead())));
    }
}
