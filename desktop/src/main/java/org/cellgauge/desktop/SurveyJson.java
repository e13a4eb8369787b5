package org.cellgauge.desktop;

import com.google.gson.Gson;
import com.google.gson.GsonBuilder;
import com.google.gson.JsonArray;
import com.google.gson.JsonObject;
import java.util.ArrayList;
import java.util.List;
import org.cellgauge.check.Conformity;
import org.cellgauge.estimate.PoseEstimate;
import org.cellgauge.statistics.Convergence;
import org.cellgauge.survey.Drift;
import org.cellgauge.survey.Epoch;
import org.cellgauge.survey.SurveyAdvice;
import org.cellgauge.survey.SurveyResult;
import org.cellgauge.survey.SurveyRun;
import org.cellgauge.survey.SurveyedDistance;
import org.cellgauge.survey.SurveyedMeasurement;
import org.cellgauge.survey.SurveyedObject;
import org.cellgauge.survey.SurveyedPhoto;
import org.cellgauge.survey.SurveyedReference;
import org.cellgauge.warning.Warning;
import org.jspecify.annotations.Nullable;

/** A survey for programs. */
public final class SurveyJson {
    private static final Gson GSON = new GsonBuilder().disableHtmlEscaping().create();
    private static final List<String> ORDER =
            List.of("x_mm", "y_mm", "z_mm", "psi_rad", "theta_rad", "phi_rad");

    private SurveyJson() {
    }

    /**
     * All figures in one line of JSON.
     *
     * @param result a survey
     * @param drift what has moved since an earlier one; null where it is held against none
     * @param verdict its key
     * @param version of this program
     * @param command that makes it again
     * @return JSON, ended by a line feed
     */
    public static String line(SurveyResult result, @Nullable Drift drift, String verdict, String version,
            String command) {
        JsonObject out = new JsonObject();
        out.addProperty("schema", 1);
        out.addProperty("verdict", verdict);
        JsonArray photos = new JsonArray();
        for (SurveyedPhoto p : result.photos()) {
            JsonObject one = new JsonObject();
            one.addProperty("name", p.name());
            one.addProperty("used", p.used());
            one.addProperty("markers", p.markers());
            one.addProperty("chance", finite(p.chance()));
            if (p.camera() != null) {
                one.add("camera", pose(p.camera()));
            }
            photos.add(one);
        }
        out.add("photos", photos);
        out.add("objects", objects(result));
        JsonObject references = new JsonObject();
        for (SurveyedReference r : result.references()) {
            JsonObject one = new JsonObject();
            one.add("pose", pose(r.pose()));
            one.addProperty("photos", r.photos());
            one.addProperty("off_mm", r.offMm());
            one.addProperty("chance", finite(r.chance()));
            one.addProperty("misplaced", r.misplaced());
            references.add(String.valueOf(r.stated().id()), one);
        }
        out.add("references", references);
        out.add("distances", distances(result));
        JsonArray measurements = new JsonArray();
        for (SurveyedMeasurement m : result.measurements()) {
            JsonObject one = new JsonObject();
            one.add("members", GSON.toJsonTree(m.measurement().members()));
            one.addProperty("deviations", m.deviations());
            one.addProperty("chance", finite(m.chance()));
            measurements.add(one);
        }
        out.add("measurements", measurements);
        if (!result.advice().isEmpty()) {
            JsonArray advice = new JsonArray();
            for (SurveyAdvice a : result.advice()) {
                JsonObject one = new JsonObject();
                one.addProperty("code", a.change().kind().code());
                one.addProperty("text", a.change().toString());
                one.addProperty("worst_std_mm", a.worstStdMm());
                advice.add(one);
            }
            out.add("plan", advice);
        }
        SurveyRun run = result.run();
        if (run != null) {
            JsonObject one = new JsonObject();
            one.addProperty("r_hat_max", finite(run.rHatMax()));
            one.addProperty("ess_bulk_min", finite(run.essBulkMin()));
            one.addProperty("ess_tail_min", finite(run.essTailMin()));
            one.addProperty("converged", run.convergence() == Convergence.CONVERGED);
            one.addProperty("chains", run.chains());
            one.addProperty("draws", run.draws());
            one.addProperty("evaluations", run.evaluations());
            one.addProperty("acceptance", run.acceptance());
            out.add("diagnostics", one);
        }
        out.add(EpochJson.KEY, EpochJson.of(result.epoch()));
        List<Warning> said = new ArrayList<>(result.warnings());
        if (drift != null) {
            out.add("drift", drift(drift));
            said.addAll(drift.warnings());
        }
        JsonArray warnings = new JsonArray();
        for (Warning w : said) {
            JsonObject one = new JsonObject();
            one.addProperty("code", w.kind().code());
            one.addProperty("text", w.toString());
            warnings.add(one);
        }
        out.add("warnings", warnings);
        out.addProperty("command", command);
        out.addProperty("version", version);
        return GSON.toJson(out) + "\n";
    }

