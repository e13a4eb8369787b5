package org.cellgauge.internal.plan;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.function.DoubleFunction;
import java.util.function.Function;
import java.util.function.UnaryOperator;
import java.util.stream.Collectors;
import org.cellgauge.cell.CameraCalibration;
import org.cellgauge.cell.Cell;
import org.cellgauge.cell.ChangeKind;
import org.cellgauge.cell.ObjectMarker;
import org.cellgauge.cell.Placement;
import org.cellgauge.cell.Reference;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.internal.geometry.MarkerGeometry;
import org.cellgauge.internal.geometry.Rotations;
import org.cellgauge.internal.pose.IntrinsicsPrior;
import org.cellgauge.internal.vision.CornerForecast;
import org.cellgauge.internal.warning.Decimal;
import org.cellgauge.internal.warning.Listing;
import org.cellgauge.plan.Change;
import org.cellgauge.plan.Layout;
import org.cellgauge.plan.MeasuredDistance;
import org.cellgauge.plan.PlanOptions;
import org.cellgauge.settings.Estimate;
import org.cellgauge.warning.Warning;
import org.jspecify.annotations.Nullable;

/** The changes that a set-up allows, each in a few sizes and, where one size just meets the target, in that. */
final class Levers {
    /** Shares of the stated deviations that more careful placing comes down to. */
    private static final double[] PRECISER = {0.5, 0.2, 0.1, 0.05};
    private static final double[] LARGER = {1.25, 1.5, 2, 3};
    private static final double[] CLOSER = {0.85, 0.7, 0.5};
    private static final double[] ASLANT_DEG = {20, 35, 50};
    private static final double[] ASLANT_QUICKLY_DEG = {35};
    private static final double[] LONGER = {1.33, 1.5, 2};
    private static final double TILT_DEG = 30;
    private static final int AROUND = 8;
    private static final int HALVINGS = 12;
    /** No further apart than this are the sizes that a change is offered in: people set up to so many parts of it. */
    private static final double FINE = 0.02;
    /**
     * What a proposal may take of what is asked, squared: 85 %. Checks of rendered photos state up to a tenth more than
     * is forecast, and a verdict leaves a guard band of twice the Monte Carlo error.
     */
    static final double MEETS = 0.7225;
    /** References that are added at once, at most. */
    static final int MOST_ADDED = 3;
    /** More places of the camera than this, and places of references are tried on the coarser grid. */
    private static final int FEW_VIEWS = 3;
    private static final int BOUND_STEPS = 200;
    /** Centres of plates that are tried, at most. */
    private static final int MOST_PLATES = 24;
    /** From one reference of a plate to the next, in sizes of theirs: a plate of three sizes either way. */
    private static final double PLATE_SPACING = 2;
    /** What a steel rule is good for over the length of a table, mm. */
    private static final double DISTANCE_STD_MM = 0.5;
    private static final int MOST_PHOTOS = 3;
    private static final double PHOTO_DEG = 25;

    private final Layout layout;
    private final PlanOptions options;
    private final CornerForecast forecast;
    private final List<Step> steps = new ArrayList<>();
    private final ReferencePlaces places;
    private final boolean quick;
    /** Whether there is a target that is missed as it is. */
    private final boolean missed;
    private double @Nullable [] bounds;
    private double @Nullable [] founds;

    /**
     * A change in one size.
     *
     * @param group changes of one group exclude each other
     * @param change what to do
     * @param apply makes the layout with it; null where it cannot be made there
     * @param calibrated whether intrinsics count as known then
     */
    record Step(String group, Change change, UnaryOperator<@Nullable Layout> apply, boolean calibrated) {
    }

