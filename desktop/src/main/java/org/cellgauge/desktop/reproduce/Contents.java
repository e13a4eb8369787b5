package org.cellgauge.desktop.reproduce;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;

/** What stands on the page, in its order. */
final class Contents {
    private final Effort effort;
    private final Map<String, List<Section>> chapters = new LinkedHashMap<>();

    Contents(Effort effort) {
        this.effort = effort;
        Assumptions usual = Assumptions.usual();
        Assumptions assumptions = effort.isQuick() ? usual.withExactCorners(usual.cleanPixelStdPx()) : usual;
        Map<String, SetUp> setUps = SetUp.all();
        Map<String, PrintedTable> tables = PrintedTable.all();
        chapters.put("What came of it", List.of(
                new ConclusionSection(assumptions, setUps, effort),
                new DecisionSection(assumptions, effort),
                new ContradictionSection(assumptions, setUps, tables, effort),
                new AssumptionSection(assumptions, setUps, effort),
                new DiagnosticsSection(assumptions, setUps, effort)));
        Map<String, List<Section>> byChapter = new LinkedHashMap<>();
        tables.values().forEach(table -> byChapter
                .computeIfAbsent(table.number().substring(0, 1), n -> new ArrayList<>())
                .add(new TableSection(table, setUps, assumptions, effort)));
        List<Section> seven = Objects.requireNonNull(byChapter.get("7"));
        List<Section> eight = Objects.requireNonNull(byChapter.get("8"));
        List<Section> nine = Objects.requireNonNull(byChapter.get("9"));
        seven.add(new TraceSection(List.of("figure-7.2"), "Figure 7.2 and Appendix B: the camera in three chains",
                "camera-3", 0, assumptions, setUps));
        eight.add(0, new ExpectationSection(assumptions, setUps, tables, effort));
        eight.add(new TraceSection(List.of("figure-8.3", "figure-8.4"),
                "Figures 8.3 and 8.4: an object in three chains", "scenario-3", 20, assumptions, setUps));
        eight.add(new CombinationSection(assumptions, setUps, effort));
        if (!effort.isQuick()) {
            eight.add(0, new SceneSection(assumptions, setUps));
        }
        nine.add(new EvolutionSection(assumptions, setUps, Objects.requireNonNull(tables.get("9.6")), effort));
        chapters.put("Chapter 7: prior experiments", seven);
        chapters.put("Chapter 8: improving the camera accuracy", eight);
        chapters.put("Chapter 9: intrinsic parameters", nine);
        chapters.put("Further research", List.of(new FurtherSection(assumptions, setUps, effort)));
    }

    List<Section> sections() {
        return chapters.values().stream().flatMap(List::stream).toList();
    }

    /** The whole page. */
    Page page(String pictureFolder, Section.Results results) {
        Page page = new Page(pictureFolder);
        page.heading(1, "The thesis, reproduced and corrected");
        page.paragraph("\"Improving the Vision System Accuracy for Collaborative Robots\" asked in 2020 how uncertain "
                + "a "
                + "marker-based vision system is, sampled camera poses by the Metropolis algorithm, and advised how "
                + "to place "
                + "references. This page runs its experiments (chapters 7 to 9) again. `./cellgauge reproduce --out "
                + "docs` "
                + "wrote it; `./cellgauge reproduce 8.8` prints one table, `--list` names all parts.");
        page.heading(2, "What this page cannot say");
        page.list(List.of(
                "The thesis' photos are not public, and its code is not in the copy that was read. Scenes are "
                        + "rendered after "
                        + "its text; where the text is silent something had to be assumed "
                        + "([assumptions](#assumptions-and-what-depends-on-them)).",
                "\"Right\" means the library's default on the rendered photo: converged, corners that move together, "
                        + "the "
                        + "object's own noise as that photo shows it (0.01 px: a clean rendering; a cheap camera has "
                        + "ten times "
                        + "as much, which the [decision table](#table-816-which-set-up-reaches-which-accuracy) has in "
                        + "columns of "
                        + "its own). It rests on placement errors being Gaussian and of the stated size.",
                "A verdict compares one printed chain with " + effort.seeds() + " of ours. That a printed figure lies "
                        + "among "
                        + "them says that the algorithm can give it, not that it is right."));
        page.heading(2, "How to read the tables");
        page.list(List.of(
                "*printed*: as in the thesis, digit by digit.",
                "*repeated*: the thesis' algorithm with its settings (steps in position or angles alone, 10 000 "
                        + "iterations, "
                        + "the last 5000 kept, corners on their own with the box at the proposed pose, kappa 0.5, "
                        + "objects exact), "
                        + effort.seeds() + " seeds: median, and lowest to highest.",
                "*converged*: the same posterior, sampled until R-hat is below 1.01 and the Monte Carlo error of every "
                        + "deviation below " + Words.percent(effort.precision()) + " (with the focal length explored "
                        + Words.percent(Math.max(SetUpWork.FOCAL_PRECISION, effort.precision())) + ").",
                "*right*: the default of the library, as precise.",
                "x, y, z in mm, then psi, theta, phi in rad. In the diagrams a row of the table has three marks side "
                        + "by side, "
                        + "for x, y and z; the bar goes from the lowest chain to the highest."));
        chapters.forEach((title, sections) -> {
            page.heading(2, title);
            sections.forEach(section -> section.write(page, results));
        });
        return page;
    }
}
