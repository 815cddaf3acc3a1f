// PLY, text and binary: the elements `vertex` (x, y, z, nx, ny, nz), `face` and `tristrips` (vertex_indices); others
// are skipped. The layouts that nearly all binary files have (float positions and normals; one list of 32-bit indices)
// are read in bulk.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>

#include "language/ply_source.hpp"
#include "language/polygon.hpp"
#include "language/triangle_builder.hpp"

namespace penumbra {
namespace {

constexpr std::uint64_t largest_index = std::numeric_limits<std::uint32_t>::max();
constexpr std::uint32_t restart = largest_index;  // in place of a corner, where a strip ends and another one begins

// The place of a character of a text.
SourcePlace place_in_text(std::string_view text, const char* at) {
  LineCursor cursor(text);
  Line line;
  while (cursor.next(line) && line.text.data() + line.text.size() < at) continue;
  std::string_view rest = line.text.substr(std::min(line.text.size(), static_cast<std::size_t>(at - line.text.data())));
  const std::size_t column = static_cast<std::size_t>(rest.data() - line.text.data());
  const std::string_view word = take_word(rest);
  return place_of(0, line, line.text.substr(column, word.size()));
}

template <class Source>
class PlyBody {
 public:
  PlyBody(std::string_view bytes, const PlyHeader& header, Source source, MeshStore& mesh)
      : bytes_(bytes), header_(header), source_(source), mesh_(mesh), store_(mesh.store) {}

  std::optional<MeshError> read() {
    vertex_count_ = header_.find("vertex")->count;
    first_vertex_ = mesh_.first_vertex / 3;
    if (first_vertex_ + vertex_count_ > largest_index) return mesh_error("there are too many vertices");
    std::optional<Source> early_faces;  // those before the vertices wait for them
    bool has_vertices = false;
    for (const PlyElement& element : header_.elements) {
      has_vertices = has_vertices || element.name == "vertex";
      if (element.name == "face" && !has_vertices) early_faces = source_;
      if (!read_element(element, has_vertices)) return std::move(error_);
    }
    if (early_faces) {
      source_ = *early_faces;
      if (!read_element(*header_.find("face"), true)) return std::move(error_);
    }
    if (store_.indices.size() == mesh_.first_index) return mesh_error("this mesh has no faces");
    if (mesh_.normal_count() > 0) number_normals();
    return std::nullopt;
  }

 private:
  bool fail(const char* at, std::string message) {
    if constexpr (Source::is_binary) {
      error_ = mesh_error(fmt::format("{} (at byte {} of the file)", message, at - bytes_.data()));
    } else {
      error_ = MeshError{place_in_text(bytes_, at), std::move(message)};
    }
    return false;
  }

  // Reports that a number is missing.
  bool fail_at_number(const PlyElement& element, std::uint64_t i) {
    const char* const at = source_.at();
    if (Source::is_binary || at == bytes_.data() + bytes_.size()) {
      return fail(
          at, fmt::format("the file ends in element {} of {} of {}", i + 1, element.count, in_quotes(element.name)));
    }
    return fail(at, fmt::format("element {} of {} should have a number here", i + 1, in_quotes(element.name)));
  }

  static bool is_strips(const PlyElement& element) { return element.name == "tristrips"; }
  static std::string_view kind_of(const PlyElement& element) { return is_strips(element) ? "strip" : "face"; }

  bool read_element(const PlyElement& element, bool has_vertices) {
    std::size_t least = 0;
    for (const PlyProperty& p : element.properties) least += Source::least_size(p.is_list ? p.count_type : p.type);
    if (least > 0 && element.count > source_.remaining() / least) {
      return fail(source_.at(), fmt::format("{} elements {} do not fit into the remaining {} bytes", element.count,
                                            in_quotes(element.name), source_.remaining()));
    }
    if (element.name == "vertex") return read_vertices(element, least);
    if (is_strips(element) || (element.name == "face" && has_vertices)) return read_faces(element, least);
    if (least == 0) return true;
    for (std::uint64_t i = 0; i < element.count; i++) {
      if (!skip_properties(element, i, 0, element.properties.size())) return false;
    }
    return true;
  }

  bool skip_properties(const PlyElement& element, std::uint64_t i, std::size_t from, std::size_t to) {
    for (std::size_t k = from; k < to; k++) {
      const PlyProperty& property = element.properties[k];
      std::uint64_t count = 1;
      if (property.is_list && !read_length(element, property.count_type, i, count)) return false;
      if (!source_.skip(property.type, count)) return fail_at_number(element, i);
    }
    return true;
  }

  // Reads the length of a list; one that cannot fit into the rest of the file is an error here already.
  bool read_length(const PlyElement& element, PlyType type, std::uint64_t i, std::uint64_t& length) {
    const char* const at = source_.at();
    double value = 0;
    if (!source_.read(type, value)) return fail_at_number(element, i);
    if (!(value >= 0) || value != std::floor(value))
      return fail(at, fmt::format("a list cannot have length {}", value));
    if (value > static_cast<double>(source_.remaining())) {
      return fail(
          at, fmt::format("a list of {} numbers does not fit into the remaining {} bytes", value, source_.remaining()));
    }
    length = static_cast<std::uint64_t>(value);
    return true;
  }

