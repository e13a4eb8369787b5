package org.cellgauge.cell;

import java.util.List;

/** What stands in the photos of a calibration; immutable. {@link CalibrationTargetReader} reads it from a file. */
public sealed interface CalibrationTarget {
    /**
     * The name of its kind, the key that states it in a target file.
     *
     * @return such as {@code chessboard}
     */
    String kindName();

    /** Regular patterns on one plane. */
    enum Pattern {
        /** Black and white squares; corners inside of the board count. */
        CHESSBOARD("chessboard"),
        /** A chessboard whose white squares say which they are (BoofCV's ECoCheck): it may be seen in part. */
        ECOCHECK("ecocheck"),
        /** Black discs in rows and columns. */
        CIRCLE_GRID("circle_grid"),
        /** Black discs in rows, every other one shifted by half a step. */
        HEXAGONAL_CIRCLE_GRID("hexagonal_circle_grid");

        private final String key;

        Pattern(String key) {
            this.key = key;
        }

        /**
         * The key of target files.
         *
         * @return in lower case with underscores
         */
        public String key() {
            return key;
        }

        /**
         * Whether it is made of discs.
         *
         * @return false for squares
         */
        public boolean isOfCircles() {
            return this == CIRCLE_GRID || this == HEXAGONAL_CIRCLE_GRID;
        }
    }

    /**
     * A regular pattern.
     *
     * @param pattern which
     * @param rows squares or discs from top to bottom
     * @param columns squares or discs from left to right
     * @param sizeMm side of a square or diameter of a disc, mm
     * @param spacingMm distance of neighbouring discs' centres, mm; the side for squares
     */
    record Grid(Pattern pattern, int rows, int columns, double sizeMm, double spacingMm)
            implements CalibrationTarget {
        @Override
        public String kindName() {
            return pattern.key();
        }
    }

    /**
     * Markers whose places are known: of a plate, of a board such as ChArUco, or of a cell that was surveyed.
     *
     * @param kindName the key that states it
     * @param family family of the markers
     * @param markers the markers in the target's frame; their placements do not count
     * @param isFlat whether all lie in one plane and face one way
     */
    record Markers(String kindName, MarkerFamily family, List<Reference> markers, boolean isFlat)
            implements CalibrationTarget {
        /**
         * Markers.
         *
         * @param kindName the key that states it
         * @param family family of the markers
         * @param markers the markers in the target's frame; copied
         * @param isFlat whether all lie in one plane and face one way
         */
        public Markers {
            markers = List.copyOf(markers);
        }
    }
}
