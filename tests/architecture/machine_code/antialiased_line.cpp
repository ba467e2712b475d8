// Every method of antialiased_line as a function of its own; see machine_code_test.py.
#include "scan_conversion/antialiased_line/antialiased_line.hpp"
#include "scan_conversion/antialiased_line/antialiased_line_notes.hpp"

using namespace gradus::antialiased_line;
using gradus::ivec2;

void set_pixel(ivec2 p, int intensity);  // defined nowhere: the compiler must call them
void set_area(ivec2 p, double area);

// Flattened: what is compared is the whole method, not a call of it
extern "C" {
[[gnu::flatten]] void machine_code_wu(ivec2 from, ivec2 to) { wu(from, to, set_pixel); }
[[gnu::flatten]] void machine_code_gupta_sproull(ivec2 from, ivec2 to) { gupta_sproull(from, to, set_pixel); }
[[gnu::flatten]] void machine_code_exact_area(ivec2 from, ivec2 to) { exact_area(from, to, set_area); }
[[gnu::flatten]] void machine_code_distance_along_column(ivec2 from, ivec2 to) {
  distance_along_column(from, to, set_pixel);
}
}
