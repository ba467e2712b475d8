// Every method of liang_barsky_circle as a function of its own; see machine_code_test.py.
#include "clipping/liang_barsky_circle/liang_barsky_circle.hpp"
#include "clipping/liang_barsky_circle/liang_barsky_circle_notes.hpp"

namespace circle = gradus::liang_barsky_circle;
using Segment = gradus::Segment<2, double>;
using Circle = gradus::Circle<double>;

void keep(const std::optional<Segment>& part);  // defined nowhere: the compiler must call it

// Flattened: what is compared is the whole method, not a call of it
extern "C" {
[[gnu::flatten]] void machine_code_half_chord(const Segment& s, const Circle& c) {
  keep(circle::half_chord(s, c));
}
[[gnu::flatten]] void machine_code_exact_decision(const Segment& s, const Circle& c) {
  keep(circle::exact_decision(s, c));
}
[[gnu::flatten]] void machine_code_without_empty_test(const Segment& s, const Circle& c) {
  keep(circle::without_empty_test(s, c));
}
[[gnu::flatten]] void machine_code_discriminant_equals_zero(const Segment& s, const Circle& c) {
  keep(circle::discriminant_equals_zero(s, c));
}
}
