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
    private static final int FEW = 1;
    private static final double PRECISION = 0.05;

    private final Assumptions usual;
    private final Map<String, SetUp> setUps;
    private final Effort effort;
    /** What each experiment gets. */
    private final Effort each;

    SensitivityWork(Assumptions usual, Map<String, SetUp> setUps, Effort effort) {
        this.usual = usual;
        this.setUps = setUps;
        this.effort = effort;
        each = new Effort(Math.min(SEEDS, effort.seeds()), Math.max(PRECISION, effort.precision()),
                effort.cells());
    }

    /** What is changed. */
    List<String> changes() {
        List<String> all = List.copyOf(usual.changes().keySet());
        return effort.isQuick() && all.size() > FEW ? all.subList(0, FEW) : all;
    }

    static String name(String change, String setUp) {
        return "change-" + setUp + " " + change;
    }

    List<Work> all() {
        List<Work> all = new ArrayList<>();
        Map<String, Assumptions> changed = usual.changes();
        changes().forEach(change -> SET_UPS.forEach(setUp -> all.add(SetUpWork.of(name(change, setUp),
                Objects.requireNonNull(setUps.get(setUp)), Objects.requireNonNull(changed.get(change)), each))));
        return all;
    }
}
