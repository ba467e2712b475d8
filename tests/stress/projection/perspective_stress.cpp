// The promises of the perspective projection onto a plane, of the transformation, and of stored depth.

#include "stress/projection/perspective.hpp"

#include <algorithm>

#include "projection/perspective/perspective_notes.hpp"
#include "stress/exactly.hpp"
#include "stress/scales.hpp"

namespace gradus::stress {
namespace {

using namespace gradus::perspective;

// --- Projection and vanishing points: the plane's distance d, then x, y, z -------------------------------

Input plane_and_point(Kind kind, Random& random) {
  Input input{std::abs(number(kind, random)), number(kind, random), number(kind, random),
              number(kind, random)};
  if (random.unit() < 0.75) input[3] = std::abs(input[3]);
  if (kind == Kind::near_degenerate) {
    // Beside the plane, or nearly in the eye
    input[3] = random.unit() < 0.5 ? nudged(input[0], random) : std::ldexp(input[3], -1000);
  } else if (kind == Kind::grazing) {
    input[3] = random.unit() < 0.5 ? input[0] : 0;
  }
  return input;
}
void plane_before_eye(Input& i) { i[0] = std::abs(i[0]); }

template <class T>
double project_error(const std::vector<T>& i) {
  const T d = i[0], z = i[3];
  const glm::vec<3, T> point = vector_in(i, 1);
  const auto answer = accepted([&] { return project(d, point); });
  const auto kept = accepted([&] { return keep_z(d, point); });
  const auto matrix = accepted([&] { return matrix_onto(d); });
  for (const bool taken : {answer.has_value(), kept.has_value(), matrix.has_value()}) {
    if (taken != (d > 0)) return wrong;
  }
  if (!answer) return 0;
  const auto& image = *answer;
  const bool finite_one = z > 0 && gradus::all_finite(d / z, point.x * (d / z), point.y * (d / z));
  if (image.has_value() != finite_one) return wrong;
  if (*kept != (image ? std::optional(glm::vec<3, T>(image->x, image->y, z)) : std::nullopt)) {
    return wrong;
  }
  if (!image || !all_finite(i)) return 0;  // infinitely far away, say
  if (image->z != d || (z == d && *image != point)) return wrong;
  if (!std::isnormal(d / z)) return 0;
  const Exact u = rounding_unit<T>();
  const ExactVec3 right = *project(Exact(d), ExactVec3(point));
  double worst = 0;
  for (int k = 0; k < 2; ++k) {
    const Exact exact = Exact(d) * Exact(point[k]) / Exact(z);
    if (right[k] != exact) return wrong;
    if (!fits<T>(exact)) continue;
    const Exact bound = Exact(2) * u * (Exact(1) + u) * abs(exact);
    worst = std::max(worst, in_bounds(abs(Exact((*image)[k]) - exact), bound));
  }
  return worst;
}

template <class T>
double vanishing_error(const std::vector<T>& i) {
  const glm::vec<3, T> direction = vector_in(i, 1);
  if (!(i[0] > 0) || !all_finite(i)) return 0;
  const auto answer = accepted([&] { return vanishing_point(matrix_onto(i[0]), direction); });
  const bool points_somewhere = direction != glm::vec<3, T>(0);
  if (answer.has_value() != points_somewhere) return wrong;
  const Exact d(i[0]), z(i[3]);
  if (!answer || !fits<T>(Exact(1) / d) || !fits<T>(z / d)) return 0;  // beyond the domain
  const auto& found = *answer;
  const auto right = vanishing_point(matrix_onto(d), ExactVec3(direction));
  if (right.has_value() != (i[3] != 0)) return wrong;
  if (!right) return found ? wrong : 0;
  const Exact u = rounding_unit<T>(), share = Exact(3) * u * (Exact(1) + Exact(3) * u);
  const Exact largest(std::numeric_limits<T>::max());
  const Exact most = std::max(abs(right->x), abs(right->y));
  if (!found) return most > largest * (Exact(1) - share) ? 0 : wrong;
  if (most > largest * (Exact(1) + share)) return wrong;
  double worst = 0;
  for (int k = 0; k < 2; ++k) {
    const Exact exact = Exact(direction[k]) * d / z;
    if ((*right)[k] != exact) return wrong;
    if (!fits<T>(exact)) continue;
    worst = std::max(worst, in_bounds(abs(Exact((*found)[k]) - exact), share * abs(exact)));
  }
  return worst;
}

// --- The transformation: scales, near, far, then a point of view space -----------------------------------

Input lens_and_point(Kind kind, Random& random) {
  Input input = numbers_of(kind, random, 7);
  for (std::size_t k = 0; k < 4; ++k) input[k] = std::abs(input[k]);
  if (kind == Kind::near_degenerate) input[3] = nudged(input[2], random);
  if (kind == Kind::grazing) input[6] = random.unit() < 0.5 ? input[2] : input[3];
  return input;
}
void put_planes_in_order(Input& i) {
  for (std::size_t k = 0; k < 4; ++k) i[k] = std::abs(i[k]);
  put_in_order(i[2], i[3]);
}

template <class T>
double transform_error(const std::vector<T>& i) {
  if (!(0 < i[2] && i[2] < i[3]) || !all_finite(i)) return 0;
  const Projection<T> p = projection_of(i[0], i[1], i[2], i[3]);
  const glm::vec<3, T> view = vector_in(i, 4);
  const Exact scale(p.z_scale), u = rounding_unit<T>();
  if (!gradus::all_finite(p.z_scale, p.z_offset) || !fits<T>(scale * Exact(i[2]))) return 0;
  const glm::vec<4, T> clip = transform(p, view);
  if (clip.w != view.z || (view.z == i[2] && clip.z != 0)) return wrong;
  const Exact x = Exact(i[0]) * Exact(view.x), y = Exact(i[1]) * Exact(view.y);
  const Exact product = scale * Exact(view.z), z = product + Exact(p.z_offset);
  double worst = 0;
  const auto look_at = [&](T found, const Exact& exact, const Exact& terms, const Exact& last) {
    if (!fits<T>(terms) || !fits<T>(exact)) return;
    worst = std::max(worst, in_bounds(abs(Exact(found) - exact), (abs(terms) + last) * u));
  };
  look_at(clip.x, x, x, 0);
  look_at(clip.y, y, y, 0);
  if (fits<T>(product)) look_at(clip.z, z, product, abs(z) * (Exact(1) + Exact(2) * u));
  // The division, in front of the eye
  const auto tested = divide_tested(p, view);
  const auto ndc = accepted([&] { return divide(clip); });
  if (tested != ndc || ndc.has_value() != (view.z > 0)) return wrong;
  if (ndc && divide_untested(p, view) != *ndc) return wrong;
  if (!ndc || !gradus::all_finite(clip.x, clip.y, clip.z)) return worst;
  for (int k = 0; k < 3; ++k) {
    const Exact quotient = Exact(clip[k]) / Exact(clip.w);
    look_at((*ndc)[k], quotient, quotient, 0);
  }
  return worst;
}

// --- Stored depths: near, far, how far z lies between them -----------------------------------------------

constexpr DepthCurve curves[] = {DepthCurve::linear, DepthCurve::inverse, DepthCurve::reversed};
constexpr DepthFormat formats[] = {DepthFormat::fixed24, DepthFormat::float32};

Input depth_input(Kind kind, Random& random) {
  Input input{std::abs(number(kind, random)), std::abs(number(kind, random)), random.unit()};
  if (kind == Kind::near_degenerate) input[1] = input[0] * (1 + std::ldexp(random.unit(), -40));
  if (kind == Kind::grazing) input[2] = random.unit() < 0.5 ? 0 : 1;
  if (kind == Kind::ties) input[2] = std::round(8 * input[2]) / 8;
  put_in_order(input[0], input[1]);
  return input;
}

template <class T>
struct Depths {
  T near, far, z;
};
/// Nothing where the planes are not those of the promise, or a step would leave the normal numbers of T.
template <class T>
std::optional<Depths<T>> depths_in(const std::vector<T>& i) {
  const T most = std::same_as<T, float> ? T(0x1p50) : T(0x1p400);
  const T n = i[0], f = i[1];
  if (!(1 / most <= n && n < f && f <= most) || !(0 <= i[2] && i[2] <= 1)) return {};
  const T z = std::clamp(n + i[2] * (f - n), n, f);
  const Exact near(n), far(f), at(z), range = far - near;
  for (const Exact& part : {range, near / at, far / at, at - near, far - at, near / at * (far / at),
                            Exact(1) / range, near * far / (at * at * range)}) {
    if (!fits<T>(part)) return {};
  }
  return Depths<T>{n, f, z};
}

template <class T>
double depth_error(const std::vector<T>& i) {
  const auto depths = depths_in(i);
  if (!depths) return 0;
  const auto& [n, f, z] = *depths;
  const auto p = projection_of(Exact(1), Exact(1), Exact(n), Exact(f));
  const Exact transformed = divide(transform(p, ExactVec3{Exact(0), Exact(0), Exact(z)})).z;
  if (transformed != depth_between(DepthCurve::inverse, Exact(n), Exact(f), Exact(z))) return wrong;
  double worst = 0;
  for (const DepthCurve curve : curves) {
    const Exact exact = depth_between(curve, Exact(n), Exact(f), Exact(z)), u = rounding_unit<T>();
    if (depth_of(curve, Exact(n), Exact(f), Exact(z)) != exact) return wrong;
    if (!fits<T>(exact)) continue;
    const Exact roundings(curve == DepthCurve::linear ? 3 : 5);
    const Exact bound = roundings * u * (Exact(1) + Exact(8) * u) * exact;
    worst = std::max(worst, in_bounds(abs(Exact(depth_of(curve, n, f, z)) - exact), bound));
  }
  return worst;
}

double step_error(const Input& i) {
  const ExactScope scope;
  const auto depths = depths_in(i);
  if (!depths) return 0;
  const auto& [n, f, z] = *depths;
  double worst = 0;
  for (const DepthCurve curve : curves) {
    const double depth = depth_of(curve, n, f, z);
    const Exact near(n), far(f), at(z), range = far - near;
    const Exact slope = curve == DepthCurve::linear ? Exact(1) / range : near * far / (at * at * range);
    if (!(0 <= depth && depth <= 1)) continue;
    for (const DepthFormat format : formats) {
      const Exact step = Exact(spacing(format, depth)) / slope;
      if (!fits<double>(step)) continue;
      const Exact bound = Exact(12) * rounding_unit<double>() * step;
      worst = std::max(worst, in_bounds(abs(Exact(separable_step(curve, format, n, f, z)) - step), bound));
    }
  }
  return worst;
}

/// near, how many times as far the far plane is, where between them a surface lies (0 to 1, by ratio), and
/// which curve and format.
Input stored_input(Kind, Random& random) {
  return {std::ldexp(random.uniform(1, 2), static_cast<int>(random.uniform_int(-8, 4))),
          std::ldexp(random.uniform(1, 2), static_cast<int>(random.uniform_int(3, 20))), random.unit(),
          static_cast<double>(random.uniform_int(0, 5))};
}

/// What is stored for a depth, for one a fifth of a step on, and for one a step on. On the way the step may
/// grow a little.
struct Stored {
  std::uint32_t first, soon, next;
  bool falls;
};
std::optional<Stored> stored_in(const Input& i) {
  if (!(0x1p-8 <= i[0] && i[0] <= 0x1p5 && 8 <= i[1] && i[1] <= 0x1p21)) return {};
  if (!(0 <= i[2] && i[2] <= 1 && 0 <= i[3] && i[3] < 6)) return {};
  const auto code = static_cast<std::size_t>(i[3]);
  const DepthCurve curve = curves[code % 3];
  const DepthFormat format = formats[code / 3];
  const double near = i[0], far = near * i[1];
  const double z = std::min(near * gradus::exp(i[2] * gradus::log(i[1]) * 0.98), far);
  const double step = separable_step(curve, format, near, far, z), beyond = z + 1.05 * step;
  // Near 0 floats are finer than the doubles of z
  if (!(0x1p-40 * z < step && step < 0.01 * z) || beyond >= far) return {};
  const double apart = 1.05 * std::max(step, separable_step(curve, format, near, far, beyond));
  const auto at = [&](double depth) { return stored(format, depth_of(curve, near, far, depth)); };
  return Stored{at(z), at(z + 0.2 * step), at(z + apart), curve == DepthCurve::reversed};
}

double stored_error(const Input& i) {
  const auto depths = stored_in(i);
  if (!depths) return 0;
  return (depths->falls ? depths->first > depths->next : depths->first < depths->next) ? 0 : wrong;
}

// --- What stays straight ---------------------------------------------------------------------------------

/// The near plane, how far behind it the far one is, three points in front of the eye, and two shares.
Input triangle_before_eye(Kind kind, Random& random) {
  Input input = small_fractions(13, kind, random);
  for (const std::size_t k : {0u, 1u, 4u, 7u, 10u}) input[k] = std::abs(input[k]) + 0.5;
  for (const std::size_t k : {11u, 12u}) input[k] = static_cast<double>(random.uniform_int(1, 7)) / 16;
  return input;
}

bool collinear(const ExactVec3& a, const ExactVec3& b, const ExactVec3& c) {
  return glm::cross(b - a, c - a) == ExactVec3(Exact(0));
}

ExactVec3 exact_point(const Input& i, std::size_t from) { return ExactVec3(vector_in(i, from)); }

/// Through the eye or parallel to the picture lines stay lines also with z' = z.
bool bends(const ExactVec3& a, const ExactVec3& b) {
  return !collinear(ExactVec3(Exact(0)), a, b) && a.z != b.z;
}

struct Triangle {
  ExactVec3 a, b, c, on_line, inside;
};
std::optional<Triangle> triangle_in(const Input& i) {
  const auto is_share = [](double x) { return 0 < x && x < 1; };
  if (!(i[0] > 0 && i[1] > 0 && i[4] > 0 && i[7] > 0 && i[10] > 0)) return {};
  if (!is_share(i[11]) || !is_share(i[12])) return {};
  const ExactVec3 a = exact_point(i, 2), b = exact_point(i, 5), c = exact_point(i, 8);
  const Exact share(i[11]), other(i[12]);
  return Triangle{a, b, c, a + share * (b - a),
                  a + share * other * (b - a) + (Exact(1) - share) * other * (c - a)};
}

ExactVec3 kept_z(const ExactVec3& v) { return *keep_z(Exact(1), v); }

bool stays_straight(const Input& i) {
  const auto triangle = triangle_in(i);
  if (!triangle) return true;
  const auto& [a, b, c, on_line, inside] = *triangle;
  const Exact near(i[0]), one(1), two(2);
  const auto p = projection_of(Exact(3, 2), two, near, near + Exact(i[1]));
  const auto right = [&](const ExactVec3& v) { return divide(transform(p, v)); };
  if (!collinear(right(a), right(b), right(on_line))) return false;
  if (orient3d(right(a), right(b), right(c), right(inside)) != 0) return false;
  const ExactVec3 pa = kept_z(a), pb = kept_z(b);
  if (a != b && collinear(pa, pb, kept_z(on_line)) == bends(a, b)) return false;
  if (pa.x == pb.x) return true;
  // The point of the line whose image lies half-way between theirs
  const ExactVec3 middle = (a / a.z + b / b.z) / (one / a.z + one / b.z), image = kept_z(middle);
  const Exact off = interpolated_depth(pa, pb, image.x) - middle.z, deep = b.z - a.z;
  return image.x == (pa.x + pb.x) / two && off == deep * deep / (two * (a.z + b.z)) &&
         interpolated_depth(right(a), right(b), right(middle).x) == right(middle).z;
}

/// Whether z' = z bends the line and the plane.
bool bends_both(const Input& i) {
  const ExactScope scope;
  const auto t = triangle_in(i);
  return t && bends(t->a, t->b) && orient3d(kept_z(t->a), kept_z(t->b), kept_z(t->c), kept_z(t->inside)) != 0;
}

/// Two points from 1 to 100 deep, left and right of the axis, and the share of the way between them.
Input across_the_picture(Kind, Random& random) {
  return {random.uniform(-0.9, -0.1), random.uniform(1, 100), random.uniform(0.1, 0.9),
          random.uniform(1, 100), random.unit()};
}

/// By how much depth is off that is interpolated between them, and by how much with z' = z.
struct DepthsOff {
  double right, bent;
};
std::optional<DepthsOff> depths_off(const Input& i) {
  const auto within = [&](std::size_t k, double least, double most) { return least <= i[k] && i[k] <= most; };
  if (!within(0, -0.9, -0.1) || !within(2, 0.1, 0.9) || !within(1, 1, 100) || !within(3, 1, 100)) return {};
  if (!within(4, 0, 1)) return {};
  const dvec3 a{i[0] * i[1], 0, i[1]}, b{i[2] * i[3], 0, i[3]}, m = a + i[4] * (b - a);
  static const Projection<double> p = projection_of(1.0, 1.0, 1.0, 100.0);
  const auto right = [&](dvec3 v) { return divide(transform(p, v)); };
  const auto bent = [&](dvec3 v) { return *keep_z(1.0, v); };
  return DepthsOff{std::abs(interpolated_depth(right(a), right(b), right(m).x) - right(m).z),
                   interpolated_depth(bent(a), bent(b), bent(m).x) - m.z};
}

double interpolated_error(const Input& i) {
  const auto off = depths_off(i);
  if (!off) return 0;
  return off->bent > 81 ? wrong : off->right * 0x1p53;  // (sqrt 100 - sqrt 1)^2
}

}  // namespace

Domain perspective() {
  const auto planes_in_order = [](Input& i) { put_in_order(i[0], i[1]); };
  const auto apart = [](const Input& i) { return stored_in(i).has_value(); };
  Property straight =
      exact_relation("straight",
                     "lines and planes stay what they are; with z' = z they bend, and depth half-way is too "
                     "large by (z1 - z0)^2 / (2 (z0 + z1))",
                     13, stays_straight, triangle_before_eye);
  straight.shares = {{"z' = z bends line and plane", 0.8, bends_both}};
  return {
      "perspective",
      {{.name = "project",
        .states = "no image at or behind the eye; else x and y within two roundings",
        .unit = "bounds",
        .bound = 1,
        .numbers = 4,
        .generate = at_every_scale(plane_and_point, {}, plane_before_eye),
        .error = in_both([](const auto& i) { return project_error(i); }),
        .traps = {{"in the eye", {1, 1, 1, 0}},
                  {"behind the eye", {1, 1, 1, -1}},
                  {"the eye from behind", {1, 1, 1, -0.0}},
                  {"nearly in the eye", {1, 1, 1, 1e-310}},
                  {"the plane itself", {0.1, 0.3, 0.7, 0.1}},
                  {"the axis, nearly in the eye", {1, 0, 0, 1e-310}},
                  {"no distance", {0, 1, 1, 1}},
                  {"a depth that is no number", {1, 1, 1, std::nan("")}}},
        .shares = {{"in front of the eye", 0.4, [](const Input& i) { return i[3] > 0; }},
                   {"at or behind it", 0.1, [](const Input& i) { return i[3] <= 0; }},
                   {"in the plane", 0.05, [](const Input& i) { return i[3] == i[0] && i[0] > 0; }}}},
       {.name = "vanishing_point",
        .states = "within three roundings, where it is finite",
        .unit = "bounds",
        .bound = 1,
        .numbers = 4,
        .generate = at_every_scale(plane_and_point, {}, plane_before_eye),
        .error = in_both([](const auto& i) { return vanishing_error(i); }),
        .traps = {{"nearly parallel to the picture", {1, 1, 0, 1e-310}}, {"no direction", {1, 0, 0, 0}}},
        .shares = {{"parallel to the picture", 0.05, [](const Input& i) { return i[3] == 0; }}}},
       {.name = "transform",
        .states = "x and y one rounding, z two, exactly 0 at the near plane, w exact; the division one more, "
                  "and none at or behind the eye",
        .unit = "bounds",
        .bound = 1,
        .numbers = 7,
        .generate = at_every_scale(lens_and_point, {}, put_planes_in_order),
        .error = in_both([](const auto& i) { return transform_error(i); }),
        .traps = {{"the far plane an ulp behind the near one", {1, 1, 1, 1 + 0x1p-52, 1, 1, 1}}},
        .shares = {{"at the near plane", 0.03, [](const Input& i) { return i[6] == i[2]; }},
                   {"divided", 1 / 3.0, [](const Input& i) { return i[6] > 0; }}}},
       {.name = "depth_of",
        .states = "3 roundings for the linear curve, 5 for the others",
        .unit = "bounds",
        .bound = 1,
        .numbers = 3,
        .generate = at_every_scale(depth_input, {0, 1}, planes_in_order),
        .error = in_both([](const auto& i) { return depth_error(i); })},
       {.name = "separable_step",
        .states = "12 roundings",
        .unit = "bounds",
        .bound = 1 + 0x1p-40,
        .numbers = 3,
        .generate = at_every_scale(depth_input, {0, 1}, planes_in_order),
        .error = step_error},
       {.name = "stored_depths",
        .states = "depths a step apart are told apart",
        .numbers = 4,
        .kinds = {Kind::random},
        .generate = stored_input,
        .error = stored_error,
        .shares = {{"the step is small beside the depth", 0.5, apart},
                   {"a fifth of a step is too little", 0.25,
                    [](const Input& i) {
                      const auto depths = stored_in(i);
                      return depths && depths->first == depths->soon;
                    }}},
        .cases = 60'000},
       straight,
       {.name = "interpolated_depth",
        .states = "within 512 roundings of 1 from 1 to 100; with z' = z it is off by up to 81",
        .unit = "roundings",
        .bound = 512,  // the point itself is rounded, at up to 90 in x and 100 in z; seen are 57
        .numbers = 5,
        .kinds = {Kind::random},
        .generate = across_the_picture,
        .error = interpolated_error,
        .shares = {{"with z' = z off by more than 75", 1e-5,
                    [](const Input& i) { return depths_off(i).value_or(DepthsOff{}).bent > 75; }}},
        .cases = 100'000}}};
}

}  // namespace gradus::stress
