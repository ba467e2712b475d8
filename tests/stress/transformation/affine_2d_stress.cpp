// The promises of transformations in the plane.

#include "stress/transformation/affine_2d.hpp"

#include <algorithm>
#include <array>

#include "stress/exactly.hpp"
#include "stress/scales.hpp"
#include "transformation/affine_2d/affine_2d.hpp"

namespace gradus::stress {
namespace {

using namespace gradus::affine_2d;

/// A matrix by its rows: xx, xy, x0, yx, yy, y0.
template <class T>
Matrix<T> matrix_in(const std::vector<T>& i) {
  return {i[0], i[3], T(0), i[1], i[4], T(0), i[2], i[5], T(1)};
}
ExactVec2 exact_point(const Input& i, std::size_t from) { return {Exact(i[from]), Exact(i[from + 1])}; }

// --- A point under a matrix ------------------------------------------------------------------------------

Input matrix_and_point(Kind kind, Random& random) {
  Input input = numbers_of(kind, random, 8);
  if (kind == Kind::near_degenerate) {
    // Both rows nearly undo themselves
    input[1] = nudged(-input[0], random);
    input[7] = nudged(input[6], random);
    input[2] = input[5] = 0;
  } else if (kind == Kind::huge || kind == Kind::extremes) {
    for (std::size_t i = 6; i < 8; ++i) input[i] = random.uniform(-1, 1);
  }
  return input;
}

/// The error of a row's sum in ulp of its largest possible value; 0 where that overflows.
template <class T>
double row_error(T found, const T* row, T x, T y) {
  const Exact first = Exact(row[0]) * Exact(x), second = Exact(row[1]) * Exact(y), last(row[2]);
  const Exact size = abs(first) + abs(second) + abs(last);
  if (overflows<T>(size)) return 0;
  if (!std::isfinite(found)) return wrong;
  return in_bounds(abs(first + second + last - Exact(found)), ulp_of<T>(size));
}

template <class T>
double transform_error(const std::vector<T>& i) {
  if (!all_finite(i)) return 0;
  const Point<T> p = transform(matrix_in(i), Point<T>(i[6], i[7]));
  return std::max(row_error(p.x, &i[0], i[6], i[7]), row_error(p.y, &i[3], i[6], i[7]));
}

// --- The mirror through two points -----------------------------------------------------------------------

Input two_points(Kind kind, Random& random) {
  Input input = numbers_of(kind, random, 4);
  if (kind == Kind::near_degenerate) {
    input[2] = nudged(input[0], random);
    input[3] = nudged(input[1], random);
  } else if (kind == Kind::grazing) {
    input[static_cast<std::size_t>(random.uniform_int(2, 3))] *= 1e-200;
    input[0] = input[1] = 0;
  }
  return input;
}

template <class T>
double mirror_error(const std::vector<T>& i) {
  const Point<T> a{i[0], i[1]}, b{i[2], i[3]}, d = b - a;
  const auto mirror = accepted([&] { return reflection_in_line(a, b); });
  if (mirror.has_value() != (gradus::all_finite(a.x, a.y, d.x, d.y) && a != b)) return wrong;
  if (!mirror) return 0;
  const Exact x(d.x), y(d.y), square = x * x + y * y;
  const Exact cos = (x * x - y * y) / square, sin = Exact(2) * x * y / square;
  const Exact entries[] = {cos, sin, sin, -cos};
  double worst = 0;
  for (int k = 0; k < 4; ++k) {
    const T found = mirror->linear[k / 2][k % 2];
    if (!std::isfinite(found)) return wrong;
    worst = std::max(worst, in_bounds(abs(entries[k] - Exact(found)), ulp_of<T>(Exact(1))));
  }
  return worst;
}

// --- The way back ----------------------------------------------------------------------------------------

Input any_matrix(Kind kind, Random& random) {
  Input input = numbers_of(kind == Kind::refused ? Kind::random : kind, random, 6);
  if (kind == Kind::near_degenerate || kind == Kind::grazing) {
    // Rows that are nearly, or exactly, multiples of each other
    const double share = kind == Kind::grazing ? std::ldexp(1.0, static_cast<int>(random.uniform_int(-9, 9)))
                                               : random.uniform(-3, 3);
    input[3] = share * input[0];
    input[4] = kind == Kind::grazing ? share * input[1] : nudged(share * input[1], random);
  }
  if (kind == Kind::refused) {
    input[static_cast<std::size_t>(random.uniform_int(0, 5))] = random.unit() < 0.5 ? std::nan("") : wrong;
  }
  return input;
}

/// The largest share of what is promised that is used up.
template <class T>
double inverse_error(const std::vector<T>& i) {
  const auto answer = accepted([&] { return inverse(matrix_in(i)); });
  if (answer.has_value() != all_finite(i)) return wrong;
  if (!answer) return 0;
  const std::optional<Matrix<T>>& found = *answer;
  const Matrix<Exact> m(matrix_in(i));
  const Exact size = abs(m[0].x * m[1].y) + abs(m[1].x * m[0].y), det = abs(determinant(m));
  constexpr double ulp = std::numeric_limits<T>::epsilon();
  const double ulps = in_bounds(det, Exact(ulp) * size);
  // Between 1/2 and 2 rounding may decide whether it flattens
  if (ulps <= 0.5) return found ? wrong : 0;
  const double off = 4 / ulps, most = std::numeric_limits<T>::max() * (1 - 2 * off);
  const Exact smallest(std::numeric_limits<T>::denorm_min());
  const Matrix<Exact> right = *inverse(m);
  double worst = 0;
  bool representable = true;
  for (int k = 0; k < 6; ++k) {
    const int column = k / 2, row = k % 2;
    const Exact exact = right[column][row];
    representable = representable && std::abs(to_double(exact)) < most;
    if (!found) continue;
    const T entry = (*found)[column][row];
    if (!std::isfinite(entry)) return wrong;
    const Exact terms = column < 2 ? abs(exact) : abs(right[0][row] * m[2].x) + abs(right[1][row] * m[2].y);
    worst = std::max(worst, in_bounds(abs(exact - Exact(entry)), Exact(off) * terms + smallest / Exact(2)));
  }
  return !found && ulps > 2 && representable ? wrong : worst;
}

template <class T>
bool is_plain(const std::vector<T>& i) {
  return affine_2d::detail::are_moderate<T>(i[0], i[1], i[2], i[3], i[4], i[5]);
}

/// Plain numbers give the bits that numbers without bounds to their exponents do.
template <class T>
double plain_inverse_error(const std::vector<T>& i) {
  if (!all_finite(i)) return 0;
  const Matrix<T> m = matrix_in(i);
  const auto back = inverse(m);
  const auto boundless = affine_2d::detail::inverse_in(m, affine_2d::detail::Boundless{});
  if (back.has_value() != boundless.has_value()) return wrong;
  if (!back) return 0;
  if (flattens(glm::mat<2, 2, T>(m))) return wrong;
  for (int k = 0; k < 6; ++k) {
    const T x = (*back)[k / 2][k % 2], y = (*boundless)[k / 2][k % 2];
    if (x != y || std::signbit(x) != std::signbit(y)) return wrong;
  }
  return 0;
}

// --- The nearest rotation: xx, xy, yx, yy ----------------------------------------------------------------

template <class T>
double rotation_error(const std::vector<T>& i) {
  const auto found = accepted(
      [&] { return nearest_rotation(Matrix<T>{i[0], i[2], T(0), i[1], i[3], T(0), T(0), T(0), T(1)}); });
  if (!all_finite(i)) return found ? wrong : 0;
  const Exact xx(i[0]), xy(i[1]), yx(i[2]), yy(i[3]);
  if (found.has_value() != (xx * yy - xy * yx > Exact(0))) return wrong;
  const T most = std::numeric_limits<T>::max() / 2;
  if (!found || std::ranges::any_of(i, [&](T x) { return std::abs(x) > most; })) return 0;
  const T cos = (*found)[0].x, sin = (*found)[0].y;
  if (!gradus::all_finite(cos, sin) || (*found)[1].x != -sin || (*found)[1].y != cos) return wrong;
  // The mean of the turns that the columns say
  const Exact c(cos), s(sin), ulp = ulp_of<T>(Exact(1)), along = xx + yy, across = yx - xy;
  if (c * along + s * across <= Exact(0)) return wrong;
  if (abs(c * across - s * along) > Exact(8) * ulp * (abs(along) + abs(across))) return wrong;
  return in_bounds(abs(c * c + s * s - Exact(1)), ulp);
}

// --- In exact arithmetic ---------------------------------------------------------------------------------

/// A point, a centre, factors, the tangent of half an angle, and two points of a mirror.
bool formulas_hold(const Input& i) {
  const ExactVec2 p = exact_point(i, 0), c = exact_point(i, 2), f = exact_point(i, 4);
  const ExactVec2 a = exact_point(i, 7), b = exact_point(i, 9);
  const Turn<Exact> t = rational_turn(Exact(i[6]));
  const auto gives = [&](const Factor<Exact>& factor, const ExactVec2& place) {
    return transform(matrix(factor), p) == place && transform(factor, p) == place;
  };
  const Factor<Exact> shear = shearing(f, c), turn = rotation(t, c);
  if (!gives(translation(f), p + f) || !gives(scaling(f, c), scaled(p, f, c)) ||
      !gives(turn, turned(p, t.sin, t.cos, c)) || !gives(shear, sheared(p, f, c))) {
    return false;
  }
  // About a point is: there, about the origin, and back
  const Matrix<Exact> there = matrix(translation(c)), back = matrix(translation(ExactVec2(-c)));
  if (there * matrix(shearing(f)) * back != matrix(shear)) return false;
  if (determinant(matrix(shear)) != Exact(1) - f.x * f.y) return false;
  // A rotation keeps lengths
  const ExactVec2 was = p - c, is = transform(turn, p) - c;
  if (glm::dot(is, is) != glm::dot(was, was)) return false;
  if (a == b) return true;
  // A mirror keeps its line, and swaps its sides at right angles
  const Matrix<Exact> mirror = matrix(reflection_in_line(a, b));
  const ExactVec2 image = transform(mirror, p);
  return transform(mirror, a) == a && transform(mirror, b) == b && determinant(mirror) == Exact(-1) &&
         mirror * mirror == Matrix<Exact>(Exact(1)) && orient2d(a, b, p) == -orient2d(a, b, image) &&
         glm::dot(image - p, b - a) == Exact(0);
}

/// A kind of factor, and two points.
constexpr std::size_t most_factors = 5, numbers_a_factor = 5;

Factor<Exact> factor_in(const Input& i, std::size_t from) {
  const ExactVec2 p = exact_point(i, from + 1), q = exact_point(i, from + 3);
  switch (static_cast<int>(std::abs(i[from])) % 6) {
    case 0:
      return translation(p);
    case 1:
      return scaling(p, q);
    case 2:
      return rotation(rational_turn(p.x), q);
    case 3:
      return shearing(p, q);
    case 4:
      return reflection_in_diagonal<Exact>();
    default:
      return p == q ? translation(p) : reflection_in_line(p, q);
  }
}

/// How many, the factors, three points of a shape, and an origin.
constexpr std::size_t chain_numbers = 1 + most_factors * numbers_a_factor + 8;

Input any_chain(Kind kind, Random& random) {
  Input input = small_fractions(chain_numbers, kind, random);
  input[0] = static_cast<double>(random.uniform_int(0, 4));
  for (std::size_t k = 0; k < most_factors; ++k) {
    input[1 + k * numbers_a_factor] = static_cast<double>(random.uniform_int(0, 5));
  }
  return input;
}

std::vector<Factor<Exact>> factors_in(const Input& i) {
  std::vector<Factor<Exact>> factors;
  const auto last = static_cast<std::size_t>(std::abs(i[0])) % most_factors;
  for (std::size_t k = 0; k <= last; ++k) factors.push_back(factor_in(i, 1 + k * numbers_a_factor));
  return factors;
}

Exact determinant_of(const std::vector<Factor<Exact>>& factors) {
  Exact product(1);
  for (const auto& factor : factors) product *= determinant(matrix(factor));
  return product;
}

bool all_ways_agree(const Input& i) {
  const std::vector<Factor<Exact>> factors = factors_in(i);
  const std::span<const Factor<Exact>> chain(factors);
  const std::size_t at = chain_numbers - 8;
  const std::vector<ExactVec2> shape{exact_point(i, at), exact_point(i, at + 2), exact_point(i, at + 4)};
  const ExactVec2 origin = exact_point(i, at + 6);
  std::vector<ExactVec2> a = shape, b = shape, local = shape;
  const Matrix<Exact> m = one_matrix(chain, std::span(a));
  factor_by_factor(chain, std::span(b));
  local_coordinates(origin, chain, std::span(local));
  for (std::size_t k = 0; k < shape.size(); ++k) {
    if (a[k] != transform(m, shape[k]) || a[k] != b[k] || a[k] != origin + local[k]) return false;
  }
  const Exact det = determinant_of(factors);
  const auto back = inverse(m);
  const bool undone = undo(chain, std::span(a));
  if (determinant(m) != det || undone != (det != Exact(0)) || back.has_value() != undone) return false;
  return !undone || (a == shape && *back * m == Matrix<Exact>(Exact(1)));
}

// --- Far from the origin: a pivot (c, -c), degrees, a point beside it ------------------------------------

Input far_pivot(Kind, Random& random) {
  const auto beside = [&] { return std::ldexp(std::floor(random.uniform(-1024, 1024)), -10); };
  const double away = std::ldexp(1.0, static_cast<int>(random.uniform_int(20, 39)));
  return {away, random.uniform(0, 360), beside(), beside()};
}

/// The errors of local coordinates and of the matrix, in ulp of 1; nothing where the point would be rounded.
std::optional<std::array<double, 2>> far_errors(const Input& i) {
  const dvec2 pivot{i[0], -i[0]}, beside{i[2], i[3]};
  if (!all_finite(i) || std::abs(i[0]) > 0x1p40 || std::abs(i[2]) > 1 || std::abs(i[3]) > 1) return {};
  if ((pivot + beside) - pivot != beside) return {};
  const ExactScope scope;
  const Turn<double> turn = turn_degrees(i[1]);
  const Factor<double> factor = rotation(turn, pivot);
  const ExactVec2 right = turned(ExactVec2(beside), Exact(turn.sin), Exact(turn.cos), ExactVec2(Exact(0)));
  dvec2 local = pivot + beside, by_matrix = local;
  local_coordinates(pivot, std::span(&factor, 1), std::span(&local, 1));
  one_matrix(std::span(&factor, 1), std::span(&by_matrix, 1));
  const ExactVec2 off = ExactVec2(local) - right, lost = ExactVec2(by_matrix) - ExactVec2(pivot) - right;
  const auto ulps = [](const ExactVec2& v) { return to_double(std::max(abs(v.x), abs(v.y))) * 0x1p52; };
  return std::array{ulps(off), ulps(lost)};
}

double far_error(const Input& i) {
  const auto errors = far_errors(i);
  return errors ? (*errors)[0] : 0;
}

}  // namespace

Domain affine_2d() {
  const auto undone = [](const Input& i) {
    const ExactScope scope;
    return determinant_of(factors_in(i)) != Exact(0);
  };
  Property chains =
      exact_relation("chains", "all ways through a chain agree, and what does not flatten leads back",
                     chain_numbers, all_ways_agree, any_chain);
  chains.shares = {{"leads back", 1 / 3.0, undone},
                   {"flattens", 1 / 60.0, [=](const Input& i) { return !undone(i); }}};
  chains.cases = 3000;  // each takes a third of a millisecond
  return {
      "affine_2d",
      {{.name = "transform",
        .states = "within 3 ulp of |xx x| + |xy y| + |x0|, likewise in y",
        .unit = "ulp",
        .bound = 3,
        .numbers = 8,
        .generate = at_every_scale(matrix_and_point),
        .error = in_both([](const auto& i) { return transform_error(i); }),
        .traps = {{"the sum cancels", {1, -1, 0x1p-53, 1, 1, 0, 1, std::nextafter(1, 2)}},
                  {"products underflow", {1e-200, 0, 0, 0, 1e-200, 0, 1e-200, 1e-200}}}},
       {.name = "reflection_in_line",
        .states = "each entry within 4 ulp of 1",
        .unit = "ulp",
        .bound = 4,
        .numbers = 4,
        .generate = at_every_scale(two_points),
        .error = in_both([](const auto& i) { return mirror_error(i); }),
        .traps = {{"squares underflow", {0, 0, 1e-200, 2e-200}},
                  {"squares overflow", {0, 0, 1e200, -1e200}},
                  {"the smallest step", {1, 1, 1, std::nextafter(1, 2)}},
                  {"one point", {3, 4, 3, 4}},
                  {"too far apart", {-1.7e308, 0, 1.7e308, 1}},
                  {"no number", {0, 0, std::nan(""), 1}}}},
       {.name = "inverse",
        .states = "within 4 ulp of the entry's terms, times how far the determinant cancels; nothing where "
                  "it is 0 or an entry would be infinite",
        .unit = "bounds",
        .bound = 1,
        .numbers = 6,
        .generate = at_every_scale(any_matrix),
        .error = in_both([](const auto& i) { return inverse_error(i); }),
        .traps = {{"columns of two sizes", {1e200, 1e200, 0, 1e-200, -1e-200, 0}},
                  {"rows of two sizes", {1e200, 1e-200, 3, 1e200, -1e-200, 4}},
                  {"subnormal entries", {0x3p-1074, 0x1p-1074, 0, 0x1p-1074, 0x1p-1074, 0}},
                  {"subnormal beside 1", {1, 0x1p-1074, 0, 0x1p-1074, 1, 5}},
                  {"the determinant underflows", {1e-170, 1e-170, 1, -1e-170, 1e-170, 2}},
                  {"the determinant overflows", {1e200, 1e200, 1, -1e200, 1e200, 2}},
                  {"an entry would be infinite", {1e-310, 0, 0, 0, 1, 0}},
                  {"the shift comes back infinite", {1e-200, 0, 1e200, 0, 1e-200, 0}},
                  {"a shear that flattens", {1, 3, 0, 1.0 / 3, 1, 0}}}},
       {.name = "plain_inverse",
        .states = "plain numbers give the bits that numbers without bounds to their exponents do",
        .numbers = 6,
        .generate = at_every_scale(any_matrix),
        .error = in_both([](const auto& i) { return plain_inverse_error(i); }),
        .shares = {{"in plain doubles", 0.4, [](const Input& i) { return is_plain(i); }},
                   {"beyond them", 0.1, [](const Input& i) { return all_finite(i) && !is_plain(i); }},
                   {"in plain floats", 0.3, [](const Input& i) { return is_plain(as_floats(i)); }},
                   {"no inverse", 0.01,
                    [](const Input& i) { return all_finite(i) && !inverse(matrix_in(i)).has_value(); }}},
        .cases = 100'000},
       {.name = "nearest_rotation",
        .states = "the mean of the columns' turns, orthogonal to 3 ulp of 1, for every determinant above 0; "
                  "others are refused",
        .unit = "ulp",
        .bound = 3,
        .numbers = 4,
        .generate = at_every_scale([](Kind kind, Random& random) {
          const Input m = any_matrix(kind, random);
          return Input{m[0], m[1], m[3], m[4]};
        }),
        .error = in_both([](const auto& i) { return rotation_error(i); }),
        .traps = {{"orthogonal to 2.3 ulp only",
                   {-0x1.17a480e6fc43p+1, 0x1.0de2407d8b7acp+3, -0x1.cb7a4df6da7a8p+1, 0x1.b163e9cbdd974p+3}},
                  {"the determinant underflows", {1e-200, 0, 0, 1e-200}},
                  {"the determinant overflows", {1e200, -1e200, 1e200, 1e200}},
                  {"a determinant of 2^-2148", {0x1p-1074, 0, 0, 0x1p-1074}},
                  {"the smallest, half a right angle", {0x1p-1074, -0x1p-1074, 0x1p-1074, 0x1p-1074}},
                  {"a mirror", {1, 0, 0, -1}},
                  {"nothing", {0, 0, 0, 0}},
                  {"flat", {1, 2, 2, 4}}}},
       exact_relation(
           "coordinate_formulas",
           "matrices are the formulas of textbooks, turns keep lengths, and mirrors swap the sides "
           "of their line",
           11, formulas_hold),
       chains,
       {.name = "local_coordinates",
        .states = "within 2 ulp of 1 beside a pivot as far as 2^40, where the matrix is not",
        .unit = "ulp",
        .bound = 2,
        .numbers = 4,
        .kinds = {Kind::random},
        .generate = far_pivot,
        .error = far_error,
        .traps = {{"part 4's example", {0x1p40, 30, 1, 0}}},
        .shares = {{"the matrix is off by 1e-5", 0.1, [](const Input& i) {
                      const auto errors = far_errors(i);
                      return errors && (*errors)[1] > 1e-5 * 0x1p52;
                    }}}}}};
}

}  // namespace gradus::stress
