package org.cellgauge.desktop.reproduce;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Objects;

/** The experiments that the conclusions rest on, under other assumptions. */
final class SensitivityWork {
    static final List<String> SET_UPS = List.of("plane-3-high", "raised-3-high", "plane-4-low", "raised-4-high");
    /** Enough to see whether chains agree with each other. */
    private static final int SEEDS = 8;
    private static final double PRECISION = 0.05;

    private final Assumptions usual;
    private final Map<String, SetUp> setUps;
    private final Effort effort;

    SensitivityWork(Assumptions usual, Map<String, SetUp> setUps, Effort effort) {
        this.usual = usual;
        this.setUps = setUps;
        this.effort = new Effort(Math.min(SEEDS, effort.seeds()), Math.max(PRECISION, effort.precision()),
                effort.cells());
    }

    List<String> changes() {
        return List.copyOf(usual.changes().keySet());
    }

    static String name(String change, String setUp) {
        return "change-" + setUp + " " + change;
    }

    List<Work> all() {
        List<Work> all = new ArrayList<>();
        usual.changes().forEach((change, assumptions) -> SET_UPS.forEach(setUp ->
                all.add(SetUpWork.of(name(change, setUp), Objects.requireNonNull(setUps.get(setUp)), assumptions,
                        effort))));
        return all;
    }
}
