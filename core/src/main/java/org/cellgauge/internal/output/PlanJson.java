package org.cellgauge.internal.output;

import com.google.gson.FormattingStyle;
import com.google.gson.stream.JsonWriter;
import java.io.IOException;
import java.io.StringWriter;
import java.io.UncheckedIOException;
import java.util.List;
import org.cellgauge.check.SampledForecast;
import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.plan.Change;
import org.cellgauge.plan.Forecast;
import org.cellgauge.plan.Plan;
import org.cellgauge.plan.Proposal;
import org.jspecify.annotations.Nullable;

/** A plan as JSON. Lengths are in mm, angles in rad; a deviation that is not determined is null. */
public final class PlanJson {
    private PlanJson() {
    }

    /**
     * The plan.
     *
     * @param plan what was found
     * @param sampled what chains say of each of {@link Plan#best()}, null where they were not asked; or empty
     * @return one JSON object and a line feed
     */
    public static String of(Plan plan, List<@Nullable SampledForecast> sampled) {
        StringWriter text = new StringWriter();
        try (JsonWriter out = new JsonWriter(text)) {
            out.setFormattingStyle(FormattingStyle.PRETTY.withIndent("  "));
            out.beginObject();
            out.name("schema").value(1);
            out.name("verdict").value(!plan.target().isAny() ? "no-target" : plan.met() ? "pass" : "fail");
            out.name("target");
            TargetJson.write(plan.target(), out);
            out.name("cameras").beginArray();
            for (RigidTransform pose : plan.layout().worldFromCameras()) {
                out.beginArray();
                for (double v : pose.translationMm()) {
                    out.value(v);
                }
                for (double v : pose.eulerRad()) {
                    out.value(v);
                }
                out.endArray();
            }
            out.endArray();
            out.name("now");
            forecast(out, plan.now());
            out.name("bound_std_mm");
            number(out, plan.boundStdMm());
            out.name("proposals");
            proposals(out, plan.best(), plan, sampled);
            out.name("front");
            proposals(out, plan.front(), plan, List.of());
            out.name("single");
            proposals(out, plan.single(), plan, List.of());
            out.name("certificates").beginArray();
            for (Plan.Certificate certificate : plan.certificate()) {
                out.beginObject().name("references").value(certificate.references());
                out.name("found_ratio");
                number(out, certificate.foundRatio());
                out.name("bound_ratio");
                number(out, certificate.boundRatio());
                out.name("proven").value(certificate.proven()).endObject();
            }
            out.endArray();
            out.endObject();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        return text + "\n";
    }

    private static void number(JsonWriter out, double value) throws IOException {
        if (Double.isFinite(value)) {
            out.value(value);
        } else {
            out.nullValue();
        }
    }

    private static void forecast(JsonWriter out, Forecast forecast) throws IOException {
        out.beginObject().name("worst_std_mm");
        number(out, forecast.worstStdMm());
        out.name("ratio");
        number(out, forecast.ratio());
        out.name("references").beginArray();
        for (int id : forecast.references()) {
            out.value(id);
        }
        out.endArray().name("not_seen").beginArray();
        for (int id : forecast.unseen()) {
            out.value(id);
        }
        out.endArray().name("points").beginArray();
        for (Forecast.Row row : forecast.rows()) {
            out.beginObject().name("object").value(row.object()).name("point").value(row.grip() ? "grip" : "marker");
            out.name("std_mm").beginArray();
            for (int axis = 0; axis < Forecast.AXES; axis++) {
                number(out, row.axis(axis));
            }
            out.endArray().name("own_std_mm");
            number(out, row.ownStdMm());
            if (!row.grip()) {
                out.name("turn_std_deg");
                number(out, row.turnStdDeg());
            }
            out.name("ratio");
            number(out, row.ratio());
            if (!Double.isNaN(row.probability())) {
                out.name("probability").value(row.probability());
            }
            out.endObject();
        }
        out.endArray().endObject();
    }

    private static void proposals(JsonWriter out, List<Proposal> proposals, Plan plan,
            List<@Nullable SampledForecast> sampled) throws IOException {
        out.beginArray();
        for (int i = 0; i < proposals.size(); i++) {
            Proposal proposal = proposals.get(i);
            out.beginObject().name("changes").beginArray();
            for (Change change : proposal.changes()) {
                out.beginObject().name("code").value(change.kind().code());
                out.name("sentence").value(change.words().toString());
                out.name("cost").value(change.cost()).endObject();
            }
            out.endArray().name("cost").value(proposal.cost());
            out.name("meets_target").value(plan.isMetBy(proposal.forecast()));
            out.name("forecast");
            forecast(out, proposal.forecast());
            SampledForecast chains = i < sampled.size() ? sampled.get(i) : null;
            if (chains != null) {
                out.name("sampled").beginObject();
                out.name("confirmed").value(chains.confirms());
                out.name("converged").value(chains.converged());
                out.name("std_mm");
                number(out, chains.sampledStdMm());
                out.name("forecast_std_mm");
                number(out, chains.forecastStdMm());
                out.endObject();
            }
            out.endObject();
        }
        out.endArray();
    }
}
