// The promises of points without faces: a normal is the direction of least spread to within roundings, at
// every scale and however far away, or is refused by name; and pixels of depth images come back.

#include "modeling/point_cloud/point_cloud.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "stress/exactly.hpp"
#include "stress/scales.hpp"

namespace gradus::stress {
namespace {

using namespace point_cloud;

constexpr std::size_t points = 6;
/// Behind the points' coordinates the eye's and k.
constexpr std::size_t numbers_of_cloud = 3 * points + 4;

Input any_cloud(Kind kind, Random& random) {
  Input input = numbers_of(kind, random, numbers_of_cloud);
  const auto any = [&] { return static_cast<std::size_t>(random.uniform_int(0, points - 1)); };
  if (kind == Kind::near_degenerate) {
    // Equal points, and others in one plane or line, but for the last places
    for (std::size_t i = 0; i < points; ++i) {
      const std::size_t like = any();
      for (std::size_t axis = 0; axis < 3; ++axis) {
        double& x = input[3 * i + axis];
        if (i % 4 == 0) x = input[3 * like + axis];
        if (i % 4 != 0 && axis == i % 2) x = nudged(input[axis], random);
      }
    }
  } else if (kind == Kind::grazing) {
    // Far away, with what they differ by in the last digits; or the corners of a box, which may be a cube
    const double far = sized(random, 0, 40), side = random.unit() < 0.5 ? 1 : random.uniform(1, 2);
    const bool box = random.unit() < 0.5;
    for (std::size_t i = 0; i < points; ++i) {
      for (std::size_t axis = 0; axis < 3; ++axis)
        input[3 * i + axis] =
            far + (box ? (i >> axis & 1u ? (axis == 0 ? side : 1) : 0) : random.uniform(-1, 1));
    }
  }
  input.back() = static_cast<double>(random.uniform_int(1, points + 1));
  return input;
}
Generator clouds() {
  std::vector<std::size_t> lengths(numbers_of_cloud - 1);
  std::iota(lengths.begin(), lengths.end(), std::size_t{0});
  return at_every_scale(any_cloud, lengths);
}

template <class T>
struct Given {
  std::vector<Place<T>> cloud{};
  Place<T> eye;
  std::size_t k;
  bool taken;  ///< whether it lies in the domain

