// Every method of supersampling as a function of its own; see machine_code_test.py.
#include "antialiasing/supersampling/supersampling.hpp"
#include "antialiasing/supersampling/supersampling_notes.hpp"

using namespace gradus::supersampling;
using gradus::dvec2, gradus::dvec3, gradus::ivec2, gradus::Window;

void set_pixel(ivec2 p, double value);  // defined nowhere: the compiler must call it
void set_colour(ivec2 p, const dvec3& value);
double grey_at(dvec2 place);
double grey_of(ivec2 pixel);
dvec3 colour_of(ivec2 pixel);

// Flattened: what is compared is the whole method, not a call of it
extern "C" {
[[gnu::flatten]] void machine_code_draw(const Window& window, const Kernel<double>& kernel) {
  draw(window, kernel, grey_at, set_pixel);
}
[[gnu::flatten]] void machine_code_large_picture(const Window& window, int n, Filter filter) {
  large_picture(window, n, filter, grey_at, set_pixel);
}
[[gnu::flatten]] void machine_code_upsampled_image(ivec2 size, int n) {
  upsampled_image(size, n, grey_of, set_pixel);
}
[[gnu::flatten]] void machine_code_blurred_channels(ivec2 size, int n) {
  blurred_channels(size, n, colour_of, set_colour);
}
}
