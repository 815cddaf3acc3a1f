// A render takes no more memory than it is refused for.
#include "app/render/memory_need.hpp"
#include "base/atomic_file.hpp"
#include "base/json_text.hpp"
#include "sittings/sitting_fixture.hpp"

namespace penumbra::test {
namespace {

class Memory : public SittingTest {
 protected:
  Memory() { put_content(scene_, "light 0 9 9 1 1 1\nsphere 1 0 0 -5\n"); }

  // The most memory that a render of this size had.
  std::uint64_t peak(const std::string& size, const Words& arguments) const {
    EXPECT_EQ(render(arguments + Words{"--size", size, "--threads", "2", "--stats", path("stats")}), 0) << said();
    return static_cast<std::uint64_t>(json_from(read_file(path("stats"))).at("peak_memory_bytes").as<double>());
  }
  // The memory that the program says it needs for 2000 x 1500 pixels.
  std::uint64_t need(const RenderOptions& options) const {
    const ReadOptions of_text;
    return memory_need(options, read_scene(scene_, of_text)).bytes;
  }
};

TEST_F(Memory, ThatIsNotThereIsRefusedWithTheNumbers) {
  const Words large = {"--size", "2000x1500", "-o", path("a.png")};
  EXPECT_EQ(render(large + Words{"--memory-limit", "64M"}), 64);
  EXPECT_TRUE(said().starts_with("penumbra: this render needs about 96 MB of memory for 3000000 pixels")) << said();
  EXPECT_NE(said().find(" of the --memory-limit of 64 MB: "), std::string::npos) << said();
  EXPECT_EQ(others(), Words{});
  EXPECT_EQ(render(large + Words{"--memory-limit", "1.5GB"}), 0) << said();
  for (const char* wrong : {"4", "M", "-1G", "4X", "0M", "nanG", "1e300T"}) {
    EXPECT_EQ(render(large + Words{"--memory-limit", wrong}), 64) << wrong;
  }
}

TEST_F(Memory, IsWhatTheAddressSpaceLeaves) {
  if (scaled(1, 0) == 0) GTEST_SKIP() << "a sanitizer needs all of the address space";
  const ProgramResult result = run_program("ulimit -v 600000; '" PENUMBRA_PROGRAM "' render '" + scene_ +
                                           "' --size 16384x16384 -o '" + path("a.png") + "'");
  EXPECT_EQ(result.exit_code, 64);
  EXPECT_NE(result.output.find("needs about 7.0 GB of memory for 268435456 pixels"), std::string::npos)
      << result.output;
}

// The peak of a render contains the program itself, which a small picture shows.
TEST_F(Memory, IsNoMoreThanIsSaid) {
  if (scaled(1, 0) == 0) GTEST_SKIP() << "a sanitizer takes memory of its own";
  struct Case {
    Words words;
    RenderOptions options;
  };
  std::vector<Case> cases = {{{"-o", path("a.png")}, {}},
                             {{"-o", path("a.png"), "--bits", "16", "-o", path("b.png")}, {}},
                             {{"-o", path("a.exr"), "--aov", "depth,normal,albedo,variance,samples"}, {}},
                             {{"-o", path("a.exr"), "--noise", "0.5", "--rays", "4", "--checkpoint", path("c"),
                               "--every", "0.1s", "--keep-checkpoint"},
                              {}},
                             {{"-o", path("a.exr"), "--shard", "0/1"}, {}}};
  cases[2].options.layers = {Layer::depth, Layer::normal, Layer::albedo, Layer::variance, Layer::samples};
  cases[3].options.noise = 0.5;
  cases[3].options.session.checkpoint = path("c");
  cases[4].options.session.shard = Shard{};
  for (Case& one : cases) {
    one.options.size = {2000, 1500};
    const std::uint64_t program = peak("16x16", one.words), all = peak("2000x1500", one.words);
    EXPECT_LE(all - program, need(one.options)) << one.words[1] << " " << one.words.back();
    EXPECT_GE(all - program, need(one.options) / 2) << one.words[1] << " " << one.words.back();
    std::filesystem::remove(path("c"));
  }
}

}  // namespace
}  // namespace penumbra::test
