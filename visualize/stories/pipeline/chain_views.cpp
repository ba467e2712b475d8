#include "stories/pipeline/chain_views.hpp"

#include "clipping/sutherland_hodgman/sutherland_hodgman.hpp"
#include "core/colour.hpp"
#include "figure/number_text.hpp"

namespace gradus::textbook_chain {
namespace {

using namespace pipeline;

/// The same from the right side: z to the left, y up, x towards the reader. What looks at a front looks
/// right.
dvec2 oblique_from_right(dvec3 p) { return {-p.z - 0.42 * p.x, p.y - 0.3 * p.x}; }
/// Seen from the side: depth to the right, y up.
dvec2 from_side(double depth, double y) { return {depth, y}; }

/// The part of a polygon with w >= least as points (x / w, y / w): for drawing what lies before the eye.
std::vector<dvec2> before_eye(const std::vector<glm::dvec4>& corners, double least) {
  std::vector<dvec2> points;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const glm::dvec4 a = corners[i], b = corners[(i + 1) % corners.size()];
    if (a.w >= least) points.emplace_back(a.x / a.w, a.y / a.w);
    if ((a.w < least) == (b.w < least)) continue;
    const glm::dvec4 cut = a + (least - a.w) / (b.w - a.w) * (b - a);
    points.emplace_back(cut.x / least, cut.y / least);
  }
  return points;
}

/// A polygon as far as it lies round the paper: what divides by next to nothing flies off.
std::vector<dvec2> near_paper(const std::vector<dvec2>& points) {
  constexpr double far = 1e6;
  const auto flies = [](dvec2 p) { return std::max(std::abs(p.x), std::abs(p.y)) > far; };
  if (std::ranges::none_of(points, flies)) return points;
  const AxisBox<2, double> room{{-far, -far}, {far, far}};
  std::vector<dvec2> kept;
  for (const auto& corner : sutherland_hodgman::clip_to_window(points, room)) kept.push_back(corner.at);
  return kept;
}

std::string padded(std::string_view name, int number) { return fmt::format("{} {:05}", name, number); }

void put(View& view, ivec2 pixel, Role role, std::optional<Rgba8> color = {}) {
  view.cells.insert_or_assign({pixel.y, pixel.x}, CellLook{role, "", color});
}

}  // namespace

Panel Views::panel(double x0, double x1, dvec2 lower, dvec2 upper) const {
  // A margin for names; the caption stands above
  return {
      {{x0 + 0.6, 1.4}, {x1 - 0.6, run_.size.height - 1.6}}, {lower, upper}, Panel::Fit::same_scale, false};
}
Panel Views::whole(dvec2 lower, dvec2 upper) const {
  return panel(-0.5, run_.size.width - 0.5, lower, upper);
}
Panel Views::left(dvec2 lower, dvec2 upper) const {
  return panel(-0.5, run_.size.width / 2.0 - 0.7, lower, upper);
}
Panel Views::right(dvec2 lower, dvec2 upper) const {
  return panel(run_.size.width / 2.0 - 0.3, run_.size.width - 0.5, lower, upper);
}

template <class At>
Panel Views::fitted(At at, int side, const std::vector<dvec2>& more) const {
  Extent all;
  for (const Piece& piece : run_.pieces) {
    for (const PieceCorner& corner : piece.corners) all.add(at(static_cast<std::size_t>(corner.vertex)));
  }
  for (const dvec2 p : more) all.add(p);
  const auto& [lower, upper] = all;
  return side < 0 ? left(lower, upper) : side > 0 ? right(lower, upper) : whole(lower, upper);
}

void Views::polygon(View& view, const Panel& panel, std::string id, Role role,
                    const std::vector<dvec2>& points) const {
  Path path{near_paper(panel.at(points)), true};
  if (path.points.size() >= 2) view.add({std::move(id), role, std::move(path)});
}

void Views::caption(View& view, const Panel& panel, const std::string& key) const {
  view.add({"caption " + key, Role::boundary,
            Label{{(panel.place().lower.x + panel.place().upper.x) / 2, 0.4}, words_.say("space." + key)}});
}

