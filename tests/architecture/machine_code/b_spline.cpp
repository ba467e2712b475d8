// Every method of b_spline as a function of its own; see machine_code_test.py.
#include "modeling/b_spline/b_spline.hpp"

#include "modeling/b_spline/b_spline_notes.hpp"

using namespace gradus::b_spline;

using Given = Spline<2, double>;
using Weights = std::span<const double>;

// Flattened: what is compared is the whole method, not a call of it
extern "C" {
[[gnu::flatten]] void machine_code_de_boor(const Given& spline, double t, Point<2, double>& p) {
  p = de_boor(spline, t);
}
[[gnu::flatten]] void machine_code_own_span_only(const Given& spline, double t, Point<2, double>& p) {
  p = own_span_only(spline, t);
}
[[gnu::flatten]] void machine_code_basis(const Given& spline, double t, Point<2, double>& p) {
  p = basis(spline, t);
}
[[gnu::flatten]] void machine_code_half_open(const Given& spline, double t, Point<2, double>& p) {
  p = half_open(spline, t);
}
[[gnu::flatten]] void machine_code_with_knot(const Given& spline, double t, Curve<2, double>& curve) {
  curve = with_knot(spline, t);
}
[[gnu::flatten]] void machine_code_bezier_pieces(const Given& spline, std::vector<Piece<2, double>>& pieces) {
  pieces = bezier_pieces(spline);
}
[[gnu::flatten]] void machine_code_nurbs(const Given& spline, Weights weights, double t,
                                         Point<2, double>& p) {
  p = nurbs<2, double>(spline, weights, t);
}
[[gnu::flatten]] void machine_code_unweighted(const Given& spline, Weights weights, double t,
                                              Point<2, double>& p) {
  p = unweighted<2, double>(spline, weights, t);
}
}
