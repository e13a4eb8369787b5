package org.cellgauge.android.camera;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertSame;

import android.hardware.camera2.CameraMetadata;
import java.util.Collections;
import java.util.EnumSet;
import org.cellgauge.geometry.BrownLens;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.internal.geometry.PixelArea;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** The model of the frames, and what is passed over of what devices state. */
class ModelChoiceTest {
    private static final PixelSize FULL_HD = new PixelSize(1920, 1080);
    private static final PixelSize QUARTER = new PixelSize(1000, 750);

    /** A sensor of 4000 x 3000 px of 1.4 um, of which all is used, behind a lens of 4.2 mm: 3000 px. */
    private static CameraTraits.Builder sensor() {
        return new CameraTraits.Builder("0").pixelArray(new PixelSize(4000, 3000)).sensorMm(5.6f, 4.2f)
                .focalLengthsMm(4.2f).activeArray(new PixelArea(0, 0, 4000, 3000))
                .preCorrectionActiveArray(new PixelArea(0, 0, 4000, 3000));
    }

    private static CameraTraits.Builder calibrated() {
        return sensor().intrinsicCalibration(3100, 3110, 2020, 1490, 0).distortion(0.1f, -0.05f, 0.01f, 0.001f, -0.002f)
                .distortionCorrectionModes(CameraMetadata.DISTORTION_CORRECTION_MODE_OFF,
                        CameraMetadata.DISTORTION_CORRECTION_MODE_FAST);
    }

    private static void assertCamera(PinholeCamera camera, double fx, double fy, double cx, double cy) {
        assertEquals(fx, camera.get(PinholeCamera.FX), 1e-3);
        assertEquals(fy, camera.get(PinholeCamera.FY), 1e-3);
        assertEquals(cx, camera.get(PinholeCamera.CX), 1e-3);
        assertEquals(cy, camera.get(PinholeCamera.CY), 1e-3);
    }

    @Test
    void theUsersCalibrationGoesBeforeTheDevices() {
        PinholeCamera file = PinholeCamera.ideal(1920, 1080, 1500, 1501, 960, 540);
        ModelChoice model = ModelChoice.of(calibrated().build(), FULL_HD, file);
        assertSame(file, model.camera());
        assertEquals(CameraModelSource.CALIBRATION_FILE, model.source());
        assertEquals(EnumSet.of(CameraNote.CALIBRATION_OF_ANOTHER_CAMERA), model.notes());
    }

    @Test
    void aCalibrationOfAnotherSizeIsScaledAndSaidToBe() {
        PinholeCamera file = PinholeCamera.ideal(4032, 3024, 3000, 3010, 2000, 1500);
        ModelChoice model = ModelChoice.of(sensor().build(), new PixelSize(1344, 1008), file);
        assertCamera(model.camera(), 1000, 3010 / 3.0, 2000 / 3.0, 500);
        assertEquals(1344, model.camera().widthPx());
        assertEquals(EnumSet.of(CameraNote.CALIBRATION_OF_ANOTHER_CAMERA, CameraNote.CALIBRATION_SCALED),
                model.notes());
    }

    @Test
    void theDevicesCalibrationIsScaledToFramesOfTheSensorsShape() {
        ModelChoice model = ModelChoice.of(calibrated().build(), QUARTER, null);
        assertEquals(CameraModelSource.DEVICE_CALIBRATION, model.source());
        assertEquals(Collections.emptySet(), model.notes());
        assertCamera(model.camera(), 775, 777.5, 505, 372.5);
        assertEquals(0.1, model.camera().get(BrownLens.K1), 1e-7);
        assertEquals(-0.002, model.camera().get(BrownLens.P2), 1e-7);
    }

    @Test
    void framesOfAnotherShapeAreCutFromTheMiddle() {
        // 4000 x 2250 of the sensor, 375 px less above and below, at 0.48
        ModelChoice model = ModelChoice.of(calibrated().build(), FULL_HD, null);
        assertCamera(model.camera(), 0.48 * 3100, 0.48 * 3110, 0.48 * 2020, 0.48 * (1490 - 375));
    }

    @Test
    void calibrationIsOfTheArrayBeforeTheCorrectionWhereThatIsOff() {
        // the array of corrected images is smaller and lies inside
        CameraTraits traits = calibrated().activeArray(new PixelArea(100, 75, 3800, 2850)).build();
        assertCamera(ModelChoice.of(traits, QUARTER, null).camera(), 775, 777.5, 505, 372.5);
    }

