package org.cellgauge.internal.survey;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import org.cellgauge.cell.Cell;
import org.cellgauge.cell.InputRefusedException;
import org.cellgauge.cell.ObjectMarker;
import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.internal.pose.IntrinsicsPrior;
import org.cellgauge.internal.warning.Listing;
import org.cellgauge.settings.CheckSettings;
import org.cellgauge.survey.Drift;
import org.cellgauge.survey.Epoch;
import org.cellgauge.survey.SurveyRefusal;
import org.cellgauge.survey.SurveyResult;
import org.cellgauge.survey.SurveyWarning;
import org.cellgauge.vision.Detections;
import org.cellgauge.vision.MarkerObservation;
import org.cellgauge.warning.Warning;
import org.jspecify.annotations.Nullable;

/** The photos of a survey so far, and its mode; immutable. */
public final class SurveyProgress {
    /** A turn by which another pose of a camera or an object is another one and no correction, rad. */
    private static final double OTHER_POSE_RAD = 0.1;

    /**
     * A photo that was given.
     *
     * @param detections what it shows
     * @param view the same as the model has it; null for a photo that can be of no use whatever the others show
     * @param why it is left out; null where it is used
     */
    record Entry(Detections detections, @Nullable SurveyView view, @Nullable Warning why) {
        boolean used() {
            return why == null;
        }
    }

    final Cell cell;
    final CheckSettings settings;
    final List<Entry> entries;
    final @Nullable SurveyFit fit;

    private SurveyProgress(Cell cell, CheckSettings settings, List<Entry> entries, @Nullable SurveyFit fit) {
        this.cell = cell;
        this.settings = settings;
        this.entries = Collections.unmodifiableList(entries);
        this.fit = fit;
    }

    /**
     * No photo yet.
     *
     * @param cell the cell
     * @param settings what is modelled, and how draws are made
     * @return the beginning
     */
    public static SurveyProgress start(Cell cell, CheckSettings settings) {
        return new SurveyProgress(cell, settings, new ArrayList<>(), null);
    }

    /**
     * With more photos.
     *
     * @param photos what they show
     * @return the survey with them
     */
    public SurveyProgress with(List<Detections> photos) {
        List<Entry> all = new ArrayList<>(entries);
        for (Detections photo : photos) {
            all.add(entry(photo, all));
        }
        return fitted(all);
    }

    private Entry entry(Detections photo, List<Entry> others) {
        int width = cell.camera().widthPx();
        int height = cell.camera().heightPx();
        if (photo.widthPx() != width || photo.heightPx() != height) {
            return new Entry(photo, null, Warning.of(SurveyWarning.OTHER_SIZE, photo.imageName(), photo.widthPx(),
                    photo.heightPx(), width, height));
        }
        if (photo.light() != null && photo.light().toneCurveOpen()) {
            return new Entry(photo, null, Warning.of(SurveyWarning.TONE_CURVE_OPEN, photo.imageName()));
        }
        for (Entry other : others) {
            if (other.view != null && same(photo, other.detections)) {
                return new Entry(photo, null, Warning.of(SurveyWarning.SAME_PHOTO, photo.imageName(),
                        other.detections.imageName()));
            }
        }
        SurveyView view = new SurveyView(cell, photo);
        return view.size() == 0 ? new Entry(photo, null, Warning.of(SurveyWarning.NOT_LINKED, photo.imageName()))
                : new Entry(photo, view, null);
    }

    private static boolean same(Detections a, Detections b) {
        if (a.markers().isEmpty() || a.markers().size() != b.markers().size()) {
            return false;
        }
        for (MarkerObservation m : a.markers()) {
            MarkerObservation other = b.find(m.id());
            if (other == null || !Arrays.equals(m.cornersPx(), other.cornersPx())) {
                return false;
            }
        }
        return true;
    }

