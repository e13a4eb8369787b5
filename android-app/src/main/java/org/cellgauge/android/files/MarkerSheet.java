package org.cellgauge.android.files;

import java.io.ByteArrayOutputStream;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import org.cellgauge.cell.Cell;
import org.cellgauge.vision.FamilyPatterns;

/**
 * The markers of a cell for a printer, true to size: a PDF file of A4 pages, larger ones where a marker needs it. Each
 * marker stands in a grey line to cut along, which leaves it the white margin that detection needs; its id and size
 * stand below it, so that the print says which way up it is. A line of 100 mm tells whether the printer scaled the
 * page.
 */
final class MarkerSheet {
    /** White beside a marker, as a share of its side. */
    static final double WHITE_SHARE = 0.2;
    static final double RULER_MM = 100;
    private static final double POINTS_PER_MM = 72 / 25.4;
    private static final double PAGE_WIDTH_MM = 210;
    private static final double PAGE_HEIGHT_MM = 297;
    private static final double MARGIN_MM = 5;
    private static final double GAP_MM = 1;
    private static final double LABEL_MM = 6;
    private static final double HEAD_MM = 14;
    private static final int FIRST_PAGE_OBJECT = 4;

    private final FamilyPatterns patterns;
    private final double widthMm;
    private final double heightMm;
    private final List<StringBuilder> pages = new ArrayList<>();
    private double xMm;
    private double topMm;
    private double rowMm;

    private MarkerSheet(Cell cell, double largestMm) {
        patterns = new FamilyPatterns(cell.family());
        double box = largestMm * (1 + 2 * WHITE_SHARE);
        widthMm = Math.max(PAGE_WIDTH_MM, box + 2 * MARGIN_MM);
        heightMm = Math.max(PAGE_HEIGHT_MM, box + LABEL_MM + HEAD_MM + 2 * MARGIN_MM);
    }

    /**
     * Draws the markers of a cell: the smallest first, references before objects, each once.
     *
     * @param cell which markers, of which family and size
     * @return a PDF file
     */
    static byte[] of(Cell cell) {
        Map<Integer, Double> sizes = new LinkedHashMap<>();
        cell.references().forEach(reference -> sizes.put(reference.id(), reference.sizeMm()));
        cell.objects().forEach(object -> sizes.put(object.id(), object.sizeMm()));
        // those of one size beside each other take the fewest pages
        List<Integer> ids = new ArrayList<>(sizes.keySet());
        ids.sort((a, b) -> Double.compare(sizes.get(a), sizes.get(b)));
        MarkerSheet sheet = new MarkerSheet(cell, sizes.get(ids.get(ids.size() - 1)));
        sheet.newPage(cell.family().familyName());
        ids.forEach(id -> sheet.add(id, sizes.get(id), cell.family().familyName()));
        return sheet.pdf();
    }

    private void newPage(String family) {
        pages.add(new StringBuilder());
        xMm = MARGIN_MM;
        topMm = MARGIN_MM + HEAD_MM;
        rowMm = 0;
        double ruler = MARGIN_MM + 5;
        line(MARGIN_MM, ruler, MARGIN_MM + RULER_MM, ruler);
        line(MARGIN_MM, ruler - 2, MARGIN_MM, ruler + 2);
        line(MARGIN_MM + RULER_MM, ruler - 2, MARGIN_MM + RULER_MM, ruler + 2);
        text(MARGIN_MM + 2, ruler - 1.5, "100 mm");
        text(MARGIN_MM + RULER_MM + 6, ruler + 1, family);
    }

    private void add(int id, double sizeMm, String family) {
        double white = WHITE_SHARE * sizeMm;
        double box = sizeMm + 2 * white;
        if (xMm + box > widthMm - MARGIN_MM) {
            xMm = MARGIN_MM;
            topMm += rowMm + GAP_MM;
            rowMm = 0;
        }
        if (topMm + box + LABEL_MM > heightMm - MARGIN_MM) {
            newPage(family);
        }
        page().append("0.75 G 0.3 w ").append(rectangle(xMm, topMm, box, box + LABEL_MM)).append("S\n");
        marker(id, xMm + white, topMm + white, sizeMm);
        text(xMm + white, topMm + box + LABEL_MM - 2, id + "   " + number(sizeMm) + " mm");
        xMm += box + GAP_MM;
        rowMm = Math.max(rowMm, box + LABEL_MM);
    }

