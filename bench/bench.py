#!/usr/bin/env python3
"""Measures the program and prints tables: whole renders against the hand-specialised packet prototype (if its folder
and AVX-512 are available), renders against those of an earlier revision, rays per second of the project's own scenes,
the instruction sets against each other, a large picture against a small one, two threads against one, meshes against
Embree alone, and the speed of reading. Things that are compared take turns within one run; a table shows medians and
the median of the ratios of all turns."""

import argparse
import contextlib
import json
import os
import re
import statistics
import subprocess
import tempfile
import time

import scaling

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
PROTOTYPE_SCENES = ["a", "b", "aG", "bG"]
RUNS_OF_A_TURN = 10
SCENES = ["demo"] + [f"s0{n}b" for n in range(1, 10)]


@contextlib.contextmanager
def one_core():
    """Runs everything that is started inside on one core, without a wrapper program whose start would count, too."""
    cores = os.sched_getaffinity(0)
    os.sched_setaffinity(0, {min(cores)})
    try:
        yield
    finally:
        os.sched_setaffinity(0, cores)


def render(penumbra, scene, *options, file="out.png"):
    """Renders on one thread and returns the statistics of the run."""
    with tempfile.TemporaryDirectory() as folder:
        stats = os.path.join(folder, "stats.json")
        run_once(penumbra, scene, os.path.join(folder, file), "--stats", stats, *options)
        with open(stats) as file:
            return json.load(file)


def timed_run(penumbra, scene, *options):
    """The seconds from start to end of a process that writes only the picture, and its output."""
    with tempfile.TemporaryDirectory() as folder:
        start = time.perf_counter()
        printed = run_once(penumbra, scene, os.path.join(folder, "out.png"), *options)
        return time.perf_counter() - start, printed


def rendering_and_rest(penumbra, scene, *options):
    """The seconds a process takes to render, and those for everything else, including printing its statistics."""
    whole, stats = timed_run(penumbra, scene, "--stats", "/dev/stdout", *options)
    rendering = json.loads(stats)["render_seconds"]
    return rendering, whole - rendering


def seconds_of_nothing():
    """The seconds any process takes: to start and end one that does nothing."""
    def once():
        start = time.perf_counter()
        subprocess.run(["/bin/true"], check=True)
        return time.perf_counter() - start
    return statistics.median(once() for _ in range(50))


def run_once(penumbra, scene, picture, *options):
    return subprocess.run([penumbra, "render", scene, "-o", picture, "--quiet", "--threads", "1", *options], check=True,
                          stdout=subprocess.PIPE).stdout


def build_prototype(peers, folder):
    program = os.path.join(folder, "mini_render")
    subprocess.run(["g++", "-O3", "-march=native", "-mprefer-vector-width=512", "-std=c++20",
                    os.path.join(peers, "mini_render.cpp"), "-o", program, "-lembree3"], check=True)
    return program


def prototype_seconds(program):
    """Maps scene names to the render seconds of the faster of the prototype's own kernels."""
    text = subprocess.run([program, "1"], check=True, capture_output=True, text=True).stdout
    seconds = {}
    scene = None
    for line in text.splitlines():
        if line.startswith("## scene"):
            scene = line.split()[2]
        match = re.search(r", own(?: BVH2/brute)? +(\d+\.\d+)", line)
        if match and line.startswith("16-wide packet"):
            value = float(match.group(1))
            seconds[scene] = min(value, seconds.get(scene, value))
    return seconds


def has_avx512():
    with open("/proc/cpuinfo") as file:
        return "avx512f" in file.read()


