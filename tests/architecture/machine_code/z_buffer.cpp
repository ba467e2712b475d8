// Every method of z_buffer as a function of its own; see machine_code_test.py.
#include "visibility/z_buffer/z_buffer.hpp"
#include "visibility/z_buffer/z_buffer_notes.hpp"

void set_pixel(gradus::ivec2 pixel, gradus::z_buffer::Id id);  // defined nowhere: the compiler must call it
glm::dvec3 colour_of(gradus::z_buffer::Id id);

extern "C" {
[[gnu::flatten]] bool machine_code_keep_nearest(gradus::Raster<gradus::z_buffer::Cell<double, int>>& buffer,
                                                gradus::ivec2 pixel, double depth, int key) {
  return gradus::z_buffer::keep_nearest(buffer, pixel, depth, key);
}
[[gnu::flatten]] void machine_code_per_polygon(
    std::span<const gradus::z_buffer::Face> faces,
    gradus::Raster<gradus::z_buffer::Cell<double, gradus::z_buffer::Id>>& buffer) {
  gradus::z_buffer::per_polygon<double>(faces, buffer);
}
[[gnu::flatten]] void machine_code_scanline(
    std::span<const gradus::z_buffer::Face> faces, gradus::Window picture,
    std::span<gradus::z_buffer::Cell<double, gradus::z_buffer::Id>> line) {
  gradus::z_buffer::scanline<double>(faces, picture, line, gradus::z_buffer::Exactly{}, set_pixel);
}
[[gnu::flatten]] void machine_code_first_come(
    std::span<const gradus::z_buffer::Face> faces,
    gradus::Raster<gradus::z_buffer::Cell<double, gradus::z_buffer::Id>>& buffer) {
  gradus::z_buffer::first_come(faces, buffer);
}
[[gnu::flatten]] void machine_code_integer_colours(
    std::span<const gradus::z_buffer::Face> faces,
    gradus::Raster<gradus::z_buffer::Cell<double, gradus::z_buffer::Id>>& depths,
    gradus::Raster<glm::ivec3>& colours) {
  gradus::z_buffer::integer_colours(faces, depths, colours, colour_of);
}
}
