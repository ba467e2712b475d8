// The drawing slot: a grid, its cells, the marks over it, and labels where they are free of each other.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <optional>

#include "core/contract.hpp"
#include "figure/layout.hpp"
#include "figure/number_text.hpp"

namespace gradus::layout {
namespace {

constexpr double followed_cell = 30;
constexpr double axis_below = 34, axis_above = 30;
constexpr double inset_height = 104, inset_gap = 8;         ///< of an overview above the view
constexpr double inset_width = 190, inset_column_gap = 16;  ///< of one beside it

bool overlap(const Box& a, const Box& b) {
  return a.x < b.right() && b.x < a.right() && a.y < b.bottom() && b.y < a.bottom();
}
double overlap_area(const Box& a, const Box& b) {
  const double width = std::min(a.right(), b.right()) - std::max(a.x, b.x);
  const double height = std::min(a.bottom(), b.bottom()) - std::max(a.y, b.y);
  return width > 0 && height > 0 ? width * height : 0;
}
bool inside(const Box& inner, const Box& outer) {
  return inner.x >= outer.x && inner.y >= outer.y && inner.right() <= outer.right() &&
         inner.bottom() <= outer.bottom();
}
Box around(const Box& a, const Box& b) {
  const double x = std::min(a.x, b.x), y = std::min(a.y, b.y);
  return {x, y, std::max(a.right(), b.right()) - x, std::max(a.bottom(), b.bottom()) - y};
}
Box grown(const Box& b, double by) { return {b.x - by, b.y - by, b.width + 2 * by, b.height + 2 * by}; }

/// The part of a stroke inside a box; nothing when it misses it. (Liang and Barsky's parameters.)
std::optional<Segment<2, double>> clipped(dvec2 a, dvec2 b, const Box& box) {
  // Most are far from it
  if (std::max(a.x, b.x) < box.x || std::min(a.x, b.x) > box.right() || std::max(a.y, b.y) < box.y ||
      std::min(a.y, b.y) > box.bottom()) {
    return std::nullopt;
  }
  double enter = 0, leave = 1;
  const dvec2 d = b - a;
  const auto side = [&](double p, double q) {
    if (p == 0) return q >= 0;
    const double t = q / p;
    if (p < 0) enter = std::max(enter, t);
    if (p > 0) leave = std::min(leave, t);
    return enter <= leave;
  };
  if (!side(-d.x, a.x - box.x) || !side(d.x, box.right() - a.x) || !side(-d.y, a.y - box.y) ||
      !side(d.y, box.bottom() - a.y)) {
    return std::nullopt;
  }
  return Segment{a + enter * d, a + leave * d};
}

/// The part of a ring inside a box: cut at one side after the other.
std::vector<dvec2> inside_of(std::vector<dvec2> ring, const Box& box) {
  const auto cut = [&ring](int axis, double border, double sign) {
    std::vector<dvec2> kept;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const dvec2 a = ring[i], b = ring[(i + 1) % ring.size()];
      const double from = sign * (a[axis] - border), to = sign * (b[axis] - border);
      if (from >= 0) kept.push_back(a);
      if ((from < 0 && to > 0) || (from > 0 && to < 0)) kept.push_back(a + from / (from - to) * (b - a));
    }
    ring = std::move(kept);
  };
  cut(0, box.x, 1);
  cut(0, box.right(), -1);
  cut(1, box.y, 1);
  cut(1, box.bottom(), -1);
  return ring;
}

/// Cells shown along one axis, following `focus` by jumps of half a view: the first one.
std::int64_t followed(std::int64_t lower, std::int64_t upper, std::int64_t count, std::int64_t focus) {
  if (upper - lower + 1 <= count) return lower;
  const std::int64_t half = std::max<std::int64_t>(count / 2, 1);
  const std::int64_t page = (focus - lower) / half;
  const std::int64_t first = lower + page * half - half / 2;
  return std::clamp(first, lower, upper - count + 1);
}

/// The cells of a view that follows the step.
Window followed_view(const Window& all, const Fit& shown, ivec2 focus) {
  const std::int64_t x = followed(all.lower.x, all.upper.x, shown.columns, focus.x);
  const std::int64_t y = followed(all.lower.y, all.upper.y, shown.rows, focus.y);
  return {{static_cast<int>(x), static_cast<int>(y)},
          {static_cast<int>(x + shown.columns - 1), static_cast<int>(y + shown.rows - 1)}};
}

/// Beside a narrow grid there must be room for labels; a wider one has room of its own.
Box with_room_for_labels(const Box& settled, const Box& slot, double s) {
  constexpr double enough = 420;
  const double missing = std::max(0.0, enough * s - settled.width);
  const double x = std::max(slot.x, settled.x - missing / 2);
  return {x, settled.y, std::min(slot.right(), settled.right() + missing / 2) - x, settled.height};
}

/// Distance between labelled integers: 1, 2, 5, 10 … cells, so that the labels keep apart.
std::int64_t tick_step(double cell, double needed) {
  std::int64_t step = 1;
  for (int i = 0; static_cast<double>(step) * cell < needed; ++i) step = i % 3 == 1 ? step / 2 * 5 : step * 2;
  return step;
}

/// The first multiple of `step` that is not below `lower`.
std::int64_t first_tick(std::int64_t lower, std::int64_t step) {
  const std::int64_t rest = ((lower % step) + step) % step;
  return rest == 0 ? lower : lower + step - rest;
}

class DrawingLayout {
 public:
  DrawingLayout(Pen& pen, const Figure& figure, const Scene& scene)
      : pen_(pen), figure_(figure), trace_(*figure.trace), s_(pen.scale()), at_(scene), frame_(scene.frame) {}

