// Every method of viewport as a function of its own; see machine_code_test.py.
#include "projection/viewport/viewport.hpp"

extern "C" {
[[gnu::flatten]] void machine_code_to_pixel(glm::dvec2* points, int count, int width, int height) {
  for (int i = 0; i < count; ++i) points[i] = gradus::viewport::to_pixel(points[i], width, height);
}
}