  // The corners of a face have the normals of their vertices, if all of these have one.
  void number_normals() {
    store_.normal_numbers.reserve(mesh_.first_normal_number + store_.indices.size() - mesh_.first_index);
    for (std::size_t i = mesh_.first_index; i < store_.indices.size(); i += 3) {
      std::uint32_t number[3];
      for (std::size_t k = 0; k < 3; k++) number[k] = mesh_.normal_number(store_.indices[i + k] - first_vertex_);
      const bool smooth = number[0] != 0 && number[1] != 0 && number[2] != 0;
      for (const std::uint32_t n : number) store_.normal_numbers.push_back(smooth ? n : 0);
    }
  }

  // False if the position cannot be stored.
  bool store_vertex(float*& out, const double (&value)[6]) {
    const Vec3 position = transform_point(mesh_.matrix, {value[0], value[1], value[2]});
    *out++ = static_cast<float>(position.x);
    *out++ = static_cast<float>(position.y);
    *out++ = static_cast<float>(position.z);
    if (has_normals_) mesh_.add_normal({value[3], value[4], value[5]});
    return fits_single_precision(position);
  }

  bool read_vertices(const PlyElement& element, std::size_t stride) {
    const std::array place{element.find("x"),  element.find("y"),  element.find("z"),
                           element.find("nx"), element.find("ny"), element.find("nz")};
    const auto is_there = [&](int k) { return k >= 0 && !element.properties[static_cast<std::size_t>(k)].is_list; };
    if (!std::all_of(place.begin(), place.begin() + 3, is_there)) {
      return fail(source_.at(), "the vertices of this PLY file have no x, y and z");
    }
    has_normals_ = !mesh_.flat && std::all_of(place.begin() + 3, place.end(), is_there);
    const std::span<const int> axis(place.data(), has_normals_ ? 6 : 3);
    bool bulk = Source::is_binary;
    for (const int k : axis) bulk = bulk && element.properties[static_cast<std::size_t>(k)].type == PlyType::float32;
    for (const PlyProperty& p : element.properties) bulk = bulk && !p.is_list;
    store_.vertices.resize(mesh_.first_vertex + 3 * element.count);
    if (has_normals_) store_.normals.reserve(mesh_.first_normal + 3 * element.count);
    float* out = store_.vertices.data() + mesh_.first_vertex;
    if constexpr (Source::is_binary) {
      if (bulk) return read_vertices_in_bulk(element, stride, axis, out);
    }
    for (std::uint64_t i = 0; i < element.count; i++) {
      double value[6] = {};
      const char* const at = source_.at();
      for (std::size_t k = 0; k < element.properties.size(); k++) {
        const auto which = static_cast<std::size_t>(std::ranges::find(axis, static_cast<int>(k)) - axis.begin());
        if (which < axis.size() && source_.read(element.properties[k].type, value[which])) continue;
        if (which < 3) return fail_at_number(element, i);
        if (!skip_properties(element, i, k, k + 1)) return false;  // or a normal that is no number
        if (which < axis.size()) value[which] = std::numeric_limits<double>::quiet_NaN();
      }
      if (!store_vertex(out, value)) return fail(at, fmt::format("vertex {} is not finite", i));
    }
    return true;
  }

  // Binary vertices without lists, with positions and normals in single precision.
  bool read_vertices_in_bulk(const PlyElement& element, std::size_t stride, std::span<const int> axis,
                             float* out) requires Source::is_binary {
    std::size_t offset[6] = {};
    for (std::size_t a = 0; a < axis.size(); a++) {
      for (int k = 0; k < axis[a]; k++) offset[a] += size_of(element.properties[static_cast<std::size_t>(k)].type);
    }
    const char* p = source_.at();
    for (std::uint64_t i = 0; i < element.count; i++, p += stride) {
      double value[6] = {};
      for (std::size_t a = 0; a < axis.size(); a++) value[a] = load_number<float>(p + offset[a], source_.swapped());
      if (!store_vertex(out, value)) return fail(p, fmt::format("vertex {} is not finite", i));
    }
    source_.advance(stride * element.count);
    return true;
  }

  bool read_faces(const PlyElement& element, std::size_t least) {
    int list = element.find("vertex_indices");
    if (list < 0) list = element.find("vertex_index");
    if (list < 0 || !element.properties[static_cast<std::size_t>(list)].is_list) {
      return fail(source_.at(),
                  fmt::format("the {}s of this PLY file have no list `vertex_indices`", kind_of(element)));
    }
    const PlyProperty& corners = element.properties[static_cast<std::size_t>(list)];
    const std::uint64_t size = least + 3 * Source::least_size(corners.type);
    store_.indices.reserve(store_.indices.size() + 3 * std::min(element.count, source_.remaining() / size + 1));
    const bool bulk = element.properties.size() == 1 && !is_strips(element) && corners.count_type == PlyType::uint8 &&
                      (corners.type == PlyType::int32 || corners.type == PlyType::uint32);
    std::uint64_t i = 0;
    if constexpr (Source::is_binary) {
      if (bulk) i = read_triangles_in_bulk(element.count);
    }
    for (; i < element.count; i++) {
      const auto k = static_cast<std::size_t>(list);
      if (!skip_properties(element, i, 0, k) ||
          !(is_strips(element) ? read_strip(element, corners, i) : read_face(element, corners, i)) ||
          !skip_properties(element, i, k + 1, element.properties.size())) {
        return false;
      }
    }
    return true;
  }

