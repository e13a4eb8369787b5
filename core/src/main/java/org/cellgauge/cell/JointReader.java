package org.cellgauge.cell;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.internal.cell.CellPhrase;
import org.jspecify.annotations.Nullable;

/**
 * Reads what a cell file says of several references together: groups, distances, heights, planes, touched points, and
 * the joint covariance that a survey wrote.
 */
final class JointReader {
    /** The keys at the top of a cell file. */
    static final List<String> KEYS =
            List.of("groups", "distances", "heights", "planes", "touched", "robot", "surveyed");

    private static final String GROUP = "{members: [944, 22], placement: {std_mm: [5, 5, 5], std_deg: 0.5}, within: "
            + "{std_mm: [0.2, 0.2, 0.2], std_deg: 0.05}}";
    private static final String DISTANCE = "{between: [944, 911], mm: 492.0, std_mm: 0.3}";
    private static final String HEIGHT = "{above: 22, below: 944, mm: 165.0, std_mm: 0.3}";
    private static final String PLANE = "{members: [944, 911, 22, 1234], std_mm: 0.5}";
    private static final String TOUCHED = "{position_mm: [492, 0, 0], std_mm: [0.2, 0.2, 0.2]}";
    private static final String ROBOT = "robot: {base: {std_mm: [2, 2, 2], std_deg: 0.1}, tool_std_mm: 0.3}";
    private static final String SURVEYED = "{references: [944, 22], covariance: [[...], ...]}";
    private static final String STD_MM = "std_mm: 0.3";
    /** Three points always lie in one plane. */
    private static final int LEAST_OF_PLANE = 4;

    private final Map<Integer, Reference> references = new LinkedHashMap<>();

    private JointReader(List<Reference> references) {
        references.forEach(r -> this.references.put(r.id(), r));
    }

    /** A cell with what its file says of references together; members of a group are placed as precisely as in it. */
    static Cell with(YamlMapping file, Cell cell) {
        JointReader reader = new JointReader(cell.references());
        List<PlacementGroup> groups = reader.groups(file.optional("groups"));
        List<Measurement> measurements = new ArrayList<>();
        reader.distances(file.optional("distances"), measurements);
        reader.heights(file.optional("heights"), measurements);
        reader.planes(file.optional("planes"), measurements);
        boolean touched = reader.touched(file.optional("touched"), measurements);
        RobotPrecision robot = touched ? robot(file.required("robot", ROBOT)) : null;
        YamlValue surveyed = file.optional("surveyed");
        return cell.withReferences(new ArrayList<>(reader.references.values())).withJointPlacement(
                new JointPlacement(groups, measurements, robot, surveyed == null ? null : reader.surveyed(surveyed)));
    }

    private List<PlacementGroup> groups(@Nullable YamlValue value) {
        List<PlacementGroup> groups = new ArrayList<>();
        Map<Integer, String> groupOf = new HashMap<>();
        if (value == null || value.isEmpty()) {
            return groups;
        }
        for (Map.Entry<String, YamlValue> e : value.mapping("plate: " + GROUP).values().entrySet()) {
            YamlMapping entry = e.getValue().mapping(GROUP, "members", "placement", "within");
            YamlValue membersValue = entry.required("members", "members: [944, 22]");
            List<Integer> members = members(membersValue, 2);
            for (int id : members) {
                String other = groupOf.putIfAbsent(id, e.getKey());
                if (other != null) {
                    throw membersValue.refused(CellRefusal.IN_TWO_GROUPS, id, other);
                }
            }
            Placement placement = CellReader.placementOf(entry.required("placement",
                    "placement: {std_mm: [5, 5, 5], std_deg: 0.5}"));
            YamlValue within = entry.optional("within");
            if (within != null) {
                Placement own = CellReader.placementOf(within);
                members.forEach(id -> references.computeIfPresent(id, (key, r) ->
                        new Reference(r.id(), r.sizeMm(), r.worldFromMarker(), own)));
            }
            groups.add(new PlacementGroup(e.getKey(), members, placement));
        }
        return groups;
    }

    private int id(YamlValue value) {
        int id = value.whole(0, Integer.MAX_VALUE, CellPhrase.REFERENCE_ID);
        if (!references.containsKey(id)) {
            throw value.refused(CellRefusal.NO_SUCH_REFERENCE, id);
        }
        return id;
    }

    private List<Integer> members(YamlValue value, int atLeast) {
        List<Integer> members = new ArrayList<>();
        for (YamlValue item : items(value)) {
            int id = id(item);
            if (members.contains(id)) {
                throw item.refused(CellRefusal.NAMED_TWICE, id);
            }
            members.add(id);
        }
        if (members.size() < atLeast) {
            throw value.refused(CellRefusal.TOO_FEW_MEMBERS, atLeast);
        }
        return members;
    }

