#!/usr/bin/env python3
"""Measures adaptive rendering (`--noise E`) and prints two tables: for every scene, the error of the finished picture
against a converged one, as a multiple of E; and for demo.cli, how many times more rays the same error takes with the
same number of rays in every pixel. Errors are of colours clamped to 0..1 (16-bit PNG files). Converged pictures use
another seed and are kept in the folder of --cache."""

import argparse
import json
import math
import os
import subprocess
import tempfile

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
SCENES = ["demo", "s01b", "s02b", "s03b", "s04b", "s05a", "s05b", "s06b", "s07a", "s07b", "s08b", "s09b"]
GOALS = [0.02, 0.01, 0.005]
COUNTS = [4, 6, 8, 12, 16, 24, 32, 48, 64, 96, 128, 192, 256, 384, 512]


class Measure:
    def __init__(self, penumbra, folder):
        self.penumbra = penumbra
        self.folder = folder

    def render(self, scene, size, picture, *options):
        """Writes the picture and returns the statistics of the run."""
        stats = os.path.join(self.folder, "stats.json")
        subprocess.run([self.penumbra, "render", scene, "--size", size, "--bits", "16", "-o", picture, "--quiet",
                        "--stats", stats, *options], check=True)
        with open(stats) as file:
            return json.load(file)

    def rmse(self, a, b):
        result = subprocess.run([self.penumbra, "compare", a, b, "--json"], capture_output=True, text=True)
        return json.loads(result.stdout)["rmse"]

    def converged(self, scene, size, rays, cache):
        name = f"{os.path.splitext(os.path.basename(scene))[0]}-{size}-{rays}.png"
        picture = os.path.join(cache or self.folder, name)
        if not os.path.exists(picture):
            self.render(scene, size, picture, "--rays", str(rays), "--seed", "77")
        return picture

    def run(self, scene, size, truth, *options):
        """The error, the camera rays per pixel, and all rays per pixel."""
        picture = os.path.join(self.folder, "picture.png")
        stats = self.render(scene, size, picture, *options)
        pixels = math.prod(int(n) for n in size.split("x"))
        return self.rmse(picture, truth), stats["samples"] / pixels, sum(stats["rays"].values()) / pixels


def rays_at(curve, error):
    """The fewest rays per pixel for this error, between the measured points (error, rays) on logarithmic axes."""
    best = math.inf
    for (e0, n0), (e1, n1) in zip(curve, curve[1:]):
        if e0 >= error >= e1:
            share = (math.log(error) - math.log(e0)) / (math.log(e1) - math.log(e0))
            best = min(best, math.exp(math.log(n0) + share * (math.log(n1) - math.log(n0))))
    return best


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--penumbra", default=os.path.join(ROOT, "build/release/penumbra"))
    parser.add_argument("--cache", help="folder for the converged pictures [none: rendered every time]")
    parser.add_argument("--size", default="160x120")
    parser.add_argument("--rays", type=int, default=2048, help="rays per pixel of the converged pictures")
    parser.add_argument("--demo-size", default="320x240")
    parser.add_argument("--demo-rays", type=int, default=4096)
    parser.add_argument("--check", action="store_true", help="only the first table; fail if an error is above 1.2 E")
    parser.add_argument("scenes", nargs="*", help="further scenes")
    arguments = parser.parse_args()
    if arguments.cache:
        os.makedirs(arguments.cache, exist_ok=True)
    with tempfile.TemporaryDirectory() as folder:
        measure = Measure(arguments.penumbra, folder)
        print(f"Error of the picture in units of E, and rays per pixel, {arguments.size}:\n")
        print("| scene |" + "".join(f" E = {e} | rays |" for e in GOALS))
        print("| --- |" + " --: | --: |" * len(GOALS))
        worst = 0
        for path in [os.path.join(ROOT, "scenes", s + ".cli") for s in SCENES] + arguments.scenes:
            truth = measure.converged(path, arguments.size, arguments.rays, arguments.cache)
            row = f"| {os.path.splitext(os.path.basename(path))[0]} |"
            for goal in GOALS:
                error, camera, _ = measure.run(path, arguments.size, truth, "--noise", str(goal))
                worst = max(worst, error / goal)
                row += f" {error / goal:.2f} | {camera:.1f} |"
            print(row, flush=True)
        print(f"\nThe largest is {worst:.2f}.\n")
        if arguments.check:
            raise SystemExit(worst > 1.2)

        demo = os.path.join(ROOT, "scenes/demo.cli")
        size = arguments.demo_size
        truth = measure.converged(demo, size, arguments.demo_rays, arguments.cache)
        uniform = [measure.run(demo, size, truth, "--rays", str(n)) for n in COUNTS]
        print(f"demo.cli, {size}: rays for the same error, uniform / adaptive:\n")
        print("| E | error / E | rays per pixel | camera rays | all rays |\n| --: | --: | --: | --: | --: |")
        for goal in GOALS:
            error, camera, total = measure.run(demo, size, truth, "--noise", str(goal))
            by_camera = rays_at([(e, c) for e, c, _ in uniform], error) / camera
            by_total = rays_at([(e, t) for e, _, t in uniform], error) / total
            print(f"| {goal} | {error / goal:.2f} | {camera:.1f} | {by_camera:.2f} | {by_total:.2f} |", flush=True)


if __name__ == "__main__":
    main()
