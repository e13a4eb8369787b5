package org.cellgauge.warning;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Arrays;
import java.util.Collections;
import org.cellgauge.internal.warning.CheckPhrase;
import org.cellgauge.internal.warning.Decimal;
import org.cellgauge.internal.warning.Listing;
import org.cellgauge.vision.DetectionWarning;
import org.junit.jupiter.api.Test;

/** The sentences of result files and reports, each written out; how they are come by is tested with the checks. */
class CheckWarningTest {
    private static void says(String sentence, WarningKind kind, Object... arguments) {
        assertEquals(sentence, Warning.of(kind, arguments).toString());
    }

    private static Decimal n(double value, int decimals) {
        return Decimal.of(value, decimals);
    }

    @Test
    void ofDetection() {
        says("what looks like marker 7 at (300, 220) px is left out: its cells do not match; if it is that marker, use "
                + "a larger one, a closer camera, a sharper image or more light",
                DetectionWarning.CELLS_DO_NOT_MATCH, 7, 300, 220);
        says("what looks like marker 7 at (300, 220) px is left out: its edges cannot be measured; if it is that "
                + "marker, use a larger one, a closer camera, a sharper image or more light",
                DetectionWarning.EDGES_NOT_MEASURED, 7, 300, 220);
        says("marker 944 at (300, 220) px is left out: its corners miss those of a square by 6.3 px (limit 2.9); look "
                + "for something that covers or bends it, or for another pattern taken for it",
                DetectionWarning.NOT_SQUARE, 944, 300, 220, n(6.31, 1), n(2.9, 1));
        says("marker 5 is seen at 2 places, (150, 201) and (420, 250) px, and is left out; an id may stand only once "
                + "in view: remove or cover the others", DetectionWarning.SEEN_TWICE, 5, 2, Listing.and(Arrays.asList(
                Warning.of(CheckPhrase.PLACE, 150, 201), Warning.of(CheckPhrase.PLACE, 420, 250))));
        says("marker 5: its edges are too blurred, short or covered to be measured finely; its corners are coarse",
                DetectionWarning.COARSE_CORNERS, 5);
    }

    @Test
    void ofWhatExplainsAMisfit() {
        says("as if all markers were 2.1 % smaller than 47 mm (give or take 0.2 %): measure the black square of a "
                + "print and state that as size_mm; it may be the focal length or reference 22 instead",
                CheckWarning.AS_IF_MARKERS, n(2.1, 1), CheckPhrase.SMALLER, Warning.of(CheckPhrase.STD_MM, n(47, 0)),
                n(0.2, 1), Warning.of(CheckPhrase.OR_CAUSE, Listing.or(Arrays.asList(
                        Warning.of(CheckPhrase.CAUSE_FOCAL_LENGTH), Warning.of(CheckPhrase.CAUSE_REFERENCE, 22)))));
        says("references 22 and 944 seem exchanged: each stands where the cell file has the other; exchange their ids "
                + "or their markers", CheckWarning.REFERENCES_EXCHANGED, Listing.and(Arrays.asList(22, 944)), "");
    }

    @Test
    void ofWhatThePhotoShows() {
        says("not seen in the photo: object 5, 20 and 30", CheckWarning.OBJECTS_NOT_SEEN,
                Listing.and(Arrays.asList(5, 20, 30)));
        says("the camera's principal point (1900, -300) px is far from the middle of the image of 1280 x 720 px (by "
                + "more than 20 % of a side): as it must be where images are cut out of larger ones, and else a "
                + "mistake in cx or cy", CheckWarning.PRINCIPAL_POINT_OFF, n(1900, 0), n(-300, 0), 1280, 720, n(20, 0));
        says("not seen in the photo: reference 8", CheckWarning.REFERENCES_NOT_SEEN,
                Listing.and(Collections.singletonList(8)));
        says("small in the image: marker 5 (20.1 px), 7 (24.9 px); below 25 px of side corners get imprecise and "
                + "markers are missed, plan for 32 px: larger markers or a closer camera", CheckWarning.SMALL_MARKERS,
                Listing.comma(Arrays.asList(Warning.of(CheckPhrase.SMALL_MARKER, 5, n(20.1, 1)),
                        Warning.of(CheckPhrase.SMALL_MARKER, 7, n(24.94, 1)))), n(25, 0), n(32, 0));
        says("pixel_std_px is not stated: corners of this photo are good to 0.213 px as far as it tells, and with 95 % "
                + "to between 0.150 and 0.310 px",
                CheckWarning.CORNER_NOISE_ESTIMATED, n(0.2134, 3), n(0.15, 3), n(0.3104, 3));
        says("the corners of marker 22 fit no square: 12 times worse than those of the others; it counts for little "
                + "until they do (is it covered, smudged, bent, or has it a glint?)", CheckWarning.MARKER_SET_ASIDE, 22,
                n(12.3, 0));
        says("the corners of marker 5 fit no square: 12.3 times worse than those of the others, which no noise that "
                + "these leave open explains; no target counts as met until they do", CheckWarning.MARKER_NO_SQUARE, 5,
                n(12.3, 1));
        says("markers 5 and 20 are seen in one place, where at most one of them can be: one is misread, or the "
                + "detections are not of one photo", CheckWarning.MARKERS_IN_ONE_PLACE, 5, 20);
        says("the cell file has references 8 and 9 in one place, where at most one of them can be: correct the "
                + "position of one", CheckWarning.REFERENCES_IN_ONE_PLACE, 8, 9);
        says("reference 8 and 9 may stand off by up to 7 % of its distance from the camera, as stated: what the result "
                + "says is that uncertain, and rests on nothing else; measure the place", CheckWarning.PLACES_WIDE,
                Listing.and(Arrays.asList(8, 9)), n(7.2, 0));
        says("chains and Laplace's approximation are apart: the standard deviation of camera_z_mm is 2.40 times as "
                + "large, its mean -0.3 deviations off; the photo leaves too much open for a model that is linear in "
                + "placement errors: state smaller placement deviations, or add references", CheckWarning.CHAINS_APART,
                "camera_z_mm", n(2.4, 2), n(-0.3, 1));
        says("reference 8 and 9 may be turned farther than the model can follow (side in px times squared turn in rad "
                + "over corner noise in px is up to 61, and the model holds to about 20): figures may be off; state a "
                + "smaller std_deg after measuring how it is mounted", CheckWarning.TURNS_TOO_LOOSE,
                Listing.and(Arrays.asList(8, 9)), n(61.2, 0), n(20, 0));
    }

