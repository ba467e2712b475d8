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

/// Of models with more faces all edges are drawn, hidden or not.
constexpr std::size_t most_faces = 100;

/// Depth as grey: from dark, near, to light.
Rgba8 grey_of(double depth) {
  const auto tone = static_cast<std::uint8_t>(90 + std::lround(140 * std::clamp(depth, 0.0, 1.0)));
  return {tone, tone, tone, 255};
}

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

using FacePart = std::pair<int, std::vector<dvec3>>;  ///< which face, and the ring

bool has_edge(const FacePart& part, int face, dvec3 a, dvec3 b) {
  if (part.first != face) return false;
  const auto same = [](dvec3 p, dvec3 q) { return length_between(p, q) < 1e-9; };
  const auto& ring = part.second;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    if (same(ring[i], a) && same(ring[(i + 1) % ring.size()], b)) return true;
  }
  return false;
}

/// The edges of the parts of faces but for those between two parts of one.
void add_rims(SpaceDrawing& drawing, const std::vector<FacePart>& parts) {
  int number = 0;
  for (const auto& [face, ring] : parts) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const dvec3 a = ring[i], b = ring[(i + 1) % ring.size()];
      if (std::ranges::any_of(parts, [&](const FacePart& part) { return has_edge(part, face, b, a); }))
        continue;
      drawing.add(SpaceEdge{.id = fmt::format("b divided rim {:03}", number++),
                            .role = Role::past,
                            .a = a,
                            .b = b,
                            .behind = false});
    }
  }
}

}  // namespace

Views::Views(const Run& run, const Followed& followed, const Words& words)
    : run_(run),
      piece_(run.pieces[followed.piece]),
      pixel_(followed.pixel),
      words_(words),
      unit_(run.size.width / 36.0),
      world_(*run.scene.objects[0].mesh) {
  for (std::size_t i = 0; i < world_.positions.size(); ++i) world_.positions[i] = run.placed[i].to.at;
}

Panel Views::panel(double left, double right, const Extent& world) const {
  // A margin for names; the caption stands above
  const dvec2 size(run_.size.width, run_.size.height);
  return {{{left * size.x + 0.2 * unit_, 1.8 * unit_}, {right * size.x - 1.2 * unit_, size.y - 1.4 * unit_}},
          widened(world, 0.02),
          Panel::Fit::same_scale,
          false};
}

Views::Sight Views::from_the_front() const { return {distant_viewer(towards_oblique), {1, 0, 0}, {0, 0, 1}}; }
Views::Sight Views::from_the_right() const {
  return {distant_viewer({1, 0.3, -0.42}), {0, 0, -1}, {1, 0, 0}};
}

template <class At>
Extent Views::extent(At at, const std::vector<dvec2>& more) const {
  Extent all;
  for (const Piece& piece : run_.pieces) {
    for (const PieceCorner& corner : piece.corners) all.add(at(static_cast<std::size_t>(corner.vertex)));
  }
  for (const dvec2 p : more) all.add(p);
  return all;
}

void Views::polygon(View& view, const Panel& panel, std::string id, Role role,
                    const std::vector<dvec2>& points) const {
  Path path{near_paper(panel.at(points)), true};
  if (path.points.size() >= 2) view.add({std::move(id), role, std::move(path)});
}

void Views::caption(View& view, const Panel& panel, const std::string& key, double aside) const {
  const double x = panel.place().centre().x + aside * unit_;
  view.add({"caption " + key, Role::guide, Text{{x, 0.4 * unit_}, words_.say("space." + key)}});
}

/// The model as a solid.
/// flat(p): a place on the panel's plane.
template <class At>
void Views::solid(View& view, const Panel& panel, const std::string& name, const Mesh& mesh,
                  const Sight& sight, At flat) const {
  // It stays the same from step to step
  const auto [known, fresh] = solids_.try_emplace(fmt::format("{} {}", name, panel.scale().x));
  if (fresh) {
    SpaceDrawing drawing({.viewer = sight.viewer,
                          .at = [&](dvec3 p) { return std::optional(panel.at(flat(p))); },
                          .right = sight.right,
                          .towards = sight.towards,
                          .frame = panel.place()});
    // The lines of a large model would only hide it
    const EdgesShown edges = mesh.faces.size() <= most_faces ? EdgesShown::seen : EdgesShown::none;
    drawing.add("b " + name, Role::past, mesh, edges);
    drawing.add_to(known->second, "a " + name);
  }
  for (const auto& [id, mark] : known->second.marks) view.add(mark);
}

