#include "language/other_programs.hpp"

#include <algorithm>
#include <array>

namespace penumbra {
namespace {

constexpr std::array commands{
    std::string_view{"ambient_light"},
    std::string_view{"area_light"},
    std::string_view{"begin_bvh"},
    std::string_view{"begin_grid"},
    std::string_view{"begin_kd"},
    std::string_view{"bump"},
    std::string_view{"caustic_photons"},
    std::string_view{"cone"},
    std::string_view{"debug"},
    std::string_view{"diffuse_photons"},
    std::string_view{"directional_light"},
    std::string_view{"end_bvh"},
    std::string_view{"end_grid"},
    std::string_view{"end_kd"},
    std::string_view{"environment"},
    std::string_view{"final_gather"},
    std::string_view{"hollow_cone"},
    std::string_view{"image_texture"},
    std::string_view{"load_identity"},
    std::string_view{"mesh_texture"},
    std::string_view{"normal"},
    std::string_view{"photons"},
    std::string_view{"plane"},
    std::string_view{"print"},
    std::string_view{"print_matrix"},
    std::string_view{"quad"},
    std::string_view{"resolution"},
    std::string_view{"save"},
    std::string_view{"screen"},
    std::string_view{"square_light"},
    std::string_view{"supersample"},
    std::string_view{"texture"},
    std::string_view{"texture_map"},
    std::string_view{"torus"},
    std::string_view{"triangle"},
    std::string_view{"wait"},
};

}  // namespace

bool is_command_of_other_programs(std::string_view word) {
  return std::find(commands.begin(), commands.end(), word) != commands.end();
}

}  // namespace penumbra
