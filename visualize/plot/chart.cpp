#include "plot/chart.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/contract.hpp"
#include "figure/layout/layout.hpp"
#include "figure/text/metrics.hpp"

namespace gradus::plot {
namespace {

using layout::Pen;

constexpr double text_size = 20, title_size = 34, dot_radius = 9;

/// A logarithmic axis in pixels.
struct Scale {
  double least, most;  ///< powers of ten
  double from, to;

  double at(double value) const { return from + (std::log10(value) - least) / (most - least) * (to - from); }
};

/// The powers of ten between which the values lie, at least one apart.
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
  return {least, std::max(most, least + 1)};
}

/// "0.001", "1", "1000", beyond "10⁻⁵".
std::string power_text(int exponent) {
  if (exponent >= 0 && exponent <= 3) return fmt::format("{}", std::lround(std::pow(10, exponent)));
  if (exponent < 0 && exponent >= -3) return fmt::format("{:.{}f}", std::pow(10, exponent), -exponent);
  static const char* const digits[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string text = exponent < 0 ? "10⁻" : "10";
  for (const char digit : fmt::format("{}", std::abs(exponent))) text += digits[digit - '0'];
  return text;
}

double overlap(const Box& a, const Box& b) {
  const double width = std::min(a.right(), b.right()) - std::max(a.x, b.x);
  const double height = std::min(a.bottom(), b.bottom()) - std::max(a.y, b.y);
  return width > 0 && height > 0 ? width * height : 0;
}

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
    draw_footer();
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
    zeros_ = std::ranges::any_of(chart_.dots, [](const Dot& dot) { return dot.at.y == 0; });
    // Names of curves stand in a column beside them
    double names = 40 * s_;
    bool named = false;
    for (const Curve& curve : chart_.curves) {
      if (curve.name.empty()) continue;
      named = true;
      names = std::max(names, text_width(curve.name, Face::sans, text_size * s_) + 90 * s_);
    }
    const double left = 120 * s_, right = sheet_.width - names, top = 146 * s_;
    const double bottom = sheet_.height - 130 * s_;
    // The row of zeros stands below the axis
    zero_row_ = bottom - 24 * s_;
    const double lowest = zeros_ ? bottom - 66 * s_ : bottom;
    place_ = {left, top, right - left, bottom - top};
    auto [x_least, x_most] = decades(xs);
    // Curves end at the edge beside which their names stand
    if (named) x_most = std::log10(*std::ranges::max_element(xs));
    const auto [y_least, y_most] = decades(ys);
    x_ = {x_least, x_most, left, right};
    y_ = {y_least, y_most, lowest, top};
  }

  dvec2 at(dvec2 p) const { return {x_.at(p.x), p.y == 0 ? zero_row_ : y_.at(p.y)}; }

  TextShape text(dvec2 baseline, std::string words, Align align, Paint paint, Face face = Face::sans,
                 double size = text_size) const {
    return {baseline, std::move(words), face, size * s_, align, paint, true, Paint::of(Tone::paper)};
  }

  void draw_title() {
    Pen p = pen(Slot::title);
    p.text("title",
           text({40 * s_, 54 * s_}, chart_.title, Align::left, Paint::of(Tone::ink), Face::bold, title_size));
    p.text("subtitle",
           text({40 * s_, 88 * s_}, chart_.subtitle, Align::left, Paint::of(Tone::muted), Face::sans, 22));
  }

  void draw_axes() {
    Pen p = pen(Slot::drawing);
    p.rect("place", {.box = place_,
                     .fill = {},
                     .stroke = Paint::of(Tone::rule),
                     .stroke_width = 1.5 * s_,
                     .hatch_paint = {}});
    StrokesShape grid{{}, Paint::of(Tone::rule), 1 * s_};
    for (int e = static_cast<int>(std::ceil(x_.least)); e <= static_cast<int>(std::floor(x_.most)); ++e) {
      const double x = x_.at(std::pow(10.0, e));
      grid.segments.push_back({{x, place_.y}, {x, place_.bottom()}});
      p.text(fmt::format("x {}", e),
             text({x, place_.bottom() + 28 * s_}, power_text(e), Align::centre, Paint::of(Tone::muted)));
    }
    const int low = static_cast<int>(std::ceil(y_.least)), high = static_cast<int>(std::floor(y_.most));
    // A long axis names every other power
    const int stride = 1 + (high - low) / 9;
    for (int e = low; e <= high; e += stride) {
      const double y = y_.at(std::pow(10.0, e));
      grid.segments.push_back({{place_.x, y}, {place_.right(), y}});
      p.text(fmt::format("y {}", e),
             text({place_.x - 10 * s_, y + 7 * s_}, power_text(e), Align::right, Paint::of(Tone::muted)));
    }
    if (zeros_) {
      const double y = zero_row_ - 24 * s_;
      p.line("zeros", {{{place_.x, y}, {place_.right(), y}}, Paint::of(Tone::muted), 1.5 * s_});
      p.text("zero", text({place_.x - 10 * s_, zero_row_ + 7 * s_}, chart_.y.zero, Align::right,
                          Paint::of(Tone::muted)));
    }
    p.strokes("grid", std::move(grid));
    p.text("x axis", text({place_.right(), place_.bottom() + 60 * s_}, chart_.x.label, Align::right,
                          Paint::of(Tone::ink), Face::bold));
    p.text("y axis", text({40 * s_, place_.y - 24 * s_}, chart_.y.label, Align::left, Paint::of(Tone::ink),
                          Face::bold));
  }

