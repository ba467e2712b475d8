// The promises of Cohen and Sutherland's clipping in the plane.

#include "clipping/cohen_sutherland_2d/cohen_sutherland_2d.hpp"

#include "clipping/cohen_sutherland_2d/cohen_sutherland_2d_batch.hpp"
#include "stress/clipping/axis_boxes.hpp"

namespace gradus::stress {
namespace {

constexpr auto correctly_rounded = [](const auto& line, const auto& window, const auto& order) {
  return cohen_sutherland_2d::correctly_rounded(line, window, order);
};
constexpr auto cut_of_a_cut = [](const auto& line, const auto& window, const auto& order) {
  return cohen_sutherland_2d::cut_of_a_cut(line, window, order);
};
constexpr auto batch = [](const auto& lines, const auto& window, auto& clipped, auto& accepted) {
  return cohen_sutherland_2d::clip_batch(lines, window, clipped, accepted);
};

/// How often the line is cut; nothing where a watcher changes what is left.
std::optional<int> cuts_of(const axis_boxes::Clip<2>& of) {
  int cuts = 0;
  const auto count = [&]<class Step>(const Step&) {
    cuts += std::same_as<Step, cohen_sutherland_2d::Cut<double>>;
  };
  const auto watched = cohen_sutherland_2d::correctly_rounded(of.line, of.box, usual_order<2>(), count);
  if (!test::same_bits(watched, correctly_rounded(of.line, of.box, usual_order<2>()))) return std::nullopt;
  return cuts;
}

Property four_cuts() {
  Property cuts = axis_boxes::promise<2>(
      "cuts", "at most four, and watching changes nothing", "correctly_rounded", [](const Input& i) {
        return !axis_boxes::is_taken<2>(i) || cuts_of(axis_boxes::clip_of<2>(i)).value_or(5) <= 4 ? 0 : wrong;
      });
  cuts.shares = {axis_boxes::share<2>("three cuts", 0.003, [](const auto& of) { return cuts_of(of) == 3; }),
                 axis_boxes::share<2>("four cuts", 0.0003, [](const auto& of) { return cuts_of(of) == 4; })};
  return cuts;
}

}  // namespace

Domain cohen_sutherland_2d() {
  auto all =
      axis_boxes::promises<2>("", "correctly_rounded", correctly_rounded, "cut_of_a_cut", cut_of_a_cut);
  all.push_back(axis_boxes::batch_promise<2>(batch, correctly_rounded));
  all.push_back(four_cuts());
  return {"cohen_sutherland_2d", all};
}

}  // namespace gradus::stress
