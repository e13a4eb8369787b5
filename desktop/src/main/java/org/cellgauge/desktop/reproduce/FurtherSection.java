package org.cellgauge.desktop.reproduce;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;

/** The further work that the thesis asks for, answered. */
final class FurtherSection implements Section {
    private final FurtherWork work;

    FurtherSection(Assumptions assumptions, Map<String, SetUp> setUps, Effort effort) {
        work = new FurtherWork(assumptions, setUps, effort);
    }

    @Override
    public String id() {
        return "further";
    }

    @Override
    public String title() {
        return "Further research, done";
    }

    @Override
    public List<Work> needs() {
        return work.all();
    }

    @Override
    public void write(Page page, Results results) {
        page.heading(3, title());
        page.paragraph("On exact corners with a noise of 0.1 px stated; the rest as in the assumptions. "
                + "`cellgauge reproduce further` prints this part alone; each answer also names the command that "
                + "gives the "
                + "like for a cell of one's own.");
        corners(page, results.of("further-corners"));
        grip(page, results.of("further-grip"));
        intrinsics(page, results.of("further-intrinsics"));
        starts(page, results.of("further-start"));
        more(page, results);
        misplaced(page, results.of("further-misplaced"));
    }

    private static void corners(Page page, Figures figures) {
        page.paragraph("**Four corners that move together.** The rigid likelihood has them so. Cells of four "
                + "references "
                + "were drawn with rigid placement errors of 5 mm; errors of the objects over what was stated of "
                + "them, root "
                + "mean square, should be 1:");
        List<List<String>> rows = new ArrayList<>();
        List.of("cube 0.5", "cube 1", "rigid").forEach(model -> rows.add(List.of(
                model.startsWith("cube") ? "corners on their own, kappa " + model.substring(5) : "corners as one",
                Words.fixed(figures.all(model)[0], 2), Words.fixed(figures.all(model)[1], 2))));
        page.table(List.of("likelihood", "x and y", "z"), rows);
        page.paragraph("`cellgauge validate --cell CELL --model corner-cube`, and without `--model`.");
    }

    private void grip(Page page, Figures figures) {
        page.paragraph("**Translation and rotation as one: the gripping point**, 100 mm above the object. Worst axis "
                + "of "
                + "any object, mm, four references, objects lifted:");
        List<List<String>> rows = new ArrayList<>();
        for (String name : List.of("lifted-plane-4-high", "lifted-raised-4-high")) {
            for (double placed : work.placedMm()) {
                double[] f = figures.all(name + " " + Words.number(placed));
                rows.add(List.of(name.contains("raised") ? "one raised" : "in the plane", Words.number(placed) + " mm",
                        Words.std(f[0]), Words.fixed(f[2], 3), Words.std(f[1])
                                + (f[3] == 0 ? " (not converged)" : "")));
            }
        }
        page.table(List.of("references", "placed to", "position", "rotation about x, y, rad", "gripping point"), rows);
        page.paragraph("`grip_mm` in the cell file, then `cellgauge check`.");
    }

    private void intrinsics(Page page, Figures figures) {
        page.paragraph("**All intrinsics, not only the focal length.** Six references; worst axis of the objects "
                + "(root mean "
                + "square over them, mm), and deviations of fx and cx, px:");
        List<List<String>> rows = new ArrayList<>();
        for (String name : List.of("focal-plane-6", "focal-raised-6")) {
            for (double placed : work.placedMm()) {
                List<String> row = new ArrayList<>(List.of(name.contains("raised") ? "one raised" : "in the plane",
                        Words.number(placed) + " mm"));
                for (String explored : List.of("none", "focal", "intrinsics")) {
                    double[] f = figures.all(name + " " + Words.number(placed) + " " + explored);
                    row.add(f[3] == 0 ? "not converged" : Words.std(f[0])
                            + (explored.equals("none") ? "" : ", fx " + Words.std(f[1]))
                            + (explored.equals("intrinsics") ? ", cx " + Words.std(f[2]) : ""));
                }
                rows.add(row);
            }
        }
        page.table(List.of("references", "placed to", "known", "focal lengths explored", "all explored"), rows);
        page.paragraph("`cellgauge check --estimate intrinsics`. What replaces a calibration is a calibration: "
                + "`cellgauge calibrate`.");
    }

