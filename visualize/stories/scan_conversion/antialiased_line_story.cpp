// The story of a line without stairs: how much of it each pixel gets, by three answers.

#include "scan_conversion/antialiased_line/antialiased_line.hpp"

#include "scan_conversion/antialiased_line/antialiased_line_notes.hpp"
#include "stories/scan_conversion/antialiased_line/drawing.hpp"
#include "stories/scan_conversion/antialiased_line/pictures.hpp"

namespace gradus::antialiased_line {
namespace {

constexpr auto drop = [](ivec2, auto) {};

/// The step that a figure shows where nobody names one: the one worth most, of equal ones the first.
class Telling {
 public:
  void offer(std::int64_t step, double worth) {
    if (step_ && worth <= worth_) return;
    step_ = {step, 0};
    worth_ = worth;
  }
  void give_to(Narrator& narrator) const {
    if (step_ && has_step(narrator.trace(), *step_)) narrator.telling(*step_);
  }

 private:
  std::optional<StepNumber> step_;
  double worth_ = 0;
};

// --- Two pixels per column

class WuStory {
 public:
  WuStory(const Words& words, const Subject& subject) : words_(words), subject_(subject) {}

  const Telling& telling() const { return telling_; }

  void show(Board& board, const Started& s) {
    board.milestone(s.from);
    put_paper(board, subject_.cells);
    put_pixel(board, s.from, full);
    put_pixel(board, s.to, full);
  }
  Event say(const Started& s) const {
    return {.text = subject_.point() ? "started.point" : "started",
            .facts = {{"from", s.from}, {"to", s.to}, {"dx", s.dx}, {"dy", s.dy}},
            .words = {{"slope", slope()}},
            .row = {0, s.from.x, s.from.y, "0", full, none},
            .key = pixel_key(s.from)};
  }

  void show(Board& board, const Paired& p) {
    board.milestone(p.front);
    const Whole last = subject_.size.dx;
    // Of such steps the last, by which most of the line is drawn
    telling_.offer(p.k, (p.over && p.far > 0 ? 2 : p.far > 0 ? 1 : 0) + 1e-3 * static_cast<double>(p.k));
    const bool middle = 2 * p.k == last;
    if (!middle || subject_.go.tie) put_pair(board, p.front, aside(), p.far);
    if (!middle || !subject_.go.tie) put_pair(board, p.back, -aside(), p.far);
    if (!middle) outline(board, "back", Role::candidate, p.back, -aside(), p.far);
    outline(board, "front", Role::current, p.front, aside(), p.far);
    if (p.far == none) return;
    const dvec2 centre(p.front), crossing = centre + fraction(p.k) * subject_.aside();
    board.mark("fraction", Role::measure, Stroke{centre, crossing});
    board.mark("crossing", Role::measure, Dot{crossing});
    board.mark("fraction name", Role::measure, Label{0.5 * (centre + crossing), fraction_text(p.k)});
  }
  Event say(const Paired& p) const {
    return {.text = p.far == none ? "paired.centre"
                    : p.over      ? "paired.over"
                                  : "paired.straight",
            .facts = {{"front", p.front, "pixel"},
                      {"back", p.back, "pixel"},
                      {"over", p.over},
                      {"near", p.near},
                      {"far", p.far}},
            .words = {{"before", fraction_text(p.k - 1)},
                      {"slope", slope()},
                      {"place", fraction_text(p.k)},
                      {"pixel", p.front},
                      {"other", p.front + aside()}},
            .row = {p.k, p.front.x, p.front.y, fraction_text(p.k), p.near, p.far},
            .key = pixel_key(p.front),
            .decides =
                yes_or_no(words_, "question.over", {{"before", fraction_text(p.k - 1)}, {"slope", slope()}},
                          p.over, "diagonal", "straight")};
  }

  void show(Board& board, const Finished&) { board.detail(subject_.to); }
  Event say(const Finished& f) const {
    const double ink =
        subject_.point() ? 1 : static_cast<double>(subject_.size.dx) / length_of(subject_.size);
    return {.text = "done", .facts = {{"columns", f.columns}, {"ink", ink}}, .count = f.columns};
  }

