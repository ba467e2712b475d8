// The story of ear clipping: which corners are ears, in which order they are cut off, and how holes are
// joined to their outline before.

#include "modeling/ear_clipping/ear_clipping.hpp"

#include <numeric>
#include <set>

#include "core/faces.hpp"
#include "core/record.hpp"
#include "modeling/ear_clipping/ear_clipping_notes.hpp"
#include "modeling/ear_clipping/join_holes.hpp"
#include "modeling/ear_clipping/widest_ear.hpp"
#include "stories/checking.hpp"
#include "stories/modeling/ear_clipping/bridge_story.hpp"
#include "stories/modeling/ear_clipping/ear_story.hpp"
#include "stories/outline.hpp"
#include "stories/parameters.hpp"

namespace gradus::ear_clipping {
namespace {

// --- What is given

using Points = std::vector<dvec2>;

void refuse_unless_simple(std::string_view parameter, const Points& ring) {
  if (!is_simple(ring)) refuse(parameter, "expected edges that neither cross nor touch each other");
}

/// A ring's numbers, counter-clockwise from the first one on.
std::vector<int> counter_clockwise(const Points& points, std::vector<int> ring) {
  std::vector<std::int32_t> numbers(ring.begin(), ring.end());
  const std::vector<int> turned = from_rightmost(std::span<const dvec2>(points), numbers, false);
  const auto first = std::ranges::find(turned, ring[0]);
  std::ranges::rotate_copy(turned, first, ring.begin());
  return ring;
}
std::vector<int> numbers_from(std::size_t first, std::size_t count) {
  std::vector<int> numbers;
  for (std::size_t i = first; i < first + count; ++i) numbers.push_back(static_cast<int>(i));
  return numbers;
}

Subject polygon_of(const Arguments& arguments) {
  Subject subject{.points = arguments.points("polygon"), .rings = {}};
  const std::vector<int> given = numbers_from(0, subject.points.size());
  subject.rings = {counter_clockwise(subject.points, given)};
  subject.turned = subject.rings[0] != given;
  return subject;
}

/// Whether a ring goes round a point, which lies on none of its edges.
bool goes_round(const Points& ring, dvec2 p) {
  bool round = false;
  for (const auto& [a, b] : sides_of(ring)) {
    if ((a.y > p.y) != (b.y > p.y) && (orient2d(a, b, p) > 0) == (b.y > a.y)) round = !round;
  }
  return round;
}
bool is_on(dvec2 a, dvec2 b, dvec2 p) {
  return orient2d(a, b, p) == 0 && p == glm::clamp(p, glm::min(a, b), glm::max(a, b));
}
bool lies_on(const Points& ring, dvec2 p) {
  return std::ranges::any_of(sides_of(ring),
                             [&](const auto& side) { return is_on(side.first, side.second, p); });
}
bool cross(const Points& one, const Points& other) {
  for (const auto& [a, b] : sides_of(one)) {
    for (const auto& [c, d] : sides_of(other)) {
      if (orient2d(a, b, c) * orient2d(a, b, d) < 0 && orient2d(c, d, a) * orient2d(c, d, b) < 0) return true;
    }
  }
  return false;
}
/// How many corners of the one lie on the other, and the other way round.
std::ptrdiff_t touches(const Points& one, const Points& other) {
  const auto on = [](const Points& ring) { return [&ring](dvec2 p) { return lies_on(ring, p); }; };
  return std::ranges::count_if(one, on(other)) + std::ranges::count_if(other, [&](dvec2 p) {
           return lies_on(one, p) && std::ranges::find(one, p) == one.end();
         });
}

/// Rings that hang together already and touch once more enclose a part of the inside.
void refuse_circles(const std::vector<Points>& rings) {
  std::vector<std::size_t> chain(rings.size());
  std::iota(chain.begin(), chain.end(), 0);
  std::set<std::pair<double, double>> places;
  for (const Points& ring : rings) {
    for (const dvec2 p : ring) {
      if (!places.emplace(p.x, p.y).second) continue;
      std::set<std::size_t> there;
      for (std::size_t i = 0; i < rings.size(); ++i) {
        if (lies_on(rings[i], p) && !there.insert(chain[i]).second)
          refuse("rings", "expected an inside in one piece, found rings that touch in a circle at {},{}", p.x,
                 p.y);
      }
      for (std::size_t& its : chain) its = there.contains(its) ? *there.begin() : its;
    }
  }
}

void refuse_unless_holes(const std::vector<Points>& rings) {
  for (std::size_t i = 1; i < rings.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      const std::string other = k == 0 ? "the outline" : fmt::format("hole {}", k);
      if (cross(rings[i], rings[k]))
        refuse("rings", "expected rings that don't cross: hole {} and {}", i, other);
      if (touches(rings[i], rings[k]) > 1)
        refuse("rings", "expected rings that touch in one point at most: hole {} and {}", i, other);
      const auto free = [&](const Points& ring, const Points& from) {
        return *std::ranges::find_if(ring, [&](dvec2 p) { return !lies_on(from, p); });
      };
      const bool inside = goes_round(rings[k], free(rings[i], rings[k]));
      if (inside != (k == 0) || (k > 0 && goes_round(rings[i], free(rings[k], rings[i]))))
        refuse("rings", "expected holes inside the outline and beside each other: hole {} and {}", i, other);
    }
  }
  refuse_circles(rings);
}

Subject rings_of(const Arguments& arguments) {
  const std::vector<Points> rings = arguments.rings("rings");
  if (rings.size() < 2) refuse("rings", "expected an outline and at least one hole");
  for (const Points& ring : rings) refuse_unless_simple("rings", ring);
  refuse_unless_holes(rings);
  Subject subject;
  for (const Points& ring : rings) {
    subject.rings.push_back(numbers_from(subject.points.size(), ring.size()));
    subject.points.insert(subject.points.end(), ring.begin(), ring.end());
  }
  return subject;
}

// --- The methods

void set_up(Narrator& narrator, const Drawing& drawing, std::string_view parameter) {
  require_scale(drawing.panel(), narrator.arguments(), {parameter});
  narrator.paper(paper_width, paper_height);
  narrator.handles(parameter, shown_in(drawing.panel()));
}
/// The triangles of a ring as a surface in the plane z = 0.
class Triangles {
 public:
  Triangles(const Subject& subject, const std::vector<int>& ring) : subject_(subject), ring_(ring) {}

