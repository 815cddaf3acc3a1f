#!/usr/bin/env python3
"""The variance that each pattern leaves in a picture, relative to `random` at the same number of rays.

The variance is the mean squared difference from a converged picture, over pixels, channels and seeds; the converged
picture's own error is comparatively small and is not subtracted.

usage: bench/variance.py [--penumbra build/release/penumbra] [--rays 64] [--seeds 5] [--size 200x150] SCENE.cli ...
"""
import argparse
import json
import pathlib
import subprocess
import tempfile

PATTERNS = ["random", "regular", "jittered", "multijittered", "poisson", "halton", "sobol", "bluenoise"]


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--penumbra", default="build/release/penumbra")
    parser.add_argument("--rays", type=int, default=64)
    parser.add_argument("--seeds", type=int, default=5)
    parser.add_argument("--size", default="200x150")
    parser.add_argument("--converged", type=int, default=8192)
    parser.add_argument("--patterns", default=",".join(PATTERNS))
    parser.add_argument("scenes", nargs="+")
    args = parser.parse_args()
    patterns = args.patterns.split(",")

    def render(scene, out, *options):
        command = [args.penumbra, "render", scene, "-o", out, "--size", args.size, "--quiet", *map(str, options)]
        subprocess.run(command, check=True)

    def squared_error(a, b):
        run = subprocess.run([args.penumbra, "compare", "--json", a, b], capture_output=True, text=True)
        return json.loads(run.stdout)["rmse"] ** 2

    print(f"variance at {args.rays} rays, random = 1, mean of {args.seeds} seeds")
    print(f"{'scene':24}" + "".join(f"{p:>15}" for p in patterns))
    with tempfile.TemporaryDirectory() as folder:
        converged = str(pathlib.Path(folder) / "converged.exr")
        picture = str(pathlib.Path(folder) / "picture.exr")
        for scene in args.scenes:
            render(scene, converged, "--rays", args.converged, "--seed", 1000)
            variance = {}
            for pattern in {"random", *patterns}:
                total = 0
                for seed in range(args.seeds):
                    render(scene, picture, "--rays", args.rays, "--sampler", pattern, "--seed", seed)
                    total += squared_error(picture, converged)
                variance[pattern] = total / args.seeds
            row = "".join(f"{variance[p] / variance['random']:15.3f}" for p in patterns)
            print(f"{pathlib.Path(scene).name:24}{row}", flush=True)


if __name__ == "__main__":
    main()