def compare_with_prototype(penumbra, peers, turns):
    if not os.path.exists(os.path.join(peers, "mini_render.cpp")):
        print(f"prototype: skipped, no folder {peers} (set PENUMBRA_PEERS_DIR)\n")
        return
    if not has_avx512():
        print("prototype: skipped, this machine has no AVX-512\n")
        return
    turn_of = {s: [] for s in PROTOTYPE_SCENES}
    with tempfile.TemporaryDirectory() as folder:
        prototype = build_prototype(peers, folder)
        for _ in range(turns):
            theirs = prototype_seconds(prototype)
            for scene in PROTOTYPE_SCENES:
                path = os.path.join(peers, f"proto-{scene}.cli")
                # The prototype's figure is the best of several renders, and so is ours.
                whole = min(timed_run(penumbra, path)[0] for _ in range(RUNS_OF_A_TURN))
                rendering, rest = map(min, zip(*(rendering_and_rest(penumbra, path) for _ in range(RUNS_OF_A_TURN))))
                turn_of[scene].append((theirs[scene], rendering, whole, rest))
    print(f"Whole processes against the hand-specialised prototype's rendering, 300x300, 100 rays, 1 thread, "
          f"{turns} turns:\n")
    print("| scene | prototype s | penumbra: render s | whole s | the rest ms | whole / prototype: median | best |\n"
          "| --- | --: | --: | --: | --: | --: | --: |")
    for scene, all_turns in turn_of.items():
        best = [min(values) for values in zip(*all_turns)]
        ratio = statistics.median(whole / theirs for theirs, _, whole, _ in all_turns)
        rest = statistics.median(rest for *_, rest in all_turns)
        print(f"| {scene} | {best[0]:.4f} | {best[1]:.4f} | {best[2]:.4f} | {rest * 1e3:.1f} | {ratio:.2f} "
              f"| {best[2] / best[0]:.2f} |")
    print(f"\nTo start and end /bin/true takes {seconds_of_nothing() * 1e3:.1f} ms.\n")


def rays_per_second(penumbra, turns):
    print("The project's own scenes, 1 thread, 16 rays per pixel:\n")
    print("| scene | Mrays | render s | Mrays/s | parse + build + write ms | peak MB |")
    print("| --- | --: | --: | --: | --: | --: |")
    for scene in SCENES:
        path = os.path.join(ROOT, "scenes", scene + ".cli")
        runs = [render(penumbra, path, "--rays", "16") for _ in range(turns)]
        seconds = statistics.median(r["render_seconds"] for r in runs)
        rays = sum(runs[0]["rays"].values())
        other = statistics.median(r["parse_seconds"] + r["build_seconds"] + r["write_seconds"] for r in runs)
        print(f"| {scene} | {rays * 1e-6:.1f} | {seconds:.3f} | {rays / seconds * 1e-6:.1f} | {other * 1e3:.1f} "
              f"| {runs[0]['peak_memory_bytes'] >> 20} |")
    print()


def compare_instruction_sets(penumbra, turns):
    if not has_avx512():
        print("instruction sets: skipped, this machine has no AVX-512\n")
        return
    print("Rays per second against those of AVX-512, 1 thread, 16 rays per pixel:\n")
    print("| scene | AVX2 | SSE4.2 |\n| --- | --: | --: |", flush=True)
    for scene in SCENES:
        path = os.path.join(ROOT, "scenes", scene + ".cli")
        speeds = {"avx2": [], "sse42": []}
        for _ in range(turns):
            widest = render(penumbra, path, "--rays", "16", "--isa", "avx512")["render_seconds"]
            for isa, of_turns in speeds.items():
                of_turns.append(widest / render(penumbra, path, "--rays", "16", "--isa", isa)["render_seconds"])
        print(f"| {scene} | " + " | ".join(f"{statistics.median(s):.2f}" for s in speeds.values()) + " |", flush=True)
    print()


def compare_sizes(penumbra, turns):
    path = os.path.join(ROOT, "scenes/demo.cli")

    def speed(*options, file="out.png"):
        run = render(penumbra, path, "--rays", "256", *options, file=file)
        return sum(run["rays"].values()) / run["render_seconds"]

    # The tiles of a shard lie all over the picture, and its film is that of the whole picture.
    ratios = [speed("--size", "3840x2160", "--shard", f"{turn}/64", file="part.exr") / speed("--size", "300x300")
              for turn in range(turns)]
    print(f"3840x2160 (a 64th of it in turn) against 300x300, demo.cli, 256 rays, rays per second: "
          f"{statistics.median(ratios):.2f}\n")


def build_revision(revision):
    """Builds another revision of the project in a separate folder, and returns the path of the program."""
    folder = os.path.join(ROOT, "build", "before")
    if not os.path.isdir(folder):
        subprocess.run(["git", "clone", "--quiet", "--no-checkout", ROOT, folder], check=True)
    subprocess.run(["git", "-C", folder, "fetch", "--quiet", "--tags"], check=True)
    commit = subprocess.run(["git", "-C", ROOT, "rev-parse", revision + "^{commit}"], check=True, capture_output=True,
                            text=True).stdout.strip()
    subprocess.run(["git", "-C", folder, "checkout", "--quiet", "--detach", commit], check=True)
    for step in (["--preset", "release", "-DPENUMBRA_TESTS=OFF"], ["--build", "--preset", "release"]):
        subprocess.run(["cmake", *step], cwd=folder, check=True, stdout=subprocess.DEVNULL)
    return os.path.join(folder, "build/release/penumbra")


