// The drawing slot: a grid, its cells, the marks over it, and texts where they are free of each other.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <utility>

#include "core/geometry.hpp"
#include "figure/aside.hpp"
#include "figure/layout/layout.hpp"
#include "figure/text/number_text.hpp"

namespace gradus::layout {
namespace {

class DrawingLayout {
 public:
  DrawingLayout(Pen& pen, const Figure& figure, const Scene& scene)
      : pen_(pen), figure_(figure), trace_(*figure.trace), s_(pen.scale()), at_(scene), frame_(scene.frame) {}

  void draw() {
    draw_picture();
    draw_cell_grounds();
    draw_cell_colors();
    if (!figure_.canvas->plane()) {
      for (const Mark& mark : trace_.backdrop) draw_ground(mark);  // a tint hides neither lines nor centres
      for (const auto& [id, mark] : figure_.canvas->marks()) draw_ground(mark);
      draw_grid();
      if (at_.numbered) lay_out_axes(pen_, trace_.grid, at_, free_);
    }
    draw_cell_outlines();
    if (at_.follows) {
      for (const Box& text : draw_overview(pen_, figure_, at_)) free_.texts.push_back(text);
    }
    const auto cells_taken = static_cast<std::ptrdiff_t>(free_.taken.size());
    for (const Mark& mark : trace_.backdrop) take(mark, true);
    draw_cell_texts();
    fixed_dots_.assign(free_.taken.begin() + cells_taken, free_.taken.end());
    fixed_strokes_ = free_.strokes.size();
    for (const auto& [id, mark] : figure_.canvas->marks()) take(mark, false);
    point_outside();
    place_texts();
    if (at_.ring) place_ring(frame_.point(*at_.ring));
    place_labels();
    draw_marks();
    for (auto& [id, disc] : ring_) pen_.disc(id, disc);
  }

 private:
  // --- The grid ------------------------------------------------------------------------------------------

  template <class F>
  void for_each_cell(F f) const {
    const Window& view = frame_.view;
    for (std::int64_t y = view.lower.y; y <= view.upper.y; ++y) {
      for (std::int64_t x = view.lower.x; x <= view.upper.x; ++x) {
        f(ivec2{static_cast<int>(x), static_cast<int>(y)});
      }
    }
  }
  /// Where a cell's pixel stands in a picture of the view.
  ivec2 pixel_of(ivec2 p) const {
    const Window& view = frame_.view;
    return {p.x - view.lower.x, frame_.y_up ? view.upper.y - p.y : p.y - view.lower.y};
  }
  Image picture_of_view() const {
    return {static_cast<int>(frame_.view.width()), static_cast<int>(frame_.view.height()), Rgba8{}};
  }
  /// All cells of the view; more than what is shown where a paper is cut inside a cell.
  Box cells_box() const {
    const Box a = frame_.square(frame_.view.lower), b = frame_.square(frame_.view.upper);
    return around(a, b);
  }

  void draw_picture() {
    const auto& picture = trace_.grid.picture;
    if (!picture) return;
    Image part = picture_of_view();
    for_each_cell([&](ivec2 p) {
      const ivec2 at = p - trace_.grid.cells.lower;
      if (picture->contains(at)) part[pixel_of(p)] = (*picture)[at];
    });
    pen_.image("picture", {cells_box(), std::move(part), {}});
  }

  void draw_cell_grounds() {
    for_each_cell([&](ivec2 p) {
      const auto look = figure_.canvas->at(p);
      if (!look || look->color) return;
      draw_cell_ground(pen_, fmt::format("cell {},{}", p.x, p.y), look->role, frame_.square(p));
      if (!look->text.empty()) cell_texts_.emplace_back(p, *look);
      note_cell(p, look->role);
    });
  }

