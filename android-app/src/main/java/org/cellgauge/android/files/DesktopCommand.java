package org.cellgauge.android.files;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.cellgauge.check.CheckSettings;

/** The command by which the command line makes the figures of a kept result again. */
final class DesktopCommand {
    private DesktopCommand() {
    }

    /**
     * The command.
     *
     * @param name common beginning of the result's files
     * @param settings the check's
     * @return one line for a shell, with the options that differ from the defaults
     */
    static String of(String name, CheckSettings settings) {
        CheckSettings defaults = CheckSettings.builder().build();
        List<String> words = new ArrayList<>();
        words.add("cellgauge check --cell " + name + ".cell.yaml");
        words.add("--seed " + settings.seed());
        if (settings.model() != defaults.model()) {
            words.add("--model " + settings.model().optionName());
        }
        if (settings.kappa() != defaults.kappa()) {
            words.add("--kappa " + settings.kappa());
        }
        if (settings.sampler() != defaults.sampler()) {
            words.add("--sampler " + settings.sampler().optionName());
        }
        if (settings.chains() != defaults.chains()) {
            words.add("--chains " + settings.chains());
        }
        if (settings.iterations().isPresent()) {
            words.add("--iterations " + settings.iterations().getAsInt());
        }
        if (settings.warmup() != usualWarmup(settings)) {
            words.add("--warmup " + settings.warmup());
        }
        if (settings.estimate() != defaults.estimate()) {
            words.add("--estimate " + settings.estimate().optionName());
            if (settings.focalPriorStdPx() != defaults.focalPriorStdPx()) {
                words.add("--focal-prior-std " + settings.focalPriorStdPx());
            }
            if (settings.aspectPriorStd() != defaults.aspectPriorStd()) {
                words.add("--aspect-prior-std "
                        + (Double.isInfinite(settings.aspectPriorStd()) ? "independent" : settings.aspectPriorStd()));
            }
        }
        if (settings.initial() != defaults.initial()) {
            words.add("--initial " + settings.initial().optionName());
        }
        if (settings.objectNoise() != defaults.objectNoise()) {
            words.add("--object-noise " + settings.objectNoise().optionName().toLowerCase(Locale.ROOT));
        }
        words.add(name + ".png");
        return String.join(" ", words);
    }

    /** The warm-up where nobody asked for one: it depends on the sampler and the iterations. */
    private static int usualWarmup(CheckSettings settings) {
        CheckSettings.Builder usual = CheckSettings.builder().sampler(settings.sampler())
                .maxIterations(settings.maxIterations());
        if (settings.iterations().isPresent()) {
            usual.iterations(settings.iterations().getAsInt());
        }
        return usual.build().warmup();
    }
}
