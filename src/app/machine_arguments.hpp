// Options of how to render and not of what: they never change a picture.
#pragma once

namespace CLI {
class App;
}

namespace penumbra {

struct Kernel;

// Adds --threads (0: all there are) and --isa (null: the widest that can run here).
void add_machine_options(CLI::App& command, int& threads, const Kernel*& kernel);

}  // namespace penumbra
