// Planes that triangles share, against every pair of them in rationals.

#include "scene/shared_planes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <cstddef>
#include <vector>

#include "core/random.hpp"
#include "support/seed.hpp"

namespace gradus::pipeline::shared_planes_test {
namespace {

using Rational = boost::multiprecision::cpp_rational;
using Place = std::array<Rational, 3>;
using Outline = std::vector<std::array<Rational, 2>>;

struct Triangles {
  std::vector<dvec3> positions{};
  std::vector<Triple> triples{};

  void add(const dvec3& a, const dvec3& b, const dvec3& c) {
    const int first = static_cast<int>(positions.size());
    positions.insert(positions.end(), {a, b, c});
    triples.push_back({first, first + 1, first + 2});
  }
  SharedPlanes shared() const { return shared_planes(positions, triples); }
  std::array<Place, 3> corners(std::size_t t) const {
    const auto place = [&](std::size_t k) {
      const dvec3& p = positions[static_cast<std::size_t>(triples[t][k])];
      return Place{Rational(p.x), Rational(p.y), Rational(p.z)};
    };
    return {place(0), place(1), place(2)};
  }
};

Place minus(const Place& a, const Place& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Place cross(const Place& a, const Place& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Rational dot(const Place& a, const Place& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Rational turn(const std::array<Rational, 2>& a, const std::array<Rational, 2>& b,
              const std::array<Rational, 2>& p) {
  return (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]);
}

/// The part of an outline on the left of a line.
Outline left_of(const Outline& outline, const std::array<Rational, 2>& a, const std::array<Rational, 2>& b) {
  Outline left;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const auto &p = outline[i], &q = outline[(i + 1) % outline.size()];
    const Rational at_p = turn(a, b, p), at_q = turn(a, b, q);
    if (at_p >= 0) left.push_back(p);
    if (at_p * at_q >= 0) continue;
    const Rational share = at_p / (at_p - at_q);
    left.push_back({p[0] + share * (q[0] - p[0]), p[1] + share * (q[1] - p[1])});
  }
  return left;
}

Rational doubled_area(const Outline& outline) {
  Rational sum = 0;
  for (std::size_t i = 2; i < outline.size(); ++i) sum += turn(outline[0], outline[i - 1], outline[i]);
  return sum;
}

/// Whether two triangles lie in one plane and have an area in common.
bool lie_over_one_another(const std::array<Place, 3>& a, const std::array<Place, 3>& b) {
  const Place normal = cross(minus(a[1], a[0]), minus(a[2], a[0]));
  for (const Place& p : b)
    if (dot(normal, minus(p, a[0])) != 0) return false;
  std::size_t along = 0;
  while (along < 3 && normal[along] == 0) ++along;
  if (along == 3) return false;
  const auto flat = [&](const std::array<Place, 3>& t) {
    Outline outline;
    for (const Place& p : t) outline.push_back({p[(along + 1) % 3], p[(along + 2) % 3]});
    if (doubled_area(outline) < 0) std::swap(outline[0], outline[1]);
    return outline;
  };
  Outline common = flat(a);
  const Outline other = flat(b);
  for (std::size_t i = 0; i < 3; ++i) common = left_of(common, other[i], other[(i + 1) % 3]);
  return doubled_area(other) != 0 && doubled_area(common) > 0;
}

/// Triangles with corners among a few places, so that many lie in one plane; moved and turned by what is
/// exact in doubles.
Triangles crowded(Random& random) {
  Triangles all;
  const double scale = std::ldexp(1.0, static_cast<int>(random.uniform_int(-40, 40)));
  const auto whole = [&](std::int64_t most) { return static_cast<double>(random.uniform_int(0, most)); };
  const dvec3 from{whole(1 << 20), whole(1 << 20), whole(1 << 20)};
  const std::int64_t lean_x = random.uniform_int(-3, 3), lean_y = random.uniform_int(-3, 3);
  const auto place = [&](double layer) {
    const double x = whole(4), y = whole(4);
    const double z = layer + static_cast<double>(lean_x) * x + static_cast<double>(lean_y) * y;
    return scale * (from + dvec3{x, y, z});
  };
  const auto count = random.uniform_int(2, 14);
  for (int i = 0; i < count; ++i) {
    const double layer = whole(1);
    const auto p = place(layer), q = place(layer),
               r = place(random.uniform_int(0, 9) == 0 ? 1 - layer : layer);
    all.add(p, q, r);
  }
  return all;
}

TEST(SharedPlanes, AreThoseInWhichTrianglesHaveAnAreaInCommon) {
  int shared = 0, alone = 0;
  for (std::uint64_t round = 0; round < 400; ++round) {
    Random random(test::seed(), round);
    const Triangles all = crowded(random);
    const SharedPlanes found = all.shared();
    ASSERT_EQ(found.of.size(), all.triples.size());
    for (std::size_t i = 0; i < all.triples.size(); ++i) {
      bool meets = false;
      for (std::size_t k = 0; k < all.triples.size(); ++k) {
        if (i == k || !lie_over_one_another(all.corners(i), all.corners(k))) continue;
        meets = true;
        EXPECT_EQ(found.of[i], found.of[k]) << "round " << round << ", triangles " << i << " and " << k;
      }
      EXPECT_EQ(found.of[i] != SharedPlanes::none, meets) << "round " << round << ", triangle " << i;
      (meets ? shared : alone) += 1;
      if (!meets) continue;
      // What gives the plane spans it, and lies in that of the triangle
      const auto corners = all.corners(i);
      const Place normal = cross(minus(corners[1], corners[0]), minus(corners[2], corners[0]));
      std::array<Place, 3> given;
      for (std::size_t k = 0; k < 3; ++k) {
        const dvec3& p =
            all.positions[static_cast<std::size_t>(found.planes[static_cast<std::size_t>(found.of[i])][k])];
        given[k] = {Rational(p.x), Rational(p.y), Rational(p.z)};
        EXPECT_EQ(dot(normal, minus(given[k], corners[0])), 0);
      }
      EXPECT_NE(cross(minus(given[1], given[0]), minus(given[2], given[0])), (Place{0, 0, 0}));
    }
  }
  EXPECT_GT(shared, 500);
  EXPECT_GT(alone, 500);
}

TEST(SharedPlanes, ThePartsOfAFaceShareNone) {
  Triangles quad;
  quad.add({0, 0, 0.1}, {1, 0, 0.1}, {1, 1, 0.1});
  quad.add({0, 0, 0.1}, {1, 1, 0.1}, {0, 1, 0.1});
  EXPECT_EQ(quad.shared().of, (std::vector{SharedPlanes::none, SharedPlanes::none}));
  // A decal on both
  quad.add({0.25, 0.25, 0.1}, {0.75, 0.5, 0.1}, {0.25, 0.75, 0.1});
  EXPECT_EQ(quad.shared().of, (std::vector{0, 0, 0}));
}

/// A floor of side x side tiles of two triangles each.
Triangles tiles(int side) {
  Triangles floor;
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) {
      const dvec3 a(x, y, 0.3), b(x + 1, y, 0.3), c(x + 1, y + 1, 0.3), d(x, y + 1, 0.3);
      floor.add(a, b, c);
      floor.add(a, c, d);
    }
  }
  return floor;
}

TEST(SharedPlanes, TilesOfAFloorShareNoneButThoseUnderACarpet) {
  Triangles floor = tiles(60);
  const auto sharing = [](const SharedPlanes& found) {
    return std::ranges::count_if(found.of, [](int plane) { return plane != SharedPlanes::none; });
  };
  EXPECT_EQ(sharing(floor.shared()), 0);
  floor.add({10, 10, 0.3}, {13, 10, 0.3}, {10, 13, 0.3});
  // 3 tiles whole, and halves of 3 on its slanted side, which both of their triangles have
  EXPECT_EQ(sharing(floor.shared()), 1 + 2 * 6);
}

TEST(SharedPlanes, ManySliversRoundOnePlaceEndSoon) {
  Triangles fan;
  constexpr int count = 20000;
  for (int i = 0; i < count; ++i) {
    const auto rim = [&](int k) {
      const double x = static_cast<double>(k) / count;
      return dvec3{x, 1 - x * x / 2, 0};
    };
    fan.add({0, 0, 0}, rim(i + 1), rim(i));
  }
  const SharedPlanes found = fan.shared();
  EXPECT_EQ(found.of.size(), std::size_t{count});
  EXPECT_LE(found.planes.size(), 1U);
}

TEST(SharedPlanes, TrianglesWithoutAnAreaShareNone) {
  Triangles all;
  all.add({0, 0, 0}, {1, 1, 1}, {2, 2, 2});
  all.add({0, 0, 0}, {1, 1, 1}, {2, 2, 2});
  all.add({3, 3, 3}, {3, 3, 3}, {3, 3, 3});
  EXPECT_EQ(all.shared().of, (std::vector(3, SharedPlanes::none)));
  EXPECT_TRUE(Triangles{}.shared().of.empty());
}

}  // namespace
}  // namespace gradus::pipeline::shared_planes_test
