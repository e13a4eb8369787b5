package org.cellgauge.cli;

import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.cellgauge.cell.Cell;
import org.cellgauge.cell.ObjectMarker;
import org.cellgauge.geometry.RigidTransform;
import picocli.CommandLine;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.TypeConversionException;

/** The option {@code --object ID=X,Y,Z[,PSI,THETA,PHI]} of several commands. */
final class ObjectPoses {
    private ObjectPoses() {
    }

    /**
     * Reads the poses.
     *
     * @param command for messages about faulty options
     * @param objects values of the option, as typed
     * @return worldFromObject by id, in the order given
     * @throws ParameterException if a value is no such pose, or an id stands twice
     */
    static Map<Integer, RigidTransform> parse(CommandLine command, List<String> objects) {
        Map<Integer, RigidTransform> poses = new LinkedHashMap<>();
        for (String text : objects) {
            int equals = text.indexOf('=');
            int id;
            try {
                id = Integer.parseInt(text.substring(0, Math.max(0, equals)).trim());
            } catch (NumberFormatException e) {
                throw new ParameterException(command,
                        "--object: '" + text + "' does not start with a marker id and '=', as in 5=370,295,0");
            }
            try {
                if (poses.put(id, PoseArgument.parse(text.substring(equals + 1)).pose()) != null) {
                    throw new ParameterException(command, "--object: marker " + id + " is given twice");
                }
            } catch (TypeConversionException e) {
                throw new ParameterException(command, "--object: " + e.getMessage());
            }
        }
        return poses;
    }

    /**
     * Requires that all ids are objects of a cell.
     *
     * @param command for the message
     * @param cell the cell
     * @param cellFile its file, for the message
     * @param poses poses by id
     * @throws ParameterException if an id is none
     */
    static void requireKnown(CommandLine command, Cell cell, Path cellFile, Map<Integer, RigidTransform> poses) {
        List<Integer> known = cell.objects().stream().map(ObjectMarker::id).toList();
        for (int id : poses.keySet()) {
            if (!known.contains(id)) {
                throw new ParameterException(command, "--object: " + cellFile + " has no object " + id
                        + "; its objects are " + (known.isEmpty() ? "none" : known));
            }
        }
    }
}
