package org.cellgauge.desktop.reproduce;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;
import org.cellgauge.settings.LikelihoodModel;

/** Table 8.16, and what should stand in its place. */
final class DecisionSection implements Section {
    private static final double TOLERATED = 0.05;
    /** What the thesis promises without a bound. */
    private static final String NO_BOUND = "> 5 mm";

    private final DecisionWork work;
    private final DataNode advice = DataNode.ofResource("advice.yaml");

    DecisionSection(Assumptions assumptions, Effort effort) {
        work = new DecisionWork(assumptions, effort);
    }

    @Override
    public String id() {
        return "8.16";
    }

    @Override
    public List<String> alsoCalled() {
        return List.of("decisions");
    }

    @Override
    public String title() {
        return "Table 8.16: which set-up reaches which accuracy";
    }

    @Override
    public List<Work> needs() {
        return work.all();
    }

    @Override
    public void write(Page page, Results results) {
        DecisionTable table = new DecisionTable(work, results);
        double size = work.sizesMm()[0];
        double px = work.noisesPx()[0];
        double fine = work.noisesPx()[1];
        page.heading(3, title());
        page.paragraph("Objects lie in the plane as for Table 8.8; every figure is a root mean square over the three, "
                + "in "
                + "mm: the worst axis, in brackets the worse of x and y. \"Camera part\" is what placement and noise "
                + "of the "
                + "references leave; the corner noise of the object itself comes on top, and stands in columns of its "
                + "own.");
        page.paragraph("**What the thesis advises, and what comes of it** (" + Words.number(size) + " mm markers, " + px
                + " px unless said otherwise):");
        page.table(List.of("goal", "placed to", "references", "printed promise holds?", "camera part, thesis' "
                + "likelihood",
                "camera part, rigid", "with own noise of " + fine + " px", "with own noise of " + px + " px"),
                adviceRows(table, size, px, fine));
        page.paragraph(agreement(results, table, size, px));
        page.paragraph("**The object's own noise**, whatever the references: ");
        List<List<String>> own = new ArrayList<>();
        for (double markers : work.sizesMm()) {
            for (double noise : work.noisesPx()) {
                double[] mm = table.ownMm(new Layout("plane", 4, 1, markers, noise));
                own.add(List.of(Words.number(markers) + " mm", noise + " px", Words.std(mm[0]), Words.std(mm[1]),
                        Words.std(mm[2])));
            }
        }
        page.table(List.of("marker", "corner noise", "x", "y", "z"), own);
        goals(page, table);
        for (double markers : work.sizesMm()) {
            grid(page, table, LikelihoodModel.RIGID_MARKER, markers, px);
        }
        for (double markers : work.sizesMm()) {
            grid(page, table, LikelihoodModel.RIGID_MARKER, markers, fine);
        }
        for (double markers : work.sizesMm()) {
            grid(page, table, LikelihoodModel.CORNER_CUBE, markers, px);
        }
    }

    /** The thesis' advice, a row each. */
    private List<List<String>> adviceRows(DecisionTable table, double size, double px, double fine) {
        List<List<String>> rows = new ArrayList<>();
        for (DataNode item : advice.at("advice").items()) {
            List<DataNode> cells = item.items();
            Layout layout = new Layout(cells.get(4).text(), (int) cells.get(3).number(), cells.get(2).number(), size,
                    px);
            Layout finer = new Layout(layout.arrangement(), layout.references(), layout.stdMm(), size, fine);
            double bound = cells.get(1).number();
            double[] cube = table.stdMm(LikelihoodModel.CORNER_CUBE, layout);
            double[] rigid = table.stdMm(LikelihoodModel.RIGID_MARKER, layout);
            double[] fineRigid = table.stdMm(LikelihoodModel.RIGID_MARKER, finer);
            rows.add(List.of(cells.get(0).text(), Words.number(layout.stdMm()) + " mm",
                    layout.references() + ", " + words(layout.arrangement()), promise(bound, cube, rigid), both(cube),
                    both(rigid), both(DecisionTable.together(fineRigid, table.ownMm(finer))),
                    both(DecisionTable.together(rigid, table.ownMm(layout)))));
        }
        return rows;
    }

    private static String promise(double bound, double[] cube, double[] rigid) {
        if (Double.isInfinite(bound)) {
            return "yes: " + NO_BOUND + " is no promise";
        }
        double least = Math.min(DecisionTable.worst(cube), DecisionTable.worst(rigid));
        return least <= bound ? "yes" : "no: " + Words.times(least / bound) + " the bound at least";
    }

