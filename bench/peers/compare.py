#!/usr/bin/env python3
"""Compares Penumbra with POV-Ray and Cycles on the scenes A to E, 300x300, one thread on one core: at equal rays (100
per pixel) and at equal error (a linear RMSE of 0.002, each renderer against its own converged pictures). Prints tables;
writes all figures (JSON) and a plot of each scene to the results folder.

Seconds are CPU seconds, the least of all turns, so that other work on the core matters little. Converged pictures
take some ten minutes; they are kept in the work folder."""

import argparse
import csv
import dataclasses
import datetime
import functools
import json
import os
import re
import subprocess
import sys
import time

import bumpy_sphere
import curves
import report
from renderers import SIZE, Cycles, Penumbra, PovRay

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))


@dataclasses.dataclass
class Series:
    """A curve to measure: the values for every scene, one more for some scenes, and more options for the renderer."""

    name: str
    renderer: object
    values: list
    one_more: dict = dataclasses.field(default_factory=dict)
    adaptive: bool = False
    options: dict = dataclasses.field(default_factory=dict)

    def values_for(self, scene):
        if scene not in self.renderer.scenes:
            return []
        return self.values + ([self.one_more[scene]] if scene in self.one_more else [])

    def is_long(self, value):
        return not isinstance(self.renderer, Penumbra) and (self.adaptive or value > report.EQUAL_RAYS)


def series_of(penumbra, povray, cycles):
    patterns = ["random", "multijittered", "halton", "bluenoise"]
    return [
        Series("POV-Ray", povray, [16, 36, 64, 100, 256]),
        Series("POV-Ray adaptive", povray, [16, 36, 81, 144], adaptive=True),
        Series("Cycles", cycles, [16, 64, 100, 256], {"C": 400, "D": 1400}),
        Series("Cycles adaptive", cycles, [0.05, 0.02, 0.01], {"D": 0.005}, adaptive=True),
        Series("Penumbra", penumbra, [4, 16, 32, 64, 100, 128, 256]),
        Series("Penumbra --noise", penumbra, [0.02, 0.014, 0.01, 0.007, 0.005], adaptive=True),
        *[Series(f"Penumbra {p}", penumbra, [16, 64, 256], options={"options": ["--sampler", p]}) for p in patterns]]


def plan(arguments, series):
    """What to measure, in this order: (turn, scene, series, value)."""
    for turn in range(arguments.turns):
        for scene in arguments.scenes:
            for one in series:
                for value in one.values_for(scene):
                    if turn < arguments.long_turns or not one.is_long(value):
                        yield turn, scene, one, value


class Bench:
    def __init__(self, work, core):
        self.work = work
        self.core = core

    def run(self, command):
        """Runs it in the work folder, pinned to the core; returns its output and what the whole process took."""
        log = os.path.join(self.work, "output.txt")
        with open(log, "w") as output:
            start = time.perf_counter()
            process = subprocess.Popen(["taskset", "-c", str(self.core), *command], cwd=self.work, stdout=output,
                                       stderr=subprocess.STDOUT)
            _, status, usage = os.wait4(process.pid, 0)
            wall = time.perf_counter() - start
        with open(log, errors="replace") as output:
            printed = output.read()
        if status != 0:
            sys.exit(f"{' '.join(command)}\n{printed[-2000:]}\nfailed")
        return printed, {"process_seconds": wall, "process_cpu_seconds": usage.ru_utime + usage.ru_stime,
                         "peak_memory_bytes": usage.ru_maxrss * 1024}

    @functools.cache
    def converged(self, renderer, scene):
        pictures = []
        for rays, seed in renderer.converged(scene):
            name = f"converged-{renderer.name}-{scene}-{rays}-{seed}{renderer.picture_suffix}"
            path = os.path.join(self.work, name)
            if not os.path.exists(path):
                print(f"rendering {path}", file=sys.stderr, flush=True)
                part = "part-" + name
                self.run(renderer.command(scene, rays, seed, part))
                os.replace(os.path.join(self.work, part), path)
            pictures.append(curves.read_picture(path, SIZE))
        return pictures

    def measure(self, series, scene, value):
        renderer = series.renderer
        converged = self.converged(renderer, scene)
        picture = "picture" + renderer.picture_suffix
        printed, figures = self.run(renderer.command(scene, value, 0, picture, series.adaptive, **series.options))
        seconds, cpu_seconds = renderer.seconds(printed)
        error = curves.rmse(curves.read_picture(os.path.join(self.work, picture), SIZE), converged)
        return {"render_seconds": seconds, "render_cpu_seconds": cpu_seconds, "rmse": error, **figures}