  /// Adds one by the places of its corners in the ring. Where a bridge leads to and fro it may be a line.
  void operator()(const Triangle& triangle) {
    std::array<std::int32_t, 3> t{};
    for (std::size_t i = 0; i < 3; ++i) t[i] = ring_[static_cast<std::size_t>(triangle[i])];
    if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0]) faces_.add(t);
  }
  void become_result_of(Narrator& narrator) const {
    std::vector<dvec3> points;
    for (const dvec2 p : subject_.points) points.emplace_back(p, 0);
    narrator.result(points, faces_);
    narrator.result({{"triangles", std::ssize(ring_) - 2}});
  }

 private:
  const Subject& subject_;
  const std::vector<int>& ring_;
  Faces faces_{};
};

template <Choice choice, auto cut>
void tell_ears(Narrator& narrator) {
  const Subject subject = polygon_of(narrator.arguments());
  const Drawing drawing(subject);
  set_up(narrator, drawing, "polygon");
  narrator.subtitle("subtitle", {{"corners", subject.points.size()}});
  narrator.columns({{"corner", false}, {"triangle", false}, {"is", false}, {"angle"}});
  narrator.legend({{Role::input, "left"},
                   {Role::current, choice == Choice::widest ? "cut" : "current"},
                   {Role::accepted, "ear"},
                   {Role::rejected, choice == Choice::convex ? "turned" : "none"},
                   {Role::result, "done"},
                   {Role::measure, "angle"}});
  if (choice == Choice::widest) narrator.add_to_legend(Role::candidate, "others");
  EarStory story(narrator.words(), subject, drawing, subject.rings[0], choice);
  const auto watch = narrator.watcher(story);
  watch(steps::Started{}, 0);
  const Points places = subject.places(subject.rings[0]);
  Triangles triangles(subject, subject.rings[0]);
  cut(std::span<const dvec2>(places), std::ref(triangles), watch);
  triangles.become_result_of(narrator);
}

