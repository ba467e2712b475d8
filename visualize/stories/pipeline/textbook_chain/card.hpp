#pragma once
// The numbers of a stage, written below its panels: lines of text, and matrices between brackets.

#include <string>
#include <vector>

#include "figure/drawing.hpp"
#include "stories/paper.hpp"

namespace gradus::textbook_chain {

/// Numbers as texts, by rows.
using Texts = std::vector<std::vector<std::string>>;

/// What stands beside a block of numbers.
enum class Fence { none, brackets, bars };

/// Writes from left to right and from top to bottom. What it writes is left out where a drawing is one of
/// many, and has no say there in how large the others are.
class Card {
 public:
  static constexpr double line_height = 1.55, row_height = 1.47;  ///< units

  /// name: begins the ids. place: of the paper, whose rows go down. unit: of the paper, see ChainPaper.
  Card(View& view, std::string name, const Extent& place, double unit)
      : view_(view), name_(std::move(name)), left_(place.lower.x), unit_(unit), at_(place.lower) {}

  /// In units.
  static double width_of(const std::string& text);

  /// A text, and the next one behind it.
  Card& say(const std::string& text, Role role = Role::input);
  /// A block with its middle on the line. Columns are flush right, or left for the first `names` of them.
  Card& block(const Texts& rows, Fence fence, Role role = Role::input, std::size_t names = 0);
  Card& space(double units);
  Card& down(double units);
  /// The line is as high as so many rows of a block; texts stand in its middle. Called before it is written.
  Card& high(std::size_t rows);
  /// The next line.
  Card& line();

 private:
  dvec2 middle() const { return {at_.x, at_.y + 0.5 * height_ * unit_}; }
  void put(dvec2 at, const std::string& text, Role role, Align align);
  double fence(Fence fence, std::size_t rows, bool opens);

  View& view_;
  const std::string name_;
  const double left_, unit_;
  dvec2 at_;
  double height_ = line_height;  ///< units
  int number_ = 0;
};

}  // namespace gradus::textbook_chain
