// Every method of area_sampling as a function of its own; see machine_code_test.py.
#include "antialiasing/area_sampling/area_sampling.hpp"
#include "antialiasing/area_sampling/area_sampling_notes.hpp"

namespace sampling = gradus::area_sampling;
using Fragments = std::span<sampling::Fragment<double>>;

// Defined nowhere: they must be called
void set_pixel(gradus::ivec2 p, double area);
void set_tone(gradus::ivec2 p, int tone);
void show(const sampling::Fragment<double>& fragment, const sampling::Pieces<double>& pieces, double area);

extern "C" {
[[gnu::flatten]] void machine_code_clip_to_pixels(std::span<const gradus::ivec2> corners,
                                                  const gradus::Window& box) {
  sampling::clip_to_pixels(corners, box, set_pixel);
}
[[gnu::flatten]] void machine_code_area_as_tone(std::span<const gradus::ivec2> corners,
                                                const gradus::Window& window) {
  sampling::area_as_tone(corners, window, set_tone);
}
[[gnu::flatten]] void machine_code_visible_areas(Fragments fragments) {
  sampling::visible_areas(fragments, show);
}
[[gnu::flatten]] void machine_code_areas_without_visibility(Fragments fragments) {
  sampling::areas_without_visibility(fragments, show);
}
}