    private static List<YamlValue> items(@Nullable YamlValue value) {
        if (value == null || value.isEmpty()) {
            return List.of();
        }
        if (!value.isList()) {
            throw value.refused(CellRefusal.NO_LIST);
        }
        return value.items();
    }

    private void distances(@Nullable YamlValue value, List<Measurement> out) {
        for (YamlValue item : items(value)) {
            YamlMapping entry = item.mapping(DISTANCE, "between", "mm", "std_mm");
            YamlValue between = entry.required("between", "between: [944, 911]");
            List<Integer> ends = members(between, 2);
            if (ends.size() > 2) {
                throw between.refused(CellRefusal.TWO_ENDS);
            }
            out.add(new Measurement.Distance(ends.get(0), ends.get(1), positive(entry, "mm"),
                    positive(entry, "std_mm")));
        }
    }

    private void heights(@Nullable YamlValue value, List<Measurement> out) {
        for (YamlValue item : items(value)) {
            YamlMapping entry = item.mapping(HEIGHT, "above", "below", "mm", "std_mm");
            YamlValue belowValue = entry.required("below", "below: 944");
            int above = id(entry.required("above", "above: 22"));
            int below = id(belowValue);
            if (above == below) {
                throw belowValue.refused(CellRefusal.NAMED_TWICE, below);
            }
            YamlValue mm = entry.required("mm", "mm: 165.0");
            out.add(new Measurement.Height(above, below, CellReader.bounded(mm, mm.number(CellPhrase.LENGTH),
                    CellPhrase.LENGTH), positive(entry, "std_mm")));
        }
    }

    private void planes(@Nullable YamlValue value, List<Measurement> out) {
        for (YamlValue item : items(value)) {
            YamlMapping entry = item.mapping(PLANE, "members", "std_mm");
            out.add(new Measurement.OnePlane(members(entry.required("members", "members: [944, 911, 22, 1234]"),
                    LEAST_OF_PLANE), positive(entry, "std_mm")));
        }
    }

    private boolean touched(@Nullable YamlValue value, List<Measurement> out) {
        if (value == null || value.isEmpty()) {
            return false;
        }
        for (Map.Entry<String, YamlValue> e : value.mapping("911: " + TOUCHED).values().entrySet()) {
            YamlMapping entry = e.getValue().mapping(TOUCHED, "position_mm", "std_mm", "tool_rotation_deg");
            if (!e.getKey().matches("\\d{1,9}") || !references.containsKey(Integer.parseInt(e.getKey()))) {
                throw e.getValue().refused(CellRefusal.NO_SUCH_REFERENCE, e.getKey());
            }
            double[] at = CellReader.point(entry.required("position_mm", "position_mm: [x, y, z]"));
            double[] std = CellReader.placementStdMm(entry.required("std_mm", "std_mm: [0.2, 0.2, 0.2]"));
            double[] turn = CellReader.rotation(entry.optional("tool_rotation_deg"));
            out.add(new Measurement.Touched(Integer.parseInt(e.getKey()), RigidTransform.ofEuler(at[0], at[1], at[2],
                    Math.toRadians(turn[0]), Math.toRadians(turn[1]), Math.toRadians(turn[2])),
                    new Placement(std[0], std[1], std[2], 0)));
        }
        return true;
    }

    private static RobotPrecision robot(YamlValue value) {
        YamlMapping entry = value.mapping(ROBOT, "base", "tool_std_mm");
        return new RobotPrecision(CellReader.placementOf(entry.required("base",
                "base: {std_mm: [2, 2, 2], std_deg: 0.1}")), positive(entry, "tool_std_mm"));
    }

    private static double positive(YamlMapping entry, String key) {
        YamlValue value = entry.required(key, key.equals("mm") ? "mm: 492.0" : STD_MM);
        return CellReader.bounded(value, value.positive(CellPhrase.LENGTH), CellPhrase.LENGTH);
    }

    private SurveyedPlacement surveyed(YamlValue value) {
        YamlMapping entry = value.mapping(SURVEYED, "references", "covariance");
        List<Integer> ids = members(entry.required("references", "references: [944, 22]"), 1);
        YamlValue rows = entry.required("covariance", "covariance: [[...], ...]");
        int n = SurveyedPlacement.ERRORS * ids.size();
        List<YamlValue> items = items(rows);
        if (items.size() != n) {
            throw rows.refused(CellRefusal.NO_SURVEY, ids.size());
        }
        double[] covariance = new double[n * n];
        for (int i = 0; i < n; i++) {
            System.arraycopy(items.get(i).numbers(n, SURVEYED), 0, covariance, i * n, n);
        }
        try {
            return new SurveyedPlacement(ids, covariance);
        } catch (IllegalArgumentException e) {
            throw rows.refused(CellRefusal.NO_SURVEY, ids.size());
        }
    }
}
