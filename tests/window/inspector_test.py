"""A click shows what that pixel saw: the same tree of rays as `penumbra render --debug-pixel`, to the last digit."""

import os
import re
import shlex
import subprocess
import sys

from harness import DEADLINE, Tests
from tiny import SCENE


class InspectorTests(Tests):
    def test_click_and_arrows(self):
        self.put("tiny.cli", SCENE)
        window = self.open("tiny.cli", "--rays", "6")
        state = window.wait_for_rays(6)
        x, y, width, height = state["picture"]
        zoom = state["zoom"]
        before = state["frame"]
        window.click(x + 40 * zoom + 1, y + 45 * zoom + 1)
        state = window.wait(lambda s: "inspection" in s, "the inspector", since=before)
        assert state["inspection"]["pixel"] == [40, 45], state["inspection"]
        for key, sample in (("Right", 1), ("Right", 2), ("Down", 5), ("Left", 4), ("Up", 0)):
            state = window.press(key, lambda s: s["inspection"]["sample"] == sample, "sample %d" % sample)
            words = shlex.split(state["inspection"]["command"])
            text = subprocess.run([self.penumbra, *words[1:]], cwd=self.folder, check=True, capture_output=True,
                                  text=True, timeout=DEADLINE).stdout
            assert text == state["inspection"]["text"], text + state["inspection"]["text"]
            assert text.count("eye ray") == 1 and "shadow ray to light 1" in text, text
        # The rays are drawn over the picture, which is the same again when they are gone.
        window.screenshot(self.path("with.png"), (x, y, width, height))
        before = window.state["frame"]
        window.click(x + 40 * zoom + 1, y + 45 * zoom + 1)
        state = window.wait(lambda s: "inspection" not in s, "no inspector", since=before)
        window.wait(lambda s: s["frame"] > state["frame"], "a frame after it")
        window.picture_shot(self.path("without.png"))
        self.assert_same_picture(self.path("without.png"), self.render(self.path("tiny.cli"), "it.png", "--rays", "6"))
        window.screenshot(self.path("plain.png"), (x, y, width, height))
        self.assert_other_picture(self.path("with.png"), self.path("plain.png"))

    def test_is_not_clicked_through(self):
        """The mouse on the inspector's own window does not reach the picture below it."""
        self.put("tiny.cli", SCENE)
        window = self.open("tiny.cli", "--rays", "4")
        state = window.wait_for_rays(4)
        x, y, width, height = state["picture"]
        window.click(x + width * 0.36, y + height * 0.2)
        before = window.wait(lambda s: "inspector" in s, "the inspector")
        left, top, inspector_width, inspector_height = before["inspector"]
        place = (left + inspector_width // 2, (max(top, y) + min(top + inspector_height, y + height)) // 2)
        assert x < place[0] < x + width and top < place[1] < top + inspector_height, "it should lie over the picture"
        window.mouse("mousemove", *place, "click", 1, "click", 4)
        # Events are handled in order.
        state = window.press("h", lambda s: s["help"], "help")
        assert state["inspection"]["pixel"] == before["inspection"]["pixel"], state["inspection"]["pixel"]
        assert state["zoom"] == before["zoom"] and state["picture"] == before["picture"], state["picture"]

    def test_rays_have_the_colours_of_the_table(self):
        """Reflected, transmitted and shadow rays of a sample are drawn in the colours that the pages name."""
        root = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
        with open(os.path.join(root, "src", "rendering", "ray_colors.hpp")) as file:
            table = {word: bytes(int(n) for n in numbers.split(","))
                     for word, numbers in re.findall(r'\{"(\w+)", \{([\d, ]+)\}\}', file.read())}
        self.put("tiny.cli", SCENE)
        window = self.open("tiny.cli", "--rays", "4")
        state = window.wait_for_rays(4)
        x, y, width, height = state["picture"]
        window.click(x + 89 * state["zoom"] + 1, y + 40 * state["zoom"] + 1)
        state = window.wait(lambda s: "inspection" in s, "the inspector of the translucent ball")
        rows = window.screen.rgb(x, y, width, height)
        seen = {row[3 * i:3 * i + 3] for row in rows for i in range(width)}
        for word in ("red", "blue", "amber"):
            assert table[word] in seen, "no %s ray: %s" % (word, state["inspection"]["text"])

    def test_covers_at_most_a_third(self):
        """Wherever the pixel is, and however large the picture."""
        window = self.open(self.scenes + "/s07b.cli", "--rays", "4")
        state = window.wait_for_rays(4)
        for zoom in range(2):
            x, y, width, height = state["picture"]
            for share in (0.1, 0.45, 0.9):
                before = window.state["frame"]
                window.click(x + width * 0.5, y + height * share)
                s = window.wait(lambda s: "inspector" in s and "inspection" in s, "the inspector", since=before)
                left, top, w, h = s["inspector"]
                covered = max(0, min(left + w, x + width) - max(left, x)) * max(0, min(top + h, y + height) - max(top, y))
                assert 3 * covered <= width * height, (s["inspector"], s["picture"])
                pixel_y = y + (s["inspection"]["pixel"][1] + 0.5) * s["zoom"]
                assert not top <= pixel_y < top + h, "it should not cover the pixel"
                window.press("Escape", lambda s: "inspection" not in s, "no inspector")
            window.mouse("mousemove", x + width // 2, y + height // 2, "click", 5)
            state = window.wait(lambda s: s["zoom"] != state["zoom"], "a smaller picture")

    def test_follows_the_picture(self):
        self.put("tiny.cli", SCENE)
        window = self.open("tiny.cli", "--rays", "4")
        state = window.wait_for_rays(4)
        x, y, width, height = state["picture"]
        window.click(x + width * 0.36, y + height * 0.5)
        first = window.wait(lambda s: "inspection" in s, "the inspector")["inspection"]["text"]
        window.press("d", lambda s: s["picture_task"] == s["task"] and s["inspection"]["text"] != first,
                     "another tree without disk lights")


if __name__ == "__main__":
    sys.exit(InspectorTests.main())
