#include "base/large_heap.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <memory>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

namespace penumbra {
namespace {

// Whether the kernel was asked for large pages where `memory` lies.
bool asked_for_large_pages(const void* memory) {
  const auto address = reinterpret_cast<std::uintptr_t>(memory);
  std::ifstream smaps("/proc/self/smaps");
  bool inside = false;
  for (std::string line; std::getline(smaps, line);) {
    unsigned long begin = 0, end = 0;
    if (std::sscanf(line.c_str(), "%lx-%lx ", &begin, &end) == 2) inside = begin <= address && address < end;
    if (!inside || line.rfind("VmFlags:", 0) != 0) continue;
    std::istringstream flags(line);
    for (std::string flag; flags >> flag;) {
      if (flag == "hg") return true;
    }
    return false;
  }
  ADD_FAILURE() << "no mapping holds " << memory;
  return false;
}

bool is_limited(int resource) {
  rlimit limit{};
  return getrlimit(resource, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY;
}

TEST(LargeHeap, BlocksLieInLargePages) {
  if (is_limited(RLIMIT_AS) || is_limited(RLIMIT_DATA)) GTEST_SKIP() << "memory is limited here";
  if (!std::filesystem::exists("/sys/kernel/mm/transparent_hugepage")) GTEST_SKIP() << "a kernel without large pages";
  use_large_heap();
  std::vector<std::unique_ptr<char[]>> blocks;
  for (const std::size_t size : {100 << 10, 1 << 20, 16 << 20}) {
    blocks.push_back(std::make_unique<char[]>(size));
    std::thread([&] { blocks.push_back(std::make_unique<char[]>(size)); }).join();
  }
  for (const auto& block : blocks) EXPECT_TRUE(asked_for_large_pages(block.get()));
  const void* const last = blocks.back().get();
  blocks.pop_back();  // is kept, and given out again
  blocks.push_back(std::make_unique<char[]>(16 << 20));
  EXPECT_EQ(blocks.back().get(), last);
}

// The exit code of a process with a limit of 2 GB: whether its heap was grown.
void grow_with_limit(int resource) {
  rlimit limit{};
  getrlimit(resource, &limit);
  limit.rlim_cur = std::size_t{2} << 30;
  if (setrlimit(resource, &limit) != 0) std::exit(2);
  const char* const before = static_cast<char*>(sbrk(0));
  use_large_heap();
  std::exit(static_cast<char*>(sbrk(0)) - before > (1 << 20) ? 1 : 0);
}

TEST(LargeHeapDeathTest, LeavesMemoryToOthersWhereItIsLimited) {
  for (const int resource : {RLIMIT_AS, RLIMIT_DATA}) {
    EXPECT_EXIT(grow_with_limit(resource), testing::ExitedWithCode(0), "");
  }
}

}  // namespace
}  // namespace penumbra
