package org.cellgauge.survey;

import java.util.ArrayList;
import java.util.List;
import org.cellgauge.internal.warning.Decimal;
import org.cellgauge.warning.Warning;

/**
 * What has moved between two surveys of a cell; immutable.
 *
 * @param bodies of all later photos together, of everything that both surveys know; the camera by the photo that says
 *     most
 * @param photos the same of every later photo by itself, in their order
 * @param limit squared distance, of six degrees of freedom, above which a body of one photo counts as moved
 */
public record Drift(List<Displacement> bodies, List<OfPhoto> photos, double limit) {
    /** Copies the lists. */
    public Drift {
        bodies = List.copyOf(bodies);
        photos = List.copyOf(photos);
    }

    /**
     * What one photo says.
     *
     * @param photo its name
     * @param bodies of those that it tells of
     */
    public record OfPhoto(String photo, List<Displacement> bodies) {
        /** Copies the list. */
        public OfPhoto {
            bodies = List.copyOf(bodies);
        }
    }

    /**
     * How far one thing has moved, all others but those that have moved, too, taken to stand where they stood.
     *
     * @param body what, where it stood
     * @param shiftMm along world x, y, z
     * @param stdMm deviations of that
     * @param turnDeg angle of the turn
     * @param chiSquare the move in units of its own deviations, squared: of six degrees of freedom where nothing has
     *     moved
     * @param chance of as much or more where nothing has moved
     * @param moved whether that is less likely than chance allows for all things together
     */
    public record Displacement(Epoch.Body body, List<Double> shiftMm, List<Double> stdMm, double turnDeg,
            double chiSquare, double chance, boolean moved) {
        /** Copies the lists. */
        public Displacement {
            shiftMm = List.copyOf(shiftMm);
            stdMm = List.copyOf(stdMm);
        }

        /**
         * Length of the shift.
         *
         * @return mm
         */
        public double distanceMm() {
            return Math.sqrt(shiftMm.stream().mapToDouble(x -> x * x).sum());
        }
    }

    /**
     * What users should know.
     *
     * @return a warning for everything that has moved, and for what single photos alone have elsewhere
     */
    public List<Warning> warnings() {
        List<Warning> out = new ArrayList<>();
        List<Epoch.Body> named = new ArrayList<>();
        for (Displacement d : bodies) {
            if (d.moved()) {
                named.add(d.body());
                out.add(Warning.of(SurveyWarning.MOVED, d.body().words(), Decimal.of(d.distanceMm(), 2),
                        Decimal.of(d.turnDeg(), 2), Decimal.of(100 * d.chance(), 4)));
            }
        }
        for (OfPhoto p : photos) {
            for (Displacement d : p.bodies()) {
                if (d.moved() && !named.contains(d.body())) {
                    out.add(Warning.of(SurveyWarning.MOVED_IN_PHOTO, d.body().words(), p.photo(),
                            Decimal.of(d.distanceMm(), 2), Decimal.of(d.turnDeg(), 2)));
                }
            }
        }
        return List.copyOf(out);
    }

    /**
     * Whether anything has moved.
     *
     * @return true if a body is called moved, by all photos or by a single one
     */
    public boolean any() {
        return bodies.stream().anyMatch(Displacement::moved)
                || photos.stream().anyMatch(p -> p.bodies().stream().anyMatch(Displacement::moved));
    }
}
