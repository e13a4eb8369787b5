package org.cellgauge.internal.pose;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import org.cellgauge.cell.Cell;
import org.cellgauge.cell.ObjectMarker;
import org.cellgauge.cell.Reference;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.internal.geometry.Cholesky;
import org.cellgauge.vision.Detections;
import org.cellgauge.vision.EdgeShift;
import org.cellgauge.vision.MarkerObservation;
import org.jspecify.annotations.Nullable;

/**
 * How far the corners of one photo may be from where they are seen: for each marker a covariance of its own errors, and
 * what it shares with others, as unit-normal unknowns with a column of 8 pixels per unit each; immutable.
 *
 * <p>{@code seen = true + sum_j column_j nu_j + e}, {@code e ~ N(0, C + added(u) I)}, nu_j and u standard normal.
 * Where the cell states the noise as a number, C is its square times the unit matrix, to the last bit, and nothing is
 * added.
 *
 * <p>Markers whose corners fit no square, given the noise of the others, are set aside: a covariance of theirs alone,
 * scaled up, and no say in the common noise. Corners are taken to be off by far with a chance of 5 % (a contaminated
 * normal distribution: Tukey, "A survey of sampling from contaminated distributions", 1960). Four corners cannot tell
 * which of them is off, so all of a marker are scaled alike.
 */
public final class CornerErrors {
    /** Chance that a corner is an outlier. */
    private static final double OUTLIER_CORNERS = 0.05;
    private static final double OUTLIER_MARKERS = 1 - Math.pow(1 - OUTLIER_CORNERS, 4);
    /** Inflations of the variance of a marker with an outlier: log-uniform between these, so many of them. */
    private static final double LEAST_INFLATION = 9;
    private static final double MOST_INFLATION = 1e4;
    private static final int INFLATIONS = 15;
    /** Probability from which on a marker counts as one with an outlier. */
    private static final double SET_ASIDE = 0.8;
    /** More than sums of probabilities lose by rounding. */
    private static final double ROUNDING = 1e-9;
    /** Share of a variance below which more or less of it does not show. */
    private static final double NEGLIGIBLE = 1e-3;
    /**
     * Probability, by squareness, that the added noise is no more than what references may say of it: a reference that
     * stands elsewhere than stated would else be taken for noise of all corners.
     */
    private static final double NOISE_LIMIT = 0.999;
    /** Fewer markers than this cannot say which of them is out of line. */
    private static final int LEAST_MARKERS = 3;

    private final Map<Integer, MarkerErrors> markers;
    private final double statedStdPx;
    private final @Nullable AddedNoise added;
    private final @Nullable EdgeModel edges;
    private final List<Double> sizesMm;
    private final double sizeStdMm;
    private final int unknowns;
    private final Map<Integer, Double> inflations;
    private final boolean flat;

    private CornerErrors(Map<Integer, MarkerErrors> markers, double statedStdPx, @Nullable AddedNoise added,
            @Nullable EdgeModel edges, List<Double> sizesMm, double sizeStdMm, int unknowns,
            Map<Integer, Double> inflations) {
        this.markers = markers;
        this.statedStdPx = statedStdPx;
        this.added = added;
        this.edges = edges;
        this.sizesMm = sizesMm;
        this.sizeStdMm = sizeStdMm;
        this.unknowns = unknowns;
        this.inflations = inflations;
        boolean any = false;
        for (MarkerErrors m : markers.values()) {
            any |= m.flatnessPx2 != null;
        }
        flat = any;
    }

    /**
     * The errors of the markers of a cell that a photo shows.
     *
     * @param cell the cell
     * @param detections what the photo shows; ids foreign to the cell are ignored
     * @return their errors, no marker set aside
     */
    public static CornerErrors of(Cell cell, Detections detections) {
        return of(cell, detections, new MarkerPoseFinder());
    }

    /**
     * The same with a finder for the poses that errors depend on.
     *
     * @param cell the cell
     * @param detections what the photo shows; ids foreign to the cell are ignored
     * @param finder of the caller's thread
     * @return their errors, no marker set aside
     */
    public static CornerErrors of(Cell cell, Detections detections, MarkerPoseFinder finder) {
        return of(cell, detections, Collections.emptyMap(), finder);
    }