  void draw_curves() {
    Pen p = pen(Slot::drawing);
    for (const Curve& curve : chart_.curves) {
      LineShape line{{}, Paint::mark(curve.role), 3 * s_, curve.role == Role::rejected};
      for (const dvec2 point : curve.points) line.points.push_back(at(point));
      for (std::size_t i = 1; i < line.points.size(); ++i)
        strokes_.push_back({line.points[i - 1], line.points[i]});
      for (const dvec2 point : line.points) {
        draw_marker(p, "point " + curve.name, curve.role, point, 6 * s_);
      }
      p.line("curve " + curve.name, std::move(line));
    }
    name_curves();
  }

  /// The names beside the curves' ends, moved apart, in the ends' order.
  void name_curves() {
    struct Name {
      const Curve* curve;
      dvec2 end;
      double y;
    };
    std::vector<Name> names;
    for (const Curve& curve : chart_.curves) {
      if (!curve.points.empty() && !curve.name.empty())
        names.push_back({&curve, at(curve.points.back()), at(curve.points.back()).y});
    }
    std::ranges::sort(names, {}, &Name::y);
    const double line = 28 * s_;
    for (std::size_t i = 1; i < names.size(); ++i) names[i].y = std::max(names[i].y, names[i - 1].y + line);
    // What went too far down goes up again
    double lowest = place_.bottom();
    for (std::size_t i = names.size(); i-- > 0; lowest = names[i].y - line) {
      names[i].y = std::min(names[i].y, lowest);
    }
    Pen p = pen(Slot::drawing);
    for (const Name& name : names) {
      const double x = place_.right() + 60 * s_;
      const Paint paint = Paint::text(name.curve->role);
      p.line("leader " + name.curve->name,
             {{name.end + dvec2(8 * s_, 0), dvec2(x - 8 * s_, name.y)}, paint, 1.4 * s_});
      p.text("name " + name.curve->name, text({x, name.y + 7 * s_}, name.curve->name, Align::left, paint));
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
    for (const Dot& dot : chart_.dots) {
      const dvec2 centre = at(dot.at);
      const double r = (dot_radius + (dot.on_front ? 7 : 0)) * s_;
      taken_.push_back({centre.x - r, centre.y - r, 2 * r, 2 * r});
    }
    for (const Dot& dot : chart_.dots) {
      const dvec2 centre = at(dot.at);
      if (dot.on_front)
        p.disc("front " + dot.name, {centre, (dot_radius + 5) * s_, {}, Paint::mark(dot.role), 2.5 * s_});
      draw_marker(p, "dot " + dot.name, dot.role, centre, dot_radius * s_);
    }
    for (const Dot& dot : chart_.dots) {
      if (!dot.name.empty()) place_label(dot.name, at(dot.at), dot.role);
    }
  }

  /// Shapes beside colours: a cross for what is wrong, a square for others' programs, a diamond for speed.
  void draw_marker(Pen& p, const std::string& id, Role role, dvec2 at, double r) const {
    const Paint paint = Paint::mark(role);
    if (role == Role::rejected) {
      p.strokes(id, {{{at - dvec2(r, r), at + dvec2(r, r)}, {at - dvec2(r, -r), at + dvec2(r, -r)}},
                     paint,
                     4 * s_,
                     true});
    } else if (role == Role::past) {
      p.rect(id, {.box = {at.x - r, at.y - r, 2 * r, 2 * r},
                  .fill = paint,
                  .stroke = {},
                  .stroke_width = 0,
                  .hatch_paint = {}});
    } else if (role == Role::candidate) {
      const double d = 1.3 * r;
      p.area(id, {{{at - dvec2(d, 0), at - dvec2(0, d), at + dvec2(d, 0), at + dvec2(0, d)}}, paint, {}, {}});
    } else {
      p.disc(id, {at, r, paint, {}, 0});
    }
  }

  /// The name beside its point, where it covers least; with a leader when that is far away.
  void place_label(const std::string& name, dvec2 anchor, Role role) {
    const double width = text_width(name, Face::sans, text_size * s_), height = 24 * s_;
    double least = std::numeric_limits<double>::infinity();
    Box best;
    double best_distance = 0;
    for (const double distance : {18.0, 44.0, 76.0, 112.0}) {
      for (const auto& [dx, dy] : {std::pair{1.0, 0.0},
                                   {-1.0, 0.0},
                                   {1.0, -1.0},
                                   {1.0, 1.0},
                                   {-1.0, -1.0},
                                   {-1.0, 1.0},
                                   {0.0, -1.0},
                                   {0.0, 1.0}}) {
        const Box box{anchor.x + dx * distance * s_ -
                          (dx < 0   ? width
                           : dx > 0 ? 0
                                    : width / 2),
                      anchor.y + dy * distance * s_ - height / 2, width, height};
        if (box.x < place_.x || box.right() > place_.right() || box.y < place_.y ||
            box.bottom() > place_.bottom())
          continue;
        const Box with_air{box.x - 12 * s_, box.y - 4 * s_, box.width + 24 * s_, box.height + 8 * s_};
        double cost = distance;
        for (const Box& label : labels_) cost += overlap(with_air, label) > 0 ? 10000 : 0;
        for (const Box& dot : taken_) cost += overlap(box, dot) > 0 ? 1500 : 0;
        for (const auto& [a, b] : strokes_) cost += crosses(a, b, box) ? 60 : 0;
        if (cost >= least) continue;
        least = cost;
        best = box;
        best_distance = distance;
      }
    }
    if (!std::isfinite(least)) return;
    labels_.push_back(best);
    Pen p = pen(Slot::drawing);
    if (best_distance > 20) {
      const dvec2 end{std::clamp(anchor.x, best.x, best.right()),
                      std::clamp(anchor.y, best.y, best.bottom())};
      p.line("leader " + name, {{end, anchor}, Paint::text(role), 1.4 * s_});
    }
    p.text("name " + name, text({best.x, best.y + 18 * s_}, name, Align::left, Paint::text(role)));
  }

  static bool crosses(dvec2 a, dvec2 b, const Box& box) {
    // By samples: enough for a choice between places
    for (int i = 0; i <= 24; ++i) {
      const dvec2 p = a + (b - a) * (i / 24.0);
      if (p.x > box.x && p.x < box.right() && p.y > box.y && p.y < box.bottom()) return true;
    }
    return false;
  }

  void draw_footer() {
    Pen p = pen(Slot::footer);
    double x = 40 * s_;
    const double y = sheet_.height - 24 * s_;
    for (const auto& [role, words] : chart_.legend) {
      draw_marker(p, "legend " + words, role, {x + 8 * s_, y - 7 * s_}, 8 * s_);
      p.text("legend text " + words, text({x + 24 * s_, y}, words, Align::left, Paint::of(Tone::ink)));
      x += 24 * s_ + text_width(words, Face::sans, text_size * s_) + 28 * s_;
    }
    const double room = sheet_.width - 40 * s_ - x;
    p.text("footer",
           text({sheet_.width - 40 * s_, y}, elided(chart_.footer, Face::sans, text_size * s_, room),
                Align::right, Paint::of(Tone::muted)));
  }

  const Chart& chart_;
  double s_;
  Sheet sheet_;
  Box place_;
  Scale x_{}, y_{};
  bool zeros_ = false;
  double zero_row_ = 0;
  std::vector<Box> taken_, labels_;
  std::vector<Segment<2, double>> strokes_;
};

}  // namespace

Sheet sheet_of(const Chart& chart, double width, double height) {
  return Drawing(chart, width, height).drawn();
}

std::optional<double> slope(std::span<const dvec2> points) {
  dvec2 mean{0, 0};
  for (const dvec2 p : points)
    mean += dvec2(std::log(p.x), std::log(p.y)) / static_cast<double>(points.size());
  double across = 0, along = 0;
  for (const dvec2 p : points) {
    const dvec2 d = dvec2(std::log(p.x), std::log(p.y)) - mean;
    across += d.x * d.y;
    along += d.x * d.x;
  }
  return along > 0 ? std::optional(across / along) : std::nullopt;
}

std::vector<bool> front(std::span<const dvec2> points) {
  std::vector<bool> kept(points.size(), true);
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (const dvec2 other : points) {
      const bool no_worse = other.x <= points[i].x && other.y <= points[i].y;
      if (no_worse && (other.x < points[i].x || other.y < points[i].y)) kept[i] = false;
    }
  }
  return kept;
}

}  // namespace gradus::plot
