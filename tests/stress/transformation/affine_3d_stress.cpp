// The promises of transformations in space.

#include "stress/transformation/affine_3d.hpp"

#include <algorithm>
#include <boost/multiprecision/cpp_bin_float.hpp>

#include "stress/exactly.hpp"
#include "stress/scales.hpp"
#include "transformation/affine_3d/affine_3d.hpp"

namespace gradus::stress {
namespace {

using namespace gradus::affine_3d;
using Float = boost::multiprecision::number<
    boost::multiprecision::cpp_bin_float<340, boost::multiprecision::digit_base_2>,
    boost::multiprecision::et_off>;

/// The largest entry of R^T R - I, exactly, in ulp of 1.
template <class T>
double off_orthogonal(const Matrix<T>& m) {
  double worst = 0;
  for (int i = 0; i < 3; ++i) {
    if (!gradus::all_finite(m[i].x, m[i].y, m[i].z)) return wrong;
    for (int k = 0; k <= i; ++k) {
      const Exact product = glm::dot(ExactVec3(m[i]), ExactVec3(m[k]));
      worst = std::max(worst, in_bounds(abs(product - Exact(i == k ? 1 : 0)), ulp_of<T>(Exact(1))));
    }
  }
  return worst;
}

// --- Rotations: an axis, radians --------------------------------------------------------------------------

Input axis_and_angle(Kind kind, Random& random) {
  Input input{number(kind, random), number(kind, random), number(kind, random), random.uniform(-7, 7)};
  if (kind == Kind::refused && all_finite(input)) input = {0, 0, 0, 1};
  if (kind == Kind::near_degenerate) {
    // Nearly along an axis of coordinates, nearly no angle
    input[0] *= 1e-17;
    if (random.unit() < 0.5) input[1] *= 1e-17;
    if (random.unit() < 0.5) input[3] *= 1e-9;
  } else if (kind == Kind::huge || kind == Kind::extremes) {
    input[3] = sized(random, 0, 80);
  } else if (kind == Kind::ties) {
    input[3] = 0.5 * static_cast<double>(random.uniform_int(-8, 8));
  }
  return input;
}

template <class T>
double rotation_error(const std::vector<T>& i) {
  const Point<T> axis = vector_in(i, 0);
  const auto found = accepted([&] { return rotation(axis, i[3]); });
  if (found.has_value() != (all_finite(i) && axis != Point<T>(0))) return wrong;
  return found ? off_orthogonal(*found) : 0;
}

/// The size of the axis makes no difference.
double size_error(const Input& i) {
  const dvec3 axis = vector_in(i, 0);
  const auto moderate = [](double x) {
    return x == 0 || (0x1p-400 <= std::abs(x) && std::abs(x) <= 0x1p400);
  };
  if (!all_finite(i) || axis == dvec3(0) || !std::all_of(i.begin(), i.begin() + 3, moderate)) return 0;
  const glm::dmat4 m = rotation(axis, i[3]);
  return rotation(axis * 0x1p600, i[3]) == m && rotation(axis * 0x1p-600, i[3]) == m ? 0 : wrong;
}

/// In units of 1e-15.
double entry_error(const Input& i) {
  const dvec3 axis = vector_in(i, 0);
  if (!all_finite(i) || axis == dvec3(0) || std::abs(i[3]) > 0x1p100) return 0;
  const glm::dmat4 found = rotation(axis, i[3]);
  const auto right = rotation_about<Float>(axis, i[3]);
  double worst = 0;
  for (int k = 0; k < 9; ++k) {
    const Float miss = abs(Float(found[k / 3][k % 3]) - right[static_cast<std::size_t>(k)]);
    worst = std::max(worst, static_cast<double>(miss) * 1e15);
  }
  return worst;
}

/// The largest share used up of what is promised of the other ways to turn: an axis, radians, a point of the
/// axis, a point.
double other_ways_error(const Input& i) {
  const ExactScope scope;
  const dvec3 axis = vector_in(i, 0), through = vector_in(i, 4), p = vector_in(i, 7);
  const double size = glm::length(through) + glm::length(p - through);
  if (!all_finite(i) || axis == dvec3(0) || !(0x1p-400 < size && size < 0x1p400)) return 0;
  const dvec3 n = direction_of(axis);
  const Turn<double> t = turn(i[3]);
  const Matrix<double> r = rodrigues(n, t), d = decomposition(dvec3(0), alignment(axis), t);
  const Matrix<double> k = rodrigues_by_cross_products(n, t), clean = rotation(axis, i[3]);
  double worst = std::max(off_orthogonal(r), off_orthogonal(d)) / 10;
  for (int e = 0; e < 9; ++e) {
    const int x = e / 3, y = e % 3;
    const double apart = std::max(std::abs(r[x][y] - d[x][y]), std::abs(r[x][y] - k[x][y]));
    worst = std::max({worst, apart * 0x1p52 / 8, std::abs(r[x][y] - clean[x][y]) * 1e15});
  }
  const double away = glm::distance(turn_vector(n, through, t, p), transform(about(through, clean), p));
  return std::max(worst, away / size * 0x1p52 / 8);
}

// --- A point under a matrix: four columns, then the point -------------------------------------------------

Input matrix_and_point(Kind kind, Random& random) {
  Input input = numbers_of(kind, random, 15);
  if (kind == Kind::near_degenerate) {
    // The first row nearly undoes itself
    input[14] = nudged(input[13], random);
    input[6] = nudged(-input[3], random);
    input[0] *= 1e-17, input[9] *= 1e-17;
  }
  return input;
}

template <class T>
Matrix<T> columns_in(const std::vector<T>& i, std::size_t count) {
  Matrix<T> m(T(1));
  for (std::size_t k = 0; k < count; ++k) {
    m[static_cast<int>(k)] = glm::vec<4, T>(vector_in(i, 3 * k), T(k == 3 ? 1 : 0));
  }
  return m;
}

template <class T>
double transform_error(const std::vector<T>& i) {
  if (!all_finite(i)) return 0;
  const Matrix<T> m = columns_in(i, 4);
  const Point<T> point = vector_in(i, 12), to = transform(m, point);
  const Exact u = rounding_unit<T>(), smallest(std::numeric_limits<T>::denorm_min());
  double worst = 0;
  for (int row = 0; row < 3; ++row) {
    Exact sum(m[3][row]), size = abs(sum), lost(0);
    for (int k = 0; k < 3; ++k) {
      const Exact product = Exact(m[k][row]) * Exact(point[k]);
      sum += product;
      size += abs(product);
      if (!fits<T>(product) && std::abs(to_double(product)) < 1) lost += smallest / Exact(2);
    }
    if (overflows<T>(size)) continue;
    if (!std::isfinite(to[row])) return wrong;
    const Exact bound = size * Exact(4) * u * (Exact(1) + Exact(3) * u) + lost;
    worst = std::max(worst, in_bounds(abs(sum - Exact(to[row])), bound));
  }
  return worst;
}

// --- Normals: three columns -------------------------------------------------------------------------------

Input three_columns(Kind kind, Random& random) {
  Input input = numbers_of(kind, random, 9);
  if (kind == Kind::near_degenerate || kind == Kind::grazing) {
    // The third column in the plane of the others, but for the last places
    const double s = random.uniform(-2, 2), t = random.uniform(-2, 2);
    for (std::size_t k = 0; k < 3; ++k) input[6 + k] = nudged(s * input[k] + t * input[3 + k], random);
  }
  return input;
}

double normal_error(const Input& i) {
  const ExactScope scope;
  const Matrix<double> m = columns_in(i, 3);
  const auto answer = accepted([&] { return normal_matrix(m); });
  if (answer.has_value() != all_finite(i)) return wrong;
  if (!answer) return 0;
  const glm::dmat3& found = *answer;
  double largest = 0;
  for (const double x : i) largest = std::max(largest, std::abs(x));
  if (largest == 0) return found == glm::dmat3(0) ? 0 : wrong;
  // What may count as 0 may decide the sign
  if (std::ranges::any_of(i, [&](double x) { return x != 0 && std::abs(x) < 0x1p-499 * largest; })) return 0;
  const int exponent = std::ilogb(largest);
  const Exact scale =
      Exact(std::ldexp(1.0, -exponent / 2)) * Exact(std::ldexp(1.0, -exponent + exponent / 2));
  ExactVec3 columns[3];
  for (int k = 0; k < 3; ++k) columns[k] = ExactVec3(dvec3(m[k])) * scale;
  const Exact det = glm::dot(columns[0], glm::cross(columns[1], columns[2]));
  if (mirrors(m) != (det < Exact(0))) return wrong;
  const Exact side(det < Exact(0) ? -1 : 1), share = Exact(0x1p-52) * (Exact(1) + Exact(0x1p-53));
  double worst = 0;
  for (int k = 0; k < 9; ++k) {
    const ExactVec3 &a = columns[(k / 3 + 1) % 3], &b = columns[(k / 3 + 2) % 3];
    const int row = k % 3, next = (row + 1) % 3, last = (row + 2) % 3;
    const Exact left = a[next] * b[last], right = a[last] * b[next];
    if (!std::isfinite(found[k / 3][row])) return wrong;
    const Exact off = abs(side * (left - right) - Exact(found[k / 3][row]));
    worst = std::max(worst, in_bounds(off, share * (abs(left) + abs(right))));
  }
  return worst;
}

// --- Drifted rotations: the first two columns -------------------------------------------------------------

Input two_columns(Kind kind, Random& random) {
  Input input = numbers_of(kind == Kind::refused ? Kind::random : kind, random, 6);
  if (kind == Kind::near_degenerate || kind == Kind::grazing) {
    // Nearly along each other, at angles down to the last place; or a little beside a rotation
    const double angle = std::ldexp(random.uniform(-1, 1), static_cast<int>(random.uniform_int(-60, -2)));
    for (std::size_t k = 0; k < 3; ++k) {
      input[3 + k] = 2 * input[k] + (kind == Kind::grazing ? 0 : angle * input[3 + k]);
    }
    if (kind == Kind::grazing) {
      const auto k = static_cast<std::size_t>(random.uniform_int(3, 5));
      input[k] = nudged(input[k], random);
    }
  }
  if (kind == Kind::refused) {
    input[static_cast<std::size_t>(random.uniform_int(0, 5))] = random.unit() < 0.5 ? std::nan("") : wrong;
  }
  return input;
}

/// How far a vector is from the direction of another one, in ulp of 1.
double off_direction(const glm::dvec4& found, const ExactVec3& v) {
  const Exact largest = std::max({abs(v.x), abs(v.y), abs(v.z)});
  Float wide[3];
  for (int k = 0; k < 3; ++k) {
    // In two parts, for the quotient has more digits than a double
    const Exact quotient = v[k] / largest;
    const double high = to_double(quotient);
    wide[k] = Float(high) + Float(to_double(quotient - Exact(high)));
  }
  const Float length = sqrt(Float(wide[0] * wide[0] + wide[1] * wide[1] + wide[2] * wide[2]));
  double worst = 0;
  for (int k = 0; k < 3; ++k) {
    worst = std::max(worst, std::abs(static_cast<double>(Float(found[k] - wide[k] / length))) * 0x1p52);
  }
  return worst;
}

double orthonormal_error(const Input& i) {
  const ExactScope scope;
  const auto found = accepted([&] { return orthonormalized(columns_in(i, 2)); });
  if (!all_finite(i)) return found ? wrong : 0;
  // As the header has it: what is vanishingly small beside the largest may count as 0
  const ExactVec3 a(Scaled<double>(vector_in(i, 0)).vector), b(Scaled<double>(vector_in(i, 3)).vector);
  const ExactVec3 normal = glm::cross(a, b);
  const Exact sine = std::max({abs(normal.x), abs(normal.y), abs(normal.z)});
  if (sign(sine) == 0) return found ? wrong : 0;
  if (sine < Exact(0x1p-900)) return 0;
  if (!found) return wrong;
  return std::max(
      {off_orthogonal(*found), off_direction((*found)[0], a), off_direction((*found)[2], normal)});
}

// --- In exact arithmetic ----------------------------------------------------------------------------------

/// Tangents of half the angles that align an axis and of the turn, which of the two are made (0: round y
/// alone, 1: round x alone), a point of the axis, a point, a number; and three vectors.
constexpr std::size_t turn_numbers = 20;

ExactVec3 exact_vector(const Input& i, std::size_t from) { return ExactVec3(vector_in(i, from)); }

/// The vectors of the drawing obey its laws.
struct Drawing {
  ExactVec3 n, p, r, s;
  int steps = 0;
  bool right = true;

