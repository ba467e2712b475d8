// What drawings of space show and hide, judged by rays.

#include "stories/space_drawing.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string>

#include "core/random.hpp"
#include "support/seed.hpp"

namespace gradus {
namespace {

using Rings = std::vector<std::vector<dvec3>>;

Rings rings_of(const std::vector<dvec3>& corners, const std::vector<std::vector<std::size_t>>& faces) {
  Rings rings;
  for (const auto& face : faces) {
    rings.emplace_back();
    for (const std::size_t i : face) rings.back().push_back(corners[i]);
  }
  return rings;
}

/// Corner i lies at x, y, z = its bits 0, 1, 2.
std::vector<dvec3> cube_corners() {
  std::vector<dvec3> corners;
  for (int i = 0; i < 8; ++i) corners.push_back({i & 1, i >> 1 & 1, i >> 2 & 1});
  return corners;
}
Rings cube() {
  return rings_of(cube_corners(),
                  {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}});
}

/// An L 2 wide, 2 high and 1 deep, whose front and back are concave.
Rings letter_l() {
  const std::array<dvec2, 6> outline{{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}};
  Rings rings(2);
  for (const dvec2 p : outline) {
    rings[0].emplace_back(p, 1);
    rings[1].insert(rings[1].begin(), dvec3(p, 0));
  }
  for (std::size_t i = 0; i < 6; ++i) {
    const dvec2 a = outline[i], b = outline[(i + 1) % 6];
    rings.push_back({{a, 0}, {b, 0}, {b, 1}, {a, 1}});
  }
  return rings;
}

/// Three squares through each other.
Rings piercing_squares() {
  return {{{-1, -1, 0.1}, {1, -1, 0.1}, {1, 1, 0.1}, {-1, 1, 0.1}},
          {{-1, 0.2, -1}, {1, 0.2, -1}, {1, 0.2, 1}, {-1, 0.2, 1}},
          {{0.3, -1, -1}, {0.3, 1, -1}, {0.3, 1, 1}, {0.3, -1, 1}}};
}

/// Where the way from p meets a flat ring, as a multiple of the way, by the parity of crossings in the plane
/// that keeps most of it.
std::optional<double> hit(const std::vector<dvec3>& ring, dvec3 p, dvec3 way) {
  const dvec3 normal = area_vector(ring), size = glm::abs(normal);
  const double along = glm::dot(normal, way);
  if (along == 0) return std::nullopt;
  const double t = glm::dot(normal, ring[0] - p) / along;
  const dvec3 at = p + t * way;
  const int drop = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  const int u = (drop + 1) % 3, v = (drop + 2) % 3;
  bool in = false;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const dvec3 a = ring[i], b = ring[(i + 1) % ring.size()];
    if ((a[v] <= at[v]) == (b[v] <= at[v])) continue;
    if (at[u] < a[u] + (at[v] - a[v]) / (b[v] - a[v]) * (b[u] - a[u])) in = !in;
  }
  return in ? std::optional(t) : std::nullopt;
}

bool is_hidden(const Rings& faces, dvec3 p, const Viewer& viewer) {
  return std::ranges::any_of(faces, [&](const auto& ring) {
    const auto t = hit(ring, p, towards(viewer, p));
    return t && *t > 1e-7 && (viewer.w == 0 || *t < 1);
  });
}

TEST(HiddenLines, EdgesOfACubeAreSeenOrHiddenAsAWhole) {
  for (const Viewer& viewer : {distant_viewer({3, 2, 5}), viewer_at({3, 2, 5})}) {
    const HiddenLines lines(cube(), viewer, 2);
    int hidden = 0;
    const auto corners = cube_corners();
    for (std::size_t a = 0; a < 8; ++a) {
      for (const std::size_t bit : {std::size_t{1}, std::size_t{2}, std::size_t{4}}) {
        if ((a & bit) != 0) continue;
        const auto pieces = lines.pieces(corners[a], corners[a | bit]);
        ASSERT_EQ(pieces.size(), 1U);
        hidden += pieces[0].hidden;
        EXPECT_EQ(pieces[0].hidden, a == 0);
      }
    }
    EXPECT_EQ(hidden, 3);
  }
}

TEST(HiddenLines, APartBehindACubeEndsWhereItComesOut) {
  const HiddenLines lines(cube(), distant_viewer({0, 0, 1}), 4);
  const auto pieces = lines.pieces({-1, 0.5, -1}, {3, 0.5, -1});
  ASSERT_EQ(pieces.size(), 3U);
  EXPECT_NEAR(pieces[1].from, 0.25, 1e-8);
  EXPECT_NEAR(pieces[1].to, 0.5, 1e-8);
  EXPECT_TRUE(pieces[1].hidden);
  // However short it is
  const auto brief = lines.pieces({-100, 0.5, -1}, {1100, 0.5, -1});
  ASSERT_EQ(brief.size(), 3U);
  EXPECT_NEAR(1200 * (brief[1].to - brief[1].from), 1, 1e-6);
}

