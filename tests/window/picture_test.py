"""The window shows what `penumbra render` makes of the same scene, options and number of rays, to the byte."""

import os
import sys

from harness import Tests


class PictureTests(Tests):
    def scene(self, name):
        return os.path.join(self.scenes, name)

    def check_screen(self, scene, rays, *options):
        window = self.open(scene, "--rays", str(rays), *options)
        window.wait_for_rays(rays)
        window.picture_shot(self.path("seen.png"))
        self.assert_same_picture(self.path("seen.png"),
                                 self.render(scene, "rendered.png", "--rays", str(rays), *options))
        window.close()

    def test_one_ray(self):
        self.check_screen(self.scene("s05b.cli"), 1)

    def test_many_rays(self):
        self.check_screen(self.scene("s08b.cli"), 50)

    def test_pattern_that_needs_the_count(self):
        self.check_screen(self.scene("s05b.cli"), 24, "--sampler", "jittered")

    def test_course(self):
        self.check_screen(self.scene("s06b.cli"), 8, "--course")

    def test_small_window_of_a_large_picture(self):
        window = self.open(self.scene("s01a.cli"), "--size", "1600x1200", "--rays", "1")
        state = window.wait_for_rays(1)
        x, y, width, height = state["picture"]
        assert width <= state["window"][0] and height <= state["window"][1], state


if __name__ == "__main__":
    sys.exit(PictureTests.main())
