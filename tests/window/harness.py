"""Drives the window as a user does: an X server without a screen (Xvfb), real key and mouse events (xdotool), pixels
read back from the server. No test relies on a sleep: the window reports every frame it presents, and a test waits for a
frame that is as it should be, with a deadline far beyond what a loaded machine needs."""

import ctypes
import json
import os
import shutil
import signal
import struct
import subprocess
import sys
import tempfile
import threading
import time
import traceback
import zlib

DEADLINE = float(os.environ.get("PENUMBRA_TEST_DEADLINE", "120"))


class Display:
    """A separate X server."""

    def __init__(self, size="1440x900"):
        read_end, write_end = os.pipe()
        self.process = subprocess.Popen(
            ["Xvfb", "-displayfd", str(write_end), "-screen", "0", size + "x24", "-nolisten", "tcp", "-noreset"],
            pass_fds=[write_end], stderr=subprocess.DEVNULL)
        os.close(write_end)
        with os.fdopen(read_end) as pipe:
            self.name = ":" + pipe.readline().strip()
        if self.name == ":":
            raise RuntimeError("Xvfb does not start")
        self.environment = dict(os.environ, DISPLAY=self.name, LIBGL_ALWAYS_SOFTWARE="1", SDL_VIDEODRIVER="x11")
        self.environment.pop("WAYLAND_DISPLAY", None)

    def run(self, *command, **options):
        return subprocess.run(command, env=self.environment, check=True, capture_output=True, text=True,
                              timeout=DEADLINE, **options).stdout

    def close(self):
        self.process.terminate()
        self.process.wait()


class Screen:
    """Reads pixels of the whole screen through libX11."""

    def __init__(self, display_name):
        x11 = ctypes.CDLL("libX11.so.6")
        x11.XOpenDisplay.restype = ctypes.c_void_p
        x11.XDefaultRootWindow.argtypes = [ctypes.c_void_p]
        x11.XDefaultRootWindow.restype = ctypes.c_ulong
        x11.XGetImage.argtypes = [ctypes.c_void_p, ctypes.c_ulong, ctypes.c_int, ctypes.c_int, ctypes.c_uint,
                                  ctypes.c_uint, ctypes.c_ulong, ctypes.c_int]
        x11.XGetImage.restype = ctypes.c_void_p
        self.x11 = x11
        self.display = x11.XOpenDisplay(display_name.encode())

    def rgb(self, x, y, width, height):
        """Rows of bytes r, g, b."""
        x11 = self.x11
        image = x11.XGetImage(self.display, x11.XDefaultRootWindow(self.display), x, y, width, height, 0xFFFFFFFF, 2)
        if not image:
            raise RuntimeError("XGetImage fails")
        # struct XImage: width, height, xoffset, format; data; byte_order, unit, bit_order, pad, depth, bytes_per_line
        data = ctypes.cast(image + 16, ctypes.POINTER(ctypes.c_void_p))[0]
        line = ctypes.cast(image + 44, ctypes.POINTER(ctypes.c_int))[0]
        rows = []
        for row in range(height):
            bgrx = ctypes.string_at(data + row * line, 4 * width)
            rgb = bytearray(3 * width)
            rgb[0::3], rgb[1::3], rgb[2::3] = bgrx[2::4], bgrx[1::4], bgrx[0::4]
            rows.append(bytes(rgb))
        return rows


