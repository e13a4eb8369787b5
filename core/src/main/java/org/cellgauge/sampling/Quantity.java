package org.cellgauge.sampling;

import java.util.Locale;
import java.util.OptionalInt;
import org.jspecify.annotations.Nullable;

/**
 * One column of draws: what it is about, which marker's, along which axis and in what unit; immutable. Two quantities
 * are equal where their names are.
 */
public final class Quantity {
    /** What a quantity is about. */
    public enum Kind {
        /** Logarithm of the camera's posterior density, up to a constant. */
        LOG_DENSITY,
        /** A coordinate of the camera's pose. */
        CAMERA,
        /** Which of the camera's pose modes the draw is near, from 0. */
        CAMERA_MODE,
        /** An unknown parameter of the lens. */
        INTRINSIC,
        /** Shift of the photo's edges into the dark. */
        EDGE_SHIFT,
        /** Spread of ink on prints of one size. */
        PRINT_GAIN,
        /** True size of prints of one stated size. */
        PRINT_SIZE,
        /** Noise of corners on top of what the detector says. */
        ADDED_NOISE,
        /** A coordinate of an object's pose. */
        OBJECT,
        /** Which of an object's pose modes the draw is near, from 0. */
        OBJECT_MODE,
        /** A coordinate of an object's gripping point. */
        GRIP
    }

    /** Coordinates of a pose in the world; a point has the first three. */
    public enum Axis {
        /** Position along world x. */
        X(Unit.MM),
        /** Position along world y. */
        Y(Unit.MM),
        /** Position along world z. */
        Z(Unit.MM),
        /** Angle about x. */
        PSI(Unit.RAD),
        /** Angle about y. */
        THETA(Unit.RAD),
        /** Angle about z. */
        PHI(Unit.RAD),
        /** Rotation vector from the pose's reference rotation, along world x. */
        WX(Unit.RAD),
        /** The same along world y. */
        WY(Unit.RAD),
        /** The same along world z. */
        WZ(Unit.RAD);

        private final Unit unit;

        Axis(Unit unit) {
            this.unit = unit;
        }

        private String column() {
            return name().toLowerCase(Locale.ROOT) + unit.suffix;
        }
    }

    /** Units, as they end a column's name. */
    public enum Unit {
        /** A pure number. */
        NONE(""),
        /** Millimetres. */
        MM("_mm"),
        /** Radians. */
        RAD("_rad"),
        /** Pixels. */
        PX("_px");

        private final String suffix;

        Unit(String suffix) {
            this.suffix = suffix;
        }
    }

    /** The log density; Stan's tools know it by this name. */
    public static final Quantity LOG_DENSITY = new Quantity(Kind.LOG_DENSITY, OptionalInt.empty(), null, Unit.NONE,
            "lp__");
    /** Which of its modes the camera is near. */
    public static final Quantity CAMERA_MODE = new Quantity(Kind.CAMERA_MODE, OptionalInt.empty(), null, Unit.NONE,
            "camera_mode");
    /** Shift of the photo's edges into the dark, px. */
    public static final Quantity EDGE_SHIFT = new Quantity(Kind.EDGE_SHIFT, OptionalInt.empty(), null, Unit.PX,
            "edge_shift_px");
    /** Noise of corners on top of what the detector says, px. */
    public static final Quantity ADDED_NOISE = new Quantity(Kind.ADDED_NOISE, OptionalInt.empty(), null, Unit.PX,
            "added_noise_px");

    private final Kind kind;
    private final OptionalInt id;
    private final @Nullable Axis axis;
    private final Unit unit;
    private final String name;

    private Quantity(Kind kind, OptionalInt id, @Nullable Axis axis, Unit unit, String name) {
        this.kind = kind;
        this.id = id;
        this.axis = axis;
        this.unit = unit;
        this.name = name;
    }

