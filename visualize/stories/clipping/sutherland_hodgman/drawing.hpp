#pragma once
// A polygon and a convex window in the plane: what is given, and what all stories of it draw alike.

#include <tuple>

#include "clipping/sutherland_hodgman/separate_pieces.hpp"
#include "clipping/sutherland_hodgman/sutherland_hodgman.hpp"
#include "core/geometry.hpp"
#include "stories/telling.hpp"

namespace gradus::sutherland_hodgman {

using Points = std::vector<dvec2>;

inline constexpr int plane_width = 36, plane_height = 27;

/// What a run was given.
struct Subject {
  std::vector<Points> rings;                      ///< the outline, and perhaps holes
  std::optional<ConvexWindow<double>> oblique{};  ///< instead of the rectangle
  Rectangle<double> rectangle{};
  std::vector<int> order{};

  const Points& outline() const { return rings[0]; }
  Points window() const {
    if (oblique) return oblique->corners;
    return Extent{rectangle.lower, rectangle.upper}.corners();
  }
  Segment<2, double> border(int number) const {
    return oblique ? line_of(*oblique, number) : line_of(rectangle, number);
  }
};

inline Points places(std::span<const Vertex<double>> ring) {
  Points points;
  for (const Vertex<double>& v : ring) points.push_back(v.at);
  return points;
}

inline double area_of(const Points& ring) {
  double doubled = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const dvec2 a = ring[i] - ring[0], b = ring[i + 1 < ring.size() ? i + 1 : 0] - ring[0];
    doubled += a.x * b.y - a.y * b.x;
  }
  return doubled / 2;
}
inline double area_of(const Piece<double>& piece) {
  double area = area_of(places(piece.outline));
  for (const auto& hole : piece.holes) area += area_of(places(hole));
  return area;
}

/// The plane as the paper shows it.
inline Panel panel_of(const Subject& subject) {
  Extent all;
  for (const Points& ring : subject.rings) {
    for (const dvec2 p : ring) all.add(p);
  }
  for (const dvec2 p : subject.window()) all.add(p);
  return tight_panel({{3, 3}, {plane_width - 1.5, plane_height - 1.2}}, widened(all, 0.015));
}

/// What of a rectangle of the plane lies right of a line: outside a border.
inline Points right_of(const Segment<2, double>& line, const Extent& shown) {
  const dvec2 way = line.b - line.a;
  const auto left = [&](dvec2 p) { return way.x * (p.y - line.a.y) - way.y * (p.x - line.a.x); };
  const Points corners = shown.corners();
  Points ring;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const dvec2 a = corners[i], b = corners[i + 1 < corners.size() ? i + 1 : 0];
    const double from = left(a), to = left(b);
    if (from <= 0) ring.push_back(a);
    if ((from < 0 && to > 0) || (from > 0 && to < 0)) ring.push_back(a + from / (from - to) * (b - a));
  }
  return ring;
}

/// The part of a line that a rectangle of the plane shows.
inline std::optional<Stroke> across(const Segment<2, double>& line, const Extent& shown) {
  const auto [first, last] = span_in(shown, line.a, line.b - line.a, -1e300, 1e300);
  if (!(first < last)) return std::nullopt;
  return Stroke{line.a + first * (line.b - line.a), line.a + last * (line.b - line.a)};
}

/// Names of vertices: those given by their numbers, those made by letters as they come.
class Names {
 public:
  std::string operator()(const Vertex<double>& v) {
    if (!v.made()) return fmt::format("{}", v.input + 1);
    return letter(letters_.insert({{v.edge.id, v.border.id, v.at.x, v.at.y}, letters_.size()}).first->second);
  }

 private:
  std::map<std::tuple<int, int, double, double>, std::size_t> letters_;
};

/// The drawing that a story adds to. What begins with "f " is pointed at by one step alone.
class PlaneDrawing {
 public:
  PlaneDrawing(const Words& words, const Subject& subject)
      : words_(words), subject_(subject), panel_(panel_of(subject)) {
    for (const Points& ring : subject.rings) {
      Ring<double> vertices;
      for (const dvec2 p : ring) vertices.push_back({p, static_cast<int>(vertices.size()), {}, {}, {}});
      rest_.push_back(vertices);
    }
  }

  // Once for all stories: what is asked

  void show(Board& board, const steps::Started&) {
    add_input();
    show_rest("d ring", Role::accepted);
    put(board);
  }
  Event say(const steps::Started&) const {
    std::string order;
    for (const int border : subject_.order) order += (order.empty() ? "" : ", ") + name_of_border(border);
    return {.text = "started",
            .words = {{"corners", subject_.outline().size()}, {"order", order}},
            .level = Level::idea};
  }

 protected:
  /// What a list calls it: "right".
  std::string name_of_border(int border) const { return text_of_border("border.", border); }
  /// What a sentence calls it: "the right border".
  std::string border_in_words(int border) const { return text_of_border("at.", border); }
  std::string phase_of(int border) const { return text_of_border("phase.", border); }

