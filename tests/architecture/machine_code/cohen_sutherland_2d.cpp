// Every method of cohen_sutherland_2d as a function of its own; see machine_code_test.py.
#include "clipping/cohen_sutherland_2d/cohen_sutherland_2d.hpp"
#include "clipping/cohen_sutherland_2d/cohen_sutherland_2d_notes.hpp"

namespace clip = gradus::cohen_sutherland_2d;
using Line = gradus::Segment<2, double>;
using Rectangle = gradus::Rectangle<double>;

extern "C" {
[[gnu::flatten]] bool machine_code_cut_of_a_cut(Line& line, const Rectangle& window) {
  const auto found = clip::cut_of_a_cut(line, window);
  if (found) line = *found;
  return found.has_value();
}
[[gnu::flatten]] bool machine_code_correctly_rounded(Line& line, const Rectangle& window) {
  const auto found = clip::correctly_rounded(line, window);
  if (found) line = *found;
  return found.has_value();
}
[[gnu::flatten]] bool machine_code_whole_or_nothing(Line& line, const Rectangle& window) {
  const auto found = clip::whole_or_nothing(line, window);
  if (found) line = *found;
  return found.has_value();
}
[[gnu::flatten]] bool machine_code_codes_only(Line& line, const Rectangle& window) {
  const auto found = clip::codes_only(line, window);
  if (found) line = *found;
  return found.has_value();
}
}
