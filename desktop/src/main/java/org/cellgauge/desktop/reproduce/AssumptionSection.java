package org.cellgauge.desktop.reproduce;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.function.UnaryOperator;

/** What the thesis does not say, what is taken for it, and what depends on that. */
final class AssumptionSection implements Section {
    private static final double GOAL_LOW_MM = 1;
    private static final double GOAL_HIGH_MM = 2;
    private static final double MIXED = 1.1;
    /** A deviation that is less than this share of another is called smaller. */
    private static final double SMALLER = 0.9;
    private static final String AS_ASSUMED = "as assumed";

    private final Assumptions assumptions;
    private final SensitivityWork sensitivity;
    private final List<Work> usual = new ArrayList<>();

    AssumptionSection(Assumptions assumptions, Map<String, SetUp> setUps, Effort effort) {
        this.assumptions = assumptions;
        sensitivity = new SensitivityWork(assumptions, setUps, effort);
        SensitivityWork.SET_UPS.forEach(name ->
                usual.add(SetUpWork.of(Objects.requireNonNull(setUps.get(name)), assumptions, effort)));
    }

    @Override
    public String id() {
        return "assumptions";
    }

    @Override
    public String title() {
        return "Assumptions, and what depends on them";
    }

    @Override
    public List<Work> needs() {
        List<Work> all = new ArrayList<>(usual);
        all.addAll(sensitivity.all());
        return all;
    }

    @Override
    public void write(Page page, Results results) {
        page.heading(3, title());
        page.paragraph("Where the thesis says nothing, this is taken "
                + "([assumptions.yaml](../desktop/src/main/resources/org/cellgauge/desktop/reproduce/assumptions.yaml) "
                + "has all of it, with the places of what it does say):");
        List<List<String>> silent = new ArrayList<>();
        assumptions.silences().forEach(s -> silent.add(List.of(s.about(), s.taken(), s.because())));
        page.table(List.of("open", "taken", "because"), silent);
        page.paragraph("The experiments that the conclusions rest on, run again with one assumption changed at a time. "
                + "Worst axis (mm, root mean square over the objects) by default; z with one of three raised over z "
                + "with all "
                + "in the plane, for the default and for the thesis' posterior; R-hat of four chains of the thesis, "
                + "and what "
                + "one of them states over the converged deviation of its posterior (medians):");
        List<List<String>> rows = new ArrayList<>();
        List<boolean[]> answers = new ArrayList<>();
        rows.add(row(AS_ASSUMED, name -> name, results, answers));
        sensitivity.changes().forEach(change ->
                rows.add(row(change, name -> SensitivityWork.name(change, name), results, answers)));
        page.table(List.of("changed", "4 in the plane, 5 mm", "4, one raised, 20 mm", "z raised / plane",
                "the same, thesis' posterior", "R-hat", "stated / converged"), rows);
        page.list(List.of(
                dependence("that 5 mm do not reach 1 mm", answers, rows, 0),
                dependence("that 20 mm with four references, one raised, do not reach 2 mm", answers, rows, 1),
                dependence("that a raised reference does not lower z by a tenth at 20 mm, by "
                        + "default", answers, rows, 2),
                dependence("that it does so in the thesis' own posterior", answers, rows, 3),
                dependence("that the thesis' chains do not mix (R-hat above 1.1)", answers, rows, 4),
                dependence("that they state too little", answers, rows, 5)));
    }

    private static List<String> row(String name, UnaryOperator<String> work, Results results, List<boolean[]> answers) {
        double low = CombinationSection.worst("right.", results.of(work.apply("plane-4-low")));
        double high = CombinationSection.worst("right.", results.of(work.apply("raised-4-high")));
        Figures plane = results.of(work.apply("plane-3-high"));
        Figures raised = results.of(work.apply("raised-3-high"));
        double right = ExpectationSection.one("right.", raised, 2) / ExpectationSection.one("right.", plane, 2);
        double same = ExpectationSection.one("same.", raised, 2) / ExpectationSection.one("same.", plane, 2);
        double rHat = Words.median(plane.all("rhat.objects"));
        double stated = stated(plane);
        answers.add(new boolean[] {low > GOAL_LOW_MM, high > GOAL_HIGH_MM, right > SMALLER, same < SMALLER,
            rHat > MIXED, stated < 1});
        return List.of(name, Words.std(low), Words.std(high), Words.fixed(right, 2), Words.fixed(same, 2),
                Words.fixed(rHat, 2), Words.fixed(stated, 2));
    }

    /** What a chain states of z over the converged deviation. */
    private static double stated(Figures figures) {
        return Words.median(List.of(5, 20, 30).stream().mapToDouble(id ->
                Words.median(figures.column("object." + id + ".std", 6, 2))
                        / figures.all("same.object." + id + ".std")[2]).toArray());
    }

    private static String dependence(String conclusion, List<boolean[]> answers, List<List<String>> rows, int which) {
        List<String> others = new ArrayList<>();
        for (int i = 1; i < answers.size(); i++) {
            if (answers.get(i)[which] != answers.get(0)[which]) {
                others.add(rows.get(i).get(0));
            }
        }
        return (answers.get(0)[which] ? "Holds: " : "Does not hold: ") + conclusion + "; "
                + (others.isEmpty() ? "no change above says otherwise." : "otherwise with: " + String.join("; "
                + "", others) + ".");
    }
}
