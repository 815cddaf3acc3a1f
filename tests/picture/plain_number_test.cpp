#include "picture/plain_number.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace penumbra {
namespace {

TEST(PlainNumber, HasFewDigits) {
  EXPECT_EQ(with_digits(15.049999237060547, 4), 15.05);
  EXPECT_EQ(with_digits(123456, 4), 123500);
  EXPECT_EQ(with_digits(1.23456e-7, 3), 1.23e-7);
  EXPECT_EQ(with_digits(0, 4), 0);
  EXPECT_EQ(with_decimals(0.123456, 4), 0.1235);
  EXPECT_EQ(with_decimals(123456.789, 0), 123457);
  EXPECT_EQ(fmt::format("{}", with_decimals(-0.00001, 3)), "0") << "not -0";
}

TEST(PlainNumber, ShortensTheNumbersOfAText) {
  EXPECT_EQ(with_short_numbers("from 0 2.5 9.50000012 toward -0.4231996 1e-07, light 12, s07.cli 123456"),
            "from 0 2.5 9.5 toward -0.4232 1e-07, light 12, s07.cli 123456");
  EXPECT_EQ(with_short_numbers(""), "");
}

}  // namespace
}  // namespace penumbra
