// Every method of liang_barsky as a function of its own; see machine_code_test.py.
#include "clipping/liang_barsky/liang_barsky.hpp"
#include "clipping/liang_barsky/liang_barsky_box.hpp"

namespace clip = gradus::liang_barsky;
using Line = gradus::Segment<2, double>;
using Rectangle = gradus::Rectangle<double>;

extern "C" {
[[gnu::flatten]] bool machine_code_parametric(Line& line, const Rectangle& window) {
  const auto found = clip::parametric(line, window);
  if (found) line = *found;
  return found.has_value();
}
[[gnu::flatten]] bool machine_code_correctly_rounded(Line& line, const Rectangle& window) {
  const auto found = clip::correctly_rounded(line, window);
  if (found) line = *found;
  return found.has_value();
}
[[gnu::flatten]] bool machine_code_box_parametric(gradus::Segment<3, double>& line,
                                                  const gradus::AxisBox<3, double>& box) {
  const auto found = clip::box_parametric(line, box);
  if (found) line = *found;
  return found.has_value();
}
[[gnu::flatten]] bool machine_code_box_correctly_rounded(gradus::Segment<3, double>& line,
                                                         const gradus::AxisBox<3, double>& box) {
  const auto found = clip::box_correctly_rounded(line, box);
  if (found) line = *found;
  return found.has_value();
}
}
