#pragma once
// Polynomials in doubles without rounding: Form<4> is the exact value of one whose terms are products of four
// doubles. Its degree is its type, so that a sum of an area and a length does not compile.

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "core/arithmetic/exact.hpp"

namespace gradus {

namespace detail {

/// Magnitudes in words of 64 bits, lowest first. Each returns how many words of `result` are used (the
/// highest of them is not 0); `result` may be `a`.
std::size_t add_magnitudes(std::span<const std::uint64_t> a, std::span<const std::uint64_t> b,
                           std::span<std::uint64_t> result);
/// Domain: a >= b.
std::size_t subtract_magnitudes(std::span<const std::uint64_t> a, std::span<const std::uint64_t> b,
                                std::span<std::uint64_t> result);
/// `result` is neither `a` nor `b`.
std::size_t multiply_magnitudes(std::span<const std::uint64_t> a, std::span<const std::uint64_t> b,
                                std::span<std::uint64_t> result);
/// -1, 0 or +1: the sign of a - b. The highest words are not 0.
int compare_magnitudes(std::span<const std::uint64_t> a, std::span<const std::uint64_t> b);

/// |x| as significand * 2^(exponent - 1088). Domain: x finite (others are refused).
struct DoubleBits {
  std::uint64_t significand;
  int exponent;  ///< from 14 on
};
DoubleBits bits_of(double x);

}  // namespace detail

/// A number too large or too small for a double, as (value + error) * 2^exponent, 1/2 <= |value| <= 1.
struct Leading {
  Rounded digits;
  int exponent;
};

namespace detail {

/// The first 106 bits of a magnitude of words whose lowest bit weighs 2^lowest.
Leading leading_of(std::span<const std::uint64_t> words, int lowest, bool negative);

}  // namespace detail

/// The exact value of a homogeneous polynomial of this degree in doubles, in fixed point on the stack: 33
/// words of 64 bits per degree, of which only those in use are touched.
/// Source: Kulisch, "Computer arithmetic and validity", 2008, chapter 8, with multiplication.
/// Domain: all finite doubles, from the subnormals to the largest, mixed at will (others are refused); up to
/// 2^60 terms. Accuracy: exact. Cost: sums O(words in use), products O(words in use, squared).
template <int Degree>
class Form {
  static_assert(1 <= Degree && Degree <= 24);

 public:
  Form() = default;

  /// A double itself: a form of degree 1.
  explicit Form(double x)
    requires(Degree == 1)
      : negative_(x < 0) {
    const detail::DoubleBits bits = detail::bits_of(x);
    if (bits.significand == 0) return;
    const std::size_t word = static_cast<std::size_t>(bits.exponent / 64);
    const int shift = bits.exponent % 64;
    words_[word] = bits.significand << shift;
    words_[word + 1] = shift == 0 ? 0 : bits.significand >> (64 - shift);
    first_ = word;
    size_ = words_[word + 1] == 0 ? 1 : 2;
    drop_zeros();
  }

  Form(const Form& other) { *this = other; }
  Form& operator=(const Form& other) {
    if (this == &other) return *this;
    negative_ = other.negative_;
    first_ = other.first_;
    size_ = other.size_;
    std::copy_n(other.words_.begin() + static_cast<std::ptrdiff_t>(first_), size_,
                words_.begin() + static_cast<std::ptrdiff_t>(first_));
    return *this;
  }

  /// -1, 0 or +1.
  int sign() const { return size_ == 0 ? 0 : negative_ ? -1 : 1; }

  /// The number's first digits. Accuracy: 2^-104, relative. Zero gives zero digits.
  Leading leading() const {
    return detail::leading_of(used(), 64 * static_cast<int>(first_) - 1088 * Degree, negative_);
  }

  Form operator-() const {
    Form negated = *this;
    negated.negative_ = !negative_;
    return negated;
  }
  friend Form operator+(const Form& a, const Form& b) { return sum(a, b, b.negative_); }
  friend Form operator-(const Form& a, const Form& b) { return sum(a, b, !b.negative_); }

