#pragma once
// Exhibits: two view matrices of lecture notes that look elsewhere, kept so that a figure can show where, and
// a frame made without a look at what it divides by. Never use them to look; viewing.hpp has the right ones.

#include "projection/viewing/viewing.hpp"

namespace gradus::viewing {

/// FAULTY unless the frame is unturned or the eye is the origin: the matrix of notes whose last column holds
/// minus the eye's position as it stands, not measured along the axes (errata E004-01).
///
/// frame: as for world_to_view.
///
/// Domain: right for right, up, forward = x, y, z and for eye = 0. The camera at (1,2,3) that looks along +x
///   with right = -z sees itself at (-4,0,-2), and a point 5 ahead at (-4,0,3).
/// Steps: RowWritten RowWritten RowWritten.
/// Accuracy: none: everything is moved by the same wrong way, the eye included.
/// Cost: none but moving numbers.
template <class T, Observer<RowWritten<T>> O = Unobserved>
Matrix<T> minus_position(const Frame<T>& frame, O&& observer = {}) {
  Matrix<T> matrix(T(1));
  for (int row = 0; row < 3; ++row) {
    // An axis, and minus the eye itself
    const auto axis = axis_of(frame, row);
    const T shift = -frame.eye[row];
    write_row(matrix, row, axis, shift);
    if constexpr (observed<O>) observer(RowWritten<T>{row, axis, shift});
  }
  return matrix;
}

/// FAULTY: the axes right, up, -forward as columns where rows belong, so that view coordinates are taken for
/// world coordinates. A report's test prints what this matrix gives for its target (errata E000-01).
///
/// frame: as for world_to_view.
///
/// Domain: right for no frame that is turned. The eye still goes to the origin and distances stay what they
///   are, which is why it goes unnoticed: the target of eye (2,3,5) looking at 0 comes out at
///   (-2.937, -5.054, -1.957), as far away as it should be and far off the middle of the picture.
/// Steps: RowWritten RowWritten RowWritten.
/// Accuracy: none.
/// Cost: 9 multiplications, 6 additions.
template <class T, Observer<RowWritten<T>> O = Unobserved>
Matrix<T> transposed(const Frame<T>& frame, O&& observer = {}) {
  Matrix<T> matrix(T(1));
  const auto right = frame.right;
  const auto up = frame.up;
  const auto back = -frame.forward;
  for (int row = 0; row < 3; ++row) {
    // A column of the right matrix, as a row
    const glm::vec<3, T> axis{
        right[row],
        up[row],
        back[row],
    };
    const T shift = -dot(axis, frame.eye);
    write_row(matrix, row, axis, shift);
    if constexpr (observed<O>) observer(RowWritten<T>{row, axis, shift});
  }
  return matrix;
}

/// FAULTY where up lies along the view: the frame by two cross products, without a look at what they divide
/// by (errata E000-03).
///
/// eye, target, up: as for look_at.
///
/// Domain: right where the sine between up and the view is far from 0. Along the view, and for target = eye,
///   NaN. From straight above up = (1e-17, 1, 0) "works": right is (0, 0, 1), for 1e-17 is left of up.
/// Steps: Aimed Levelled Framed.
/// Accuracy: that of look_at divided by the sine; vectors whose squares leave T are lost.
/// Cost: two square roots, two cross products. Errors: none, where there should be one.
template <std::floating_point T, Observer<Aimed<T>, Levelled<T>, Framed<T>> O = Unobserved>
Frame<T> cross_products(glm::vec<3, T> eye, glm::vec<3, T> target, glm::vec<3, T> up, O&& observer = {}) {
  const auto along = target - eye;
  const T distance = glm::length(along);
  const auto ahead = along / distance;
  if constexpr (observed<O>) observer(Aimed<T>{eye, target, ahead});
  // However little is left of up
  const auto across = glm::cross(ahead, up);
  const T length = glm::length(across);
  const auto right = across / length;
  if constexpr (observed<O>) observer(Levelled<T>{up, right, length});
  const auto above = glm::cross(right, ahead);
  const Frame<T> frame{
      eye,
      right,
      above,
      ahead,
  };
  if constexpr (observed<O>) observer(Framed<T>{frame});
  return frame;
}

}  // namespace gradus::viewing
