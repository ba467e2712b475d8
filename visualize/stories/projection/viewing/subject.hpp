#pragma once
// What a view is about: an eye and what it looks at, or given axes, and the letter that is seen.

#include "core/geometry.hpp"
#include "projection/viewing/viewing.hpp"
#include "projection/viewing/viewing_notes.hpp"
#include "scene/models/obj.hpp"
#include "stories/telling.hpp"

namespace gradus::viewing {

using DFrame = Frame<double>;

constexpr std::array<std::string_view, 3> axis_names{"right", "up", "forward"};
constexpr std::array world_axes{std::pair{"x", dvec3{1, 0, 0}}, std::pair{"y", dvec3{0, 1, 0}},
                                std::pair{"z", dvec3{0, 0, 1}}};

/// What the reader calls the directions right, up and forward.
inline std::string direction_name(const Words& words, int number) {
  const std::string own = words.say(fmt::format("name.{}", axis_names[static_cast<std::size_t>(number)]));
  return number == 2 ? words.notation().forward_name(own) : words.notation().axis_name(number, own);
}
/// The same of the axes of view space: the third one may point backward.
inline std::string axis_name(const Words& words, int number) {
  const std::string own = words.say(fmt::format("name.{}", axis_names[static_cast<std::size_t>(number)]));
  return words.notation().axis_name(number, own);
}

/// Of coordinates: farther away the letter is a dot, and numbers don't fit.
constexpr Sizes coordinate_sizes{1e-100, 1e6};

/// Axes that are much shorter or longer don't fit into a drawing with the letter.
constexpr double longest_axis = 1000;

/// What is made of a hint for up along the view.
enum class Along { refused, replaced, divided };

struct Subject {
  dvec3 eye, target, up;
  double distance;  ///< from the eye to the target
  Mesh letter;
  std::optional<DFrame> axes{};  ///< given ones, of any lengths and angles, instead of target and up
  Along along = Along::refused;

  /// The frame at the eye.
  DFrame frame() const {
    return axes ? *axes : aimed([](const auto&) {});
  }
  /// The same, watched.
  template <class O>
  DFrame aimed(O&& observer) const {
    if (along == Along::replaced) return spare_up(eye, target, up, observer);
    if (along == Along::divided) return cross_products(eye, target, up, observer);
    return look_at(eye, target, up, observer);
  }
};

inline Mesh shipped_letter() {
  const auto open = [](const std::string& name) { return std::optional(std::string(shipped_model(name))); };
  return pipeline::parse_obj(shipped_model("letter_f.obj"), "letter_f.obj", open).mesh;
}

/// An eye with three axes of any lengths and angles.
inline Subject subject_of_axes(const Arguments& arguments) {
  const dvec3 eye = *arguments.place("eye");
  const auto axes = arguments.places("axes");
  const auto expect = [&](bool holds, const std::string& what) {
    if (!holds) refuse("axes", "{} expected, found {}", what, arguments.text("axes"));
  };
  for (const dvec3 axis : axes) {
    const double length = length_of(axis);
    expect(1 / longest_axis <= length && length <= longest_axis,
           fmt::format("axes of lengths from {} to {}", 1 / longest_axis, longest_axis));
  }
  const DFrame frame{eye, axes[0], axes[1], axes[2]};
  const auto [x, y, z] = Rescaled<double>(frame).scaled;
  expect(std::abs(glm::dot(x, glm::cross(y, z))) > 1e-6, "three axes that don't lie in one plane");
  const dvec3 middle{0.4, 0.6, 0};  // of the letter
  return {eye, middle, {0, 1, 0}, std::max(1.0, length_of(middle - eye)), shipped_letter(), frame};
}

inline Subject subject_of(const Arguments& arguments, Along along) {
  Subject subject{*arguments.place("eye"), *arguments.place("target"), *arguments.place("up"), 0, {}};
  subject.along = along;
  if (subject.eye == subject.target)
    refuse(arguments, {"target", "eye"}, "a target apart from the eye expected, found both in one point");
  if (subject.up == dvec3{0})
    refuse(arguments, {"up"}, "a direction expected, found 0,0,0, which points nowhere");
  const double sine = sine_between(subject.target - subject.eye, subject.up);
  if (along == Along::divided && !is_finite(subject.frame().right))
    refuse(arguments, {"up", "target", "eye"},
           "a hint for up that leaves something to divide by expected, this one gives 0 / 0");
  if (along == Along::refused && !(sine >= least_sine<double>)) {
    refuse(arguments, {"up", "target", "eye"},
           fmt::format("an up apart from the view direction expected, found {}, which is parallel to it",
                       arguments.text("up")));
  }
  subject.distance = length_of(subject.target - subject.eye);
  subject.letter = shipped_letter();
  return subject;
}

}  // namespace gradus::viewing
