"""Resizing, zoom, pan, the camera and the knobs of the panel."""

import re
import sys

from harness import Tests
from tiny import SCENE


def shown(state):
    return state["picture_task"] == state["task"] and state["done"]


class MouseTests(Tests):
    def open_tiny(self):
        self.put("tiny.cli", SCENE)
        window = self.open("tiny.cli", "--rays", "4", "--window", "1280x880")
        window.wait(shown, "the picture")
        return window

    def check_seen(self, window, *options):
        window.picture_shot(self.path("seen.png"))
        self.assert_same_picture(self.path("seen.png"),
                                 self.render(self.path("tiny.cli"), "it.png", "--rays", "4", *options))

    def test_resize(self):
        window = self.open_tiny()
        for width, height in ((700, 500), (1300, 800), (480, 320)):
            before = window.state["frame"]
            window.mouse("windowsize", window.id, width, height)
            state = window.wait(lambda s: s["window"] == [width, height], "a window of that size", since=before)
            x, y, w, h = state["picture"]
            assert x >= 0 and y >= 0 and x + w <= width and y + h <= height, state
            window.wait(lambda s: s["frame"] > state["frame"] + 1, "frames after it")
            self.check_seen(window)

    def test_scale(self):
        """Everything but the picture has the size that --scale asks for."""
        self.put("tiny.cli", SCENE)
        places = []
        for scale in ("1", "2"):
            window = self.open("tiny.cli", "--rays", "4", "--window", "1280x880", "--scale", scale)
            state = window.wait(shown, "the picture")
            x, y, width, height = state["picture"]
            assert x + width < state["knobs"]["lens radius"][0] and y + height < 880, state["picture"]
            places.append(state["knobs"]["lens radius"])
            self.check_seen(window)
            window.close()
        (x1, y1), (x2, y2) = places
        assert abs((1280 - x2) - 2 * (1280 - x1)) < 20 and abs(y2 - 2 * y1) < 8, places

    def test_zoom(self):
        window = self.open_tiny()
        x, y, width, height = window.state["picture"]
        zoom = window.state["zoom"]
        corner = (x + 1, y + 1)
        window.move(*corner)
        before = window.state["frame"]
        window.mouse("click", 5)
        state = window.wait(lambda s: s["zoom"] < zoom, "a smaller picture", since=before)
        # What is under the cursor stays there.
        assert abs(state["picture"][0] - x) <= 2 and abs(state["picture"][1] - y) <= 2, state["picture"]
        window.wait(lambda s: s["frame"] > state["frame"] + 1, "frames after it")
        self.check_seen(window)
        window.mouse("click", 4)
        window.wait(lambda s: s["zoom"] == zoom, "the old zoom", since=state["frame"])

    def test_pan(self):
        window = self.open_tiny()
        x, y, width, height = window.state["picture"]
        window.mouse("mousemove", x + 50, y + 50, "mousedown", 1)
        window.mouse("mousemove", x + 80, y + 70)
        window.mouse("mouseup", 1)
        state = window.wait(lambda s: s["picture"][:2] == [x + 30, y + 20], "the picture elsewhere")
        window.wait(lambda s: s["frame"] > state["frame"] + 1, "frames after it")
        self.check_seen(window)

    def test_camera(self):
        """After O, the mouse turns, moves and brings nearer the camera; the copied lines make the same picture."""
        window = self.open_tiny()
        x, y, width, height = window.state["picture"]
        middle = (x + width // 2, y + height // 2)
        window.press("o", lambda s: s["camera"], "the camera")
        ways = (("mousedown", 1, "mousemove", middle[0] + 50, middle[1] + 10, "mouseup", 1),
                ("mousedown", 3, "mousemove", middle[0] - 30, middle[1] + 20, "mouseup", 3),
                ("keydown", "shift", "mousedown", 1, "mousemove", middle[0] + 30, middle[1], "mouseup", 1, "keyup",
                 "shift"),
                ("click", 4))
        for number, way in enumerate(ways):
            eye = window.state["eye"]
            before = window.state["frame"]
            window.mouse("mousemove", *middle, *way)
            window.wait(lambda s: s["eye"] != eye and shown(s), "another place of the eye", since=before)
            self.window_rests(window)
            state = window.state
            assert state["picture"] == [x, y, width, height], "the picture itself stays"
            lines = state["changed"]
            assert lines.startswith("eye ") and "\nuvw " in lines, lines
            uvw = lines.splitlines()[1]
            assert number == 0 or uvw == turned, "only the first drag should turn: " + lines
            turned = uvw
            window.picture_shot(self.path("seen.png"))
            self.put("changed.cli", SCENE + lines)
            self.assert_same_picture(self.path("seen.png"), self.render(self.path("changed.cli"), "it.png"))
        window.press("o", lambda s: not s["camera"], "the mouse has the picture again")
        window.mouse("mousemove", *middle, "mousedown", 1, "mousemove", middle[0] + 30, middle[1] + 20, "mouseup", 1)
        window.wait(lambda s: s["picture"][:2] == [x + 30, y + 20], "the picture elsewhere")

    def drag_knob(self, window, label, changed, distance=40):
        before = window.state["frame"]
        x, y = window.state["knobs"][label]
        window.mouse("mousemove", x, y, "mousedown", 1)
        # The window must see the button go down before the mouse moves.
        window.wait(lambda s: s["frame"] > before + 2, "frames after the button", since=before)
        window.mouse("mousemove", x + distance, y)
        window.wait(changed, label + " to change", since=before)
        window.mouse("mouseup", 1)
        state = window.wait(lambda s: changed(s) and shown(s), "the picture", since=before)
        self.window_rests(window)
        return window.state

    def window_rests(self, window):
        """Waits for the picture after the last event."""
        while True:
            state = window.state
            window.wait(shown, "the picture")
            if window.state["task"] == state["task"]:
                return

    def test_knobs_of_the_scene(self):
        window = self.open_tiny()
        knobs = (("lens radius", lambda s: s["lens"][0] != 0.15, "lens "),
                 ("focus distance", lambda s: s["lens"][1] != 5, "lens "),
                 ("shutter opens", lambda s: s["shutter"][0] != 0, "shutter "),
                 ("shutter closes", lambda s: s["shutter"][1] != 1, "shutter "),
                 ("line 6, disk_light: radius", lambda s: "disk_light" in s["changed"], "disk_light 2 5 -1 "),
                 ("line 7, glossy: gloss", lambda s: "glossy" in s["changed"], "glossy 0.3 0.1 0.1 0.4 0.4 0.4 20 0.4 "),
                 ("line 10, translucent: gloss", lambda s: "translucent" in s["changed"], "translucent 0.1 0.3 0.1 "),
                 ("line 10, translucent: blur", lambda s: "translucent" in s["changed"], "translucent 0.1 0.3 0.1 "),
                 ("max depth", lambda s: s["max_depth"] != 8, "max_depth "))
        for label, changed, line in knobs:
            state = self.drag_knob(window, label, changed, distance=20)
            assert line in state["changed"], state["changed"]
            for number in re.findall(r"[\d.]+", state["changed"]):
                assert len(number.replace(".", "").strip("0")) <= 4, "a number nobody writes: " + state["changed"]
            window.picture_shot(self.path("seen.png"))
            self.put("changed.cli", self.with_lines(state["changed"]))
            self.assert_same_picture(self.path("seen.png"), self.render(self.path("changed.cli"), "it.png"))
            window.click_knob("As in the file", lambda s: (s["changed"] == "rays_per_pixel 4\n" or not s["changed"]) and shown(s))

    def with_lines(self, lines):
        """The scene with these lines in place of its own."""
        scene = SCENE
        for line in lines.splitlines(keepends=True):
            command = line.split()[0]
            if command in ("glossy", "translucent", "disk_light"):
                start = scene.index(command)
                scene = scene[:start] + line + scene[scene.index("\n", start) + 1:]
            else:
                scene = scene + line
        return scene

    def test_effects_and_sampler(self):
        window = self.open_tiny()
        window.click_knob("lens 0", lambda s: s["sides"][0]["without"] == "lens" and shown(s))
        self.check_seen(window, "--without", "lens")
        window.click_knob("lens 0", lambda s: s["sides"][0]["without"] == "" and shown(s))
        window.click_knob("sampler 0", shown)

    def test_seed(self):
        window = self.open_tiny()
        x, y = window.state["knobs"]["seed"]
        before = window.state["frame"]
        window.mouse("mousemove", x, y, "mousedown", 1)
        window.wait(lambda s: s["typing"], "the field to take the keys", since=before)
        window.mouse("mouseup", 1)
        window.key("ctrl+a", "7", "Return")
        state = window.wait(lambda s: s["seed"] == 7 and shown(s) and not s["typing"], "the seed")
        assert "seed 7\n" in state["changed"], state["changed"]
        self.check_seen(window, "--seed", "7")

    def test_typed_numbers_are_no_keys(self):
        """Keys typed into a field of the panel do not load scenes."""
        window = self.open_tiny()
        x, y = window.state["knobs"]["rays per pixel"]
        before = window.state["frame"]
        window.mouse("mousemove", x, y, "mousedown", 1)
        window.wait(lambda s: s["typing"], "the field to take the keys", since=before)
        window.mouse("mouseup", 1)
        window.key("ctrl+a", "1", "6", "Return")
        state = window.wait(lambda s: s["limit"] == 16 and shown(s), "16 rays")
        assert state["scene"] == "tiny.cli" and not state["error"], state


if __name__ == "__main__":
    sys.exit(MouseTests.main())
