// JSON (RFC 8259) as plain values and as text, as far as the reports and the files of the farm need it. nlohmann/json,
// whose header is slow to compile and therefore included only in json_text.cpp, reads and writes the text.
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace penumbra {

class Json {
 public:
  using Member = std::pair<std::string, Json>;
  using Array = std::vector<Json>;
  using Object = std::vector<Member>;  // in the order in which the members were added
  using Value = std::variant<std::monostate, bool, std::int64_t, double, std::string, Array, Object>;

  Json() = default;  // null
  Json(bool value) : value_(value) {}
  Json(double value) : value_(value) {}  // null in the text if it is not finite
  Json(std::string value) : value_(std::move(value)) {}
  Json(std::string_view value) : value_(std::string(value)) {}
  Json(const char* value) : value_(std::string(value)) {}
  Json(Array values) : value_(std::move(values)) {}
  template <std::integral Number>
  Json(Number value) : value_(static_cast<std::int64_t>(value)) {}
  // An array of the elements of a container.
  template <class Values, class = typename Values::const_iterator>
  Json(const Values& values) : value_(Array(values.begin(), values.end())) {}
  static Json object(std::initializer_list<Member> members = {});

  // The member of that name; adds it if it is missing. Null becomes an object.
  Json& operator[](std::string_view name);

  // These throw std::invalid_argument if the value is of another kind or the member is missing.
  const Json& at(std::string_view name) const;
  bool contains(std::string_view name) const;
  // As bool, int, double, std::string, or a container of these.
  template <class Result>
  Result as() const {
    if constexpr (std::is_same_v<Result, int>) {
      const std::int64_t whole = get<std::int64_t>();
      if (whole == static_cast<int>(whole)) return static_cast<int>(whole);
      throw std::invalid_argument("a whole number is too large");
    } else if constexpr (std::is_same_v<Result, double>) {
      return number();
    } else if constexpr (std::is_same_v<Result, bool> || std::is_same_v<Result, std::string>) {
      return get<Result>();
    } else {
      Result values;
      for (const Json& value : get<Array>()) values.insert(values.end(), value.as<typename Result::value_type>());
      return values;
    }
  }

  template <class Result>
  void get_to(Result& result) const {
    result = as<Result>();
  }

  const Value& value() const { return value_; }

 private:
  template <class Kind>
  const Kind& get() const;
  double number() const;

  Value value_;
};

// How to treat a string that is not UTF-8, as JSON requires: replace the invalid bytes or throw.
enum class BadText { replaced, refused };

// The value as ASCII text, on several lines with an indentation of two, or on one line. Throws std::invalid_argument if
// a string is refused.
std::string to_text(const Json& json, BadText bad_text = BadText::replaced);
std::string to_line(const Json& json);

// Parses a text. Throws std::invalid_argument with the reason and its position, also if arrays and objects are nested
// deeper than 100.
Json json_from(std::span<const std::byte> text);

}  // namespace penumbra