    /**
     * The changes of a layout.
     *
     * @param layout one photo of references that err independently
     * @param options what to reckon with
     * @param quick whether to leave out what takes long: the finer grid of places, several references at once, their
     *     bound, plates and more photos
     */
    Levers(Layout layout, PlanOptions options, boolean quick) {
        this.layout = layout;
        this.options = options;
        this.quick = quick;
        forecast = new CornerForecast(options.toneCurve(), options.blurPx(), options.noiseGrey());
        places = new ReferencePlaces(layout, options, quick ? ReferencePlaces.Grid.QUICK
                : layout.worldFromCameras().size() > FEW_VIEWS ? ReferencePlaces.Grid.COARSE
                : ReferencePlaces.Grid.FINE);
        missed = layout.cell().target().isAny() && worst(layout, false) > 1;
        placements();
        added();
        raised();
        tilted();
        larger();
        camera();
        if (!quick) {
            plate();
            distance();
            photos();
        }
    }

    Layout layout() {
        return layout;
    }

    List<Step> steps() {
        return steps;
    }

    /** What a layout reaches, in units of the target's square; infinite where it cannot be made. */
    double worst(@Nullable Layout changed, boolean calibrated) {
        return changed == null ? Double.POSITIVE_INFINITY : model(changed, calibrated).worst();
    }

    LayoutModel model(Layout changed, boolean calibrated) {
        return new LayoutModel(changed, forecast, calibrated ? IntrinsicsPrior.KNOWN
                : IntrinsicsPrior.stated(changed.cell(), options.settings().model()));
    }

    private static Cell replaced(Cell cell, Reference by) {
        List<Reference> all = new ArrayList<>();
        cell.references().forEach(r -> all.add(r.id() == by.id() ? by : r));
        return cell.withReferences(all);
    }

    private static Reference find(Cell cell, int id) {
        return cell.references().stream().filter(r -> r.id() == id).findFirst().orElseThrow();
    }

    private static Reference placed(Reference r, double share) {
        Placement p = r.placement();
        return new Reference(r.id(), r.sizeMm(), r.worldFromMarker(), new Placement(p.stdMm(0) * share,
                p.stdMm(1) * share, p.stdMm(2) * share, p.stdRad() * share));
    }

    private static Decimal mm(double value) {
        return Decimal.of(value, value < 1 ? 2 : value < 20 ? 1 : 0);
    }

    private static Decimal degrees(double rad) {
        double value = Math.toDegrees(rad);
        return Decimal.of(value, value < 0.1 ? 3 : 2);
    }

    private void placements() {
        Cell cell = layout.cell();
        double mm = cell.references().stream().mapToDouble(r -> ReferencePlaces.worst(r.placement())).max().orElse(0);
        double rad = cell.references().stream().mapToDouble(r -> r.placement().stdRad()).max().orElse(0);
        double cost = options.cost(ChangeKind.PLACE_PRECISELY) * cell.references().size();
        sizes(PRECISER, share -> new Step("placement",
                new Change(Warning.of(ChangeKind.PLACE_PRECISELY, mm(share * mm), degrees(share * rad)), cost),
                all -> {
                    List<Reference> placed = new ArrayList<>();
                    all.cell().references().forEach(r -> placed.add(placed(r, share)));
                    return all.with(all.cell().withReferences(placed));
                }, false));
        if (cell.references().size() > 1) {
            int id = bestReference(r -> with(placed(r, PRECISER[2])));
            Reference r = find(cell, id);
            sizes(PRECISER, share -> new Step("placement",
                    new Change(Warning.of(ChangeKind.MEASURE_REFERENCE, id,
                            mm(share * ReferencePlaces.worst(r.placement())), degrees(share * r.placement().stdRad())),
                            options.cost(ChangeKind.MEASURE_REFERENCE)),
                    all -> all.with(replaced(all.cell(), placed(find(all.cell(), id), share))), false));
        }
    }

    private Layout with(Reference changed) {
        return layout.with(replaced(layout.cell(), changed));
    }

    /** The reference that a change is best made of. */
    private int bestReference(Function<Reference, @Nullable Layout> changed) {
        int best = layout.cell().references().get(0).id();
        double least = Double.POSITIVE_INFINITY;
        for (Reference r : layout.cell().references()) {
            double reached = worst(changed.apply(r), false);
            if (reached < least) {
                least = reached;
                best = r.id();
            }
        }
        return best;
    }

