package org.cellgauge.fuzz;

import java.awt.color.ColorSpace;
import java.awt.color.ICC_Profile;
import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Base64;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.SplittableRandom;
import java.util.TreeMap;
import java.util.stream.Stream;
import java.util.zip.CRC32;
import javax.imageio.ImageIO;
import org.cellgauge.cell.Cell;
import org.cellgauge.cell.CellReader;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.internal.geometry.MarkerGeometry;

/** Small inputs without a fault. */
final class Scenes {
    /** Stands between the two files of a check; no number in it. */
    static final String BETWEEN = "\n=== corners ===\n";

    /** Of a survey what {@code --against} reads: one reference and a camera. */
    static final String SURVEY = survey();

    static final String FISHEYE = """
            model: kannala_brandt
            pinhole: {fx: 400, fy: 400, cx: 640, cy: 480, width: 1280, height: 960, skew: 0}
            symmetric: [1, -0.01, 0.002]
            """;
    /** Camera files that OpenCV and mrcal wrote. */
    static final String CAMERAS = "core/src/test/resources/org/cellgauge/cell/cameras/";
    private static final List<String> OTHER_CAMERAS = List.of("""
            image_width: 1280
            image_height: 720
            camera_matrix: {rows: 3, cols: 3, data: [581.25, 0.0, 640.125, 0.0, 582.5, 359.75, 0.0, 0.0, 1.0]}
            distortion_model: rational_polynomial
            distortion_coefficients: {rows: 1, cols: 8, data: [0.52, -2.4, 9e-04, -3e-4, 1.5, 0.4, -2.3, 1.42]}
            """, """
            cam0:
              camera_model: pinhole
              distortion_coeffs: [-0.012, 0.006, -0.004, 0.0005]
              distortion_model: equidistant
              intrinsics: [581.25, 582.5, 640.125, 359.75]
              resolution: [1280, 720]
            """, """
            {\t"resolution": {"width": 1280.0, "height": 720.0}, "cameraIntrinsics": {"rows": 3, "cols": 3,
            "data": [581.25, 0, 640.125, 0, 582.5, 359.75, 0, 0, 1]},
            "observations": [{"snapshotData": "AbC/+", "c": [{}]}],
            "distCoeffs": {"rows": 1, "cols": 5, "data": [-0.28, 0.09, 0.001, -0.0005, -0.01]},
            "lensmodel": "LENSMODEL_OPENCV"}
            """, """
            {"width": 1280, "height": 720, "ppx": 640.125, "ppy": 359.75, "fx": 581.25, "fy": 582.5,
            "model": "Brown Conrady", "coeffs": [-0.28, 0.09, 0.001, -0.0005, -0.01]}
            """, """
            {'lensmodel': 'LENSMODEL_OPENCV5', # as fitted
            'intrinsics': [581.25, 582.5, 640.125, 359.75, -0.28, 0.09, 0.001, -0.0005, -0.01,],
            'imagersize': [1280, 720,], 'optimization_inputs': b'P)h>@6aWAK{,]:'}
            """);
    static final String PRECISE_DETECTIONS = """
            {"image": {"width": 1280, "height": 720, "name": "a.png"},
             "light": {"tone_curve": "gamma 2.2", "edge_shift_std_px": 0.1, "blur_px": 0.7, "noise_grey": 2},
             "markers": [{"id": 944, "corners_px": [[700, 150.5], [730, 150], [730.25, 180], [700, 180]],
               "covariance_px2": [[1,0,0,0,0,0,0,0],[0,1,0,0,0,0,0,0],[0,0,1,0,0,0,0,0],[0,0,0,1,0,0,0,0],
                 [0,0,0,0,1,0,0,0],[0,0,0,0,0,1,0,0],[0,0,0,0,0,0,1,0],[0,0,0,0,0,0,0,1]],
               "edge_shift": {"px": 0.1, "variance_px2": 0.01, "covariance_with_corners_px2": [0,0,0,0,0,0,0,0]}}]}
            """;
    /** Written by Pillow: Java has no encoder. */
    private static final String WEBP = "UklGRigAAABXRUJQVlA4TBsAAAAvC8AAAM1lRP8Dato2YHr3Ln+4E0FETADk8gIA";

