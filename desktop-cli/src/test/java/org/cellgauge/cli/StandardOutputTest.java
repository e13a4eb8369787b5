package org.cellgauge.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.OutputStream;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import picocli.CommandLine;

class StandardOutputTest {
    @TempDir
    private Path folder;

    /** A full disk, or a pipe whose other end is closed: the data is lost, and the exit code says so. */
    @Test
    void outputThatNobodyTakesIsNoSuccess() {
        OutputStream full = new OutputStream() {
            @Override
            public void write(int b) throws IOException {
                throw new IOException("No space left on device");
            }
        };
        StringWriter err = new StringWriter();
        CommandLine command = Main.commandLine().setOut(new PrintWriter(full, true)).setErr(new PrintWriter(err));
        assertEquals(3, Main.run(command, "--version"));
        assertTrue(err.toString().contains("disk is full"), err.toString());
    }

    /** Options are read from no file, whatever a photo is called. */
    @Test
    void namesThatBeginWithAnAtAreNames() throws IOException {
        Path options = Files.writeString(folder.resolve("args.png"), "--version");
        CommandCall call = CommandCall.of("check", "--cell", "nowhere.yaml", "@" + options);
        assertEquals(3, call.code(), call.out());
        assertTrue(call.err().contains("nowhere.yaml"), call.err());
    }
}
