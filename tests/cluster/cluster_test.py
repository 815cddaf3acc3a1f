#!/usr/bin/env python3
"""A frame in 24 shards and an animation of 12 frames on a Slurm cluster of three nodes, first undisturbed, then with
everything that can go wrong on a cluster: whatever happens, the pictures are the files that one machine writes, to the
byte, and nothing is rendered twice except what was lost.

usage: cluster_test.py --penumbra build/release/penumbra"""

import argparse
import json
import os
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import threading
import time

from loop_cluster import LoopCluster, processes, wait_until

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
NAME = "the picture's \"file\".exr"
SHARDS = 24
FRAMES = 12
# Enough rays for each part to be caught while it is rendered.
OPTIONS = ["--size", "480x270", "--rays", "192", "--aov", "depth,samples"]
ANIMATION = ["--frames", f"1-{FRAMES}", "--size", "240x180", "--rays", "256"]
PATIENCE = 150  # seconds for one job, even if the processors are busy with other things


PART = r"(\d+)(\.\d+)?\.exr"


def require(condition, what):
    if not condition:
        raise AssertionError(what)


class Farm:
    """One job and what is known about it."""

    def __init__(self, penumbra, cluster, folder, scene):
        self.penumbra, self.cluster = penumbra, cluster
        os.mkdir(folder)
        self.place = folder
        self.frames = 1
        self.output = os.path.join(folder, NAME)
        self.folder = self.output + ".farm"
        self.scene = scene

    def run(self, *words, code=0):
        result = subprocess.run([self.penumbra, "farm", *words], capture_output=True, text=True, check=False)
        require(result.returncode == code, f"farm {words[0]}: exit code {result.returncode}, not {code}: "
                                           f"{result.stdout}{result.stderr}")
        return result.stdout

    def submit(self, *words):
        print(self.run("submit", self.scene, "-o", self.output, *words), end="", flush=True)

    def status(self):
        return json.loads(self.run("status", self.output, "--json"))

    def parts(self):
        """The files of the parts that exist, by their units, the oldest first."""
        with os.scandir(os.path.join(self.folder, "parts")) as entries:
            found = [(entry.stat().st_mtime, entry.path) for entry in entries if re.fullmatch(PART, entry.name)]
        return {int(os.path.basename(path).split(".")[0]): path for _, path in sorted(found)}

    def renders(self):
        """The units that are being rendered, and their processes."""
        found = {}
        for process in processes():
            words = process.words
            if len(words) > 2 and words[0] == self.penumbra and words[1] == "render" and "-o" in words:
                part = re.fullmatch(r"parts/(\d+)\.exr", words[words.index("-o") + 1])
                if part and os.path.samefile(f"/proc/{process.pid}/cwd", self.folder):
                    found[int(part[1])] = process
        return found

    def hold(self, among=lambda unit, process: True):
        """A unit that is being rendered, stopped before its part is written, and its process."""
        for unit, process in sorted(self.renders().items(), key=lambda item: item[0]):
            if not among(unit, process):
                continue
            if process.hold() and unit not in self.parts():
                return unit, process
            process.send(signal.SIGCONT)
        return None

    def wait(self):
        state = os.path.join(self.folder, "state.json")

        def finished():
            with open(state, encoding="utf-8") as file:
                return len(json.load(file)["finished"]) == self.frames

        wait_until(finished, PATIENCE, "finished job", self.cluster.hurry)
        require(self.status()["finished"], self.status())

    def log(self):
        text = ""
        for name in sorted(os.listdir(os.path.join(self.folder, "logs"))):
            with open(os.path.join(self.folder, "logs", name), encoding="utf-8") as file:
                text += file.read()
        return text

    def counts(self, pattern):
        """How often a line occurs in the logs, for each unit."""
        found = [int(unit) for unit in re.findall(pattern, self.log(), re.MULTILINE)]
        return {unit: found.count(unit) for unit in set(found)}

    def begun(self):
        return self.counts(r"^unit (\d+) begins")

    def rendered(self):
        return self.counts(r"^parts/(\d+)(?:\.\d+)?\.exr: \d+x\d+ pixels")

    def require_pictures(self, expected):
        """Requires the pictures of one machine, which are in the folder `expected`."""
        names = sorted(os.listdir(expected))
        require(len(names) == self.frames, names)
        for name in names:
            with open(os.path.join(expected, name), "rb") as one, open(os.path.join(self.place, name), "rb") as many:
                require(one.read() == many.read(), f"{name} is not the file of one machine")


def once(units, *twice):
    return {unit: 2 if unit in twice else 1 for unit in range(units)}


class Slowed(threading.Thread):
    """Lets a process run for a tenth of the time."""

    def __init__(self, process):
        super().__init__(daemon=True)
        self.process = process
        self.start()

    def run(self):
        while os.path.exists(f"/proc/{self.process.pid}"):
            self.process.send(signal.SIGSTOP)
            time.sleep(0.09)
            self.process.send(signal.SIGCONT)
            time.sleep(0.01)


