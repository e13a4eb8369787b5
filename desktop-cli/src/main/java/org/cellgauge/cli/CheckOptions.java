package org.cellgauge.cli;

import java.util.Arrays;
import java.util.List;
import java.util.function.Function;
import java.util.stream.Collectors;
import org.cellgauge.settings.CheckSettings;
import org.cellgauge.settings.Estimate;
import org.cellgauge.settings.InitialEstimate;
import org.cellgauge.settings.LikelihoodModel;
import org.cellgauge.settings.ObjectNoise;
import org.cellgauge.settings.SamplerKind;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine;

/** Options common to the commands that sample. What is not given stays as the preset or the default has it. */
final class CheckOptions {
    @Option(names = "--preset", paramLabel = "thesis",
            description = "Sets all of the following as in the thesis: corner-cube with kappa 0.5, its mixture of "
                    + "steps, 1 chain of 10000 iterations of which 5000 are kept, start at the average pose, no noise "
                    + "of the objects' own corners. Options given besides still count.")
    private String preset;

    @Option(names = "--model", paramLabel = "rigid-marker|corner-cube",
            description = "How placement errors move corners: each reference as a rigid whole (default), or every "
                    + "corner on its own as in the thesis.")
    private String model;

    @Option(names = "--kappa", paramLabel = "K",
            description = "Half extent of corner-cube's box in standard deviations (0.5).")
    private Double kappa;

    @Option(names = "--sampler", paramLabel = "independence|adaptive|thesis-mixture",
            description = "How the camera pose is sampled (independence).")
    private String sampler;

    @Option(names = "--chains", paramLabel = "N", description = "Number of chains (4).")
    private Integer chains;

    @Option(names = "--iterations", paramLabel = "N",
            description = "Iterations of each chain, warm-up included. Without it: as many as --precision takes.")
    private Integer iterations;

    @Option(names = "--precision", paramLabel = "SHARE",
            description = "Chains run until the Monte Carlo error of every standard deviation is below this share of "
                    + "it (0.02; validate 0.1).")
    private Double precision;

    @Option(names = "--max-iterations", paramLabel = "N",
            description = "Cap on the iterations of each chain, warm-up included, whatever the precision is by then; a "
                    + "warning says if it was not reached (50000).")
    private Integer maxIterations;

    @Option(names = "--warmup", paramLabel = "N",
            description = "Iterations of each chain that are not kept (independence 200, adaptive 5000, thesis-mixture "
                    + "half of them).")
    private Integer warmup;

    @Option(names = "--seed", paramLabel = "SEED",
            description = "Seed of everything random; the same seed gives the same figures (1). Each photo has random "
                    + "numbers of its own, named by the seed and by the corners of its markers.")
    private Long seed;

    @Option(names = "--estimate", paramLabel = "none|focal|intrinsics",
            description = "What of the camera is estimated along with its pose (none).")
    private String estimate;

    @Option(names = "--focal-prior-std", paramLabel = "PX",
            description = "With --estimate focal: standard deviation of what is known of the focal length beforehand, "
                    + "about the camera file's fx, px (200).")
    private Double focalPriorStdPx;

    @Option(names = "--aspect-prior-std", paramLabel = "SHARE|independent",
            description = "With --estimate focal: standard deviation of what is known of fy / fx beforehand, as a "
                    + "share of the camera file's (0.005); independent for two focal lengths that know nothing of each "
                    + "other, as in the thesis.")
    private String aspectPriorStd;

    @Option(names = "--initial", paramLabel = "average|ransac|pnp",
            description = "First estimate of the camera pose (pnp).")
    private String initial;

    @Option(names = "--object-noise", paramLabel = "detection|none",
            description = "Whether the noise in an object's own corners counts (detection), or the camera's part alone "
                    + "is wanted (none).")
    private String objectNoise;

    @Option(names = "--threads", paramLabel = "N",
            description = "Number of threads; no figure depends on it (all cores).")
    private Integer threads;

    /**
     * The settings that these options ask for.
     *
     * @param command for messages about faulty options
     * @return the settings
     * @throws ParameterException if an option has no such value, or values do not go together
     */
    CheckSettings settings(CommandLine command) {
        CheckSettings.Builder b = CheckSettings.builder();
        if (preset != null) {
            choose(command, "--preset", preset, List.of("thesis"), Function.identity());
            b = CheckSettings.thesis();
        }
        if (model != null) {
            b.likelihood(choose(command, "--model", model, Arrays.asList(LikelihoodModel.values()),
                    LikelihoodModel::word));
        }
        if (sampler != null) {
            b.sampler(choose(command, "--sampler", sampler, Arrays.asList(SamplerKind.values()),
                    SamplerKind::word));
        }
        if (estimate != null) {
            if (estimate.equals("intrinsics")) {
                throw new ParameterException(command, "--estimate: this version estimates no intrinsics but the focal "
                        + "length; use --estimate focal, or calibrate the camera beforehand");
            }
            b.estimate(choose(command, "--estimate", estimate, Arrays.asList(Estimate.values()),
                    Estimate::word));
        }
        if (initial != null) {
            b.initial(choose(command, "--initial", initial,
                    Arrays.asList(InitialEstimate.values()), InitialEstimate::word));
        }
        if (objectNoise != null) {
            b.objectNoise(choose(command, "--object-noise", objectNoise,
                    Arrays.asList(ObjectNoise.values()), ObjectNoise::word));
        }
        if (kappa != null) {
            b.kappa(kappa);
        }
        if (chains != null) {
            b.chains(chains);
        }
        if (iterations != null && (precision != null || maxIterations != null)) {
            throw new ParameterException(command, "--iterations fixes the length of the chains; leave it out, or leave "
                    + "out " + (precision != null ? "--precision" : "--max-iterations"));
        }
        if (iterations != null) {
            b.iterations(iterations);
        }
        if (precision != null) {
            b.untilPrecise().targetMcseStdRel(precision);
        }
        if (maxIterations != null) {
            b.untilPrecise().maxIterations(maxIterations);
        }
        if (warmup != null) {
            b.warmup(warmup);
        }
        if (seed != null) {
            b.seed(seed);
        }
        if (focalPriorStdPx != null) {
            b.focalPriorStdPx(focalPriorStdPx);
        }
        if (aspectPriorStd != null) {
            b.aspectPriorStd(aspect(command, aspectPriorStd));
        }
        if (threads != null) {
            b.threads(threads);
        }
        try {
            return b.build();
        } catch (IllegalArgumentException e) {
            throw new ParameterException(command, e.getMessage());
        }
    }

    private static double aspect(CommandLine command, String text) {
        if (text.equals("independent")) {
            return Double.POSITIVE_INFINITY;
        }
        try {
            double share = Double.parseDouble(text);
            if (share > 0 && share < Double.POSITIVE_INFINITY) {
                return share;
            }
        } catch (NumberFormatException e) {
            // said below
        }
        throw new ParameterException(command, "--aspect-prior-std: '" + text + "' is neither a share above 0, such as "
                + "0.005, nor independent");
    }

    /** Whether the precision was given, so that no default of a command's own takes its place. */
    boolean hasPrecision() {
        return precision != null;
    }

    private static <T> T choose(CommandLine command, String option, String given, List<T> choices,
            Function<T, String> name) {
        for (T choice : choices) {
            if (name.apply(choice).equals(given)) {
                return choice;
            }
        }
        throw new ParameterException(command, option + ": '" + given + "' is not known; write "
                + choices.stream().map(name).collect(Collectors.joining(" or ")));
    }
}
