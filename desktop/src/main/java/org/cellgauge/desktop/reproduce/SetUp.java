package org.cellgauge.desktop.reproduce;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.stream.Collectors;
import org.apache.commons.math3.random.RandomGenerator;
import org.apache.commons.math3.random.Well19937c;
import org.cellgauge.cell.Cell;
import org.cellgauge.cell.MarkerFamily;
import org.cellgauge.cell.ObjectMarker;
import org.cellgauge.cell.Reference;
import org.cellgauge.desktop.render.CellSimulation;
import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.internal.geometry.MarkerGeometry;
import org.cellgauge.settings.Estimate;
import org.cellgauge.vision.BoofMarkerDetector;
import org.cellgauge.vision.Detections;
import org.cellgauge.vision.MarkerObservation;

/**
 * One experiment of the thesis: what stands before the camera, and how precisely; immutable.
 *
 * @param name as tables refer to it
 * @param references names of the references
 * @param stdMm measurement deviation of their places along each axis, mm
 * @param objects name of the objects' poses
 * @param cameraPose name of the camera's pose
 * @param estimate whether the focal lengths are explored
 * @param ransac whether the chain starts where RANSAC sees the camera
 */
record SetUp(String name, List<String> references, double stdMm, String objects, String cameraPose, Estimate estimate,
        boolean ransac) {
    private static final double TEXTURE_CONTRAST = 0.08;
    private static final double QUIET_ZONE = 0.2;

    /** All of the file, by name. */
    static Map<String, SetUp> all() {
        DataNode file = DataNode.ofResource("setups.yaml");
        Map<String, SetUp> all = new LinkedHashMap<>();
        for (String name : file.keys()) {
            DataNode data = file.at(name);
            all.put(name, new SetUp(name, data.at("references").texts(), data.at("std_mm").number(),
                    data.at("objects").text(), data.has("camera_pose") ? data.at("camera_pose").text() : "usual",
                    data.has("estimate") ? Estimate.FOCAL : Estimate.NONE, data.has("initial")));
        }
        return all;
    }

    /** The same under another name, with other references. */
    SetUp with(String otherName, List<String> otherReferences) {
        return new SetUp(otherName, otherReferences, stdMm, objects, cameraPose, estimate, ransac);
    }

    /** The same placed to another deviation. */
    SetUp placedTo(double otherStdMm) {
        return new SetUp(name + "-" + Words.number(otherStdMm), references, otherStdMm, objects, cameraPose, estimate,
                ransac);
    }

    /** The same with other intrinsics explored. */
    SetUp exploring(Estimate other) {
        return new SetUp(name + "-" + other.word(), references, stdMm, objects, cameraPose, other, ransac);
    }

    boolean focal() {
        return estimate != Estimate.NONE;
    }

    boolean raised() {
        return references.stream().anyMatch(r -> r.endsWith("raised"));
    }

    /** In words, as in {@code 3 references, one raised, 20 mm}. */
    String words() {
        return references.size() + " references" + (raised() ? ", one raised" : "") + ", " + Words.number(stdMm) + " mm"
                + (focal() ? ", focal length explored" : "") + (ransac ? ", RANSAC" : "");
    }

    /** What is in the photo, as a check is told of it. */
    Cell cell(Assumptions assumptions) {
        List<ObjectMarker> objectMarkers = assumptions.objects(objects).keySet().stream()
                .map(id -> new ObjectMarker(id, assumptions.sizeMm(), null)).collect(Collectors.toList());
        return new Cell(assumptions.camera(), MarkerFamily.SQUARE_BINARY, assumptions.references(references, stdMm),
                objectMarkers, assumptions.pixelStdPx(), OptionalDouble.empty());
    }

    /** The photo, rendered. */
    CellSimulation.Photo photo(Assumptions assumptions) {
        return new CellSimulation(cell(assumptions), assumptions.worldFromCamera(cameraPose),
                assumptions.objects(objects), new CellSimulation.Settings(assumptions.photoSeed(),
                        assumptions.placementErrors(), 0, 0, TEXTURE_CONTRAST, QUIET_ZONE))
                .photo(0, assumptions.sensor());
    }

    /**
     * The corners that a check rests on: detected in the rendered photo, or exactly where they are.
     *
     * @throws IllegalStateException if not all markers are seen
     */
    Detections detections(Assumptions assumptions) {
        Cell cell = cell(assumptions);
        if (!assumptions.rendered()) {
            return exact(cell, assumptions.worldFromCamera(cameraPose), assumptions.objects(objects), Map.of());
        }
        Detections seen = BoofMarkerDetector.forCell(cell).detect(photo(assumptions).image(), name);
        if (seen.markers().size() != cell.references().size() + cell.objects().size()) {
            throw new IllegalStateException("not all markers of " + name + " are seen");
        }
        return seen;
    }

    /**
     * Corners where a camera sees them.
     *
     * @param cell references at their stated places, and objects
     * @param worldFromCamera true pose
     * @param objects true poses, by id
     * @param misplaced true poses of references that are not where they are stated to be, by id
     */
    static Detections exact(Cell cell, RigidTransform worldFromCamera, Map<Integer, RigidTransform> objects,
            Map<Integer, RigidTransform> misplaced) {
        RigidTransform cameraFromWorld = worldFromCamera.inverse();
        List<MarkerObservation> seen = new ArrayList<>();
        for (Reference reference : cell.references()) {
            RigidTransform pose = misplaced.getOrDefault(reference.id(), reference.worldFromMarker());
            seen.add(observed(cell, reference.id(), cameraFromWorld.compose(pose), reference.sizeMm()));
        }
        for (ObjectMarker object : cell.objects()) {
            seen.add(observed(cell, object.id(), cameraFromWorld.compose(objects.get(object.id())), object.sizeMm()));
        }
        return new Detections("exact corners", cell.camera().widthPx(), cell.camera().heightPx(), seen);
    }

    /** References that stand off their places by a draw of what is stated, with noise; objects seen without. */
    static Detections drawn(Cell cell, RigidTransform worldFromCamera, Map<Integer, RigidTransform> objects,
            long seed) {
        RandomGenerator random = new Well19937c(seed);
        Map<Integer, RigidTransform> misplaced = new LinkedHashMap<>();
        cell.references().forEach(reference -> misplaced.put(reference.id(), reference.drawn(random)));
        List<MarkerObservation> noisy = new ArrayList<>();
        for (MarkerObservation marker : exact(cell, worldFromCamera, objects, misplaced).markers()) {
            double[] px = marker.cornersPx();
            for (int i = 0; i < px.length && misplaced.containsKey(marker.id()); i++) {
                px[i] += cell.pixelStdPx().orElse(0) * random.nextGaussian();
            }
            noisy.add(new MarkerObservation(marker.id(), px));
        }
        return new Detections("drawn corners", cell.camera().widthPx(), cell.camera().heightPx(), noisy);
    }

    private static MarkerObservation observed(Cell cell, int id, RigidTransform cameraFromMarker, double sizeMm) {
        double[] px = MarkerGeometry.seenPx(cell.camera(), cameraFromMarker, sizeMm);
        if (px == null) {
            throw new IllegalStateException("marker " + id + " is not in the image");
        }
        return new MarkerObservation(id, px);
    }
}
