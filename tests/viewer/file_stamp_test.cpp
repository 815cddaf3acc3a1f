#include "viewer/file_stamp.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <thread>

#include "base/test_folder.hpp"
#include "language/file_bytes.hpp"
#include "viewer/loaded_scene.hpp"

namespace penumbra {
namespace {

using test::put_content;

class FileStampTest : public testing::Test {
 protected:
  // The stamp of a file that was read long after it was written.
  FileStamp old_stamp(const std::filesystem::path& path) {
    FileStamp stamp = stamp_of(path, {});
    stamp.unsure = false;
    return stamp;
  }
  test::TestFolder folder_;
};

TEST_F(FileStampTest, SameFileIsUnchanged) {
  put_content(folder_ / "a", "1");
  EXPECT_EQ(change_of({old_stamp(folder_ / "a"), old_stamp(folder_ / "missing")}), FileChange::none);
}

TEST_F(FileStampTest, SeesEveryWayOfSaving) {
  const auto path = folder_ / "a";
  put_content(path, "1");
  FileStamp stamp = old_stamp(path);
  put_content(path, "22");
  EXPECT_NE(change_of({stamp}), FileChange::none) << "another size";

  stamp = old_stamp(path);
  put_content(folder_ / "b", "33");
  std::filesystem::rename(folder_ / "b", path);
  EXPECT_NE(change_of({stamp}), FileChange::none) << "renamed over it";

  stamp = old_stamp(path);
  std::filesystem::remove(path);
  EXPECT_NE(change_of({stamp}), FileChange::none) << "gone";

  stamp = old_stamp(path);
  put_content(path, "33");
  EXPECT_NE(change_of({stamp}), FileChange::none) << "back";
}

TEST_F(FileStampTest, WrittenWhileItWasReadIsLookedAtAgain) {
  const StampClock before = StampClock::now();
  put_content(folder_ / "a", "1");
  EXPECT_TRUE(stamp_of(folder_ / "a", before).unsure);
  EXPECT_NE(change_of({stamp_of(folder_ / "a", before)}), FileChange::none);
  EXPECT_EQ(change_of({stamp_of(folder_ / "a", before)}), FileChange::fresh);
  std::this_thread::sleep_for(std::chrono::milliseconds(40));
  EXPECT_EQ(change_of({stamp_of(folder_ / "a", before)}), FileChange::settled);
  EXPECT_FALSE(stamp_of(folder_ / "a", StampClock::now()).unsure);
}

TEST_F(FileStampTest, ALargeFileMayBeCutShortWhileItIsUsed) {
  const std::string large = std::string((std::size_t{16} << 20) + 1, '#');
  put_content(folder_ / "a", large);
  const LoadedFile loaded = load_copy_from_disk(folder_ / "a");
  std::filesystem::resize_file(folder_ / "a", 0);
  EXPECT_EQ(loaded.bytes.view(), large) << "a mapped file would crash this program here";
}

TEST_F(FileStampTest, SceneIsWatchedWithAllThatItNames) {
  put_content(folder_ / "a.cli", "read part.cli\nread missing.cli\nsphere 1 0 0 -5\n");
  put_content(folder_ / "part.cli", "sphere 1 1 0 -5\n");
  const LoadedScene loaded = load_scene(folder_ / "a.cli", {});
  EXPECT_EQ(loaded.scene, nullptr);
  std::vector<std::string> names;
  for (const FileStamp& stamp : loaded.files) names.push_back(stamp.path.filename().string());
  EXPECT_EQ(names, (std::vector<std::string>{"a.cli", "part.cli", "missing.cli"}));
}

}  // namespace
}  // namespace penumbra
