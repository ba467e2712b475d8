// Every method of cohen_sutherland_3d as a function of its own; see machine_code_test.py.
#include "clipping/cohen_sutherland_3d/cohen_sutherland_3d.hpp"
#include "clipping/cohen_sutherland_3d/cohen_sutherland_3d_volume.hpp"

namespace clip = gradus::cohen_sutherland_3d;

// Flattened: what is compared is the whole method, not a call of it
extern "C" {
[[gnu::flatten]] bool machine_code_cut_of_a_cut(const gradus::Segment<3, double>& line,
                                                const gradus::AxisBox<3, double>& box,
                                                gradus::Segment<3, double>& part) {
  const auto kept = clip::cut_of_a_cut(line, box);
  if (kept) part = *kept;
  return kept.has_value();
}
[[gnu::flatten]] bool machine_code_correctly_rounded(const gradus::Segment<4, double>& line,
                                                     gradus::Segment<4, double>& part) {
  const auto kept = clip::correctly_rounded(line, clip::ViewVolume{});
  if (kept) part = *kept;
  return kept.has_value();
}
}
