package org.cellgauge.cell;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.OptionalDouble;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.light.ToneCurve;
import org.jspecify.annotations.Nullable;

/** A robot cell as its cell file describes it; immutable. References and objects keep the order of the file. */
public final class Cell {
    private final PinholeCamera camera;
    private final MarkerFamily family;
    private final List<Reference> references;
    private final List<ObjectMarker> objects;
    private final OptionalDouble pixelStdPx;
    private final Target target;
    private final @Nullable ToneCurve toneCurve;
    private final @Nullable CameraCalibration calibration;
    private final OptionalDouble focusDistanceM;
    private final PrintPrecision prints;
    private final Planning planning;
    private final JointPlacement joint;

    /**
     * A cell whose markers are printed as usual.
     *
     * @param camera intrinsics of the camera
     * @param family marker family that all markers are of
     * @param references markers with a known place, at least one; ids differ from each other and from the objects'
     * @param objects markers on objects; may be empty
     * @param pixelStdPx standard deviation of each corner coordinate in px, positive; empty: estimate it ("auto")
     * @param targetStdMm largest standard deviation allowed on any axis of any object and gripping point in mm,
     *     positive; empty: no target
     * @throws IllegalArgumentException if there is no reference, an id stands twice or a deviation is not positive
     */
    public Cell(PinholeCamera camera, MarkerFamily family, List<Reference> references, List<ObjectMarker> objects,
            OptionalDouble pixelStdPx, OptionalDouble targetStdMm) {
        this(camera, family, references, objects, pixelStdPx, targetStdMm, PrintPrecision.USUAL);
    }

    /**
     * A cell.
     *
     * @param camera intrinsics of the camera
     * @param family marker family that all markers are of
     * @param references markers with a known place, at least one; ids differ from each other and from the objects'
     * @param objects markers on objects; may be empty
     * @param pixelStdPx standard deviation of each corner coordinate in px, positive; empty: estimate it ("auto")
     * @param targetStdMm largest standard deviation allowed on any axis of any object and gripping point in mm,
     *     positive; empty: no target
     * @param prints how precisely the markers are printed
     * @throws IllegalArgumentException if there is no reference, an id stands twice or a deviation is not positive
     */
    public Cell(PinholeCamera camera, MarkerFamily family, List<Reference> references, List<ObjectMarker> objects,
            OptionalDouble pixelStdPx, OptionalDouble targetStdMm, PrintPrecision prints) {
        this(camera, family, references, objects, pixelStdPx, Target.ofStdMm(targetStdMm), prints, null, null,
                OptionalDouble.empty(), Planning.NONE, JointPlacement.NONE);
    }

    private Cell(PinholeCamera camera, MarkerFamily family, List<Reference> references, List<ObjectMarker> objects,
            OptionalDouble pixelStdPx, Target target, PrintPrecision prints,
            @Nullable ToneCurve toneCurve, @Nullable CameraCalibration calibration, OptionalDouble focusDistanceM,
            Planning planning, JointPlacement joint) {
        if (references.isEmpty()) {
            throw new IllegalArgumentException("a cell needs at least one reference");
        }
        if (pixelStdPx.isPresent() && !(pixelStdPx.getAsDouble() > 0)) {
            throw new IllegalArgumentException("pixel deviation must be positive");
        }
        java.util.Set<Integer> ids = new java.util.HashSet<>();
        references.forEach(r -> addOnce(ids, r.id()));
        objects.forEach(o -> addOnce(ids, o.id()));
        this.camera = camera;
        this.family = family;
        this.references = Collections.unmodifiableList(new ArrayList<>(references));
        this.objects = Collections.unmodifiableList(new ArrayList<>(objects));
        this.pixelStdPx = pixelStdPx;
        this.target = target;
        this.toneCurve = toneCurve;
        this.calibration = calibration;
        this.focusDistanceM = focusDistanceM;
        this.prints = prints;
        this.planning = planning;
        this.joint = joint;
    }

    private static void addOnce(java.util.Set<Integer> ids, int id) {
        if (!ids.add(id)) {
            throw new IllegalArgumentException("marker " + id + " stands twice in the cell");
        }
    }

