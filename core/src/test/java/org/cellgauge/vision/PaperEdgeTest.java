package org.cellgauge.vision;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.apache.commons.math3.distribution.NormalDistribution;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.light.ToneCurve;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The edge of the paper in pictures drawn by the normal distribution: a marker, its margin, and the ground beyond. */
class PaperEdgeTest {
    private static final int SIZE = 80;
    private static final double SIDE_PX = 40;
    private static final double BLACK = 30;
    private static final double WHITE = 200;
    private static final double STD_PX = Math.sqrt(0.49 + MarkerEdges.PIXEL_VARIANCE);

    private static PaperEdge found(double paperPx, double ground) {
        NormalDistribution blur = new NormalDistribution(null, 0, STD_PX);
        byte[] grey = new byte[SIZE * SIZE];
        for (int i = 0; i < grey.length; i++) {
            double x = i % SIZE + 0.5 - SIDE_PX;
            grey[i] = (byte) Math.round(BLACK + (WHITE - BLACK) * blur.cumulativeProbability(x)
                    - (WHITE - ground) * blur.cumulativeProbability(x - paperPx));
        }
        GreyScale scale = new GreyScale();
        scale.set(ToneCurve.LINEAR);
        SideFit side = new SideFit(new SideFit.Work());
        side.middleX = SIDE_PX;
        side.middleY = SIZE / 2.0;
        side.tangentY = 1;
        side.normalX = 1;
        side.lengthPx = 30;
        StraightPlane plane = new StraightPlane(PinholeCamera.ideal(SIZE, SIZE, 100, 100, 40, 40));
        PaperEdge paper = new PaperEdge();
        paper.find(GreyImage.packed(grey, SIZE, SIZE), null, plane, scale, side, STD_PX, 8);
        return paper;
    }

    /** Greys are whole numbers, and between pixels a straight line stands for the edge. */
    @ParameterizedTest
    @CsvSource({"2.6, 100", "3.3, 60", "4.1, 150", "5.2, 100"})
    void edgeLiesWhereThePaperEnds(double paperPx, double ground) {
        PaperEdge paper = found(paperPx, ground);
        assertEquals(paperPx, paper.px, 0.05);
        assertEquals((WHITE - ground) / (WHITE - BLACK), paper.share, 0.03);
    }

    @ParameterizedTest
    @CsvSource({"5, 200", "5, 195", "30, 100"})
    void noDropIsNoEdge(double paperPx, double ground) {
        PaperEdge paper = found(paperPx, ground);
        assertTrue(paper.px == Double.POSITIVE_INFINITY && paper.share == 0, paper.px + " px, " + paper.share);
    }
}
