package org.cellgauge.android.files;

import android.content.Context;
import android.graphics.Bitmap;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.time.Clock;
import java.time.LocalDate;
import java.time.LocalDateTime;
import java.time.format.DateTimeFormatter;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import org.cellgauge.android.state.LensKnowledge;
import org.cellgauge.check.CheckResult;
import org.cellgauge.internal.cell.CellWriter;
import org.cellgauge.internal.overlay.CellOverlay;
import org.cellgauge.internal.overlay.OverlayStyle;
import org.cellgauge.output.ResultJson;
import org.cellgauge.output.ResultRecord;
import org.cellgauge.vision.GreyImage;
import org.cellgauge.warning.Refusal;

/**
 * Results in the app's own storage, where they need no permission and outlast everything but the app's removal. The
 * user sees, copies, shares and deletes them in the system's Files app, to which {@link ResultProvider} shows them.
 *
 * <p>A result is a folder of its own, named after the time: {@code NAME.png} (the photo, grey, without loss),
 * {@code NAME.result.json} (as the command line writes it), {@code NAME.overlay.png} (in the language of the app) and
 * {@code NAME.cell.yaml} (with the camera that was used, and the command that makes the figures again).
 */
public final class FolderArchive implements ResultArchive {
    private static final DateTimeFormatter TIME = DateTimeFormatter.ofPattern("yyyyMMdd-HHmmss", Locale.ROOT);
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
    public SavedResult save(Photo photo, CheckResult result) throws IOException {
        try {
            return saveWhole(photo, result);
        } catch (OutOfMemoryError e) {
            throw new NotSavedException(Refusal.of(FileRefusal.RESULT_MEMORY), e);
        }
    }

    private synchronized SavedResult saveWhole(Photo photo, CheckResult result) throws IOException {
        String name = store.freeName("cellgauge-" + LocalDateTime.now(clock).format(TIME));
        byte[] png = GreyPng.encode(photo.luminance());
        String command = DesktopCommand.of(name, result.settings());
        byte[] cell = utf8(CellWriter.text(result.cell(), Arrays.asList(
                "Cell and camera of the result " + name + ", made by CellGauge " + version + " on an Android device.",
                "The same figures on another machine:", command)));
        ResultRecord record = ResultRecord.of(name + ".png", sha256(png), version).withCommand(command)
                .withCell(name + ".cell.yaml", sha256(cell)).withDate(LocalDate.now(clock).toString());
        Map<String, byte[]> files = new LinkedHashMap<>();
        files.put(name + ".png", png);
        files.put(name + ".result.json", utf8(ResultJson.of(result, record)));
        files.put(name + ".overlay.png", overlayPng(photo.luminance(), result));
        files.put(name + ".cell.yaml", cell);
        store.write(name, files);
        links.changed();
        return saved(name);
    }

    private byte[] overlayPng(GreyImage photo, CheckResult result) throws IOException {
        OverlayStyle style = OverlayStyle.PHOTO.withLabels(words.labels()).withLegend(words.legend());
        boolean measured = LensKnowledge.isMeasured(result);
        Bitmap picture = overlay.paint(photo, CellOverlay.of(LensKnowledge.drawn(result, measured), style,
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
}
