#pragma once
// The circle itself, as the stories of circles draw it behind all steps.

#include "scan_conversion/bresenham_circle/bresenham_circle.hpp"
#include "scan_conversion/bresenham_circle/bresenham_circle_window.hpp"
#include "stories/telling.hpp"

namespace gradus::bresenham_circle {

struct Circle {
  ivec2 center;
  int radius;
  std::optional<Window> window;  ///< only what lies in it is drawn
  std::int64_t first = 0;        ///< the first column that is told, when the run starts in the middle
};

/// A point of an octant, between pixels too.
inline dvec2 point_of(ivec2 center, const Octant& octant, dvec2 at) {
  return dvec2(center) + at.x * dvec2(octant.right) + at.y * dvec2(octant.up);
}

/// Adds the ideal arc of an octant over columns `from` to `to`, its first point included, its last one not.
/// Chords this short leave it by less than 1/50 pixel.
inline void add_arc(Path& path, const Circle& circle, const Octant& octant, double from, double to) {
  const double r = circle.radius;
  const int chords = std::max(1, static_cast<int>(std::ceil(std::abs(to - from) * 6 / std::sqrt(r))));
  for (int i = 0; i < chords; ++i) {
    const double x = from + (to - from) * i / chords;
    path.points.push_back(point_of(circle.center, octant, {x, std::sqrt((r - x) * (r + x))}));
  }
}

/// The columns of an octant, and a little more, as a chain of points.
inline Path ideal_arc(const Circle& circle, const Octant& octant, Stretch shown) {
  const double r = circle.radius, end = r * std::sqrt(0.5);
  const double from = std::clamp(static_cast<double>(shown.first) - 1, 0.0, end);
  const double to = std::clamp(static_cast<double>(shown.last) + 1, from, end);
  Path path;
  add_arc(path, circle, octant, from, to);
  path.points.push_back(point_of(circle.center, octant, {to, std::sqrt((r - to) * (r + to))}));
  return path;
}

/// The whole circle, clockwise: every second octant runs back from its diagonal.
inline Path ideal_circle(const Circle& circle) {
  const double end = circle.radius * std::sqrt(0.5);
  Path path{.points = {}, .closed = true};
  for (const Octant& octant : octants) {
    add_arc(path, circle, octant, octant.has_borders() ? 0 : end, octant.has_borders() ? end : 0);
  }
  return path;
}

inline void draw_ideal(Narrator& narrator, const Circle& circle, int longest_watched) {
  std::optional<dvec2> named;
  if (circle.window) {
    for (const auto& [octant, shown, whole] : visible({circle.center, circle.radius}, *circle.window)) {
      if (shown.count() == 0) continue;
      Path arc = ideal_arc(circle, octant, shown);
      if (!named) named = arc.points[arc.points.size() / 2];
      narrator.backdrop(fmt::format("ideal circle, octant {}", octant.number), Role::boundary, arc);
    }
  } else if (circle.radius > longest_watched) {
    const Stretch told{std::max<std::int64_t>(0, circle.first - 100), circle.first + longest_watched};
    narrator.backdrop("ideal circle", Role::boundary, ideal_arc(circle, octants[0], told));
  } else {
    narrator.backdrop("ideal circle", Role::boundary, ideal_circle(circle));
    // Far from what is told; an octant alone has no such place, and nothing else in it is round
    if (!narrator.trace().grid.part)
      named = point_of(circle.center, octants[4], dvec2(circle.radius * std::sqrt(0.5)));
  }
  if (named)
    narrator.backdrop("ideal circle name", Role::boundary, Label{*named, narrator.words().say("ideal")});
}

/// The centre as a cross, the radius, and the diagonal that ends the octant.
inline void draw_octant(Narrator& narrator, const Circle& circle) {
  const Words& words = narrator.words();
  const dvec2 center(circle.center), across{0.3, 0}, up{0, 0.3};
  narrator.backdrop("centre, across", Role::input, Stroke{center - across, center + across});
  narrator.backdrop("centre, up", Role::input, Stroke{center - up, center + up});
  if (circle.radius < 2) return;
  // On the far side of the octant that is told: its labels need the room
  const dvec2 left = center - dvec2{circle.radius, 0}, corner = center + circle.radius * std::sqrt(0.5);
  narrator.backdrop("radius", Role::input, Stroke{center, left});
  narrator.backdrop("diagonal", Role::boundary, Stroke{center, corner});
  if (circle.radius < 4) return;
  // As far from their lines for any radius: the whole circle is as large as the drawing
  const double r = circle.radius;
  narrator.backdrop("radius name", Role::input,
                    Text{center + dvec2{-0.5, 0.08} * r, words.say("radius", {{"radius", circle.radius}})});
  narrator.backdrop("diagonal name", Role::boundary,
                    Text{center + dvec2{0.4, 0.28} * r, words.say("diagonal"), Align::left});
}

/// What a run's cells mean beside what all runs have: mirror images, the right pixels beside wrong ones, or
/// mirror images that are set again.
enum class Key { mirrored, right, again };

inline void draw_key(Narrator& narrator, Key key) {
  narrator.legend({Role::past,
                   Role::current,
                   {Role::accepted, key == Key::right ? "right" : "mirrored"},
                   Role::candidate,
                   {Role::rejected, key == Key::again ? "again" : "rejected"},
                   Role::result,
                   {Role::measure, "error"}});
}

/// The pixels of the octant that is told, and their neighbours.
inline Window octant_of(const Circle& circle) {
  const auto end = static_cast<int>(last_column(circle.radius));
  const auto height = static_cast<int>(height_at(circle.radius, end));
  return {circle.center + ivec2{-1, height - 1}, circle.center + ivec2{end + 1, circle.radius}};
}

/// What stands unchanged behind all steps.
inline void draw_circle(Narrator& narrator, const Circle& circle, int longest_watched, Key key) {
  constexpr int most_whole = 20;   // a larger one is watched in a view that follows the step
  constexpr int least_octant = 6;  // a smaller one has large pixels as a whole
  narrator.grid(circle.window ? *circle.window
                              : Window{circle.center - circle.radius, circle.center + circle.radius});
  narrator.trace().grid.whole = !circle.window && circle.radius <= most_whole;
  if (key == Key::mirrored && !circle.window && circle.radius >= least_octant && circle.radius <= most_whole)
    narrator.trace().grid.part = octant_of(circle);
  narrator.subtitle("subtitle", {{"center", circle.center}, {"radius", circle.radius}});
  if (circle.window) {
    narrator.retitle("in_window");
  } else if (circle.radius > longest_watched) {
    narrator.retitle("jumped_to_part");
  }
  if (!circle.window || circle.window->contains(circle.center)) draw_octant(narrator, circle);
  if (circle.radius > 0) draw_ideal(narrator, circle, longest_watched);
  draw_key(narrator, key);
  const auto shown = as_it_is_in(narrator.trace().grid.own());
  narrator.handles("center", shown);
  if (const auto right = shown(dvec2(circle.center) + dvec2{circle.radius, 0}))
    narrator.handle("radius", 0, *right, {1, 0});
}

}  // namespace gradus::bresenham_circle