    /**
     * The same cell seen by another camera, which counts as exact: what is known of the calibration of this one says
     * nothing of that of another.
     *
     * @param other intrinsics and image size
     * @return a new cell
     */
    public Cell withCamera(PinholeCamera other) {
        return new Cell(other, family, references, objects, pixelStdPx, target, prints, toneCurve, null,
                OptionalDouble.empty(), planning, joint);
    }

    /**
     * The same cell where the images of its camera are delivered in another size: all of the image, binned or scaled.
     * Camera and calibration scale along; a stated deviation of corners stays, since it is of the images there are.
     *
     * @param widthPx width of the images
     * @param heightPx height of the images
     * @return a new cell
     * @throws IllegalArgumentException if a size is not positive, or the shape is another, so that it cannot be the
     *     whole image
     */
    public Cell scaledTo(int widthPx, int heightPx) {
        if (!camera.hasShape(widthPx, heightPx)) {
            throw new IllegalArgumentException(widthPx + " x " + heightPx + " px is of another shape than "
                    + camera.widthPx() + " x " + camera.heightPx() + " px");
        }
        return withCamera(camera.resized(widthPx, heightPx)).withFocusDistanceM(focusDistanceM).withCalibration(
                calibration == null ? null : calibration.scaled(widthPx / (double) camera.widthPx()));
    }

    /**
     * The same cell with other references.
     *
     * @param others markers with a known place, at least one
     * @return a new cell
     * @throws IllegalArgumentException if there is none, or an id stands twice in the cell then
     */
    public Cell withReferences(List<Reference> others) {
        return new Cell(camera, family, others, objects, pixelStdPx, target, prints, toneCurve, calibration,
                focusDistanceM, planning, joint);
    }

    /**
     * The same cell with other objects.
     *
     * @param others markers on objects; may be empty
     * @return a new cell
     * @throws IllegalArgumentException if an id stands twice in the cell then
     */
    public Cell withObjects(List<ObjectMarker> others) {
        return new Cell(camera, family, references, others, pixelStdPx, target, prints, toneCurve, calibration,
                focusDistanceM, planning, joint);
    }

    /**
     * The same cell with one standard deviation as its target.
     *
     * @param stdMm largest allowed standard deviation of any axis of any object, mm, positive, or empty for no target
     * @return a new cell
     * @throws IllegalArgumentException if the target is not positive
     */
    public Cell withTarget(OptionalDouble stdMm) {
        return withTarget(Target.ofStdMm(stdMm));
    }

    /**
     * The same cell with another target.
     *
     * @param other what is asked of its objects
     * @return a new cell
     */
    public Cell withTarget(Target other) {
        return new Cell(camera, family, references, objects, pixelStdPx, other, prints, toneCurve, calibration,
                focusDistanceM, planning, joint);
    }

    /**
     * The same cell with another deviation of the corners.
     *
     * @param px standard deviation of each corner coordinate, px, positive; empty where the photo is to tell it
     * @return a new cell
     * @throws IllegalArgumentException if the deviation is not positive
     */
    public Cell withPixelStdPx(OptionalDouble px) {
        return new Cell(camera, family, references, objects, px, target, prints, toneCurve, calibration,
                focusDistanceM, planning, joint);
    }

    /**
     * The same cell with another statement about the camera's tone curve.
     *
     * @param stated how the camera makes grey values of light, or null: to be estimated from each photo ("auto")
     * @return a new cell
     */
    public Cell withToneCurve(@Nullable ToneCurve stated) {
        return new Cell(camera, family, references, objects, pixelStdPx, target, prints, stated, calibration,
                focusDistanceM, planning, joint);
    }

    /**
     * The same cell with another statement about how well its camera's intrinsics are known.
     *
     * @param stated what its calibration leaves open; null where the intrinsics count as exact
     * @return a new cell
     * @throws IllegalArgumentException if the camera's lens has no parameter of one of its names
     */
    public Cell withCalibration(@Nullable CameraCalibration stated) {
        if (stated != null) {
            stated.indices(camera.lens());
        }
        return new Cell(camera, family, references, objects, pixelStdPx, target, prints, toneCurve, stated,
                focusDistanceM, planning, joint);
    }

