package org.cellgauge.internal.overlay;

import java.util.Objects;
import org.cellgauge.cell.Cell;
import org.cellgauge.check.CellEstimate;
import org.cellgauge.check.CheckResult;
import org.cellgauge.check.CheckUpdate;
import org.cellgauge.check.Verdict;
import org.cellgauge.internal.warning.Decimal;
import org.cellgauge.output.ResultView;
import org.cellgauge.vision.Detections;

/**
 * The overlay of a check at whatever stage: detected, at the quick look, running, finished.
 *
 * <p>Each comes in two forms: over the photo as it is, and in a given {@link OverlayStyle}, for a display on which the
 * image is turned or mirrored, say. It is laid out in the upright image: its shapes are turned and mirrored with the
 * image, its texts stay upright and are never mirrored. Without panels labels may use the whole area.
 */
public final class CellOverlay {
    private CellOverlay() {
    }

    /**
     * The overlay of a finished check.
     *
     * @param result the result
     * @return what to draw over its photo
     */
    public static Overlay of(CheckResult result) {
        return of(result, OverlayStyle.PHOTO);
    }

    /**
     * The overlay of a finished check in a style.
     *
     * @param result the result
     * @param style how it is shown; its banner is in English
     * @return what to draw over the upright photo
     */
    public static Overlay of(CheckResult result, OverlayStyle style) {
        return of(result.cell(), result.detections(), ResultView.of(result), style);
    }

    /**
     * The overlay of a result, whether it comes from a check or from a file.
     *
     * @param cell the cell
     * @param detections the markers of the photo
     * @param result what was found; not preliminary
     * @param style how it is shown; its banner is in English
     * @return what to draw over the upright photo
     */
    public static Overlay of(Cell cell, Detections detections, ResultView result, OverlayStyle style) {
        String headline;
        switch (verdict(result)) {
            case PASS:
                headline = "PASS";
                break;
            case FAIL:
                headline = "TARGET MISSED";
                break;
            case NOT_CONVERGED:
                headline = "NOT CONVERGED \u2013 no figure to trust";
                break;
            case CONTRADICTED:
                headline = "CONTRADICTED \u2013 references do not fit together";
                break;
            case AMBIGUOUS:
                headline = "AMBIGUOUS \u2013 two poses explain the photo";
                break;
            default:
                headline = "NO TARGET SET";
                break;
        }
        return judged(cell, detections, result, style, headline,
                Objects.requireNonNull(result.reason(), "a verdict has a reason"));
    }

    /**
     * The overlay of a finished check in a style, its banner in another language.
     *
     * @param result the result
     * @param style how it is shown; without panels headline and reason are not drawn
     * @param headline a few words: the verdict
     * @param reason a sentence or two: why
     * @return what to draw over the upright photo
     */
    public static Overlay of(CheckResult result, OverlayStyle style, String headline, String reason) {
        return judged(result.cell(), result.detections(), ResultView.of(result), style, headline, reason);
    }

    private static Overlay judged(Cell cell, Detections detections, ResultView result, OverlayStyle style,
            String headline, String reason) {
        CellDrawing.Stage stage = result.verdict() == Verdict.NOT_CONVERGED ? CellDrawing.Stage.NOT_CONVERGED
                : result.verdict() == Verdict.CONTRADICTED ? CellDrawing.Stage.CONTRADICTED
                : CellDrawing.Stage.FINAL;
        return new CellDrawing(cell, detections, result, stage, style)
                .draw(status(verdict(result)), headline, reason);
    }

    private static Verdict verdict(ResultView result) {
        return Objects.requireNonNull(result.verdict(), "a preliminary result is drawn as such");
    }

    private static Status status(Verdict verdict) {
        switch (verdict) {
            case PASS:
                return Status.PASS;
            case FAIL:
                return Status.FAIL;
            case NOT_CONVERGED:
            case CONTRADICTED:
                return Status.NOT_CONVERGED;
            case AMBIGUOUS:
                return Status.AMBIGUOUS;
            default:
                return Status.NEUTRAL;
        }
    }

