// The promises of a parametric surface: points are those of the rational parametrization but for roundings,
// identities hold, and faces and what is looked up in them are no farther off than their bounds say.

#include "modeling/parametric_surface/parametric_surface.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "stress/exactly.hpp"
#include "stress/scales.hpp"

namespace gradus::stress {
namespace {

using namespace parametric_surface;
using Real = long double;
using RealVec = glm::vec<3, Real>;

/// Tangents of both half angles, and the radius; the second one from -1 to 1, a latitude.
Input halves(Kind kind, Random& random) {
  Input input = numbers_of(kind, random, 3);
  if (kind == Kind::near_degenerate) input[1] = nudged(random.unit() < 0.5 ? -1 : 1, random);
  if (kind == Kind::grazing) input[0] = sized(random, -60, 60);
  if (kind != Kind::refused) input[1] = std::remainder(input[1], 2), input[2] = std::abs(input[2]);
  return input;
}

template <class T>
T largest_of(const T& a, const T& b) {
  return a < b ? b : a;
}

/// In parts of 3.5 u of the radius, or of 1, and the smallest number. Half angles a, b, as rationals:
/// P = r ((1 - b^2)(1 - a^2), (1 - b^2) 2a, 2b (1 + a^2)) / ((1 + a^2)(1 + b^2)).
double point_error(const Input& i) {
  if (!(std::abs(i[0]) <= 0x1p60) || !(std::abs(i[1]) <= 1) || !std::isfinite(i[2])) return 0;
  if (i[0] != 0 && std::abs(i[0]) < 0x1p-60) return 0;
  const ExactScope scope;
  const Exact a(i[0]), b(i[1]), r(i[2]), one(1), two(2);
  const auto rounded = [](const Turn<Exact>& t) { return turn_of(to_double(t.sin), to_double(t.cos)); };
  const auto found =
      accepted([&] { return point(i[2], rounded(rational_turn(a)), rounded(rational_turn(b))); });
  if (!(0 < i[2] && i[2] <= std::numeric_limits<double>::max() / 4)) return found ? wrong : 0;
  if (!found) return wrong;
  const Exact aa = one + a * a, bb = one + b * b, below = aa * bb, c = one - a * a, d = one - b * b;
  const std::array<Exact, 3> n{d * c / below, d * two * a / below, two * b / bb};
  const std::array<Exact, 3> by_s{Exact(0) - n[1], n[0], Exact(0)};
  const Exact height = two * b / bb;
  const std::array<Exact, 3> by_t{Exact(0) - height * c / aa, Exact(0) - height * two * a / aa, d / bb};
  const Exact of_one = Exact(3.5) * (rounding_unit<double>() + Exact(0x1p-1074));
  const Exact of_radius = Exact(3.5) * (rounding_unit<double>() * r + Exact(0x1p-1074));
  double most = 0;
  for (int k = 0; k < 3; ++k) {
    const auto axis = static_cast<std::size_t>(k);
    most = std::max(most, in_bounds(abs(Exact(found->normal[k]) - n[axis]), of_one));
    most = std::max(most, in_bounds(abs(Exact(found->point[k]) - r * n[axis]), of_radius));
    most = std::max(most, in_bounds(abs(Exact(found->by_s[k]) - r * by_s[axis]), of_radius));
    most = std::max(most, in_bounds(abs(Exact(found->by_t[k]) - r * by_t[axis]), of_radius));
  }
  return most;
}

/// On the sphere; the tangents across the radius and each other, as long as they should be.
bool identities(const Input& i) {
  const Turn<Exact> s = rational_turn(Exact(i[0])), t = rational_turn(Exact(i[1]));
  const Exact r = abs(Exact(i[2])) + Exact(1), ring = r * t.cos, none(0);
  const SurfacePoint<Exact> p = point(r, s, t);
  const auto dot = [](const Vec<Exact>& a, const Vec<Exact>& b) { return a.x * b.x + a.y * b.y + a.z * b.z; };
  return dot(p.point, p.point) == r * r && dot(p.by_s, p.by_s) == ring * ring &&
         dot(p.by_t, p.by_t) == r * r && dot(p.normal, p.normal) == Exact(1) &&
         dot(p.by_s, p.point) == none && dot(p.by_t, p.point) == none && dot(p.by_s, p.by_t) == none &&
         r * p.normal == p.point;
}

/// Turned round, mirrored, at the poles and along the seam: angles of any size.
double symmetry_error(const Input& i) {
  if (!all_finite(i)) return 0;
  const double s = i[0], t = std::remainder(i[1], 90);
  const auto at = [](double a, double b) { return point(1.0, angle(a), angle(b)); };
  const SurfacePoint<double> p = at(s, t), mirrored = at(-s, t), below = at(s, -t);
  const bool kept = mirrored.point == p.point * dvec3{1, -1, 1} && below.point == p.point * dvec3{1, 1, -1} &&
                    at(s, 90).point == dvec3{0, 0, 1} && at(s, 90).by_s == dvec3{0} &&
                    at(s, -90).normal == dvec3{0, 0, -1} && at(std::fmod(s, 360), t) == p &&
                    at(0, t) == at(360, t);
  return kept ? 0 : wrong;
}

/// r, s, t, n, m.
Input mesh_and_place(Kind kind, Random& random) {
  Input input{std::abs(number(kind, random)), random.uniform(-720, 720), random.uniform(-90, 90), 0, 0};
  input[3] = static_cast<double>(random.uniform_int(3, 12));
  input[4] = static_cast<double>(random.uniform_int(2, 8));
  const auto cell = [&](double whole, double parts) {
    return whole * static_cast<double>(random.uniform_int(0, static_cast<int>(parts))) / parts;
  };
  if (kind == Kind::ties || kind == Kind::grazing)
    input[1] = cell(360, input[3]), input[2] = cell(180, input[4]) - 90;
  if (kind == Kind::grazing)
    input[1] = nudged(input[1], random), input[2] = std::clamp(nudged(input[2], random), -90.0, 90.0);
  if (kind == Kind::refused) input[static_cast<std::size_t>(random.uniform_int(0, 2))] = number(kind, random);
  return input;
}

struct Given {
  int n, m;
  bool taken;
};
Given given_in(const Input& i) {
  const auto whole = [](double x, int least, int most) {
    return std::isfinite(x) ? static_cast<int>(std::clamp(std::abs(x), 1.0 * least, 1.0 * most)) : least;
  };
  const bool radius = 0 < i[0] && i[0] <= std::numeric_limits<double>::max() / 4;
  return {whole(i[3], 3, 12), whole(i[4], 2, 8), radius && std::isfinite(i[1]) && std::abs(i[2]) <= 90};
}

/// A place of the mesh as a part of the radius, so that nothing overflows.
RealVec part_of(dvec3 p, double r) { return RealVec(p) / static_cast<Real>(r); }

constexpr Real unit = 0x1p-53L, pi = 3.14159265358979323846L;

double lookup_error(const Input& i) {
  const auto [n, m, taken] = given_in(i);
  const auto found = accepted([&] { return lookup(patches(i[0], n, m), i[1], i[2]); });
  if (!taken || !found) return taken == found.has_value() ? 0 : wrong;
  if (i[0] < 0x1p-1000) return 0;  // there the smallest numbers are steps of the radius
  const Real s = std::fmod(static_cast<Real>(i[1]), 360) * pi / 180, t = static_cast<Real>(i[2]) * pi / 180;
  const RealVec right{std::cos(t) * std::cos(s), std::cos(t) * std::sin(s), std::sin(t)};
  const Real bound = pi * pi / (2 * n * n) + pi * pi / (8 * m * m) + 16 * unit;
  return static_cast<double>(length_of(part_of(found->point, i[0]) - right) / bound);
}

/// Places of all faces: corners, middles of sides and of the face, and between these.
double faces_error(const Input& i) {
  const auto [n, m, taken] = given_in(i);
  if (!taken || i[0] < 0x1p-1000) return 0;
  const Patches<double> mesh = patches(i[0], n, m);
  const Real allowed = (1 - std::cos(pi / n) * std::cos(pi / (2 * m))) + 8 * unit;
  const Real stated = static_cast<Real>(off_sphere(i[0], n, m)) / static_cast<Real>(i[0]);
  if (std::abs(stated + 8 * unit - allowed) > 8 * unit) return wrong;
  Real most = 0;
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    const auto ring = mesh.faces[f];
    const auto corner = [&](std::size_t k) {
      return part_of(mesh.points[static_cast<std::size_t>(ring[std::min(k, ring.size() - 1)])], i[0]);
    };
    for (int a = 0; a <= 4; ++a) {
      for (int b = 0; b <= 4; ++b) {
        const Real u = a / 4.0L, v = b / 4.0L;
        const RealVec p =
            (1 - v) * ((1 - u) * corner(0) + u * corner(1)) + v * ((1 - u) * corner(3) + u * corner(2));
        const Real off = 1 - length_of(p);
        if (off < -8 * unit) return wrong;
        most = std::max(most, off / allowed);
      }
    }
  }
  return static_cast<double>(most);
}

}  // namespace

