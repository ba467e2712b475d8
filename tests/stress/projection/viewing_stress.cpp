// The promises of the viewer's frame, of coordinates in it, and of the way back.

#include "stress/projection/viewing.hpp"

#include <algorithm>
#include <boost/multiprecision/cpp_bin_float.hpp>

#include "projection/viewing/viewing_notes.hpp"
#include "stress/exactly.hpp"
#include "stress/scales.hpp"

namespace gradus::stress {
namespace {

using namespace gradus::viewing;
using Float = boost::multiprecision::cpp_bin_float_100;
template <class T>
using Vec3 = glm::vec<3, T>;

// The header's bounds. Forward: the difference, three roundings under the root (halved), root and quotient,
// each of half an ulp of 1 at most
constexpr double forward_ulps = 2.25, other_ulps = 3;

template <class T>
Float one_ulp() {
  return Float(std::numeric_limits<T>::epsilon());
}
template <class T>
double largest(const Vec3<T>& v) {
  return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}
template <class T>
std::optional<Frame<T>> look(const std::vector<T>& i) {
  return accepted([&] { return look_at(vector_in(i, 0), vector_in(i, 3), vector_in(i, 6)); });
}

// --- look_at: eye, target, up -----------------------------------------------------------------------------

Input look_input(Kind kind, Random& random) {
  Input input = numbers_of(kind, random, 9);
  if (kind == Kind::near_degenerate) {  // up nearly along the view, the target nearly at the eye
    const bool close = random.unit() < 0.5;
    const double share = std::ldexp(1.0, static_cast<int>(random.uniform_int(-52, -4)));
    for (std::size_t k = 0; k < 3; ++k) {
      if (close) input[3 + k] = nudged(input[k], random);
      if (!close) input[6 + k] = input[3 + k] - input[k] + share * random.uniform(-1, 1);
    }
  } else if (kind == Kind::grazing) {  // along the axes
    for (double& x : input) x = static_cast<double>(random.uniform_int(-1, 1));
  }
  return input;
}

/// The largest distance of a component from the exact one, in ulp of 1.
template <class T>
double off(const Vec3<T>& found, const Triple<Float>& exact) {
  if (!is_finite(found)) return wrong;
  double worst = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const Float miss = abs(Float(found[static_cast<int>(k)]) - exact[k]) / one_ulp<T>();
    worst = std::max(worst, static_cast<double>(miss));
  }
  return worst;
}

/// The largest share of what is promised that is used up.
template <class T>
double look_error(const std::vector<T>& i) {
  const auto frame = look(i);
  const Vec3<T> eye = vector_in(i, 0), target = vector_in(i, 3), up = vector_in(i, 6);
  if (!all_finite(i) || eye == target || up == Vec3<T>(0)) return frame ? wrong : 0;
  const auto exact = axes_of<Float>(eye, target, up);
  // So near to the limit that rounding may decide
  const bool parallel = exact.sine < least_sine<T>;
  if (abs(exact.sine - least_sine<T>) >= 8 * one_ulp<T>() && frame.has_value() == parallel) return wrong;
  if (!frame) return 0;
  const double other = other_ulps / static_cast<double>(exact.sine);
  return std::max({off(frame->forward, exact.forward) / forward_ulps, off(frame->right, exact.right) / other,
                   off(frame->up, exact.up) / other});
}

/// How far the target is from (0, 0, distance), in ulp of the distance; `wrong` where axes are not upright.
double target_error(const Input& i) {
  const auto frame = look(i);
  const dvec3 target = vector_in(i, 3), along = target - vector_in(i, 0);
  const double distance = gradus::length_of(along);
  if (!frame || !(0x1p-1000 < distance && distance < 0x1p1000)) return 0;
  const dvec3 axes[] = {frame->right, frame->up, frame->forward};
  for (int k = 0; k < 3; ++k) {
    if (std::abs(glm::length(axes[k]) - 1) > 2e-15) return wrong;
    if (std::abs(glm::dot(axes[k], axes[(k + 1) % 3])) > 2e-15) return wrong;
  }
  if (std::abs(glm::dot(frame->right, glm::cross(frame->up, frame->forward)) + 1) > 4e-15) return wrong;
  if (glm::dot(frame->up, unit_vector(vector_in(i, 6))) <= 0) return wrong;
  return largest(to_view(*frame, target) - dvec3(0, 0, distance)) / distance * 0x1p52;
}

Input spare_input(Kind kind, Random& random) {
  Input input = look_input(kind, random);
  if (random.unit() < 0.5) return input;
  const double share = random.uniform(-2, 2);
  for (std::size_t k = 0; k < 3; ++k) input[6 + k] = share * (input[3 + k] - input[k]);
  return input;
}

/// Any hint but one along the view is look_at's; with that, too, the frame is upright.
double spare_error(const Input& i) {
  const dvec3 eye = vector_in(i, 0), target = vector_in(i, 3), up = vector_in(i, 6);
  const auto frame = accepted([&] { return spare_up(eye, target, up); });
  if (frame.has_value() != (all_finite(i) && eye != target)) return wrong;
  if (!frame) return 0;
  const dvec3 ahead = unit_vector(way(eye, target));
  if (sine_between(ahead, up) > 2 * least_sine<double>) {
    const auto plain = look(i);
    if (!plain || plain->right != frame->right || plain->up != frame->up) return wrong;
  }
  const bool upright = is_upright(*frame) && frame->forward == ahead &&
                       sine_between(ahead, spare_hint(ahead)) > 0.7 &&
                       std::abs(glm::dot(frame->right, glm::cross(frame->up, frame->forward)) + 1) < 4e-15;
  return upright ? 0 : wrong;
}

// --- Points in a frame as look_at makes it ----------------------------------------------------------------

Input view_input(Kind kind, Random& random) {
  Input input = look_input(kind == Kind::near_degenerate ? Kind::random : kind, random);
  for (std::size_t k = 0; k < 3; ++k) {
    input.push_back(kind == Kind::near_degenerate ? nudged(input[k], random) : number(kind, random));
  }
  return input;
}

/// By point and by matrix: the coordinates within 2 ulp of the distance, or of |eye| + |point|, the last
/// column within 3/2 of |eye|; and two of the smallest numbers, by matrix four.
template <class T>
double view_error(const std::vector<T>& i) {
  const auto frame = look(i);
  const Vec3<T> eye = vector_in(i, 0), world = vector_in(i, 9);
  if (!frame || !is_finite(world)) return 0;  // look_at's own promise
  const Vec3<T> view = to_view(*frame, world);
  const auto p = way_from<Float>(eye, world);
  const Float distance = length_of(p), reach = length_of(triple<Float>(eye)),
              far = reach + length_of(triple<Float>(world));
  if (distance > Float(std::numeric_limits<T>::max()) / 2) return 0;
  if (distance == 0 && view != Vec3<T>(0)) return wrong;
  const Matrix<T> matrix = world_to_view(*frame);
  const Vec3<T> by_matrix(matrix * glm::vec<4, T>(world, T(1)));
  const Float smallest(std::numeric_limits<T>::denorm_min());
  double worst = 0;
  const auto look_at = [&](T found, const Float& exact, const Float& size, int underflows) {
    if (!std::isfinite(found)) return void(worst = wrong);
    const Float bound = size * one_ulp<T>() + underflows * smallest;
    worst = std::max(worst, static_cast<double>(abs(Float(found) - exact) / bound));
  };
  for (int k = 0; k < 3; ++k) {
    const Triple<Float> axis = triple<Float>(axis_of(*frame, k));
    look_at(view[k], dot(axis, p), 2 * distance, 2);
    if (far > Float(std::numeric_limits<T>::max()) / 8) continue;
    look_at(matrix[3][k], -dot(axis, triple<Float>(eye)), 1.5 * reach, 2);
    look_at(by_matrix[k], dot(axis, p), 2 * far, 4);
  }
  return worst;
}

// --- inverse_of_any_frame: eye and three axes -------------------------------------------------------------

Input inverse_input(Kind kind, Random& random) {
  Input input = numbers_of(kind, random, 12);
  if (kind == Kind::near_degenerate) {  // the third axis nearly in the plane of the others
    const double a = random.uniform(-2, 2), b = random.uniform(-2, 2);
    const double share = std::ldexp(1.0, static_cast<int>(random.uniform_int(-48, -2)));
    for (std::size_t k = 0; k < 3; ++k) {
      input[9 + k] = a * input[3 + k] + b * input[6 + k] + share * random.uniform(-1, 1);
    }
  }
  return input;
}

/// A power of two that brings the largest component to [1, 2); 0 for the zero vector.
template <class T>
Exact power_that_fits(const Vec3<T>& v) {
  const double size = largest(v);
  if (size == 0) return Exact(0);
  const int exponent = -std::ilogb(size);  // of a subnormal beyond what a double holds
  return Exact(std::ldexp(1.0, exponent / 2)) * Exact(std::ldexp(1.0, exponent - exponent / 2));
}

/// The header's bound, in rounding units: 240 for the determinant's six products, of 8 at most and rounded
/// five times; 6 times 16 for a column; 42 for the quotient.
template <class T>
double inverse_error(const std::vector<T>& i) {
  if (!all_finite(i)) return 0;
  const Frame<T> frame{vector_in(i, 0), vector_in(i, 3), vector_in(i, 6), vector_in(i, 9)};
  if (accepted([&] { return view_to_world(frame); }).has_value() != is_upright(frame)) return wrong;
  const auto matrix = accepted([&] { return inverse_of_any_frame(frame); });
  ExactVec3 scaled[3];
  Exact scales[3];
  for (int k = 0; k < 3; ++k) {
    scales[k] = power_that_fits(axis_of(frame, k));
    scaled[k] = ExactVec3(axis_of(frame, k)) * scales[k];
  }
  const Exact det = glm::dot(scaled[0], glm::cross(scaled[1], scaled[2])), size = abs(det);
  if (!matrix) return size > Exact(2) * Exact(least_span<T>()) ? wrong : 0;
  if (sign(det) == 0 || Vec3<T>((*matrix)[3]) != frame.eye) return wrong;
  constexpr double ulp = std::numeric_limits<T>::epsilon(), least = std::numeric_limits<T>::min() / ulp;
  double worst = 0;
  for (int k = 0; k < 3; ++k) {
    const ExactVec3 column = glm::cross(scaled[(k + 1) % 3], scaled[(k + 2) % 3]) * (scales[k] / det);
    double most = 0, error = 0;
    bool finite = true;
    for (int row = 0; row < 3; ++row) {
      const T found = (*matrix)[k][row];
      most = std::max(most, std::abs(to_double(column[row])));
      finite = finite && std::isfinite(found);
      if (finite) error = std::max(error, std::abs(to_double(column[row] - Exact(found))));
    }
    if (most > std::numeric_limits<T>::max() / 2) continue;
    if (!finite) return wrong;
    // Else its ulp underflows
    if (most >= least) worst = std::max(worst, error / most / ulp * to_double(size));
  }
  return worst;
}

// --- In exact arithmetic: the whole numbers of a quaternion, a point, an eye, any three axes --------------

/// Axes of length 1 at right angles, all of them rational: the rotation of a quaternion, mirrored so that
/// right = forward x up.
Frame<Exact> rational_frame(const Input& i) {
  const Exact a(i[0]), b(i[1]), c(i[2]), d(i[3]), two(2);
  const Exact norm = a * a + b * b + c * c + d * d;
  return {ExactVec3(vector_in(i, 7)),
          ExactVec3{a * a + b * b - c * c - d * d, two * (b * c + a * d), two * (b * d - a * c)} / norm,
          ExactVec3{two * (b * c - a * d), a * a - b * b + c * c - d * d, two * (c * d + a * b)} / norm,
          -ExactVec3{two * (b * d + a * c), two * (c * d - a * b), a * a - b * b - c * c + d * d} / norm};
}
bool is_quaternion(const Input& i) { return i[0] != 0 || i[1] != 0 || i[2] != 0 || i[3] != 0; }

bool frames_agree(const Input& i) {
  if (!is_quaternion(i)) return true;
  const Frame<Exact> frame = rational_frame(i);
  const ExactVec3 p(vector_in(i, 4)), seen = to_view(frame, p), aside = p - frame.eye;
  const Matrix<Exact> there = world_to_view(frame), back = view_to_world(frame), one(Exact(1));
  if (!is_upright(frame) || back * there != one || back != inverse_of_any_frame(frame)) return false;
  if (glm::dot(frame.right, glm::cross(frame.up, frame.forward)) != Exact(-1)) return false;
  if (ExactVec3(there * glm::vec<4, Exact>(p, Exact(1))) != seen) return false;
  if (glm::dot(seen, seen) != glm::dot(aside, aside)) return false;  // distances are kept
  const Frame<Exact> any{frame.eye, ExactVec3(vector_in(i, 10)), ExactVec3(vector_in(i, 13)),
                         ExactVec3(vector_in(i, 16))};
  if (accepted([&] { return view_to_world(any); }).has_value() != is_upright(any)) return false;
  const auto inverse = accepted([&] { return inverse_of_any_frame(any); });
  if (inverse.has_value() != (glm::dot(any.right, glm::cross(any.up, any.forward)) != Exact(0))) return false;
  return !inverse || *inverse * world_to_view(any) == one;
}

bool exhibits_go_wrong(const Input& i) {
  const ExactScope scope;
  if (!is_quaternion(i)) return false;
  const Frame<Exact> frame = rational_frame(i);
  const Matrix<Exact> right = world_to_view(frame);
  return transposed(frame) != right && minus_position(frame) != right;
}

}  // namespace