    private void starts(Page page, Figures figures) {
        page.paragraph("**A random focal length to start with.** The true one is 581 px; chains of the thesis, no "
                + "prior, "
                + "20 mm, against the default with N(start, 200 px):");
        List<List<String>> rows = new ArrayList<>();
        for (String name : work.started()) {
            for (double start : work.startsPx()) {
                String key = name + " " + Words.number(start);
                double[] mean = figures.all(key + " mean");
                double[] std = figures.all(key + " std");
                double[] right = figures.all(key + " right");
                long held = IntStream.range(0, mean.length)
                        .filter(i -> Math.abs(mean[i] - 581) < 2 * std[i]).count();
                rows.add(List.of(name.contains("raised") ? "6, one raised" : "3, in the plane",
                        Words.number(start) + " px", Words.fixed(Words.min(mean), 0) + " to "
                                + Words.fixed(Words.max(mean), 0), Words.fixed(Words.median(std), 0),
                        held + " of " + mean.length, Words.fixed(right[0], 0) + " ± " + Words.fixed(right[1], 0)
                                + (right[2] == 0 ? " (not converged)" : "")));
            }
        }
        page.table(List.of("references", "start", "means of the chains, px", "stated deviation, median",
                "chains within two deviations of the truth", "default"), rows);
        page.paragraph("`cellgauge check --estimate focal --focal-prior-std 200` with the start in the camera file.");
    }

    private void more(Page page, Results results) {
        page.paragraph("**More references, to twelve.** Worst axis, mm (root mean square over the objects), with the "
                + "focal length known / explored, by default:");
        List<String> head = new ArrayList<>(List.of("references", "placed to"));
        for (int count : work.counts()) {
            head.add(Integer.toString(count));
        }
        List<List<String>> rows = new ArrayList<>();
        for (boolean raised : new boolean[] {false, true}) {
            for (double placed : work.placedMm()) {
                Figures figures = results.of(FurtherWork.moreName(raised, placed));
                List<String> row = new ArrayList<>(List.of(raised ? "one raised" : "in the plane",
                        Words.number(placed) + " mm"));
                for (int i = 0; i < work.counts().size(); i++) {
                    row.add(Words.std(figures.all("none")[i]) + " / " + Words.std(figures.all("focal")[i]));
                }
                rows.add(row);
            }
        }
        page.table(head, rows);
        List<String> thesis = new ArrayList<>();
        for (int count : work.more()) {
            Figures figures = results.of("further-thesis-" + count);
            thesis.add(count + " references: R-hat " + Words.fixed(Words.median(figures.all("rhat.objects")), 2)
                    + ", fx " + Words.fixed(Words.min(figures.column("focal.mean", 2, 0)), 0) + " to "
                    + Words.fixed(Words.max(figures.column("focal.mean", 2, 0)), 0) + " px where each chain states "
                    + Words.fixed(Words.median(figures.column("focal.std", 2, 0)), 0));
        }
        page.paragraph("Chains of the thesis with as many in the plane, 20 mm, do not mix any better: "
                + String.join("; ", thesis) + ".");
        page.paragraph("`cellgauge check --cell CELL --estimate focal PHOTO`, with as many references as there are.");
    }

    private static void misplaced(Page page, Figures figures) {
        page.paragraph("**RANSAC against the average with one misplaced reference.** Six references, one raised, said "
                + "to be "
                + "placed to 5 mm; one stands 50 mm off. Errors of the objects against what is stated, root mean "
                + "squares, "
                + "mm:");
        List<List<String>> rows = new ArrayList<>();
        for (String start : List.of("average", "ransac")) {
            double[] error = figures.column(start, 2, 0);
            double[] stated = figures.column(start, 2, 1);
            rows.add(List.of("thesis, start by " + start, Words.std(Words.median(error)) + " ("
                    + Words.std(Words.min(error)) + " to " + Words.std(Words.max(error)) + ")",
                    Words.std(Words.median(stated)), "nothing"));
        }
        rows.add(List.of("default", Words.std(figures.all("right")[0]), Words.std(figures.all("right")[1]),
                named(figures)));
        page.table(List.of("", "error", "stated", "what is said of the references"), rows);
        page.paragraph("RANSAC changes where the chain starts and nothing of what it samples, so Table 9.7 could show "
                + "no "
                + "misplacement whatever stood wrong. `cellgauge check` tests every reference "
                + "([misplaced references](misplaced.md)).");
    }

    /** Which references the default calls misplaced. */
    private static String named(Figures figures) {
        if (!figures.has("named")) {
            return "none is named";
        }
        List<String> ids = new ArrayList<>();
        for (double id : figures.all("named")) {
            ids.add(Words.number(id));
        }
        return Words.and(ids) + (ids.size() == 1 ? " is" : " are") + " misplaced";
    }
}
