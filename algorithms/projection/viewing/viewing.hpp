#pragma once
// From the world to the viewer: a frame right, up, forward at the eye, the matrix that takes points of the
// world to their coordinates in it, and the way back.
//
// right = forward x up, so the rows right, up, forward have determinant -1: seen along forward, the world is
// not turned alone but mirrored too, which is what makes depth positive (docs/conventions.md).

#include <array>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <limits>

#include "core/camera.hpp"
#include "core/contract.hpp"
#include "core/geometry.hpp"
#include "core/observe.hpp"

namespace gradus::viewing {

/// The view direction has length 1.
template <class T>
struct Aimed {
  glm::vec<3, T> eye, target;
  glm::vec<3, T> forward;  ///< from the eye to the target
};

/// The hint for up lies along the view and says nothing: another one is taken.
template <class T>
struct HintReplaced {
  glm::vec<3, T> up_hint, spare;
};

/// right stands at right angles to the view direction and to the hint for up.
template <class T>
struct Levelled {
  glm::vec<3, T> up_hint;
  glm::vec<3, T> right;
  T sine;  ///< of the angle between the view direction and the hint
};

/// The frame is complete.
template <class T>
struct Framed {
  Frame<T> frame;
};

/// A row of the matrix world to view stands: an axis of the frame, and minus its product with the eye.
template <class T>
struct RowWritten {
  int row;  ///< 0 right, 1 up, 2 forward
  glm::vec<3, T> axis;
  T shift;  ///< the entry of the last column
};

/// A column of the matrix view to world stands: where a unit of right, up or depth leads, or the eye.
template <class T>
struct ColumnWritten {
  int column;  ///< 0 right, 1 up, 2 forward, 3 the eye
  glm::vec<3, T> entries;
};

/// A point of the world has its coordinates in the frame.
template <class T>
struct Viewed {
  glm::vec<3, T> world;
  glm::vec<3, T> view;  ///< right, up, depth
};

/// The sine of the angle between two directions of any length but 0.
template <std::floating_point T>
T sine_between(glm::vec<3, T> a, glm::vec<3, T> b) {
  return glm::length(glm::cross(unit_vector(a), unit_vector(b)));
}

/// The direction of v without what rounding has left of it along n. Domain: n of length 1, v nearly at right
/// angles.
template <std::floating_point T>
glm::vec<3, T> upright_on(glm::vec<3, T> n, glm::vec<3, T> v) {
  const glm::vec<3, T> direction = unit_vector(v);
  return unit_vector(direction - glm::dot(direction, n) * n);
}

/// Whether no component is infinite or not a number.
template <std::floating_point T>
bool is_finite(glm::vec<3, T> v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

/// A vector that points from one point to another: their difference, or, where that overflows, half of it.
template <std::floating_point T>
glm::vec<3, T> way(glm::vec<3, T> from, glm::vec<3, T> to) {
  const glm::vec<3, T> difference = to - from;
  return is_finite(difference) ? difference : to / T(2) - from / T(2);
}

/// The least sine of the angle between the view direction and the hint for up that look_at accepts: below it
/// rounding would turn the picture.
template <std::floating_point T>
inline constexpr T least_sine = T(1000) * std::numeric_limits<T>::epsilon();

/// The frame of a viewer at `eye` who looks at `target` and holds the head so that `up` points up in the
/// picture. The camera transformation of lecture notes, with their order right, up, forward (Foley, van Dam,
/// Feiner, Hughes, Computer graphics: principles and practice, 1990, section 6.2, has the same frame as
/// u, v, n).
///
/// eye, target: in world space, apart. up: a hint, of any length but 0, not along the view direction.
///
/// Domain: finite coordinates of any size.
/// Steps: Aimed Levelled Framed.
/// Accuracy: against the exact frame forward is within 9/4 ulp of 1 per component, right and up within 3 ulp
///   of 1 divided by the sine between the view direction and the hint; lengths and right angles to 8 ulp of
///   1; determinant of right, up, forward -1.
/// Cost: five square roots, two cross products.
/// Errors: ContractViolation when a coordinate is not finite, when eye and target are the same point, when up
///   has length 0, and when up is parallel to the view direction (their sine is below least_sine).
template <std::floating_point T, Observer<Aimed<T>, Levelled<T>, Framed<T>> O = Unobserved>
Frame<T> look_at(glm::vec<3, T> eye, glm::vec<3, T> target, glm::vec<3, T> up, O&& observer = {}) {
  expects(is_finite(eye) && is_finite(target) && is_finite(up), "eye, target and up have finite coordinates");
  // Forward: from eye to target
  const auto d = way(eye, target);
  const auto ahead = unit_vector(d);
  expects(ahead != glm::vec<3, T>{T(0)}, "the eye and the target are the same point ({}, {}, {})", eye.x,
          eye.y, eye.z);
  if constexpr (observed<O>) observer(Aimed<T>{eye, target, ahead});
  // Right: at right angles to both
  const auto hint = unit_vector(up);
  expects(hint != glm::vec<3, T>{T(0)}, "up is the zero vector, which points nowhere");
  const auto r = cross(ahead, hint);
  expects(length(r) >= least_sine<T>, "up ({}, {}, {}) is parallel to the view direction", up.x, up.y, up.z);
  auto right = upright_on(ahead, r);
  if constexpr (observed<O>) observer(Levelled<T>{up, right, length(r)});
  // Up: at right angles to both
  auto above = cross(right, ahead);
  Frame f{eye, right, above, ahead};
  if constexpr (observed<O>) observer(Framed<T>{f});
  return f;
}

/// What points up for a viewer whose own hint says nothing: -z for who looks up or down, as on a map of the
/// ground, else y. Domain: a direction of length 1; the sine between the two is above 0.7.
template <class T>
glm::vec<3, T> spare_hint(glm::vec<3, T> ahead) {
  const bool steep = ahead.y * ahead.y > ahead.z * ahead.z;
  return steep ? glm::vec<3, T>{T(0), T(0), T(-1)} : glm::vec<3, T>{T(0), T(1), T(0)};
}

/// look_at with any hint for up: one that lies along the view is replaced by spare_hint, so that a viewer may
/// look straight up and down.
///
/// eye, target: in world space, apart. up: a hint; also 0, and along the view.
///
/// Domain: finite coordinates of any size.
///   Where the hint is replaced the picture turns at once: what points up can't be chosen for all
///   directions without a jump somewhere.
/// Steps: HintReplaced? Aimed Levelled Framed.
/// Accuracy: as look_at; with the spare hint the sine is above 0.7.
/// Cost: as look_at, and two square roots and a cross product more.
/// Errors: ContractViolation when a coordinate is not finite, and when eye and target are the same point.
template <std::floating_point T, Observer<HintReplaced<T>, Aimed<T>, Levelled<T>, Framed<T>> O = Unobserved>
Frame<T> spare_up(glm::vec<3, T> eye, glm::vec<3, T> target, glm::vec<3, T> up, O&& observer = {}) {
  expects(is_finite(eye) && is_finite(target) && is_finite(up), "eye, target and up have finite coordinates");
  // Does up say what is right?
  const auto d = way(eye, target);
  T sine = sine_between(d, up);
  if (sine >= least_sine<T>) {
    return look_at(eye, target, up, observer);
  }
  // It doesn't: take another up
  const auto ahead = unit_vector(d);
  auto top = spare_hint(ahead);
  if constexpr (observed<O>) observer(HintReplaced<T>{up, top});
  return look_at(eye, target, top, observer);
}

// --- The matrix, and the way back --------------------------------

template <class T>
using Matrix = glm::mat<4, 4, T>;

/// 0 right, 1 up, 2 forward.
template <class T>
glm::vec<3, T> axis_of(const Frame<T>& frame, int number) {
  return number == 0 ? frame.right : number == 1 ? frame.up : frame.forward;
}

/// Row `row` of a matrix becomes (axis, shift). (GLM's matrices are addressed column first.)
template <class T>
void write_row(Matrix<T>& matrix, int row, glm::vec<3, T> axis, T shift) {
  for (int column = 0; column < 3; ++column) matrix[column][row] = axis[column];
  matrix[3][row] = shift;
}

/// Column `column` of a matrix becomes (entries, ...), its last entry stays.
template <class T>
void write_column(Matrix<T>& matrix, int column, glm::vec<3, T> entries) {
  for (int row = 0; row < 3; ++row) matrix[column][row] = entries[row];
}

/// World space to view space as one matrix: rows right, up, forward, and in the last column minus their
/// products with the eye, so that the eye goes to the origin and a target to (0, 0, distance).
///
/// T: float, double or Exact. frame: any axes; upright ones give view space in world units.
///
/// Domain: finite; the products of axes and eye don't overflow.
/// Steps: RowWritten RowWritten RowWritten.
/// Accuracy: the axes are copied; an entry of the last column is within 3/2 ulp of |eye| for axes of
/// length 1.
///   A point that it takes to view space is within 2 ulp of |eye| + |point|, where to_view is within 2 ulp of
///   their distance: far away the matrix loses what to_view keeps. Underflow adds 2 and 4 smallest numbers.
/// Cost: 9 multiplications, 6 additions.
/// Errors: none.
template <class T, Observer<RowWritten<T>> O = Unobserved>
Matrix<T> world_to_view(const Frame<T>& frame, O&& observer = {}) {
  const auto& eye = frame.eye;
  Matrix<T> m(T(1));
  for (int i = 0; i < 3; ++i) {
    auto axis = axis_of(frame, i);
    // So that the eye goes to 0
    const T shift = -dot(axis, eye);
    write_row(m, i, axis, shift);
    if constexpr (observed<O>) observer(RowWritten<T>{i, axis, shift});
  }
  return m;
}

/// Whether the axes have length 1 and stand at right angles, but for rounding (for Exact: exactly).
template <class T>
bool is_upright(const Frame<T>& frame) {
  const T slack = T(32) * std::numeric_limits<T>::epsilon();
  const auto near = [&](T value, T wanted) { return value - wanted <= slack && wanted - value <= slack; };
  const auto& [eye, right, up, forward] = frame;
  const bool ones = near(glm::dot(right, right), T(1)) && near(glm::dot(up, up), T(1)) &&
                    near(glm::dot(forward, forward), T(1));
  return ones && near(glm::dot(right, up), T(0)) && near(glm::dot(up, forward), T(0)) &&
         near(glm::dot(forward, right), T(0));
}

/// View space back to world space: the inverse of world_to_view. The axes of an upright frame are the columns
/// now (transposed, so inverted), and the eye is where the origin goes.
///
/// T: float, double or Exact. frame: upright.
///
/// Domain: axes of length 1 at right angles, to 32 ulp of 1; for Exact without slack.
/// Steps: ColumnWritten four times.
/// Accuracy: copies only: as upright as the frame is.
/// Cost: none but moving numbers.
/// Errors: ContractViolation for any other frame, whose inverse is not its transpose: see
///   inverse_of_any_frame.
template <class T, Observer<ColumnWritten<T>> O = Unobserved>
Matrix<T> view_to_world(const Frame<T>& frame, O&& observer = {}) {
  expects(is_upright(frame),
          "the axes have length 1 and stand at right angles; of others the transposed matrix is no inverse");
  Matrix<T> m(T(1));
  for (int i = 0; i < 3; ++i) {
    // A unit of view, in the world
    auto axis = axis_of(frame, i);
    write_column(m, i, axis);
    if constexpr (observed<O>) observer(ColumnWritten<T>{i, axis});
  }
  // The origin goes to the eye
  write_column(m, 3, frame.eye);
  if constexpr (observed<O>) observer(ColumnWritten<T>{3, frame.eye});
  return m;
}

/// The axes of a frame, each times a power of two that makes its largest component at least 1 and less than
/// 2, so that products neither overflow nor vanish. Exact needs no scaling.
template <class T>
struct Rescaled {
  std::array<glm::vec<3, T>, 3> scaled;
  std::array<int, 3> exponents{};

  explicit Rescaled(const Frame<T>& frame) : scaled{frame.right, frame.up, frame.forward} {
    if constexpr (std::floating_point<T>) {
      for (std::size_t i = 0; i < 3; ++i) {
        const Scaled<T> axis(scaled[i]);
        scaled[i] = axis.vector;
        exponents[i] = axis.exponent;
      }
    }
  }
  /// A vector that was divided by the i-th scaled axis, as if divided by the axis itself.
  glm::vec<3, T> undo(glm::vec<3, T> v, int i) const {
    if constexpr (std::floating_point<T>) {
      const int exponent = -exponents[static_cast<std::size_t>(i)];
      return {std::scalbn(v.x, exponent), std::scalbn(v.y, exponent), std::scalbn(v.z, exponent)};
    } else {
      return v;
    }
  }
};

/// The least determinant of three rescaled axes that inverse_of_any_frame accepts; for Exact 0.
template <class T>
T least_span() {
  return T(1000) * std::numeric_limits<T>::epsilon();
}

/// The inverse of world_to_view for axes of any lengths and any angles: column i is the cross product of the
/// two other axes, divided by the determinant (Cramer's rule; the columns are the reciprocal basis of the
/// axes).
///
/// T: float, double or Exact. frame: three axes that don't lie in one plane.
///
/// Domain: finite axes of any length (each is scaled by a power of two first). With each axis scaled to
///   between 1 and 2 sqrt(3), their determinant is above 1000 ulp of 1; for Exact just not 0. The result's
///   columns don't overflow.
/// Steps: ColumnWritten four times.
/// Accuracy: against the exact inverse a column is off by at most 192 ulp of 1 times its largest entry,
///   divided by that determinant.
/// Cost: three cross products, 3 divisions of a vector.
/// Errors: ContractViolation when the axes lie in one plane: then nothing leads back.
template <class T, Observer<ColumnWritten<T>> O = Unobserved>
Matrix<T> inverse_of_any_frame(const Frame<T>& frame, O&& observer = {}) {
  // Each axis about 1 long
  const Rescaled<T> axes(frame);
  auto [x, y, z] = axes.scaled;
  // What the three axes span
  const T det = dot(x, cross(y, z));
  expects(det > least_span<T>() || det < -least_span<T>(),
          "the axes lie in one plane, so no point can be told from those beside it");
  // Each at right angles to two
  const glm::vec<3, T> normals[]{
      cross(y, z),
      cross(z, x),
      cross(x, y),
  };
  Matrix<T> m(T(1));
  for (int i = 0; i < 3; ++i) {
    const auto n = normals[i] / det;
    const auto c = axes.undo(n, i);
    write_column(m, i, c);
    if constexpr (observed<O>) observer(ColumnWritten<T>{i, c});
  }
  // The origin goes to the eye
  write_column(m, 3, frame.eye);
  if constexpr (observed<O>) observer(ColumnWritten<T>{3, frame.eye});
  return m;
}

/// The coordinates of a point for the viewer: how far right, how far up, how deep.
///
/// Domain: finite; the distance from the eye is at most half the largest number of T.
/// Steps: Viewed.
/// Accuracy: a component is within 2 ulp of the distance from the eye, which is subtracted first (axes of
///   length 1), and 2 of the smallest numbers of T where products underflow.
/// Cost: 9 multiplications, 9 additions.
/// Errors: none.
template <class T, Observer<Viewed<T>> O = Unobserved>
glm::vec<3, T> to_view(const Frame<T>& frame, glm::vec<3, T> world, O&& observer = {}) {
  const auto p = world - frame.eye;
  const T x = glm::dot(frame.right, p);
  const T y = glm::dot(frame.up, p);
  const T depth = glm::dot(frame.forward, p);
  const glm::vec<3, T> view{x, y, depth};
  if constexpr (observed<O>) observer(Viewed<T>{world, view});
  return view;
}

}  // namespace gradus::viewing
