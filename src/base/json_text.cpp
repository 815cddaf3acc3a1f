#include "base/json_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

namespace penumbra {
namespace {

using Library = nlohmann::ordered_json;

constexpr int deepest = 100;

auto find(const Json::Object& members, std::string_view name) {
  return std::find_if(members.begin(), members.end(), [&](const Json::Member& member) { return member.first == name; });
}

Library to_library(const Json& json) {
  return std::visit(
      [](const auto& value) -> Library {
        using Kind = std::decay_t<decltype(value)>;
        if constexpr (std::is_same_v<Kind, std::monostate>) {
          return nullptr;
        } else if constexpr (std::is_same_v<Kind, Json::Array>) {
          Library array = Library::array();
          for (const Json& element : value) array.push_back(to_library(element));
          return array;
        } else if constexpr (std::is_same_v<Kind, Json::Object>) {
          Library object = Library::object();
          for (const auto& [name, element] : value) object[name] = to_library(element);
          return object;
        } else {
          return value;
        }
      },
      json.value());
}

Json from_library(const Library& value, int depth) {
  if (depth > deepest) throw std::invalid_argument("it is nested too deep");
  switch (value.type()) {
    case Library::value_t::boolean:
      return value.get<bool>();
    case Library::value_t::number_integer:
      return value.get<std::int64_t>();
    case Library::value_t::number_unsigned: {
      const auto whole = value.get<std::uint64_t>();
      return whole <= INT64_MAX ? Json(whole) : Json(static_cast<double>(whole));
    }
    case Library::value_t::number_float:
      return value.get<double>();
    case Library::value_t::string:
      return value.get<std::string>();
    case Library::value_t::array: {
      Json::Array array;
      for (const Library& element : value) array.push_back(from_library(element, depth + 1));
      return array;
    }
    case Library::value_t::object: {
      Json object = Json::object();
      for (const auto& [name, element] : value.items()) object[name] = from_library(element, depth + 1);
      return object;
    }
    default:
      return {};
  }
}

std::string dump(const Json& json, int indent, BadText bad_text) {
  try {
    return to_library(json).dump(
        indent, ' ', true,
        bad_text == BadText::replaced ? Library::error_handler_t::replace : Library::error_handler_t::strict);
  } catch (const Library::exception& error) {
    throw std::invalid_argument(error.what());
  }
}

}  // namespace

Json Json::object(std::initializer_list<Member> members) {
  Json json;
  json.value_ = Object(members);
  return json;
}

Json& Json::operator[](std::string_view name) {
  if (std::holds_alternative<std::monostate>(value_)) value_ = Object();
  auto& members = std::get<Object>(value_);
  if (const auto place = find(members, name); place != members.end()) {
    return members[static_cast<std::size_t>(place - members.begin())].second;
  }
  return members.emplace_back(std::string(name), Json()).second;
}

const Json& Json::at(std::string_view name) const {
  const auto& members = get<Object>();
  const auto place = find(members, name);
  if (place == members.end()) throw std::invalid_argument(fmt::format("there is no `{}`", name));
  return place->second;
}

bool Json::contains(std::string_view name) const {
  const auto& members = get<Object>();
  return find(members, name) != members.end();
}

template <class Kind>
const Kind& Json::get() const {
  if (const Kind* const value = std::get_if<Kind>(&value_)) return *value;
  constexpr const char* kinds[] = {"null",   "true or false", "a whole number", "a number",
                                   "a text", "an array",      "an object"};
  throw std::invalid_argument(
      fmt::format("expected {}, found {}", kinds[Value(Kind()).index()], kinds[value_.index()]));
}
template const bool& Json::get() const;
template const std::int64_t& Json::get() const;
template const std::string& Json::get() const;
template const Json::Array& Json::get() const;

double Json::number() const {
  if (const auto* whole = std::get_if<std::int64_t>(&value_)) return static_cast<double>(*whole);
  return get<double>();
}

std::string to_text(const Json& json, BadText bad_text) { return dump(json, 2, bad_text); }
std::string to_line(const Json& json) { return dump(json, -1, BadText::replaced); }

Json json_from(std::span<const std::byte> text) {
  try {
    return from_library(Library::parse(text), 0);
  } catch (const Library::exception& error) {
    throw std::invalid_argument(error.what());
  }
}

}  // namespace penumbra
