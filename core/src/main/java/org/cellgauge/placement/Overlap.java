package org.cellgauge.placement;

import java.util.ArrayList;
import java.util.List;
import java.util.function.DoubleBinaryOperator;
import java.util.function.Function;
import org.cellgauge.cell.Cell;
import org.cellgauge.cell.ObjectMarker;
import org.cellgauge.cell.Reference;
import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.internal.geometry.MarkerGeometry;
import org.cellgauge.vision.Detections;
import org.cellgauge.vision.MarkerObservation;
import org.cellgauge.warning.CheckWarning;
import org.cellgauge.warning.Warning;

/**
 * Two markers in one place, where at most one of them can be: in the photo, or in the world by the cell file;
 * immutable.
 */
public final class Overlap {
    /** Share of the smaller marker's area from which on two lie one over the other and do not just touch. */
    private static final double LARGEST_SHARE = 0.1;
    /** Two places are one if their distance across is below this share of the smaller marker's size. */
    private static final double LARGEST_HEIGHT = 0.25;
    /** Cosine of the angle between two faces up to which they can be one place: 30 degrees. */
    private static final double LEAST_COSINE = Math.sqrt(0.75);

    private final boolean inPhoto;
    private final int first;
    private final int second;

    private Overlap(boolean inPhoto, int first, int second) {
        this.inPhoto = inPhoto;
        this.first = first;
        this.second = second;
    }

    /**
     * Markers of a cell that a photo shows in one place, and references in it that the cell file has in one place.
     *
     * @param cell the cell
     * @param detections what the photo shows; ids foreign to the cell are ignored
     * @return those of the photo first; mostly none
     */
    public static List<Overlap> among(Cell cell, Detections detections) {
        List<Integer> ids = new ArrayList<>();
        List<double[]> outlines = new ArrayList<>();
        List<Reference> references = new ArrayList<>();
        for (Reference r : cell.references()) {
            MarkerObservation seen = detections.find(r.id());
            if (seen != null) {
                references.add(r);
                ids.add(r.id());
                outlines.add(seen.cornersPx());
            }
        }
        for (ObjectMarker o : cell.objects()) {
            MarkerObservation seen = detections.find(o.id());
            if (seen != null) {
                ids.add(o.id());
                outlines.add(seen.cornersPx());
            }
        }
        List<Overlap> found = new ArrayList<>();
        for (int[] pair : BoxSweep.touching(ends(outlines, Math::min), ends(outlines, Math::max))) {
            if (overlap(outlines.get(pair[0]), outlines.get(pair[1]))) {
                found.add(new Overlap(true, ids.get(pair[0]), ids.get(pair[1])));
            }
        }
        for (int[] pair : BoxSweep.touching(around(references, -1), around(references, 1))) {
            Reference one = references.get(pair[0]);
            Reference other = references.get(pair[1]);
            if (inOnePlace(one, other)) {
                found.add(new Overlap(false, one.id(), other.id()));
            }
        }
        return found;
    }

    /** The least or the most of each coordinate of some outlines. */
    private static List<double[]> ends(List<double[]> outlines, DoubleBinaryOperator end) {
        List<double[]> out = new ArrayList<>();
        for (double[] outline : outlines) {
            double[] box = {outline[0], outline[1]};
            for (int i = 2; i < outline.length; i++) {
                box[i % 2] = end.applyAsDouble(box[i % 2], outline[i]);
            }
            out.add(box);
        }
        return out;
    }

    /** One end of a box about each reference that reaches past its corners: two in one place touch. */
    private static List<double[]> around(List<Reference> references, int side) {
        List<double[]> out = new ArrayList<>();
        for (Reference reference : references) {
            double[] box = reference.worldFromMarker().translationMm();
            for (int axis = 0; axis < box.length; axis++) {
                box[axis] += side * reference.sizeMm();
            }
            out.add(box);
        }
        return out;
    }

    private static boolean inOnePlace(Reference a, Reference b) {
        RigidTransform aFromB = a.worldFromMarker().inverse().compose(b.worldFromMarker());
        if (aFromB.rotation()[8] < LEAST_COSINE || Math.abs(aFromB.translationMm()[2])
                > LARGEST_HEIGHT * Math.min(a.sizeMm(), b.sizeMm())) {
            return false;
        }
        return overlap(outlineMm(a.sizeMm(), point -> point),
                outlineMm(b.sizeMm(), point -> aFromB.apply(point[0], point[1], 0)));
    }

    private static double[] outlineMm(double sizeMm, Function<double[], double[]> moved) {
        double[] corners = MarkerGeometry.cornersMm(sizeMm);
        double[] outline = new double[8];
        for (int k = 0; k < 4; k++) {
            double[] point = moved.apply(new double[] {corners[3 * k], corners[3 * k + 1]});
            outline[2 * k] = point[0];
            outline[2 * k + 1] = point[1];
        }
        return outline;
    }

    private static boolean overlap(double[] a, double[] b) {
        return commonArea(a, b) > LARGEST_SHARE * Math.min(Math.abs(area(a)), Math.abs(area(b)));
    }

    /** Twice the area, positive where the outline turns from the first axis to the second. */
    private static double area(double[] outline) {
        double sum = 0;
        for (int i = 0; i < outline.length; i += 2) {
            int j = (i + 2) % outline.length;
            sum += outline[i] * outline[j + 1] - outline[j] * outline[i + 1];
        }
        return sum;
    }

    /** Twice the area that two convex outlines share: one clipped at each side of the other (Sutherland, Hodgman). */
    private static double commonArea(double[] a, double[] b) {
        double turn = Math.signum(area(b));
        double[] left = a;
        for (int i = 0; i < b.length && left.length > 0; i += 2) {
            int j = (i + 2) % b.length;
            double nx = turn * (b[i + 1] - b[j + 1]);
            double ny = turn * (b[j] - b[i]);
            List<Double> kept = new ArrayList<>();
            for (int p = 0; p < left.length; p += 2) {
                int q = (p + 2) % left.length;
                double inside = nx * (left[p] - b[i]) + ny * (left[p + 1] - b[i + 1]);
                double next = nx * (left[q] - b[i]) + ny * (left[q + 1] - b[i + 1]);
                if (inside >= 0) {
                    kept.add(left[p]);
                    kept.add(left[p + 1]);
                }
                if (inside < 0 != next < 0) {
                    double share = inside / (inside - next);
                    kept.add(left[p] + share * (left[q] - left[p]));
                    kept.add(left[p + 1] + share * (left[q + 1] - left[p + 1]));
                }
            }
            left = kept.stream().mapToDouble(Double::doubleValue).toArray();
        }
        return Math.abs(area(left));
    }

    /**
     * Where they are in one place.
     *
     * @return true for the photo, false for the world by the cell file
     */
    public boolean inPhoto() {
        return inPhoto;
    }

    /**
     * One of the two.
     *
     * @return marker id
     */
    public int first() {
        return first;
    }

    /**
     * The other.
     *
     * @return marker id
     */
    public int second() {
        return second;
    }

    /** What to tell the user. */
    Warning warning() {
        return Warning.of(inPhoto ? CheckWarning.MARKERS_IN_ONE_PLACE : CheckWarning.REFERENCES_IN_ONE_PLACE, first,
                second);
    }

    /** What it adds to a reason. */
    Misfit misfit() {
        return Misfit.ofOverlap(inPhoto, first, second);
    }
}
