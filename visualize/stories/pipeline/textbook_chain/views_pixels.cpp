// The tour's drawings of pixels: from rasterization to the picture.

#include "figure/tone_of.hpp"
#include "stories/pipeline/textbook_chain/shapes.hpp"
#include "stories/pipeline/textbook_chain/views.hpp"

namespace gradus::textbook_chain {
namespace {

using namespace pipeline;

/// Columns and rows round the followed pixel.
constexpr int near_columns = 9, near_rows = 7;

/// Depth as grey: from dark, near, to light.
Rgba8 grey_of(double depth) {
  const auto tone = static_cast<std::uint8_t>(90 + std::lround(140 * std::clamp(depth, 0.0, 1.0)));
  return {tone, tone, tone, 255};
}

std::vector<dvec2> square(dvec2 centre) { return Extent{centre - 0.5, centre + 0.5}.corners(); }

/// A small mark at a pixel's centre.
std::vector<dvec2> diamond(dvec2 at) {
  constexpr double half = 0.06;
  return {at - dvec2{half, 0}, at - dvec2{0, half}, at + dvec2{half, 0}, at + dvec2{0, half}};
}

}  // namespace

// --- Pictures -------------------------------------------------------------------------------------------

void Views::frame(View& view, Side side) const {
  view.add({side == Side::before ? "a frame before" : "a frame after", Role::boundary,
            Path{paper_.picture(side).corners(), true}});
}

void Views::put(View& view, Side side, ivec2 pixel, Role role, std::optional<Rgba8> color) const {
  const ivec2 cell = paper_.cell(side, pixel);
  view.cells.insert_or_assign({cell.y, cell.x}, CellLook{role, "", color});
}

void Views::mark_pixel(View& view, Side side) const {
  view.add({side == Side::before ? "g pixel before" : "g pixel after", Role::input,
            Path{square(paper_.in_picture(side, dvec2(pixel_))), true}});
}

void Views::depth_picture(View& view, Side side) const {
  double least = 1, most = 0;
  for (const Shaded& s : run_.shaded) {
    least = std::min(least, s.fragment.depth);
    most = std::max(most, s.fragment.depth);
  }
  for (const Shaded& s : run_.shaded) {
    put(view, side, s.fragment.pixel, Role::past,
        grey_of((s.fragment.depth - least) / std::max(most - least, 1e-9)));
  }
  frame(view, side);
  mark_pixel(view, side);
}

void Views::lit_picture(View& view, Side side) const {
  for (const Shaded& s : run_.shaded)
    put(view, side, s.fragment.pixel, Role::result, tone_of(dvec3(s.colour)));
  frame(view, side);
  mark_pixel(view, side);
}

// --- Round the followed pixel ---------------------------------------------------------------------------

Extent Views::window_near() const {
  const dvec2 half = dvec2{near_columns, near_rows} * 0.5;
  return {dvec2(pixel_) - half, dvec2(pixel_) + half};
}

/// With room for the numbers of rows and columns.
Panel Views::near_panel(Side side) const {
  const Extent place = paper_.panel(side);
  return {{place.lower + dvec2{1.6, 0} * unit_, place.upper - dvec2{0, 1.4} * unit_},
          window_near(),
          Panel::Fit::same_scale,
          true};
}

Panel Views::near_pixel(View& view, Side side, const std::function<std::optional<Role>(ivec2)>& role) const {
  const Extent world = window_near();
  const Panel panel = near_panel(side);
  const ivec2 first(glm::ceil(world.lower)), last(glm::floor(world.upper));
  const auto inside = [&](std::vector<dvec2> ring) {
    for (dvec2& p : ring) p = glm::clamp(p, world.lower, world.upper);
    return panel.at(ring);
  };
  for (int y = first.y; y <= last.y; ++y) {
    for (int x = first.x; x <= last.x; ++x) {
      if (!run_.image.contains({x, y})) continue;
      const int number = 100 * (y - first.y) + x - first.x;
      const std::vector<dvec2> ring = inside(square({x, y}));
      view.add({padded("b near grid", number), Role::guide, Path{ring, true}});
      view.add({padded("b near centre", number), Role::guide, Path{panel.at(diamond({x, y})), true}});
      if (const auto found = role({x, y})) view.add({padded("a near", number), *found, Area{{ring}}});
    }
  }
  const double below = panel.at({0, std::min(world.upper.y, run_.size.height - 0.5)}).y + 0.8 * unit_;
  for (int x = first.x; x <= last.x; ++x) {
    if (x < 0 || x >= run_.size.width) continue;
    const double at = panel.at(dvec2(x, 0)).x;
    view.add({padded("h near column", x - first.x), Role::guide, Text{{at, below}, figure_number(x)}});
  }
  for (int y = first.y; y <= last.y; ++y) {
    const double at = panel.at(dvec2(0, y)).y;
    if (y < 0 || y >= run_.size.height) continue;
    view.add({padded("h near row", y - first.y), Role::guide,
              Text{{panel.at({std::max(world.lower.x, -0.5), 0}).x - 0.4 * unit_, at},
                   figure_number(y),
                   Align::right}});
  }
  view.add({"g near pixel", Role::input, Path{panel.at(square(dvec2(pixel_))), true}});
  return panel;
}

void Views::outline_near(View& view, const Panel& panel) const {
  const Extent world = window_near();
  for (const Snapped& triangle : run_.snapped) {
    if (!follows(triangle.id)) continue;
    for (std::size_t i = 0; i < 3; ++i) {
      const dvec2 a = corner_in_picture(triangle.corners[i]),
                  b = corner_in_picture(triangle.corners[(i + 1) % 3]);
      const auto part = shown_part(world, a, b);
      if (!part) continue;
      view.add({padded("c near edge", 3 * triangle.triangle + static_cast<int>(i)), Role::current,
                Stroke{panel.at(part->a), panel.at(part->b)}});
    }
  }
}

std::optional<Role> Views::covered_role(ivec2 pixel, int last_row) const {
  if (pixel.y > last_row) return std::nullopt;
  const auto wrong = std::ranges::find(run_.misjudged, pixel, &Misjudged::pixel);
  if (wrong != run_.misjudged.end()) return Role::rejected;
  const bool own =
      std::ranges::any_of(run_.covered, [&](const Fragment& f) { return follows(f.id) && f.pixel == pixel; });
  return own ? std::optional(Role::accepted) : std::nullopt;
}

std::optional<Role> Views::kept_role(ivec2 pixel) const {
  if (!covered_role(pixel, run_.size.height)) return std::nullopt;
  const Shaded* seen = run_.shaded_at(pixel);
  return seen && follows(seen->fragment.id) ? Role::accepted : Role::rejected;
}

// --- 6: rasterization -----------------------------------------------------------------------------------

View Views::raster(int last_row, const Pointer& at) const {
  View view;
  space(view, Side::before, "space.picture");
  for (const Fragment& f : run_.covered) {
    if (!follows(f.id)) put(view, Side::before, f.pixel, Role::past, grey_of(0.9));
  }
  for (const Fragment& f : run_.covered) {
    if (follows(f.id) && f.pixel.y <= last_row)
      put(view, Side::before, f.pixel, f.pixel.y == last_row ? Role::current : Role::accepted);
  }
  for (const Misjudged& wrong : run_.misjudged) {
    if (wrong.pixel.y <= last_row) put(view, Side::before, wrong.pixel, Role::rejected);
  }
  frame(view, Side::before);
  std::size_t corner = 0;
  for (const Snapped& triangle : run_.snapped) {
    if (!follows(triangle.id)) continue;
    Path path{{}, true};
    for (const SnappedPoint& p : triangle.corners) {
      path.points.push_back(paper_.in_picture(Side::before, corner_in_picture(p)));
      if (at.corner != corner++) continue;
      view.add_named("d corner", "e corner name", Role::current, path.points.back(), at.text);
    }
    view.add({padded("c triangle", triangle.triangle), Role::current, std::move(path)});
  }
  mark_pixel(view, Side::before);
  arrow(view);
  caption(view, Side::after, words_.say("space.near", {{"pixel", pixel_}}));
  const Panel near =
      near_pixel(view, Side::after, [&](ivec2 pixel) { return covered_role(pixel, last_row); });
  outline_near(view, near);
  if (way_.edges && last_row >= run_.size.height) {
    edge_lines(view, *way_.edges);
    cards_.edges(view, *way_.edges);
  }
  return view;
}

/// Their lengths: an edge function is the distance from the edge, times its length.
void Views::edge_lines(View& view, const EdgeValues& values) const {
  const Snapped& triangle = run_.snapped[static_cast<std::size_t>(values.triangle)];
  const Extent world = window_near();
  const Panel near = near_panel(Side::after);
  const dvec2 centre(pixel_);
  for (std::size_t i = 0; i < 3; ++i) {
    // Edge i lies opposite corner i
    const dvec2 a = corner_in_picture(triangle.corners[(i + 1) % 3]),
                b = corner_in_picture(triangle.corners[(i + 2) % 3]);
    const double along = std::clamp(glm::dot(centre - a, b - a) / glm::dot(b - a, b - a), 0.0, 1.0);
    const auto part = shown_part(world, centre, a + along * (b - a));
    if (!part) continue;
    const std::string id = fmt::format("e edge {}", i);
    view.add({id, Role::measure, Stroke{near.at(part->a), near.at(part->b)}});
    view.add({id + " name", Role::measure, Label{near.at(0.5 * (part->a + part->b)), edge_name(i)}});
  }
  view.add({"f near centre", Role::input, Dot{near.at(centre)}});
}

View Views::edge_functions(const EdgeValues& values, const std::optional<dvec3>& found) const {
  View view = raster(pixel_.y);
  edge_lines(view, values);
  cards_.edges(view, values, found);
  return view;
}

// --- 7: hidden surfaces and light -----------------------------------------------------------------------

View Views::depths(const DepthTested& test) const {
  View view;
  space(view, Side::before, "space.depths");
  depth_picture(view, Side::before);
  arrow(view);
  caption(view, Side::after, words_.say("space.near", {{"pixel", pixel_}}));
  const Panel near = near_pixel(view, Side::after, [&](ivec2 pixel) { return kept_role(pixel); });
  outline_near(view, near);
  cards_.depth(view, test);
  return view;
}

View Views::shading() const {
  View view;
  space(view, Side::before, "space.world");
  const Sight sight = from_aside();
  const auto where = [&](std::size_t i) { return run_.placed[i].to.at; };
  std::vector<std::pair<std::string, dvec3>> ways;
  std::vector<dvec2> tips;
  if (way_.shaded) {
    const dvec3 place = way_.shaded->place.at;
    const Extent model = extent(where, sight.flat);
    const double length = 0.6 * std::max(model.size().x, model.size().y);
    const auto add = [&](std::string name, dvec3 way) {
      ways.emplace_back(std::move(name), place + length * unit_vector(way));
      tips.push_back(sight.flat(ways.back().second));
    };
    add("N", way_.shaded->normal);
    add("V", viewer_of(run_.scene.camera, place) - place);
    for (const LampLight& l : way_.lamps) {
      if (!(l.n_dot_l > 0)) continue;
      add(fmt::format("L{}", l.light + 1), l.arrival.to_light);
      add(fmt::format("R{}", l.light + 1), l.mirror);
    }
  }
  const Panel here = panel(Side::before, extent(where, sight.flat, tips));
  solid(view, here, "lit world", world_, sight);
  followed(view, here, "lit world", own(where, sight.flat), {}, Names::none);
  for (const auto& [name, tip] : ways) {
    const dvec2 from = here.at(sight.flat(way_.shaded->place.at)), to = here.at(sight.flat(tip));
    view.add({"e ray " + name, Role::measure, Stroke{from, to, true, name[0] == 'R', name[0] == 'V'}});
    view.add({"e ray " + name + " name", Role::measure, Label{to, name}});
  }
  if (way_.shaded) pixel_place(view, "lit", here.at(sight.flat(way_.shaded->place.at)));
  arrow(view);
  space(view, Side::after, "space.light");
  lit_picture(view, Side::after);
  cards_.light(view);
  return view;
}

View Views::visibility() const {
  View view;
  space(view, Side::before, "space.depths");
  depth_picture(view, Side::before);
  if (!way_.tests.empty()) {
    view.add({"h pixel name", Role::input,
              Label{paper_.in_picture(Side::before, dvec2(pixel_)), depth_text(words_, way_.tests.back())}});
  }
  arrow(view);
  space(view, Side::after, "space.light");
  lit_picture(view, Side::after);
  cards_.light(view);
  return view;
}

// --- 8: output ------------------------------------------------------------------------------------------

View Views::output(bool whole) const {
  View view;
  space(view, Side::before, "space.picture");
  for (const Written& w : run_.written) {
    if (whole || w.pixel == pixel_) put(view, Side::before, w.pixel, Role::result, w.colour);
  }
  frame(view, Side::before);
  for (const Snapped& triangle : run_.snapped) {
    if (!follows(triangle.id)) continue;
    Path path{{}, true};
    for (const SnappedPoint& p : triangle.corners)
      path.points.push_back(paper_.in_picture(Side::before, corner_in_picture(p)));
    view.add({padded("c triangle", triangle.triangle), Role::current, std::move(path)});
  }
  mark_pixel(view, Side::before);
  caption(view, Side::after, words_.say("space.way", {{"pixel", pixel_}}), true);
  cards_.bytes(view);
  cards_.way(view);
  // The colour, large
  if (way_.written) {
    const Extent place = paper_.card();
    const ivec2 lower(glm::ceil(place.lower + dvec2{5.5, 6} * unit_));
    const ivec2 size(dvec2{11, 2.2} * unit_);
    for (int y = 0; y < size.y; ++y) {
      for (int x = 0; x < size.x; ++x)
        view.cells.insert_or_assign({lower.y + y, lower.x + x},
                                    CellLook{Role::guide, "", way_.written->colour});
    }
    view.add({"g swatch", Role::guide,
              Path{Extent{dvec2(lower) - 0.5, dvec2(lower + size) - 0.5}.corners(), true, false, true}});
  }
  return view;
}

}  // namespace gradus::textbook_chain