    /**
     * The errors of markers whose poses are known beforehand, as where a layout is only thought of.
     *
     * @param cell the cell
     * @param detections where their corners would be; ids foreign to the cell are ignored
     * @param cameraFromMarkers their poses in the camera frame, by id; others are found from the corners
     * @return their errors
     */
    public static CornerErrors of(Cell cell, Detections detections, Map<Integer, RigidTransform> cameraFromMarkers) {
        return of(cell, detections, cameraFromMarkers, new MarkerPoseFinder());
    }

    private static CornerErrors of(Cell cell, Detections detections, Map<Integer, RigidTransform> cameraFromMarkers,
            MarkerPoseFinder ofThread) {
        List<MarkerErrors.Source> seen = new ArrayList<>();
        for (Reference r : cell.references()) {
            addSeen(detections.find(r.id()), r.sizeMm(), seen);
        }
        for (ObjectMarker o : cell.objects()) {
            addSeen(detections.find(o.id()), o.sizeMm(), seen);
        }
        double stated = cell.pixelStdPx().orElse(Double.NaN);
        boolean unknown = !cell.pixelStdPx().isPresent();
        EdgeModel edges = EdgeModel.of(cell, detections, seen);
        List<Double> sizes = new ArrayList<>();
        if (cell.prints().sizeStdMm() > 0) {
            for (MarkerErrors.Source m : seen) {
                if (!sizes.contains(m.sizeMm)) {
                    sizes.add(m.sizeMm);
                }
            }
        }
        int ofEdges = edges == null ? 0 : edges.unknowns();
        int q = ofEdges + sizes.size();
        double[] largest = unknown ? largest(seen) : null;
        double[] isotropic = unknown ? null : isotropic(stated * stated);
        Map<Integer, MarkerErrors> markers = new LinkedHashMap<>();
        List<Double> variances = new ArrayList<>();
        // where all is stated, errors do not depend on poses
        MarkerPoseFinder finder = unknown || !sizes.isEmpty() || cell.prints().flatnessMm() > 0
                ? ofThread : null;
        for (MarkerErrors.Source m : seen) {
            RigidTransform pose = cameraFromMarkers.get(m.observation.id());
            MarkerErrors errors = errors(cell, m, pose, finder, isotropic, largest, edges, sizes, q);
            markers.put(m.observation.id(), errors);
            variances.add(meanVariance(errors.covariancePx2));
        }
        Collections.sort(variances);
        AddedNoise added = !unknown ? null : largest == null ? AddedNoise.toNothing()
                : AddedNoise.toFits(variances.get(variances.size() / 2));
        return new CornerErrors(Collections.unmodifiableMap(markers), stated, added, edges,
                Collections.unmodifiableList(sizes), cell.prints().sizeStdMm(), q, Collections.emptyMap());
    }

    private static void addSeen(@Nullable MarkerObservation observation, double sizeMm,
            List<MarkerErrors.Source> seen) {
        if (observation != null) {
            seen.add(new MarkerErrors.Source(observation, sizeMm));
        }
    }

    private static double meanVariance(double[] covariance) {
        double sum = 0;
        for (int i = 0; i < 8; i++) {
            sum += covariance[9 * i];
        }
        return sum / 8;
    }

    /** The largest covariance of any marker, as one for corners that have none beside it; null where none has. */
    private static double @Nullable [] largest(List<MarkerErrors.Source> seen) {
        double most = 0;
        for (MarkerErrors.Source m : seen) {
            double[] covariance = m.observation.covariancePx2();
            most = covariance == null ? most : Math.max(most, meanVariance(covariance));
        }
        return most > 0 ? isotropic(most) : null;
    }

    private static double[] isotropic(double variance) {
        double[] out = new double[64];
        for (int i = 0; i < 8; i++) {
            out[9 * i] = variance;
        }
        return out;
    }

