// Every method of kd_tree as a function of its own; see machine_code_test.py.
#include "modeling/kd_tree/kd_tree.hpp"

#include "modeling/kd_tree/kd_tree_notes.hpp"

using namespace gradus::kd_tree;

using PlaneTree = Tree<2, double>;
using Place = Point<2, double>;
using Found = Neighbours<double>;

// Flattened: what is compared is the whole method, not a call of it
extern "C" {
[[gnu::flatten]] void machine_code_build(Points<2, double> points, PlaneTree& tree) {
  tree = build<2, double>(points);
}
[[gnu::flatten]] void machine_code_nearest(const PlaneTree& tree, const Place& q, std::size_t k,
                                           Found& found) {
  found = nearest<2, double>(tree, q, k);
}
[[gnu::flatten]] void machine_code_brute_force(Points<2, double> points, const Place& q, std::size_t k,
                                               Found& found) {
  found = brute_force<2, double>(points, q, k);
}
[[gnu::flatten]] void machine_code_no_turning_back(const PlaneTree& tree, const Place& q, std::size_t k,
                                                   Found& found) {
  found = no_turning_back<2, double>(tree, q, k);
}
[[gnu::flatten]] void machine_code_not_squared(const PlaneTree& tree, const Place& q, std::size_t k,
                                               Found& found) {
  found = not_squared<2, double>(tree, q, k);
}
}
