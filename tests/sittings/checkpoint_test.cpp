// A checkpoint that is damaged, or of another render, is refused with one sentence that says so.
#include "rendering/checkpoint.hpp"

#include <gtest/gtest.h>

#include "base/atomic_file.hpp"
#include "base/test_folder.hpp"
#include "sittings/pictures.hpp"
#include "sittings/stopping_kernel.hpp"

namespace penumbra::test {
namespace {

// A checkpoint of a small adaptive render in the middle of its second round.
std::vector<std::byte> example(const Setting& setting) {
  RenderState state;
  const StoppingKernel kernel(state.stop);
  const std::unique_ptr<ResumableRender> render = setting.render(kernel.kernel());
  StoppingKernel::stop_in_call(4 * 9 + 3);
  render->run(state);
  EXPECT_FALSE(render->is_finished());
  return encode_checkpoint(setting.key, {{{1, 2, 3, 4}, {7, 6, 5, 4}}, 5.5}, *render);
}

class CheckpointFile : public testing::Test {
 protected:
  static inline const PictureOfTest picture{"", scene_text(64), 0.02f, {17, 17, 31, 20}, {}};
  const Setting setting_{picture};
  const std::vector<std::byte> good_ = example(setting_);

  // The error message; empty if there is no error.
  static std::string error_of(const std::vector<std::byte>& bytes) {
    try {
      Checkpoint(bytes, "c");
    } catch (const FileError& error) {
      EXPECT_EQ(error.exit_code, 65);
      return error.what();
    }
    return {};
  }
};

TEST_F(CheckpointFile, TellsWhatItIs) {
  const Checkpoint checkpoint(good_, "c");
  EXPECT_EQ(difference(checkpoint.key(), setting_.key), "");
  EXPECT_EQ(checkpoint.spent().rays.total(), 10u);
  EXPECT_EQ(checkpoint.spent().rays.not_finite.count, 7u);
  EXPECT_EQ(checkpoint.spent().rays.not_finite.sample, 4u);
  EXPECT_EQ(checkpoint.spent().seconds, 5.5);
}

TEST_F(CheckpointFile, EveryDamagedByteIsNoticed) {
  for (std::size_t i = 0; i < good_.size(); i++) {
    std::vector<std::byte> bad = good_;
    bad[i] ^= std::byte{0x01};
    ASSERT_NE(error_of(bad), "") << i;
  }
}

TEST_F(CheckpointFile, EveryMissingEndIsNoticed) {
  for (std::size_t size = 0; size < good_.size(); size++) {
    ASSERT_NE(error_of({good_.begin(), good_.begin() + static_cast<std::ptrdiff_t>(size)}), "") << size;
  }
  std::vector<std::byte> longer = good_;
  longer.push_back({});
  EXPECT_NE(error_of(longer), "");
}

TEST_F(CheckpointFile, SaysWhatIsWrong) {
  EXPECT_EQ(error_of({}), "`c` is not a checkpoint");
  std::vector<std::byte> bad = good_;
  bad[12] = std::byte{9};
  EXPECT_EQ(error_of(bad), "`c` is a checkpoint of format 9, but this program knows only format 4");
  bad = good_;
  bad[100] ^= std::byte{1};
  EXPECT_EQ(error_of(bad), "`c` is a damaged checkpoint: block 1 at byte 16 of " + std::to_string(bad.size()) +
                               ": its checksum does not match");
  bad = good_;
  bad.pop_back();
  EXPECT_TRUE(error_of(bad).ends_with("the file ends too early")) << error_of(bad);
}

TEST_F(CheckpointFile, OfAnotherRender) {
  const Checkpoint checkpoint(good_, "c");
  const auto refusal = [&](const auto& change) -> std::string {
    PictureKey key = setting_.key;
    change(key);
    try {
      checkpoint.require(key);
    } catch (const FileError& error) {
      EXPECT_EQ(error.exit_code, 65);
      return error.what();
    }
    return "none";
  };
  EXPECT_EQ(refusal([](PictureKey&) {}), "none");
  EXPECT_EQ(refusal([](PictureKey& key) { key.version = "2"; }),
            "`c` is the checkpoint of another render: penumbra 1 wrote it, not 2");
  EXPECT_EQ(refusal([](PictureKey& key) { key.scene.high++; }),
            "`c` is the checkpoint of another render: the scene, or a file that it reads, is not the same");
  EXPECT_EQ(refusal([](PictureKey& key) { key.picture = 3; }),
            "`c` is the checkpoint of another render: it is of picture 1 of the scene, not of 3");
  EXPECT_EQ(refusal([](PictureKey& key) { key.plan.emplace_back("rays", "5"); }),
            "`c` is the checkpoint of another render: its `rays` is not given, but 5 here");
}

// Intact blocks that cannot belong to this picture.
TEST_F(CheckpointFile, OfAnotherSizeIsDamaged) {
  const Checkpoint checkpoint(good_, "c");
  const auto is_refused = [&](PictureOfTest other) {
    const std::unique_ptr<ResumableRender> render = Setting(other).render(*usable_kernels().back());
    try {
      checkpoint.restore(*render);
    } catch (const FileError& error) {
      return error.exit_code == 65;
    }
    return false;
  };
  PictureOfTest other = picture;
  EXPECT_FALSE(is_refused(other));
  other.layers.add(Layer::depth);
  EXPECT_TRUE(is_refused(other));
  other = picture;
  other.noise.reset();
  EXPECT_TRUE(is_refused(other));
  other = picture;
  other.crop = {17, 17, 18, 18};
  EXPECT_FALSE(is_refused(other)) << "the same whole tiles";
}

class LastCheckpointFile : public CheckpointFile {
 protected:
  void put(const std::filesystem::path& path, std::vector<std::byte> bytes, bool damaged = false) const {
    if (damaged) bytes[bytes.size() / 2] ^= std::byte{1};
    put_content(path, {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
  }

  TestFolder folder_;
  const std::filesystem::path newest_ = folder_ / "c", previous_ = folder_ / "c.previous";
};

TEST_F(LastCheckpointFile, IsTheNewestThatIsWhole) {
  EXPECT_FALSE(read_last_checkpoint(newest_).checkpoint);
  put(newest_, good_);
  LastCheckpoint last = read_last_checkpoint(newest_);
  EXPECT_TRUE(last.checkpoint);
  EXPECT_EQ(last.warning, "");

  put(previous_, good_);
  put(newest_, good_, true);
  last = read_last_checkpoint(newest_);
  EXPECT_TRUE(last.checkpoint);
  EXPECT_TRUE(last.warning.starts_with("`" + newest_.string() + "` is a damaged checkpoint: block ")) << last.warning;
  EXPECT_TRUE(last.warning.ends_with("; resuming from the previous one, `" + previous_.string() + "`")) << last.warning;

  std::filesystem::remove(newest_);
  last = read_last_checkpoint(newest_);
  EXPECT_TRUE(last.checkpoint);
  EXPECT_TRUE(last.warning.starts_with("there is no checkpoint `")) << last.warning;
}

TEST_F(LastCheckpointFile, NoneIsWhole) {
  put(newest_, good_, true);
  EXPECT_THROW(read_last_checkpoint(newest_), FileError);
  put(previous_, good_, true);
  try {
    read_last_checkpoint(newest_);
    FAIL();
  } catch (const FileError& error) {
    EXPECT_EQ(error.exit_code, 65);
    const std::string sentence = error.what();
    EXPECT_NE(sentence.find("c` is a damaged"), std::string::npos) << sentence;
    EXPECT_NE(sentence.find("c.previous` is a damaged"), std::string::npos) << sentence;
  }
}

}  // namespace
}  // namespace penumbra::test
