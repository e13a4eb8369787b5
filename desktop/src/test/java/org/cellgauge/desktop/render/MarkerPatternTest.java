package org.cellgauge.desktop.render;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import boofcv.abst.fiducial.FiducialDetector;
import boofcv.alg.distort.brown.LensDistortionBrown;
import boofcv.factory.fiducial.ConfigFiducialBinary;
import boofcv.factory.fiducial.ConfigFiducialHammingDetector;
import boofcv.factory.fiducial.ConfigHammingMarker;
import boofcv.factory.fiducial.FactoryFiducial;
import boofcv.factory.fiducial.HammingDictionary;
import boofcv.factory.filter.binary.ConfigThreshold;
import boofcv.factory.filter.binary.ThresholdType;
import boofcv.struct.calib.CameraPinholeBrown;
import boofcv.struct.image.GrayU8;
import georegression.struct.se.Se3_F64;
import georegression.struct.shapes.Polygon2D_F64;
import java.util.Arrays;
import java.util.Locale;
import java.util.stream.Stream;
import org.apache.commons.math3.random.Well19937c;
import org.cellgauge.cell.MarkerFamily;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.internal.vision.MarkerPattern;
import org.cellgauge.vision.GreyImage;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

class MarkerPatternTest {
    private static final double SIZE_MM = 100;

    /** But the one that BoofCV has another table of. */
    static Stream<String> families() {
        return Stream.concat(Stream.of("square-binary"), Arrays.stream(HammingDictionary.allPredefined())
                .filter(d -> d != HammingDictionary.ARUCO_OCV_4x4_1000)
                .map(d -> d.name().toLowerCase(Locale.ROOT).replace('_', '-')));
    }

    /** BoofCV's own detector is the judge of what is upright: id, order of the corners and pose must be the truth's. */
    @ParameterizedTest
    @MethodSource("families")
    void detectorReadsIdCornersAndPoseOfEveryFamily(String family) {
        PinholeCamera camera = PinholeCamera.ideal(400, 300, 500, 500, 200, 150);
        RigidTransform worldFromCamera = RigidTransform.ofEuler(60, 80, 480, Math.PI - 0.2, 0.1, 0.1);
        int id = 7;
        RigidTransform worldFromMarker = RigidTransform.ofEuler(0, 0, 0, 0.1, -0.05, 0.3);
        Scene scene = Scene.of(camera, worldFromCamera).backdrop(Backdrop.textured(0.08, 2))
                .marker(family, id, SIZE_MM, worldFromMarker).build();
        GreyImage image = SceneRenderer.render(scene, Sensor.USUAL, new Well19937c(3));
        SceneTruth.MarkerInImage truth = SceneTruth.of(scene).get(0);
        assertTrue(truth.whollyInside());

        FiducialDetector<GrayU8> detector = detector(family, camera);
        GrayU8 grey = new GrayU8(image.widthPx(), image.heightPx());
        System.arraycopy(image.luminance(), 0, grey.data, 0, grey.data.length);
        detector.detect(grey);
        assertEquals(1, detector.totalFound());
        assertEquals(id, detector.getId(0));
        Polygon2D_F64 corners = detector.getBounds(0, null);
        assertNotNull(corners);
        for (int i = 0; i < 4; i++) {
            double[] expected = truth.cornersPx()[i];
            // 0.3 px is far beyond BoofCV's error on such a picture (0.08 px rms) and far below a corner's confusion
            double error = Math.hypot(corners.get(i).x - expected[0], corners.get(i).y - expected[1]);
            assertEquals(0, error, 0.3, "corner " + i);
        }
        Se3_F64 found = new Se3_F64();
        assertTrue(detector.getFiducialToCamera(0, found));
        RigidTransform cameraFromMarker = worldFromCamera.inverse().compose(worldFromMarker);
        RigidTransform detected = RigidTransform.of(found.R.data.clone(),
                new double[] {found.T.x, found.T.y, found.T.z});
        assertEquals(0, detected.angleRadTo(cameraFromMarker), Math.toRadians(3));
        double[] place = cameraFromMarker.translationMm();
        assertEquals(place[0], found.T.x, 2);
        assertEquals(place[1], found.T.y, 2);
        assertEquals(place[2], found.T.z, 5);
    }

    private static FiducialDetector<GrayU8> detector(String family, PinholeCamera camera) {
        FiducialDetector<GrayU8> detector;
        if (family.equals("square-binary")) {
            detector = FactoryFiducial.squareBinary(new ConfigFiducialBinary(SIZE_MM),
                    ConfigThreshold.local(ThresholdType.LOCAL_MEAN, 21), GrayU8.class);
        } else {
            ConfigHammingMarker marker = ConfigHammingMarker.loadDictionary(Arrays
                    .stream(HammingDictionary.allPredefined())
                    .filter(d -> d.name().equalsIgnoreCase(family.replace('-', '_'))).findFirst().orElseThrow());
            marker.targetWidth = SIZE_MM;
            detector = FactoryFiducial.squareHamming(marker, new ConfigFiducialHammingDetector(), GrayU8.class);
        }
        CameraPinholeBrown brown = new CameraPinholeBrown();
        brown.fsetK(camera.get(PinholeCamera.FX), camera.get(PinholeCamera.FY), 0, camera.get(PinholeCamera.CX),
                camera.get(PinholeCamera.CY), camera.widthPx(), camera.heightPx());
        detector.setLensDistortion(new LensDistortionBrown(brown), camera.widthPx(), camera.heightPx());
        return detector;
    }

    @Test
    void idsBeyondTheFamilyAndUnknownFamiliesAreRefused() {
        assertThrows(IllegalArgumentException.class, () -> MarkerPattern.of(MarkerFamily.of("square-binary"), 4096));
        assertThrows(IllegalArgumentException.class, () -> MarkerPattern.of(MarkerFamily.of("apriltag-36h11"), 587));
        assertThrows(IllegalArgumentException.class, () -> MarkerPattern.of(MarkerFamily.of("apriltag-36h11"), -1));
        assertThrows(IllegalArgumentException.class, () -> MarkerPattern.of(MarkerFamily.of("custom"), 0));
    }

    @Test
    void bordersAreBlack() {
        MarkerPattern binary = MarkerPattern.of(MarkerFamily.of("square-binary"), 4095);
        assertEquals(8, binary.cells());
        MarkerPattern tag = MarkerPattern.of(MarkerFamily.of("aruco-ocv-5x5-1000"), 17);
        assertEquals(7, tag.cells());
        for (int i = 0; i < 8; i++) {
            assertTrue(!binary.isWhite(0, i) && !binary.isWhite(1, i) && !binary.isWhite(6, i));
            assertTrue(!binary.isWhite(i, 0) && !binary.isWhite(i, 6) && !binary.isWhite(i, 7));
            assertTrue(i > 6 || !tag.isWhite(0, i) && !tag.isWhite(i, 0) && !tag.isWhite(6, i) && !tag.isWhite(i, 6));
        }
    }
}