/// The followed piece, with its corners named.
void Views::followed(View& view, const Panel& panel, const std::string& name,
                     const std::vector<dvec2>& corners, const Pointer& pointer, bool labelled) const {
  view.add({"b " + name + " inside", Role::current, Area{{near_paper(panel.at(corners))}}});
  polygon(view, panel, "c " + name + " followed", Role::current, corners);
  if (!labelled) return;
  for (std::size_t i = 0; i < 3; ++i) {
    const dvec2 p = panel.at(corners[i]);
    const bool pointed = pointer.corner == i;
    const int vertex = piece_.corners[i].vertex;
    view.add_named(fmt::format("d {} corner {}", name, i), fmt::format("e {} name {}", name, i),
                   Role::current, p, fmt::format("v{}", vertex) + (pointed ? " " + pointer.text : ""),
                   !pointed);
  }
}

/// Faces as outlines, where no solid can be seen; the followed piece over them.
template <class At>
void Views::outlines(View& view, const Panel& panel, const std::string& name, At at, const Pointer& pointer,
                     bool labelled) const {
  for (const FaceRead& face : run_.faces) {
    std::vector<dvec2> points;
    for (const int vertex : face.vertices) points.push_back(at(static_cast<std::size_t>(vertex)));
    polygon(view, panel, padded("a " + name + " face", face.face), Role::past, points);
  }
  std::vector<dvec2> own;
  for (const PieceCorner& corner : piece_.corners) own.push_back(at(static_cast<std::size_t>(corner.vertex)));
  followed(view, panel, name, own, pointer, labelled);
}

/// The directions of a space's axes, in the lower left corner.
void Views::axes(View& view, const Panel& panel, const std::string& name, dvec2 (*to_paper)(dvec3)) const {
  const double length = 3.2 * unit_ / panel.scale().y;
  const dvec2 corner = {panel.place().lower.x + 2.2 * unit_, panel.place().upper.y - 0.4 * unit_};
  const dvec2 origin = panel.at({0, 0});
  for (const auto& [axis, label] :
       {std::pair{dvec3{1, 0, 0}, "x"}, {dvec3{0, 1, 0}, "y"}, {dvec3{0, 0, 1}, "z"}}) {
    const dvec2 tip = corner + (panel.at(to_paper(axis * length)) - origin);
    view.add({fmt::format("e {} axis {}", name, label), Role::guide, Stroke{corner, tip, true}});
    view.add({fmt::format("e {} axis name {}", name, label), Role::guide, Label{tip, words_.symbol(label)}});
  }
}

View Views::object(const Pointer& at) const {
  View view;
  const auto place = [&](std::size_t i) { return oblique(run_.read[i].point.at); };
  const Panel panel = this->panel(0.1, 1, extent(place));
  caption(view, panel, "object");
  axes(view, this->panel(0, 1, extent(place)), "object", oblique);
  solid(view, panel, "object", *run_.scene.objects[0].mesh, from_the_front(), oblique);
  std::vector<dvec2> own;
  for (const PieceCorner& corner : piece_.corners)
    own.push_back(place(static_cast<std::size_t>(corner.vertex)));
  followed(view, panel, "object", own, at, true);
  return view;
}

