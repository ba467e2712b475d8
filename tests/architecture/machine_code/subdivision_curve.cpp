// Every method of subdivision_curve as a function of its own; see machine_code_test.py.
#include "modeling/subdivision_curve/subdivision_curve.hpp"

using namespace gradus::subdivision_curve;

void take(const Parabola<double>& arc);  // defined nowhere: the compiler must call it

// Flattened: what is compared is the whole method, not a call of it
extern "C" {
[[gnu::flatten]] void machine_code_chaikin(const Points<double>& polygon, int rounds, Ends ends,
                                           Points<double>& points) {
  points = chaikin(polygon, rounds, ends);
}
[[gnu::flatten]] void machine_code_limit(const Points<double>& polygon, Ends ends) {
  limit(polygon, ends, take);
}
}