def compare_with_revision(penumbra, before, revision, turns):
    if not before:
        print("An earlier revision: skipped, there is no tag (make bench BEFORE=REVISION)\n")
        return
    print(f"Render seconds against those of {revision}, 1 thread, 16 rays per pixel, {turns} turns:\n")
    print("| scene | then s | now s | now / then |\n| --- | --: | --: | --: |")
    for scene in ["demo"] + [f"s0{n}b" for n in range(1, 10)]:
        path = os.path.join(ROOT, "scenes", scene + ".cli")
        pairs = [[render(program, path, "--rays", "16")["render_seconds"] for program in (before, penumbra)]
                 for _ in range(turns)]
        then, now = (statistics.median(values) for values in zip(*pairs))
        print(f"| {scene} | {then:.3f} | {now:.3f} | {statistics.median(b / a for a, b in pairs):.2f} |")
    print()


def compare_growth(penumbra, before, turns):
    """How render seconds grow with depth, lights and shapes, over three decades; with an earlier revision, against it."""
    print("How seconds grow, 300x300, 16 rays per pixel, 1 thread: rendering, and in brackets all else:\n")
    print("| what | size | now s |" + (" then s | now / then |" if before else "") + "\n| --- | --: | --: |" +
          (" --: | --: |" if before else ""))
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "scene.cli")
        for what, make, sizes, most_before in [("depth of glass", scaling.glass, [2, 4, 8, 16, 100], 8),
                                               ("lights", scaling.lights, [10, 100, 1000, 10_000], 1000),
                                               ("shapes", scaling.shapes, [1000, 10_000, 100_000, 1_000_000], 10**9)]:
            for size in sizes:
                with open(path, "w") as file:
                    file.write("\n".join(make(size)) + "\n")
                programs = [penumbra] + ([before] if before and size <= most_before else [])
                runs = [[rendering_and_rest(program, path, "--rays", "16") for program in programs]
                        for _ in range(turns)]
                def seconds(k):
                    return " ".join(f.format(statistics.median(run[k][part] for run in runs))
                                    for part, f in ((0, "{:.3f}"), (1, "({:.3f})")))
                row = f"| {what} | {size} | {seconds(0)} |"
                if len(programs) == 2:
                    ratio = statistics.median(sum(run[0]) / sum(run[1]) for run in runs)
                    row += f" {seconds(1)} | {ratio:.2f} |"
                elif before:
                    row += " | |"
                print(row, flush=True)
    print()


MESH_SCENE = """fov 60
image_size 300 300
background .2 .4 .8
disk_light 2 5 -4  .9  0 -1 0  .8 .8 .8
light -5 5 5  .15 .15 .15
{ground}
glossy .64 .24 .16  .3 .3 .3  50  0 0
mesh {mesh}
"""

GROUND = """diffuse .63 .63 .63  .07 .07 .07
begin
vertex -40 -1 10
vertex 40 -1 10
vertex 40 -1 -60
end
begin
vertex -40 -1 10
vertex 40 -1 -60
vertex -40 -1 -60
end"""


def compare_with_embree(mesh_replay, bumpy_sphere, turns):
    if not has_avx512():
        print("Embree: skipped, this machine has no AVX-512\n")
        return
    print("Renders of meshes against Embree alone, 300x300, 1 thread: against the packets that reach the mesh, then "
          "against\nall rays through one Embree scene, the ground in it:\n", flush=True)
    with tempfile.TemporaryDirectory() as folder:
        def write_scene(name, rows, *ground):
            path = os.path.join(folder, name)
            subprocess.run([bumpy_sphere, str(rows), path + ".ply", *ground], check=True)
            with open(path + ".cli", "w") as file:
                file.write(MESH_SCENE.format(mesh=name + ".ply", ground="" if ground else GROUND))
            return path + ".cli"

        def write_instances(name, rows):
            """49 smaller copies of the mesh in a square."""
            path = write_scene(name, rows)
            with open(path) as file:
                text = file.read()
            with open(path, "w") as file:
                file.write(text + "named_object ball\n")
                for i in range(49):
                    file.write(f"push\ntranslate {i % 7 - 3} {i // 7 - 3} 0\ntranslate 0 0 -4\nscale .4 .4 .4\n"
                               "translate 0 0 4\ninstance ball\npop\n")
            return path

        for rows, rays in [(188, 64), (708, 64), (2237, 16)]:
            scene = write_scene(f"sphere-{rows}", rows)
            with_ground = write_scene(f"sphere-and-ground-{rows}", rows, "ground")
            subprocess.run([mesh_replay, scene, scene, str(rays), str(turns)], check=True)
            subprocess.run([mesh_replay, scene, with_ground, "16", str(turns)], check=True)
        scene = write_instances("instances-188", 188)
        subprocess.run([mesh_replay, scene, scene, "16", str(turns)], check=True)


