package org.cellgauge.desktop.reproduce;

import org.cellgauge.cell.Cell;
import org.cellgauge.check.CellCheck;
import org.cellgauge.check.CheckResult;
import org.cellgauge.settings.CheckSettings;
import org.cellgauge.settings.InitialEstimate;
import org.cellgauge.settings.LikelihoodModel;
import org.cellgauge.settings.ObjectNoise;
import org.cellgauge.vision.Detections;

/**
 * One experiment run three times: as in the thesis ({@link ThesisChains}), its own posterior until it has converged
 * ({@code same.}), and the library's default ({@code right.}).
 */
final class SetUpWork {
    private static final String SAME = "same.";
    private static final String RIGHT = "right.";
    private static final double SMALLEST_DEVIATION = 1e-12;
    /** Of the thesis' posterior with unknown focal lengths, whose long tails take minutes for less. */
    static final double FOCAL_PRECISION = 0.05;

    private SetUpWork() {
    }

    /** All three on one photo. */
    static Work of(SetUp setUp, Assumptions assumptions, Effort effort) {
        return of(setUp.name(), setUp, assumptions, effort);
    }

    /** The same under another name, for another assumption. */
    static Work of(String name, SetUp setUp, Assumptions assumptions, Effort effort) {
        return new Work(name, setUp + "\n" + effort + "\n" + assumptions.identity(),
                () -> run(setUp, assumptions, effort));
    }

    private static Figures run(SetUp setUp, Assumptions assumptions, Effort effort) {
        Cell cell = setUp.cell(assumptions);
        Detections detections = setUp.detections(assumptions);
        CheckSettings.Builder thesis = assumptions.asInThesis().estimate(setUp.estimate());
        if (setUp.ransac()) {
            thesis.initial(InitialEstimate.RANSAC);
        }
        Figures.Builder figures = new Figures.Builder();
        figures.putAll("", ThesisChains.run(cell, detections, thesis, effort.seeds()));
        figures.putAll(SAME, converged(cell, detections, same(assumptions, effort, setUp).build()));
        figures.putAll(RIGHT, converged(cell, detections, right(assumptions, effort, setUp).build()));
        return figures.build();
    }

    /** The thesis' posterior, sampled by what converges. */
    static CheckSettings.Builder same(Assumptions assumptions, Effort effort, SetUp setUp) {
        CheckSettings thesis = assumptions.asInThesis().build();
        CheckSettings.Builder precise = setUp.focal()
                ? effort.untilPrecise().targetMcseStdRel(Math.max(FOCAL_PRECISION, effort.precision()))
                : effort.untilPrecise();
        return precise.likelihood(LikelihoodModel.CORNER_CUBE).kappa(thesis.model().kappa())
                .objectNoise(ObjectNoise.NONE).rotationPrior(thesis.model().rotationPrior())
                .estimate(setUp.estimate()).focalPriorStdPx(thesis.model().focalPriorStdPx())
                .aspectPriorStd(thesis.model().aspectPriorStd());
    }

    /** The library's default. */
    static CheckSettings.Builder right(Assumptions assumptions, Effort effort, SetUp setUp) {
        return effort.untilPrecise().estimate(setUp.estimate())
                .focalPriorStdPx(assumptions.asInThesis().build().model().focalPriorStdPx());
    }

    /** Means, deviations, and whether the chains have converged. */
    static Figures converged(Cell cell, Detections detections, CheckSettings settings) {
        CheckResult result = CellCheck.run(cell, detections, settings);
        Figures.Builder figures = new Figures.Builder();
        ThesisChains.putEstimate(figures, "", result.estimate());
        return figures.put("converged", result.diagnostics().converged() ? 1 : 0)
                .put("rhat", Math.max(SMALLEST_DEVIATION, result.diagnostics().rHatMax()))
                .put("pixel_std_px", result.pixelStdPx()).build();
    }
}
