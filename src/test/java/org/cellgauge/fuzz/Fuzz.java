package org.cellgauge.fuzz;

import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.SplittableRandom;
import org.cellgauge.cell.InputRefusedException;

/**
 * Tries a reader, or whole checks, on mutated inputs (docs/robustness.md). Every input is named by the seed and its
 * number, so that one alone can be tried again.
 */
public final class Fuzz {
    /** Longest processor time of one input, ms. */
    private static final long MOST_MS = 2000;
    /** Longest message of a refusal, in characters. */
    private static final int LONGEST_MESSAGE = 3000;
    private static final int MOST_FAULTS = 20;
    /** Processor time after which an input counts as one that never ends, ms. */
    private static final long HANGS_MS = 20_000;

    private final Target target;
    private final long seed;
    private final List<byte[]> corpus;
    private final ThreadMXBean threads = ManagementFactory.getThreadMXBean();
    private final List<String> faults = new ArrayList<>();
    private long refused;
    private long tried;
    private long longestMs;
    /** The input at work, and the processor time at which it began. */
    private volatile long current = -1;
    private volatile long startedNs;

    Fuzz(Target target, long seed, Path root) throws IOException {
        this.target = target;
        this.seed = seed;
        this.corpus = target.corpus(root);
        // without a fault, or mutations of it say little
        corpus.forEach(target::read);
    }

    /** The input of a number. */
    byte[] input(long number) {
        SplittableRandom random = new SplittableRandom(seed * 0x9E3779B97F4A7C15L + number);
        byte[] whole = corpus.get(random.nextInt(corpus.size()));
        return target.mutated(whole, new Mutator(random), corpus);
    }

    /** Tries the input of a number; a fault is kept. */
    void tryOne(long number) {
        byte[] input = input(number);
        startedNs = threads.getCurrentThreadCpuTime();
        current = number;
        String fault = "";
        try {
            target.read(input);
        } catch (InputRefusedException e) {
            refused++;
            String message = e.getMessage();
            // of a hole in a pattern; the file's own words stand in messages too
            boolean hole = (message.contains("null)") || message.contains("%s"))
                    && !new String(input, StandardCharsets.UTF_8).matches("(?s).*(null\\)|%s).*");
            if (message.length() > LONGEST_MESSAGE || hole) {
                fault = "message: " + message.substring(0, Math.min(200, message.length()));
            }
        } catch (RuntimeException | Error e) {
            fault = e + " at " + (e.getStackTrace().length > 0 ? e.getStackTrace()[0] : "?");
        }
        long ms = (threads.getCurrentThreadCpuTime() - startedNs) / 1_000_000;
        current = -1;
        longestMs = Math.max(longestMs, ms);
        tried++;
        if (fault.isEmpty() && ms > MOST_MS) {
            fault = ms + " ms";
        }
        if (!fault.isEmpty()) {
            faults.add(target + ", seed " + seed + ", number " + number + ": " + fault);
        }
    }

    /** Ends the process, and says where it is, when an input of a thread does not end. */
    private void watch(Thread worker, Path root) {
        Thread guard = new Thread(() -> {
            while (worker.isAlive()) {
                long number = current;
                long ms = (threads.getThreadCpuTime(worker.getId()) - startedNs) / 1_000_000;
                if (number >= 0 && number == current && ms > HANGS_MS) {
                    System.out.println(target + ", seed " + seed + ", number " + number + ": does not end");
                    for (StackTraceElement at : worker.getStackTrace()) {
                        System.out.println("    at " + at);
                    }
                    try {
                        keep(number, root);
                    } catch (IOException e) {
                        System.out.println("not kept: " + e);
                    }
                    Runtime.getRuntime().halt(1);
                }
                try {
                    Thread.sleep(1000);
                } catch (InterruptedException e) {
                    return;
                }
            }
        }, "guard");
        guard.setDaemon(true);
        guard.start();
    }

    private void keep(long number, Path root) throws IOException {
        Path folder = Files.createDirectories(root.resolve("out/fuzz-faults"));
        Files.write(folder.resolve(target + "-" + seed + "-" + number), input(number));
    }

    List<String> faults() {
        return faults;
    }

    @Override
    public String toString() {
        return String.format(Locale.ROOT, "%s: %d inputs from seed %d, %d refused, %d faults, longest %d ms", target,
                tried, seed, refused, faults.size(), longestMs);
    }

    /**
     * Tries inputs until their number or the time is reached.
     *
     * @param args target (or {@code all}), how many inputs, seed, most seconds for each target, first number; all but
     *     the first may be left out
     * @throws IOException if the fixtures cannot be read, or an input with a fault not be written to
     *     {@code out/fuzz-faults}
     */
    public static void main(String[] args) throws IOException {
        String name = args.length > 0 ? args[0].toUpperCase(Locale.ROOT) : "ALL";
        long count = args.length > 1 ? Long.parseLong(args[1]) : 100_000;
        long seed = args.length > 2 ? Long.parseLong(args[2]) : 1;
        long seconds = args.length > 3 ? Long.parseLong(args[3]) : 600;
        long first = args.length > 4 ? Long.parseLong(args[4]) : 0;
        Path root = Path.of(System.getProperty("cellgauge.root", "."));
        boolean sound = true;
        for (Target target : name.equals("ALL") ? Target.values() : new Target[] {Target.valueOf(name)}) {
            Fuzz fuzz = new Fuzz(target, seed, root);
            fuzz.watch(Thread.currentThread(), root);
            long end = System.nanoTime() + seconds * 1_000_000_000L;
            for (long i = first; i < first + count && System.nanoTime() < end; i++) {
                int before = fuzz.faults.size();
                if (before == MOST_FAULTS) {
                    break;
                }
                fuzz.tryOne(i);
                if (fuzz.faults.size() > before) {
                    System.out.println(fuzz.faults.get(before));
                    fuzz.keep(i, root);
                }
            }
            System.out.println(fuzz);
            sound &= fuzz.faults.isEmpty();
        }
        System.exit(sound ? 0 : 1);
    }
}
