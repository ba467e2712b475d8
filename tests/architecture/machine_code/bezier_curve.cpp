// Every method of bezier_curve as a function of its own; see machine_code_test.py.
#include "modeling/bezier_curve/bezier_curve.hpp"

#include "modeling/bezier_curve/bezier_curve_notes.hpp"
#include "modeling/bezier_curve/compensated.hpp"

using namespace gradus::bezier_curve;

using Control = Polygon<2, double>;
using Found = Points<2, double>;

// Flattened: what is compared is the whole method, not a call of it
extern "C" {
[[gnu::flatten]] void machine_code_de_casteljau(Control control, double t, Point<2, double>& p) {
  p = de_casteljau<2, double>(control, t);
}
[[gnu::flatten]] void machine_code_overwritten(Control control, double t, Point<2, double>& p) {
  p = overwritten<2, double>(control, t);
}
[[gnu::flatten]] void machine_code_compensated(Control control, double t, Point<2, double>& p) {
  p = compensated<2>(control, t);
}
[[gnu::flatten]] void machine_code_bernstein(Control control, double t, Point<2, double>& p) {
  p = bernstein<2, double>(control, t);
}
[[gnu::flatten]] void machine_code_cut_at(const Found& control, double t, Halves<2, double>& halves) {
  halves = cut_at<2, double>(control, t);
}
[[gnu::flatten]] void machine_code_raise_degree(Control control, Found& points) {
  points = raise_degree<2, double>(control);
}
[[gnu::flatten]] void machine_code_flatten(Control control, double tolerance, Found& points) {
  points = flatten<2, double>(control, tolerance);
}
[[gnu::flatten]] void machine_code_middle_only(Control control, double tolerance, Found& points) {
  points = middle_only<2, double>(control, tolerance);
}
}
