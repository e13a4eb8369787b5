package org.cellgauge.settings;

import java.util.HashMap;
import java.util.Map;
import java.util.Objects;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import org.cellgauge.warning.Refusal;

/**
 * Everything that determines the figures of a check besides its inputs; immutable. What each setting is, and which
 * values it may have, stands in {@link SettingTable}.
 */
public final class CheckSettings implements SettingSource {
    /** Fewest iterations of a chain, and fewest of them that are kept. */
    static final int FEWEST_ITERATIONS = 8;

    private final SettingValues values;
    private final ModelSettings model;
    private final SamplingSettings sampling;

    private CheckSettings(SettingValues values) {
        this.values = values;
        this.model = new ModelSettings(values);
        this.sampling = new SamplingSettings(values);
    }

    /**
     * Settings with the defaults: rigid-marker, independence, 4 chains until the Monte Carlo error suffices.
     *
     * @return a builder
     */
    public static Builder builder() {
        return new Builder(new HashMap<>());
    }

    /**
     * The settings of the thesis: corner-cube with kappa 0.5, one chain of 10 000 iterations of its mixture of steps
     * from the average pose, the last 5 000 kept, objects exact in the camera frame, flat in Euler angles.
     *
     * @return a builder, so that single settings can still be changed
     */
    public static Builder thesis() {
        return builder().likelihood(LikelihoodModel.CORNER_CUBE).kappa(0.5).sampler(SamplerKind.THESIS_MIXTURE)
                .chains(1).iterations(10_000).warmup(5_000).initial(InitialEstimate.AVERAGE)
                .objectNoise(ObjectNoise.NONE).rotationPrior(RotationPrior.FLAT_IN_EULER_ANGLES)
                .start(ChainStart.INITIAL_ESTIMATE).posePriorAllowed(false)
                .aspectPriorStd(Double.POSITIVE_INFINITY);
    }

    /**
     * The same settings as a builder.
     *
     * @return a new builder
     */
    public Builder toBuilder() {
        return new Builder(values.copy());
    }

    /**
     * What is modelled.
     *
     * @return the half of the settings from which the posterior follows
     */
    public ModelSettings model() {
        return model;
    }

    /**
     * How it is sampled.
     *
     * @return the other half
     */
    public SamplingSettings sampling() {
        return sampling;
    }

    @Override
    public <T> T get(Setting<T> setting) {
        return values.get(setting);
    }

    @Override
    public boolean equals(Object other) {
        return other instanceof CheckSettings
                && SettingTable.all().stream().allMatch(row -> get(row).equals(((CheckSettings) other).get(row)));
    }

    @Override
    public int hashCode() {
        return SettingTable.all().stream().mapToInt(row -> get(row).hashCode()).reduce(0, (a, b) -> 31 * a + b);
    }

    /** The settings that differ from their defaults. */
    @Override
    public String toString() {
        return values.toString();
    }

    /** Builds settings; every method returns the builder itself. */
    public static final class Builder {
        private final Map<Setting<?>, Object> values;

        private Builder(Map<Setting<?>, Object> values) {
            this.values = values;
        }

        /**
         * Sets any setting.
         *
         * @param setting its row
         * @param value its value; whether it is in range is seen when the settings are built
         * @param <T> type of its values
         * @return this
         */
        public <T> Builder set(Setting<T> setting, T value) {
            values.put(setting, Objects.requireNonNull(value, setting.name()));
            return this;
        }

        /**
         * Sets the likelihood.
         *
         * @param value the likelihood
         * @return this
         */
        public Builder likelihood(LikelihoodModel value) {
            return set(SettingTable.MODEL, value);
        }

        /**
         * Sets the half extent of corner-cube's box.
         *
         * @param value in placement deviations, positive
         * @return this
         */
        public Builder kappa(double value) {
            return set(SettingTable.KAPPA, value);
        }

        /**
         * Sets the sampler.
         *
         * @param value the sampler
         * @return this
         */
        public Builder sampler(SamplerKind value) {
            return set(SettingTable.SAMPLER, value);
        }

        /**
         * Sets the number of chains.
         *
         * @param value at least 1
         * @return this
         */
        public Builder chains(int value) {
            return set(SettingTable.CHAINS, value);
        }

        /**
         * Fixes the iterations of each chain, warm-up included.
         *
         * @param value at least 8
         * @return this
         */
        public Builder iterations(int value) {
            return set(SettingTable.ITERATIONS, OptionalInt.of(value));
        }

