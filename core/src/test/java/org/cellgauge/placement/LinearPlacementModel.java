package org.cellgauge.placement;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.apache.commons.math3.distribution.NormalDistribution;
import org.apache.commons.math3.random.RandomGenerator;
import org.apache.commons.math3.special.Erf;
import org.cellgauge.cell.Placement;
import org.cellgauge.cell.Reference;
import org.cellgauge.check.ThesisScene;
import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.internal.geometry.MarkerGeometry;
import org.cellgauge.internal.sampling.RandomStreams;
import org.ejml.simple.SimpleEVD;
import org.ejml.simple.SimpleMatrix;

/**
 * What tests of misplaced references can reach, in the model linearised at the true pose: an independent computation,
 * with derivatives taken numerically and limits found by counting simulated cells.
 *
 * <p>Scores of all placement coordinates (one stated deviation each) are normal with covariance G = D^T P D. Where
 * coordinate j is off by a, in the place of its random error, they have mean a G_j and covariance G - G_j G_j^T.
 */
final class LinearPlacementModel {
    /** So many stated deviations a reference is off. */
    static final double OFF = 5;
    private static final NormalDistribution NORMAL = new NormalDistribution(null, 0, 1);
    private static final double HALF = Math.sqrt(0.5);
    private static final int CELLS = 50_000;
    private static final int CELLS_PER_ALTERNATIVE = 2000;

    private final int references;
    private final SimpleMatrix covariance;
    /** Sensitivities along x and y, reference by reference. */
    private final double[] inPlane;
    private final Tests tests;
    /** Likelihood ratio of the likeliest reference, and smallest p over weight, of cells as stated; ascending. */
    private final double[] ratios = new double[CELLS];
    private final double[] least = new double[CELLS];

    LinearPlacementModel(ThesisScene scene, double pixelStdPx) {
        List<Reference> all = scene.cell().references();
        references = all.size();
        SimpleMatrix byPose = new SimpleMatrix(8 * references, 6);
        SimpleMatrix byPlacement = new SimpleMatrix(8 * references, 6 * references);
        for (int m = 0; m < references; m++) {
            Placement p = all.get(m).placement();
            for (int c = 0; c < 6; c++) {
                double h = c < 3 ? 0.01 : 1e-5;
                double std = c < 3 ? p.stdMm(c) : p.stdRad();
                double[] up = corners(all.get(m), c, h, -1);
                double[] down = corners(all.get(m), c, -h, -1);
                double[] poseUp = corners(all.get(m), -1, h, c);
                double[] poseDown = corners(all.get(m), -1, -h, c);
                for (int i = 0; i < 8; i++) {
                    byPlacement.set(8 * m + i, 6 * m + c, std * (up[i] - down[i]) / (2 * h));
                    byPose.set(8 * m + i, c, (poseUp[i] - poseDown[i]) / (2 * h));
                }
            }
        }
        SimpleMatrix w = byPlacement.mult(byPlacement.transpose())
                .plus(SimpleMatrix.identity(8 * references).scale(pixelStdPx * pixelStdPx)).invert();
        SimpleMatrix normal = byPose.transpose().mult(w).mult(byPose);
        SimpleMatrix left = w.minus(w.mult(byPose).mult(normal.invert()).mult(byPose.transpose()).mult(w));
        covariance = byPlacement.transpose().mult(left).mult(byPlacement);
        inPlane = new double[2 * references];
        for (int i = 0; i < inPlane.length; i++) {
            inPlane[i] = sensitivity(i / 2, i % 2);
        }
        tests = new Tests();
        RandomGenerator random = RandomStreams.of(1);
        double[][] root = root(covariance);
        double[] u = new double[6 * references];
        for (int i = 0; i < CELLS; i++) {
            draw(root, random, u);
            ratios[i] = likelihoodRatio(likeliest(u), u);
            least[i] = tests.leastOverWeight(u);
        }
        Arrays.sort(ratios);
        Arrays.sort(least);
    }

    /** Corners of a reference when it (placement) or the camera (pose) is moved by h along or about a world axis. */
    private static double[] corners(Reference reference, int placement, double h, int pose) {
        RigidTransform marker = moved(reference.worldFromMarker(), placement, h);
        RigidTransform camera = moved(ThesisScene.WORLD_FROM_CAMERA, pose, h);
        double[] c = MarkerGeometry.cornersMm(camera.inverse().compose(marker), reference.sizeMm());
        double[] px = new double[8];
        for (int k = 0; k < 4; k++) {
            double[] uv = ThesisScene.CAMERA.project(c[3 * k], c[3 * k + 1], c[3 * k + 2]);
            px[2 * k] = uv[0];
            px[2 * k + 1] = uv[1];
        }
        return px;
    }

