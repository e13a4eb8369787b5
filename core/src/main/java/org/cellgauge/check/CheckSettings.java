package org.cellgauge.check;

import java.util.OptionalInt;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.pose.InitialPose;
import org.cellgauge.pose.IntrinsicsPrior;
import org.cellgauge.posterior.RotationPrior;

/** Everything that determines the figures of a check besides its inputs; immutable. */
public final class CheckSettings {
    /** Which intrinsics are sampled along with the pose. */
    public enum Estimate {
        /** All intrinsics are taken as the camera file has them. */
        NONE("none"),
        /** Focal lengths fx and fy are unknown. */
        FOCAL("focal");

        private final String optionName;

        Estimate(String optionName) {
            this.optionName = optionName;
        }

        /**
         * Its word in settings and files.
         *
         * @return {@code none} or {@code focal}
         */
        public String optionName() {
            return optionName;
        }
    }

    /** What is taken of the noise in an object's own corners. */
    public enum ObjectNoise {
        /** The object's pose in the camera frame is sampled from its posterior given its corners. */
        DETECTION("detection"),
        /** The object's pose in the camera frame is its best fit, taken as exact: the camera's part alone. */
        NONE("none");

        private final String optionName;

        ObjectNoise(String optionName) {
            this.optionName = optionName;
        }

        /**
         * Its word in settings and files.
         *
         * @return {@code detection} or {@code none}
         */
        public String optionName() {
            return optionName;
        }
    }

    /** Where the chains of a random walk start. */
    public enum Start {
        /** At draws around the mode, wider than the posterior. */
        DISPERSED,
        /** At the initial estimate, as in the thesis. */
        INITIAL_ESTIMATE
    }

    private final Builder v;

    private CheckSettings(Builder b) {
        v = new Builder(b);
    }

    /**
     * Settings with the defaults: rigid-marker, independence, 4 chains until the Monte Carlo error suffices.
     *
     * @return a builder
     */
    public static Builder builder() {
        return new Builder();
    }

    /**
     * The settings of the thesis: corner-cube with kappa 0.5, one chain of 10 000 iterations of its mixture of steps
     * from the average pose, the last 5 000 kept, objects exact in the camera frame, flat in Euler angles.
     *
     * @return a builder, so that single settings can still be changed
     */
    public static Builder thesis() {
        return new Builder().model(LikelihoodModel.CORNER_CUBE).kappa(0.5).sampler(SamplerKind.THESIS_MIXTURE).chains(1)
                .iterations(10_000).warmup(5_000).initial(InitialPose.AVERAGE).objectNoise(ObjectNoise.NONE)
                .rotationPrior(RotationPrior.FLAT_IN_EULER_ANGLES).start(Start.INITIAL_ESTIMATE)
                .posePriorAllowed(false).aspectPriorStd(Double.POSITIVE_INFINITY);
    }

    /**
     * The same settings as a builder.
     *
     * @return a new builder
     */
    public Builder toBuilder() {
        return new Builder(v);
    }

    /**
     * Likelihood of the references' corners.
     *
     * @return the model
     */
    public LikelihoodModel model() {
        return v.model;
    }

    /**
     * Half extent of corner-cube's box in placement deviations.
     *
     * @return positive
     */
    public double kappa() {
        return v.kappa;
    }

    /**
     * How the camera pose is sampled.
     *
     * @return the sampler
     */
    public SamplerKind sampler() {
        return v.sampler;
    }

    /**
     * Number of chains.
     *
     * @return at least 1
     */
    public int chains() {
        return v.chains;
    }

    /**
     * Iterations of each chain, warm-up included, where the user fixed them.
     *
     * @return empty: chains run until {@link #targetMcseStdRel()} is reached or {@link #maxIterations()}
     */
    public OptionalInt iterations() {
        return v.iterations;
    }

    /**
     * Cap on the iterations of each chain where they are not fixed.
     *
     * @return more than the warm-up
     */
    public int maxIterations() {
        return v.maxIterations;
    }

    /**
     * Iterations of each chain that are not kept.
     *
     * @return the user's number, else 200 for independence, 5 000 for adaptive, half of the iterations for
     *     thesis-mixture
     */
    public int warmup() {
        if (v.warmup.isPresent()) {
            return v.warmup.getAsInt();
        }
        switch (v.sampler) {
            case INDEPENDENCE:
                return Math.min(200, cap() / 2);
            case ADAPTIVE:
                return Math.min(5_000, cap() / 2);
            default:
                return cap() / 2;
        }
    }

    private int cap() {
        return v.iterations.orElse(v.maxIterations);
    }

    /**
     * Seed of all randomness. Each photo has random streams of its own, named by this seed and by its markers' corners.
     *
     * @return any number
     */
    public long seed() {
        return v.seed;
    }