    /**
     * A change in some sizes, up to the first that meets the target; that one no larger than it needs to be.
     *
     * @param sizes from the least change to the largest
     * @param step the change in a size
     */
    private void sizes(double[] sizes, DoubleFunction<Step> step) {
        double before = 1;
        for (double size : sizes) {
            Step tried = step.apply(size);
            double reached = worst(tried.apply().apply(layout), false);
            if (Double.isInfinite(reached)) {
                continue;
            }
            if (reached <= MEETS && missed) {
                double meets = size;
                double misses = before;
                for (int i = 0; i < HALVINGS && Math.abs(meets - misses) > FINE * Math.abs(meets); i++) {
                    double middle = 0.5 * (meets + misses);
                    if (worst(step.apply(middle).apply().apply(layout), false) <= MEETS) {
                        meets = middle;
                    } else {
                        misses = middle;
                    }
                }
                steps.add(step.apply(meets));
                return;
            }
            steps.add(tried);
            before = size;
        }
    }

    private void added() {
        int count = places.worldFromMarkers.size();
        if (count == 0) {
            return;
        }
        LayoutModel model = model(layout, false);
        List<Design> designs = new ArrayList<>();
        double[][][] candidates = new double[count][model.views()][];
        for (int v = 0; v < model.views(); v++) {
            designs.add(model.design(v));
            for (int c = 0; c < count; c++) {
                double[] information = model.view(v).information(places.worldFromMarkers.get(c), places.sizeMm,
                        places.placement);
                candidates[c][v] = information == null ? new double[model.view(v).unknowns()
                        * model.view(v).unknowns()] : information;
            }
        }
        bounds = new double[MOST_ADDED];
        founds = new double[MOST_ADDED];
        for (int size = 1; size <= (quick ? 1 : MOST_ADDED); size++) {
            double[][] base = new double[model.views()][];
            for (int v = 0; v < base.length; v++) {
                base[v] = model.information(v, List.of(), size);
            }
            SubsetSearch search = new SubsetSearch(designs, base, candidates, places::both);
            SubsetSearch.Choice choice = search.best(size);
            if (choice == null) {
                return;
            }
            // with one, all were tried
            founds[size - 1] = choice.worst();
            bounds[size - 1] = size == 1 ? choice.worst() : search.bound(size, BOUND_STEPS);
            List<Reference> more = new ArrayList<>();
            List<Change> changes = new ArrayList<>();
            Set<Integer> taken = taken();
            for (int member : choice.members()) {
                RigidTransform pose = places.worldFromMarkers.get(member);
                int id = free(taken);
                more.add(new Reference(id, places.sizeMm, pose, places.placement));
                changes.add(change(pose));
            }
            Change together = size == 1 ? changes.get(0) : null;
            steps.add(new Step("added", together == null ? joined(changes) : together, all -> {
                List<Reference> references = new ArrayList<>(all.cell().references());
                references.addAll(more);
                return all.with(all.cell().withReferences(references));
            }, false));
        }
    }

    private Set<Integer> taken() {
        Set<Integer> taken = new LinkedHashSet<>();
        layout.cell().references().forEach(r -> taken.add(r.id()));
        layout.cell().objects().forEach(o -> taken.add(o.id()));
        return taken;
    }

    /** The smallest id of the family that is not taken yet, which it is then. */
    private int free(Set<Integer> taken) {
        int id = 0;
        while (taken.contains(id) || !layout.cell().family().has(id)) {
            id++;
        }
        taken.add(id);
        return id;
    }

    /** Four references on one plate, flat, at the best of some places where all of them are clear. */
    private void plate() {
        double half = 0.5 * PLATE_SPACING * places.sizeMm;
        List<RigidTransform> middles = places.clearPlates(half);
        int every = Math.max(1, (middles.size() + MOST_PLATES - 1) / MOST_PLATES);
        Step best = null;
        double least = Double.POSITIVE_INFINITY;
        for (int m = every / 2; m < middles.size(); m += every) {
            Step step = plate(middles.get(m), half);
            double reached = worst(step.apply().apply(layout), false);
            if (reached < least) {
                least = reached;
                best = step;
            }
        }
        if (best != null) {
            steps.add(best);
        }
    }

