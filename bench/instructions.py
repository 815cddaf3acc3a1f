#!/usr/bin/env python3
"""Counts the instructions of the render loop on four small scenes, under callgrind, and compares them with the counts
in instructions.json. A count has no noise: it depends on the compiler and on the code, not on the machine or its load.
Only render_samples() and what it calls is counted, not the start, which libc does differently on each processor.

Fails if a scene needs 3 % more or fewer instructions than recorded. If there are no counts for the compiler, it only
says so. After a change that is meant to be faster, or is worth its cost, `make instructions` writes the new counts."""

import argparse
import json
import os
import re
import subprocess
import sys
import tempfile

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
COUNTS = os.path.join(ROOT, "bench/instructions.json")
ISA = "avx2"  # the widest that callgrind supports
SCENES = {  # at 16 rays per pixel, packets are full
    "s05b": ["--size", "96x96", "--rays", "16"],
    "s07b": ["--size", "80x80", "--rays", "16"],
    "s08b": ["--size", "80x80", "--rays", "16"],
    "demo": ["--size", "64x48", "--rays", "16"],
}
TOLERANCE = 0.03


def compiler_of(program):
    """The compiler recorded in the program, such as "GCC 12.2.0"; other compilers have other counts."""
    text = subprocess.run(["readelf", "-p", ".comment", program], check=True, capture_output=True, text=True).stdout
    names = set()
    for line in text.splitlines():
        match = re.search(r"\] +(?P<name>GCC|.*clang version).* (?P<version>\d+\.\d+\.\d+)", line)
        if match:
            names.add(f"{'GCC' if match['name'] == 'GCC' else 'Clang'} {match['version']}")
    return " and ".join(sorted(names)) or "unknown"


def count(penumbra, scene, options):
    """The instructions of the render loop for a scene file."""
    with tempfile.TemporaryDirectory() as folder:
        profile = os.path.join(folder, "callgrind.out")
        command = ["valgrind", "--tool=callgrind", f"--callgrind-out-file={profile}",
                   "--toggle-collect=penumbra::render_samples(*RenderState&)",
                   penumbra, "render", scene, "-o",
                   os.path.join(folder, "out.png"), "--quiet", "--threads", "1", "--isa", ISA, *options]
        result = subprocess.run(command, capture_output=True, text=True)
        if result.returncode != 0:
            sys.exit(f"{scene}: {result.stderr}")
        with open(profile) as file:
            total = re.search(r"^(?:totals|summary): (\d+)", file.read(), re.MULTILINE)
    if not total or int(total[1]) == 0:
        sys.exit(f"{scene}: nothing was counted; is there still a function render_samples(..., RenderState&)?")
    return int(total[1])


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--penumbra", default=os.path.join(ROOT, "build/release/penumbra"))
    parser.add_argument("--update", action="store_true", help="write the counts into instructions.json")
    arguments = parser.parse_args()

    with open("/proc/cpuinfo") as file:
        if ISA not in file.read():
            print(f"instructions: skipped, this machine has no {ISA}")
            return
    compiler = compiler_of(arguments.penumbra)
    with open(COUNTS) as file:
        written = json.load(file)
    known = written.get(compiler, {})
    counts = {}
    worst = 0
    for scene, options in SCENES.items():
        counts[scene] = count(arguments.penumbra, os.path.join(ROOT, "scenes", scene + ".cli"), options)
        line = f"{scene}: {counts[scene]:,} instructions"
        if scene in known:
            change = counts[scene] / known[scene] - 1
            worst = max(worst, abs(change))
            line += f", {change:+.2%}"
        print(line, flush=True)
    if arguments.update:
        written[compiler] = counts
        with open(COUNTS, "w") as file:
            json.dump(written, file, indent=2, sort_keys=True)
            file.write("\n")
        print(f"{COUNTS}: counts of {compiler} written")
    elif set(known) != set(SCENES):
        print(f"warning: bench/instructions.json has no counts of {compiler} for all of these; nothing was compared")
    elif worst > TOLERANCE:
        sys.exit(f"instructions: more than {TOLERANCE:.0%} from bench/instructions.json. If that is intended, "
                 "`make instructions` writes the new counts; say in the commit what they were.")


if __name__ == "__main__":
    main()
