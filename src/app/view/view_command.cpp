#include "app/view/view_command.hpp"

#include <fmt/format.h>
#include <sysexits.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <system_error>

#include "base/say.hpp"

namespace penumbra {
namespace {

// Returns an exit code only if the window's program cannot be started.
int view_command(const std::vector<std::string>& arguments) {
  std::error_code error;
  const std::filesystem::path self = std::filesystem::read_symlink("/proc/self/exe", error);
  const std::string program = (self.parent_path() / "penumbra-view").string();
  std::vector<char*> words = {const_cast<char*>(program.c_str())};
  for (const std::string& argument : arguments) words.push_back(const_cast<char*>(argument.c_str()));
  words.push_back(nullptr);
  ::execv(program.c_str(), words.data());
  complain(fmt::format("the window's program `{}` cannot be started ({}); use `penumbra render SCENE.cli -o OUT.png`",
                       program, std::generic_category().message(errno)));
  return EX_UNAVAILABLE;
}

}  // namespace

Subcommand view_subcommand() {
  Subcommand view{"view", "Open a window to watch, change and inspect a picture", {}, {}, {}, {}, {}, {}};
  view.hand_over = view_command;
  return view;
}

}  // namespace penumbra
