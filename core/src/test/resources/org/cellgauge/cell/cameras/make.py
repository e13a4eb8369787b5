"""Camera files as OpenCV and mrcal write them, and where they see points.

pip install opencv-python-headless==5.0.0.* numpy && python make.py [mrcal], in this folder; with mrcal (Python 3.12,
pip install mrcal) for mrcal's files.

projections.txt: file, x, y, z in the camera frame, u, v as the program counts pixels.
"""
import sys

import numpy as np

FOUR = [581.25, 582.5, 640.125, 359.75]
BENT = {
    5: [-0.28, 0.09, 0.001, -0.0005, -0.01],
    8: [0.52, -2.4, 0.0009, -0.0003, 1.5, 0.40, -2.3, 1.42],
    12: [0.52, -2.4, 0.0009, -0.0003, 1.5, 0.40, -2.3, 1.42, 0.002, -0.001, -0.0015, 0.0007],
}
BENT[14] = BENT[12] + [0, 0]
FISHEYE = [-0.012, 0.006, -0.004, 0.0005]
random = np.random.default_rng(11)
POINTS = np.round(np.column_stack([random.uniform(-700, 700, 12), random.uniform(-400, 400, 12),
                                   random.uniform(600, 1500, 12)]), 1)


def lines(name, pixels):
    return [' '.join([name, *map(repr, p.tolist()), *map(repr, q.tolist())]) for p, q in zip(POINTS, pixels)]


def of_mrcal():
    import mrcal
    for count in (0, 4, 5, 8, 12):
        lens = f'LENSMODEL_OPENCV{count}' if count else 'LENSMODEL_PINHOLE'
        values = np.array(FOUR + (BENT.get(count) or BENT[5][:count]))
        name = f'mrcal-{count}.cameramodel'
        mrcal.cameramodel(intrinsics=(lens, values), imagersize=(1280, 720)).write(name)
        yield from lines(name, mrcal.project(POINTS, lens, values))


def of_opencv():
    import cv2
    matrix = np.array([[FOUR[0], 0, FOUR[2]], [0, FOUR[1], FOUR[3]], [0, 0, 1]])

    def write(name, bent, fisheye):
        files = cv2.FileStorage(name, cv2.FILE_STORAGE_WRITE)
        files.write('calibration_time', 'Sat Nov 28 2026')
        files.write('image_width', 1280)
        files.write('image_height', 720)
        if fisheye:
            files.write('fisheye_model', 1)
        files.write('camera_matrix', matrix)
        files.write('distortion_coefficients', np.array([bent]).T)
        if not fisheye:
            files.write('std_intrinsics', np.full((18, 1), 0.1))
        files.release()

    for name, count in (('opencv-5.yml', 5), ('opencv-8.json', 8), ('opencv-12.xml', 12), ('opencv-14.yml', 14)):
        write(name, BENT[count], False)
        pixels, _ = cv2.projectPoints(POINTS, np.zeros(3), np.zeros(3), matrix, np.array(BENT[count]))
        yield from lines(name, pixels[:, 0])
    write('opencv-fisheye.yml', FISHEYE, True)
    pixels, _ = cv2.fisheye.projectPoints(POINTS[:, None], np.zeros(3), np.zeros(3), matrix, np.array(FISHEYE))
    yield from lines('opencv-fisheye.yml', pixels[:, 0])


kept = []
mine = 'mrcal' if 'mrcal' in sys.argv else 'opencv'
try:
    kept = [line for line in open('projections.txt').read().splitlines() if not line.startswith(mine)]
except FileNotFoundError:
    pass
made = list(of_mrcal() if mine == 'mrcal' else of_opencv())
with open('projections.txt', 'w') as out:
    out.write('\n'.join(sorted(kept + made)) + '\n')