def undisturbed(farm, expected, units, words):
    farm.submit("--partition", "render", "--time", "10m", *words)
    wait_until(lambda: len(farm.parts()) >= 3, PATIENCE, "three parts")
    status = farm.status()
    require(status["slurm"] and status["parts"] == units and status["done"] >= 3 and not status["lost"], status)
    farm.wait()
    farm.require_pictures(expected)
    require(farm.begun() == once(units) and farm.rendered() == once(units), farm.log())


def disturbed(farm, expected, units, words):
    cluster = farm.cluster
    farm.submit(*words)
    submitted = time.time()
    wait_until(lambda: len(farm.renders()) == 3, PATIENCE, "three tasks at a time")
    interrupted, process = wait_until(farm.hold, PATIENCE, "task to interrupt")
    process.send(signal.SIGTERM)
    process.send(signal.SIGCONT)
    slow, process = wait_until(lambda: farm.hold(lambda unit, _: unit != interrupted), PATIENCE, "task to slow down")
    Slowed(process)
    print(f"  shard {slow} is ten times slower, {interrupted} has to end, exit code 75", flush=True)

    wait_until(lambda: len(farm.parts()) >= 3, PATIENCE, "three parts", cluster.hurry)
    (torn, torn_file), (deleted, deleted_file) = list(farm.parts().items())[:2]
    os.truncate(torn_file, os.path.getsize(torn_file) - 1000)
    os.remove(deleted_file)
    print(f"  part {torn} is torn, {deleted} deleted", flush=True)

    def is_on_n2(unit, render):
        return unit != slow and render.pid in {process.pid for process in cluster.tasks_of("n2")}

    killed, _ = wait_until(lambda: farm.hold(is_on_n2), PATIENCE, "task on n2", cluster.hurry)
    cluster.kill_node("n2")
    print(f"  n2 is dead, and shard {killed} with it", flush=True)
    cluster.kill_controller(submitted)
    status = farm.status()
    require(not status["slurm"] and status["unknown"] and status["done"] > 0, status)
    farm.run("collect", farm.output, code=65)
    print("  the controller is dead; status still works", flush=True)
    time.sleep(1)
    cluster.restart_controller()
    cluster.declare_down("n2")
    wait_until(lambda: farm.begun().get(killed, 0) == 2, PATIENCE, f"second start of {killed}", cluster.hurry)
    cluster.start_node("n2")

    farm.wait()
    farm.require_pictures(expected)
    require(farm.status()["resubmissions"] == 1, farm.status())
    begun, rendered = farm.begun(), farm.rendered()
    require(rendered == once(units, torn, deleted), f"rendered: {rendered}")
    again = {unit for unit, count in begun.items() if count > rendered[unit]}
    require(again == {interrupted, killed}, f"begun again: {again}")
    cluster.wait_for_idle_nodes(3)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--penumbra", required=True)
    parser.add_argument("--keep", action="store_true", help="keep the folder of the cluster for inspection")
    arguments = parser.parse_args()
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(1))  # stops the cluster first
    penumbra = os.path.abspath(arguments.penumbra)
    scratch = tempfile.mkdtemp(prefix="penumbra-cluster-")
    start = time.monotonic()
    try:
        work = os.path.join(scratch, "it's 100% \"odd\" $HOME")  # names must not matter
        os.mkdir(work)
        jobs = {"frame": ("demo", 1, SHARDS, OPTIONS, ["--shards", str(SHARDS)]),
                "animation": ("carousel", FRAMES, FRAMES, ANIMATION, ["--shards", "1"])}
        with LoopCluster(os.path.join(scratch, "slurm")) as cluster:
            for name, (scene_name, frames, units, options, shards) in jobs.items():
                scene = os.path.join(work, f"a {scene_name}.cli")
                shutil.copy(os.path.join(ROOT, f"scenes/{scene_name}.cli"), scene)
                expected = os.path.join(work, f"one machine's {name}")
                os.mkdir(expected)
                subprocess.run([penumbra, "render", scene, "-o", os.path.join(expected, NAME), "--quiet", *options],
                               check=True)
                for scenario in [undisturbed, disturbed]:
                    print(f"{name}, {scenario.__name__} ({time.monotonic() - start:.0f} s)", flush=True)
                    farm = Farm(penumbra, cluster, os.path.join(work, f"{name} {scenario.__name__}"), scene)
                    farm.frames = frames
                    scenario(farm, expected, units, options + shards)
        print(f"the cluster's pictures are those of one machine ({time.monotonic() - start:.0f} s)")
    finally:
        if arguments.keep:
            print(f"kept for inspection: {scratch}", file=sys.stderr)
        else:
            shutil.rmtree(scratch, ignore_errors=True)


if __name__ == "__main__":
    main()
