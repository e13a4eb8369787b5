package org.cellgauge.android.screen;

import android.app.Activity;
import android.content.res.Configuration;
import android.graphics.Color;
import android.graphics.Insets;
import android.graphics.Rect;
import android.os.Build;
import android.view.View;
import android.view.Window;
import android.view.WindowInsets;
import android.view.WindowInsetsController;
import android.view.WindowManager;
import org.cellgauge.android.R;

/**
 * Keeps what is read and tapped clear of the system's bars and of the camera's cutout. From Android 11 on the app fills
 * the whole screen, as Android 15 has it for all apps: the banner's colour goes on behind the status bar, the picture
 * behind what is at its sides. Before, the system puts the app between its bars.
 */
final class SystemBars {

    private SystemBars() {
    }

    /** A view whose content gives way at some of its sides, besides the room that its layout leaves there. */
    private static final class Yielding {
        private final View view;
        private final Rect own;
        private final boolean left;
        private final boolean top;
        private final boolean right;
        private final boolean bottom;

        Yielding(View view, boolean left, boolean top, boolean right, boolean bottom) {
            this.view = view;
            this.own = new Rect(view.getPaddingLeft(), view.getPaddingTop(), view.getPaddingRight(),
                    view.getPaddingBottom());
            this.left = left;
            this.top = top;
            this.right = right;
            this.bottom = bottom;
        }

        void giveWay(Rect covered) {
            view.setPadding(own.left + (left ? covered.left : 0), own.top + (top ? covered.top : 0),
                    own.right + (right ? covered.right : 0), own.bottom + (bottom ? covered.bottom : 0));
        }
    }

    /**
     * Has the screen's content keep clear, now and whenever the bars change.
     *
     * @param activity whose content is there
     */
    static void keepClear(Activity activity) {
        // across, the list stands to the right of the picture
        Configuration shape = activity.getResources().getConfiguration();
        boolean across = shape.orientation == Configuration.ORIENTATION_LANDSCAPE;
        keepClear(activity, R.id.screen,
                new Yielding(activity.findViewById(R.id.banner), true, true, true, false),
                new Yielding(activity.findViewById(R.id.message), true, false, true, false),
                new Yielding(activity.findViewById(R.id.caption), true, false, true, false),
                new Yielding(activity.findViewById(R.id.panel), !across, false, true, false),
                new Yielding(activity.findViewById(R.id.bar), true, false, true, true));
    }

    /**
     * The same of a page below a heading.
     *
     * @param activity whose content is there
     * @param page all of it
     */
    static void keepPageClear(Activity activity, int page) {
        keepClear(activity, page, new Yielding(activity.findViewById(R.id.heading), true, true, true, false),
                new Yielding(activity.findViewById(R.id.below_heading), true, false, true, true));
    }

    private static void keepClear(Activity activity, int whole, Yielding... views) {
        if (Build.VERSION.SDK_INT >= Build.VERSION_CODES.R) {
            fillTheScreen(activity.getWindow(), activity.getResources().getConfiguration());
        }
        activity.findViewById(whole).setOnApplyWindowInsetsListener((view, insets) -> {
            Rect covered = Build.VERSION.SDK_INT >= Build.VERSION_CODES.R ? covered(insets) : coveredBefore11(insets);
            for (Yielding yielding : views) {
                yielding.giveWay(covered);
            }
            return insets;
        });
    }

    private static void fillTheScreen(Window window, Configuration shape) {
        window.setDecorFitsSystemWindows(false);
        window.setStatusBarColor(Color.TRANSPARENT);
        window.setNavigationBarColor(Color.TRANSPARENT);
        WindowManager.LayoutParams attributes = window.getAttributes();
        attributes.layoutInDisplayCutoutMode = WindowManager.LayoutParams.LAYOUT_IN_DISPLAY_CUTOUT_MODE_ALWAYS;
        window.setAttributes(attributes);
        // banner and heading are dark by day and night, so that the status bar's signs are light; by day the rest is
        // light
        boolean night = (shape.uiMode & Configuration.UI_MODE_NIGHT_MASK) == Configuration.UI_MODE_NIGHT_YES;
        WindowInsetsController bars = window.getInsetsController();
        bars.setSystemBarsAppearance(night ? 0 : WindowInsetsController.APPEARANCE_LIGHT_NAVIGATION_BARS,
                WindowInsetsController.APPEARANCE_LIGHT_STATUS_BARS
                | WindowInsetsController.APPEARANCE_LIGHT_NAVIGATION_BARS);
    }

    /** How far bars and cutout reach into the app from each side, px. */
    private static Rect covered(WindowInsets insets) {
        Insets all = insets.getInsets(WindowInsets.Type.systemBars() | WindowInsets.Type.displayCutout());
        return new Rect(all.left, all.top, all.right, all.bottom);
    }

    @SuppressWarnings("deprecation") // what replaces it does not exist before Android 11
    private static Rect coveredBefore11(WindowInsets insets) {
        return new Rect(insets.getSystemWindowInsetLeft(), insets.getSystemWindowInsetTop(),
                insets.getSystemWindowInsetRight(), insets.getSystemWindowInsetBottom());
    }
}