 private:
  ivec2 aside() const { return subject_.go.diagonal - subject_.go.straight; }
  static void put_pair(Board& board, ivec2 pixel, ivec2 aside, int far) {
    put_pixel(board, pixel, full - far);
    if (far > none) put_pixel(board, pixel + aside, far);
  }
  static void outline(Board& board, std::string id, Role role, ivec2 pixel, ivec2 aside, int far) {
    if (far > none) board.mark(id + " far", role, outline_of(pixel + aside));
    board.mark(id, role, outline_of(pixel));
  }
  std::string slope() const {
    return subject_.point() ? "0" : figure_fraction(subject_.size.dy, subject_.size.dx);
  }
  /// How far aside of its pixel the line passes in column k: exactly.
  std::string fraction_text(Whole k) const {
    return figure_fraction(k * subject_.size.dy % subject_.size.dx, subject_.size.dx);
  }
  double fraction(Whole k) const {
    return static_cast<double>(k * subject_.size.dy % subject_.size.dx) /
           static_cast<double>(subject_.size.dx);
  }

  const Words& words_;
  const Subject& subject_;
  Telling telling_;
};

// --- A cone about each pixel

/// How distances are taken: at right angles to the axis, or, by mistake, along the column.
enum class Way { right, along_column };

class ConeStory {
 public:
  ConeStory(const Words& words, const Subject& subject, Way way)
      : words_(words), subject_(subject), way_(way) {}

  const Telling& telling() const { return telling_; }
  std::int64_t wrong() const { return wrong_; }

  void show(Board& board, const Started& s) {
    board.milestone(s.from);
    put_paper(board, subject_.cells);
  }
  Event say(const Started& s) const {
    return {.text = "started.cone",
            .facts = {{"from", s.from}, {"to", s.to}, {"dx", s.dx}, {"dy", s.dy}},
            .key = pixel_key(s.from)};
  }

  void show(Board& board, const Measured& m) {
    if (m.intensity == none) return;
    ++milestones_;
    if (is_wrong(m)) ++wrong_;
    offer(m);
    board.milestone(m.pixel);
    if (m.k != column_) clear_column(board);
    column_ = m.k;
    number_.put(board, m.pixel, m.intensity);
    const dvec2 centre(m.pixel);
    board.mark("at", Role::current, outline_of(m.pixel));
    board.mark("cone", Role::candidate, Path{disc_between(centre, subject_.across(), -1, 1), true});
    const double beside = at_right_angles(m);
    const double least = std::max(-1.0, beside - 0.5), most = std::min(1.0, beside + 0.5);
    board.mark("within", Role::candidate, Area{{disc_between(centre, subject_.across(), least, most)}, 2});
    const dvec2 way = way_ == Way::right ? subject_.across() : subject_.aside();
    const std::string id = fmt::format("distance {}", m.row);
    board.keep(id, Role::measure, Stroke{centre, centre + m.beside * way});
    distances_.push_back(id);
    board.mark("distance name", Role::measure,
               Label{centre + 0.5 * m.beside * way, figure_real(std::abs(m.beside))});
  }
  Event say(const Measured& m) const {
    const double distance = std::abs(m.beside), part = cone_share(distance);
    Event event{.text = verdict(m),
                .facts = {{"pixel", m.pixel},
                          {"beside", m.beside, "distance"},
                          {"part", part},
                          {"intensity", m.intensity}},
                .words = {{"distance", distance},
                          {"right", std::abs(at_right_angles(m))},
                          {"correct", cone_table().at(std::abs(at_right_angles(m)))}},
                .row = {m.pixel.x, m.pixel.y, distance, part, m.intensity},
                .key = pixel_key(m.pixel)};
    event.decides =
        yes_or_no(words_, "question.centre", {{"pixel", m.pixel}}, distance < 0.5, "inside", "outside");
    return event;
  }

  void show(Board& board, const Finished&) {
    board.detail(subject_.to);
    clear_column(board);
  }
  Event say(const Finished& f) const {
    return {.text = way_ == Way::right ? "done.cone" : "done.along_column",
            .facts = {{"columns", f.columns}},
            .words = {{"wrong", wrong_}, {"n", milestones_}}};
  }