  void draw() {
    draw_picture();
    draw_cell_grounds();
    draw_cell_colors();
    if (!figure_.canvas->plane()) {
      draw_grid();
      draw_axes();
    }
    draw_cell_outlines();
    draw_marks();
    if (at_.follows) draw_overview();
    point_outside();
    place_labels();
  }

 private:
  template <class F>
  void for_each_cell(F f) const {
    const Window& view = frame_.view;
    for (std::int64_t y = view.lower.y; y <= view.upper.y; ++y) {
      for (std::int64_t x = view.lower.x; x <= view.upper.x; ++x) {
        f(ivec2{static_cast<int>(x), static_cast<int>(y)});
      }
    }
  }

  void draw_picture() {
    const auto& picture = trace_.grid.picture;
    if (!picture) return;
    const Window& view = frame_.view;
    Image part(static_cast<int>(view.width()), static_cast<int>(view.height()));
    for_each_cell([&](ivec2 p) {
      const ivec2 at = p - trace_.grid.cells.lower;
      const int row = frame_.y_up ? view.upper.y - p.y : p.y - view.lower.y;
      if (picture->contains(at)) part[{p.x - view.lower.x, row}] = (*picture)[at];
    });
    pen_.image("picture", {frame_.box, std::move(part), {}});
  }

  void draw_cell_grounds() {
    for_each_cell([&](ivec2 p) {
      const auto look = figure_.canvas->at(p);
      if (!look || look->color) return;
      const std::string id = fmt::format("cell {},{}", p.x, p.y);
      draw_cell_ground(pen_, id, look->role, frame_.square(p));
      if (!look->text.empty()) cell_texts_.emplace_back(p, *look);
      note_cell(p, look->role);
    });
  }

  /// Cells with colours of their own, as one picture.
  void draw_cell_colors() {
    const Window& view = frame_.view;
    Image part(static_cast<int>(view.width()), static_cast<int>(view.height()), {0, 0, 0, 0});
    bool any = false;
    for_each_cell([&](ivec2 p) {
      const auto look = figure_.canvas->at(p);
      if (!look || !look->color) return;
      part[{p.x - view.lower.x, frame_.y_up ? view.upper.y - p.y : p.y - view.lower.y}] = *look->color;
      any = true;
    });
    if (any) pen_.image("colours", {frame_.box, std::move(part), {}});
  }

  /// What labels should not cover.
  void note_cell(ivec2 p, Role role) {
    if (role == Role::past || role == Role::boundary || role == Role::result) {
      crowded_.emplace_back(frame_.square(p), role == Role::boundary ? 300 : 60);
    } else {
      taken_.push_back(frame_.square(p));
    }
  }

  void draw_grid() {
    const Box& b = frame_.box;
    StrokesShape grid{{}, Paint::of(Tone::rule), 1.5 * s_};
    for (std::int64_t i = 0; i <= frame_.view.width(); ++i) {
      const double x = b.x + static_cast<double>(i) * frame_.cell;
      grid.segments.push_back({{x, b.y}, {x, b.bottom()}});
    }
    for (std::int64_t i = 0; i <= frame_.view.height(); ++i) {
      const double y = b.y + static_cast<double>(i) * frame_.cell;
      grid.segments.push_back({{b.x, y}, {b.right(), y}});
    }
    pen_.strokes("grid", std::move(grid));
    if (!trace_.grid.picture) draw_centres();
  }

  void draw_centres() {
    StrokesShape dots{{}, Paint::mark(Role::past), 4.4 * s_, true};
    for_each_cell([&](ivec2 p) {
      const auto look = figure_.canvas->at(p);
      if (look && (look->role == Role::boundary || look->color || !look->text.empty())) return;
      const dvec2 centre = frame_.point({p.x, p.y});
      dots.segments.push_back({centre, centre});
    });
    if (!dots.segments.empty()) pen_.strokes("centres", std::move(dots));
  }

  void tick(std::string id, dvec2 baseline, std::string text, Align align) {
    TextShape shape{baseline, std::move(text), Face::sans, text_size * s_, align, Paint::of(Tone::muted)};
    texts_.push_back(shape.box());
    ticks_.push_back(grown(shape.box(), 8 * s_));
    pen_.text(std::move(id), std::move(shape));
  }

