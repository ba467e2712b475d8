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

dvec3 in_space(const std::vector<double>& place) {
  return {place[0], place[1], place.size() > 2 ? place[2] : 0};
}

}  // namespace

std::vector<Handle> handles_of(const Arguments::Entry& argument, int dimensions, bool bounds,
                               const std::function<std::optional<dvec2>(const dvec3&)>& at) {
  Points points(dimensions, bounds);
  std::visit(points, argument.value);
  std::vector<Handle> handles;
  if (points.found().size() > most_handles) return handles;
  for (const Movable& point : points.found()) {
    const dvec3 place = in_space(point.place);
    const std::optional<dvec2> drawn = at(place);
    if (!drawn) continue;
    Handle handle{argument.name, point.numbers, *drawn, {}};
    double size = 0;
    for (const double x : point.place) size = std::max(size, std::abs(x));
    const double step = size == 0 ? 1 : std::ldexp(1.0, std::ilogb(size) - 10);
    for (std::size_t i = 0; i < point.place.size(); ++i) {
      dvec3 moved = place;
      moved[static_cast<int>(i)] += step;
      const std::optional<dvec2> there = at(moved);
      handle.along.push_back(there ? (*there - *drawn) / step : dvec2(0));
    }
    handles.push_back(std::move(handle));
  }
  return handles;
}

}  // namespace gradus
