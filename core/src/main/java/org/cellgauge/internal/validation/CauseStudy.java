package org.cellgauge.internal.validation;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.function.IntConsumer;
import org.apache.commons.math3.random.RandomGenerator;
import org.cellgauge.cell.Cell;
import org.cellgauge.cell.InputRefusedException;
import org.cellgauge.cell.ObjectMarker;
import org.cellgauge.cell.Reference;
import org.cellgauge.check.CellCheck;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.internal.geometry.Lenses;
import org.cellgauge.internal.sampling.RandomStreams;
import org.cellgauge.placement.Cause;
import org.cellgauge.placement.CauseFit;
import org.cellgauge.placement.Explanation;
import org.cellgauge.placement.MisplacedReference;
import org.cellgauge.placement.ReferenceCheck;
import org.cellgauge.placement.ReferenceFit;
import org.cellgauge.settings.CheckSettings;
import org.cellgauge.vision.Detections;
import org.cellgauge.vision.EdgeShift;
import org.cellgauge.vision.MarkerObservation;
import org.jspecify.annotations.Nullable;

/**
 * How often a cause of misfit is named: simulated cells whose file is wrong by it, or whose photo is, each checked
 * without chains.
 */
public final class CauseStudy {
    private static final long STREAM_NOISE = 131;
    private static final long STREAM_CAUSE = 132;
    /** Units that lengths of a cell file may be stated in, mm. */
    private static final double[] UNITS_MM = {10, 25.4, 1000};
    /** Shares and shifts beyond these are no error but another world. */
    private static final double LARGEST_SHARE = 0.3;
    /** A size beyond this is said to be the scale of positions, which is one and the same to every photo. */
    private static final double LARGEST_SIZE_SHARE = 0.14;
    private static final double LARGEST_EDGE_PX = 3;
    private static final double LARGEST_SHIFT_PX = 300;
    private static final double LARGEST_BEND = 0.3;
    private static final double LARGEST_OFFSET_MM = 200;

    /** What became of the cells; immutable. */
    public static final class Figures {
        private final int cells;
        private final int skipped;
        private final int first;
        private final int listed;
        private final int silent;
        private final int alarms;
        private final Map<Cause, Integer> instead;

        private Figures(int cells, int skipped, int first, int listed, int silent, int alarms,
                Map<Cause, Integer> instead) {
            this.cells = cells;
            this.skipped = skipped;
            this.first = first;
            this.listed = listed;
            this.silent = silent;
            this.alarms = alarms;
            this.instead = Collections.unmodifiableMap(instead);
        }

        /** Cells checked. */
        public int cells() {
            return cells;
        }

        /** Cells left out, as the cause would not show in them at any size that makes sense. */
        public int skipped() {
            return skipped;
        }

        /** Cells in which the cause is named first. */
        public int first() {
            return first;
        }

        /** Cells in which it is named first, or as what it may be instead. */
        public int listed() {
            return listed;
        }

        /** Cells in which nothing is named, nor that anything does not fit. */
        public int silent() {
            return silent;
        }

        /** Cells in which anything is said: a cause, a reference, corner noise, or that references do not fit. */
        public int alarms() {
            return alarms;
        }

        /** What was named first in place of the cause, how often. */
        public Map<Cause, Integer> instead() {
            return instead;
        }
    }

    /** What became of one cell. */
    private static final class Outcome {
        private boolean skipped;
        private boolean first;
        private boolean listed;
        private boolean alarm;
        private @Nullable Cause named;
    }

    private final CellSource source;
    private final @Nullable Cause cause;
    private final double leastStds;
    private final double mostStds;
    private final boolean apart;
    private final CheckSettings settings;

    /**
     * A study.
     *
     * @param source cells as they really are, and as they would rightly be stated
     * @param cause what is wrong with each; null: nothing
     * @param leastStds least size of a cause that has one, in its standard deviations
     * @param mostStds largest such size; sizes are uniform between the two
     * @param apart whether these are of a size that the photo tells from any other one cause
     * @param settings of the check
     */
    public CauseStudy(CellSource source, @Nullable Cause cause, double leastStds, double mostStds, boolean apart,
            CheckSettings settings) {
        this.source = source;
        this.cause = cause;
        this.leastStds = leastStds;
        this.mostStds = mostStds;
        this.apart = apart;
        this.settings = settings;
    }

