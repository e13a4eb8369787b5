package org.cellgauge.cli;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.geom.Path2D;
import java.awt.image.BufferedImage;
import org.cellgauge.check.CheckResult;
import org.cellgauge.check.ObjectEstimate;
import org.cellgauge.statistics.Ellipse;
import org.cellgauge.vision.GreyImage;
import org.cellgauge.vision.MarkerObservation;

/** The picture of a result: the photo with what was found in it. */
final class ResultPicture {
    private ResultPicture() {
    }

    /**
     * Paints a result.
     *
     * @param photo the photo, or null for a plain ground of its size
     * @param result what the check found
     * @return a new picture of the photo's size
     */
    static BufferedImage of(GreyImage photo, CheckResult result) {
        BufferedImage picture = new BufferedImage(result.detections().widthPx(), result.detections().heightPx(),
                BufferedImage.TYPE_INT_RGB);
        Graphics2D g = picture.createGraphics();
        g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        g.setColor(Color.DARK_GRAY);
        g.fillRect(0, 0, picture.getWidth(), picture.getHeight());
        if (photo != null) {
            g.drawImage(Pictures.of(photo), 0, 0, null);
        }
        g.setStroke(new BasicStroke(2));
        for (MarkerObservation marker : result.detections().markers()) {
            boolean reference = result.referencesUsed().contains(marker.id());
            g.setColor(reference ? Color.CYAN : Color.ORANGE);
            double[] c = marker.cornersPx();
            Path2D outline = new Path2D.Double();
            outline.moveTo(c[0], c[1]);
            for (int i = 1; i < 4; i++) {
                outline.lineTo(c[2 * i], c[2 * i + 1]);
            }
            outline.closePath();
            g.draw(outline);
            g.drawString(String.valueOf(marker.id()), (float) c[0], (float) c[1] - 4);
        }
        g.setColor(Color.RED);
        for (ObjectEstimate object : result.estimate().objects()) {
            draw(g, object.ellipse95Px());
            draw(g, object.gripEllipse95Px());
        }
        g.dispose();
        return picture;
    }

    private static void draw(Graphics2D g, Ellipse ellipse) {
        if (ellipse == null) {
            return;
        }
        double[][] points = ellipse.boundary(64);
        Path2D path = new Path2D.Double();
        path.moveTo(points[0][0], points[0][1]);
        for (double[] p : points) {
            path.lineTo(p[0], p[1]);
        }
        path.closePath();
        g.draw(path);
    }
}
