package org.cellgauge.cli;

import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Model.OptionSpec;

/**
 * The options of every command, for commands whose specification is made by calls: picocli's own are made of
 * annotations, which takes long.
 */
final class StandardOptions {
    private StandardOptions() {
    }

    /**
     * Adds {@code --help} and {@code --version}, in picocli's words.
     *
     * @param spec a command
     * @return the command
     */
    static CommandSpec add(CommandSpec spec) {
        return spec.addOption(OptionSpec.builder("-h", "--help").type(boolean.class).usageHelp(true)
                        .description("Show this help message and exit.").build())
                .addOption(OptionSpec.builder("-V", "--version").type(boolean.class).versionHelp(true)
                        .description("Print version information and exit.").build());
    }
}
