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
    display = Display("1280x900")

    def open_window(scene, *options):
        return Window(display, penumbra, scene, *options, folder=folder)

    def take(window, name):
        # The result of the last event is on the screen two frames later.
        frame = window.state["frame"]
        window.move(9, 9)
        window.move(3, 3)
        window.wait(lambda s: s["frame"] >= frame + 2, "another frame", since=frame)
        window.screenshot(os.path.join(IMAGES, "view-" + name + ".png"), (0, 0, 1280, 760))
        window.close()

    with tempfile.TemporaryDirectory() as folder:
        for name in os.listdir(os.path.join(ROOT, "scenes")):
            os.symlink(os.path.join(ROOT, "scenes", name), os.path.join(folder, name))
        window = open_window("s08b.cli")
        window.wait_for_rays(100)
        take(window, "window")

        window = open_window("s07b.cli", "--rays", "64")
        window.wait_for_rays(64)
        window.press("h", lambda s: s["help"], "help")
        take(window, "help")

        window = open_window("s05b.cli", "--rays", "16")
        window.wait_for_rays(16)
        window.press("v", lambda s: s["split"] and s["done"] and s["picture_task"] == s["task"], "two halves")
        take(window, "split")

        window = open_window("s07b.cli", "--rays", "64")
        state = window.wait_for_rays(64)
        x, y, width, height = state["picture"]
        window.click(x + width * 0.5, y + height * 0.35)
        window.wait(lambda s: "inspection" in s, "the inspector")
        take(window, "inspector")

        window = open_window("s08a.cli")
        x, y, width, height = window.wait_for_rays(36)["picture"]
        window.press("o", lambda s: s["camera"], "the camera")
        middle = (x + width // 2, y + height // 2)
        window.mouse("mousemove", *middle, "mousedown", 1, "mousemove", middle[0] + 80, middle[1] + 30, "mouseup", 1)
        window.wait(lambda s: "uvw" in s["changed"] and s["done"] and s["picture_task"] == s["task"], "another view")
        take(window, "camera")

        with open(os.path.join(ROOT, "scenes", "s02b.cli")) as file:
            text = file.read()
        scene = os.path.join(folder, "broken.cli")
        with open(scene, "w") as file:
            file.write(text)
        window = open_window("broken.cli", "--rays", "16")
        window.wait_for_rays(16)
        with open(scene, "w") as file:
            file.write("shpere 1 0 0 -5\n" + text)
        window.wait(lambda s: s["error"], "an error")
        take(window, "error")
    display.close()


if __name__ == "__main__":
    main()