    private static RigidTransform moved(RigidTransform pose, int coordinate, double h) {
        double[] w = new double[3];
        double[] t = pose.translationMm();
        if (coordinate >= 3) {
            w[coordinate - 3] = h;
        } else if (coordinate >= 0) {
            t[coordinate] += h;
        }
        RigidTransform turned = RigidTransform.ofRotationVector(w, new double[3])
                .compose(RigidTransform.of(pose.rotation(), new double[3]));
        return RigidTransform.of(turned.rotation(), t);
    }

    /** Deviation of the score of one coordinate: how much of a shift the pose and corner noise leave to be seen. */
    double sensitivity(int reference, int coordinate) {
        int j = 6 * reference + coordinate;
        return Math.sqrt(Math.max(0, covariance.get(j, j)));
    }

    // ---- bounds

    /**
     * Chance with which a test at 1 % false alarms that is told which reference may be off, along which axis and to
     * which side finds it; mean over references and the axes x and y.
     */
    double clairvoyant() {
        double sum = 0;
        for (int m = 0; m < references; m++) {
            for (int axis = 0; axis < 2; axis++) {
                double s = sensitivity(m, axis);
                sum += NORMAL.cumulativeProbability((OFF * s - NORMAL.inverseCumulativeProbability(0.99))
                        / Math.sqrt(1 - s * s));
            }
        }
        return sum / (2 * references);
    }

    /**
     * The largest share, over references and the axes x and y, that any rule with so many false alarms names: by the
     * lemma of Neyman and Pearson that of the rule that names the reference with the largest likelihood ratio, where
     * this is beyond a limit. It knows that one reference is off by just 5 deviations along x or y, but not which,
     * along which and to which side.
     */
    double bound(double level) {
        RandomGenerator random = RandomStreams.of(2);
        double[] u = new double[6 * references];
        double limit = ratios[(int) ((1 - level) * CELLS)];
        int named = 0;
        for (int m = 0; m < references; m++) {
            for (int axis = 0; axis < 2; axis++) {
                double[][] off = rootOff(6 * m + axis);
                for (int i = 0; i < CELLS_PER_ALTERNATIVE; i++) {
                    drawOff(off, 6 * m + axis, random, u);
                    int likeliest = likeliest(u);
                    named += likeliest == m && likelihoodRatio(likeliest, u) > limit ? 1 : 0;
                }
            }
        }
        return (double) named / (2 * references * CELLS_PER_ALTERNATIVE);
    }

    private int likeliest(double[] u) {
        int likeliest = 0;
        double most = -1;
        for (int m = 0; m < references; m++) {
            double ratio = likelihoodRatio(m, u);
            if (ratio > most) {
                most = ratio;
                likeliest = m;
            }
        }
        return likeliest;
    }

    /** How much likelier the scores are if this reference is off along x or y, to either side, than if none is. */
    private double likelihoodRatio(int reference, double[] u) {
        double sum = 0;
        for (int axis = 0; axis < 2; axis++) {
            double s = inPlane[2 * reference + axis];
            double t = u[6 * reference + axis] / s;
            double variance = 1 - s * s;
            for (int side = -1; side <= 1; side += 2) {
                double d = t - side * OFF * s;
                sum += Math.exp(t * t / 2 - d * d / (2 * variance)) / Math.sqrt(variance);
            }
        }
        return sum;
    }

    // ---- the product's tests

    /** The tests as docs/misplaced.md describes them, limits by counting. */
    private final class Tests {
        final List<double[]> directions = new ArrayList<>();
        final List<Integer> of = new ArrayList<>();
        final List<Double> deviations = new ArrayList<>();
        final List<Double> weights = new ArrayList<>();

        Tests() {
            for (int m = 0; m < references; m++) {
                for (int c = 0; c < 3; c++) {
                    add(m, 1, c, -1, 1);
                    add(m, 1, c, (c + 1) % 3, 0.2);
                    add(m, -1, c, (c + 1) % 3, 0.2);
                    add(m, 1, 3 + c, -1, 0.05);
                }
            }
        }

        /** Smallest p over weight of all tests. */
        double leastOverWeight(double[] u) {
            double least = 1;
            for (int t = 0; t < of.size(); t++) {
                double size = Math.abs(statistic(t, u));
                if (size > 2.3) {
                    least = Math.min(least, Erf.erfc(size / Math.sqrt(2)) / weights.get(t));
                }
            }
            return least;
        }

        /** Limits with a chance of any false alarm: its quantile of p over weight is the scale of all levels. */
        double[] limits(double level) {
            double scale = least[(int) (level * CELLS)];
            double[] limits = new double[of.size()];
            for (int t = 0; t < limits.length; t++) {
                limits[t] = NORMAL.inverseCumulativeProbability(1 - scale * weights.get(t) / 2);
            }
            return limits;
        }

