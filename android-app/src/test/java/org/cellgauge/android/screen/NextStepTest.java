package org.cellgauge.android.screen;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import org.cellgauge.light.ToneCurve;
import org.cellgauge.vision.DetectionWarning;
import org.cellgauge.vision.Detections;
import org.cellgauge.vision.PhotoLight;
import org.cellgauge.warning.Warning;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;

/** From how much blur on a steadier hand is asked for. */
class NextStepTest {
    private static Detections frame(double blurPx, List<Warning> warnings) {
        PhotoLight light = Double.isNaN(blurPx) ? null : new PhotoLight(ToneCurve.SRGB, true, blurPx, 1, 100, 0);
        return new Detections("frame", 1280, 720, Collections.emptyList(), warnings, light);
    }

    private static Detections with(double blurPx, DetectionWarning... kinds) {
        List<Warning> warnings = new ArrayList<>();
        for (DetectionWarning kind : kinds) {
            int places = kind == DetectionWarning.GLARE ? 2
                    : kind == DetectionWarning.BLURRED || kind == DetectionWarning.TOO_DARK ? 1 : 3;
            warnings.add(Warning.of(kind, Collections.nCopies(places, 5).toArray()));
        }
        return frame(blurPx, warnings);
    }

    @ParameterizedTest
    @CsvSource({"0.7, false", "1.9, false", "2.1, true", "NaN, false"})
    void markersThatAreReadAreBlurredFromTwoPixelsOn(double blurPx, boolean blurred) {
        assertEquals(blurred, NextStep.isBlurred(with(blurPx)));
        assertEquals(blurred, NextStep.isBlurred(with(blurPx, DetectionWarning.GLARE, DetectionWarning.TOO_DARK)));
    }

    @ParameterizedTest
    @EnumSource(value = DetectionWarning.class, names = {"CELLS_DO_NOT_MATCH", "EDGES_NOT_MEASURED"})
    void lessBlurIsTooMuchWhereAMarkerCouldNotBeRead(DetectionWarning unread) {
        assertFalse(NextStep.isBlurred(with(1.1, unread)));
        assertTrue(NextStep.isBlurred(with(1.3, unread)));
        assertFalse(NextStep.isBlurred(with(Double.NaN, unread)));
    }

    @Test
    void whatTheDetectorCallsBlurredIs() {
        for (DetectionWarning kind : new DetectionWarning[] {DetectionWarning.BLURRED, DetectionWarning.TOO_BLURRED}) {
            assertTrue(NextStep.isBlurred(with(0.7, kind)));
            assertTrue(NextStep.isBlurred(with(Double.NaN, DetectionWarning.GLARE, kind)));
        }
    }
}
