// The tour's drawings of clip space: projection, facing, clipping and division.

#include "stories/pipeline/textbook_chain/shapes.hpp"
#include "stories/pipeline/textbook_chain/views.hpp"

namespace gradus::textbook_chain {

using namespace pipeline;

// --- 3: from the side -----------------------------------------------------------------------------------

/// upright: w goes up, as on a map; else to the right.
void Views::wedge(View& view, const Panel& panel, const char* across, bool upright) const {
  const double near = run_.scene.camera.lens.near;
  const Extent frame = paper_.panel();
  const auto at = [&](double w, double side) { return panel.at(upright ? dvec2{side, w} : dvec2{w, side}); };
  const auto line = [&](const std::string& id, Role role, dvec2 a, dvec2 b, bool arrow = false) {
    auto part = shown_part(frame, a, b);
    if (!part) return;
    part->arrow = arrow;
    view.add({id, role, *part});
  };
  const dvec2 eye = at(0, 0);
  const double far = length_of(frame.size()) / panel.scale().x;
  line("b wedge 0", Role::boundary, eye, at(far, far));
  line("b wedge 1", Role::boundary, eye, at(far, -far));
  line("b near", Role::boundary, at(near, -near), at(near, near));
  view.add({"d near name", Role::boundary, Label{at(near, upright ? near : -near), words_.say("near")}});
  view.add_named("c eye", "d eye name", Role::boundary, eye, words_.say("eye"));
  // Axes from the eye on, as far as the panel goes
  const auto axis = [&](const std::string& name, dvec2 way) {
    const auto part = shown_part(frame, eye, eye + way * length_of(frame.size()));
    if (!part) return;
    const dvec2 tip = part->b - way * (0.7 * unit_);
    view.add({"a axis " + name, Role::guide, Stroke{eye, tip, true}});
    view.add({"e axis name " + name, Role::guide, Label{tip, words_.symbol(name)}});
  };
  axis("w", upright ? dvec2{0, -1} : dvec2{1, 0});
  axis(across, upright ? dvec2{1, 0} : dvec2{0, -1});
}

View Views::clip_space(const Pointer& at) const {
  View view = begin(3, words_.say("space.clip"));
  const Place place = [this](std::size_t i) {
    const glm::dvec4& p = clip_at(i);
    return dvec3{p.w, p.y, p.x};
  };
  Extent all = extent(place);
  const double near = run_.scene.camera.lens.near;
  all.add({0, 0});
  all.add({near, near});
  all.add({near, -near});
  const Panel here = panel(all);
  solid(view, here, "clip", pieces(place));
  wedge(view, here, "y", false);
  followed(view, here, own(place), {at.corner.value_or(0), ""}, false);
  if (way_.place) pixel_place(view, here, {way_.place->clip.w, way_.place->clip.y});
  cards_.projection(view, at.corner.value_or(0));
  return view;
}

// --- 4: what the eye sees -------------------------------------------------------------------------------

Panel Views::picture_panel(double wider) const {
  return {paper_.picture(), widened({{-aspect_, -1}, {aspect_, 1}}, wider), Panel::Fit::same_scale, false};
}

void Views::window(View& view, const Panel& panel) const {
  polygon(view, panel, "b window", Role::boundary, Extent{{-aspect_, -1}, {aspect_, 1}}.corners());
}

/// What lies in front of the eye of a piece, divided for the drawing: right, up, towards the reader.
std::vector<dvec3> Views::seen_ring(const Piece& piece) const {
  std::vector<glm::dvec4> corners;
  for (const PieceCorner& c : piece.corners) corners.push_back(clip_at(static_cast<std::size_t>(c.vertex)));
  std::vector<dvec3> ring = before_eye(corners, run_.scene.camera.lens.near);
  for (dvec3& p : ring) p = {aspect_ * p.x, p.y, 0 - p.z};
  return ring;
}

View Views::facing() const {
  View view = begin(4, words_.say("space.facing"));
  const Panel here = picture_panel();
  frame(view);
  std::vector<SolidPart> kept, removed;
  for (std::size_t i = 0; i < run_.pieces.size(); ++i) {
    const Piece& piece = run_.pieces[i];
    const bool own = follows(piece.id);
    const SolidPart part{piece.id.face, seen_ring(piece), own};
    const std::vector<dvec2> points(part.ring.begin(), part.ring.end());
    if (own) polygon(view, here, "d piece", Role::current, points);
    if (run_.wrongly_faced(i) && run_.faced[i].removed)
      area(view, here, padded("a wrong", static_cast<int>(i)), Role::rejected, points);
    if (part.ring.size() >= 3) (run_.faced[i].removed ? removed : kept).push_back(part);
  }
  // Those that go are seen through those that stay; of many only where they end
  for (const auto& [a, b] : rims_of(removed)) {
    const bool ends = std::ranges::any_of(kept, [&](const SolidPart& part) { return has_edge(part, b, a); });
    if (ends == few_faces()) continue;
    auto part = shown_part(paper_.panel(), here.at(dvec2(a)), here.at(dvec2(b)));
    if (!part) continue;
    part->dashed = part->thin = true;
    view.add({padded("c removed", static_cast<int>(view.marks.size())), Role::rejected, *part});
  }
  solid(view, here, "kept", kept);
  for (std::size_t k = 0; k < 3; ++k) {
    const glm::dvec4& c = clip_at(vertex(k));
    const dvec2 at = here.at({aspect_ * c.x / c.w, c.y / c.w});
    if (c.w < run_.scene.camera.lens.near || !paper_.panel().holds(at)) continue;
    view.add_named(fmt::format("e corner {}", k), fmt::format("f name {}", k), Role::current, at,
                   fmt::format("v{}", piece_.corners[k].vertex), true);
  }
  if (way_.place) pixel_place(view, here, {aspect_ * way_.place->divided.x, way_.place->divided.y});
  cards_.determinant(view);
  return view;
}

// --- 5: clipping and division ---------------------------------------------------------------------------

/// Clip space on a map: w ahead, x to the right.
View Views::clipping(const Pointer& at) const {
  View view = begin(5, words_.say("space.map"));
  const auto side = [](const std::vector<ClipPoint>& points) {
    std::vector<dvec2> out;
    for (const ClipPoint& p : points) out.emplace_back(p.at.x, p.at.w);
    return out;
  };
  const double near = run_.scene.camera.lens.near;
  Extent all;
  for (const dvec2 p : {dvec2{0, 0}, dvec2{near, near}, dvec2{-near, near}}) all.add(p);
  // Near by, where the followed piece is cut
  const Clipped* followed = run_.clipped_of(piece_.id);
  const bool cut = followed && followed->changed;
  std::vector<SolidPart> parts;
  for (const Clipped& piece : run_.clipped) {
    SolidPart part{piece.id.face, {}, follows(piece.id)};
    for (const ClipPoint& p : piece.after) part.ring.emplace_back(p.at.x, p.at.w, p.at.y);
    for (const ClipPoint& p : piece.before) {
      if (part.followed || !cut) all.add({p.at.x, p.at.w});
    }
    if (part.ring.size() >= 3) parts.push_back(std::move(part));
  }
  const Panel here = panel(all, {0.9, 0.4});  // its names stand round it
  solid(view, here, "clipped", parts);
  wedge(view, here, "x", true);
  for (const Clipped& piece : run_.clipped) {
    if (!follows(piece.id)) continue;
    if (piece.changed) polygon(view, here, "c before", Role::rejected, side(piece.before), true);
    polygon(view, here, "d after", Role::current, side(piece.after));
    for (std::size_t k = 0; k < piece.after.size(); ++k) {
      const bool made =
          std::ranges::none_of(piece.before, [&](const ClipPoint& p) { return p.at == piece.after[k].at; });
      const bool loud = made || at.corner == k;
      view.add_named(fmt::format("e corner {}", k), fmt::format("f name {}", k),
                     loud ? Role::accepted : Role::current, here.at(side(piece.after)[k]),
                     fmt::format("c{}", k), !loud);
    }
  }
  if (way_.place) pixel_place(view, here, {way_.place->clip.x, way_.place->clip.w});
  cards_.division(view);
  return view;
}

/// The picture as the division makes it, and what lies round it.
View Views::divided(const Pointer& at) const {
  View view = begin(5, words_.say("space.ndc"));
  const Panel here = picture_panel(0.3);
  window(view, here);
  for (const double end : {-1.0, 1.0}) {
    view.add({fmt::format("h window {}", end), Role::boundary,
              Label{here.at({aspect_ * end, end}), place_text(dvec2{end, end})}});
  }
  std::vector<SolidPart> parts;
  for (const Clipped& piece : run_.clipped) {
    const bool own = follows(piece.id);
    SolidPart part{piece.id.face, {}, own};
    for (const NdcPoint& p : piece.divided) part.ring.emplace_back(aspect_ * p.at.x, p.at.y, 0 - p.at.z);
    if (own) {
      polygon(view, here, "d divided", Role::current, {part.ring.begin(), part.ring.end()});
      for (std::size_t k = 0; k < part.ring.size(); ++k) {
        const dvec2 place = here.at(dvec2(part.ring[k]));
        if (!paper_.panel().holds(place)) continue;
        view.add_named(fmt::format("e corner {}", k), fmt::format("f name {}", k),
                       at.corner == k ? Role::accepted : Role::current, place, fmt::format("c{}", k),
                       at.corner != k);
      }
    }
    if (part.ring.size() >= 3) parts.push_back(std::move(part));
  }
  solid(view, here, "divided", parts);
  if (way_.place) pixel_place(view, here, {aspect_ * way_.place->divided.x, way_.place->divided.y});
  cards_.division(view);
  return view;
}

}  // namespace gradus::textbook_chain