  // Reads faces while each is a triangle with valid corners, and returns how many; the general way finds any error.
  std::uint64_t read_triangles_in_bulk(std::uint64_t count) requires Source::is_binary {
    constexpr std::size_t stride = 13;
    count = std::min<std::uint64_t>({count, source_.remaining() / stride, largest_index - store_.triangle_count()});
    const std::size_t before = store_.indices.size();
    store_.indices.resize(before + 3 * count);
    std::uint32_t* out = store_.indices.data() + before;
    const char* p = source_.at();
    const auto first = static_cast<std::uint32_t>(first_vertex_);
    std::uint64_t i = 0;
    for (; i < count; i++, p += stride, out += 3) {
      if (*p != 3) break;
      const auto a = load_number<std::uint32_t>(p + 1, source_.swapped());
      const auto b = load_number<std::uint32_t>(p + 5, source_.swapped());
      const auto c = load_number<std::uint32_t>(p + 9, source_.swapped());
      if (std::max({a, b, c}) >= vertex_count_) break;
      out[0] = first + a;
      out[1] = first + b;
      out[2] = first + c;
    }
    store_.indices.resize(before + 3 * i);
    source_.advance(stride * i);
    return i;
  }

  bool read_face(const PlyElement& element, const PlyProperty& corners, std::uint64_t i) {
    const char* const at = source_.at();
    std::uint64_t count = 0;
    if (!read_length(element, corners.count_type, i, count)) return false;
    if (count < 3) return fail(at, fmt::format("face {} has {} corners; it needs at least three", i, count));
    corners_.clear();
    for (std::uint64_t k = 0; k < count; k++) {
      if (!read_corner(element, corners.type, i, corners_.emplace_back())) return false;
    }
    std::string problem = append_polygon(store_, corners_);
    return problem.empty() || fail(at, std::move(problem));
  }

  // Each corner makes a triangle with the two before it, every other one the other way round. Those that only lead on,
  // with a corner twice, are left out.
  bool read_strip(const PlyElement& element, const PlyProperty& corners, std::uint64_t i) {
    const char* const at = source_.at();
    std::uint64_t count = 0, length = 0;
    if (!read_length(element, corners.count_type, i, count)) return false;
    std::uint32_t a = 0, b = 0, c = 0;
    for (; count > 0; count--, a = b, b = c) {
      if (!read_corner(element, corners.type, i, c)) return false;
      length = c == restart ? 0 : length + 1;
      if (length < 3 || a == b || b == c || c == a) continue;
      if (store_.triangle_count() >= largest_index) return fail(at, "there are too many triangles");
      const bool other_way = length % 2 == 0;
      for (const std::uint32_t corner : {other_way ? b : a, other_way ? a : b, c}) store_.indices.push_back(corner);
    }
    return true;
  }

  bool read_corner(const PlyElement& element, PlyType type, std::uint64_t i, std::uint32_t& index) {
    const char* const at = source_.at();
    double value = 0;
    if (!source_.read(type, value)) return fail_at_number(element, i);
    index = restart;
    if (is_strips(element) && value == -1) return true;
    if (!(value >= 0) || value >= static_cast<double>(vertex_count_) || value != std::floor(value)) {
      return fail(at, fmt::format("{} {} names vertex {}; there are {}, counted from 0", kind_of(element), i, value,
                                  vertex_count_));
    }
    index = static_cast<std::uint32_t>(first_vertex_ + static_cast<std::uint64_t>(value));
    return true;
  }

  std::string_view bytes_;
  const PlyHeader& header_;
  Source source_;
  MeshStore& mesh_;
  TriangleStore& store_;
  bool has_normals_ = false;
  std::uint64_t vertex_count_ = 0;
  std::uint64_t first_vertex_ = 0;
  std::vector<std::uint32_t> corners_;  // of the last face
  std::optional<MeshError> error_;
};

}  // namespace

std::optional<MeshError> read_ply(std::string_view bytes, MeshStore& mesh) {
  PlyHeader header;
  if (std::optional<MeshError> error = read_ply_header(bytes, header)) return error;
  if (header.find("vertex") == nullptr) return mesh_error("this PLY file has no vertices");
  if (header.find("face") == nullptr && header.find("tristrips") == nullptr)
    return mesh_error("this mesh has no faces");
  if (header.format == PlyFormat::ascii) {
    return PlyBody(bytes, header, PlyText(bytes, header.size), mesh).read();
  }
  const bool big_endian = header.format == PlyFormat::big_endian;
  return PlyBody(bytes, header, PlyBinary(bytes, header.size, big_endian), mesh).read();
}

}  // namespace penumbra
