package org.cellgauge.desktop.reproduce;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** What stands on the page, in its order. */
final class Contents {
    private final Map<String, List<Section>> chapters = new LinkedHashMap<>();

    Contents(Effort effort) {
        Assumptions assumptions = Assumptions.usual();
        Map<String, SetUp> setUps = SetUp.all();
        Map<String, PrintedTable> tables = PrintedTable.all();
        chapters.put("The corrected decision table", List.of(new DecisionSection(assumptions, effort)));
        chapters.put("Chapters 7 to 9, table by table", new ArrayList<>());
        for (PrintedTable table : tables.values()) {
            chapters.get("Chapters 7 to 9, table by table")
                    .add(new TableSection(table, setUps, assumptions, effort));
        }
        chapters.put("Further research", List.of(new FurtherSection(assumptions, setUps, effort)));
    }

    List<Section> sections() {
        return chapters.values().stream().flatMap(List::stream).toList();
    }

    Page page(String pictureFolder, Section.Results results) {
        Page page = new Page(pictureFolder);
        page.heading(1, "The thesis, reproduced and corrected");
        chapters.forEach((title, sections) -> {
            page.heading(2, title);
            sections.forEach(section -> section.write(page, results));
        });
        return page;
    }
}
