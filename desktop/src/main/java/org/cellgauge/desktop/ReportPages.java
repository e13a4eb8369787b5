package org.cellgauge.desktop;

import java.io.Closeable;
import java.io.IOException;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.cellgauge.internal.warning.Decimal;
import org.cellgauge.output.ResultView;

/**
 * The files of a report, written while the run goes on. Up to {@value #PHOTOS_A_PAGE} photos are on one page; of more,
 * {@code report.html} has the run as a whole, what to look at first and the table of the others, {@code
 * report-001.html} and so on, which are written as soon as they are full.
 */
final class ReportPages implements Closeable {
    /** Most photos of a page: some megabytes. */
    static final int PHOTOS_A_PAGE = 100;

    private static final String MAIN = "report.html";
    private static final Pattern PART = Pattern.compile("report-(\\d{3,9})\\.html");
    private static final int MOST_NOTABLE = 30;
    /** Room for what a page has besides its sections, so that a disk that fills up costs no report. */
    private static final int RESERVED_BYTES = 1 << 20;

    private final HtmlReport report;
    private final Path folder;
    private final boolean parts;
    private final PhotoTrend trend = new PhotoTrend();
    private final StringBuilder partRows = new StringBuilder();
    private final StringBuilder notableRows = new StringBuilder();
    private int notable;
    private final StringBuilder rows = new StringBuilder();
    private final Map<String, Integer> byWord = new LinkedHashMap<>();
    /** Pages that are whole but not on the disk. */
    private final Map<String, WholeFiles.Content> ready = new LinkedHashMap<>();
    private GrowingFile sections;
    private int page;
    private int first;
    private int last;

    /**
     * An empty report.
     *
     * @param report its layout
     * @param folder where it goes, which exists
     * @param photos how many it may come to have
     */
    ReportPages(HtmlReport report, Path folder, int photos) {
        this.report = report;
        this.folder = folder;
        parts = photos > PHOTOS_A_PAGE;
    }

    /**
     * Adds an input.
     *
     * @param number of it, from 1; numbers rise
     * @param section what to say of it
     * @param view its result; null where there is none
     * @throws IOException if the folder takes no more
     */
    void add(int number, PhotoSection section, ResultView view) throws IOException {
        int itsPage = parts ? (number - 1) / PHOTOS_A_PAGE + 1 : 1;
        if (sections != null && itsPage != page) {
            endPart(false);
            write(folder);
        }
        if (sections == null) {
            sections = new GrowingFile(folder.resolve(MAIN), RESERVED_BYTES);
            page = itsPage;
            first = number;
        }
        sections.append(section.html());
        last = number;
        rows.append(section.row(""));
        byWord.merge(section.word(), 1, Integer::sum);
        if (parts && section.isNotable() && ++notable <= MOST_NOTABLE) {
            notableRows.append(section.row(file(page)));
        }
        if (view != null) {
            trend.add(number, view);
        }
    }

    private static String file(int page) {
        return String.format(Decimal.POINT, "report-%03d.html", page);
    }

    /** Makes a page of what has grown. */
    private void endPart(boolean isLast) throws IOException {
        String title = "photos " + first + " to " + last;
        String links = "<p><a href=\"" + MAIN + "\">The run as a whole</a>"
                + (page == 1 ? "" : " &nbsp; <a href=\"" + file(page - 1) + "\">the page before</a>")
                + (isLast ? "" : " &nbsp; <a href=\"" + file(page + 1) + "\">the next page</a>") + "</p>\n";
        partRows.append("<tr><td><a href=\"").append(file(page)).append("\">").append(title)
                .append("</a></td><td class=\"text\">").append(Html.escape(BatchOutcome.words(byWord)))
                .append("</td></tr>\n");
        ready.put(file(page), report.part(title, links, HtmlReport.overview(rows.toString()), taken()));
        rows.setLength(0);
        byWord.clear();
    }

    /** The sections so far; their file goes, so that there is room for the page. */
    private byte[] taken() throws IOException {
        if (sections == null) {
            return new byte[0];
        }
        byte[] bytes = sections.bytes();
        sections.close();
        sections = null;
        return bytes;
    }

    /** Writes what is ready; where that fails it stays so, for another folder. */
    private void write(Path into) throws IOException {
        Map<Path, WholeFiles.Content> files = new LinkedHashMap<>();
        ready.forEach((name, content) -> files.put(into.resolve(name), content));
        WholeFiles.writeContents(files);
        ready.clear();
    }

    /**
     * Ends the report, of however many photos it has by now, and deletes pages that an earlier one had more. Where it
     * fails it can be tried again with another folder.
     *
     * @param total one line about the whole run
     * @param into where the last page and {@code report.html} go, which exists
     * @throws IOException if they cannot be written
     */
    void finish(String total, Path into) throws IOException {
        if (!ready.containsKey(MAIN)) {
            if (parts) {
                if (sections != null) {
                    endPart(true);
                }
                String notables = notable == 0 ? "" : "<h2>To look at first</h2>\n"
                        + HtmlReport.overview(notableRows.toString()) + (notable <= MOST_NOTABLE ? ""
                                : "<p>and " + (notable - MOST_NOTABLE) + " more on the pages below</p>\n");
                ready.put(MAIN, report.main(total, notables + "<h2>Pages</h2>\n<table>\n" + partRows + "</table>\n",
                        trend, new byte[0]));
            } else {
                ready.put(MAIN, report.main(total, HtmlReport.overview(rows.toString()), trend, taken()));
            }
        }
        write(into);
        deletePartsAfter(parts ? page : 0, into);
    }

    private static void deletePartsAfter(int last, Path folder) throws IOException {
        try (DirectoryStream<Path> files = Files.newDirectoryStream(folder, "report-*.html")) {
            for (Path file : files) {
                Matcher name = PART.matcher(file.getFileName().toString());
                if (name.matches() && Integer.parseInt(name.group(1)) > last
                        && Files.isRegularFile(file, LinkOption.NOFOLLOW_LINKS)) {
                    Files.deleteIfExists(file);
                }
            }
        }
    }

    /** Gives up what has not been written. */
    @Override
    public void close() throws IOException {
        if (sections != null) {
            sections.close();
        }
    }
}