    private Step plate(RigidTransform middle, double half) {
        Set<Integer> taken = taken();
        List<Reference> four = new ArrayList<>();
        for (int i = 0; i < 4; i++) {
            four.add(new Reference(free(taken), places.sizeMm, middle.compose(ReferencePlaces.onPlate(i, half)),
                    places.placement));
        }
        double[] at = middle.translationMm();
        return new Step("added", new Change(Warning.of(ChangeKind.ADD_PLATE, Decimal.shortest(places.sizeMm),
                whole(2 * half), whole(at[0]), whole(at[1]), whole(at[2])), options.cost(ChangeKind.ADD_PLATE)),
                all -> {
                    List<Reference> references = new ArrayList<>(all.cell().references());
                    references.addAll(four);
                    return all.with(all.cell().withReferences(references))
                            .withPlate(four.stream().map(Reference::id).collect(Collectors.toList()));
                }, false);
    }

    /** The distance between the two references where it helps most. */
    private void distance() {
        List<Reference> references = layout.cell().references();
        Step best = null;
        double least = Double.POSITIVE_INFINITY;
        for (int i = 0; i < references.size(); i++) {
            for (int j = 0; j < i; j++) {
                MeasuredDistance distance = new MeasuredDistance(references.get(j).id(), references.get(i).id(),
                        DISTANCE_STD_MM);
                Step step = new Step("distance", new Change(Warning.of(ChangeKind.MEASURE_DISTANCE, distance.first(),
                        distance.second(), Decimal.shortest(DISTANCE_STD_MM)),
                        options.cost(ChangeKind.MEASURE_DISTANCE)), all -> all.withDistance(distance), false);
                double reached = worst(step.apply().apply(layout), false);
                if (reached < least) {
                    least = reached;
                    best = step;
                }
            }
        }
        if (best != null) {
            steps.add(best);
        }
    }

    /** More photos, each from the side of where the camera stands that helps most beside those before. */
    private void photos() {
        double[] centre = centre();
        RigidTransform camera = layout.worldFromCameras().get(0);
        List<RigidTransform> chosen = new ArrayList<>();
        for (int k = 1; k <= MOST_PHOTOS; k++) {
            RigidTransform best = null;
            double least = Double.POSITIVE_INFINITY;
            for (int a = 0; a <= AROUND; a++) {
                // the last is one more from where it stands
                RigidTransform other = camera.inverse().compose(a == AROUND ? camera
                        : aslant(camera, centre, PHOTO_DEG, 2 * Math.PI * a / AROUND));
                List<RigidTransform> others = new ArrayList<>(chosen);
                others.add(other);
                double reached = worst(seen(layout.withOtherPhotos(others)), false);
                if (reached < least) {
                    least = reached;
                    best = other;
                }
            }
            if (best == null) {
                return;
            }
            chosen.add(best);
            List<RigidTransform> others = List.copyOf(chosen);
            List<Object> where = new ArrayList<>();
            for (RigidTransform other : others) {
                double[] at = camera.compose(other).translationMm();
                where.add("(" + whole(at[0]) + ", " + whole(at[1]) + ", " + whole(at[2]) + ")");
            }
            steps.add(new Step("photos", new Change(Warning.of(ChangeKind.MORE_PHOTOS, Listing.and(where)),
                    options.cost(ChangeKind.MORE_PHOTOS) * k), all -> seen(all.withOtherPhotos(others)), false));
        }
    }

    private Change change(RigidTransform pose) {
        double[] at = pose.translationMm();
        double[] euler = pose.eulerRad();
        return new Change(Warning.of(ChangeKind.ADD_REFERENCE, Decimal.shortest(places.sizeMm), whole(at[0]),
                whole(at[1]), whole(at[2]), whole(Math.toDegrees(euler[0])), whole(Math.toDegrees(euler[1])),
                whole(Math.toDegrees(euler[2]))),
                options.cost(ChangeKind.ADD_REFERENCE));
    }

