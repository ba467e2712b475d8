// The promises of parallel projections: onto a plane z = d, and onto any.

#include "stress/projection/parallel.hpp"

#include <algorithm>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <numbers>

#include "projection/parallel/parallel.hpp"
#include "stress/exactly.hpp"
#include "stress/scales.hpp"

namespace gradus::stress {
namespace {

using namespace gradus::parallel;

std::array<Exact, 3> exactly(const ExactVec3& v) { return {v.x, v.y, v.z}; }

// --- Oblique: d, slant, point ----------------------------------------------------------------------------

Input oblique_input(Kind kind, Random& random) {
  Input input = numbers_of(kind, random, 6);
  if (kind == Kind::near_degenerate) input[5] = nudged(input[0], random);  // beside the plane
  if (kind == Kind::grazing) input[5] = input[0];
  if (kind == Kind::tiny) input[1] = input[2] = random.uniform(-2, 2);
  return input;
}

template <class T>
double oblique_error(const std::vector<T>& i) {
  if (!all_finite(i)) return 0;
  const T d = i[0];
  const glm::vec<3, T> point = vector_in(i, 3);
  const Exact t = Exact(d) - Exact(point.z), aside[] = {t * Exact(i[1]), t * Exact(i[2])}, four(4);
  // Beyond the domain
  if (overflows<T>(t) || overflows<T>(four * aside[0]) || overflows<T>(four * aside[1])) return 0;
  if (std::max(std::abs(point.x), std::abs(point.y)) > std::numeric_limits<T>::max() / 4) return 0;
  const glm::vec<3, T> image = oblique(d, Slant<T>{i[1], i[2]}, point);
  if (image.z != d || (point.z == d && image != point)) return wrong;
  const auto right = crossing_of<Exact>({0, 0, 1}, d, {i[1], i[2], 1}, exactly(ExactVec3(point)));
  const Exact u = rounding_unit<T>(), smallest(std::numeric_limits<T>::denorm_min());
  double worst = 0;
  for (std::size_t k = 0; k < 2; ++k) {
    const Exact place(image[static_cast<int>(k)]);
    const Exact bound = u * (abs(place) + Exact(2) * (Exact(1) + u) * abs(aside[k])) + smallest / Exact(2);
    worst = std::max(worst, in_bounds(abs(right[k] - place), bound));
  }
  return worst;
}

// --- Along any direction onto any plane: normal, offset, direction, point --------------------------------

Input along_input(Kind kind, Random& random) {
  Input input = numbers_of(kind, random, 10);
  if (kind == Kind::near_degenerate) {
    // Nearly in the plane: from a right angle to the normal a little aside
    const dvec3 n = vector_in(input, 0), across = glm::cross(n, vector_in(input, 4));
    const double share = std::ldexp(random.uniform(-1, 1), static_cast<int>(random.uniform_int(-56, -2)));
    for (int i = 0; i < 3; ++i) input[4 + static_cast<std::size_t>(i)] = across[i] + share * n[i];
  } else if (kind == Kind::grazing) {
    input[4] = input[5] = input[6] = 0;
    input[4 + static_cast<std::size_t>(random.uniform_int(0, 2))] = 1;
  }
  return input;
}

/// A plane and a direction, and what decides whether they meet: q = normal . direction, and the sum of its
/// absolute terms.
template <class T>
struct Meeting {
  Plane<T> plane;
  glm::vec<3, T> direction;
  Exact q, sum;
  bool normal = true;  ///< all products are normal numbers of T

