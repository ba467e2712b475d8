// Every method of z_buffer as a function of its own; see machine_code_test.py.
#include "visibility/z_buffer/z_buffer.hpp"

extern "C" {
[[gnu::flatten]] bool machine_code_keep_nearest(gradus::Raster<gradus::z_buffer::Cell<double, int>>& buffer,
                                                gradus::ivec2 pixel, double depth, int key) {
  return gradus::z_buffer::keep_nearest(buffer, pixel, depth, key);
}
}