TEST(HiddenLines, WhatIsHiddenIsWhatRaysSay) {
  Random random(test::seed());
  const auto point = [&] {
    return dvec3{random.uniform(-2, 3), random.uniform(-2, 3), random.uniform(-2, 3)};
  };
  int asked = 0, hidden = 0, cut = 0;
  for (const Rings& faces : {cube(), letter_l(), piercing_squares()}) {
    for (int i = 0; i < 1000; ++i) {
      const dvec3 a = point(), b = point(), from = 8.0 * glm::normalize(point());
      const Viewer viewer = i % 2 == 0 ? distant_viewer(from) : viewer_at(from);
      const auto pieces = HiddenLines(faces, viewer, 2).pieces(a, b);
      cut += pieces.size() > 1;
      EXPECT_EQ(pieces.front().from, 0);
      EXPECT_EQ(pieces.back().to, 1);
      for (const SightPiece& piece : pieces) {
        if (piece.to - piece.from < 1e-3) continue;
        const double t = piece.from + random.uniform(0.001, 0.999) * (piece.to - piece.from);
        const dvec3 p = a + t * (b - a);
        EXPECT_EQ(is_hidden(faces, p, viewer), piece.hidden) << i << " " << t;
        ++asked;
        hidden += piece.hidden;
      }
    }
  }
  EXPECT_GT(asked, 4000);
  EXPECT_GT(hidden, 700);
  EXPECT_GT(cut, 700);
}

// --- Areas

bool inside(const Area& area, dvec2 p) {
  bool in = false;
  for (const auto& ring : area.rings) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const dvec2 a = ring[i], b = ring[(i + 1) % ring.size()];
      if ((a.y <= p.y) == (b.y <= p.y)) continue;
      if (p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)) in = !in;
    }
  }
  return in;
}

/// What is seen at a place of the paper, by the ids of the areas, of which later ones cover earlier ones.
std::string seen_at(const View& view, dvec2 p) {
  std::string seen;
  for (const auto& [id, mark] : view.marks) {
    if (const Area* area = std::get_if<Area>(&mark.shape); area && inside(*area, p))
      seen = id.substr(id.rfind(' ') + 1);
  }
  return seen;
}

/// At any place the drawing shows the face that a ray meets first.
TEST(SpaceDrawing, CoversWhatLiesBehind) {
  Random random(test::seed());
  int asked = 0, covered = 0;
  for (const Rings& faces : {cube(), letter_l(), piercing_squares()}) {
    for (int round = 0; round < 40; ++round) {
      const dvec3 forward =
          glm::normalize(dvec3{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)});
      const dvec3 right = glm::normalize(glm::cross(forward, dvec3{0.3, 0.9, 0.1}));
      const dvec3 up = glm::cross(right, forward);
      const bool distant = round % 2 == 0;
      const Viewer viewer = distant ? distant_viewer(-forward) : viewer_at(-9.0 * forward);
      const auto at = [&](dvec3 p) -> std::optional<dvec2> {
        const dvec2 flat{glm::dot(p, right), glm::dot(p, up)};
        return distant ? flat : flat / (glm::dot(p, forward) + 9.0);
      };
      SpaceDrawing drawing({.viewer = viewer, .at = at});
      for (std::size_t i = 0; i < faces.size(); ++i)
        drawing.add(SpaceFace{std::to_string(i), Role::input, faces[i], false});
      View view;
      drawing.add_to(view, "a");
      for (int ray = 0; ray < 60; ++ray) {
        const dvec3 place{random.uniform(-1, 2), random.uniform(-1, 2), random.uniform(-1, 1)};
        const dvec3 way = towards(viewer, place);
        std::string nearest;
        double most = -1e300, next = -1e300;
        for (std::size_t i = 0; i < faces.size(); ++i) {
          const auto t = hit(faces[i], place, way);
          if (!t) continue;
          if (*t > most) {
            next = most;
            most = *t;
            nearest = std::to_string(i);
          } else {
            next = std::max(next, *t);
          }
          ++covered;
        }
        if (most - next < 1e-6) continue;  // where they meet either may be seen
        EXPECT_EQ(seen_at(view, *at(place)), nearest) << round;
        ++asked;
      }
    }
  }
  EXPECT_GT(asked, 2500);
  EXPECT_GT(covered, 5000);
}

