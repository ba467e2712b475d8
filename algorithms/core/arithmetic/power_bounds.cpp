#include "core/arithmetic/power_bounds.hpp"

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "core/arithmetic/elementary.hpp"
#include "core/arithmetic/two_doubles.hpp"

namespace gradus {
namespace {

constexpr Rounded over_ln2 = {0x1.71547652b82fep+0, 0x1.777d0ffda0d24p-56};
constexpr Rounded ln2 = {0x1.62e42fefa39efp-1, 0x1.abc9e3b39803fp-56};

// --- Tables --------------------------------------------------------------------------------------

constexpr int log_bits = 6, exp_bits = 5;
constexpr std::size_t log_entries = 1 << log_bits, exp_entries = 1 << exp_bits;

// Significands are counted from here on, so that 1 lies amidst the numbers of one entry
constexpr std::uint64_t first_bits = 0x3fe6955500000000;

// log2 c. Domain: c from 0.7 to 1.5
constexpr double log2_of(double c) {
  // 2 artanh((c - 1) / (c + 1)) / ln 2
  const Rounded s = quotient_of_pairs({c - 1, 0}, two_sum(c, 1)), square = product_of_pairs(s, s);
  Rounded power = s, sum = {0, 0};
  for (int k = 1; k < 60; k += 2) {
    sum = sum_of_pairs(sum, quotient_of_pairs(power, {static_cast<double>(k), 0}));
    power = product_of_pairs(power, square);
  }
  return 2 * product_of_pairs(sum, over_ln2).value;
}

struct LogEntry {
  double scale = 1;  // a number of few digits near one over those of the entry
  double log2 = 0;   // -log2 of that
};
constexpr std::array<LogEntry, log_entries> log_table = [] {
  std::array<LogEntry, log_entries> table{};
  for (std::size_t i = 0; i < log_entries; ++i) {
    const auto at = [&](std::uint64_t entry) {
      return std::bit_cast<double>(first_bits + (entry << (52 - log_bits)));
    };
    const double lower = at(i), upper = at(i + 1);
    if (lower <= 1 && 1 < upper) continue;  // exactly 1, so that the logarithm of 1 is 0
    constexpr double digits = 0x1p16;
    table[i].scale = static_cast<double>(static_cast<int>(digits * 2 / (lower + upper))) / digits;
    table[i].log2 = -log2_of(table[i].scale);
  }
  return table;
}();

// 2^(j / 32)
constexpr std::array<double, exp_entries> exp_table = [] {
  std::array<double, exp_entries> table{};
  for (std::size_t j = 0; j < exp_entries; ++j) {
    const Rounded x = product_of_pairs(ln2, {static_cast<double>(j) / exp_entries, 0});
    Rounded term = {1, 0}, sum = {1, 0};
    for (int k = 1; k < 30; ++k) {
      term = quotient_of_pairs(product_of_pairs(term, x), {static_cast<double>(k), 0});
      sum = sum_of_pairs(sum, term);
    }
    table[j] = sum.value;
  }
  return table;
}();

// --- Series --------------------------------------------------------------------------------------

// log2 x within 8 units of 2^-53, relatively. Domain: x > 0, normal
double log2_nearly(double x) {
  const std::uint64_t bits = std::bit_cast<std::uint64_t>(x), from_first = bits - first_bits;
  const auto& [scale, log2_of_entry] =
      log_table[static_cast<std::size_t>(from_first >> (52 - log_bits)) % log_entries];
  const std::uint64_t exponent = from_first & std::uint64_t{0xfff} << 52;
  const double m = std::bit_cast<double>(bits - exponent);
  const auto k = static_cast<double>(static_cast<std::int64_t>(exponent) >> 52);
  // m scale - 1: the first product has few enough digits to be exact
  const double m_high = std::bit_cast<double>((bits - exponent) & ~std::uint64_t{0x7ffffff});
  const double r = (m_high * scale - 1) + (m - m_high) * scale;
  constexpr auto term = [](int i) { return (i % 2 == 0 ? -1 : 1) * over_ln2.value / i; };
  constexpr double t2 = term(2), t3 = term(3), t4 = term(4), t5 = term(5), t6 = term(6), t7 = term(7),
                   t8 = term(8);
  const double r2 = r * r;
  const double far = (t2 + r * t3) + r2 * ((t4 + r * t5) + r2 * ((t6 + r * t7) + r2 * t8));
  return (k + log2_of_entry) + (r * over_ln2.value + r2 * far);
}

// 2^t within 6 units of 2^-53, relatively. Domain: |t| <= 1000
double exp2_nearly(double t) {
  // The nearest multiple of 1/32: of the sum with 1.5 * 2^47 the lowest digits
  constexpr double round = 0x1.8p47;
  static_assert(exp_bits == 5);
  const double shifted = t + round;
  const double x = (t - (shifted - round)) * ln2.value;
  const std::uint64_t multiple = std::bit_cast<std::uint64_t>(shifted) - std::bit_cast<std::uint64_t>(round);
  const std::uint64_t n = multiple >> exp_bits;
  const auto j = static_cast<std::size_t>(multiple) % exp_entries;
  const double scale = std::bit_cast<double>(std::bit_cast<std::uint64_t>(exp_table[j]) + (n << 52));
  const double x2 = x * x;
  const double part =
      x + x2 * ((0.5 + x * (1.0 / 6)) + x2 * ((1.0 / 24 + x * (1.0 / 120)) + x2 * (1.0 / 720)));
  return scale + scale * part;
}

}  // namespace

Between power_bounds(double x, double y) {
  constexpr double most = 1000, smallest = std::numeric_limits<double>::min();
  if (smallest <= x && x < std::numeric_limits<double>::infinity()) {
    const double t = y * log2_nearly(x), size = std::abs(t);
    if (size <= most) {
      const double power = exp2_nearly(t);
      // 6 |t| and 6 units of 2^-53 are what it may be off, two more those of pow
      const double off = power * (0x1p-50 * (size + 1.5));
      return {power - off, power + off};
    }
    if (t < -most && y > -std::numeric_limits<double>::infinity()) return {0, 0x1p-999};
  }
  const double exactly = pow(x, y);
  return {exactly, exactly};
}

}  // namespace gradus
