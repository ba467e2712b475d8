// Decimal numbers, read as they are and by strtod: std::from_chars is the oracle.

#include "scene/decimal.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <string>

#include "core/random.hpp"
#include "support/seed.hpp"

namespace gradus::pipeline::decimal_test {
namespace {

using Reader = decltype(read_decimal);

/// Whether it reads what the oracle reads of this text; a text too small for a double may be a zero to it.
::testing::AssertionResult reads(Reader& reader, const std::string& text, bool may_vanish) {
  const char *first = text.data(), *last = first + text.size();
  double expected = 0, found = 0;
  const auto oracle = std::from_chars(first, last, expected);
  const auto result = reader(first, last, found);
  const bool vanished =
      may_vanish && oracle.ec == std::errc::result_out_of_range && result.ec == std::errc{} && found == 0;
  if (vanished && result.ptr == oracle.ptr) return ::testing::AssertionSuccess();
  const bool same_number = std::bit_cast<std::uint64_t>(expected) == std::bit_cast<std::uint64_t>(found) ||
                           (std::isnan(expected) && std::isnan(found));
  if (result.ptr == oracle.ptr && result.ec == oracle.ec && same_number) return ::testing::AssertionSuccess();
  return ::testing::AssertionFailure()
         << "'" << text << "': " << expected << " and " << found << ", " << oracle.ptr - first << " and "
         << result.ptr - first << " characters";
}

/// Whether all readers read the same of this text.
::testing::AssertionResult read_alike(const std::string& text) {
  const auto by_strtod = reads(read_decimal_by_strtod, text, true);
  return by_strtod ? reads(read_decimal, text, false) : by_strtod;
}

TEST(Decimal, WhatStrtodTakesBesidesIsRefused) {
  for (const char* text : {"", "-", "+1", "-+1", "--1", " 1", "\t1", "\v1", "- 1", "0x10", "-0X1p3", "0x",
                           "x", ".", "-.", "e5", ".e5"}) {
    EXPECT_TRUE(read_alike(text));
  }
}

TEST(Decimal, Forms) {
  for (const char* text : {"0",
                           "-0",
                           "1",
                           "-1",
                           "1.",
                           ".5",
                           "-.5",
                           "1.25",
                           "1e3",
                           "1E3",
                           "1e+3",
                           "1e-3",
                           "1e",
                           "1e+",
                           "1.5.5",
                           "1/2",
                           "1,5",
                           "3 4",
                           "007",
                           "inf",
                           "-inf",
                           "Infinity",
                           "infinit",
                           "nan",
                           "-NaN",
                           "nanx",
                           "in",
                           "1x",
                           "00x1",
                           "1e400",
                           "-1e400",
                           "1e-400",
                           "-1e-400",
                           "2e-324",
                           "3e-324",
                           "4.9e-324",
                           "2.2250738585072011e-308",
                           "1.7976931348623157e308",
                           "1.7976931348623159e308",
                           "1e99999999999999999999",
                           "1e-99999999999999999999",
                           "9007199254740993",
                           "0.1",
                           "123456789012345678901234567890"}) {
    EXPECT_TRUE(read_alike(text));
  }
}

/// As models have them: few digits, a point anywhere among them.
TEST(Decimal, ShortNumbers) {
  Random random(test::seed());
  for (int i = 0; i < 200'000; ++i) {
    std::string text;
    for (auto left = random.uniform_int(1, 17); left > 0; --left)
      text += static_cast<char>('0' + random.uniform_int(0, 9));
    const auto size = std::ssize(text);
    if (random.uniform_int(0, 3) > 0)
      text.insert(static_cast<std::size_t>(random.uniform_int(0, size)), 1, '.');
    if (random.uniform_int(0, 1) == 0) text.insert(0, 1, '-');
    if (random.uniform_int(0, 9) == 0) text += "e-7";
    ASSERT_TRUE(read_alike(text)) << "case " << i << ", seed " << test::seed();
  }
}

TEST(Decimal, RandomNumbers) {
  Random random(test::seed());
  const auto one_in_two = [&] { return random.uniform_int(0, 1) == 0; };
  for (int i = 0; i < 20'000; ++i) {
    std::string text = one_in_two() ? "-" : "";
    const auto digits = [&](int most) {
      for (auto left = random.uniform_int(0, most); left > 0; --left)
        text += static_cast<char>('0' + random.uniform_int(0, 9));
    };
    digits(24);
    if (one_in_two()) text += '.', digits(24);
    if (one_in_two()) text += one_in_two() ? "e-" : "e", digits(3);
    ASSERT_TRUE(read_alike(text)) << "case " << i << ", seed " << test::seed();
  }
}

}  // namespace
}  // namespace gradus::pipeline::decimal_test