        /**
         * Lets chains run until their precision suffices, where a number of iterations was fixed before.
         *
         * @return this
         */
        public Builder untilPrecise() {
            return set(SettingTable.ITERATIONS, OptionalInt.empty());
        }

        /**
         * Sets the cap on iterations where they are not fixed.
         *
         * @param value at least 8
         * @return this
         */
        public Builder maxIterations(int value) {
            return set(SettingTable.MAX_ITERATIONS, value);
        }

        /**
         * Sets the iterations of each chain that are not kept.
         *
         * @param value at least 0, less than the iterations
         * @return this
         */
        public Builder warmup(int value) {
            return set(SettingTable.WARMUP, OptionalInt.of(value));
        }

        /**
         * Sets the seed.
         *
         * @param value any number
         * @return this
         */
        public Builder seed(long value) {
            return set(SettingTable.SEED, value);
        }

        /**
         * Sets which intrinsics are sampled.
         *
         * @param value none or focal
         * @return this
         */
        public Builder estimate(Estimate value) {
            return set(SettingTable.ESTIMATE, value);
        }

        /**
         * Sets the prior deviation of the focal length.
         *
         * @param value px, positive; +infinity for a flat prior
         * @return this
         */
        public Builder focalPriorStdPx(double value) {
            return set(SettingTable.FOCAL_PRIOR_STD_PX, value);
        }

        /**
         * Sets the prior deviation of the aspect ratio fy / fx.
         *
         * @param value share of the camera file's ratio, positive; +infinity for two independent focal lengths
         * @return this
         */
        public Builder aspectPriorStd(double value) {
            return set(SettingTable.ASPECT_PRIOR_STD, value);
        }

        /**
         * Sets the first estimate of the camera pose.
         *
         * @param value the estimate
         * @return this
         */
        public Builder initial(InitialEstimate value) {
            return set(SettingTable.INITIAL, value);
        }

        /**
         * Sets what is taken of the noise in an object's own corners.
         *
         * @param value detection or none
         * @return this
         */
        public Builder objectNoise(ObjectNoise value) {
            return set(SettingTable.OBJECT_NOISE, value);
        }

        /**
         * Sets the prior over the camera's rotation.
         *
         * @param value the prior
         * @return this
         */
        public Builder rotationPrior(RotationPrior value) {
            return set(SettingTable.ROTATION_PRIOR, value);
        }

        /**
         * Sets where random walks start.
         *
         * @param value dispersed or at the initial estimate
         * @return this
         */
        public Builder start(ChainStart value) {
            return set(SettingTable.START, value);
        }

        /**
         * Sets whether a weak prior on the pose may be added.
         *
         * @param value true to allow it
         * @return this
         */
        public Builder posePriorAllowed(boolean value) {
            return set(SettingTable.POSE_PRIOR_ALLOWED, value);
        }

        /**
         * Sets the relative Monte Carlo error of standard deviations at which sampling stops.
         *
         * @param value share, above 0 and below 1
         * @return this
         */
        public Builder targetMcseStdRel(double value) {
            return set(SettingTable.PRECISION, value);
        }

        /**
         * Sets the target in place of the cell's own.
         *
         * @param value mm, positive
         * @return this
         */
        public Builder targetStdMm(double value) {
            return set(SettingTable.TARGET_STD_MM, OptionalDouble.of(value));
        }

        /**
         * Sets the number of threads.
         *
         * @param value at least 1
         * @return this
         */
        public Builder threads(int value) {
            return set(SettingTable.THREADS, value);
        }

        /**
         * The settings.
         *
         * @return immutable
         * @throws SettingRefusedException if a value is out of range, with what to change
         */
        public CheckSettings build() {
            SettingValues built = new SettingValues(values);
            SettingTable.all().forEach(row -> requireInRange(row, built));
            CheckSettings settings = new CheckSettings(built);
            int cap = settings.sampling.cap();
            int warmup = settings.sampling.warmup();
            if (warmup < 0 || warmup > cap - FEWEST_ITERATIONS && built.get(SettingTable.WARMUP).isPresent()) {
                throw new SettingRefusedException(SettingTable.WARMUP,
                        Refusal.of(SettingRefusal.TOO_FEW_LEFT, FEWEST_ITERATIONS, cap, warmup));
            }
            return settings;
        }

        private static <T> void requireInRange(Setting<T> row, SettingValues values) {
            row.requireInRange(values.get(row));
        }
    }
}
