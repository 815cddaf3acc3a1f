// What draws rays and what tells of them use one table of colours.
#include "rendering/ray_colors.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "base/test_folder.hpp"
#include "language/scene_file.hpp"

namespace penumbra {
namespace {

const std::filesystem::path root = PENUMBRA_ROOT;

const RayColor& color_of_kind(RayKind kind) { return ray_colors[static_cast<std::size_t>(kind)]; }

std::string words_for(const char* rays, RayKind kind) {
  return std::string(rays) + ' ' + std::string(color_of_kind(kind).word);
}

TEST(RayColors, TheLecturesModelHasThem) {
  const SceneFile file = read_scene(root / "scenes/lecture/ray_tree.cli", {});
  ASSERT_FALSE(file.actions.empty());
  const Scene& scene = *std::get<Picture>(file.actions.front()).scene;
  for (const RayColor& wanted : ray_colors) {
    const auto has_it = [&](const Surface& surface) {
      for (int c = 0; c < 3; c++) {
        if (std::lround(255 * surface.diffuse[c]) != wanted.rgb[static_cast<std::size_t>(c)]) return false;
      }
      return true;
    };
    EXPECT_TRUE(std::any_of(scene.surfaces.begin(), scene.surfaces.end(), has_it)) << wanted.word;
  }
}

TEST(RayColors, ThePagesNameThem) {
  for (const char* page : {"docs/viewer.md", "docs/lecture.md"}) {
    std::string text = test::content_of(root / page);
    std::replace(text.begin(), text.end(), '\n', ' ');
    for (const std::string& words :
         {words_for("reflected rays", RayKind::reflection), words_for("transmitted rays", RayKind::transmission),
          words_for("shadow rays", RayKind::shadow)}) {
      EXPECT_NE(text.find(words), text.npos) << page << " does not say `" << words << '`';
    }
  }
}

}  // namespace
}  // namespace penumbra
