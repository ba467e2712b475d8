#include "stories/pipeline/textbook_chain/way.hpp"

#include <algorithm>
#include <span>

#include "core/arithmetic/elementary.hpp"
#include "core/record.hpp"

namespace gradus::textbook_chain {
namespace {

using namespace pipeline;

/// Which three of the corners that clipping left make a triangle: they are a fan.
std::array<std::size_t, 3> corners_in_fan(const Run& run, const Fragment& f) {
  const auto first = std::ranges::find(run.snapped, f.id, &Snapped::id);
  const auto place = static_cast<std::size_t>(f.triangle - first->triangle);
  return {0, place + 1, place + 2};
}

/// Solves for the corners' shares in x, y and w, which are linear on the triangle.
dvec3 shares_of(const std::array<glm::dvec4, 3>& corners, const glm::dvec4& p) {
  const auto row = [](const glm::dvec4& c) { return dvec3{c.x, c.y, c.w}; };
  const dvec3 a = row(corners[0]), b = row(corners[1]), c = row(corners[2]), at = row(p);
  const dvec3 parts{glm::dot(at, glm::cross(b, c)), glm::dot(a, glm::cross(at, c)),
                    glm::dot(a, glm::cross(b, at))};
  return parts / glm::dot(a, glm::cross(b, c));
}

PixelPlace place_of(const Run& run, const Piece& piece, const Clipped& clipped, const Fragment& f) {
  const std::array<std::size_t, 3> fan = corners_in_fan(run, f);
  glm::dvec4 seen{0};
  for (std::size_t i = 0; i < 3; ++i) seen += f.weights[static_cast<int>(i)] * clipped.after[fan[i]].at;
  const auto vertex = [&](std::size_t i) { return static_cast<std::size_t>(piece.corners[i].vertex); };
  std::array<glm::dvec4, 3> corners{};
  for (std::size_t i = 0; i < 3; ++i) corners[i] = run.clip[vertex(i)].clip.at;
  PixelPlace place{.shares = clipped.changed ? shares_of(corners, seen) : f.weights,
                   .object = dvec3{0},
                   .world = dvec3{0},
                   .view = dvec3{0},
                   .clip = seen,
                   .divided = dvec3(seen) / seen.w};
  for (std::size_t i = 0; i < 3; ++i) {
    const double share = place.shares[static_cast<int>(i)];
    place.object += share * run.placed[vertex(i)].from.at;
    place.world += share * run.placed[vertex(i)].to.at;
    place.view += share * run.clip[vertex(i)].view;
  }
  return place;
}

std::vector<EdgeCut> cuts_of(const Run& run, const Clipped& clipped) {
  using Corner = sutherland_hodgman::Point<double>;
  std::vector<Corner> polygon;
  for (const ClipPoint& p : clipped.before) polygon.push_back({p.at});
  Recorder<sutherland_hodgman::Tested<double>, EdgeCut, sutherland_hodgman::CornerKept<double>,
           sutherland_hodgman::Passed<double>>
      seen;
  sutherland_hodgman::clip(polygon, guard_volume(run.size), seen);
  return all<EdgeCut>(seen);
}

}  // namespace

EdgeValues edge_values(const Run& run, int triangle, ivec2 pixel) {
  constexpr double unit = 65536;  // of a doubled area in 1/256 pixel
  const Snapped& snapped = run.snapped[static_cast<std::size_t>(triangle)];
  const auto edges = triangle_coverage::edges_of(on_grid(snapped.corners));
  const auto weights = triangle_coverage::weights_at_place(edges, triangle_coverage::centre_of(pixel));
  EdgeValues found{.triangle = triangle};
  for (std::size_t i = 0; i < 3; ++i)
    found.values[static_cast<int>(i)] = static_cast<double>(weights[i]) / unit;
  found.doubled_area = static_cast<double>(weights[0] + weights[1] + weights[2]) / unit;
  found.weights = triangle_coverage::barycentric(weights);
  return found;
}

Way way_of(const Run& run, const Followed& followed) {
  Way way;
  const Piece& piece = run.pieces[followed.piece];
  const Clipped* clipped = run.clipped_of(piece.id);
  if (clipped && clipped->changed) way.cuts = cuts_of(run, *clipped);
  const auto fragment = std::ranges::find_if(
      run.covered, [&](const Fragment& f) { return f.id == piece.id && f.pixel == followed.pixel; });
  if (clipped && fragment != run.covered.end()) {
    way.fragment = *fragment;
    way.place = place_of(run, piece, *clipped, *fragment);
    way.edges = edge_values(run, fragment->triangle, followed.pixel);
    const std::array<std::size_t, 3> fan = corners_in_fan(run, *fragment);
    for (std::size_t i = 0; i < 3; ++i)
      way.edges->corner_depths[static_cast<int>(i)] = clipped->divided[fan[i]].at.z;
  }
  for (const DepthTested& test : run.tests) {
    if (test.fragment.pixel == followed.pixel) way.tests.push_back(test);
  }
  way.shaded = run.shaded_at(followed.pixel);
  if (way.shaded) {
    const Mesh& mesh = *run.scene.objects[0].mesh;
    const Material& material = mesh.materials[static_cast<std::size_t>(way.shaded->material)];
    const dvec3 place = way.shaded->place.at;
    way.shininess = static_cast<double>(material.shininess);
    Recorder<illumination::AmbientAdded<double>, illumination::LampTaken<double>, LampLight,
             illumination::Finished<double>>
        seen;
    illumination::phong(place, way.shaded->normal, viewer_of(run.scene.camera, place), material,
                        std::span<const Light>(run.scene.lights), run.scene.ambient, illumination::AllSeen{},
                        seen);
    way.lamps = all<LampLight>(seen);
  }
  const auto written = std::ranges::find(run.written, followed.pixel, &Written::pixel);
  way.written = written == run.written.end() ? nullptr : &*written;
  return way;
}

double srgb_of_linear(double light) {
  const double within = std::clamp(light, 0.0, 1.0);
  return within <= 0.0031308 ? 12.92 * within : 1.055 * gradus::pow(within, 1 / 2.4) - 0.055;
}

}  // namespace gradus::textbook_chain
