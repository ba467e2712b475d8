#pragma once
// Arithmetic without rounding errors on the stack: error-free sums and products, expansions, sums of products
// of doubles, exact signs of orient2d and orient3d, and correctly rounded quotients.
//
// All of it needs round-to-nearest. It stays right where the compiler fuses products and sums (see
// core/arithmetic/rounding.hpp): what must round alone is guarded, and every bound of an error holds with
// fewer roundings, too.

#include <array>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <initializer_list>
#include <limits>
#include <optional>
#include <span>
#include <type_traits>

#include "core/arithmetic/rounding.hpp"
#include "core/contract.hpp"

namespace gradus {

// --- Error-free transforms --------------------------------------------------------------------------------

/// A rounded result and what the rounding took away: value + error is exact.
struct Rounded {
  double value;
  double error;
};

/// a + b without loss (Knuth 1969, TAOCP 2, section 4.2.2, theorem B).
/// Domain: the sum does not overflow. Accuracy: exact, also for subnormals. Cost: 6 additions.
constexpr Rounded two_sum(double a, double b) {
  if constexpr (has_fma) a = unfused(a), b = unfused(b);
  const double sum = a + b;
  const double b_kept = sum - a;
  const double a_kept = sum - b_kept;
  return {sum, (a - a_kept) + (b - b_kept)};
}

/// a + b without loss when |a| >= |b| or a = 0 (Dekker 1971, section 4).
/// Domain: as said, and the sum does not overflow. Accuracy: exact. Cost: 3 additions.
constexpr Rounded fast_two_sum(double a, double b) {
  if constexpr (has_fma) a = unfused(a), b = unfused(b);
  const double sum = a + b;
  return {sum, b - (sum - a)};
}

/// a - b without loss. Domain: the difference does not overflow. Accuracy: exact. Cost: 6 additions.
constexpr Rounded two_difference(double a, double b) { return two_sum(a, -b); }

/// a = value + error, each with at most 26 bits, so that products of halves are exact (Veltkamp 1968, in
/// Dekker 1971, section 5). Domain: |a| <= 2^995, else the product below overflows. Cost: 4 operations.
constexpr Rounded split_in_halves(double a) {
  const double shifted = unfused(0x1.0000002p27 * a);  // 2^27 + 1
  const double high = shifted - (shifted - a);
  return {high, a - high};
}

/// a * b without loss: by a fused multiply-add where the machine has one, else in halves (Dekker 1971,
/// section 5), for without hardware std::fma is a slow library call. In the domain the result is the same.
/// Domain: |a|, |b| <= 2^995, and a * b is 0 through a zero factor or 2^-968 <= |a * b| < 2^1023 (smaller
/// products lose their error below the subnormals). Not checked; see Expansion for a checked product.
/// Accuracy: exact in the domain. Cost: 2 operations, in halves 17.
constexpr Rounded two_product(double a, double b) {
  const double product = unfused(a * b);
  if constexpr (has_fma) {
    if (!std::is_constant_evaluated()) return {product, __builtin_fma(a, b, -product)};
  }
  const Rounded x = split_in_halves(a);
  const Rounded y = split_in_halves(b);
  const double rest = ((x.value * y.value - product) + x.value * y.error) + x.error * y.value;
  return {product, rest + x.error * y.error};
}

// --- Expansions -------------------------------------------------------------------------------------------

/// An exact number as a sum of at most `Capacity` doubles that share no bits, the smallest first.
/// Source: Shewchuk, "Adaptive precision floating-point arithmetic and fast robust geometric predicates",
/// 1997, section 2 (grow-expansion, theorem 10). No heap; the sizes of sums and products are types.
/// Domain: no part overflows, products lie in the domain of two_product; both are checked (`expects`).
/// For the whole range of double use SumOfProducts. Accuracy: exact. Cost: one two_sum per part and addition.
template <std::size_t Capacity>
class Expansion {
 public:
  constexpr Expansion() = default;

