package org.cellgauge.desktop;

import org.cellgauge.output.ResultJson;
import org.cellgauge.output.ResultRecord;
import org.cellgauge.output.ResultView;
import org.cellgauge.output.StoredResult;
import org.cellgauge.warning.Place;

/**
 * What became of one input of a batch.
 *
 * @param input what was checked
 * @param kind whether there is a result
 * @param result the result; null where there is none. A refused input has one where only its files could not be written
 * @param record what the input is, and by what it was checked
 * @param refusal why there is no result; null where there is one
 * @param isKept whether an earlier run had the result
 * @param everyDraw every how-manieth draw the files of draws hold; 0 where none were written
 * @param number its place in the batch, from 1
 * @param count how many inputs the batch has
 * @param seconds how long it took
 */
public record InputOutcome(CheckInput input, Kind kind, StoredResult result, ResultRecord record, Failure refusal,
        boolean isKept, int everyDraw, int number, int count, double seconds) {
    /** Whether an input has a result. */
    public enum Kind {
        /** It has. */
        RESULT,
        /** It cannot be used. */
        REFUSED,
        /** The program failed. */
        INTERNAL_ERROR
    }

    /**
     * Why an input has no result.
     *
     * @param code of the reason, as {@link org.cellgauge.warning.MessageKind#code()}; {@code internal-error} where the
     *     program failed
     * @param message what to tell people
     * @param place of the fault; null where none is known
     * @param error as it was thrown
     */
    public record Failure(String code, String message, Place place, RuntimeException error) {
    }

    /**
     * What the result says.
     *
     * @return null where there is none
     */
    public ResultView view() {
        return result == null ? null : result.view();
    }

    /**
     * What became of it in a word, as tables have it.
     *
     * @return the verdict's word, {@code refused} or {@code internal error}
     */
    public String word() {
        return kind == Kind.RESULT ? CheckText.word(result.view().verdict())
                : kind == Kind.REFUSED ? ResultJson.REFUSED : "internal error";
    }

    /**
     * The outcome as JSON in one line, which has the same shape for every input.
     *
     * @return the result file's object, also where its files could not be written; without a result
     *     {@link ResultJson#refused}
     */
    public String jsonLine() {
        return result != null ? ResultJson.line(result)
                : ResultJson.refused(record, refusal.code(), refusal.message(), refusal.place());
    }
}
