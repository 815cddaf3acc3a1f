// PLY, text and binary: the elements `vertex` (x, y, z), `face` and `tristrips` (vertex_indices); others are skipped.
// The layouts that nearly all binary files have (float positions; one list of 32-bit indices) are read in bulk.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

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
  PlyBody(std::string_view bytes, const PlyHeader& header, Source source, const Affine& matrix, TriangleStore& store)
      : bytes_(bytes), header_(header), source_(source), matrix_(matrix), store_(store) {}

  std::optional<MeshError> read() {
    vertex_count_ = header_.find("vertex")->count;
    first_vertex_ = store_.vertices.size() / 3;
    const std::size_t indices_before = store_.indices.size();
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
    if (store_.indices.size() == indices_before) return mesh_error("this mesh has no faces");
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

  void store_vertex(float*& out, Vec3 position) {
    *out++ = static_cast<float>(position.x);
    *out++ = static_cast<float>(position.y);
    *out++ = static_cast<float>(position.z);
  }

  bool read_vertices(const PlyElement& element, std::size_t stride) {
    const int axis[3] = {element.find("x"), element.find("y"), element.find("z")};
    bool bulk = Source::is_binary;
    for (const int k : axis) {
      if (k < 0 || element.properties[static_cast<std::size_t>(k)].is_list) {
        return fail(source_.at(), "the vertices of this PLY file have no x, y and z");
      }
      bulk = bulk && element.properties[static_cast<std::size_t>(k)].type == PlyType::float32;
    }
    for (const PlyProperty& p : element.properties) bulk = bulk && !p.is_list;
    const std::size_t before = store_.vertices.size();
    store_.vertices.resize(before + 3 * element.count);
    float* out = store_.vertices.data() + before;
    if constexpr (Source::is_binary) {
      if (bulk) return read_vertices_in_bulk(element, stride, axis, out);
    }
    for (std::uint64_t i = 0; i < element.count; i++) {
      double value[3] = {};
      const char* const at = source_.at();
      for (std::size_t k = 0; k < element.properties.size(); k++) {
        const auto which = std::find(axis, axis + 3, static_cast<int>(k));
        if (which == axis + 3) {
          if (!skip_properties(element, i, k, k + 1)) return false;
        } else if (!source_.read(element.properties[k].type, value[which - axis])) {
          return fail_at_number(element, i);
        }
      }
      const Vec3 position = transform_point(matrix_, {value[0], value[1], value[2]});
      if (!fits_single_precision(position)) return fail(at, fmt::format("vertex {} is not finite", i));
      store_vertex(out, position);
    }
    return true;
  }

  // Binary vertices without lists, with positions in single precision.
  bool read_vertices_in_bulk(const PlyElement& element, std::size_t stride, const int (&axis)[3],
                             float* out) requires Source::is_binary {
    std::size_t offset[3] = {};
    for (int a = 0; a < 3; a++) {
      for (int k = 0; k < axis[a]; k++) offset[a] += size_of(element.properties[static_cast<std::size_t>(k)].type);
    }
    const char* p = source_.at();
    for (std::uint64_t i = 0; i < element.count; i++, p += stride) {
      const Vec3 position = transform_point(matrix_, {load_number<float>(p + offset[0], source_.swapped()),
                                                      load_number<float>(p + offset[1], source_.swapped()),
                                                      load_number<float>(p + offset[2], source_.swapped())});
      if (!fits_single_precision(position)) return fail(p, fmt::format("vertex {} is not finite", i));
      store_vertex(out, position);
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
  const Affine& matrix_;
  TriangleStore& store_;
  std::uint64_t vertex_count_ = 0;
  std::uint64_t first_vertex_ = 0;
  std::vector<std::uint32_t> corners_;  // of the last face
  std::optional<MeshError> error_;
};

}  // namespace

std::optional<MeshError> read_ply(std::string_view bytes, const Affine& matrix, TriangleStore& store) {
  PlyHeader header;
  if (std::optional<MeshError> error = read_ply_header(bytes, header)) return error;
  if (header.find("vertex") == nullptr) return mesh_error("this PLY file has no vertices");
  if (header.find("face") == nullptr && header.find("tristrips") == nullptr)
    return mesh_error("this mesh has no faces");
  if (header.format == PlyFormat::ascii) {
    return PlyBody(bytes, header, PlyText(bytes, header.size), matrix, store).read();
  }
  const bool big_endian = header.format == PlyFormat::big_endian;
  return PlyBody(bytes, header, PlyBinary(bytes, header.size, big_endian), matrix, store).read();
}

}  // namespace penumbra
