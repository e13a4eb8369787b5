package org.cellgauge.output;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.OptionalDouble;
import org.cellgauge.cell.Cell;
import org.cellgauge.cell.ObjectMarker;
import org.cellgauge.cell.Placement;
import org.cellgauge.cell.Reference;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.internal.statistics.Angles;
import org.cellgauge.light.ToneCurve;
import org.jspecify.annotations.Nullable;

/** A cell as a result rests on it; immutable. */
public final class CellView extends Value {
    private final PinholeCamera camera;
    private final String family;
    private final OptionalDouble pixelStdPx;
    private final @Nullable ToneCurve toneCurve;
    private final double sizeStdMm;
    private final double flatnessMm;
    private final double printGainStdMm;
    private final List<StatedReference> references;
    private final List<StatedObject> objects;

    CellView(PinholeCamera camera, String family, OptionalDouble pixelStdPx, @Nullable ToneCurve toneCurve, double
            sizeStdMm, double flatnessMm, double printGainStdMm, List<StatedReference> references, List<StatedObject>
            objects) {
        this.camera = camera;
        this.family = family;
        this.pixelStdPx = pixelStdPx;
        this.toneCurve = toneCurve;
        this.sizeStdMm = Figures.finite(sizeStdMm);
        this.flatnessMm = Figures.finite(flatnessMm);
        this.printGainStdMm = Figures.finite(printGainStdMm);
        this.references = Collections.unmodifiableList(new ArrayList<>(references));
        this.objects = Collections.unmodifiableList(new ArrayList<>(objects));
    }

    /**
     * The view of a cell.
     *
     * @param cell the cell
     * @return what a result file holds of it
     */
    public static CellView of(Cell cell) {
        List<StatedReference> references = new ArrayList<>();
        for (Reference r : cell.references()) {
            double[] rotation = r.worldFromMarker().eulerRad();
            for (int i = 0; i < 3; i++) {
                rotation[i] = Angles.wrapToPi(rotation[i]);
            }
            Placement placement = r.placement();
            references.add(new StatedReference(r.id(), r.sizeMm(), r.worldFromMarker().translationMm(), rotation,
                    new double[] {placement.stdMm(0), placement.stdMm(1), placement.stdMm(2)}, placement.stdRad()));
        }
        List<StatedObject> objects = new ArrayList<>();
        for (ObjectMarker o : cell.objects()) {
            objects.add(new StatedObject(o.id(), o.sizeMm(), o.hasGrip() ? o.gripMm() : null));
        }
        return new CellView(cell.camera(), cell.family().familyName(), cell.pixelStdPx(), cell.toneCurve(),
                cell.prints().sizeStdMm(), cell.prints().flatnessMm(), cell.prints().printGainStdMm(), references,
                objects);
    }

    /**
     * The camera.
     *
     * @return its lens and image size
     */
    public PinholeCamera camera() {
        return camera;
    }

    /**
     * The family of its markers.
     *
     * @return as cell files name it
     */
    public String family() {
        return family;
    }

    /**
     * The stated noise of corner coordinates.
     *
     * @return standard deviation, px; empty where it is learned from the photo
     */
    public OptionalDouble pixelStdPx() {
        return pixelStdPx;
    }

    /**
     * The stated tone curve.
     *
     * @return null where it is estimated
     */
    public @Nullable ToneCurve toneCurve() {
        return toneCurve;
    }

    /**
     * How far printed sizes may be off.
     *
     * @return standard deviation, mm
     */
    public double sizeStdMm() {
        return sizeStdMm;
    }

    /**
     * How far prints may be bent.
     *
     * @return standard deviation, mm
     */
    public double flatnessMm() {
        return flatnessMm;
    }

    /**
     * How far the edges of prints may have moved into the white.
     *
     * @return standard deviation, mm
     */
    public double printGainStdMm() {
        return printGainStdMm;
    }

    /**
     * Its references.
     *
     * @return in its order
     */
    public List<StatedReference> references() {
        return references;
    }

    /**
     * Its objects.
     *
     * @return in its order
     */
    public List<StatedObject> objects() {
        return objects;
    }

    @Override
    @Nullable Object[] figures() {
        return new @Nullable Object[] {camera.widthPx(), camera.heightPx(), camera.lens().modelName(),
            camera.intrinsics(), family, pixelStdPx, toneCurve == null ? null : toneCurve.words(), sizeStdMm,
            flatnessMm, printGainStdMm, references, objects};
    }
}
