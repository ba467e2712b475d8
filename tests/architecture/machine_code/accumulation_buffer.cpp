// Every method of accumulation_buffer as a function of its own; see machine_code_test.py.
#include "antialiasing/accumulation_buffer/accumulation_buffer.hpp"

#include "antialiasing/accumulation_buffer/accumulation_buffer_notes.hpp"

using namespace gradus::accumulation_buffer;
using gradus::dvec2, gradus::ivec2;

// Defined nowhere: the compiler must call them
void render_place(dvec2 place, const Sums<double>& plot);
void render_moment(double moment, const Sums<double>& plot);
void render_bytes(dvec2 place, const ByteSums& plot);

extern "C" {
[[gnu::flatten]] void machine_code_accumulate(ivec2 grid, const Sums<double>& sums) {
  accumulate(grid, render_place, sums);
}
[[gnu::flatten]] void machine_code_motion_blur(int passes, const Shutter& shutter, const Sums<double>& sums) {
  motion_blur(passes, shutter, render_moment, sums);
}
[[gnu::flatten]] void machine_code_depth_of_field(int n, const Lens& lens, const Sums<double>& sums) {
  depth_of_field(n, lens, render_place, sums);
}
[[gnu::flatten]] void machine_code_eight_bits(ivec2 grid, const ByteSums& sums) {
  eight_bits(grid, render_bytes, sums);
}
}
