#pragma once
// What all stories of B-splines draw: the control points with their polygon, the curve with the places of its
// knots, and below them the knots on a scale.

#include "modeling/b_spline/b_spline.hpp"
#include "stories/telling.hpp"

namespace gradus::b_spline {

using Control = Points<2, double>;
using Knots = std::vector<double>;

constexpr int paper_width = 36, paper_height = 27;

/// What a run is about. Weights: those of a rational curve, else none.
struct Subject {
  Control control;
  Knots knots, weights{};
  double t = 0;

  Spline<2, double> spline() const { return {control, knots}; }
  Index degree() const { return spline().degree(); }
  dvec2 at(double where) const {
    return weights.empty() ? de_boor(spline(), where) : nurbs<2, double>(spline(), weights, where);
  }
};

/// "P2", "Q1", "R0": the point i of a round.
inline std::string name_of(Index round, Index i) {
  return fmt::format("{}{}", static_cast<char>('P' + static_cast<char>(round)), i);
}

/// How much of the way from one knot to the other t has gone.
inline double share_of(double lo, double t, double hi) { return (t - lo) / (hi - lo); }

/// To which of its two neighbours a point lies nearer.
inline Decision nearer(const Words& words, double share, const std::string& name, const std::string& first,
                       const std::string& second) {
  const std::size_t answer = share < 0.5 ? 0 : share > 0.5 ? 1 : 2;
  return {words.say("question.nearer", {{"name", name}}),
          {first, second, words.say("neither")},
          answer,
          std::array{"first", "second", "middle"}[answer]};
}

/// Places from one to the other; what is reached from one side only is not jumped over.
inline Knots places(double from, double to, int pieces) {
  Knots all;
  for (int k = 0; k < pieces; ++k) all.push_back(std::min(from + (to - from) * k / pieces, to));
  all.push_back(std::max(from, std::nextafter(to, from)));
  return all;
}

inline Extent extent_of(const Control& points) {
  Extent extent;
  for (const dvec2 p : points) extent.add(p);
  return extent;
}

/// The curve with its polygon above its knots.
class SplineDrawing {
 public:
  SplineDrawing(const Subject& subject, const Extent& place)
      : SplineDrawing(subject, Panel(place, extent_of(subject.control))) {}
  /// In the panel of another one.
  SplineDrawing(const Subject& subject, const Panel& panel)
      : subject_(subject), panel_(panel), line_({5, 2.4}, {31.5, 2.4}, first(), last()) {}

  const Panel& panel() const { return panel_; }
  dvec2 at(dvec2 p) const { return panel_.at(p); }
  Path path(const Control& points, bool dashed = false) const { return {panel_.at(points), false, dashed}; }

  /// turn: how many polygons were there before.
  void add_polygon(View& view, bool named = true, Index turn = 0) const {
    view.add({"a polygon", Role::input, path(subject_.control)});
    for (Index i = 0; i < subject_.control.size(); ++i) {
      const dvec2 p = at(subject_.control[i]);
      view.add({fmt::format("a point {:02}", i), Role::input, Dot{p, true}});
      if (named) view.add({fmt::format("a point {:02} name", i), Role::input, Label{p, name_of(turn, i)}});
    }
  }
  /// Its part between two numbers of t, piece by piece: it may jump at knots.
  void add_curve(View& view, const std::string& id, Role role, double from, double to) const {
    const Knots& u = subject_.knots;
    for (Index k = subject_.degree(); k < subject_.control.size(); ++k) {
      const double a = std::max(from, u[k]), b = std::min(to, u[k + 1]);
      if (!(a < b)) continue;
      Control points;
      for (const double t : places(a, b, 48)) points.push_back(subject_.at(t));
      view.add({fmt::format("{} {:02}", id, k), role, path(points)});
    }
  }
  /// All of it, and where one piece ends and the next begins.
  void add_curve(View& view) const {
    const Spline<2, double> spline = subject_.spline();
    add_curve(view, "b curve", Role::accepted, spline.begin(), spline.end());
    for (Index i = subject_.degree() + 1; i < subject_.control.size(); ++i)
      view.add({fmt::format("b joint {:02}", i), Role::boundary, Dot{at(subject_.at(subject_.knots[i]))}});
  }

  /// The knots on their scale, equal ones one above the other; between lo and hi t divides it.
  void add_knots(View& view, const Words& words, std::optional<std::pair<double, double>> around = {}) const {
    line_.add_to(view, "x knots", words.symbol("t"), 4);
    for (Index i = 0; i < subject_.knots.size(); ++i)
      view.add({fmt::format("x knot {:02}", i), Role::boundary, Dot{knot(i)}});
    const double t = subject_.t;
    if (around) {
      view.add({"y around", Role::current, Stroke{line_.at(around->first), line_.at(around->second)}});
      if (around->first < t)
        view.add({"y share", Role::measure, Stroke{line_.at(around->first), line_.at(t), true}});
    }
    view.add({"z t", Role::measure, Dot{line_.at(t)}});
  }
  dvec2 place_of_t() const { return line_.at(subject_.t); }
  /// Where it goes when it grows by 1.
  dvec2 along() const { return (line_.at(last()) - line_.at(first())) / (last() - first()); }
  void let_drag(Narrator& narrator) const {
    narrator.handles("control", shown_in(panel_));
    narrator.handle("t", 0, place_of_t(), along());
    for (Index i = 0; i < subject_.knots.size(); ++i)
      narrator.handle("knots", static_cast<int>(i), knot(i), along());
  }

 private:
  double first() const { return subject_.knots.front(); }
  double last() const { return subject_.knots.back(); }
  dvec2 knot(Index i) const {
    const auto first_equal = std::ranges::lower_bound(subject_.knots, subject_.knots[i]);
    const auto before = first_equal - subject_.knots.begin();
    constexpr double apart = 0.75;
    return line_.at(subject_.knots[i]) +
           dvec2{0, apart * static_cast<double>(static_cast<std::ptrdiff_t>(i) - before + 1)};
  }

  const Subject& subject_;
  Panel panel_;
  NumberLine line_;
};

}  // namespace gradus::b_spline