def write_png(path, rows):
    """Rows of bytes r, g, b as a PNG file."""
    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
    header = struct.pack(">IIBBBBB", len(rows[0]) // 3, len(rows), 8, 2, 0, 0, 0)
    body = zlib.compress(b"".join(b"\0" + row for row in rows), 1)
    with open(path, "wb") as file:
        file.write(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", body) + chunk(b"IEND", b""))


def metadata_of(png):
    """The metadata of a PNG file, in order."""
    with open(png, "rb") as file:
        data = file.read()
    texts, at = {}, 8
    while at < len(data):
        size, kind = struct.unpack(">I4s", data[at:at + 8])
        body = data[at + 8:at + 8 + size]
        at += 12 + size
        if kind == b"tEXt":
            key, value = body.split(b"\0", 1)
            texts[key.decode()] = value.decode("latin-1")
        elif kind == b"iTXt":
            key, rest = body.split(b"\0", 1)
            texts[key.decode()] = rest[2:].split(b"\0", 2)[2].decode()
    return {key.removeprefix("penumbra:"): value for key, value in texts.items()}


class Window:
    """`penumbra view` on a display."""

    def __init__(self, display, penumbra, *arguments, folder):
        self.display, self.folder = display, folder
        self.report = os.path.join(folder, "report-%d.json" % time.monotonic_ns())
        self.log_path = self.report + ".log"
        self.log = open(self.log_path, "wb")
        open(self.report, "w").close()
        self.reader = open(self.report)
        self.partial = ""
        self.frames = []
        self.process = subprocess.Popen([penumbra, "view", *arguments, "--report", self.report], cwd=folder,
                                        env=display.environment, stdout=self.log, stderr=self.log)
        self.wait(lambda s: True, "the window to present a frame")
        self.id = display.run("xdotool", "search", "--sync", "--onlyvisible", "--pid",
                              str(self.process.pid)).split()[-1]
        self.focus()
        self.screen = Screen(display.name)

    def focus(self):
        self.display.run("xdotool", "windowmove", "--sync", self.id, "0", "0", "windowfocus", self.id)

    def read_frames(self):
        """Frames reported since the last call."""
        text = self.partial + self.reader.read()
        *lines, self.partial = text.split("\n")
        new = [json.loads(line) for line in lines if line]
        self.frames += new
        return new

    def output(self):
        self.log.flush()
        with open(self.log_path) as file:
            return file.read()

    def wait(self, condition, what, since=None):
        """Returns the first frame after `since` (a frame's number) for which the condition holds."""
        end = time.monotonic() + DEADLINE
        index = 0 if since is None else len(self.frames)
        for i, frame in enumerate(self.frames):
            if since is not None and frame["frame"] > since:
                index = i
                break
        if since is None:
            index = max(len(self.frames) - 1, 0)
        while True:
            self.read_frames()
            while index < len(self.frames):
                if condition(self.frames[index]):
                    return self.frames[index]
                index += 1
            if self.process.poll() is not None:
                raise AssertionError("the window ended with %s while waiting for %s\n%s" %
                                     (self.process.returncode, what, self.output()))
            if time.monotonic() > end:
                last = self.frames[-1] if self.frames else None
                raise AssertionError("timed out waiting for %s; last frame: %s" % (what, json.dumps(last, indent=1)))
            time.sleep(0.005)

    @property
    def state(self):
        self.read_frames()
        return self.frames[-1]

    def key(self, *names):
        self.display.run("xdotool", "key", *names)

    def press(self, name, condition, what):
        """Presses a key and waits for a later frame for which the condition holds."""
        before = self.state["frame"]
        self.key(name)
        return self.wait(condition, what + " after " + name, since=before)

    def mouse(self, *words):
        self.display.run("xdotool", *[str(word) for word in words])

    def move(self, x, y):
        self.mouse("mousemove", int(x), int(y))

    def click(self, x, y):
        self.mouse("mousemove", int(x), int(y), "click", 1)

    def click_knob(self, label, condition):
        """Clicks a knob of the panel, by what stands on it."""
        before = self.state["frame"]
        x, y = self.state["knobs"][label]
        self.mouse("mousemove", x, y, "mousedown", 1)
        self.wait(lambda s: s["frame"] > before + 2, "frames after the button", since=before)
        self.mouse("mouseup", 1)
        return self.wait(condition, "what %s does" % label, since=before)

    def wait_for_rays(self, rays, what="the picture"):
        return self.wait(lambda s: s["picture_task"] == s["task"] and s["rays"] == rays and s["done"],
                         "%s with %d rays per pixel" % (what, rays))

    def screenshot(self, path, area=None):
        """The window, or a part of it, as a PNG."""
        x, y, width, height = area or (0, 0, *self.state["window"])
        write_png(path, self.screen.rgb(x, y, width, height))

    def picture_shot(self, path):
        """The picture alone, every zoom-th pixel of the screen: one for each of its own."""
        state = self.state
        x, y, width, height = state["picture"]
        zoom = int(state["zoom"])
        assert zoom == state["zoom"] and zoom >= 1, "the picture is shrunk: %s" % state["zoom"]
        rows = self.screen.rgb(x, y, width, height)
        small = []
        for row in rows[::zoom]:
            columns = bytearray(3 * (width // zoom))
            for c in range(3):
                columns[c::3] = row[c::3 * zoom]
            small.append(bytes(columns))
        write_png(path, small)

    def close(self):
        if self.process.poll() is None:
            self.process.send_signal(signal.SIGTERM)
            try:
                self.process.wait(DEADLINE)
            except subprocess.TimeoutExpired:
                self.process.kill()
                self.process.wait()
        self.log.close()
        self.reader.close()


class Tests:
    """Runs the methods of a subclass that start with `test_`, each in its own folder and with the windows it opens.
    The program and the scenes come from the command line."""

    def __init__(self, penumbra, scenes):
        self.penumbra, self.scenes = penumbra, scenes
        self.windows = []

    def open(self, *arguments):
        window = Window(self.display, self.penumbra, *arguments, folder=self.folder)
        self.windows.append(window)
        return window

    def render(self, scene, name, *options):
        path = os.path.join(self.folder, name)
        subprocess.run([self.penumbra, "render", scene, "-o", path, "--quiet", *options], check=True, timeout=DEADLINE)
        return path

    def assert_same_picture(self, a, b, *options):
        result = subprocess.run([self.penumbra, "compare", a, b, *(options or ["--fail", "0"])], capture_output=True,
                                text=True, timeout=DEADLINE)
        assert result.returncode == 0, "%s and %s differ:\n%s" % (a, b, result.stdout + result.stderr)

    def assert_other_picture(self, a, b):
        result = subprocess.run([self.penumbra, "compare", a, b], capture_output=True, text=True, timeout=DEADLINE)
        assert result.returncode == 2, "%s and %s should differ:\n%s" % (a, b, result.stdout + result.stderr)

    def path(self, name):
        return os.path.join(self.folder, name)

    def put(self, name, text):
        """Saves a file as editors do: under another name, then renamed."""
        path = self.path(name)
        with open(path + "~", "w") as file:
            file.write(text)
        os.replace(path + "~", path)
        return path

    @classmethod
    def main(cls):
        for program in ("Xvfb", "xdotool"):
            if not shutil.which(program):
                print("%s is missing: scripts/install-dependencies.sh test installs it" % program)
                return 1
        wanted = sys.argv[3:]
        failed = []
        for name in sorted(n for n in dir(cls) if n.startswith("test_") and (not wanted or n in wanted)):
            tests = cls(os.path.abspath(sys.argv[1]), os.path.abspath(sys.argv[2]))
            tests.display = Display()
            start = time.monotonic()
            with tempfile.TemporaryDirectory(prefix="penumbra-window-") as folder:
                tests.folder = folder
                try:
                    getattr(tests, name)()
                    print("ok      %s (%.1f s)" % (name, time.monotonic() - start), flush=True)
                except Exception:
                    failed.append(name)
                    print("FAILED  %s" % name)
                    traceback.print_exc(file=sys.stdout)
                    for window in tests.windows:
                        print(window.output(), flush=True)
                finally:
                    for window in tests.windows:
                        window.close()
            tests.display.close()
        return 1 if failed else 0
