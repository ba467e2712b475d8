// The promises of Bézier patches: points and tangents within their roundings of tensor sums of Bernstein
// polynomials in exact rationals, joined rows within theirs; and what joining must give exactly.

#include "modeling/bezier_patch/bezier_patch.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "stress/exactly.hpp"
#include "stress/scales.hpp"

namespace gradus::stress {
namespace {

using namespace bezier_patch;

/// Rows of 4 and of 3 control points: degrees 3 along u and 2 along v.
constexpr Index columns = 4, rows = 3, count = 3 * columns * rows;
constexpr Index n = columns - 1, m = rows - 1;

template <class T>
Patch<T> patch_in(const std::vector<T>& numbers) {
  Patch<T> patch{columns, {}};
  for (Index k = 0; k < columns * rows; ++k) patch.points.push_back(vector_in(numbers, 3 * k));
  return patch;
}

/// The control points, u and v.
Input generate(Kind kind, Random& random) {
  Input input = numbers_of(kind, random, count + 2);
  if (kind == Kind::near_degenerate || kind == Kind::grazing || kind == Kind::ties) {
    // Rows of one point, or nearly
    for (Index k = 0; k < count; ++k) {
      const Index first = k / (3 * columns) * 3 * columns + k % 3;
      if (kind == Kind::ties)
        input[k] = input[first];
      else
        input[k] = nudged(input[first], random);
    }
  }
  const double places[] = {0, 1, 0.5, random.unit(), random.unit(), std::ldexp(random.unit(), -40)};
  for (const Index k : {count, count + 1}) input[k] = places[random.uniform_int(0, 5)];
  return input;
}

Exact power(const Exact& x, Index exponent) {
  Exact all(1);
  for (Index k = 0; k < exponent; ++k) all = all * x;
  return all;
}
/// Bernstein's polynomial i of a degree, or its derivative: by powers and binomial numbers.
Exact weight(Index degree, Index i, const Exact& t, bool derived) {
  if (derived) {
    const Exact before = i > 0 ? weight(degree - 1, i - 1, t, false) : Exact(0);
    const Exact here = i < degree ? weight(degree - 1, i, t, false) : Exact(0);
    return Exact(degree) * (before - here);
  }
  constexpr int ways[4][4] = {{1}, {1, 1}, {1, 2, 1}, {1, 3, 3, 1}};
  return Exact(ways[degree][i]) * power(t, i) * power(Exact(1) - t, degree - i);
}
template <class T>
Point<Exact> right_of(const Patch<T>& patch, const Exact& u, const Exact& v, bool along_u, bool along_v) {
  Point<Exact> sum(Exact(0));
  for (Index j = 0; j < patch.rows(); ++j) {
    for (Index i = 0; i < patch.columns; ++i) {
      const Exact w = weight(patch.columns - 1, i, u, along_u) * weight(patch.rows() - 1, j, v, along_v);
      for (int axis = 0; axis < 3; ++axis) sum[axis] = sum[axis] + w * Exact(patch(j, i)[axis]);
    }
  }
  return sum;
}

template <class T>
double off(const Point<T>& found, const Point<Exact>& right, const Exact& bound) {
  double most = 0;
  for (int axis = 0; axis < 3; ++axis)
    most = std::max(most, in_bounds(abs(Exact(found[axis]) - right[axis]), bound));
  return most;
}
/// So many u M, and so many of the smallest numbers.
template <class T>
Exact allowed(const Patch<T>& patch, const Exact& roundings, Index smallest) {
  return roundings * rounding_unit<T>() * Exact(largest_of(patch.points)) +
         Exact(smallest) * Exact(std::numeric_limits<T>::denorm_min());
}

/// Whether these numbers are an input; others must be refused.
template <class T>
bool taken(const std::vector<T>& numbers) {
  const T most = std::numeric_limits<T>::max() / 1024;
  const auto is_place = [](T t) { return 0 <= t && t <= 1; };
  return std::all_of(numbers.begin(), numbers.end() - 2, [&](T x) { return std::abs(x) <= most; }) &&
         is_place(numbers[count]) && is_place(numbers[count + 1]);
}
const auto drop = [](const auto&) {};

const auto point_error = []<class T>(const std::vector<T>& numbers) -> double {
  const Patch<T> patch = patch_in(numbers);
  const T u = numbers[count], v = numbers[count + 1];
  const auto found = accepted([&] { return de_casteljau(patch, u, v); });
  if (found.has_value() != taken(numbers)) return wrong;
  if (!found) return 0;
  if (de_casteljau(patch, u, v, drop).point != found->point) return wrong;
  return off(found->point, right_of(patch, Exact(u), Exact(v), false, false),
             allowed(patch, Exact(5, 2) * Exact(n + m), n + m));
};
const auto tangent_error = []<class T>(const std::vector<T>& numbers) -> double {
  if (!taken(numbers)) return 0;
  const Patch<T> patch = patch_in(numbers);
  const T u = numbers[count], v = numbers[count + 1];
  const auto f = de_casteljau(patch, u, v);
  const auto bound = [&](Index k) { return allowed(patch, Exact(5 * k * (n + m)), 2 * k * (n + m)); };
  return std::max(off(f.along_u, right_of(patch, Exact(u), Exact(v), true, false), bound(n)),
                  off(f.along_v, right_of(patch, Exact(u), Exact(v), false, true), bound(m)));
};
/// The rows of C2, and that of G1 at any length.
const auto rows_error = []<class T>(const std::vector<T>& numbers) -> double {
  if (!taken(numbers)) return 0;
  const Patch<T> patch = patch_in(numbers);
  const T k = 16 * std::max(numbers[count], T(0x1p-10));
  const Patch<T> bent = join(patch, patch, Continuity::C2, k),
                 straight = join(patch, patch, Continuity::G1, k);
  double most = bent.row(0) == patch.row(m) && straight.row(2) == patch.row(2) ? 0 : wrong;
  for (Index i = 0; i < columns; ++i) {
    Point<Exact> free, next, third;
    for (int axis = 0; axis < 3; ++axis) {
      const Exact a(patch(m - 1, i)[axis]), b(patch(m, i)[axis]), c(patch(m - 2, i)[axis]);
      free[axis] = (Exact(1) + Exact(k)) * b - Exact(k) * a;
      next[axis] = b + b - a;
      third[axis] = Exact(4) * b - Exact(4) * a + c;
    }
    most = std::max({most, off(straight(1, i), free, allowed(patch, Exact(6) * Exact(k) + Exact(1), 1)),
                     off(bent(1, i), next, allowed(patch, Exact(7), 1)),
                     off(bent(2, i), third, allowed(patch, Exact(17), 1))});
  }
  return most;
};

// --- Exact relations

Patch<Exact> exact_patch(const Input& input) {
  Patch<Exact> patch{columns, {}};
  for (Index k = 0; k < columns * rows; ++k)
    patch.points.push_back({Exact(input[3 * k]), Exact(input[3 * k + 1]), Exact(input[3 * k + 2])});
  return patch;
}
Patch<Exact> flipped(const Patch<Exact>& patch) {
  Patch<Exact> turned{patch.rows(), {}};
  for (Index i = 0; i < patch.columns; ++i) {
    for (Index j = 0; j < patch.rows(); ++j) turned.points.push_back(patch(j, i));
  }
  return turned;
}

/// Rows first or columns first, and the sum of Bernstein polynomials: one point, one normal but for its side.
bool is_one_surface(const Input& input) {
  const Patch<Exact> patch = exact_patch(input);
  const Exact u(3, 8), v(2, 5);
  const auto f = de_casteljau(patch, u, v), g = de_casteljau(flipped(patch), v, u);
  return f.point == g.point && f.along_u == g.along_v && f.normal == -g.normal &&
         f.point == right_of(patch, u, v, false, false) && f.along_u == right_of(patch, u, v, true, false);
}
/// A column of the part of a patch from v = 1/2 on, or up to there: control points by blossoming.
Patch<Exact> half(const Patch<Exact>& patch, bool second) {
  Patch<Exact> part = patch;
  for (Index i = 0; i < columns; ++i) {
    const auto &a = patch(0, i), &b = patch(1, i), &c = patch(2, i);
    const Exact quarter(1, 4), two(2);
    part(0, i) = second ? quarter * (a + two * b + c) : a;
    part(1, i) = second ? Exact(1, 2) * (b + c) : Exact(1, 2) * (a + b);
    part(2, i) = second ? c : quarter * (a + two * b + c);
  }
  return part;
}
/// Parts cut from one patch go on smoothly: joining finds the second one again.
bool finds_its_other_half(const Input& input) {
  const Patch<Exact> patch = exact_patch(input);
  return join(half(patch, false), patch, Continuity::C2, Exact(1)).points == half(patch, true).points;
}
/// All along the seam: G1 has parallel first derivatives, k times as long, C1 the same.
bool agrees_along_the_seam(const Input& input) {
  const Patch<Exact> patch = exact_patch(input);
  const Exact k(3, 4);
  const auto along = [](const Patch<Exact>& p, const Exact& u, int v) {
    return right_of(p, u, Exact(v), false, true);
  };
  const auto G1 = join(patch, patch, Continuity::G1, k), C1 = join(patch, patch, Continuity::C1, k);
  for (const Exact& u : {Exact(0), Exact(1, 3), Exact(7, 8)}) {
    const Point<Exact> here = along(patch, u, 1);
    if (along(G1, u, 0) != k * here || along(C1, u, 0) != here) return false;
  }
  return true;
}

}  // namespace

Domain bezier_patch() {
  const auto promise = [](std::string name, std::string states, std::int64_t cases, auto judge) {
    std::vector<std::size_t> lengths(count);
    std::iota(lengths.begin(), lengths.end(), std::size_t{0});
    Input largest(count + 2, std::numeric_limits<double>::max() / 1024), one(count + 2, 0.3), smallest = one;
    for (Index k = 0; k < count; ++k) {
      if (k % 2 == 0) largest[k] *= -1;
      smallest[k] = k % 3 == 0 ? 5e-324 : 0;
    }
    largest[count] = largest[count + 1] = 0.9;
    Input beyond = one, none = one;
    beyond[4] = 1e306;
    none[7] = std::nan("");
    return Property{.name = std::move(name),
                    .states = std::move(states),
                    .unit = "of the bound",
                    .bound = 1,
                    .numbers = count + 2,
                    .generate = at_every_scale(generate, lengths),
                    .error = in_both(judge),
                    .traps = {{"all control points one", one},
                              {"the largest numbers", largest},
                              {"the smallest numbers", smallest},
                              {"beyond the largest", beyond},
                              {"no number", none}},
                    .cases = cases};
  };
  return {"bezier_patch",
          {promise("points", "points within 2.5 (n + m) u M of the exact ones, M the largest coordinate", 300,
                   point_error),
           promise("tangents", "tangents within 5 k (n + m) u M of the exact ones, k = n or m", 300,
                   tangent_error),
           promise("rows", "joined rows within (6 k + 1) u M, those of C2 within 17 u M", 300, rows_error),
           exact_relation("surface", "rows first, columns first and the sum of Bernstein polynomials are one",
                          count, is_one_surface),
           exact_relation("halves", "of a patch cut in two, joining finds the second part from the first",
                          count, finds_its_other_half),
           exact_relation("seam", "first derivatives agree all along a seam, those of G1 in direction", count,
                          agrees_along_the_seam)}};
}

}  // namespace gradus::stress