    private static MarkerErrors errors(Cell cell, MarkerErrors.Source m, @Nullable RigidTransform known,
            @Nullable MarkerPoseFinder finder, double @Nullable [] stated, double @Nullable [] otherwise,
            @Nullable EdgeModel edges, List<Double> sizes, int q) {
        boolean unknown = stated == null;
        double[] corners = m.observation.cornersPx();
        double[] covariance = stated == null ? m.observation.covariancePx2() : stated;
        boolean ofFit = unknown && covariance != null;
        if (covariance == null) {
            covariance = otherwise == null ? new double[64] : otherwise.clone();
        }
        double[] columns = new double[8 * q];
        if (edges != null) {
            EdgeShift shift = m.observation.edgeShift();
            double mean = edges.mean(m);
            double[] ofCorner = edges.rowsOfCorners(m);
            double[] meanOfCorners = edges.meanOfCorners(ofCorner);
            double[] byUnknown = edges.ofInnerByUnknown(m);
            double[] ofCorners = edges.cornersByUnknown(ofCorner);
            // a noise that is stated is independent of what edges show; one of a fit shares its errors with the shift
            double[] shared = shift != null && ofFit ? shift.covarianceWithCornersPx2() : new double[8];
            double variance = shift == null ? 1 : EdgeModel.variance(shift);
            for (int i = 0; i < 8; i++) {
                double error = shift == null ? 0 : shared[i] / variance * (shift.shiftPx() - mean);
                corners[i] -= meanOfCorners[i] + error;
                for (int j = 0; j < byUnknown.length; j++) {
                    columns[i * q + j] = ofCorners[i * byUnknown.length + j] - shared[i] / variance * byUnknown[j];
                }
                for (int j = 0; j < 8 && ofFit; j++) {
                    covariance[8 * i + j] -= shared[i] * shared[j] / variance;
                }
            }
        }
        Squareness squareness = null;
        double @Nullable [] flatness = null;
        if (finder != null) {
            List<PoseMode> modes = known != null && !unknown ? Collections.emptyList()
                    : finder.modes(corners, m.sizeMm, cell.camera(), 1);
            CameraState pose = !modes.isEmpty() ? modes.get(0).state()
                    : known != null ? CameraState.of(known, cell.camera()) : null;
            double[] by = pose == null ? null : MarkerErrors.bySizeAndHeight(pose, m.sizeMm);
            int size = sizes.indexOf(m.sizeMm);
            if (by != null && size >= 0) {
                for (int i = 0; i < 8; i++) {
                    columns[i * q + q - sizes.size() + size] = by[i] * cell.prints().sizeStdMm();
                }
            }
            if (by != null && cell.prints().flatnessMm() > 0) {
                flatness = flatness(by, cell.prints().flatnessMm());
                // what is stated is the same for all markers, and in one array
                covariance = stated == null ? covariance : stated.clone();
                for (int i = 0; i < 64; i++) {
                    covariance[i] += flatness[i];
                }
            }
            squareness = unknown && !modes.isEmpty() ? new Squareness(modes, covariance) : null;
        }
        return new MarkerErrors(corners, covariance, flatness, columns, squareness, false);
    }

    private static double[] flatness(double[] by, double stdMm) {
        double[] out = new double[64];
        for (int k = 0; k < 8; k += 2) {
            for (int i = k; i < k + 2; i++) {
                for (int j = k; j < k + 2; j++) {
                    out[8 * i + j] = by[8 + i] * by[8 + j] * stdMm * stdMm;
                }
            }
        }
        return out;
    }

    /**
     * What the corners of all markers say of their common noise by how far they are from squares.
     *
     * @return probabilities of the added noise
     * @throws IllegalStateException if the noise is stated
     */
    public NoiseBelief squarenessBelief() {
        double[] log = logPrior();
        for (MarkerErrors m : markers.values()) {
            for (int i = 0; i < log.length; i++) {
                log[i] += logSquareness(m, i);
            }
        }
        return new NoiseBelief(unknownNoise(), log);
    }

    private AddedNoise unknownNoise() {
        if (added == null) {
            throw new IllegalStateException("the noise is stated");
        }
        return added;
    }

