// Every method of flood_fill as a function of its own; see machine_code_test.py.
#include "scan_conversion/flood_fill/flood_fill.hpp"
#include "scan_conversion/flood_fill/flood_fill_notes.hpp"

namespace fill = gradus::flood_fill;
using gradus::ivec2;

bool is_inside(ivec2 p);  // defined nowhere: the compiler must call it
void set_pixel(ivec2 p);

// Flattened: what is compared is the whole method, not a call of it
extern "C" {
[[gnu::flatten]] std::int64_t machine_code_depth_first(ivec2 seed) {
  return fill::depth_first(seed, is_inside, set_pixel).painted;
}
[[gnu::flatten]] std::int64_t machine_code_breadth_first(ivec2 seed) {
  return fill::breadth_first(seed, is_inside, set_pixel).painted;
}
[[gnu::flatten]] std::int64_t machine_code_span(ivec2 seed) {
  return fill::span(seed, is_inside, set_pixel).painted;
}
[[gnu::flatten]] std::int64_t machine_code_recursive(ivec2 seed) {
  return fill::recursive(seed, is_inside, set_pixel).painted;
}
[[gnu::flatten]] std::int64_t machine_code_recurse(ivec2 seed) {
  fill::Area area{is_inside, set_pixel, fill::ways(fill::Connectivity::four)};
  gradus::Unobserved nobody;
  recurse(area, seed, seed, nobody);
  return area.depth.painted;
}
[[gnu::flatten]] std::int64_t machine_code_unchecked_seed(gradus::Raster<int>& raster, ivec2 seed) {
  const auto done = fill::unchecked_seed(raster, seed, 1);
  return done ? done->painted : -1;
}
}