/// Faces as outlines; the followed piece over them with its corners named.
template <class At>
void Views::model(View& view, const Panel& panel, const std::string& name, At at, const Pointer& pointer,
                  bool labelled) const {
  for (const FaceRead& face : run_.faces) {
    std::vector<dvec2> points;
    for (const int vertex : face.vertices) points.push_back(at(static_cast<std::size_t>(vertex)));
    polygon(view, panel, padded("a " + name + " face", face.face), Role::past, points);
  }
  std::vector<dvec2> own;
  for (const PieceCorner& corner : piece_.corners) own.push_back(at(static_cast<std::size_t>(corner.vertex)));
  polygon(view, panel, "b " + name + " followed", Role::current, own);
  if (!labelled) return;
  for (std::size_t i = 0; i < 3; ++i) {
    const dvec2 p = panel.at(own[i]);
    const bool pointed = pointer.corner == i;
    const int vertex = piece_.corners[i].vertex;
    view.add_named(fmt::format("c {} corner {}", name, i), fmt::format("d {} name {}", name, i),
                   pointed ? Role::accepted : Role::current, p,
                   fmt::format("v{}", vertex) + (pointed ? " " + pointer.text : ""), !pointed);
  }
}

/// The directions of a space's axes, in the lower left corner.
void Views::axes(View& view, const Panel& panel, const std::string& name, dvec2 (*to_paper)(dvec3)) const {
  const double length = 0.16 * (panel.place().upper.y - panel.place().lower.y) / panel.scale().y;
  const dvec2 corner = {panel.place().lower.x + 1.2, panel.place().upper.y - 0.6};
  const dvec2 origin = panel.at({0, 0});
  for (const auto& [axis, label] :
       {std::pair{dvec3{1, 0, 0}, "x"}, {dvec3{0, 1, 0}, "y"}, {dvec3{0, 0, 1}, "z"}}) {
    const dvec2 tip = corner + (panel.at(to_paper(axis * length)) - origin);
    view.add({fmt::format("e {} axis {}", name, label), Role::boundary, Stroke{corner, tip, true}});
    view.add(
        {fmt::format("e {} axis name {}", name, label), Role::boundary, Label{tip, words_.symbol(label)}});
  }
}

View Views::object(const Pointer& at) const {
  View view;
  const auto place = [&](std::size_t i) { return oblique(run_.read[i].point.at); };
  const Panel panel = fitted(place, 0);
  caption(view, panel, "object");
  axes(view, panel, "object", oblique);
  model(view, panel, "object", place, at);
  return view;
}

View Views::world(const Pointer& at) const {
  View view;
  const auto before = [&](std::size_t i) { return oblique(run_.read[i].point.at); };
  const auto after = [&](std::size_t i) { return oblique_from_right(run_.placed[i].to.at); };
  const Panel here = fitted(before, -1);
  caption(view, here, "object");
  axes(view, here, "object", oblique);
  model(view, here, "object", before, {}, false);
  const Camera& camera = run_.scene.camera;
  const dvec3 eye = camera.frame.eye;
  const double depth = std::max(1e-3, glm::dot(bounds_of(run_.scene).centre() - eye, camera.frame.forward));
  const auto [width, height] = run_.size;
  std::vector<dvec2> window;
  for (const dvec2 corner : {dvec2{0, 0}, dvec2{width, 0}, dvec2{width, height}, dvec2{0, height}}) {
    const Ray ray = ray_through(camera, width, height, corner);
    window.push_back(oblique_from_right(ray.origin + depth * ray.direction));
  }
  std::vector<dvec2> more = window;
  more.push_back(oblique_from_right(eye));
  const Panel there = fitted(after, 1, more);
  caption(view, there, "world");
  axes(view, there, "world", oblique_from_right);
  polygon(view, there, "a world window", Role::boundary, window);
  const dvec2 from = there.at(oblique_from_right(eye));
  for (std::size_t i = 0; i < window.size(); ++i) {
    view.add({fmt::format("a world ray {}", i), Role::candidate, Stroke{from, there.at(window[i])}});
  }
  view.add_named("c world eye", "d world eye name", Role::boundary, from, words_.say("eye"));
  model(view, there, "world", after, at, at.corner.has_value());
  return view;
}

