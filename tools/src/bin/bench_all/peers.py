"""Peers that are Python packages: peers.py canny PICTURE OUT ACROSS, with the pixels across that are worked on, or peers.py
vtracer PICTURE OUT. Says on standard error how long the work took without the start of Python, in ms."""

import sys
import time


def canny(picture, out, across):
    import cv2

    start = time.perf_counter()
    grey = cv2.imread(picture, cv2.IMREAD_REDUCED_GRAYSCALE_4)
    height, width = grey.shape
    across = int(across)
    smaller = cv2.resize(grey, (across, round(across * height / width)), interpolation=cv2.INTER_AREA)
    edges = cv2.Canny(cv2.GaussianBlur(smaller, (0, 0), 1.5), 50, 100)
    cv2.imwrite(out, edges)
    return start


def vtracer(picture, out):
    import vtracer

    start = time.perf_counter()
    vtracer.convert_image_to_svg_py(picture, out)
    return start


started = {"canny": canny, "vtracer": vtracer}[sys.argv[1]](*sys.argv[2:])
print(f"alone {(time.perf_counter() - started) * 1000:.1f} ms", file=sys.stderr)