    /** Length of a PNG's signature and its first chunk. */
    private static final int PNG_HEADER = 33;
    /** Place of the first JPEG among the images: the first format comes in all types. */
    private static final int JPEG_AT = 5;

    private Scenes() {
    }

    /** The cell file of a fixture with its camera written into it. */
    static String cellWithCamera(Path root, String scene) throws IOException {
        Path folder = root.resolve("fixtures").resolve(scene);
        String camera = Files.readString(folder.resolve("camera.yaml")).replaceAll("(?m)^#.*\n", "")
                .replaceAll("(?m)^", "  ").stripTrailing();
        return Files.readString(folder.resolve("cell.yaml")).replace("camera: camera.yaml", "camera:\n" + camera);
    }

    /** The same cell with references that a calibration may rest on. */
    static String surveyed(Path root) throws IOException {
        return cellWithCamera(root, "lifted-4").replaceFirst("(?m)^placement:.*",
                "placement: {std_mm: [0.1, 0.1, 0.1], std_deg: 0.05}");
    }

    /** A target file of each kind; one rests on a cell file beside it. */
    static List<byte[]> targets(String cellFile) {
        Stream<String> ofBoofCv = Stream.of("CIRCLE_HEX\n  grid: {numRows: 8, numCols: 10, shapeSize: 20,"
                + " shapeDistance: 40}\n", "ECOCHECK\n  ecocheck: {markerShapes: [{numRows: 10, numCols: 7,"
                + " squareSize: 30}]}\n").map(kind -> "boofcv.alg.fiducial.calib.ConfigCalibrationTarget:\n  type: "
                + kind);
        Stream<String> own = Stream.of("ecocheck: {rows: 10, columns: 7, square_mm: 30}",
                "hexagonal_circle_grid: {rows: 8, columns: 10, diameter_mm: 20, spacing_mm: 40}",
                "charuco: {rows: 8, columns: 11, square_mm: 24, marker_mm: 18, family: aruco-mip-36h12}",
                "marker_plate: {family: apriltag-36h11, size_mm: 40, positions_mm: {0: [0, 0], 1: [60, 0]}}",
                "cell: {file: " + cellFile + "}").map(kind -> "cellgauge_target: 1\n" + kind + "\n");
        return Stream.concat(own, ofBoofCv).map(text -> text.getBytes(StandardCharsets.UTF_8)).toList();
    }

    /** Camera files of other programs, but for XML. */
    static List<byte[]> cameras(Path root) throws IOException {
        List<byte[]> cameras = new ArrayList<>();
        for (String text : OTHER_CAMERAS) {
            cameras.add(text.getBytes(StandardCharsets.UTF_8));
        }
        for (String name : List.of("opencv-14.yml", "opencv-8.json", "opencv-fisheye.yml", "mrcal-12.cameramodel")) {
            cameras.add(Files.readAllBytes(root.resolve(CAMERAS + name)));
        }
        return cameras;
    }

    static Cell cell(Path root, String scene) throws IOException {
        return CellReader.read(root.resolve("fixtures").resolve(scene).resolve("cell.yaml"));
    }

    /** Corners of the cell {@code lifted-4}, three tenths of a pixel of noise on them. */
    static String detections() {
        PinholeCamera camera = PinholeCamera.ideal(1280, 720, 581, 581, 640, 360);
        RigidTransform cameraFromWorld = RigidTransform.ofEuler(418, 106, 1070, 3.08, 0.10, 0.02).inverse();
        Map<Integer, RigidTransform> markers = new TreeMap<>(Map.of(944, RigidTransform.ofEuler(492, 380, 0, 0, 0, 0),
                1234, RigidTransform.ofEuler(0, 380, 0, 0, 0, 0), 911, RigidTransform.ofEuler(492, 0, 0, 0, 0, 0),
                22, RigidTransform.ofEuler(0, 0, 0, 0, 0, 0), 5, RigidTransform.ofEuler(370, 295, 0, 0, 0, 0.35),
                20, RigidTransform.ofEuler(240, -44, 60, 0.3, 0, 2.29)));
        SplittableRandom random = new SplittableRandom(7);
        List<String> found = new ArrayList<>();
        markers.forEach((id, pose) -> {
            double[] px = MarkerGeometry.cornersPx(camera, cameraFromWorld.compose(pose), 47);
            List<String> corners = new ArrayList<>();
            for (int k = 0; k < 8; k += 2) {
                corners.add(String.format(Locale.ROOT, "[%.3f, %.3f]", px[k] + 0.3 * random.nextGaussian(),
                        px[k + 1] + 0.3 * random.nextGaussian()));
            }
            found.add("{\"id\": " + id + ", \"corners_px\": [" + String.join(", ", corners) + "]}");
        });
        return "{\"image\": {\"width\": 1280, \"height\": 720, \"name\": \"a.png\"}, \"markers\": ["
                + String.join(",\n", found) + "]}";
    }