    private double[] logPrior() {
        unknownNoise();
        double[] log = new double[AddedNoise.NODES];
        for (int i = 0; i < log.length; i++) {
            double u = AddedNoise.atNode(i);
            log[i] = -0.5 * u * u;
        }
        return log;
    }

    private double logSquareness(MarkerErrors m, int node) {
        return m.squareness == null || m.setAside ? 0
                : m.squareness.logLikelihood(unknownNoise(), node);
    }

    /**
     * Logarithm of the prior of the added noise times what some markers say of it by their squareness, for the others
     * to speak through their likelihood: within what the squareness of all of them allows.
     *
     * @param ids the markers
     * @return one value per node of the grid, up to a constant; -infinity where markers would be less square than they
     *     are in 999 of 1000 photos
     * @throws IllegalStateException if the noise is stated
     */
    public double[] logNoise(List<Integer> ids) {
        double[] log = logPrior();
        NoiseBelief bySquares = squarenessBelief();
        int last = Math.max(bySquares.quantileNode(NOISE_LIMIT), AddedNoise.node(bySquares.ofMeanVariance()));
        Arrays.fill(log, last + 1, log.length, Double.NEGATIVE_INFINITY);
        for (int id : ids) {
            MarkerErrors m = markers.get(id);
            for (int i = 0; i < log.length && m != null; i++) {
                log[i] += logSquareness(m, i);
            }
        }
        return log;
    }

    /**
     * Markers whose corners are of no square, given a noise that is as unknown as the other markers leave it: the
     * chance of squares as large as a marker's, averaged over what is known of the noise without it (the predictive
     * distribution: Gelman et al., "Bayesian Data Analysis", 3rd ed. 2013, section 6.3), is below a level that all
     * markers share.
     *
     * @param level chance that any marker of a photo is named although all corners are alike
     * @return how many times worse they fit a square than those of the others, by id, the worst first; mostly empty
     * @throws IllegalStateException if the noise is stated
     */
    public Map<Integer, Double> noSquares(double level) {
        AddedNoise unknown = Objects.requireNonNull(added, "noise that is stated is no belief");
        double[] log = logPrior();
        if (areSquares(unknown, level)) {
            return new LinkedHashMap<>();
        }
        int told = 0;
        for (MarkerErrors m : markers.values()) {
            for (int i = 0; i < log.length; i++) {
                log[i] += logSquareness(m, i);
            }
            told += m.squareness == null ? 0 : 1;
        }
        Map<Integer, Double> found = new LinkedHashMap<>();
        for (Map.Entry<Integer, MarkerErrors> entry : markers.entrySet()) {
            MarkerErrors m = entry.getValue();
            if (m.squareness == null) {
                continue;
            }
            double[] ofOthers = log.clone();
            for (int i = 0; i < log.length; i++) {
                ofOthers[i] -= logSquareness(m, i);
            }
            NoiseBelief belief = new NoiseBelief(unknown, ofOthers);
            double chance = 0;
            for (int i = 0; i < log.length; i++) {
                chance += belief.weight(i)
                        * Math.exp(-0.5 * m.squareness.chiSquare(unknown.variancePx2AtNode(i)));
            }
            if (chance < level / told) {
                found.put(entry.getKey(), Math.sqrt(0.5
                        * m.squareness.chiSquare(unknown.variancePx2(belief.ofMeanVariance()))));
            }
        }
        List<Map.Entry<Integer, Double>> worstFirst = new ArrayList<>(found.entrySet());
        worstFirst.sort((a, b) -> Double.compare(b.getValue(), a.getValue()));
        found.clear();
        worstFirst.forEach(e -> found.put(e.getKey(), e.getValue()));
        return found;
    }

    /** Whether even with the least noise of the grid, which makes squares the largest, no marker has too large ones. */
    private boolean areSquares(AddedNoise unknown, double level) {
        int told = 0;
        double most = 0;
        for (MarkerErrors m : markers.values()) {
            if (m.squareness != null) {
                told++;
                most = Math.max(most, m.squareness.chiSquare(unknown.variancePx2AtNode(0)));
            }
        }
        return told == 0 || Math.exp(-0.5 * most) * (1 - ROUNDING) > level / told;
    }

