// Every method of bresenham_line as a function of its own; see machine_code_test.py.
#include "scan_conversion/bresenham_line/bresenham_line.hpp"
#include "scan_conversion/bresenham_line/bresenham_line_batch.hpp"
#include "scan_conversion/bresenham_line/bresenham_line_notes.hpp"
#include "scan_conversion/bresenham_line/bresenham_line_window.hpp"

namespace line = gradus::bresenham_line;
using gradus::ivec2;
using gradus::Window;

void set_pixel(ivec2 p);  // defined nowhere: the compiler must call it
void set_run(ivec2 start, std::int64_t count);

// Flattened: what is compared is the whole method, not a call of it
extern "C" {
[[gnu::flatten]] void machine_code_decision_parameter(ivec2 from, ivec2 to) {
  line::decision_parameter(from, to, set_pixel);
}
[[gnu::flatten]] void machine_code_in_window(ivec2 from, ivec2 to, const Window& window) {
  line::in_window(from, to, window, set_pixel);
}
[[gnu::flatten]] void machine_code_dda(ivec2 from, ivec2 to) { line::dda(from, to, set_pixel); }
[[gnu::flatten]] void machine_code_emit_runs(ivec2 from, ivec2 to) { line::run_length(from, to, set_run); }
[[gnu::flatten]] void machine_code_first_octant(ivec2 from, ivec2 to) {
  line::first_octant(from, to, set_pixel);
}
[[gnu::flatten]] void machine_code_swapped_ends(ivec2 from, ivec2 to) {
  line::swapped_ends(from, to, set_pixel);
}
[[gnu::flatten]] void machine_code_misprinted_derivation(ivec2 from, ivec2 to) {
  line::misprinted_derivation(from, to, set_pixel);
}
}
