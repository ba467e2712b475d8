#pragma once
// Lines and circles drawn into a picture, with how far their pixels are from the ideal figure: what the
// benchmarks of scan conversion share.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "benchmark/subject.hpp"
#include "core/raster.hpp"

namespace gradus::bench::drawings {

using Canvas = Raster<std::uint8_t>;  ///< a byte per cell, as OpenCV's pictures in grey

/// One kind of figure: Shape is what is drawn.
template <class Shape>
struct Figures {
  std::function<void(Canvas&, const Shape&)> reference;  ///< the pixels that are right
  std::function<Window(const Shape&)> window;            ///< where those and near misses lie
  std::function<double(const Shape&, ivec2)> off;        ///< a pixel's distance from the ideal figure
};

/// How far the pixels of a method are off, in pixels, and how many are not the right ones or are missing.
template <class Shape, class Draw>
Error error_of(const Draw& draw, const std::vector<Shape>& shapes, int side, const Figures<Shape>& figures) {
  Error::Sum sum;
  Canvas drawn(side, side), right(side, side);
  for (const Shape& shape : shapes) {
    draw(drawn, shape);
    figures.reference(right, shape);
    const Window at = figures.window(shape);
    for (int y = std::max(at.lower.y, 0); y <= std::min(at.upper.y, side - 1); ++y) {
      for (int x = std::max(at.lower.x, 0); x <= std::min(at.upper.x, side - 1); ++x) {
        const ivec2 p{x, y};
        if ((drawn[p] != 0) != (right[p] != 0)) sum.wrong_decision();
        if (drawn[p] != 0) sum.add(figures.off(shape, p));
        drawn[p] = 0;
        right[p] = 0;
      }
    }
  }
  return sum.error();
}

/// A method that draws all shapes at once: `all(canvas, shapes)` is timed, `one(canvas, shape)` is looked at.
template <class Shape, class All, class One>
Case case_of_all(std::string name, Standing standing, All all, One one, const std::vector<Shape>& shapes,
                 int side, std::int64_t pixels, const Figures<Shape>& figures, Workload workload) {
  const auto canvas = std::make_shared<Canvas>(side, side);
  return {.method = std::move(name),
          .standing = standing,
          .workload = std::move(workload),
          .items = pixels,
          .run = [all, &shapes, canvas] { all(*canvas, shapes); },
          .error = error_of(one, shapes, side, figures)};
}

/// A method that draws one shape after the other.
template <class Shape, class Draw>
Case case_of(std::string name, Standing standing, Draw draw, const std::vector<Shape>& shapes, int side,
             std::int64_t pixels, const Figures<Shape>& figures, Workload workload) {
  const auto all = [draw](Canvas& canvas, const std::vector<Shape>& set) {
    for (const Shape& shape : set) draw(canvas, shape);
  };
  return case_of_all(std::move(name), standing, all, draw, shapes, side, pixels, figures,
                     std::move(workload));
}

}  // namespace gradus::bench::drawings
