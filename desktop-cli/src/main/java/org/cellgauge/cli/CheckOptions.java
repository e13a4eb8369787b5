package org.cellgauge.cli;

import java.util.List;
import org.cellgauge.settings.CheckSettings;
import org.cellgauge.settings.Setting;
import org.cellgauge.settings.SettingRefusedException;
import org.cellgauge.settings.SettingTable;
import picocli.CommandLine;
import picocli.CommandLine.IModelTransformer;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Model.OptionSpec;
import picocli.CommandLine.ParameterException;

/**
 * Options of the commands that sample, made from the table of settings: each is called after its setting. What is not
 * given stays as the preset or the command's default has it.
 */
final class CheckOptions {
    static final CheckSettings CHECK_USUAL = CheckSettings.builder().build();

    private static final String PRESET = "--preset";
    private static final String THESIS = "thesis";

    private final CommandLine command;
    private final CheckSettings usual;

    private CheckOptions(CommandLine command, CheckSettings usual) {
        this.command = command;
        this.usual = usual;
    }

    /**
     * Adds the options to {@code check}.
     *
     * @param spec the command, as yet without options of help
     */
    static void addToCheck(CommandSpec spec) {
        add(spec, CHECK_USUAL, List.of());
    }

    /** Adds to {@code survey} those that many photos know: of the lens, of chains, and the target. */
    static final class OfSurvey implements IModelTransformer {
        @Override
        public CommandSpec transform(CommandSpec spec) {
            List<OptionSpec> last = takeLast(spec);
            SettingOptions.add(spec, List.of(SettingTable.ESTIMATE, SettingTable.FOCAL_PRIOR_STD_PX,
                    SettingTable.ASPECT_PRIOR_STD, SettingTable.PRINCIPAL_PRIOR_STD_PX, SettingTable.RADIAL_PRIOR_STD,
                    SettingTable.CALIBRATION, SettingTable.CHAINS, SettingTable.ITERATIONS,
                    SettingTable.MAX_ITERATIONS, SettingTable.SEED, SettingTable.TARGET_STD_MM,
                    SettingTable.THREADS), CHECK_USUAL);
            putBack(spec, last);
            return spec;
        }
    }

    /**
     * Adds those of {@link StudyTable} and these to {@code validate}: errors of its checks average out, and it judges
     * nothing by a target.
     */
    static final class OfValidate implements IModelTransformer {
        static final CheckSettings USUAL = CheckSettings.builder().targetMcseStdRel(0.1).build();

        @Override
        public CommandSpec transform(CommandSpec spec) {
            SettingOptions.add(spec, StudyTable.all(), StudySettings.USUAL);
            List<OptionSpec> last = takeLast(spec);
            add(spec, USUAL, List.of(SettingTable.TARGET_STD_MM));
            putBack(spec, last);
            return spec;
        }
    }

    private static void add(CommandSpec spec, CheckSettings usual, List<Setting<?>> without) {
        spec.addOption(OptionSpec.builder(PRESET).paramLabel(THESIS).type(String.class)
                .description("Sets all of the following as in the thesis: corner-cube with kappa 0.5, its mixture of "
                        + "steps, 1 chain of 10000 iterations of which 5000 are kept, start at the average pose, no "
                        + "noise of the objects' own corners. Options given besides still count.").build());
        SettingOptions.add(spec, SettingTable.all().stream().filter(row -> !without.contains(row)).toList(), usual);
    }

    /**
     * Takes out the options that help tells of last. A loop, here and below, since references to methods of picocli's
     * specification keep that, its largest class, out of the archive of classes.
     */
    private static List<OptionSpec> takeLast(CommandSpec spec) {
        List<OptionSpec> last = List.of(spec.findOption("--help"), spec.findOption("--version"));
        for (OptionSpec option : last) {
            spec.remove(option);
        }
        return last;
    }

    private static void putBack(CommandSpec spec, List<OptionSpec> last) {
        for (OptionSpec option : last) {
            spec.addOption(option);
        }
    }

    /**
     * The settings that the options of a command ask for.
     *
     * @param command the command, parsed
     * @param usual settings where neither option nor preset says otherwise
     * @return the settings
     * @throws ParameterException if an option has no such value, or values do not go together
     */
    static CheckSettings settings(CommandLine command, CheckSettings usual) {
        return new CheckOptions(command, usual).settings();
    }

    private CheckSettings settings() {
        CheckSettings.Builder builder = start();
        if (given(SettingTable.ITERATIONS) != null) {
            for (Setting<?> other : List.of(SettingTable.PRECISION, SettingTable.MAX_ITERATIONS)) {
                if (given(other) != null) {
                    throw new ParameterException(command, SettingOptions.name(SettingTable.ITERATIONS)
                            + " fixes the length of the chains; leave it out, or leave out "
                            + SettingOptions.name(other));
                }
            }
        } else if (given(SettingTable.PRECISION) != null || given(SettingTable.MAX_ITERATIONS) != null) {
            builder.untilPrecise();
        }
        for (Setting<?> setting : SettingTable.all()) {
            String text = given(setting);
            if (text != null) {
                read(setting, text, builder);
            }
        }
        try {
            return builder.build();
        } catch (SettingRefusedException e) {
            throw SettingOptions.refused(command, e);
        }
    }

    private CheckSettings.Builder start() {
        String preset = command.getCommandSpec().findOption(PRESET) == null ? null
                : command.getParseResult().matchedOptionValue(PRESET, (String) null);
        if (preset == null) {
            return usual.toBuilder();
        }
        if (!preset.equals(THESIS)) {
            throw new ParameterException(command, PRESET + ": '" + preset + "' is not known; write " + THESIS);
        }
        return CheckSettings.thesis().targetMcseStdRel(usual.sampling().targetMcseStdRel());
    }

    private void read(Setting<?> setting, String text, CheckSettings.Builder builder) {
        try {
            setting.read(text, builder);
        } catch (SettingRefusedException e) {
            throw SettingOptions.refused(command, e);
        }
    }

    private String given(Setting<?> setting) {
        return SettingOptions.given(command, setting);
    }
}