    /**
     * Sets markers aside whose corners fit no square as well as the others' do.
     *
     * @return errors in which these have a covariance of their own; the same where there are none, too few markers to
     *     tell, or the noise is stated
     */
    public CornerErrors withOutliersSetAside() {
        List<Integer> ids = new ArrayList<>();
        List<Squareness> squares = new ArrayList<>();
        markers.forEach((id, m) -> {
            if (m.squareness != null) {
                ids.add(id);
                squares.add(m.squareness);
            }
        });
        if (added == null || ids.size() < LEAST_MARKERS || areUsual(squares, added)) {
            return this;
        }
        int nodes = AddedNoise.NODES;
        double[][] logMixture = new double[ids.size()][nodes];
        double[][] outlier = new double[ids.size()][nodes];
        double[] inflated = inflations();
        double[] logInflated = new double[inflated.length];
        for (int k = 0; k < inflated.length; k++) {
            logInflated[k] = Math.log(inflated[k]);
        }
        double[] log = logPrior();
        for (int m = 0; m < ids.size(); m++) {
            Squareness squareness = squares.get(m);
            for (int i = 0; i < nodes; i++) {
                double clean = Math.log(1 - OUTLIER_MARKERS) + squareness.logLikelihood(added, i);
                double off = Math.log(OUTLIER_MARKERS)
                        + squareness.logMeanLikelihood(added.variancePx2AtNode(i), inflated, logInflated);
                double most = Math.max(clean, off);
                logMixture[m][i] = most + Math.log(Math.exp(clean - most) + Math.exp(off - most));
                outlier[m][i] = Math.exp(off - logMixture[m][i]);
                log[i] += logMixture[m][i];
            }
        }
        NoiseBelief belief = new NoiseBelief(added, log);
        double variance = added.variancePx2(belief.ofMeanVariance());
        Map<Integer, MarkerErrors> others = new LinkedHashMap<>(markers);
        Map<Integer, Double> factors = new LinkedHashMap<>();
        for (int m = 0; m < ids.size(); m++) {
            double probability = 0;
            for (int i = 0; i < nodes; i++) {
                probability += belief.weight(i) * outlier[m][i];
            }
            if (probability > SET_ASIDE) {
                MarkerErrors errors = of(ids.get(m));
                // half of chi-square is the factor that would make it usual; 2 degrees of freedom tell it so poorly
                // that twice that is what regions need
                double chiSquare = squares.get(m).chiSquare(variance);
                double factor = Math.max(LEAST_INFLATION, chiSquare);
                double[] covariance = errors.withAdded(variance).covariancePx2;
                for (int i = 0; i < 64; i++) {
                    covariance[i] *= factor;
                }
                others.put(ids.get(m), errors.setAside(covariance));
                factors.put(ids.get(m), Math.sqrt(chiSquare / 2));
            }
        }
        return factors.isEmpty() ? this : new CornerErrors(Collections.unmodifiableMap(others), statedStdPx, added,
                edges, sizesMm, sizeStdMm, unknowns, Collections.unmodifiableMap(factors));
    }

    private static double[] inflations() {
        double step = Math.log(MOST_INFLATION / LEAST_INFLATION) / (INFLATIONS - 1);
        double[] out = new double[INFLATIONS];
        for (int k = 0; k < INFLATIONS; k++) {
            out[k] = LEAST_INFLATION * Math.exp(k * step);
        }
        return out;
    }

    /**
     * Whether no marker can be one with an outlier, whatever the noise is: with the least of the grid each is likelier
     * to have none. Of most photos this is so, and the mixture need not be worked out.
     */
    private static boolean areUsual(List<Squareness> squares, AddedNoise added) {
        double[] inflations = inflations();
        double prior = OUTLIER_MARKERS / (1 - OUTLIER_MARKERS);
        for (Squareness squareness : squares) {
            double odds = prior * squareness.largestRatio(added.variancePx2AtNode(0), inflations);
            // not so for NaN
            if (!(odds / (1 + odds) < SET_ASIDE - ROUNDING)) {
                return false;
            }
        }
        return true;
    }