  /// Adds one double; at most `Capacity` parts may come together.
  constexpr void add(double term) {
    // Carry the term upwards through the parts; what each addition rounds away stays behind as a part
    std::size_t kept = 0;
    for (std::size_t i = 0; i < size_; ++i) {
      const Rounded sum = two_sum(term, parts_[i]);
      if (sum.error != 0) parts_[kept++] = sum.error;
      term = sum.value;
    }
    size_ = kept;
    if (term == 0) return;
    expects(std::numeric_limits<double>::lowest() <= term && term <= std::numeric_limits<double>::max(),
            "an expansion left the range of double with the part {}", term);
    expects(size_ < Capacity, "an expansion of capacity {} got one part too many", Capacity);
    parts_[size_++] = term;
  }

  /// Adds a * b. Domain: that of two_product, checked.
  constexpr void add_product(double a, double b) {
    if (a == 0 || b == 0) return;
    const Rounded product = two_product(a, b);
    const double size = product.value < 0 ? -product.value : product.value;
    expects(
        -0x1p995 <= a && a <= 0x1p995 && -0x1p995 <= b && b <= 0x1p995 && 0x1p-968 <= size && size < 0x1p1023,
        "the product {} * {} is too large or too small for an expansion; use SumOfProducts", a, b);
    add(product.error);
    add(product.value);
  }

  /// Number of non-zero parts; 0 for the number zero.
  constexpr std::size_t size() const { return size_; }
  /// Part i, 0 <= i < size(), smallest first.
  constexpr double operator[](std::size_t i) const { return parts_[i]; }

  /// -1, 0 or +1. The largest part decides, since the others together are smaller.
  constexpr int sign() const {
    if (size_ == 0) return 0;
    return parts_[size_ - 1] < 0 ? -1 : 1;
  }

  /// The number in one double, within 1 ulp; `rounded` gives the nearest.
  constexpr double estimate() const {
    double sum = 0;
    for (std::size_t i = 0; i < size_; ++i) sum += parts_[i];
    return sum;
  }

  constexpr Expansion operator-() const {
    Expansion negated = *this;
    for (std::size_t i = 0; i < size_; ++i) negated.parts_[i] = -parts_[i];
    return negated;
  }

 private:
  std::array<double, Capacity> parts_{};
  std::size_t size_ = 0;
};

/// a + b exactly. Domain: a + b does not overflow (checked). Cost: 6 additions.
constexpr Expansion<2> exact_sum(double a, double b) {
  Expansion<2> sum;
  sum.add(a);
  sum.add(b);
  return sum;
}

/// a - b exactly. Domain: a - b does not overflow (checked). Cost: 6 additions.
constexpr Expansion<2> exact_difference(double a, double b) { return exact_sum(a, -b); }

/// a * b exactly. Domain: that of two_product (checked). Cost: about 25 operations.
constexpr Expansion<2> exact_product(double a, double b) {
  Expansion<2> product;
  product.add_product(a, b);
  return product;
}

/// The exact sum of two expansions. Domain: no overflow (checked). Cost: N * M two_sums.
template <std::size_t N, std::size_t M>
constexpr Expansion<N + M> operator+(const Expansion<N>& a, const Expansion<M>& b) {
  Expansion<N + M> sum;
  for (std::size_t i = 0; i < a.size(); ++i) sum.add(a[i]);
  for (std::size_t i = 0; i < b.size(); ++i) sum.add(b[i]);
  return sum;
}

/// The exact difference of two expansions. Domain: no overflow (checked). Cost: N * M two_sums.
template <std::size_t N, std::size_t M>
constexpr Expansion<N + M> operator-(const Expansion<N>& a, const Expansion<M>& b) {
  return a + (-b);
}

/// The exact product of two expansions.
/// Domain: every product of two parts in the domain of two_product (checked). Cost: O((N M)^2) two_sums.
template <std::size_t N, std::size_t M>
constexpr Expansion<2 * N * M> operator*(const Expansion<N>& a, const Expansion<M>& b) {
  Expansion<2 * N * M> product;
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t j = 0; j < b.size(); ++j) product.add_product(a[i], b[j]);
  }
  return product;
}

