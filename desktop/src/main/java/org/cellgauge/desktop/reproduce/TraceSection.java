package org.cellgauge.desktop.reproduce;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Objects;
import org.cellgauge.cell.Cell;
import org.cellgauge.check.CellCheck;
import org.cellgauge.check.CheckResult;
import org.cellgauge.sampling.Quantity;
import org.cellgauge.sampling.Quantity.Axis;
import org.cellgauge.settings.ChainStart;
import org.cellgauge.settings.CheckSettings;
import org.cellgauge.statistics.ChainDiagnostics;
import org.cellgauge.vision.Detections;

/** Figures 7.2, 8.3 and 8.4: three chains of the thesis from different starts, all of their 10000 samples. */
final class TraceSection implements Section {
    private static final int CHAINS = 3;
    /** Of so many samples one is drawn. */
    private static final int THINNED = 50;
    private static final List<String> COLOURS = List.of(Svg.ORANGE, Svg.BLUE, Svg.GREEN);
    private static final List<Axis> AXES = List.of(Axis.X, Axis.Y, Axis.Z);

    private final String id;
    private final List<String> alsoCalled;
    private final String title;
    private final SetUp setUp;
    /** Whose traces; 0 for the camera. */
    private final int objectId;
    private final Work work;

    TraceSection(List<String> ids, String title, String setUpName, int objectId, Assumptions assumptions,
            Map<String, SetUp> setUps) {
        this.id = ids.get(0);
        alsoCalled = ids.subList(1, ids.size());
        this.title = title;
        this.setUp = Objects.requireNonNull(setUps.get(setUpName));
        this.objectId = objectId;
        work = new Work("traces-" + setUpName, setUp + assumptions.identity(), () -> traces(assumptions));
    }

    @Override
    public String id() {
        return id;
    }

    @Override
    public List<String> alsoCalled() {
        return alsoCalled;
    }

    @Override
    public String title() {
        return title;
    }

    @Override
    public List<Work> needs() {
        return List.of(work);
    }

    private Quantity quantity(Axis axis) {
        return objectId == 0 ? Quantity.camera(axis) : Quantity.object(objectId, axis);
    }

    /** The first start is the thesis' own, the others lie about the mode, wider than the posterior. */
    private Figures traces(Assumptions assumptions) {
        Cell cell = setUp.cell(assumptions);
        Detections detections = setUp.detections(assumptions);
        double[][][] kept = new double[AXES.size()][CHAINS][];
        Figures.Builder figures = new Figures.Builder();
        for (int chain = 0; chain < CHAINS; chain++) {
            CheckSettings settings = assumptions.asInThesis().warmup(0).seed(chain + 1L).threads(1)
                    .start(chain == 0 ? ChainStart.INITIAL_ESTIMATE : ChainStart.DISPERSED).build();
            CheckResult result = CellCheck.run(cell, detections, settings);
            for (int axis = 0; axis < AXES.size(); axis++) {
                double[] all = result.draws().get(0).series(result.layout().indexOf(quantity(AXES.get(axis))));
                int points = all.length / THINNED;
                double[] thin = new double[points];
                double[] mean = new double[points];
                double sum = 0;
                for (int i = 0; i < points * THINNED; i++) {
                    sum += all[i];
                    if (i % THINNED == THINNED - 1) {
                        thin[i / THINNED] = Math.rint(100 * all[i]) / 100;
                        mean[i / THINNED] = Math.rint(100 * sum / (i + 1)) / 100;
                    }
                }
                figures.put("trace." + axis + "." + chain, thin).put("mean." + axis + "." + chain, mean);
                kept[axis][chain] = Arrays.copyOfRange(all, all.length / 2, all.length);
                ChainDiagnostics alone = ChainDiagnostics.of(new double[][] {kept[axis][chain]});
                figures.append("stated." + axis, alone.mean(), alone.std());
            }
        }
        for (int axis = 0; axis < AXES.size(); axis++) {
            figures.put("rhat." + axis, ChainDiagnostics.of(kept[axis]).rHat());
        }
        return figures.build();
    }

    @Override
    public void write(Page page, Results results) {
        Figures figures = results.of(work.name());
        page.heading(3, title);
        List<String> words = new ArrayList<>();
        for (int axis = 0; axis < AXES.size(); axis++) {
            List<String> stated = new ArrayList<>();
            for (int chain = 0; chain < CHAINS; chain++) {
                stated.add(Words.fixed(figures.column("stated." + axis, 2, 0)[chain], 1) + " ± "
                        + Words.std(figures.column("stated." + axis, 2, 1)[chain]));
            }
            words.add(name(axis) + ": " + String.join(", ", stated) + " mm, R-hat "
                    + Words.fixed(figures.one("rhat." + axis), 2));
        }
        page.paragraph(setUp.words() + ". What the kept halves of the three chains state: " + String.join("; ", words)
                + ". Chains that had converged would state the same; running means would meet.");
        for (int axis = 0; axis < AXES.size(); axis++) {
            page.picture(id + "-" + name(axis) + ".svg", title + ", " + name(axis), diagram(figures, axis));
        }
    }

    private static String name(int axis) {
        return AXES.get(axis).name().toLowerCase(Locale.ROOT);
    }

    private Svg diagram(Figures figures, int axis) {
        double low = Double.POSITIVE_INFINITY;
        double high = Double.NEGATIVE_INFINITY;
        for (int chain = 0; chain < CHAINS; chain++) {
            low = Math.min(low, Words.min(figures.all("trace." + axis + "." + chain)));
            high = Math.max(high, Words.max(figures.all("trace." + axis + "." + chain)));
        }
        Svg svg = new Svg(760, 240, (objectId == 0 ? "camera" : "object " + objectId) + ", " + name(axis)
                + ": three chains, running means dark", Svg.Axis.linear("sample", 0, 10_000),
                Svg.Axis.linear("mm", low, high));
        for (int chain = 0; chain < CHAINS; chain++) {
            svg.legend(chain == 0 ? "initial estimate" : chain == 1 ? "2nd start" : "3rd start", COLOURS.get(chain));
            double[] trace = figures.all("trace." + axis + "." + chain);
            double[] at = new double[trace.length];
            for (int i = 0; i < at.length; i++) {
                at[i] = (i + 1.0) * THINNED;
            }
            svg.line(at, trace, COLOURS.get(chain), 0.8);
        }
        for (int chain = 0; chain < CHAINS; chain++) {
            double[] mean = figures.all("mean." + axis + "." + chain);
            double[] at = new double[mean.length];
            for (int i = 0; i < at.length; i++) {
                at[i] = (i + 1.0) * THINNED;
            }
            svg.line(at, mean, Svg.BLACK, 2.6);
            svg.line(at, mean, COLOURS.get(chain), 1.4);
        }
        return svg;
    }
}
