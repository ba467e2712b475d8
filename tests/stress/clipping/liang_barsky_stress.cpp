// The promises of Liang and Barsky's clipping to a window and to a box.

#include "clipping/liang_barsky/liang_barsky.hpp"

#include "clipping/cohen_sutherland_2d/cohen_sutherland_2d.hpp"
#include "clipping/cohen_sutherland_3d/cohen_sutherland_3d.hpp"
#include "clipping/liang_barsky/liang_barsky_box.hpp"
#include "stress/clipping/axis_boxes.hpp"

namespace gradus::stress {
namespace {

constexpr auto correctly_rounded = [](const auto& line, const auto& window, const auto& order) {
  return liang_barsky::correctly_rounded(line, window, order);
};
constexpr auto parametric = [](const auto& line, const auto& window, const auto& order) {
  return liang_barsky::parametric(line, window, order);
};
constexpr auto box_correctly_rounded = [](const auto& line, const auto& box, const auto& order) {
  return liang_barsky::box_correctly_rounded(line, box, order);
};
constexpr auto box_parametric = [](const auto& line, const auto& box, const auto& order) {
  return liang_barsky::box_parametric(line, box, order);
};

/// 0 where region codes leave the same.
double window_agreement(const Input& i) {
  if (!axis_boxes::is_taken<2>(i)) return 0;
  const auto [line, window] = axis_boxes::clip_of<2>(i);
  return test::same_bits(liang_barsky::correctly_rounded(line, window),
                         cohen_sutherland_2d::correctly_rounded(line, window))
             ? 0
             : wrong;
}
double box_agreement(const Input& i) {
  if (!axis_boxes::is_taken<3>(i)) return 0;
  const auto [line, box] = axis_boxes::clip_of<3>(i);
  return liang_barsky::box_correctly_rounded(line, box) == cohen_sutherland_3d::correctly_rounded(line, box)
             ? 0
             : wrong;
}

/// What rounded values of t cost: the ends lie beside the borders, and clipping again moves them.
template <int N, class Method>
Share beside(Method method, double least) {
  return axis_boxes::share<N>("ends outside", least, [=](const axis_boxes::Clip<N>& of) {
    const auto found = method(of.line, of.box, usual_order<N>());
    return found && !axis_boxes::lies_in(*found, of.box);
  });
}

}  // namespace

Domain liang_barsky() {
  auto all = axis_boxes::promises<2>("", "correctly_rounded", correctly_rounded, "parametric", parametric);
  all.back().shares.push_back(beside<2>(parametric, 0.01));
  all.back().shares.push_back(axis_boxes::share<2>("another clip moves an end", 0.01, [](const auto& of) {
    const auto found = liang_barsky::parametric(of.line, of.box);
    return found && liang_barsky::parametric(*found, of.box) != found;
  }));
  all.push_back(axis_boxes::promise<2>("agreement", "the bits of Cohen and Sutherland's", "correctly_rounded",
                                       window_agreement));
  auto of_boxes = axis_boxes::promises<3>("box_", "box_correctly_rounded", box_correctly_rounded,
                                          "box_parametric", box_parametric);
  of_boxes.back().shares.push_back(beside<3>(box_parametric, 0.01));
  of_boxes.push_back(axis_boxes::promise<3>("box_agreement", "what Cohen and Sutherland's leaves",
                                            "box_correctly_rounded", box_agreement));
  for (Property& one : of_boxes) {
    one.arguments = nullptr;  // no figure of the topic takes a box
    all.push_back(std::move(one));
  }
  return {"liang_barsky", all};
}

}  // namespace gradus::stress