    private static Decimal whole(double value) {
        // adding 0 makes 0 of -0
        return Decimal.of(Math.rint(value) + 0.0, 0);
    }

    /** Several references at once, as one change whose words are a row. */
    private Change joined(List<Change> changes) {
        List<Object> words = new ArrayList<>();
        changes.forEach(change -> words.add(change.words()));
        return new Change(Warning.of(ChangeKind.ADD_REFERENCES, Listing.and(words)),
                changes.stream().mapToDouble(Change::cost).sum());
    }

    /**
     * What the search found for so many added references, by the same model as {@link #bound}: with more markers a
     * forecast believes a little less in noise beside that of fits, which the search leaves as it is.
     *
     * @param size 1 to {@link #MOST_ADDED}
     * @return what the best choice reaches, in units of the target's square; NaN where none fit
     */
    double found(int size) {
        return founds == null ? Double.NaN : founds[size - 1];
    }

    /**
     * The certificate of so many added references.
     *
     * @param size 1 to {@link #MOST_ADDED}
     * @return a lower bound of what any so many at these places can reach, in units of the target's square; NaN where
     *     none fit
     */
    double bound(int size) {
        return bounds == null ? Double.NaN : bounds[size - 1];
    }

    private void raised() {
        if (!(options.maxHeightMm() > 0)) {
            return;
        }
        double most = options.maxHeightMm();
        int id = bestReference(r -> lifted(layout, r.id(), most));
        double[] heights = {most / 4, most / 2, most};
        double[] whole = Arrays.stream(heights).map(Math::rint).toArray();
        sizesFrom(whole, height -> new Step("raised",
                new Change(Warning.of(ChangeKind.RAISE_REFERENCE, id, whole(height)),
                        options.cost(ChangeKind.RAISE_REFERENCE)),
                all -> lifted(all, id, height), false));
    }

    private void sizesFrom(double[] sizes, DoubleFunction<Step> step) {
        for (double size : sizes) {
            Step tried = step.apply(size);
            double reached = worst(tried.apply().apply(layout), false);
            if (!Double.isInfinite(reached)) {
                steps.add(tried);
                if (reached <= MEETS && missed) {
                    return;
                }
            }
        }
    }

    private @Nullable Layout lifted(Layout all, int id, double heightMm) {
        Reference r = find(all.cell(), id);
        return moved(all, r, r.worldFromMarker().compose(RigidTransform.ofEuler(0, 0, heightMm, 0, 0, 0)));
    }

    private @Nullable Layout moved(Layout all, Reference r, RigidTransform to) {
        Reference moved = new Reference(r.id(), r.sizeMm(), to, r.placement());
        return places.allows(moved) ? all.with(replaced(all.cell(), moved)) : null;
    }

    private void tilted() {
        Step best = null;
        double least = Double.POSITIVE_INFINITY;
        for (Reference r : layout.cell().references()) {
            for (int axis = 0; axis < 2; axis++) {
                for (int sign = -1; sign <= 1; sign += 2) {
                    double[] turn = new double[3];
                    turn[axis] = Math.toRadians(sign * TILT_DEG);
                    RigidTransform by = RigidTransform.ofRotationVector(turn, new double[3]);
                    int id = r.id();
                    Step step = new Step("tilted", new Change(Warning.of(ChangeKind.TILT_REFERENCE, id,
                            whole(sign * TILT_DEG), axis == 0 ? "x" : "y"),
                            options.cost(ChangeKind.TILT_REFERENCE)), all -> {
                                Reference now = find(all.cell(), id);
                                return moved(all, now, now.worldFromMarker().compose(by));
                            }, false);
                    double reached = worst(step.apply().apply(layout), false);
                    if (reached < least) {
                        least = reached;
                        best = step;
                    }
                }
            }
        }
        if (best != null) {
            steps.add(best);
        }
    }

