#pragma once
// From the bytes of a fuzzer to numbers that are hard: ties, neighbours, subnormals, the ends of every range.

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <string_view>

namespace gradus::test {

/// Ends the program with this text when something is wrong: a fuzzer keeps the input, a replay fails.
inline void require(bool right, const char* what) {
  if (right) return;
  std::fprintf(stderr, "WRONG: not so: %s\n", what);
  std::abort();
}

/// Whether a text for people holds nothing that a terminal would act on: no control character (C0, DEL, C1),
/// no sign that turns the direction of text, and well-formed UTF-8.
inline bool harmless(std::string_view text) {
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto byte = [&](std::size_t k) {
      return i + k < text.size() ? static_cast<unsigned char>(text[i + k]) : 0u;
    };
    const unsigned lead = byte(0);
    if (lead < 0x20 || lead == 0x7f || (0x80 <= lead && lead < 0xc2) || lead > 0xf4) return false;
    const std::size_t more = lead < 0x80 ? 0 : lead < 0xe0 ? 1 : lead < 0xf0 ? 2 : 3;
    char32_t code = more == 0 ? lead : lead & (0x3fu >> more);
    for (std::size_t k = 1; k <= more; ++k) {
      if ((byte(k) & 0xc0) != 0x80) return false;
      code = (code << 6) | (byte(k) & 0x3f);
    }
    if (code >= 0x80 && code < 0xa0) return false;
    if (code == 0x61c || (0x200e <= code && code <= 0x200f) || (0x2028 <= code && code <= 0x202e))
      return false;
    if (0x2066 <= code && code <= 0x2069) return false;
    i += more;
  }
  return true;
}

/// Reads numbers from bytes; behind the last byte all of them are 0. Numbers repeat and neighbour earlier
/// ones often, which is what makes ties, tangents and points on borders.
class FuzzInput {
 public:
  FuzzInput(const std::uint8_t* data, std::size_t size) : at_(data), end_(data + size) {}

  bool empty() const { return at_ == end_; }
  std::size_t left() const { return static_cast<std::size_t>(end_ - at_); }
  std::string_view rest() const { return {reinterpret_cast<const char*>(at_), left()}; }

  std::uint8_t byte() { return at_ == end_ ? std::uint8_t{0} : *at_++; }
  bool coin() { return byte() & 1; }
  /// 0 to n - 1. Domain: 1 <= n <= 65536.
  int below(int n) { return n <= 256 ? byte() % n : (byte() + 256 * byte()) % n; }
  std::uint64_t word() {
    std::uint64_t bits = 0;
    for (int i = 0; i < 8; ++i) bits |= std::uint64_t{byte()} << (8 * i);
    return bits;
  }

  /// Any finite double whose size is 0 or lies between 2^lowest and 2^highest.
  double number(int lowest = -1074, int highest = 1023) {
    double x = raw_number();
    if (!std::isfinite(x)) x = 1;
    // By a power of two into the range, so that digits and ties stay
    if (x != 0) {
      const int size = std::ilogb(x);
      if (size < lowest) x = std::ldexp(x, lowest - size);
      if (size > highest) x = std::ldexp(x, highest - size);
    }
    earlier_[next_++ % earlier_.size()] = x;
    return x;
  }
  /// NaN and the infinities too, now and then.
  double any_number() {
    const int kind = below(16);
    if (kind == 15) return std::numeric_limits<double>::quiet_NaN();
    if (kind == 14) return coin() ? HUGE_VAL : -HUGE_VAL;
    return number();
  }

 private:
  double earlier() { return earlier_[static_cast<std::size_t>(below(static_cast<int>(earlier_.size())))]; }

  double raw_number() {
    // From the traps of the catalogue's numerical errata, and the ends of every range of doubles
    static constexpr std::array magic{0.0,
                                      -0.0,
                                      1.0,
                                      0.5,
                                      10.0,
                                      1.0 + 0x1p-52,
                                      1.0 - 0x1p-53,
                                      -1.0000000000000002,
                                      9.000000000000002,
                                      0x1p-53,
                                      0x1p-1074,
                                      0x1p-1022,
                                      0x0.fffffffffffffp-1022,
                                      0x1.fffffffffffffp1023,
                                      1e308,
                                      1e200,
                                      1e-170,
                                      1e160,
                                      1e-310,
                                      5e-321,
                                      0x1p53,
                                      0x1p53 + 2,
                                      0x1p52 + 1,
                                      0x1p300,
                                      0x1p-300,
                                      0x1p400,
                                      0x1p-400,
                                      0x1p995,
                                      0x1p-968,
                                      0x1.921fb54442d18p+0,
                                      0x1.921fb54442d18p+1,
                                      0x1.6ac5b262ca1ffp+849,
                                      1e22,
                                      1e12,
                                      0.1,
                                      1.0 / 3,
                                      2147483647.0,
                                      -2147483648.0,
                                      16777216.0};
    switch (below(12)) {
      case 0:
        return static_cast<std::int8_t>(byte());
      case 1:
        return static_cast<std::int8_t>(byte()) / 4.0;
      case 2: {
        const double x = magic[static_cast<std::size_t>(below(static_cast<int>(magic.size())))];
        return coin() ? -x : x;
      }
      case 3:
        return std::bit_cast<double>(word());
      case 4:
        return earlier();
      case 5: {  // a few steps beside an earlier one
        double x = earlier();
        const int steps = below(9) - 4;
        for (int i = std::abs(steps); i > 0; --i) x = std::nextafter(x, steps < 0 ? -HUGE_VAL : HUGE_VAL);
        return x;
      }
      case 6:
        return -earlier();
      case 7: {
        const double x = earlier();
        return x / 2 + earlier() / 2;
      }
      case 8: {
        const double x = earlier();
        return x + earlier();
      }
      case 9: {
        const double x = earlier();
        return std::ldexp(x, static_cast<std::int8_t>(byte()));
      }
      case 10:  // few digits, any size
        return std::ldexp(static_cast<std::int8_t>(byte()), below(2100) - 1080);
      default:
        return static_cast<double>(static_cast<std::int64_t>(word())) * 0x1p-63;
    }
  }

  const std::uint8_t* at_;
  const std::uint8_t* end_;
  std::array<double, 8> earlier_{};
  std::size_t next_ = 0;
};

}  // namespace gradus::test
