#!/usr/bin/env python3
"""Measures how fast the window responds: from pressing a key or saving a file to the first frame of the new picture on
the screen (1 ray per pixel), from any key to a frame that shows its effect, and from Escape to the end of the program,
all while the window renders. Needs Xvfb; OpenGL is emulated on the same processors that render, so a machine with a
graphics card is faster."""

import argparse
import ctypes
import os
import shutil
import statistics
import sys
import tempfile
import time

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
sys.path.insert(0, os.path.join(ROOT, "tests", "window"))
from harness import DEADLINE, Display, Window  # noqa: E402


class Keys:
    """Presses keys through libXtst, so that no program has to start between the clock and the key."""

    def __init__(self, display_name):
        self.x11 = ctypes.CDLL("libX11.so.6")
        self.test = ctypes.CDLL("libXtst.so.6")
        self.x11.XOpenDisplay.restype = ctypes.c_void_p
        self.x11.XStringToKeysym.restype = ctypes.c_ulong
        self.x11.XKeysymToKeycode.argtypes = [ctypes.c_void_p, ctypes.c_ulong]
        self.x11.XFlush.argtypes = [ctypes.c_void_p]
        self.test.XTestFakeKeyEvent.argtypes = [ctypes.c_void_p, ctypes.c_uint, ctypes.c_int, ctypes.c_ulong]
        self.display = self.x11.XOpenDisplay(display_name.encode())

    def press(self, name):
        """Returns the time, on the clock of the window's report."""
        code = self.x11.XKeysymToKeycode(self.display, self.x11.XStringToKeysym(name.encode()))
        start = time.monotonic()
        self.test.XTestFakeKeyEvent(self.display, code, 1, 0)
        self.test.XTestFakeKeyEvent(self.display, code, 0, 0)
        self.x11.XFlush(self.display)
        return start


def shown(state):
    return state["picture_task"] == state["task"]


def measure(display, penumbra, size, scenes, turns):
    rows = {"key to first frame": [], "saved file to first frame": [], "any key to its frame": [],
            "Escape to the end": []}
    with tempfile.TemporaryDirectory() as folder:
        shutil.copytree(os.path.join(ROOT, "scenes"), folder, dirs_exist_ok=True)
        texts = {}
        for number in scenes:
            with open(os.path.join(folder, "s0%da.cli" % number)) as file:
                texts[number] = file.read()
        window = Window(display, penumbra, ".", "--rays", "65536", "--size", size, "--window", "1600x780", folder=folder)
        keys = Keys(display.name)
        for turn in range(turns):
            for number in texts:
                before = window.wait(lambda s: shown(s) and s["rays"] >= 2, "rays", since=window.state["frame"] - 1)
                start = keys.press(str(number))
                state = window.wait(lambda s: shown(s) and s["task"] > before["task"], "a picture",
                                    since=before["frame"])
                rows["key to first frame"].append(state["time"] - start)

                before = window.wait(lambda s: s["rays"] >= 2, "rays", since=state["frame"])
                path = os.path.join(folder, "s0%da.cli" % number)
                with open(path + "~", "w") as file:
                    file.write(texts[number] + "# %d\n" % turn)
                start = time.monotonic()
                os.replace(path + "~", path)
                state = window.wait(lambda s: shown(s) and s["task"] > before["task"], "a picture",
                                    since=before["frame"])
                rows["saved file to first frame"].append(state["time"] - start)

                before = window.wait(lambda s: s["rays"] >= 2, "rays", since=state["frame"])
                start = keys.press("h")
                state = window.wait(lambda s: s["help"] != before["help"], "help", since=before["frame"])
                rows["any key to its frame"].append(state["time"] - start)
        window.close()
        for _ in range(turns):
            window = Window(display, penumbra, ".", "--rays", "65536", "--size", size, folder=folder)
            window.wait(lambda s: s["rays"] >= 2, "rays")
            start = Keys(display.name).press("Escape")
            window.process.wait(DEADLINE)
            rows["Escape to the end"].append(time.monotonic() - start)
            window.close()
    return rows


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--penumbra", default=os.path.join(ROOT, "build", "release", "penumbra"))
    parser.add_argument("--turns", type=int, default=5)
    options = parser.parse_args()
    scenes = (1, 5, 7)
    display = Display("1920x1080")
    print("| picture | what | median ms | worst ms |")
    print("| --- | --- | --: | --: |")
    for size in ("300x300", "1280x720"):
        for what, seconds in measure(display, os.path.abspath(options.penumbra), size, scenes, options.turns).items():
            print("| %s | %s | %.0f | %.0f |" % (size, what, 1000 * statistics.median(seconds), 1000 * max(seconds)),
                  flush=True)
    display.close()


if __name__ == "__main__":
    main()
