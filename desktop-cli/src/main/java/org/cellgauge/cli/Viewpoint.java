package org.cellgauge.cli;

import java.util.Arrays;
import java.util.Map;
import org.cellgauge.cell.Cell;
import org.cellgauge.desktop.render.CellSimulation;
import org.cellgauge.geometry.RigidTransform;
import picocli.CommandLine;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;

/** Options of the commands that think of a photo: where the camera stands. */
final class Viewpoint {
    @Option(names = "--camera-pose", paramLabel = "X,Y,Z,PSI,THETA,PHI", converter = PoseArgument.Converter.class,
            preprocessor = PoseArgument.MayBeNegative.class,
            description = "Pose of the camera in the world, mm and degrees. Without it the camera looks straight at "
                    + "the plane z = 0, from where all markers fit.")
    private PoseArgument cameraPose;

    @Option(names = "--look-at", paramLabel = "X,Y,Z", preprocessor = PoseArgument.MayBeNegative.class,
            description = "Point that the camera looks at, in the world, mm, in place of --camera-pose; up in the "
                    + "image is up in the world, or y where it looks straight down.")
    private String lookAt;

    @Option(names = "--camera-position", paramLabel = "X,Y,Z", preprocessor = PoseArgument.MayBeNegative.class,
            description = "With --look-at: where the camera stands, in the world, mm.")
    private String cameraPosition;

    @Option(names = "--distance", paramLabel = "MM",
            description = "With --look-at, in place of --camera-position: straight above the point, so far from it.")
    private Double distanceMm;

    /** Whether any of the options was given. */
    boolean given() {
        return cameraPose != null || lookAt != null;
    }

    /**
     * Requires that the options say one thing.
     *
     * @param command for messages
     * @throws ParameterException if they contradict each other or leave something open
     */
    void requireOne(CommandLine command) {
        if (lookAt == null && (cameraPosition != null || distanceMm != null)) {
            throw new ParameterException(command, (cameraPosition != null ? "--camera-position" : "--distance")
                    + " needs the point to look at: give --look-at, too");
        }
        if (lookAt != null && cameraPose != null) {
            throw new ParameterException(command,
                    "--look-at and --camera-pose both say where the camera looks: leave out one of them");
        }
        if (lookAt != null && (cameraPosition == null) == (distanceMm == null)) {
            throw new ParameterException(command,
                    "--look-at: say from where, with either --camera-position X,Y,Z or --distance MM");
        }
        if (distanceMm != null && !(distanceMm > 0 && Double.isFinite(distanceMm))) {
            throw new ParameterException(command, "--distance: must be positive, not " + distanceMm);
        }
    }

    /**
     * Where the camera stands.
     *
     * @param command for messages
     * @param cell for an overview where nothing is said
     * @param worldFromObjects objects that the overview is to show
     * @return worldFromCamera
     */
    RigidTransform pose(CommandLine command, Cell cell, Map<Integer, RigidTransform> worldFromObjects) {
        if (lookAt == null) {
            return cameraPose != null ? cameraPose.pose() : CellSimulation.overview(cell, worldFromObjects);
        }
        double[] target = point(command, "--look-at", lookAt);
        double[] from = cameraPosition != null ? point(command, "--camera-position", cameraPosition)
                : new double[] {target[0], target[1], target[2] + distanceMm};
        try {
            return CellSimulation.lookingAt(from, target);
        } catch (IllegalArgumentException e) {
            throw new ParameterException(command, "--look-at: " + e.getMessage());
        }
    }

    private static double[] point(CommandLine command, String option, String text) {
        String[] parts = text.split(",", -1);
        try {
            double[] point = Arrays.stream(parts).mapToDouble(part -> Double.parseDouble(part.trim())).toArray();
            if (point.length == 3 && Arrays.stream(point).allMatch(Double::isFinite)) {
                return point;
            }
        } catch (NumberFormatException e) {
            // said below
        }
        throw new ParameterException(command,
                option + ": '" + text.trim() + "' is not X,Y,Z in mm, as in 250,190,0");
    }
}