    private static JsonObject drift(Drift drift) {
        JsonObject out = new JsonObject();
        out.addProperty("moved", drift.any());
        out.add("bodies", displacements(drift.bodies()));
        JsonArray photos = new JsonArray();
        for (Drift.OfPhoto p : drift.photos()) {
            JsonObject one = new JsonObject();
            one.addProperty("name", p.photo());
            one.add("bodies", displacements(p.bodies()));
            photos.add(one);
        }
        out.add("photos", photos);
        out.addProperty("limit", drift.limit());
        return out;
    }

    private static JsonArray displacements(List<Drift.Displacement> bodies) {
        JsonArray out = new JsonArray();
        for (Drift.Displacement d : bodies) {
            JsonObject one = new JsonObject();
            one.addProperty("kind", d.body().kind().word());
            if (d.body().kind() != Epoch.Kind.CAMERA) {
                one.addProperty("id", d.body().id());
            }
            one.addProperty("moved", d.moved());
            one.addProperty("chance", finite(d.chance()));
            one.addProperty("chi_square", d.chiSquare());
            one.add("shift_mm", GSON.toJsonTree(d.shiftMm()));
            one.add("std_mm", GSON.toJsonTree(d.stdMm()));
            one.addProperty("turn_deg", d.turnDeg());
            out.add(one);
        }
        return out;
    }

    private static JsonObject objects(SurveyResult result) {
        JsonObject objects = new JsonObject();
        for (SurveyedObject o : result.objects()) {
            JsonObject one = new JsonObject();
            one.add("pose", pose(o.pose()));
            one.addProperty("photos", o.photos());
            one.add("budget", GSON.toJsonTree(o.shares()));
            one.addProperty("ambiguous", o.ambiguous());
            JsonArray conformities = new JsonArray();
            for (Conformity c : o.conformities()) {
                JsonObject kept = new JsonObject();
                kept.addProperty("of", c.of().key());
                kept.addProperty("tolerance_" + c.of().unit(), c.tolerance());
                kept.addProperty("probability", c.probability());
                kept.addProperty("mcse", c.mcse());
                kept.addProperty("asked", c.asked());
                conformities.add(kept);
            }
            if (conformities.size() > 0) {
                one.add("conformity", conformities);
            }
            JsonArray curve = new JsonArray();
            o.worstStdMmByPhotos().forEach(std -> curve.add(finite(std)));
            one.add("worst_std_mm_by_photos", curve);
            one.addProperty("next_worst_std_mm", finite(o.nextWorstStdMm()));
            if (o.grip() != null) {
                JsonObject grip = new JsonObject();
                grip.add("mean", GSON.toJsonTree(o.grip().meanMm()));
                grip.add("std", GSON.toJsonTree(o.grip().stdMm()));
                grip.add("covariance", GSON.toJsonTree(o.grip().covarianceMm2()));
                one.add("grip", grip);
            }
            objects.add(String.valueOf(o.marker().id()), one);
        }
        return objects;
    }

    private static JsonArray distances(SurveyResult result) {
        JsonArray out = new JsonArray();
        List<SurveyedReference> references = result.references();
        for (int a = 0; a < references.size(); a++) {
            for (int b = a + 1; b < references.size(); b++) {
                SurveyedDistance d = result.distance(references.get(a).stated().id(), references.get(b).stated().id());
                JsonObject one = new JsonObject();
                one.add("between", GSON.toJsonTree(new int[] {d.from(), d.to()}));
                one.addProperty("stated_mm", d.statedMm());
                one.addProperty("mm", d.mm());
                one.addProperty("std_mm", d.stdMm());
                out.add(one);
            }
        }
        return out;
    }

    private static JsonObject pose(PoseEstimate pose) {
        JsonObject out = new JsonObject();
        out.addProperty("frame", pose.frame());
        out.add("order", GSON.toJsonTree(ORDER));
        out.add("mean", GSON.toJsonTree(pose.mean()));
        out.add("std", GSON.toJsonTree(pose.std()));
        out.add("covariance", GSON.toJsonTree(pose.covariance()));
        out.add("tangent_covariance", GSON.toJsonTree(pose.tangentCovariance()));
        return out;
    }

    private static Double finite(double value) {
        return Double.isFinite(value) ? value : null;
    }
}
