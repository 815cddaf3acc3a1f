// Shards divide all tiles evenly among them, and their parts, in any order, give the picture.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "base/atomic_file.hpp"
#include "rendering/shard_part.hpp"
#include "sittings/pictures.hpp"

namespace penumbra::test {
namespace {

TEST(Shards, HaveAllTilesBetweenThem) {
  const TileGrid grid({0, 0, 1280, 720});
  for (const int count : {1, 2, 3, 5, 7, 16, 24, 64, 100, 999, 3600, 5000}) {
    std::vector<int> owners(static_cast<std::size_t>(grid.count()));
    for (int index = 0; index < count; index++) {
      for (int tile = 0; tile < grid.count(); tile++)
        owners[static_cast<std::size_t>(tile)] += grid.has({index, count}, tile);
    }
    EXPECT_EQ(owners, std::vector<int>(owners.size(), 1)) << count;
  }
}

// In each twelfth of the picture, each shard has its share, within 10 % and two tiles.
TEST(Shards, AreSpreadEvenly) {
  for (const PixelRect& picture :
       {PixelRect{0, 0, 640, 480}, PixelRect{0, 0, 1280, 720}, PixelRect{0, 0, 3840, 2160}}) {
    const TileGrid grid(picture);
    for (int count = 1; count <= 64; count++) {
      int all = 0, own[3][4] = {};
      for (int tile = 0; tile < grid.count(); tile++) {
        if (!grid.has({count / 2, count}, tile)) continue;
        own[tile / grid.columns() * 3 / grid.rows()][tile % grid.columns() * 4 / grid.columns()]++;
        all++;
      }
      const double share = static_cast<double>(grid.count()) / count;
      EXPECT_NEAR(all, share, 0.02 * share + 2) << count << " shards";
      for (const auto& row : own) {
        for (const int tiles : row) EXPECT_NEAR(tiles, share / 12, 0.1 * share / 12 + 2) << count << " shards";
      }
    }
  }
}

std::vector<std::byte> part_of(const Setting& setting, Shard shard, std::string development = "as it is") {
  Setting own = setting;
  own.plan.shard = shard;
  own.plan.threads = 2;
  RenderState state;
  const std::unique_ptr<ResumableRender> render = own.render(*usable_kernels().back());
  render->run(state);
  EXPECT_TRUE(render->is_finished());
  const Film film = render->take_film();
  return encode_part({own.key, shard, own.plan.crop, own.plan.layers, film.counts(), std::move(development)}, film);
}

std::vector<std::vector<std::byte>> parts_of(const Setting& setting, int count) {
  std::vector<std::vector<std::byte>> parts;
  for (int i = 0; i < count; i++) parts.push_back(part_of(setting, {i, count}));
  return parts;
}

std::vector<Part> opened(const std::vector<std::vector<std::byte>>& bytes) {
  std::vector<Part> parts;
  for (const auto& part : bytes) parts.emplace_back(part, "part" + std::to_string(parts.size()));
  return parts;
}

class Shards : public testing::TestWithParam<PictureOfTest> {};

TEST_P(Shards, MergeToTheWholeFilm) {
  const Setting setting(GetParam());
  const FilmValues whole = unbroken(setting);
  std::mt19937 random(3);
  for (const int count : {1, 2, 3, 7, 30}) {  // more than there are tiles
    std::vector<std::vector<std::byte>> parts = parts_of(setting, count);
    std::shuffle(parts.begin(), parts.end(), random);
    const std::vector<Part> open = opened(parts);
    EXPECT_EQ(problems_of(open), std::vector<std::string>());
    EXPECT_TRUE(values_of(merge(open)) == whole) << count;
  }
}

INSTANTIATE_TEST_SUITE_P(Pictures, Shards, testing::ValuesIn(pictures_of_test()), [](const auto& of) {
  std::string name = of.param.name;
  std::erase_if(name, [](char c) { return !std::isalnum(static_cast<unsigned char>(c)); });
  return name;
});

class Complaints : public testing::Test {
 protected:
  static inline const PictureOfTest picture{"", "image_size 70 50\nbackground 1 .5 .2\n", {}, {0, 0, 70, 50}, {}};
  const Setting setting_{picture};
  std::vector<std::vector<std::byte>> parts_ = parts_of(setting_, 12);

  std::vector<std::string> problems() const { return problems_of(opened(parts_)); }
  using Sentences = std::vector<std::string>;
};

TEST_F(Complaints, WhatIsMissing) {
  parts_.erase(parts_.begin() + 11);
  EXPECT_EQ(problems(), Sentences{"of 12 shards, numbered from 0, one is missing: 11"});
  parts_.erase(parts_.begin() + 5, parts_.begin() + 8);
  parts_.erase(parts_.begin() + 1);
  EXPECT_EQ(problems(), Sentences{"of 12 shards, numbered from 0, 5 are missing: 1, 5-7, 11"});
}

TEST_F(Complaints, WhatIsThereTwice) {
  parts_.push_back(parts_[4]);
  EXPECT_EQ(problems(), Sentences{"shard 4 occurs twice: `part4` and `part12`"});
}

TEST_F(Complaints, WhatIsOfAnotherPicture) {
  const auto problem = [&](const auto& change) {
    Setting other = setting_;
    change(other);
    parts_[0] = part_of(other, {0, 12});
    const Sentences sentences = problems();
    EXPECT_EQ(sentences.size(), 2u);
    EXPECT_EQ(sentences.back(), "of 12 shards, numbered from 0, one is missing: 0");
    return sentences.front();
  };
  EXPECT_EQ(problem([](Setting& s) { s.key.version = "0.9"; }),
            "`part0` is a part of another picture: penumbra 0.9 wrote it, not 1");
  EXPECT_EQ(problem([](Setting& s) { s.key.scene.low = 5; }),
            "`part0` is a part of another picture: the scene, or a file that it reads, is not the same");
  EXPECT_EQ(problem([](Setting& s) { s.key.picture = 2; }),
            "`part0` is a part of another picture: it is of picture 2 of the scene, not of 1");
  EXPECT_EQ(problem([](Setting& s) { s.key.plan.emplace_back("seed", "7"); }),
            "`part0` is a part of another picture: its `seed` is 7, but not given in the others");
  EXPECT_EQ(problem([](Setting& s) { s.plan.layers.add(Layer::depth); }),
            "`part0` is a part of another picture: its crop, layers or output options differ from the others");
  parts_[0] = part_of(setting_, {0, 13});
  EXPECT_EQ(problems().front(), "`part0` is a part of another picture: it is one of 13 shards, not of 12");
}

// Any changed byte and any missing end is noticed.
TEST_F(Complaints, Damage) {
  const std::vector<std::byte> good = part_of(setting_, {1, 12});
  const auto is_refused = [](const std::vector<std::byte>& bytes) {
    try {
      Part(bytes, "part");
    } catch (const FileError& error) {
      return error.exit_code == 65 && std::string(error.what()).starts_with("`part` is ");
    }
    return false;
  };
  ASSERT_FALSE(is_refused(good));
  for (std::size_t i = 0; i < good.size(); i++) {
    std::vector<std::byte> bad = good;
    bad[i] ^= std::byte{0x10};
    ASSERT_TRUE(is_refused(bad)) << i;
  }
  for (std::size_t size = 0; size < good.size(); size++) {
    ASSERT_TRUE(is_refused({good.begin(), good.begin() + static_cast<std::ptrdiff_t>(size)})) << size;
  }
  std::vector<std::byte> longer = good;
  longer.push_back({});
  EXPECT_TRUE(is_refused(longer));
}

}  // namespace
}  // namespace penumbra::test
