#include "core/arithmetic/exact_scalar.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <atomic>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "core/contract.hpp"

#if !defined(__cpp_exceptions)
// Boost leaves it to us how its calls end then
namespace boost {
void throw_exception(const std::exception& error) { gradus::contract_violated(error.what()); }
void throw_exception(const std::exception& error, const source_location&) { throw_exception(error); }
}  // namespace boost
#endif

namespace gradus {

using Integer = boost::multiprecision::cpp_int;
using Rational = boost::multiprecision::cpp_rational;

// The numbers of one thread, in the order they were made; place 0 holds the permanent 0.
class ExactArena {
 public:
  ExactArena() : next_stamp_(first_stamp()) {}

  Exact put(Rational value) {
    values_.push_back({std::move(value), next_stamp_});
    return Exact(values_.size() - 1, next_stamp_++, nullptr);
  }

  // Valid until the next put
  const Rational& get(Exact x) const {
    expects(x.index_ < values_.size() && values_[static_cast<std::size_t>(x.index_)].stamp == x.stamp_,
            "an exact number was used outside its scope or thread, or before it got a value (place {})",
            x.index_);
    return values_[static_cast<std::size_t>(x.index_)].number;
  }

  std::size_t size() const { return values_.size(); }
  void shrink_to(std::size_t size) { values_.resize(std::min(size, values_.size())); }

  std::size_t open_scopes = 0;

 private:
  struct Value {
    Rational number;
    std::uint64_t stamp = 0;
  };

  // Stamps never repeat, neither in a thread nor between threads
  static std::uint64_t first_stamp() {
    static std::atomic<std::uint64_t> threads = 0;
    return ++threads << 40;
  }

  std::vector<Value> values_ = std::vector<Value>(1);
  std::uint64_t next_stamp_;
};

namespace {

ExactArena& arena() {
  thread_local ExactArena of_this_thread;
  return of_this_thread;
}

const Rational& value_of(Exact x) { return arena().get(x); }

// Rounded towards minus infinity; C++ rounds towards 0
Integer floor_of(const Rational& x) {
  Integer quotient, remainder;
  boost::multiprecision::divide_qr(Integer(numerator(x)), Integer(denominator(x)), quotient, remainder);
  return remainder < 0 ? Integer(quotient - 1) : quotient;
}

// Not Boost's str(): it asks the locale how to write a short number, and a module gets all that locales can
// do
std::string decimal(const Integer& x) {
  constexpr std::uint64_t block = 1'000'000'000'000'000'000;  // 18 digits
  std::string digits;
  Integer left = boost::multiprecision::abs(x), above, below;
  for (; left >= block; left = above) {
    boost::multiprecision::divide_qr(left, Integer(block), above, below);
    digits = fmt::format("{:018}", static_cast<std::uint64_t>(below)) + digits;
  }
  return fmt::format("{}{}{}", x < 0 ? "-" : "", static_cast<std::uint64_t>(left), digits);
}

std::int64_t to_int64(const Integer& x) {
  using Limits = std::numeric_limits<std::int64_t>;
  expects(Limits::min() <= x && x <= Limits::max(), "{} does not fit into 64 bits", decimal(x));
  return static_cast<std::int64_t>(x);
}

int length_in_bits(const Integer& x) { return static_cast<int>(boost::multiprecision::msb(x)) + 1; }

}  // namespace

Exact Exact::from_signed(std::int64_t value) { return arena().put(Rational(value)); }

Exact Exact::from_unsigned(std::uint64_t value) { return arena().put(Rational(value)); }

Exact::Exact(double value) {
  expects(std::isfinite(value), "an exact number needs a finite value, got {}", value);
  *this = arena().put(Rational(value));
}

Exact::Exact(std::int64_t numerator, std::int64_t denominator) {
  expects(denominator != 0, "an exact number needs a denominator other than 0, got {}/{}", numerator,
          denominator);
  // Not Rational(numerator, denominator): Boost 1.74 refuses a negative denominator there
  *this = arena().put(Rational(numerator) / Rational(denominator));
}

Exact operator+(Exact a, Exact b) { return arena().put(value_of(a) + value_of(b)); }

Exact operator-(Exact a, Exact b) { return arena().put(value_of(a) - value_of(b)); }

Exact operator*(Exact a, Exact b) { return arena().put(value_of(a) * value_of(b)); }

Exact operator/(Exact a, Exact b) {
  expects(value_of(b) != 0, "exact division of {} by 0", to_string(a));
  return arena().put(value_of(a) / value_of(b));
}

Exact operator-(Exact a) { return arena().put(-value_of(a)); }

bool operator==(Exact a, Exact b) { return value_of(a) == value_of(b); }

std::strong_ordering operator<=>(Exact a, Exact b) { return value_of(a).compare(value_of(b)) <=> 0; }

Exact::operator double() const { return to_double(*this); }

ExactScope::ExactScope() : begin_(arena().size()), depth_(++arena().open_scopes) {}

ExactScope::~ExactScope() {
  if (!open_) return;
  arena().shrink_to(begin_);
  --arena().open_scopes;
}

Exact ExactScope::leave_with(Exact result) {
  leave_with(std::span(&result, 1));
  return result;
}

void ExactScope::leave_with(std::span<Exact> results) {
  expects(open_ && depth_ == arena().open_scopes, "only the innermost open scope can be left, once");
  std::vector<Rational> numbers;
  for (const Exact& result : results) numbers.push_back(value_of(result));
  arena().shrink_to(begin_);
  --arena().open_scopes;
  open_ = false;
  for (std::size_t i = 0; i < results.size(); ++i) results[i] = arena().put(std::move(numbers[i]));
}

std::size_t exact_values_alive() { return arena().size() - 1; }

double to_double(Exact x) {
  const Rational& value = value_of(x);
  if (value == 0) return 0;
  Integer above = boost::multiprecision::abs(Integer(numerator(value)));
  Integer below = denominator(value);

  // Scale so that the quotient has 63 or 64 bits, and divide once
  const int shift = 63 - (length_in_bits(above) - length_in_bits(below));
  if (shift > 0) above <<= shift;
  if (shift < 0) below <<= -shift;
  Integer quotient, remainder;
  boost::multiprecision::divide_qr(above, below, quotient, remainder);
  return nearest_double(value < 0, static_cast<std::uint64_t>(quotient), -shift, remainder != 0);
}

int sign(Exact x) { return value_of(x).sign(); }

Exact abs(Exact x) { return sign(x) < 0 ? -x : x; }

std::int64_t floor(Exact x) { return to_int64(floor_of(value_of(x))); }

std::int64_t ceil(Exact x) { return to_int64(-floor_of(-value_of(x))); }

std::string to_string(Exact x) {
  const Integer above = numerator(value_of(x)), below = denominator(value_of(x));
  return below == 1 ? decimal(above) : decimal(above) + "/" + decimal(below);
}

}  // namespace gradus
