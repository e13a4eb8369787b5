package org.cellgauge.internal.chains;

import java.util.ArrayList;
import java.util.List;
import org.apache.commons.math3.random.RandomGenerator;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.internal.geometry.Rotations;
import org.cellgauge.internal.laplace.CameraFit;
import org.cellgauge.internal.laplace.ObjectFit;
import org.cellgauge.internal.pose.CameraState;
import org.cellgauge.internal.pose.ReprojectionFit;
import org.cellgauge.internal.posterior.ObjectPosterior;
import org.cellgauge.internal.sampling.ChainProcess;
import org.cellgauge.internal.sampling.MetropolisChain;
import org.cellgauge.internal.sampling.RandomStreams;
import org.cellgauge.internal.sampling.StudentTMixture;
import org.cellgauge.sampling.AcceptanceCount;
import org.cellgauge.settings.ObjectNoise;

/**
 * One chain of a check: the camera's, and one for each object's pose before the camera, side by side.
 *
 * <p>References alone inform the camera and the intrinsics; an object's corners inform its own pose given these. That
 * is modular inference (Liu, Bayarri, Berger, "Modularization in Bayesian analysis", Bayesian Analysis 2009): the
 * corners of one small marker say next to nothing of a focal length. Where intrinsics are unknown, each draw solves
 * every object's pose with its own: the object's chain moves in deviations from that solution. Unknowns that markers
 * share come from the camera's draw likewise, and the object's base moves along.
 */
public final class CellProcess implements ChainProcess {
    private final CellQuantities quantities;
    private final MetropolisChain camera;
    private final CameraSampler.CameraChain cameraChain;
    private final CameraState state = new CameraState();
    private final ObjectWalk[] objects;
    /** Steps of an object with two modes after its camera has moved: where the modes are does not follow the noise. */
    private static final int STEPS_WITH_MODES = 4;
    /**
     * Steps of an object after the intrinsics have moved. Its proposal was fitted at the mode's intrinsics and follows
     * others by the solved pose and the depth alone; of so many steps, seven in ten accepted, none is left that
     * remembers the last draw (Plummer, "Cuts in Bayesian graphical models", Statistics and Computing 2015, on chains
     * that lag behind what they are given).
     */
    private static final int STEPS_WITH_INTRINSICS = 8;

    private final boolean intrinsicsUnknown;
    private final boolean shared;
    private final double[] centroid;
    private final double[] worldFromCamera = new double[9];
    private final double[] centre = new double[3];
    private final double[] worldFromObject = new double[9];
    private final double[] turned = new double[9];

    /**
     * One chain of camera and objects, at its start.
     *
     * @param quantities what to record of each state
     * @param tuned makes the camera's chain
     * @param seed of the photo's random streams
     * @param chain number of the chain, from 0
     * @throws IllegalStateException if no start has a density
     */
    public CellProcess(CellQuantities quantities, CameraSampler.Tuned tuned, long seed, int chain) {
        this.quantities = quantities;
        CameraFit fit = quantities.camera;
        cameraChain = tuned.chain(RandomStreams.of(seed, RandomPaths.CHAIN, chain));
        camera = cameraChain.chain;
        intrinsicsUnknown = fit.intrinsicsPrior.count() > 0;
        shared = fit.view.unknowns() > 0 || fit.belief != null;
        centroid = fit.view.centroidMm();
        objects = new ObjectWalk[quantities.objects.size()];
        cameraChain.chart.decode(camera.current(), state);
        for (int o = 0; o < objects.length; o++) {
            ObjectTarget object = quantities.objects.get(o);
            RandomGenerator random = RandomStreams.of(seed, RandomPaths.OBJECT, chain, object.fit.marker.id());
            objects[o] = new ObjectWalk(object,
                    fit.settings.model().objectNoise() == ObjectNoise.DETECTION, random);
            if (intrinsicsUnknown || shared) {
                objects[o].cameraMoved(state, intrinsicsUnknown, shared);
            }
        }
    }

    /** The walk of one object's pose before the camera. */
    private static final class ObjectWalk {
        final ObjectTarget target;
        final ReprojectionFit fit;
        final CameraState mode;
        final CameraState base;
        final CameraState state = new CameraState();
        final ObjectPosterior posterior;
        final MetropolisChain chain;
        final double[] grip;
        final double[] observed;
        /** Coordinates of the solved pose. */
        final double[] solution = new double[6];
        /**
         * Whether there is a pose at the camera's draw at all; where not (a focal length of a few pixels, of which no
         * draw that counts is made) the object stays where it was.
         */
        boolean standing = true;

        ObjectWalk(ObjectTarget target, boolean noisy, RandomGenerator random) {
            this.target = target;
            observed = target.fit.cornersPx.clone();
            fit = target.fit.fitTo(observed);
            mode = target.fit.modes.get(0).state();
            base = target.fit.modes.get(0).state();
            grip = target.fit.marker.gripMm();
            posterior = target.posterior();
            state.copyFrom(base);
            if (noisy) {
                StudentTMixture proposal = target.proposal.copy();
                chain = new MetropolisChain(posterior, List.of(proposal),
                        TunedMixture.start(proposal, posterior, random), random);
            } else {
                chain = null;
            }
        }