/// What the camera sees, from the side: up and down to slope times depth, from the near plane on.
void Views::wedge(View& view, const Panel& panel, const std::string& name, double slope, double depth) const {
  const double near = run_.scene.camera.lens.near;
  const dvec2 eye = panel.at({0, 0});
  view.add({"a " + name + " top", Role::boundary, Stroke{eye, panel.at({depth, slope * depth})}});
  view.add({"a " + name + " bottom", Role::boundary, Stroke{eye, panel.at({depth, -slope * depth})}});
  view.add({"c " + name + " eye", Role::boundary, Dot{eye}});
  const dvec2 low = panel.at({near, -slope * near}), high = panel.at({near, slope * near});
  view.add({"a " + name + " near", Role::boundary, Stroke{low, high}});
  view.add({"d " + name + " near name", Role::boundary, Label{low, words_.say("near")}});
}

View Views::clip_space(const Pointer& at) const {
  View view;
  const auto before = [&](std::size_t i) { return from_side(run_.clip[i].view.z, run_.clip[i].view.y); };
  const auto after = [&](std::size_t i) { return from_side(run_.clip[i].clip.at.w, run_.clip[i].clip.at.y); };
  double depth = run_.scene.camera.lens.near * 2;
  for (const Projected& p : run_.clip) depth = std::max(depth, 1.08 * p.view.z);
  const double slope = gradus::tan(run_.scene.camera.lens.vertical_radians / 2);
  const Panel here = fitted(before, -1, {{0, 0}, {depth, slope * depth}, {depth, -slope * depth}});
  caption(view, here, "view");
  wedge(view, here, "view", slope, depth);
  model(view, here, "view", before, {}, false);
  const Panel there = fitted(after, 1, {{0, 0}, {depth, depth}, {depth, -depth}});
  caption(view, there, "clip");
  wedge(view, there, "clip", 1, depth);
  model(view, there, "clip", after, at, at.corner.has_value());
  return view;
}

View Views::facing() const {
  View view;
  const double aspect = static_cast<double>(run_.size.width) / run_.size.height;
  const Panel panel = whole({-aspect, -1}, {aspect, 1});
  caption(view, panel, "facing");
  polygon(view, panel, "a window", Role::boundary, Extent{{-aspect, -1}, {aspect, 1}}.corners());
  for (std::size_t i = 0; i < run_.pieces.size(); ++i) {
    const Piece& piece = run_.pieces[i];
    std::vector<glm::dvec4> corners;
    for (const PieceCorner& c : piece.corners)
      corners.push_back(run_.clip[static_cast<std::size_t>(c.vertex)].clip.at);
    std::vector<dvec2> points = before_eye(corners, run_.scene.camera.lens.near);
    for (dvec2& p : points) p.x *= aspect;
    const bool removed = run_.faced[i].removed;
    const Role role = follows(piece.id) ? Role::current : removed ? Role::rejected : Role::past;
    // Those that stay lie over those that go, and the followed one over all
    const char* layer = follows(piece.id) ? "d piece" : removed ? "b piece" : "c piece";
    polygon(view, panel, padded(layer, static_cast<int>(i)), role, points);
    if (!follows(piece.id)) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      if (corners[k].w < run_.scene.camera.lens.near) continue;
      const dvec2 p = panel.at({aspect * corners[k].x / corners[k].w, corners[k].y / corners[k].w});
      view.add_named(fmt::format("e corner {}", k), fmt::format("f name {}", k), Role::current, p,
                     fmt::format("v{}", piece.corners[k].vertex), true);
    }
  }
  return view;
}

