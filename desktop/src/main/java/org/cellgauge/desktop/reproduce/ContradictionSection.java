package org.cellgauge.desktop.reproduce;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Objects;

/** Printed figures that contradict each other, or that the described algorithm cannot give. */
final class ContradictionSection implements Section {
    private static final List<String> OBJECTS = List.of("5", "20", "30");
    private static final int AXES = 3;
    private static final String LOW = "plane-3-low";
    /** The other reading of the box, and what its work is called. */
    private static final String WHOLE_BOX = "box with half extents of one deviation (kappa 1)";
    private static final String WHOLE = "kappa-1-";

    private final Map<String, PrintedTable> tables;
    private final List<Work> works = new ArrayList<>();

    ContradictionSection(Assumptions assumptions, Map<String, SetUp> setUps, Map<String, PrintedTable> tables,
            Effort effort) {
        this.tables = tables;
        List.of(LOW, "camera-3", "camera-3-low").forEach(name ->
                works.add(SetUpWork.of(Objects.requireNonNull(setUps.get(name)), assumptions, effort)));
        Assumptions whole = Objects.requireNonNull(assumptions.changes().get(WHOLE_BOX));
        List.of("camera-3", "camera-3-low").forEach(name -> works.add(SetUpWork.of(WHOLE + name,
                Objects.requireNonNull(setUps.get(name)), whole, effort)));
    }

    @Override
    public String id() {
        return "contradictions";
    }

    @Override
    public String title() {
        return "What cannot be as printed";
    }

    @Override
    public List<Work> needs() {
        return works;
    }

    @Override
    public void write(Page page, Results results) {
        page.heading(3, title());
        page.paragraph("Printed figures that contradict each other, or cannot come from the algorithm as described. "
                + "What is "
                + "calculated here is calculated from the printed figures, unless it says otherwise.");
        List<String> points = new ArrayList<>();
        points.add(sameForAll(results.of(LOW)));
        points.add(sameOfTwo());
        points.add(zeros(results.of(LOW)));
        points.add(repeatedRun());
        points.add(offTheWall());
        points.add(geometricMeans("9.6", "9.5", "focal-plane-2", "Root mean squares"));
        points.add(percentages());
        points.add(constantPart());
        points.add(lostSample());
        points.add(oneStep());
        points.add(ownGoal());
        points.add(accurate());
        points.add(cube(results));
        points.add(adviceAgainstTables());
        points.add("**Captions and texts.** The caption of Table 9.8 compares an exploration \"with 5 mm\" with a "
                + "constant "
                + "focal length \"with 20 mm\"; the text and the figures (those of Table 9.6) say 20 mm for both. "
                + "Table 9.3 is "
                + "captioned \"camera parameters\" and shows objects. Table 9.7 ends in a stray \"0.20\". Section "
                + "8.3.2 moves "
                + "fiducials 5 and 20 off the plane, section 8.4.3.2 fiducials 5 and 30, as Table 8.11 does; Tables "
                + "8.12 to "
                + "8.14 have 5 and 20. Section 9.3 lifts fiducial 5, Table 9.2 fiducial 20.");
        points.add("**Ten thousand or five.** Sections 8.3.1 and 8.4.2 speak of 10000 samples behind each deviation; "
                + "by "
                + "section 5.4 the statistics take the last 5000.");
        page.list(points);
    }

    private double[] std(String table, String setUp, String whose) {
        return Arrays.copyOf(row(table, setUp, whose).values(), AXES);
    }

    private PrintedTable.Row row(String table, String setUp, String whose) {
        return Objects.requireNonNull(tables.get(table), table).row(setUp, whose, "std");
    }

    private String printed(String table, String setUp, String whose) {
        return "(" + String.join(", ", row(table, setUp, whose).figures().subList(0, AXES)) + ")";
    }

