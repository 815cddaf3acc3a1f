// Which limit counts, on machines that a folder stands for.
#include "base/available_memory.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include "base/test_folder.hpp"

namespace penumbra {
namespace {

class AvailableMemory : public testing::Test {
 protected:
  AvailableMemory() {
    put("proc/meminfo", "MemTotal:       9000 kB\nMemFree:          10 kB\nMemAvailable:   1000 kB\n");
  }

  void put(const std::string& file, const std::string& content) const {
    std::filesystem::create_directories((folder_ / file).parent_path());
    test::put_content(folder_ / file, content);
  }
  std::uint64_t kilobytes() const { return available_memory(folder_.path()) / 1024; }

  test::TestFolder folder_;
};

TEST_F(AvailableMemory, IsThatOfTheMachine) { EXPECT_EQ(kilobytes(), 1000u); }

TEST_F(AvailableMemory, IsWhatTheGroupLeaves) {
  put("proc/self/cgroup", "0::/job/task\n");
  put("sys/fs/cgroup/job/task/memory.max", "max\n");
  put("sys/fs/cgroup/job/task/memory.current", "409600\n");
  EXPECT_EQ(kilobytes(), 1000u) << "no limit";
  put("sys/fs/cgroup/job/task/memory.max", "819200\n");
  EXPECT_EQ(kilobytes(), 400u);
  put("sys/fs/cgroup/job/task/memory.stat", "anon 204800\nfile 204800\nactive_file 102400\ninactive_file 102400\n");
  EXPECT_EQ(kilobytes(), 500u) << "the kernel gives up its cache";
  put("sys/fs/cgroup/job/memory.max", "409600\n");
  put("sys/fs/cgroup/job/memory.current", "307200\n");
  EXPECT_EQ(kilobytes(), 100u) << "the group above counts, too";
  put("sys/fs/cgroup/job/memory.current", "500000\n");
  EXPECT_EQ(kilobytes(), 0u);
}

TEST_F(AvailableMemory, IsWhatAGroupOfVersion1Leaves) {
  put("proc/self/cgroup", "5:cpu,cpuacct:/\n4:memory:/outside/of/the/container\n0::/\n");
  put("sys/fs/cgroup/memory/memory.limit_in_bytes", "409600\n");
  put("sys/fs/cgroup/memory/memory.usage_in_bytes", "204800\n");
  put("sys/fs/cgroup/memory/memory.stat", "cache 1\ninactive_file 1\ntotal_inactive_file 102400\n");
  EXPECT_EQ(kilobytes(), 300u);
  put("sys/fs/cgroup/memory/memory.limit_in_bytes", "9223372036854771712\n");
  EXPECT_EQ(kilobytes(), 1000u);
}

TEST_F(AvailableMemory, IsLimitedByUlimit) {
  put("proc/meminfo", "MemAvailable: 1000000000000 kB\n");
  rlimit old{};
  ::getrlimit(RLIMIT_AS, &old);
  const rlim_t size = rlim_t{1} << 46;
  const rlimit limit{size, old.rlim_max};
  ASSERT_EQ(::setrlimit(RLIMIT_AS, &limit), 0);
  EXPECT_LT(available_memory(folder_.path()), size);
  EXPECT_GT(available_memory(folder_.path()), size / 2);
  ::setrlimit(RLIMIT_AS, &old);
}

TEST_F(AvailableMemory, IsPlentyWhereNothingIsKnown) {
  std::filesystem::remove(folder_ / "proc/meminfo");
  EXPECT_GT(kilobytes(), 1000'000'000'000u);
}

TEST_F(AvailableMemory, IsLessThanTheProcessHasAlready) { EXPECT_GT(resident_memory(), 100'000u); }

}  // namespace
}  // namespace penumbra
