#pragma once
// A circle unrolled into a scale of degrees, with the crossings of a polygon in their order round it.

#include <numbers>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "clipping/polygon_circle/polygon_circle.hpp"
#include "stories/clipping/circle_drawing.hpp"
#include "stories/paper.hpp"

namespace gradus::polygon_circle {

/// What the walk along the boundary looks the next entry up in. Counterclockwise from the first crossing, so
/// that numbers grow to the right.
class UnrolledCircle {
 public:
  UnrolledCircle() = default;
  /// scale: from 0 to 360.
  UnrolledCircle(std::span<const Crossing> crossings, const Disc& circle, NumberLine scale) : scale_(scale) {
    constexpr std::size_t most = 24;  // more can't be told apart
    if (crossings.empty() || crossings.size() > most) return;
    const Unit unit = unit_of(circle.radius);
    const dvec2 first = seen_from(circle.centre, crossings[0].at, unit);
    for (const Crossing& c : crossings) {
      const dvec2 at = seen_from(circle.centre, c.at, unit);
      const double turn = atan2(first.x * at.y - first.y * at.x, first.x * at.x + first.y * at.y);
      const double degrees = turn * 180 / std::numbers::pi;
      places_.push_back({degrees < 0 ? degrees + 360 : degrees, c.leaves});
    }
  }

  /// The scale with a dot where the boundary enters, a ring where it leaves; of those close together the
  /// first has its number.
  void add_to(View& view, const std::string& id) const {
    if (places_.empty()) return;
    View scale;
    scale_->add_to(scale, "order", "°");
    for (const auto& [name, mark] : scale.marks) view.add({id + " " + name, mark.role, mark.shape});
    std::optional<dvec2> numbered;
    for (std::size_t i = 0; i < places_.size(); ++i) {
      const dvec2 at = scale_->at(places_[i].degrees);
      const Role role = places_[i].leaves ? Role::past : Role::candidate;
      const std::string own = fmt::format("{} {:03}", id, i);
      view.add({own, role, Dot{at, places_[i].leaves}});
      if (numbered && at.x - numbered->x < least_distance) continue;
      view.add({own + " number", role, Text{at + dvec2{0, 1.5}, fmt::format("{}", i + 1)}});
      numbered = at;
    }
  }

  /// The arc from an exit to the next entry; one beyond the scale's end goes on at its start.
  void add_arc(View& view, const std::string& id, std::size_t exit, std::size_t entry) const {
    if (std::max(exit, entry) >= places_.size()) return;
    const double from = places_[exit].degrees, to = places_[entry].degrees;
    const auto add = [&](const std::string& own, double a, double b) {
      if (a < b) view.add({own, Role::current, Stroke{scale_->at(a), scale_->at(b)}});
    };
    add(id, from, from < to ? to : 360);
    if (to <= from) add(id + " on", 0, to);
  }

 private:
  static constexpr double least_distance = 1.6;  ///< units of the paper, of two numbers
  struct Place {
    double degrees;
    bool leaves;
  };
  std::optional<NumberLine> scale_;
  std::vector<Place> places_;
};

}  // namespace gradus::polygon_circle