View Views::world(const Pointer& at) const {
  View view;
  const auto before = [&](std::size_t i) { return oblique(run_.read[i].point.at); };
  const auto after = [&](std::size_t i) { return oblique_from_right(run_.placed[i].to.at); };
  const auto own = [&](const auto& place) {
    std::vector<dvec2> corners;
    for (const PieceCorner& corner : piece_.corners)
      corners.push_back(place(static_cast<std::size_t>(corner.vertex)));
    return corners;
  };
  const Panel here = panel(0.09, 0.38, extent(before));
  caption(view, here, "object");
  axes(view, panel(0, 0.38, extent(before)), "object", oblique);
  solid(view, here, "object", *run_.scene.objects[0].mesh, from_the_front(), oblique);
  followed(view, here, "object", own(before), {}, false);
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
  const Panel there = panel(0.4, 1, extent(after, more));
  caption(view, there, "world");
  axes(view, there, "world", oblique_from_right);
  solid(view, there, "world", world_, from_the_right(), oblique_from_right);
  polygon(view, there, "a world window", Role::boundary, window);
  const dvec2 from = there.at(oblique_from_right(eye));
  for (std::size_t i = 0; i < window.size(); ++i) {
    view.add({fmt::format("a world ray {}", i), Role::candidate, Stroke{from, there.at(window[i])}});
  }
  view.add_named("c world eye", "d world eye name", Role::boundary, from, words_.say("eye"));
  followed(view, there, "world", own(after), at, at.corner.has_value());
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

/// The axes of a space seen from the side, from the eye on.
void Views::wedge_axes(View& view, const Panel& panel, const std::string& name, double depth,
                       const std::string& along) const {
  const dvec2 eye = panel.at({0, 0}), ahead = panel.at({depth, 0}), above{eye.x, panel.place().lower.y};
  view.add({"e " + name + " axis along", Role::guide, Stroke{eye, ahead, true}});
  view.add({"e " + name + " axis along name", Role::guide, Label{ahead, along}});
  view.add({"e " + name + " axis y", Role::guide, Stroke{eye, above, true}});
  view.add({"e " + name + " axis y name", Role::guide, Label{above, words_.symbol("y")}});
}

View Views::clip_space(const Pointer& at) const {
  View view;
  const auto before = [&](std::size_t i) { return from_side(run_.clip[i].view.z, run_.clip[i].view.y); };
  const auto after = [&](std::size_t i) { return from_side(run_.clip[i].clip.at.w, run_.clip[i].clip.at.y); };
  double depth = run_.scene.camera.lens.near * 2;
  for (const Projected& p : run_.clip) depth = std::max(depth, 1.08 * p.view.z);
  const double slope = gradus::tan(run_.scene.camera.lens.vertical_radians / 2);
  const Panel here = panel(0, 0.6, extent(before, {{0, 0}, {depth, slope * depth}, {depth, -slope * depth}}));
  caption(view, here, "view");
  wedge(view, here, "view", slope, depth);
  wedge_axes(view, here, "view", depth, words_.say("depth"));
  outlines(view, here, "view", before, {}, false);
  const Panel there = panel(0.63, 1, extent(after, {{0, 0}, {depth, depth}, {depth, -depth}}));
  caption(view, there, "clip");
  wedge(view, there, "clip", 1, depth);
  wedge_axes(view, there, "clip", depth, words_.symbol("w"));
  outlines(view, there, "clip", after, at, at.corner.has_value());
  return view;
}

View Views::facing() const {
  View view;
  const double aspect = static_cast<double>(run_.size.width) / run_.size.height;
  const Panel panel = this->panel(0, 1, {{-aspect, -1}, {aspect, 1}});
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
    if (run_.wrongly_faced(i)) {
      view.add({padded("a wrong", static_cast<int>(i)), removed ? Role::rejected : Role::past,
                Area{{near_paper(panel.at(points))}}});
    }
    if (!follows(piece.id)) continue;
    view.add({"a inside", role, Area{{near_paper(panel.at(points))}}});
    for (std::size_t k = 0; k < 3; ++k) {
      if (corners[k].w < run_.scene.camera.lens.near) continue;
      const dvec2 p = panel.at({aspect * corners[k].x / corners[k].w, corners[k].y / corners[k].w});
      view.add_named(fmt::format("e corner {}", k), fmt::format("f name {}", k), Role::current, p,
                     fmt::format("v{}", piece.corners[k].vertex), true);
    }
  }
  return view;
}

/// What is left of a model after division, as a solid seen along z: right, up, towards the reader.
void Views::divided_solid(View& view, const Panel& panel, double aspect) const {
  const auto [known, fresh] = solids_.try_emplace("divided");
  if (fresh) {
    SpaceDrawing drawing({.viewer = distant_viewer({0, 0, 1}),
                          .at = [&](dvec3 p) { return std::optional(panel.at(dvec2(p))); }});
    std::vector<FacePart> pieces;
    for (const Clipped& piece : run_.clipped) {
      std::vector<dvec3> ring;
      for (const NdcPoint& p : piece.divided) ring.emplace_back(aspect * p.at.x, p.at.y, 0 - p.at.z);
      if (ring.size() < 3) continue;
      drawing.add(SpaceFace{.id = fmt::format("divided {:03}", pieces.size()),
                            .role = Role::past,
                            .ring = ring,
                            .one_sided = false,
                            .shade = shade_of_face(piece.id.face)});
      pieces.emplace_back(piece.id.face, std::move(ring));
    }
    add_rims(drawing, pieces);
    drawing.add_to(known->second, "a divided");
  }
  for (const auto& [id, mark] : known->second.marks) view.add(mark);
}

