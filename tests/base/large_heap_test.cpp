#include "base/large_heap.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <memory>
#include <sstream>
#include <string>
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

TEST(LargeHeap, BlocksLieInLargePages) {
  if (!std::filesystem::exists("/sys/kernel/mm/transparent_hugepage")) GTEST_SKIP() << "a kernel without large pages";
  use_large_heap();
  std::vector<std::unique_ptr<char[]>> blocks;
  for (const std::size_t size : {100 << 10, 1 << 20, 16 << 20, 50 << 20}) {
    blocks.push_back(std::make_unique<char[]>(size));
    blocks.back()[size - 1] = 1;
  }
  blocks.pop_back();  // larger than what the heap takes, so on its own
  for (const auto& block : blocks) EXPECT_TRUE(asked_for_large_pages(block.get()));
  const void* const last = blocks.back().get();
  blocks.pop_back();  // is kept, and given out again
  blocks.push_back(std::make_unique<char[]>(16 << 20));
  EXPECT_EQ(blocks.back().get(), last);
}

}  // namespace
}  // namespace penumbra