    /**
     * Runs it.
     *
     * @param cells how many cells are checked
     * @param progress told how many are done
     * @return the counts; the same for every number of threads
     */
    public Figures run(int cells, IntConsumer progress) {
        List<Outcome> outcomes = InOrder.run(cells, settings.sampling().threads(), this::one, progress);
        int skipped = 0;
        int first = 0;
        int listed = 0;
        int alarms = 0;
        Map<Cause, Integer> instead = new EnumMap<>(Cause.class);
        for (Outcome outcome : outcomes) {
            skipped += outcome.skipped ? 1 : 0;
            first += outcome.first ? 1 : 0;
            listed += outcome.listed ? 1 : 0;
            alarms += outcome.alarm ? 1 : 0;
            if (outcome.named != null && !outcome.first) {
                instead.merge(outcome.named, 1, Integer::sum);
            }
        }
        int checked = cells - skipped;
        return new Figures(checked, skipped, first, listed, checked - alarms, alarms, instead);
    }

    private Outcome one(int index) {
        long seed = settings.sampling().seed();
        Outcome outcome = new Outcome();
        RandomGenerator random = RandomStreams.of(seed, STREAM_CAUSE, index);
        Wrong wrong = null;
        ReferenceCheck check = null;
        try {
            SimulatedCell real = source.cell(seed, index);
            Detections detections = DrawnCorners.asStated().detect(real, RandomStreams.of(seed, STREAM_NOISE, index));
            wrong = cause == null ? new Wrong(real.cell(), detections) : wrong(real.cell(), detections, random);
            check = wrong == null ? null
                    : CellCheck.quickLook(wrong.cell, wrong.detections, settings, null).referenceCheck();
        } catch (InputRefusedException e) {
            // a photo that shows no pose of a marker is no matter of causes
            wrong = null;
        }
        if (wrong == null || check == null) {
            outcome.skipped = true;
            return outcome;
        }
        outcome.alarm = !check.causes().isEmpty() || !check.misplaced().isEmpty() || check.contradictory()
                || !check.noise().holds();
        if (!check.causes().isEmpty() && !(cause == Cause.REFERENCE_OFF && !check.misplaced().isEmpty())) {
            Explanation best = check.causes().get(0);
            outcome.named = best.cause();
            outcome.first = wrong.isNamedBy(best);
            outcome.listed = outcome.first || best.orInstead().stream().anyMatch(wrong::isNamedBy);
        }
        if (!check.misplaced().isEmpty() && !outcome.first) {
            MisplacedReference worst = check.misplaced().get(0);
            outcome.named = Cause.REFERENCE_OFF;
            outcome.first = cause == Cause.REFERENCE_OFF && worst.id() == wrong.reference;
            outcome.listed |= outcome.first || worst.others().stream().anyMatch(wrong::isNamedBy);
        }
        return outcome;
    }

    /** A cell that is not what it is stated to be, or a photo that is not what it should be. */
    private final class Wrong {
        private final Cell cell;
        private final Detections detections;
        private int reference = -1;
        private int other = -1;
        private int axis = -1;
        private double size = Double.NaN;

        Wrong(Cell cell, Detections detections) {
            this.cell = cell;
            this.detections = detections;
        }

        boolean isNamedBy(Explanation e) {
            if (e.cause() != cause || (axis >= 0 && e.axis() != axis)) {
                return false;
            }
            switch (e.cause()) {
                case EXCHANGED:
                    return e.references().contains(reference) && e.references().contains(other);
                case TURNED:
                    return e.references().contains(reference) && e.size()[0] == size;
                case ALL_TURNED:
                case POSITION_UNIT:
                case SIZE_UNIT:
                    return e.size()[0] == size;
                case SIZE_OF_SOME:
                case REFERENCE_OFF:
                case REFERENCE_ELSEWHERE:
                    return e.references().contains(reference);
                default:
                    return true;
            }
        }
    }

