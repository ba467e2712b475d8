// Every method of csg_tree as a function of its own; see machine_code_test.py.
#include "modeling/csg_tree/csg_tree.hpp"

#include "modeling/csg_tree/csg_tree_notes.hpp"

using namespace gradus::csg_tree;

using Given = Tree<double>;
using Found = Ends<double>;
using Known = Evaluation<double>;

// Flattened: what is compared is the whole method, not a call of it
extern "C" {
[[gnu::flatten]] bool machine_code_contains(Given tree, const Point<double>& x) {
  return contains<double>(tree, x);
}
[[gnu::flatten]] void machine_code_along_ray(Given tree, const Ray<double>& ray, Found& ends) {
  ends = along_ray<double>(tree, ray);
}
[[gnu::flatten]] void machine_code_cracked(Given tree, const Ray<double>& ray, Found& ends) {
  ends = cracked<double>(tree, ray);
}
[[gnu::flatten]] void machine_code_exchanged(Given tree, const Ray<double>& ray, Found& ends) {
  ends = exchanged<double>(tree, ray);
}
[[gnu::flatten]] void machine_code_change(Known& e, Index leaf, const Solid<double>& solid,
                                          Undo<double>& undo) {
  undo = change<double>(e, leaf, solid);
}
[[gnu::flatten]] void machine_code_restore(Known& e, const Undo<double>& undo) { restore<double>(e, undo); }
}
