// Wavefront OBJ: `v`, `vn` and `f`. A backslash at the end of a line continues the statement on the next one. Texture
// coordinates, groups, materials, lines and curves are skipped.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <vector>

#include "language/mesh.hpp"
#include "language/number.hpp"
#include "language/polygon.hpp"
#include "language/text_lines.hpp"
#include "language/triangle_builder.hpp"

namespace penumbra {
namespace {

constexpr std::array skipped{
    std::string_view{"vt"},         std::string_view{"vn"},        std::string_view{"vp"},
    std::string_view{"g"},          std::string_view{"o"},         std::string_view{"s"},
    std::string_view{"usemtl"},     std::string_view{"mtllib"},    std::string_view{"l"},
    std::string_view{"p"},          std::string_view{"usemap"},    std::string_view{"maplib"},
    std::string_view{"bevel"},      std::string_view{"lod"},       std::string_view{"c_interp"},
    std::string_view{"d_interp"},   std::string_view{"mg"},        std::string_view{"cstype"},
    std::string_view{"shadow_obj"}, std::string_view{"trace_obj"}, std::string_view{"deg"},
    std::string_view{"bmat"},       std::string_view{"step"},      std::string_view{"curv"},
    std::string_view{"curv2"},      std::string_view{"surf"},      std::string_view{"parm"},
    std::string_view{"trim"},       std::string_view{"hole"},      std::string_view{"scrv"},
    std::string_view{"sp"},         std::string_view{"end"},       std::string_view{"con"},
    std::string_view{"ctech"},      std::string_view{"stech"},     std::string_view{"call"},
};

class ObjReader {
 public:
  ObjReader(FileBytes& bytes, MeshStore& mesh)
      : bytes_(bytes), text_(bytes.view()), cursor_(text_), mesh_(mesh), store_(mesh.store) {}

  std::optional<MeshError> read() {
    progress_.total = text_.size();
    while (!error_ && cursor_.next(line_)) {
      read_statement();
      progress_.done = text_.size() - cursor_.remaining();
      bytes_.release_before(progress_.done);
    }
    if (!error_ && store_.indices.size() == mesh_.first_index) error_ = mesh_error("this mesh has no faces");
    return std::move(error_);
  }

 private:
  void fail(std::string_view part, std::string message) {
    error_ = MeshError{place_of(0, line_, part), std::move(message)};
  }
  void fail_statement(std::string message) {
    line_ = first_line_;
    fail(command_, std::move(message));
  }

  void read_statement() {
    rest_ = line_.text;
    command_ = next_word();
    first_line_ = line_;
    if (command_ == "v") {
      read_vertex();
    } else if (command_ == "vn" && !mesh_.flat) {
      read_normal();
    } else if (command_ == "f" || command_ == "fo") {
      read_face();
    } else if (!command_.empty() && std::find(skipped.begin(), skipped.end(), command_) == skipped.end()) {
      fail(command_, fmt::format("{} is not a statement of an OBJ file", in_quotes(command_)));
    }
    while (!error_ && is_continued() && cursor_.next(line_)) continue;
  }

  bool is_continued() const {
    std::string_view text = line_.text;
    while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
    return text.ends_with('\\') && text.find('#') == text.npos;
  }

  // The next word of the statement, on the next line if this one ends with a backslash; empty at its end.
  std::string_view next_word() {
    while (true) {
      std::string_view word = take_word(rest_);
      if (!word.ends_with('\\') || !std::all_of(rest_.begin(), rest_.end(), is_blank)) return word;
      if (word.size() > 1) {
        rest_ = word.substr(word.size() - 1);
        word.remove_suffix(1);
        return word;
      }
      rest_ = cursor_.next(line_) ? line_.text : std::string_view();
    }
  }

  void read_vertex() {
    std::array<double, 3> number{};
    for (double& value : number) {
      const std::string_view word = next_word();
      if (word.empty()) return fail_statement("`v` needs three numbers: x y z");
      const NumberError error = parse_number(word, value);
      if (error == NumberError::too_large)
        return fail(word, fmt::format("the number {} is too large", in_quotes(word)));
      if (error != NumberError::none) return fail(word, fmt::format("{} is not a number", in_quotes(word)));
    }
    const Vec3 position = transform_point(mesh_.matrix, {number[0], number[1], number[2]});
    if (!fits_single_precision(position)) return fail_statement("the current matrix moves this vertex too far away");
    make_room(store_.vertices, 3, progress_, mesh_.first_vertex);
    store_.vertices.push_back(static_cast<float>(position.x));
    store_.vertices.push_back(static_cast<float>(position.y));
    store_.vertices.push_back(static_cast<float>(position.z));
  }