  void draw_axes() {
    const Box& b = frame_.box;
    const Window& view = frame_.view;
    const double widest = std::max(text_width(figure_number(view.lower.x), Face::sans, text_size * s_),
                                   text_width(figure_number(view.upper.x), Face::sans, text_size * s_));
    const std::int64_t across = tick_step(frame_.cell, widest + 10 * s_);
    // The axis' name stands behind the last label, inside the slot
    const double most_right =
        at_.labels.right() - text_width(trace_.grid.x_name, Face::italic, text_size * s_) - 8 * s_;
    double last_right = b.x;
    for (std::int64_t x = first_tick(view.lower.x, across); x <= view.upper.x; x += across) {
      const std::string text = figure_number(x);
      const double half = text_width(text, Face::sans, text_size * s_) / 2;
      if (frame_.column(static_cast<double>(x)) + half > most_right) break;
      tick("x " + text, {frame_.column(static_cast<double>(x)), b.bottom() + 26 * s_}, text, Align::centre);
      last_right = texts_.back().right();
    }
    const std::int64_t up = tick_step(frame_.cell, 24 * s_);
    for (std::int64_t y = first_tick(view.lower.y, up); y <= view.upper.y; y += up) {
      const std::string text = figure_number(y);
      tick("y " + text, {b.x - 10 * s_, frame_.row(static_cast<double>(y)) + 7 * s_}, text, Align::right);
    }
    const double x_name = std::max(b.right() + 6 * s_, last_right + 8 * s_);
    name_axis("x axis", {x_name, b.bottom() + 26 * s_}, trace_.grid.x_name, Align::left);
    // The arrow behind the name of the rows says where they grow; columns always grow to the right
    const double y_name = text_width(trace_.grid.y_name, Face::italic, text_size * s_);
    // A long name may stand over the grid's corner, but not in the margin
    name_axis("y axis", {std::max(b.x - 10 * s_ - y_name, at_.left), b.y - 10 * s_},
              trace_.grid.y_name + (frame_.y_up ? " ↑" : " ↓"), Align::left);
  }

  void name_axis(std::string id, dvec2 baseline, const std::string& name, Align align) {
    TextShape shape{baseline, name, Face::italic, text_size * s_, align, Paint::of(Tone::muted)};
    texts_.push_back(shape.box());
    pen_.text(std::move(id), std::move(shape));
  }

  void draw_cell_outlines() {
    for_each_cell([&](ivec2 p) {
      if (const auto look = figure_.canvas->at(p); look && !look->color) {
        draw_cell_outline(pen_, fmt::format("outline {},{}", p.x, p.y), look->role, frame_.square(p));
      }
    });
    for (const auto& [p, look] : cell_texts_) {
      const double size = text_size * s_;
      if (text_width(look.text, Face::sans, size) > frame_.cell - 2 * s_ || frame_.cell < 26 * s_) continue;
      const dvec2 centre = frame_.point({p.x, p.y});
      pen_.text(fmt::format("text {},{}", p.x, p.y), {{centre.x, centre.y + 7 * s_},
                                                      look.text,
                                                      Face::sans,
                                                      size,
                                                      Align::centre,
                                                      Paint::on(look.role),
                                                      true,
                                                      Paint::fill(look.role)});
    }
  }

  void draw_marks() {
    for (const Mark& mark : trace_.backdrop) draw_area(mark);
    for (const auto& [id, mark] : figure_.canvas->marks()) draw_area(mark);
    for (const Mark& mark : trace_.backdrop) draw_mark(mark, true);
    for (const auto& [id, mark] : figure_.canvas->marks()) draw_mark(mark, false);
    // Over all lines; those that stand through all steps first, so that they keep still
    for (const Mark& mark : trace_.backdrop) draw_text(mark);
    for (const auto& [id, mark] : figure_.canvas->marks()) draw_text(mark);
  }

  void draw_area(const Mark& mark) {
    const Area* area = std::get_if<Area>(&mark.shape);
    if (!area) return;
    AreaShape shape{{}, Paint::fill(mark.role), channel_of(mark.role).hatch, Paint::mark(mark.role)};
    for (const auto& ring : area->rings) {
      std::vector<dvec2> points;
      for (const dvec2 p : ring) points.push_back(frame_.point(p));
      points = inside_of(std::move(points), frame_.box);
      if (points.size() >= 3) shape.rings.push_back(std::move(points));
    }
    if (!shape.rings.empty()) pen_.area(mark.id, std::move(shape));
  }

