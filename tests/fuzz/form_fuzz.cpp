// Forms and signs with square roots against rationals and, for two roots, wide floats.

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <cstdint>

#include "core/form.hpp"
#include "core/two_doubles.hpp"
#include "support/fuzz_input.hpp"

using namespace gradus;
using gradus::test::require;
using Rational = boost::multiprecision::cpp_rational;
using Wide = boost::multiprecision::number<
    boost::multiprecision::cpp_bin_float<1200, boost::multiprecision::digit_base_2, void, std::int32_t>>;

namespace {

Rational exact(double x) { return Rational(x); }
Rational power_of_two(int e) {
  const boost::multiprecision::cpp_int p = boost::multiprecision::cpp_int(1) << std::abs(e);
  return e < 0 ? Rational(1, p) : Rational(p);
}

void polynomial(test::FuzzInput& input) {
  double n[8];
  for (double& x : n) x = input.number();
  const auto f = [&](int k) { return Form<1>(n[k]); };
  const Form<3> form = (f(0) * f(1) - f(2) * f(3)) * f(4) - f(5) * f(6) * f(7);
  const Rational right = (exact(n[0]) * exact(n[1]) - exact(n[2]) * exact(n[3])) * exact(n[4]) -
                         exact(n[5]) * exact(n[6]) * exact(n[7]);
  require(form.sign() == right.sign(), "the sign of a form is exact");
  const Leading leading = form.leading();
  const Rational shown =
      (exact(leading.digits.value) + exact(leading.digits.error)) * power_of_two(leading.exponent);
  require(abs(shown - right) <= abs(right) * power_of_two(-104), "the first digits are right to 2^-104");
}

void one_root(test::FuzzInput& input) {
  const double a = input.number(), b = input.number(), c = std::abs(input.number());
  const Rational left = exact(a) * exact(a), right = exact(b) * exact(b) * exact(c);
  // a + b sqrt(c), by squaring, with forms of degree 1, 0.5 and 1: written with a third factor 1
  const Form<1> one(1.0);
  const int sign_a = exact(a).sign(), sign_b = c == 0 ? 0 : exact(b).sign();
  int wanted = sign_a;
  if (sign_a * sign_b < 0) {
    const int larger = Rational(left - right).sign();
    wanted = larger == 0 ? 0 : larger > 0 ? sign_a : sign_b;
  } else if (sign_a == 0) {
    wanted = sign_b;
  }
  require(sign_with_root(Form<1>(a) * one, Form<1>(b), Form<1>(c) * one) == wanted,
          "the sign with a root is exact");
}

void two_roots(test::FuzzInput& input) {
  const double a = input.number(-20, 20), b = input.number(-20, 20), c = std::abs(input.number(-20, 20));
  const double d = input.number(-20, 20), e = std::abs(input.number(-20, 20));
  const Wide first = Wide(b) * sqrt(Wide(c)), second = Wide(d) * sqrt(Wide(e));
  const Wide value = Wide(a) + first + second, size = abs(Wide(a)) + abs(first) + abs(second);
  // What is not 0 is larger than this: a product of four conjugates of at most 10 times 75 bits each
  const int right = abs(value) <= size * pow(Wide(2), -1000) ? 0 : value.sign();
  const Form<1> one(1.0);
  require(
      sign_with_roots(Form<1>(a) * one, Form<1>(b), Form<1>(c) * one, Form<1>(d), Form<1>(e) * one) == right,
      "the sign with two roots is exact");
}

void pairs(test::FuzzInput& input) {
  const auto pair = [&] {
    const double value = input.number(-60, 60), ulp = std::abs(value) * 0x1p-53;
    return fast_two_sum(value, ulp * (input.byte() - 128) / 128.0);
  };
  const Rounded a = pair(), b = pair();
  const auto value = [](Rounded x) -> Rational { return exact(x.value) + exact(x.error); };
  const Rational x = value(a), y = value(b);
  const auto near = [&](Rounded got, const Rational& right, const Rational& size, int bits) {
    return abs(value(got) - right) <= abs(size) * power_of_two(-bits);
  };
  require(near(sum_of_pairs(a, b), x + y, abs(x) + abs(y), 102), "a sum of pairs keeps its bound");
  require(near(product_of_pairs(a, b), x * y, x * y, 101), "a product of pairs keeps its bound");
  if (y != 0) require(near(quotient_of_pairs(a, b), x / y, x / y, 99), "a quotient of pairs keeps its bound");
  const Rounded root = root_of_pair(a.value < 0 ? negated(a) : a);
  require(abs(value(root) * value(root) - abs(x)) <= abs(x) * power_of_two(-98),
          "a root of a pair keeps its bound");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  test::FuzzInput input(data, size);
  switch (input.below(4)) {
    case 0:
      polynomial(input);
      break;
    case 1:
      one_root(input);
      break;
    case 2:
      two_roots(input);
      break;
    default:
      pairs(input);
  }
  return 0;
}