    private String sameForAll(Figures low) {
        List<String> same = new ArrayList<>();
        for (String where : List.of("8.6 plane-3-low", "8.6 raised-3-low", "8.7 plane-2-low", "8.7 plane-4-low",
                "8.12 lifted-plane-3-low")) {
            String[] parts = where.split(" ");
            boolean all = OBJECTS.stream().map(id -> printed(parts[0], parts[1], id)).distinct().count() == 1;
            if (all) {
                same.add(printed(parts[0], parts[1], "5") + " in Table " + parts[0]);
            }
        }
        double[] turned = low.all("turned");
        long still = Arrays.stream(turned).filter(t -> t == 0).count();
        double lowest = OBJECTS.stream()
                .mapToDouble(id -> Words.min(low.column("object." + id + ".std", 2 * AXES, 2))).min().orElseThrow();
        return "**The same deviations for all objects.** At 5 mm every object has the same: "
                + Words.and(same.stream().distinct().toList())
                + ". An object's deviation is the camera's position and its rotation times the lever arm; it is the "
                + "same for "
                + "all only where the camera never turned. Those are deviations of a chain whose rotation stood "
                + "still, not "
                + "of the posterior. Of our " + turned.length + " chains " + still
                + " never turned among the kept draws; and none has so small a deviation along z: the smallest is "
                + Words.std(lowest) + " mm, where " + row("8.6", LOW, "5").figures().get(2)
                + " are printed, less than a fifth of one narrow step of 1 mm.";
    }

    private String sameOfTwo() {
        return "**The same deviations for two layouts.** Table 8.6 has " + printed("8.6", LOW, "5")
                + " for three references in the plane and " + printed("8.6", "raised-3-low", "5")
                + " with one raised. Two posteriors, two chains and three equal digits each: one of the columns was "
                + "copied.";
    }

    private String zeros(Figures low) {
        double[] right = low.column("right.object.5.std", 2 * AXES, AXES);
        return "**Rotation deviations with eight zeros** (text under Table 8.12). That is the rounding of a constant: "
                + "no "
                + "rotation was accepted among the 5000 kept draws. By default " + Words.fixed(right[0], 3)
                + " rad are right there (5 mm, three references in the plane).";
    }

    /** Tables 8.5 and 8.6 have one experiment twice. */
    private String repeatedRun() {
        double most = 0;
        String where = "";
        for (String id : OBJECTS) {
            double[] first = Objects.requireNonNull(tables.get("8.5")).row("plane-3-high", id, "mean").values();
            double[] second = Objects.requireNonNull(tables.get("8.6")).row("plane-3-high", id, "mean").values();
            double off = Math.abs(first[2] - second[2]) / std("8.5", "plane-3-high", id)[2];
            if (off > most) {
                most = off;
                where = "z of object " + id + ": " + Words.fixed(first[2], 2) + " and " + Words.fixed(second[2], 2)
                        + " mm, " + Words.fixed(off, 1) + " of the stated deviations apart";
            }
        }
        return "**One experiment, two results.** \"Naturally, the same\" (section 8.4.3.1) are three references in "
                + "the plane "
                + "at 20 mm in Tables 8.5 and 8.6, and so are the deviations, nearly. The means are not: " + where
                + ". Two chains that had converged would agree to a few per cent of a deviation.";
    }

    /** Which mean a printed one is. */
    private String geometricMeans(String means, String of, String setUp, String called) {
        double[] x = new double[OBJECTS.size()];
        for (int i = 0; i < x.length; i++) {
            x[i] = std(of, setUp, OBJECTS.get(i))[0];
        }
        int geometric = 0;
        int squares = 0;
        int count = 0;
        for (String each : Objects.requireNonNull(tables.get(means)).setUps()) {
            for (int axis = 0; axis < AXES; axis++) {
                double[] all = new double[OBJECTS.size()];
                for (int i = 0; i < all.length; i++) {
                    all[i] = std(of, each, OBJECTS.get(i))[axis];
                }
                PrintedTable.Row row = row(means, each, "objects");
                double printed = row.values()[axis];
                // a last digit for what was rounded before the mean was taken
                double tolerance = 2 * row.halfDigit(axis);
                geometric += Math.abs(Words.geometricMean(all) - printed) <= tolerance ? 1 : 0;
                squares += Math.abs(Words.rms(all) - printed) <= tolerance ? 1 : 0;
                count++;
            }
        }
        return "**" + called + " that are none: Table " + means + ".** It is said to hold root mean squares of Table "
                + "" + of
                + ". For x with two references in the plane that would be " + Words.std(Words.rms(x))
                + "; printed is " + row(means, setUp, "objects").figures().get(0) + ", the geometric mean ("
                + Words.std(Words.geometricMean(x)) + "). Of its " + count + " deviations of positions " + geometric
                + " are geometric means of Table " + of + " to the last digit, " + squares
                + " root mean squares. A geometric mean hides the worst object.";
    }