    /**
     * Which intrinsics are sampled.
     *
     * @return none or the focal lengths
     */
    public Estimate estimate() {
        return v.estimate;
    }

    /**
     * Standard deviation of the prior of the focal length about the camera file's.
     *
     * @return px
     */
    public double focalPriorStdPx() {
        return v.focalPriorStdPx;
    }

    /**
     * Standard deviation of the prior of the aspect ratio fy / fx about the camera file's, as a share of it.
     *
     * @return share; +infinity where fx and fy are independent beforehand, each with {@link #focalPriorStdPx()}
     */
    public double aspectPriorStd() {
        return v.aspectPriorStd;
    }

    /**
     * What is known beforehand of a camera's intrinsics.
     *
     * @param camera as the camera file has it
     * @return the prior
     */
    public IntrinsicsPrior intrinsicsPrior(PinholeCamera camera) {
        if (v.estimate != Estimate.FOCAL) {
            return IntrinsicsPrior.KNOWN;
        }
        return Double.isInfinite(v.aspectPriorStd) ? IntrinsicsPrior.focal(camera, v.focalPriorStdPx)
                : IntrinsicsPrior.focalAndAspect(camera, v.focalPriorStdPx, v.aspectPriorStd);
    }

    /**
     * First estimate of the camera pose.
     *
     * @return the estimator
     */
    public InitialPose initial() {
        return v.initial;
    }

    /**
     * What is taken of the noise in an object's own corners.
     *
     * @return detection noise or none
     */
    public ObjectNoise objectNoise() {
        return v.objectNoise;
    }

    /**
     * Prior over the camera's rotation.
     *
     * @return uniform unless the thesis is followed
     */
    public RotationPrior rotationPrior() {
        return v.rotationPrior;
    }

    /**
     * Where random walks start.
     *
     * @return dispersed unless the thesis is followed
     */
    public Start start() {
        return v.start;
    }

    /**
     * Whether a weak prior on the pose may be added where two or fewer references leave directions open.
     *
     * @return true unless the thesis is followed
     */
    public boolean posePriorAllowed() {
        return v.posePriorAllowed;
    }

    /**
     * Monte Carlo error of every standard deviation, relative to it, at which sampling stops.
     *
     * @return share, for instance 0.02
     */
    public double targetMcseStdRel() {
        return v.targetMcseStdRel;
    }

    /**
     * Number of threads; no figure depends on it.
     *
     * @return at least 1
     */
    public int threads() {
        return v.threads;
    }

    /** Builds settings; every method returns the builder itself. */
    public static final class Builder {
        private LikelihoodModel model = LikelihoodModel.RIGID_MARKER;
        private double kappa = 0.5;
        private SamplerKind sampler = SamplerKind.INDEPENDENCE;
        private int chains = 4;
        private OptionalInt iterations = OptionalInt.empty();
        private int maxIterations = 50_000;
        private OptionalInt warmup = OptionalInt.empty();
        private long seed = 1;
        private Estimate estimate = Estimate.NONE;
        private double focalPriorStdPx = 200;
        private double aspectPriorStd = 0.005;
        private InitialPose initial = InitialPose.PNP;
        private ObjectNoise objectNoise = ObjectNoise.DETECTION;
        private RotationPrior rotationPrior = RotationPrior.UNIFORM;
        private Start start = Start.DISPERSED;
        private boolean posePriorAllowed = true;
        private double targetMcseStdRel = 0.02;
        private int threads = Math.max(1, Runtime.getRuntime().availableProcessors());

        private Builder() {
        }

        private Builder(Builder b) {
            model = b.model;
            kappa = b.kappa;
            sampler = b.sampler;
            chains = b.chains;
            iterations = b.iterations;
            maxIterations = b.maxIterations;
            warmup = b.warmup;
            seed = b.seed;
            estimate = b.estimate;
            focalPriorStdPx = b.focalPriorStdPx;
            aspectPriorStd = b.aspectPriorStd;
            initial = b.initial;
            objectNoise = b.objectNoise;
            rotationPrior = b.rotationPrior;
            start = b.start;
            posePriorAllowed = b.posePriorAllowed;
            targetMcseStdRel = b.targetMcseStdRel;
            threads = b.threads;
        }

        /**
         * Sets the likelihood.
         *
         * @param value the model
         * @return this
         */
        public Builder model(LikelihoodModel value) {
            model = value;
            return this;
        }

        /**
         * Sets the half extent of corner-cube's box.
         *
         * @param value in placement deviations, positive
         * @return this
         */
        public Builder kappa(double value) {
            kappa = value;
            return this;
        }

