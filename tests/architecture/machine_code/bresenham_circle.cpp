// Every method of bresenham_circle as a function of its own; see machine_code_test.py.
#include "scan_conversion/bresenham_circle/bresenham_circle.hpp"
#include "scan_conversion/bresenham_circle/bresenham_circle_notes.hpp"
#include "scan_conversion/bresenham_circle/bresenham_circle_window.hpp"

namespace circle = gradus::bresenham_circle;
using gradus::ivec2;
using gradus::Window;

void set_pixel(ivec2 p);  // defined nowhere: the compiler must call it

// Flattened: what is compared is the whole method, not a call of it
extern "C" {
[[gnu::flatten]] void machine_code_decision_parameter(ivec2 center, int radius) {
  circle::decision_parameter(center, radius, set_pixel);
}
[[gnu::flatten]] void machine_code_in_window(ivec2 center, int radius, const Window& window) {
  circle::in_window(center, radius, window, set_pixel);
}
[[gnu::flatten]] void machine_code_late_update(ivec2 center, int radius) {
  circle::late_update(center, radius, set_pixel);
}
[[gnu::flatten]] void machine_code_eight_plots(ivec2 center, int radius) {
  circle::eight_plots(center, radius, set_pixel);
}
}
