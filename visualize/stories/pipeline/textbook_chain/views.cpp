// What the tour's drawings share, and those of the model where it was made and where it stands.

#include "stories/pipeline/textbook_chain/views.hpp"

#include "core/colour.hpp"
#include "stories/pipeline/textbook_chain/shapes.hpp"
#include "stories/space_drawing.hpp"

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
      closed_(closed_outward(*run.scene.objects[0].mesh)) {}

// --- What is the same in all of them --------------------------------------------------------------------

View Views::begin(std::size_t stage, const std::string& caption) const {
  View view;
  if (stage > 0) cards_.strip(view, stage);
  const Extent place = paper_.panel();
  view.add({"caption", Role::guide,
            Text{{place.centre().x, place.lower.y - 0.9 * unit_}, caption, Align::centre, true}});
  return view;
}

Panel Views::panel(const Extent& world, dvec2 margin) const {
  const Extent place = paper_.panel();
  margin *= unit_;
  return {{place.lower + margin, place.upper - margin}, widened(world, 0.02), Panel::Fit::same_scale, false};
}

void Views::polygon(View& view, const Panel& panel, std::string id, Role role,
                    const std::vector<dvec2>& points, bool dashed) const {
  Path path{near_paper(panel.at(points)), true, dashed};
  const Extent frame = paper_.panel();
  if (path.points.size() < 2) return;
  if (std::ranges::all_of(path.points, [&](dvec2 p) { return frame.holds(p); })) {
    view.add({std::move(id), role, std::move(path)});
    return;
  }
  for (std::size_t i = 0; i < path.points.size(); ++i) {
    auto part = shown_part(frame, path.points[i], path.points[(i + 1) % path.points.size()]);
    if (!part) continue;
    part->dashed = dashed;
    view.add({fmt::format("{} edge {}", id, i), role, *part});
  }
}

void Views::area(View& view, const Panel& panel, std::string id, Role role,
                 const std::vector<dvec2>& points) const {
  const Extent frame = paper_.panel();
  std::vector<dvec2> ring;
  for (const auto& corner : sutherland_hodgman::clip_to_window(near_paper(panel.at(points)),
                                                               AxisBox<2, double>{frame.lower, frame.upper}))
    ring.push_back(corner.at);
  if (ring.size() >= 3) view.add({std::move(id), role, Area{{std::move(ring)}}});
}

void Views::pixel_place(View& view, const Panel& panel, dvec2 at) const {
  if (paper_.panel().holds(panel.at(at))) view.add({"f pixel", Role::input, Dot{panel.at(at)}});
}

// --- Solids ---------------------------------------------------------------------------------------------

/// Someone who looks along −towards, upright.
Views::Axes Views::upright(dvec3 towards, dvec3 up) {
  const dvec3 front = unit_vector(towards), right = unit_vector(glm::cross(up, front));
  return {right, glm::cross(front, right), front};
}

/// Towards +z, as models are read, and a little from the right and from above.
Views::Axes Views::from_the_front() { return upright({0.45, 0.42, 1}, {0, 1, 0}); }

/// Seen from the camera's right, so that what looks at a front looks right.
Views::Axes Views::from_aside() const {
  const Frame<double>& eye = run_.scene.camera.frame;
  dvec3 up{0, 1, 0};
  if (length_of(glm::cross(eye.forward, up)) < 0.1) up = eye.up;
  const dvec3 level = unit_vector(eye.forward - glm::dot(eye.forward, up) * up);
  return upright(0.8 * eye.right - 0.6 * level + 0.35 * up, up);
}

Views::Place Views::turned(const Place& place, const Axes& axes) {
  return [=](std::size_t vertex) {
    const dvec3 p = place(vertex);
    return dvec3{glm::dot(p, axes[0]), glm::dot(p, axes[1]), glm::dot(p, axes[2])};
  };
}

bool Views::few_faces() const { return run_.faces.size() <= most_faces; }

Extent Views::extent(const Place& place) const {
  Extent all;
  for (const Piece& piece : run_.pieces) {
    for (const PieceCorner& corner : piece.corners)
      all.add(dvec2(place(static_cast<std::size_t>(corner.vertex))));
  }
  return all;
}

std::vector<dvec2> Views::own(const Place& place) const {
  std::vector<dvec2> corners;
  for (const PieceCorner& corner : piece_.corners)
    corners.emplace_back(place(static_cast<std::size_t>(corner.vertex)));
  return corners;
}

std::vector<SolidPart> Views::pieces(const Place& place) const {
  std::vector<SolidPart> parts;
  for (const Piece& piece : run_.pieces) {
    SolidPart part{piece.id.face, {}, follows(piece.id)};
    for (const PieceCorner& c : piece.corners) part.ring.push_back(place(static_cast<std::size_t>(c.vertex)));
    parts.push_back(std::move(part));
  }
  return parts;
}

/// Of its material, in the same light in all drawings: a face keeps its tone. The followed part has a colour
/// of its own.
dvec3 Views::colour_of(const SolidPart& part) const {
  constexpr dvec3 light{0.1, 0.84, 0.53};
  constexpr double least = 0.4;
  const auto face = static_cast<std::size_t>(part.face);
  const Mesh& mesh = *run_.scene.objects[0].mesh;
  std::vector<dvec3> ring;
  for (const int vertex : run_.faces[face].vertices)
    ring.push_back(object_at(static_cast<std::size_t>(vertex)));
  const double facing = glm::dot(unit_vector(area_vector(ring)), light);
  const double lit = std::max(0.0, closed_ ? facing : std::abs(facing));
  const auto material = static_cast<std::size_t>(mesh.faces[face].material);
  const dvec3 colour = part.followed ? dvec3(linear_from_srgb8(Rgba8{0, 114, 178, 255}))
                                     : dvec3(mesh.materials[material].diffuse);
  return colour * (least + (1 - least) * lit);
}