        /**
         * Sets the sampler.
         *
         * @param value the sampler
         * @return this
         */
        public Builder sampler(SamplerKind value) {
            sampler = value;
            return this;
        }

        /**
         * Sets the number of chains.
         *
         * @param value at least 1
         * @return this
         */
        public Builder chains(int value) {
            chains = value;
            return this;
        }

        /**
         * Fixes the iterations of each chain, warm-up included.
         *
         * @param value at least 8
         * @return this
         */
        public Builder iterations(int value) {
            iterations = OptionalInt.of(value);
            return this;
        }

        /**
         * Lets chains run until their precision suffices, where a number of iterations was fixed before.
         *
         * @return this
         */
        public Builder untilPrecise() {
            iterations = OptionalInt.empty();
            return this;
        }

        /**
         * Sets the cap on iterations where they are not fixed.
         *
         * @param value at least 8
         * @return this
         */
        public Builder maxIterations(int value) {
            maxIterations = value;
            return this;
        }

        /**
         * Sets the iterations of each chain that are not kept.
         *
         * @param value at least 0, less than the iterations
         * @return this
         */
        public Builder warmup(int value) {
            warmup = OptionalInt.of(value);
            return this;
        }

        /**
         * Sets the seed.
         *
         * @param value any number
         * @return this
         */
        public Builder seed(long value) {
            seed = value;
            return this;
        }

        /**
         * Sets which intrinsics are sampled.
         *
         * @param value none or focal
         * @return this
         */
        public Builder estimate(Estimate value) {
            estimate = value;
            return this;
        }

        /**
         * Sets the prior deviation of the focal length.
         *
         * @param value px, positive
         * @return this
         */
        public Builder focalPriorStdPx(double value) {
            focalPriorStdPx = value;
            return this;
        }

        /**
         * Sets the prior deviation of the aspect ratio fy / fx.
         *
         * @param value share of the camera file's ratio, positive; +infinity for two independent focal lengths
         * @return this
         */
        public Builder aspectPriorStd(double value) {
            aspectPriorStd = value;
            return this;
        }

        /**
         * Sets the first estimate of the camera pose.
         *
         * @param value the estimator
         * @return this
         */
        public Builder initial(InitialPose value) {
            initial = value;
            return this;
        }

        /**
         * Sets what is taken of the noise in an object's own corners.
         *
         * @param value detection or none
         * @return this
         */
        public Builder objectNoise(ObjectNoise value) {
            objectNoise = value;
            return this;
        }

        /**
         * Sets the prior over the camera's rotation.
         *
         * @param value the prior
         * @return this
         */
        public Builder rotationPrior(RotationPrior value) {
            rotationPrior = value;
            return this;
        }

        /**
         * Sets where random walks start.
         *
         * @param value dispersed or at the initial estimate
         * @return this
         */
        public Builder start(Start value) {
            start = value;
            return this;
        }

        /**
         * Sets whether a weak prior on the pose may be added.
         *
         * @param value true to allow it
         * @return this
         */
        public Builder posePriorAllowed(boolean value) {
            posePriorAllowed = value;
            return this;
        }

        /**
         * Sets the relative Monte Carlo error of standard deviations at which sampling stops.
         *
         * @param value share, above 0 and below 1
         * @return this
         */
        public Builder targetMcseStdRel(double value) {
            targetMcseStdRel = value;
            return this;
        }

        /**
         * Sets the number of threads.
         *
         * @param value at least 1
         * @return this
         */
        public Builder threads(int value) {
            threads = value;
            return this;
        }

        /**
         * The settings.
         *
         * @return immutable
         * @throws IllegalArgumentException if a value is out of range, with what to change
         */
        public CheckSettings build() {
            require(kappa > 0 && Double.isFinite(kappa), "kappa must be positive");
            require(chains >= 1 && chains <= 1000, "chains must be between 1 and 1000");
            require(focalPriorStdPx > 0 && Double.isFinite(focalPriorStdPx), "focal prior must be positive");
            require(aspectPriorStd > 0, "aspect prior must be positive: it is a share, 0.005 for half a per cent");
            require(targetMcseStdRel > 0 && targetMcseStdRel < 1,
                    "precision must lie between 0 and 1: it is a share, 0.02 for 2 %");
            require(threads >= 1, "threads must be at least 1");
            int cap = iterations.orElse(maxIterations);
            require(cap >= 8, "iterations must be at least 8");
            require(!warmup.isPresent() || (warmup.getAsInt() >= 0 && warmup.getAsInt() <= cap - 8),
                    "warm-up must be at least 0 and leave at least 8 of the " + cap + " iterations");
            return new CheckSettings(this);
        }

        private static void require(boolean holds, String message) {
            if (!holds) {
                throw new IllegalArgumentException(message);
            }
        }
    }
}
