// Every method of iterated_functions as a function of its own; see machine_code_test.py.
// FILL IN: a function for each method that reports steps.
#include "modeling/iterated_functions/iterated_functions.hpp"

using namespace gradus::iterated_functions;
using gradus::ivec2;

void set_pixel(ivec2 p);  // defined nowhere: the compiler must call it

// Flattened: what is compared is the whole method, not a call of it
extern "C" {
[[gnu::flatten]] void machine_code_walk(ivec2 from, ivec2 to) { walk(from, to, set_pixel); }
}