    private String percentages() {
        List<String> parts = new ArrayList<>();
        for (String[] pair : new String[][] {{"plane-2-high", "plane-4-high"}, {"raised-2-high", "raised-4-high"}}) {
            double[] two = ofAll("8.8 8.9", pair[0]);
            double[] four = ofAll("8.8 8.9", pair[1]);
            double printedTwo = std("8.10", pair[0], "objects")[2];
            double printedFour = std("8.10", pair[1], "objects")[2];
            parts.add((pair[0].startsWith("raised") ? "With one raised" : "With all in the plane") + ", z: printed "
                    + Words.percent(1 - printedFour / printedTwo) + ", by geometric means of the tables "
                    + Words.percent(1 - Words.geometricMean(four) / Words.geometricMean(two))
                    + ", by root mean squares " + Words.percent(1 - Words.rms(four) / Words.rms(two)));
        }
        return "**Percentages of Table 8.10.** They follow from its own columns; the columns are geometric means of "
                + "Tables "
                + "8.7 to 8.9, called means. " + String.join("; ", parts)
                + ". The sign of the last depends on which mean is taken: the \"-21%\" that the text "
                + "passes over is one object's deviation of 0.63 mm.";
    }

    private double[] ofAll(String either, String setUp) {
        for (String table : either.split(" ")) {
            if (Objects.requireNonNull(tables.get(table)).setUps().contains(setUp)) {
                return OBJECTS.stream().mapToDouble(id -> std(table, setUp, id)[2]).toArray();
            }
        }
        throw new IllegalStateException(setUp + " is in none of " + either);
    }

    private String constantPart() {
        double[] from813 = OBJECTS.stream().mapToDouble(id -> std("8.13", "lifted-plane-2-high", id)[0]).toArray();
        double[] from88 = OBJECTS.stream().mapToDouble(id -> std("8.8", "plane-2-high", id)[0]).toArray();
        return "**Where the constant half of Table 9.8 comes from.** The text says root mean squares of Tables 8.8 "
                + "and 8.9; "
                + "for x with two references that is " + Words.std(Words.rms(from88)) + ". Printed is "
                + row("9.8", "lifted-plane-2-high", "objects").figures().get(0)
                + ", the geometric mean (" + Words.std(Words.geometricMean(from813)) + ") of Table 8.13. So it "
                + "compares other "
                + "objects, in other places, with those of Table 9.5.";
    }

    private String lostSample() {
        double[] total = Objects.requireNonNull(tables.get("7.2")).row("camera-3", "all", "accepted").values();
        return "**9999 of 10000.** Accepted and rejected of Tables 7.2 and 7.3 add up to "
                + Words.number(total[0] + total[1]) + ": the start counts as a sample.";
    }

    private String oneStep() {
        PrintedTable.Row mean = Objects.requireNonNull(tables.get("9.1")).row("camera-3-low-focal", "focal", "mean");
        PrintedTable.Row plane3 = Objects.requireNonNull(tables.get("9.4")).row("focal-raised-2", "focal", "mean");
        return "**One focal length or two.** In Table 9.1 fx and fy have the same mean (" + String.join(", "
                + "", mean.figures())
                + " px) and deviation to the last digit, as if one step moved both; in Table 9.4 they are "
                + String.join(" and ", plane3.figures()) + " px for two references, one raised, as if each moved on "
                + "its own. "
                + "Ours move on their own.";
    }

