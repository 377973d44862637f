r"""Detectors of edges that others use, on the pictures of the accuracy benchmark.

Needs numpy, numba, opencv-python-headless and scikit-image. All in one line, from the project's folder:

    python3 -m venv target/venv \
      && target/venv/bin/pip install numpy numba opencv-python-headless scikit-image \
      && cargo run --release -p tactograph-tools --bin accuracy -- --export target/peers \
      && target/venv/bin/python tools/src/bin/accuracy/peers.py target/peers \
      && cargo run --release -p tactograph-tools --bin accuracy -- --peers target/peers

Each detector gets the 8-bit picture and gives linked lines; thresholds are steps of 8 (low) and 16 (high) code values.
Times are from the decoded picture to linked lines, one thread's work. Lines and times are written beside the pictures, in
the form that tools/src/bin/accuracy/peers.rs describes.
"""

import json
import math
import statistics
import sys
import time
from pathlib import Path

import cv2
import numpy as np
from numba import njit
from skimage.feature import canny

LOW, HIGH = 8.0, 16.0  # code values
RUNS = 7


def per_step(sigma):
    """Steepest slope, per pixel, of a step of height 1 after a Gaussian of this sigma."""
    return 1.0 / (sigma * math.sqrt(2.0 * math.pi))


# --- linking -----------------------------------------------------------------------------------------------------


@njit
def link_pixels(edge):
    """Chains of an edge map's pixels: from ends first, then what is left (rings). Pixel numbers, and starts of chains."""
    height, width = edge.shape
    left = np.zeros((height + 2, width + 2), np.bool_)
    left[1:-1, 1:-1] = edge
    rows = np.array([0, 0, 1, -1, 1, 1, -1, -1])  # neighbours side by side before those across a corner
    columns = np.array([1, -1, 0, 0, 1, -1, 1, -1])
    order, starts = [np.int64(0) for _ in range(0)], [np.int64(0)]
    for rings in (False, True):
        for y in range(1, height + 1):
            for x in range(1, width + 1):
                if not left[y, x]:
                    continue
                neighbours = 0
                for k in range(8):
                    neighbours += left[y + rows[k], x + columns[k]]
                if neighbours != 1 and not rings:
                    continue
                cy, cx = y, x
                while True:
                    left[cy, cx] = False
                    order.append(np.int64((cy - 1) * width + cx - 1))
                    found = False
                    for k in range(8):
                        if left[cy + rows[k], cx + columns[k]]:
                            cy, cx = cy + rows[k], cx + columns[k]
                            found = True
                            break
                    if not found:
                        break
                starts.append(np.int64(len(order)))
    return np.array(order), np.array(starts)


def pixel_lines(edge, strength):
    """Lines through the centres of an edge map's pixels."""
    order, starts = link_pixels(edge)
    width = edge.shape[1]
    lines = []
    for first, last in zip(starts[:-1], starts[1:]):
        if last - first < 2:
            continue
        y, x = np.divmod(order[first:last], width)
        closed = last - first >= 8 and max(abs(x[0] - x[-1]), abs(y[0] - y[-1])) <= 1
        lines.append((bool(closed), x + 0.5, y + 0.5, strength[y, x]))
    return lines


@njit
def link_points(number, px, py, gx, gy):
    """Each point's next one along the contour (-1: none): the nearest ahead within two pixels whose gradient does not
    point against its own, if it is that one's nearest behind as well."""
    height, width = number.shape
    count = len(px)
    ahead, behind = np.full(count, -1), np.full(count, -1)
    for i in range(count):
        row, column = int(py[i]), int(px[i])
        best_ahead = best_behind = 1e9
        for y in range(max(row - 2, 0), min(row + 3, height)):
            for x in range(max(column - 2, 0), min(column + 3, width)):
                j = number[y, x]
                if j < 0 or j == i or gx[i] * gx[j] + gy[i] * gy[j] <= 0.0:
                    continue
                dx, dy = px[j] - px[i], py[j] - py[i]
                distance = dx * dx + dy * dy
                along = dx * -gy[i] + dy * gx[i]
                if along > 0.0 and distance < best_ahead:
                    best_ahead, ahead[i] = distance, j
                elif along < 0.0 and distance < best_behind:
                    best_behind, behind[i] = distance, j
    for i in range(count):
        if ahead[i] >= 0 and behind[ahead[i]] != i:
            ahead[i] = -1
    return ahead


