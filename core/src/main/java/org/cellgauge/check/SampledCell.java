package org.cellgauge.check;

import java.util.Collections;
import java.util.List;
import org.cellgauge.internal.chains.CellQuantities;
import org.cellgauge.internal.sampling.EnsembleSnapshot;
import org.cellgauge.sampling.Draws;
import org.cellgauge.settings.SamplerKind;
import org.cellgauge.warning.Warning;

/** The fourth stage of a check: the draws of its chains, and how far they have converged; immutable. */
final class SampledCell {
    final QuickLook quickLook;
    final CellQuantities quantities;
    final CellEstimate estimate;
    final List<Draws> draws;
    final EnsembleSnapshot last;
    final Diagnostics diagnostics;
    final SamplerKind samplerUsed;
    /** How often tuning has evaluated the camera's posterior. */
    final long tuningEvaluations;
    /** All warnings so far. */
    final List<Warning> warnings;

    SampledCell(QuickLook quickLook, CellQuantities quantities, CellEstimate estimate, List<Draws> draws,
            EnsembleSnapshot last, Diagnostics diagnostics, SamplerKind samplerUsed, long tuningEvaluations,
            List<Warning> warnings) {
        this.quickLook = quickLook;
        this.quantities = quantities;
        this.estimate = estimate;
        this.draws = draws;
        this.last = last;
        this.diagnostics = diagnostics;
        this.samplerUsed = samplerUsed;
        this.tuningEvaluations = tuningEvaluations;
        this.warnings = Collections.unmodifiableList(warnings);
    }

    /** Whether the target asked of the Monte Carlo errors is reached. */
    boolean preciseEnough() {
        return ChainRun.preciseEnough(diagnostics, quickLook.modes.observed.settings);
    }
}
