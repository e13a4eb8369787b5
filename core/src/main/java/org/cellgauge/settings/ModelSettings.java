package org.cellgauge.settings;

import java.util.OptionalDouble;

/** What is taken of cell, camera and noise, from which the posterior follows, and what is wanted of it; immutable. */
public final class ModelSettings {
    private final SettingValues values;

    ModelSettings(SettingValues values) {
        this.values = values;
    }

    /**
     * Value of any row of this half, for those without a method of their own.
     *
     * @param setting the row
     * @param <T> type of its values
     * @return the value, never null
     * @throws IllegalArgumentException if the row belongs to the other half
     */
    public <T> T get(Setting<T> setting) {
        return values.get(setting, Setting.Part.MODEL);
    }

    /**
     * Likelihood of the references' corners.
     *
     * @return the likelihood
     */
    public LikelihoodModel likelihood() {
        return values.get(SettingTable.MODEL);
    }

    /**
     * Half extent of corner-cube's box in placement deviations.
     *
     * @return positive
     */
    public double kappa() {
        return values.get(SettingTable.KAPPA);
    }

    /**
     * Which intrinsics are sampled.
     *
     * @return none or the focal lengths
     */
    public Estimate estimate() {
        return values.get(SettingTable.ESTIMATE);
    }

    /**
     * Standard deviation of the prior of the focal length about the camera file's.
     *
     * @return px; +infinity where it is flat
     */
    public double focalPriorStdPx() {
        return values.get(SettingTable.FOCAL_PRIOR_STD_PX);
    }

    /**
     * Standard deviation of the prior of the aspect ratio fy / fx about the camera file's, as a share of it.
     *
     * @return share; +infinity where fx and fy are independent beforehand, each with {@link #focalPriorStdPx()}
     */
    public double aspectPriorStd() {
        return values.get(SettingTable.ASPECT_PRIOR_STD);
    }

    /**
     * What is taken of the noise in an object's own corners.
     *
     * @return detection noise or none
     */
    public ObjectNoise objectNoise() {
        return values.get(SettingTable.OBJECT_NOISE);
    }

    /**
     * Prior over the camera's rotation.
     *
     * @return uniform unless the thesis is followed
     */
    public RotationPrior rotationPrior() {
        return values.get(SettingTable.ROTATION_PRIOR);
    }

    /**
     * Whether a weak prior on the pose may be added where two or fewer references leave directions open.
     *
     * @return true unless the thesis is followed
     */
    public boolean posePriorAllowed() {
        return values.get(SettingTable.POSE_PRIOR_ALLOWED);
    }

    /**
     * Largest standard deviation allowed on any axis of any object and gripping point.
     *
     * @return mm; empty where the cell's own counts
     */
    public OptionalDouble targetStdMm() {
        return values.get(SettingTable.TARGET_STD_MM);
    }
}