        private void add(int m, int sign, int first, int second, double weight) {
            double[] d = new double[6];
            d[first] = second < 0 ? 1 : HALF;
            if (second >= 0) {
                d[second] = sign * HALF;
            }
            double variance = 0;
            for (int a = 0; a < 6; a++) {
                for (int b = 0; b < 6; b++) {
                    variance += d[a] * d[b] * covariance.get(6 * m + a, 6 * m + b);
                }
            }
            double s = Math.sqrt(variance);
            directions.add(d);
            of.add(m);
            deviations.add(s);
            weights.add(weight * NORMAL.cumulativeProbability((5 * s - 3.3) / Math.sqrt(1 - variance)));
        }

        double statistic(int t, double[] u) {
            double sum = 0;
            double[] d = directions.get(t);
            for (int c = 0; c < 6; c++) {
                sum += d[c] == 0 ? 0 : d[c] * u[6 * of.get(t) + c];
            }
            return sum / deviations.get(t);
        }

        /** The reference named, or -1. */
        int named(double[] u, double[] limits) {
            int named = -1;
            double most = Double.NEGATIVE_INFINITY;
            for (int t = 0; t < of.size(); t++) {
                double statistic = statistic(t, u);
                double evidence = statistic * statistic + 2 * Math.log(weights.get(t));
                if (Math.abs(statistic) > limits[t] && evidence > most) {
                    most = evidence;
                    named = of.get(t);
                }
            }
            return named;
        }
    }

    /** Share named of references off along x, y (each in turn) at a level of false alarms. */
    double namedAlongAxes(double level) {
        double[] limits = tests.limits(level);
        RandomGenerator random = RandomStreams.of(3);
        double[] u = new double[6 * references];
        int named = 0;
        for (int m = 0; m < references; m++) {
            for (int axis = 0; axis < 2; axis++) {
                double[][] off = rootOff(6 * m + axis);
                for (int i = 0; i < CELLS_PER_ALTERNATIVE; i++) {
                    drawOff(off, 6 * m + axis, random, u);
                    named += tests.named(u, limits) == m ? 1 : 0;
                }
            }
        }
        return (double) named / (2 * references * CELLS_PER_ALTERNATIVE);
    }

    /** Share named of references off in any direction, all alike, of the plane (2) or of space (3). */
    double namedInAnyDirection(double level, int dimensions) {
        double[] limits = tests.limits(level);
        RandomGenerator random = RandomStreams.of(4);
        double[] u = new double[6 * references];
        int named = 0;
        for (int m = 0; m < references; m++) {
            SimpleMatrix columns = covariance.extractMatrix(0, 6 * references, 6 * m, 6 * m + dimensions);
            double[][] rest = root(covariance.minus(columns.mult(columns.transpose())));
            for (int i = 0; i < CELLS_PER_ALTERNATIVE; i++) {
                draw(rest, random, u);
                double[] e = new double[dimensions];
                double squares = 0;
                for (int c = 0; c < dimensions; c++) {
                    e[c] = random.nextGaussian();
                    squares += e[c] * e[c];
                }
                for (int j = 0; j < u.length; j++) {
                    for (int c = 0; c < dimensions; c++) {
                        u[j] += OFF * e[c] / Math.sqrt(squares) * columns.get(j, c);
                    }
                }
                named += tests.named(u, limits) == m ? 1 : 0;
            }
        }
        return (double) named / (references * CELLS_PER_ALTERNATIVE);
    }

    // ---- draws

    private double[][] rootOff(int j) {
        SimpleMatrix column = covariance.extractVector(false, j);
        return root(covariance.minus(column.mult(column.transpose())));
    }

    private void drawOff(double[][] root, int j, RandomGenerator random, double[] u) {
        draw(root, random, u);
        for (int i = 0; i < u.length; i++) {
            u[i] += OFF * covariance.get(i, j);
        }
    }

    /** Root of a covariance, column by column. */
    private static double[][] root(SimpleMatrix matrix) {
        SimpleEVD<SimpleMatrix> eigen = matrix.plus(matrix.transpose()).scale(0.5).eig();
        int n = matrix.getNumRows();
        double[][] root = new double[n][n];
        for (int k = 0; k < n; k++) {
            double length = Math.sqrt(Math.max(0, eigen.getEigenvalue(k).getReal()));
            SimpleMatrix vector = eigen.getEigenVector(k);
            for (int i = 0; i < n; i++) {
                root[k][i] = length * vector.get(i);
            }
        }
        return root;
    }

    private static void draw(double[][] root, RandomGenerator random, double[] u) {
        Arrays.fill(u, 0);
        for (int k = 0; k < u.length; k++) {
            double z = random.nextGaussian();
            double[] column = root[k];
            for (int i = 0; i < u.length; i++) {
                u[i] += column[i] * z;
            }
        }
    }
}
