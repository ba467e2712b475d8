// The tour's drawings of pixels: from rasterization to the picture.

#include <set>

#include "figure/tone_of.hpp"
#include "stories/pipeline/textbook_chain/shapes.hpp"
#include "stories/pipeline/textbook_chain/views.hpp"

namespace gradus::textbook_chain {
namespace {

using namespace pipeline;

/// Columns and rows round the followed pixel.
constexpr int near_columns = 15, near_rows = 11;

/// Of what is misjudged.
constexpr Rgba8 wrong_tone{213, 94, 0, 255};

std::vector<dvec2> square(dvec2 centre) { return Extent{centre - 0.5, centre + 0.5}.corners(); }

/// A small mark at a pixel's centre.
std::vector<dvec2> diamond(dvec2 at) {
  constexpr double half = 0.06;
  return {at - dvec2{half, 0}, at - dvec2{0, half}, at + dvec2{half, 0}, at + dvec2{0, half}};
}

}  // namespace

// --- Pictures -------------------------------------------------------------------------------------------

void Views::frame(View& view) const {
  view.add({"a frame", Role::boundary, Path{paper_.picture().corners(), true}});
}

void Views::put(View& view, ivec2 pixel, Role role, Rgba8 color) const {
  const ivec2 first = paper_.cell(pixel);
  for (int y = 0; y < paper_.block(); ++y) {
    for (int x = 0; x < paper_.block(); ++x)
      view.cells.insert_or_assign({first.y + y, first.x + x}, CellLook{role, "", color});
  }
}

void Views::mark_pixel(View& view) const {
  std::vector<dvec2> ring = square(dvec2(pixel_));
  for (dvec2& p : ring) p = paper_.in_picture(p);
  view.add({"g pixel", Role::input, Path{std::move(ring), true}});
  view.add({"h pixel name", Role::input, Label{paper_.in_picture(dvec2(pixel_)), pixel_name()}});
}

/// As grey: from dark, near, to light, over all depths that are seen.
Rgba8 Views::depth_tone(double depth) const {
  const auto [least, most] =
      std::ranges::minmax(run_.shaded, {}, [](const Shaded& s) { return s.fragment.depth; });
  const double span = std::max(most.fragment.depth - least.fragment.depth, 1e-9);
  const double part = std::clamp((depth - least.fragment.depth) / span, 0.0, 1.0);
  const auto tone = static_cast<std::uint8_t>(70 + std::lround(150 * part));
  return {tone, tone, tone, 255};
}

std::vector<dvec2> Views::outline(const Snapped& triangle) const {
  std::vector<dvec2> ring;
  for (const SnappedPoint& p : triangle.corners) ring.push_back(corner_in_picture(p));
  return ring;
}

// --- Round the followed pixel ---------------------------------------------------------------------------

Extent Views::window_near() const {
  const dvec2 half = dvec2{near_columns, near_rows} * 0.5;
  return {dvec2(pixel_) - half, dvec2(pixel_) + half};
}

/// With room for the numbers of rows and columns.
Panel Views::near_panel() const {
  const Extent place = paper_.panel();
  return {{place.lower + dvec2{1.6, 0} * unit_, place.upper - dvec2{0, 1.4} * unit_},
          window_near(),
          Panel::Fit::same_scale,
          true};
}

Panel Views::near_pixel(View& view, const std::function<std::optional<Role>(ivec2)>& role) const {
  const Extent world = window_near();
  const Panel panel = near_panel();
  const ivec2 first(glm::ceil(world.lower)), last(glm::floor(world.upper));
  const ivec2 lower = glm::max(first, ivec2(0)),
              upper = glm::min(last, ivec2(run_.size.width, run_.size.height) - 1);
  for (int y = lower.y; y <= upper.y; ++y) {
    for (int x = lower.x; x <= upper.x; ++x) {
      const int number = 100 * (y - first.y) + x - first.x;
      view.add({padded("b near centre", number), Role::guide, Path{panel.at(diamond({x, y})), true}});
      if (const auto found = role({x, y}))
        view.add({padded("a near", number), *found, Area{{panel.at(square({x, y}))}}});
    }
  }
  const auto add_line = [&](std::string_view id, int number, dvec2 from, dvec2 to) {
    view.add({padded(id, number), Role::guide, Stroke{panel.at(from - 0.5), panel.at(to - 0.5)}});
  };
  for (int y = lower.y; y <= upper.y + 1; ++y)
    add_line("b near row", y - first.y, {lower.x, y}, {upper.x + 1, y});
  for (int x = lower.x; x <= upper.x + 1; ++x)
    add_line("b near column", x - first.x, {x, lower.y}, {x, upper.y + 1});
  // Every other one: all would touch
  const double below = panel.at({0, upper.y + 0.5}).y + 0.8 * unit_;
  const double beside = panel.at({lower.x - 0.5, 0}).x - 0.4 * unit_;
  const auto number = [&](const std::string& id, dvec2 at, int value, Align align) {
    view.add({padded(id, value), Role::guide, Text{at, figure_number(value), align, true}});
  };
  for (int x = lower.x; x <= upper.x; ++x) {
    if ((x - pixel_.x) % 2 == 0) number("h near column", {panel.at(dvec2(x, 0)).x, below}, x, Align::centre);
  }
  for (int y = lower.y; y <= upper.y; ++y) {
    if ((y - pixel_.y) % 2 == 0) number("h near row", {beside, panel.at(dvec2(0, y)).y}, y, Align::right);
  }
  for (const Snapped& triangle : run_.snapped) {
    if (!follows(triangle.id)) continue;
    const std::vector<dvec2> ring = outline(triangle);
    for (std::size_t i = 0; i < 3; ++i) {
      const auto part = shown_part(world, ring[i], ring[(i + 1) % 3]);
      if (!part) continue;
      view.add({padded("c near edge", 3 * triangle.triangle + static_cast<int>(i)), Role::current,
                Stroke{panel.at(part->a), panel.at(part->b)}});
    }
  }
  view.add({"g near pixel", Role::input, Path{panel.at(square(dvec2(pixel_))), true}});
  return panel;
}

std::optional<Role> Views::covered_role(ivec2 pixel) const {
  const auto wrong = std::ranges::find(run_.misjudged, pixel, &Misjudged::pixel);
  if (wrong != run_.misjudged.end()) return Role::rejected;
  const bool own =
      std::ranges::any_of(run_.covered, [&](const Fragment& f) { return follows(f.id) && f.pixel == pixel; });
  return own ? std::optional(Role::accepted) : std::nullopt;
}

std::optional<Role> Views::kept_role(ivec2 pixel) const {
  if (!covered_role(pixel)) return std::nullopt;
  const Shaded* seen = run_.shaded_at(pixel);
  return seen && follows(seen->fragment.id) ? Role::accepted : Role::rejected;
}

// --- 6: rasterization -----------------------------------------------------------------------------------

std::vector<dvec2> Views::run_of_pixels(ivec2 first, int last) const {
  return Extent{paper_.in_picture(dvec2(first) - 0.5), paper_.in_picture(dvec2{last, first.y} + 0.5)}
      .corners();
}

void Views::covered(View& view, int last_row) const {
  std::set<std::pair<int, int>> other, own, current;  // row and column
  for (const Fragment& f : run_.covered) {
    auto& pixels = !follows(f.id) ? other : f.pixel.y == last_row ? current : own;
    if (!follows(f.id) || f.pixel.y <= last_row) pixels.emplace(f.pixel.y, f.pixel.x);
  }
  const auto add = [&](const std::string& id, Role role, const std::set<std::pair<int, int>>& pixels,
                       int shade) {
    Area area{{}, shade};
    for (auto at = pixels.begin(); at != pixels.end();) {
      const auto [y, first] = *at;
      int last = first;
      while (++at != pixels.end() && *at == std::pair{y, last + 1}) ++last;
      area.rings.push_back(run_of_pixels({first, y}, last));
    }
    if (!area.rings.empty()) view.add({id, role, std::move(area)});
  };
  add("a others", Role::past, other, 3);
  add("b covered", Role::accepted, own, 0);
  add("b current row", Role::current, current, 0);
}

View Views::raster(int last_row, const Pointer& at) const {
  View view = begin(6, words_.say("space.picture"));
  covered(view, last_row);
  for (const Misjudged& wrong : run_.misjudged) {
    if (wrong.pixel.y <= last_row) put(view, wrong.pixel, Role::rejected, wrong_tone);
  }
  frame(view);
  const Extent shown{dvec2{-0.5}, dvec2(run_.size.width, run_.size.height) - 0.5};
  std::size_t corner = 0;
  for (const Snapped& triangle : run_.snapped) {
    if (!follows(triangle.id)) continue;
    const std::vector<dvec2> ring = outline(triangle);
    for (std::size_t i = 0; i < 3; ++i) {
      if (const auto part = shown_part(shown, ring[i], ring[(i + 1) % 3])) {
        view.add({padded("c edge", 3 * triangle.triangle + static_cast<int>(i)), Role::current,
                  Stroke{paper_.in_picture(part->a), paper_.in_picture(part->b)}});
      }
      if (at.corner != corner++ || !shown.holds(ring[i])) continue;
      view.add_named("d corner", "e corner name", Role::current, paper_.in_picture(ring[i]), at.text);
    }
  }
  mark_pixel(view);
  return view;
}

/// Their lengths: an edge function is the distance from the edge, times its length.
void Views::edge_lines(View& view, const EdgeValues& values) const {
  const Snapped& triangle = run_.snapped[static_cast<std::size_t>(values.triangle)];
  const Extent world = window_near();
  const Panel near = near_panel();
  const dvec2 centre(pixel_);
  const std::vector<dvec2> ring = outline(triangle);
  for (std::size_t i = 0; i < 3; ++i) {
    // Edge i lies opposite corner i
    const dvec2 a = ring[(i + 1) % 3], b = ring[(i + 2) % 3];
    const double along = std::clamp(glm::dot(centre - a, b - a) / glm::dot(b - a, b - a), 0.0, 1.0);
    const auto part = shown_part(world, centre, a + along * (b - a));
    if (!part) continue;
    const std::string id = fmt::format("e edge {}", i);
    view.add({id, Role::measure, Stroke{near.at(part->a), near.at(part->b)}});
    view.add({id + " name", Role::measure, Label{near.at(0.5 * (part->a + part->b)), edge_name(i)}});
  }
  view.add({"f near centre", Role::input, Dot{near.at(centre)}});
}

View Views::rastered() const {
  // What a faulty stage misjudges lies all over the picture
  if (!run_.misjudged.empty()) {
    View view = raster(run_.size.height);
    if (way_.edges) cards_.edges(view, *way_.edges);
    return view;
  }
  if (way_.edges) return edge_functions(*way_.edges);
  View view = begin(6, words_.say("space.near", {{"pixel", pixel_}}));
  near_pixel(view, [&](ivec2 pixel) { return covered_role(pixel); });
  return view;
}

View Views::edge_functions(const EdgeValues& values, const std::optional<dvec3>& found) const {
  View view = begin(6, words_.say("space.near", {{"pixel", pixel_}}));
  near_pixel(view, [&](ivec2 pixel) { return covered_role(pixel); });
  edge_lines(view, values);
  cards_.edges(view, values, found);
  return view;
}

// --- 7: hidden surfaces and light -----------------------------------------------------------------------

View Views::depths(const DepthTested& test) const {
  View view = begin(7, words_.say("space.near", {{"pixel", pixel_}}));
  near_pixel(view, [&](ivec2 pixel) { return kept_role(pixel); });
  cards_.depth(view, test);
  return view;
}

View Views::shading() const {
  View view = begin(7, words_.say("space.world"));
  const Axes axes = from_aside();
  const Flat flat = [=](dvec3 p) { return dvec2{glm::dot(p, axes[0]), glm::dot(p, axes[1])}; };
  const Place place = turned([this](std::size_t i) { return world_at(i); }, axes);
  Extent all = extent(place);
  std::vector<std::pair<std::string, dvec3>> ways;
  const dvec3 lit = way_.shaded->place.at;
  const double length = 0.45 * std::max(all.size().x, all.size().y);
  const auto add = [&](std::string name, dvec3 way) {
    ways.emplace_back(std::move(name), lit + length * unit_vector(way));
    all.add(flat(ways.back().second));
  };
  add("N", way_.shaded->normal);
  add("V", viewer_of(run_.scene.camera, lit) - lit);
  for (const LampLight& l : way_.lamps) {
    if (!(l.n_dot_l > 0)) continue;
    add(fmt::format("L{}", l.light + 1), l.arrival.to_light);
    add(fmt::format("R{}", l.light + 1), l.mirror);
  }
  const Panel here = panel(all);
  solid(view, here, "lit world", pieces(place));
  followed(view, here, own(place), {}, false);
  for (const auto& [name, tip] : ways) {
    const dvec2 from = here.at(flat(lit)), to = here.at(flat(tip));
    view.add({"e ray " + name, Role::measure, Stroke{from, to, true, name[0] == 'R', name[0] == 'V'}});
    view.add({"e ray " + name + " name", Role::measure, Label{to, name}});
  }
  pixel_place(view, here, flat(lit));
  cards_.light(view);
  return view;
}

View Views::visibility() const {
  View view = begin(7, words_.say("space.depths"));
  const int middle = run_.size.width / 2;
  for (const Shaded& s : run_.shaded) {
    put(view, s.fragment.pixel, Role::past,
        s.fragment.pixel.x < middle ? depth_tone(s.fragment.depth) : tone_of(dvec3(s.colour)));
  }
  frame(view);
  view.add({"b middle", Role::boundary,
            Stroke{paper_.in_picture({middle - 0.5, -0.5}),
                   paper_.in_picture({middle - 0.5, run_.size.height - 0.5})}});
  mark_pixel(view);
  cards_.light(view);
  return view;
}

// --- 8: output ------------------------------------------------------------------------------------------

void Views::picture(View& view) const {
  for (const Written& w : run_.written) put(view, w.pixel, Role::result, w.colour);
  frame(view);
  mark_pixel(view);
}

/// What the stages are to make; the followed pixel can be dragged in it.
View Views::goal() const {
  View view = begin(0, words_.say("space.picture"));
  picture(view);
  cards_.stages(view);
  return view;
}

View Views::output(bool whole) const {
  View view = begin(8, words_.say("space.picture"));
  picture(view);
  if (whole)
    cards_.way(view);
  else
    cards_.bytes(view);
  return view;
}

}  // namespace gradus::textbook_chain
