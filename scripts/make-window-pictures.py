#!/usr/bin/env python3
"""Makes the pictures of docs/viewer.md: opens the window on a headless X server, presses keys, and takes screenshots.

usage: make-window-pictures.py PENUMBRA"""

import os
import sys
import tempfile

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
sys.path.insert(0, os.path.join(ROOT, "tests", "window"))
from harness import Display, Window  # noqa: E402

IMAGES = os.path.join(ROOT, "docs", "images")


def main():
    penumbra = os.path.abspath(sys.argv[1])
    display = Display("1280x760")

    def open_window(scene, *options):
        return Window(display, penumbra, scene, *options, folder=folder)

    def take(window, name, height=640):
        # The result of the last event is on the screen two frames later.
        frame = window.state["frame"]
        window.move(9, 9)
        window.move(3, 3)
        window.wait(lambda s: s["frame"] >= frame + 2, "another frame", since=frame)
        window.screenshot(os.path.join(IMAGES, "view-" + name + ".png"), (0, 0, 1100, height))
        window.close()

    size = ("--window", "1100x640")
    with tempfile.TemporaryDirectory() as folder:
        for name in os.listdir(os.path.join(ROOT, "scenes")):
            os.symlink(os.path.join(ROOT, "scenes", name), os.path.join(folder, name))
        window = open_window("s08b.cli", "--rays", "256", *size)
        window.wait_for_rays(256)
        take(window, "window")

        window = open_window("s07b.cli", "--rays", "64", *size)
        window.wait_for_rays(64)
        window.press("h", lambda s: s["help"], "help")
        take(window, "help")

        window = open_window("s05b.cli", "--rays", "16", *size)
        window.wait_for_rays(16)
        window.press("v", lambda s: s["split"] and s["done"] and s["picture_task"] == s["task"], "two halves")
        take(window, "split")

        window = open_window("s07b.cli", "--rays", "64", "--window", "1100x760")
        state = window.wait_for_rays(64)
        x, y, width, height = state["picture"]
        window.click(x + width * 0.5, y + height * 0.55)
        window.wait(lambda s: "inspection" in s, "the inspector")
        take(window, "inspector", 760)

        with open(os.path.join(ROOT, "scenes", "s02b.cli")) as file:
            text = file.read()
        scene = os.path.join(folder, "broken.cli")
        with open(scene, "w") as file:
            file.write(text)
        window = open_window("broken.cli", "--rays", "16", *size)
        window.wait_for_rays(16)
        with open(scene, "w") as file:
            file.write("shpere 1 0 0 -5\n" + text)
        window.wait(lambda s: s["error"], "an error")
        take(window, "error")
    display.close()


if __name__ == "__main__":
    main()
