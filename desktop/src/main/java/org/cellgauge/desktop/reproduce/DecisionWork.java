package org.cellgauge.desktop.reproduce;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Supplier;
import org.cellgauge.settings.CheckSettings;
import org.cellgauge.settings.LikelihoodModel;
import org.cellgauge.settings.ObjectNoise;

/**
 * What the corrected decision table rests on. By Laplace's approximation where chains agree with it (the rigid
 * likelihood), by chains where it is far off (boxes of more than half a millimetre).
 */
final class DecisionWork {
    /** Placement from which on the thesis' likelihood is sampled: below, its posterior is as good as Gaussian. */
    static final double SAMPLED_FROM_MM = 1;
    static final int AXES = 3;
    private static final List<LikelihoodModel> MODELS =
            List.of(LikelihoodModel.RIGID_MARKER, LikelihoodModel.CORNER_CUBE);
    /** Where one can be held against the other, and against an independent implementation. */
    private static final double[] CHECKED_MM = {1, 5, 20};
    private static final int MOST_CHECKED = 6;
    private static final int MOST_SAMPLED_QUICK = 3;

    private final Assumptions assumptions;
    private final Effort effort;

    DecisionWork(Assumptions assumptions, Effort effort) {
        this.assumptions = assumptions;
        this.effort = effort;
    }

    double[] stdsMm() {
        return assumptions.at("layouts").at("std_mm").numbers();
    }

    double[] sizesMm() {
        double[] all = assumptions.at("layouts").at("sizes_mm").numbers();
        return effort.isQuick() ? new double[] {all[0]} : all;
    }

    double[] goalsMm() {
        return assumptions.at("layouts").at("goals_mm").numbers();
    }

    /** Corner noise: the usual one, and that of fine corners. */
    double[] noisesPx() {
        return new double[] {assumptions.at("layouts").at("pixel_std_px").number(),
            assumptions.at("layouts").at("fine_pixel_std_px").number()};
    }

    /** Up to how many references the thesis' likelihood is sampled: with more it is nearer to Gaussian. */
    int mostSampled() {
        return effort.isQuick() ? MOST_SAMPLED_QUICK : Layout.MOST;
    }

    List<Work> all() {
        List<Work> all = new ArrayList<>();
        all.add(forecasts());
        for (double size : sizesMm()) {
            for (String arrangement : Layout.ARRANGEMENTS) {
                all.add(work(sampledName(size, arrangement), () -> sampledCubes(size, arrangement)));
            }
        }
        all.add(work("decision-rigid-sampled", this::sampledRigid));
        return all;
    }

    /** Of every layout by Laplace's approximation: takes about a second. */
    Work forecasts() {
        return work("decision-forecasts", this::forecast);
    }

    private Work work(String name, Supplier<Figures> figures) {
        return new Work(name, effort + "\n" + assumptions.identity() + assumptions.at("layouts").text(), figures);
    }

    static String sampledName(double sizeMm, String arrangement) {
        return "decision-cube-" + Words.number(sizeMm) + "-" + arrangement;
    }

    /** The camera's part alone. */
    private CheckSettings settings(LikelihoodModel model) {
        return effort.untilPrecise().likelihood(model).kappa(assumptions.at("sampler").at("kappa").number())
                .objectNoise(ObjectNoise.NONE).build();
    }

    /** The name of a row of figures: x, y, z for each deviation in turn. */
    static String key(LikelihoodModel model, double sizeMm, double pixelStdPx, String arrangement, int references) {
        return model.word() + " " + Words.number(sizeMm) + " " + pixelStdPx + " " + arrangement + " " + references;
    }

    /** What the object's own corner noise adds, x, y, z. */
    static String ownKey(double sizeMm, double pixelStdPx) {
        return "own " + Words.number(sizeMm) + " " + pixelStdPx;
    }

    private Figures forecast() {
        Figures.Builder figures = new Figures.Builder();
        for (double size : sizesMm()) {
            for (double px : noisesPx()) {
                for (LikelihoodModel model : MODELS) {
                    for (String arrangement : Layout.ARRANGEMENTS) {
                        for (int n = Layout.FEWEST; n <= Layout.MOST; n++) {
                            for (double std : stdsMm()) {
                                figures.append(key(model, size, px, arrangement, n),
                                        new Layout(arrangement, n, std, size, px)
                                                .forecast(assumptions, settings(model)));
                            }
                        }
                    }
                }
                figures.put(ownKey(size, px), own(new Layout("plane", 4, 1, size, px)));
            }
        }
        return figures.build();
    }

    private double[] own(Layout layout) {
        double[] all = layout.forecast(assumptions, effort.untilPrecise().build());
        double[] camera = layout.forecast(assumptions, settings(LikelihoodModel.RIGID_MARKER));
        for (int i = 0; i < all.length; i++) {
            all[i] = Math.sqrt(all[i] * all[i] - camera[i] * camera[i]);
        }
        return all;
    }

    private Figures sampledCubes(double sizeMm, String arrangement) {
        Figures.Builder figures = new Figures.Builder();
        CheckSettings settings = settings(LikelihoodModel.CORNER_CUBE);
        for (int n = Layout.FEWEST; n <= mostSampled(); n++) {
            for (double std : stdsMm()) {
                if (std >= SAMPLED_FROM_MM) {
                    figures.append(Integer.toString(n), new Layout(arrangement, n, std, sizeMm, noisesPx()[0])
                            .sampled(assumptions, settings));
                }
            }
        }
        return figures.build();
    }

    private Figures sampledRigid() {
        Figures.Builder figures = new Figures.Builder();
        for (String arrangement : Layout.ARRANGEMENTS.subList(0, 2)) {
            for (double std : CHECKED_MM) {
                for (int n = Layout.FEWEST; n <= MOST_CHECKED; n++) {
                    Layout layout = new Layout(arrangement, n, std, sizesMm()[0], noisesPx()[0]);
                    figures.append("sampled", layout.sampled(assumptions, settings(LikelihoodModel.RIGID_MARKER)));
                    figures.append("forecast", layout.forecast(assumptions, settings(LikelihoodModel.RIGID_MARKER)));
                }
            }
        }
        return figures.build();
    }
}
