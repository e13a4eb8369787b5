package org.cellgauge.output;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import org.cellgauge.placement.Explanation;
import org.jspecify.annotations.Nullable;

/** What explains that references do not fit together: a {@link Explanation} as results tell it; immutable. */
public final class CauseView extends Value {
    /** A cause that the photo speaks for hardly less. */
    public static final class Other extends Value {
        private final String cause;
        private final String phrase;

        Other(String cause, String phrase) {
            this.cause = cause;
            this.phrase = phrase;
        }

        /**
         * Its name in files.
         *
         * @return {@link org.cellgauge.placement.Cause#key()}
         */
        public String cause() {
            return cause;
        }

        /**
         * What it is called in a sentence.
         *
         * @return English
         */
        public String phrase() {
            return phrase;
        }

        @Override
        @Nullable Object[] figures() {
            return new @Nullable Object[] {cause, phrase};
        }
    }

    private final String cause;
    private final List<Integer> references;
    private final int axis;
    private final double[] size;
    private final double std;
    private final String sentence;
    private final List<Other> orInstead;

    CauseView(String cause, List<Integer> references, int axis, double[] size, double std, String sentence,
            List<Other> orInstead) {
        this.cause = cause;
        this.references = Collections.unmodifiableList(new ArrayList<>(references));
        this.axis = axis;
        this.size = Figures.finite(size);
        this.std = Figures.finite(std);
        this.sentence = sentence;
        this.orInstead = Collections.unmodifiableList(new ArrayList<>(orInstead));
    }

    static CauseView of(Explanation cause) {
        List<Other> others = new ArrayList<>();
        for (Explanation other : cause.orInstead()) {
            others.add(new Other(other.cause().key(), other.phrase().toString()));
        }
        return new CauseView(cause.cause().key(), cause.references(), cause.axis(), cause.size(), cause.std(),
                cause.warning().toString(), others);
    }

    /**
     * Its name in files.
     *
     * @return {@link org.cellgauge.placement.Cause#key()}
     */
    public String cause() {
        return cause;
    }

    /**
     * The references that it is about.
     *
     * @return marker ids; empty where it is about all
     */
    public List<Integer> references() {
        return references;
    }

    /**
     * The world axis that it is about.
     *
     * @return 0, 1, 2 for x, y, z; -1 for none
     */
    public int axis() {
        return axis;
    }

    /**
     * How large it is.
     *
     * @return a copy, in the unit of {@link org.cellgauge.placement.Cause}
     */
    public double[] size() {
        return size.clone();
    }

    /**
     * Standard deviation of its size.
     *
     * @return NaN where it is not estimated
     */
    public double std() {
        return std;
    }

    /**
     * As if what, and what to do.
     *
     * @return one English sentence without a full stop
     */
    public String sentence() {
        return sentence;
    }

    /**
     * What it may be instead.
     *
     * @return the likelier first
     */
    public List<Other> orInstead() {
        return orInstead;
    }

    @Override
    @Nullable Object[] figures() {
        return new @Nullable Object[] {cause, references, axis, size, std, sentence, orInstead};
    }
}
