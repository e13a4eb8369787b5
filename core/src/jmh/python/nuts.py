"""Effective draws per second of NUTS on the camera pose of three references, to compare with the independence sampler.

    python3 -m venv nuts && nuts/bin/pip install nutpie numba && nuts/bin/python core/src/jmh/python/nuts.py

The cell of fixtures/plane-3 (three references of 47 mm in the plane, 1280 x 720 px, f 581 px), placed to 5 mm and
10 mrad, corners to 0.05 px: the scene of EffectiveDrawsTest. Placement errors are integrated out to first order at the
true pose, as docs/method.md has it, so that what is left is a function of six numbers. NUTS (Hoffman and Gelman 2014)
gets what it can have: coordinates whitened by the Gauss-Newton covariance, the gradient written out and compiled by
numba, the sampler of nutpie (Rust). Printed is the least effective size, over coordinates, of the draws and of their
squared deviations, per second of processor time after the warm-up: the latter to hold against 585 in 1000 steps of
StepBenchmark's independence step. Beside it, how long 400 of them take from the start of the warm-up on, and what a
gradient takes, from which follows what NUTS could do at most if nothing else took time.
"""
import time
import warnings

warnings.simplefilter("ignore")

import arviz
import nutpie
import nutpie.compiled_pyfunc
import numba
import numpy as np

FOCAL_PX, CX_PX, CY_PX = 581.0, 640.0, 360.0
SIZE_MM, STD_MM, STD_RAD, PIXEL_STD_PX = 47.0, 5.0, 0.01, 0.05
PLACES_MM = np.array([[492.0, 380.0, 0.0], [0.0, 380.0, 0.0], [492.0, 0.0, 0.0]])
CORNERS_MM = SIZE_MM / 2 * np.array([[-1.0, 1.0, 0.0], [1.0, 1.0, 0.0], [1.0, -1.0, 0.0], [-1.0, -1.0, 0.0]])
CAMERA_MM = np.array([418.0, 106.0, 1070.0])
WARM_UP, DRAWS, CHAINS = 500, 10000, 4


@numba.njit(cache=False)
def cross(v):
    return np.array([[0.0, -v[2], v[1]], [v[2], 0.0, -v[0]], [-v[1], v[0], 0.0]])


@numba.njit(cache=False)
def rotation(v):
    """Rotation matrix of a rotation vector, rad."""
    angle = np.sqrt(np.sum(v * v)) + 1e-12
    k = cross(v / angle)
    return np.eye(3) + np.sin(angle) * k + (1 - np.cos(angle)) * k @ k


WORLD_FROM_CAMERA = rotation(np.array([3.08, 0.1, 0.02]))


@numba.njit(cache=False)
def world_points(placement):
    """Corners of all references in the world, 12 x 3, mm, of six numbers of each placement (mm, rad)."""
    out = np.empty((12, 3))
    for i in range(3):
        own = rotation(placement[6 * i + 3:6 * i + 6])
        for c in range(4):
            out[4 * i + c] = own @ CORNERS_MM[c] + PLACES_MM[i] + placement[6 * i:6 * i + 3]
    return out


@numba.njit(cache=False, fastmath=True)
def seen(camera, world, jacobian):
    """Points in the image, px: 24 values, of six numbers of the camera (mm, rad).

    Fills the derivative by the camera, 24 x 6: with y = exp(-v) q, a change dv moves y by exp(-v) [q]x J_r(-v) dv.
    """
    v = camera[3:]
    back = rotation(-v)
    angle = np.sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]) + 1e-12
    w = cross(-v)
    right = np.eye(3) - (1 - np.cos(angle)) / angle**2 * w + (angle - np.sin(angle)) / angle**3 * w @ w
    turn = back @ np.ascontiguousarray(WORLD_FROM_CAMERA.T)
    out = np.empty(24)
    q, p, by_turn = np.empty(3), np.empty(3), np.empty((3, 3))
    for n in range(12):
        for a in range(3):
            q[a] = 0.0
            p[a] = 0.0
            for b in range(3):
                d = world[n, b] - CAMERA_MM[b] - camera[b]
                q[a] += WORLD_FROM_CAMERA[b, a] * d
                p[a] += turn[a, b] * d
        for a in range(3):
            x = back[a, 1] * q[2] - back[a, 2] * q[1]
            y = back[a, 2] * q[0] - back[a, 0] * q[2]
            z = back[a, 0] * q[1] - back[a, 1] * q[0]
            for k in range(3):
                by_turn[a, k] = x * right[0, k] + y * right[1, k] + z * right[2, k]
        for axis in range(2):
            out[2 * n + axis] = FOCAL_PX * p[axis] / p[2] + (CX_PX if axis == 0 else CY_PX)
            for k in range(3):
                jacobian[2 * n + axis, k] = FOCAL_PX * (-turn[axis, k] + p[axis] / p[2] * turn[2, k]) / p[2]
                jacobian[2 * n + axis, 3 + k] = FOCAL_PX * (by_turn[axis, k] - p[axis] / p[2] * by_turn[2, k]) / p[2]
    return out