  template <class Step>
  void operator()(const Step& step) {
    ++steps;
    if constexpr (std::same_as<Step, Projected<Exact>>) {
      p = step.p, r = step.r;
      right = right && glm::cross(r, n) == ExactVec3(Exact(0));
    } else if constexpr (std::same_as<Step, Rejected<Exact>>) {
      s = step.s;
      right = right && r + s == p && glm::dot(s, n) == Exact(0);
    } else if constexpr (std::same_as<Step, Crossed<Exact>>) {
      right = right && glm::dot(step.v, s) == Exact(0) && glm::dot(step.v, step.v) == glm::dot(s, s);
    }
  }
};

/// The turns that align it make the axis: z, turned back round y, then round x.
bool turns_agree(const Input& i) {
  Alignment<Exact> align;
  if (i[3] != 0) align.x = rational_turn(Exact(i[0]));
  if (i[3] != 1) align.y = rational_turn(Exact(i[1]));
  const Turn<Exact> turn = rational_turn(Exact(i[2]));
  Matrix<Exact> out(Exact(1));
  if (align.y) out = rotation_y(reversed(*align.y)) * out;
  if (align.x) out = rotation_x(reversed(*align.x)) * out;
  const ExactVec3 n(out[2]), through = exact_vector(i, 4), p = exact_vector(i, 7);
  const Matrix<Exact> by_parts = decomposition(through, align, turn), straight = rodrigues(n, turn);
  if (glm::dot(n, n) != Exact(1) || rodrigues_by_cross_products(n, turn) != straight) return false;
  // About a point is there, and back
  if (by_parts != about(through, straight)) return false;
  if (by_parts != translation(through) * straight * translation(ExactVec3(-through))) return false;
  Drawing drawing{.n = n, .p = {}, .r = {}, .s = {}};
  const ExactVec3 to = transform(by_parts, p), on_axis = through + Exact(i[10]) * n;
  if (turn_vector(n, through, turn, p, drawing) != to || drawing.steps != 4 || !drawing.right) return false;
  // The axis stays, point by point; lengths stay
  const ExactVec3 was = p - through, is = to - through;
  if (transform(by_parts, on_axis) != on_axis || glm::dot(was, was) != glm::dot(is, is)) return false;
  const ExactVec3 a = exact_vector(i, 11), b = exact_vector(i, 14), c = exact_vector(i, 17);
  return glm::cross(a, glm::cross(b, c)) == b * glm::dot(a, c) - c * glm::dot(a, b);
}

/// Two points, factors of a scaling, a centre, the tangent of half an angle, a way.
bool chain_is_its_factors(const Input& i) {
  const std::vector<Matrix<Exact>> factors{scaling(exact_vector(i, 6)),
                                           about(exact_vector(i, 9), rotation_y(rational_turn(Exact(i[12])))),
                                           translation(exact_vector(i, 13))};
  const std::vector<ExactVec3> before{exact_vector(i, 0), exact_vector(i, 3)};
  std::vector<ExactVec3> points = before;
  one_matrix(std::span<const Matrix<Exact>>(factors), std::span(points));
  for (std::size_t k = 0; k < points.size(); ++k) {
    ExactVec3 p = before[k];
    for (const auto& factor : factors) p = transform(factor, p);
    if (points[k] != p) return false;
  }
  // A translation changes no distance
  const auto moved = [&](const ExactVec3& p) { return transform(factors[2], p); };
  return moved(before[1]) - moved(before[0]) == before[1] - before[0];
}

}  // namespace

Domain affine_3d() {
  const Generator generate = at_every_scale(axis_and_angle, {0, 1, 2});
  Property turns = exact_relation(
      "turns", "decomposition, Rodrigues' matrix and vectors agree, and the vectors obey their drawing",
      turn_numbers, turns_agree, [](Kind kind, Random& random) {
        Input input = small_fractions(turn_numbers, kind, random);
        input[3] = static_cast<double>(random.uniform_int(0, 2));
        return input;
      });
  turns.shares = {{"an axis in general position", 0.2,
                   [](const Input& i) { return i[3] == 2 && i[0] != 0 && i[1] != 0; }}};
  turns.cases = 5000;  // each takes a third of a millisecond
  const std::vector<Trap> traps{{"squares underflow", {1e-200, 0, 0, 1}},
                                {"squares overflow", {1e200, 1e200, 0, 1}},
                                {"no axis", {0, 0, 0, 1}},
                                {"1 - cos is 0", {1, 2, 3, 1e-9}},
                                {"a full reduction of the angle", {1, 2, 3, 1e22}},
                                {"an angle that is no number", {1, 2, 3, std::nan("")}}};
  return {"affine_3d",
          {{.name = "rotation",
            .states = "no entry of R^T R - I is above 4 ulp of 1",
            .unit = "ulp",
            .bound = 4,
            .numbers = 4,
            .generate = generate,
            .error = in_both([](const auto& i) { return rotation_error(i); }),
            .traps = traps},
           {.name = "rotation_entries",
            .states = "each entry within 1e-15",
            .unit = "1e-15",
            .bound = 1,
            .numbers = 4,
            .generate = generate,
            .error = entry_error,
            .traps = traps},
           {.name = "size_of_the_axis",
            .states = "axes of length 1, 2^-600 and 2^600 give the same bits",
            .numbers = 4,
            .kinds = {Kind::random, Kind::near_degenerate, Kind::ties},
            .generate = axis_and_angle,
            .error = size_error},
           {.name = "other_ways",
            .states = "Rodrigues' matrix and the decomposition orthogonal to 10 ulp of 1, within 8 ulp of "
                      "each other, 1e-15 of the rotation; the vectors within 8 ulp of theirs",
            .unit = "bounds",
            .bound = 1,
            .numbers = 10,
            .generate = at_every_scale(
                [](Kind kind, Random& random) {
                  Input input = axis_and_angle(kind, random);
                  for (int k = 0; k < 6; ++k) input.push_back(random.uniform(-3, 3));
                  return input;
                },
                {0, 1, 2}),
            .error = other_ways_error,
            .traps = {{"two coordinates vanish beside the third",
                       {0x1.9aaa06992ce94p+77, 0x1.97ff75249d0dp-951, -0x1.0ff8c02d3941p-948, -3.7, -2.8,
                        -1.3, -0.7, 1.1, -2.8, -1.2}}}},
           {.name = "transform",
            .states = "within 4 roundings of |xx x| + |xy y| + |xz z| + |x0|, likewise in y and z",
            .unit = "bounds",
            .bound = 1,
            .numbers = 15,
            .generate = at_every_scale(matrix_and_point),
            .error = in_both([](const auto& i) { return transform_error(i); })},
           {.name = "normal_matrix",
            .states =
                "cofactors within 2 roundings of their products, on the side that the exact determinant says",
            .unit = "bounds",
            .bound = 1,
            .numbers = 9,
            .generate = at_every_scale(three_columns),
            .error = normal_error,
            .traps = {{"products underflow", {1e-200, 0, 0, 0, 1e-200, 0, 0, 0, -1e-200}},
                      {"products overflow", {1e200, 0, 0, 0, 1e200, 0, 0, 0, -1e200}},
                      {"a determinant of -2^-3222", {0x1p-1074, 0, 0, 0, 0x1p-1074, 0, 0, 0, -0x1p-1074}},
                      {"flat", {1, 2, 3, 4, 5, 6, 7, 8, 9}}}},
           {.name = "orthonormalized",
            .states = "orthogonal to 2 ulp of 1, first column and normal kept to 2 ulp, at every angle",
            .unit = "ulp",
            .bound = 2,
            .numbers = 6,
            .generate = at_every_scale(two_columns),
            .error = orthonormal_error,
            .traps = {{"columns 2^-20 apart", {1, 0, 0, 1, 0x1p-20, 0}},
                      {"columns 2^-20 apart, askew", {0.6, 0.48, 0.64, 0.6 + 0x1p-20, 0.48, 0.64}},
                      {"columns 2^-40 apart, askew", {0.6, 0.48, 0.64, 0.6 + 0x1p-40, 0.48, 0.64}},
                      {"columns 2^-52 apart, askew", {0.6, 0.48, 0.64, 0.6 + 0x1p-52, 0.48, 0.64}},
                      {"columns 2^-900 apart", {1, 0, 0, 3, 0x1p-900, 0}},
                      {"columns an ulp apart", {1, 1, 1, 1, 1, 1 + 0x1p-52}},
                      {"products underflow", {1e-200, 0, 0, 0, 1e-200, 0}},
                      {"products overflow", {1e200, 1e200, 0, 1e200, -1e200, 0}},
                      {"the smallest columns", {0x1p-1074, 0, 0, 0x1p-1074, 0x1p-1074, 0}},
                      {"parallel", {1, 2, 3, -2, -4, -6}},
                      {"no column", {0, 0, 0, 1, 2, 3}}}},
           turns,
           exact_relation("chains", "one matrix is its factors, and translations change no distance", 16,
                          chain_is_its_factors)}};
}

}  // namespace gradus::stress