  /// Cells with colours of their own, as one picture: of a grid, or on a paper of these cells alone.
  void draw_cell_colors() {
    std::optional<Window> colored;
    for_each_cell([&](ivec2 p) {
      const auto look = figure_.canvas->at(p);
      if (!look || !look->color) return;
      if (!colored) colored = Window{p, p};
      colored = Window{glm::min(colored->lower, p), glm::max(colored->upper, p)};
      if (!look->text.empty()) cell_texts_.emplace_back(p, *look);
    });
    if (!colored) return;
    const Window shown = figure_.canvas->plane() ? *colored : frame_.view;
    Image part(static_cast<int>(shown.width()), static_cast<int>(shown.height()), {0, 0, 0, 0});
    for_each_cell([&](ivec2 p) {
      const auto look = figure_.canvas->at(p);
      if (!look || !look->color) return;
      part[{p.x - shown.lower.x, frame_.y_up ? shown.upper.y - p.y : p.y - shown.lower.y}] = *look->color;
    });
    pen_.image("colours",
               {around(frame_.square(shown.lower), frame_.square(shown.upper)), std::move(part), {}});
  }

  /// What labels should not cover.
  void note_cell(ivec2 p, Role role) {
    if (role == Role::past || role == Role::boundary || role == Role::result) {
      free_.crowded.emplace_back(frame_.square(p), role == Role::boundary ? 300 : 60);
    } else {
      free_.taken.push_back(frame_.square(p));
    }
  }

  /// The cells in view that are the grid's own: those of a shelf are not.
  Window own_cells() const { return at_.own_cells(trace_.grid); }

  void draw_grid() {
    constexpr double least_ruled = 6;  // smaller cells are the pixels of a picture
    const Window own = own_cells();
    if (own.empty() || frame_.cell < least_ruled * s_) return;
    const Box b = around(frame_.square(own.lower), frame_.square(own.upper));
    StrokesShape grid{{}, Paint::of(Tone::rule), 1.5 * s_};
    for (std::int64_t i = 0; i <= own.width(); ++i) {
      const double x = b.x + static_cast<double>(i) * frame_.cell;
      grid.segments.push_back({{x, b.y}, {x, b.bottom()}});
    }
    for (std::int64_t i = 0; i <= own.height(); ++i) {
      const double y = b.y + static_cast<double>(i) * frame_.cell;
      grid.segments.push_back({{b.x, y}, {b.right(), y}});
    }
    pen_.strokes("grid", std::move(grid));
    constexpr double least_dotted = 14;  // in smaller cells a dot would be a shade
    if (!trace_.grid.picture && frame_.cell >= least_dotted * s_) take_centres();
  }

  void take_centres() {
    const Window own = own_cells();
    for_each_cell([&](ivec2 p) {
      if (!own.contains(p)) return;
      const auto look = figure_.canvas->at(p);
      if (look && (look->role == Role::boundary || look->color || !look->text.empty())) return;
      centres_.push_back(frame_.point({p.x, p.y}));
    });
  }

  /// But for those beside a text, which would read as its punctuation.
  void draw_centres() {
    StrokesShape dots{{}, Paint::mark(Role::past), 4.4 * s_, true};
    std::vector<Box> texts;
    for (const auto& [id, text] : letters_) texts.push_back(grown(text.box(), 8 * s_));
    for (const dvec2 centre : centres_) {
      if (std::ranges::none_of(texts, [&](const Box& text) { return inside(centre, text); }))
        dots.segments.push_back({centre, centre});
    }
    if (!dots.segments.empty()) pen_.strokes("centres", std::move(dots));
  }

  /// A text in a cell, and the ground that it brings along: on a colour of its own the stronger contrast.
  static std::pair<Paint, Paint> text_paints(const CellLook& look) {
    if (!look.color) return {Paint::on(look.role), Paint::fill(look.role)};
    const Rgba8& c = *look.color;
    const bool dark = 0.299 * c.r + 0.587 * c.g + 0.114 * c.b < 90;
    return dark ? std::pair{Paint::of(Tone::paper), Paint::of(Tone::ink)}
                : std::pair{Paint::of(Tone::ink), Paint::of(Tone::paper)};
  }

