// Every method of a_buffer as a function of its own; see machine_code_test.py.
#include "antialiasing/a_buffer/a_buffer.hpp"
#include "antialiasing/a_buffer/a_buffer_notes.hpp"

using namespace gradus::a_buffer;

void take(const Fragment& fragment, double weight);  // defined nowhere: the compiler must call it

extern "C" {
[[gnu::flatten]] Mask machine_code_mask_of(const Edges& edges, gradus::ivec2 pixel) {
  return mask_of(edges, pixel);
}
[[gnu::flatten]] void machine_code_put_in_order(std::vector<Fragment>& list) {
  ByRange before;
  put_in_order(list, before);
}
double machine_code_resolve(std::vector<Fragment>& list) { return resolve(list, take); }
double machine_code_by_ranges(std::vector<Fragment>& list) { return by_ranges(list, take); }
double machine_code_sum_of_areas(std::vector<Fragment>& list) { return sum_of_areas(list, take); }
double machine_code_divided_by_covered(std::vector<Fragment>& list) { return divided_by_covered(list, take); }
}
