// The program: parses the command line, runs one subcommand and returns its exit code (those of <sysexits.h>).
#include "app/check/check_command.hpp"
#include "app/compare/compare_command.hpp"
#include "app/farm/farm_command.hpp"
#include "app/merge/merge_command.hpp"
#include "app/options/render_options.hpp"
#include "app/samples/samples_command.hpp"
#include "app/view/view_command.hpp"

int main(int argc, char** argv) {
  using namespace penumbra;
  RenderOptions render;
  CheckOptions check;
  CompareOptions compare;
  SamplesOptions samples;
  MergeOptions merge;
  FarmOptions farm;
  Subcommand program{"penumbra", "Penumbra, a distribution ray tracer for .cli scenes", {}, {}, {}, {}, {}, {}};
  program.subcommands = {render_subcommand(render),
                         check_subcommand(check),
                         compare_subcommand(compare),
                         samples_subcommand(samples),
                         merge_subcommand(merge),
                         farm_subcommand(farm),
                         view_subcommand()};
  return run_command_line(program, argc, argv);
}
