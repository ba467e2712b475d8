// The promises of culling: which side of a face is seen is never a matter of rounding.

#include "visibility/back_face_culling/back_face_culling.hpp"

#include <algorithm>
#include <vector>

#include "core/record.hpp"
#include "stress/core/integers.hpp"
#include "stress/decisions.hpp"
#include "stress/scales.hpp"

namespace gradus::stress {
namespace {

using namespace back_face_culling;

/// x, y, w of three corners.
Input three_corners(Kind kind, Random& random) {
  Input input = numbers_to_place(kind, random, 9, 9);
  if (kind == Kind::near_degenerate || kind == Kind::grazing) {
    // The third corner in the plane of the others and the eye, but for the last places
    const double s = random.uniform(-2, 2), t = kind == Kind::grazing ? 1 - s : random.uniform(-2, 2);
    for (std::size_t k = 0; k < 3; ++k) input[6 + k] = nudged(s * input[k] + t * input[3 + k], random);
  } else if (kind == Kind::ties && random.unit() < 0.5) {
    for (std::size_t k = 0; k < 3; ++k) input[6 + k] = 2 * input[k] - input[3 + k];
  }
  return input;
}

int exact_sign(const Input& i) {
  const auto minor = [&](std::size_t a, std::size_t b) {
    return Integer(fixed(i[a]) * fixed(i[b + 1]) - fixed(i[a + 1]) * fixed(i[b]));
  };
  // By the column of w
  return Integer(fixed(i[2]) * minor(3, 6) - fixed(i[5]) * minor(0, 6) + fixed(i[8]) * minor(0, 3)).sign();
}

/// By the facing found, and the sign told with it.
template <class T>
int facing_found(const std::vector<T>& numbers) {
  std::vector<glm::vec<4, T>> corners;
  for (const auto& p : points_in<3>(numbers, 3)) corners.push_back({p.x, p.y, T(0), p.z});
  const auto &a = corners[0], &b = corners[1], &c = corners[2];
  Recorder<Tested<T>> seen;
  const Facing found = facing(a, b, c, seen);
  const int sign = all<Tested<T>>(seen).at(0).sign;
  return found == facing_of(sign) && facing(a, b, c) == found && determinant_sign(a, b, c) == sign ? sign
                                                                                                   : no_sign;
}

// --- Faces of four corners, that need not be flat

constexpr std::size_t corners = 4;

/// x, y, z of the corners and of an eye; then whether the eye is a direction.
Input face_and_eye(Kind kind, Random& random) {
  Input input = numbers_to_place(kind, random, 3 * corners + 4, 3 * corners);
  if (kind == Kind::near_degenerate || kind == Kind::grazing) {
    // The last corner and the eye in the plane of the others, but for the last places
    for (const std::size_t end : {3 * (corners - 1), 3 * corners}) {
      const double s = random.uniform(-2, 2), t = random.uniform(-2, 2);
      for (std::size_t k = 0; k < 3; ++k)
        input[end + k] =
            nudged(input[k] + s * (input[3 + k] - input[k]) + t * (input[6 + k] - input[k]), random);
    }
  }
  input.back() = random.unit() < 0.5 ? 1 : -1;
  return input;
}

/// The sign of N . (E - w P) in whole numbers; of a face alone, the eye is at 0.
int exact_side(const Input& i) {
  const bool eye_at_zero = i.size() == 3 * corners, distant = i.back() < 0;
  const auto at = [&](std::size_t corner, std::size_t k) { return fixed(i[3 * (corner % corners) + k]); };
  Integer sum = 0;
  for (std::size_t c = 0; c < corners; ++c) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t m = (k + 1) % 3, n = (k + 2) % 3;
      const Integer normal = at(c, m) * at(c + 1, n) - at(c, n) * at(c + 1, m);
      if (!eye_at_zero) sum += normal * fixed(i[3 * corners + k]);
      if (eye_at_zero || !distant) sum -= normal * at(0, k);
    }
  }
  return sum.sign();
}

