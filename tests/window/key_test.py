"""Every key of the help, pressed for real."""

import os
import re
import subprocess
import sys
import time

from harness import DEADLINE, Tests, metadata_of
from tiny import SCENE


def current(state):
    return state["picture_task"] == state["task"]


class KeyTests(Tests):
    def open_tiny(self, *options):
        return self.open(self.put("tiny.cli", SCENE), *options)

    def options_of(self, png):
        """The options that the metadata of a picture names."""
        words = []
        for key, value in metadata_of(png).items():
            if key in ("scene", "version"):
                continue
            words += ["--" + key] if value == "yes" else ["--" + key, value]
        return words

    def check_repeats(self, png):
        """`penumbra render` makes the same file from the file's own metadata."""
        again = self.render(self.path(metadata_of(png)["scene"]), "again.png", *self.options_of(png))
        with open(png, "rb") as a, open(again, "rb") as b:
            assert a.read() == b.read(), "%s is not repeated by %s" % (png, self.options_of(png))

    def save(self, window):
        state = window.press("s", lambda s: s["message"].startswith("saved"), "a message")
        names = [word for word in state["message"].split() if word.endswith(".png")]
        return [self.path(name) for name in names]

    def test_digits_load_scenes(self):
        for name in ("s01a", "s01b", "s02a", "s09b"):
            self.put(name + ".cli", SCENE)
        window = self.open(".", "--rays", "1")
        assert window.state["scene"].endswith("s01a.cli")
        for key, scene in (("2", "s02a.cli"), ("shift+1", "s01b.cli"), ("shift+9", "s09b.cli"), ("1", "s01a.cli")):
            state = window.press(key, lambda s: s["scene"].endswith(scene) and current(s), scene)
            assert state["error"] == "", state
        state = window.press("5", lambda s: s["error"], "an error")
        assert "s05a.cli" in state["error"], state["error"]
        window.press("1", lambda s: s["scene"].endswith("s01a.cli") and not s["error"] and current(s), "s01a.cli")

    def test_digits_on_another_layout(self):
        """On a French keyboard, digits are typed with Shift; the window goes by the position of the key."""
        for name in ("s01a", "s02a", "s02b"):
            self.put(name + ".cli", SCENE)
        window = self.open(".", "--rays", "1")
        self.display.run("setxkbmap", "fr")
        window.press("eacute", lambda s: s["scene"].endswith("s02a.cli") and current(s), "s02a.cli")
        window.press("2", lambda s: s["scene"].endswith("s02b.cli") and current(s), "s02b.cli")

    def test_help(self):
        window = self.open_tiny("--rays", "4")
        window.wait_for_rays(4)
        window.screenshot(self.path("plain.png"))
        state = window.press("h", lambda s: s["help"], "help")
        window.wait(lambda s: s["frame"] > state["frame"] + 1, "frames after it")
        window.screenshot(self.path("help.png"))
        self.assert_other_picture(self.path("plain.png"), self.path("help.png"))
        window.press("question", lambda s: not s["help"], "no help")
        window.press("question", lambda s: s["help"], "help")
        window.press("h", lambda s: not s["help"], "no help")

    def test_status_line(self):
        window = self.open_tiny("--rays", "8")
        state = window.wait_for_rays(8)
        assert re.fullmatch(r"tiny\.cli   8 rays per pixel of 8 \(done\)   \d+\.\d Mrays/s   \d+\.\d s   "
                            r"sobol, error 0\.\d{4}", state["status"]), state["status"]
        state = window.press("l", lambda s: current(s) and s["done"] and s["sides"][0]["without"], "no lens")
        assert state["status"].endswith(", without lens"), state["status"]

    def test_pause(self):
        window = self.open_tiny()
        before = window.press("space", lambda s: s["paused"], "a pause")
        window.press("r", lambda s: s["task"] > before["task"] and current(s) and s["rays"] == 1, "the first picture")
        for _ in range(10):
            window.press("h", lambda s: s["help"], "help")
            state = window.press("h", lambda s: not s["help"], "no help")
            assert current(state) and state["rays"] == 1, "it continues while it is paused"
        window.press("space", lambda s: not s["paused"] and s["rays"] > 1, "more rays")

    def test_restart(self):
        window = self.open_tiny("--rays", "1000000")
        before = window.wait(lambda s: s["rays"] >= 8, "some rays")
        state = window.press("r", lambda s: s["task"] > before["task"] and current(s), "a new picture")
        assert state["rays"] < 8 or state["task"] > before["task"]

    def test_rays(self):
        window = self.open_tiny()
        state = window.wait_for_rays(4, "the picture rests at what the scene says:")
        assert state["limit"] == 4 and state["changed"] == "", state["changed"]
        window.press("plus", lambda s: s["limit"] == 8 and current(s) and (s["done"] or s["rays"] > 8), "8 rays")
        window.wait_for_rays(8)
        window.press("plus", lambda s: s["limit"] == 16, "16 rays")
        window.wait_for_rays(16)
        window.press("minus", lambda s: s["limit"] == 8, "8 rays")
        window.wait_for_rays(8)
        window.picture_shot(self.path("seen.png"))
        self.assert_same_picture(self.path("seen.png"), self.render("tiny.cli", "8.png", "--rays", "8"))
        window.press("KP_Add", lambda s: s["limit"] == 16, "16 rays")

    def test_effects(self):
        window = self.open_tiny("--rays", "8")
        window.wait_for_rays(8)
        for key, effect in (("a", "antialiasing"), ("l", "lens"), ("m", "motion"), ("d", "disk-lights"), ("g", "gloss"),
                            ("t", "translucency")):
            window.press(key, lambda s: current(s) and s["sides"][0]["without"] == effect and s["done"],
                         "no " + effect)
            window.picture_shot(self.path("seen.png"))
            self.assert_same_picture(self.path("seen.png"),
                                     self.render("tiny.cli", effect + ".png", "--rays", "8", "--without", effect))
            self.assert_other_picture(self.path("seen.png"), self.render("tiny.cli", "with.png", "--rays", "8"))
            window.press(key, lambda s: current(s) and s["sides"][0]["without"] == "" and s["done"], effect)

    def test_samplers(self):
        window = self.open_tiny("--rays", "8")
        window.wait_for_rays(8)
        seen = []
        for _ in range(8):
            last = window.state["sides"][0]["sampler"]
            state = window.press("p", lambda s: current(s) and s["done"] and s["sides"][0]["sampler"] != last,
                                 "another sampler")
            seen.append(state["sides"][0]["sampler"])
            window.picture_shot(self.path("seen.png"))
            self.assert_same_picture(self.path("seen.png"),
                                     self.render("tiny.cli", "it.png", "--rays", "8", "--sampler", seen[-1]))
        assert len(set(seen)) == 8, seen

    def test_exposure(self):
        window = self.open_tiny("--rays", "4")
        window.wait_for_rays(4)
        window.press("e", lambda s: s["exposure"] == 0.5, "exposure")
        window.press("e", lambda s: s["exposure"] == 1, "exposure")
        window.picture_shot(self.path("seen.png"))
        self.assert_same_picture(self.path("seen.png"),
                                 self.render("tiny.cli", "1.png", "--rays", "4", "--exposure", "1"))
        window.press("shift+e", lambda s: s["exposure"] == 0.5, "exposure")

    def test_save(self):
        window = self.open_tiny("--rays", "8")
        window.wait_for_rays(8)
        (first,) = self.save(window)
        assert metadata_of(first)["rays"] == "8", metadata_of(first)
        self.check_repeats(first)
        window.press("l", lambda s: current(s) and s["done"] and s["sides"][0]["without"] == "lens", "no lens")
        window.press("e", lambda s: s["exposure"] == 0.5, "exposure")
        state = window.press("s", lambda s: "view-2.png" in s["message"], "a message")
        assert "8 rays" in state["message"]
        second = self.path("tiny-view-2.png")
        assert metadata_of(second)["without"] == "lens"
        self.check_repeats(second)

    def test_save_while_it_grows(self):
        window = self.open_tiny("--rays", "1000000")
        window.wait(lambda s: s["rays"] >= 4, "a few rays")
        (png,) = self.save(window)
        self.check_repeats(png)

    def test_copy(self):
        window = self.open_tiny("--rays", "4")
        window.wait_for_rays(4)
        window.press("c", lambda s: s["message"] == "nothing has been changed", "a message")
        window.press("l", lambda s: current(s) and s["sides"][0]["without"] == "lens", "no lens")
        window.press("d", lambda s: current(s) and "disk-lights" in s["sides"][0]["without"], "no disk lights")
        window.press("plus", lambda s: s["limit"] == 8, "8 rays")
        window.press("c", lambda s: s["message"].startswith("copied"), "a message")
        lines = subprocess.run(["xclip", "-o", "-selection", "clipboard"], env=self.display.environment, check=True,
                               capture_output=True, text=True, timeout=DEADLINE).stdout
        assert lines == "rays_per_pixel 8\nlens 0 5\ndisk_light 2 5 -1 0 0 -1 0 0.9 0.9 0.9\n", lines
        # The lines do what they say: in the scene, they make the picture that is shown.
        changed = SCENE.replace("disk_light 2 5 -1 0.8 0 -1 0 0.9 0.9 0.9\n", "") + lines
        self.put("changed.cli", changed)
        window.wait_for_rays(8)
        window.picture_shot(self.path("seen.png"))
        self.assert_same_picture(self.path("seen.png"), self.render("changed.cli", "changed.png"))

    def test_focus(self):
        window = self.open_tiny("--rays", "4")
        state = window.wait_for_rays(4)
        x, y, width, height = state["picture"]
        # The middle of the red sphere, whose front is at distance 4 from the eye.
        window.move(x + width * 0.36, y + height * 0.5)
        state = window.press("f", lambda s: s["lens"][1] != 5 and current(s), "another focus")
        assert 3.9 < state["lens"][1] < 4.3 and state["lens"][0] == 0.15, state["lens"]
        window.move(x + width * 0.9, y + height * 0.05)
        window.press("f", lambda s: "nothing" in s["message"], "a message")

    def test_split(self):
        window = self.open_tiny("--rays", "8")
        window.wait_for_rays(8)
        state = window.press("v", lambda s: s["split"] and current(s) and s["done"], "two halves")
        assert [side["sampler"] for side in state["sides"]] == ["sobol", "random"], state["sides"]
        window.press("d", lambda s: current(s) and s["done"] and s["sides"][1]["without"] == "disk-lights",
                     "no disk lights at the right")
        assert window.state["sides"][0]["without"] == ""
        x, y, width, height = state["picture"]
        middle = x + width // 2
        window.mouse("mousemove", middle, y + 20, "mousedown", 1)
        window.mouse("mousemove", x + width // 4, y + 20)
        window.mouse("mouseup", 1)
        window.wait(lambda s: abs(s["divider"] - 0.25) < 0.01, "the divider at a quarter")
        left, right = self.save(window)
        assert "left" in left and "right" in right
        self.check_repeats(left)
        self.check_repeats(right)
        assert metadata_of(right)["sampler"] == "random" and metadata_of(right)["rays"] == "8"
        window.press("v", lambda s: not s["split"] and current(s) and len(s["sides"]) == 1, "one picture")

    def test_new_scene(self):
        """Another scene starts unpaused, at exposure 0, and rests at its own rays per pixel."""
        self.put("s01a.cli", SCENE)
        self.put("s01b.cli", SCENE.replace("rays_per_pixel 4", "rays_per_pixel 9"))
        window = self.open(".")
        window.wait_for_rays(4)
        window.press("e", lambda s: s["exposure"] == 0.5, "exposure")
        window.press("space", lambda s: s["paused"], "a pause")
        window.press("shift+1", lambda s: s["scene"].endswith("s01b.cli") and not s["paused"] and s["exposure"] == 0,
                     "the twin")
        window.wait_for_rays(9)

    def test_scenes_of_a_folder(self):
        """A folder without s01a.cli: N and Shift+N, and a list."""
        for name in ("ant", "bee", "cat"):
            self.put(name + ".cli", SCENE)
        window = self.open(".")
        assert window.state["scene"].endswith("ant.cli")
        for key, scene in (("n", "bee"), ("n", "cat"), ("n", "ant"), ("shift+n", "cat")):
            window.press(key, lambda s: s["scene"].endswith(scene + ".cli") and current(s), scene)
        window.click_knob("scene", lambda s: "bee.cli" in s["knobs"])
        # Escape closes the list, and nothing else.
        window.press("Escape", lambda s: "bee.cli" not in s["knobs"], "no list")
        open_list = window.click_knob("scene", lambda s: "bee.cli" in s["knobs"])
        window.wait(lambda s: s["frame"] > open_list["frame"] + 1, "the list in its place")
        window.click_knob("bee.cli", lambda s: s["scene"].endswith("bee.cli") and current(s))
        window.click_knob("previous scene", lambda s: s["scene"].endswith("ant.cli") and current(s))
        window.click_knob("next scene", lambda s: s["scene"].endswith("bee.cli") and current(s))

    def test_escape(self):
        """Escape closes what is open, then the window."""
        window = self.open_tiny()
        x, y, width, height = window.wait_for_rays(4)["picture"]
        window.click(x + width * 0.36, y + height * 0.5)
        window.wait(lambda s: "inspection" in s, "the inspector")
        window.press("h", lambda s: s["help"], "help")
        state = window.press("Escape", lambda s: not s["help"], "no help")
        assert "inspection" in state, "one thing at a time"
        window.press("Escape", lambda s: "inspection" not in s, "no inspector")
        window.key("Escape")
        assert window.process.wait(DEADLINE) == 0

    def render(self, scene, name, *options):
        return super().render(self.path(scene), name, *options)


if __name__ == "__main__":
    sys.exit(KeyTests.main())
