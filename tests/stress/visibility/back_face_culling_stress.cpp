// The promises of culling: which side of a face is seen is never a matter of rounding.

#include "visibility/back_face_culling/back_face_culling.hpp"

#include <algorithm>
#include <concepts>
#include <vector>

#include "core/arithmetic/exact_scalar.hpp"
#include "core/contract.hpp"
#include "core/record.hpp"
#include "stress/core/integers.hpp"
#include "stress/numbers.hpp"
#include "stress/scales.hpp"

namespace gradus::stress {
namespace {

using namespace back_face_culling;

/// x, y, w of three corners.
Input generate(Kind kind, Random& random) {
  Input input(9);
  for (double& x : input) x = number(kind == Kind::refused ? Kind::random : kind, random);
  if (kind == Kind::near_degenerate || kind == Kind::grazing) {
    // The third corner in the plane of the others and the eye, but for the last places
    const double s = random.uniform(-2, 2), t = kind == Kind::grazing ? 1 - s : random.uniform(-2, 2);
    for (std::size_t k = 0; k < 3; ++k) input[6 + k] = nudged(s * input[k] + t * input[3 + k], random);
  } else if (kind == Kind::ties && random.unit() < 0.5) {
    for (std::size_t k = 0; k < 3; ++k) input[6 + k] = 2 * input[k] - input[3 + k];
  }
  if (kind == Kind::refused) {
    input[static_cast<std::size_t>(random.uniform_int(0, 8))] = random.unit() < 0.5 ? std::nan("") : wrong;
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
template <class T>
glm::vec<4, T> corner(const Input& i, std::size_t k) {
  return {static_cast<T>(i[k]), static_cast<T>(i[k + 1]), T(0), static_cast<T>(i[k + 2])};
}

double error(const Input& i) {
  Recorder<Tested<double>> seen;
  Facing found{};
  try {
    const auto a = corner<double>(i, 0), b = corner<double>(i, 3), c = corner<double>(i, 6);
    found = facing(a, b, c, seen);
    if (!all_finite(i) || facing(a, b, c) != found) return wrong;
  } catch (const ContractViolation&) {
    return all_finite(i) ? wrong : 0;
  }
  const int sign = exact_sign(i);
  const ExactScope scope;
  const int of_rationals = determinant_sign(corner<Exact>(i, 0), corner<Exact>(i, 3), corner<Exact>(i, 6));
  const Facing right = sign > 0 ? Facing::front : sign < 0 ? Facing::back : Facing::edge_on;
  // Where the numbers are floats, too
  const bool floats = std::ranges::all_of(
      i, [](double x) { return std::abs(x) <= 0x1p127 && double{static_cast<float>(x)} == x; });
  if (floats && facing(corner<float>(i, 0), corner<float>(i, 3), corner<float>(i, 6)) != right) return wrong;
  return found == right && of_rationals == sign && all<Tested<double>>(seen).at(0).sign == sign ? 0 : wrong;
}

// --- Faces of four corners, that need not be flat

constexpr std::size_t corners = 4;

/// x, y, z of the corners and of an eye; then whether the eye is a direction.
Input face_and_eye(Kind kind, Random& random) {
  Input input(3 * corners + 4);
  for (double& x : input) x = number(kind == Kind::refused ? Kind::random : kind, random);
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
  if (kind == Kind::refused) {
    input[static_cast<std::size_t>(random.uniform_int(0, 3 * corners - 1))] =
        random.unit() < 0.5 ? std::nan("") : wrong;
  }
  return input;
}
bool is_distant(const Input& i) { return i.back() < 0; }

template <class T>
std::vector<glm::vec<3, T>> face_of(const Input& i) {
  std::vector<glm::vec<3, T>> face;
  for (std::size_t k = 0; k < corners; ++k)
    face.push_back({static_cast<T>(i[3 * k]), static_cast<T>(i[3 * k + 1]), static_cast<T>(i[3 * k + 2])});
  return face;
}
template <class T>
Eye<T> eye_of(const Input& i) {
  const std::size_t k = 3 * corners;
  return {static_cast<T>(i[k]), static_cast<T>(i[k + 1]), static_cast<T>(i[k + 2]), T(is_distant(i) ? 0 : 1)};
}

/// The sign of N . (E - w P) in whole numbers; the eye at 0 for `homogeneous`, whose sign is the other one.
int exact_side(const Input& i, bool eye_at_zero) {
  const auto at = [&](std::size_t corner, std::size_t k) { return fixed(i[3 * (corner % corners) + k]); };
  Integer sum = 0;
  for (std::size_t c = 0; c < corners; ++c) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t m = (k + 1) % 3, n = (k + 2) % 3;
      const Integer normal = at(c, m) * at(c + 1, n) - at(c, n) * at(c + 1, m);
      if (!eye_at_zero) sum += normal * fixed(i[3 * corners + k]);
      if (eye_at_zero || !is_distant(i)) sum -= normal * at(0, k);
    }
  }
  return sum.sign();
}

template <class T, class Method>
int sign_found(const Method& method) {
  int sign = 7;
  method([](std::size_t) {},
         [&]<class Step>(const Step& step) {
           if constexpr (std::same_as<Step, Judged<T>>) sign = step.sign;
         });
  return sign;
}
template <class T>
int side_found(const Input& i) {
  const auto ring = face_of<T>(i);
  const std::vector<Face<T>> faces{ring};
  return sign_found<T>(
      [&](const auto& draw, const auto& watch) { normal_and_view<T>(faces, eye_of<T>(i), draw, watch); });
}
template <class T>
int determinant_found(const Input& i) {
  const auto ring = face_of<T>(i);
  const std::vector<Face<T>> faces{ring};
  return sign_found<T>([&](const auto& draw, const auto& watch) { homogeneous<T>(faces, draw, watch); });
}
bool are_floats(const Input& i) {
  return std::ranges::all_of(
      i, [](double x) { return std::abs(x) <= 0x1p127 && double{static_cast<float>(x)} == x; });
}

double side_error(const Input& i) {
  try {
    const int found = side_found<double>(i), determinant = determinant_found<double>(i);
    if (!all_finite(i)) return wrong;
    const int side = exact_side(i, false), of_zero = -exact_side(i, true);
    if (found != side || determinant != of_zero) return wrong;
    if (are_floats(i) && (side_found<float>(i) != side || determinant_found<float>(i) != of_zero))
      return wrong;
    const ExactScope scope;
    return side_found<Exact>(i) == side ? 0 : wrong;
  } catch (const ContractViolation&) {
    return all_finite(i) ? wrong : 0;
  }
}

// --- Outlines in the picture

/// x, y of four corners.
Input outline(Kind kind, Random& random) {
  Input input(2 * corners);
  for (double& x : input) x = number(kind == Kind::refused ? Kind::random : kind, random);
  if (kind == Kind::near_degenerate || kind == Kind::grazing) {
    for (std::size_t c = 2; c < corners; ++c) {
      const double t = random.uniform(-2, 2);
      for (std::size_t k = 0; k < 2; ++k)
        input[2 * c + k] = nudged(input[k] + t * (input[2 + k] - input[k]), random);
    }
  }
  if (kind == Kind::refused) input[static_cast<std::size_t>(random.uniform_int(0, 7))] = std::nan("");
  return input;
}

template <class T>
int turn_found(const Input& i) {
  std::vector<glm::vec<2, T>> ring;
  for (std::size_t k = 0; k < corners; ++k)
    ring.push_back({static_cast<T>(i[2 * k]), static_cast<T>(i[2 * k + 1])});
  const std::vector<Outline<T>> faces{ring};
  return sign_found<T>([&](const auto& draw, const auto& watch) { screen_area<T>(faces, draw, watch); });
}
int exact_turn(const Input& i) {
  Integer sum = 0;
  for (std::size_t c = 0; c < corners; ++c) {
    const std::size_t a = 2 * c, b = 2 * ((c + 1) % corners);
    sum += fixed(i[a]) * fixed(i[b + 1]) - fixed(i[b]) * fixed(i[a + 1]);
  }
  return sum.sign();
}

double turn_error(const Input& i) {
  try {
    const int found = turn_found<double>(i);
    if (!all_finite(i)) return wrong;
    const int right = exact_turn(i);
    if (found != right || (are_floats(i) && turn_found<float>(i) != right)) return wrong;
    const ExactScope scope;
    return turn_found<Exact>(i) == right ? 0 : wrong;
  } catch (const ContractViolation&) {
    return all_finite(i) ? wrong : 0;
  }
}

// --- The normal

/// In multiples of (n - 2)(4 + 2n) u r^2, without underflow.
double normal_error(const Input& i) {
  if (!all_finite(i)) return 0;
  const auto ring = face_of<double>(i);
  double reach = 0;
  for (const glm::dvec3 p : ring) {
    for (int k = 0; k < 3; ++k) reach = std::max(reach, std::abs(p[k] - ring[0][k]));
  }
  if (reach < 1e-140 || reach > 1e150) return 0;
  const glm::dvec3 found = newell_normal<double>(ring);
  const ExactScope scope;
  const auto rationals = face_of<Exact>(i);
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
        .generate = at_every_scale(generate),
        .error = error,
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
        .error = turn_error,
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
