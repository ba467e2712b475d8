// Every method of viewport as a function of its own; see machine_code_test.py.
#include "projection/viewport/viewport.hpp"
#include "projection/viewport/viewport_notes.hpp"

using namespace gradus::viewport;

extern "C" {
[[gnu::flatten]] void machine_code_to_pixel(glm::dvec2* points, int count, int width, int height) {
  for (int i = 0; i < count; ++i) points[i] = to_pixel(points[i], width, height);
}
[[gnu::flatten]] int machine_code_rasterize(const Mapping<double>& map, const glm::dvec2* points, int count,
                                            glm::ivec2* pixels) {
  int inside = 0;
  for (int i = 0; i < count; ++i) {
    if (const auto pixel = rasterize(map, points[i])) pixels[inside++] = *pixel;
  }
  return inside;
}
[[gnu::flatten]] void machine_code_clamped(const Mapping<double>& map, const glm::dvec2* points, int count,
                                           glm::ivec2* pixels) {
  for (int i = 0; i < count; ++i) pixels[i] = clamped(map, points[i], Rounding::half_even);
}
}