    /**
     * The same errors with the added noise as if it were known, and no shared unknowns: for models that sample neither.
     *
     * @param u the added noise
     * @return errors with stated covariances
     */
    public CornerErrors fixedAt(double u) {
        Map<Integer, MarkerErrors> fixed = new LinkedHashMap<>();
        markers.forEach((id, m) -> fixed.put(id, m.withAdded(added == null ? 0 : added.variancePx2(u))));
        return new CornerErrors(Collections.unmodifiableMap(fixed), statedStdPx, null, null, Collections.emptyList(), 0,
                0, inflations);
    }

    /**
     * How far the corners of a marker are from any square, measured by what is known of their errors (added noise is
     * left out). Size and pose of the marker, and so its placement, have no part in it.
     *
     * @param id marker id
     * @param sizeMm its size
     * @param lens intrinsics
     * @param finder of the caller's thread
     * @return if the errors are as known at most distributed like chi-square of 2 degrees of freedom (8 coordinates
     *     less 6 of the pose; less where a small marker seen frontally can tilt to either side, which is no linear
     *     model); NaN where the corners are of no pose
     */
    public double squareChiSquare(int id, double sizeMm, PinholeCamera lens, MarkerPoseFinder finder) {
        return finder.squareChiSquare(of(id), unknowns, sizeMm, lens);
    }

    /**
     * The same errors with some markers set aside: with covariances of their own, scaled up.
     *
     * @param factors factors on the covariances by marker id, 2 (times worse)² each at most where corners are that many
     *     times worse than stated
     * @return errors of which the other markers' are what they were
     */
    public CornerErrors withSetAside(Map<Integer, Double> factors) {
        if (factors.isEmpty()) {
            return this;
        }
        Map<Integer, MarkerErrors> out = new LinkedHashMap<>(markers);
        Map<Integer, Double> times = new LinkedHashMap<>(inflations);
        factors.forEach((id, factor) -> {
            double[] covariance = of(id).covariancePx2.clone();
            for (int i = 0; i < 64; i++) {
                covariance[i] *= factor;
            }
            out.put(id, of(id).setAside(covariance));
            times.put(id, Math.sqrt(factor / 2));
        });
        return new CornerErrors(Collections.unmodifiableMap(out), statedStdPx, added, edges, sizesMm, sizeStdMm,
                unknowns, Collections.unmodifiableMap(times));
    }

    /**
     * The same errors with some covariances scaled up, for corners that are seen to be worse than stated.
     *
     * @param factors factors on the covariances by marker id; markers without one keep theirs
     * @return errors of which none counts as stated
     */
    public CornerErrors inflated(Map<Integer, Double> factors) {
        Map<Integer, MarkerErrors> out = new LinkedHashMap<>();
        markers.forEach((id, m) -> {
            double[] covariance = m.covariancePx2.clone();
            for (int i = 0; i < 64; i++) {
                covariance[i] *= factors.getOrDefault(id, 1.0);
            }
            out.put(id, new MarkerErrors(m.cornersPx, covariance, m.flatnessPx2, m.columns, m.squareness, m.setAside));
        });
        return new CornerErrors(Collections.unmodifiableMap(out), Double.NaN, added, edges, sizesMm, sizeStdMm,
                unknowns, inflations);
    }

    /**
     * Whether every corner has the same stated deviation and nothing else is unknown.
     *
     * @return true for a cell that states a number, flat prints of known size and a photo whose edges are not in doubt
     *     and that shows no marker set aside
     */
    public boolean isPlain() {
        return !Double.isNaN(statedStdPx) && unknowns == 0 && !hasFlatness() && inflations.isEmpty();
    }

    /**
     * Whether prints may be bent.
     *
     * @return true if a part of the covariances comes from that
     */
    public boolean hasFlatness() {
        return flat;
    }

    /**
     * The stated deviation of every coordinate.
     *
     * @return px, NaN where it is unknown
     */
    public double statedStdPx() {
        return statedStdPx;
    }

    /**
     * Number of shared unknowns.
     *
     * @return 0 where there are none
     */
    public int unknowns() {
        return unknowns;
    }

