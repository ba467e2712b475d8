#pragma once
// Where the drawing of transformations in the plane shows what: the shape before and after, and matrices.

#include "stories/transformation/affine_2d/subject.hpp"

namespace gradus::affine_2d {

inline Extent extent_of(const Shape& shape) {
  Extent extent;
  for (const dvec2 p : shape) extent.add(p);
  return extent;
}

inline double longer_side(const Extent& extent) { return std::max(extent.size().x, extent.size().y); }

/// The way of a point that is turned round a pivot, as a chain of short lines.
inline std::vector<dvec2> arc_round(dvec2 pivot, dvec2 from, double degrees) {
  constexpr int parts = 32;
  std::vector<dvec2> points;
  for (int i = 0; i <= parts; ++i) {
    const Turn<double> turn = turn_degrees(degrees * i / parts);
    points.push_back(transform(rotation(turn, pivot), from));
  }
  return points;
}

/// A paper of 36 x 24: the plane, and the matrices to its right or, over a wide plane, above it. Shapes that
/// are far from each other have a panel each, with one scale, so that none becomes a dot.
class Layout {
 public:
  /// undo: the matrices are inverses. world: all that has to be seen. largest: the size of the largest shape.
  Layout(const Wording& words, const Subject& subject, bool undo, Extent world, double largest)
      : words_(words),
        matrices_(room_for_matrices(subject, undo)),
        far_(longer_side(world) > most_apart * largest && largest > 0),
        above_(far_ ? beside().size().x < least_apart : is_wide(world)),
        panel_(place(), roomy(world)) {}

  /// The whole plane.
  const Panel& panel() const { return panel_; }

  struct Frames {
    Panel before, after;
    bool apart = false;  ///< they are two
  };
  Frames frames(const Extent& before, const Extent& after) const {
    if (!far_) return {panel_, panel_};
    Extent both = before;
    both.add(after.lower);
    both.add(after.upper);
    const double size = std::max(longer_side(before), longer_side(after));
    if (longer_side(both) <= 4 * size) {
      const Panel one(place(), widened(both, 0.15));
      return {one, one};
    }
    const auto [lower, upper] = place();
    const double half = (upper.x - lower.x - gap) / 2;
    const auto round = [size](const Extent& e) {
      return widened({e.centre() - size / 2, e.centre() + size / 2}, 0.2);
    };
    return {Panel({lower, {lower.x + half, upper.y}}, round(before)),
            Panel({{upper.x - half, lower.y}, upper}, round(after)), true};
  }

  /// The axes of the panels; between two of them a break.
  void add_frames(View& view, const Frames& frames, const AxisNames& names) const {
    add_axes(view, frames.before, "plane", names, frames.apart ? 3 : 6);
    if (!frames.apart) return;
    add_axes(view, frames.after, "after", names, 3);
    const double x = (frames.before.place().upper.x + frames.after.place().lower.x) / 2 - 1;
    for (const double dx : {-0.3, 0.3}) {
      view.add({fmt::format("axis break {}", dx), Role::guide,
                Stroke{{x + dx - 0.4, place().lower.y - 0.8}, {x + dx + 0.4, place().lower.y + 0.8}}});
    }
  }

  struct Named {
    std::string name;
    MatrixRows rows;
    Role role;
  };
  void add_matrices(View& view, const std::vector<Named>& matrices) const {
    dvec2 right{paper.x - 0.8, paper.y - 2 - matrices_.y / 2};
    for (std::size_t i = 0; i < matrices.size(); ++i) {
      const auto& [name, rows, role] = matrices[i];
      const std::string id = fmt::format("m{}", i);
      const dvec2 size = matrix_size(shown(rows));
      if (right.x - size.x < 0) return;  // the current factor's has taken all the room
      view.add({id + " heading", role,
                Text{{right.x - size.x, right.y + size.y / 2 + 1.1}, name + " =", Align::left, true}});
      add_matrix(view, id, right, "", shown(rows), role, true);
      if (above_) {
        right.x -= matrices_.x + 3;
      } else {
        right.y -= matrices_.y + 3.4;
      }
    }
  }

 private:
  static constexpr dvec2 paper{36, 24};
  /// A world so many times as large as its shapes is shown in parts.
  static constexpr double most_apart = 14;
  static constexpr double gap = 5.5;
  /// Two panels narrower than this together have no room beside the matrices.
  static constexpr double least_apart = 16;

  /// Two decimals, or of long numbers three digits, are enough beside a drawing: the steps have more.
  static double brief(double x) {
    if (std::abs(x) < 1000) return std::round(x * 100) / 100;
    return std::abs(x) < 1e6 ? x : std::strtod(fmt::format("{:.2e}", x).c_str(), nullptr);
  }
  MatrixRows shown(MatrixRows rows) const {
    for (auto& row : rows) {
      for (double& x : row) x = brief(x);
    }
    return oriented(words_, std::move(rows));
  }

  /// The largest of the matrices that will be shown.
  dvec2 room_for_matrices(const Subject& subject, bool undo) const {
    dvec2 most = matrix_size(shown(rows_of(Matrix<double>(1.0))));
    Matrix<double> product(1.0);
    const auto show = [&](const Matrix<double>& m) { most = glm::max(most, matrix_size(shown(rows_of(m)))); };
    for (std::size_t k = 0; k < subject.factors.size(); ++k) {
      const Factor<double>& factor = subject.factors[undo ? subject.factors.size() - 1 - k : k];
      const auto back = undo ? inverse(factor) : std::optional(factor);
      if (!back) break;
      const Matrix<double> m = matrix(*back);
      product = m * product;
      show(m);
      show(product);
    }
    return most;
  }

  Extent beside() const { return {{2.6, 2}, {paper.x - matrices_.x - 2, paper.y - 1}}; }
  Extent below() const { return {{2.6, 2}, {paper.x - 0.8, paper.y - 3.6 - matrices_.y}}; }
  Extent place() const { return above_ ? below() : beside(); }
  bool is_wide(const Extent& world) const {
    return Panel(below(), roomy(world)).scale().x > Panel(beside(), roomy(world)).scale().x;
  }
  static Extent roomy(Extent world) {
    if (world.size() == dvec2{0}) {
      const dvec2 size = glm::max(glm::abs(world.lower), glm::abs(world.upper));
      const double room = std::max(1.0, 0.01 * std::max(size.x, size.y));
      world = {world.lower - room, world.upper + room};
    }
    return widened(world, 0.02);
  }

  const Wording& words_;
  const dvec2 matrices_;
  const bool far_, above_;
  const Panel panel_;
};

}  // namespace gradus::affine_2d
