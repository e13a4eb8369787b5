package org.cellgauge.plan;

import java.util.List;
import java.util.OptionalDouble;
import org.cellgauge.cell.Target;

/**
 * What a layout would reach and what would reach the target; immutable.
 *
 * @param layout the layout as it is
 * @param now what a photo of it would tell
 * @param target what is asked of the objects
 * @param best changes that meet the target, cheapest first; without a target, or where none meets it, those that come
 *     nearest
 * @param front for every cost the least deviation that changes of at most that cost reach, cheapest first
 * @param single every single change in its largest useful size, the most useful first
 * @param boundStdMm what no reference can improve on: the largest deviation that the objects' own corners leave, mm
 * @param certificate how good the places for added references are, by number
 */
public record Plan(Layout layout, Forecast now, Target target, List<Proposal> best, List<Proposal> front,
        List<Proposal> single, double boundStdMm, List<Certificate> certificate) {
    /** A gap up to which a choice of places counts as proven. */
    public static final double PROVEN_GAP = 0.03;

    /**
     * How good a choice of places for added references is.
     *
     * @param references number of added references
     * @param foundRatio how much of what is asked is taken with the best places found, as in {@link Forecast#ratio()}
     *     but for distances and turns, which count at most
     * @param boundRatio no so many references at any of the places tried can reach less
     */
    public record Certificate(int references, double foundRatio, double boundRatio) {
        /**
         * By how much a better choice could at most be better.
         *
         * @return a share of the bound
         */
        public double gap() {
            return foundRatio / boundRatio - 1;
        }

        /**
         * Whether the choice is as good as the best.
         *
         * @return true where the gap is at most {@link #PROVEN_GAP}
         */
        public boolean proven() {
            return gap() <= PROVEN_GAP;
        }
    }

    /**
     * A plan.
     *
     * @param best copied, as the other lists are
     */
    public Plan {
        best = List.copyOf(best);
        front = List.copyOf(front);
        single = List.copyOf(single);
        certificate = List.copyOf(certificate);
    }

    /**
     * The target as one standard deviation.
     *
     * @return as {@link Target#oneStdMm()}
     */
    public OptionalDouble targetStdMm() {
        return target.oneStdMm();
    }

    /**
     * Whether the target is met as it is.
     *
     * @return true where it is, and where there is none
     */
    public boolean met() {
        return isMetBy(now);
    }

    /**
     * Whether a forecast meets the target.
     *
     * @param forecast of any layout
     * @return true where it does, and where there is none
     */
    public boolean isMetBy(Forecast forecast) {
        return !target.isAny() || forecast.ratio() <= 1;
    }

    /**
     * Whether references alone could ever meet the target.
     *
     * @return false where the objects' own corners leave more
     */
    public boolean referencesCouldMeetIt() {
        return !target.isAny() || now.boundRatio() <= 1;
    }
}
