// Every method of fractal_curve as a function of its own; see machine_code_test.py.
#include "modeling/fractal_curve/fractal_curve.hpp"

#include "modeling/fractal_curve/box_count.hpp"
#include "modeling/fractal_curve/fractal_curve_notes.hpp"
#include "modeling/fractal_curve/l_system.hpp"

using namespace gradus::fractal_curve;

void draw(Corner from, Corner to);  // defined nowhere: the compiler must call it

// Flattened: what is compared is the whole method, not a call of it
extern "C" {
[[gnu::flatten]] void machine_code_koch(const Corners& base, int levels, Corners& way) {
  way = koch(base, levels);
}
[[gnu::flatten]] void machine_code_inside(const Corners& base, int levels, Corners& way) {
  way = inside(base, levels);
}
[[gnu::flatten]] void machine_code_rewrite(const std::string& axiom, Rules rules, int rounds,
                                           std::string& text) {
  text = rewrite(axiom, rules, rounds);
}
[[gnu::flatten]] void machine_code_rule_after_rule(const std::string& axiom, Rules rules, int rounds,
                                                   std::string& text) {
  text = rule_after_rule(axiom, rules, rounds);
}
[[gnu::flatten]] void machine_code_turtle(std::string_view text) { turtle<Corner>(text, lattice_way, draw); }
[[gnu::flatten]] void machine_code_box_count(std::span<const Line> lines, std::span<const Whole> sides,
                                             std::vector<Count>& counts) {
  counts = box_count(lines, sides);
}
}