  void draw_cell_outlines() {
    for_each_cell([&](ivec2 p) {
      if (const auto look = figure_.canvas->at(p); look && !look->color) {
        draw_cell_outline(pen_, fmt::format("outline {},{}", p.x, p.y), look->role, frame_.square(p));
      }
    });
  }

  /// Where a text stands in its cell: in the middle, or, on a colour of its own, off the lines that stand
  /// through all steps.
  dvec2 text_place(ivec2 p, const CellLook& look, double width) const {
    const dvec2 centre = frame_.point({p.x, p.y});
    if (!look.color || free_.strokes.empty()) return centre;
    const double enough = 0.4 * frame_.cell;
    const dvec2 spare = glm::max(0.5 * (frame_.cell - dvec2{width, text_size * s_}) - 3 * s_, dvec2(0));
    dvec2 best = centre;
    double most = -1;
    for (int k = 0; k < 25; ++k) {
      // The middle comes first
      const int place = (k + 12) % 25;
      const dvec2 off = 0.5 * spare * dvec2{place % 5 - 2, place / 5 - 2};
      double clear = enough;
      for (const auto& line : free_.strokes) clear = std::min(clear, distance_of_text(centre + off, line));
      clear -= 0.1 * length_of(off);
      if (clear > most + 1e-6) most = clear, best = centre + off;
    }
    return best;
  }
  /// A text is wider than high.
  static double distance_of_text(dvec2 p, const Segment<2, double>& line) {
    const dvec2 narrowed{0.8, 1}, way = (line.b - line.a) * narrowed, to = (p - line.a) * narrowed;
    const double length = glm::dot(way, way);
    return length_of(to - way * (length > 0 ? std::clamp(glm::dot(to, way) / length, 0.0, 1.0) : 0));
  }
  /// Before any mark of the step is known: numbers keep still.
  void draw_cell_texts() {
    for (const auto& [p, look] : cell_texts_) {
      const double size = text_size * s_, width = text_width(look.text, Face::sans, size);
      if (width > frame_.cell - 2 * s_ || frame_.cell < 26 * s_) continue;
      const dvec2 centre = text_place(p, look, width);
      const auto [ink, ground] = text_paints(look);
      const TextShape text{
          {centre.x, centre.y + 7 * s_}, look.text, Face::sans, size, Align::centre, ink, true, ground};
      // Over a value of the picture nothing is written; over others no ring is drawn
      (look.color ? free_ : written_).texts.push_back(text.box());
      pen_.text(fmt::format("text {},{}", p.x, p.y), text);
    }
  }

  // --- Marks: taken first, drawn once the texts have their places -----------------------------------------

  void take(const Mark& mark, bool fixed) {
    if ((at_.among_many || at_.bare) && stands_aside(mark)) return;
    if (figure_.canvas->plane()) draw_ground(mark);
    if (const Stroke* stroke = std::get_if<Stroke>(&mark.shape)) {
      take_chain(mark, {stroke->a, stroke->b},
                 {.arrow = stroke->arrow, .dashed = stroke->dashed, .thin = stroke->thin});
    } else if (const Path* path = std::get_if<Path>(&mark.shape)) {
      take_chain(mark, path->points, {.closed = path->closed, .dashed = path->dashed});
    } else if (const Dot* dot = std::get_if<Dot>(&mark.shape)) {
      take_dot(mark, *dot);
    } else if (const Text* text = std::get_if<Text>(&mark.shape)) {
      texts_.emplace_back(&mark, text);
    } else if (const Label* label = std::get_if<Label>(&mark.shape)) {
      (fixed ? fixed_labels_ : labels_).emplace_back(&mark, label);
    }
  }

