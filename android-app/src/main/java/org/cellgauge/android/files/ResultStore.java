package org.cellgauge.android.files;

import android.system.ErrnoException;
import android.system.OsConstants;
import java.io.File;
import java.io.FileOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.regex.Pattern;
import org.cellgauge.warning.Refusal;

/**
 * A folder with one folder per result, each written whole or not at all: under another name first, on the disk to the
 * last byte, then renamed. What an ended app or an empty battery left half done goes with the next writing.
 */
final class ResultStore {
    /** Names of results and of their files: they stand in addresses, and none leads out of its folder. */
    private static final Pattern NAME = Pattern.compile("[A-Za-z0-9][A-Za-z0-9._-]{0,120}");
    private static final String UNDER_WAY = ".writing-";
    private static final String GOING = ".deleted-";
    /** Space that must be left beside what is written: folders and the file system's own bookkeeping take some. */
    private static final long MARGIN_BYTES = 1 << 20;

    private final File folder;
    private final Disk disk;

    /** What the store needs of a disk; one of a test can be full. */
    interface Disk {
        /**
         * Opens a new file.
         *
         * @param file the file
         * @return takes its bytes; {@link Whole#sync} before it is closed
         * @throws IOException if it cannot be made
         */
        Whole create(File file) throws IOException;

        /**
         * Space that is left.
         *
         * @param folder somewhere on the disk
         * @return bytes, or 0 where nobody knows
         */
        long freeBytes(File folder);
    }

    /** A file under way. */
    abstract static class Whole extends OutputStream {
        /**
         * Waits until all that was written is on the disk.
         *
         * @throws IOException if it is not
         */
        abstract void sync() throws IOException;
    }

    /** The device's own disk. */
    static final class RealDisk implements Disk {
        @Override
        public Whole create(File file) throws IOException {
            FileOutputStream out = new FileOutputStream(file);
            return new Whole() {
                @Override
                public void write(int b) throws IOException {
                    out.write(b);
                }

                @Override
                public void write(byte[] bytes, int from, int count) throws IOException {
                    out.write(bytes, from, count);
                }

                @Override
                void sync() throws IOException {
                    out.getFD().sync();
                }

                @Override
                public void close() throws IOException {
                    out.close();
                }
            };
        }

        @Override
        public long freeBytes(File folder) {
            return folder.getUsableSpace();
        }
    }

    /**
     * A store.
     *
     * @param folder where results are kept; made when the first comes
     * @param disk the disk that it is on
     */
    ResultStore(File folder, Disk disk) {
        this.folder = folder;
        this.disk = disk;
    }

    /**
     * A name that no result has.
     *
     * @param wanted the name that it should have
     * @return that name, or the first of it with "-2", "-3" and so on behind it that is free
     */
    String freeName(String wanted) {
        String name = wanted;
        for (int n = 2; new File(folder, name).exists(); n++) {
            name = wanted + "-" + n;
        }
        return name;
    }

    /**
     * Writes a result.
     *
     * @param name its name, one that is free
     * @param files bytes by file name
     * @throws StorageFullException if there is no room
     * @throws IOException if it cannot be written; nothing is left behind in either case
     */
    void write(String name, Map<String, byte[]> files) throws IOException {
        if (!folder.isDirectory() && !folder.mkdirs()) {
            throw new NotSavedException(Refusal.of(FileRefusal.NO_FOLDER_FOR_RESULTS), null);
        }
        clearLeftovers();
        long bytes = 0;
        for (byte[] content : files.values()) {
            bytes += content.length;
        }
        long free = disk.freeBytes(folder);
        if (free > 0 && free < bytes + MARGIN_BYTES) {
            throw new StorageFullException(bytes, free);
        }
        File underWay = new File(folder, UNDER_WAY + name);
        boolean whole = false;
        try {
            if (!underWay.mkdir()) {
                throw new NotSavedException(Refusal.of(FileRefusal.NO_FOLDER_FOR_RESULT), null);
            }
            for (Map.Entry<String, byte[]> file : files.entrySet()) {
                try (Whole out = disk.create(new File(underWay, file.getKey()))) {
                    out.write(file.getValue(), 0, file.getValue().length);
                    out.sync();
                }
            }
            if (!underWay.renameTo(new File(folder, name))) {
                throw new NotSavedException(Refusal.of(FileRefusal.RESULT_NOT_NAMED), null);
            }
            whole = true;
        } catch (IOException e) {
            throw isFull(e) ? new StorageFullException(bytes, disk.freeBytes(folder)) : e;
        } finally {
            if (!whole) {
                remove(underWay);
            }
        }
    }