    /**
     * What a shared unknown is about.
     *
     * @param j 0 to {@link #unknowns()} - 1
     * @return true for the size of prints, false for where the edges of the photo lie or references stand together
     */
    public boolean isSizeOfPrints(int j) {
        int first = edges == null ? 0 : edges.unknowns();
        return j >= first && j < first + sizesMm.size();
    }

    /**
     * Whether a shared unknown is about where references stand together.
     *
     * @param j 0 to {@link #unknowns()} - 1
     * @return true for those that {@link CommonPlacement} added, which are the last
     */
    public boolean isPlacement(int j) {
        return j >= (edges == null ? 0 : edges.unknowns()) + sizesMm.size();
    }

    /**
     * These errors with more shared unknowns, the last then.
     *
     * @param more by id: changes of its corners by each, 8 x count, row by row, px; markers without stand where they do
     * @param count how many
     */
    CornerErrors withCommonPlacement(Map<Integer, double[]> more, int count) {
        Map<Integer, MarkerErrors> all = new LinkedHashMap<>();
        int q = unknowns + count;
        markers.forEach((id, m) -> {
            double[] columns = new double[8 * q];
            double[] byCommon = more.get(id);
            for (int i = 0; i < 8; i++) {
                System.arraycopy(m.columns, i * unknowns, columns, i * q, unknowns);
                if (byCommon != null) {
                    System.arraycopy(byCommon, i * count, columns, i * q + unknowns, count);
                }
            }
            all.put(id, new MarkerErrors(m.cornersPx, m.covariancePx2, m.flatnessPx2, columns, m.squareness,
                    m.setAside));
        });
        return new CornerErrors(Collections.unmodifiableMap(all), statedStdPx, added, edges, sizesMm, sizeStdMm, q,
                inflations);
    }

    /**
     * The shift of edges.
     *
     * @return the model, null where nothing speaks of a shift
     */
    public @Nullable EdgeModel edges() {
        return edges;
    }

    /**
     * Sizes of markers that may be off.
     *
     * @return unmodifiable, mm; their unknowns follow those of edges
     */
    public List<Double> sizesMm() {
        return sizesMm;
    }

    /**
     * Standard deviation of printed sizes.
     *
     * @return mm
     */
    public double sizeStdMm() {
        return sizeStdMm;
    }

    /**
     * The added noise.
     *
     * @return its prior; null where the noise is stated
     */
    public @Nullable AddedNoise added() {
        return added;
    }

    /**
     * Deviation of the added noise.
     *
     * @param u the added noise
     * @return px
     * @throws IllegalStateException if the noise is stated
     */
    public double addedStdPx(double u) {
        return Math.sqrt(unknownNoise().variancePx2(u));
    }

    /**
     * Whether the noise is unknown and no marker has a covariance.
     *
     * @return true where all of the noise is the added one
     */
    public boolean fromNothing() {
        return added != null && added.isAll();
    }

    /**
     * Whether anything is unknown that markers share.
     *
     * @return true where there is a shared unknown or the noise is unknown
     */
    public boolean isShared() {
        return unknowns > 0 || added != null;
    }

    /**
     * Markers that were set aside.
     *
     * @return by id: how many times worse their corners fit a square than the others'; unmodifiable
     */
    public Map<Integer, Double> setAside() {
        return inflations;
    }

    private MarkerErrors of(int id) {
        MarkerErrors errors = markers.get(id);
        if (errors == null) {
            throw new IllegalArgumentException("marker " + id + " is not seen");
        }
        return errors;
    }

    /**
     * Whether the corners of a marker are known.
     *
     * @param id marker id
     * @return true if the photo shows it
     */
    public boolean has(int id) {
        return markers.containsKey(id);
    }

    /**
     * Corners of a marker, corrected for the mean shift of its edges.
     *
     * @param id marker id
     * @return a copy of 8 values, px
     */
    public double[] cornersPx(int id) {
        return of(id).cornersPx.clone();
    }

