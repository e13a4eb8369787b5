package org.cellgauge.settings;

import java.util.OptionalInt;

/** How the posterior is sampled, and from where; immutable. */
public final class SamplingSettings {
    private final SettingValues values;

    SamplingSettings(SettingValues values) {
        this.values = values;
    }

    /**
     * Value of any row of this half, for those without a method of their own.
     *
     * @param setting the row
     * @param <T> type of its values
     * @return the value, never null
     * @throws IllegalArgumentException if the row belongs to the other half
     */
    public <T> T get(Setting<T> setting) {
        return values.get(setting, Setting.Part.SAMPLING);
    }

    /**
     * How the camera pose is sampled.
     *
     * @return the sampler
     */
    public SamplerKind sampler() {
        return values.get(SettingTable.SAMPLER);
    }

    /**
     * Number of chains.
     *
     * @return at least 1
     */
    public int chains() {
        return values.get(SettingTable.CHAINS);
    }

    /**
     * Iterations of each chain, warm-up included, where the user fixed them.
     *
     * @return empty: chains run until {@link #targetMcseStdRel()} is reached or {@link #maxIterations()}
     */
    public OptionalInt iterations() {
        return values.get(SettingTable.ITERATIONS);
    }

    /**
     * Cap on the iterations of each chain where they are not fixed.
     *
     * @return more than the warm-up
     */
    public int maxIterations() {
        return values.get(SettingTable.MAX_ITERATIONS);
    }

    /**
     * Iterations of each chain that are not kept.
     *
     * @return the user's number, else what the sampler needs
     */
    public int warmup() {
        return warmup(sampler());
    }

    /**
     * Iterations of each chain that are not kept, where another sampler takes the place of the one asked for.
     *
     * @param used the sampler
     * @return the user's number, else 200 for independence, 5 000 for adaptive, half of the iterations for
     *     thesis-mixture
     */
    public int warmup(SamplerKind used) {
        OptionalInt fixed = values.get(SettingTable.WARMUP);
        if (fixed.isPresent()) {
            return fixed.getAsInt();
        }
        switch (used) {
            case INDEPENDENCE:
                return Math.min(200, cap() / 2);
            case ADAPTIVE:
                return Math.min(5_000, cap() / 2);
            default:
                return cap() / 2;
        }
    }

    /**
     * Seed of all randomness. Each photo has random streams of its own, named by this seed and by its markers'
     * corners.
     *
     * @return any number
     */
    public long seed() {
        return values.get(SettingTable.SEED);
    }

    /**
     * First estimate of the camera pose.
     *
     * @return the estimate
     */
    public InitialEstimate initial() {
        return values.get(SettingTable.INITIAL);
    }

    /**
     * Where random walks start.
     *
     * @return dispersed unless the thesis is followed
     */
    public ChainStart start() {
        return values.get(SettingTable.START);
    }

    /**
     * Monte Carlo error of every standard deviation, relative to it, at which sampling stops.
     *
     * @return share, for instance 0.02
     */
    public double targetMcseStdRel() {
        return values.get(SettingTable.PRECISION);
    }

    /**
     * Number of threads; no figure depends on it.
     *
     * @return at least 1
     */
    public int threads() {
        return values.get(SettingTable.THREADS);
    }

    /** Iterations of each chain at most. */
    int cap() {
        return iterations().orElse(maxIterations());
    }
}