  template <int Other>
  Form<Degree + Other> operator*(const Form<Other>& b) const {
    Form<Degree + Other> product;
    if (sign() == 0 || b.sign() == 0) return product;
    product.first_ = first_ + b.first_;
    product.size_ = detail::multiply_magnitudes(used(), b.used(), product.from(product.first_));
    product.negative_ = negative_ != b.negative_;
    product.drop_zeros();
    return product;
  }

 private:
  template <int>
  friend class Form;
  // The lowest bit weighs 2^(-1088 Degree): words of products then lie where those of sums do
  static constexpr std::size_t word_count = 33 * std::size_t{Degree} + 2;

  std::span<const std::uint64_t> used() const { return std::span(words_).subspan(first_, size_); }
  std::span<std::uint64_t> from(std::size_t word) { return std::span(words_).subspan(word); }

  static Form sum(const Form& a, const Form& b, bool b_negative) {
    if (b.size_ == 0) return a;
    Form result = b;
    result.negative_ = b_negative;
    if (a.size_ == 0) return result;
    // Both from the same word on
    Form x = a;
    const std::size_t first = std::min(a.first_, b.first_);
    x.extend_down(first);
    result.extend_down(first);
    if (x.negative_ == b_negative) {
      result.size_ = detail::add_magnitudes(x.used(), result.used(), result.from(first));
    } else if (detail::compare_magnitudes(x.used(), result.used()) >= 0) {
      result.size_ = detail::subtract_magnitudes(x.used(), result.used(), result.from(first));
      result.negative_ = x.negative_;
    } else {
      result.size_ = detail::subtract_magnitudes(result.used(), x.used(), result.from(first));
    }
    result.drop_zeros();
    return result;
  }
  void extend_down(std::size_t first) {
    std::fill(words_.begin() + static_cast<std::ptrdiff_t>(first),
              words_.begin() + static_cast<std::ptrdiff_t>(first_), 0);
    size_ += first_ - first;
    first_ = first;
  }
  void drop_zeros() {
    while (size_ > 0 && words_[first_] == 0) ++first_, --size_;
  }

  std::array<std::uint64_t, word_count> words_;  // only size_ of them, from first_ on, have a value
  std::size_t first_ = 0, size_ = 0;
  bool negative_ = false;
};

/// a - b of two doubles, exactly.
inline Form<1> form_difference(double a, double b) { return Form<1>(a) - Form<1>(b); }

// --- Signs with square roots ------------------------------------------------------------------------------

/// The sign of a + b sqrt(c), exactly: where a and b differ in sign, a^2 is compared with b^2 c.
/// Domain: c >= 0. Cost: that of the squares.
template <int A, int B, int C>
  requires(2 * A == 2 * B + C)
int sign_with_root(const Form<A>& a, const Form<B>& b, const Form<C>& c) {
  const int rational = a.sign();
  const int root = c.sign() == 0 ? 0 : b.sign();
  if (root == 0 || rational == root) return rational;
  if (rational == 0) return root;
  return rational * (a * a - b * b * c).sign();
}

/// The sign of a + b sqrt(c) + d sqrt(e), exactly: first that of the roots' sum, then squares of both sides,
/// which leave a single root. Domain: c, e >= 0. Cost: forms of four times the degree of a.
template <int A, int B, int C>
  requires(2 * A == 2 * B + C)
int sign_with_roots(const Form<A>& a, const Form<B>& b, const Form<C>& c, const Form<B>& d,
                    const Form<C>& e) {
  if (c.sign() == 0 || b.sign() == 0) return sign_with_root(a, d, e);
  if (e.sign() == 0 || d.sign() == 0) return sign_with_root(a, b, c);
  const int rational = a.sign();
  // b sqrt(c) against -d sqrt(e)
  const Form<2 * A> first = b * b * c, second = d * d * e;
  const int roots = b.sign() == d.sign() ? b.sign() : b.sign() * (first - second).sign();
  if (roots == 0 || rational == roots) return rational;
  if (rational == 0) return roots;
  // a^2 - (b sqrt(c) + d sqrt(e))^2 = (a^2 - b^2 c - d^2 e) - 2 b d sqrt(c e)
  const Form<2 * B> twice = b * d + b * d;
  return rational * sign_with_root(a * a - first - second, -twice, c * e);
}

}  // namespace gradus