  void draw_ground(const Mark& mark) {
    if (const Area* area = std::get_if<Area>(&mark.shape)) draw_area(mark, *area);
    const Picture* picture = std::get_if<Picture>(&mark.shape);
    if (!picture) return;
    ImageShape shape = image_in(frame_, *picture);
    free_.crowded.emplace_back(shape.box, 300);
    pen_.image(mark.id, std::move(shape));
  }
  void draw_area(const Mark& mark, const Area& area) {
    std::vector<std::vector<dvec2>> rings;
    for (const auto& ring : area.rings) {
      std::vector<dvec2> points;
      for (const dvec2 p : ring) points.push_back(frame_.point(p));
      points = inside_of(std::move(points), frame_.box);
      if (points.size() >= 3) rings.push_back(std::move(points));
    }
    if (!rings.empty()) pen_.area(mark.id, area_in(std::move(rings), mark.role, area.shade));
  }

  void take_chain(const Mark& mark, const std::vector<dvec2>& points, const ChainLook& look) {
    if (points.empty()) return;
    LineShape line = line_through({}, mark.role, look, s_);
    const auto keep = [&] {
      if (line.points.size() >= 2) {
        auto& among = mark.role == Role::guide ? guides_ : lines_;
        among.emplace_back(mark.id, line);
      }
      line.points.clear();
    };
    const std::size_t ends = look.closed ? points.size() : points.size() - 1;
    bool whole = look.closed;
    line.closed = line.arrow = false;
    for (std::size_t i = 0; i < ends; ++i) {
      const dvec2 from = frame_.point(points[i]), to = frame_.point(points[(i + 1) % points.size()]);
      const auto part = clipped(from, to, frame_.box);
      whole = whole && part && *part == Segment{from, to};
      if (!part || (!line.points.empty() && line.points.back() != part->a)) keep();
      if (!part) continue;
      free_.strokes.push_back(*part);
      if (line.points.empty()) line.points.push_back(part->a);
      line.points.push_back(part->b);
    }
    if (whole) line.points.pop_back();
    line.closed = whole;
    line.arrow = look.arrow;
    keep();
  }

  void take_dot(const Mark& mark, const Dot& dot) {
    const dvec2 at = frame_.point(dot.at);
    if (!inside(at, grown(frame_.box, 1e-6))) return;
    dots_.emplace_back(mark.id, disc_at(at, mark_paint(trace_, mark), dot.ring, s_));
    const double radius = dots_.back().second.radius;
    free_.taken.push_back({at.x - radius, at.y - radius, 2 * radius, 2 * radius});
  }

  /// Where the step happens when that is not in the view: an arrow at its border, and the cell.
  void point_outside() {
    const ivec2 focus = figure_.focus;
    if (!trace_.grid.axes || frame_.view.contains(focus) || !trace_.grid.cells.contains(focus)) return;
    const Box& b = frame_.box;
    const dvec2 centre{b.x + b.width / 2, b.y + b.height / 2};
    const auto inner = clipped(centre, frame_.point({focus.x, focus.y}), grown(b, -4 * s_));
    if (!inner) return;
    const dvec2 tip = inner->b, way = tip - centre;
    const dvec2 tail = tip - way * (30 * s_ / length_of(way));
    free_.taken.push_back({std::min(tip.x, tail.x), std::min(tip.y, tail.y), std::abs(tip.x - tail.x),
                           std::abs(tip.y - tail.y)});
    lines_.emplace_back("outside", line_through({tail, tip}, Role::current, {.arrow = true}, s_));
    outside_ = Mark{
        "outside name", Role::current,
        Label{frame_.place(tail), fmt::format("({}, {})", figure_number(focus.x), figure_number(focus.y))}};
  }

  // --- Texts ---------------------------------------------------------------------------------------------

