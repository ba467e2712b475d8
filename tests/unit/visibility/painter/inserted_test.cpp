// Where the painter puts the parts that a plane has cut, and what had moved before: told by its steps, and
// held against a sort of the whole list.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <vector>

#include "core/random.hpp"
#include "support/seed.hpp"
#include "visibility/painter/painter.hpp"

namespace gradus::painter {
namespace {

using Scene = std::vector<Polygon<double>>;

/// Triangles with small whole coordinates, so that many depths are alike.
Scene random_scene(Random& random, std::size_t count, int most) {
  Scene scene;
  while (scene.size() < count) {
    std::vector<dvec3> p;
    for (int i = 0; i < 3; ++i) {
      const auto number = [&] { return static_cast<double>(random.uniform_int(-most, most)); };
      p.emplace_back(number(), number(), number());
    }
    if (glm::cross(p[1] - p[0], p[2] - p[0]) != dvec3(0)) scene.emplace_back(p, scene.size());
  }
  return scene;
}

/// The painter's list as its steps tell it; the first is the next to be drawn.
class Told {
 public:
  explicit Told(dvec3 forward) : forward_(forward) {}

  void operator()(const Sorted<double>& s) { order_ = s.order; }
  void operator()(const Drawn<double>& d) { order_.erase(find(d.polygon)); }
  void operator()(const Moved<double>& m) { std::rotate(order_.begin(), find(m.q), find(m.q) + 1); }
  void operator()(const Cut<double>& c) {
    order_.erase(find(c.whole));
    order_.insert(order_.begin(), {c.behind, c.in_front});
  }
  void operator()(const Inserted<double>& i) {
    Scene sorted = order_;
    std::ranges::stable_sort(sorted, [&](const auto& p, const auto& q) {
      // Whole numbers, and cuts between them: of what rounding leaves doubtful the exact comparison decides
      const int deeper = compare_depths(forward_, farthest(p), farthest(q));
      return deeper != 0 ? deeper > 0 : p.face < q.face;
    });
    for (const auto& place : i.places) order_.erase(find(place.polygon));
    for (const auto& [polygon, before] : i.places)
      order_.insert(order_.begin() + static_cast<std::ptrdiff_t>(before), polygon);
    EXPECT_TRUE(std::ranges::equal(order_, sorted, {}, &Polygon<double>::corners, &Polygon<double>::corners));
    several += i.places.size() > 2;
    ++inserted;
  }
  template <class Step>
  void operator()(const Step&) {}

  int inserted = 0, several = 0;

 private:
  Scene::iterator find(const Polygon<double>& polygon) {
    return std::ranges::find(order_, polygon.corners, &Polygon<double>::corners);
  }
  dvec3 farthest(const Polygon<double>& polygon) const {
    return *std::ranges::max_element(polygon.corners,
                                     [&](dvec3 p, dvec3 q) { return compare_depths(forward_, p, q) < 0; });
  }

  dvec3 forward_;
  Scene order_;
};

TEST(Painter, PartsAreInsertedWhereSortingWouldPutThem) {
  int inserted = 0, several = 0;
  for (std::uint64_t round = 0; round < 60; ++round) {
    SCOPED_TRACE(testing::Message() << "seed " << test::seed() << ", round " << round);
    Random random(test::seed(), round);
    const View<double> view = round % 2 == 0 ? distant_view(dvec3{1, 2, 9}, dvec3{0, 1, 0})
                                             : view_along({3, -2, 12, 1}, dvec3{0, 0, -1}, dvec3{0, 1, 0});
    Told told(view.forward);
    newell(random_scene(random, 12, round % 3 == 0 ? 2 : 6), view, [](const auto&) {}, told);
    inserted += told.inserted;
    several += told.several;
  }
  EXPECT_GT(inserted, 500);
  EXPECT_GT(several, 100);
}

TEST(Painter, PartsGoBackAlikeWhetherOrNotTheirPlacesAreAskedFor) {
  const View<double> view = distant_view(dvec3{1, 2, 9}, dvec3{0, 1, 0});
  for (std::uint64_t round = 0; round < 60; ++round) {
    SCOPED_TRACE(testing::Message() << "seed " << test::seed() << ", round " << round);
    Random random(test::seed(), round);
    const Scene scene = random_scene(random, 12, 6);
    auto list = pieces_of(scene, view);
    const auto last = random.uniform_int(0, 6);
    std::ranges::rotate(list, list.begin() + random.uniform_int(0, 11));
    std::sort(list.begin(), list.end() - last,
              [&](const auto& p, const auto& q) { return belongs_before(p, q, view); });
    for (auto piece = list.end() - last; piece != list.end(); ++piece) piece->moved = true;
    auto unasked = list;
    EXPECT_EQ(std::ssize(put_back<true>(list, view)), last);
    EXPECT_TRUE(put_back(unasked, view).empty());
    const auto number = [](const auto& piece) { return piece.number; };
    EXPECT_TRUE(std::ranges::equal(list, unasked, {}, number, number));
    EXPECT_TRUE(std::ranges::is_sorted(
        list, [&](const auto& p, const auto& q) { return belongs_before(p, q, view); }));
  }
}

TEST(Painter, ACutDoesNotMoveTheWholeList) {
  // Beyond a thousand squares two cross: their parts stay beyond them
  Scene scene;
  const auto square = [&](double size, double z, double lean) {
    scene.push_back(
        {{{-size, -size, z - lean}, {size, -size, z + lean}, {size, size, z + lean}, {-size, size, z - lean}},
         scene.size()});
  };
  for (int i = 0; i < 1000; ++i) square(1, i * 1e-3, 0);
  square(1, -5, 0.5), square(1, -5, -0.5);
  std::size_t cuts = 0, passed = 0;
  newell(
      scene, distant_view(dvec3{0, 0, 1}, dvec3{0, 1, 0}), [](const auto&) {},
      [&]<class Step>(const Step& step) {
        if constexpr (std::same_as<Step, Inserted<double>>) {
          ++cuts;
          for (const auto& place : step.places) passed += place.before;
        }
      });
  EXPECT_GT(cuts, 0U);
  EXPECT_LT(passed, 10 * cuts);
}

}  // namespace
}  // namespace gradus::painter
