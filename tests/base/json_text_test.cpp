// JSON values and their text: each kind as RFC 8259 writes it, and back; what is not JSON, or not what was asked for,
// is an error with a sentence.
#include "base/json_text.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <set>

namespace penumbra {
namespace {

std::string problem(void (*use)()) {
  try {
    use();
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

Json json_from_text(std::string_view text) { return json_from(std::as_bytes(std::span(text))); }

TEST(JsonText, EachKindOfValue) {
  EXPECT_EQ(to_line({}), "null");
  EXPECT_EQ(to_line(true), "true");
  EXPECT_EQ(to_line(-7), "-7");
  EXPECT_EQ(to_line(std::size_t{1} << 62), "4611686018427387904");
  EXPECT_EQ(to_line(0.1), "0.1");
  EXPECT_EQ(to_line(3.0), "3.0");
  EXPECT_EQ(to_line(0.1f), "0.10000000149011612");
  EXPECT_EQ(to_line("a \"word\"\n"), R"("a \"word\"\n")");
  EXPECT_EQ(to_line(std::array{1, 2}), "[1,2]");
  EXPECT_EQ(to_line(std::set<int>{3, 1}), "[1,3]");
  EXPECT_EQ(to_line(std::vector<std::vector<std::string>>{{"a"}, {}}), R"([["a"],[]])");
  EXPECT_EQ(to_line(Json::object()), "{}");
}

TEST(JsonText, WhatIsNotFiniteIsNull) {
  EXPECT_EQ(to_line(std::array{HUGE_VAL, -HUGE_VAL, std::nan("")}), "[null,null,null]");
}

TEST(JsonText, MembersKeepTheirOrder) {
  Json json;
  json["z"] = 1;
  json["a"]["inner"] = Json::object({{"x", 2}, {"w", 3}});
  json["z"] = "other";
  EXPECT_EQ(to_line(json), R"({"z":"other","a":{"inner":{"x":2,"w":3}}})");
  EXPECT_EQ(to_text(json),
            "{\n  \"z\": \"other\",\n  \"a\": {\n    \"inner\": {\n      \"x\": 2,\n      \"w\": 3\n    }\n  }\n}");
}

TEST(JsonText, BytesThatAreNotUtf8) {
  EXPECT_EQ(to_line("a\xff"), R"("a\ufffd")");
  EXPECT_THROW(to_text("a\xff", BadText::refused), std::invalid_argument);
}

TEST(JsonText, IsReadAgain) {
  const std::string text =
      R"({"b":[1,-2,9223372036854775807,9223372036854775808,0.1,1e300,true,null,"\u00e4"],"a":{"c":{}}})";
  EXPECT_EQ(to_line(json_from_text(text)),
            R"({"b":[1,-2,9223372036854775807,9.223372036854776e+18,0.1,1e+300,true,null,"\u00e4"],"a":{"c":{}}})");
  for (const double value : {0.1, 1.0 / 3, 5e-324, 1.7976931348623157e308, -0.0, 12345678901234567.0}) {
    EXPECT_EQ(json_from_text(to_line(value)).as<double>(), value);
  }
}

TEST(JsonText, ValuesAreTakenOut) {
  const Json json = json_from_text(R"({"n": 12, "x": 2.5, "yes": true, "word": "w", "list": [[3, 1], []]})");
  EXPECT_EQ(json.at("n").as<int>(), 12);
  EXPECT_EQ(json.at("n").as<double>(), 12);
  EXPECT_EQ(json.at("x").as<double>(), 2.5);
  EXPECT_TRUE(json.at("yes").as<bool>());
  EXPECT_EQ(json.at("word").as<std::string>(), "w");
  EXPECT_EQ(json.at("list").as<std::vector<std::set<int>>>(), (std::vector<std::set<int>>{{1, 3}, {}}));
  EXPECT_TRUE(json.contains("x"));
  EXPECT_FALSE(json.contains("y"));
}

TEST(JsonText, WhatIsOfAnotherKindIsRefused) {
  EXPECT_EQ(problem([] { json_from_text("{}").at("x"); }), "there is no `x`");
  EXPECT_EQ(problem([] { json_from_text("[]").at("x"); }), "expected an object, found an array");
  EXPECT_EQ(problem([] { json_from_text("\"1\"").as<int>(); }), "expected a whole number, found a text");
  EXPECT_EQ(problem([] { json_from_text("1.5").as<int>(); }), "expected a whole number, found a number");
  EXPECT_EQ(problem([] { json_from_text("null").as<double>(); }), "expected a number, found null");
  EXPECT_EQ(problem([] { json_from_text("[1, true]").as<std::vector<int>>(); }),
            "expected a whole number, found true or false");
  EXPECT_EQ(problem([] { json_from_text("2147483648").as<int>(); }), "a whole number is too large");
}

TEST(JsonText, WhatIsNotJsonIsRefused) {
  for (const char* text : {"", "{", "[1,]", "{\"a\" 1}", "nul", "1 2", "\"\xff\""}) {
    EXPECT_THROW(json_from_text(text), std::invalid_argument) << text;
  }
  EXPECT_NO_THROW(json_from_text(std::string(100, '[') + std::string(100, ']')));
  EXPECT_THROW(json_from_text(std::string(1'000'000, '[') + std::string(1'000'000, ']')), std::invalid_argument);
}

}  // namespace
}  // namespace penumbra