    private @Nullable Wrong wrong(Cell cell, Detections seen, RandomGenerator random) {
        List<Reference> references = cell.references();
        int n = references.size();
        int m = random.nextInt(n);
        int quarters = 1 + random.nextInt(3);
        List<Reference> stated = new ArrayList<>(references);
        Wrong wrong;
        switch (Objects.requireNonNull(cause, "nothing is wrong then")) {
            case EXCHANGED:
                int k = n < 2 ? m : (m + 1 + random.nextInt(n - 1)) % n;
                stated.set(m, placed(references.get(m), references.get(k).worldFromMarker()));
                stated.set(k, placed(references.get(k), references.get(m).worldFromMarker()));
                wrong = new Wrong(with(cell, stated, cell.camera(), 1), seen);
                wrong.reference = references.get(m).id();
                wrong.other = references.get(k).id();
                return n < 2 ? null : wrong;
            case TURNED:
                stated.set(m, turned(references.get(m), -quarters));
                wrong = new Wrong(with(cell, stated, cell.camera(), 1), seen);
                wrong.reference = references.get(m).id();
                wrong.size = quarters;
                return n < 2 ? null : wrong;
            case ALL_TURNED:
                stated.replaceAll(r -> turned(r, -quarters));
                wrong = new Wrong(with(cell, stated, cell.camera(), 1), seen);
                wrong.size = quarters;
                return n < 2 ? null : wrong;
            case MIRRORED:
                int axis = random.nextInt(3);
                stated.replaceAll(r -> scaled(r, axis, -1));
                wrong = new Wrong(with(cell, stated, cell.camera(), 1), seen);
                wrong.axis = axis;
                return n < 2 ? null : wrong;
            case RADIANS:
                stated.replaceAll(CauseStudy::inRadians);
                return n < 2 ? null : new Wrong(with(cell, stated, cell.camera(), 1), seen);
            case POSITION_UNIT:
            case SIZE_UNIT:
                double mm = UNITS_MM[random.nextInt(UNITS_MM.length)];
                boolean ofSizes = cause == Cause.SIZE_UNIT;
                if (!ofSizes) {
                    stated.replaceAll(r -> scaled(scaled(scaled(r, 0, 1 / mm), 1, 1 / mm), 2, 1 / mm));
                }
                wrong = new Wrong(with(cell, stated, cell.camera(), ofSizes ? 1 / mm : 1), seen);
                wrong.size = mm;
                return n < 2 ? null : wrong;
            default:
                return ofSize(cell, seen, m, random);
        }
    }

    /** A cell stated wrong by a cause of so many deviations; null where no size that makes sense shows so clearly. */
    private @Nullable Wrong ofSize(Cell cell, Detections seen, int m, RandomGenerator random) {
        ReferenceCheck asStated = CellCheck.quickLook(cell, seen, settings, null).referenceCheck();
        Reference reference = cell.references().get(m);
        double sign = random.nextBoolean() ? 1 : -1;
        List<Reference> stated = new ArrayList<>(cell.references());
        if (cause == Cause.REFERENCE_OFF) {
            int axis = random.nextInt(3);
            ReferenceFit fit = asStated.fit(reference.id());
            double mm = fit == null ? Double.NaN
                    : stds(random) * (apart ? fit.apartStd() : fit.offsetStd())[axis];
            if (!(mm < LARGEST_OFFSET_MM)) {
                return null;
            }
            double[] t = reference.worldFromMarker().translationMm();
            t[axis] -= sign * mm;
            stated.set(m, placed(reference, RigidTransform.of(reference.worldFromMarker().rotation(), t)));
            Wrong wrong = new Wrong(with(cell, stated, cell.camera(), 1), seen);
            wrong.reference = reference.id();
            return wrong;
        }
        List<CauseFit> fits = new ArrayList<>();
        for (CauseFit fit : asStated.causeFits()) {
            if (fit.cause() == cause) {
                fits.add(fit);
            }
        }
        if (fits.isEmpty()) {
            return null;
        }
        CauseFit fit = fits.get(random.nextInt(fits.size()));
        double size = sign * stds(random) * (apart ? fit.apartStd() : fit.std());
        if (!(Math.abs(size) < largest())) {
            return null;
        }
        double[] intrinsics = cell.camera().intrinsics();
        Detections photo = seen;
        double sizes = 1;
        switch (Objects.requireNonNull(cause, "nothing is wrong then")) {
            case MARKER_SIZE:
                sizes = 1 / (1 + size);
                break;
            case SIZE_OF_SOME:
                stated.replaceAll(r -> fit.references().contains(r.id()) ? ofSize(r, r.sizeMm() / (1 + size)) : r);
                break;
            case FOCAL_LENGTH:
                intrinsics[PinholeCamera.FX] /= 1 + size;
                intrinsics[PinholeCamera.FY] /= 1 + size;
                break;
            case PRINCIPAL_POINT:
                double length = Math.hypot(fit.size()[0], fit.size()[1]);
                intrinsics[PinholeCamera.CX] -= size * fit.size()[0] / length;
                intrinsics[PinholeCamera.CY] -= size * fit.size()[1] / length;
                break;
            case DISTORTION:
                intrinsics[Lenses.FIRST_RADIAL] -= size;
                break;
            case STRETCH:
                stated.replaceAll(r -> scaled(r, fit.axis(), 1 / (1 + size)));
                break;
            case EDGE_SHIFT:
                photo = shifted(seen, size);
                break;
            default:
                return null;
        }
        Wrong wrong = new Wrong(with(cell, stated, cell.camera().withIntrinsics(intrinsics), sizes), photo);
        wrong.axis = fit.axis();
        wrong.reference = fit.references().isEmpty() ? -1 : fit.references().get(0);
        return wrong;
    }