 private:
  std::string_view verdict(const Measured& m) const {
    if (way_ == Way::along_column) return is_wrong(m) ? "measured.wrong" : "measured.same";
    // Never 1/2 itself: no multiple of the extents' common divisor is half the length of an even diagonal
    return std::abs(m.beside) < 0.5 ? "measured.inside" : "measured.outside";
  }
  /// The distance of the axis, positive on the side of `across`.
  double at_right_angles(const Measured& m) const {
    if (way_ == Way::right || subject_.point()) return m.beside;
    return m.beside * static_cast<double>(subject_.size.dx) / length_of(subject_.size);
  }
  bool is_wrong(const Measured& m) const {
    return way_ == Way::along_column && m.intensity != cone_table().at(std::abs(at_right_angles(m)));
  }
  /// In the middle column the pixel aside that has a good part; of the mistake where it is largest.
  void offer(const Measured& m) {
    const double off = std::abs(std::abs(m.beside) - 0.6);
    const int lack = std::abs(m.intensity - cone_table().at(std::abs(at_right_angles(m))));
    const bool middle = m.k == (subject_.size.dx + 1) / 2;
    telling_.offer(milestones_, way_ == Way::right ? (middle ? 2 : 0) - off : lack);
  }
  void clear_column(Board& board) {
    for (const std::string& id : distances_) board.remove(id);
    distances_.clear();
  }

  const Words& words_;
  const Subject& subject_;
  const Way way_;
  std::int64_t milestones_ = 0, wrong_ = 0;
  Whole column_ = -1;
  std::vector<std::string> distances_;
  NumberedPixel number_;
  Telling telling_;
};

// --- The exact area

class AreaStory {
 public:
  AreaStory(const Words& words, const Subject& subject) : words_(words), subject_(subject) {}

  const Telling& telling() const { return telling_; }
  double sum() const { return sum_; }

  void show(Board& board, const Started& s) {
    board.milestone(s.from);
    put_paper(board, subject_.cells);
  }
  Event say(const Started& s) const {
    return {.text = subject_.point() ? "started.no_area" : "started.area",
            .facts = {{"from", s.from}, {"to", s.to}, {"dx", s.dx}, {"dy", s.dy}},
            .words = {{"length", length()}},
            .key = pixel_key(s.from)};
  }

  void show(Board& board, const Cut& c) {
    ++pixels_;
    sum_ += c.area;
    const bool middle = 2 * c.k >= subject_.size.dx && 2 * c.k <= subject_.size.dx + 2;
    telling_.offer(pixels_, (middle ? 1 : 0) + (0.15 < c.area && c.area < 0.85 ? 2 : 0) +
                                0.1 * static_cast<double>(c.piece.count));
    board.milestone(c.pixel);
    number_.put(board, c.pixel, byte_of(c.area));
    const std::vector<dvec2> corners = corners_of(c);
    board.mark("piece area", Role::past, Area{{corners}});
    board.mark("piece", Role::current, Path{corners, true});
    board.mark("pixel", Role::candidate, outline_of(c.pixel));
  }
  Event say(const Cut& c) const {
    const bool whole = byte_of(c.area) == full;
    return {.text = whole ? "cut.whole" : "cut.part",
            .facts = {{"pixel", c.pixel}, {"area", c.area}, {"byte", byte_of(c.area), "intensity"}},
            .words = {{"corners", corners_of(c).size()}},
            .row = {c.pixel.x, c.pixel.y, corners_of(c).size(), c.area, byte_of(c.area)},
            .key = pixel_key(c.pixel),
            .decides = yes_or_no(words_, "question.whole", {{"pixel", c.pixel}}, whole, "whole", "part")};
  }

  void show(Board& board, const Finished&) { board.detail(subject_.to); }
  Event say(const Finished& f) const {
    return {.text = "done.area",
            .facts = {{"columns", f.columns}, {"sum", sum_}},
            .words = {{"length", length()}, {"n", pixels_}}};
  }