    /** One small image of each format, and of each way to store it. */
    static List<byte[]> images() throws IOException {
        List<byte[]> images = new ArrayList<>();
        int[] types = {BufferedImage.TYPE_BYTE_GRAY, BufferedImage.TYPE_3BYTE_BGR, BufferedImage.TYPE_BYTE_INDEXED,
            BufferedImage.TYPE_USHORT_GRAY, BufferedImage.TYPE_4BYTE_ABGR};
        for (String format : new String[] {"png", "jpg", "bmp", "gif", "tiff"}) {
            for (int type : types) {
                BufferedImage image = new BufferedImage(24, 16, type);
                for (int i = 0; i < 24 * 16; i++) {
                    image.setRGB(i % 24, i / 24, 0xFF000000 | i * 0x051309 & 0xFFFFFF);
                }
                ByteArrayOutputStream out = new ByteArrayOutputStream();
                if (ImageIO.write(image, format, out)) {
                    images.add(out.toByteArray());
                }
            }
        }
        // notes that are read beside the pixels: a colour profile, a gamma
        byte[] profile = ICC_Profile.getInstance(ColorSpace.CS_LINEAR_RGB).getData();
        byte[] begin = "ICC_PROFILE\0\1\1".getBytes(StandardCharsets.ISO_8859_1);
        images.add(inserted(images.get(JPEG_AT), 2, ByteBuffer.allocate(4 + begin.length + profile.length)
                .putShort((short) 0xFFE2).putShort((short) (2 + begin.length + profile.length)).put(begin).put(profile)
                .array()));
        byte[] gamma = ByteBuffer.allocate(16).putInt(4).put("gAMA".getBytes(StandardCharsets.ISO_8859_1)).putInt(45455)
                .array();
        CRC32 checksum = new CRC32();
        checksum.update(gamma, 4, 8);
        images.add(inserted(images.get(0), PNG_HEADER, ByteBuffer.wrap(gamma).putInt(12, (int) checksum.getValue())
                .array()));
        images.add(Base64.getDecoder().decode(WEBP));
        images.add("P2 3 2 # text\n 9\n0 1 2 7 8 9".getBytes(StandardCharsets.US_ASCII));
        images.add("P6\n2 1\n1023\n\u0001\u0002\u0003\u0000\u0001\u0001\u0001\u0001\u0002\u0002\u0003\u0003".getBytes(
                StandardCharsets.US_ASCII));
        return images;
    }

    private static byte[] inserted(byte[] file, int at, byte[] part) {
        return ByteBuffer.allocate(file.length + part.length).put(file, 0, at).put(part)
                .put(file, at, file.length - at).array();
    }

    private static String survey() {
        StringBuilder rows = new StringBuilder();
        for (int i = 0; i < 12; i++) {
            rows.append(i == 0 ? "[" : ", [");
            for (int j = 0; j < 12; j++) {
                rows.append(j == 0 ? "" : ", ").append(i != j ? "0" : i % 6 < 3 ? "0.25" : "0.0001");
            }
            rows.append(']');
        }
        String rotation = ", \"rotation\": [1, 0, 0, 0, 1, 0, 0, 0, 1]}";
        return "{\"schema\": 1, \"epoch\": {\"bodies\": [{\"kind\": \"reference\", \"id\": 22, "
                + "\"position_mm\": [1, 2, 3]" + rotation + ", {\"kind\": \"camera\", \"id\": 0, "
                + "\"position_mm\": [0, 0, 900]" + rotation + "], \"covariance\": [" + rows + "]}}";
    }
}