// --- Sums of products over the whole range of double ------------------------------------------------------

namespace detail {

/// Adds or subtracts a product of doubles to a two's complement number in words of 64 bits, lowest first,
/// whose lowest bit weighs 2^(-1074 * factors). Refuses infinities and NaN.
void accumulate_product(std::span<std::uint64_t> words, int factors, std::initializer_list<double> product,
                        bool subtract);
int sign_of(std::span<const std::uint64_t> words);

/// The nearest double to (a * 2^a_exponent) / (b * 2^b_exponent), both in two's complement words.
double rounded_quotient_of(std::span<const std::uint64_t> a, int a_exponent, std::span<const std::uint64_t> b,
                           int b_exponent);

}  // namespace detail

/// The exact value of a sum of products of up to `Factors` doubles each; one wide fixed-point number on the
/// stack (68 words of 64 bits for two factors, 101 for three, 134 for four).
/// Source: Kulisch, "Computer arithmetic and validity", 2008, chapter 8 (the complete register).
/// Domain: all finite doubles, from the subnormals to the largest, mixed at will (others are refused);
/// up to 2^60 terms. Accuracy: exact. Cost: some 30 ns per product.
template <int Factors>
class SumOfProducts {
  static_assert(1 <= Factors && Factors <= 4);

 public:
  /// Adds the product of one to `Factors` doubles, e.g. sum.add(x, y).
  template <std::same_as<double>... Doubles>
    requires(1 <= sizeof...(Doubles) && sizeof...(Doubles) <= Factors)
  void add(Doubles... factors) {
    detail::accumulate_product(words_, Factors, {factors...}, false);
  }

  /// Subtracts the product of one to `Factors` doubles.
  template <std::same_as<double>... Doubles>
    requires(1 <= sizeof...(Doubles) && sizeof...(Doubles) <= Factors)
  void subtract(Doubles... factors) {
    detail::accumulate_product(words_, Factors, {factors...}, true);
  }

  /// -1, 0 or +1, exactly.
  int sign() const { return detail::sign_of(words_); }

  /// The number in two's complement, lowest word first, and the weight of its lowest bit.
  std::span<const std::uint64_t> words() const { return words_; }
  static constexpr int lowest_exponent = -1074 * Factors;
  // 2098 bits hold any double in fixed point; two words more leave room for carries and the sign
  static constexpr std::size_t word_count = (2098 * std::size_t{Factors} + 63) / 64 + 2;

 private:
  std::array<std::uint64_t, word_count> words_{};
};

/// The same number as an expansion, in the form that rounded_quotient divides.
template <std::size_t Capacity>
SumOfProducts<1> to_sum(const Expansion<Capacity>& expansion) {
  SumOfProducts<1> sum;
  for (std::size_t i = 0; i < expansion.size(); ++i) sum.add(expansion[i]);
  return sum;
}

// --- Correctly rounded results ----------------------------------------------------------------------------

/// The double nearest to ±(significand + fraction) * 2^exponent, ties to even, where 0 < fraction < 1 when
/// `inexact` and fraction = 0 when not. Subnormal results are rounded once; too large ones give ±infinity,
/// too small ones ±0, as IEEE 754 says.
/// Domain: an inexact significand has at least 55 bits (checked), so that the fraction only breaks ties.
/// Accuracy: 1/2 ulp. Cost: a few ns.
double nearest_double(bool negative, std::uint64_t significand, int exponent, bool inexact);

