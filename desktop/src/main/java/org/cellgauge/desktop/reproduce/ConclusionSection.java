package org.cellgauge.desktop.reproduce;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import org.cellgauge.settings.LikelihoodModel;

/** The thesis' conclusions, one by one. */
final class ConclusionSection implements Section {
    private static final int LATERAL = 0;
    private static final int DEPTH = 2;
    /** Within so much of each other two deviations are called alike. */
    private static final double ALIKE = 0.2;
    private static final List<String> SET_UPS = List.of("camera-3", "camera-3-low-focal", "plane-3-high", "plane-3-low",
            "raised-3-high", "raised-3-low", "plane-2-high", "plane-4-high", "plane-4-low", "raised-4-high",
            "lifted-plane-3-high", "nine-3-high", "nine-3-high-focal", "focal-plane-4", "focal-plane-6",
            "reference-as-object");

    private final DecisionWork decisions;
    private final FurtherWork further;
    private final List<Work> works = new ArrayList<>();

    ConclusionSection(Assumptions assumptions, Map<String, SetUp> setUps, Effort effort) {
        decisions = new DecisionWork(assumptions, effort);
        Map<String, Work> all = new LinkedHashMap<>();
        SET_UPS.forEach(name -> all.put(name,
                SetUpWork.of(Objects.requireNonNull(setUps.get(name), name), assumptions, effort)));
        decisions.all().forEach(work -> all.put(work.name(), work));
        further = new FurtherWork(assumptions, setUps, effort);
        further.all().forEach(work -> all.put(work.name(), work));
        works.addAll(all.values());
    }

    @Override
    public String id() {
        return "conclusions";
    }

    @Override
    public String title() {
        return "The conclusions, one by one";
    }

    @Override
    public List<Work> needs() {
        return works;
    }

    @Override
    public void write(Page page, Results results) {
        Answers answers = new Answers();
        chapterSeven(results, answers);
        chapterEight(results, answers);
        chapterNine(results, answers);
        page.heading(3, title());
        page.paragraph("Deviations are the default's (\"right\" below) unless said otherwise, worst axis, root mean "
                + "square "
                + "over the objects.");
        page.table(List.of("section", "the thesis", "holds?", "the figure that decides"), answers.rows);
    }

    /** The rows of the table, as they are found. */
    private static final class Answers {
        private final List<List<String>> rows = new ArrayList<>();

        void add(String section, String sentence, boolean holds, String figure) {
            add(section, sentence, holds ? "holds" : "does not hold", figure);
        }

        void add(String section, String sentence, String holds, String figure) {
            rows.add(List.of(section, sentence, "**" + holds + "**", figure));
        }
    }

    private static double right(Results results, String setUp, int axis) {
        return ExpectationSection.one("right.", results.of(setUp), axis);
    }

    private static double same(Results results, String setUp, int axis) {
        return ExpectationSection.one("same.", results.of(setUp), axis);
    }

    private static double worst(Results results, String setUp) {
        return CombinationSection.worst("right.", results.of(setUp));
    }

    private static String ratio(double factor) {
        return Words.fixed(factor, 2);
    }

    private static void chapterSeven(Results results, Answers answers) {
        double rHat = Words.median(results.of("camera-3").all("rhat.camera"));
        double accepted = Words.median(results.of("camera-3").column("accepted.all", 2, 0)) / 10_000;
        answers.add("7.2.2", "More than 25 % accepted is enough for conclusions to be significant.", rHat < 1.01,
                Words.percent(accepted) + " are accepted, and R-hat of four chains is " + Words.fixed(rHat, 2)
                        + " with " + Words.std(Words.median(results.of("camera-3").all("ess.camera")))
                        + " effective draws of 5000.");
    }

