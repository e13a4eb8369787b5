package org.cellgauge.internal.validation;

import org.cellgauge.settings.CheckSettings;

/** How many cells are simulated, with what noise, and how each is checked; immutable. */
public final class ValidationSettings {
    private final int simulations;
    private final CheckSettings check;
    private final double pixelStdPx;
    private final int threads;
    private final int calibrationPhotos;

    /**
     * Settings.
     *
     * @param simulations number of simulated cells, at least 1
     * @param check how each is checked; its seed is that of the whole validation, its number of threads does not count
     * @param pixelStdPx standard deviation of the noise put on corners, px, positive
     * @param threads number of cells checked at a time, at least 1; no figure depends on it
     * @throws IllegalArgumentException if a value is out of range
     */
    public ValidationSettings(int simulations, CheckSettings check, double pixelStdPx, int threads) {
        this(simulations, check, pixelStdPx, threads, 0);
    }

    private ValidationSettings(int simulations, CheckSettings check, double pixelStdPx, int threads,
            int calibrationPhotos) {
        if (simulations < 1 || simulations > 1_000_000) {
            throw new IllegalArgumentException("simulations must be between 1 and 1000000, not " + simulations);
        }
        if (!(pixelStdPx > 0 && Double.isFinite(pixelStdPx))) {
            throw new IllegalArgumentException("corner noise must be positive, not " + pixelStdPx);
        }
        if (threads < 1) {
            throw new IllegalArgumentException("threads must be at least 1");
        }
        this.simulations = simulations;
        this.check = check;
        this.pixelStdPx = pixelStdPx;
        this.threads = threads;
        this.calibrationPhotos = calibrationPhotos;
    }

    /**
     * The same with the camera of every cell calibrated anew.
     *
     * @param photos simulated photos of a board that a calibration takes; 0 for none, the camera being that of the cell
     * @return other settings
     */
    public ValidationSettings calibrating(int photos) {
        return new ValidationSettings(simulations, check, pixelStdPx, threads, photos);
    }

    /**
     * How many simulated photos of a board the camera of every cell is calibrated from.
     *
     * @return 0 where the check gets the camera of the cell
     */
    public int calibrationPhotos() {
        return calibrationPhotos;
    }

    /**
     * Number of simulated cells.
     *
     * @return at least 1
     */
    public int simulations() {
        return simulations;
    }

    /**
     * How each is checked.
     *
     * @return settings, with the seed of the whole validation
     */
    public CheckSettings check() {
        return check;
    }

    /**
     * Noise put on corners.
     *
     * @return standard deviation, px
     */
    public double pixelStdPx() {
        return pixelStdPx;
    }

    /**
     * Number of cells checked at a time.
     *
     * @return at least 1
     */
    public int threads() {
        return threads;
    }
}