template <class T>
int side_found(const std::vector<T>& numbers) {
  const auto ring = points_in<3>(numbers, corners);
  const std::vector<Face<T>> faces{ring};
  const Eye<T> eye(vector_in(numbers, 3 * corners), T(numbers.back() < T(0) ? 0 : 1));
  return sign_told<Judged<T>>([&](const auto&... with) { normal_and_view<T>(faces, eye, with...); });
}
template <class T>
int determinant_found(const std::vector<T>& numbers) {
  const auto ring = points_in<3>(numbers, corners);
  const std::vector<Face<T>> faces{ring};
  return sign_told<Judged<T>>([&](const auto&... with) { homogeneous<T>(faces, with...); });
}

/// From the eye at 0, too, which the determinant has the other way round.
double side_error(const Input& i) {
  const Input face(i.begin(), i.begin() + 3 * corners);
  return std::max(
      decision_error(
          i, [](const auto& numbers) { return side_found(numbers); }, exact_side),
      decision_error(face, [](const auto& numbers) { return -determinant_found(numbers); }, exact_side));
}

// --- Outlines in the picture

/// x, y of four corners.
Input outline(Kind kind, Random& random) {
  Input input = numbers_to_place(kind, random, 2 * corners, 2 * corners);
  if (kind == Kind::near_degenerate || kind == Kind::grazing) {
    for (std::size_t c = 2; c < corners; ++c) {
      const double t = random.uniform(-2, 2);
      for (std::size_t k = 0; k < 2; ++k)
        input[2 * c + k] = nudged(input[k] + t * (input[2 + k] - input[k]), random);
    }
  }
  return input;
}

template <class T>
int turn_found(const std::vector<T>& numbers) {
  const auto ring = points_in<2>(numbers, corners);
  const std::vector<Outline<T>> faces{ring};
  return sign_told<Judged<T>>([&](const auto&... with) { screen_area<T>(faces, with...); });
}
int exact_turn(const Input& i) {
  Integer sum = 0;
  for (std::size_t c = 0; c < corners; ++c) {
    const std::size_t a = 2 * c, b = 2 * ((c + 1) % corners);
    sum += fixed(i[a]) * fixed(i[b + 1]) - fixed(i[b]) * fixed(i[a + 1]);
  }
  return sum.sign();
}

// --- The normal

/// In multiples of (n - 2)(4 + 2n) u r^2, without underflow.
double normal_error(const Input& i) {
  if (!all_finite(i)) return 0;
  const auto ring = points_in<3>(i, corners);
  double reach = 0;
  for (const glm::dvec3 p : ring) {
    for (int k = 0; k < 3; ++k) reach = std::max(reach, std::abs(p[k] - ring[0][k]));
  }
  if (reach < 1e-140 || reach > 1e150) return 0;
  const glm::dvec3 found = newell_normal<double>(ring);
  const ExactScope scope;
  const auto rationals = points_in<3>(numbers_in<Exact>(i), corners);
  const ExactVec3 right = newell_normal<Exact>(rationals);
  const Exact bound =
      Exact(double((corners - 2) * (4 + 2 * corners)) * 0x1p-53) * Exact(reach) * Exact(reach);
  double most = 0;
  for (int k = 0; k < 3; ++k) most = std::max(most, to_double(abs(Exact(found[k]) - right[k]) / bound));
  return most;
}

}  // namespace