/// The double nearest to numerator / denominator, ties to even: for a point on an edge, say, put
/// x0 * (y1 - y) + x1 * (y - y0) and y1 - y0 into two sums, multiplied out, and divide once.
/// Domain: every sum of finite doubles; a zero denominator is refused. Overflow gives ±infinity, results in
/// the subnormal range are rounded once, a quotient of exactly 0 is +0.
/// Accuracy: 1/2 ulp, the nearest double.
/// Cost: about 1 us for operands of like size, up to 10 us over the full range of exponents.
template <int N, int M>
double rounded_quotient(const SumOfProducts<N>& numerator, const SumOfProducts<M>& denominator) {
  return detail::rounded_quotient_of(numerator.words(), numerator.lowest_exponent, denominator.words(),
                                     denominator.lowest_exponent);
}

/// The double nearest to numerator / denominator, ties to even. Domain: denominator not 0 (refused).
template <std::size_t N, std::size_t M>
double rounded_quotient(const Expansion<N>& numerator, const Expansion<M>& denominator) {
  return rounded_quotient(to_sum(numerator), to_sum(denominator));
}

/// The double nearest to the sum, ties to even; ±infinity beyond the range of double.
template <int N>
double rounded(const SumOfProducts<N>& sum) {
  SumOfProducts<1> one;
  one.add(1.0);
  return rounded_quotient(sum, one);
}

/// The double nearest to the expansion, ties to even.
template <std::size_t N>
double rounded(const Expansion<N>& expansion) {
  return rounded(to_sum(expansion));
}

__extension__ typedef __int128 Int128;

/// The double nearest to numerator / denominator, ties to even.
/// Domain: every numerator, denominator not 0 (refused). Accuracy: 1/2 ulp. Cost: about 0.4 us.
double rounded_quotient(Int128 numerator, Int128 denominator);

/// The same for the built-in integers, signed and unsigned, which all fit.
template <std::integral Numerator, std::integral Denominator>
double rounded_quotient(Numerator numerator, Denominator denominator) {
  return rounded_quotient(static_cast<Int128>(numerator), static_cast<Int128>(denominator));
}

/// Doubles would lose their fractions on the way to integers; plain division rounds them correctly.
double rounded_quotient(double numerator, double denominator) = delete;

// --- Signs of orientation ---------------------------------------------------------------------------------

/// The sign of orient2d where plain double arithmetic is sure of it, else nothing.
/// Source: Shewchuk 1997, section 4.1, stage A, with 4u for his 3u + 16u^2 and room for underflow (u =
/// 2^-53). Domain: any doubles; nothing for overflow, infinities and NaN. Cost: about 3 ns.
inline std::optional<int> orient2d_filtered(glm::dvec2 a, glm::dvec2 b, glm::dvec2 c) {
  const glm::dvec2 p = b - a, q = c - a;
  const double left = p.x * q.y, right = p.y * q.x;
  const double area = left - right;
  // Rounding errs by less than 4u of the two products, underflow by less than 2^-1000
  const double bound = 0x1p-51 * (std::abs(left) + std::abs(right)) + 0x1p-1000;
  if (area > bound) return 1;
  if (-area > bound) return -1;

  // Common on grids: a factor of either product is exactly 0
  const bool finite = std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(q.x) && std::isfinite(q.y);
  if (finite && (p.x == 0 || q.y == 0) && (p.y == 0 || q.x == 0)) return 0;
  return std::nullopt;
}

/// The sign of orient2d by exact arithmetic alone. Domain: finite coordinates (others are refused).
/// Cost: about 0.2 us.
int orient2d_exact(glm::dvec2 a, glm::dvec2 b, glm::dvec2 c);

