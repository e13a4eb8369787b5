package org.cellgauge.settings;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Objects;
import java.util.function.Predicate;
import org.cellgauge.warning.Refusal;
import org.cellgauge.warning.RefusalKind;
import org.jspecify.annotations.Nullable;

/**
 * One setting: a row of {@link SettingTable}, or of a like table of another program; immutable. It says how the setting
 * is named, written, read, limited and explained; what it does stands where its value is asked for.
 *
 * @param <T> type of its values
 */
public final class Setting<T> {
    /** Which half of the settings one belongs to. */
    enum Part {
        /** What is taken of cell, camera and noise. */
        MODEL,
        /** How the posterior of that model is sampled. */
        SAMPLING,
        /** Neither: a row of another table than {@link SettingTable}. */
        OTHER
    }

    private final Part part;
    private final String key;
    private final String name;
    private final String unit;
    private final SettingForm<T> form;
    private final T usual;
    private final String usualWords;
    private final List<Limit<T>> limits;
    private final Predicate<SettingSource> where;
    private final boolean determinesFigures;
    private final String description;

    private Setting(Part part, String key, String name, String unit, SettingForm<T> form, T usual, String usualWords,
            List<Limit<T>> limits, Predicate<SettingSource> where, boolean determinesFigures, String description) {
        this.part = part;
        this.key = key;
        this.name = name;
        this.unit = unit;
        this.form = form;
        this.usual = Objects.requireNonNull(usual, key);
        this.usualWords = usualWords;
        this.limits = limits;
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
        return new Setting<>(part, key, key.replace('_', '-'), "", form, usual, form.text(usual), List.of(),
                settings -> true, true, description);
    }

    /**
     * A row of another table than {@link SettingTable} that all values suit.
     *
     * @param key what files call it: lower case with underscores, ending with its unit where it has one
     * @param form how its values are written
     * @param usual its default
     * @param description one sentence in English without its full stop
     * @param <T> type of its values
     * @return the row
     */
    public static <T> Setting<T> of(String key, SettingForm<T> form, T usual, String description) {
        return of(Part.OTHER, key, form, usual, description);
    }

    /**
     * The same under another name than its key.
     *
     * @param other lower case, hyphens between its words
     * @return a row in place of this one
     */
    public Setting<T> named(String other) {
        return new Setting<>(part, key, other, unit, form, usual, usualWords, limits, where,
                determinesFigures, description);
    }

    /**
     * The same in a unit, with which its key ends and its name does not.
     *
     * @param itsUnit for instance {@code px}
     * @return a row in place of this one
     */
    public Setting<T> in(String itsUnit) {
        return new Setting<>(part, key, key.substring(0, key.length() - 1 - itsUnit.length()).replace('_', '-'),
                itsUnit, form, usual, usualWords, limits, where, determinesFigures, description);
    }

    /**
     * The same with other words for its default.
     *
     * @param words in English
     * @return a row in place of this one
     */
    public Setting<T> usually(String words) {
        return new Setting<>(part, key, name, unit, form, usual, words, limits, where, determinesFigures,
                description);
    }

    /**
     * The same with a limit besides those it has.
     *
     * @param range whether a value is within it
     * @param refusal what is said of a value outside: what it must be; the last place of its pattern is the value's
     * @param arguments what stands in the other places
     * @return a row in place of this one
     */
    public Setting<T> within(Predicate<T> range, RefusalKind refusal, Object... arguments) {
        List<Limit<T>> all = new ArrayList<>(limits);
        all.add(new Limit<>(range, refusal, Arrays.asList(arguments)));
        return new Setting<>(part, key, name, unit, form, usual, usualWords, List.copyOf(all), where,
                determinesFigures, description);
    }

    /**
     * The same where it means something under some values of other settings only.
     *
     * @param others whether these are such values
     * @return a row in place of this one
     */
    public Setting<T> where(Predicate<SettingSource> others) {
        return new Setting<>(part, key, name, unit, form, usual, usualWords, limits, others,
                determinesFigures, description);
    }

    /** The same on which no figure depends. */
    Setting<T> withoutEffectOnFigures() {
        return new Setting<>(part, key, name, unit, form, usual, usualWords, limits, where, false,
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
     * @param settings all of its table
     * @return for instance false for the prior of a focal length that is known
     */
    public boolean appliesTo(SettingSource settings) {
        return where.test(settings);
    }

    /**
     * Whether it has to be written down so that the same figures can be made again.
     *
     * @param settings all of its table
     * @return true where it determines figures, applies and is not the default
     */
    public boolean isTold(SettingSource settings) {
        return determinesFigures && appliesTo(settings) && !settings.get(this).equals(usual);
    }

    /**
     * The same where other values than the defaults need not be written down.
     *
     * @param settings all of its table
     * @param others what stands where nothing is written
     * @return true where it determines figures, applies and has another value
     */
    public boolean isTold(SettingSource settings, SettingSource others) {
        return determinesFigures && appliesTo(settings) && !settings.get(this).equals(others.get(this));
    }

    /**
     * Its value as text.
     *
     * @param settings all of its table
     * @return what {@link #read} makes the same value of; empty where it is open
     */
    public String text(SettingSource settings) {
        return form.text(settings.get(this));
    }

    /**
     * Its value as files hold it.
     *
     * @param settings all of its table
     * @return a String, a Number or a Boolean; null where it is open or does not apply
     */
    public @Nullable Object plain(SettingSource settings) {
        return appliesTo(settings) ? form.plain(settings.get(this)) : null;
    }

    /**
     * The value that a text says.
     *
     * @param text as a user writes it
     * @return the value
     * @throws SettingRefusedException if the text is no such value or out of range
     */
    public T read(String text) {
        T value;
        try {
            value = form.read(text);
        } catch (SettingForm.UnreadableException e) {
            throw new SettingRefusedException(this, e.refusal());
        }
        requireInRange(value);
        return value;
    }

    /**
     * Sets it to what a text says.
     *
     * @param text as a user writes it
     * @param builder receives the value
     * @throws SettingRefusedException if the text is no such value or out of range
     */
    public void read(String text, CheckSettings.Builder builder) {
        builder.set(this, read(text));
    }

    /**
     * Sets it to what null stands for in a file: open, or, where it does not apply, the default.
     *
     * @param builder receives the value
     */
    public void readOpen(CheckSettings.Builder builder) {
        builder.set(this, form.open() == null ? usual : form.open());
    }

    /** Requires that a value is in range. */
    void requireInRange(T value) {
        Refusal reason = refusal(value);
        if (reason != null) {
            throw new SettingRefusedException(this, reason);
        }
    }

    /** Why a value is out of range, or null where it is not. */
    @Nullable Refusal refusal(T value) {
        for (Limit<T> limit : limits) {
            if (!limit.range.test(value)) {
                return limit.refusal(form.text(value));
            }
        }
        return null;
    }

    /** A range, and what is said of a value outside. */
    private static final class Limit<T> {
        private final Predicate<T> range;
        private final RefusalKind kind;
        private final List<Object> arguments;

        Limit(Predicate<T> range, RefusalKind kind, List<Object> arguments) {
            this.range = range;
            this.kind = kind;
            this.arguments = arguments;
        }

        Refusal refusal(String value) {
            List<Object> all = new ArrayList<>(arguments);
            all.add(value);
            return Refusal.of(kind, all.toArray());
        }
    }

    @Override
    public String toString() {
        return name;
    }
}
