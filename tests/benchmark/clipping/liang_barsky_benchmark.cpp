// Liang and Barsky's clipping on the same segments as OpenCV's clipLine and Boost.Geometry's clip_segment.

#include "clipping/liang_barsky/liang_barsky.hpp"

#include "benchmark/clipping/window_lines.hpp"

namespace gradus::bench {
namespace {

using namespace window_lines;

std::vector<Case> cases() {
  std::vector<Method> methods{
      {"parametric", Standing::taught,
       each([](const Line& line) { return liang_barsky::parametric(line, window); })},
      {"correctly_rounded", Standing::robust,
       each([](const Line& line) { return liang_barsky::correctly_rounded(line, window); })},
  };
  for (Method& peer : peers()) methods.push_back(std::move(peer));
  return cases_of(methods);
}

}  // namespace

Subject liang_barsky() {
  return {.topic = "liang_barsky",
          .title = "Segments against a window",
          .item = "segment",
          .unit = "ulp",
          .measure = "segments",
          .telling = "crossing, not whole",
          .cases = cases,
          .choice = {"correctly_rounded", "decided exactly, and nothing moves when it is clipped again"}};
}

}  // namespace gradus::bench