    /** How large a cause is to be, in its standard deviations. */
    private double stds(RandomGenerator random) {
        return leastStds + (mostStds - leastStds) * random.nextDouble();
    }

    private double largest() {
        return cause == Cause.MARKER_SIZE ? LARGEST_SIZE_SHARE : cause == Cause.EDGE_SHIFT ? LARGEST_EDGE_PX
                : cause == Cause.PRINCIPAL_POINT ? LARGEST_SHIFT_PX
                : cause == Cause.DISTORTION ? LARGEST_BEND : LARGEST_SHARE;
    }

    private static Detections shifted(Detections seen, double px) {
        List<MarkerObservation> markers = new ArrayList<>();
        for (MarkerObservation marker : seen.markers()) {
            double[] corners = marker.cornersPx();
            double[] by = EdgeShift.ofCorners(corners);
            for (int i = 0; i < 8; i++) {
                corners[i] += px * by[i];
            }
            markers.add(new MarkerObservation(marker.id(), corners));
        }
        return new Detections(seen.imageName(), seen.widthPx(), seen.heightPx(), markers);
    }

    private static Cell with(Cell cell, List<Reference> references, PinholeCamera camera, double sizes) {
        List<Reference> sized = new ArrayList<>();
        references.forEach(r -> sized.add(sizes == 1 ? r : ofSize(r, sizes * r.sizeMm())));
        List<ObjectMarker> objects = new ArrayList<>();
        cell.objects().forEach(o -> objects.add(new ObjectMarker(o.id(), sizes * o.sizeMm(),
                o.hasGrip() ? o.gripMm() : null)));
        return new Cell(camera, cell.family(), sized, objects, cell.pixelStdPx(), cell.targetStdMm(), cell.prints())
                .withTarget(cell.target());
    }

    private static Reference placed(Reference r, RigidTransform worldFromMarker) {
        return new Reference(r.id(), r.sizeMm(), worldFromMarker, r.placement());
    }

    private static Reference ofSize(Reference r, double sizeMm) {
        return new Reference(r.id(), sizeMm, r.worldFromMarker(), r.placement());
    }

    private static Reference turned(Reference r, int quarters) {
        return placed(r, r.worldFromMarker().compose(RigidTransform.ofEuler(0, 0, 0, 0, 0, quarters * Math.PI / 2)));
    }

    private static Reference scaled(Reference r, int axis, double factor) {
        double[] t = r.worldFromMarker().translationMm();
        t[axis] *= factor;
        return placed(r, RigidTransform.of(r.worldFromMarker().rotation(), t));
    }

    private static Reference inRadians(Reference r) {
        double[] t = r.worldFromMarker().translationMm();
        double[] euler = r.worldFromMarker().eulerRad();
        Arrays.setAll(euler, i -> Math.toRadians(Math.IEEEremainder(euler[i], 2 * Math.PI)));
        return placed(r, RigidTransform.ofEuler(t[0], t[1], t[2], euler[0], euler[1], euler[2]));
    }
}
