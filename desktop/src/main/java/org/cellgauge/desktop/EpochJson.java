package org.cellgauge.desktop;

import com.google.gson.Gson;
import com.google.gson.JsonArray;
import com.google.gson.JsonElement;
import com.google.gson.JsonObject;
import com.google.gson.JsonParseException;
import com.google.gson.JsonParser;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.cellgauge.cell.InputRefusedException;
import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.internal.cell.InputFiles;
import org.cellgauge.survey.Epoch;
import org.cellgauge.survey.SurveyRefusal;
import org.cellgauge.warning.Place;
import org.cellgauge.warning.Refusal;

/** What a survey leaves for later ones to be held against, in its JSON. */
public final class EpochJson {
    /** Key of a survey's JSON that holds it. */
    public static final String KEY = "epoch";
    private static final int MAX_BYTES = 64 << 20;
    private static final Gson GSON = new Gson();

    private EpochJson() {
    }

    /**
     * As it stands in a survey's JSON.
     *
     * @param epoch poses and their joint covariance
     * @return an object: {@code bodies} with kind, id, position in mm and rotation row by row, and {@code covariance},
     *     six rows for each, mm and rad
     */
    static JsonObject of(Epoch epoch) {
        JsonArray bodies = new JsonArray();
        for (Epoch.Body b : epoch.bodies()) {
            JsonObject one = new JsonObject();
            one.addProperty("kind", b.kind().word());
            one.addProperty("id", b.id());
            one.add("position_mm", GSON.toJsonTree(b.worldFromBody().translationMm()));
            one.add("rotation", GSON.toJsonTree(b.worldFromBody().rotation()));
            bodies.add(one);
        }
        int n = Epoch.ERRORS * epoch.bodies().size();
        JsonArray rows = new JsonArray();
        for (int i = 0; i < n; i++) {
            rows.add(GSON.toJsonTree(Arrays.copyOfRange(epoch.covariance(), i * n, (i + 1) * n)));
        }
        JsonObject out = new JsonObject();
        out.add("bodies", bodies);
        out.add("covariance", rows);
        return out;
    }

    /**
     * Reads it back.
     *
     * @param file what {@code survey} wrote: {@code NAME.survey.json}, or its standard output with {@code --json}
     * @return the epoch
     * @throws InputRefusedException if the file is missing or holds none
     */
    public static Epoch read(Path file) {
        return parse(InputFiles.text(file, SurveyRefusal.SURVEY_FILE, MAX_BYTES), file.toString());
    }

    /**
     * Reads what was read from a file already.
     *
     * @param text all of it
     * @param name of the file as people know it
     * @return the epoch
     * @throws InputRefusedException if it holds none
     */
    public static Epoch parse(String text, String name) {
        try {
            JsonElement all = JsonParser.parseString(text);
            if (!all.isJsonObject() || !all.getAsJsonObject().has(KEY)) {
                throw refused(name, "it has no key \"" + KEY + "\"");
            }
            return epoch(all.getAsJsonObject().getAsJsonObject(KEY));
        } catch (JsonParseException e) {
            throw refused(name, "it is no JSON");
        } catch (IllegalArgumentException | IllegalStateException | ClassCastException | NullPointerException
                | UnsupportedOperationException | IndexOutOfBoundsException e) {
            throw refused(name, "its key \"" + KEY + "\" is not as survey writes it");
        }
    }

    private static InputRefusedException refused(String file, String why) {
        return new InputRefusedException(Refusal.at(Place.of(file), SurveyRefusal.NO_SURVEY, why));
    }

    private static Epoch epoch(JsonObject from) {
        List<Epoch.Body> bodies = new ArrayList<>();
        for (JsonElement e : from.getAsJsonArray("bodies")) {
            JsonObject one = e.getAsJsonObject();
            Epoch.Kind kind = null;
            for (Epoch.Kind k : Epoch.Kind.values()) {
                kind = k.word().equals(one.get("kind").getAsString()) ? k : kind;
            }
            if (kind == null) {
                throw new IllegalArgumentException("no such kind");
            }
            bodies.add(new Epoch.Body(kind, one.get("id").getAsInt(), RigidTransform.of(
                    numbers(one.getAsJsonArray("rotation")), numbers(one.getAsJsonArray("position_mm")))));
        }
        int n = Epoch.ERRORS * bodies.size();
        JsonArray rows = from.getAsJsonArray("covariance");
        double[] covariance = new double[n * n];
        for (int i = 0; i < n; i++) {
            System.arraycopy(numbers(rows.get(i).getAsJsonArray()), 0, covariance, i * n, n);
        }
        return new Epoch(bodies, covariance);
    }

    private static double[] numbers(JsonArray from) {
        double[] out = new double[from.size()];
        for (int i = 0; i < out.length; i++) {
            out[i] = from.get(i).getAsDouble();
            if (!Double.isFinite(out[i])) {
                throw new IllegalArgumentException("not finite");
            }
        }
        return out;
    }
}
