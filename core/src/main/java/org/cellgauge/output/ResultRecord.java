package org.cellgauge.output;

import org.jspecify.annotations.Nullable;

/**
 * What a result is of, and what made it: files by their names and SHA-256 (hexadecimal, null where there was no file),
 * program and date; immutable. With it a result file is a record of its own.
 */
public final class ResultRecord extends Value {
    private final String inputName;
    private final @Nullable String inputSha256;
    private final String version;
    private @Nullable String date;
    private @Nullable String judgedOn;
    private @Nullable String command;
    private @Nullable String cellName;
    private @Nullable String cellSha256;
    private @Nullable String cameraName;
    private @Nullable String cameraSha256;

    private ResultRecord(String inputName, @Nullable String inputSha256, String version) {
        this.inputName = inputName;
        this.inputSha256 = inputSha256;
        this.version = version;
    }

    /**
     * The record of an input.
     *
     * @param inputName name of the photo or detections file, without its folder
     * @param inputSha256 of its bytes; null where the input was no file
     * @param version version of this program
     * @return a record of nothing else
     */
    public static ResultRecord of(String inputName, @Nullable String inputSha256, String version) {
        return new ResultRecord(inputName, inputSha256, version);
    }

    private ResultRecord copy() {
        ResultRecord copy = new ResultRecord(inputName, inputSha256, version);
        copy.date = date;
        copy.judgedOn = judgedOn;
        copy.command = command;
        copy.cellName = cellName;
        copy.cellSha256 = cellSha256;
        copy.cameraName = cameraName;
        copy.cameraSha256 = cameraSha256;
        return copy;
    }

    /**
     * The same with the day of the check.
     *
     * @param day as in {@code 2026-11-28}; the day alone, so that a check repeated on it gives the same bytes
     * @return a new record
     */
    public ResultRecord withDate(@Nullable String day) {
        ResultRecord copy = copy();
        copy.date = day;
        return copy;
    }

    /**
     * The same with the day on which another target was held against it.
     *
     * @param day as in {@code 2026-11-28}
     * @return a new record
     */
    public ResultRecord withJudgedOn(@Nullable String day) {
        ResultRecord copy = copy();
        copy.judgedOn = day;
        return copy;
    }

    /**
     * The same with a command.
     *
     * @param line what makes the same figures again, or null where nothing does
     * @return a new record
     */
    public ResultRecord withCommand(@Nullable String line) {
        ResultRecord copy = copy();
        copy.command = line;
        return copy;
    }

    /**
     * The same with the cell file.
     *
     * @param name its name, without its folder
     * @param sha256 of its bytes
     * @return a new record
     */
    public ResultRecord withCell(@Nullable String name, @Nullable String sha256) {
        ResultRecord copy = copy();
        copy.cellName = name;
        copy.cellSha256 = sha256;
        return copy;
    }

    /**
     * The same with the camera file.
     *
     * @param name its name as the cell file has it; null where that holds the camera itself
     * @param sha256 of its bytes
     * @return a new record
     */
    public ResultRecord withCamera(@Nullable String name, @Nullable String sha256) {
        ResultRecord copy = copy();
        copy.cameraName = name;
        copy.cameraSha256 = sha256;
        return copy;
    }

    /**
     * The photo or detections file.
     *
     * @return its name, without its folder
     */
    public String inputName() {
        return inputName;
    }

    /**
     * Its SHA-256.
     *
     * @return hexadecimal; null where the input was no file
     */
    public @Nullable String inputSha256() {
        return inputSha256;
    }

    /**
     * The program that made the result.
     *
     * @return its version
     */
    public String version() {
        return version;
    }

    /**
     * The day of the check.
     *
     * @return as in {@code 2026-11-28}; null where it is not told
     */
    public @Nullable String date() {
        return date;
    }

    /**
     * The day on which another target was held against it.
     *
     * @return as in {@code 2026-11-28}; null where none was
     */
    public @Nullable String judgedOn() {
        return judgedOn;
    }

    /**
     * What makes the same figures again.
     *
     * @return one line for a shell; null where nothing does
     */
    public @Nullable String command() {
        return command;
    }

    /**
     * The cell file.
     *
     * @return its name, without its folder; null where it is not told
     */
    public @Nullable String cellName() {
        return cellName;
    }

    /**
     * Its SHA-256.
     *
     * @return hexadecimal; null where it is not told
     */
    public @Nullable String cellSha256() {
        return cellSha256;
    }

    /**
     * The camera file.
     *
     * @return its name as the cell file has it; null where there is none
     */
    public @Nullable String cameraName() {
        return cameraName;
    }

    /**
     * Its SHA-256.
     *
     * @return hexadecimal; null where there is none
     */
    public @Nullable String cameraSha256() {
        return cameraSha256;
    }

    @Override
    @Nullable Object[] figures() {
        return new @Nullable Object[] {inputName, inputSha256, version, date, judgedOn, command, cellName, cellSha256,
            cameraName, cameraSha256};
    }
}
