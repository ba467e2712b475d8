// The promises of Cohen and Sutherland's clipping to a box, one segment or many, and to the view volume.

#include "clipping/cohen_sutherland_3d/cohen_sutherland_3d.hpp"

#include "clipping/cohen_sutherland_3d/cohen_sutherland_3d_batch.hpp"
#include "clipping/cohen_sutherland_3d/cohen_sutherland_3d_volume.hpp"
#include "stress/clipping/axis_boxes.hpp"
#include "support/box_cases.hpp"

namespace gradus::stress {
namespace {

using axis_boxes::list;
using test::Rational;
using Line = Segment<3, double>;
using Box = AxisBox<3, double>;
using HomogeneousLine = Segment<4, double>;

// --- The box ---

std::optional<Line> correctly_rounded(const Line& line, const Box& box) {
  return cohen_sutherland_3d::correctly_rounded(line, box);
}
void by_batch(std::span<const Line> lines, const Box& box, std::span<Line> clipped,
              std::span<std::uint8_t> accepted) {
  cohen_sutherland_3d::clip_batch(lines, box, clipped, accepted);
}

std::vector<std::pair<std::string, std::string>> box_arguments(const Input& i) {
  return {{"method", "correctly_rounded"}, {"line", list(i, 0, 6)}, {"box", list(i, 6, 6)}};
}

std::vector<Trap> box_traps() {
  return {{"a difference overflows", {-1e308, 0, 0, 1e308, 10, 10, 0, 0, 0, 10, 10, 10}},
          {"through two corners", {-1, -1, -1, 11, 11, 11, 0, 0, 0, 10, 10, 10}},
          {"touches a corner", {-1, 1, 0, 1, -1, 0, 0, 0, 0, 10, 10, 10}}};
}

// --- The view volume ---

HomogeneousLine segment_of(const Input& i) { return {{i[0], i[1], i[2], i[3]}, {i[4], i[5], i[6], i[7]}}; }

/// x, y, z, w of both ends.
Input volume_input(Kind kind, Random& random) {
  // Which of the cases that VolumeCases makes is of this kind
  const auto made = [&](int which) {
    const HomogeneousLine s = test::VolumeCases(random())(which);
    return Input{s.a.x, s.a.y, s.a.z, s.a.w, s.b.x, s.b.y, s.b.z, s.b.w};
  };
  Input input(8);
  switch (kind) {
    case Kind::random:
      return made(static_cast<int>(random.uniform_int(0, 1)));
    case Kind::grazing:
      return made(static_cast<int>(random.uniform_int(2, 3)));
    case Kind::ties:
      return made(6);
    case Kind::near_degenerate:
      // Nearly a point, or nearly opposite each other
      input = made(static_cast<int>(random.uniform_int(0, 2)));
      for (std::size_t k = 0; k < 4; ++k) input[4 + k] = nudged(input[k], random);
      if (random.unit() < 0.5) {
        for (std::size_t k = 4; k < 8; ++k) input[k] = -input[k];
      }
      return input;
    case Kind::refused: {
      input = made(0);
      const double way = random.unit();
      if (way < 0.3) std::fill(input.begin(), input.begin() + 4, 0.0);
      if (way > 0.6) {
        for (std::size_t k = 0; k < 4; ++k) input[4 + k] = -4 * input[k];
      }
      if (0.3 <= way && way <= 0.6) {
        input[static_cast<std::size_t>(random.uniform_int(0, 7))] = way < 0.45 ? std::nan("") : wrong;
      }
      return input;
    }
    case Kind::denormal:
      if (random.unit() < 0.5) return made(7);
      [[fallthrough]];
    default:
      for (double& x : input) x = number(kind, random);
      // Mostly before the eye
      if (random.unit() < 0.7) input[3] = std::abs(input[3]), input[7] = std::abs(input[7]);
      return input;
  }
}

/// Whether b = -s a with s > 0: then (0, 0, 0, 0), which is no point, lies between them.
bool through_nothing(const HomogeneousLine& s) {
  Rational same = 0;
  for (int i = 0; i < 4; ++i) {
    same += Rational(s.a[i]) * Rational(s.b[i]);
    for (int j = 0; j < i; ++j) {
      if (Rational(s.a[i]) * Rational(s.b[j]) != Rational(s.a[j]) * Rational(s.b[i])) return false;
    }
  }
  return same < 0;
}

std::optional<HomogeneousLine> volume_part(const HomogeneousLine& line) {
  return cohen_sutherland_3d::correctly_rounded(line, cohen_sutherland_3d::ViewVolume{});
}

double volume_error(const Input& input) {
  const HomogeneousLine line = segment_of(input);
  const glm::dvec4 none(0);
  const bool taken = all_finite(input) && line.a != none && line.b != none && !through_nothing(line);
  std::optional<HomogeneousLine> found;
  try {
    found = volume_part(line);
  } catch (const ContractViolation&) {
    return taken ? wrong : 0;
  }
  if (!taken) return wrong;
  const auto exact = test::representable<double>(test::exact_part(line));
  if (found.has_value() != exact.has_value()) return wrong;
  double worst = 0;
  for (int i = 0; found && i < 4; ++i) {
    const auto k = static_cast<std::size_t>(i);
    worst = std::max(
        {worst, test::error_in_ulp(found->a[i], exact->a[k]), test::error_in_ulp(found->b[i], exact->b[k])});
  }
  if (found && !test::same_bits(volume_part(*found), found)) return wrong;
  return worst;
}

}  // namespace

Domain cohen_sutherland_3d() {
  return {"cohen_sutherland_3d",
          {{.name = "correctly_rounded",
            .states = "accepts and rejects exactly; every end is the nearest double",
            .unit = "ulp",
            .bound = 0.5,
            .numbers = 12,
            .generate = axis_boxes::generate<3>,
            .error = [](const Input& i) { return axis_boxes::error<3>(i, correctly_rounded); },
            .arguments = box_arguments,
            .traps = box_traps()},
           {.name = "clip_batch",
            .states = "the bits of correctly_rounded, in every lane",
            .unit = "ulp",
            .bound = 0.5,
            .numbers = 12,
            .generate = axis_boxes::generate<3>,
            .error =
                [](const Input& i) {
                  return axis_boxes::error<3>(i, axis_boxes::in_every_lane<3>(by_batch, correctly_rounded));
                },
            .arguments = box_arguments,
            .traps = box_traps()},
           {.name = "view_volume",
            .states = "before the division: accepts and rejects exactly; every end is the nearest double; "
                      "again changes nothing",
            .unit = "ulp",
            .bound = 0.5,
            .numbers = 8,
            .generate = at_every_scale(volume_input),
            .error = volume_error,
            .arguments = [](const Input& i) -> std::vector<std::pair<std::string, std::string>> {
              return {{"method", "view_volume"}, {"homogeneous", list(i, 0, 8)}};
            },
            .traps = {{"w goes through 0", {-2, 0, 1, 2, 2, 0, 0, -2}},
                      {"wholly behind the eye", {0, 0, -1, -2, 1, 1, -2, -3}},
                      {"ends in the eye's plane", {0, 0, 0.5, 1, 1, 0, 0, 0}},
                      {"z = 1e-310 before the eye", {1, 0, 1e-310, 1e-310, 0, 0, 1, 2}},
                      {"a sum of w and x overflows", {1e308, 0, 1, 1.5e308, -1.7e308, 1, 2, 1.5e308}},
                      {"an end rounds to (0, 0, 0, 0)", {0x1p-1074, 0, 0x1p-1074, 0, -1, 1 - 0x1p-52, -1, 1}},
                      {"no point", {0, 0, 0, 0, 1, 0, 0, 1}},
                      {"opposite each other", {1, 2, 3, 4, -2, -4, -6, -8}}}}}};
}

}  // namespace gradus::stress