Domain viewing() {
  const auto refused = [](const Input& i) { return all_finite(i) && !look(i); };
  Property frames = exact_relation(
      "exact_frames", "the matrix's inverse is the pose, distances stay, and point and matrix agree", 19,
      frames_agree);
  frames.shares = {{"the exhibits go wrong", 0.9, exhibits_go_wrong}};
  frames.cases = 5000;  // each takes a third of a millisecond
  return {
      "viewing",
      {{.name = "look_at",
        .states = "forward within 9/4 ulp of 1, right and up within 3 over the sine; parallel up is refused",
        .unit = "bounds",
        .bound = 1,
        .numbers = 9,
        .generate = at_every_scale(look_input),
        .error = in_both([](const auto& i) { return look_error(i); }),
        .traps = {{"up along the view", {0, 5, 0, 0, 0, 0, 0, 1, 0}},
                  {"up along the view but for 1e-17", {0, 1, 0, 0, 0, 0, 1e-17, 1, 0}},
                  {"the target at the eye", {1, 2, 3, 1, 2, 3, 0, 1, 0}},
                  {"up 2.1 ulp off in float", {0, 0x1.7328e8p0, 0, 0, 0, -0x1.c8c26ap0, -0x1p12, 0, 1}},
                  {"as far apart as doubles allow", {-1e308, 0, 0, 1e308, 1, 0, 0, 1, 0}},
                  {"squares underflow", {0, 0, 0, 1e-200, 0, 1e-200, 0, 1e-300, 0}}},
        .shares = {{"refused", 0.03, refused}}},
       {.name = "target",
        .states = "lies on the axis, within 4 ulp of its distance, and the axes are upright",
        .unit = "ulp",
        .bound = 4,
        .numbers = 9,
        .generate = at_every_scale(look_input),
        .error = target_error,
        .cases = 20'000},
       {.name = "spare_up",
        .states = "look_at's frame unless the hint lies along the view, and an upright one then",
        .numbers = 9,
        .generate = at_every_scale(spare_input),
        .error = spare_error,
        .shares = {{"spared", 0.2, refused}}},
       {.name = "to_view",
        .states = "each coordinate within 2 ulp of the distance, by matrix of |eye| + |point|",
        .unit = "bounds",
        .bound = 1,
        .numbers = 12,
        .generate = at_every_scale(view_input),
        .error = in_both([](const auto& i) { return view_error(i); }),
        .traps = {{"the eye itself", {2, 3, 5, 0, 0, 0, 0, 1, 0, 2, 3, 5}},
                  {"the target", {2, 3, 5, 0, 0, 0, 0, 1, 0, 0, 0, 0}},
                  {"far from the origin", {1e8, 1e8, 1e8, 0, 0, 1, 0, 1, 0, 1e8 + 1, 1e8, 1e8}}}},
       {.name = "inverse_of_any_frame",
        .states =
            "a column within 192 ulp of its largest entry over the determinant; flat frames are refused",
        .unit = "ulp",
        .bound = 192,
        .numbers = 12,
        .generate = at_every_scale(inverse_input),
        .error = in_both([](const auto& i) { return inverse_error(i); }),
        .traps = {{"in one plane", {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0}},
                  {"37 ulp in float",
                   {0, 0, 0, 0x1.a049c4p+0, -0x1.bf3838p+0, 0x1.9b23d6p+0, 0x1.483ef4p+0, 0x1.11eb62p+0,
                    -0x1.84c224p+0, 0x1.896446p+0, 0x1.ff5e58p+0, 0x1.d01eaap+0}},
                  {"lengths far apart", {0, 0, 0, 1e-200, 0, 0, 0, 1, 0, 0, 0, 1e200}},
                  {"no axis", {0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 1}}}},
       frames}};
}

}  // namespace gradus::stress
