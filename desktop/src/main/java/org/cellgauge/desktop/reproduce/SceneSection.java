package org.cellgauge.desktop.reproduce;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.cellgauge.desktop.render.GreyJpeg;
import org.cellgauge.vision.GreyImage;

/** Table 8.2 and the photos of the thesis: the scene of each experiment, as rendered. */
final class SceneSection implements Section {
    private static final int SHRUNK = 5;
    private static final int COLUMNS = 4;
    private static final int QUALITY = 70;
    private static final int WHITE = 255;

    private final Map<String, List<SetUp>> scenes = new LinkedHashMap<>();
    private final List<Work> works = new ArrayList<>();

    SceneSection(Assumptions assumptions, Map<String, SetUp> setUps) {
        for (SetUp setUp : setUps.values()) {
            String scene = setUp.references() + " " + setUp.objects() + " " + setUp.cameraPose();
            if (!scenes.containsKey(scene)) {
                works.add(new Work("scene-" + setUp.name(), scene + assumptions.identity(),
                        () -> shrunk(setUp.photo(assumptions).image())));
            }
            scenes.computeIfAbsent(scene, s -> new ArrayList<>()).add(setUp);
        }
    }

    private static Figures shrunk(GreyImage image) {
        int width = image.widthPx() / SHRUNK;
        int height = image.heightPx() / SHRUNK;
        double[] grey = new double[width * height];
        for (int y = 0; y < height; y++) {
            for (int x = 0; x < width; x++) {
                double sum = 0;
                for (int i = 0; i < SHRUNK * SHRUNK; i++) {
                    sum += image.get(x * SHRUNK + i % SHRUNK, y * SHRUNK + i / SHRUNK);
                }
                grey[y * width + x] = Math.rint(sum / (SHRUNK * SHRUNK));
            }
        }
        return new Figures.Builder().put("size", width, height).put("grey", grey).build();
    }

    @Override
    public String id() {
        return "8.2";
    }

    @Override
    public List<String> alsoCalled() {
        return List.of("figure-7.1", "figure-8.2", "figure-8.5", "figure-8.6", "figure-8.7", "figure-9.1", "figure-9.2",
                "figure-9.3");
    }

    @Override
    public String title() {
        return "Table 8.2, Figures 7.1, 8.2, 8.5 to 8.7, 9.1 to 9.3: the scenes, as rendered";
    }

    @Override
    public List<Work> needs() {
        return works;
    }

    @Override
    public void write(Page page, Results results) {
        page.heading(3, title());
        page.paragraph("The thesis took photos; these are rendered (blur, noise, sRGB, no distortion), and their "
                + "markers were "
                + "detected in them. Of Table 8.2, the three scenarios, little is left in the copy: one object inside "
                + "the grid, "
                + "one outside, one turned; scenario 2 has one of them on a book, scenario 3 one turned by 60 degrees "
                + "about x.");
        List<String> names = new ArrayList<>();
        scenes.values().forEach(of -> names.add((names.size() + 1) + " "
                + String.join(", ", of.stream().map(SetUp::name).toList())));
        page.picture("scenes.jpg", "Rendered scenes, " + COLUMNS + " to a row", sheet(results));
        page.paragraph("Row by row: " + String.join("; ", names) + ".");
    }

    private byte[] sheet(Results results) {
        double[] size = results.of(works.get(0).name()).all("size");
        int width = (int) size[0];
        int height = (int) size[1];
        int rows = (works.size() + COLUMNS - 1) / COLUMNS;
        byte[] pixels = new byte[COLUMNS * (width + 4) * rows * (height + 4)];
        Arrays.fill(pixels, (byte) WHITE);
        for (int i = 0; i < works.size(); i++) {
            double[] grey = results.of(works.get(i).name()).all("grey");
            int left = i % COLUMNS * (width + 4) + 2;
            int top = i / COLUMNS * (height + 4) + 2;
            for (int k = 0; k < grey.length; k++) {
                pixels[(top + k / width) * COLUMNS * (width + 4) + left + k % width] = (byte) (int) grey[k];
            }
        }
        try {
            return GreyJpeg.encode(GreyImage.packed(pixels, COLUMNS * (width + 4), rows * (height + 4)), QUALITY);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }
}