def machine():
    with open("/proc/cpuinfo") as file:
        text = file.read()
    model, family, number = (re.search(rf"^{name}\s*: (.*)$", text, re.MULTILINE)[1]
                             for name in ["model name", "cpu family", "model"])
    with open("/etc/os-release") as file:
        system = re.search(r'^PRETTY_NAME="(.*)"$', file.read(), re.MULTILINE)[1]
    return f"{model} (family {family}, model {number}), {os.cpu_count()} cores, {system}"


def read_cited(path):
    if not path:
        return []
    with open(path) as file:
        rows = csv.DictReader(line for line in file if not line.startswith("#"))
        return [{"scene": r["scene"], "series": r["series"], "rays": float(r["rays"]), "seconds": float(r["seconds"]),
                 "rmse": float(r["rmse"])} for r in rows]


def measure_all(arguments):
    os.makedirs(arguments.work, exist_ok=True)
    bumpy_sphere.write(arguments.work)
    penumbra, povray, cycles = Penumbra(arguments.penumbra, arguments.work), PovRay(), Cycles()
    bench = Bench(arguments.work, arguments.core)
    results = {"date": datetime.datetime.now(datetime.timezone.utc).isoformat(timespec="seconds"),
               "machine": machine(), "core": arguments.core, "turns": arguments.turns, "size": [SIZE, SIZE],
               "versions": [r.version() for r in (penumbra, povray, cycles)], "runs": []}
    for turn, scene, series, value in plan(arguments, series_of(penumbra, povray, cycles)):
        run = bench.measure(series, scene, value)
        results["runs"].append({"scene": scene, "series": series.name, "value": value, "turn": turn, **run})
        print(f"turn {turn} {scene} {series.name} {value:g}: {run['render_cpu_seconds']:.3f} s, "
              f"RMSE {run['rmse']:.5f}", file=sys.stderr, flush=True)
    results["converged_errors"] = {scene: {r.name: curves.spread(bench.converged(r, scene))
                                           for r in (penumbra, povray, cycles) if scene in r.scenes}
                                   for scene in arguments.scenes}
    results["cited"] = read_cited(arguments.cited)
    return results


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--penumbra", default=os.path.join(ROOT, "build/release/penumbra"))
    parser.add_argument("--work", default=os.path.join(ROOT, "build/peers"),
                        help="folder of the mesh and of the converged pictures, which later runs reuse")
    parser.add_argument("--results", default=os.path.join(ROOT, "build/peers/results"), help="folder of the results")
    parser.add_argument("--plots", help="folder of the plots [the folder of the results]")
    parser.add_argument("--cited", help="figures of other renderers, from elsewhere, such as bench/peers/pbrt-v3.csv")
    parser.add_argument("--scenes", default="ABCDE")
    parser.add_argument("--turns", type=int, default=3)
    parser.add_argument("--long-turns", type=int, default=1,
                        help="turns for peers' pictures with more than 100 rays and for their adaptive ones")
    parser.add_argument("--core", type=int, default=0)
    parser.add_argument("--report", metavar="FILE.json", help="measure nothing; report an earlier run")
    arguments = parser.parse_args()
    if arguments.report:
        with open(arguments.report) as file:
            results = json.load(file)
    else:
        results = measure_all(arguments)
        os.makedirs(arguments.results, exist_ok=True)
        name = "peers-" + re.sub(r"[^0-9T]", "", results["date"][:19]) + ".json"
        with open(os.path.join(arguments.results, name), "w") as file:
            json.dump(results, file, indent=1)
    print(report.tables(results))
    report.plot(results, arguments.plots or arguments.results)


if __name__ == "__main__":
    main()
