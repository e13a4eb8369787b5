"""Draws marker 7 of four families, upright, as an SVG picture: python3 docs/markers_svg.py > docs/markers.svg"""
import cv2

CELL = 12
TAG = cv2.aruco.getPredefinedDictionary(cv2.aruco.DICT_APRILTAG_36h11)


def coded(dictionary):
    return cv2.aruco.generateImageMarker(dictionary, 7, dictionary.markerSize + 2) > 0


def square_binary(number):
    """A black border of two cells, the lower left corner of the code black, the number's bits from there upwards."""
    white = [[False] * 8 for _ in range(8)]
    bit = 0
    for row in (3, 2, 1, 0):
        for column in range(4):
            corner = row in (0, 3) and column in (0, 3)
            black = (row, column) == (3, 0) if corner else bool(number >> bit & 1)
            bit += not corner
            white[2 + row][2 + column] = not black
    return white


pictures = (("square-binary", square_binary(7)),
            ("DICT_4X4_50", coded(cv2.aruco.getPredefinedDictionary(cv2.aruco.DICT_4X4_50))),
            ("tag36h11", coded(TAG)[::-1, ::-1]),
            ("tag36h11, orientation: opencv", coded(TAG)))
print('<svg xmlns="http://www.w3.org/2000/svg" width="800" height="180" font-family="sans-serif" font-size="12">')
print('<rect width="800" height="180" fill="white"/>')
for k, (name, white) in enumerate(pictures):
    x, y, side = 30 + 185 * k, 40, CELL * len(white)
    print(f'<rect x="{x}" y="{y}" width="{side}" height="{side}" fill="black"/>')
    for row in range(len(white)):
        for column in range(len(white)):
            if white[row][column]:
                print(f'<rect x="{x + CELL * column}" y="{y + CELL * row}" width="{CELL}" height="{CELL}" fill="white"/>')
    print(f'<circle cx="{x}" cy="{y}" r="5" fill="#d00"/>')
    print(f'<path d="M{x + side + 14} {y + side}V{y + 4}m-5 8l5 -8l5 8" stroke="#06c" stroke-width="2" fill="none"/>')
    print(f'<text x="{x}" y="{y + side + 20}">{name}</text>')
print('</svg>')
