package org.cellgauge.check;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import org.cellgauge.cell.Cell;
import org.cellgauge.cell.InputRefusedException;
import org.cellgauge.cell.Reference;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.internal.chains.RandomPaths;
import org.cellgauge.internal.pose.CommonPlacement;
import org.cellgauge.internal.pose.CornerErrors;
import org.cellgauge.internal.pose.InitialPose;
import org.cellgauge.internal.pose.IntrinsicsPrior;
import org.cellgauge.internal.pose.MarkerPoseFinder;
import org.cellgauge.internal.pose.NoiseBelief;
import org.cellgauge.internal.pose.ReferenceView;
import org.cellgauge.internal.sampling.RandomStreams;
import org.cellgauge.internal.warning.Decimal;
import org.cellgauge.internal.warning.Listing;
import org.cellgauge.placement.NoiseFit;
import org.cellgauge.placement.WrongCorner;
import org.cellgauge.settings.CheckSettings;
import org.cellgauge.settings.LikelihoodModel;
import org.cellgauge.settings.ObjectNoise;
import org.cellgauge.vision.Detections;
import org.cellgauge.vision.MarkerObservation;
import org.cellgauge.warning.CheckRefusal;
import org.cellgauge.warning.CheckWarning;
import org.cellgauge.warning.Warning;

/**
 * The first stage of a check: what the photo shows of the cell, and how far its corners may be off; immutable.
 */
final class Observed {
    /** How far from the middle the principal point of a whole image is, at most, in sides. */
    private static final double USUAL_OFFSET = 0.2;

    final Cell cell;
    final Detections detections;
    final CheckSettings settings;
    /** Whether corners are of squares, as precise as stated. */
    final NoiseFit noiseFit;
    /** What is known of the corners' errors, in the terms that the model knows. */
    final CornerErrors errors;
    /** The added noise by the squareness of markers alone: the u of {@link org.cellgauge.internal.pose.AddedNoise}. */
    final double noiseLevel;
    final List<Warning> warnings;

    private Observed(Cell cell, Detections detections, CheckSettings settings, NoiseFit noiseFit,
            CornerErrors errors, double noiseLevel, List<Warning> warnings) {
        this.noiseFit = noiseFit;
        this.cell = cell;
        this.detections = detections;
        this.settings = settings;
        this.errors = errors;
        this.noiseLevel = noiseLevel;
        this.warnings = Collections.unmodifiableList(warnings);
    }

    /**
     * Looks at what was detected.
     *
     * @param stated the cell; the settings may have another target
     * @param detections markers seen in its photo; ids foreign to the cell are ignored
     * @param settings how the cell is modelled
     * @param finder of the caller's thread
     * @return the observation
     * @throws InputRefusedException if no reference is in the photo, or its light says nothing of where edges are
     */
    static Observed of(Cell stated, Detections detections, CheckSettings settings, MarkerPoseFinder finder) {
        boolean rigid = settings.model().likelihood() == LikelihoodModel.RIGID_MARKER;
        CommonPlacement common = CommonPlacement.of(stated);
        // a likelihood of corners without rigid placement knows nothing that references share
        Cell own = rigid && common.isAny() ? stated.withReferences(common.references()) : stated;
        Cell cell = settings.model().targetStdMm().isPresent()
                ? own.withTarget(settings.model().targetStdMm()) : own;
        if (detections.light() != null && detections.light().toneCurveOpen()) {
            throw new InputRefusedException(detections.imageName(), CheckRefusal.TONE_CURVE_OPEN);
        }
        List<Warning> warnings = new ArrayList<>(detections.warnings());
        warnOfPrincipalPoint(cell.camera(), warnings);
        warnOfReferencesNotSeen(cell, detections, warnings);
        CornerErrors found = CornerErrors.of(cell, detections, finder).withOutliersSetAside();
        found.setAside().forEach((id, factor) ->
                warnings.add(Warning.of(CheckWarning.MARKER_SET_ASIDE, id, Decimal.of(factor, factor < 10 ? 1 : 0))));
        double noiseLevel = found.added() == null ? 0 : found.squarenessBelief().ofMeanVariance();
        if (found.fromNothing() && !rigid) {
            warnings.add(noiseWarning(found.squarenessBelief()));
        }
        // the thesis' likelihood has no corner noise for shared errors to be a part of
        NoiseFit noiseFit = noiseFit(cell, found, settings, finder);
        CornerErrors kept = found.withSetAside(noiseFit.inflationOfOutliers());
        CornerErrors errors = rigid ? withCommon(kept, common, cell)
                : kept.isPlain() ? kept : kept.fixedAt(noiseLevel);
        return new Observed(cell, detections, settings, noiseFit, errors, noiseLevel, warnings);
    }

