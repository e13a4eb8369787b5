package org.cellgauge.overlay;

import java.util.Locale;
import org.cellgauge.cell.Cell;
import org.cellgauge.check.CellEstimate;
import org.cellgauge.check.CheckResult;
import org.cellgauge.check.CheckUpdate;
import org.cellgauge.check.Verdict;
import org.cellgauge.vision.Detections;

/**
 * The overlay of a check at whatever stage: detected, at the quick look, running, finished.
 *
 * <p>Each comes in two forms: over the photo as it is, with its panels, and for a display on which the image is turned
 * or mirrored. The latter is laid out in the upright image: its shapes are turned and mirrored with the image, its
 * texts stay upright and are never mirrored. Without panels, for programs that say in their own way what banner and
 * legend say, labels may use the whole area.
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
        return of(result, ImageOrientation.IDENTITY, true);
    }

    /**
     * The overlay of a finished check for a display.
     *
     * @param result the result
     * @param orientation how the photo is turned and mirrored there
     * @param panels whether there is a banner and a legend
     * @return what to draw over the upright photo
     */
    public static Overlay of(CheckResult result, ImageOrientation orientation, boolean panels) {
        return of(result, orientation, panels, LabelWords.ENGLISH);
    }

    /**
     * The overlay of a finished check for a display, its labels in another language.
     *
     * @param result the result
     * @param orientation how the photo is turned and mirrored there
     * @param panels whether there is a banner and a legend, in English
     * @param words what the labels say
     * @return what to draw over the upright photo
     */
    public static Overlay of(CheckResult result, ImageOrientation orientation, boolean panels, LabelWords words) {
        String headline;
        switch (result.verdict()) {
            case PASS:
                headline = "PASS";
                break;
            case FAIL:
                headline = "TARGET MISSED";
                break;
            case NOT_CONVERGED:
                headline = "NOT CONVERGED \u2013 no figure to trust";
                break;
            case AMBIGUOUS:
                headline = "AMBIGUOUS \u2013 two poses explain the photo";
                break;
            default:
                headline = "NO TARGET SET";
                break;
        }
        return drawing(result, orientation, panels, words, LegendWords.ENGLISH)
                .draw(status(result.verdict()), headline, result.reason());
    }

    /**
     * The overlay of a finished check for a display with banner and legend, all of it in another language.
     *
     * @param result the result
     * @param orientation how the photo is turned and mirrored there
     * @param labels what the labels say
     * @param legend what the legend says
     * @param headline a few words: the verdict
     * @param reason a sentence or two: why
     * @return what to draw over the upright photo
     */
    public static Overlay of(CheckResult result, ImageOrientation orientation, LabelWords labels, LegendWords legend,
            String headline, String reason) {
        return drawing(result, orientation, true, labels, legend).draw(status(result.verdict()), headline, reason);
    }

    private static CellDrawing drawing(CheckResult result, ImageOrientation orientation, boolean panels,
            LabelWords labels, LegendWords legend) {
        CellDrawing.Stage stage = result.verdict() == Verdict.NOT_CONVERGED ? CellDrawing.Stage.NOT_CONVERGED
                : CellDrawing.Stage.FINAL;
        return new CellDrawing(result.cell(), result.detections(), result.estimate(), result.referenceCheck(), stage,
                orientation, panels, labels, legend);
    }

    private static Status status(Verdict verdict) {
        switch (verdict) {
            case PASS:
                return Status.PASS;
            case FAIL:
                return Status.FAIL;
            case NOT_CONVERGED:
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
        return of(cell, detections, update, ImageOrientation.IDENTITY, true);
    }

    /**
     * The overlay of a running check for a display.
     *
     * @param cell the cell
     * @param detections the markers of the photo
     * @param update the newest item of the check's stream
     * @param orientation how the photo is turned and mirrored there
     * @param panels whether there is a banner and a legend
     * @return what to draw over the upright photo
     */
    public static Overlay of(Cell cell, Detections detections, CheckUpdate update, ImageOrientation orientation,
            boolean panels) {
        return of(cell, detections, update, orientation, panels, LabelWords.ENGLISH);
    }

    /**
     * The overlay of a running check for a display, its labels in another language.
     *
     * @param cell the cell
     * @param detections the markers of the photo
     * @param update the newest item of the check's stream
     * @param orientation how the photo is turned and mirrored there
     * @param panels whether there is a banner and a legend, in English
     * @param words what the labels say
     * @return what to draw over the upright photo
     */
    public static Overlay of(Cell cell, Detections detections, CheckUpdate update, ImageOrientation orientation,
            boolean panels, LabelWords words) {
        if (update.result() != null) {
            return of(update.result(), orientation, panels, words);
        }
        String headline = update.phase() == CheckUpdate.Phase.QUICK_LOOK ? "QUICK LOOK"
                : String.format(Locale.ROOT, "SAMPLING \u2013 %d iterations per chain", update.iterationsPerChain());
        return preliminary(cell, detections, update.estimate(), headline, orientation, panels, words);
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
        return of(cell, detections, estimate, ImageOrientation.IDENTITY, true);
    }

    /**
     * The overlay of an estimate that no chain has confirmed for a display.
     *
     * @param cell the cell
     * @param detections the markers of the photo
     * @param estimate poses and their uncertainties
     * @param orientation how the photo is turned and mirrored there
     * @param panels whether there is a banner and a legend
     * @return what to draw over the upright photo; its figures are marked as not converged yet
     */
    public static Overlay of(Cell cell, Detections detections, CellEstimate estimate, ImageOrientation orientation,
            boolean panels) {
        return preliminary(cell, detections, estimate, "QUICK LOOK", orientation, panels, LabelWords.ENGLISH);
    }

    private static Overlay preliminary(Cell cell, Detections detections, CellEstimate estimate, String headline,
            ImageOrientation orientation, boolean panels, LabelWords words) {
        return new CellDrawing(cell, detections, estimate, null, CellDrawing.Stage.PRELIMINARY, orientation, panels,
                words, LegendWords.ENGLISH).draw(Status.NEUTRAL, headline,
                "Figures are preliminary: the chains have not converged yet.");
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
        return ofDetections(cell, detections, status, headline, reason, ImageOrientation.IDENTITY, true);
    }

    /**
     * The overlay of a photo that was not, or could not be, checked, for a display.
     *
     * @param cell the cell
     * @param detections the markers of the photo
     * @param status {@link Status#FAIL} where the photo was refused, {@link Status#NEUTRAL} where it only waits
     * @param headline a few words
     * @param reason a sentence
     * @param orientation how the photo is turned and mirrored there
     * @param panels whether there is a banner and a legend; without them headline and reason are not drawn
     * @return what to draw over the upright photo
     */
    public static Overlay ofDetections(Cell cell, Detections detections, Status status, String headline,
            String reason, ImageOrientation orientation, boolean panels) {
        return ofDetections(cell, detections, status, headline, reason, orientation, panels, LabelWords.ENGLISH);
    }

    /**
     * The overlay of a photo that was not, or could not be, checked, for a display, its labels in another language.
     *
     * @param cell the cell
     * @param detections the markers of the photo
     * @param status {@link Status#FAIL} where the photo was refused, {@link Status#NEUTRAL} where it only waits
     * @param headline a few words
     * @param reason a sentence
     * @param orientation how the photo is turned and mirrored there
     * @param panels whether there is a banner and a legend; without them headline and reason are not drawn
     * @param words what the labels say
     * @return what to draw over the upright photo
     */
    public static Overlay ofDetections(Cell cell, Detections detections, Status status, String headline,
            String reason, ImageOrientation orientation, boolean panels, LabelWords words) {
        return new CellDrawing(cell, detections, null, null, CellDrawing.Stage.PRELIMINARY, orientation, panels, words,
                LegendWords.ENGLISH).draw(status, headline, reason);
    }
}
