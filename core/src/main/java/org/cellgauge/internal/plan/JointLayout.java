package org.cellgauge.internal.plan;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.TreeMap;
import org.cellgauge.cell.ObjectMarker;
import org.cellgauge.cell.Placement;
import org.cellgauge.cell.Reference;
import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.internal.geometry.Cholesky;
import org.cellgauge.plan.Layout;
import org.cellgauge.plan.MeasuredDistance;
import org.jspecify.annotations.Nullable;

/**
 * A layout whose markers do not err independently of each other given the camera: several photos show the same
 * references, some of which stand on one plate or have a measured distance. All that is unknown is kept: the camera's
 * pose in every photo, what photos and prints share, and where each reference or plate truly is.
 *
 * <p>Normal equations of a bundle adjustment (Triggs et al., "Bundle adjustment - a modern synthesis", 2000, section
 * 6), its unknowns in the order photos, shared, bodies; an object is added at the end, one place after the other.
 */
final class JointLayout {
    private static final int POSE = PlannedView.POSE;
    /** Deviations are at least this, so that what stands exactly is no division by zero: mm and rad. */
    private static final double LEAST_STD = 1e-6;

    private final Layout layout;
    private final List<PlannedView> photos;
    /** Index of each photo's unknowns among those of all. */
    private final int[][] columns;
    private final int bodies;
    private final int size;
    private final Map<Integer, Integer> bodyOf = new TreeMap<>();
    private final double[] information;
    private final Map<Integer, double[]> squares = new LinkedHashMap<>();

    /** What is known of a point and of its object's orientation: covariances in the world. */
    static final class Known {
        private final double[] covarianceMm2;
        private final double[] ownMm2;
        private final double @Nullable [] turnRad2;
        private final double @Nullable [] ownTurnRad2;

        Known(double[] covarianceMm2, double[] ownMm2, double @Nullable [] turnRad2,
                double @Nullable [] ownTurnRad2) {
            this.covarianceMm2 = covarianceMm2;
            this.ownMm2 = ownMm2;
            this.turnRad2 = turnRad2;
            this.ownTurnRad2 = ownTurnRad2;
        }

        /** Of the point, 3 x 3. */
        double[] covarianceMm2() {
            return covarianceMm2;
        }

        /** What the object's own corners leave of it. */
        double[] ownMm2() {
            return ownMm2;
        }

        /** Of the turn about world axes; null of a gripping point. */
        double @Nullable [] turnRad2() {
            return turnRad2;
        }

        /** What the object's own corners leave of it. */
        double @Nullable [] ownTurnRad2() {
            return ownTurnRad2;
        }
    }

    /**
     * A layout as seen in some photos.
     *
     * @param layout references, plates and distances
     * @param photos at least one
     * @param seen ids of the references that count, each seen in every photo
     */
    JointLayout(Layout layout, List<PlannedView> photos, List<Integer> seen) {
        this.layout = layout;
        this.photos = photos;
        columns = new int[photos.size()][photos.get(0).unknowns()];
        int next = 0;
        for (int[] of : columns) {
            for (int i = 0; i < of.length; i++) {
                if (photos.get(0).isOfPhoto(i)) {
                    of[i] = next++;
                }
            }
        }
        for (int i = 0; i < columns[0].length; i++) {
            if (!photos.get(0).isOfPhoto(i)) {
                for (int[] of : columns) {
                    of[i] = next;
                }
                next++;
            }
        }
        bodies = next;
        int count = 0;
        for (int id : seen) {
            List<Integer> plate = plateOf(id);
            Integer same = plate == null ? null
                    : plate.stream().map(bodyOf::get).filter(Objects::nonNull).findFirst().orElse(null);
            bodyOf.put(id, same == null ? count++ : same);
        }
        size = bodies + POSE * count;
        information = new double[size * size];
        addPriors(seen);
        for (Reference r : layout.cell().references()) {
            if (bodyOf.containsKey(r.id())) {
                double[] byBody = byBody(r);
                for (int p = 0; p < photos.size(); p++) {
                    double[] told = photos.get(p).withPlace(r.worldFromMarker(), r.sizeMm());
                    add(Objects.requireNonNull(told, "seen in every photo"), columns[p],
                            bodies + POSE * body(r.id()), byBody, information, size);
                }
            }
        }
        layout.distances().forEach(this::addDistance);
        for (ObjectMarker object : layout.cell().objects()) {
            List<RigidTransform> places = layout.worldFromObjects().get(object.id());
            if (places != null) {
                squares.put(object.id(), square(places.get(0), object.sizeMm()));
            }
        }
    }

    private int body(int id) {
        return Objects.requireNonNull(bodyOf.get(id), "a body of each that is seen");
    }

