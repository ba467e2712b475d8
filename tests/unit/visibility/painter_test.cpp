// The painter's order, judged along rays in rational numbers.

#include "core/arithmetic/exact_scalar.hpp"

#include "visibility/painter/painter.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <regex>
#include <string>
#include <vector>

#include "core/random.hpp"
#include "core/record.hpp"
#include "support/sanitized.hpp"
#include "support/seed.hpp"
#include "visibility/painter/painter_notes.hpp"

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

template <class Method>
std::vector<std::size_t> drawn_by(const Method& method, const Scene& scene, const View<double>& view) {
  std::vector<std::size_t> all;
  method(scene, view, [&](const Polygon<double>& polygon) { all.push_back(polygon.face); });
  return all;
}
constexpr auto by_newell = [](auto&&... all) { newell(all...); };
constexpr auto by_farthest = [](auto&&... all) { farthest_vertex(all...); };
constexpr auto by_centroid = [](auto&&... all) { centroid(all...); };
constexpr auto by_mean_depth = [](auto&&... all) { mean_depth(all...); };
constexpr auto by_mean_z = [](auto&&... all) { descending_mean_z(all...); };
using Order = std::vector<std::size_t>;

TEST(Painter, ALongWallInFrontOfASmallOne) {
  // G001-76: from the origin, A at z = 10 is in front of B at z = 20
  const Scene walls{Polygon<double>({{0, -1, 10}, {100, -1, 10}, {100, 1, 10}, {0, 1, 10}}, 0),
                    Polygon<double>({{0, -1, 20}, {2, -1, 20}, {2, 1, 20}, {0, 1, 20}}, 1)};
  const View<double> view = view_along(Eye<double>{0, 0, 0, 1}, dvec3{0, 0, 1}, dvec3{0, 1, 0});
  EXPECT_EQ(drawn_by(by_newell, walls, view), (Order{1, 0}));
  EXPECT_EQ(drawn_by(by_centroid, walls, view), (Order{0, 1})) << "the notes paint B over A";
  const auto distance = [&](std::size_t i) { return std::sqrt(far(view.eye, mean(walls[i]))); };
  EXPECT_NEAR(distance(0), 50.99019513592785, 1e-12);
  EXPECT_NEAR(distance(1), 20.024984394500787, 1e-12);
}

TEST(Painter, TheMeanOfCornersIsNoCentroid) {
  // E001-27: a square of side 10 with five more corners on top
  const Polygon<double> square({{0, 0, 0},
                                {10, 0, 0},
                                {10, 10, 0},
                                {9, 10, 0},
                                {8, 10, 0},
                                {7, 10, 0},
                                {6, 10, 0},
                                {5, 10, 0},
                                {0, 10, 0}});
  const dvec3 place = mean(square);
  EXPECT_NEAR(place.x, 6.11, 5e-3);
  EXPECT_NEAR(place.y, 7.78, 5e-3);
}

/// Squares that face an eye on the axis, at these z.
Scene squares_at(std::initializer_list<double> places) {
  Scene scene;
  for (const double z : places)
    scene.push_back({{{-1, -1, z}, {1, -1, z}, {1, 1, z}, {-1, 1, z}}, scene.size()});
  return scene;
}

TEST(Painter, DescendingMeanZDrawsTheNearestFirst) {
  // G002-17: an eye at z = 1000 that looks along -z
  const Scene scene = squares_at({500, 100, 900});
  const View<double> view = view_along(Eye<double>{0, 0, 1000, 1}, dvec3{0, 0, -1}, dvec3{0, 1, 0});
  EXPECT_EQ(drawn_by(by_mean_z, scene, view), (Order{2, 0, 1}));
  EXPECT_EQ(drawn_by(by_newell, scene, view), (Order{1, 0, 2}));
  EXPECT_EQ(drawn_by(by_farthest, scene, view), (Order{1, 0, 2}));
}

TEST(Painter, TwoSquaresAtDifferentDepthsAreRightByAnyDepth) {
  for (const auto& [one, other] : {std::pair(1.0, 2.0), std::pair(2.0, 1.0)}) {
    const Scene scene = squares_at({one, other});
    const Order right = one < other ? Order{0, 1} : Order{1, 0};
    const View<double> view = distant_view(dvec3{0.1, 0.2, 1}, dvec3{0, 1, 0});
    EXPECT_EQ(drawn_by(by_newell, scene, view), right);
    EXPECT_EQ(drawn_by(by_farthest, scene, view), right);
    EXPECT_EQ(drawn_by(by_centroid, scene, view), right);
    EXPECT_EQ(drawn_by(by_mean_depth, scene, view), right);
  }
}

