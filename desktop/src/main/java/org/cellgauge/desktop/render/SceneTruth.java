package org.cellgauge.desktop.render;

import java.util.ArrayList;
import java.util.List;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.internal.geometry.MarkerGeometry;

/** Where the corners of a scene's markers really are in its image. */
public final class SceneTruth {
    private static final int GRID = 24;

    private SceneTruth() {
    }

    /**
     * A marker in the image.
     *
     * @param id marker id
     * @param cornersPx its four corners, top-left, top-right, bottom-right, bottom-left of its own frame, each u, v in
     *     px; null where one of them has no image
     * @param whollyInside whether it shows its face and all corners lie within the image
     * @param visibleShare share of its face that is in the image and not hidden by another marker's paper, 0 to 1
     */
    public record MarkerInImage(int id, double[][] cornersPx, boolean whollyInside, double visibleShare) {
    }

    /**
     * Projects every marker of a scene.
     *
     * @param scene the scene
     * @return one entry per marker, in the scene's order
     */
    public static List<MarkerInImage> of(Scene scene) {
        RigidTransform cameraFromWorld = scene.worldFromCamera().inverse();
        List<PlanarMarker> papers = new ArrayList<>();
        for (SceneMarker marker : scene.markers()) {
            papers.add(PlanarMarker.of(marker, scene.quietZone(), scene.printGainMm(), cameraFromWorld,
                    scene.camera()));
        }
        List<MarkerInImage> out = new ArrayList<>();
        for (int m = 0; m < papers.size(); m++) {
            out.add(inImage(scene, cameraFromWorld, papers, m));
        }
        return out;
    }

    private static MarkerInImage inImage(Scene scene, RigidTransform cameraFromWorld, List<PlanarMarker> papers,
            int m) {
        SceneMarker marker = scene.markers().get(m);
        RigidTransform cameraFromMarker = cameraFromWorld.compose(marker.worldFromMarker());
        double[] r = cameraFromMarker.rotation();
        double[] t = cameraFromMarker.translationMm();
        boolean facing = papers.get(m) != null && r[2] * t[0] + r[5] * t[1] + r[8] * t[2] < 0;
        double[] corners = MarkerGeometry.cornersMm(cameraFromMarker, marker.sizeMm());
        double[][] cornersPx = new double[MarkerGeometry.CORNERS][];
        boolean all = true;
        boolean inside = facing;
        for (int i = 0; i < MarkerGeometry.CORNERS; i++) {
            cornersPx[i] = scene.camera().image(corners[3 * i], corners[3 * i + 1], corners[3 * i + 2]);
            all &= cornersPx[i] != null;
            inside &= cornersPx[i] != null && within(scene.camera(), cornersPx[i]);
        }
        double visible = facing ? visibleShare(scene, cameraFromMarker, papers, m) : 0;
        return new MarkerInImage(marker.id(), all ? cornersPx : null, inside, visible);
    }

    private static double visibleShare(Scene scene, RigidTransform cameraFromMarker, List<PlanarMarker> papers, int m) {
        double size = scene.markers().get(m).sizeMm();
        int visible = 0;
        for (int i = 0; i < GRID * GRID; i++) {
            double x = size * ((i % GRID + 0.5) / GRID - 0.5);
            double y = size * ((i / GRID + 0.5) / GRID - 0.5);
            double[] p = cameraFromMarker.apply(x, y, 0);
            double[] uv = scene.camera().image(p[0], p[1], p[2]);
            double scale = p[2] > 0 ? p[2] : Math.hypot(Math.hypot(p[0], p[1]), p[2]);
            if (uv != null && within(scene.camera(), uv)
                    && !hidden(papers, m, p[0] / scale, p[1] / scale, p[2] / scale)) {
                visible++;
            }
        }
        return visible / (double) (GRID * GRID);
    }

    private static boolean hidden(List<PlanarMarker> papers, int m, double x, double y, double z) {
        double own = papers.get(m).inverseDistance(x, y, z);
        for (int k = 0; k < papers.size(); k++) {
            PlanarMarker other = papers.get(k);
            if (k != m && other != null && other.colourAt(x, y, z) != PlanarMarker.NOTHING) {
                double theirs = other.inverseDistance(x, y, z);
                // of two papers in one plane the first in the scene lies on top, as in the renderer
                if (theirs > own || theirs == own && k < m) {
                    return true;
                }
            }
        }
        return false;
    }

    private static boolean within(PinholeCamera camera, double[] uv) {
        return uv[0] >= 0 && uv[1] >= 0 && uv[0] <= camera.widthPx() && uv[1] <= camera.heightPx();
    }

}
