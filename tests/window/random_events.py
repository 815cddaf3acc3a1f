"""Thousands of random keys, clicks, drags, turns of the wheel, resizes, saved files and broken files: the window must
respond to the end and exit without a sanitizer report.

usage: random_events.py PENUMBRA [--events N] [--seed S]"""

import argparse
import os
import random
import re
import sys
import tempfile
import time

from harness import DEADLINE, Display, Window
from tiny import BROKEN, OTHER, SCENE

KEYS = (["h", "question", "space", "r", "plus", "minus", "s", "c", "f", "v", "e", "shift+e", "p", "Left", "Right", "Up",
         "Down", "n", "shift+n", "o", "Return", "Tab", "BackSpace", "ctrl+a", "x", "0", "period"] +
        list("almdgt") + [str(n) for n in range(1, 10)] + ["shift+%d" % n for n in range(1, 10)])
SUPPRESSIONS = """leak:swrast_dri
leak:libgallium
leak:libLLVM
leak:libGLX
leak:libGL
leak:libX11
leak:libxcb
leak:libSDL2
leak:libdbus
leak:libfontconfig
leak:libtbb
leak:libembree
"""


def file_text(chance):
    """A scene, usually without errors."""
    text = chance.choice([SCENE, OTHER, SCENE.replace("rays_per_pixel 4", "sampler poisson"), BROKEN])
    kind = chance.random()
    if kind < 0.1:
        text = text[:chance.randrange(len(text))]
    elif kind < 0.2:
        place = chance.randrange(len(text))
        text = text[:place] + chr(chance.randrange(1, 255)) + text[place:]
    elif kind < 0.3:
        text = text.replace("120 90", "%d %d" % (chance.randrange(1, 200), chance.randrange(1, 200)))
    elif kind < 0.4:
        text = "read part.cli\n" + text
    return text


def random_event(chance, window, folder):
    """Returns words for xdotool; files are written at once."""
    width, height = window.state["window"]
    x, y = chance.randrange(width), chance.randrange(height)
    kind = chance.random()
    if kind < 0.55:
        return ["key", chance.choice(KEYS)]
    if kind < 0.68:
        return ["mousemove", x, y, "click", chance.choice([1, 1, 1, 2, 3, 4, 4, 5, 5])]
    if kind < 0.82:
        return ["mousemove", x, y, "mousedown", 1, "mousemove", chance.randrange(width), chance.randrange(height),
                "mouseup", 1]
    if kind < 0.86:
        return ["windowsize", window.id, chance.randrange(480, 1300), chance.randrange(320, 800)]
    name = chance.choice(["s01a.cli", "s01a.cli", "s02a.cli", "s01b.cli", "s05b.cli", "part.cli"])
    path = os.path.join(folder, name)
    if chance.random() < 0.05:
        if os.path.exists(path):
            os.remove(path)
    elif chance.random() < 0.5:
        with open(path, "w", errors="surrogateescape") as file:
            file.write(file_text(chance))
    else:
        with open(path + "~", "w") as file:
            file.write(file_text(chance) if name != "part.cli" else "sphere 0.1 0 1 -4\n")
        os.replace(path + "~", path)
    return []


def only_drivers_leak(output):
    """Whether all reported leaks are those of libraries already unloaded, as OpenGL drivers are. These no longer
    have a name that could be suppressed, but the program itself always has one. What the sanitizer's own functions
    allocated was for these libraries."""
    if output.count("ERROR:") != 1 or "ERROR: LeakSanitizer" not in output or "runtime error" in output:
        return False
    leaks = re.split(r"(?m)^(?:Direct|Indirect) leak", output)[1:]
    callers = [line for leak in leaks for line in re.findall(r"(?m)^ +#[1-9].*", leak)]
    return bool(callers) and all("<unknown module>" in caller or "/libasan.so" in caller for caller in callers)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("penumbra")
    parser.add_argument("--events", type=int, default=1000)
    parser.add_argument("--seed", type=int, default=1)
    options = parser.parse_args()
    chance = random.Random(options.seed)
    display = Display()
    with tempfile.TemporaryDirectory(prefix="penumbra-events-") as folder:
        suppressions = os.path.join(folder, "suppressions")
        with open(suppressions, "w") as file:
            file.write(SUPPRESSIONS)
        # Mesa, X and TBB are not compiled for ThreadSanitizer, which then reports their locks as races.
        display.environment.update(
            ASAN_OPTIONS="halt_on_error=1:exitcode=99", UBSAN_OPTIONS="halt_on_error=1:print_stacktrace=1",
            LSAN_OPTIONS="print_suppressions=0:suppressions=" + suppressions,
            TSAN_OPTIONS="halt_on_error=1:exitcode=99:ignore_noninstrumented_modules=1")
        for name in ("s01a.cli", "s02a.cli", "s01b.cli"):
            with open(os.path.join(folder, name), "w") as file:
                file.write(SCENE)
        window = Window(display, os.path.abspath(options.penumbra), ".", "--window", "1000x700", folder=folder)
        done, start = 0, time.monotonic()
        while done < options.events:
            batch = []
            count = min(20, options.events - done)
            for _ in range(count):
                batch += random_event(chance, window, folder)
            before = window.state
            if batch:
                window.mouse("mousemove", 5, 5, *batch, "mouseup", 1, "mousemove", 7, 7 + done % 2)
                window.wait(lambda s: s["events"] > before["events"], "the window to answer", since=before["frame"])
            done += count
            for picture in os.listdir(folder):
                if picture.endswith(".png"):
                    os.remove(os.path.join(folder, picture))
            if done % 1000 == 0:
                print("%d events, %.0f s" % (done, time.monotonic() - start), flush=True)
        window.focus()
        window.key(*5 * ["Escape"])  # the first ones close what is open
        code = window.process.wait(DEADLINE)
        output = window.output()
        window.close()
    display.close()
    print("%d events, exit code %d" % (done, code))
    if (code != 0 or "Sanitizer" in output or "runtime error" in output) and not only_drivers_leak(output):
        print(output)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
