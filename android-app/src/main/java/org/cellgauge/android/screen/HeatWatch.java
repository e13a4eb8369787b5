package org.cellgauge.android.screen;

import android.content.Context;
import android.os.Build;
import android.os.PowerManager;
import java.util.concurrent.Executor;
import java.util.function.Consumer;
import org.cellgauge.android.state.HeatStep;

/** Tells how warm the device is. Before Android 10 it does not say, and nothing is given up. */
final class HeatWatch {
    private final PowerManager power;
    private final Object listener;

    /**
     * A watch that does not run yet.
     *
     * @param context to ask the system
     * @param executor where steps are told
     * @param steps gets the step at the start and whenever it changes
     */
    HeatWatch(Context context, Executor executor, Consumer<HeatStep> steps) {
        power = context.getSystemService(PowerManager.class);
        listener = Build.VERSION.SDK_INT >= Build.VERSION_CODES.Q && power != null
                ? new FromAndroid10(power, executor, steps) : null;
    }

    void start() {
        if (listener != null) {
            ((FromAndroid10) listener).start();
        }
    }

    void stop() {
        if (listener != null) {
            ((FromAndroid10) listener).stop();
        }
    }

    /**
     * What a thermal status asks for.
     *
     * @param status one of {@link PowerManager}'s
     * @return the step
     */
    static HeatStep step(int status) {
        if (status >= PowerManager.THERMAL_STATUS_CRITICAL) {
            return HeatStep.CRITICAL;
        }
        if (status >= PowerManager.THERMAL_STATUS_SEVERE) {
            return HeatStep.HOT;
        }
        return status >= PowerManager.THERMAL_STATUS_MODERATE ? HeatStep.WARM : HeatStep.NORMAL;
    }

    /** In a class of its own, so that older systems never load it. */
    private static final class FromAndroid10 implements PowerManager.OnThermalStatusChangedListener {
        private final PowerManager power;
        private final Executor executor;
        private final Consumer<HeatStep> steps;

        FromAndroid10(PowerManager power, Executor executor, Consumer<HeatStep> steps) {
            this.power = power;
            this.executor = executor;
            this.steps = steps;
        }

        void start() {
            power.addThermalStatusListener(executor, this);
        }

        void stop() {
            power.removeThermalStatusListener(this);
        }

        @Override
        public void onThermalStatusChanged(int status) {
            steps.accept(step(status));
        }
    }
}