  void draw_text(const Mark& mark) {
    const Text* text = std::get_if<Text>(&mark.shape);
    if (!text) return;
    const dvec2 at = frame_.point(text->at);
    if (!inside({at.x, at.y, 0, 0}, grown(frame_.box, 1))) return;
    const double size = text_size * s_;
    TextShape shape{
        {at.x, at.y + 0.35 * size}, text->text, Face::sans, size, text->align, Paint::text(mark.role), true,
        Paint::of(Tone::paper)};
    const Box box = shape.box();
    const auto hits = [&](const Box& other) { return overlap(grown(box, 2 * s_), other); };
    if (!inside(box, at_.labels) || std::ranges::any_of(texts_, hits)) return;
    texts_.push_back(box);
    pen_.text(mark.id, std::move(shape));
  }

  void draw_mark(const Mark& mark, bool fixed) {
    if (const Stroke* stroke = std::get_if<Stroke>(&mark.shape)) {
      draw_chain(mark, {stroke->a, stroke->b}, {.arrow = stroke->arrow, .dashed = stroke->dashed});
    } else if (const Path* path = std::get_if<Path>(&mark.shape)) {
      draw_chain(mark, path->points, {.closed = path->closed, .dashed = path->dashed});
    } else if (const Dot* dot = std::get_if<Dot>(&mark.shape)) {
      draw_dot(mark, *dot);
    } else if (const Label* label = std::get_if<Label>(&mark.shape)) {
      (fixed ? fixed_labels_ : labels_).emplace_back(&mark, label);
    }
  }

  struct ChainLook {
    bool closed = false, arrow = false, dashed = false;
  };
  void draw_chain(const Mark& mark, const std::vector<dvec2>& points, const ChainLook& look) {
    if (points.empty()) return;
    const bool dashed = look.dashed || is_dashed(mark.role);
    LineShape line{{}, Paint::mark(mark.role), line_width(mark.role) * s_, dashed};
    const auto draw = [&] {
      if (line.points.size() >= 2) pen_.line(mark.id, line);
      line.points.clear();
    };
    const std::size_t ends = look.closed ? points.size() : points.size() - 1;
    bool whole = look.closed;
    for (std::size_t i = 0; i < ends; ++i) {
      const dvec2 from = frame_.point(points[i]), to = frame_.point(points[(i + 1) % points.size()]);
      const auto part = clipped(from, to, frame_.box);
      whole = whole && part && *part == Segment{from, to};
      if (!part || (!line.points.empty() && line.points.back() != part->a)) draw();
      if (!part) continue;
      strokes_.push_back(*part);
      if (line.points.empty()) line.points.push_back(part->a);
      line.points.push_back(part->b);
    }
    if (whole) line.points.pop_back();
    line.closed = whole;
    line.arrow = look.arrow;
    draw();
  }

  void draw_dot(const Mark& mark, const Dot& dot) {
    const dvec2 at = frame_.point(dot.at);
    if (at.x < frame_.box.x || at.x > frame_.box.right() || at.y < frame_.box.y || at.y > frame_.box.bottom())
      return;
    const double radius = (mark.role == Role::input ? 7 : 6) * s_;
    taken_.push_back({at.x - radius, at.y - radius, 2 * radius, 2 * radius});
    if (dot.ring) {
      pen_.disc(mark.id, {at, radius, Paint::of(Tone::paper), Paint::mark(mark.role), 3 * s_});
    } else {
      pen_.disc(mark.id, {at, radius, Paint::mark(mark.role), {}, 0});
    }
  }

  /// Where the step happens when that is not in the view: an arrow at its border, and the cell.
  void point_outside() {
    const ivec2 focus = figure_.focus;
    if (frame_.view.contains(focus) || !trace_.grid.cells.contains(focus)) return;
    const Box& b = frame_.box;
    const dvec2 centre{b.x + b.width / 2, b.y + b.height / 2};
    const auto inner = clipped(centre, frame_.point({focus.x, focus.y}), grown(b, -4 * s_));
    if (!inner) return;
    const dvec2 tip = inner->b, way = tip - centre;
    const dvec2 tail = tip - way * (30 * s_ / std::hypot(way.x, way.y));
    taken_.push_back({std::min(tip.x, tail.x), std::min(tip.y, tail.y), std::abs(tip.x - tail.x),
                      std::abs(tip.y - tail.y)});
    pen_.line("outside", {{tail, tip}, Paint::mark(Role::current), 4 * s_, false, false, true});
    outside_ =
        Mark{"outside name", Role::current,
             Label{cell_at(tail), fmt::format("({}, {})", figure_number(focus.x), figure_number(focus.y))}};
  }
  /// The inverse of Frame::point.
  dvec2 cell_at(dvec2 pixel) const {
    const Box& b = frame_.box;
    const double up = (frame_.y_up ? b.bottom() - pixel.y : pixel.y - b.y) / frame_.cell;
    return {frame_.view.lower.x + (pixel.x - b.x) / frame_.cell - 0.5, frame_.view.lower.y + up - 0.5};
  }