    /**
     * The same with a reference set aside of which a corner is off.
     *
     * @param wrong the corner
     * @return the observation, which says so
     */
    Observed without(WrongCorner wrong) {
        return new Observed(cell, detections, settings, noiseFit.with(wrong), errors.withSetAside(
                Collections.singletonMap(wrong.id(), NoiseFit.inflation(wrong))), noiseLevel, warnings);
    }

    /** The errors with those that references have in common, as a first estimate of the camera sees them. */
    private static CornerErrors withCommon(CornerErrors errors, CommonPlacement common, Cell cell) {
        RigidTransform first = common.isAny()
                ? InitialPose.PNP.estimate(ReferenceView.of(cell.references(), errors), cell.camera()) : null;
        return first == null ? errors : common.addedTo(errors, cell.camera(), first);
    }

    private static NoiseFit noiseFit(Cell cell, CornerErrors errors, CheckSettings settings,
            MarkerPoseFinder finder) {
        // the thesis' likelihood with corners of objects taken as exact has no corner noise at all
        if (settings.model().likelihood() != LikelihoodModel.RIGID_MARKER
                && settings.model().objectNoise() == ObjectNoise.NONE) {
            return NoiseFit.untested();
        }
        IntrinsicsPrior prior = IntrinsicsPrior.stated(cell, settings.model());
        return prior.count() > 0 ? NoiseFit.ofUnknownIntrinsics(cell, errors, prior.proper(), finder)
                : NoiseFit.of(cell, errors, cell.camera(), finder);
    }

    private static void warnOfPrincipalPoint(PinholeCamera camera, List<Warning> warnings) {
        double cx = camera.get(PinholeCamera.CX);
        double cy = camera.get(PinholeCamera.CY);
        if (Math.abs(cx / camera.widthPx() - 0.5) > USUAL_OFFSET
                || Math.abs(cy / camera.heightPx() - 0.5) > USUAL_OFFSET) {
            warnings.add(Warning.of(CheckWarning.PRINCIPAL_POINT_OFF, Decimal.of(cx, 0), Decimal.of(cy, 0),
                    camera.widthPx(), camera.heightPx(), Decimal.of(100 * USUAL_OFFSET, 0)));
        }
    }

    private static void warnOfReferencesNotSeen(Cell cell, Detections detections, List<Warning> warnings) {
        List<Integer> unseen = new ArrayList<>();
        for (Reference r : cell.references()) {
            if (detections.find(r.id()) == null) {
                unseen.add(r.id());
            }
        }
        if (unseen.size() == cell.references().size()) {
            if (!detections.warnings().isEmpty()) {
                throw new InputRefusedException(detections.imageName(), CheckRefusal.NO_REFERENCE_LEFT,
                        Listing.and(unseen), Listing.semicolon(detections.warnings()));
            }
            throw new InputRefusedException(detections.imageName(), CheckRefusal.NO_REFERENCE_SEEN,
                    Listing.and(unseen));
        }
        if (!unseen.isEmpty()) {
            warnings.add(Warning.of(CheckWarning.REFERENCES_NOT_SEEN, Listing.and(unseen)));
        }
    }

    /** What is said of a noise that nobody states. */
    static Warning noiseWarning(NoiseBelief belief) {
        return Warning.of(CheckWarning.CORNER_NOISE_ESTIMATED, Decimal.of(belief.quantileStdPx(0.5), 3),
                Decimal.of(belief.quantileStdPx(0.025), 3), Decimal.of(belief.quantileStdPx(0.975), 3));
    }

    /**
     * What names the random streams of this photo: the seed and the corners of its markers, so that photos of a batch
     * do not share their random numbers, and a photo has the same figures alone, in a batch and under another name.
     */
    long photoSeed() {
        List<MarkerObservation> markers = detections.markers();
        long[] path = new long[1 + 9 * markers.size()];
        int at = 0;
        path[at++] = RandomPaths.PHOTO;
        for (MarkerObservation marker : markers) {
            path[at++] = marker.id();
            for (double px : marker.cornersPx()) {
                path[at++] = Double.doubleToLongBits(px);
            }
        }
        return RandomStreams.of(settings.sampling().seed(), path).nextLong();
    }
}
