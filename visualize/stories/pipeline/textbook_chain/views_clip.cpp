// The tour's drawings of clip space: projection, facing, clipping and division.

#include "stories/pipeline/textbook_chain/shapes.hpp"
#include "stories/pipeline/textbook_chain/views.hpp"

namespace gradus::textbook_chain {

using namespace pipeline;

// --- 3: from the side -----------------------------------------------------------------------------------

/// What the camera sees, from the side: up and down to slope times depth, from the near plane on; and axes.
void Views::wedge(View& view, const Panel& panel, const std::string& name, double slope, double depth,
                  const std::string& along) const {
  const double near = run_.scene.camera.lens.near;
  const dvec2 eye = panel.at({0, 0}), ahead = panel.at({depth, 0}), above{eye.x, panel.place().lower.y};
  view.add({"a " + name + " top", Role::boundary, Stroke{eye, panel.at({depth, slope * depth})}});
  view.add({"a " + name + " bottom", Role::boundary, Stroke{eye, panel.at({depth, -slope * depth})}});
  view.add({"c " + name + " eye", Role::boundary, Dot{eye}});
  const dvec2 low = panel.at({near, -slope * near}), high = panel.at({near, slope * near});
  view.add({"a " + name + " near", Role::boundary, Stroke{low, high}});
  view.add({"d " + name + " near name", Role::boundary, Label{low, words_.say("near")}});
  view.add({"e " + name + " axis along", Role::guide, Stroke{eye, ahead, true}});
  view.add({"e " + name + " axis along name", Role::guide, Label{ahead, along}});
  view.add({"e " + name + " axis y", Role::guide, Stroke{eye, above, true}});
  view.add({"e " + name + " axis y name", Role::guide, Label{above, words_.symbol("y")}});
}

void Views::side_solid(View& view, const Panel& panel, const std::string& name,
                       const std::vector<FacePart>& parts) const {
  const Frame<double>& eye = run_.scene.camera.frame;
  const Sight sight{distant_viewer({1, 0, 0}), {}, {}, {}, [](dvec3 p) { return dvec2{p.z, p.y}; }};
  pieces_solid(view, panel, name, parts, sight, {eye.forward, eye.up, eye.right});
}
/// Seen by the eye: right, up, towards it.
void Views::seen_solid(View& view, const Panel& panel, const std::string& name,
                       const std::vector<FacePart>& parts) const {
  const Frame<double>& eye = run_.scene.camera.frame;
  const Sight sight{distant_viewer({0, 0, 1}), {}, {}, {}, [](dvec3 p) { return dvec2(p); }};
  pieces_solid(view, panel, name, parts, sight, {eye.right, eye.up, -eye.forward});
}

/// place: to the side, up, depth.
void Views::side_panel(View& view, Side side, const std::string& name, const Placing& place, double slope,
                       double depth, const Pointer& at) const {
  const Flat flat = [](dvec3 p) { return dvec2{p.z, p.y}; };
  const Panel here =
      panel(side, extent(place, flat, {{0, 0}, {depth, slope * depth}, {depth, -slope * depth}}));
  if (few_faces()) {
    side_solid(view, here, name, pieces(place));
  } else {
    for (const auto& [face, ring] : pieces(place)) {
      std::vector<dvec2> points;
      for (const dvec3 p : ring) points.push_back(flat(p));
      polygon(view, here, padded("a " + name + " face", static_cast<int>(view.marks.size())), Role::past,
              points);
    }
  }
  wedge(view, here, name, slope, depth, name == "clip" ? words_.symbol("w") : words_.say("depth"));
  followed(view, here, name, own(place, flat), at, Names::pointed);
  if (!way_.place) return;
  dvec3 pixel{0};
  for (std::size_t i = 0; i < 3; ++i)
    pixel +=
        way_.place->shares[static_cast<int>(i)] * place(static_cast<std::size_t>(piece_.corners[i].vertex));
  pixel_place(view, name, here.at(flat(pixel)));
}

View Views::clip_space(const Pointer& at) const {
  View view;
  const Pointer pointed{at.corner.value_or(0), ""};
  double depth = run_.scene.camera.lens.near * 2;
  for (const Projected& p : run_.clip) depth = std::max(depth, 1.04 * p.view.z);
  const double slope = gradus::tan(run_.scene.camera.lens.vertical_radians / 2);
  space(view, Side::before, "space.view");
  side_panel(
      view, Side::before, "view", [&](std::size_t i) { return run_.clip[i].view; }, slope, depth, pointed);
  arrow(view, words_.symbol("P"));
  space(view, Side::after, "space.clip");
  const auto clip = [&](std::size_t i) {
    const glm::dvec4 place = run_.clip[i].clip.at;
    return dvec3{place.x, place.y, place.w};
  };
  side_panel(view, Side::after, "clip", clip, 1, depth, pointed);
  cards_.projection(view, *pointed.corner);
  return view;
}

// --- 4: what the eye sees -------------------------------------------------------------------------------

Panel Views::picture_panel(Side side) const {
  return {paper_.picture(side), {{-aspect_, -1}, {aspect_, 1}}, Panel::Fit::same_scale, false};
}

void Views::window(View& view, const Panel& panel, const std::string& id) const {
  polygon(view, panel, id, Role::boundary, Extent{{-aspect_, -1}, {aspect_, 1}}.corners());
}

/// What lies in front of the eye of a piece, divided for the drawing: right, up, towards the reader.
std::vector<dvec3> Views::seen_ring(const Piece& piece) const {
  std::vector<glm::dvec4> corners;
  for (const PieceCorner& c : piece.corners)
    corners.push_back(run_.clip[static_cast<std::size_t>(c.vertex)].clip.at);
  std::vector<dvec3> ring = before_eye(corners, run_.scene.camera.lens.near);
  for (dvec3& p : ring) p = {aspect_ * p.x, p.y, 0 - p.z};
  return ring;
}

View Views::facing() const {
  View view;
  const Panel here = picture_panel(Side::before), there = picture_panel(Side::after);
  space(view, Side::before, "space.facing");
  arrow(view);
  space(view, Side::after, "space.kept");
  window(view, here, "a window");
  window(view, there, "a window after");
  std::vector<FacePart> kept;
  for (std::size_t i = 0; i < run_.pieces.size(); ++i) {
    const Piece& piece = run_.pieces[i];
    const bool removed = run_.faced[i].removed, own = follows(piece.id);
    const std::vector<dvec3> ring = seen_ring(piece);
    std::vector<dvec2> points;
    for (const dvec3 p : ring) points.emplace_back(p);
    const Role role = own ? Role::current : removed ? Role::rejected : Role::past;
    // Those that stay lie over those that go, and the followed one over all
    const char* layer = own ? "d piece" : removed ? "b piece" : "c piece";
    polygon(view, here, padded(layer, static_cast<int>(i)), role, points);
    if (own) area(view, here, "a inside", role, points);
    if (run_.wrongly_faced(i)) {
      area(view, here, padded("a wrong", static_cast<int>(i)), removed ? Role::rejected : Role::past, points);
    }
    if (removed) continue;
    if (own || !few_faces()) polygon(view, there, padded("d kept", static_cast<int>(i)), role, points);
    if (own) area(view, there, "b kept inside", role, points);
    if (ring.size() >= 3) kept.emplace_back(piece.id.face, ring);
  }
  if (few_faces()) seen_solid(view, there, "kept", kept);
  for (std::size_t k = 0; k < 3; ++k) {
    const glm::dvec4 c = run_.clip[static_cast<std::size_t>(piece_.corners[k].vertex)].clip.at;
    const dvec2 at = here.at({aspect_ * c.x / c.w, c.y / c.w});
    if (c.w < run_.scene.camera.lens.near || !paper_.panel(Side::before).holds(at)) continue;
    view.add_named(fmt::format("e corner {}", k), fmt::format("f name {}", k), Role::current, at,
                   fmt::format("v{}", piece_.corners[k].vertex), true);
  }
  if (way_.place) {
    pixel_place(view, "seen", there.at({aspect_ * way_.place->divided.x, way_.place->divided.y}));
  }
  cards_.determinant(view);
  return view;
}

// --- 5: clipping and division ---------------------------------------------------------------------------

void Views::clip_panel(View& view, const Pointer& at) const {
  const auto flat = [](const glm::dvec4& p) { return dvec2{p.w, p.y}; };
  double depth = run_.scene.camera.lens.near * 2;
  Extent world{{0, 0}, {0, 0}};
  for (const Projected& p : run_.clip) {
    depth = std::max(depth, 1.04 * p.clip.at.w);
    world.add(flat(p.clip.at));
  }
  world.add({depth, depth});
  world.add({depth, -depth});
  const Panel here = panel(Side::before, world);
  wedge(view, here, "clip", 1, depth, words_.symbol("w"));
  const auto side = [&](const std::vector<ClipPoint>& points) {
    std::vector<dvec2> out;
    for (const ClipPoint& p : points) out.push_back(flat(p.at));
    return out;
  };
  std::vector<FacePart> parts;
  for (std::size_t i = 0; i < run_.clipped.size(); ++i) {
    const Clipped& piece = run_.clipped[i];
    const bool own = follows(piece.id);
    const int number = static_cast<int>(i);
    FacePart part{piece.id.face, {}};
    for (const ClipPoint& p : piece.after) part.second.emplace_back(p.at.x, p.at.y, p.at.w);
    if (part.second.size() >= 3) parts.push_back(std::move(part));
    if (piece.changed) polygon(view, here, padded("b before", number), Role::rejected, side(piece.before));
    if (own || !few_faces()) {
      polygon(view, here, padded(own ? "d after" : "c after", number), own ? Role::current : Role::past,
              side(piece.after));
    }
    if (!own) continue;
    area(view, here, "b inside", Role::current, side(piece.after));
    for (std::size_t k = 0; k < piece.after.size(); ++k) {
      const bool made =
          std::ranges::none_of(piece.before, [&](const ClipPoint& p) { return p.at == piece.after[k].at; });
      const bool loud = made || at.corner == k;
      view.add_named(fmt::format("e corner {}", k), fmt::format("f name {}", k),
                     loud ? Role::accepted : Role::current, here.at(side(piece.after)[k]),
                     fmt::format("c{}", k), !loud);
    }
  }
  if (few_faces()) side_solid(view, here, "clipped", parts);
  if (way_.place) pixel_place(view, "clip", here.at(flat(way_.place->clip)));
}

void Views::divided_panel(View& view, const Pointer& at) const {
  const Panel there = picture_panel(Side::after);
  window(view, there, "a window");
  std::vector<FacePart> parts;
  for (std::size_t i = 0; i < run_.clipped.size(); ++i) {
    const Clipped& piece = run_.clipped[i];
    const bool own = follows(piece.id);
    std::vector<dvec3> ring;
    std::vector<dvec2> points;
    for (const NdcPoint& p : piece.divided) {
      ring.emplace_back(aspect_ * p.at.x, p.at.y, 0 - p.at.z);
      points.emplace_back(ring.back());
    }
    if (ring.size() >= 3) parts.emplace_back(piece.id.face, ring);
    if (own || !few_faces()) {
      polygon(view, there, padded(own ? "d divided" : "c divided", static_cast<int>(i)),
              own ? Role::current : Role::past, points);
    }
    if (!own) continue;
    area(view, there, "b divided inside", Role::current, points);
    for (std::size_t k = 0; k < points.size(); ++k) {
      const bool pointed = at.corner == k && !at.text.empty();
      if (!paper_.panel(Side::after).holds(there.at(points[k]))) continue;
      view.add_named(fmt::format("e divided corner {}", k), fmt::format("f divided name {}", k),
                     pointed ? Role::accepted : Role::current, there.at(points[k]), fmt::format("c{}", k),
                     !pointed);
    }
  }
  if (few_faces()) seen_solid(view, there, "divided", parts);
  if (way_.place)
    pixel_place(view, "divided", there.at({aspect_ * way_.place->divided.x, way_.place->divided.y}));
}

View Views::clipping(const Pointer& at) const {
  View view;
  space(view, Side::before, "space.clip");
  clip_panel(view, at);
  arrow(view, fmt::format("÷ {}", words_.symbol("w")));
  space(view, Side::after, "space.ndc");
  divided_panel(view, at);
  cards_.division(view);
  return view;
}

}  // namespace gradus::textbook_chain