  explicit Meeting(const std::vector<T>& i)
      : plane{vector_in(i, 0), i[3]}, direction(vector_in(i, 4)), q(0), sum(0) {
    for (int k = 0; k < 3; ++k) {
      const Exact product = Exact(plane.normal[k]) * Exact(direction[k]);
      normal = normal && fits<T>(product);
      q += product;
      sum += abs(product);
    }
    normal = normal && fits<T>(sum);
  }
  bool surely() const { return abs(q) > Exact(20) * rounding_unit<T>() * sum; }
};

/// A refusal is right only where rounding could decide whether they meet.
template <class T>
double refusal_error(const Meeting<T>& m) {
  return m.surely() ? wrong : 0;
}

template <class T>
double along_error(const std::vector<T>& i) {
  if (!all_finite(i)) return 0;
  const Meeting<T> m(i);
  const glm::vec<3, T> point = vector_in(i, 7);
  const ExactVec3 n(m.plane.normal), v(m.direction), p(point);
  const Exact offset(m.plane.offset), ahead = offset - glm::dot(n, p);
  const Exact t = sign(m.q) == 0 ? m.q : ahead / m.q;
  Exact far = abs(offset);
  bool in_domain = m.normal && fits<T>(t);
  for (int k = 0; k < 3; ++k) {
    const Exact product = n[k] * p[k], slide = t * v[k];
    far += abs(product);
    in_domain = in_domain && fits<T>(product) && fits<T>(far) && fits<T>(slide) && fits<T>(p[k] + slide);
  }
  if (!in_domain) return 0;
  const auto image = accepted([&] { return along(m.plane, m.direction, point); });
  if (image.has_value() != meets(m.plane, m.direction)) return wrong;
  if (!image) return refusal_error(m);
  if (sign(m.q) == 0) return wrong;
  const auto right = crossing_of(exactly(n), offset, exactly(v), exactly(p));
  const Exact slide = Exact(10) * far * m.sum / (m.q * m.q);
  double worst = 0;
  for (int k = 0; k < 3; ++k) {
    const Exact bound = rounding_unit<T>() * (slide * abs(v[k]) + Exact(2) * abs(p[k]));
    worst = std::max(worst, in_bounds(abs(right[static_cast<std::size_t>(k)] - Exact((*image)[k])), bound));
  }
  return worst;
}

bool is_refused(const Input& i) {
  return all_finite(i) && !meets(Plane<double>{vector_in(i, 0), i[3]}, vector_in(i, 4));
}

/// The matrix: normal, offset, direction.
template <class T>
double matrix_error(const std::vector<T>& i) {
  if (!all_finite(i)) return 0;
  const Meeting<T> m(i);
  if (!m.normal) return 0;
  const auto found = accepted([&] { return matrix_of(m.plane, m.direction); });
  if (!found) return refusal_error(m);
  if (sign(m.q) == 0) return wrong;
  const Exact u = rounding_unit<T>(), cancels = Exact(7) * m.sum / abs(m.q);
  const ExactVec3 shares = ExactVec3(m.direction) / m.q;
  double worst = 0;
  for (int column = 0; column < 4; ++column) {
    for (int row = 0; row < 3; ++row) {
      const Exact product = shares[row] * Exact(i[static_cast<std::size_t>(column)]);
      if (!fits<T>(shares[row]) || !fits<T>(product)) continue;
      const Exact one(column == row ? 1 : 0), exact = column == 3 ? product : one - product;
      const Exact bound = u * (cancels * abs(product) + one);
      worst = std::max(worst, in_bounds(abs(exact - Exact((*found)[column][row])), bound));
    }
  }
  return worst;
}

// --- The slant of an angle and a foreshortening -----------------------------------------------------------

template <unsigned bits>
using Float = boost::multiprecision::number<
    boost::multiprecision::cpp_bin_float<bits, boost::multiprecision::digit_base_2>,
    boost::multiprecision::et_off>;

Input slant_input(Kind kind, Random& random) {
  Input input{number(kind, random), std::abs(number(kind, random))};
  if (kind == Kind::grazing) input = {nudged(std::numbers::pi / 4 * std::round(input[0]), random), 1};
  if (kind == Kind::near_degenerate)
    input[1] = std::ldexp(1.0, static_cast<int>(random.uniform_int(-1074, 1023)));
  if (kind == Kind::ties) input[1] /= 2;
  return input;
}

template <class Number>
double slant_ulps(const Input& i, const Slant<double>& found) {
  const Number length(i[1]), angle(i[0]), exact[] = {-(length * cos(angle)), -(length * sin(angle))};
  double worst = 0;
  for (const auto& [slant, right] : {std::pair(found.a, exact[0]), std::pair(found.b, exact[1])}) {
    if (!std::isfinite(slant)) return wrong;
    const double size = std::abs(static_cast<double>(right));
    const double ulp = std::nextafter(size, wrong) - size;
    worst = std::max(worst, static_cast<double>(Number(abs(Number(slant) - right) / ulp)));
  }
  return worst;
}

double slant_error(const Input& i) {
  const auto slant = accepted([&] { return slant_of(i[0], i[1]); });
  if (slant.has_value() != (all_finite(i) && i[1] >= 0)) return wrong;
  if (!slant) return 0;
  // Digits for angles of 1e308, too
  return std::abs(i[0]) < 0x1p60 ? slant_ulps<Float<340>>(i, *slant) : slant_ulps<Float<1400>>(i, *slant);
}

// --- What is kept: normal, offset, direction, two points, a move, a share ---------------------------------

bool laws_hold(const Input& i) {
  const Plane<Exact> plane{ExactVec3(vector_in(i, 0)), Exact(i[3])};
  const ExactVec3 v(vector_in(i, 4)), a(vector_in(i, 7)), b(vector_in(i, 10)), move(vector_in(i, 13));
  const Exact share(i[16]);
  if (!meets(plane, v)) return glm::dot(plane.normal, v) == Exact(0);
  const auto image = [&](const ExactVec3& p) { return along(plane, v, p); };
  const ExactVec3 ia = image(a), ib = image(b);
  const Slant<Exact> slant{v.x, v.y};
  const Plane<Exact> front{ExactVec3{0, 0, 1}, plane.offset};
  return glm::dot(plane.normal, ia) == plane.offset && glm::cross(ia - a, v) == ExactVec3(Exact(0)) &&
         oblique(plane.offset, slant, a) == along(front, ExactVec3{v.x, v.y, Exact(1)}, a) &&
         // Parallels stay parallel, ratios stay
         image(a + share * (b - a)) == ia + share * (ib - ia) &&
         // No diminution with distance: moved anywhere, the same figure
         image(b + move) - image(a + move) == ib - ia &&
         // Two depths, one picture
         image(a + share * v) == ia && image(ia) == ia &&
         matrix_of(plane, v) * glm::vec<4, Exact>(a, Exact(1)) == glm::vec<4, Exact>(ia, Exact(1));
}

}  // namespace

Domain parallel() {
  return {"parallel",
          {{.name = "oblique",
            .states = "x and y within u (|x'| + 2 |t a|) and half the smallest number",
            .unit = "bounds",
            .bound = 1,
            .numbers = 6,
            .generate = at_every_scale(oblique_input),
            .error = in_both([](const auto& i) { return oblique_error(i); }),
            .traps = {{"in the plane", {0.1, 0.3, 0.7, 0.1, 0.2, 0.1}},
                      {"nearly in the plane", {1, 1, 1, 1, 1, std::nextafter(1, 2)}},
                      {"products underflow", {1e-200, 1e-200, 1e-200, 0, 0, 0}}},
            .shares = {{"in the plane", 0.05, [](const Input& i) { return i[5] == i[0]; }}}},
           {.name = "along",
            .states = "each coordinate within 10 u |v| N S / q^2 + 2 u |p|; parallel projectors are refused",
            .unit = "bounds",
            .bound = 1,
            .numbers = 10,
            .generate = at_every_scale(along_input),
            .error = in_both([](const auto& i) { return along_error(i); }),
            .traps = {{"in the plane", {1, -1, 1, -3, 1, 1, 0, 2, 2, 4}},
                      {"in the plane but for a rounding", {0.1, 0.2, 0.3, 1, 3, 0, -1, 1, 2, 3}},
                      {"no direction", {0, 0, 1, 1, 0, 0, 0, 1, 2, 3}},
                      {"no plane", {0, 0, 0, 1, 1, 2, 3, 1, 2, 3}}},
            .shares = {{"refused", 0.05, is_refused}}},
           {.name = "matrix_of",
            .states = "an entry within 7 u S / |q| of its product, and u where it is taken from 1",
            .unit = "bounds",
            .bound = 1,
            .numbers = 7,
            .generate = at_every_scale([](Kind kind, Random& random) {
              Input input = along_input(kind, random);
              input.resize(7);
              return input;
            }),
            .error = in_both([](const auto& i) { return matrix_error(i); }),
            .traps = {{"in the plane but for a rounding", {0.1, 0.2, 0.3, 1, 3, 0, -1}},
                      {"no direction", {0, 0, 1, 1, 0, 0, 0}}}},
           {.name = "slant_of",
            .states = "both numbers within 1.51 ulp, for every angle",
            .unit = "ulp",
            .bound = 1.51,
            .numbers = 2,
            .generate = at_every_scale(slant_input),
            .error = slant_error,
            .traps = {{"1.42 ulp", {-0x1.0c6e2dee943eep+1, 0x1.f3a0abfca1e54p+1}},
                      {"an angle of 10^22", {1e22, 0.5}},
                      {"a right angle", {std::numbers::pi / 2, 1}},
                      {"the product underflows", {1, 0x1p-1074}},
                      {"a negative foreshortening", {1, -0.5}},
                      {"an infinite angle", {wrong, 1}}}},
           exact_relation("laws",
                          "parallels and ratios stay, distance diminishes nothing, and twice is as once, by "
                          "matrix, too",
                          17, laws_hold)}};
}

}  // namespace gradus::stress