  void read_normal() {
    std::array<double, 3> number{};
    for (double& value : number) {
      if (parse_number(next_word(), value) != NumberError::none) value = std::numeric_limits<double>::quiet_NaN();
    }
    make_room(store_.normals, 3, progress_, mesh_.first_normal);
    mesh_.add_normal({number[0], number[1], number[2]});
  }

  // Reads the number of a vertex or a normal at `p` and converts it to one that counts from 0; in the file, it counts
  // from 1, or backwards from -1.
  bool read_number(std::string_view word, const char*& p, std::string_view what, std::size_t given,
                   std::size_t& from_zero) {
    const auto count = static_cast<std::int64_t>(given);
    const char* const end = word.data() + word.size();
    const bool backwards = p != end && *p == '-';
    const char* const digits = p + backwards;
    std::int64_t value = 0;
    for (p = digits; p != end && *p >= '0' && *p <= '9' && p - digits < 18; p++) value = 10 * value + (*p - '0');
    if (backwards) value = -value;
    const bool is_number = p != digits && (p == end || *p == '/');
    if (!is_number || value == 0 || value < -count || value > count) {
      fail(word, is_number ? fmt::format("there is no {} {}; {} have been given so far", what, value, count)
                           : fmt::format("{} is not the number of a {}", in_quotes(word), what));
      return false;
    }
    from_zero = static_cast<std::size_t>(value > 0 ? value - 1 : value + count);
    return true;
  }

  // Reads `i`, `i/t`, `i//n` or `i/t/n`.
  bool read_corner(std::string_view word) {
    const char* p = word.data();
    std::size_t from_zero = 0;
    if (!read_number(word, p, "vertex", (store_.vertices.size() - mesh_.first_vertex) / 3, from_zero)) return false;
    const std::uint64_t stored = mesh_.first_vertex / 3 + from_zero;
    corners_.push_back(static_cast<std::uint32_t>(stored));
    if (stored != corners_.back()) {
      fail(word, "there are too many vertices");
      return false;
    }
    const std::size_t slash =
        mesh_.flat || p == word.end() ? word.npos : word.find('/', static_cast<std::size_t>(p - word.data()) + 1);
    if (slash >= word.size() - 1) return true;
    p = word.data() + slash + 1;
    if (!read_number(word, p, "normal", mesh_.normal_count(), from_zero)) return false;
    if (const std::uint32_t number = mesh_.normal_number(from_zero)) normals_.push_back(number);
    return true;
  }

  void read_face() {
    corners_.clear();
    normals_.clear();
    for (std::string_view word = next_word(); !word.empty(); word = next_word()) {
      if (!read_corner(word)) return;
    }
    if (corners_.size() < 3) {
      return fail_statement(fmt::format("a face needs at least three corners; found {}", corners_.size()));
    }
    make_room(store_.indices, 3 * (corners_.size() - 2), progress_, mesh_.first_index);
    const bool smooth = normals_.size() == corners_.size();
    if (smooth) {
      mesh_.fill_normal_numbers();
      make_room(store_.normal_numbers, 3 * (corners_.size() - 2), progress_, mesh_.first_normal_number);
    } else {
      normals_.clear();
    }
    std::string problem = append_polygon(store_, corners_, normals_);
    if (!problem.empty()) fail_statement(std::move(problem));
  }

  FileBytes& bytes_;
  std::string_view text_;
  LineCursor cursor_;
  Line line_;
  std::string_view command_;  // the first word of the statement
  Line first_line_;           // where that is
  std::string_view rest_;     // of the line, behind the words taken so far
  MeshStore& mesh_;
  TriangleStore& store_;
  std::vector<std::uint32_t> corners_, normals_;  // of the last face
  ReadProgress progress_;
  std::optional<MeshError> error_;
};

}  // namespace

std::optional<MeshError> read_obj(FileBytes& bytes, MeshStore& mesh) { return ObjReader(bytes, mesh).read(); }

}  // namespace penumbra