void Views::solid(View& view, const Panel& panel, const std::string& name,
                  const std::vector<SolidPart>& parts) const {
  const auto [known, fresh] = solids_.try_emplace(name);
  if (fresh) {
    SolidCells cells(panel, paper_.panel());
    for (const SolidPart& part : parts) cells.add(part.ring, colour_of(part));
    cells.put(known->second);
    SpaceDrawing drawing({.viewer = distant_viewer({0, 0, 1}),
                          .at = [&](dvec3 p) { return std::optional(panel.at(dvec2(p))); },
                          .frame = paper_.panel()});
    for (const SolidPart& part : parts)
      drawing.add(SpaceFace{.id = "", .role = Role::past, .ring = part.ring, .one_sided = false});
    View lines;
    if (few_faces()) {
      int number = 0;
      for (const auto& [a, b] : rims_of(parts)) {
        drawing.add(SpaceEdge{.id = fmt::format("b {} rim {:03}", name, number++),
                              .role = Role::past,
                              .a = a,
                              .b = b,
                              .thin = true,
                              .behind = false});
      }
      drawing.add_to(lines, "a " + name);
    }
    for (auto& [id, mark] : lines.marks) {
      if (std::holds_alternative<Stroke>(mark.shape)) known->second.add(std::move(mark));
    }
  }
  for (const auto& [id, mark] : known->second.marks) view.add(mark);
  view.cells = known->second.cells;
}

/// The directions of a space's axes, in the panel's lower left corner.
void Views::axes_cross(View& view, const Axes& axes) const {
  const double length = 1.9 * unit_;
  const Extent place = paper_.panel();
  const dvec2 corner{place.lower.x + 1.9 * unit_, place.upper.y - 1.6 * unit_};
  const std::array names{"x", "y", "z"};
  for (int i = 0; i < 3; ++i) {
    const dvec2 tip = corner + length * dvec2{axes[0][i], -axes[1][i]};
    const std::string label = names[static_cast<std::size_t>(i)];
    view.add({"e axis " + label, Role::guide, Stroke{corner, tip, true}});
    view.add({"e axis name " + label, Role::guide, Label{tip, words_.symbol(label)}});
  }
}

void Views::followed(View& view, const Panel& panel, const std::vector<dvec2>& corners,
                     const Pointer& pointer, bool all_names) const {
  polygon(view, panel, "c followed", Role::current, corners);
  for (std::size_t i = 0; i < 3; ++i) {
    const bool pointed = pointer.corner == i;
    const dvec2 at = panel.at(corners[i]);
    if ((!all_names && !pointed) || !paper_.panel().holds(at)) continue;
    view.add_named(fmt::format("d corner {}", i), fmt::format("e name {}", i), Role::current, at,
                   fmt::format("v{}", piece_.corners[i].vertex), !pointed);
  }
}

// --- 1 and 2: where the model stands --------------------------------------------------------------------

void Views::model(View& view) const {
  const Axes axes = from_the_front();
  const Place place = turned([this](std::size_t i) { return object_at(i); }, axes);
  const Panel here = panel(extent(place));
  solid(view, here, "object", pieces(place));
  axes_cross(view, axes);
}

View Views::object(const Pointer& at) const {
  View view = begin(1, words_.say("space.object"));
  model(view);
  const Axes axes = from_the_front();
  const Place place = turned([this](std::size_t i) { return object_at(i); }, axes);
  const Panel here = panel(extent(place));
  followed(view, here, own(place), at, true);
  if (way_.place)
    pixel_place(view, here, dvec2(turned([this](std::size_t) { return way_.place->object; }, axes)(0)));
  cards_.file(view);
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
  polygon(view, panel, "b window", Role::boundary, window);
  const dvec2 from = panel.at(flat(run_.scene.camera.frame.eye));
  for (std::size_t i = 0; i < window.size(); ++i) {
    view.add(
        {fmt::format("b ray {}", i), Role::candidate, Stroke{from, panel.at(window[i]), false, true, true}});
  }
  view.add_named("c eye", "d eye name", Role::boundary, from, words_.say("eye"));
}

View Views::world(const Pointer& at) const {
  View view = begin(2, words_.say("space.world"));
  const Pointer pointed{at.corner.value_or(0), ""};
  const Axes axes = from_aside();
  const Flat flat = [=](dvec3 p) { return dvec2{glm::dot(p, axes[0]), glm::dot(p, axes[1])}; };
  const Place place = turned([this](std::size_t i) { return world_at(i); }, axes);
  Extent all = extent(place);
  for (const dvec2 p : window_in_world(flat)) all.add(p);
  all.add(flat(run_.scene.camera.frame.eye));
  const Panel here = panel(all);
  solid(view, here, "world", pieces(place));
  lines_of_sight(view, here, flat);
  axes_cross(view, axes);
  followed(view, here, own(place), pointed, false);
  if (way_.place) {
    const dvec2 pixel = flat(way_.place->world);
    pixel_place(view, here, pixel);
    view.add({"e sight", Role::candidate,
              Stroke{here.at(flat(run_.scene.camera.frame.eye)), here.at(pixel), false, true, true}});
  }
  cards_.placement(view, *pointed.corner);
  return view;
}

}  // namespace gradus::textbook_chain