    /** Links photos to each other, and fits those that can be. */
    private SurveyProgress fitted(List<Entry> all) {
        List<Integer> tried = new ArrayList<>();
        for (int e = 0; e < all.size(); e++) {
            Entry entry = all.get(e);
            boolean maybe = entry.why == null || entry.why.kind() == SurveyWarning.NOT_LINKED;
            if (entry.view != null && maybe) {
                tried.add(e);
            }
        }
        List<Entry> out = new ArrayList<>(all);
        SurveyFit found = fit(all, tried, out);
        if (found == null && !tried.isEmpty()) {
            // one of them spoils the search: one after another those are kept that do not
            List<Integer> kept = new ArrayList<>();
            for (int e : tried) {
                List<Integer> more = new ArrayList<>(kept);
                more.add(e);
                List<Entry> trial = new ArrayList<>(all);
                SurveyFit next = fit(all, more, trial);
                if (next != null) {
                    kept = more;
                    found = next;
                    tried.forEach(i -> out.set(i, trial.get(i)));
                } else {
                    Entry entry = all.get(e);
                    all.set(e, new Entry(entry.detections, entry.view,
                            Warning.of(SurveyWarning.NO_POSE, entry.detections.imageName())));
                    out.set(e, all.get(e));
                }
            }
        }
        return new SurveyProgress(cell, settings, out, found);
    }

    /** Fits some of the photos; null where there is no mode. Which of them are linked is written to {@code out}. */
    private @Nullable SurveyFit fit(List<Entry> all, List<Integer> tried, List<Entry> out) {
        List<SurveyView> views = new ArrayList<>();
        for (int e : tried) {
            SurveyView view = all.get(e).view;
            if (view != null) {
                views.add(view);
            }
        }
        SurveyStart start = start(views);
        List<SurveyView> linked = new ArrayList<>();
        for (int i = 0; i < views.size(); i++) {
            Entry entry = all.get(tried.get(i));
            boolean posed = start.worldFromCamera(i) != null;
            if (posed) {
                linked.add(views.get(i));
            }
            out.set(tried.get(i), new Entry(entry.detections, entry.view, posed ? null
                    : Warning.of(SurveyWarning.NOT_LINKED, entry.detections.imageName())));
        }
        if (linked.isEmpty()) {
            return null;
        }
        SurveyFit before = fit;
        SurveyFit found = fit(linked, linked.size() == views.size() ? start : start(linked));
        if (found == null) {
            return null;
        }
        // with references where they stand, a pose that was mirrored may be seen for what it is
        SurveyStart again = again(linked, before, found);
        SurveyFit other = again == null ? null : fit(linked, again);
        return other != null && other.cost < found.cost ? other : found;
    }

    private SurveyStart start(List<SurveyView> views) {
        @Nullable RigidTransform[] cameras = new RigidTransform[views.size()];
        RigidTransform[] references = new RigidTransform[cell.references().size()];
        @Nullable RigidTransform[] objects = new RigidTransform[cell.objects().size()];
        SurveyFit before = fit;
        for (int r = 0; r < references.length; r++) {
            references[r] = before == null ? cell.references().get(r).worldFromMarker()
                    : before.model.worldFromReference(before.mode, r);
        }
        if (before != null) {
            for (int v = 0; v < cameras.length; v++) {
                int known = before.views().indexOf(views.get(v));
                cameras[v] = known < 0 ? null : before.worldFromCamera(known);
            }
            knownObjects(before, objects);
        }
        return new SurveyStart(cell, views, cameras, references, objects);
    }

    private void knownObjects(SurveyFit known, @Nullable RigidTransform[] objects) {
        for (int o = 0; o < objects.length; o++) {
            int at = known.model.layout.object(cell.objects().get(o).id());
            objects[o] = at < 0 ? null : SurveyState.get(known.mode.objects, SurveyState.TRANSFORM * at);
        }
    }