    /**
     * A coordinate of the camera's pose.
     *
     * @param axis which
     * @return the quantity
     */
    public static Quantity camera(Axis axis) {
        return new Quantity(Kind.CAMERA, OptionalInt.empty(), axis, axis.unit, "camera_" + axis.column());
    }

    /**
     * A coordinate of an object's pose.
     *
     * @param id marker id
     * @param axis which
     * @return the quantity
     */
    public static Quantity object(int id, Axis axis) {
        return new Quantity(Kind.OBJECT, OptionalInt.of(id), axis, axis.unit, "object_" + id + "_" + axis.column());
    }

    /**
     * Which of its modes an object is near.
     *
     * @param id marker id
     * @return the quantity
     */
    public static Quantity objectMode(int id) {
        return new Quantity(Kind.OBJECT_MODE, OptionalInt.of(id), null, Unit.NONE, "object_" + id + "_mode");
    }

    /**
     * A coordinate of an object's gripping point.
     *
     * @param id marker id
     * @param axis x, y or z
     * @return the quantity
     */
    public static Quantity grip(int id, Axis axis) {
        return new Quantity(Kind.GRIP, OptionalInt.of(id), axis, axis.unit, "object_" + id + "_grip_" + axis.column());
    }

    /**
     * An unknown parameter of the lens.
     *
     * @param name as the lens names it, its unit included
     * @return the quantity
     */
    public static Quantity intrinsic(String name) {
        return new Quantity(Kind.INTRINSIC, OptionalInt.empty(), null,
                name.endsWith(Unit.PX.suffix) ? Unit.PX : Unit.NONE, name);
    }

    /**
     * Spread of ink on prints of one size.
     *
     * @param sizeMm stated size of these markers, mm
     * @return the quantity, mm
     */
    public static Quantity printGain(double sizeMm) {
        return new Quantity(Kind.PRINT_GAIN, OptionalInt.empty(), null, Unit.MM,
                "print_gain_of_" + inName(sizeMm) + Unit.MM.suffix);
    }

    /**
     * True size of prints of one stated size.
     *
     * @param sizeMm stated size of these markers, mm
     * @return the quantity, mm
     */
    public static Quantity printSize(double sizeMm) {
        return new Quantity(Kind.PRINT_SIZE, OptionalInt.empty(), null, Unit.MM,
                "size_of_" + inName(sizeMm) + Unit.MM.suffix);
    }

    /** A size in a name, where a point would mean an index to readers of Stan's files. */
    private static String inName(double sizeMm) {
        return (sizeMm == Math.rint(sizeMm) ? String.valueOf((long) sizeMm) : String.valueOf(sizeMm)).replace('.', '_');
    }

    /**
     * What it is about.
     *
     * @return never null
     */
    public Kind kind() {
        return kind;
    }

    /**
     * The object it belongs to.
     *
     * @return marker id; empty for what is no object's
     */
    public OptionalInt id() {
        return id;
    }

    /**
     * The coordinate of a pose or point that it is.
     *
     * @return null for what is no coordinate
     */
    public @Nullable Axis axis() {
        return axis;
    }

    /**
     * Its unit.
     *
     * @return never null
     */
    public Unit unit() {
        return unit;
    }

    /**
     * Its name in files: the column of a chain, the key of a diagnostic.
     *
     * @return such as {@code object_5_grip_x_mm}
     */
    public String name() {
        return name;
    }

    /**
     * Its name without the marker it belongs to.
     *
     * @return such as {@code x_mm} or {@code grip_x_mm} for a coordinate; else its name
     */
    public String coordinate() {
        return axis == null ? name : (kind == Kind.GRIP ? "grip_" : "") + axis.column();
    }

    @Override
    public boolean equals(Object other) {
        return other instanceof Quantity && name.equals(((Quantity) other).name);
    }

    @Override
    public int hashCode() {
        return name.hashCode();
    }

    @Override
    public String toString() {
        return name;
    }
}
