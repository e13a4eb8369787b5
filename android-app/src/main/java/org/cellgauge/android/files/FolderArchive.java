package org.cellgauge.android.files;

import android.content.Context;
import android.graphics.Bitmap;
import java.io.BufferedReader;
import java.io.ByteArrayOutputStream;
import java.io.File;
import java.io.FileInputStream;
import java.io.FileNotFoundException;
import java.io.IOException;
import java.io.InputStreamReader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.time.Clock;
import java.time.LocalDate;
import java.time.LocalDateTime;
import java.time.format.DateTimeFormatter;
import java.time.format.DateTimeParseException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.cellgauge.cell.InputRefusedException;
import org.cellgauge.check.CheckResult;
import org.cellgauge.internal.cell.CellWriter;
import org.cellgauge.internal.overlay.CellOverlay;
import org.cellgauge.internal.overlay.OverlayStyle;
import org.cellgauge.output.ResultJson;
import org.cellgauge.output.ResultReader;
import org.cellgauge.output.ResultRecord;
import org.cellgauge.vision.GreyImage;
import org.cellgauge.warning.Place;
import org.cellgauge.warning.Refusal;

/**
 * Results in the app's own storage, where they need no permission and outlast everything but the app's removal. The
 * user sees, copies, shares and deletes them in the system's Files app, to which {@link ResultProvider} shows them.
 *
 * <p>A result is a folder of its own, named after the time: {@code NAME.png} (the photo, grey, without loss),
 * {@code NAME.result.json} (as the command line writes it), {@code NAME.overlay.png} (in the language of the app) and
 * {@code NAME.cell.yaml} (with the camera that was used, the name that the cell file had, and the command that makes
 * the figures again).
 */
public final class FolderArchive implements ResultArchive {
    private static final DateTimeFormatter TIME = DateTimeFormatter.ofPattern("yyyyMMdd-HHmmss", Locale.ROOT);
    private static final Pattern TIME_IN_NAME = Pattern.compile("cellgauge-(\\d{8}-\\d{6})(?:-\\d+)?");
    private static final String RESULT = ".result.json";
    private static final String CELL = ".cell.yaml";
    private static final String PICTURE = ".overlay.png";
    /** Before the name of the cell file, in a remark of the one that is kept. */
    private static final String FROM_CELL = "From the cell file: ";
    private static final int BEST = 100;

    private final ResultStore store;
    private final ResultLinks links;
    private final OverlayPicture overlay;
    private final PictureWords words;
    private final Clock clock;
    private final String version;

    /**
     * The archive of the app.
     *
     * @param context of the app
     * @param overlay paints the overlay's picture
     * @param words what that picture says
     * @param clock tells what results are named after, in its time zone
     * @param version of this program, for the result file
     */
    public FolderArchive(Context context, OverlayPicture overlay, PictureWords words, Clock clock, String version) {
        this(ResultProvider.store(context), ResultProvider.links(context), overlay, words, clock, version);
    }

    /** An archive on any disk. */
    FolderArchive(ResultStore store, ResultLinks links, OverlayPicture overlay, PictureWords words, Clock clock,
            String version) {
        this.store = store;
        this.links = links;
        this.overlay = overlay;
        this.words = words;
        this.clock = clock;
        this.version = version;
    }

    /** What other apps know results by. */
    interface ResultLinks {
        /**
         * The address of a file.
         *
         * @param result name of the result
         * @param file name of the file
         * @return a content URI
         */
        String of(String result, String file);

        /** Results came or went. */
        void changed();
    }

    @Override
    public SavedResult save(Photo photo, CheckResult result, String cellName) throws IOException {
        try {
            return saveWhole(photo, result, cellName);
        } catch (OutOfMemoryError e) {
            throw new NotSavedException(Refusal.of(FileRefusal.RESULT_MEMORY), e);
        }
    }

    private synchronized SavedResult saveWhole(Photo photo, CheckResult result, String cellName)
            throws IOException {
        String name = store.freeName("cellgauge-" + LocalDateTime.now(clock).format(TIME));
        byte[] png = GreyPng.encode(photo.luminance());
        String command = DesktopCommand.of(name, result.settings());
        byte[] cell = utf8(CellWriter.text(result.cell(), Arrays.asList(
                "Cell and camera of the result " + name + ", made by CellGauge " + version + " on an Android device.",
                FROM_CELL + cellName,
                "The same figures on another machine:", command)));
        ResultRecord record = ResultRecord.of(name + ".png", sha256(png), version).withCommand(command)
                .withCell(name + CELL, sha256(cell)).withDate(LocalDate.now(clock).toString());
        Map<String, byte[]> files = new LinkedHashMap<>();
        files.put(name + ".png", png);
        files.put(name + RESULT, utf8(ResultJson.of(result, record)));
        files.put(name + PICTURE, overlayPng(photo.luminance(), result));
        files.put(name + CELL, cell);
        store.write(name, files);
        links.changed();
        return saved(name);
    }

