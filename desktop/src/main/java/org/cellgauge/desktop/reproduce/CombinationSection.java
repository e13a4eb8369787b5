package org.cellgauge.desktop.reproduce;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Objects;

/** Figure 8.8: the seventeen combinations that the thesis ran, as a list. */
final class CombinationSection implements Section {
    private static final List<String> SAME_PLANE = List.of("plane-3-high", "raised-3-high", "plane-3-low",
            "raised-3-low", "plane-2-low", "plane-4-low", "plane-2-high", "plane-4-high", "raised-2-high",
            "raised-4-high");
    private static final List<String> OTHER_PLANES = List.of("first-plane-3-high", "first-raised-3-high",
            "lifted-plane-3-low", "lifted-plane-2-high", "lifted-plane-4-high", "lifted-raised-2-high",
            "lifted-raised-4-high");

    private final Map<String, SetUp> setUps;
    private final List<String> all = new ArrayList<>(SAME_PLANE);
    private final List<Work> works = new ArrayList<>();

    CombinationSection(Assumptions assumptions, Map<String, SetUp> setUps, Effort effort) {
        this.setUps = setUps;
        all.addAll(OTHER_PLANES);
        all.forEach(name -> works.add(SetUpWork.of(setUp(name), assumptions, effort)));
    }

    private SetUp setUp(String name) {
        return Objects.requireNonNull(setUps.get(name), name);
    }

    @Override
    public String id() {
        return "figure-8.8";
    }

    @Override
    public String title() {
        return "Figure 8.8: the seventeen combinations";
    }

    @Override
    public List<Work> needs() {
        return works;
    }

    @Override
    public void write(Page page, Results results) {
        page.heading(3, title());
        page.paragraph("As the tables have them; the figure itself is not in the copy. Worst axis of the objects "
                + "(root mean "
                + "square over them, mm): one chain of the thesis (median), its posterior converged, by default.");
        List<List<String>> rows = new ArrayList<>();
        for (String name : all) {
            Figures figures = results.of(name);
            double[] chain = {median(figures, 0), median(figures, 1), median(figures, 2)};
            rows.add(List.of(Integer.toString(rows.size() + 1),
                    SAME_PLANE.contains(name) ? "in the plane" : "in different planes", setUp(name).words(),
                    Words.std(Words.max(chain)), Words.std(worst("same.", figures)),
                    Words.std(worst("right.", figures))));
        }
        page.table(List.of("", "objects", "experiment", "repeated", "converged", "right"), rows);
    }

    private static double median(Figures figures, int axis) {
        return Words.rms(List.of(5, 20, 30).stream()
                .mapToDouble(id -> Words.median(figures.column("object." + id + ".std", 6, axis))).toArray());
    }

    /** Root mean square over the objects, the worst axis. */
    static double worst(String prefix, Figures figures) {
        double worst = 0;
        for (int axis = 0; axis < 3; axis++) {
            worst = Math.max(worst, ExpectationSection.one(prefix, figures, axis));
        }
        return worst;
    }
}