  /// At the first step of a border: what comes to it, and the border itself with all that lies outside.
  bool enter_border(int border) {
    if (border_ == border) return false;
    border_ = border;
    erase("d ");
    show_rest("c ring", Role::accepted);
    const Segment<2, double> line = subject_.border(border);
    view_.add({"a outside", Role::measure, Area{{panel_.at(right_of(line, panel_.shown()))}}});
    if (const auto stroke = across(line, panel_.shown())) add_border(*stroke);
    return true;
  }
  /// At its last step: what is left.
  void pass_border(const std::vector<Ring<double>>& rest) {
    erase("c ");
    erase("d ");
    rest_ = rest;
    show_rest("d ring", Role::result);
  }
  void leave_border() {
    border_.reset();
    erase("a outside");
    erase("b window border");
    erase("e ");
  }

  void mark_side(const Vertex<double>& v, int side) {
    const Role role = side >= 0 ? Role::result : Role::rejected;
    view_.add({"e side " + names_(v), role, Dot{panel_.at(v.at), side < 0}});
  }

  void put(Board& board) const { board.milestone(view_); }
  /// Takes away what the last step pointed at.
  void quiet() { erase("f "); }
  void erase(std::string_view start) {
    std::erase_if(view_.marks, [&](const auto& mark) { return mark.first.starts_with(start); });
  }

  const Words& words_;
  const Subject& subject_;
  const Panel panel_;
  View view_;
  Names names_;

 private:
  std::string text_of_border(std::string_view key, int border) const {
    constexpr std::array<std::string_view, 4> names{"left", "right", "bottom", "top"};
    if (subject_.oblique) return words_.say(fmt::format("{}numbered", key), {{"number", border + 1}});
    return words_.say(fmt::format("{}{}", key, names[static_cast<std::size_t>(border)]));
  }
  /// The border as far as it is seen, and near its upper end which side is which.
  void add_border(const Stroke& seen) {
    const dvec2 from = panel_.at(seen.a), to = panel_.at(seen.b);
    view_.add({"b window border", Role::measure, Stroke{from, to}});
    const dvec2 way = to - from, along = way / length_of(way), outward{along.y, -along.x};
    const bool upward = std::abs(along.y) > std::abs(along.x);
    const dvec2 upper = (upward ? along.y > 0 : along.x > 0) ? to - 1.1 * along : from + 1.1 * along;
    const auto put_side = [&](const char* id, Role role, dvec2 aside, std::string_view key) {
      const Align align = !upward ? Align::right : aside.x > 0 ? Align::left : Align::right;
      view_.add({id, role, Text{upper + (upward ? 0.5 : 0.65) * aside, words_.say(key), align}});
    };
    put_side("b window border in", Role::result, -outward, "side.inside");
    put_side("b window border out", Role::measure, outward, "side.outside");
  }
  void add_input() {
    view_.add({"b window", Role::boundary, Path{panel_.at(subject_.window()), true}});
    add_axes(view_, panel_, "a axes", {words_.symbol("x"), words_.symbol("y")});
    // Of several drawings none has room for numbers beside corners' names
    for (auto& [id, mark] : view_.marks) {
      if (auto* text = std::get_if<Text>(&mark.shape)) text->aside = true;
    }
    if (subject_.oblique) {
      for (const int border : subject_.order) {
        const Segment<2, double> line = subject_.border(border);
        view_.add({fmt::format("b border {:03}", border), Role::boundary,
                   Label{panel_.at(0.5 * line.a + 0.5 * line.b), name_of_border(border)}});
      }
    }
    std::size_t before = 0;  // corners of earlier rings
    for (std::size_t r = 0; r < subject_.rings.size(); ++r) {
      const Points& ring = subject_.rings[r];
      view_.add({fmt::format("b given {}", r), Role::past, Path{panel_.at(ring), true, true}});
      for (std::size_t i = 0; i < ring.size() && ring.size() <= 24; ++i) {
        const std::size_t n = before + i;
        view_.add({fmt::format("b number {:03}", n), Role::input,
                   Label{panel_.at(ring[i]), fmt::format("{}", n + 1)}});
      }
      before += ring.size();
    }
  }
  void show_rest(std::string_view id, Role role) {
    std::vector<Points> all;
    for (std::size_t i = 0; i < rest_.size(); ++i) {
      all.push_back(panel_.at(places(rest_[i])));
      view_.add({fmt::format("{} {:03} line", id, i), role, Path{all.back(), true}});
    }
    if (!all.empty()) view_.add({fmt::format("{} area", id), role, Area{all}});
  }

  std::optional<int> border_;       ///< the one that is cut at
  std::vector<Ring<double>> rest_;  ///< what came to it
};

}  // namespace gradus::sutherland_hodgman