  explicit Given(const std::vector<T>& numbers) : eye(vector_in(numbers, 3 * points)) {
    for (std::size_t i = 0; i < points; ++i) cloud.push_back(vector_in(numbers, 3 * i));
    const double wanted = static_cast<double>(numbers.back());
    k = static_cast<std::size_t>(wanted >= 1 && wanted < 99 ? wanted : 1);
    taken = std::all_of(numbers.begin(), numbers.end() - 1,
                        [](T x) { return std::abs(x) <= kd_tree::most_coordinate<T>; });
  }
};

using ExactPlace = std::array<Exact, 3>;
using Matrix = std::array<ExactPlace, 3>;

/// The covariance of n neighbours times n^3, exactly: without a quotient, which would cost most.
template <class T>
Matrix exact_covariance(const std::vector<Place<T>>& cloud, const Near<T>& near) {
  const Exact count(near.size());
  ExactPlace sum{Exact(0), Exact(0), Exact(0)};
  const auto part = [&](Index i, std::size_t axis) { return Exact(cloud[i][static_cast<int>(axis)]); };
  for (const auto& n : near) {
    for (std::size_t a = 0; a < 3; ++a) sum[a] += part(n.point, a);
  }
  Matrix C{};
  for (const auto& n : near) {
    ExactPlace off;
    for (std::size_t a = 0; a < 3; ++a) off[a] = count * part(n.point, a) - sum[a];
    for (std::size_t a = 0; a < 3; ++a) {
      for (std::size_t b = 0; b < 3; ++b) C[a][b] = off[a] * off[b] + C[a][b];
    }
  }
  return C;
}

/// How many eigenvalues of a symmetric matrix lie above s: as often as the signs of its characteristic
/// polynomial change once s is subtracted, since all roots are real.
int above(Matrix C, const Exact& s) {
  for (std::size_t a = 0; a < 3; ++a) C[a][a] = C[a][a] - s;
  const auto minor = [&](std::size_t a, std::size_t b) { return C[a][a] * C[b][b] - C[a][b] * C[a][b]; };
  const Exact trace = C[0][0] + C[1][1] + C[2][2], minors = minor(0, 1) + minor(1, 2) + minor(0, 2),
              determinant = C[0][0] * minor(1, 2) - C[0][1] * (C[0][1] * C[2][2] - C[1][2] * C[0][2]) +
                            C[0][2] * (C[0][1] * C[1][2] - C[1][1] * C[0][2]);
  int changes = 0, last = 1;
  for (const int its : {-sign(trace), sign(minors), -sign(determinant)}) {
    if (its == 0) continue;
    changes += its != last ? 1 : 0;
    last = its;
  }
  return changes;
}

/// The residual of a normal as a share of what is allowed, squared; `wrong` where another direction has less
/// variance than roundings explain, or where the eye is on the other side.
template <class T>
double error_of(const Given<T>& given, const Normal<T>& n, const Matrix& C, std::size_t count) {
  const Exact whole = C[0][0] + C[1][1] + C[2][2], allowed = Exact(doubt<T>(count)) * whole;
  ExactPlace way, image;
  for (std::size_t a = 0; a < 3; ++a) way[a] = Exact(n.way[static_cast<int>(a)]);
  Exact square(0), product(0), side(0), sides(0);
  for (std::size_t a = 0; a < 3; ++a) {
    image[a] = C[a][0] * way[0] + C[a][1] * way[1] + C[a][2] * way[2];
    square = square + way[a] * way[a];
    product = product + way[a] * image[a];
    const Exact to_eye = Exact(given.eye[static_cast<int>(a)]) - Exact(given.cloud[0][static_cast<int>(a)]);
    side = side + way[a] * to_eye;
    sides = sides + abs(way[a] * to_eye);
  }
  const Exact variance = product / square, u = rounding_unit<T>();
  if (above(C, variance - allowed) < 3) return wrong;
  if (side < Exact(0) - Exact(8) * u * sides - Exact(4) * Exact(std::numeric_limits<T>::denorm_min()))
    return wrong;
  if (abs(square - Exact(1)) > Exact(64) * u) return wrong;
  Exact off(0);
  for (std::size_t a = 0; a < 3; ++a) {
    const Exact its = image[a] - variance * way[a];
    off = off + its * its;
  }
  return in_bounds(off, allowed * allowed * square);
}

/// Whether there is no normal for a reason: two eigenvalues within what roundings may have made of one.
template <class T>
bool has_none(const Normal<T>& n, const Matrix& C, std::size_t count) {
  const Exact whole = C[0][0] + C[1][1] + C[2][2], allowed = Exact(6) * Exact(doubt<T>(count)) * whole;
  if (n.way != Place<T>(T(0))) return false;
  if (n.shape == Shape::one_place) return sign(whole) == 0;
  if (n.shape == Shape::in_line) return above(C, allowed) == 1;
  // Variances that are no normal numbers have lost their digits
  if (n.variance[2] < std::numeric_limits<T>::min() / std::numeric_limits<T>::epsilon()) return true;
  const Exact cube(count * count * count);
  return above(C, cube * Exact(n.variance[0]) + allowed) <= 1;
}

template <class T>
double normal_error(const std::vector<T>& numbers) {
  if (!std::isfinite(numbers.back())) return 0;
  const Given<T> given(numbers);
  Near<T> near;
  const auto watch = [&]<class Step>(const Step& step) {
    if constexpr (std::same_as<Step, Gathered<T>>) near = step.near;
  };
  const auto found =
      accepted([&] { return normal(kd_tree::build<3, T>(given.cloud), 0, given.k, given.eye, watch); });
  if (found.has_value() != given.taken) return wrong;
  if (!given.taken) return 0;
  if (near != kd_tree::brute_force<3, T>(given.cloud, given.cloud[0], given.k)) return wrong;
  const Matrix C = exact_covariance(given.cloud, near);
  if (found->shape == Shape::surface) return error_of(given, *found, C, near.size());
  return has_none<T>(*found, C, near.size()) ? 0 : wrong;
}

/// Points in a plane across an axis, at any height: their normal is the axis.
template <class T>
double flat_error(const std::vector<T>& numbers) {
  if (!all_finite(numbers)) return 0;
  Given<T> given(numbers);
  if (!given.taken) return 0;
  for (int axis = 0; axis < 3; ++axis) {
    for (Place<T>& p : given.cloud) p[axis] = given.cloud[0][axis];
    const auto n = normal(kd_tree::build<3, T>(given.cloud), 0, given.k, given.eye);
    if (n.shape != Shape::surface) continue;
    Place<T> up(T(0));
    up[axis] = T(1);
    const bool below = given.eye[axis] < given.cloud[0][axis];
    // Beside the plane: either side
    const bool beside = given.eye[axis] == given.cloud[0][axis];
    if (n.way != (below ? -up : up) && !(beside && n.way == -up)) return wrong;
    given = Given<T>(numbers);
  }
  return 0;
}

// --- Depth images ------------------------------------------------

constexpr std::size_t numbers_of_pixel = 6;  // column, row, the centre's, focal length, depth

Input any_pixel(Kind kind, Random& random) {
  Input input = numbers_of(kind, random, numbers_of_pixel);
  for (const std::size_t i : {0u, 1u}) input[i] = static_cast<double>(random.uniform_int(0, 12));
  if (kind != Kind::refused) {
    for (const std::size_t i : {2u, 3u})
      input[i] = kind == Kind::grazing ? nudged(input[i - 2] + 0.5, random) : sized(random, -3, 14);
    for (const std::size_t i : {4u, 5u}) input[i] = std::abs(input[i]);
  }
  return input;
}

template <class T>
double pixel_error(const std::vector<T>& n) {
  const auto within = [](T x) { return T(1) / largest_depth<T> <= x && x <= largest_depth<T>; };
  const ivec2 pixel{n[0], n[1]};
  if (!(T(0) <= n[0] && n[0] < T(64) && T(0) <= n[1] && n[1] < T(64))) return 0;
  const bool taken = std::abs(n[2]) <= T(most_pixels) && std::abs(n[3]) <= T(most_pixels) && within(n[4]) &&
                     (within(n[5]) || n[5] == 0);
  Raster<T> depth(pixel.x + 1, pixel.y + 1);
  depth[pixel] = n[5];
  const Pinhole<T> camera{n[4], {n[2], n[3]}};
  const auto seen = accepted([&] { return back_project(depth, camera); });
  if (seen.has_value() != taken) return wrong;
  if (!taken) return 0;
  if (n[5] == 0) return seen->empty() ? 0 : wrong;
  return seen->size() == 1 && seen->front().z == n[5] && project(camera, seen->front()) == pixel ? 0 : wrong;
}

/// Every coordinate of the points one number, the eye's another.
Input all_at(double cloud, double eye, double k) {
  Input input(numbers_of_cloud, cloud);
  std::fill(input.end() - 4, input.end() - 1, eye);
  input.back() = k;
  return input;
}

}  // namespace

Domain point_cloud() {
  const auto with = [](Input input, std::initializer_list<std::pair<std::size_t, double>> others) {
    for (const auto& [i, x] : others) input[i] = x;
    return input;
  };
  return {
      "point_cloud",
      {{.name = "normals",
        .states =
            "neighbours are those of brute force, and a normal's exact residual within (2 k + 64) u of the "
            "covariance's trace, squared; or there is none, with a reason",
        .unit = "of the bound",
        .bound = 1,
        .numbers = numbers_of_cloud,
        .generate = clouds(),
        .error = in_both([](const auto& numbers) { return normal_error(numbers); }),
        .traps = {{"all points one", all_at(1, 2, 6)},
                  {"two places", with(all_at(0, 5, 6), {{3, 1}, {7, 1}, {8, 1}})},
                  {"three places", with(all_at(0, 5, 6), {{3, 1}, {7, 1}})},
                  {"three places, far away", with(all_at(0x1p40, 5, 6), {{3, 0x1p40 + 1}, {7, 0x1p40 + 1}})},
                  {"three places, tiny", with(all_at(0, 1, 6), {{3, 5e-324}, {7, 5e-324}})},
                  {"the largest numbers", with(all_at(-0x1p509, 0, 6), {{3, 0x1p509}, {7, 0x1p509}})},
                  {"a point that is no number", with(all_at(1, 0, 6), {{7, std::nan("")}})},
                  {"the eye in the point", with(all_at(0, 0, 6), {{3, 1}, {7, 1}})}},
        .cases = 500},
       {.name = "flat",
        .states =
            "points in a plane across an axis have that axis as their normal, exactly, on the eye's side",
        .unit = "decisions",
        .bound = 0,
        .numbers = numbers_of_cloud,
        .generate = clouds(),
        .error = in_both([](const auto& numbers) { return flat_error(numbers); })},
       {.name = "pixels",
        .states = "a pixel of a depth image, given its place in space, is seen in the same pixel again",
        .unit = "decisions",
        .bound = 0,
        .numbers = numbers_of_pixel,
        .generate = at_every_scale(any_pixel, {4, 5}),
        .error = in_both([](const auto& numbers) { return pixel_error(numbers); }),
        .traps = {{"an eye as near as can be", {12, 0, -32768, 32768, 0x1p-400, 0x1p400}},
                  {"one as far as can be", {12, 0, -32768, 32768, 0x1p400, 0x1p-400}},
                  {"no depth", {3, 4, 0, 0, 1, 0}},
                  {"a depth that is no number", {3, 4, 0, 0, 1, std::nan("")}}}}}};
}

}  // namespace gradus::stress
