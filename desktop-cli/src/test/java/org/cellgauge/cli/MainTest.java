package org.cellgauge.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Set;
import java.util.TreeSet;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import picocli.CommandLine;

class MainTest {
    @ParameterizedTest
    @ValueSource(strings = {"check", "plan", "calibrate", "survey", "simulate", "validate", "reproduce", "camera",
        "families"})
    void aCommandThatIsCalledIsMadeAloneWithAllItsOptions(String name) {
        CommandLine alone = Main.commandLine("--debug", name, "--unknown");

        assertEquals(Set.of(name), alone.getSubcommands().keySet());
        assertEquals(options(Main.commandLine(), name), options(alone, name));
    }

    @Test
    void helpAndMistypedCommandsKnowAllCommands() {
        Set<String> all = Main.commandLine().getSubcommands().keySet();

        assertEquals(10, all.size());
        assertEquals(all, Main.commandLine("help", "check").getSubcommands().keySet());
        assertEquals(all, Main.commandLine("chek").getSubcommands().keySet());
        assertEquals(all, Main.commandLine("--help").getSubcommands().keySet());
    }

    private static Set<String> options(CommandLine line, String command) {
        return new TreeSet<>(line.getSubcommands().get(command).getCommandSpec().optionsMap().keySet());
    }
}