Domain back_face_culling() {
  const double u = 0x1p-53;
  return {
      "back_face_culling",
      {{.name = "facing",
        .states = "front, back or edge-on as the exact determinant says, whatever the signs of w",
        .unit = "decisions",
        .bound = 0,
        .numbers = 9,
        .generate = at_every_scale(three_corners),
        .error =
            [](const Input& i) {
              return decision_error(i, [](const auto& n) { return facing_found(n); }, exact_sign);
            },
        .traps =
            {{"no area", {1, 1, 1, 2, 2, 1, 3, 3, 1}},
             {"all corners one", {1, 1, 1, 1, 1, 1, 1, 1, 1}},
             {"edges of 1e-170", {0, 0, 1, 1e-170, 0, 1, 0, 1e-170, 1}},
             {"edges of 1e160", {0, 0, 1, 1e160, 0, 1, 0, 1e160, 1}},
             {"the eye in the plane", {0, 0, 0, 1, 1, 1, 2, 0, 1}},
             {"an area of -1.33e-15 that doubles call 0", {0.5 + 2 * u, 0.5 + u, 1, 12, 12, 1, 24, 24, 1}},
             {"six products near 1e16", {1e8, 1e8, 1, 1e8 + 1, 1e8 + 0.25, 1, 1e8 + 0.5, 1e8 + 0.875, 1}},
             {"a corner behind the eye", {0, 0, 1, 1, 0, 1, 0, 1, -1}},
             {"a corner that is no number", {std::nan(""), 0, 1, 1, 0, 1, 0, 1, 1}}},
        .shares = {{"is edge-on", 0.01, [](const Input& i) { return all_finite(i) && exact_sign(i) == 0; }}}},
       {.name = "normal_and_view",
        .states =
            "the exact side of the eye, at any distance, for faces of four corners, flat or not; so does "
            "the determinant before the division",
        .unit = "decisions",
        .bound = 0,
        .numbers = 3 * corners + 4,
        .generate = at_every_scale(face_and_eye),
        .error = side_error,
        .traps = {{"no area", {0, 0, 0, 1, 1, 1, 2, 2, 2, 3, 3, 3, 0, 0, 9, 1}},
                  {"the first three corners on a line", {0, 0, 0, 1, 0, 0, 2, 0, 0, 2, 2, 0, 0, 0, 9, 1}},
                  {"a reflex corner in the middle", {2, 1, 0, 1, 1, 0, 1, 2, 0, 0, 0, 0, 1, 1, 5, 1}},
                  {"a product that doubles call 0",
                   {0.5 + u, 0.5 + 2 * u, 0, 12, 12, 0, 24, 24, 0, 0.5 + u, 0.5 + 2 * u, 0, 0, 0, 1, -1}},
                  {"edges of 1e-170", {0, 0, 0, 1e-170, 0, 0, 1e-170, 1e-170, 0, 0, 1e-170, 0, 0, 0, 1, 1}},
                  {"edges of 1e160", {0, 0, 0, 1e160, 0, 0, 1e160, 1e160, 0, 0, 1e160, 0, 0, 0, 1, 1}},
                  {"a corner that is no number",
                   {std::nan(""), 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0, 0, 1, 1}}}},
       {.name = "screen_area",
        .states = "the exact sign of the area in the picture",
        .unit = "decisions",
        .bound = 0,
        .numbers = 2 * corners,
        .generate = at_every_scale(outline),
        .error =
            [](const Input& i) {
              return decision_error(i, [](const auto& n) { return turn_found(n); }, exact_turn);
            },
        .traps =
            {{"an area that doubles call 0", {0.5 + u, 0.5 + 2 * u, 12, 12, 24, 24, 0.5 + u, 0.5 + 2 * u}},
             {"six products near 1e16", {1e8, 1e8, 1e8 + 1, 1e8 + 0.1, 1e8 + 0.5, 1e8 + 0.875, 1e8, 1e8}},
             {"a bow tie", {0, 0, 2, 2, 2, 0, 0, 2}}},
        .shares = {{"has no area", 0.001,
                    [](const Input& i) { return all_finite(i) && exact_turn(i) == 0; }}}},
       {.name = "newell_normal",
        .states = "components within (n - 2)(4 + 2n) u r^2 of the sum without rounding",
        .unit = "of the bound",
        .bound = 1,
        .numbers = 3 * corners + 4,
        .generate = at_every_scale(face_and_eye),
        .error = normal_error,
        .traps = {{"a sliver", {0, 0, 0, 1, 1, 1, 2, 2, 2 + 4 * u, 1, 1, 1, 0, 0, 0, 1}}}}}};
}

}  // namespace gradus::stress
