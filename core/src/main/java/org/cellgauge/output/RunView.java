package org.cellgauge.output;

import java.util.OptionalDouble;
import org.cellgauge.check.CheckResult;
import org.cellgauge.settings.CheckSettings;
import org.cellgauge.settings.SettingTable;
import org.jspecify.annotations.Nullable;

/** How a result was sampled; immutable. */
public final class RunView extends Value {
    private final CheckSettings settings;
    private final String samplerUsed;
    private final int iterationsPerChain;
    private final @Nullable String posePrior;

    RunView(CheckSettings settings, String samplerUsed, int iterationsPerChain, @Nullable String posePrior) {
        this.settings = settings;
        this.samplerUsed = samplerUsed;
        this.iterationsPerChain = iterationsPerChain;
        this.posePrior = posePrior;
    }

    static RunView of(CheckResult result) {
        CheckSettings settings = result.settings().toBuilder().warmup(result.warmup())
                .set(SettingTable.THREADS, SettingTable.THREADS.usual()).build();
        return new RunView(settings, result.samplerUsed().word(), result.iterationsPerChain(), result.posePrior());
    }

    /** The same without a target of its own: the result has it. */
    RunView withoutTarget() {
        return new RunView(settings.toBuilder().set(SettingTable.TARGET_STD_MM, OptionalDouble.empty()).build(),
                samplerUsed, iterationsPerChain, posePrior);
    }

    /**
     * Iterations of each chain that were not kept.
     *
     * @return less than {@link #iterationsPerChain()}
     */
    public int warmup() {
        return settings.get(SettingTable.WARMUP).getAsInt();
    }

    /**
     * The settings, the warm-up as it was run. Threads, on which no figure depends, are the default.
     *
     * @return never null
     */
    public CheckSettings settings() {
        return settings;
    }

    /**
     * The sampler that made the draws.
     *
     * @return the one asked for, unless the posterior was too far from Gaussian for it
     */
    public String samplerUsed() {
        return samplerUsed;
    }

    /**
     * Iterations each chain ran, warm-up included.
     *
     * @return positive
     */
    public int iterationsPerChain() {
        return iterationsPerChain;
    }

    /**
     * The weak prior that was put on the camera pose, in English.
     *
     * @return null where it was flat in position and uniform over rotations
     */
    public @Nullable String posePrior() {
        return posePrior;
    }

    @Override
    @Nullable Object[] figures() {
        return new @Nullable Object[] {settings, samplerUsed, iterationsPerChain, posePrior};
    }
}
