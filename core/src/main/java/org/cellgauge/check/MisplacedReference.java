package org.cellgauge.check;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Locale;
import org.cellgauge.cell.Placement;
import org.cellgauge.cell.Reference;

/** A reference that stands farther off than its stated precision allows; immutable. */
public final class MisplacedReference {
    private final Reference reference;
    private final double[] offset;
    private final double statistic;
    private final double limit;
    private final List<Integer> orInstead;

    MisplacedReference(PlacementTest test, List<Integer> orInstead) {
        reference = test.reference;
        offset = test.offset();
        statistic = test.statistic();
        limit = test.limit();
        this.orInstead = Collections.unmodifiableList(new ArrayList<>(orInstead));
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
        return orInstead;
    }

    /**
     * What to tell the user.
     *
     * @return one sentence without a full stop
     */
    public String warning() {
        Placement placement = reference.placement();
        StringBuilder by = new StringBuilder();
        StringBuilder stated = new StringBuilder();
        boolean turned = false;
        for (int c = 0; c < offset.length; c++) {
            if (offset[c] == 0) {
                continue;
            }
            by.append(by.length() == 0 ? "" : " and ");
            if (c < 3) {
                by.append(String.format(Locale.ROOT, "%.1f mm along %s", offset[c], "xyz".charAt(c)));
                String std = String.format(Locale.ROOT, "%.1f mm", placement.stdMm(c));
                stated.append(stated.length() == 0 ? std : stated.toString().equals(std) ? "" : " and " + std);
            } else {
                turned = true;
                by.append(String.format(Locale.ROOT, "%.1f degrees about %s", Math.toDegrees(offset[c]),
                        "xyz".charAt(c - 3)));
                stated.append(String.format(Locale.ROOT, "%.2f degrees", Math.toDegrees(placement.stdRad())));
            }
        }
        return "reference " + id() + " seems " + (turned ? "turned" : "off") + " by about " + by
                + ", which its stated precision (" + stated + ") does not allow: "
                + (turned ? "check how it is mounted" : "measure its position again")
                + (orInstead.isEmpty() ? "" : "; it may be reference " + Reason.joined(orInstead, " or ") + " instead");
    }
}