def main():
    random = np.random.default_rng(1)
    std = np.tile(np.repeat([STD_MM, STD_RAD], 3), 3)
    zero, nominal, j = np.zeros(6), world_points(np.zeros(18)), np.empty((24, 6))
    observed = seen(zero, world_points(random.normal(size=18) * std), j) + PIXEL_STD_PX * random.normal(size=24)
    by_placement = np.empty((24, 18))
    for k in range(18):
        step = np.zeros(18)
        step[k] = 1e-4
        by_placement[:, k] = (seen(zero, world_points(step), j) - seen(zero, world_points(-step), j)) / 2e-4 * std[k]
    covariance = by_placement @ by_placement.T + PIXEL_STD_PX**2 * np.eye(24)
    whitening = np.linalg.inv(np.linalg.cholesky(covariance))
    mode = zero
    for _ in range(20):
        residual = whitening @ (seen(mode, nominal, j) - observed)
        a = whitening @ j
        mode = mode - np.linalg.solve(a.T @ a, a.T @ residual)
    scale = np.linalg.cholesky(np.linalg.inv(a.T @ a))

    @numba.njit(cache=False)
    def log_density(z):
        by_camera = np.empty((24, 6))
        r = whitening @ (seen(mode + scale @ z, nominal, by_camera) - observed)
        return -0.5 * np.sum(r * r), -(scale.T @ (by_camera.T @ (whitening.T @ r)))

    z = random.normal(size=6)
    value, gradient = log_density(z)
    for k in range(6):
        step = np.zeros(6)
        step[k] = 1e-5
        assert abs((log_density(z + step)[0] - log_density(z - step)[0]) / 2e-5 - gradient[k]) < 1e-5

    @numba.njit(cache=False)
    def many(z, times):
        total = 0.0
        for _ in range(times):
            total += log_density(z)[0]
        return total

    many(z, 1)
    clock = time.process_time()
    many(z, 20000)
    per_gradient = (time.process_time() - clock) / 20000
    model = nutpie.compiled_pyfunc.from_pyfunc(6, lambda: log_density, lambda s1, s2, chain: lambda x: {"z": x},
                                               [np.dtype("float64")], [(6,)], ["z"])
    print(f"nutpie {nutpie.__version__}, numba {numba.__version__}; std of the camera, mm: "
          f"{np.sqrt(np.diag(scale @ scale.T))[:3].round(2)}; a gradient takes {1e6 * per_gradient:.1f} us")

    def sample(draws, seed):
        clock = time.process_time()
        trace = nutpie.sample(model, draws=draws, tune=WARM_UP, chains=CHAINS, cores=1, seed=seed, progress_bar=False)
        return trace, time.process_time() - clock

    sample(10, 0)
    warm = min(sample(10, seed)[1] for seed in (1, 2, 3))
    trace, seconds = sample(DRAWS, 4)
    seconds -= warm
    draws = trace.posterior["z"].values
    of_draws = float(arviz.ess(trace.posterior)["z"].min())
    squares = arviz.convert_to_dataset({"s": (draws - draws.mean((0, 1)))**2})
    of_squares = float(arviz.ess(squares)["s"].min())
    gradients = float(trace.sample_stats["n_steps"].values.sum())
    per_second = of_squares / seconds
    print(f"{CHAINS} chains: {of_draws / seconds:.0f} effective draws per second, {per_second:.0f} of squared "
          f"deviations; {1e3 * (warm + 400 / per_second):.0f} ms to 400; {gradients / draws[..., 0].size:.1f} gradients a draw: "
          f"{of_squares / (gradients * per_gradient):.0f} of squared deviations at most")


if __name__ == "__main__":
    main()
