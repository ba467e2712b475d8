#pragma once
// What roundings take from the points of a curve, plain and compensated, along t: beside the exact points.

#include "core/arithmetic/exact_scalar.hpp"
#include "modeling/bezier_curve/compensated.hpp"
#include "stories/modeling/bezier_curve/drawing.hpp"

namespace gradus::bezier_curve {

class RoundingsDrawing {
 public:
  explicit RoundingsDrawing(const Subject& subject)
      : t_(subject.t),
        unit_(0x1p-53 * std::max(largest_of<2, double>(Polygon<2, double>(subject.control)), 1e-300)) {
    for (int k = 0; k <= pieces; ++k) add(subject.control, static_cast<double>(k) / pieces);
    double most = 1;
    for (const Measured& at : measured_) most = std::max({most, at.plain, at.compensated});
    most_ = std::ceil(most);
    plot_ = Panel(place, {{0, 0}, {1, most_}}, Panel::Fit::stretched);
  }

  void add_to(View& view, const Words& words) const {
    add_axes(view, plot_, "x plot", {words.symbol("t"), words.say("off", {{"unit", unit_}})}, 4);
    view.add({"y t", Role::measure, Stroke{plot_.at({t_, 0}), plot_.at({t_, most_}), false, true}});
    for (std::size_t k = 0; k < measured_.size(); ++k) {
      const auto& [t, plain, compensated] = measured_[k];
      view.add({fmt::format("v plain {:02}", k), Role::rejected, Dot{plot_.at({t, plain})}});
      view.add({fmt::format("w compensated {:02}", k), Role::accepted, Dot{plot_.at({t, compensated})}});
    }
  }

 private:
  static constexpr int pieces = 40;
  static constexpr Extent place{{24.5, 6}, {35, 26.5}};

  struct Measured {
    double t, plain, compensated;  ///< in parts of the unit
  };

  void add(const Control& control, double t) {
    const ExactScope scope;
    Points<2, Exact> exact;
    for (const dvec2 p : control) exact.push_back({Exact(p.x), Exact(p.y)});
    const auto right = de_casteljau<2, Exact>(Polygon<2, Exact>(exact), Exact(t));
    const auto off = [&](dvec2 p) {
      return std::max(to_double(abs(Exact(p.x) - right.x)), to_double(abs(Exact(p.y) - right.y))) / unit_;
    };
    measured_.push_back({t, off(point_at(control, t)), off(compensated<2>(control, t))});
  }

  double t_, unit_, most_ = 1;
  std::vector<Measured> measured_;
  Panel plot_{place, {}};
};

}  // namespace gradus::bezier_curve
