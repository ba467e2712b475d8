// Every method of bsp_tree as a function of its own; see machine_code_test.py.
#include "visibility/bsp_tree/bsp_tree.hpp"
#include "visibility/bsp_tree/bsp_tree_notes.hpp"

using namespace gradus::bsp_tree;

void draw_polygon(const Polygon<double>& polygon);  // defined nowhere: the compiler must call it

// Flattened: what is compared is the whole method, not a call of it
extern "C" {
[[gnu::flatten]] void machine_code_build(const std::vector<Polygon<double>>& polygons, Tree<double>& tree) {
  tree = build(polygons);
}
[[gnu::flatten]] void machine_code_build_uncut(const std::vector<Polygon<double>>& polygons,
                                               Tree<double>& tree) {
  tree = build_uncut(polygons);
}
[[gnu::flatten]] void machine_code_back_to_front(const Tree<double>& tree, const Eye<double>& eye) {
  back_to_front(tree, eye, draw_polygon);
}
}
