package org.cellgauge.desktop.reproduce;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;

/** R-hat and effective sample sizes of the thesis' settings, experiment by experiment. */
final class DiagnosticsSection implements Section {
    private static final double CONVERGED = 1.01;
    private static final double ENOUGH_DRAWS = 100;

    private final Map<String, SetUp> setUps;
    private final List<Work> works = new ArrayList<>();

    DiagnosticsSection(Assumptions assumptions, Map<String, SetUp> setUps, Effort effort) {
        this.setUps = setUps;
        setUps.values().forEach(setUp -> works.add(SetUpWork.of(setUp, assumptions, effort)));
    }

    @Override
    public String id() {
        return "convergence";
    }

    @Override
    public String title() {
        return "Convergence of the thesis' chains";
    }

    @Override
    public List<Work> needs() {
        return works;
    }

    @Override
    public void write(Page page, Results results) {
        page.heading(3, title());
        page.paragraph("R-hat (rank-normalised, split; Vehtari et al. 2021) of four chains of each experiment, the "
                + "largest of "
                + "any position; effective draws of the 5000 that each chain keeps, the smallest; median over groups "
                + "of four. "
                + "Below 1.01, and 100 of each of four chains, is what counts as converged.");
        List<List<String>> rows = new ArrayList<>();
        int groups = 0;
        int poor = 0;
        double[] rHats = new double[setUps.size()];
        double[] draws = new double[setUps.size()];
        double[] objectRHats = new double[setUps.size()];
        double[] objectDraws = new double[setUps.size()];
        int at = 0;
        for (SetUp setUp : setUps.values()) {
            Figures figures = results.of(setUp.name());
            boolean objects = figures.has("rhat.objects");
            for (double rHat : figures.all(objects ? "rhat.objects" : "rhat.camera")) {
                groups++;
                poor += rHat > 1.1 ? 1 : 0;
            }
            rHats[at] = Words.median(figures.all("rhat.camera"));
            draws[at] = Words.median(figures.all("ess.camera"));
            objectRHats[at] = objects ? Words.median(figures.all("rhat.objects")) : Double.NaN;
            objectDraws[at] = objects ? Words.median(figures.all("ess.objects")) : Double.NaN;
            double[] turned = figures.all("turned");
            rows.add(List.of(Integer.toString(at + 1), setUp.name(), setUp.words(), Words.fixed(rHats[at], 2),
                    Words.std(draws[at]), objects ? Words.fixed(objectRHats[at], 2) : "",
                    objects ? Words.std(objectDraws[at]) : "",
                    Words.percent(Words.median(figures.column("accepted.all", 2, 0)) / 10_000),
                    Arrays.stream(turned).filter(t -> t == 0).count() + " of " + turned.length));
            at++;
        }
        page.paragraph("**R-hat is above 1.1 in " + poor + " of " + groups + " groups of four chains.**");
        page.picture("r-hat.svg", "R-hat by experiment",
                diagram("R-hat of four chains, by experiment", rHats, objectRHats, CONVERGED));
        page.picture("effective-draws.svg", "Effective draws by experiment",
                diagram("effective draws of 5000, by experiment", draws, objectDraws, ENOUGH_DRAWS));
        page.table(List.of("", "experiment", "", "R-hat, camera", "draws", "R-hat, objects", "draws", "accepted",
                "chains that never turned"), rows);
    }

    private static Svg diagram(String title, double[] camera, double[] objects, double limit) {
        double[] all = Arrays.stream(new double[][] {camera, objects, {limit}}).flatMapToDouble(Arrays::stream)
                .filter(Double::isFinite).toArray();
        Svg svg = new Svg(860, 260, title, Svg.Axis.linear("number of the experiment, below", 1, camera.length),
                Svg.Axis.logarithmic("", Words.min(all), Words.max(all)))
                .legend("camera", Svg.ORANGE).legend("objects", Svg.BLUE).legend("what counts as converged", Svg.GREEN)
                .level(limit, Svg.GREEN);
        for (int i = 0; i < camera.length; i++) {
            svg.point(i + 1.0, camera[i], Svg.ORANGE, 3.5, true).point(i + 1.0, objects[i], Svg.BLUE, 3.5, true);
        }
        return svg;
    }
}