@njit
def chains(ahead, strength, high):
    """Follows the links; a chain stays if it reaches `high` somewhere. Point numbers, starts and whether closed."""
    count = len(ahead)
    has_behind = np.zeros(count, np.bool_)
    for i in range(count):
        if ahead[i] >= 0:
            has_behind[ahead[i]] = True
    done = np.zeros(count, np.bool_)
    order, starts, closed = [np.int64(0) for _ in range(0)], [np.int64(0)], [False for _ in range(0)]
    for rings in (False, True):
        for first in range(count):
            if done[first] or (has_behind[first] and not rings):
                continue
            start, i, strongest = len(order), first, 0.0
            while i >= 0 and not done[i]:
                done[i] = True
                order.append(np.int64(i))
                strongest = max(strongest, strength[i])
                i = ahead[i]
            if strongest < high or len(order) - start < 2:
                del order[start:]
                continue
            starts.append(np.int64(len(order)))
            closed.append(i == first)
    return np.array(order), np.array(starts), np.array(closed)


# --- detectors: an RGB picture to lines (closed, x, y, strength) ----------------------------------------------------


def opencv_canny(picture, sigma, grey):
    """OpenCV's Canny on the blurred picture; in colour it takes each pixel's strongest channel."""
    if grey:
        picture = cv2.cvtColor(picture, cv2.COLOR_RGB2GRAY)
    blurred = cv2.GaussianBlur(picture, (0, 0), sigma, borderType=cv2.BORDER_REPLICATE)
    scale = 8.0 * per_step(sigma)  # its Sobel kernel gives 8 times the slope
    edge = cv2.Canny(blurred, LOW * scale, HIGH * scale, apertureSize=3, L2gradient=True)
    dx = cv2.Sobel(blurred, cv2.CV_32F, 1, 0, borderType=cv2.BORDER_REPLICATE)
    dy = cv2.Sobel(blurred, cv2.CV_32F, 0, 1, borderType=cv2.BORDER_REPLICATE)
    strength = cv2.magnitude(dx, dy)
    if not grey:
        strength = strength.max(axis=2)
    return pixel_lines(edge > 0, strength / scale)


def skimage_canny(picture, sigma):
    """scikit-image's Canny; its strength is taken with OpenCV's kernels, for it gives none."""
    grey = cv2.cvtColor(picture, cv2.COLOR_RGB2GRAY).astype(np.float32)
    scale = 8.0 * per_step(sigma)
    edge = canny(grey, sigma, LOW * scale, HIGH * scale, mode="nearest")
    blurred = cv2.GaussianBlur(grey, (0, 0), sigma, borderType=cv2.BORDER_REPLICATE)
    dx, dy = cv2.Sobel(blurred, cv2.CV_32F, 1, 0), cv2.Sobel(blurred, cv2.CV_32F, 0, 1)
    return pixel_lines(edge, cv2.magnitude(dx, dy) / scale)


