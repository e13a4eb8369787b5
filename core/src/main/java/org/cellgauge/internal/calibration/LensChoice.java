package org.cellgauge.internal.calibration;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.cellgauge.geometry.BrownLens;
import org.cellgauge.geometry.KannalaBrandtLens;
import org.cellgauge.geometry.Lens;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.geometry.RationalLens;

/** A lens and which of its parameters are unknown; immutable. */
final class LensChoice {
    private static final List<String> FOCAL_AND_MIDDLE = List.of("fx_px", "fy_px", "cx_px", "cy_px");

    private final String name;
    private final Lens lens;
    private final int[] free;
    private final boolean square;

    private LensChoice(String name, Lens lens, int[] free, boolean square) {
        this.name = name;
        this.lens = lens;
        this.free = free;
        this.square = square;
    }

    private static LensChoice of(String name, Lens lens, String... distortion) {
        List<String> names = new ArrayList<>(FOCAL_AND_MIDDLE);
        names.addAll(Arrays.asList(distortion));
        return new LensChoice(name, lens, names.stream().mapToInt(lens.parameterNames()::indexOf).toArray(), false);
    }

    /** From the leanest to the richest of lenses that are not wide. */
    static List<LensChoice> ladder() {
        return List.of(of("radial-1", BrownLens.MODEL, "k1"), of("radial-2", BrownLens.MODEL, "k1", "k2"),
                of("brown-4", BrownLens.MODEL, "k1", "k2", "p1", "p2"),
                of("brown-5", BrownLens.MODEL, "k1", "k2", "p1", "p2", "k3"),
                of("rational-8", RationalLens.MODEL, "k1", "k2", "p1", "p2", "k3", "k4", "k5", "k6"));
    }

    /** The usual one, where no richer one does better. */
    static LensChoice usual() {
        return ladder().get(1);
    }

    /** Richer than photos of a board tell apart by themselves; for lenses whose maker says so. */
    static LensChoice prism() {
        return of("prism-12", RationalLens.MODEL, "k1", "k2", "p1", "p2", "k3", "k4", "k5", "k6", "s1", "s2", "s3",
                "s4");
    }

    static LensChoice fisheye() {
        return of("fisheye", KannalaBrandtLens.MODEL, "k1", "k2", "k3", "k4");
    }

    /** All there are. */
    static List<LensChoice> all() {
        List<LensChoice> all = new ArrayList<>(ladder());
        all.add(prism());
        all.add(fisheye());
        return all;
    }

    /** One focal length and the first radial coefficient: a start for all the others. */
    LensChoice first() {
        return new LensChoice(name, lens, new int[] {PinholeCamera.FX, PinholeCamera.SKEW + 1}, true);
    }

    /** The same lens with nothing unknown: for poses alone. */
    LensChoice known() {
        return new LensChoice(name, lens, new int[0], false);
    }

    String name() {
        return name;
    }

    Lens lens() {
        return lens;
    }

    int unknowns() {
        return free.length;
    }

    /** Index among the lens's parameters of an unknown. */
    int parameter(int unknown) {
        return free[unknown];
    }

    /** Which unknown a parameter of the lens is; -1 where it is known. */
    int unknown(int parameter) {
        for (int k = 0; k < free.length; k++) {
            if (free[k] == parameter) {
                return k;
            }
        }
        return -1;
    }

    /** Takes the unknown columns out of a lens's derivative. */
    void select(double[] byLens, double[] rowU, double[] rowV) {
        int second = lens.parameterCount();
        for (int k = 0; k < free.length; k++) {
            rowU[k] = byLens[free[k]];
            rowV[k] = byLens[second + free[k]];
        }
        if (square) {
            rowU[0] += byLens[PinholeCamera.FY];
            rowV[0] += byLens[second + PinholeCamera.FY];
        }
    }

    /** The lens's values a step further. */
    void add(double[] values, double[] step, double[] out) {
        for (int k = 0; k < free.length; k++) {
            out[free[k]] = values[free[k]] + step[k];
        }
        if (square) {
            out[PinholeCamera.FY] = out[PinholeCamera.FX];
        }
    }
}