    private static boolean isFull(IOException e) {
        for (Throwable cause = e; cause != null; cause = cause.getCause()) {
            if (cause instanceof ErrnoException && (((ErrnoException) cause).errno == OsConstants.ENOSPC
                    || ((ErrnoException) cause).errno == OsConstants.EDQUOT)) {
                return true;
            }
            String message = String.valueOf(cause.getMessage());
            if (message.contains("ENOSPC") || message.contains("EDQUOT") || message.contains("No space left")) {
                return true;
            }
        }
        return false;
    }

    /**
     * The names of all results.
     *
     * @return the newest first
     */
    List<String> names() {
        File[] found = folder.listFiles(file -> file.isDirectory() && NAME.matcher(file.getName()).matches());
        List<File> results = new ArrayList<>(Arrays.asList(found == null ? new File[0] : found));
        // read once, since a comparison of times that change while it runs would have no order
        List<Long> times = new ArrayList<>();
        results.forEach(file -> times.add(file.lastModified()));
        List<Integer> order = new ArrayList<>();
        for (int i = 0; i < results.size(); i++) {
            order.add(i);
        }
        Collections.sort(order, (a, b) -> {
            int byTime = Long.compare(times.get(b), times.get(a));
            return byTime != 0 ? byTime : results.get(b).getName().compareTo(results.get(a).getName());
        });
        List<String> names = new ArrayList<>();
        order.forEach(i -> names.add(results.get(i).getName()));
        return names;
    }

    /**
     * The names of a result's files.
     *
     * @param name its name
     * @return in alphabetical order; empty where there is no such result
     */
    List<String> files(String name) {
        File result = result(name);
        String[] found = result == null ? null : result.list((in, file) -> NAME.matcher(file).matches());
        List<String> files = new ArrayList<>(Arrays.asList(found == null ? new String[0] : found));
        Collections.sort(files);
        return files;
    }

    /**
     * The folder of a result.
     *
     * @param name its name, from anywhere
     * @return the folder, or null where there is no such result
     */
    File result(String name) {
        File result = inside(folder, name);
        return result != null && result.isDirectory() ? result : null;
    }

    /**
     * A file of a result.
     *
     * @param name name of the result, from anywhere
     * @param file name of the file, from anywhere
     * @return the file, or null where there is none
     */
    File file(String name, String file) {
        File result = result(name);
        File found = result == null ? null : inside(result, file);
        return found != null && found.isFile() ? found : null;
    }

    /** A direct child of a folder, or null where the name would lead elsewhere. */
    private static File inside(File folder, String name) {
        if (name == null || !NAME.matcher(name).matches()) {
            return null;
        }
        File child = new File(folder, name);
        try {
            // a link would lead out in spite of its name
            return child.getCanonicalFile().equals(new File(folder.getCanonicalFile(), name)) ? child : null;
        } catch (IOException e) {
            return null;
        }
    }

    /**
     * Removes a result with all of its files.
     *
     * @param name its name
     * @return whether there was one and it is gone
     */
    boolean delete(String name) {
        File result = result(name);
        if (result == null) {
            return false;
        }
        // under a hidden name at once: half a result is never seen
        File going = new File(folder, GOING + name);
        if (!result.renameTo(going)) {
            return false;
        }
        remove(going);
        return true;
    }

    private void clearLeftovers() {
        File[] leftovers = folder.listFiles(file -> file.getName().startsWith(UNDER_WAY)
                || file.getName().startsWith(GOING));
        if (leftovers != null) {
            for (File leftover : leftovers) {
                remove(leftover);
            }
        }
    }

    private static void remove(File folder) {
        File[] files = folder.listFiles();
        if (files != null) {
            for (File file : files) {
                // what cannot be removed now is tried again with the next writing
                file.delete();
            }
        }
        folder.delete();
    }
}
