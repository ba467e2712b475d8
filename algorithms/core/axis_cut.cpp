#include "core/axis_cut.hpp"

namespace gradus {

double cut_coordinate_exact(double a_axis, double b_axis, double a_other, double b_other, double c) {
  expects(a_axis != b_axis, "a segment along the border {} has no cut with it", c);
  // (a_other (b_axis - c) + b_other (c - a_axis)) / (b_axis - a_axis), multiplied out
  SumOfProducts<2> numerator;
  numerator.add(a_other, b_axis);
  numerator.subtract(a_other, c);
  numerator.add(b_other, c);
  numerator.subtract(b_other, a_axis);
  SumOfProducts<1> denominator;
  denominator.add(b_axis);
  denominator.subtract(a_axis);
  return rounded_quotient(numerator, denominator) + 0.0;
}

}  // namespace gradus
