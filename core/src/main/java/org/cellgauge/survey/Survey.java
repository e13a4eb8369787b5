package org.cellgauge.survey;

import io.reactivex.rxjava3.core.Flowable;
import java.util.ArrayList;
import java.util.List;
import org.cellgauge.cell.Cell;
import org.cellgauge.cell.InputRefusedException;
import org.cellgauge.internal.survey.SurveyProgress;
import org.cellgauge.settings.CheckSettings;
import org.cellgauge.vision.Detections;

/**
 * Many photos of one cell, that may arrive one by one; immutable: every photo makes a new survey, whose mode is sought
 * from that of the one before.
 *
 * <p>Unknown are the pose of every camera, one error of placement of every reference and plate that is the same in all
 * photos, the pose of every object that stands still, what the calibration leaves open of the lens, sizes of prints and
 * where the edges of every photo lie. Photos that cannot be used are named and left out; they never stop the others.
 *
 * <p>The same photos in the same order give the same figures.
 */
public final class Survey {
    private final SurveyProgress progress;
    private final CheckSettings settings;

    private Survey(SurveyProgress progress, CheckSettings settings) {
        this.progress = progress;
        this.settings = settings;
    }

    /**
     * A survey without photos.
     *
     * @param cell the cell
     * @param settings what is modelled of the camera, and how draws are made; of a model's settings those of intrinsics
     *     count
     * @return the survey
     */
    public static Survey of(Cell cell, CheckSettings settings) {
        return new Survey(SurveyProgress.start(cell, settings), settings);
    }

    /**
     * The survey with one photo more.
     *
     * @param photo markers that were seen in it
     * @return a new survey
     */
    public Survey with(Detections photo) {
        return with(List.of(photo));
    }

    /**
     * The survey with more photos, its mode sought once.
     *
     * @param photos markers that were seen in them
     * @return a new survey
     */
    public Survey with(List<Detections> photos) {
        return new Survey(progress.with(photos), settings);
    }

    /**
     * The survey without the photos that do not fit the others.
     *
     * @return a new survey; this one where all fit
     */
    public Survey withoutMisfits() {
        SurveyProgress left = progress.withoutMisfits();
        return left == progress ? this : new Survey(left, settings);
    }

    /**
     * Number of photos that are used.
     *
     * @return 0 while none can be
     */
    public int used() {
        return progress.used();
    }

    /**
     * What Laplace's approximation says.
     *
     * @return the result without draws
     * @throws InputRefusedException if no photo can be used
     */
    public SurveyResult estimate() {
        return progress.result(false);
    }

    /**
     * What draws of the posterior say: their moments in place of the approximation's.
     *
     * @return the result; draws that do not suffice say so in {@link SurveyResult#run}
     * @throws InputRefusedException if no photo can be used
     */
    public SurveyResult sampled() {
        return progress.result(true);
    }

    /**
     * What has moved since an earlier survey of the cell.
     *
     * @param earlier what that found; {@link SurveyResult#epoch}
     * @param cameraStands whether all photos, those of the earlier survey too, are of a camera that should not have
     *     moved
     * @return everything that both know
     * @throws InputRefusedException if no photo can be used, or the two surveys have nothing in common
     */
    public Drift against(Epoch earlier, boolean cameraStands) {
        return progress.against(earlier, cameraStands);
    }

    /**
     * Surveys of photos as they arrive: after each photo the survey so far.
     *
     * <dl>
     * <dt><b>Backpressure:</b></dt>
     * <dd>Honoured: a photo is asked for where a survey is.</dd>
     * <dt><b>Scheduler:</b></dt>
     * <dd>Works on the thread that photos arrive on.</dd>
     * <dt><b>Error handling:</b></dt>
     * <dd>Photos that cannot be used are named in the result; an error of the source ends the stream.</dd>
     * </dl>
     *
     * @param cell the cell
     * @param photos markers that were seen in them
     * @param settings as for {@link #of}
     * @return one survey for each photo
     */
    public static Flowable<Survey> stream(Cell cell, Flowable<Detections> photos, CheckSettings settings) {
        return photos.scanWith(() -> of(cell, settings), Survey::with).skip(1);
    }

    /**
     * The survey of photos that are all there.
     *
     * @param cell the cell
     * @param photos markers that were seen in them
     * @param settings as for {@link #of}
     * @return the survey
     */
    public static Survey of(Cell cell, List<Detections> photos, CheckSettings settings) {
        return of(cell, settings).with(new ArrayList<>(photos));
    }
}
