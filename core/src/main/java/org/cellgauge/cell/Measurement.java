package org.cellgauge.cell;

import java.util.List;
import org.cellgauge.geometry.RigidTransform;

/**
 * What somebody measured of references besides placing them, with its standard deviation; immutable. Points are the
 * centres of markers; errors are Gaussian and independent but for what all touched points share.
 */
public sealed interface Measurement {
    /**
     * The references that it is about.
     *
     * @return their ids, unmodifiable
     */
    List<Integer> members();

    /**
     * The distance between two references, by tape, calliper or scale bar.
     *
     * @param from id of one
     * @param to id of the other
     * @param mm distance of their centres, mm, positive
     * @param stdMm standard deviation, mm, positive
     */
    record Distance(int from, int to, double mm, double stdMm) implements Measurement {
        @Override
        public List<Integer> members() {
            return List.of(from, to);
        }
    }

    /**
     * How much higher along world z one reference stands than another.
     *
     * @param above id of the one
     * @param below id of the other
     * @param mm z of the one less z of the other, mm
     * @param stdMm standard deviation, mm, positive
     */
    record Height(int above, int below, double mm, double stdMm) implements Measurement {
        @Override
        public List<Integer> members() {
            return List.of(above, below);
        }
    }

    /**
     * References whose centres lie in one plane, of which nothing more is known.
     *
     * @param members ids, at least four: three points always lie in one
     * @param stdMm standard deviation of each from the plane, mm, positive
     */
    record OnePlane(List<Integer> members, double stdMm) implements Measurement {
        /** Copies the list. */
        public OnePlane {
            members = List.copyOf(members);
        }
    }

    /**
     * A reference's centre as a robot touched it. Where the robot's base stands and where its tool ends are the same
     * errors in all touched points ({@link RobotPrecision}).
     *
     * @param id the reference
     * @param worldFromTool where the robot reports the tip of its tool, and how the tool was turned; in the world
     * @param std standard deviation of each coordinate of this touch, mm; its turn means nothing
     */
    record Touched(int id, RigidTransform worldFromTool, Placement std) implements Measurement {
        @Override
        public List<Integer> members() {
            return List.of(id);
        }
    }
}