    /**
     * The overlay of a running check.
     *
     * @param cell the cell
     * @param detections the markers of the photo
     * @param update the newest item of the check's stream; the last one gives the same as {@link #of(CheckResult)}
     * @return what to draw over the photo
     */
    public static Overlay of(Cell cell, Detections detections, CheckUpdate update) {
        return of(cell, detections, update, OverlayStyle.PHOTO);
    }

    /**
     * The overlay of a running check in a style.
     *
     * @param cell the cell
     * @param detections the markers of the photo
     * @param update the newest item of the check's stream
     * @param style how it is shown; its banner is in English
     * @return what to draw over the upright photo
     */
    public static Overlay of(Cell cell, Detections detections, CheckUpdate update, OverlayStyle style) {
        if (update.result() != null) {
            return of(update.result(), style);
        }
        String headline = update.phase() == CheckUpdate.Phase.QUICK_LOOK ? "QUICK LOOK"
                : String.format(Decimal.POINT, "SAMPLING \u2013 %d iterations per chain", update.iterationsPerChain());
        return preliminary(cell, detections, update.estimate(), headline, style);
    }

    /**
     * The overlay of an estimate that no chain has confirmed.
     *
     * @param cell the cell
     * @param detections the markers of the photo
     * @param estimate poses and their uncertainties
     * @return what to draw over the photo; its figures are marked as not converged yet
     */
    public static Overlay of(Cell cell, Detections detections, CellEstimate estimate) {
        return of(cell, detections, estimate, OverlayStyle.PHOTO);
    }

    /**
     * The overlay of an estimate that no chain has confirmed, in a style.
     *
     * @param cell the cell
     * @param detections the markers of the photo
     * @param estimate poses and their uncertainties
     * @param style how it is shown; its banner is in English
     * @return what to draw over the upright photo; its figures are marked as not converged yet
     */
    public static Overlay of(Cell cell, Detections detections, CellEstimate estimate, OverlayStyle style) {
        return preliminary(cell, detections, estimate, "QUICK LOOK", style);
    }

    private static Overlay preliminary(Cell cell, Detections detections, CellEstimate estimate, String headline,
            OverlayStyle style) {
        return new CellDrawing(cell, detections, ResultView.preliminary(cell, estimate),
                CellDrawing.Stage.PRELIMINARY, style)
                .draw(Status.NEUTRAL, headline, "Figures are preliminary: the chains have not converged yet.");
    }

    /**
     * The overlay of a photo that was not, or could not be, checked: what was detected and a word about it.
     *
     * @param cell the cell
     * @param detections the markers of the photo
     * @param status {@link Status#FAIL} where the photo was refused, {@link Status#NEUTRAL} where it only waits
     * @param headline a few words, for instance {@code NO REFERENCE IN THE PHOTO}
     * @param reason a sentence
     * @return what to draw over the photo
     */
    public static Overlay ofDetections(Cell cell, Detections detections, Status status, String headline,
            String reason) {
        return ofDetections(cell, detections, status, headline, reason, OverlayStyle.PHOTO);
    }

    /**
     * The overlay of a photo that was not, or could not be, checked, in a style.
     *
     * @param cell the cell
     * @param detections the markers of the photo
     * @param status {@link Status#FAIL} where the photo was refused, {@link Status#NEUTRAL} where it only waits
     * @param headline a few words
     * @param reason a sentence
     * @param style how it is shown; without panels headline and reason are not drawn
     * @return what to draw over the upright photo
     */
    public static Overlay ofDetections(Cell cell, Detections detections, Status status, String headline,
            String reason, OverlayStyle style) {
        return new CellDrawing(cell, detections, null, CellDrawing.Stage.PRELIMINARY, style)
                .draw(status, headline, reason);
    }
}
