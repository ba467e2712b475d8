#include "scene/shared_planes.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <tuple>
#include <utility>

#include "core/arithmetic/exact.hpp"

namespace gradus::pipeline {
namespace {

__extension__ typedef unsigned __int128 Wide;

// --- Planes modulo a prime -----------------------------------------------------------------------

/// A number modulo 2^61 - 1. Sums and products of doubles have the residues that those of their residues are,
/// without any rounding: powers of two only turn the bits round.
class Residue {
 public:
  static constexpr int bits = 61;
  static constexpr std::uint64_t prime = (std::uint64_t{1} << bits) - 1;

  constexpr Residue() = default;
  explicit Residue(double x) {
    int exponent = 0;
    const double mantissa = std::ldexp(std::frexp(std::abs(x), &exponent), 53);
    const int turn = ((exponent - 53) % bits + bits) % bits;
    *this = of(static_cast<std::uint64_t>(mantissa)) * of(std::uint64_t{1} << turn);
    if (x < 0) *this = Residue{} - *this;
  }
  static constexpr Residue of(std::uint64_t value) {
    Residue r;
    r.value_ = value % prime;
    return r;
  }

  friend constexpr Residue operator+(Residue a, Residue b) { return of(a.value_ + b.value_); }
  friend constexpr Residue operator-(Residue a, Residue b) { return of(a.value_ + prime - b.value_); }
  friend constexpr Residue operator*(Residue a, Residue b) {
    const Wide product = Wide{a.value_} * b.value_;
    return of(static_cast<std::uint64_t>(product >> bits) + static_cast<std::uint64_t>(product & prime));
  }
  friend constexpr auto operator<=>(const Residue&, const Residue&) = default;
  explicit constexpr operator bool() const { return value_ != 0; }