/// How dark a face is from where the camera stands.
int Views::shade_of_face(int face) const {
  const Camera& camera = run_.scene.camera;
  std::vector<dvec3> ring;
  for (const int vertex : run_.faces[static_cast<std::size_t>(face)].vertices)
    ring.push_back(run_.placed[static_cast<std::size_t>(vertex)].to.at);
  const dvec3 normal = area_vector(ring);
  return shade_of({glm::dot(normal, camera.frame.right), glm::dot(normal, camera.frame.up),
                   0 - glm::dot(normal, camera.frame.forward)});
}

View Views::clipping(const Pointer& at) const {
  View view;
  const auto place = [&](std::size_t i) { return from_side(run_.clip[i].clip.at.w, run_.clip[i].clip.at.y); };
  double depth = run_.scene.camera.lens.near * 2;
  for (const Projected& p : run_.clip) depth = std::max(depth, 1.08 * p.clip.at.w);
  const Panel here = panel(0, 0.33, extent(place, {{0, 0}, {depth, depth}, {depth, -depth}}));
  // Apart from the other one
  caption(view, here, "clip", -1.5);
  wedge(view, here, "clip", 1, depth);
  wedge_axes(view, here, "clip", depth, words_.symbol("w"));
  const double aspect = static_cast<double>(run_.size.width) / run_.size.height;
  const Panel there = panel(0.35, 1.02, {{-aspect, -1}, {aspect, 1}});
  caption(view, there, "ndc", 1);
  const bool as_solid = run_.faces.size() <= most_faces;
  if (as_solid) divided_solid(view, there, aspect);
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
    if (own || !as_solid) {
      polygon(view, there, padded(own ? "d divided" : "c divided", number), own ? Role::current : Role::past,
              divided);
    }
    if (!own) continue;
    view.add({"a inside", Role::current, Area{{near_paper(here.at(side(piece.after)))}}});
    view.add({"b divided inside", Role::current, Area{{near_paper(there.at(divided))}}});
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
  for (const Misjudged& wrong : run_.misjudged) {
    if (wrong.pixel.y <= last_row) put(view, wrong.pixel, Role::rejected);
  }
  std::size_t corner = 0;
  for (const Snapped& triangle : run_.snapped) {
    if (!follows(triangle.id)) continue;
    Path path{{}, true};
    for (const SnappedPoint& p : triangle.corners) {
      path.points.push_back(corner_in_picture(p));
      if (at.corner != corner++) continue;
      view.add_named("c corner", "d corner name", Role::current, path.points.back(), at.text);
    }
    view.add({padded("b triangle", triangle.triangle), Role::current, std::move(path)});
  }
  mark_pixel(view);
  return view;
}

dvec2 Views::corner_in_picture(const SnappedPoint& p) const { return dvec2(p.at) / 256.0 - 0.5; }

View Views::edge_functions(const Snapped& triangle) const {
  View view = raster(pixel_.y);
  const dvec2 centre(pixel_);
  for (std::size_t i = 0; i < 3; ++i) {
    // Edge i lies opposite corner i; its function is the distance from it, times its length
    const dvec2 a = corner_in_picture(triangle.corners[(i + 1) % 3]),
                b = corner_in_picture(triangle.corners[(i + 2) % 3]);
    const double along = std::clamp(glm::dot(centre - a, b - a) / glm::dot(b - a, b - a), 0.0, 1.0);
    const dvec2 foot = a + along * (b - a);
    const std::string id = fmt::format("e edge {}", i);
    view.add({id, Role::measure, Stroke{foot, centre}});
    view.add({id + " name", Role::measure, Label{(foot + centre) * 0.5, edge_name(i)}});
  }
  return view;
}

View Views::depths(const std::string& at) const {
  View view{.plane = false};
  double least = 1, most = 0;
  for (const Shaded& s : run_.shaded) {
    least = std::min(least, s.fragment.depth);
    most = std::max(most, s.fragment.depth);
  }
  for (const Shaded& s : run_.shaded)
    put(view, s.fragment.pixel, Role::past,
        grey_of((s.fragment.depth - least) / std::max(most - least, 1e-9)));
  for (const Fragment& f : run_.covered) {
    if (!follows(f.id)) continue;
    const Shaded* seen = run_.shaded_at(f.pixel);
    put(view, f.pixel, seen && follows(seen->fragment.id) ? Role::accepted : Role::rejected);
  }
  mark_pixel(view);
  if (!at.empty()) view.add({"h pixel name", Role::input, Label{dvec2(pixel_), at}});
  return view;
}

View Views::lit() const {
  View view{.plane = false};
  for (const Shaded& s : run_.shaded) put(view, s.fragment.pixel, Role::result, srgb8_from_linear(s.colour));
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