View Views::clipping(const Pointer& at) const {
  View view;
  const auto place = [&](std::size_t i) { return from_side(run_.clip[i].clip.at.w, run_.clip[i].clip.at.y); };
  double depth = run_.scene.camera.lens.near * 2;
  for (const Projected& p : run_.clip) depth = std::max(depth, 1.08 * p.clip.at.w);
  const Panel here = fitted(place, -1, {{0, 0}, {depth, depth}, {depth, -depth}});
  caption(view, here, "clip");
  wedge(view, here, "clip", 1, depth);
  const double aspect = static_cast<double>(run_.size.width) / run_.size.height;
  const Panel there = right({-aspect, -1}, {aspect, 1});
  caption(view, there, "ndc");
  polygon(view, there, "a window", Role::boundary, Extent{{-aspect, -1}, {aspect, 1}}.corners());
  const auto side = [](const std::vector<ClipPoint>& points) {
    std::vector<dvec2> out;
    for (const ClipPoint& p : points) out.push_back(from_side(p.at.w, p.at.y));
    return out;
  };
  for (std::size_t i = 0; i < run_.clipped.size(); ++i) {
    const Clipped& piece = run_.clipped[i];
    const bool own = follows(piece.id);
    const int number = static_cast<int>(i);
    if (piece.changed) polygon(view, here, padded("b before", number), Role::rejected, side(piece.before));
    polygon(view, here, padded(own ? "d after" : "c after", number), own ? Role::current : Role::past,
            side(piece.after));
    std::vector<dvec2> divided;
    for (const NdcPoint& p : piece.divided) divided.push_back({aspect * p.at.x, p.at.y});
    polygon(view, there, padded(own ? "d divided" : "c divided", number), own ? Role::current : Role::past,
            divided);
    if (!own) continue;
    for (std::size_t k = 0; k < piece.after.size(); ++k) {
      const bool made =
          std::ranges::none_of(piece.before, [&](const ClipPoint& p) { return p.at == piece.after[k].at; });
      const bool pointed = at.corner == k;
      const dvec2 p = here.at(side(piece.after)[k]);
      const bool loud = made || pointed;
      view.add_named(fmt::format("e corner {}", k), fmt::format("f name {}", k),
                     loud ? Role::accepted : Role::current, p, fmt::format("c{}", k), !loud);
      if (!pointed || at.text.empty()) continue;
      view.add_named("e divided corner", "f divided name", Role::accepted, there.at(divided[k]),
                     fmt::format("c{} {}", k, at.text));
    }
  }
  return view;
}

void Views::mark_pixel(View& view) const {
  view.add({"g pixel", Role::input, Path{Extent{dvec2(pixel_) - 0.5, dvec2(pixel_) + 0.5}.corners(), true}});
}

View Views::raster(int last_row, const Pointer& at) const {
  View view{.plane = false};
  for (const Fragment& f : run_.covered) {
    if (!follows(f.id)) view.cells.try_emplace({f.pixel.y, f.pixel.x}, CellLook{Role::past, "", {}});
    if (follows(f.id) && f.pixel.y <= last_row)
      put(view, f.pixel, f.pixel.y == last_row ? Role::current : Role::accepted);
  }
  std::size_t corner = 0;
  for (const Snapped& triangle : run_.snapped) {
    if (!follows(triangle.id)) continue;
    Path path{{}, true};
    for (const SnappedPoint& p : triangle.corners) {
      path.points.push_back({p.at.x / 256.0 - 0.5, p.at.y / 256.0 - 0.5});
      if (at.corner != corner++) continue;
      view.add_named("c corner", "d corner name", Role::boundary, path.points.back(), at.text);
    }
    view.add({padded("b triangle", triangle.triangle), Role::boundary, std::move(path)});
  }
  mark_pixel(view);
  return view;
}

View Views::visible(bool lit) const {
  View view{.plane = false};
  for (const Fragment& f : run_.covered) put(view, f.pixel, Role::past);
  for (const Fragment& f : run_.covered) {
    if (!follows(f.id)) continue;
    const Shaded* seen = run_.shaded_at(f.pixel);
    put(view, f.pixel, seen && follows(seen->fragment.id) ? Role::accepted : Role::rejected);
  }
  if (lit) {
    for (const Shaded& s : run_.shaded)
      put(view, s.fragment.pixel, Role::result, srgb8_from_linear(s.colour));
  }
  mark_pixel(view);
  return view;
}

View Views::output(bool whole) const {
  View view{.plane = false};
  for (const Written& w : run_.written) {
    if (whole || w.pixel == pixel_) put(view, w.pixel, Role::result, w.colour);
  }
  mark_pixel(view);
  return view;
}

}  // namespace gradus::textbook_chain
