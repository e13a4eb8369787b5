package org.cellgauge.cli;

import java.util.Locale;
import java.util.TreeSet;
import org.cellgauge.cell.CameraFormat;
import org.cellgauge.internal.cell.CameraExport;
import picocli.CommandLine;
import picocli.CommandLine.ParameterException;

/** The word after {@code --to}: whose form a camera file is written in. */
final class CameraForm {
    static final String WORDS = "boofcv|opencv|ros";

    private CameraForm() {
    }

    /**
     * The form of a word.
     *
     * @param command where it was given
     * @param word as given
     * @throws ParameterException if no such form is written
     */
    static CameraFormat of(CommandLine command, String word) {
        CameraFormat format = CameraExport.FORMS.get(word.toLowerCase(Locale.ROOT));
        if (format == null) {
            throw new ParameterException(command, "--to: '" + word + "' is none of "
                    + String.join(", ", new TreeSet<>(CameraExport.FORMS.keySet())));
        }
        return format;
    }
}
