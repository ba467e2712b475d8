// Exact signs and correctly rounded numbers against Boost's rationals.

#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <cstdint>
#include <limits>

#include "core/axis_cut.hpp"
#include "core/exact.hpp"
#include "core/exact_scalar.hpp"
#include "support/clip_oracle.hpp"
#include "support/fuzz_input.hpp"

using namespace gradus;
using gradus::test::Rational;
using gradus::test::require;

namespace {

/// The nearest double, or infinity from half a step beyond the largest on.
bool is_rounded(double x, const Rational& exact) {
  const Rational largest = std::numeric_limits<double>::max();
  const Rational beyond = largest + Rational(boost::multiprecision::cpp_int(1) << 970);
  if (abs(exact) >= beyond) return std::isinf(x) && (x < 0) == (exact < 0);
  if (abs(exact) >= largest)
    return std::abs(x) == std::numeric_limits<double>::max() && (x < 0) == (exact < 0);
  return test::is_nearest(x, exact);
}

void orientation(test::FuzzInput& input) {
  const glm::dvec2 a = input.point(), b = input.point(), c = input.point();
  const Rational px = Rational(b.x) - Rational(a.x), py = Rational(b.y) - Rational(a.y);
  const Rational qx = Rational(c.x) - Rational(a.x), qy = Rational(c.y) - Rational(a.y);
  const int right = Rational(px * qy - py * qx).sign();
  require(orient2d(a, b, c) == right && orient2d_exact(a, b, c) == right, "the side of a line is exact");
  require(orient2d(b, c, a) == right && orient2d(b, a, c) == -right, "the side turns with its points");
  const auto sure = orient2d_filtered(a, b, c);
  require(!sure || *sure == right, "a filter is sure only of what is right");
}

void volume(test::FuzzInput& input) {
  const glm::dvec3 a = input.space_point(), b = input.space_point(), c = input.space_point(),
                   d = input.space_point();
  Rational p[3], q[3], r[3];
  for (int i = 0; i < 3; ++i) {
    p[i] = Rational(b[i]) - Rational(a[i]);
    q[i] = Rational(c[i]) - Rational(a[i]);
    r[i] = Rational(d[i]) - Rational(a[i]);
  }
  const int right = Rational(r[0] * (p[1] * q[2] - p[2] * q[1]) + r[1] * (p[2] * q[0] - p[0] * q[2]) +
                             r[2] * (p[0] * q[1] - p[1] * q[0]))
                        .sign();
  require(orient3d(a, b, c, d) == right && orient3d_exact(a, b, c, d) == right,
          "the side of a plane is exact");
  require(orient3d(b, a, c, d) == -right, "the side turns with its points");
  const auto sure = orient3d_filtered(a, b, c, d);
  require(!sure || *sure == right, "a filter is sure only of what is right");
}

void quotient(test::FuzzInput& input) {
  SumOfProducts<3> above;
  SumOfProducts<2> below;
  Rational n = 0, m = 0;
  for (int i = 1 + input.below(4); i > 0; --i) {
    const double x = input.number(), y = input.number(), z = input.number();
    const bool minus = input.coin();
    minus ? above.subtract(x, y, z) : above.add(x, y, z);
    const Rational term = Rational(x) * Rational(y) * Rational(z);
    n += minus ? Rational(-term) : term;
  }
  for (int i = 1 + input.below(3); i > 0; --i) {
    const double x = input.number(), y = input.number();
    below.add(x, y);
    m += Rational(x) * Rational(y);
  }
  require(above.sign() == n.sign() && below.sign() == m.sign(), "the sign of a sum of products is exact");
  if (m == 0) return;
  require(is_rounded(rounded_quotient(above, below), n / m), "a quotient is the nearest double");
  require(is_rounded(rounded(below), m), "a sum is the nearest double");
}

void whole_quotient(test::FuzzInput& input) {
  const auto n = static_cast<std::int64_t>(input.word());
  const auto d = static_cast<std::int64_t>(input.coin() ? input.word() : input.byte());
  if (d == 0) return;
  require(is_rounded(rounded_quotient(n, d), Rational(n) / d),
          "a quotient of integers is the nearest double");
}

void cut(test::FuzzInput& input) {
  const double a = input.number(), b = input.number(), p = input.number(), q = input.number(),
               c = input.number();
  if (a == b || c < std::min(a, b) || c > std::max(a, b)) return;
  const Rational exact =
      Rational(p) + (Rational(c) - Rational(a)) * (Rational(q) - Rational(p)) / (Rational(b) - Rational(a));
  const double at = cut_coordinate(a, b, p, q, c);
  require(is_rounded(at, exact), "a cut is the nearest double");
  require(std::min(p, q) <= at && at <= std::max(p, q), "a cut lies between the ends");
  const double back = cut_coordinate(b, a, q, p, c);
  require(std::bit_cast<std::uint64_t>(at) == std::bit_cast<std::uint64_t>(back),
          "the reverse has the same cut");
  const auto sure = cut_coordinate_filtered(a, b, p, q, c);
  require(!sure || *sure == at, "a filter is sure only of what is right");
}

void scalar(test::FuzzInput& input) {
  const ExactScope scope;
  Exact x = input.number();
  Rational right(to_double(x));
  for (int i = input.below(8); i > 0; --i) {
    const double y = input.number();
    switch (input.below(4)) {
      case 0:
        x += y, right += Rational(y);
        break;
      case 1:
        x -= y, right -= Rational(y);
        break;
      case 2:
        x *= y, right *= Rational(y);
        break;
      default:
        if (y != 0) x /= y, right /= Rational(y);
    }
  }
  require(sign(x) == right.sign(), "an exact number has the right sign");
  require(is_rounded(to_double(x), right), "an exact number gives the nearest double");
  if (abs(right) < Rational(std::int64_t{1} << 62)) {
    require(Rational(floor(x)) <= right && right < Rational(floor(x)) + 1, "floor is below");
    require(Rational(ceil(x)) >= right && right > Rational(ceil(x)) - 1, "ceil is above");
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  test::FuzzInput input(data, size);
  switch (input.below(6)) {
    case 0:
      orientation(input);
      break;
    case 1:
      volume(input);
      break;
    case 2:
      quotient(input);
      break;
    case 3:
      whole_quotient(input);
      break;
    case 4:
      cut(input);
      break;
    default:
      scalar(input);
  }
  return 0;
}
