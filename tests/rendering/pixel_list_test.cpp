// Pixels of a tile are listed once each, those that share packets near each other; sharing a packet does not show.
#include "rendering/pixel_list.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "rendering/all_effects.hpp"
#include "rendering/film_values.hpp"
#include "rendering/render_text.hpp"

namespace penumbra::test {
namespace {

TEST(PixelList, HasEachWantedPixelOnce) {
  for (const PixelRect& tile : {PixelRect{0, 0, 8, 8}, PixelRect{16, 32, 32, 48}, PixelRect{3, 5, 16, 6},
                                PixelRect{8, 0, 9, 8}, PixelRect{5, 1, 10, 8}}) {
    for (const int step : {1, 3}) {
      const auto wanted = [step](int x, int y) { return (x + 2 * y) % step == 0; };
      std::set<std::pair<int, int>> expected, found;
      for (int y = tile.y0; y < tile.y1; y++) {
        for (int x = tile.x0; x < tile.x1; x++) {
          if (wanted(x, y)) expected.insert({x, y});
        }
      }
      const PixelList list = pixels_of(tile, wanted);
      for (const Pixel& pixel : list.all()) found.insert({static_cast<int>(pixel.x), static_cast<int>(pixel.y)});
      EXPECT_EQ(list.all().size(), expected.size());
      EXPECT_TRUE(found == expected);
    }
  }
}

TEST(PixelList, PutsNeighboursTogether) {
  const PixelList list = pixels_of({16, 32, 32, 48});
  for (std::size_t size = 1; size <= 256; size *= 2) {
    for (std::size_t begin = 0; begin < 256; begin += size) {
      std::uint32_t left = ~0u, top = ~0u, right = 0, bottom = 0;
      for (const Pixel& pixel : list.all().subspan(begin, size)) {
        left = std::min(left, pixel.x), right = std::max(right, pixel.x + 1);
        top = std::min(top, pixel.y), bottom = std::max(bottom, pixel.y + 1);
      }
      EXPECT_EQ((right - left) * (bottom - top), size);  // a full rectangle
      EXPECT_LE(right - left, 2 * (bottom - top));
      EXPECT_LE(bottom - top, right - left);
    }
  }
}

// The pixels of a tile in their order, shuffled, and each alone.
TEST(PixelList, CompanyDoesNotShow) {
  for (const std::string& text : {scene_text(48), scene_text(48) + mesh_text()}) {
    const Scene scene = scene_from(text);
    const Frame frame = frame_from(scene);
    const PixelRect tile{16, 16, 32, 32};
    for (const Kernel* kernel : usable_kernels()) {
      for (const std::uint32_t samples : {1u, 2u, 5u, 16u, 48u}) {
        const auto colors = [&](const auto& render) {
          Film film(tile, all_layers);
          render(film.view());
          film.set_samples(pixels_of(tile).all(), samples);
          return std::pair(film.color(), film.layer(Layer::variance));
        };
        RayCounts counts;
        const PixelList list = pixels_of(tile);
        const auto in_order = colors([&](const FilmView& view) {
          kernel->render_pixels(frame, view, {list.all(), 0, samples}, counts);
        });
        std::vector<Pixel> mixed(list.all().begin(), list.all().end());
        for (std::size_t i = 1; i < mixed.size(); i++) std::swap(mixed[i], mixed[i * 7919 % (i + 1)]);
        EXPECT_TRUE(colors([&](const FilmView& view) {
                      kernel->render_pixels(frame, view, {mixed, 0, samples}, counts);
                    }) == in_order);
        EXPECT_TRUE(colors([&](const FilmView& view) {
                      for (const Pixel& pixel : mixed) {
                        kernel->render_pixels(frame, view, {{&pixel, 1}, 0, samples}, counts);
                      }
                    }) == in_order);
      }
    }
  }
}

}  // namespace
}  // namespace penumbra::test