    private byte[] overlayPng(GreyImage photo, CheckResult result) throws IOException {
        OverlayStyle style = OverlayStyle.PHOTO.withLabels(words.labels()).withLegend(words.legend());
        boolean measured = DrawnResult.isLensMeasured(result);
        Bitmap picture = overlay.paint(photo, CellOverlay.of(DrawnResult.of(result, measured), style,
                words.headline(result.verdict(), measured), words.reason(result.finding())));
        ByteArrayOutputStream out = new ByteArrayOutputStream(1 << 20);
        boolean written = picture.compress(Bitmap.CompressFormat.PNG, BEST, out);
        picture.recycle();
        if (!written) {
            throw new NotSavedException(Refusal.of(FileRefusal.PICTURE_NOT_WRITTEN), null);
        }
        return out.toByteArray();
    }

    private static byte[] utf8(String text) {
        return text.getBytes(StandardCharsets.UTF_8);
    }

    private static String sha256(byte[] bytes) {
        MessageDigest digest;
        try {
            digest = MessageDigest.getInstance("SHA-256");
        } catch (NoSuchAlgorithmException e) {
            throw new IllegalStateException("every Android has SHA-256", e);
        }
        StringBuilder hex = new StringBuilder();
        for (byte b : digest.digest(bytes)) {
            hex.append(Character.forDigit((b >> 4) & 0xF, 16)).append(Character.forDigit(b & 0xF, 16));
        }
        return hex.toString();
    }

    @Override
    public List<SavedResult> saved() {
        List<SavedResult> saved = new ArrayList<>();
        for (String name : store.names()) {
            saved.add(saved(name));
        }
        return saved;
    }

    private SavedResult saved(String name) {
        List<String> uris = new ArrayList<>();
        for (String file : store.files(name)) {
            uris.add(links.of(name, file));
        }
        return new SavedResult(name, uris);
    }

    @Override
    public List<KeptResult> kept() {
        List<KeptResult> kept = new ArrayList<>();
        for (SavedResult saved : saved()) {
            // one that was deleted meanwhile is left out
            if (store.result(saved.name()) != null) {
                kept.add(read(saved));
            }
        }
        return kept;
    }

    private KeptResult read(SavedResult saved) {
        String name = saved.name();
        LocalDateTime time = time(name);
        File result = store.file(name, name + RESULT);
        try {
            if (result != null) {
                return new KeptResult(saved, time, cellName(name), ResultReader.read(result.toPath()));
            }
        } catch (InputRefusedException e) {
            // what is wrong with it in detail is of no use to who cannot edit it
            return notRead(saved, time);
        }
        return notRead(saved, time);
    }

    private static KeptResult notRead(SavedResult saved, LocalDateTime time) {
        return new KeptResult(saved, time, Refusal.at(Place.of(saved.name() + RESULT), FileRefusal.RESULT_NOT_READ));
    }

    private static LocalDateTime time(String name) {
        Matcher parts = TIME_IN_NAME.matcher(name);
        try {
            return parts.matches() ? LocalDateTime.parse(parts.group(1), TIME) : null;
        } catch (DateTimeParseException e) {
            return null;
        }
    }

    /** The name that the cell file had; null in results of versions that did not keep it. */
    private String cellName(String name) {
        File cell = store.file(name, name + CELL);
        if (cell == null) {
            return null;
        }
        try (BufferedReader in = new BufferedReader(new InputStreamReader(new FileInputStream(cell),
                StandardCharsets.UTF_8))) {
            for (String line = in.readLine(); line != null && line.startsWith("# "); line = in.readLine()) {
                if (line.startsWith("# " + FROM_CELL)) {
                    return line.substring(2 + FROM_CELL.length());
                }
            }
            return null;
        } catch (IOException e) {
            return null;
        }
    }

    @Override
    public byte[] picture(String name) throws IOException {
        File picture = store.file(name, name + PICTURE);
        if (picture == null) {
            throw new FileNotFoundException(name + PICTURE);
        }
        return Files.readAllBytes(picture.toPath());
    }

    @Override
    public boolean delete(String name) {
        boolean gone = store.delete(name);
        if (gone) {
            links.changed();
        }
        return gone;
    }
}
