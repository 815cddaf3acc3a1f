#!/usr/bin/env python3
"""Measures the cost of dividing a picture into shards (`--shard i/n`), and prints a table: for each n, the sum of the
times of all shards over the time of one whole render, the largest over the mean of the shards' times, and the time of
`merge`. Times are CPU times of whole processes with one thread, including start, reading, building and writing. The
whole render and all its shards are run in turn, several times, and the best time of each counts: machines have slow
seconds. With --check, the exit code is 1 if a ratio is not below its bound."""

import argparse
import filecmp
import os
import subprocess
import sys
import tempfile

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
MOST_OVERHEAD = 1.05  # sum of the shards over the whole
MOST_UNEVEN = 1.15  # largest shard over the mean


def seconds_of(command):
    """Runs a command; returns the CPU seconds that it took."""
    process = subprocess.Popen(command)
    _, status, usage = os.wait4(process.pid, 0)
    process.returncode = os.waitstatus_to_exitcode(status)
    if process.returncode != 0:
        sys.exit(f"{' '.join(command)}: exit code {process.returncode}")
    return usage.ru_utime + usage.ru_stime


def best_of_turns(turns, commands):
    """The least seconds of each command over some turns of all commands."""
    return [min(times) for times in zip(*([seconds_of(c) for c in commands] for _ in range(turns)))]


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--penumbra", default=os.path.join(ROOT, "build/release/penumbra"))
    parser.add_argument("--scene", default=os.path.join(ROOT, "scenes/demo.cli"))
    parser.add_argument("--size", default="1280x720")
    parser.add_argument("--rays", default="64")
    parser.add_argument("--counts", default="2,3,4,8,16,24,32,48,64", help="the numbers of shards")
    parser.add_argument("--turns", type=int, default=3, help="turns, of which the best counts for each render")
    parser.add_argument("--check", action="store_true", help="fail if a ratio is not below its bound")
    arguments = parser.parse_args()

    render = [arguments.penumbra, "render", arguments.scene, "--size", arguments.size, "--rays", arguments.rays,
              "--threads", "1", "--quiet"]
    good = True
    print("| shards | sum / whole | largest / mean | whole s | mean shard s | merge s |")
    print("| --: | --: | --: | --: | --: | --: |", flush=True)
    with tempfile.TemporaryDirectory() as folder:
        whole, merged = os.path.join(folder, "whole.exr"), os.path.join(folder, "merged.exr")
        for count in [int(n) for n in arguments.counts.split(",")]:
            parts = [os.path.join(folder, f"{i}.exr") for i in range(count)]
            single, *times = best_of_turns(
                arguments.turns, [[*render, "-o", whole]] + [[*render, "--shard", f"{i}/{count}", "-o", part]
                                                             for i, part in enumerate(parts)])
            merge = seconds_of([arguments.penumbra, "merge", "--quiet", *parts, "-o", merged])
            if not filecmp.cmp(whole, merged, shallow=False):
                sys.exit(f"{count} shards do not give the bytes of one render")
            mean = sum(times) / count
            overhead, uneven = sum(times) / single, max(times) / mean
            good &= overhead < MOST_OVERHEAD and uneven < MOST_UNEVEN
            print(f"| {count} | {overhead:.3f} | {uneven:.3f} | {single:.2f} | {mean:.3f} | {merge:.3f} |", flush=True)
            for part in parts:
                os.remove(part)
    if arguments.check and not good:
        sys.exit(f"a ratio is not below its bound: {MOST_OVERHEAD} and {MOST_UNEVEN}")


if __name__ == "__main__":
    main()
