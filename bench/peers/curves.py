"""Errors of pictures, and where a curve of measured errors over seconds reaches a goal."""

import math

import numpy as np
import OpenImageIO as oiio


def read_picture(path, size):
    """Linear colours clamped to 0..1; a larger picture is averaged down to size x size."""
    file = oiio.ImageInput.open(path)  # an ImageBuf would show the picture last read under this name
    if not file:
        raise RuntimeError(f"{path}: {oiio.geterror()}")
    pixels = np.clip(file.read_image(format=oiio.FLOAT)[:, :, :3].astype(float), 0, 1)
    file.close()
    scale = len(pixels) // size
    return pixels.reshape(size, scale, size, scale, 3).mean((1, 3))


def rmse(picture, converged):
    """The error against the limit of two converged pictures. Their own errors are independent, so the mean of the
    product of the differences contains only the picture's error."""
    first, second = converged
    return math.sqrt(max(0.0, float(np.mean((picture - first) * (picture - second)))))


def spread(converged):
    """The error of one converged picture, from its difference to the other."""
    first, second = converged
    return math.sqrt(float(np.mean((first - second) ** 2)) / 2)


def on_line(a, b, error):
    """The seconds at which the line through two points (seconds, error), on logarithmic axes, has that error."""
    share = math.log(error / a[1]) / math.log(b[1] / a[1])
    return a[0] * (b[0] / a[0]) ** share


def crossing(points, goal, reach=2.5):
    """The seconds at which a curve of points (seconds, error) falls to the goal, and a remark: none between measured
    points, `at most` if all points are below the goal, `extrapolated` if the line through the last two points was
    extended, at most to `reach` times the last seconds. (None, `not reached`) beyond that."""
    points = sorted(points, key=lambda point: -point[1])
    if points[0][1] <= goal:
        return points[0][0], "at most"
    for before, after in zip(points, points[1:]):
        if before[1] > goal >= after[1]:
            return on_line(before, after, goal), ""
    if len(points) > 1:
        seconds = on_line(*points[-2:], goal)
        if seconds <= reach * points[-1][0]:
            return seconds, "extrapolated"
    return None, "not reached"
