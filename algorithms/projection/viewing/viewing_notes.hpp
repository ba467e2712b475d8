#pragma once
// Exhibits: two view matrices of lecture notes that look elsewhere, kept so that a figure can show where, and
// a frame made without a look at what it divides by, and a block of points that is read by its shape. Never
// use them to look; viewing.hpp has the right ones.

#include <cstddef>
#include <vector>

#include "core/contract.hpp"
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
  Matrix<T> m(T(1));
  for (int row = 0; row < 3; ++row) {
    auto axis = axis_of(frame, row);
    // Minus the eye itself
    const T shift = -frame.eye[row];
    write_row(m, row, axis, shift);
    if constexpr (observed<O>) observer(RowWritten<T>{row, axis, shift});
  }
  return m;
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
  const auto& eye = frame.eye;
  const auto right = frame.right;
  const auto up = frame.up;
  const auto back = -frame.forward;
  Matrix<T> m(T(1));
  for (int row = 0; row < 3; ++row) {
    // A column, where a row belongs
    const glm::vec<3, T> axis{
        right[row],
        up[row],
        back[row],
    };
    const T shift = -dot(axis, eye);
    write_row(m, row, axis, shift);
    if constexpr (observed<O>) observer(RowWritten<T>{row, axis, shift});
  }
  return m;
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
  const auto d = target - eye;
  const T distance = length(d);
  const auto ahead = d / distance;
  if constexpr (observed<O>) observer(Aimed<T>{eye, target, ahead});
  // However little is left of up
  const auto r = cross(ahead, up);
  const T size = length(r);
  const auto right = r / size;
  if constexpr (observed<O>) observer(Levelled<T>{up, right, size});
  auto above = cross(right, ahead);
  Frame f{eye, right, above, ahead};
  if constexpr (observed<O>) observer(Framed<T>{f});
  return f;
}

/// 3 rows, or rows of 3, all of one length.
template <class T>
void expect_block(const std::vector<std::vector<T>>& block) {
  const std::size_t columns = block.empty() ? 0 : block[0].size();
  expects(block.size() == 3 || columns == 3, "a block of 3 x N or N x 3 expected, found {} x {}",
          block.size(), columns);
  for (const auto& row : block) expects(row.size() == columns, "rows of equal length expected");
}

/// FAULTY: the points of a block of numbers, as 3 x N or as N x 3 (errata E000-06): three rows are taken for
/// x, y and z of all points, else every row for a point. Three points in rows come out with their x, y and z
/// mixed up, and nothing can tell.
///
/// block: rows of equal length; 3 rows, or rows of 3.
///
/// Domain: right for every 3 x N, and for N x 3 unless N = 3.
/// Accuracy: numbers are copied.
/// Cost: none but moving numbers.
/// Errors: ContractViolation for a block that is neither.
template <class T>
std::vector<glm::vec<3, T>> points_of_block(const std::vector<std::vector<T>>& block) {
  expect_block(block);
  std::vector<glm::vec<3, T>> points;
  if (block.size() == 3) {
    // Rows x, y and z of all points?
    const auto x = block[0], y = block[1], z = block[2];
    for (std::size_t i = 0; i < x.size(); ++i) points.push_back({x[i], y[i], z[i]});
  } else {
    // Every row is a point
    for (const auto& row : block) points.push_back({row[0], row[1], row[2]});
  }
  return points;
}

}  // namespace gradus::viewing
