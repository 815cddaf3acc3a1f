#include "app/view_command.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <system_error>

namespace penumbra {
namespace {

constexpr int exit_unavailable = 69;

}  // namespace

int view_command(const std::vector<std::string>& arguments) {
  std::error_code error;
  const std::filesystem::path self = std::filesystem::read_symlink("/proc/self/exe", error);
  const std::string program = (self.parent_path() / window_program).string();
  std::vector<char*> words = {const_cast<char*>(program.c_str())};
  for (const std::string& argument : arguments) words.push_back(const_cast<char*>(argument.c_str()));
  words.push_back(nullptr);
  ::execv(program.c_str(), words.data());
  fmt::print(stderr,
             "penumbra: the window's program `{}` cannot be started ({}); use `penumbra render SCENE.cli -o OUT.png`\n",
             program, std::generic_category().message(errno));
  return exit_unavailable;
}

}  // namespace penumbra
