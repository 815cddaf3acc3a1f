// The layers of a picture, each once: films, what kernels add to them, files, `--aov` and EXR channels are loops over
// this table. To add a layer takes a row here and its case in tracing/film_packet.hpp: what a sample adds to its sums.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <iterator>
#include <string>
#include <string_view>

namespace penumbra {

enum class Layer : std::uint8_t { color, depth, normal, albedo, variance, samples };

// What the numbers of a layer are, of the samples of a pixel.
enum class LayerValue : std::uint8_t {
  mean,              // of all samples; 0 where there are none
  mean_of_hits,      // of those samples that hit anything, whose number is the last sum; infinity where none did
  variance_of_mean,  // of the mean of the colours: the sums are their squares; 0 below two samples
  sample_count       // which every film has: there are no sums
};

struct LayerRow {
  Layer layer;
  std::string_view name;      // for `--aov`; `name.X` is the EXR channel with the letter X
  std::string_view channels;  // a letter for each number of a pixel
  LayerValue value;

  // How many sums a film has for each pixel.
  constexpr int sums() const {
    if (value == LayerValue::sample_count) return 0;
    return static_cast<int>(channels.size()) + (value == LayerValue::mean_of_hits ? 1 : 0);
  }
};

// In the order of `Layer`.
inline constexpr LayerRow layer_table[] = {
    {Layer::color, "color", "RGB", LayerValue::mean},
    {Layer::depth, "depth", "Z", LayerValue::mean_of_hits},  // along the view
    {Layer::normal, "normal", "XYZ", LayerValue::mean},      // of the first hit, in the world
    {Layer::albedo, "albedo", "RGB", LayerValue::mean},      // the diffuse colour of the first hit
    {Layer::variance, "variance", "RGB", LayerValue::variance_of_mean},
    {Layer::samples, "samples", "Y", LayerValue::sample_count},
};

inline constexpr std::size_t layer_count = std::size(layer_table);

constexpr std::size_t index_of(Layer layer) { return static_cast<std::size_t>(layer); }
constexpr const LayerRow& row_of(Layer layer) { return layer_table[index_of(layer)]; }
static_assert([] {
  for (const LayerRow& row : layer_table) {
    if (&row_of(row.layer) != &row) return false;
  }
  return true;
}());

// Of a pixel that has all layers.
inline constexpr int most_sums = [] {
  int sums = 0;
  for (const LayerRow& row : layer_table) sums += row.sums();
  return sums;
}();

// Some of the layers; the colour is always among them.
class Layers {
 public:
  constexpr Layers() = default;
  constexpr Layers(std::initializer_list<Layer> layers) {
    for (const Layer layer : layers) add(layer);
  }

  constexpr void add(Layer layer) { bits_ |= 1u << index_of(layer); }
  constexpr bool has(Layer layer) const { return (bits_ >> index_of(layer) & 1) != 0; }
  // Whether there is any beside the colour.
  constexpr bool any() const { return *this != Layers(); }

  bool operator==(const Layers&) const = default;

 private:
  std::uint32_t bits_ = 1u << index_of(Layer::color);
};

// The layers that can be asked for: all but the colour.
inline constexpr auto layer_names = [] {
  std::array<std::string_view, layer_count - 1> names;
  for (std::size_t i = 0; i < names.size(); i++) names[i] = layer_table[i + 1].name;
  return names;
}();

// False if there is no layer of that name to ask for.
inline bool add_layer(Layers& layers, std::string_view name) {
  for (const LayerRow& row : layer_table) {
    if (row.layer == Layer::color || row.name != name) continue;
    layers.add(row.layer);
    return true;
  }
  return false;
}

// The names of the layers beside the colour, in the order of the table, with commas between them.
inline std::string to_string(const Layers& layers) {
  std::string names;
  for (const LayerRow& row : layer_table) {
    if (row.layer == Layer::color || !layers.has(row.layer)) continue;
    if (!names.empty()) names += ',';
    names += row.name;
  }
  return names;
}

}  // namespace penumbra