    private void chapterEight(Results results, Answers answers) {
        double lifted = right(results, "lifted-plane-3-high", DEPTH) / right(results, "plane-3-high", DEPTH);
        answers.add("8.5", "The plane of the objects has no impact.", Math.abs(lifted - 1) < ALIKE,
                "z lifted over z in the plane: " + ratio(lifted) + ".");
        double raised = right(results, "raised-3-high", DEPTH) / right(results, "plane-3-high", DEPTH);
        double raisedSame = same(results, "raised-3-high", DEPTH) / same(results, "plane-3-high", DEPTH);
        answers.add("8.5", "A raised reference improves z of all objects, a lot.", raised < 1 - ALIKE,
                "z raised over z in the plane, three references at 20 mm: " + ratio(raised) + "; in the thesis' own "
                        + "posterior, "
                        + "converged, " + ratio(raisedSame) + ".");
        double raisedLow = right(results, "raised-3-low", DEPTH) / right(results, "plane-3-low", DEPTH);
        double raisedLowSame = same(results, "raised-3-low", DEPTH) / same(results, "plane-3-low", DEPTH);
        answers.add("8.4.3.1", "With a low measurement deviation the plane of the references does not matter.",
                Math.abs(raisedLow - 1) < ALIKE && Math.abs(raisedLowSame - 1) < ALIKE,
                "At 5 mm: " + ratio(raisedLow) + "; in the thesis' own posterior " + ratio(raisedLowSame)
                        + ". The finer references are placed, the more it matters: at 1 mm "
                        + ratio(forecast(results, "one-raised", 3, 1)[DEPTH] / forecast(results, "plane", 3, 1)[DEPTH])
                        + ".");
        double placed = right(results, "plane-3-high", LATERAL) / right(results, "plane-3-low", LATERAL);
        answers.add("8.5", "The measurement deviation always matters, with high impact.", placed > 1 + ALIKE,
                "x at 20 mm over x at 5 mm: " + ratio(placed) + ".");
        double number = right(results, "plane-4-high", LATERAL) / right(results, "plane-2-high", LATERAL);
        answers.add("8.5", "More references always help, slightly.",
                number < 1 - ALIKE ? "holds, and not slightly" : number < 1 ? "holds" : "does not hold",
                "x with four over x with two: " + ratio(number) + ", the root of a half is 0.71.");
        double low = worst(results, "plane-4-low");
        answers.add("8.5, 8.16", "Four references placed to 5 mm ensure less than 0.2 mm, two or three less than 1 "
                + "mm.", low < 1,
                "Four: " + Words.std(low) + " mm before the object's own noise.");
        answers.add("Conclusions", "Below 1 mm is reached if, and only if, references are placed to 5 mm or better.",
                "half of it holds", "Coarser than 5 mm never does; 5 mm does not either (" + Words.std(low)
                        + " mm). It takes " + coarsestForOne(results) + ".");
        double high = worst(results, "raised-4-high");
        answers.add("8.5, 8.16", "Four references at 20 mm with one raised reach 1 to 2 mm.", high < 2,
                Words.std(high) + " mm; converged by the thesis' own likelihood "
                        + Words.std(CombinationSection.worst("same.", results.of("raised-4-high"))) + " mm.");
        double turn = results.of("plane-3-low").all("right.object.5.std")[3];
        answers.add("8.4", "Orientation deviations are extremely low, close to zero.", turn < 1e-3,
                "At 5 mm " + Words.fixed(turn, 3) + " rad, of which 100 mm of tool make " + Words.std(100 * turn)
                        + " mm; in the thesis' own posterior "
                        + Words.fixed(results.of("plane-3-low").all("same.object.5.std")[3], 3) + " rad.");
        Figures reference = results.of("reference-as-object");
        answers.add("8.4.2", "The reference treated as an object is found accurately and precisely.", "cannot be told",
                "With two references the right deviations are " + triple(reference.all("right.object.944.std"))
                        + " mm, so an error of (3.8, 1, 1.2) mm is luck; stated were (2.02, 2.05, 4.93).");
    }

    private double[] forecast(Results results, String arrangement, int references, double stdMm) {
        return new DecisionTable(decisions, results).stdMm(LikelihoodModel.RIGID_MARKER, new Layout(arrangement,
                references, stdMm, decisions.sizesMm()[0], decisions.noisesPx()[1]));
    }

    /** What reaches 1 mm with four references, camera part. */
    private String coarsestForOne(Results results) {
        double coarsest = Double.NaN;
        for (double std : decisions.stdsMm()) {
            if (DecisionTable.worst(forecast(results, "plane", 4, std)) <= 1) {
                coarsest = std;
            }
        }
        Layout layout = new Layout("plane", 4, 1, decisions.sizesMm()[0], decisions.noisesPx()[1]);
        return (Double.isNaN(coarsest) ? "finer than the table's" : Words.number(coarsest) + " mm")
                + " with four in the plane and corners of " + decisions.noisesPx()[1]
                + " px, and still the object's own corners leave "
                + Words.std(DecisionTable.worst(new DecisionTable(decisions, results).ownMm(layout)))
                + " mm: larger markers or a nearer camera";
    }

    private static String triple(double[] std) {
        return "(" + Words.std(std[0]) + ", " + Words.std(std[1]) + ", " + Words.std(std[2]) + ")";
    }

