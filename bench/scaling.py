#!/usr/bin/env python3
"""How the work grows with the depth of trees of rays, with the number of lights and with the number of shapes: counts of
instructions, as in instructions.py. Each law is an exponent: between two of its sizes, the work may grow by no more than
their ratio to that power. Fails if it grows by more."""

import argparse
import math
import os
import random
import sys
import tempfile

from instructions import ISA, ROOT, count


def glass(depth):
    numbers = random.Random(7)
    lines = [f"max_depth {depth}", "background .2 .3 .5", "disk_light 5 10 5 2 -1 -1 -1 1 1 1", "fov 50",
             "shiny .05 .05 .05 0 0 0 .3 .3 .3 40 .15 .8 1.5"]
    lines += [f"sphere .7 {numbers.uniform(-3, 3)} {numbers.uniform(-2, 2)} {numbers.uniform(-10, -6)}"
              for _ in range(30)]
    return lines


def lights(count):
    numbers = random.Random(8)
    color = lambda: " ".join(f"{numbers.uniform(0, 8 / count):.9f}" for _ in range(3))
    lines = [f"disk_light {numbers.uniform(-5, 5)} {numbers.uniform(1, 3)} {numbers.uniform(-12, -3)} .2 0 -1 0 {color()}"
             for _ in range(count)]
    lines += ["diffuse .8 .8 .8 0 0 0", "begin", "vertex -50 -2 50", "vertex 50 -2 50", "vertex 0 -2 -90", "end"]
    lines += [f"sphere .5 {numbers.uniform(-4, 4)} {numbers.uniform(-2, 0)} {numbers.uniform(-11, -5)}"
              for _ in range(40)]
    return lines


def shapes(count):
    numbers = random.Random(9)
    radius = 2 / count ** (1 / 3)
    lines = ["light 5 10 5 1 1 1"]
    lines += [f"sphere {radius} {numbers.uniform(-3, 3)} {numbers.uniform(-3, 3)} {numbers.uniform(-10, -4)}"
              for _ in range(count)]
    return lines


LAWS = {  # of the work of all rays: (scene, sizes, exponent of each step)
    "depth of glass": (glass, (4, 8, 16), (math.log2(2.5), math.log2(1.5))),
    "lights": (lights, (10, 100, 1000), (0.75, 0.2)),
    "shapes": (shapes, (1000, 10_000, 100_000), (0.33, 0.33)),
}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--penumbra", default=os.path.join(ROOT, "build/release/penumbra"))
    arguments = parser.parse_args()
    with open("/proc/cpuinfo") as file:
        if ISA not in file.read():
            print(f"scaling: skipped, this machine has no {ISA}")
            return
    broken = 0
    with tempfile.TemporaryDirectory() as folder:
        for law, (make, sizes, exponents) in LAWS.items():
            counts = []
            for size in sizes:
                scene = os.path.join(folder, "scene.cli")
                with open(scene, "w") as file:
                    file.write("\n".join(make(size)) + "\n")
                counts.append(count(arguments.penumbra, scene, ["--size", "32x32", "--rays", "16"]))
            for i, most in enumerate(exponents):
                exponent = math.log(counts[i + 1] / counts[i]) / math.log(sizes[i + 1] / sizes[i])
                broken += exponent > most
                print(f"{law}, {sizes[i]} to {sizes[i + 1]}: {counts[i]:,} to {counts[i + 1]:,} instructions, "
                      f"exponent {exponent:.3f}, at most {most:.3f}", flush=True)
    if broken:
        sys.exit("scaling: the work grows faster than it should")


if __name__ == "__main__":
    main()