def devernay(picture, sigma):
    """Devernay 1995: maxima of the slope along the stronger axis, placed by a parabola through three slopes."""
    grey = cv2.cvtColor(picture, cv2.COLOR_RGB2GRAY).astype(np.float32)
    radius = math.ceil(4.0 * sigma)
    at = np.arange(-radius, radius + 1)
    smooth = np.exp(-0.5 * (at / sigma) ** 2)
    smooth /= smooth.sum()
    slope = -at * smooth  # convolution turns it round
    slope /= np.abs((slope * at).sum())
    slope = -slope  # OpenCV correlates
    gx = cv2.sepFilter2D(grey, cv2.CV_32F, slope, smooth, borderType=cv2.BORDER_REPLICATE)
    gy = cv2.sepFilter2D(grey, cv2.CV_32F, smooth, slope, borderType=cv2.BORDER_REPLICATE)
    strength = cv2.magnitude(gx, gy) / per_step(sigma)
    here = strength[1:-1, 1:-1]
    level = np.abs(gx[1:-1, 1:-1]) >= np.abs(gy[1:-1, 1:-1])
    before = np.where(level, strength[1:-1, :-2], strength[:-2, 1:-1])
    after = np.where(level, strength[1:-1, 2:], strength[2:, 1:-1])
    y, x = np.nonzero((here >= LOW) & (here > before) & (here >= after))
    a, b, c, level = before[y, x], here[y, x], after[y, x], level[y, x]
    offset = 0.5 * (a - c) / (a - 2.0 * b + c)
    number = np.full(grey.shape, -1)
    y, x = y + 1, x + 1
    number[y, x] = np.arange(len(x))
    px, py = x + 0.5 + np.where(level, offset, 0.0), y + 0.5 + np.where(level, 0.0, offset)
    step = strength[y, x]
    # looked up by its pixel, so a point moved over the border of its pixel is still found within two pixels
    ahead = link_points(number, px, py, gx[y, x], gy[y, x])
    order, starts, closed = chains(ahead, step, HIGH)
    return [(bool(ring), px[i], py[i], step[i]) for ring, i in zip(closed, np.split(order, starts[1:-1]))]


PEERS = {
    "canny-grey-s1": lambda picture: opencv_canny(picture, 1.0, True),
    "canny-grey-s1.5": lambda picture: opencv_canny(picture, 1.5, True),
    "canny-grey-s2": lambda picture: opencv_canny(picture, 2.0, True),
    "canny-rgb-s1.5": lambda picture: opencv_canny(picture, 1.5, False),
    "skimage-s1.5": lambda picture: skimage_canny(picture, 1.5),
    "devernay-s1": lambda picture: devernay(picture, 1.0),
    "devernay-s1.5": lambda picture: devernay(picture, 1.5),
}

# --- files ----------------------------------------------------------------------------------------------------------


def read(file):
    return cv2.cvtColor(cv2.imread(str(file)), cv2.COLOR_BGR2RGB)


def write(file, picture, lines):
    polylines = [
        {
            "closed": closed,
            "points": np.round(np.column_stack([x, y]).astype(float), 4).tolist(),
            "strength": np.round(np.asarray(strength, float), 3).tolist(),
        }
        for closed, x, y, strength in lines
    ]
    file.parent.mkdir(parents=True, exist_ok=True)
    height, width = picture.shape[:2]
    file.write_text(json.dumps({"image": [width, height], "polylines": polylines}))


def milliseconds(detect, picture):
    detect(picture)  # numba compiles, caches are warm
    times = []
    for _ in range(RUNS):
        start = time.thread_time()
        detect(picture)
        times.append(1e3 * (time.thread_time() - start))
    megapixels = picture.shape[0] * picture.shape[1] / 1e6
    return statistics.median(times) / megapixels, min(times) / megapixels


def main(folder):
    cv2.setNumThreads(1)
    mosaic = read(folder / "mosaic.png")
    for name, detect in PEERS.items():
        for file in sorted((folder / "scenes").glob("*/*.png")):
            picture = read(file)
            write(folder / name / file.parent.name / (file.stem + ".json"), picture, detect(picture))
        median, best = milliseconds(detect, mosaic)
        (folder / name / "ms_per_megapixel.txt").write_text(f"{median:.2f} {best:.2f}\n")
        print(f"{name}: {median:.1f} ms per megapixel (best {best:.1f})")


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit("give the folder that `accuracy --export` wrote")
    main(Path(sys.argv[1]))