    @Test
    void ofTheWayToTheFigures() {
        says("the posterior is far from Gaussian (importance efficiency 3 %, acceptance 12 %): adaptive Metropolis was "
                + "used instead of independence", CheckWarning.FAR_FROM_GAUSSIAN,
                Warning.of(CheckPhrase.MISFIT, n(3.4, 0), n(12, 0)));
        says("the average estimate found no camera pose; pnp was used instead", CheckWarning.INITIAL_ESTIMATE_FAILED,
                "average");
        says("the references leave a direction of the camera pose open: 45 % of what is known there is the weak prior "
                + "N(initial estimate, 1000 mm, 0.7 rad); add a reference", CheckWarning.DIRECTION_OPEN, n(45, 0),
                Warning.of(CheckPhrase.WEAK_PRIOR, n(1000, 0), n(0.7, 1)));
        says("the chains reached their cap of 4000 iterations before the precision asked for: the standard deviation "
                + "of camera_x has a Monte Carlo error of 1.7 % in place of 0.1 %; allow more iterations",
                CheckWarning.CAP_REACHED, n(4000, 0), "camera_x", n(1.66, 1), Decimal.shortest(0.1),
                CheckPhrase.MORE_ITERATIONS);
        says("the draws of camera_x_mm have heavy tails (Pareto k 0.41, up to 0.25 is well): its standard deviation is "
                + "less precise than its stated Monte Carlo error, and more iterations hardly help; more or better "
                + "placed references do", CheckWarning.HEAVY_TAILS, "camera_x_mm", n(0.412, 2), n(0.25, 2));
    }

    @Test
    void ofReferences() {
        says("reference 3 is left out: its corners are nowhere near where the other references put it; check its id "
                + "and position in the cell file", CheckWarning.REFERENCE_LEFT_OUT, 3);
        Warning x = Warning.of(CheckPhrase.SHIFT, n(15.2, 1), "x");
        Warning y = Warning.of(CheckPhrase.SHIFT, n(-3, 1), "y");
        says("reference 22 seems off by about 15.2 mm along x and -3.0 mm along y, which its stated precision (1.0 mm "
                + "and 2.0 mm) does not allow: measure its position again; it may be reference 8 or 9 instead",
                CheckWarning.REFERENCE_OFF, 22, Listing.and(Arrays.asList(x, y)),
                Listing.and(Arrays.asList(Warning.of(CheckPhrase.STD_MM, n(1, 1)),
                        Warning.of(CheckPhrase.STD_MM, n(2, 1)))),
                Warning.of(CheckPhrase.OR_INSTEAD, Listing.or(Arrays.asList(8, 9))));
        says("reference 22 seems turned by about 4.0 degrees about z, which its stated precision (0.50 degrees) does "
                + "not allow: check how it is mounted", CheckWarning.REFERENCE_TURNED, 22,
                Listing.and(Collections.singletonList(Warning.of(CheckPhrase.TURN, n(4, 1), "z"))),
                Listing.and(Collections.singletonList(Warning.of(CheckPhrase.STD_DEGREES, n(0.5, 2)))), "");
    }

    @Test
    void ofWhatHangsOnThem() {
        says("figures rest on reference 22 all the same: without it the gripping point of object 20 moves by (1.0, "
                + "-2.0, 0.5) mm, more than any other, and the largest deviation is 1.40 mm instead of 1.20 mm",
                CheckWarning.FIGURES_REST_ON_IT, Listing.and(Collections.singletonList(22)),
                Warning.of(CheckPhrase.GRIP, 20), n(1, 1), n(-2, 1), n(0.5, 1),
                Warning.of(CheckPhrase.MORE_THAN_ANY_OTHER),
                Warning.of(CheckPhrase.LARGEST_DEVIATION, n(1.4, 2), n(1.2, 2)));
        says("figures rest on references 22 and 8 all the same: without them the camera moves by (1.0, -2.0, 0.5) mm",
                CheckWarning.FIGURES_REST_ON_THEM, Listing.and(Arrays.asList(22, 8)), Warning.of(CheckPhrase.CAMERA),
                n(1, 1), n(-2, 1), n(0.5, 1), "", "");
        says("object 20", CheckPhrase.OBJECT, 20);
        says("without it the other references lead to no camera pose", CheckWarning.NO_POSE_WITHOUT_IT);
        says("without them the other references lead to no camera pose", CheckWarning.NO_POSE_WITHOUT_THEM);
    }
}