def compare_memory(penumbra, embree_memory, bumpy_sphere):
    """The peak of the whole program against 1.3 times that of Embree alone, in bytes per triangle."""
    print("Memory of meshes, whole program, 300x300:\n")
    print("| mesh | triangles | Embree's own peak MB | ours MB | bytes a triangle above 1.3 of Embree's |\n"
          "| --- | --: | --: | --: | --: |", flush=True)
    with tempfile.TemporaryDirectory() as folder:
        for rows, ending in [(2237, "ply"), (2237, "cli")]:
            mesh = os.path.join(folder, "sphere." + ending)
            scene = os.path.join(folder, "scene.cli")
            subprocess.run([bumpy_sphere, str(rows), mesh], check=True)
            with open(scene, "w") as file:
                file.write(f"light 0 5 0  1 1 1\n{'mesh' if ending == 'ply' else 'read'} sphere.{ending}\n")
            figures = subprocess.run([embree_memory, scene], check=True, capture_output=True, text=True).stdout
            triangles, embree = map(int, figures.split())
            ours = render(penumbra, scene)["peak_memory_bytes"]
            print(f"| {ending} | {triangles} | {embree >> 20} | {ours >> 20} | {(ours - 1.3 * embree) / triangles:.0f} |",
                  flush=True)
            os.remove(mesh)
    print()


def compare_threads(penumbra, turns):
    path = os.path.join(ROOT, "scenes/demo.cli")
    ratios = []
    for _ in range(turns):
        seconds = []
        for threads in (1, 2):
            with tempfile.TemporaryDirectory() as folder:
                stats = os.path.join(folder, "stats.json")
                subprocess.run([penumbra, "render", path, "--rays", "32", "-o", os.path.join(folder, "out.png"), "--quiet",
                                "--threads", str(threads), "--stats", stats], check=True, stdout=subprocess.DEVNULL)
                with open(stats) as file:
                    seconds.append(json.load(file)["render_seconds"])
        ratios.append(seconds[0] / seconds[1])
    print(f"Two threads against one, demo.cli, render seconds: {statistics.median(ratios):.2f} "
          f"(best of {turns} turns {max(ratios):.2f})\n")


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--penumbra", default=os.path.join(ROOT, "build/release/penumbra"))
    parser.add_argument("--parse-bench")
    parser.add_argument("--mesh-replay")
    parser.add_argument("--bumpy-sphere")
    parser.add_argument("--embree-memory")
    parser.add_argument("--before", default="", help="a revision of the project to compare with")
    parser.add_argument("--turns", type=int, default=5)
    arguments = parser.parse_args()
    peers = os.environ.get("PENUMBRA_PEERS_DIR", os.path.join(ROOT, "../shared/peers"))
    before = build_revision(arguments.before) if arguments.before else None
    compare_threads(arguments.penumbra, arguments.turns)
    with one_core():
        compare_with_prototype(arguments.penumbra, peers, arguments.turns)
        compare_with_revision(arguments.penumbra, before, arguments.before, min(arguments.turns, 3))
        compare_growth(arguments.penumbra, before, min(arguments.turns, 3))
        rays_per_second(arguments.penumbra, min(arguments.turns, 3))
        compare_instruction_sets(arguments.penumbra, min(arguments.turns, 3))
        compare_sizes(arguments.penumbra, arguments.turns)
        if arguments.mesh_replay and arguments.bumpy_sphere:
            compare_with_embree(arguments.mesh_replay, arguments.bumpy_sphere, 3)
        if arguments.embree_memory and arguments.bumpy_sphere:
            compare_memory(arguments.penumbra, arguments.embree_memory, arguments.bumpy_sphere)
        if arguments.parse_bench:
            print("Reading:\n", flush=True)
            subprocess.run([arguments.parse_bench], check=True)


if __name__ == "__main__":
    main()