    /** A start from where a fit has references, with poses of new photos sought anew; null if that finds no others. */
    private @Nullable SurveyStart again(List<SurveyView> views, @Nullable SurveyFit before, SurveyFit found) {
        @Nullable RigidTransform[] cameras = new RigidTransform[views.size()];
        RigidTransform[] references = new RigidTransform[cell.references().size()];
        @Nullable RigidTransform[] objects = new RigidTransform[cell.objects().size()];
        for (int r = 0; r < references.length; r++) {
            references[r] = found.model.worldFromReference(found.mode, r);
        }
        knownObjects(found, objects);
        @Nullable RigidTransform[] placed = objects.clone();
        for (int o = 0; o < objects.length; o++) {
            boolean known = before != null && before.model.layout.object(cell.objects().get(o).id()) >= 0;
            objects[o] = known ? objects[o] : null;
        }
        for (int v = 0; v < cameras.length; v++) {
            boolean known = before != null && before.views().contains(views.get(v));
            cameras[v] = known ? found.worldFromCamera(v) : null;
        }
        SurveyStart start = new SurveyStart(cell, views, cameras, references, objects);
        boolean other = false;
        for (int v = 0; v < cameras.length; v++) {
            RigidTransform pose = start.worldFromCamera(v);
            if (pose == null) {
                return null;
            }
            other |= pose.angleRadTo(found.worldFromCamera(v)) > OTHER_POSE_RAD;
        }
        for (int o = 0; o < objects.length; o++) {
            RigidTransform pose = start.worldFromObject(o);
            RigidTransform now = placed[o];
            other |= pose != null && now != null && pose.angleRadTo(now) > OTHER_POSE_RAD;
        }
        return other ? start : null;
    }

    private @Nullable SurveyFit fit(List<SurveyView> views, SurveyStart start) {
        List<ObjectMarker> seen = new ArrayList<>();
        for (int o = 0; o < cell.objects().size(); o++) {
            if (start.worldFromObject(o) != null && !cell.objects().get(o).moves()) {
                seen.add(cell.objects().get(o));
            }
        }
        SurveyLayout layout = new SurveyLayout(cell, seen, IntrinsicsPrior.stated(cell, settings.model()));
        double[] trust = new double[cell.references().size()];
        Arrays.fill(trust, 1);
        SurveyModel model = new SurveyModel(layout, views, trust);
        SurveyState state = start.state(layout, model.centreMm);
        SurveyFit before = fit;
        if (before != null) {
            state.warm(before.mode, before.views(), views);
        }
        return SurveyFit.of(model, state);
    }

    /**
     * Number of photos that are used.
     *
     * @return 0 while none can be
     */
    public int used() {
        return (int) entries.stream().filter(Entry::used).count();
    }

    /**
     * Without the photos that do not fit the others.
     *
     * @return this where all fit
     */
    public SurveyProgress withoutMisfits() {
        SurveyProgress now = this;
        while (now.fit != null && now.used() > 2) {
            SurveyAnalysis analysis = SurveyAnalysis.of(now);
            int worst = analysis.worstMisfit();
            if (worst < 0) {
                return now;
            }
            Warning why = analysis.misfit(worst);
            SurveyView left = analysis.fit.views().get(worst);
            List<Entry> kept = new ArrayList<>();
            for (Entry e : now.entries) {
                kept.add(e.view == left ? new Entry(e.detections, e.view, why) : e);
            }
            now = new SurveyProgress(cell, settings, kept, now.fit).fitted(kept);
        }
        return now;
    }

    /**
     * What the photos say.
     *
     * @param sampled whether by draws
     * @return the result
     * @throws InputRefusedException if no photo can be used
     */
    public SurveyResult result(boolean sampled) {
        requirePhoto();
        return SurveyAnalysis.of(this).result(sampled);
    }

    /**
     * What has moved since an earlier survey.
     *
     * @param earlier what that found
     * @param cameraStands whether the camera of all photos should not have moved
     * @return everything that both know
     * @throws InputRefusedException if no photo can be used, or the two have nothing in common
     */
    public Drift against(Epoch earlier, boolean cameraStands) {
        requirePhoto();
        Drift drift = SurveyAnalysis.of(this).against(earlier, cameraStands);
        if (drift.bodies().isEmpty()) {
            throw new InputRefusedException("survey", SurveyRefusal.NOTHING_IN_COMMON);
        }
        return drift;
    }

    private void requirePhoto() {
        if (fit == null) {
            List<Warning> reasons = new ArrayList<>();
            entries.forEach(e -> {
                if (e.why != null) {
                    reasons.add(e.why);
                }
            });
            throw new InputRefusedException("survey", SurveyRefusal.NO_PHOTO, entries.size(),
                    Listing.semicolon(reasons));
        }
    }
}
