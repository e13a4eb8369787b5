package org.cellgauge.cli;

import java.util.Locale;
import java.util.Map;
import java.util.Stack;
import org.cellgauge.geometry.RigidTransform;
import picocli.CommandLine.IParameterPreprocessor;
import picocli.CommandLine.ITypeConverter;
import picocli.CommandLine.Model.ArgSpec;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.TypeConversionException;

/**
 * A pose as it is typed: {@code X,Y,Z[,PSI,THETA,PHI]}, mm and, as in the cell file, degrees; an angle that ends in
 * {@code rad} is in radians. Angles left out are 0.
 *
 * @param pose the pose, with the same meaning as {@link RigidTransform#ofEuler}
 */
public record PoseArgument(RigidTransform pose) {
    private static final double MAX_LENGTH_MM = 1e6;
    private static final double MAX_ANGLE_RAD = 2 * Math.PI + 1e-9;
    private static final String FORM = "X,Y,Z[,PSI,THETA,PHI] in mm and degrees (or radians: 0.1rad)";

    /**
     * Reads a pose.
     *
     * @param text as typed
     * @return the pose
     * @throws TypeConversionException if the text is none; the message says what is wrong with it
     */
    public static PoseArgument parse(String text) {
        String[] parts = text.split(",", -1);
        if (parts.length != 3 && parts.length != 6) {
            throw new TypeConversionException("'" + text + "' has " + parts.length + " values; expected " + FORM);
        }
        double[] values = new double[6];
        for (int i = 0; i < parts.length; i++) {
            values[i] = i < 3 ? number(parts[i], text) : angleRad(parts[i], text);
            double most = i < 3 ? MAX_LENGTH_MM : MAX_ANGLE_RAD;
            if (Math.abs(values[i]) > most) {
                throw new TypeConversionException("'" + parts[i].trim() + "' in '" + text + "' is beyond "
                        + (i < 3 ? "1000000 mm" : "360 degrees") + "; expected " + FORM);
            }
        }
        return new PoseArgument(
                RigidTransform.ofEuler(values[0], values[1], values[2], values[3], values[4], values[5]));
    }

    private static double angleRad(String part, String text) {
        String trimmed = part.trim().toLowerCase(Locale.ROOT);
        return trimmed.endsWith("rad") ? number(trimmed.substring(0, trimmed.length() - 3), text)
                : Math.toRadians(number(trimmed, text));
    }

    private static double number(String part, String text) {
        try {
            double value = Double.parseDouble(part.trim());
            if (Double.isFinite(value)) {
                return value;
            }
        } catch (NumberFormatException e) {
            // said below, as for infinite values
        }
        throw new TypeConversionException("'" + part.trim() + "' in '" + text + "' is no number; expected " + FORM);
    }

    /**
     * Lets the first number be negative, as in {@code --camera-pose -418,106,1070}: the parser would take the value for
     * an option. A leading space tells it otherwise, and does not matter to the number.
     */
    public static final class MayBeNegative implements IParameterPreprocessor {
        @Override
        public boolean preprocess(Stack<String> args, CommandSpec command, ArgSpec option, Map<String, Object> info) {
            if (!args.isEmpty() && args.peek().matches("-\\.?[0-9].*")) {
                args.push(" " + args.pop());
            }
            return false;
        }
    }

    /** Lets an option be of this type. */
    public static final class Converter implements ITypeConverter<PoseArgument> {
        @Override
        public PoseArgument convert(String value) {
            return parse(value);
        }
    }
}
