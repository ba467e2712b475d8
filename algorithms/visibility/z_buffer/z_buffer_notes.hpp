#pragma once
// The z-buffer of the notes, as exhibits: what its listing does to colours, and what it leaves open.

#include <glm/vec3.hpp>

#include "visibility/z_buffer/z_buffer.hpp"

namespace gradus::z_buffer {

/// FAULTY: the colour buffer is filled with whole numbers, the background's, so it takes nothing else: 0.5,
/// 0.2 and 0.9 become 0 (errata E001-33). Depths are right.
///
/// faces, depths: as for per_polygon. colour_of(id): red, green and blue from 0 to 1. colours: the colour
///   buffer, as large as the depths.
///
/// Steps, Cost, Errors: those of per_polygon.
template <class ColourOf, Observer<FaceTaken, Compared<double, Id>, FaceDone, Finished> O = Unobserved>
void integer_colours(std::span<const Face> faces, Raster<Cell<double, Id>>& depths,
                     Raster<glm::ivec3>& colours, ColourOf&& colour_of, O&& observer = {}) {
  Work all;
  for (const Face& face : faces) {
    const auto id = face.id;
    const auto plane = plane_of(face);
    const Outline outline(  // convex
        face, depths.window());
    Work work;
    if constexpr (observed<O>) observer(FaceTaken{id, plane});
    const auto visit = [&](ivec2 p) {
      auto z = plane->at(p);
      auto& cell = depths[p];
      const auto old = held(cell);
      bool wins = beats(cell, z, id);
      if constexpr (observed<O>) observer(Compared<double, Id>{p, z, id, old, wins});
      if (wins) {
        take(cell, z, id);
        // Whole numbers: the rest is lost
        auto& colour = colours[p];
        colour = glm::ivec3(colour_of(id));
      }
      work.count(wins);
    };
    if (plane) outline.visit(visit);
    all.add(work);
    if constexpr (observed<O>) observer(FaceDone{id, work.compared, work.kept});
  }
  if constexpr (observed<O>) observer(Finished{all.compared, all.kept, bytes_of(depths.cells())});
}

/// FAULTY: of equal depths the one drawn first stays, so faces in one plane change places with the order in
/// which they come. The notes' "always correct for any arrangement" (errata E001-31) leaves the case open.
///
/// Parameters, Domain, Steps, Cost, Errors: those of per_polygon.
template <Observer<FaceTaken, Compared<double, Id>, FaceDone, Finished> O = Unobserved>
void first_come(std::span<const Face> faces, Raster<Cell<double, Id>>& buffer, O&& observer = {}) {
  Work all;
  for (const Face& face : faces) {
    const auto id = face.id;
    const auto plane = plane_of(face);
    const Outline outline(  // convex
        face, buffer.window());
    Work work;
    if constexpr (observed<O>) observer(FaceTaken{id, plane});
    const auto visit = [&](ivec2 p) {
      auto z = plane->at(p);
      auto& cell = buffer[p];
      const auto old = held(cell);
      // Equal depths: nobody asks who
      bool wins = !old || z < *old;
      if constexpr (observed<O>) observer(Compared<double, Id>{p, z, id, old, wins});
      if (wins) take(cell, z, id);
      work.count(wins);
    };
    if (plane) outline.visit(visit);
    all.add(work);
    if constexpr (observed<O>) observer(FaceDone{id, work.compared, work.kept});
  }
  if constexpr (observed<O>) observer(Finished{all.compared, all.kept, bytes_of(buffer.cells())});
}

}  // namespace gradus::z_buffer
