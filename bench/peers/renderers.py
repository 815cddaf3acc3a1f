"""How each renderer is called and how it reports its time. Commands run in the work folder, which holds the mesh of
scene E."""

import json
import math
import os
import re
import shutil
import subprocess

HERE = os.path.dirname(os.path.abspath(__file__))
SIZE = 300


def first_match(pattern, text):
    match = re.search(pattern, text, re.DOTALL)
    if not match:
        raise RuntimeError(f"no `{pattern}` in what the renderer printed:\n{text[-2000:]}")
    return match


def package_version(package):
    return subprocess.run(["dpkg-query", "-W", "-f", "${Version}", package], check=True, capture_output=True,
                          text=True).stdout


class Penumbra:
    """A value is the number of rays per pixel; adaptive, the error that --noise asks for."""

    name = "Penumbra"
    scenes = "ABCDE"
    picture_suffix = ".png"

    def __init__(self, program, work):
        self.program = os.path.abspath(program)
        self.work = work
        for scene in self.scenes:  # next to the mesh
            shutil.copy(os.path.join(HERE, scene + ".cli"), work)

    def converged(self, _):
        """Rays per pixel and seeds of two independent pictures."""
        return [(2048, 101), (2048, 102)]

    def version(self):  # such as "penumbra 0.1.0"
        return subprocess.run([self.program, "--version"], check=True, capture_output=True, text=True).stdout.strip()

    def command(self, scene, value, seed, picture, adaptive=False, options=()):
        return [self.program, "render", scene + ".cli", "--noise" if adaptive else "--rays", str(value), "--seed",
                str(seed), "-o", picture, "--bits", "16", "--threads", "1", "--quiet", "--stats", "stats.json",
                *options]

    def seconds(self, _):
        with open(os.path.join(self.work, "stats.json")) as file:
            stats = json.load(file)
        return stats["render_seconds"], stats["render_cpu_seconds"]


class PovRay:
    """A value is the number of rays per pixel, on a grid; in B, of points on the lens. Adaptive, it is the number where
    the first rays of neighbours differ by 0.02 or more; in B, the most that are used to reach a variance of 1e-5."""

    name = "POV-Ray"
    scenes = "ABCE"
    picture_suffix = ".png"

    def converged(self, scene):
        # It has no seed, but jitters another grid differently.
        return [(1024, 1), (900, 2)] if scene == "B" else [(324, 0), (441, 0)]

    def version(self):
        return "POV-Ray " + package_version("povray")

    def command(self, scene, rays, seed, picture, adaptive=False):
        if scene == "B":
            scale = max(1, seed)  # an enlarged picture has other lens samples
            variance, confidence = (1e-5, 0.9) if adaptive else (0, 0.9999)
            samples = ["-A", f"Declare=LensSamples={rays // scale**2}", f"Declare=LensVariance={variance:f}",
                       f"Declare=LensConfidence={confidence}"]
        else:
            scale, grid = self.grid(rays)
            samples = ["+AM1", "+A0.02" if adaptive else "+A0.0", f"+R{grid}"]
        return ["povray", f"+I{HERE}/scene.pov", "+L.", f"+O{picture}", "+FN16", "File_Gamma=1", "-D", "-V", "+WT1",
                f"+W{SIZE * scale}", f"+H{SIZE * scale}", f"Declare=Scene={'ABCDE'.index(scene) + 1}", *samples]

    @staticmethod
    def grid(rays):
        """A pixel has at most 9 x 9 rays; more take a larger picture: its scale, and the rows of rays in a pixel."""
        rows = math.isqrt(rays)
        if rows**2 != rays:
            raise ValueError(f"{rays} is not a square")
        scale = next(s for s in range(1, rows + 1) if rows % s == 0 and rows // s <= 9)
        return scale, rows // scale

    def seconds(self, output):
        match = first_match(r"Trace Time:[^(]*\(([\d.]+) seconds\)[^(]*\(s\) with ([\d.]+) CPU-seconds", output)
        return float(match[1]), float(match[2])


class Cycles:
    """A value is the number of rays per pixel; adaptive, Blender's noise threshold."""

    name = "Cycles"
    scenes = "ABCDE"
    picture_suffix = ".exr"

    def converged(self, _):
        return [(512, 101), (512, 102)]

    def version(self):
        return "Cycles of Blender " + package_version("blender")

    def command(self, scene, value, seed, picture, adaptive=False):
        rays, noise = (4096, value) if adaptive else (value, 0)
        return ["blender", "-b", "--factory-startup", "-P", f"{HERE}/cycles_scene.py", "--", scene, str(rays),
                str(seed), str(noise), picture]

    def seconds(self, output):
        match = first_match(r"RENDER_SECONDS ([\d.]+) ([\d.]+)", output)
        return float(match[1]), float(match[2])
