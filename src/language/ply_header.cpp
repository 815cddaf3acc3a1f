#include "language/ply_header.hpp"

#include <fmt/format.h>

#include <array>
#include <utility>

#include "base/parse.hpp"
#include "language/text_lines.hpp"

namespace penumbra {
namespace {

using Named = std::pair<std::string_view, PlyType>;
constexpr std::array type_names{
    Named{"char", PlyType::int8},       Named{"int8", PlyType::int8},       Named{"uchar", PlyType::uint8},
    Named{"uint8", PlyType::uint8},     Named{"short", PlyType::int16},     Named{"int16", PlyType::int16},
    Named{"ushort", PlyType::uint16},   Named{"uint16", PlyType::uint16},   Named{"int", PlyType::int32},
    Named{"int32", PlyType::int32},     Named{"uint", PlyType::uint32},     Named{"uint32", PlyType::uint32},
    Named{"float", PlyType::float32},   Named{"float32", PlyType::float32}, Named{"double", PlyType::float64},
    Named{"float64", PlyType::float64},
};
constexpr std::size_t most_elements = 64;
constexpr std::size_t most_properties = 256;

class HeaderReader {
 public:
  HeaderReader(std::string_view bytes, PlyHeader& header) : bytes_(bytes), cursor_(bytes), header_(header) {}

  std::optional<MeshError> read() {
    cursor_.next(line_);
    bool has_format = false;
    while (!error_ && cursor_.next(line_)) {
      const Words words = split_words(line_.text);
      if (words.count == 0) continue;
      const std::string_view word = words.word[0];
      if (word == "end_header") {
        if (!has_format) fail(word, "the header of this PLY file has no `format` line");
        header_.size = bytes_.size() - cursor_.remaining();
        return std::move(error_);
      }
      if (word == "comment" || word == "obj_info") continue;
      if (word == "format") {
        has_format = true;
        read_format(words);
      } else if (word == "element") {
        read_element(words);
      } else if (word == "property") {
        read_property(words);
      } else {
        fail(word, fmt::format("{} is not a line of a PLY header", in_quotes(word)));
      }
    }
    if (!error_) error_ = mesh_error("the header of this PLY file does not end: there is no `end_header`");
    return std::move(error_);
  }

 private:
  void fail(std::string_view part, std::string message) {
    error_ = MeshError{place_of(0, line_, part), std::move(message)};
  }

  void read_format(const Words& words) {
    const std::string_view name = words.word[1];
    if (name == "ascii") {
      header_.format = PlyFormat::ascii;
    } else if (name == "binary_little_endian") {
      header_.format = PlyFormat::little_endian;
    } else if (name == "binary_big_endian") {
      header_.format = PlyFormat::big_endian;
    } else {
      fail(words.word[0], "the format of a PLY file is `ascii`, `binary_little_endian` or `binary_big_endian`");
    }
  }

  void read_element(const Words& words) {
    PlyElement element;
    element.name = words.word[1];
    const auto count = number_from<std::uint64_t>(words.word[2]);
    if (words.count != 3 || !count) {
      return fail(words.word[0], "`element` needs a name and a number of elements");
    }
    element.count = *count;
    if (header_.find(element.name) != nullptr) {
      return fail(words.word[1], fmt::format("the element {} is declared twice", in_quotes(element.name)));
    }
    if (header_.elements.size() >= most_elements) return fail(words.word[0], "there are too many elements");
    header_.elements.push_back(std::move(element));
  }

  bool read_type(std::string_view word, PlyType& type) {
    for (const auto& [name, named] : type_names) {
      if (name != word) continue;
      type = named;
      return true;
    }
    fail(word.empty() ? line_.text : word, fmt::format("{} is not a type of a PLY file", in_quotes(word)));
    return false;
  }

  void read_property(const Words& words) {
    if (header_.elements.empty()) return fail(words.word[0], "`property` before the first `element`");
    PlyProperty property;
    property.is_list = words.word[1] == "list";
    if (words.count != (property.is_list ? 5 : 3)) {
      return fail(words.word[0], "`property` needs a type and a name, or `list`, two types and a name");
    }
    const std::size_t type = property.is_list ? 3 : 1;
    if (property.is_list && !read_type(words.word[2], property.count_type)) return;
    if (!read_type(words.word[type], property.type)) return;
    if (property.is_list && is_float(property.count_type)) {
      return fail(words.word[2], "the length of a list has to be of an integer type");
    }
    property.name = words.word[type + 1];
    std::vector<PlyProperty>& properties = header_.elements.back().properties;
    if (properties.size() >= most_properties) return fail(words.word[0], "there are too many properties");
    properties.push_back(std::move(property));
  }

  std::string_view bytes_;
  LineCursor cursor_;
  PlyHeader& header_;
  Line line_;
  std::optional<MeshError> error_;
};

}  // namespace

int PlyElement::find(std::string_view property) const {
  for (std::size_t i = 0; i < properties.size(); i++) {
    if (properties[i].name == property) return static_cast<int>(i);
  }
  return -1;
}

const PlyElement* PlyHeader::find(std::string_view element) const {
  for (const PlyElement& candidate : elements) {
    if (candidate.name == element) return &candidate;
  }
  return nullptr;
}

std::optional<MeshError> read_ply_header(std::string_view bytes, PlyHeader& header) {
  return HeaderReader(bytes, header).read();
}

}  // namespace penumbra