    private void larger() {
        Cell cell = layout.cell();
        double smallestObject = cell.objects().stream().mapToDouble(ObjectMarker::sizeMm).min().orElse(0);
        double smallest = cell.references().stream().mapToDouble(Reference::sizeMm).min().orElse(0);
        if (smallestObject > 0) {
            sizes(LARGER, factor -> new Step("objects",
                    new Change(Warning.of(ChangeKind.LARGER_OBJECT_MARKERS, Decimal.of(factor, 2),
                            whole(factor * smallestObject)),
                            options.cost(ChangeKind.LARGER_OBJECT_MARKERS) * cell.objects().size()),
                    all -> {
                        List<ObjectMarker> larger = new ArrayList<>();
                        all.cell().objects().forEach(o ->
                                larger.add(new ObjectMarker(o.id(), o.sizeMm() * factor, o.gripMm())));
                        return all.with(all.cell().withObjects(larger));
                    }, false));
        }
        sizes(LARGER, factor -> new Step("references",
                new Change(Warning.of(ChangeKind.LARGER_REFERENCE_MARKERS, Decimal.of(factor, 2),
                        whole(factor * smallest)),
                        options.cost(ChangeKind.LARGER_REFERENCE_MARKERS) * cell.references().size()),
                all -> {
                    List<Reference> larger = new ArrayList<>();
                    for (Reference r : all.cell().references()) {
                        Reference by = new Reference(r.id(), r.sizeMm() * factor, r.worldFromMarker(), r.placement());
                        if (!places.allows(by)) {
                            return null;
                        }
                        larger.add(by);
                    }
                    return all.with(all.cell().withReferences(larger));
                }, false));
    }

    private void camera() {
        double[] centre = centre();
        sizes(CLOSER, share -> {
            List<RigidTransform> nearer = new ArrayList<>();
            for (RigidTransform pose : layout.worldFromCameras()) {
                nearer.add(RigidTransform.of(pose.rotation(), between(centre, pose.translationMm(), share)));
            }
            double[] at = nearer.get(0).translationMm();
            return new Step("camera", new Change(Warning.of(ChangeKind.CAMERA_CLOSER, whole(at[0]),
                    whole(at[1]), whole(at[2]), whole(100 * share)),
                    options.cost(ChangeKind.CAMERA_CLOSER)), all -> seen(all.withCameras(nearer)), false);
        });
        for (double degrees : quick ? ASLANT_QUICKLY_DEG : ASLANT_DEG) {
            Step best = null;
            double least = Double.POSITIVE_INFINITY;
            for (int k = 0; k < AROUND; k++) {
                Step step = aslant(centre, degrees, 2 * Math.PI * k / AROUND);
                double reached = worst(step.apply().apply(layout), false);
                if (reached < least) {
                    least = reached;
                    best = step;
                }
            }
            if (best != null) {
                steps.add(best);
            }
        }
        PinholeCamera lens = layout.cell().camera();
        double focal = lens.get(PinholeCamera.FX);
        sizes(LONGER, factor -> new Step("lens",
                new Change(Warning.of(ChangeKind.LONGER_LENS, whole(factor * focal), Decimal.of(factor, 2)),
                        options.cost(ChangeKind.LONGER_LENS)),
                all -> seen(all.with(seenBy(all.cell(), all.cell().camera().withFocal(
                        factor * all.cell().camera().get(PinholeCamera.FX),
                        factor * all.cell().camera().get(PinholeCamera.FY))))), false));
        steps.add(new Step("pixels", new Change(Warning.of(ChangeKind.MORE_PIXELS, 2 * lens.widthPx(),
                2 * lens.heightPx()), options.cost(ChangeKind.MORE_PIXELS)),
                all -> all.with(seenBy(all.cell(), all.cell().camera().resized(2 * all.cell().camera().widthPx(),
                        2 * all.cell().camera().heightPx()))), false));
        if (options.settings().model().estimate() != Estimate.NONE) {
            steps.add(new Step("calibration", new Change(Warning.of(ChangeKind.CALIBRATE),
                    options.cost(ChangeKind.CALIBRATE)), all -> all, true));
        }
    }