TEST(SpaceDrawing, ThreeBarsInACycleAreDrawnRight) {
  // Seen from above, each bar lies over the next one at its right end
  SpaceDrawing drawing(
      {.viewer = distant_viewer({0, 0, 1}), .at = [](dvec3 p) { return std::optional(dvec2(p)); }});
  for (int i = 0; i < 3; ++i) {
    const double turn = 2.0943951023931953 * i;
    const dvec2 along{std::cos(turn), std::sin(turn)}, aside{-along.y, along.x};
    SpaceFace bar{std::to_string(i), Role::input, {}, false};
    for (const dvec2 c : {dvec2{-1.2, -0.45}, dvec2{1.2, -0.45}, dvec2{1.2, -0.15}, dvec2{-1.2, -0.15}})
      bar.ring.emplace_back(c.x * along + c.y * aside, 0.2 * c.x);
    drawing.add(std::move(bar));
  }
  View view;
  drawing.add_to(view, "a");
  // Bars i and i + 1 cross at one place: there the former is at its right end, the latter at its left
  for (int i = 0; i < 3; ++i) {
    const double turn = 2.0943951023931953 * i;
    const dvec2 along{std::cos(turn), std::sin(turn)}, aside{-along.y, along.x};
    const dvec2 place = 0.3 * std::sqrt(3.0) * along - 0.3 * aside;
    EXPECT_EQ(seen_at(view, place), std::to_string(i));
  }
}

std::vector<std::pair<std::string, Stroke>> strokes_of(const View& view, std::string_view prefix) {
  std::vector<std::pair<std::string, Stroke>> strokes;
  for (const auto& [id, mark] : view.marks) {
    if (const Stroke* stroke = std::get_if<Stroke>(&mark.shape); stroke && id.starts_with(prefix))
      strokes.emplace_back(id, *stroke);
  }
  return strokes;
}

TEST(SpaceDrawing, ALineBehindAnotherLeavesAGap) {
  SpaceDrawing drawing(
      {.viewer = distant_viewer({0, 0, 1}), .at = [](dvec3 p) { return std::optional(dvec2(p)); }});
  drawing.add(SpaceEdge{.id = "near", .role = Role::input, .a = {-5, 0, 1}, .b = {5, 0, 1}});
  drawing.add(SpaceEdge{.id = "far", .role = Role::input, .a = {0, -5, 0}, .b = {0, 5, 0}});
  View view;
  drawing.add_to(view, "a");
  EXPECT_EQ(strokes_of(view, "near").size(), 1U);
  const auto far = strokes_of(view, "far");
  ASSERT_EQ(far.size(), 2U);
  EXPECT_LT(far[0].second.b.y, -0.2);
  EXPECT_GT(far[1].second.a.y, 0.2);
}

TEST(SpaceDrawing, LinesThatMeetLeaveNone) {
  SpaceDrawing drawing(
      {.viewer = distant_viewer({0, 0, 1}), .at = [](dvec3 p) { return std::optional(dvec2(p)); }});
  drawing.add(SpaceEdge{.id = "one", .role = Role::input, .a = {-5, 0, 1}, .b = {5, 0, 1}});
  drawing.add(SpaceEdge{.id = "two", .role = Role::input, .a = {0, -5, 1}, .b = {0, 5, 1}});
  View view;
  drawing.add_to(view, "a");
  EXPECT_EQ(strokes_of(view, "one").size(), 1U);
  EXPECT_EQ(strokes_of(view, "two").size(), 1U);
}

TEST(SpaceDrawing, PiercingFacesMeetInALine) {
  // Seen along (1, 2, 3): z runs down to the left
  const auto at = [](dvec3 p) { return std::optional(9.0 * dvec2{p.x - p.z / 3, p.y - p.z * 2 / 3}); };
  SpaceDrawing drawing({.viewer = distant_viewer({1, 2, 3}), .at = at});
  const Rings squares = piercing_squares();
  for (std::size_t i = 0; i < squares.size(); ++i)
    drawing.add(SpaceFace{std::to_string(i), Role::input, squares[i], false});
  View view;
  drawing.add_to(view, "a");
  for (const std::string pair : {"0 meets 1", "0 meets 2", "1 meets 2"})
    EXPECT_FALSE(strokes_of(view, pair).empty()) << pair;
  // The faces of a body only touch
  SpaceDrawing body({.viewer = distant_viewer({1, 2, 3}), .at = at});
  const Rings faces = letter_l();
  for (std::size_t i = 0; i < faces.size(); ++i)
    body.add(SpaceFace{std::to_string(i), Role::input, faces[i]});
  View letter;
  body.add_to(letter, "a");
  for (const auto& [id, stroke] : strokes_of(letter, "")) ADD_FAILURE() << id;
}

}  // namespace
}  // namespace gradus