    /** One path, so that no seams show between squares. */
    private void marker(int id, double leftMm, double fromTopMm, double sizeMm) {
        int squares = patterns.squares();
        boolean[] white = patterns.whiteSquares(id);
        double side = sizeMm / squares;
        page().append("0 g\n");
        for (int row = 0; row < squares; row++) {
            int from = 0;
            while (from < squares) {
                int to = from;
                while (to < squares && !white[row * squares + to]) {
                    to++;
                }
                if (to > from) {
                    page().append(rectangle(leftMm + from * side, fromTopMm + row * side, (to - from) * side, side))
                            .append('\n');
                }
                from = to + 1;
            }
        }
        page().append("f\n");
    }

    private StringBuilder page() {
        return pages.get(pages.size() - 1);
    }

    private void line(double x1, double y1, double x2, double y2) {
        page().append("0 G 0.5 w ").append(point(x1, y1)).append("m ").append(point(x2, y2)).append("l S\n");
    }

    private void text(double x, double y, String text) {
        page().append("BT /F 9 Tf 0 g ").append(point(x, y)).append("Td (").append(text).append(") Tj ET\n");
    }

    /** PDF counts upwards from the lower left. */
    private String rectangle(double leftMm, double fromTopMm, double wMm, double hMm) {
        return point(leftMm, fromTopMm + hMm) + number(wMm * POINTS_PER_MM) + " " + number(hMm * POINTS_PER_MM)
                + " re ";
    }

    private String point(double leftMm, double fromTopMm) {
        return number(leftMm * POINTS_PER_MM) + " " + number((heightMm - fromTopMm) * POINTS_PER_MM) + " ";
    }

    private static String number(double value) {
        String text = String.format(Locale.ROOT, "%.4f", value);
        return text.replaceAll("\\.?0+$", "");
    }

    // ---- the file

    private byte[] pdf() {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        List<Integer> offsets = new ArrayList<>();
        StringBuilder kids = new StringBuilder();
        for (int i = 0; i < pages.size(); i++) {
            kids.append(FIRST_PAGE_OBJECT + 2 * i).append(" 0 R ");
        }
        write(out, "%PDF-1.4\n");
        object(out, offsets, "<< /Type /Catalog /Pages 2 0 R /ViewerPreferences << /PrintScaling /None >> >>");
        object(out, offsets, "<< /Type /Pages /Count " + pages.size() + " /Kids [" + kids + "] >>");
        object(out, offsets, "<< /Type /Font /Subtype /Type1 /BaseFont /Helvetica >>");
        for (int i = 0; i < pages.size(); i++) {
            object(out, offsets, "<< /Type /Page /Parent 2 0 R /MediaBox [0 0 " + number(widthMm * POINTS_PER_MM) + " "
                    + number(heightMm * POINTS_PER_MM) + "] /Resources << /Font << /F 3 0 R >> >> /Contents "
                    + (FIRST_PAGE_OBJECT + 2 * i + 1) + " 0 R >>");
            object(out, offsets, "<< /Length " + pages.get(i).length() + " >>\nstream\n" + pages.get(i)
                    + "\nendstream");
        }
        int table = out.size();
        write(out, "xref\n0 " + (offsets.size() + 1) + "\n0000000000 65535 f \n");
        for (int offset : offsets) {
            write(out, String.format(Locale.ROOT, "%010d 00000 n \n", offset));
        }
        write(out, "trailer\n<< /Size " + (offsets.size() + 1) + " /Root 1 0 R >>\nstartxref\n" + table + "\n%%EOF\n");
        return out.toByteArray();
    }

    private static void object(ByteArrayOutputStream out, List<Integer> offsets, String body) {
        offsets.add(out.size());
        write(out, offsets.size() + " 0 obj\n" + body + "\nendobj\n");
    }

    private static void write(ByteArrayOutputStream out, String ascii) {
        byte[] bytes = ascii.getBytes(StandardCharsets.US_ASCII);
        out.write(bytes, 0, bytes.length);
    }
}
