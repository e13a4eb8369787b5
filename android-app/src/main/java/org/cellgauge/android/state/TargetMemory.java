package org.cellgauge.android.state;

import android.os.Bundle;
import java.util.HashMap;
import java.util.Map;
import org.cellgauge.cell.Requirement;
import org.cellgauge.cell.Target;

/** A target as it outlives its process: numbers, infinite where nothing is asked. */
final class TargetMemory {
    private static final String GENERAL = "general";

    private TargetMemory() {
    }

    /** A target in a bundle of its own. */
    static Bundle write(Target target) {
        Bundle bundle = new Bundle();
        bundle.putDoubleArray(GENERAL, numbers(target.general()));
        for (Map.Entry<Integer, Requirement> own : target.own().entrySet()) {
            bundle.putDoubleArray(String.valueOf(own.getKey()), numbers(own.getValue()));
        }
        return bundle;
    }

    /** What {@link #write(Target)} wrote; no target where there is nothing. */
    static Target read(Bundle bundle) {
        if (bundle == null) {
            return Target.NONE;
        }
        Map<Integer, Requirement> own = new HashMap<>();
        for (String key : bundle.keySet()) {
            if (!key.equals(GENERAL)) {
                own.put(Integer.valueOf(key), requirement(bundle.getDoubleArray(key)));
            }
        }
        return new Target(requirement(bundle.getDoubleArray(GENERAL)), own);
    }

    private static double[] numbers(Requirement r) {
        return new double[] {r.stdMm().x(), r.stdMm().y(), r.stdMm().z(), r.toleranceMm().x(), r.toleranceMm().y(),
            r.toleranceMm().z(), r.distanceMm(), r.toleranceDeg(), r.probability()};
    }

    private static Requirement requirement(double[] n) {
        return new Requirement(new Requirement.Axes(n[0], n[1], n[2]), new Requirement.Axes(n[3], n[4], n[5]), n[6],
                n[7], n[8]);
    }
}