        /**
         * Solves the pose with other intrinsics; the chain goes on around it. Each solution starts at the mode and not
         * at the last one, which may have slipped into the mirrored pose: a draw is a function of its own intrinsics
         * alone.
         */
        private void solveAt(CameraState camera) {
            base.copyFrom(mode);
            double stretch = camera.intrinsics[PinholeCamera.FX] / base.intrinsics[PinholeCamera.FX];
            base.copyIntrinsics(camera);
            base.offset[2] *= stretch;
            fit.fit(base);
            posterior.setBase(base);
        }

        /** Follows the camera's intrinsics and what the marker shares with others; the chain goes on from there. */
        void cameraMoved(CameraState camera, boolean intrinsicsUnknown, boolean shared) {
            if (shared) {
                posterior.setShared(camera);
                posterior.base(base);
            }
            if (intrinsicsUnknown) {
                if (shared) {
                    System.arraycopy(posterior.shiftedPx(), 0, observed, 0, observed.length);
                }
                solveAt(camera);
            }
            if (chain != null) {
                // with a focal length far from the mode's, what was near the solution may be behind the camera
                standing = chain.densityChanged(solution);
            }
        }

        void step(int steps) {
            for (int i = 0; i < steps && chain != null && standing; i++) {
                chain.step();
            }
        }

        void read() {
            if (chain == null) {
                state.copyFrom(base);
            } else if (standing) {
                posterior.decode(chain.current(), state);
            }
        }
    }

    @Override
    public void step() {
        boolean moved = camera.step();
        boolean follow = moved && (intrinsicsUnknown || shared);
        if (follow) {
            cameraChain.chart.decode(camera.current(), state);
        }
        for (ObjectWalk object : objects) {
            if (follow) {
                object.cameraMoved(state, intrinsicsUnknown, shared);
            }
            object.step(stepsOf(object, moved));
        }
    }

    private int stepsOf(ObjectWalk object, boolean cameraMoved) {
        if (cameraMoved && intrinsicsUnknown) {
            return STEPS_WITH_INTRINSICS;
        }
        return cameraMoved && shared && object.target.fit.modes.size() > 1 ? STEPS_WITH_MODES : 1;
    }

    @Override
    public void warmedUp() {
        cameraChain.warmedUp.run();
    }

    @Override
    public void read(double[] out) {
        cameraChain.chart.decode(camera.current(), state);
        Rotations.transpose(state.rotation, worldFromCamera);
        for (int i = 0; i < 3; i++) {
            centre[i] = centroid[i] - along(worldFromCamera, i, state.offset);
        }
        out[0] = camera.logDensity();
        int at = readPose(centre, worldFromCamera, quantities.cameraReference, out, 1);
        if (quantities.camera.modes.size() > 1) {
            out[at++] = ObjectFit.nearest(quantities.camera.modes, state);
        }
        at = quantities.readIntrinsics(state, out, at);
        at = quantities.readShared(state, out, at);
        for (int o = 0; o < objects.length; o++) {
            ObjectWalk object = objects[o];
            object.read();
            CameraState pose = object.state;
            Rotations.multiply(worldFromCamera, pose.rotation, worldFromObject);
            double x = pose.offset[0];
            double y = pose.offset[1];
            double z = pose.offset[2];
            double px = centre[0] + worldFromCamera[0] * x + worldFromCamera[1] * y + worldFromCamera[2] * z;
            double py = centre[1] + worldFromCamera[3] * x + worldFromCamera[4] * y + worldFromCamera[5] * z;
            double pz = centre[2] + worldFromCamera[6] * x + worldFromCamera[7] * y + worldFromCamera[8] * z;
            int first = at;
            at = readPose(null, worldFromObject, quantities.objectReferences[o], out, first);
            out[first] = px;
            out[first + 1] = py;
            out[first + 2] = pz;
            if (object.target.fit.modes.size() > 1) {
                out[at++] = ObjectFit.nearest(object.target.fit.modes, pose);
            }
            if (object.grip != null) {
                out[at++] = px + along(worldFromObject, 0, object.grip);
                out[at++] = py + along(worldFromObject, 1, object.grip);
                out[at++] = pz + along(worldFromObject, 2, object.grip);
            }
        }
    }

    private static double along(double[] rotation, int row, double[] v) {
        return rotation[3 * row] * v[0] + rotation[3 * row + 1] * v[1] + rotation[3 * row + 2] * v[2];
    }

    private int readPose(double[] position, double[] rotation, double[] reference, double[] out, int at) {
        if (position != null) {
            System.arraycopy(position, 0, out, at, 3);
        }
        Rotations.toEuler(rotation, out, at + 3);
        Rotations.multiplyTransposed(rotation, reference, turned);
        Rotations.log(turned, out, at + 6);
        return at + 9;
    }

    @Override
    public List<AcceptanceCount> acceptance() {
        List<AcceptanceCount> counts = new ArrayList<>(camera.acceptance());
        for (ObjectWalk object : objects) {
            if (object.chain != null) {
                for (AcceptanceCount count : object.chain.acceptance()) {
                    counts.add(new AcceptanceCount("object " + object.target.fit.marker.id() + " " + count.proposal(),
                            count.accepted(), count.rejected()));
                }
            }
        }
        return counts;
    }
}
