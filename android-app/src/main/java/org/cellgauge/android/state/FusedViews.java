package org.cellgauge.android.state;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import org.cellgauge.cell.Cell;
import org.cellgauge.cell.InputRefusedException;
import org.cellgauge.settings.CheckSettings;
import org.cellgauge.survey.Survey;
import org.cellgauge.survey.SurveyResult;
import org.cellgauge.survey.SurveyedObject;
import org.cellgauge.survey.SurveyedPhoto;
import org.cellgauge.vision.Detections;
import org.cellgauge.vision.MarkerObservation;

/**
 * Views of one cell taken together, as photos of it: core's survey, in which errors of placement are the same in all of
 * them, by Laplace's approximation. It holds where nothing has moved between them; a view that does not fit the others
 * begins a new set. Immutable.
 *
 * <p>What is wrong with a corner is wrong in the same way in the next frame of the same view, so that a view counts
 * only where it is another one.
 */
public final class FusedViews {
    /** As many as a technician takes; the oldest gives way. */
    static final int MOST = 8;
    /** Below this chance of fitting so badly, something has moved. */
    private static final double LEAST_CHANCE = 1e-3;
    /** Views are apart where some marker is by this share of the picture. */
    private static final double APART_SHARE = 0.02;

    private final Cell cell;
    private final CheckSettings settings;
    private final List<Detections> views;
    private final SurveyResult result;

    private FusedViews(Cell cell, CheckSettings settings, List<Detections> views, SurveyResult result) {
        this.cell = cell;
        this.settings = settings;
        this.views = Collections.unmodifiableList(views);
        this.result = result;
    }

    /** No view of a cell yet. */
    static FusedViews none(Cell cell, CheckSettings settings) {
        return new FusedViews(cell, settings, new ArrayList<>(), null);
    }

    /**
     * With one view more; takes some tenths of a second.
     *
     * @param view markers of the view
     * @return a new set; this one where the view is none of its own or cannot be used
     */
    FusedViews with(Detections view) {
        for (Detections other : views) {
            if (!isApart(view, other)) {
                return this;
            }
        }
        List<Detections> all = new ArrayList<>(views.size() < MOST ? views : views.subList(1, MOST));
        all.add(view);
        SurveyResult together = survey(all);
        if (together == null) {
            return this;
        }
        if (!fits(together)) {
            List<Detections> alone = new ArrayList<>(Collections.singletonList(view));
            SurveyResult anew = survey(alone);
            return anew == null ? this : new FusedViews(cell, settings, alone, anew);
        }
        return new FusedViews(cell, settings, all, together);
    }

    private SurveyResult survey(List<Detections> of) {
        try {
            return Survey.of(cell, of, settings).estimate();
        } catch (InputRefusedException e) {
            return null;
        }
    }

    private static boolean fits(SurveyResult result) {
        for (SurveyedPhoto photo : result.photos()) {
            if (!photo.used() || photo.chance() < LEAST_CHANCE) {
                return false;
            }
        }
        return true;
    }

    private static boolean isApart(Detections a, Detections b) {
        double least = APART_SHARE * Math.max(a.widthPx(), a.heightPx());
        boolean common = false;
        for (MarkerObservation marker : a.markers()) {
            MarkerObservation other = b.find(marker.id());
            if (other != null) {
                common = true;
                double[] p = marker.cornersPx();
                double[] q = other.cornersPx();
                for (int i = 0; i < p.length; i += 2) {
                    if (Math.hypot(p[i] - q[i], p[i + 1] - q[i + 1]) > least) {
                        return true;
                    }
                }
            }
        }
        return !common;
    }

    /**
     * How many views are taken together.
     *
     * @return 0 or more
     */
    public int count() {
        return views.size();
    }

    /**
     * Standard deviations of an object's position by all views.
     *
     * @param objectId marker id
     * @return along world x, y and z, mm; null where they do not tell, or two poses fit
     */
    public double[] stdMm(int objectId) {
        if (result != null) {
            for (SurveyedObject object : result.objects()) {
                if (object.marker().id() == objectId && !object.ambiguous()) {
                    double[] std = object.pose().std();
                    return new double[] {std[0], std[1], std[2]};
                }
            }
        }
        return null;
    }
}
