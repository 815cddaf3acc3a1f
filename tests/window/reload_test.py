"""Files that change while the window is open: saving reloads the scene, errors are shown over the last good picture,
and the window stays open."""

import os
import sys

from harness import Tests
from tiny import BROKEN, BROKEN_LINE, OTHER, SCENE


def shown(state):
    return state["picture_task"] == state["task"] and state["done"] and not state["error"]


class ReloadTests(Tests):
    def open_tiny(self):
        self.put("tiny.cli", SCENE)
        window = self.open("tiny.cli", "--rays", "4")
        window.wait(shown, "the picture")
        return window

    def save_and_wait(self, window, text, name="tiny.cli"):
        before = window.state
        self.put(name, text)
        return window.wait(lambda s: s["task"] > before["task"] and shown(s), "the picture of the saved file",
                           since=before["frame"])

    def check_seen(self, window, name="tiny.cli"):
        window.picture_shot(self.path("seen.png"))
        self.assert_same_picture(self.path("seen.png"), self.render(self.path(name), "it.png", "--rays", "4"))

    def test_save(self):
        window = self.open_tiny()
        for text in (OTHER, SCENE, OTHER.replace("120 90", "90 120")):
            self.save_and_wait(window, text)
            self.check_seen(window)

    def test_save_in_place(self):
        window = self.open_tiny()
        before = window.state
        with open(self.path("tiny.cli"), "w") as file:
            file.write(OTHER)
        window.wait(lambda s: s["task"] > before["task"] and shown(s), "the new picture", since=before["frame"])
        self.check_seen(window)

    def test_error_and_recovery(self):
        window = self.open_tiny()
        window.picture_shot(self.path("before.png"))
        before = window.state["frame"]
        self.put("tiny.cli", BROKEN)
        state = window.wait(lambda s: s["error"], "an error", since=before)
        assert state["error_line"] == BROKEN_LINE, state["error"]
        assert "tiny.cli:%d:1: error: unknown command `shpere`" % BROKEN_LINE in state["error"], state["error"]
        assert "did you mean `sphere`?" in state["error"], state["error"]
        # The last good picture stays: its lower half is not covered by the error.
        x, y, width, height = state["picture"]
        half = (x, y + height * 3 // 4, width, height // 4)
        window.screenshot(self.path("half.png"), half)
        self.save_and_wait(window, SCENE)
        window.screenshot(self.path("half-again.png"), half)
        self.assert_same_picture(self.path("half.png"), self.path("half-again.png"))
        window.picture_shot(self.path("after.png"))
        self.assert_same_picture(self.path("before.png"), self.path("after.png"))

    def test_error_is_seen_at_once(self):
        """The box of an error is there without an event, in the size of its text; so is that of the next error."""
        window = self.open_tiny()
        longer = BROKEN + "spheer 1 2 3 4\nbox 1 2\ncone a b c d e\nlight 1 1 1 and a word that makes the line longer\n"
        for number, text in enumerate((BROKEN, longer, BROKEN)):
            before = window.state
            self.put("tiny.cli", text)
            state = window.wait(lambda s: s["error"] and s["task"] > before["task"] and s["error"] != before["error"],
                                "an error", since=before["frame"])
            x, y, width, height = state["picture"]
            area = [0, 0, x + width, y + height]
            window.screenshot(self.path("at-once.png"), area)
            frame = state["frame"]
            window.move(x + width // 2 + number, y + height - 3)
            window.wait(lambda s: s["frame"] > frame + 2, "frames after the mouse has moved", since=frame)
            window.screenshot(self.path("settled.png"), area)
            self.assert_same_picture(self.path("at-once.png"), self.path("settled.png"))
            assert window.state["error_box"] == state["error_box"], (number, state["error_box"])
            rows = window.screen.rgb(*state["error_box"])
            red, green = rows[len(rows) // 2][12], rows[len(rows) // 2][13]
            assert red > 2 * green, "the left edge of the box should be red: %s" % rows[len(rows) // 2][:30].hex()
        self.save_and_wait(window, SCENE)
        assert "error_box" not in window.state

    def test_file_goes_and_comes_back(self):
        window = self.open_tiny()
        before = window.state["frame"]
        os.remove(self.path("tiny.cli"))
        window.wait(lambda s: "cannot read" in s["error"], "an error", since=before)
        self.save_and_wait(window, OTHER)
        self.check_seen(window)

    def test_file_that_is_read(self):
        self.put("part.cli", "diffuse 0.9 0.1 0.1 0 0 0\n")
        self.put("whole.cli", SCENE.replace("diffuse 0.6", "read part.cli\nsphere 0.3 0 1 -4\ndiffuse 0.6"))
        window = self.open("whole.cli", "--rays", "4")
        window.wait(shown, "the picture")
        self.save_and_wait(window, "diffuse 0.1 0.1 0.9 0 0 0\n", "part.cli")
        self.check_seen(window, "whole.cli")
        before = window.state["frame"]
        os.remove(self.path("part.cli"))
        window.wait(lambda s: "part.cli" in s["error"], "an error", since=before)
        self.save_and_wait(window, "diffuse 0.1 0.9 0.1 0 0 0\n", "part.cli")
        self.check_seen(window, "whole.cli")

    def test_mesh_that_is_read(self):
        triangle = "v -1 %s -3\nv 1 %s -3\nv 0 1 -3\nf 1 2 3\n"
        self.put("part.obj", triangle % (-1, -1))
        self.put("whole.cli", SCENE + "mesh part.obj\n")
        window = self.open("whole.cli", "--rays", "4")
        window.wait(shown, "the picture")
        self.check_seen(window, "whole.cli")
        self.save_and_wait(window, triangle % (0, 0.5), "part.obj")
        self.check_seen(window, "whole.cli")
        before = window.state["frame"]
        self.put("part.obj", "f 1 2 3\n")
        window.wait(lambda s: "part.obj:1" in s["error"], "an error", since=before)
        self.save_and_wait(window, triangle % (-1, 0.5), "part.obj")
        self.check_seen(window, "whole.cli")

    def test_what_was_changed_stays(self):
        window = self.open_tiny()
        window.press("l", lambda s: shown(s) and s["sides"][0]["without"] == "lens", "no lens")
        state = self.save_and_wait(window, OTHER)
        assert state["sides"][0]["without"] == "lens", state

    def test_broken_from_the_start(self):
        self.put("tiny.cli", BROKEN)
        window = self.open("tiny.cli", "--rays", "4")
        window.wait(lambda s: s["error_line"] == BROKEN_LINE, "an error")
        self.save_and_wait(window, SCENE)
        self.check_seen(window)


if __name__ == "__main__":
    sys.exit(ReloadTests.main())
