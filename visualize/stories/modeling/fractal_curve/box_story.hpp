#pragma once
// A curve under boxes, smaller and smaller, and how their number grows: in logarithms a line, whose slope is
// the dimension.

#include "modeling/fractal_curve/box_count.hpp"
#include "stories/modeling/fractal_curve/subject.hpp"

namespace gradus::fractal_curve {

/// The base is so many units long: enough for all sizes of boxes to be whole, and corners are rounded once to
/// them.
constexpr Whole units = 2 * 243 * 256;

/// A curve in such units, the first end of its base at 0.
struct Measured {
  std::vector<Line> lines{};
  std::vector<Whole> sides{};  ///< of boxes
  int divide = 3;              ///< how many of the next smaller boxes lie along a side
  Extent shown{};              ///< the curve and the largest boxes

  Measured(const Subject& subject, int by) : divide(by) {
    const double length = length_between(subject.base.a, subject.base.b);
    const auto in_units = [&](dvec2 p) {
      const dvec2 off = static_cast<double>(units) / length * (p - subject.base.a);
      return Box{std::llround(off.x), std::llround(off.y)};
    };
    const Way way = subject.way(subject.level);
    for (Index i = 0; i + 1 < way.size(); ++i) lines.push_back({in_units(way[i]), in_units(way[i + 1])});
    // As small as the segments, and three sizes at least
    constexpr int least = 3;
    for (int k = 1; k <= least || power(by, k) <= power(3, subject.level); ++k)
      sides.push_back(units / power(by, k));
    for (const dvec2 p : way) shown.add(p);
    Boxes largest;
    for (const Line& line : lines) cover(line, sides[0], largest);
    for (const Box box : largest) {
      const Extent place = place_of(box, sides[0], subject.base);
      shown.add(place.lower);
      shown.add(place.upper);
    }
  }
  /// What a box covers of the plane.
  static Extent place_of(Box box, Whole side, const Segment<2, double>& base) {
    const double size =
        static_cast<double>(side) / static_cast<double>(units) * length_between(base.a, base.b);
    const dvec2 lower = base.a + size * dvec2(box);
    return {lower, lower + size};
  }
};

class BoxStory : public Past<steps::Started, SideCounted, AllCounted> {
 public:
  BoxStory(const Words& words, const Subject& subject, const Measured& measured, const Panel& panel)
      : words_(words),
        subject_(subject),
        panel_(panel),
        counts_(box_count(measured.lines, measured.sides)),
        divide_(measured.divide),
        chart_(subject.closed() ? Extent{{24, 4.5}, {34.5, 19}} : Extent{{8, 3}, {29, 12.6}},
               {{0, 0}, shown_at(counts_.back())}, Panel::Fit::stretched) {}

  Fit fit() const { return fitted(counts_); }

  Event say(const steps::Started&) const {
    return {.text = "boxes.started",
            .words = {{"segments", subject_.segments(subject_.level)}, {"divide", divide_}}};
  }
  Event say(const SideCounted& s) const {
    const Count count{s.side, std::ssize(s.met)};
    const dvec2 p = shown_at(count);
    Event event{.text = "side_counted.first",
                .facts = {{"boxes", count.boxes}},
                .words = {{"side", side_of(s.side)}},
                .row = {side_of(s.side), count.boxes, p.x, p.y},
                .key = side_of(s.side),
                .phase = words_.say("phase.boxes")};
    if (const Index done = all<SideCounted>().size(); done > 1) {
      const auto before = static_cast<double>(counts_[done - 2].boxes);
      event.text = "side_counted";
      event.words.push_back({"factor", static_cast<double>(count.boxes) / before});
    }
    return event;
  }
  Event say(const AllCounted&) const {
    const Fit line = fit();
    const double own = similarity_dimension(4, 3), off = std::abs(line.slope - own);
    return {.text = "all_counted",
            .facts = {{"dimension", line.slope}, {"error", line.error}},
            .words = {{"slope", line.slope}, {"own", own}},
            .ends = true,
            .decides = yes_or_no(words_, "question.within", {}, off <= 2 * line.error, "within", "beyond")};
  }
  double tells(const auto& step) const {
    return std::same_as<std::decay_t<decltype(step)>, AllCounted> ? 1 : 0;
  }

  View draw() const {
    View view;
    view.add({"c curve", Role::input, Path{panel_.at(subject_.way(subject_.level))}});
    if (all<SideCounted>().empty()) {
      view.add({"d first", Role::input, Dot{panel_.at(subject_.base.a), true}});
      view.add({"d last", Role::input, Dot{panel_.at(subject_.base.b), true}});
    } else {
      // At the end those of the second size: the last ones are too small to be seen
      const Index which = now<AllCounted>() ? 1 : all<SideCounted>().size() - 1;
      add_boxes(view, all<SideCounted>()[which]);
    }
    add_chart(view);
    return view;
  }

 private:
  /// log 1/side, the base being 1, and log boxes.
  static dvec2 shown_at(const Count& count) {
    return {gradus::log(static_cast<double>(units) / static_cast<double>(count.side)),
            gradus::log(static_cast<double>(count.boxes))};
  }
  static std::string side_of(Whole side) { return fraction_of(side, units); }
  void add_boxes(View& view, const SideCounted& s) const {
    constexpr Index most_outlined = 120;
    Area area;
    for (const Box box : s.met) {
      area.rings.push_back(panel_.at(Measured::place_of(box, s.side, subject_.base).corners()));
      if (s.met.size() <= most_outlined)
        view.add({fmt::format("b box {:04} {:04}", box.x + 1000, box.y + 1000), Role::accepted,
                  Path{area.rings.back(), true}});
    }
    view.add({"a boxes", Role::accepted, std::move(area)});
  }
  void add_chart(View& view) const {
    add_axes(view, chart_, "p", {words_.say("axis.size"), words_.say("axis.boxes")}, 4);
    const Index done = all<SideCounted>().size();
    for (Index k = 0; k < done; ++k) {
      const bool at_hand = now<SideCounted>() && k + 1 == done;
      view.add({fmt::format("q count {}", k), at_hand ? Role::current : Role::measure,
                Dot{chart_.at(shown_at(counts_[k]))}});
    }
    if (!now<AllCounted>()) return;
    const Fit line = fit();
    const double end = shown_at(counts_.back()).x, shift = gradus::log(static_cast<double>(units));
    const auto on_line = [&](double x) { return dvec2{x, line.at_0 + line.slope * (x - shift)}; };
    view.add({"p line", Role::result, Stroke{chart_.at(on_line(0)), chart_.at(on_line(end))}});
    const dvec2 place{chart_.place().lower.x + 1, chart_.place().upper.y + 1.4};
    view.add({"r slope", Role::result,
              Text{place, words_.say("slope", {{"slope", line.slope}, {"error", line.error}}), Align::left}});
  }

  const Words& words_;
  const Subject& subject_;
  const Panel& panel_;
  const std::vector<Count> counts_;
  const int divide_;
  const Panel chart_;
};

}  // namespace gradus::fractal_curve