 private:
  double length() const { return subject_.point() ? 0 : length_of(subject_.size); }
  /// Where the corners of a piece are in the drawing; those that rounding has made of one are one.
  std::vector<dvec2> corners_of(const Cut& c) const {
    std::vector<dvec2> corners;
    for (std::size_t i = 0; i < c.piece.count; ++i) {
      const dvec2 corner = c.piece.corners[i];
      const dvec2 at = dvec2(c.pixel) + corner.x * subject_.straight() + corner.y * subject_.aside();
      const auto is_same = [&](dvec2 other) { return glm::distance(at, other) < 1e-9; };
      if (std::ranges::none_of(corners, is_same)) corners.push_back(at);
    }
    return corners;
  }

  const Words& words_;
  const Subject& subject_;
  std::int64_t pixels_ = 0;
  double sum_ = 0;
  NumberedPixel number_;
  Telling telling_;
};

// --- The methods

void tell_wu(Narrator& narrator) {
  const Subject subject = subject_of(narrator.arguments(), false);
  set_scene(narrator, subject, false);
  narrator.columns({{"k"}, {"x"}, {"y"}, {"fraction", false}, {"near"}, {"far"}});
  narrator.legend({{Role::boundary, "axis"},
                   {Role::current, "column"},
                   {Role::candidate, "other_end"},
                   {Role::measure, "fraction"}});
  WuStory story(narrator.words(), subject);
  wu(subject.from, subject.to, drop, narrator.watcher(story));
  story.telling().give_to(narrator);
  narrator.result({{"columns", subject.size.dx + 1}});
}

template <Way way, auto method>
void tell_cone(Narrator& narrator) {
  const Subject subject = subject_of(narrator.arguments(), true);
  set_scene(narrator, subject, true);
  narrator.columns({{"x"}, {"y"}, {"distance"}, {"part"}, {"intensity"}});
  narrator.legend({{Role::boundary, "line"},
                   {Role::current, "pixel"},
                   {Role::candidate, "cone"},
                   {Role::measure, way == Way::right ? "distance" : "along_column"}});
  ConeStory story(narrator.words(), subject, way);
  method(subject.from, subject.to, drop, narrator.watcher(story));
  story.telling().give_to(narrator);
  narrator.result({{"wrong", story.wrong()}});
}

void tell_area(Narrator& narrator) {
  const Subject subject = subject_of(narrator.arguments(), true);
  set_scene(narrator, subject, true);
  narrator.columns({{"x"}, {"y"}, {"corners"}, {"area"}, {"intensity"}});
  narrator.legend({{Role::boundary, "line"}, {Role::current, "piece"}, {Role::candidate, "pixel"}});
  AreaStory story(narrator.words(), subject);
  exact_area(subject.from, subject.to, drop, narrator.watcher(story));
  story.telling().give_to(narrator);
  narrator.result({{"sum", story.sum()}});
}

}  // namespace

const TopicEntry& entry();  // the catalogue asks for it by this name
const TopicEntry& entry() {
  static const TopicEntry topic = completed<entry>(
      {.name = "antialiased_line",
       .chapter = "scan_conversion",
       .aliases = {"wu", "wu line", "gupta sproull", "smooth line", "antialiasing of lines"},
       .summary = "a straight line without stairs: each pixel in the intensity of its part of the line",
       .methods =
           {{.name = "wu", .standing = Standing::taught, .tell = tell_wu},
            {.name = "gupta_sproull",
             .tell = tell_cone<Way::right, [](auto... run) { gupta_sproull(run...); }>},
            {.name = "exact_area", .tell = tell_area},
            {.name = "side_by_side", .tell = tell_pictures, .function = "wu", .unread = {"from", "to"}},
            {.name = "continued", .tell = tell_continued, .function = "wu"},
            {.name = "distance_along_column",
             .standing = Standing::faulty,
             .tell = tell_cone<Way::along_column, [](auto... run) { distance_along_column(run...); }>}},
       .parameters = {{"from", ParameterType::cell, "0,0", "0,0", "first pixel: column,row; y points up"},
                      {"to", ParameterType::cell, "7,3", "7,3", "last pixel"}},
       .examples = {"--from 0,0 --to 7,3", "--to 5,4 --method gupta_sproull", "--to 4,3 --method exact_area",
                    "--to 12,5 --method continued"}});
  return topic;
}

}  // namespace gradus::antialiased_line
