// Cohen and Sutherland's clipping on the same segments as OpenCV's clipLine and Boost.Geometry's
// clip_segment.

#include "benchmark/clipping/window_lines.hpp"
#include "clipping/cohen_sutherland_2d/cohen_sutherland_2d_batch.hpp"

namespace gradus::bench {
namespace {

using namespace window_lines;

std::vector<Case> cases() {
  std::vector<Method> methods{
      {"cut_of_a_cut", Standing::taught,
       each([](const Line& line) { return cohen_sutherland_2d::cut_of_a_cut(line, window); })},
      {"correctly_rounded", Standing::robust,
       each([](const Line& line) { return cohen_sutherland_2d::correctly_rounded(line, window); })},
      {"clip_batch", Standing::batch,
       [](const std::vector<Line>& lines, Clipped& clipped) {
         cohen_sutherland_2d::clip_batch(lines, window, clipped.lines, clipped.accepted);
       }},
  };
  for (Method& peer : peers()) methods.push_back(std::move(peer));
  return cases_of(methods);
}

}  // namespace

Subject cohen_sutherland_2d() {
  return {.topic = "cohen_sutherland_2d",
          .title = "Segments against a window",
          .item = "segment",
          .unit = "ulp",
          .measure = "segments",
          .telling = "crossing, not whole",
          .cases = cases,
          .choice = {"clip_batch", "decided exactly, ends rounded once, in the least time"}};
}

}  // namespace gradus::bench