  /// How bad a place for a label is: covering what matters, lying on lines, being far away. Nothing:
  /// impossible, or no better than `least`. `clear`: how far it should keep from lines.
  std::optional<double> badness(const Box& at, double distance, double clear, double least) const {
    if (!inside(at, at_.labels)) return std::nullopt;
    const auto hits = [&at, this](const Box& text) { return overlap(grown(at, 3 * s_), text); };
    if (std::ranges::any_of(texts_, hits)) return std::nullopt;
    double cost = distance;
    // Beside a number of an axis, a label would seem to go on with it
    for (const Box& tick : ticks_) cost += overlap(at, tick) ? 90 * s_ : 0;
    const double area = at.width * at.height;
    for (const Box& box : taken_) cost += 900 * s_ * overlap_area(at, box) / area;
    for (const auto& [box, weight] : crowded_) cost += weight * s_ * overlap_area(at, box) / area;
    // Each cost adds, so that a place that lost already need not be counted to its end
    const Box clearing = grown(at, clear);
    for (const auto& [a, b] : strokes_) {
      if (cost >= least) return std::nullopt;
      if (clipped(a, b, clearing)) cost += 160 * s_;
    }
    return cost < least ? std::optional(cost) : std::nullopt;
  }

  static dvec2 leader_end(dvec2 anchor, const Box& label) {
    return {std::clamp(anchor.x, label.x, label.right()), std::clamp(anchor.y, label.y, label.bottom())};
  }

  /// A label that touches another marked cell than its own, or stands in its row, seems to name that one.
  double ambiguity(dvec2 anchor, const Box& label) const {
    double cost = 0;
    const double row = label.y + label.height / 2;
    for (const Box& cell : taken_) {
      if (inside({anchor.x, anchor.y, 0, 0}, cell)) continue;
      const bool in_its_row = cell.y < row && row < cell.bottom() && overlap(grown(label, 16 * s_), cell);
      if (in_its_row || overlap(grown(label, 7 * s_), cell)) cost += (in_its_row ? 150 : 60) * s_;
    }
    return cost;
  }

  /// A leader should not lead over what another label speaks of, nor through a text.
  double badness_of_leader(dvec2 anchor, const Box& label) const {
    const dvec2 end = leader_end(anchor, label);
    double cost = 0;
    for (const Box& text : texts_) cost += clipped(end, anchor, text) ? 200 * s_ : 0;
    for (const Box& cell : taken_) {
      if (!inside({anchor.x, anchor.y, 0, 0}, cell) && clipped(end, anchor, grown(cell, -2 * s_)))
        cost += 200 * s_;
    }
    return cost;
  }

  /// Tries places round the anchor at this distance and beyond, near ones first; draws a leader when the best
  /// is not beside it.
  void place(const Mark& mark, const Label& label, double gap, double clear) {
    const dvec2 anchor = frame_.point(label.at);
    if (!inside({anchor.x, anchor.y, 0, 0}, grown(frame_.box, 1))) return;
    const double size = text_size * s_, width = text_width(label.text, Face::sans, size);
    std::optional<Box> best;
    double least = std::numeric_limits<double>::infinity(), best_distance = 0;
    for (const double distance :
         {gap, gap + 26 * s_, gap + 60 * s_, gap + 100 * s_, gap + 150 * s_, gap + 210 * s_}) {
      for (const auto& [dx, dy] : {std::pair{-1.0, 0.0},
                                   {1.0, 0.0},
                                   {-1.0, -1.0},
                                   {1.0, -1.0},
                                   {-1.0, 1.0},
                                   {1.0, 1.0},
                                   {0.0, -1.0},
                                   {0.0, 1.0},
                                   {-1.0, -0.5},
                                   {1.0, -0.5},
                                   {-1.0, 0.5},
                                   {1.0, 0.5},
                                   {-0.5, -1.0},
                                   {0.5, -1.0},
                                   {-0.5, 1.0},
                                   {0.5, 1.0}}) {
        const double x = anchor.x + dx * distance - (dx < 0 ? width : dx > 0 ? 0 : width / 2);
        const double y = anchor.y + dy * distance - size / 2;
        const Box at{x, y, width, size};
        auto cost = badness(at, distance, clear, least);
        if (!cost) continue;
        *cost += ambiguity(anchor, at) + (distance > gap ? badness_of_leader(anchor, at) : 0);
        if (*cost >= least) continue;
        best = at;
        least = *cost;
        best_distance = distance;
      }
    }
    if (best) draw_label(mark, label, anchor, *best, best_distance > gap + 1);
  }

  void draw_label(const Mark& mark, const Label& label, dvec2 anchor, const Box& at, bool leader) {
    if (leader) {
      pen_.line("leader " + mark.id,
                {{leader_end(anchor, at), anchor}, Paint::text(mark.role), 1.4 * s_, false, false, false});
    }
    TextShape shape{{at.x, at.y + 0.78 * at.height},
                    label.text,
                    Face::sans,
                    text_size * s_,
                    Align::left,
                    Paint::text(mark.role),
                    true,
                    Paint::of(Tone::paper)};
    texts_.push_back(shape.box());
    pen_.text(mark.id, std::move(shape));
  }

