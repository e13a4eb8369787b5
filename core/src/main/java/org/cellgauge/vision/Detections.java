package org.cellgauge.vision;

import java.util.ArrayList;
import java.util.Collections;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.cellgauge.warning.Warning;
import org.jspecify.annotations.Nullable;

/** All markers seen in one image, with the image's name and size and what the detector has to say; immutable. */
public final class Detections {
    private final String imageName;
    private final int widthPx;
    private final int heightPx;
    private final List<MarkerObservation> markers;
    private final Map<Integer, MarkerObservation> byId = new HashMap<>();
    private final List<Warning> warnings;
    private final @Nullable PhotoLight light;

    /**
     * Detections of one image without warnings.
     *
     * @param imageName name of the image for messages and results
     * @param widthPx image width
     * @param heightPx image height
     * @param markers one observation per marker id
     */
    public Detections(String imageName, int widthPx, int heightPx, List<MarkerObservation> markers) {
        this(imageName, widthPx, heightPx, markers, Collections.emptyList());
    }

    /**
     * Detections of one image.
     *
     * @param imageName name of the image for messages and results
     * @param widthPx image width
     * @param heightPx image height
     * @param markers one observation per marker id
     * @param warnings for the user
     */
    public Detections(String imageName, int widthPx, int heightPx, List<MarkerObservation> markers,
            List<Warning> warnings) {
        this(imageName, widthPx, heightPx, markers, warnings, null);
    }

    /**
     * Detections of one image with what was found out about its light.
     *
     * @param imageName name of the image for messages and results
     * @param widthPx image width
     * @param heightPx image height
     * @param markers one observation per marker id
     * @param warnings for the user
     * @param light tone curve, blur and noise; null where corners came without an image
     */
    public Detections(String imageName, int widthPx, int heightPx, List<MarkerObservation> markers,
            List<Warning> warnings, @Nullable PhotoLight light) {
        this.imageName = imageName;
        this.widthPx = widthPx;
        this.heightPx = heightPx;
        this.markers = Collections.unmodifiableList(new ArrayList<>(markers));
        // of two of one marker the first
        this.markers.forEach(marker -> byId.putIfAbsent(marker.id(), marker));
        this.warnings = Collections.unmodifiableList(new ArrayList<>(warnings));
        this.light = light;
    }

    /**
     * Name of the image.
     *
     * @return for messages and results
     */
    public String imageName() {
        return imageName;
    }

    /**
     * Image width.
     *
     * @return px
     */
    public int widthPx() {
        return widthPx;
    }

    /**
     * Image height.
     *
     * @return px
     */
    public int heightPx() {
        return heightPx;
    }

    /**
     * The markers.
     *
     * @return unmodifiable
     */
    public List<MarkerObservation> markers() {
        return markers;
    }

    /**
     * What was left out and why, and what is doubtful about what was found.
     *
     * @return unmodifiable; empty where there is nothing to say
     */
    public List<Warning> warnings() {
        return warnings;
    }

    /**
     * What was found out about the photo's light.
     *
     * @return tone curve, blur and noise; null where corners came without an image
     */
    public @Nullable PhotoLight light() {
        return light;
    }

    /**
     * The observation of one marker.
     *
     * @param id marker id
     * @return its observation, or null where it was not seen
     */
    public @Nullable MarkerObservation find(int id) {
        return byId.get(id);
    }
}
