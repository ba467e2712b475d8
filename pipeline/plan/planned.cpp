#include "plan/planned.hpp"

#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

#include "stages/1_input.hpp"
#include "stages/2_world.hpp"
#include "stages/3_perspective.hpp"
#include "stages/4_back_faces.hpp"
#include "stages/5_clipping.hpp"
#include "stages/6_rasterization.hpp"
#include "stages/arrangement.hpp"
#include "stages/wireframe.hpp"

namespace gradus::pipeline {
namespace {

constexpr std::string_view no_area = "no area";

std::int64_t count_of(const auto& list) { return std::ssize(list); }

// --- Order -----------------------------------------------------------------------------------------

/// The objects that are drawn, from the nearest on; those that reach in front of the near plane first.
std::vector<int> front_to_back(const Plan& plan) {
  std::vector<int> order(plan.objects.size());
  std::iota(order.begin(), order.end(), 0);
  std::erase_if(order, [&](int object) { return !plan.draws(object); });
  const auto depth = [&](int object) {
    const auto& extent = plan.of(object).extent;
    return std::pair(extent ? extent->depth : -1.0, object);
  };
  std::ranges::sort(order, {}, depth);
  return order;
}

Window united(const Window& a, const Window& b) {
  if (a.empty()) return b;
  if (b.empty()) return a;
  return {glm::min(a.lower, b.lower), glm::max(a.upper, b.upper)};
}

/// For each object in the order, the pixels where later ones could be hidden.
std::vector<Window> still_to_come(const Plan& plan, const std::vector<int>& order) {
  std::vector<Window> windows(order.size());
  Window all{{0, 0}, {-1, -1}};
  for (std::size_t i = order.size(); i-- > 0;) {
    windows[i] = all;
    const auto& extent = plan.of(order[i]).extent;
    if (extent) all = united(all, extent->pixels);
  }
  return windows;
}

/// Whether what the object covers may hide something of the rest.
bool may_hide(const ObjectPlan& object, const Window& rest) {
  if (rest.empty()) return false;
  return !object.extent || !intersection(object.extent->pixels, rest).empty();
}

// --- An object -------------------------------------------------------------------------------------

/// Stage 5 for what lies wholly between the planes: no test, no cut.
Triangles divided_whole(const Model<WorldPoint>& world, const Model<ClipPoint>& model, Size size) {
  Triangles triangles = room_for(model.pieces);
  const auto depths = plane_depths(model, size);
  for (const Piece& piece : model.pieces)
    append(triangles, fan(piece, divided(polygon_of(piece, world, model)), depths));
  return triangles;
}

/// Adds what stages 5 and 6 do with the pieces of an object.
void count_triangles(const std::vector<Piece>& facing, const Triangles& triangles, bool cut, Ledger& ledger) {
  LedgerRow& clipping = ledger.clipping;
  if (cut)
    clipping.done += count_of(facing);
  else
    clipping.skip(name_of(Rule::inside), count_of(facing));

  LedgerRow& drawing = ledger.rasterization;
  std::int64_t pieces_left = 0;
  const PieceId* before = nullptr;
  for (const Triangle& t : triangles) {
    pieces_left += !before || *before != t.id;
    before = &t.id;
  }
  drawing.total += count_of(triangles) - pieces_left;  // cutting has made more
  drawing.done += count_of(triangles);
  drawing.skip("cut away", count_of(facing) - pieces_left);
}

/// Triangles that came in place of others, more or fewer.
void count_change(std::int64_t before, std::int64_t after, std::string_view why_fewer, LedgerRow& drawing) {
  drawing.done += after - before;
  if (after > before)
    drawing.total += after - before;
  else
    drawing.skip(why_fewer, before - after);
}

/// In a wireframe: the bars that take the place of pieces.
void count_edges(const std::vector<Piece>& facing, const Triangles& bars, Ledger& ledger) {
  ledger.clipping.done += count_of(facing);
  ledger.rasterization.done += count_of(facing);
  count_change(count_of(facing), count_of(bars), "cut away", ledger.rasterization);
}

/// Stages 1 to 5 for one object.
Triangles geometry_of(const Scene& scene, int number, const Plan& plan, Ledger& ledger) {
  Model<ObjectPoint> model;
  bring_in(*object_at(scene, number).mesh, number, model);
  const auto pieces = count_of(model.pieces);
  const auto world = to_world(scene, std::move(model));
  const auto seen = to_clip(scene, plan.size, world);
  const auto facing = cull(scene, seen);
  const bool cut = plan.cuts(number);
  const bool edges = scene.shading == Shading::wireframe;
  Triangles triangles = edges ? outlines(facing, plan.size)
                        : cut ? clip(world, facing, plan.size)
                              : divided_whole(world, facing, plan.size);

  ledger.input.done += count_of(object_at(scene, number).mesh->faces);
  ledger.world.done += count_of(world.vertices);
  ledger.perspective.done += count_of(seen.vertices);
  ledger.facing.done += pieces;
  const auto turned_away = pieces - count_of(facing.pieces);
  ledger.clipping.skip("turned away", turned_away);
  ledger.rasterization.skip("turned away", turned_away);
  if (edges)
    count_edges(facing.pieces, triangles, ledger);
  else
    count_triangles(facing.pieces, triangles, cut, ledger);
  return triangles;
}

/// What the stages would have had to do with an object.
void count_whole(const Mesh& mesh, Ledger& ledger) {
  const std::int64_t vertices = count_of(mesh.positions), triangles = triangle_count(mesh);
  ledger.input.total += count_of(mesh.faces);
  ledger.world.total += vertices;
  ledger.perspective.total += vertices;
  for (LedgerRow* row : {&ledger.facing, &ledger.clipping, &ledger.rasterization}) row->total += triangles;
}

void count_skipped(const Mesh& mesh, Rule rule, Ledger& ledger) {
  const std::int64_t vertices = count_of(mesh.positions), triangles = triangle_count(mesh);
  const std::string_view why = name_of(rule);
  ledger.input.skip(why, count_of(mesh.faces));
  ledger.world.skip(why, vertices);
  ledger.perspective.skip(why, vertices);
  for (LedgerRow* row : {&ledger.facing, &ledger.clipping, &ledger.rasterization}) row->skip(why, triangles);
}

/// The order from back to front, where the scene asks for one, and what it adds and drops.
Triangles in_drawing_order(const Scene& scene, Triangles triangles, Size size, Ledger& ledger) {
  if (scene.shading == Shading::wireframe || scene.hidden_surfaces == HiddenSurfaces::z_buffer)
    return triangles;
  const auto before = count_of(triangles);
  arrange(scene, {}, size, triangles);
  count_change(before, count_of(triangles), no_area, ledger.rasterization);
  return triangles;
}

}  // namespace

void count_objects(const Scene& scene, const Plan& plan, Ledger& ledger) {
  int number = 0;
  for (const Object& object : scene.objects) {
    count_whole(*object.mesh, ledger);
    const auto& skipped = plan.of(number).skipped;
    if (skipped) count_skipped(*object.mesh, *skipped, ledger);
    ++number;
  }
}

void count_pixels(const ShadingCount& count, const Plan& plan, Ledger& ledger) {
  ledger.lamps.total = count.lamps + count.lamps_out_of_range;
  ledger.lamps.done = count.lamps;
  ledger.lamps.skip(name_of(Rule::out_of_range), count.lamps_out_of_range);
  ledger.highlights.total = count.lamps;
  ledger.highlights.done = count.lamps - count.lamps_without_highlight;
  ledger.highlights.skip(name_of(Rule::no_highlight), count.lamps_without_highlight);
  ledger.texels.total = count.places;
  ledger.texels.done = count.places - count.places_without_texture;
  ledger.texels.skip("no texture", count.places_without_texture);
  ledger.output.total = std::int64_t{plan.size.width} * plan.size.height;
  ledger.output.done = plan.window.width() * plan.window.height();
  ledger.output.skip(name_of(Rule::area_of_interest), ledger.output.total - ledger.output.done);
}

Triangles geometry(const Scene& scene, Plan& plan, Ledger& ledger, const Clock& clock) {
  const bool hides = plan.rules.has(Rule::hidden);
  const std::vector<int> order = front_to_back(plan);
  const std::vector<Window> rest = still_to_come(plan, order);
  std::vector<Triangles> of_object(scene.objects.size());
  Cover cover(plan.size);
  for (std::size_t i = 0; i < order.size(); ++i) {
    const int number = order[i];
    ObjectPlan& object = plan.objects[static_cast<std::size_t>(number)];
    if (hides && object.extent) object.behind = cover.hider_of(*object.extent);
    if (object.behind >= 0) {
      object.skipped = Rule::hidden;
      continue;
    }
    Triangles& triangles = of_object[static_cast<std::size_t>(number)];
    triangles = timed(clock, ledger.geometry, [&] { return geometry_of(scene, number, plan, ledger); });
    const bool opaque = !shows_through(scene, object_at(scene, number));
    if (hides && opaque && may_hide(object, rest[i])) cover.add(number, triangles);
  }
  count_objects(scene, plan, ledger);

  Triangles all;
  for (const Triangles& triangles : of_object) append(all, triangles);
  return in_drawing_order(scene, std::move(all), plan.size, ledger);
}

LightPicture antialiased_by_plan(const Scene& scene, Plan& plan, Ledger& ledger, const Clock& clock,
                                 const std::function<void(double)>& reached) {
  double both = 0;
  const Triangles triangles = timed(clock, both, [&] { return geometry(scene, plan, ledger, clock); });
  ledger.planning += both - ledger.geometry;
  PictureWatch watch{.reached = reached};
  LightPicture light =
      timed(clock, ledger.pixels, [&] { return antialias(scene, triangles, plan.size, &plan, &watch); });
  ledger.rasterization.done -= watch.without_area;
  ledger.rasterization.skip(no_area, watch.without_area);
  count_pixels(watch.count, plan, ledger);
  return light;
}

}  // namespace gradus::pipeline