  void place_labels() {
    // Those that stand through all steps come first and look only at what stands too, so that they keep still
    std::vector<Box> step_taken;
    std::vector<std::pair<Box, double>> step_crowded;
    std::vector<Segment<2, double>> step_strokes;
    std::swap(taken_, step_taken);
    std::swap(crowded_, step_crowded);
    const std::size_t fixed_strokes = trace_.backdrop.size();
    step_strokes = strokes_;
    strokes_.resize(std::min(strokes_.size(), fixed_strokes));
    const double gap = frame_.cell / 2 + 10 * s_;
    for (const auto& [mark, label] : fixed_labels_) place(*mark, *label, gap, frame_.cell);
    std::swap(taken_, step_taken);
    std::swap(crowded_, step_crowded);
    strokes_ = step_strokes;
    if (outside_) place(*outside_, std::get<Label>(outside_->shape), 12 * s_, 2 * s_);
    // What was chosen and what was not have the first pick, a length the last
    std::ranges::stable_partition(labels_, [](const auto& l) { return l.first->role != Role::measure; });
    for (const auto& [mark, label] : labels_) place(*mark, *label, gap, 2 * s_);
  }

  /// The whole grid, small, with the part that the view shows.
  void draw_overview() {
    const Window& all = trace_.grid.cells;
    const double ratio = static_cast<double>(all.width()) / static_cast<double>(all.height());
    const double most_width = (at_.beside ? 1 : 0.55) * at_.inset.width;
    const bool captions = !at_.beside || at_.inset.height > 160 * s_;
    const double height = std::min(at_.inset.height - (at_.beside && captions ? 90 * s_ : 0), 150 * s_);
    Box whole{at_.inset.x, at_.inset.y, height * ratio, height};
    if (whole.width > most_width) {
      whole.width = most_width;
      whole.height = std::max(most_width / ratio, 6 * s_);
    }
    whole.width = std::max(whole.width, 6 * s_);
    draw_overview_cells(whole);
    pen_.rect("overview frame", {whole, {}, Paint::of(Tone::muted), 1.5 * s_, 0, false, Hatch::none, {}});
    const auto to_whole = [&](dvec2 p) {
      const double x = (p.x - all.lower.x + 0.5) / static_cast<double>(all.width());
      const double y = (p.y - all.lower.y + 0.5) / static_cast<double>(all.height());
      return dvec2{whole.x + x * whole.width,
                   frame_.y_up ? whole.bottom() - y * whole.height : whole.y + y * whole.height};
    };
    for (const Mark& mark : trace_.backdrop) {
      if (const Stroke* stroke = std::get_if<Stroke>(&mark.shape)) {
        draw_overview_chain(mark, {to_whole(stroke->a), to_whole(stroke->b)}, whole);
      } else if (const Path* path = std::get_if<Path>(&mark.shape)) {
        std::vector<dvec2> points;
        std::ranges::transform(path->points, std::back_inserter(points), to_whole);
        if (path->closed) points.push_back(points.front());
        draw_overview_chain(mark, points, whole);
      }
    }
    const Window& view = frame_.view;
    const dvec2 a = to_whole({view.lower.x - 0.5, view.lower.y - 0.5});
    const dvec2 b = to_whole({view.upper.x + 0.5, view.upper.y + 0.5});
    Box part{std::min(a.x, b.x), std::min(a.y, b.y), std::abs(a.x - b.x), std::abs(a.y - b.y)};
    if (part.width < 8 * s_) part = {part.x + part.width / 2 - 4 * s_, part.y, 8 * s_, part.height};
    if (part.height < 8 * s_) part = {part.x, part.y + part.height / 2 - 4 * s_, part.width, 8 * s_};
    pen_.rect("overview view", {part, {}, Paint::mark(Role::current), 3 * s_, 0, false, Hatch::none, {}});
    if (captions) caption_overview(whole);
  }

  /// A line or a curve; of a curve's points those a pixel apart are enough here.
  void draw_overview_chain(const Mark& mark, const std::vector<dvec2>& points, const Box& whole) {
    StrokesShape shape{{}, Paint::mark(mark.role), 2 * s_, false};
    dvec2 from = points.front();
    for (std::size_t i = 1; i < points.size(); ++i) {
      if (i + 1 < points.size() && std::hypot(points[i].x - from.x, points[i].y - from.y) < s_) continue;
      if (const auto part = clipped(from, points[i], whole)) shape.segments.push_back(*part);
      from = points[i];
    }
    if (!shape.segments.empty()) pen_.strokes("overview " + mark.id, std::move(shape));
  }

