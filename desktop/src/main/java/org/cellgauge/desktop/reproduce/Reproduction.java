package org.cellgauge.desktop.reproduce;

import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.stream.Collectors;
import org.cellgauge.desktop.ResultFolder;
import org.cellgauge.desktop.StopSignal;
import org.cellgauge.desktop.WholeFiles;

/**
 * The experiments of the thesis, run again and written down as a page. What is done is kept in a folder, so that a run
 * that was stopped goes on where it was. The same figures whatever the number of threads.
 */
public final class Reproduction {
    /** Name of the page. */
    public static final String PAGE = "thesis.md";
    private static final String PICTURES = "thesis";
    private static final String KEPT = "figures";

    private final Contents contents;
    private final Path folder;
    private final String version;

    /**
     * A reproduction.
     *
     * @param quick whether four chains and rough deviations do, in place of the twenty of the page in docs
     * @param folder where the page goes, its pictures below it, and figures that are kept
     * @param version of the program: figures of another are not taken
     */
    public Reproduction(boolean quick, Path folder, String version) {
        this.contents = new Contents(quick ? Effort.QUICK : Effort.FULL);
        this.folder = folder;
        this.version = version;
    }

    /** Is told how far it is; not twice at a time. */
    public interface Listener {
        /**
         * A piece of work is done.
         *
         * @param name what it was
         * @param number how many are done with it
         * @param count how many there are
         * @param seconds it took; 0 where it was kept from an earlier run
         */
        void done(String name, int number, int count, double seconds);
    }

    /**
     * The parts of the page that can be asked for.
     *
     * @return their titles by what they are called: numbers of tables, {@code figure-7.2}, {@code conclusions}
     */
    public Map<String, String> parts() {
        Map<String, String> parts = new LinkedHashMap<>();
        contents.sections().forEach(section -> {
            parts.put(section.id(), section.title());
            section.alsoCalled().forEach(name -> parts.put(name, section.title()));
        });
        return parts;
    }

    /**
     * Runs what the page needs and writes it.
     *
     * @param threads how many pieces of work are done at once
     * @param stop ends it early; what is done is kept
     * @param listener is told how far it is
     * @return the page; empty where it was stopped
     * @throws ResultFolder.UnwritableException if the folder takes no files
     */
    public Optional<Path> page(int threads, StopSignal stop, Listener listener) {
        Map<String, Figures> figures = figures(contents.sections(), threads, stop, listener);
        if (stop.isGiven()) {
            return Optional.empty();
        }
        Page page = contents.page(PICTURES, results(figures));
        if (!page.pictures().isEmpty()) {
            Map<String, WholeFiles.Content> pictures = new LinkedHashMap<>();
            page.pictures().forEach((name, bytes) -> pictures.put(name, out -> out.write(bytes)));
            ResultFolder.into(folder.resolve(PICTURES)).write(pictures);
        }
        byte[] text = page.text().getBytes(StandardCharsets.UTF_8);
        ResultFolder.into(folder).write(Map.of(PAGE, out -> out.write(text)));
        return Optional.of(folder.resolve(PAGE));
    }

    /**
     * Runs what some parts need.
     *
     * @param parts keys of {@link #parts()}
     * @param threads as for the page
     * @param stop as for the page
     * @param listener as for the page
     * @return these parts as Markdown, without their pictures; empty where it was stopped
     * @throws ResultFolder.UnwritableException if the folder takes no figures
     */
    public Optional<String> text(List<String> parts, int threads, StopSignal stop, Listener listener) {
        List<Section> sections = contents.sections().stream()
                .filter(s -> parts.contains(s.id()) || s.alsoCalled().stream().anyMatch(parts::contains)).toList();
        Map<String, Figures> figures = figures(sections, threads, stop, listener);
        if (stop.isGiven()) {
            return Optional.empty();
        }
        Page page = new Page(PICTURES);
        sections.forEach(section -> section.write(page, results(figures)));
        return Optional.of(page.text().lines().filter(line -> !line.startsWith("!["))
                .collect(Collectors.joining("\n")).replaceAll("\n{3,}", "\n\n").strip() + "\n");
    }

    private static Section.Results results(Map<String, Figures> figures) {
        return name -> {
            Figures found = figures.get(name);
            if (found == null) {
                throw new IllegalStateException("a section did not ask for " + name);
            }
            return found;
        };
    }

    private Map<String, Figures> figures(List<Section> sections, int threads, StopSignal stop, Listener listener) {
        KeptFigures kept = new KeptFigures(ResultFolder.into(folder.resolve(PICTURES).resolve(KEPT)), version);
        Map<String, Work> works = new LinkedHashMap<>();
        sections.forEach(section -> section.needs().forEach(work -> works.putIfAbsent(work.name(), work)));
        Map<String, Figures> figures = new ConcurrentHashMap<>();
        AtomicInteger done = new AtomicInteger();
        ExecutorService pool = Executors.newFixedThreadPool(threads);
        try {
            List<Future<?>> running = new ArrayList<>();
            for (Work work : works.values()) {
                running.add(pool.submit(() -> {
                    if (stop.isGiven()) {
                        return;
                    }
                    long start = System.nanoTime();
                    Optional<Figures> earlier = kept.of(work);
                    Figures found = earlier.orElseGet(work.figures());
                    if (earlier.isEmpty()) {
                        kept.keep(work, found);
                    }
                    figures.put(work.name(), found);
                    synchronized (listener) {
                        listener.done(work.name(), done.incrementAndGet(), works.size(),
                                earlier.isPresent() ? 0 : (System.nanoTime() - start) * 1e-9);
                    }
                }));
            }
            for (Future<?> future : running) {
                await(future);
            }
        } finally {
            pool.shutdownNow();
        }
        return figures;
    }

    private static void await(Future<?> future) {
        try {
            future.get();
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new IllegalStateException("interrupted", e);
        } catch (ExecutionException e) {
            if (e.getCause() instanceof RuntimeException) {
                throw (RuntimeException) e.getCause();
            }
            if (e.getCause() instanceof Error) {
                throw (Error) e.getCause();
            }
            throw new IllegalStateException(e.getCause());
        }
    }
}
