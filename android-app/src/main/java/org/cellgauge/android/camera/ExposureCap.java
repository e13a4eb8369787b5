package org.cellgauge.android.camera;

import android.hardware.camera2.CameraMetadata;

/**
 * How long frames are exposed where the sensor can be told. The device's automatic exposure measures the light; what it
 * exposes longer than a hand is still for is then held at a cap, with as much more sensitivity as that takes. When the
 * markers get darker or brighter, or none was seen for a while, the device measures anew.
 *
 * <p>Knows no camera: it is told what frames report and show, and says what is to be asked for.
 */
final class ExposureCap {
    /**
     * What the sensor takes.
     *
     * @param shortestNs shortest exposure, ns, positive
     * @param longestNs longest exposure, ns
     * @param leastSensitivity least sensitivity, ISO, positive
     * @param mostSensitivity most sensitivity, ISO
     * @param mostBoost most that grey values may be raised besides, percent; 100 where they cannot be
     */
    record Limits(long shortestNs, long longestNs, int leastSensitivity, int mostSensitivity, int mostBoost) {
    }

    /**
     * An exposure that is asked for.
     *
     * @param timeNs for how long, ns
     * @param sensitivity ISO
     * @param boost how much grey values are raised besides, percent
     */
    record Exposure(long timeNs, int sensitivity, int boost) {
    }

    /**
     * The cap: one period of the flicker of lamps on mains of 50 Hz, in which every row of a frame gets the same light.
     * A hand that turns the tablet by 2 degrees in a second moves a picture of 1500 px focal length by half a pixel in
     * it.
     */
    static final long CAP_NS = 10_000_000;
    /** The same where the device sees mains of 60 Hz. */
    static final long CAP_60HZ_NS = 8_333_333;
    /** Devices round. */
    private static final double ROUNDED = 1.05;
    /** So many frames in a row must report that the light is measured. */
    static final int SETTLED_FRAMES = 3;
    /** Where the sensor is not sensitive enough, a picture may get darker than measured by so much, and no more. */
    static final double DARKEST_SHARE = 0.5;
    /** Below this share of the light that was measured as right, it is said that there is too little. */
    static final double ENOUGH_SHARE = 0.8;
    /** How much darker or brighter the markers' white looks in half of the light, and in half as much again. */
    static final double DARKER = 0.75;
    static final double BRIGHTER = 1.2;
    /** White that may be brighter than it looks. */
    static final double CLIPPED_GREY = 250;
    /** So many frames in a row must show it. */
    static final int CHANGED_FRAMES = 5;
    /** Frames exposed as before may still come for so long, ns. */
    static final long ON_THE_WAY_NS = 500_000_000;
    /** From holding an exposure to measuring anew, ns: every measurement has some long exposures. */
    static final long PAUSE_NS = 2_000_000_000;
    /** Without any marker for so long the device measures anew, ns: it may be too dark to see one. */
    static final long BLIND_NS = 3_000_000_000L;
    private static final int PLAIN_BOOST = 100;
    private static final long NEVER = Long.MIN_VALUE;

    private final Limits limits;
    private Exposure held;
    private boolean lightShort;
    private int settledFrames;
    private long heldSinceNs = NEVER;
    private long seenNs;
    private double white;
    private int changedFrames;

    /**
     * A cap before anything was measured.
     *
     * @param limits what the sensor takes; null where it cannot be told, and the device exposes as it likes
     */
    ExposureCap(Limits limits) {
        this.limits = limits;
    }

    /** What is to be asked for; null for the device's automatic exposure. */
    Exposure held() {
        return held;
    }

    /** Whether there is too little light for short exposures: pictures are darker than they should be, or blurred. */
    boolean isLightShort() {
        return lightShort;
    }