    /** How near forecasts are to chains, and both to the independent implementation. */
    private String agreement(Results results, DecisionTable table, double size, double px) {
        Figures rigid = results.of("decision-rigid-sampled");
        double[] sampled = rigid.all("sampled");
        double[] forecast = rigid.all("forecast");
        double most = 0;
        int compared = 0;
        for (int i = 0; i < sampled.length; i++) {
            if (Double.isFinite(sampled[i])) {
                most = Math.max(most, Math.abs(forecast[i] / sampled[i] - 1));
                compared++;
            }
        }
        double[] apart = {0, 0};
        int[] counted = {0, 0};
        List<String> beyond = new ArrayList<>();
        for (LikelihoodModel model : List.of(LikelihoodModel.RIGID_MARKER, LikelihoodModel.CORNER_CUBE)) {
            DataNode arrangements = advice.at("independent").at(model.word());
            for (String arrangement : arrangements.keys()) {
                for (String std : arrangements.at(arrangement).keys()) {
                    String[] printed = arrangements.at(arrangement).at(std).text().split(" ");
                    for (int i = 0; i < printed.length; i++) {
                        Layout layout = new Layout(arrangement, Layout.FEWEST + i / 2, Double.parseDouble(std),
                                size, px);
                        double[] ours = table.stdMm(model, layout);
                        double off = beyondRounding(printed[i],
                                i % 2 == 0 ? DecisionTable.worst(ours) : DecisionTable.lateral(ours));
                        int at = model == LikelihoodModel.RIGID_MARKER ? 0 : 1;
                        apart[at] = Math.max(apart[at], off);
                        counted[at]++;
                        if (off > TOLERATED) {
                            beyond.add(model.word() + " " + std + " mm, " + layout.references() + " "
                                    + words(arrangement) + ": " + printed[i] + " there, "
                                    + Words.percent(off) + " off");
                        }
                    }
                }
            }
        }
        return "Forecasts by Laplace's approximation stand for the rigid likelihood: held against chains in " + compared
                + " deviations (2 to 6 references, 1, 5 and 20 mm) they are " + Words.percent(most)
                + " off at most. The thesis' likelihood is sampled from " + Words.number(DecisionWork.SAMPLED_FROM_MM)
                + " mm on. Against an independent implementation (" + counted[0] + " and " + counted[1]
                + " figures), beyond the rounding of its figures: rigid " + Words.percent(apart[0]) + " off at most, "
                + "thesis' "
                + Words.percent(apart[1]) + (beyond.isEmpty() ? "." : "; by more than 5 %: "
                        + String.join("; ", beyond) + ". Two references at 20 mm lean on a weak prior of the pose, "
                        + "which "
                        + "is about the first estimate here and about the truth there.");
    }

    /** The share by which a figure is off, after what rounding explains. */
    static double beyondRounding(String printed, double ours) {
        int point = printed.indexOf('.');
        double half = 0.5 * Math.pow(10, point < 0 ? 0 : point + 1 - printed.length());
        double figure = Double.parseDouble(printed);
        return Math.max(0, Math.abs(ours - figure) - half) / figure;
    }

    /** The coarsest placement that reaches a goal. */
    private void goals(Page page, DecisionTable table) {
        page.paragraph("**The table that should have stood there**: the coarsest placement of the grid, in mm, with "
                + "which "
                + "the worst axis reaches the goal, rigid likelihood. First for the camera part alone, then with the "
                + "object's own noise; a dash where even " + Words.number(work.stdsMm()[0]) + " mm does not do.");
        for (double size : work.sizesMm()) {
            for (double px : work.noisesPx()) {
                List<String> head = new ArrayList<>(List.of(Words.number(size) + " mm, " + px + " px", "goal"));
                for (int n = Layout.FEWEST; n <= Layout.MOST; n++) {
                    head.add(n + " references");
                }
                List<List<String>> rows = new ArrayList<>();
                for (double goal : work.goalsMm()) {
                    for (String arrangement : Layout.ARRANGEMENTS) {
                        List<String> row = new ArrayList<>(List.of(words(arrangement), Words.number(goal) + " mm"));
                        for (int n = Layout.FEWEST; n <= Layout.MOST; n++) {
                            row.add(coarsest(table, arrangement, n, size, px, goal, false) + " / "
                                    + coarsest(table, arrangement, n, size, px, goal, true));
                        }
                        rows.add(row);
                    }
                }
                page.table(head, rows);
            }
        }
    }

    private String coarsest(DecisionTable table, String arrangement, int n, double size, double px, double goal,
            boolean withOwn) {
        String coarsest = "–";
        for (double std : work.stdsMm()) {
            Layout layout = new Layout(arrangement, n, std, size, px);
            double[] camera = table.stdMm(LikelihoodModel.RIGID_MARKER, layout);
            double[] all = withOwn ? DecisionTable.together(camera, table.ownMm(layout)) : camera;
            if (DecisionTable.worst(all) <= goal) {
                coarsest = Words.number(std);
            }
        }
        return coarsest;
    }

    private void grid(Page page, DecisionTable table, LikelihoodModel model, double size, double px) {
        String noise = model == LikelihoodModel.RIGID_MARKER ? ", corner noise " + px + " px" : "";
        page.paragraph("**Camera part, " + (model == LikelihoodModel.RIGID_MARKER ? "rigid likelihood"
                : "the thesis' likelihood, converged") + ", markers of " + Words.number(size) + " mm" + noise
                + "**, by placement:");
        List<String> head = new ArrayList<>(List.of("references"));
        for (double std : work.stdsMm()) {
            head.add(Words.number(std) + " mm");
        }
        List<List<String>> rows = new ArrayList<>();
        for (String arrangement : Layout.ARRANGEMENTS) {
            for (int n = Layout.FEWEST; n <= Layout.MOST; n++) {
                List<String> row = new ArrayList<>(List.of(n + ", " + words(arrangement)));
                for (double std : work.stdsMm()) {
                    row.add(both(table.stdMm(model, new Layout(arrangement, n, std, size, px))));
                }
                rows.add(row);
            }
        }
        page.table(head, rows);
    }

    static String both(double[] stdMm) {
        return Double.isNaN(stdMm[0]) ? "not converged"
                : Words.std(DecisionTable.worst(stdMm)) + " (" + Words.std(DecisionTable.lateral(stdMm)) + ")";
    }

    static String words(String arrangement) {
        return arrangement.equals("plane") ? "in the plane"
                : List.of(arrangement.split("-")).stream().collect(Collectors.joining(" "));
    }
}
