#include "viewer/scene_folder.hpp"

#include <gtest/gtest.h>

#include "base/test_folder.hpp"

namespace penumbra {
namespace {

TEST(SceneFolder, KeysNameThePairs) {
  EXPECT_EQ(scene_of_key("scenes", 1, false), "scenes/s01a.cli");
  EXPECT_EQ(scene_of_key("scenes", 9, true), "scenes/s09b.cli");
  EXPECT_EQ(scene_of_key("", 3, true), "s03b.cli");
}

TEST(SceneFolder, BeginsWithTheFirstPair) {
  const test::TestFolder folder;
  EXPECT_TRUE(first_scene(folder.path()).empty());
  test::put_content(folder / "zebra.cli", "");
  test::put_content(folder / "ant.cli", "");
  test::put_content(folder / "a.txt", "");
  EXPECT_EQ(first_scene(folder.path()), folder / "ant.cli");
  test::put_content(folder / "s02b.cli", "");
  EXPECT_EQ(first_scene(folder.path()), folder / "s02b.cli");
  EXPECT_EQ(first_scene(folder / "zebra.cli"), folder / "zebra.cli");
  EXPECT_EQ(folder_of(folder / "zebra.cli"), folder.path());
  EXPECT_EQ(folder_of(folder.path()), folder.path());
}

TEST(SceneFolder, ScenesFollowEachOtherByName) {
  const test::TestFolder folder;
  EXPECT_TRUE(scenes_of(folder.path()).empty());
  EXPECT_TRUE(scenes_of(folder / "missing").empty());
  EXPECT_TRUE(scene_after({}, "a.cli", 1).empty());
  for (const char* name : {"zebra.cli", "ant.cli", "bee.cli", "a.txt"}) test::put_content(folder / name, "");
  std::filesystem::create_directory(folder / "folder.cli");
  const std::vector<std::filesystem::path> scenes = scenes_of(folder.path());
  EXPECT_EQ(scenes, (std::vector<std::filesystem::path>{folder / "ant.cli", folder / "bee.cli", folder / "zebra.cli"}));
  EXPECT_EQ(scene_after(scenes, folder / "ant.cli", 1), folder / "bee.cli");
  EXPECT_EQ(scene_after(scenes, folder / "zebra.cli", 1), folder / "ant.cli");
  EXPECT_EQ(scene_after(scenes, folder / "ant.cli", -1), folder / "zebra.cli");
  EXPECT_EQ(scene_after(scenes, "elsewhere.cli", 1), folder / "ant.cli");
}

}  // namespace
}  // namespace penumbra
