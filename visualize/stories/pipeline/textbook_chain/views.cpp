// What the tour's drawings share, and those of the model where it was made and where it stands.

#include "stories/pipeline/textbook_chain/views.hpp"

#include "stories/pipeline/textbook_chain/shapes.hpp"

namespace gradus::textbook_chain {

using namespace pipeline;

Views::Views(const Run& run, const Followed& followed, const Words& words)
    : run_(run),
      piece_(run.pieces[followed.piece]),
      pixel_(followed.pixel),
      words_(words),
      paper_(run.size),
      unit_(paper_.unit()),
      way_(way_of(run, followed)),
      cards_(run, followed, way_, words, paper_),
      aspect_(static_cast<double>(run.size.width) / run.size.height),
      world_(*run.scene.objects[0].mesh) {
  for (std::size_t i = 0; i < world_.positions.size(); ++i) world_.positions[i] = run.placed[i].to.at;
}

// --- Panels and what is the same in all of them ---------------------------------------------------------

Panel Views::panel(const Extent& place, const Extent& world) const {
  // A margin for names
  const dvec2 margin = dvec2{1.6, 0.9} * unit_;
  return {{place.lower + margin, place.upper - margin}, widened(world, 0.02), Panel::Fit::same_scale, false};
}

void Views::caption(View& view, Side side, const std::string& text, bool aside) const {
  const Extent place = paper_.panel(side);
  view.add({side == Side::before ? "caption before" : "caption after", Role::guide,
            Text{{place.centre().x, place.lower.y - 0.9 * unit_}, text, Align::centre, aside}});
}

void Views::arrow(View& view, const std::string& name) const {
  const Extent place = paper_.panel(Side::before);
  const dvec2 from{place.upper.x - 0.4 * unit_, place.lower.y - 0.9 * unit_};
  const dvec2 to{paper_.panel(Side::after).lower.x + 0.4 * unit_, from.y};
  view.add({"h to the next", Role::guide, Stroke{from, to, true}});
  if (name.empty()) return;
  view.add({"h to the next name", Role::guide, Text{(from + to) * 0.5 + dvec2{0, 1.1 * unit_}, name}});
}

void Views::polygon(View& view, const Panel& panel, std::string id, Role role,
                    const std::vector<dvec2>& points) const {
  Path path{near_paper(panel.at(points)), true};
  const Extent frame = paper_.panel(side_of(panel));
  if (path.points.size() < 2) return;
  if (std::ranges::all_of(path.points, [&](dvec2 p) { return frame.holds(p); })) {
    view.add({std::move(id), role, std::move(path)});
    return;
  }
  for (std::size_t i = 0; i < path.points.size(); ++i) {
    const auto part = shown_part(frame, path.points[i], path.points[(i + 1) % path.points.size()]);
    if (part) view.add({fmt::format("{} edge {}", id, i), role, *part});
  }
}

Side Views::side_of(const Panel& panel) const {
  return panel.place().centre().x < paper_.panel(Side::after).lower.x ? Side::before : Side::after;
}

void Views::area(View& view, const Panel& panel, std::string id, Role role,
                 const std::vector<dvec2>& points) const {
  const Extent frame = paper_.panel(side_of(panel));
  std::vector<dvec2> ring;
  for (const auto& corner : sutherland_hodgman::clip_to_window(near_paper(panel.at(points)),
                                                               AxisBox<2, double>{frame.lower, frame.upper}))
    ring.push_back(corner.at);
  if (ring.size() >= 3) view.add({std::move(id), role, Area{{std::move(ring)}}});
}

void Views::pixel_place(View& view, const std::string& name, dvec2 at) const {
  view.add({"f " + name + " pixel", Role::input, Dot{at}});
}

// --- Solids ---------------------------------------------------------------------------------------------

Views::Sight Views::from_the_front() const {
  return {distant_viewer(towards_oblique), {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, oblique};
}

Views::Sight Views::from_aside() const {
  const Frame<double>& eye = run_.scene.camera.frame;
  dvec3 up{0, 1, 0};
  if (length_of(glm::cross(eye.forward, up)) < 0.1) up = eye.up;
  const dvec3 level = unit_vector(eye.forward - glm::dot(eye.forward, up) * up);
  const dvec3 towards = unit_vector(0.8 * eye.right - 0.6 * level + 0.35 * up);
  const dvec3 right = unit_vector(glm::cross(up, towards)), above = glm::cross(towards, right);
  return {distant_viewer(towards), right, above, towards,
          [=](dvec3 p) { return dvec2{glm::dot(p, right), glm::dot(p, above)}; }};
}

Extent Views::extent(const Placing& place, const Flat& flat, const std::vector<dvec2>& more) const {
  Extent all;
  for (const Piece& piece : run_.pieces) {
    for (const PieceCorner& corner : piece.corners)
      all.add(flat(place(static_cast<std::size_t>(corner.vertex))));
  }
  for (const dvec2 p : more) all.add(p);
  return all;
}

/// The directions of a space's axes, in the panel's lower left corner.
void Views::axes(View& view, const Panel& panel, const std::string& name, const Flat& flat) const {
  const double length = 2.2 * unit_ / panel.scale().y;
  const dvec2 corner = {panel.place().lower.x - 0.9 * unit_, panel.place().upper.y - 0.6 * unit_};
  const dvec2 origin = panel.at({0, 0}), none = flat(dvec3{0});
  for (const auto& [axis, label] :
       {std::pair{dvec3{1, 0, 0}, "x"}, {dvec3{0, 1, 0}, "y"}, {dvec3{0, 0, 1}, "z"}}) {
    const dvec2 tip = corner + (panel.at(flat(axis * length) - none) - origin);
    view.add({fmt::format("e {} axis {}", name, label), Role::guide, Stroke{corner, tip, true}});
    view.add({fmt::format("e {} axis name {}", name, label), Role::guide, Label{tip, words_.symbol(label)}});
  }
}

/// It stays the same from step to step.
void Views::solid(View& view, const Panel& panel, const std::string& name, const Mesh& mesh,
                  const Sight& sight) const {
  const dvec2 corner = panel.place().lower;
  const auto [known, fresh] = solids_.try_emplace(fmt::format("{} {} {}", name, corner.x, corner.y));
  if (fresh) {
    SpaceDrawing drawing({.viewer = sight.viewer,
                          .at = [&](dvec3 p) { return std::optional(panel.at(sight.flat(p))); },
                          .right = sight.right,
                          .up = sight.up,
                          .towards = sight.towards,
                          .frame = panel.place()});
    // The lines of a large model would only hide it
    const EdgesShown edges = mesh.faces.size() <= most_faces ? EdgesShown::seen : EdgesShown::none;
    drawing.add("b " + name, Role::past, mesh, edges);
    drawing.add_to(known->second, "a " + name);
  }
  for (const auto& [id, mark] : known->second.marks) view.add(mark);
}

int Views::shade_of_face(int face, const std::array<dvec3, 3>& world) const {
  std::vector<dvec3> ring;
  for (const int vertex : run_.faces[static_cast<std::size_t>(face)].vertices)
    ring.push_back(run_.placed[static_cast<std::size_t>(vertex)].to.at);
  const dvec3 normal = area_vector(ring);
  return shade_of({glm::dot(normal, world[0]), glm::dot(normal, world[1]), glm::dot(normal, world[2])});
}

void Views::pieces_solid(View& view, const Panel& panel, const std::string& name,
                         const std::vector<FacePart>& parts, const Sight& sight,
                         const std::array<dvec3, 3>& world) const {
  const auto [known, fresh] = solids_.try_emplace(name);
  if (fresh) {
    SpaceDrawing drawing({.viewer = sight.viewer,
                          .at = [&](dvec3 p) { return std::optional(panel.at(sight.flat(p))); },
                          .frame = panel.place()});
    for (std::size_t i = 0; i < parts.size(); ++i) {
      drawing.add(SpaceFace{.id = fmt::format("{} {:03}", name, i),
                            .role = Role::past,
                            .ring = parts[i].second,
                            .one_sided = false,
                            .shade = shade_of_face(parts[i].first, world)});
    }
    add_rims(drawing, name, parts);
    drawing.add_to(known->second, "a " + name);
  }
  for (const auto& [id, mark] : known->second.marks) view.add(mark);
}

bool Views::few_faces() const { return run_.faces.size() <= most_faces; }

std::vector<Views::FacePart> Views::pieces(const Placing& place) const {
  std::vector<FacePart> parts;
  for (const Piece& piece : run_.pieces) {
    FacePart part{piece.id.face, {}};
    for (const PieceCorner& c : piece.corners)
      part.second.push_back(place(static_cast<std::size_t>(c.vertex)));
    parts.push_back(std::move(part));
  }
  return parts;
}

std::vector<dvec2> Views::own(const Placing& place, const Flat& flat) const {
  std::vector<dvec2> corners;
  for (const PieceCorner& corner : piece_.corners)
    corners.push_back(flat(place(static_cast<std::size_t>(corner.vertex))));
  return corners;
}

void Views::followed(View& view, const Panel& panel, const std::string& name,
                     const std::vector<dvec2>& corners, const Pointer& pointer, Names names) const {
  area(view, panel, "b " + name + " inside", Role::current, corners);
  polygon(view, panel, "c " + name + " followed", Role::current, corners);
  for (std::size_t i = 0; i < 3; ++i) {
    const bool pointed = pointer.corner == i;
    if (names == Names::none || (names == Names::pointed && !pointed)) continue;
    view.add_named(fmt::format("d {} corner {}", name, i), fmt::format("e {} name {}", name, i),
                   Role::current, panel.at(corners[i]), fmt::format("v{}", piece_.corners[i].vertex),
                   !pointed);
  }
}

// --- 1 and 2: where the model stands --------------------------------------------------------------------

void Views::object_panel(View& view, const Extent& place, const Pointer& at, Names names) const {
  const auto where = [&](std::size_t i) { return run_.read[i].point.at; };
  const Sight sight = from_the_front();
  const Panel panel = this->panel(place, extent(where, sight.flat));
  axes(view, panel, "object", sight.flat);
  solid(view, panel, "object", *run_.scene.objects[0].mesh, sight);
  followed(view, panel, "object", own(where, sight.flat), at, names);
  if (way_.place) pixel_place(view, "object", panel.at(sight.flat(way_.place->object)));
}

View Views::goal() const {
  View view;
  space(view, Side::before, "space.object");
  object_panel(view, paper_.panel(Side::before), {}, Names::none);
  arrow(view);
  space(view, Side::after, "space.picture");
  frame(view, Side::after);
  mark_pixel(view, Side::after);
  const dvec2 at = paper_.in_picture(Side::after, dvec2(pixel_));
  view.add({"h pixel name", Role::input, Label{at, pixel_name()}});
  cards_.stages(view);
  return view;
}

View Views::object(const Pointer& at) const {
  View view;
  caption(view, Side::before, words_.say("space.file"), true);
  cards_.file(view);
  space(view, Side::after, "space.object");
  object_panel(view, paper_.panel(Side::after), at, Names::all);
  return view;
}

/// What the eye sees in the depth of the model.
std::vector<dvec2> Views::window_in_world(const Flat& flat) const {
  const Camera& camera = run_.scene.camera;
  const double depth =
      std::max(1e-3, glm::dot(bounds_of(run_.scene).centre() - camera.frame.eye, camera.frame.forward));
  const auto [width, height] = run_.size;
  std::vector<dvec2> window;
  for (const dvec2 corner : {dvec2{0, 0}, dvec2{width, 0}, dvec2{width, height}, dvec2{0, height}}) {
    const Ray ray = ray_through(camera, width, height, corner);
    window.push_back(flat(ray.origin + depth * ray.direction));
  }
  return window;
}

void Views::lines_of_sight(View& view, const Panel& panel, const Flat& flat) const {
  const std::vector<dvec2> window = window_in_world(flat);
  polygon(view, panel, "a world window", Role::boundary, window);
  const dvec2 from = panel.at(flat(run_.scene.camera.frame.eye));
  for (std::size_t i = 0; i < window.size(); ++i) {
    view.add({fmt::format("a world ray {}", i), Role::candidate,
              Stroke{from, panel.at(window[i]), false, true, true}});
  }
  view.add_named("c world eye", "d world eye name", Role::boundary, from, words_.say("eye"));
}

View Views::world(const Pointer& at) const {
  View view;
  const std::size_t pointed = at.corner.value_or(0);
  space(view, Side::before, "space.object");
  object_panel(view, paper_.panel(Side::before), {pointed}, Names::pointed);
  arrow(view, words_.symbol("M"));
  const auto where = [&](std::size_t i) { return run_.placed[i].to.at; };
  const Sight sight = from_aside();
  std::vector<dvec2> more = window_in_world(sight.flat);
  more.push_back(sight.flat(run_.scene.camera.frame.eye));
  const Panel there = panel(Side::after, extent(where, sight.flat, more));
  space(view, Side::after, "space.world");
  axes(view, there, "world", sight.flat);
  lines_of_sight(view, there, sight.flat);
  solid(view, there, "world", world_, sight);
  followed(view, there, "world", own(where, sight.flat), {pointed}, Names::pointed);
  if (way_.place) {
    const dvec2 pixel = there.at(sight.flat(way_.place->world));
    pixel_place(view, "world", pixel);
    view.add({"e world sight", Role::guide,
              Stroke{there.at(sight.flat(run_.scene.camera.frame.eye)), pixel, false, true, true}});
  }
  cards_.placement(view, pointed);
  return view;
}

}  // namespace gradus::textbook_chain