    /**
     * A frame reports how it was exposed.
     *
     * @param state one of the {@code CONTROL_AE_STATE} constants; null where the device reports none
     * @param exposureNs for how long; null where it is not reported
     * @param sensitivity ISO; null where it is not reported
     * @param boost how much grey values were raised besides, percent; null for not at all
     * @param flicker one of the {@code STATISTICS_SCENE_FLICKER} constants, or null
     * @return whether something else is to be asked for from now on
     */
    boolean report(Integer state, Long exposureNs, Integer sensitivity, Integer boost, Integer flicker) {
        if (limits == null || held != null) {
            return false;
        }
        // a frame that was exposed by hand reports no such state, so that late ones do not count
        settledFrames = isSettled(state) && exposureNs != null && sensitivity != null ? settledFrames + 1 : 0;
        if (settledFrames < SETTLED_FRAMES) {
            return false;
        }
        long cap = Math.max(limits.shortestNs, flicker != null
                && flicker == CameraMetadata.STATISTICS_SCENE_FLICKER_60HZ ? CAP_60HZ_NS : CAP_NS);
        if (exposureNs <= ROUNDED * cap || cap > limits.longestNs) {
            lightShort = false;
            return false;
        }
        hold(cap, exposureNs, sensitivity * ((boost == null ? PLAIN_BOOST : boost) / (double) PLAIN_BOOST));
        return true;
    }

    private static boolean isSettled(Integer state) {
        return state != null && (state == CameraMetadata.CONTROL_AE_STATE_CONVERGED
                || state == CameraMetadata.CONTROL_AE_STATE_LOCKED
                || state == CameraMetadata.CONTROL_AE_STATE_FLASH_REQUIRED);
    }

    private void hold(long cap, long measuredNs, double measuredSensitivity) {
        double wanted = measuredSensitivity * measuredNs / cap;
        int sensitivity = (int) Math.max(limits.leastSensitivity, Math.min(limits.mostSensitivity, Math.round(wanted)));
        int boost = (int) Math.max(PLAIN_BOOST, Math.min(limits.mostBoost,
                Math.round(PLAIN_BOOST * wanted / sensitivity)));
        double share = sensitivity * (boost / (double) PLAIN_BOOST) / wanted;
        long timeNs = share >= DARKEST_SHARE ? cap
                : Math.min(Math.min(measuredNs, limits.longestNs), Math.round(cap * DARKEST_SHARE / share));
        held = new Exposure(timeNs, sensitivity, boost);
        lightShort = share < ENOUGH_SHARE;
        heldSinceNs = NEVER;
        white = Double.NaN;
        changedFrames = 0;
    }

    /**
     * A frame was looked at.
     *
     * @param whiteGrey grey value of the markers' white, 0 to 255; NaN where no marker was seen
     * @param timeNs of its exposure
     * @return whether something else is to be asked for from now on
     */
    boolean look(double whiteGrey, long timeNs) {
        if (held == null) {
            return false;
        }
        if (heldSinceNs == NEVER) {
            heldSinceNs = timeNs;
            seenNs = timeNs;
        }
        if (Double.isNaN(whiteGrey)) {
            changedFrames = 0;
            return timeNs - seenNs >= BLIND_NS && measureAgain();
        }
        seenNs = timeNs;
        if (timeNs - heldSinceNs < ON_THE_WAY_NS) {
            return false;
        }
        if (Double.isNaN(white)) {
            white = whiteGrey;
            return false;
        }
        boolean changed = whiteGrey < DARKER * white || whiteGrey > BRIGHTER * white
                || whiteGrey >= CLIPPED_GREY && white < CLIPPED_GREY;
        changedFrames = changed ? changedFrames + 1 : 0;
        return changedFrames >= CHANGED_FRAMES && timeNs - heldSinceNs >= PAUSE_NS && measureAgain();
    }

    /**
     * Has the device measure the light, as when a lamp was switched.
     *
     * @return whether something else is to be asked for from now on
     */
    boolean measureAgain() {
        settledFrames = 0;
        boolean was = held != null;
        held = null;
        return was;
    }
}
