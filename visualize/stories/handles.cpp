#include "stories/handles.hpp"

#include <algorithm>
#include <cmath>

namespace gradus {
namespace {

/// A point of an argument: its coordinates, and which of the argument's numbers they are.
struct Movable {
  std::vector<double> place;
  std::vector<int> numbers;
};

/// Collects the points of a value, whatever its kind.
class Points {
 public:
  Points(int dimensions, bool bounds) : dimensions_(static_cast<std::size_t>(dimensions)), bounds_(bounds) {}

  void operator()(const auto&) {}  // nothing that could be dragged
  void operator()(ivec2 cell) { add_tuple({double(cell.x), double(cell.y)}); }
  void operator()(const Window& window) {
    add_corners(
        {double(window.lower.x), double(window.lower.y), double(window.upper.x), double(window.upper.y)});
  }
  void operator()(const Tuple& tuple) {
    std::vector<double> values;
    for (const Number& number : tuple) values.push_back(number.value);
    if (bounds_ && dimensions_ == 2 && values.size() == 4) return add_corners(values);
    add_tuple(values);
  }
  void operator()(const std::vector<Tuple>& tuples) {
    for (const Tuple& tuple : tuples) (*this)(tuple);
  }
  void operator()(const std::vector<std::vector<Tuple>>& rings) {
    for (const std::vector<Tuple>& ring : rings) (*this)(ring);
  }
  void operator()(const std::vector<FaceText>& faces) {
    for (const FaceText& face : faces) (*this)(face.points);
  }
  const std::vector<Movable>& found() const { return found_; }

 private:
  /// As many points as the numbers give, one behind the other.
  void add_tuple(const std::vector<double>& values) {
    for (std::size_t first = 0; first + dimensions_ <= values.size(); first += dimensions_) {
      Movable point;
      for (std::size_t i = first; i < first + dimensions_; ++i) {
        point.place.push_back(values[i]);
        point.numbers.push_back(next_ + static_cast<int>(i));
      }
      found_.push_back(std::move(point));
    }
    next_ += static_cast<int>(values.size());
  }
  void add_corners(const std::vector<double>& b) {
    for (const auto& [x, y] : {std::pair{0, 1}, {2, 1}, {2, 3}, {0, 3}}) {
      found_.push_back(
          {{b[static_cast<std::size_t>(x)], b[static_cast<std::size_t>(y)]}, {next_ + x, next_ + y}});
    }
    next_ += 4;
  }

  std::size_t dimensions_;
  bool bounds_;
  int next_ = 0;
  std::vector<Movable> found_;
};

glm::dvec4 with_zeros(const std::vector<double>& place) {
  glm::dvec4 all(0);
  for (std::size_t i = 0; i < place.size(); ++i) all[static_cast<int>(i)] = place[i];
  return all;
}

/// A thousandth of a point's size, a power of two; of 1 for the origin.
double a_little(const std::vector<double>& place) {
  double size = 0;
  for (const double x : place) size = std::max(size, std::abs(x));
  return std::ldexp(1.0, (size == 0 ? 0 : std::ilogb(size)) - 10);
}

/// How far a place goes when this number of its point grows by 1: measured to both sides, or to the one that
/// is drawn.
dvec2 along(const glm::dvec4& place, int number, double by, dvec2 drawn,
            const std::function<std::optional<dvec2>(const glm::dvec4&)>& at) {
  glm::dvec4 step(0);
  step[number] = by;
  const std::optional<dvec2> ahead = at(place + step), back = at(place - step);
  if (!ahead && !back) return dvec2(0);
  return (ahead.value_or(drawn) - back.value_or(drawn)) / (ahead && back ? 2 * by : by);
}

}  // namespace

std::vector<Handle> handles_of(const Arguments::Entry& argument, int dimensions, bool bounds,
                               const std::function<std::optional<dvec2>(const glm::dvec4&)>& at,
                               std::optional<double> step) {
  Points points(dimensions, bounds);
  std::visit(points, argument.value);
  std::vector<Handle> handles;
  if (points.found().size() > most_handles) return handles;
  for (const Movable& point : points.found()) {
    const glm::dvec4 place = with_zeros(point.place);
    const std::optional<dvec2> drawn = at(place);
    if (!drawn) continue;
    Handle handle{argument.name, point.numbers, *drawn, {}};
    const double by = step.value_or(a_little(point.place));
    for (int i = 0; i < dimensions; ++i) handle.along.push_back(along(place, i, by, *drawn, at));
    handles.push_back(std::move(handle));
  }
  return handles;
}

}  // namespace gradus
