#pragma once
// What a run of transformations in the plane is about, and its numbers in three arithmetics.

#include "stories/matrix_drawing.hpp"
#include "stories/side_by_side.hpp"
#include "stories/telling.hpp"
#include "transformation/affine_2d/affine_2d.hpp"

namespace gradus::affine_2d {

using Shape = std::vector<dvec2>;
using Chain = std::span<const Factor<double>>;

inline const std::vector<std::string> coordinates{"x", "y"};

inline dvec2 point_of(const Tuple& tuple) { return {tuple[0].value, tuple[1].value}; }

inline Factor<double> factor_of(const FactorText& text) {
  using Kind = FactorText::Kind;
  const dvec2 pivot = text.pivot.empty() ? dvec2{0} : point_of(text.pivot);
  const auto both = [&] {
    return text.amount.size() == 1 ? dvec2{text.amount[0].value} : point_of(text.amount);
  };
  switch (text.kind) {
    case Kind::translate:
      return translation(both());
    case Kind::scale:
      return scaling(both(), pivot);
    case Kind::rotate:
      return rotation(turn_degrees(text.amount[0].value), pivot);
    case Kind::shear:
      return shearing(both(), pivot);
    case Kind::reflect:
      break;
  }
  if (text.mirror == Mirror::x_axis) return reflection_in_x_axis<double>();
  if (text.mirror == Mirror::y_axis) return reflection_in_y_axis<double>();
  if (text.mirror == Mirror::origin) return reflection_in_origin<double>();
  if (text.mirror == Mirror::diagonal) return reflection_in_diagonal<double>();
  return reflection_in_line(point_of(text.line[0]), point_of(text.line[1]));
}

/// What a run is about.
struct Subject {
  std::vector<FactorText> texts;
  std::vector<Factor<double>> factors;
  Shape shape;
  bool compare;  ///< with the reverse order

  Chain chain() const { return factors; }
  /// Where the shape stands after so many factors, each applied by itself.
  Shape after(std::size_t count) const {
    Shape points = shape;
    factor_by_factor(chain().first(count), std::span(points));
    return points;
  }
  /// The same shape with the factors in the reverse order.
  Shape reversed() const {
    const std::vector<Factor<double>> back(factors.rbegin(), factors.rend());
    Shape points = shape;
    one_matrix(Chain(back), std::span(points));
    return points;
  }
};

inline Subject subject_of(const Arguments& arguments) {
  Subject subject;
  subject.texts = arguments.factors("factors");
  if (arguments.text("pivots") == "split") subject.texts = split_at_pivots(subject.texts);
  for (const FactorText& text : subject.texts) subject.factors.push_back(factor_of(text));
  subject.shape = arguments.points("polygon");
  subject.compare = arguments.text("orders") == "both";
  return subject;
}

inline MatrixRows rows_of(const Matrix<double>& m) {
  MatrixRows rows(3);
  for (int y = 0; y < 3; ++y) rows[static_cast<std::size_t>(y)] = {m[0][y], m[1][y], m[2][y]};
  return rows;
}

inline std::vector<Field> fields_of(const Matrix<double>& m) {
  return {{"xx", m[0].x}, {"xy", m[1].x}, {"x0", m[2].x}, {"yx", m[0].y}, {"yy", m[1].y}, {"y0", m[2].y}};
}

inline std::string letter(std::size_t corner) {
  return corner < 26 ? std::string(1, static_cast<char>('A' + corner)) : fmt::format("P{}", corner + 1);
}

// --- Side by side with exact numbers

/// What the steps of the methods that multiply and move hold. There is nothing to decide.
struct Numbers {
  template <class T>
  void operator()(NumericStep<T>&, const Started<T>&) const {}
  template <class T>
  void operator()(NumericStep<T>& to, const Rebased<T>& r) const {
    corners(to, r.points);
  }
  template <class T>
  void operator()(NumericStep<T>& to, const Multiplied<T>& m) const {
    constexpr std::array<std::string_view, 3> columns{"x", "y", "0"};
    for (int column = 0; column < 3; ++column) {
      const auto name = columns[static_cast<std::size_t>(column)];
      to.number(fmt::format("x{}", name), m.product[column].x);
      to.number(fmt::format("y{}", name), m.product[column].y);
    }
  }
  template <class T>
  void operator()(NumericStep<T>& to, const Acted<T>& a) const {
    corners(to, a.points);
  }
  template <class T>
  void operator()(NumericStep<T>& to, const Moved<T>& m) const {
    to.point(letter(m.point), m.to);
  }

 private:
  template <class T>
  static void corners(NumericStep<T>& to, const std::vector<Point<T>>& points) {
    for (std::size_t i = 0; i < points.size(); ++i) to.point(letter(i), points[i]);
  }
};

template <class T>
Factor<T> factor_in(const Factor<double>& factor) {
  const auto& [linear, pivot, shift] = factor;
  return {{in_scalar<T>(linear[0]), in_scalar<T>(linear[1])}, in_scalar<T>(pivot), in_scalar<T>(shift)};
}

/// The factors are the doubles' in all three: what is compared is multiplying and moving.
template <class T, class Act, class Watch>
void run_in(const Subject& subject, Act act, const Watch& observer) {
  std::vector<Factor<T>> factors;
  for (const Factor<double>& factor : subject.factors) factors.push_back(factor_in<T>(factor));
  std::vector<Point<T>> points;
  for (const dvec2 p : subject.shape) points.push_back(in_scalar<T>(p));
  act(std::span<const Factor<T>>(factors), std::span(points), observer);
}

}  // namespace gradus::affine_2d