    @Test
    void aLensThatTheDeviceAlwaysCorrectsHasNoDistortionLeftAndIsSaidToBeUnknown() {
        CameraTraits traits = calibrated().activeArray(new PixelArea(100, 75, 3800, 2850))
                .distortionCorrectionModes(CameraMetadata.DISTORTION_CORRECTION_MODE_FAST).build();
        ModelChoice model = ModelChoice.of(traits, QUARTER, null);
        double scale = 1000 / 3800.0;
        assertCamera(model.camera(), scale * 3100, scale * 3110, scale * (2020 - 100), scale * (1490 - 75));
        assertEquals(false, model.camera().isDistorting());
        assertEquals(CameraModelSource.DEVICE_CALIBRATION, model.source());
        assertEquals(EnumSet.of(CameraNote.DISTORTION_UNKNOWN), model.notes());
    }

    @Test
    void beforeApi28ArraysThatDifferSayThatTheLensIsCorrected() {
        CameraTraits traits = calibrated().distortion((float[]) null).distortionCorrectionModes()
                .activeArray(new PixelArea(100, 75, 3800, 2850)).build();
        assertEquals(true, traits.alwaysCorrectsLens());
        assertEquals(EnumSet.of(CameraNote.DISTORTION_UNKNOWN), ModelChoice.of(traits, QUARTER, null).notes());
    }

    @Test
    void aCalibrationWithoutDistortionSaysSo() {
        ModelChoice model = ModelChoice.of(calibrated().distortion((float[]) null).build(), QUARTER, null);
        assertEquals(CameraModelSource.DEVICE_CALIBRATION, model.source());
        assertEquals(EnumSet.of(CameraNote.DISTORTION_UNKNOWN), model.notes());
    }

    @Test
    void aCalibrationOutOfTheDrawingIsNoMoreThanAFieldOfView() {
        CameraTraits traits = calibrated().intrinsicCalibration(3100, 3100, 2000, 1500, 0).distortion(0, 0, 0, 0, 0)
                .build();
        ModelChoice model = ModelChoice.of(traits, QUARTER, null);
        assertEquals(CameraModelSource.FIELD_OF_VIEW, model.source());
        assertEquals(EnumSet.of(CameraNote.FOCAL_LENGTH_ESTIMATED, CameraNote.DISTORTION_UNKNOWN), model.notes());
        assertCamera(model.camera(), 775, 775, 500, 375);
    }

    @Test
    void aMeasuredAxisMakesItACalibrationEvenWithoutDistortion() {
        CameraTraits traits = calibrated().intrinsicCalibration(3100, 3100, 2003, 1500, 0).distortion(0, 0, 0, 0, 0)
                .build();
        assertEquals(CameraModelSource.DEVICE_CALIBRATION, ModelChoice.of(traits, QUARTER, null).source());
    }

    @Test
    void withoutACalibrationTheDataSheetGivesTheFieldOfView() {
        ModelChoice model = ModelChoice.of(sensor().build(), FULL_HD, null);
        assertEquals(CameraModelSource.FIELD_OF_VIEW, model.source());
        assertEquals(EnumSet.of(CameraNote.FOCAL_LENGTH_ESTIMATED, CameraNote.DISTORTION_UNKNOWN), model.notes());
        // 4.2 mm / 1.4 um = 3000 px; all of 4000 px are in the 1920 of the frame
        assertCamera(model.camera(), 1440, 1440, 960, 540);
    }

    @Test
    void thePhysicalSizeIsThatOfTheWholeArrayAndNotOfItsActivePart() {
        CameraTraits traits = sensor().activeArray(new PixelArea(400, 300, 3200, 2400))
                .preCorrectionActiveArray(new PixelArea(400, 300, 3200, 2400)).build();
        // pixels stay 1.4 um wide, and 3200 of them are in 1600
        assertCamera(ModelChoice.of(traits, new PixelSize(1600, 1200), null).camera(), 1500, 1500, 800, 600);
    }

    @Test
    void ofSeveralFocalLengthsTheShortestCountsAndIsAskedFor() {
        CameraTraits traits = sensor().focalLengthsMm(8.4f, 0f, 4.2f, Float.NaN).build();
        assertEquals(4.2f, RequestSettings.focalLengthMm(traits));
        assertCamera(ModelChoice.of(traits, FULL_HD, null).camera(), 1440, 1440, 960, 540);
    }

