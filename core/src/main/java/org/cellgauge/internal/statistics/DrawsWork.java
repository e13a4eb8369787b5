package org.cellgauge.internal.statistics;

import java.util.ArrayDeque;
import java.util.Arrays;

/**
 * Arrays that the diagnostics of one series of draws leave to those of the next, which mostly is as long: a check has
 * dozens of them, and new memory takes longer to come by than to fill. What is in them is anyone's. Not thread-safe.
 */
public final class DrawsWork {
    private double[] values = new double[0];
    private double[] distances = new double[0];
    private int[] order = new int[0];
    private int[] ofDistances = new int[0];
    private int[] buckets = new int[0];
    private RankScores scores = new RankScores(1);

    private DrawsWork() {
    }

    /** So many numbers. */
    public double[] values(int count) {
        values = values.length == count ? values : new double[count];
        return values;
    }

    /** As many others. */
    public double[] distances(int count) {
        distances = distances.length == count ? distances : new double[count];
        return distances;
    }

    /** So many places. */
    public int[] order(int count) {
        order = order.length == count ? order : new int[count];
        return order;
    }

    /** As many others. */
    public int[] ofDistances(int count) {
        ofDistances = ofDistances.length == count ? ofDistances : new int[count];
        return ofDistances;
    }

    /** So many counts, all 0. */
    int[] buckets(int count) {
        if (buckets.length == count) {
            Arrays.fill(buckets, 0);
        } else {
            buckets = new int[count];
        }
        return buckets;
    }

    /** Scores of so many ranks. */
    public RankScores scores(int total) {
        scores = scores.total() == total ? scores : new RankScores(total);
        return scores;
    }

    /** As many of them as series are diagnosed at a time. Safe for threads. */
    public static final class Pool {
        private final ArrayDeque<DrawsWork> free = new ArrayDeque<>();

        /** One that nobody else has until it is given back. */
        public synchronized DrawsWork take() {
            DrawsWork work = free.pollLast();
            return work != null ? work : new DrawsWork();
        }

        /** Gives it back. */
        public synchronized void giveBack(DrawsWork work) {
            free.addLast(work);
        }
    }
}
