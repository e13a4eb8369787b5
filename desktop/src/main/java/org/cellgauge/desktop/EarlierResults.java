package org.cellgauge.desktop;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.OptionalDouble;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.cellgauge.cell.Cell;
import org.cellgauge.cell.InputRefusedException;
import org.cellgauge.estimate.VarianceSource;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.output.CellView;
import org.cellgauge.output.ResultReader;
import org.cellgauge.output.ResultRecord;
import org.cellgauge.output.ResultView;
import org.cellgauge.output.StoredResult;
import org.cellgauge.settings.CheckSettings;
import org.cellgauge.settings.SamplerKind;
import org.cellgauge.settings.SettingTable;
import org.cellgauge.warning.RefusalKind;

/** What earlier runs left in a folder of the same inputs, cell and settings. */
final class EarlierResults {
    private static final Pattern THIN = Pattern.compile("(?m)^# *thin = (\\d{1,9})\\b");
    /** The line on thinning is among the first of a file of draws. */
    private static final int BYTES_OF_HEAD = 4096;

    private final ResultFolder folder;
    private final CellFile files;
    private final boolean calibrated;
    private final Cell cell;
    private final CheckSettings settings;

    /**
     * Results in a folder.
     *
     * @param folder where they are
     * @param files what the cell stands in
     * @param cell what they must rest on, but for its target, which must be one that can be held against them
     * @param settings what they must have been made with, but for the target
     */
    EarlierResults(ResultFolder folder, CellFile files, Cell cell, CheckSettings settings) {
        this.folder = folder;
        this.files = files;
        calibrated = cell.calibration() != null;
        this.cell = cell;
        this.settings = settings;
    }

    /**
     * The result of an input.
     *
     * @param input the input
     * @param sha256 of its bytes
     * @return as it is stored
     * @throws InputRefusedException if there is none of these bytes, this cell and these settings
     */
    StoredResult of(CheckInput input, String sha256) {
        Path path = folder.file(input.name() + ResultFolder.RESULT);
        if (!Files.exists(path)) {
            throw refused(input, BatchRefusal.NOT_STORED, folder.toString());
        }
        StoredResult stored = ResultReader.stored(path);
        ResultView view = stored.view();
        if (!sha256.equals(stored.record().inputSha256())) {
            throw refused(input, BatchRefusal.OTHER_INPUT);
        }
        if (!CellView.of(shownIn(view.cell().camera())).equals(view.cell()) || !isOfTheSameCalibration(stored)) {
            throw refused(input, BatchRefusal.OTHER_CELL);
        }
        if (!sampledAs(view).equals(view.run().settings().toBuilder()
                .set(SettingTable.TARGET_STD_MM, OptionalDouble.empty()).build())) {
            throw refused(input, BatchRefusal.OTHER_SETTINGS);
        }
        if (!view.canBeHeldAgainst(cell.target())) {
            throw refused(input, BatchRefusal.TOLERANCE_NEEDS_DRAWS);
        }
        return stored;
    }

    /** The cell as a photo showed it whose camera was, where settings have it, scaled. */
    private Cell shownIn(PinholeCamera camera) {
        boolean scaled = settings.model().get(SettingTable.SCALE_CAMERA)
                && cell.camera().hasShape(camera.widthPx(), camera.heightPx());
        return scaled ? cell.scaledTo(camera.widthPx(), camera.heightPx()) : cell;
    }

    /** What a calibration leaves open is in no result: where one counted, or counts now, its file must be the same. */
    private boolean isOfTheSameCalibration(StoredResult stored) {
        boolean counted = stored.view().objects().stream().flatMap(row -> row.budget().stream())
                .anyMatch(share -> share.source().equals(VarianceSource.CALIBRATION));
        if (!calibrated && !counted) {
            return true;
        }
        return files.cameraSha256() != null ? files.cameraSha256().equals(stored.record().cameraSha256())
                : files.sha256().equals(stored.record().cellSha256());
    }

    private static InputRefusedException refused(CheckInput input, RefusalKind kind, Object... arguments) {
        return new InputRefusedException(input.file().toString(), kind, arguments);
    }

    /** The settings of now as a result made with them holds them, but for the target. */
    private CheckSettings sampledAs(ResultView view) {
        CheckSettings.Builder builder = settings.toBuilder()
                .set(SettingTable.TARGET_STD_MM, OptionalDouble.empty())
                .set(SettingTable.THREADS, SettingTable.THREADS.usual());
        for (SamplerKind kind : SamplerKind.values()) {
            if (kind.word().equals(view.run().samplerUsed())) {
                builder.warmup(settings.sampling().warmup(kind));
            }
        }
        return builder.build();
    }

    /**
     * The result of an input that stands for one made now.
     *
     * @param input the input
     * @param now what one made now would be of
     * @param draws which files of draws are to be beside it
     * @return as it is stored; null where there is none, or not all that is asked for
     */
    StoredResult asIfMadeNow(CheckInput input, ResultRecord now, DrawFiles draws) {
        try {
            StoredResult stored = of(input, now.inputSha256());
            boolean whole = stored.record().inputName().equals(now.inputName())
                    && stored.record().version().equals(now.version())
                    && Files.isRegularFile(folder.file(input.name() + ResultFolder.OVERLAY))
                    && hasDraws(input, stored.view().run().settings().get(SettingTable.CHAINS), draws);
            return whole ? stored : null;
        } catch (InputRefusedException e) {
            // none, or one that is damaged or of something else: it is made anew
            return null;
        }
    }

    private boolean hasDraws(CheckInput input, int chains, DrawFiles draws) {
        for (int chain = 1; chain <= chains && draws != DrawFiles.NONE; chain++) {
            int thin = thin(folder.file(ResultFolder.chain(input.name(), chain)));
            if (thin < 1 || thin > 1 && draws == DrawFiles.ALL) {
                return false;
            }
        }
        return true;
    }

    /** Every how-manieth draw a file has; 0 where it is none. */
    private static int thin(Path file) {
        try (InputStream in = Files.newInputStream(file)) {
            Matcher thin = THIN.matcher(new String(in.readNBytes(BYTES_OF_HEAD), StandardCharsets.ISO_8859_1));
            return thin.find() ? Integer.parseInt(thin.group(1)) : 0;
        } catch (IOException e) {
            return 0;
        }
    }
}