  void draw_overview_cells(const Box& whole) {
    const Window& all = trace_.grid.cells;
    constexpr int most = 208;  // samples a side: twice the pixels it has at 720 lines
    if (!trace_.grid.picture && static_cast<double>(all.width()) * static_cast<double>(all.height()) > 4e6)
      return;
    const int width = static_cast<int>(std::min<std::int64_t>(all.width(), most));
    const int height = static_cast<int>(std::min<std::int64_t>(all.height(), most));
    pen_.image("overview", overview_image(whole, width, height));
  }

  /// One sample a cell of the small picture; cells with a role win over the input picture.
  ImageShape overview_image(const Box& whole, int width, int height) const {
    const Window& all = trace_.grid.cells;
    ImageShape small{whole, Image(width, height, Rgba8{0, 0, 0, 0}), Raster<std::uint8_t>(width, height)};
    for (int row = 0; row < height; ++row) {
      for (int column = 0; column < width; ++column) {
        const ivec2 p{static_cast<int>(all.lower.x + column * all.width() / width),
                      static_cast<int>(all.lower.y + row * all.height() / height)};
        const ivec2 to{column, frame_.y_up ? height - 1 - row : row};
        if (trace_.grid.picture) small.image[to] = (*trace_.grid.picture)[p - all.lower];
        if (const auto look = figure_.canvas->at(p)) {
          small.roles[to] = static_cast<std::uint8_t>(1 + static_cast<int>(look->role));
        }
      }
    }
    return small;
  }

  /// Beside or below the small picture: its size, and which part of it is in view. What doesn't fit is left
  /// out: the axes say it too.
  void caption_overview(const Box& whole) {
    const Window& all = trace_.grid.cells;
    const Window& view = frame_.view;
    const double x = at_.beside ? at_.inset.x : whole.right() + 14 * s_;
    const double room = at_.inset.right() - x;
    double y = at_.beside ? whole.bottom() + 24 * s_ : whole.y + 20 * s_;
    const auto fits = [&](const std::string& text) {
      return text_width(text, Face::sans, text_size * s_) <= room;
    };
    const auto line = [&](std::string id, const std::string& text) {
      if (!fits(text)) return;
      TextShape shape{{x, y}, text, Face::sans, text_size * s_, Align::left, Paint::of(Tone::muted)};
      texts_.push_back(shape.box());
      pen_.text(std::move(id), std::move(shape));
      y += 28 * s_;
    };
    const std::string size =
        trace_.wording.say("figure.whole", fmt::arg("width", all.width()), fmt::arg("height", all.height()));
    line("overview size", fits(size) ? size : fmt::format("{} × {}", all.width(), all.height()));
    line("overview columns", fmt::format("{} {} … {}", trace_.grid.x_name, figure_number(view.lower.x),
                                         figure_number(view.upper.x)));
    line("overview rows", fmt::format("{} {} … {}", trace_.grid.y_name, figure_number(view.lower.y),
                                      figure_number(view.upper.y)));
  }

  Pen& pen_;
  const Figure& figure_;
  const Trace& trace_;
  double s_;
  const Scene& at_;
  const Frame& frame_;
  std::vector<std::pair<ivec2, CellLook>> cell_texts_;
  std::vector<Box> texts_;                       ///< of texts placed so far: nothing may overlap them
  std::vector<Box> ticks_;                       ///< of the axes' numbers and some space round them
  std::vector<Box> taken_;                       ///< cells and dots that a label must not cover
  std::vector<std::pair<Box, double>> crowded_;  ///< cells that it should not, and how much
  std::vector<Segment<2, double>> strokes_;
  std::vector<std::pair<const Mark*, const Label*>> fixed_labels_, labels_;
  std::optional<Mark> outside_;  ///< the label of a step outside the view
};

}  // namespace

void draw_cell_ground(Pen& pen, const std::string& id, Role role, const Box& box) {
  const Channel channel = channel_of(role);
  pen.rect(id, {box, Paint::fill(role), {}, 0, 0, false, channel.hatch, Paint::mark(role)});
}

void draw_cell_outline(Pen& pen, const std::string& id, Role role, const Box& box) {
  const Channel channel = channel_of(role);
  if (channel.outline == 0) return;
  const double s = pen.scale(), inset = channel.outline * s / 2;
  const double width = std::min(channel.outline * s, box.height / 5);
  pen.rect(id, {grown(box, -inset), {}, Paint::mark(role), width, 0, channel.dashed, Hatch::none, {}});
  if (!channel.cross) return;
  const Box in = grown(box, -box.height * 0.3);
  pen.line(id, {{{in.x, in.y}, {in.right(), in.bottom()}}, Paint::mark(role), 2 * s, false, false, false});
  pen.line(id, {{{in.x, in.bottom()}, {in.right(), in.y}}, Paint::mark(role), 2 * s, false, false, false});
}

