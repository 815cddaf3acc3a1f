#include "language/number.hpp"

#include <gtest/gtest.h>

#include <clocale>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <string>

namespace penumbra {
namespace {

double value_of(const std::string& word) {
  double value = -12345;
  EXPECT_EQ(parse_number(word, value), NumberError::none) << word;
  return value;
}

NumberError error_of(const std::string& word) {
  double value = 0;
  return parse_number(word, value);
}

TEST(Number, readsEveryWayToWriteOne) {
  EXPECT_EQ(value_of("0"), 0.0);
  EXPECT_EQ(value_of("2"), 2.0);
  EXPECT_EQ(value_of("-2"), -2.0);
  EXPECT_EQ(value_of("+2"), 2.0);
  EXPECT_EQ(value_of(".5"), 0.5);
  EXPECT_EQ(value_of("-.5"), -0.5);
  EXPECT_EQ(value_of("5."), 5.0);
  EXPECT_EQ(value_of("1e-3"), 1e-3);
  EXPECT_EQ(value_of("1E+3"), 1e3);
  EXPECT_EQ(value_of("1.25e2"), 125.0);
  EXPECT_EQ(value_of("000.125"), 0.125);
  EXPECT_TRUE(std::signbit(value_of("-0")));
}

TEST(Number, refusesWhatIsNone) {
  for (const char* word :
       {"",         "-",    "+",     ".",   "-.",    "e5",  "1e",  "1e+",   "1e-",   "nan", "NaN", "inf", "-inf",
        "infinity", "0x10", "1.2.3", "1,5", "12abc", "--1", "+-1", "1e5.5", "1_000", "1f",  "0b1", "½"}) {
    EXPECT_EQ(error_of(word), NumberError::not_a_number) << word;
  }
}

TEST(Number, refusesWhatSinglePrecisionCannotHold) {
  for (const char* word : {"3.5e38", "-3.5e38", "1e39", "1e400", "-1e400", "1e99999999999999999999",
                           "340282366920938463463374607431768211456000", "12345678901234567890123e30"}) {
    EXPECT_EQ(error_of(word), NumberError::too_large) << word;
  }
  EXPECT_EQ(value_of("3.4e38"), 3.4e38);
  EXPECT_EQ(error_of("1" + std::string(500, '0')), NumberError::too_large);
}

TEST(Number, takesWhatIsTooSmallAsZero) {
  EXPECT_EQ(value_of("1e-400"), 0.0);
  EXPECT_TRUE(std::signbit(value_of("-1e-400")));
  EXPECT_EQ(value_of("0." + std::string(500, '0') + "1"), 0.0);
  EXPECT_EQ(value_of("1e-99999999999999999999"), 0.0);
  EXPECT_EQ(value_of("0e99999999999999999999"), 0.0);
}

TEST(Number, keepsLongNumbersExact) {
  EXPECT_EQ(value_of("0.1000000000000000055511151231257827"), 0.1);
  EXPECT_EQ(value_of("9007199254740993"), 9007199254740992.0);
  EXPECT_EQ(value_of("9007199254740993.00000000000000000001"), 9007199254740994.0);
  EXPECT_EQ(value_of("1" + std::string(500, '0') + "e-500"), 1.0);
}

TEST(Number, roundsAsTheCLibraryDoes) {
  std::mt19937_64 random(7);
  const char* const formats[] = {"%.6f", "%.3g", "%.17g", "%.9e", "%.12f", "%.0f", "%.25g"};
  std::uniform_int_distribution<int> exponent(-45, 37);
  std::uniform_real_distribution<double> mantissa(-10, 10);
  for (int i = 0; i < 200'000; i++) {
    char word[128];
    const double number = mantissa(random) * std::pow(10.0, i % 3 == 0 ? exponent(random) : 0);
    std::snprintf(word, sizeof word, formats[i % 7], number);
    double value = 0;
    ASSERT_EQ(parse_number(word, value), NumberError::none) << word;
    ASSERT_EQ(value, std::strtod(word, nullptr)) << word;
  }
}

TEST(Number, stopsBehindTheLongestNumber) {
  const std::string text = "1.5/2";
  double value = 0;
  const ParsedNumber parsed = parse_number(text.data(), text.data() + text.size(), value);
  EXPECT_EQ(parsed.end - text.data(), 3);
  EXPECT_EQ(value, 1.5);
}

TEST(Number, isTheSameInALocaleWithCommas) {
  const std::string before = std::setlocale(LC_ALL, nullptr);
  if (std::setlocale(LC_ALL, "de_DE.UTF-8") == nullptr) GTEST_SKIP() << "no locale with decimal commas here";
  EXPECT_EQ(value_of("1.5"), 1.5);
  EXPECT_EQ(value_of("0.1000000000000000055511151231257827"), 0.1);
  std::setlocale(LC_ALL, before.c_str());
}

}  // namespace
}  // namespace penumbra