void tell_holes(Narrator& narrator) {
  const Subject subject = rings_of(narrator.arguments());
  const Drawing drawing(subject);
  set_up(narrator, drawing, "rings");
  narrator.subtitle("subtitle.holes",
                    {{"corners", subject.points.size()}, {"holes", subject.rings.size() - 1}});
  narrator.columns({{"hole"}, {"corner", false}, {"bridge", false}, {"ring"}});
  narrator.legend({{Role::input, "ring"},
                   {Role::past, "waiting"},
                   {Role::candidate, "search"},
                   {Role::measure, "ray"},
                   {Role::current, "now"},
                   {Role::rejected, "blocked"},
                   {Role::result, "bridges"}});
  narrator.trace().legend[4].sample = Sample::dot;  // its corners have names
  narrator.list("bridge", "join_holes.hpp");
  narrator.list_below("join_holes");
  Faces rings;
  for (const std::vector<int>& ring : subject.rings) {
    const std::vector<std::int32_t> corners(ring.begin(), ring.end());
    rings.add(corners);
  }
  const std::span<const dvec2> points(subject.points);
  const std::vector<int> ring = join_holes(points, rings);
  BridgeStory bridges(narrator.words(), subject, drawing, ring);
  const auto watch = narrator.watcher(bridges);
  watch(steps::Started{}, 0);
  join_holes(points, rings, watch);
  EarStory ears(narrator.words(), subject, drawing, ring, Choice::of_joined);
  auto watch_ears = narrator.watcher(ears);
  auto told = only<Cut, Finished>(watch_ears);
  const Points places = subject.places(ring);
  Triangles triangles(subject, ring);
  triangulate(std::span<const dvec2>(places), std::ref(triangles), told);
  triangles.become_result_of(narrator);
}

constexpr auto first = [](auto... run) { triangulate(run...); };
constexpr auto widest = [](auto... run) { widest_ear(run...); };
constexpr auto convex = [](auto... run) { convex_only(run...); };

const Checking& checking() {
  static const Checking known{
      .asked = {{.name = "ears", .same = SameList::order, .type = "Cut", .fields = {"corner"}},
                {.name = "triangles", .same = SameList::set, .type = "Cut", .fields = {"triangle"}}}};
  return known;
}

}  // namespace

const TopicEntry& entry();  // the catalogue asks for it by this name
const TopicEntry& entry() {
  using namespace parameters;
  static const TopicEntry topic = completed<entry>(
      {.name = "ear_clipping",
       .chapter = "modeling",
       .aliases = {"triangulation", "polygon triangulation", "ears"},
       .summary = "a polygon, with holes or without, is cut into triangles ear by ear",
       .methods =
           {{.name = "triangulate",
             .standing = Standing::taught,
             .tell = tell_ears<Choice::first, first>,
             .unread = {"rings"}},
            {.name = "widest_ear",
             .tell = tell_ears<Choice::widest, widest>,
             .file = "widest_ear.hpp",
             .unread = {"rings"}},
            {.name = "join_holes", .tell = tell_holes, .file = "join_holes.hpp", .unread = {"polygon"}},
            {.name = "convex_only",
             .standing = Standing::faulty,
             .tell = tell_ears<Choice::convex, convex>,
             .unread = {"rings"}}},
       .counts = {"Tested", "Cut"},
       .parameters = {points(3, 26, "polygon", "0,0 7,0 12,1 11,8 7,3 5,9 3,4 0,8", "0,0 8,0 4,3 8,6 0,6",
                             "its corners, in either direction", xy, {1e-6, 1e6}),
                      {.name = "rings",
                       .type = ParameterType::rings,
                       .default_value = "0,0 10,0 11,3 14,0 13,9 0,8; 7,2 9,4 8,7 6,6; 2,2 5,4 3,6",
                       .example = "0,0 8,0 8,6 0,6; 3,2 5,2 4,4",
                       .help = "method join_holes: an outline, then the holes in it, beside each other",
                       .least = 3,
                       .most = 52,
                       .parts = xy,
                       .sizes = {1e-6, 1e6}}},
       .examples = {"--polygon '0,0 8,0 4,3 8,6 0,6'", "--method widest_ear",
                    "--method join_holes --rings '0,0 8,0 8,6 0,6; 3,2 5,2 4,4'"},
       .checking = &checking()});
  return topic;
}

}  // namespace gradus::ear_clipping