    @ParameterizedTest
    @ValueSource(strings = {"0,0,0,0,0", "NaN,NaN,NaN,NaN,NaN", "3100,3100,0,0,0", "-3100,3100,2000,1500,0",
        "3100,3100,4000,1500,0", "3.1,3.1,2000,1500,0", "3100,9000,2000,1500,0", "31000,31000,2000,1500,0",
        "3100,3100,Infinity,1500,0", "3100,3100,1000,750,0", "3100,3100", "3100,3100,2000,1500,2000"})
    void intrinsicsThatNoCameraHasFallBackOnTheDataSheet(String values) {
        String[] parts = values.split(",");
        float[] intrinsics = new float[parts.length];
        for (int i = 0; i < parts.length; i++) {
            intrinsics[i] = Float.parseFloat(parts[i]);
        }
        ModelChoice model = ModelChoice.of(calibrated().intrinsicCalibration(intrinsics).build(), FULL_HD, null);
        assertNotNull(model);
        assertEquals(CameraModelSource.FIELD_OF_VIEW, model.source());
        assertCamera(model.camera(), 1440, 1440, 960, 540);
    }

    @Test
    void distortionThatFoldsTheImageOverFallsBackOnTheDataSheet() {
        CameraTraits traits = calibrated().distortion(-5, 0, 0, 0, 0).build();
        assertEquals(CameraModelSource.FIELD_OF_VIEW, ModelChoice.of(traits, FULL_HD, null).source());
        traits = calibrated().distortion(Float.NaN, 0, 0, 0, 0).build();
        assertEquals(CameraModelSource.FIELD_OF_VIEW, ModelChoice.of(traits, FULL_HD, null).source());
    }

    @Test
    void aCalibrationWithoutItsArrayIsOfNoUse() {
        CameraTraits traits = calibrated().activeArray(null).preCorrectionActiveArray(null).build();
        assertEquals(CameraModelSource.FIELD_OF_VIEW, ModelChoice.of(traits, FULL_HD, null).source());
    }

    @Test
    void aDeviceThatStatesNothingOfUseHasNoModel() {
        assertNull(ModelChoice.of(new CameraTraits.Builder("0").build(), FULL_HD, null));
        assertNull(ModelChoice.of(sensor().focalLengthsMm().build(), FULL_HD, null));
        assertNull(ModelChoice.of(sensor().focalLengthsMm(0).build(), FULL_HD, null));
        assertNull(ModelChoice.of(sensor().focalLengthsMm(Float.NaN).build(), FULL_HD, null));
        assertNull(ModelChoice.of(sensor().sensorMm(0, 0).build(), FULL_HD, null));
        assertNull(ModelChoice.of(sensor().sensorMm(Float.NaN, 4.2f).build(), FULL_HD, null));
        // width and height mixed up: pixels would be 1.05 um wide and 1.87 um high
        assertNull(ModelChoice.of(sensor().sensorMm(4.2f, 5.6f).build(), FULL_HD, null));
        // a lens of 420 mm: metres for millimetres, or the like
        assertNull(ModelChoice.of(sensor().focalLengthsMm(420).build(), FULL_HD, null));
        assertNull(ModelChoice.of(sensor().focalLengthsMm(0.042f).build(), FULL_HD, null));
    }

    @Test
    void theActiveArrayStandsInForTheWholeAndTheOtherWayRound() {
        CameraTraits noArray = sensor().pixelArray(null).build();
        assertCamera(ModelChoice.of(noArray, FULL_HD, null).camera(), 1440, 1440, 960, 540);
        CameraTraits noActive = sensor().activeArray(null).preCorrectionActiveArray(null).build();
        assertCamera(ModelChoice.of(noActive, FULL_HD, null).camera(), 1440, 1440, 960, 540);
    }

    @Test
    void aCopyOfTheTraitsCannotBeChanged() {
        float[] values = {3100, 3110, 2020, 1490, 0};
        CameraTraits traits = calibrated().intrinsicCalibration(values).build();
        values[0] = 0;
        traits.intrinsicCalibration()[0] = 1;
        assertArrayEquals(new float[] {3100, 3110, 2020, 1490, 0}, traits.intrinsicCalibration());
    }
}
