// The options that change a picture, for every subcommand that makes one.
#pragma once

namespace CLI {
class App;
}

namespace penumbra {

struct PictureOptions;

// All but --crop and --noise. Parsing fills `options` and throws CLI::ParseError for what is no good.
void add_picture_options(CLI::App& command, PictureOptions& options);

// Those of them that say more or less of an effect.
void add_effect_options(CLI::App& command, PictureOptions& options);

}  // namespace penumbra