  /// Over all lines; those that stand through all steps were taken first, so that they keep still.
  void place_texts() {
    for (const auto& [mark, text] : texts_) {
      const dvec2 at = frame_.point(text->at);
      if (!inside(at, grown(frame_.box, 1))) continue;
      const double size = text_size * s_;
      TextShape shape{{at.x, at.y + text->line * paragraph_line * s_ + 0.35 * size},
                      text->text,
                      Face::sans,
                      size,
                      text->align,
                      text_paint(trace_, *mark),
                      true,
                      Paint::of(Tone::paper)};
      if (at_.among_many && lies_on_a_line(letters_of(shape)))
        continue;  // the size never gives way, names do
      if (!has_room(shape)) continue;
      if (text->line == 0) shape.baseline += way_off_dots(shape);
      free_.texts.push_back(shape.box());
      letters_.emplace_back(mark->id, std::move(shape));
    }
  }
  /// Above capitals and, but for tails, below the line there is nothing.
  static Box letters_of(const TextShape& text) {
    const Box box = text.box();
    return {box.x, box.y + 0.2 * text.size, box.width, box.height - 0.4 * text.size};
  }
  bool has_room(const TextShape& text) const {
    const auto lies_on = [](const std::vector<Box>& texts, const Box& mine) {
      return std::ranges::any_of(texts, [&](const Box& other) { return overlap(mine, other); });
    };
    return inside(letters_of(text), grown(at_.labels, s_)) &&
           !lies_on(free_.texts, grown(text.box(), 2 * s_)) && !lies_on(written_.texts, text.box());
  }
  bool lies_on_a_dot(const Box& letters) const {
    return std::ranges::any_of(dots_, [&](const auto& dot) {
      const dvec2 at = dot.second.centre,
                  nearest = glm::clamp(at, {letters.x, letters.y}, {letters.right(), letters.bottom()});
      return glm::distance(at, nearest) < dot.second.radius;
    });
  }
  /// A text that a dot would cover stands a little aside, if there is room.
  dvec2 way_off_dots(const TextShape& text) const {
    if (!lies_on_a_dot(letters_of(text))) return {};
    for (double far = 4; far <= 40; far += 4) {
      for (const dvec2 way : {dvec2{0, -1}, {0, 1}, {-1, 0}, {1, 0}}) {
        TextShape aside = text;
        aside.baseline += way * (far * s_);
        if (has_room(aside) && !lies_on_a_dot(letters_of(aside))) return way * (far * s_);
      }
    }
    return {};
  }

  /// Round what is pointed at; labels keep off it.
  void place_ring(dvec2 at) {
    std::ranges::copy(free_.texts, std::back_inserter(written_.texts));
    const double r = ring_radius(written_, at, std::max(16 * s_, std::min(0.75 * frame_.cell, 40 * s_)), s_);
    if (r == 0) return;
    free_.texts.push_back(grown({at.x, at.y, 0, 0}, r + 3 * s_));
    ring_.emplace_back("ring halo", DiscShape{at, r, {}, Paint::of(Tone::paper), 7 * s_});
    ring_.emplace_back("ring", DiscShape{at, r, {}, Paint::mark(Role::measure), 4 * s_});
  }

  void place(const Mark& mark, const Label& label, double gap, double clear) {
    const dvec2 anchor = frame_.point(label.at);
    if (!inside(anchor, grown(frame_.box, 1))) return;
    const double size = text_size * s_;
    const auto placed = place_label(free_, at_.labels, anchor,
                                    {text_width(label.text, Face::sans, size), size}, gap, clear, s_);
    const bool secondary = at_.among_many && mark.role != Role::current;
    if (!placed || (secondary && (placed->leader || lies_on_a_line(placed->box)))) return;
    if (placed->leader) {
      free_.leaders.push_back(*placed->leader);
      leaders_.emplace_back("leader " + mark.id, LineShape{{placed->leader->a, placed->leader->b},
                                                           text_paint(trace_, mark),
                                                           1.4 * s_,
                                                           false,
                                                           false,
                                                           false});
    }
    TextShape shape{{placed->box.x, placed->box.y + 0.78 * placed->box.height},
                    label.text,
                    Face::sans,
                    size,
                    Align::left,
                    text_paint(trace_, mark),
                    true,
                    Paint::of(Tone::paper)};
    free_.texts.push_back(shape.box());
    letters_.emplace_back(mark.id, std::move(shape));
  }