    private @Nullable List<Integer> plateOf(int id) {
        return layout.plates().stream().filter(plate -> plate.contains(id)).findFirst().orElse(null);
    }

    private Reference reference(int id) {
        return layout.cell().references().stream().filter(r -> r.id() == id).findFirst().orElseThrow();
    }

    /** The middle of a reference's plate, or of itself. */
    private double[] middle(int id) {
        List<Integer> plate = plateOf(id);
        List<Integer> of = plate == null ? List.of(id) : plate;
        double[] middle = new double[3];
        for (int other : of) {
            double[] at = reference(other).worldFromMarker().translationMm();
            for (int i = 0; i < 3; i++) {
                middle[i] += at[i] / of.size();
            }
        }
        return middle;
    }

    private void addPriors(List<Integer> seen) {
        double[] centroid = new double[3];
        for (Reference r : layout.cell().references()) {
            double[] at = r.worldFromMarker().translationMm();
            for (int i = 0; i < 3; i++) {
                centroid[i] += at[i] / layout.cell().references().size();
            }
        }
        for (int p = 0; p < photos.size(); p++) {
            double[] prior = photos.get(p).prior(seen.size(), centroid);
            int n = columns[p].length;
            for (int i = 0; i < n; i++) {
                for (int j = 0; j < n; j++) {
                    boolean once = photos.get(p).isOfPhoto(i) && photos.get(p).isOfPhoto(j) || p == 0;
                    information[columns[p][i] * size + columns[p][j]] += once ? prior[i * n + j] : 0;
                }
            }
        }
        for (int id : seen) {
            Placement placement = reference(id).placement();
            for (int i = 0; i < POSE; i++) {
                double std = Math.max(LEAST_STD, i < 3 ? placement.stdMm(i) : placement.stdRad());
                int at = bodies + POSE * body(id) + i;
                // of several on one plate, each states the same of it
                information[at * size + at] = 1 / (std * std);
            }
        }
    }

    /** How a marker moves with its body, 6 x 6: that of a plate turns about the plate's middle. */
    private double[] byBody(Reference r) {
        double[] at = r.worldFromMarker().translationMm();
        double[] middle = middle(r.id());
        double[] arm = {at[0] - middle[0], at[1] - middle[1], at[2] - middle[2]};
        double[] out = new double[POSE * POSE];
        for (int i = 0; i < POSE; i++) {
            out[i * POSE + i] = 1;
        }
        // w x arm
        out[4] = arm[2];
        out[5] = -arm[1];
        out[POSE + 3] = -arm[2];
        out[POSE + 5] = arm[0];
        out[2 * POSE + 3] = arm[1];
        out[2 * POSE + 4] = -arm[0];
        return out;
    }

    /** Adds what a marker tells, its place being that of a body. */
    private static void add(double[] told, int[] ofPhoto, int body, double @Nullable [] byBody, double[] to,
            int width) {
        int n = ofPhoto.length;
        int m = n + POSE;
        double[] turned = told.clone();
        if (byBody != null) {
            for (int row = 0; row < m; row++) {
                for (int c = 0; c < POSE; c++) {
                    double sum = 0;
                    for (int k = 0; k < POSE; k++) {
                        sum += told[row * m + n + k] * byBody[k * POSE + c];
                    }
                    turned[row * m + n + c] = sum;
                }
            }
            double[] both = turned.clone();
            for (int c = 0; c < m; c++) {
                for (int r = 0; r < POSE; r++) {
                    double sum = 0;
                    for (int k = 0; k < POSE; k++) {
                        sum += byBody[k * POSE + r] * both[(n + k) * m + c];
                    }
                    turned[(n + r) * m + c] = sum;
                }
            }
        }
        for (int i = 0; i < m; i++) {
            int row = i < n ? ofPhoto[i] : body + i - n;
            for (int j = 0; j < m; j++) {
                to[row * width + (j < n ? ofPhoto[j] : body + j - n)] += turned[i * m + j];
            }
        }
    }

    private void addDistance(MeasuredDistance distance) {
        if (!bodyOf.containsKey(distance.first()) || !bodyOf.containsKey(distance.second())) {
            return;
        }
        Reference a = reference(distance.first());
        Reference b = reference(distance.second());
        double[] from = a.worldFromMarker().translationMm();
        double[] to = b.worldFromMarker().translationMm();
        double length = Math.sqrt(Math.pow(to[0] - from[0], 2) + Math.pow(to[1] - from[1], 2)
                + Math.pow(to[2] - from[2], 2));
        double[] row = new double[size];
        for (int end = 0; end < 2; end++) {
            double[] byBody = byBody(end == 0 ? a : b);
            int first = bodies + POSE * body(end == 0 ? a.id() : b.id());
            for (int c = 0; c < POSE; c++) {
                for (int i = 0; i < 3; i++) {
                    row[first + c] += (end == 0 ? -1 : 1) * (to[i] - from[i]) / length * byBody[i * POSE + c];
                }
            }
        }
        for (int i = 0; i < size; i++) {
            for (int j = 0; j < size; j++) {
                information[i * size + j] += row[i] * row[j] / (distance.stdMm() * distance.stdMm());
            }
        }
    }

