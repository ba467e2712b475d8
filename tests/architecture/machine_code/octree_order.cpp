// Every method of octree_order as a function of its own; see machine_code_test.py.
#include "visibility/octree_order/octree_order.hpp"

using namespace gradus::octree_order;

bool has_children(const Cell<double>& cell);  // defined nowhere: the compiler must call it
void take(const Cell<double>& cell);

using Walking = Walk<double, bool(const Cell<double>&), void(const Cell<double>&)>;

// Flattened: what is compared is the whole method, not a call of it
extern "C" {
[[gnu::flatten]] void machine_code_front_to_back(const Cell<double>& root, const Eye<double>& eye) {
  front_to_back(root, eye, has_children, take);
}
[[gnu::flatten]] void machine_code_back_to_front(const Cell<double>& root, const Eye<double>& eye) {
  back_to_front(root, eye, has_children, take);
}
[[gnu::flatten]] void machine_code_nearer_first(Walking& walk, const Cell<double>& cell) {
  gradus::Unobserved nobody;
  nearer_first(walk, cell, nobody);
}
[[gnu::flatten]] void machine_code_farther_first(Walking& walk, const Cell<double>& cell) {
  gradus::Unobserved nobody;
  farther_first(walk, cell, nobody);
}
}
