package org.cellgauge.cell;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.internal.cell.CellWriter;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class JointReaderTest {
    private static final PinholeCamera CAMERA = PinholeCamera.ideal(1280, 720, 900, 900, 640, 360);
    private static final String CELL = "cellgauge: 1\nmarkers: {family: square-binary, size_mm: 47}\n"
            + "placement: {std_mm: [5, 5, 5], std_deg: 0.5}\nreferences:\n  1: {position_mm: [0, 0, 0]}\n"
            + "  2: {position_mm: [400, 0, 0]}\n  3: {position_mm: [400, 300, 0]}\n  4: {position_mm: [0, 300, 0]}\n"
            + "objects: {5: {moves: true}, 6: {}}\n";

    private static Cell read(String more) {
        return CellReader.read(CELL + more, "cell.yaml", CAMERA);
    }

    @Test
    void readsWhatIsStatedOfSeveralReferences() {
        Cell cell = read("groups: {plate: {members: [1, 2], placement: {std_mm: [9, 8, 7], std_deg: 1}, "
                + "within: {std_mm: [0.1, 0.2, 0.3], std_deg: 0.05}}}\n"
                + "distances: [{between: [1, 3], mm: 500, std_mm: 0.1}]\n"
                + "heights: [{above: 2, below: 1, mm: -3, std_mm: 0.2}]\n"
                + "planes: [{members: [1, 2, 3, 4], std_mm: 0.5}]\n"
                + "touched: {4: {position_mm: [1, 301, 0], std_mm: [0.2, 0.3, 0.4], tool_rotation_deg: [180, 0, 0]}}\n"
                + "robot: {base: {std_mm: [2, 2, 2], std_deg: 0.1}, tool_std_mm: 0.3}\n");
        JointPlacement joint = cell.joint();
        assertEquals(List.of(1, 2), joint.groups().get(0).members());
        assertEquals(8, joint.groups().get(0).placement().stdMm(1));
        assertEquals(0.2, cell.references().get(0).placement().stdMm(1), "on the plate");
        assertEquals(5, cell.references().get(2).placement().stdMm(1), "beside it");
        assertEquals(new Measurement.Distance(1, 3, 500, 0.1), joint.measurements().get(0));
        assertEquals(new Measurement.Height(2, 1, -3, 0.2), joint.measurements().get(1));
        assertEquals(new Measurement.OnePlane(List.of(1, 2, 3, 4), 0.5), joint.measurements().get(2));
        Measurement.Touched touched = (Measurement.Touched) joint.measurements().get(3);
        assertEquals(0.3, touched.std().stdMm(1));
        assertEquals(-1, touched.worldFromTool().rotation()[8], 1e-12);
        assertNotNull(joint.robot());
        assertTrue(cell.objects().get(0).moves());
        assertFalse(cell.objects().get(1).moves());
        assertTrue(read("").joint().isNone());
    }

    @Test
    void surveyedCellsAreReadAsTheyWereWritten() {
        double[] covariance = new double[144];
        for (int i = 0; i < 12; i++) {
            covariance[13 * i] = 1 + i;
            covariance[12 * i + (i + 6) % 12] = 0.5;
        }
        Cell cell = read("").withJointPlacement(new JointPlacement(List.of(), List.of(), null,
                new SurveyedPlacement(List.of(2, 4), covariance)));
        Cell again = CellReader.read(CellWriter.text(cell, List.of()), "surveyed", (CameraSource) name -> "");
        assertEquals(cell.joint().surveyed(), again.joint().surveyed());
        assertTrue(again.objects().get(0).moves());
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {
        "distances: [{between: [1, 9], mm: 5, std_mm: 1}]|NO_SUCH_REFERENCE|distances",
        "distances: [{between: [1, 1], mm: 5, std_mm: 1}]|NAMED_TWICE|distances",
        "distances: [{between: [1, 2, 3], mm: 5, std_mm: 1}]|TWO_ENDS|distances",
        "distances: [{between: [1, 2], mm: 0, std_mm: 1}]|NOT_POSITIVE|distances",
        "distances: {between: [1, 2]}|NO_LIST|distances",
        "planes: [{members: [1, 2, 3], std_mm: 1}]|TOO_FEW_MEMBERS|planes",
        "touched: {9: {position_mm: [0, 0, 0], std_mm: [1, 1, 1]}}|NO_SUCH_REFERENCE|touched.9",
        "touched: {1: {position_mm: [0, 0, 0], std_mm: [1, 1, 1]}}|MISSING|robot",
        "surveyed: {references: [1], covariance: [[1, 2], [2, 1]]}|NO_SURVEY|surveyed.covariance",
        "groups: {a: {members: [1], placement: {std_mm: [1, 1, 1], std_deg: 1}}}|TOO_FEW_MEMBERS|groups.a.members",
        "group: {}|UNKNOWN_KEY|group"
    })
    void faultsAreRefusedWhereTheyStand(String more, CellRefusal kind, String key) {
        InputRefusedException e = assertThrows(InputRefusedException.class, () -> read(more));
        assertEquals(kind, e.refusal().kind());
        assertTrue(e.getMessage().contains(key), e.getMessage());
    }

    @Test
    void aReferenceIsOnOnePlate() {
        String plate = "{members: [1, 2], placement: {std_mm: [1, 1, 1], std_deg: 1}}";
        InputRefusedException e = assertThrows(InputRefusedException.class,
                () -> read("groups: {a: " + plate + ", b: " + plate + "}"));
        assertEquals(CellRefusal.IN_TWO_GROUPS, e.refusal().kind());
    }
}
