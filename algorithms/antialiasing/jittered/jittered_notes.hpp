#pragma once
// Exhibits: jittered sampling as a listing of lecture notes has it. Never draw with them; they are kept to be
// run beside the right form.

#include "antialiasing/jittered/jittered.hpp"

namespace gradus::jittered {

/// FAULTY: looks the samples up in the finished picture, by whole coordinates (errata E001-55): int(i +
/// offset) is i, whatever the offset. So every sample sees the same pixel, and what comes out is what went
/// in: nothing is smoothed.
///
/// p: a pixel of a finished picture, column and row >= 0. asked: how many samples, 1 to most_samples.
/// colour_of(ivec2): the finished picture's pixel.
///
/// Steps: Cut (Placed Looked)* Finished; a Looked has the place that was truncated.
/// Accuracy: equals colour_of(p) where count·colour is exact. Cost: root_of(asked)^2 look-ups.
/// Errors: expects 1 to most_samples, and no negative coordinate.
template <class LookUp, class Colour = ColourOf<LookUp, ivec2>, class O = Unobserved>
constexpr Colour whole_coordinates(ivec2 p, int asked, Random random, LookUp&& colour_of, O&& observer = {}) {
  expects(0 < asked && asked <= most_samples, "a pattern has 1 to {} samples, not {}", most_samples, asked);
  expects(p.x >= 0 && p.y >= 0, "a finished picture has no pixel ({}, {})", p.x, p.y);
  const int side = root_of(asked);
  const int taken = side * side;
  const ivec2 grid(side);
  Colour sum{};
  if constexpr (observed<O>) observer(Cut{grid});
  for (int i = 0; i < taken; ++i) {
    // Jitter within the grid cell
    auto cell = cell_of(i, grid);
    const dvec2 u = offsets(random);
    auto s = in_cell(cell, u, grid);
    if constexpr (observed<O>) observer(Placed{i, cell, grid, u, s});
    // int(x + offset) is x again
    const ivec2 whole(dvec2(p) + s);
    auto colour = colour_of(whole);
    sum += colour;
    if constexpr (observed<O>) observer(Looked<Colour>{i, dvec2(whole), colour, sum / double(i + 1)});
  }
  if constexpr (observed<O>) observer(Finished{taken});
  return sum / double(taken);
}

/// FAULTY: takes int(sqrt n)^2 samples and divides by n (errata E001-56): where n is no square the picture
/// becomes darker, by 0.5 for n = 2, 0.333 for 3, 0.8 for 5, 0.5 for 8.
///
/// p: any pixel. asked: how many samples, 1 to most_samples. colour_at: as for sample_pixel.
///
/// Steps: Cut (Placed Looked)* Finished; the mean of a Looked is the sum so far, divided as asked.
/// Accuracy: root_of(asked)^2 / asked of the right mean. Cost: root_of(asked)^2 calls of colour_at.
/// Errors: expects 1 to most_samples.
template <class ColourAt, class Colour = ColourOf<ColourAt, dvec2>, class O = Unobserved>
constexpr Colour divided_by_asked(ivec2 p, int asked, Random random, ColourAt&& colour_at,
                                  O&& observer = {}) {
  expects(0 < asked && asked <= most_samples, "a pattern has 1 to {} samples, not {}", most_samples, asked);
  // Often fewer cells than asked
  const int side = root_of(asked);
  const int taken = side * side;
  const ivec2 grid(side);
  Colour sum{};
  if constexpr (observed<O>) observer(Cut{grid});
  for (int i = 0; i < taken; ++i) {
    auto cell = cell_of(i, grid);
    const dvec2 u = offsets(random);
    auto s = in_cell(cell, u, grid);
    if constexpr (observed<O>) observer(Placed{i, cell, grid, u, s});
    auto place = dvec2(p) + s;
    auto colour = colour_at(place);
    sum += colour;
    if constexpr (observed<O>) observer(Looked<Colour>{i, place, colour, sum / double(asked)});
  }
  if constexpr (observed<O>) observer(Finished{taken});
  // Divided by asked, not by taken
  return sum / double(asked);
}

}  // namespace gradus::jittered