    private void chapterNine(Results results, Answers answers) {
        Figures focal = results.of("camera-3-low-focal");
        double[] means = focal.column("focal.mean", 2, 0);
        double rightStd = focal.all("right.focal.std")[0];
        answers.add("9.5", "The focal length can be estimated; mean and deviation are plausible.", rightStd < 30,
                "569 ± 9 px is printed. Our chains end between " + Words.fixed(Words.min(means), 0) + " and "
                        + Words.fixed(Words.max(means), 0) + " px and state "
                        + Words.fixed(Words.median(focal.column("focal.std", 2, 0)), 0) + "; right is ± "
                        + Words.fixed(rightStd, 0) + " px under a prior of ± 200 px. References in one plane under a "
                        + "flat "
                        + "prior leave it open altogether (an improper posterior).");
        double z = right(results, "nine-3-high-focal", DEPTH) / right(results, "nine-3-high", DEPTH);
        double x = right(results, "nine-3-high-focal", LATERAL) / right(results, "nine-3-high", LATERAL);
        answers.add("9.5", "Exploring the focal length raises z and leaves x and y in the same range.",
                z > 1 + ALIKE && x < 1 + ALIKE, "explored over known: z " + ratio(z) + ", x " + ratio(x) + ".");
        double six = worst(results, "focal-plane-6");
        double known = worst(results, "plane-4-high");
        Figures many = results.of(FurtherWork.moreName(false, 20));
        double twelve = last(many.all("focal"));
        double four = many.all("none")[further.counts().indexOf(4)];
        answers.add("9.5",
                "With five or six references in the plane, exploring reaches what three or four reach without.",
                twelve < four * (1 + ALIKE) ? "holds" : six < known * (1 + ALIKE) ? "only with very fine corners"
                        : "does not hold", "Corners as fine as in the rendered photo: " + Words.std(six)
                        + " mm with six against " + Words.std(known) + " mm with four; at 0.1 px even twelve leave "
                        + Words.std(twelve) + " mm against " + Words.std(four) + " mm.");
        double more = worst(results, "focal-plane-6") / worst(results, "focal-plane-4");
        double known12 = last(many.all("none")) / four;
        answers.add("9.4.3", "From four references on, adding more does not significantly help.", more > 1 - ALIKE / 2
                && known12 > 1 - ALIKE / 2, "explored, six over four: " + ratio(more) + "; known, twelve over four: "
                + ratio(known12) + ".");
        double[] raisedFocal = results.of(FurtherWork.moreName(true, 1)).all("focal");
        double[] raisedKnown = results.of(FurtherWork.moreName(true, 1)).all("none");
        answers.add("9.5", "With one reference raised, z explored is always higher than z known, however many.",
                last(raisedFocal) > last(raisedKnown) * (1 + ALIKE), "Placed to 1 mm, twelve references: "
                        + Words.std(last(raisedFocal)) + " against " + Words.std(last(raisedKnown))
                        + " mm; at 20 mm " + Words.std(last(results.of(FurtherWork.moreName(true, 20)).all("focal")))
                        + " against " + Words.std(last(results.of(FurtherWork.moreName(true, 20)).all("none")))
                        + ". It is the fine placement that makes a raised reference tell the focal length.");
        Figures misplaced = results.of("further-misplaced");
        double average = Words.median(misplaced.column("average", 2, 0));
        double ransac = Words.median(misplaced.column("ransac", 2, 0));
        answers.add("9.4.3", "RANSAC gives the same as the average, so no reference is misplaced.", false,
                "With one reference 50 mm off, objects err by " + Words.std(average) + " mm from either start ("
                        + Words.std(ransac) + " with RANSAC): the test cannot see what it tests.");
        double[] none = results.of("further-intrinsics").all("focal-raised-6 1 none");
        double[] all = results.of("further-intrinsics").all("focal-raised-6 1 intrinsics");
        double[] plane = results.of("further-intrinsics").all("focal-plane-6 1 intrinsics");
        answers.add("Conclusions", "Estimating all intrinsics is a step to the complete removal of the calibration.",
                all[0] < none[0] * (1 + ALIKE) ? "does not hold in the plane" : "does not hold",
                "Six references placed to 1 mm: known " + Words.std(none[0]) + " mm, all explored " + Words.std(all[0])
                        + " mm with one raised, " + Words.std(plane[0]) + " mm in the plane.");
    }

    private static double last(double[] values) {
        return values[values.length - 1];
    }
}
