package org.cellgauge.desktop;

import java.util.Optional;
import org.cellgauge.warning.Refusal;
import org.cellgauge.warning.RefusalKind;

/** Why a computer cannot do what it is asked: limits that are no fault of a file. */
public enum MachineRefusal implements RefusalKind {
    /** Too little memory: MB that there are. */
    MEMORY("this takes more memory than Java may use (%s MB); use smaller images, fewer chains or fewer iterations"),
    /** Too many files at once. */
    OPEN_FILES("the system lets this process open no more files; raise its limit (ulimit -n)");

    private final String english;

    MachineRefusal(String english) {
        this.english = english;
    }

    @Override
    public String english() {
        return english;
    }

    /**
     * The limit behind an error, which libraries often wrap into errors of their own.
     *
     * @param error anything that was thrown
     * @return what to say of it, without a place; empty where no limit is behind it
     */
    public static Optional<Refusal> behind(Throwable error) {
        int depth = 0;
        for (Throwable t = error; t != null && depth < 100; t = t.getCause(), depth++) {
            if (t instanceof OutOfMemoryError) {
                return Optional.of(Refusal.of(MEMORY, (int) (Runtime.getRuntime().maxMemory() / (1 << 20))));
            }
            if (t.getMessage() != null && t.getMessage().contains("Too many open files")) {
                return Optional.of(Refusal.of(OPEN_FILES));
            }
        }
        return Optional.empty();
    }
}