  void place_labels() {
    const double gap = trace_.grid.axes ? frame_.cell / 2 + 10 * s_ : 13 * s_;
    // Those that stand through all steps come first and look only at what stands too, so that they keep still
    auto taken = std::exchange(free_.taken, fixed_dots_);
    auto crowded = std::exchange(free_.crowded, {});
    auto strokes = free_.strokes;
    free_.strokes.resize(fixed_strokes_);
    const double clear = trace_.grid.axes ? frame_.cell : 2 * s_;
    for (const auto& [mark, label] : fixed_labels_) place(*mark, *label, gap, clear);
    free_.taken = std::move(taken);
    free_.crowded = std::move(crowded);
    free_.strokes = std::move(strokes);
    if (outside_) place(*outside_, std::get<Label>(outside_->shape), 12 * s_, 2 * s_);
    // What was chosen and what was not have the first pick, a length the last
    std::ranges::stable_partition(labels_, [](const auto& l) { return l.first->role != Role::measure; });
    for (const auto& [mark, label] : labels_) place(*mark, *label, gap, 2 * s_);
  }

  // --- On the sheet --------------------------------------------------------------------------------------

  /// A text's rim hides what lies below it: the grid and tints always, lines only where the letters lie on
  /// them, dots never.
  bool lies_on_a_line(const Box& box) const {
    return std::ranges::any_of(
        free_.strokes, [&](const auto& stroke) { return clipped(stroke.a, stroke.b, box).has_value(); });
  }

  void draw_marks() {
    const auto rims = [&](bool on_lines) {
      for (const auto& [id, text] : letters_) {
        if (lies_on_a_line(text.box()) != on_lines) continue;
        TextShape rim = text;
        rim.paint = {};
        pen_.text("rim " + id, std::move(rim));
      }
    };
    draw_centres();
    rims(false);
    for (auto& [id, line] : guides_) pen_.line(id, std::move(line));
    for (auto& [id, line] : leaders_) pen_.line(id, std::move(line));
    for (auto& [id, line] : lines_) pen_.line(id, std::move(line));
    rims(true);
    for (auto& [id, dot] : dots_) pen_.disc(id, dot);
    for (auto& [id, text] : letters_) {
      text.halo = false;
      pen_.text(id, std::move(text));
    }
  }

  template <class S>
  using Named = std::vector<std::pair<std::string, S>>;

  Pen& pen_;
  const Figure& figure_;
  const Trace& trace_;
  double s_;
  const Scene& at_;
  const Frame& frame_;
  std::vector<dvec2> centres_;  ///< of the cells that have a dot there
  std::vector<std::pair<ivec2, CellLook>> cell_texts_;
  std::vector<std::pair<const Mark*, const Text*>> texts_;
  std::vector<std::pair<const Mark*, const Label*>> fixed_labels_, labels_;
  std::optional<Mark> outside_;    ///< the label of a step outside the view
  std::size_t fixed_strokes_ = 0;  ///< those that stand through all steps come first
  std::vector<Box> fixed_dots_;
  Obstacles free_;     ///< what texts are to be free of
  Obstacles written_;  ///< in cells; and once a ring is placed, all texts

  Named<LineShape> guides_, lines_, leaders_;
  Named<DiscShape> dots_, ring_;
  Named<TextShape> letters_;
};

}  // namespace

void lay_out_drawing(Pen& pen, const Figure& figure, const Scene& scene) {
  if (scene.frame.cell > 0) DrawingLayout(pen, figure, scene).draw();
}

}  // namespace gradus::layout