/// The exact sign of the doubled area of the triangle a, b, c: +1 when a, b, c run counter-clockwise (y up; c
/// is left of a -> b), -1 when clockwise, 0 when they lie on a line.
/// Source: Shewchuk 1997, section 4.1; sign of det(b - a, c - a), in doubt from the complete register.
/// Domain: all finite doubles, from subnormals to 1e308 (others are refused); equal points give 0.
/// Accuracy: exact. Cost: about 3 ns, in doubt about 0.2 us.
inline int orient2d(glm::dvec2 a, glm::dvec2 b, glm::dvec2 c) {
  const std::optional<int> sure = orient2d_filtered(a, b, c);
  return sure ? *sure : orient2d_exact(a, b, c);
}

/// The same for float and int coordinates, which double holds exactly.
inline int orient2d(glm::vec2 a, glm::vec2 b, glm::vec2 c) {
  return orient2d(glm::dvec2(a), glm::dvec2(b), glm::dvec2(c));
}
inline int orient2d(glm::ivec2 a, glm::ivec2 b, glm::ivec2 c) {
  return orient2d(glm::dvec2(a), glm::dvec2(b), glm::dvec2(c));
}

/// The sign of orient3d where plain double arithmetic is sure of it, else nothing.
/// Source: Shewchuk 1997, section 4.2, stage A, with 8u for his 7u + 56u^2 and room for underflow.
/// Domain: any doubles; nothing for overflow, infinities and NaN. Cost: about 6 ns.
inline std::optional<int> orient3d_filtered(glm::dvec3 a, glm::dvec3 b, glm::dvec3 c, glm::dvec3 d) {
  const glm::dvec3 p = b - a, q = c - a, r = d - a;
  const double yz = p.y * q.z, zy = p.z * q.y;
  const double zx = p.z * q.x, xz = p.x * q.z;
  const double xy = p.x * q.y, yx = p.y * q.x;
  const double volume = r.x * (yz - zy) + r.y * (zx - xz) + r.z * (xy - yx);
  const double size = std::abs(r.x) * (std::abs(yz) + std::abs(zy)) +
                      std::abs(r.y) * (std::abs(zx) + std::abs(xz)) +
                      std::abs(r.z) * (std::abs(xy) + std::abs(yx));
  // A product lost to underflow is multiplied by a component of r
  const double underflow = 0x1p-1000 * (std::abs(r.x) + std::abs(r.y) + std::abs(r.z)) + 0x1p-1000;
  const double bound = 0x1p-50 * size + underflow;
  if (volume > bound) return 1;
  if (-volume > bound) return -1;
  return std::nullopt;
}

/// The sign of orient3d by exact arithmetic alone. Domain: finite coordinates (others are refused).
/// Cost: about 1 us.
int orient3d_exact(glm::dvec3 a, glm::dvec3 b, glm::dvec3 c, glm::dvec3 d);

/// The exact side of the plane a, b, c on which d lies: +1 on the side of the normal (b - a) x (c - a), from
/// which a, b, c look counter-clockwise; -1 on the other, 0 when the four lie in a plane.
/// Source: Shewchuk 1997, section 4.2 (whose sign is the opposite one); sign of det(b - a, c - a, d - a).
/// Domain: all finite doubles, from subnormals to 1e308 (others are refused); a degenerate plane gives 0.
/// Accuracy: exact. Cost: about 6 ns, in doubt about 1 us.
inline int orient3d(glm::dvec3 a, glm::dvec3 b, glm::dvec3 c, glm::dvec3 d) {
  const std::optional<int> sure = orient3d_filtered(a, b, c, d);
  return sure ? *sure : orient3d_exact(a, b, c, d);
}

/// The same for float and int coordinates, which double holds exactly.
inline int orient3d(glm::vec3 a, glm::vec3 b, glm::vec3 c, glm::vec3 d) {
  return orient3d(glm::dvec3(a), glm::dvec3(b), glm::dvec3(c), glm::dvec3(d));
}
inline int orient3d(glm::ivec3 a, glm::ivec3 b, glm::ivec3 c, glm::ivec3 d) {
  return orient3d(glm::dvec3(a), glm::dvec3(b), glm::dvec3(c), glm::dvec3(d));
}

}  // namespace gradus
