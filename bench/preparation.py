#!/usr/bin/env python3
"""Compares how fast two builds of the program prepare a scene of many spheres: how fast build_world is on one thread and
on two, and how fast the scene is read with `check`. The builds take turns, and a ratio is the median of the ratios of
the turns.

    ninja -C build/release build_bench penumbra      in both checkouts
    python3 bench/preparation.py BEFORE/build/release build/release"""

import argparse
import os
import random
import re
import statistics
import subprocess
import tempfile
import time


def write_spheres(path, count):
    """Small spheres at random in a cube before the eye."""
    numbers = random.Random(1)
    with open(path, "w") as file:
        file.write("point_light 0 5 0 1 1 1\n")
        for _ in range(count):
            x, y, z = (numbers.random() for _ in range(3))
            file.write(f"sphere {0.001 + 0.004 * numbers.random():.6f} {x - 0.5:.6f} {y - 0.5:.6f} {-2 - z:.6f}\n")


def measured(build, scene, count):
    """The seconds of build_world on one thread and on two, and those of `check`."""
    printed = subprocess.run([os.path.join(build, "bench/build_bench"), str(count), "1"], check=True,
                             capture_output=True, text=True).stdout
    one, two = re.search(r"([\d.]+) s with one thread, ([\d.]+) s with two", printed).groups()
    start = time.perf_counter()
    subprocess.run([os.path.join(build, "penumbra"), "check", scene], check=True, stdout=subprocess.DEVNULL)
    return float(one), float(two), time.perf_counter() - start


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("before", help="build folder of the revision to compare with")
    parser.add_argument("now", help="build folder")
    parser.add_argument("--spheres", type=int, default=1_000_000)
    parser.add_argument("--turns", type=int, default=7)
    arguments = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        scene = os.path.join(folder, "spheres.cli")
        write_spheres(scene, arguments.spheres)
        turns = [[measured(build, scene, arguments.spheres) for build in (arguments.before, arguments.now)]
                 for _ in range(arguments.turns)]
    for i, what in enumerate(["build_world, one thread", "build_world, two threads", "check"]):
        before, now = (statistics.median(turn[side][i] for turn in turns) for side in range(2))
        ratio = statistics.median(turn[0][i] / turn[1][i] for turn in turns)
        print(f"{what:<26} {before:.3f} s before, {now:.3f} s now: {ratio:.2f} times as fast")


if __name__ == "__main__":
    main()
