// Published course scenes, if they are available: every one is read without an error.
#include <cstdlib>
#include <filesystem>

#include "picture/examine.hpp"
#include "support.hpp"

namespace penumbra {
namespace {

namespace fs = std::filesystem;

fs::path reference_folder() {
  const char* const named = std::getenv("PENUMBRA_REFERENCE_DIR");
  return named != nullptr ? fs::path(named) : fs::path(PENUMBRA_ROOT) / "../shared/reference";
}

TEST(Reference, everySceneIsRead) {
  if (!fs::is_directory(reference_folder())) GTEST_SKIP() << "no reference scenes here";
  int scenes = 0;
  for (const fs::directory_entry& entry : fs::directory_iterator(reference_folder())) {
    const fs::path path = entry.path() / "scene.cli";
    if (!fs::exists(path)) continue;
    scenes++;
    const bool of_2018 = path.string().find("-2018-") != std::string::npos;
    const auto courses = of_2018 ? std::vector{Course::year_2018} : std::vector{Course::off, Course::any_year};
    for (const Course course : courses) {
      PictureOptions options;
      options.course = course;
      const SceneFile file = read_and_examine(path, options);
      EXPECT_FALSE(has_error(file.diagnostics)) << told(file);
      EXPECT_GE(pictures(file).size(), 1u) << path;
      EXPECT_TRUE(file.diagnostics.empty()) << "an unexpected warning: " << told(file);
    }
  }
  EXPECT_GT(scenes, 0);
}

TEST(Reference, theScenesOfThisProgramAreFreeOfWarnings) {
  for (const fs::directory_entry& entry : fs::directory_iterator(fs::path(PENUMBRA_ROOT) / "scenes")) {
    if (entry.path().extension() != ".cli") continue;
    EXPECT_EQ(told(read_and_examine(entry.path(), {})), "");
  }
}

TEST(Reference, theBunnyIsOneGroup) {
  const fs::path path = reference_folder() / "27-3-bunny-accel/scene.cli";
  if (!fs::exists(path)) GTEST_SKIP() << "no reference scenes here";
  const SceneFile file = read_scene(path, {});
  ASSERT_EQ(file.actions.size(), 3u);
  const Scene& scene = *pictures(file).at(0).scene;
  ASSERT_EQ(scene.root.objects.size(), 2u);
  const auto& bunny = *shape_of<std::shared_ptr<const Group>>(scene.root.objects[1]);
  ASSERT_EQ(bunny.objects.size(), 1u);
  EXPECT_EQ(shape_of<TriangleRange>(bunny.objects[0]).count, 966u);
}

}  // namespace
}  // namespace penumbra
