#include "plot/chart.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/contract.hpp"
#include "figure/layout/layout.hpp"
#include "figure/text/metrics.hpp"
#include "plot/names.hpp"

namespace gradus::plot {
namespace {

using layout::Pen;

constexpr double axis_size = layout::text_size, name_size = 22, advice_size = 24, dot_radius = 9;
constexpr double widest_marker = 1.35;              ///< times the radius: a diamond
constexpr double name_height = 26, name_line = 29;  ///< of a name, and from one to the next in a column
constexpr double name_air = 5;                      ///< on both sides, so that two names in a row come apart
constexpr double names_gap = 52;                    ///< from the curves' ends to that column

/// A logarithmic axis in pixels.
struct Scale {
  double least, most;  ///< powers of ten
  double from, to;

  double at(double value) const { return from + (std::log10(value) - least) / (most - least) * (to - from); }
};

/// The logarithms between which the values lie, with two powers of ten at least among them.
std::pair<double, double> decades(const std::vector<double>& values) {
  double least = std::numeric_limits<double>::infinity(), most = -least;
  for (const double value : values) {
    if (value <= 0) continue;
    least = std::min(least, std::log10(value));
    most = std::max(most, std::log10(value));
  }
  if (least > most) return {0, 1};
  // A little air, so that no point lies on an axis
  least = std::floor(2 * least - 0.2) / 2;
  most = std::ceil(2 * most + 0.2) / 2;
  while (std::floor(most) - std::ceil(least) < 1) {
    if (most - std::floor(most) >= std::ceil(least) - least) {
      most = std::floor(most) + 1;
    } else {
      least = std::ceil(least) - 1;
    }
  }
  return {least, most};
}

/// "10⁻⁵".
std::string power_text(int exponent) {
  static const char* const digits[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string text = exponent < 0 ? "10⁻" : "10";
  for (const char digit : fmt::format("{}", std::abs(exponent))) text += digits[digit - '0'];
  return text;
}

/// A point that is named beside it, and how far its marker reaches.
struct Anchor {
  std::string name;
  Style style;
  dvec2 at;
  double reach;
};

/// Draws one chart.
class Drawing {
 public:
  Drawing(const Chart& chart, double width, double height)
      : chart_(chart), s_(std::min(width, height) / 720) {
    sheet_.width = width;
    sheet_.height = height;
    sheet_.unit = s_;
    set_scales();
  }

  Sheet drawn() {
    draw_title();
    draw_axes();
    draw_curves();
    draw_front();
    draw_dots();
    name_points();
    draw_foot();
    return std::move(sheet_);
  }

 private:
  Pen pen(Slot slot) { return {sheet_, slot, s_}; }

  void set_scales() {
    std::vector<double> xs, ys;
    for (const Dot& dot : chart_.dots) {
      expects(std::isfinite(dot.at.x) && dot.at.x > 0 && std::isfinite(dot.at.y) && dot.at.y >= 0,
              "a dot needs x > 0 and y >= 0, not {}, {}", dot.at.x, dot.at.y);
      xs.push_back(dot.at.x);
      ys.push_back(dot.at.y);
    }
    for (const Curve& curve : chart_.curves) {
      for (const dvec2 p : curve.points) {
        expects(std::isfinite(p.x) && p.x > 0 && std::isfinite(p.y) && p.y > 0,
                "a curve needs x, y > 0, not {}, {}", p.x, p.y);
        xs.push_back(p.x);
        ys.push_back(p.y);
      }
    }
    expects(!xs.empty(), "a chart needs a dot or a curve");
    zeros_ = std::ranges::count(ys, 0.0) > 0;
    zeros_alone_ = std::ranges::count(ys, 0.0) == std::ssize(ys);
    // Names of curves stand in a column beside them
    double names = 40 * s_;
    for (const Curve& curve : chart_.curves) {
      last_ = curve.points.empty() ? last_ : std::max(last_, curve.points.back().x);
    }
    for (const Curve& curve : chart_.curves) {
      if (!named_in_column(curve)) continue;
      names = std::max(
          names, text_width(curve.name, name_face(curve.style), name_size * s_) + (names_gap + 40) * s_);
    }
    const double left = 104 * s_, right = sheet_.width - names, top = 142 * s_;
    const double bottom = sheet_.height - (chart_.advice.empty() ? 116 : 150) * s_;
    place_ = {left, top, right - left, bottom - top};
    // The row of zeros stands below the axis
    zero_row_ = zeros_alone_ ? (top + bottom) / 2 : bottom - 28 * s_;
    const auto [x_least, x_most] = decades(xs);
    const auto [y_least, y_most] = decades(ys);
    x_ = {x_least, x_most, left, right};
    y_ = {y_least, y_most, zeros_ ? zero_rule() : bottom, top};
  }

  double zero_rule() const { return zero_row_ - 34 * s_; }
  dvec2 at(dvec2 p) const { return {x_.at(p.x), p.y == 0 ? zero_row_ : y_.at(p.y)}; }
  static Face name_face(const Style& style) { return style.chosen ? Face::bold : Face::sans; }

  TextShape text(dvec2 baseline, std::string words, Align align, Paint paint, Face face, double size) const {
    return {baseline, std::move(words), face, size * s_, align, paint, true, Paint::of(Tone::paper)};
  }

  void draw_title() {
    Pen p = pen(Slot::title);
    p.text("title", text({40 * s_, 50 * s_}, chart_.title, Align::left, Paint::of(Tone::ink), Face::bold,
                         layout::title_size));
    p.text("subtitle", text({40 * s_, 84 * s_}, chart_.subtitle, Align::left, Paint::of(Tone::muted),
                            Face::sans, name_size));
  }

  void draw_axes() {
    Pen p = pen(Slot::drawing);
    const Paint rule = Paint::of(Tone::rule), muted = Paint::of(Tone::muted), ink = Paint::of(Tone::ink);
    StrokesShape grid{{}, rule, 1 * s_}, ticks{{}, muted, 1.2 * s_};
    each_power(x_, [&](int e, double x) {
      grid.segments.push_back({{x, place_.y}, {x, place_.bottom()}});
      p.text(fmt::format("x {}", e), text({x, place_.bottom() + 28 * s_}, power_text(e), Align::centre, muted,
                                          Face::sans, axis_size));
    });
    each_tick(x_, [&](double x, double length) {
      ticks.segments.push_back({{x, place_.bottom()}, {x, place_.bottom() - length}});
    });
    if (!zeros_alone_) {
      each_power(y_, [&](int e, double y) {
        grid.segments.push_back({{place_.x, y}, {place_.right(), y}});
        p.text(fmt::format("y {}", e), text({place_.x - 12 * s_, y + 7 * s_}, power_text(e), Align::right,
                                            muted, Face::sans, axis_size));
      });
      each_tick(y_, [&](double y, double length) {
        ticks.segments.push_back({{place_.x, y}, {place_.x + length, y}});
      });
    }
    if (zeros_) {
      if (!zeros_alone_)
        p.line("zeros", {{{place_.x, zero_rule()}, {place_.right(), zero_rule()}}, muted, 1.5 * s_});
      p.text("zero", text({place_.x - 12 * s_, zero_row_ + 7 * s_}, chart_.y.zero, Align::right, muted,
                          Face::sans, axis_size));
    }
    p.strokes("grid", std::move(grid));
    p.strokes("ticks", std::move(ticks));
    p.rect("place",
           {.box = place_, .fill = {}, .stroke = muted, .stroke_width = 1.5 * s_, .hatch_paint = {}});
    p.text("x axis", text({place_.right(), place_.bottom() + 60 * s_}, chart_.x.label, Align::right, ink,
                          Face::bold, axis_size));
    p.text("y axis",
           text({40 * s_, place_.y - 20 * s_}, chart_.y.label, Align::left, ink, Face::bold, axis_size));
  }

  /// The powers of ten that get a line and a number: of a long axis every other one, or fewer.
  template <class F>
  static void each_power(const Scale& scale, F&& power) {
    const int low = static_cast<int>(std::ceil(scale.least)), high = static_cast<int>(std::floor(scale.most));
    for (int e = low; e <= high; e += 1 + (high - low) / 9) power(e, scale.at(std::pow(10.0, e)));
  }

  /// 2 to 9 times a power, by which a logarithmic axis is known; a long one has no room for them.
  template <class F>
  void each_tick(const Scale& scale, F&& tick) const {
    if (scale.most - scale.least > 7) return;
    for (int e = static_cast<int>(std::floor(scale.least)); e < scale.most; ++e) {
      for (int k = 2; k <= 9; ++k) {
        const double power = e + std::log10(k);
        if (power <= scale.least || power >= scale.most) continue;
        tick(scale.at(std::pow(10.0, power)), (k == 5 ? 9 : 6) * s_);
      }
    }
  }

  void draw_curves() {
    Pen p = pen(Slot::drawing);
    for (const Curve* curve : chosen_last(chart_.curves)) {
      const Style& style = curve->style;
      LineShape line{{}, Paint::mark(style.role), (style.chosen ? 6 : 3) * s_, is_dashed(style)};
      for (const dvec2 point : curve->points) line.points.push_back(at(point));
      for (std::size_t i = 1; i < line.points.size(); ++i)
        strokes_.push_back({line.points[i - 1], line.points[i]});
      p.line("curve " + curve->name, line);
      for (const dvec2 point : line.points) {
        draw_marker(p, "point " + curve->name, style, point, 7 * s_);
        taken_.push_back(box_round(point, 7 * s_));
      }
    }
    name_curves();
  }

  static Box box_round(dvec2 at, double reach) { return {at.x - reach, at.y - reach, 2 * reach, 2 * reach}; }

  static bool is_dashed(const Style& style) { return style.open || style.marker == Marker::cross; }

  /// What shall be seen best is drawn over the others.
  template <class T>
  static std::vector<const T*> chosen_last(const std::vector<T>& all) {
    std::vector<const T*> order;
    for (const T& one : all) order.push_back(&one);
    std::ranges::stable_sort(order, {}, [](const T* one) { return one->style.chosen; });
    return order;
  }

  /// A curve that ends before others do, or is but a point, is named where it ends.
  bool named_in_column(const Curve& curve) const {
    return !curve.name.empty() && curve.points.size() > 1 && curve.points.back().x == last_;
  }

  /// The names beside the curves' ends, moved apart, in the ends' order.
  void name_curves() {
    std::vector<const Curve*> named;
    for (const Curve& curve : chart_.curves) {
      if (named_in_column(curve)) {
        named.push_back(&curve);
      } else if (!curve.name.empty() && !curve.points.empty()) {
        anchors_.push_back({curve.name, curve.style, at(curve.points.back()), widest_marker * 7 * s_});
      }
    }
    const auto end_of = [&](const Curve* curve) { return at(curve->points.back()).y; };
    std::ranges::sort(named, {}, end_of);
    std::vector<double> wanted;
    for (const Curve* curve : named) wanted.push_back(end_of(curve));
    const std::vector<double> rows =
        moved_apart(wanted, name_line * s_, place_.y + 8 * s_, place_.bottom() - 8 * s_);
    Pen p = pen(Slot::drawing);
    const double x = place_.right() + names_gap * s_;
    for (std::size_t i = 0; i < named.size(); ++i) {
      const Style& style = named[i]->style;
      const dvec2 from = at(named[i]->points.back()) + dvec2(12 * s_, 0), to{x - 8 * s_, rows[i]};
      p.line("leader " + named[i]->name, {{from, to}, Paint::mark(style.role), 1.4 * s_});
      p.text("name " + named[i]->name, text({x, rows[i] + 8 * s_}, named[i]->name, Align::left,
                                            Paint::text(style.role), name_face(style), name_size));
    }
  }

  void draw_front() {
    std::vector<dvec2> points;
    for (const Dot& dot : chart_.dots) {
      if (dot.on_front) points.push_back(at(dot.at));
    }
    std::ranges::sort(points, {}, &dvec2::x);
    if (points.size() < 2) return;
    // What lies above and right of the front is beaten: steps, since nothing was measured between
    LineShape line{{}, Paint::of(Tone::muted), 2 * s_, true};
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (i) line.points.push_back({points[i].x, points[i - 1].y});
      line.points.push_back(points[i]);
    }
    for (std::size_t i = 1; i < line.points.size(); ++i)
      strokes_.push_back({line.points[i - 1], line.points[i]});
    pen(Slot::drawing).line("front", std::move(line));
  }

  void draw_dots() {
    Pen p = pen(Slot::drawing);
    for (const Dot* dot : chosen_last(chart_.dots)) {
      const dvec2 centre = at(dot->at);
      const double ring = (dot_radius + (dot->style.chosen ? 9 : 6)) * s_;
      if (dot->on_front)
        p.disc("front " + dot->name, {centre, ring, {}, Paint::mark(dot->style.role), 2.5 * s_});
      draw_marker(p, "dot " + dot->name, dot->style, centre, dot_radius * s_);
      const double reach = dot->on_front ? ring + 2 * s_ : widest_marker * dot_radius * s_;
      taken_.push_back(box_round(centre, reach));
      if (!dot->name.empty()) anchors_.push_back({dot->name, dot->style, centre, reach});
    }
  }

  /// Shapes beside colours, with a rim by which those that overlap come apart: a cross for what is wrong, a
  /// larger disc for what to take.
  void draw_marker(Pen& p, const std::string& id, const Style& style, dvec2 at, double r) const {
    const Paint mark = Paint::mark(style.role), paper = Paint::of(Tone::paper);
    const Paint fill = style.open ? paper : mark, rim = style.open ? mark : paper;
    const double edge = (style.open ? 3 : 1.5) * s_, d = widest_marker * r;
    if (style.chosen) r *= 1.3;
    const auto corners = [&](std::vector<dvec2> ring) {
      for (dvec2& corner : ring) corner = at + d * corner;
      p.area(id, {{ring}, fill, {}, {}});
      p.line(id + " rim", {std::move(ring), rim, edge, false, true});
    };
    switch (style.marker) {
      case Marker::disc:
        return p.disc(id, {at, r, fill, rim, edge});
      case Marker::square:
        return p.rect(id, {.box = {at.x - r, at.y - r, 2 * r, 2 * r},
                           .fill = fill,
                           .stroke = rim,
                           .stroke_width = edge,
                           .hatch_paint = {}});
      case Marker::diamond:
        return corners({{-1, 0}, {0, -1}, {1, 0}, {0, 1}});
      case Marker::triangle:
        return corners({{-1, 0.8}, {0, -1.1}, {1, 0.8}});
      case Marker::cross:
        return p.strokes(id, {{{at - dvec2(r, r), at + dvec2(r, r)}, {at - dvec2(r, -r), at + dvec2(r, -r)}},
                              mark,
                              4 * s_,
                              true});
    }
  }

  /// The names beside their points, with leaders where those stand close.
  void name_points() {
    layout::Obstacles around;
    around.strokes = strokes_;
    around.taken = taken_;
    if (zeros_) around.crowded.push_back({{place_.x, zero_rule() - s_, place_.width, 2 * s_}, 3000});
    std::vector<NamedPoint> points;
    for (const Anchor& anchor : anchors_) {
      const double width = text_width(anchor.name, name_face(anchor.style), name_size * s_);
      points.push_back({anchor.at, anchor.reach, {width + 2 * name_air * s_, name_height * s_}});
    }
    const Box room = layout::grown(place_, -4 * s_);
    const std::vector<layout::PlacedLabel> labels = place_names(points, around, room, s_);
    for (std::size_t i = 0; i < labels.size(); ++i) draw_name(anchors_[i], labels[i]);
  }

  void draw_name(const Anchor& anchor, const layout::PlacedLabel& label) {
    Pen p = pen(Slot::drawing);
    if (label.leader) {
      const dvec2 way = glm::normalize(label.leader->a - anchor.at);
      p.line("leader " + anchor.name, {{label.leader->a - way * 3.0 * s_, anchor.at + way * anchor.reach},
                                       Paint::mark(anchor.style.role),
                                       1.4 * s_});
    }
    p.text("name " + anchor.name,
           text({label.box.x + name_air * s_, label.box.y + 20 * s_}, anchor.name, Align::left,
                Paint::text(anchor.style.role), name_face(anchor.style), name_size));
  }

  void draw_foot() {
    const double width = sheet_.width - 80 * s_;
    if (!chart_.advice.empty())
      pen(Slot::sentence)
          .text("advice", text({40 * s_, sheet_.height - 56 * s_},
                               elided(chart_.advice, Face::bold, advice_size * s_, width), Align::left,
                               Paint::text(Role::current), Face::bold, advice_size));
    pen(Slot::footer)
        .text("footer", text({sheet_.width - 40 * s_, sheet_.height - 22 * s_},
                             elided(chart_.footer, Face::sans, axis_size * s_, width), Align::right,
                             Paint::of(Tone::muted), Face::sans, axis_size));
  }

  const Chart& chart_;
  double s_;
  Sheet sheet_;
  Box place_;
  Scale x_{}, y_{};
  bool zeros_ = false, zeros_alone_ = false;
  double zero_row_ = 0;
  double last_ = 0;  ///< the largest x at which a curve ends
  // What names keep from, and the points that they belong to
  std::vector<Segment<2, double>> strokes_;
  std::vector<Box> taken_;
  std::vector<Anchor> anchors_;
};

}  // namespace

bool has_room_for(std::string_view advice) {
  return text_width(advice, Face::bold, advice_size) <= 1280 - 80;
}

Sheet sheet_of(const Chart& chart, double width, double height) {
  return Drawing(chart, width, height).drawn();
}

}  // namespace gradus::plot