 private:
  std::uint64_t value_ = 0;
};

/// 1 / x. Domain: x is not 0. Fermat: x^(p - 2).
constexpr Residue inverse(Residue x) {
  Residue power = Residue::of(1);
  for (int bit = Residue::bits - 1; bit >= 0; --bit) {
    power = power * power;
    if ((Residue::prime - 2) >> bit & 1) power = power * x;
  }
  return power;
}

using Residues = std::array<Residue, 3>;

Residues difference(const Residues& a, const Residues& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Residue dot(const Residues& a, const Residues& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Residues cross(const Residues& a, const Residues& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// A plane as n . p = d, n and d up to a factor.
struct PlaneResidues {
  Residues normal;
  Residue distance;

  /// The part by which the others are divided, so that the factor is gone; 0 for a triangle without area.
  Residue divisor() const { return normal[0] ? normal[0] : normal[1] ? normal[1] : normal[2]; }
  /// All parts in one number, which tells other planes apart but for one in 2^59.
  Residue key(Residue over_divisor) const {
    constexpr Residue at = Residue::of(0x9e3779b97f4a7c15);
    return (((distance * at + normal[2]) * at + normal[1]) * at + normal[0]) * over_divisor;
  }
};

/// A triangle by the key of its plane.
struct Keyed {
  Residue key;
  int triangle;
};

std::vector<Keyed> by_plane(std::span<const dvec3> positions, std::span<const Triple> triangles) {
  std::vector<Residues> residues;
  residues.reserve(positions.size());
  for (const dvec3& p : positions) residues.push_back({Residue(p.x), Residue(p.y), Residue(p.z)});
  std::vector<PlaneResidues> planes;
  std::vector<int> numbers;
  std::vector<Residue> products;  // of all divisors so far: one inverse serves for all
  Residue product = Residue::of(1);
  int number = 0;
  for (const Triple& t : triangles) {
    const auto at = [&](std::size_t k) -> const Residues& {
      return residues[static_cast<std::size_t>(t[k])];
    };
    const Residues normal = cross(difference(at(1), at(0)), difference(at(2), at(0)));
    const PlaneResidues plane{normal, dot(normal, at(0))};
    if (plane.divisor()) {
      planes.push_back(plane);
      numbers.push_back(number);
      products.push_back(product);
      product = product * plane.divisor();
    }
    ++number;
  }
  std::vector<Keyed> keyed(planes.size());
  Residue rest = inverse(product);
  for (std::size_t i = planes.size(); i-- > 0;) {
    keyed[i] = {planes[i].key(rest * products[i]), numbers[i]};
    rest = rest * planes[i].divisor();
  }
  std::ranges::sort(keyed, {}, [](const Keyed& k) { return std::tie(k.key, k.triangle); });
  return keyed;
}

// --- In one plane --------------------------------------------------------------------------------

/// A triangle of a plane as it is seen along an axis, clockwise or not.
struct Flat {
  int triangle;
  std::array<dvec2, 3> corners;
  dvec2 lower, upper;
};

/// Whether one side of a triangle has all of the other beyond it, or on it.
bool parts(const Flat& a, const Flat& b) {
  const int turn = orient2d(a.corners[0], a.corners[1], a.corners[2]);
  for (std::size_t i = 0; i < 3; ++i) {
    const auto beyond = [&](const dvec2& p) {
      return turn * orient2d(a.corners[i], a.corners[(i + 1) % 3], p) <= 0;
    };
    if (std::ranges::all_of(b.corners, beyond)) return true;
  }
  return false;
}

bool boxes_meet(const Flat& a, const Flat& b) {
  return a.lower.x < b.upper.x && b.lower.x < a.upper.x && a.lower.y < b.upper.y && b.lower.y < a.upper.y;
}

/// Whether the insides of two triangles meet.
bool meet(const Flat& a, const Flat& b) { return boxes_meet(a, b) && !parts(a, b) && !parts(b, a); }

/// Cells over some triangles of a plane, and which of them each may hold.
class Cells {
 public:
  explicit Cells(const std::vector<Flat>& flats)
      : side_(static_cast<int>(std::ceil(std::sqrt(static_cast<double>(flats.size()))))),
        lower_(flats.front().lower) {
    dvec2 upper = lower_;
    for (const Flat& f : flats) lower_ = glm::min(lower_, f.lower), upper = glm::max(upper, f.upper);
    per_cell_ = (upper - lower_) / static_cast<double>(side_);
    cells_.resize(static_cast<std::size_t>(side_) * static_cast<std::size_t>(side_));
  }

  /// visit(cell) for each cell that the box of a triangle touches.
  template <class Visit>
  void visit(const Flat& f, const Visit& visit_cell) {
    const ivec2 first = cell_at(f.lower), last = cell_at(f.upper);
    for (int y = first.y; y <= last.y; ++y)
      for (int x = first.x; x <= last.x; ++x) visit_cell(cells_[static_cast<std::size_t>(y * side_ + x)]);
  }

 private:
  ivec2 cell_at(dvec2 p) const {
    const auto place = [&](double at, double lower, double width) {
      const double cell = (at - lower) / width;  // no number where all lies on a line
      return cell >= 0 ? static_cast<int>(std::min(cell, side_ - 1.0)) : 0;
    };
    return {place(p.x, lower_.x, per_cell_.x), place(p.y, lower_.y, per_cell_.y)};
  }

  int side_;
  dvec2 lower_, per_cell_{0};
  std::vector<std::vector<std::size_t>> cells_;
};

/// Which of some triangles in a plane meet others of them: all, where more tests were needed than are spent.
std::vector<bool> meeting(const std::vector<Flat>& flats) {
  std::vector<bool> meets(flats.size());
  const auto test = [&](std::size_t i, std::size_t k) {
    if ((!meets[i] || !meets[k]) && meet(flats[i], flats[k])) meets[i] = meets[k] = true;
  };
  if (flats.size() <= 8) {  // as the triangles of most faces are: no cells
    for (std::size_t i = 1; i < flats.size(); ++i)
      for (std::size_t k = 0; k < i; ++k) test(i, k);
    return meets;
  }
  auto left = 64 * std::ssize(flats);
  Cells cells(flats);
  for (std::size_t i = 0; i < flats.size(); ++i) {
    cells.visit(flats[i], [&](std::vector<std::size_t>& cell) {
      left -= 1 + std::ssize(cell);
      if (left < 0) return;
      for (const std::size_t other : cell) test(i, other);
      cell.push_back(i);
    });
    if (left < 0) return std::vector<bool>(flats.size(), true);
  }
  return meets;
}

class Finder {
 public:
  Finder(std::span<const dvec3> positions, std::span<const Triple> triangles)
      : positions_(positions), triangles_(triangles) {
    found_.of.assign(triangles.size(), SharedPlanes::none);
  }

  /// Looks at triangles of one key.
  void look_at(std::span<const Keyed> keyed) {
    if (keyed.size() < 2) return;
    const std::vector<Flat> flats = flattened(keyed);
    const std::vector<bool> meets = meeting(flats);
    std::vector<int> members;
    for (std::size_t i = 0; i < flats.size(); ++i)
      if (meets[i]) members.push_back(flats[i].triangle);
    if (members.empty()) return;
    for (const int member : members)
      found_.of[static_cast<std::size_t>(member)] = static_cast<int>(found_.planes.size());
    found_.planes.push_back(far_apart(members));
  }
  SharedPlanes result() && { return std::move(found_); }

 private:
  const Triple& triangle(int number) const { return triangles_[static_cast<std::size_t>(number)]; }
  const dvec3& position(int vertex) const { return positions_[static_cast<std::size_t>(vertex)]; }
  dvec3 corner(int number, std::size_t k) const { return position(triangle(number)[k]); }

  /// Those that lie in the first one's plane, seen along an axis on which that is not edge-on.
  std::vector<Flat> flattened(std::span<const Keyed> keyed) const {
    const int first = keyed.front().triangle;
    const dvec3 a = corner(first, 0), b = corner(first, 1), c = corner(first, 2);
    int along = 0;
    const auto seen = [&](const dvec3& p) { return dvec2(p[(along + 1) % 3], p[(along + 2) % 3]); };
    while (along < 2 && orient2d(seen(a), seen(b), seen(c)) == 0) ++along;
    std::vector<Flat> flats;
    for (const Keyed& k : keyed) {
      const std::array at{corner(k.triangle, 0), corner(k.triangle, 1), corner(k.triangle, 2)};
      const auto within = [&](const dvec3& p) { return orient3d(a, b, c, p) == 0; };
      if (!std::ranges::all_of(at, within)) continue;
      const std::array flat{seen(at[0]), seen(at[1]), seen(at[2])};
      flats.push_back({k.triangle, flat, glm::min(glm::min(flat[0], flat[1]), flat[2]),
                       glm::max(glm::max(flat[0], flat[1]), flat[2])});
    }
    return flats;
  }

  /// Three vertices of them: the first by its place, the one farthest from it, and the one farthest from
  /// both.
  Triple far_apart(const std::vector<int>& members) const {
    std::vector<int> vertices;
    for (const int member : members)
      vertices.insert(vertices.end(), triangle(member).begin(), triangle(member).end());
    const auto place = [&](int v) {
      const dvec3& p = position(v);
      return std::tuple(p.x, p.y, p.z, v);
    };
    const int first = *std::ranges::min_element(vertices, {}, place);
    const dvec3 from = position(first);
    const auto far = [&](int v) { return std::pair(glm::distance(position(v), from), -v); };
    const int second = *std::ranges::max_element(vertices, {}, far);
    const dvec3 way = position(second) - from;
    const auto aside = [&](int v) { return std::pair(glm::length(glm::cross(way, position(v) - from)), -v); };
    return {first, second, *std::ranges::max_element(vertices, {}, aside)};
  }

  std::span<const dvec3> positions_;
  std::span<const Triple> triangles_;
  SharedPlanes found_;
};

}  // namespace

SharedPlanes shared_planes(std::span<const dvec3> positions, std::span<const Triple> triangles) {
  const std::vector<Keyed> keyed = by_plane(positions, triangles);
  Finder finder(positions, triangles);
  for (auto from = keyed.begin(); from != keyed.end();) {
    const auto to = std::find_if(from, keyed.end(), [&](const Keyed& k) { return k.key != from->key; });
    finder.look_at({from, to});
    from = to;
  }
  return std::move(finder).result();
}

}  // namespace gradus::pipeline