    /**
     * Corners of a marker with the shared unknowns taken off.
     *
     * @param id marker id
     * @param unknowns values of the shared unknowns
     * @return 8 values, px
     */
    public double[] cornersPx(int id, double[] unknowns) {
        double[] corners = cornersPx(id);
        double[] columns = of(id).columns;
        for (int i = 0; i < 8; i++) {
            for (int j = 0; j < this.unknowns; j++) {
                corners[i] -= columns[i * this.unknowns + j] * unknowns[j];
            }
        }
        return corners;
    }

    /**
     * Change of the seen corners of a marker by each shared unknown.
     *
     * @param id marker id
     * @return a copy, 8 x {@link #unknowns()} row by row, px per unit
     */
    public double[] columns(int id) {
        return of(id).columns.clone();
    }

    /**
     * Whether an added noise is next to nothing beside what is known of the corners.
     *
     * @param u the added noise
     * @return true where less noise would change no figure
     * @throws IllegalStateException if the noise is stated
     */
    public boolean isNegligible(double u) {
        double least = Double.POSITIVE_INFINITY;
        for (MarkerErrors m : markers.values()) {
            least = m.setAside ? least : Math.min(least, meanVariance(m.covariancePx2));
        }
        return unknownNoise().variancePx2(u) < NEGLIGIBLE * least;
    }

    /**
     * Covariance of a marker's own errors.
     *
     * @param id marker id
     * @param u the added noise; ignored where it is stated
     * @param out receives 8x8 row by row, px²
     */
    public void covariance(int id, double u, double[] out) {
        MarkerErrors m = of(id);
        System.arraycopy(m.covariancePx2, 0, out, 0, 64);
        if (added != null && !m.setAside) {
            double variance = added.variancePx2(u);
            for (int i = 0; i < 8; i++) {
                out[9 * i] += variance;
            }
        }
    }

    /**
     * The part of a marker's covariance that comes from bent prints.
     *
     * @param id marker id
     * @return a copy, 8x8 row by row, px²; zeros where prints are flat
     */
    public double[] flatness(int id) {
        double[] flatness = of(id).flatnessPx2;
        return flatness == null ? new double[64] : flatness.clone();
    }

    /**
     * Mean variance of the coordinates of a marker.
     *
     * @param id marker id
     * @param u the added noise; ignored where it is stated
     * @return px²
     */
    public double meanVariancePx2(int id, double u) {
        MarkerErrors m = of(id);
        return meanVariance(m.covariancePx2) + (added == null || m.setAside ? 0 : added.variancePx2(u));
    }

    /**
     * Root of the mean variance of all coordinates of markers that are not set aside.
     *
     * @param u the added noise; ignored where it is stated
     * @return px
     */
    public double usualStdPx(double u) {
        if (!Double.isNaN(statedStdPx)) {
            return statedStdPx;
        }
        double sum = 0;
        int count = 0;
        for (Map.Entry<Integer, MarkerErrors> m : markers.entrySet()) {
            if (!m.getValue().setAside) {
                sum += meanVariancePx2(m.getKey(), u);
                count++;
            }
        }
        return Math.sqrt(sum / count);
    }

    /**
     * The marker's whitening matrix without any placement error.
     *
     * @param id marker id
     * @param u the added noise; ignored where it is stated
     * @return 64 values, lower triangular 8x8 row by row, 1/px
     * @throws IllegalStateException if its covariance is not positive definite
     */
    public double[] whitening(int id, double u) {
        double[] covariance = new double[64];
        double[] whitening = new double[64];
        covariance(id, u, covariance);
        if (!Cholesky.factor(covariance, 8)) {
            throw new IllegalStateException("covariance of the corners of marker " + id + " is not positive definite");
        }
        Cholesky.invertLower(covariance, 8, whitening);
        return whitening;
    }

    /**
     * Ids of the markers.
     *
     * @return a new list, references of the cell first
     */
    public List<Integer> ids() {
        return new ArrayList<>(markers.keySet());
    }

    /** Columns of several markers, 8 x unknowns each, one after another. */
    double[] columns(List<Reference> references) {
        double[] out = new double[8 * unknowns * references.size()];
        for (int m = 0; m < references.size(); m++) {
            double[] own = of(references.get(m).id()).columns;
            System.arraycopy(own, 0, out, m * own.length, own.length);
        }
        return out;
    }
}