    private String ownGoal() {
        PrintedTable table = Objects.requireNonNull(tables.get("9.1"));
        double with = table.row("camera-3-low-focal", "all", "accepted").values()[0];
        double without = table.row("camera-3-low", "all", "accepted").values()[0];
        return "**The acceptance it asks for.** Section 7.2.2 asks for at least 25 % accepted and keeps the steps "
                + "because "
                + "20 mm gives that; at 5 mm Table 9.1 has " + Words.percent(with / 10_000) + " and "
                + Words.percent(without / 10_000) + ", called enough. Most of what is accepted are 1 mm steps; of the "
                + "broad "
                + "turns one in 2500 is.";
    }

    private String accurate() {
        PrintedTable.Row std = row("8.4", "reference-as-object", "944");
        double[] mean = Objects.requireNonNull(tables.get("8.4")).row("reference-as-object", "944", "mean").values();
        double[] off = {mean[3], 2 * Math.PI - mean[4]};
        return "**\"Accurate and precise\"** (section 8.4.2) is a pose whose rotations miss the truth by "
                + Words.fixed(off[0] / std.values()[3], 0) + " and " + Words.fixed(off[1] / std.values()[4], 0)
                + " of their stated deviations; loose tape is blamed. Deviations that small were never those of the "
                + "pose.";
    }

    private static double accepted(Results results, String work) {
        return Words.median(results.of(work).column("accepted.all", 2, 0));
    }

    private String cube(Results results) {
        double high = Objects.requireNonNull(tables.get("7.2")).row("camera-3", "all", "accepted").values()[0];
        double low = Objects.requireNonNull(tables.get("9.1")).row("camera-3-low", "all", "accepted").values()[0];
        return "**The size of the cube.** \"A cube with this uncertainty as volume\" and its \"maximum elongation\" "
                + "(section "
                + "5.3) can be a box with sides of one deviation (kappa 0.5) or half extents of one (kappa 1). Table "
                + "7.2 has "
                + Words.number(high) + " accepted: kappa 0.5 gives " + Words.fixed(accepted(results, "camera-3"), 0)
                + ", kappa 1 " + Words.fixed(accepted(results, WHOLE + "camera-3"), 0) + " (medians). Table 9.1 has "
                + Words.number(low) + ": kappa 0.5 gives " + Words.fixed(accepted(results, "camera-3-low"), 0)
                + ", kappa 1 " + Words.fixed(accepted(results, WHOLE + "camera-3-low"), 0)
                + ". No single reading gives both.";
    }

    /** Objects that are taped to the wall, by their printed z. */
    private String offTheWall() {
        double most = 0;
        String where = "";
        for (String number : List.of("8.5", "8.6", "8.7", "8.8", "8.9")) {
            PrintedTable table = Objects.requireNonNull(tables.get(number));
            for (String setUp : table.setUps()) {
                for (String id : OBJECTS) {
                    PrintedTable.Row mean = table.row(setUp, id, "mean");
                    double off = Math.abs(mean.values()[2]) / std(number, setUp, id)[2];
                    if (off > most) {
                        most = off;
                        where = "z of object " + id + " is " + mean.figures().get(2) + " mm in Table " + number
                                + " with a stated deviation of " + row(number, setUp, id).figures().get(2) + " mm";
                    }
                }
            }
        }
        return "**Objects before and behind the wall they are taped to.** Their z is 0 in Tables 8.5 to 8.9. Printed "
                + "means lie "
                + "between 12 mm before it and 36 mm behind; " + where + ", " + Words.fixed(most, 0)
                + " of them off. No text remarks on it.";
    }

    private String adviceAgainstTables() {
        double raised = OBJECTS.stream().flatMapToDouble(id -> Arrays.stream(std("8.9", "raised-4-high", id))).max()
                .orElseThrow();
        double plane = OBJECTS.stream().flatMapToDouble(id -> Arrays.stream(std("8.8", "plane-4-high", id))).max()
                .orElseThrow();
        return "**Table 8.16 against its own tables.** \"Between 1 and 2 mm\" for four references with one raised at "
                + "20 mm: "
                + "Table 8.9 has " + Words.fixed(raised, 2) + " mm. \"Between 2 and 5 mm\" for four in the plane: "
                + "Table 8.8 has "
                + Words.fixed(plane, 2) + " mm.";
    }
}
