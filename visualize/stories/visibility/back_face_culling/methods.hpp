#pragma once
// The methods, and what each of them looks at: told, asked for their signs, and counted.

#include "core/arithmetic/counted.hpp"
#include "visibility/back_face_culling/back_face_culling.hpp"

#include "stories/visibility/back_face_culling/drawing.hpp"
#include "visibility/back_face_culling/back_face_culling_notes.hpp"

namespace gradus::back_face_culling {

/// What a method goes by.
enum class By { product, area, determinant, depth };

constexpr auto drop = [](std::size_t) {};

/// The signs that the exact method finds.
inline std::vector<int> exact_signs(const Subject& subject) {
  std::vector<int> signs;
  normal_and_view<double>(spans_of(subject.rings), subject.eye, drop, [&]<class Step>(const Step& step) {
    if constexpr (std::same_as<Step, Judged<double>>) signs.push_back(step.sign);
  });
  return signs;
}

/// What a method looks at.
template <By by>
auto seen_by(const Subject& subject) {
  if constexpr (by == By::area) return subject.outlines();
  if constexpr (by == By::determinant) return subject.clip();
  if constexpr (by == By::depth) return subject.view;
  if constexpr (by == By::product) return subject.rings;
}

/// The numbers that faces are made of.
template <class Faces>
using Scalar = typename Faces::value_type::value_type::value_type;

constexpr auto by_product = []<class F>(const F& faces, const auto&... with) {
  normal_and_view<Scalar<F>>(faces, with...);
};
constexpr auto by_three = []<class F>(const F& faces, const auto&... with) {
  first_three_corners<Scalar<F>>(faces, with...);
};
constexpr auto by_area = []<class F>(const F& faces, const auto&... with) {
  screen_area<Scalar<F>>(faces, with...);
};
constexpr auto by_misprint = []<class F>(const F& faces, const auto&... with) {
  misprinted_shoelace<Scalar<F>>(faces, with...);
};
constexpr auto by_six = []<class F>(const F& faces, const auto&... with) {
  six_products<Scalar<F>>(faces, with...);
};
constexpr auto by_determinant = []<class F>(const F& faces, const auto&... with) {
  homogeneous<Scalar<F>>(faces, with...);
};
constexpr auto by_division = []<class F>(const F& faces, const auto&... with) {
  after_division<Scalar<F>>(faces, with...);
};
constexpr auto by_depth = []<class F>(const F& faces, const auto&... with) {
  eye_space_normal<Scalar<F>>(faces, with...);
};

/// The signs that a method finds; none where corners have no place in its picture.
template <By by, auto method, bool behind_too = false>
std::vector<int> signs_by(const Subject& subject) {
  std::vector<int> signs;
  const auto watch = [&]<class Step>(const Step& step) {
    if constexpr (std::same_as<Step, Judged<double>>) signs.push_back(step.sign);
  };
  const auto has_place = [&](double w) { return behind_too ? w != 0 : w > 1e-6 * subject.radius; };
  if ((by == By::area || behind_too) && !subject.depths_are(has_place)) return signs;
  const auto rings = seen_by<by>(subject);
  if constexpr (by == By::product)
    method(spans_of(rings), subject.eye, drop, watch);
  else
    method(spans_of(rings), drop, watch);
  return signs;
}

/// What a method calculates, whatever is seen.
template <By by, auto method>
std::int64_t operations_by(const Subject& subject) {
  const auto rings = mapped(seen_by<by>(subject), [](const auto& ring) {
    return mapped(
        ring, [](const auto& p) { return glm::vec<std::remove_cvref_t<decltype(p)>::length(), Counted>(p); });
  });
  const Operations operations = operations_of([&] {
    if constexpr (by == By::product)
      method(spans_of(rings), glm::vec<4, Counted>(subject.eye), drop);
    else
      method(spans_of(rings), drop);
  });
  return operations.all();
}

}  // namespace gradus::back_face_culling