    /**
     * The same cell with another statement about how the lens was focused when its camera was calibrated. No figure
     * depends on it: it is for whoever can focus a lens.
     *
     * @param stated distance in m, positive; empty where it is not known
     * @return a new cell
     * @throws IllegalArgumentException if the distance is not positive
     */
    public Cell withFocusDistanceM(OptionalDouble stated) {
        if (stated.isPresent() && !(stated.getAsDouble() > 0)) {
            throw new IllegalArgumentException("a lens is focused at a positive distance");
        }
        return new Cell(camera, family, references, objects, pixelStdPx, target, prints, toneCurve, calibration,
                stated, planning, joint);
    }

    /**
     * The same cell with something else said for planning.
     *
     * @param other where things may be and what changes cost
     * @return a new cell
     */
    public Cell withPlanning(Planning other) {
        return new Cell(camera, family, references, objects, pixelStdPx, target, prints, toneCurve, calibration,
                focusDistanceM, other, joint);
    }

    /**
     * What is said for planning alone.
     *
     * @return {@link Planning#NONE} where nothing is
     */
    public Planning planning() {
        return planning;
    }

    /**
     * The same cell with another statement about what is known of references together.
     *
     * @param stated groups, measurements, an earlier survey
     * @return a new cell
     * @throws IllegalArgumentException if it names a reference that the cell has not, or one in two groups
     */
    public Cell withJointPlacement(JointPlacement stated) {
        java.util.Set<Integer> ids = new java.util.HashSet<>();
        references.forEach(r -> ids.add(r.id()));
        java.util.Set<Integer> grouped = new java.util.HashSet<>();
        stated.groups().forEach(group -> group.members().forEach(id -> {
            requireReference(ids, id);
            addOnce(grouped, id);
        }));
        stated.measurements().forEach(m -> m.members().forEach(id -> requireReference(ids, id)));
        return new Cell(camera, family, references, objects, pixelStdPx, target, prints, toneCurve, calibration,
                focusDistanceM, planning, stated);
    }

    private static void requireReference(java.util.Set<Integer> ids, int id) {
        if (!ids.contains(id)) {
            throw new IllegalArgumentException("marker " + id + " is no reference of the cell");
        }
    }

    /**
     * What is known of references together.
     *
     * @return groups, measurements, an earlier survey
     */
    public JointPlacement joint() {
        return joint;
    }

    /**
     * How well the camera's intrinsics are known.
     *
     * @return what their calibration leaves open; null where they count as exact
     */
    public @Nullable CameraCalibration calibration() {
        return calibration;
    }

    /**
     * The distance that the camera's lens was focused at when it was calibrated: a lens that focuses elsewhere has
     * another focal length.
     *
     * @return m; empty where that is not known
     */
    public OptionalDouble focusDistanceM() {
        return focusDistanceM;
    }

    /**
     * The camera.
     *
     * @return intrinsics and image size
     */
    public PinholeCamera camera() {
        return camera;
    }

    /**
     * The marker family.
     *
     * @return the family that all ids belong to
     */
    public MarkerFamily family() {
        return family;
    }

    /**
     * Markers with a known place.
     *
     * @return unmodifiable, in the order of the file, not empty
     */
    public List<Reference> references() {
        return references;
    }

    /**
     * Markers on objects.
     *
     * @return unmodifiable, in the order of the file
     */
    public List<ObjectMarker> objects() {
        return objects;
    }

    /**
     * How precisely the markers are printed.
     *
     * @return deviations of size, flatness and spreading ink
     */
    public PrintPrecision prints() {
        return prints;
    }

    /**
     * Standard deviation of each corner coordinate.
     *
     * @return px, or empty where it is unknown and learned from the photo
     */
    public OptionalDouble pixelStdPx() {
        return pixelStdPx;
    }

    /**
     * What is asked of the objects.
     *
     * @return the target; {@link Target#NONE} where none is set
     */
    public Target target() {
        return target;
    }

    /**
     * The target as one standard deviation.
     *
     * @return as {@link Target#oneStdMm()}
     */
    public OptionalDouble targetStdMm() {
        return target.oneStdMm();
    }

    /**
     * How the camera makes grey values of light, as the cell file or the camera file states it.
     *
     * @return the stated curve, or null where it is to be estimated from each photo ("auto")
     */
    public @Nullable ToneCurve toneCurve() {
        return toneCurve;
    }
}
