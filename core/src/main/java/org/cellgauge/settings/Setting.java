package org.cellgauge.settings;

import java.util.Objects;
import java.util.function.Predicate;
import org.jspecify.annotations.Nullable;

/**
 * One setting: a row of {@link SettingTable}; immutable. It says how the setting is named, written, read, limited and
 * explained; what it does stands where its value is asked for.
 *
 * @param <T> type of its values
 */
public final class Setting<T> {
    /** Which half of the settings one belongs to. */
    enum Part {
        /** What is taken of cell, camera and noise. */
        MODEL,
        /** How the posterior of that model is sampled. */
        SAMPLING
    }

    private final Part part;
    private final String key;
    private final String name;
    private final String unit;
    private final SettingForm<T> form;
    private final T usual;
    private final String usualWords;
    private final Predicate<T> range;
    private final String refusal;
    private final Predicate<CheckSettings> where;
    private final boolean determinesFigures;
    private final String description;

    private Setting(Part part, String key, String name, String unit, SettingForm<T> form, T usual, String usualWords,
            Predicate<T> range, String refusal, Predicate<CheckSettings> where, boolean determinesFigures,
            String description) {
        this.part = part;
        this.key = key;
        this.name = name;
        this.unit = unit;
        this.form = form;
        this.usual = Objects.requireNonNull(usual, key);
        this.usualWords = usualWords;
        this.range = range;
        this.refusal = refusal;
        this.where = where;
        this.determinesFigures = determinesFigures;
        this.description = description;
    }

    /**
     * A row that all values suit.
     *
     * @param key in files
     * @param usual its default
     * @param description one sentence in English without its full stop
     */
    static <T> Setting<T> of(Part part, String key, SettingForm<T> form, T usual, String description) {
        return new Setting<>(part, key, key.replace('_', '-'), "", form, usual, form.text(usual), value -> true, "",
                settings -> true, true, description);
    }

    /** The same under another name than its key. */
    Setting<T> named(String other) {
        return new Setting<>(part, key, other, unit, form, usual, usualWords, range, refusal, where,
                determinesFigures, description);
    }

    /** The same in a unit, with which its key ends and its name does not. */
    Setting<T> in(String itsUnit) {
        return new Setting<>(part, key, key.substring(0, key.length() - 1 - itsUnit.length()).replace('_', '-'),
                itsUnit, form, usual, usualWords, range, refusal, where, determinesFigures, description);
    }

    /** The same with other words for its default. */
    Setting<T> usually(String words) {
        return new Setting<>(part, key, name, unit, form, usual, words, range, refusal, where, determinesFigures,
                description);
    }

    /** The same with a range, and what is said of a value outside: what it must be. */
    Setting<T> within(Predicate<T> itsRange, String itsRefusal) {
        return new Setting<>(part, key, name, unit, form, usual, usualWords, itsRange, itsRefusal, where,
                determinesFigures, description);
    }

    /** The same where it means something under some values of other settings only. */
    Setting<T> where(Predicate<CheckSettings> others) {
        return new Setting<>(part, key, name, unit, form, usual, usualWords, range, refusal, others,
                determinesFigures, description);
    }

    /** The same on which no figure depends. */
    Setting<T> withoutEffectOnFigures() {
        return new Setting<>(part, key, name, unit, form, usual, usualWords, range, refusal, where, false,
                description);
    }

    Part part() {
        return part;
    }

    /**
     * What files call it.
     *
     * @return lower case with underscores, ending with its unit
     */
    public String key() {
        return key;
    }

    /**
     * What people call it.
     *
     * @return lower case, hyphens between its words
     */
    public String name() {
        return name;
    }

    /**
     * Its unit.
     *
     * @return for instance {@code px}; empty where it has none
     */
    public String unit() {
        return unit;
    }

    /**
     * How values are written.
     *
     * @return the form
     */
    public SettingForm<T> form() {
        return form;
    }

    /**
     * Its default.
     *
     * @return never null
     */
    public T usual() {
        return usual;
    }

    /**
     * Its default in words.
     *
     * @return for instance {@code 0.5}; empty where it is open
     */
    public String usualWords() {
        return usualWords;
    }

    /**
     * What it is about.
     *
     * @return one sentence in English without its full stop
     */
    public String description() {
        return description;
    }

    /**
     * Whether figures depend on it.
     *
     * @return false for what changes the time alone
     */
    public boolean determinesFigures() {
        return determinesFigures;
    }

    /**
     * Whether it means anything among other settings.
     *
     * @param settings all
     * @return for instance false for the prior of a focal length that is known
     */
    public boolean appliesTo(CheckSettings settings) {
        return where.test(settings);
    }

    /**
     * Whether it has to be written down so that the same figures can be made again.
     *
     * @param settings all
     * @return true where it determines figures, applies and is not the default
     */
    public boolean isTold(CheckSettings settings) {
        return determinesFigures && appliesTo(settings) && !settings.get(this).equals(usual);
    }

    /**
     * Its value as text.
     *
     * @param settings all
     * @return what {@link #read} makes the same value of; empty where it is open
     */
    public String text(CheckSettings settings) {
        return form.text(settings.get(this));
    }

    /**
     * Its value as files hold it.
     *
     * @param settings all
     * @return a String, a Number or a Boolean; null where it is open or does not apply
     */
    public @Nullable Object plain(CheckSettings settings) {
        return appliesTo(settings) ? form.plain(settings.get(this)) : null;
    }

    /**
     * Sets it to what a text says.
     *
     * @param text as a user writes it
     * @param builder receives the value
     * @throws IllegalArgumentException if the text is no such value or out of range: a sentence without its subject
     */
    public void read(String text, CheckSettings.Builder builder) {
        T value = form.read(text);
        String reason = refusal(value);
        if (reason != null) {
            throw new IllegalArgumentException(reason);
        }
        builder.set(this, value);
    }

    /** Sets it to what null stands for in a file: open, or, where it does not apply, the default. */
    public void readOpen(CheckSettings.Builder builder) {
        builder.set(this, form.open() == null ? usual : form.open());
    }

    /** Why a value is out of range: a sentence without its subject, or null where it is not. */
    @Nullable String refusal(T value) {
        return range.test(value) ? null : refusal + ", not " + form.text(value);
    }

    @Override
    public String toString() {
        return name;
    }
}