    /** The same cell seen by another camera that is calibrated as well, in shares of its values. */
    private static Cell seenBy(Cell cell, PinholeCamera other) {
        CameraCalibration calibration = cell.calibration();
        if (calibration == null) {
            return cell.withCamera(other);
        }
        int[] indices = calibration.indices(other.lens());
        double[] covariance = calibration.covariance();
        for (int i = 0; i < covariance.length; i++) {
            covariance[i] *= scale(cell.camera(), other, indices[i / indices.length])
                    * scale(cell.camera(), other, indices[i % indices.length]);
        }
        return cell.withCamera(other).withCalibration(
                new CameraCalibration(calibration.parameters(), covariance, calibration.photos()));
    }

    private static double scale(PinholeCamera from, PinholeCamera to, int index) {
        return switch (index) {
            case PinholeCamera.FX, PinholeCamera.FY -> to.get(index) / from.get(index);
            case PinholeCamera.CX, PinholeCamera.CY -> (double) to.widthPx() / from.widthPx();
            default -> 1;
        };
    }

    private Step aslant(double[] centre, double degrees, double around) {
        List<RigidTransform> aslant = new ArrayList<>();
        for (RigidTransform pose : layout.worldFromCameras()) {
            aslant.add(aslant(pose, centre, degrees, around));
        }
        double[] at = aslant.get(0).translationMm();
        return new Step("camera", new Change(Warning.of(ChangeKind.CAMERA_ASLANT, whole(at[0]),
                whole(at[1]), whole(at[2]), whole(degrees)),
                options.cost(ChangeKind.CAMERA_ASLANT)), all -> seen(all.withCameras(aslant)), false);
    }

    private static RigidTransform aslant(RigidTransform pose, double[] centre, double degrees, double around) {
        // about an axis of the image, so that the camera goes round what it sees
        double[] r = pose.rotation();
        double[] axis = new double[3];
        for (int i = 0; i < 3; i++) {
            axis[i] = Math.toRadians(degrees) * (Math.cos(around) * r[3 * i] + Math.sin(around) * r[3 * i + 1]);
        }
        double[] turn = new double[9];
        double[] turned = new double[9];
        Rotations.exp(axis[0], axis[1], axis[2], turn);
        Rotations.multiply(turn, r, turned);
        double[] at = pose.translationMm();
        double[] moved = RigidTransform.of(turn, new double[3]).apply(at[0] - centre[0], at[1] - centre[1],
                at[2] - centre[2]);
        for (int i = 0; i < 3; i++) {
            moved[i] += centre[i];
        }
        return RigidTransform.of(turned, moved);
    }

    /** A layout in which no reference is lost from sight that was seen before; null where one is. */
    private @Nullable Layout seen(Layout changed) {
        return seenReferences(changed) < seenReferences(layout) ? null : changed;
    }

    /** How many references every photo shows, from wherever the camera may stand. */
    private static long seenReferences(Layout of) {
        return of.cell().references().stream().filter(r -> of.worldFromCameras().stream().allMatch(camera ->
                isSeen(of, camera, r) && of.cameraFromOthers().stream().allMatch(other ->
                        isSeen(of, camera.compose(other), r)))).count();
    }

    private static boolean isSeen(Layout of, RigidTransform worldFromCamera, Reference r) {
        return MarkerGeometry.seenPx(of.cell().camera(), worldFromCamera.inverse().compose(r.worldFromMarker()),
                r.sizeMm()) != null;
    }

    private double[] centre() {
        double[] centre = new double[3];
        List<double[]> points = new ArrayList<>();
        layout.cell().references().forEach(r -> points.add(r.worldFromMarker().translationMm()));
        layout.worldFromObjects().values().forEach(all -> all.forEach(pose -> points.add(pose.translationMm())));
        for (double[] point : points) {
            for (int i = 0; i < 3; i++) {
                centre[i] += point[i] / points.size();
            }
        }
        return centre;
    }

    private static double[] between(double[] from, double[] to, double share) {
        double[] out = new double[3];
        for (int i = 0; i < 3; i++) {
            out[i] = from[i] + share * (to[i] - from[i]);
        }
        return out;
    }
}
