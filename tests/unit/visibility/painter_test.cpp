// The painter's order, judged along rays in rational numbers.

#include "core/arithmetic/exact_scalar.hpp"

#include "visibility/painter/painter.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>
#include <vector>

#include "core/random.hpp"
#include "core/record.hpp"
#include "support/seed.hpp"

namespace gradus::painter {
namespace {

using Scene = std::vector<Polygon<double>>;

template <class T>
std::vector<Polygon<T>> in_scalar(const Scene& polygons) {
  std::vector<Polygon<T>> others;
  for (const auto& polygon : polygons) {
    std::vector<glm::vec<3, T>> corners;
    for (const dvec3 p : polygon.corners) corners.emplace_back(T(p.x), T(p.y), T(p.z));
    others.emplace_back(std::move(corners), polygon.face);
  }
  return others;
}
template <class T>
View<T> in_scalar(const View<double>& view) {
  const auto all = [](dvec3 p) { return glm::vec<3, T>(T(p.x), T(p.y), T(p.z)); };
  return {Eye<T>(all(dvec3(view.eye)), T(view.eye.w)), all(view.right), all(view.up), all(view.forward)};
}

template <class T>
std::vector<Polygon<T>> drawn(const std::vector<Polygon<T>>& scene, const View<T>& view) {
  std::vector<Polygon<T>> order;
  newell(scene, view, [&](const Polygon<T>& polygon) { order.push_back(polygon); });
  return order;
}
template <class T>
std::vector<std::size_t> faces(const std::vector<Polygon<T>>& order) {
  std::vector<std::size_t> all;
  for (const auto& polygon : order) all.push_back(polygon.face);
  return all;
}

/// Where the ray from `from` along `way` meets a convex polygon's inside, as a multiple of `way`.
std::optional<Exact> hit(const Polygon<Exact>& polygon, const ExactVec3& from, const ExactVec3& way) {
  const auto& p = polygon.corners;
  const ExactVec3 normal = glm::cross(p[1] - p[0], p[2] - p[0]);
  const Exact along = glm::dot(normal, way);
  if (along == Exact{0}) return std::nullopt;
  const Exact t = glm::dot(normal, p[0] - from) / along;
  const ExactVec3 at = from + t * way;
  int turn = 0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const int side = sign(glm::dot(normal, glm::cross(p[(i + 1) % p.size()] - p[i], at - p[i])));
    if (side == 0 || side == -turn) return std::nullopt;
    turn = side;
  }
  return t;
}

/// Three corners with small whole coordinates, not on a line.
Polygon<double> random_triangle(Random& random, int most, std::size_t face) {
  while (true) {
    std::vector<dvec3> p;
    for (int i = 0; i < 3; ++i) {
      const auto number = [&] { return static_cast<double>(random.uniform_int(-most, most)); };
      p.emplace_back(number(), number(), number());
    }
    if (glm::cross(p[1] - p[0], p[2] - p[0]) != dvec3(0)) return {p, face};
  }
}
Scene random_scene(Random& random, int count, int most = 6) {
  Scene scene;
  for (int i = 0; i < count; ++i) scene.push_back(random_triangle(random, most, static_cast<std::size_t>(i)));
  return scene;
}

/// An eye beyond z = 6, or at w = 0 the direction towards it.
View<double> random_view(Random& random, bool distant) {
  const auto whole = [&](int least, int most) {
    return static_cast<double>(random.uniform_int(least, most));
  };
  const dvec3 eye{whole(-9, 9), whole(-9, 9), whole(9, 20)}, up{whole(-2, 2), 5, whole(-2, 2)};
  return distant ? distant_view(eye, up) : view_along(Eye<double>(eye, 1), dvec3{0, 0, -1}, up);
}

/// Three bars round a triangle, each over the next: G001-77.
Scene three_bars() {
  const std::array<dvec3, 6> ends{{{0, 0, 0}, {10, 0, 2}, {10, 0, 0}, {5, 8, 2}, {5, 8, 0}, {0, 0, 2}}};
  Scene bars;
  for (std::size_t i = 0; i < 3; ++i) {
    const dvec3 a = ends[2 * i], b = ends[2 * i + 1], way = b - a;
    // Half a unit to either side, and a little beyond the ends, where they cross the others
    const dvec3 aside = dvec3{-way.y, way.x, 0} / 16.0, ahead = way / 8.0;
    bars.push_back(
        Polygon<double>({a - ahead - aside, b + ahead - aside, b + ahead + aside, a - ahead + aside}, i));
  }
  return bars;
}
const View<double> from_below = distant_view(dvec3{0, 0, -1}, dvec3{0, 1, 0});

/// The face that is painted last at a place of the picture seen from below.
std::size_t shown_at(const Scene& order, dvec2 place) {
  const ExactScope scope;
  std::size_t last = none;
  const auto exact = in_scalar<Exact>(order);
  for (const auto& polygon : exact) {
    if (hit(polygon, {Exact(place.x), Exact(place.y), Exact(0)}, {Exact(0), Exact(0), Exact(1)}))
      last = polygon.face;
  }
  return last;
}
bool shows_the_cycle(const Scene& order) {
  return shown_at(order, {10, 0}) == 1 && shown_at(order, {5, 8}) == 2 && shown_at(order, {0, 0}) == 0;
}

TEST(Painter, EveryOrderOfThreeWholeBarsIsWrong) {
  // G001-77: B over A at (10, 0), C over B at (5, 8), A over C at (0, 0)
  const Scene bars = three_bars();
  std::array<std::size_t, 3> order{0, 1, 2};
  int wrong = 0;
  do {
    wrong += !shows_the_cycle({bars[order[0]], bars[order[1]], bars[order[2]]});
  } while (std::ranges::next_permutation(order).found);
  EXPECT_EQ(wrong, 6);
}

TEST(Painter, ThreeBarsInACycleAreCut) {
  const auto order = drawn(three_bars(), from_below);
  EXPECT_GT(order.size(), 3U);
  EXPECT_TRUE(shows_the_cycle(order));
}

TEST(Painter, PiercingSquaresAreCut) {
  const Scene squares{Polygon<double>({{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}}, 0),
                      Polygon<double>({{-1, 0, -1}, {1, 0, -1}, {1, 0, 1}, {-1, 0, 1}}, 1)};
  const auto order = drawn(squares, distant_view(dvec3{0, 1, 1}, dvec3{0, 1, 0}));
  EXPECT_EQ(order.size(), 3U);
}

TEST(Painter, ALongWallInFrontOfASmallOne) {
  // G001-76: from the origin, A at z = 10 is painted over B at z = 20
  const Scene walls{Polygon<double>({{0, -1, 10}, {100, -1, 10}, {100, 1, 10}, {0, 1, 10}}, 0),
                    Polygon<double>({{0, -1, 20}, {2, -1, 20}, {2, 1, 20}, {0, 1, 20}}, 1)};
  const View<double> view = view_along(Eye<double>{0, 0, 0, 1}, dvec3{0, 0, 1}, dvec3{0, 1, 0});
  EXPECT_EQ(faces(drawn(walls, view)), (std::vector<std::size_t>{1, 0}));
}

TEST(Painter, NothingGivesNothing) { EXPECT_TRUE(drawn(Scene{}, from_below).empty()); }

TEST(Painter, RefusesWhatIsNotInFrontOfTheEye) {
  const Scene one{Polygon<double>({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, 3)};
  const auto from = [&](double z) {
    drawn(one, view_along(Eye<double>{0, 0, z, 1}, dvec3{0, 0, -1}, dvec3{0, 1, 0}));
  };
  EXPECT_NO_THROW(from(1e-300));
  EXPECT_THROW(from(0), ContractViolation);
  EXPECT_THROW(from(-1), ContractViolation);
  EXPECT_THROW(distant_view(dvec3{0, 1, 0}, dvec3{0, 2, 0}), ContractViolation);
}

/// Rays on which a later polygon lies farther than an earlier one, and how often any was hit.
struct Judged {
  int hits = 0, wrong = 0;
};
Judged judge(Random& random, const std::vector<Polygon<Exact>>& order, const View<Exact>& view) {
  Judged judged;
  const bool distant = view.eye.w == Exact(0);
  const ExactVec3 eye(view.eye);
  const auto tenths = [&] { return Exact(random.uniform_int(-60, 60)) / Exact(10); };
  for (int ray = 0; ray < 40; ++ray) {
    const ExactVec3 place{tenths(), tenths(), tenths()};
    const ExactVec3 from = distant ? place : eye, way = distant ? -eye : place - eye;
    std::optional<Exact> before;
    for (const auto& polygon : order) {
      const auto at = hit(polygon, from, way);
      if (!at || (!distant && *at <= Exact(0))) continue;
      if (before && *at > *before) ++judged.wrong;
      before = at;
      ++judged.hits;
    }
  }
  return judged;
}

TEST(Painter, NothingCoversWhatComesLater) {
  Random random(test::seed());
  int hits = 0, cuts = 0;
  for (int round = 0; round < 80; ++round) {
    const ExactScope scope;
    const Scene scene = random_scene(random, 8, round % 3 == 0 ? 2 : 6);
    const View<Exact> view = in_scalar<Exact>(random_view(random, round % 2 == 0));
    const auto order = drawn(in_scalar<Exact>(scene), view);
    cuts += static_cast<int>(order.size()) - 8;
    const Judged judged = judge(random, order, view);
    EXPECT_EQ(judged.wrong, 0);
    hits += judged.hits;
  }
  EXPECT_GT(hits, 1000);
  EXPECT_GT(cuts, 200);
}

}  // namespace
}  // namespace gradus::painter