Stage stage_of(const Trace& trace, const Look& look) {
  const Grid& grid = trace.grid;
  Stage stage{grid.cells, look.view.has_value(), look.y_up.value_or(grid.y_up)};
  if (look.view) stage.cells = intersection(*look.view, grid.cells);
  if (look.view && stage.cells.empty()) {
    const Window &all = grid.cells, &view = *look.view;
    contract_violated(fmt::format("expected cells of the grid {},{} to {},{}, found {},{} to {},{}",
                                  all.lower.x, all.lower.y, all.upper.x, all.upper.y, view.lower.x,
                                  view.lower.y, view.upper.x, view.upper.y));
  }
  const auto number_width = [](int n) { return text_width(figure_number(n), Face::sans, text_size); };
  if (grid.axes) {
    stage.left = std::max({number_width(stage.cells.lower.y), number_width(stage.cells.upper.y), 24.0}) + 12;
    stage.right = std::max(24.0, text_width(grid.x_name, Face::italic, text_size) + 12);
    stage.above = axis_above;
    stage.below = axis_below;
  }
  const bool slide = look.layout == Layout::slide;
  stage.least_cell = grid.whole ? 6 : slide ? least_cell : 16;
  // In print it is the cell's real size that counts: 3 mm; the units of a paper are no cells
  stage.easy_cell = std::max(stage.least_cell, look.least_text > 0 && grid.axes ? 11 / unit_of(look) : 0.0);
  stage.largest_cell = slide ? 84 : 108;
  return stage;
}

std::optional<Fit> fit(const Stage& stage, double width, double height) {
  const double across = width - stage.left - stage.right, up = height - stage.below - stage.above;
  const double cell = std::min({across / static_cast<double>(stage.cells.width()),
                                up / static_cast<double>(stage.cells.height()), stage.largest_cell});
  if (cell >= stage.least_cell) return Fit{cell, stage.cells.width(), stage.cells.height(), false};
  if (stage.fixed) return std::nullopt;
  const auto count = [](double room, std::int64_t all) {
    return std::clamp<std::int64_t>(static_cast<std::int64_t>(room / followed_cell), 0, all);
  };
  const Fit above{followed_cell, count(across, stage.cells.width()),
                  count(up - inset_height - inset_gap, stage.cells.height()), true, false};
  const Fit beside{followed_cell, count(across - inset_width - inset_column_gap, stage.cells.width()),
                   count(up, stage.cells.height()), true, true};
  const auto cells = [](const Fit& f) { return static_cast<double>(f.columns * f.rows); };
  const Fit& better = cells(beside) > 1.25 * cells(above) ? beside : above;
  return cells(better) > 0 ? std::optional(better) : std::nullopt;
}

Fit capacity(const Stage& stage, double width, double height) {
  const auto count = [&stage](double room) {
    return static_cast<std::int64_t>(std::max(0.0, std::floor(room / stage.least_cell)));
  };
  return {stage.least_cell, count(width - stage.left - stage.right),
          count(height - stage.below - stage.above)};
}

Scene scene_of(const Figure& figure, const Look& look, const Stage& stage, const Box& slot, double s) {
  const std::optional<Fit> shown = fit(stage, slot.width / s, slot.height / s);
  Scene scene;
  if (!shown) return scene;
  scene.follows = shown->follows;
  scene.beside = shown->beside;
  Box box = slot;
  if (scene.beside) {
    box.width -= (inset_width + inset_column_gap) * s;
    scene.inset = {slot.right() - inset_width * s, slot.y + stage.above * s, inset_width * s,
                   slot.height - (stage.above + stage.below) * s};
  } else if (scene.follows) {
    scene.inset = {box.x, box.y + 4 * s, box.width, inset_height * s};
    box = {box.x, box.y + (inset_height + inset_gap) * s, box.width,
           box.height - (inset_height + inset_gap) * s};
  }
  // The cells with their axes, in the middle of what is left
  const double cell = shown->cell * s;
  const double width = cell * static_cast<double>(shown->columns) + (stage.left + stage.right) * s;
  const double height = cell * static_cast<double>(shown->rows) + (stage.above + stage.below) * s;
  scene.settled = {box.x + (box.width - width) / 2, box.y + (box.height - height) / 2, width, height};
  scene.left = scene.settled.x;
  scene.frame = {scene.follows ? followed_view(stage.cells, *shown, figure.focus) : stage.cells,
                 {scene.settled.x + stage.left * s, scene.settled.y + stage.above * s,
                  width - (stage.left + stage.right) * s, height - (stage.above + stage.below) * s},
                 cell,
                 stage.y_up};
  scene.labels = look.crop ? with_room_for_labels(scene.settled, box, s) : box;
  if (look.crop) scene.settled = scene.labels;
  if (scene.follows) scene.settled = around(scene.settled, scene.inset);
  return scene;
}

void lay_out_drawing(Pen& pen, const Figure& figure, const Scene& scene) {
  if (scene.frame.cell > 0) DrawingLayout(pen, figure, scene).draw();
}

}  // namespace gradus::layout