TEST(Painter, MeanDepthsDoNotIncrease) {
  Random random(test::seed());
  for (int round = 0; round < 40; ++round) {
    const View<double> view = random_view(random, round % 2 == 0);
    double before = std::numeric_limits<double>::infinity();
    mean_depth(random_scene(random, 20), view, [&](const Polygon<double>& polygon) {
      const double key = glm::dot(view.forward, mean(polygon));
      EXPECT_LE(key, before);
      before = key;
    });
  }
}

TEST(Painter, MeanDepthsMayTurnAPairRound) {
  // E000-13: A leans, and its far half passes behind B
  const Scene scene{Polygon<double>({{-6, -3, -5}, {6, -3, 3}, {6, 1, 3}, {-6, 1, -5}}, 0),
                    Polygon<double>({{-5, -5, -2}, {-3, -5, -2}, {-3, 3, -2}, {-5, 3, -2}}, 1)};
  const View<double> view = distant_view(dvec3{0, 0, 1}, dvec3{0, 1, 0});
  EXPECT_EQ(drawn_by(by_mean_depth, scene, view), (Order{1, 0})) << "A over B";
  EXPECT_EQ(drawn_by(by_newell, scene, view), (Order{0, 1}));
}

TEST(Painter, SortingTakesSomeNLogNComparisons) {
  Random random(test::seed());
  for (int n = 16; n <= 4096; n *= 4) {
    std::size_t comparisons = 0;
    const auto watch = [&]<class Step>(const Step& step) {
      if constexpr (std::same_as<Step, Sorted<double>>) comparisons = step.comparisons;
    };
    farthest_vertex(random_scene(random, n, 1000), from_below, [](const auto&) {}, watch);
    const double expected = n * std::log2(n);
    EXPECT_GT(static_cast<double>(comparisons), 0.5 * expected) << n;
    EXPECT_LT(static_cast<double>(comparisons), 1.1 * expected) << n;
  }
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

// --- Every pair by brute force, for a distant eye

using ExactVec2 = glm::vec<2, Exact>;
using ExactRing = std::vector<ExactVec2>;

/// Along the sight lines onto the plane z = 0.
ExactRing shadow(const Polygon<Exact>& polygon, const ExactVec3& towards) {
  ExactRing ring;
  for (const auto& p : polygon.corners)
    ring.emplace_back(p.x - p.z * towards.x / towards.z, p.y - p.z * towards.y / towards.z);
  return ring;
}
Exact cross(const ExactVec2& a, const ExactVec2& b) { return a.x * b.y - a.y * b.x; }
Exact area(const ExactRing& ring) {
  Exact sum(0);
  for (std::size_t i = 0; i < ring.size(); ++i) sum += cross(ring[i], ring[(i + 1) % ring.size()]);
  return sum;
}
ExactRing common(ExactRing ring, const ExactRing& window) {
  const int turn = sign(area(window));
  for (std::size_t i = 0; i < window.size(); ++i) {
    const ExactVec2 a = window[i], way = window[(i + 1) % window.size()] - a;
    ExactRing kept;
    for (std::size_t k = 0; k < ring.size(); ++k) {
      const ExactVec2 p = ring[k], q = ring[(k + 1) % ring.size()];
      const Exact from = Exact(turn) * cross(way, p - a), to = Exact(turn) * cross(way, q - a);
      if (sign(from) >= 0) kept.push_back(p);
      if (sign(from) * sign(to) < 0) kept.push_back(p + from / (from - to) * (q - p));
    }
    ring = std::move(kept);
  }
  return ring;
}
/// How far towards the eye from z = 0 a sight line meets a polygon's plane.
Exact height(const Polygon<Exact>& polygon, const ExactVec2& place, const ExactVec3& towards) {
  const auto &a = polygon.plane.a, &b = polygon.plane.b, &c = polygon.plane.c;
  const ExactVec3 normal = glm::cross(b - a, c - a);
  return glm::dot(normal, a - ExactVec3{place.x, place.y, Exact(0)}) / glm::dot(normal, towards);
}
/// Whether some place of one lies behind the other.
bool lies_behind(const Polygon<Exact>& one, const Polygon<Exact>& other, const ExactVec3& towards) {
  const ExactRing a = shadow(one, towards), b = shadow(other, towards);
  if (area(a) == Exact(0) || area(b) == Exact(0)) return false;
  const ExactRing overlap = common(a, b);
  if (overlap.size() < 3 || area(overlap) == Exact(0)) return false;
  return std::ranges::any_of(overlap, [&](const ExactVec2& place) {
    return height(one, place, towards) < height(other, place, towards);
  });
}

TEST(Painter, EveryPairIsInOrder) {
  Random random(test::seed());
  int pairs = 0, turned = 0;
  for (int round = 0; round < 30; ++round) {
    const ExactScope scope;
    const View<Exact> view = in_scalar<Exact>(random_view(random, true));
    const auto order = drawn(in_scalar<Exact>(random_scene(random, 5, round % 2 == 0 ? 2 : 6)), view);
    const ExactVec3 towards(view.eye);
    for (std::size_t late = 0; late < order.size(); ++late) {
      for (std::size_t early = 0; early < late; ++early) {
        EXPECT_FALSE(lies_behind(order[late], order[early], towards));
        turned += lies_behind(order[early], order[late], towards);
        ++pairs;
      }
    }
  }
  EXPECT_GT(pairs, 1000);
  EXPECT_GT(turned, 100) << "of pairs that overlap";
}

/// Along any ray the last polygon painted is that of the BSP tree's picture.
TEST(Painter, ShowsWhatTheBspTreeShows) {
  Random random(test::seed());
  int hits = 0;
  for (int round = 0; round < (test::sanitized ? 10 : 30); ++round) {
    const ExactScope scope;
    const auto scene = in_scalar<Exact>(random_scene(random, 6));
    const bool distant = round % 2 == 0;
    const View<Exact> view = in_scalar<Exact>(random_view(random, distant));
    std::vector<Polygon<Exact>> walked;
    bsp_tree::back_to_front(bsp_tree::build(scene), view.eye,
                            [&](const auto& part) { walked.push_back(part); });
    const auto order = drawn(scene, view);
    for (int ray = 0; ray < 40; ++ray) {
      const auto tenths = [&] { return Exact(random.uniform_int(-60, 60)) / Exact(10); };
      const ExactVec3 place{tenths(), tenths(), tenths()}, eye(view.eye);
      const ExactVec3 from = distant ? place : eye, way = distant ? -eye : place - eye;
      const auto shown = [&](const std::vector<Polygon<Exact>>& parts) {
        std::optional<Exact> last;
        for (const auto& part : parts) {
          if (const auto at = hit(part, from, way)) last = at;
        }
        return last;
      };
      const auto one = shown(order), other = shown(walked);
      if (!one || !other) continue;  // on the border of a part
      EXPECT_EQ(*one, *other);
      ++hits;
    }
  }
  EXPECT_GT(hits, test::sanitized ? 50 : 150);
}

// --- Steps

template <class T>
using Watch = Recorder<Sorted<T>, Taken<T>, Compared<T>, Moved<T>, Cut<T>, Inserted<T>, Drawn<T>, Finished>;

/// A letter for each step.
template <class T>
std::string grammar(const Watch<T>& seen) {
  std::string steps;
  for (const auto& event : seen.events()) steps += "STCMKIDF"[event.step.index()];
  return steps;
}

TEST(Painter, StepsFollowTheGrammar) {
  Random random(test::seed());
  const std::regex form("S(TC*(D|M|KI))*F");
  int cuts = 0, moves = 0;
  for (int round = 0; round < 40; ++round) {
    const ExactScope scope;
    Watch<Exact> seen;
    const auto scene = in_scalar<Exact>(random_scene(random, 6));
    newell(scene, in_scalar<Exact>(random_view(random, round % 2 == 0)), [](const auto&) {}, seen);
    const std::string steps = grammar(seen);
    EXPECT_TRUE(std::regex_match(steps, form)) << steps;
    cuts += static_cast<int>(std::ranges::count(steps, 'K'));
    moves += static_cast<int>(std::ranges::count(steps, 'M'));
    // Between cuts each moves at most once
    const auto pieces = scene.size() + static_cast<std::size_t>(std::ranges::count(steps, 'K'));
    std::size_t moved = 0;
    for (const char step : steps) {
      moved = step == 'K' ? 0 : moved + (step == 'M');
      EXPECT_LE(moved, pieces);
    }
  }
  EXPECT_GT(cuts, 40);
  EXPECT_GT(moves, 40);
}

TEST(Painter, SortedOrdersAreThoseOfTheFarthestCorners) {
  Random random(test::seed());
  const View<double> view = random_view(random, true);
  const auto deepest = [&](const Polygon<double>& polygon) {
    double depth = -1e300;
    for (const dvec3 p : polygon.corners) depth = std::max(depth, glm::dot(view.forward, p));
    return depth;
  };
  newell(
      random_scene(random, 12), view, [](const auto&) {},
      [&]<class Step>(const Step& step) {
        if constexpr (std::same_as<Step, Sorted<double>>)
          EXPECT_TRUE(std::ranges::is_sorted(step.order, std::greater{}, deepest));
      });
}

TEST(Painter, FloatsAreOrderedExactlyToo) {
  const auto order = drawn(in_scalar<float>(three_bars()), in_scalar<float>(from_below));
  const auto same = drawn(three_bars(), from_below);
  EXPECT_EQ(faces(order), faces(same));
}

}  // namespace
}  // namespace gradus::painter