Domain parametric_surface() {
  return {
      "parametric_surface",
      {{.name = "points",
        .states = "point, tangents and normal within 3.5 u of the radius, or of 1, at every size",
        .unit = "of the bound",
        .bound = 1,
        .numbers = 3,
        .generate = at_every_scale(halves, {2}),
        .error = point_error,
        .traps = {{"a pole", {0.5, 1, 2}},
                  {"the smallest radius", {0.5, 0.25, 5e-324}},
                  {"no radius", {0.5, 0.25, 0}}},
        .cases = 2000},
       exact_relation("identities",
                      "points lie on the sphere, tangents across the radius, as long as they should be", 3,
                      identities),
       {.name = "symmetry",
        .states = "poles and seam are single points, and mirrored angles give mirrored points, bit for bit",
        .numbers = 2,
        .generate = [](Kind kind, Random& random) { return numbers_of(kind, random, 2); },
        .error = symmetry_error,
        .traps = {{"just below a whole turn", {359.99999999999994, 10}}}},
       {.name = "lookup",
        .states =
            "a place of the mesh within r (pi^2 / (2 n^2) + pi^2 / (8 m^2)) of the surface's, 16 u r aside",
        .unit = "of the bound",
        .bound = 1,
        .numbers = 5,
        .generate = mesh_and_place,
        .error = lookup_error,
        .traps = {{"a hair below 0", {1, -1e-20, 0, 4, 2}}, {"a pole", {1, 359.99999999999994, 90, 4, 2}}},
        .cases = 2000},
       {.name = "faces",
        .states =
            "no place of a face is farther than r (1 - cos(180/n) cos(90/m)) from the sphere, 8 u r aside",
        .unit = "of the bound",
        .bound = 1,
        .numbers = 5,
        .generate = mesh_and_place,
        .error = faces_error,
        .traps = {{"the coarsest", {1, 0, 0, 3, 2}}},
        .cases = 500}}};
}

}  // namespace gradus::stress