    /** What an object's square tells of the shared unknowns, its own pose eliminated; null where it is not seen. */
    private double @Nullable [] square(RigidTransform worldFromObject, double sizeMm) {
        double[] out = new double[size * size];
        for (int p = 0; p < photos.size(); p++) {
            PlannedView.SeenObject seen = photos.get(p).object(worldFromObject, sizeMm);
            if (seen == null) {
                return null;
            }
            double[] told = seen.information();
            int n = columns[p].length;
            for (int i = 0; i < n; i++) {
                for (int j = 0; j < n; j++) {
                    out[columns[p][i] * size + columns[p][j]] += told[i * n + j];
                }
            }
        }
        return out;
    }

    /**
     * What is known of a point of an object.
     *
     * @param object the object
     * @param worldFromObject where it stands
     * @param pointsMm in its marker's frame
     * @return for each point; null where a photo does not show the object
     */
    @Nullable List<Known> of(ObjectMarker object, RigidTransform worldFromObject, List<double[]> pointsMm) {
        int width = size + POSE;
        double[] all = new double[width * width];
        double[] ofObject = new double[POSE * POSE];
        for (int i = 0; i < size; i++) {
            System.arraycopy(information, i * size, all, i * width, size);
        }
        squares.forEach((id, square) -> {
            if (id != object.id() && square != null) {
                for (int i = 0; i < size; i++) {
                    for (int j = 0; j < size; j++) {
                        all[i * width + j] += square[i * size + j];
                    }
                }
            }
        });
        for (int p = 0; p < photos.size(); p++) {
            double[] told = photos.get(p).withPlace(worldFromObject, object.sizeMm());
            if (told == null) {
                return null;
            }
            add(told, columns[p], size, null, all, width);
        }
        for (int i = 0; i < POSE; i++) {
            System.arraycopy(all, (size + i) * width + size, ofObject, i * POSE, POSE);
        }
        double[] own = Cholesky.inverse(ofObject, POSE);
        double[] pose = own == null || !Cholesky.factor(all, width) ? null : lastBlock(all, width);
        List<Known> known = new ArrayList<>();
        for (double[] point : pointsMm) {
            double[] arm = worldFromObject.apply(point);
            double[] centre = worldFromObject.translationMm();
            for (int i = 0; i < 3; i++) {
                arm[i] -= centre[i];
            }
            if (own == null || pose == null) {
                double[] nothing = new double[9];
                Arrays.fill(nothing, Double.POSITIVE_INFINITY);
                known.add(new Known(nothing, nothing, nothing, nothing));
            } else {
                known.add(new Known(ofPoint(pose, arm), ofPoint(own, arm), turn(pose), turn(own)));
            }
        }
        return known;
    }

    /** Covariance of the last six unknowns, by the factor of all. */
    private static double[] lastBlock(double[] factor, int width) {
        int from = width - POSE;
        double[] corner = new double[POSE * POSE];
        for (int i = 0; i < POSE; i++) {
            for (int j = 0; j <= i; j++) {
                corner[i * POSE + j] = factor[(from + i) * width + from + j];
            }
        }
        double[] out = new double[POSE * POSE];
        double[] column = new double[POSE];
        for (int c = 0; c < POSE; c++) {
            Arrays.fill(column, 0);
            column[c] = 1;
            Cholesky.solveLower(corner, POSE, column);
            Cholesky.solveUpper(corner, POSE, column);
            for (int r = 0; r < POSE; r++) {
                out[r * POSE + c] = column[r];
            }
        }
        return out;
    }

    private static double[] ofPoint(double[] pose, double[] arm) {
        double[] rows = {1, 0, 0, 0, arm[2], -arm[1], 0, 1, 0, -arm[2], 0, arm[0], 0, 0, 1, arm[1], -arm[0], 0};
        double[] out = new double[9];
        for (int i = 0; i < 3; i++) {
            for (int j = 0; j < 3; j++) {
                for (int a = 0; a < POSE; a++) {
                    for (int b = 0; b < POSE; b++) {
                        out[3 * i + j] += rows[i * POSE + a] * pose[a * POSE + b] * rows[j * POSE + b];
                    }
                }
            }
        }
        return out;
    }

    private static double[] turn(double[] pose) {
        double[] out = new double[9];
        for (int i = 0; i < 3; i++) {
            System.arraycopy(pose, (3 + i) * POSE + 3, out, 3 * i, 3);
        }
        return out;
    }
}
