// The story of a window on the camera plane: which pixel of the picture each point gets, or that it gets
// none.

#include "projection/viewport/viewport.hpp"

#include "projection/viewport/viewport_notes.hpp"
#include "stories/checking.hpp"
#include "stories/parameters.hpp"
#include "stories/projection/viewport/drawing.hpp"
#include "stories/side_by_side.hpp"
#include "stories/telling.hpp"

namespace gradus::viewport {
namespace {

std::string difference_text(double a, double b) {
  return figure_real(a) + "\u00a0−\u00a0" + figure_factor(b);
}

class Story {
 public:
  Story(const Words& words, const Subject& subject, bool clamps)
      : words_(words),
        subject_(subject),
        clamps_(clamps),
        drawing_(subject, words, clamps),
        fates_(subject.points.size()),
        current_(subject.points.size()) {}

  void turn_to(std::size_t point) { current_ = point; }
  const Drawing& drawing() const { return drawing_; }
  const std::vector<Fate>& fates() const { return fates_; }
  std::int64_t outside() const { return std::ranges::count_if(fates_, &Fate::outside); }

  void show(Board& board, const steps::Started&) { board.milestone(view()); }
  Event say(const steps::Started&) const {
    const auto& [lower, upper] = subject_.map.window;
    return {.text = subject_.boxed ? "input_boxed" : "input",
            .words = {{"lower", lower},
                      {"upper", upper},
                      {"width", subject_.map.picture.x},
                      {"height", subject_.map.picture.y},
                      {"side", side()}},
            .type = "Input"};
  }

  void show(Board& board, const Measured<double>& m) {
    fates_[current_].fraction = m.fraction;
    board.detail(view());
  }
  Event say(const Measured<double>& m) const {
    const auto& [lower, upper] = subject_.map.window;
    const dvec2 p = m.point;
    return {.text = rows_down() ? "measured_from_top" : "measured_from_bottom",
            .facts = {{"u", m.fraction.x}, {"v", m.fraction.y}},
            .words = {{"name", name()},
                      {"across", difference_text(p.x, lower.x)},
                      {"width", upper.x - lower.x},
                      {"along", rows_down() ? difference_text(upper.y, p.y) : difference_text(p.y, lower.y)},
                      {"height", upper.y - lower.y}},
            .key = name()};
  }

  void show(Board& board, const Placed<double>& p) {
    fates_[current_].place = p.place;
    board.detail(view());
  }
  Event say(const Placed<double>& p) const {
    Event event{.text = "placed",
                .facts = {{"x", p.place.x}, {"y", p.place.y}},
                .words = {{"across", along(0, p)},
                          {"along", along(1, p)},
                          {"name", name()},
                          {"place", p.place},
                          {"side", side()}},
                .key = name()};
    if (!clamps_) event.decides = lies_inside();
    return event;
  }

  void show(Board& board, const Outside<double>&) {
    fates_[current_].outside = true;
    board.milestone(view());
  }
  Event say(const Outside<double>&) const {
    return landed(subject_.boxed ? "not_in_viewport" : "not_in_picture", lies_inside());
  }

  void show(Board& board, const Rounded<double>& r) {
    Fate& fate = fates_[current_];
    fate.nearest = r.pixel;
    if (clamps_) return;
    fate.outside = !r.there;
    if (r.there) fate.pixel = r.pixel;
    board.milestone(view());
  }
  Event say(const Rounded<double>& r) const {
    return landed(r.there ? rounded_text() : "no_pixel", subject_.rounding == Rounding::floor
                                                             ? lies_inside()
                                                             : has_pixel(r.there ? "inside" : "outside"));
  }

  void show(Board& board, const Clamped& c) {
    fates_[current_].pixel = c.pixel;
    board.milestone(view());
  }
  Event say(const Clamped& c) const {
    const bool moved = c.pixel != c.nearest;
    return landed(moved ? "clamped" : rounded_text(), has_pixel(moved ? "clamped" : "inside"));
  }

  void show(Board& board, const steps::Finished&) {
    turn_to(fates_.size());
    done_ = true;
    board.detail(view());
  }
  Event say(const steps::Finished&) const {
    return {.text = clamps_ ? "done_clamped" : "done",
            .facts = {{"outside", outside()}},
            .words = {{"points", fates_.size()}},
            .count = clamps_ ? std::ranges::count_if(fates_, &Fate::moved) : outside()};
  }

 private:
  View view() const { return drawing_.view(fates_, current_, done_, clamps_); }
  bool rows_down() const { return subject_.map.row_zero == RowZero::top; }
  std::string side() const { return words_.say(rows_down() ? "top" : "bottom"); }
  std::string name() const { return letter(current_); }

  /// "(−0.6 − (−1)) / 2 · 8 = 1.6", of the point at hand
  std::string formula(int axis) const {
    const auto& [lower, upper] = subject_.map.window;
    const auto& [from, to] = subject_.map.viewport;
    const dvec2 p = subject_.points[current_];
    const bool down = axis == 1 && rows_down();
    const std::string start = from[axis] == 0 ? "" : figure_real(from[axis]) + "\u00a0+\u00a0";
    return fmt::format("{}({})\u00a0/\u00a0{}\u00a0·\u00a0{}\u00a0=\u00a0{}", start,
                       down ? difference_text(upper.y, p.y) : difference_text(p[axis], lower[axis]),
                       figure_real(upper[axis] - lower[axis]), figure_real(to[axis] - from[axis]),
                       pixels_text((*fates_[current_].place)[axis]));
  }
  /// "1 + 0.25·6 = 2.5"
  std::string along(int axis, const Placed<double>& p) const {
    const auto& [lower, upper] = subject_.map.viewport;
    const std::string start = lower[axis] == 0 ? "" : figure_real(lower[axis]) + " + ";
    return fmt::format("{}{}·{} = {}", start, figure_factor(p.fraction[axis]),
                       figure_real(upper[axis] - lower[axis]), figure_real(p.place[axis]));
  }

  Decision decision(std::string_view question, bool yes, std::string_view branch) const {
    const Fate& now = fates_[current_];
    const ivec2 size = subject_.map.picture;
    return yes_or_no(words_, question,
                     {{"place", *now.place},
                      {"pixel", now.nearest.value_or(ivec2{})},
                      {"width", size.x},
                      {"height", size.y}},
                     yes, branch, branch);
  }
  Decision lies_inside() const {
    const bool inside = holds(subject_.map.viewport, *fates_[current_].place);
    return decision(subject_.boxed ? "question.viewport" : "question.picture", inside,
                    inside ? "inside" : "outside");
  }
  Decision has_pixel(std::string_view branch) const {
    return decision("question.pixel", subject_.map.has(*fates_[current_].nearest), branch);
  }

  /// Whether the nearest integers are those of the pixel that the point lies in.
  std::string_view rounded_text() const {
    if (subject_.rounding == Rounding::floor) return "floored";
    return own_pixel() == fates_[current_].nearest ? "rounded_to_own" : "rounded_away";
  }
  ivec2 own_pixel() const { return rounded(*fates_[current_].place, Rounding::floor); }

  /// The point has its pixel or is known to be outside.
  Event landed(std::string_view text, Decision decision) const {
    const Fate& now = fates_[current_];
    const dvec2 place = *now.place;
    const ivec2 nearest = now.nearest.value_or(ivec2{}), pixel = now.pixel.value_or(nearest);
    Event event{.text = text,
                .facts = {{"outside", now.outside}},
                .words = {{"name", name()},
                          {"place", place},
                          {"across", formula(0)},
                          {"along", formula(1)},
                          {"px", pixels_text(place.x)},
                          {"py", pixels_text(place.y)},
                          {"nearest", nearest},
                          {"pixel", pixel},
                          {"column", pixel.x},
                          {"row", pixel.y},
                          {"width", subject_.map.picture.x},
                          {"height", subject_.map.picture.y}},
                .note = words_.say("landed", {{"name", name()}}),
                .row = {name(), pixels_text(place.x), pixels_text(place.y),
                        now.pixel ? Said(pixel) : words_.say("outside")},
                .key = name(),
                .decides = std::move(decision),
                .type = now.outside ? "Outside" : "Rounded"};
    if (now.pixel) event.facts.push_back({"pixel", pixel});
    if (text == "rounded_away") event.words.push_back({"own", own_pixel()});
    return event;
  }

  const Words& words_;
  const Subject& subject_;
  const bool clamps_;
  Drawing drawing_;
  std::vector<Fate> fates_;
  std::size_t current_;
  bool done_ = false;
};

// --- The methods

Subject subject_of(const Arguments& arguments, Rounding rounding) {
  const std::vector<double> bounds = arguments.numbers("window");
  const Rectangle<double> window{{bounds[0], bounds[1]}, {bounds[2], bounds[3]}};
  if (!(window.lower.x < window.upper.x && window.lower.y < window.upper.y)) {
    refuse("window", "a window with an inside expected, found {}", arguments.text("window"));
  }
  const RowZero row_zero = arguments.text("row_zero") == "top" ? RowZero::top : RowZero::bottom;
  const bool boxed = arguments.text("fit") == "letterbox";
  const ivec2 picture = arguments.cell("resolution");
  Subject subject{boxed ? letterboxed(window, picture, row_zero) : stretched(window, picture, row_zero),
                  arguments.points("points"), rounding, boxed};
  const dvec2 room = subject.map.viewport.upper - subject.map.viewport.lower;
  if (std::min(room.x, room.y) < 1e-3) {
    refuse(arguments, {"window", "resolution", "fit"},
           fmt::format("expected a window of a shape that leaves more than a thousandth of a pixel between "
                       "the bars, found {}",
                       arguments.text("window")));
  }
  return subject;
}

/// take(point, observer): what the method does with a point.
template <class Take>
void tell_points(Narrator& narrator, const Subject& subject, bool clamps, const Take& take) {
  const Words& words = narrator.words();
  Story story(words, subject, clamps);
  require_scale(story.drawing().plane(), narrator.arguments(), {"window"});
  for (const std::string_view drawn : {"points", "window"})
    narrator.handles(drawn, shown_in(story.drawing().plane()));
  const auto count = std::ssize(subject.points);
  narrator.trace().subtitle =
      words.count("subtitle", count, {{"width", subject.map.picture.x}, {"height", subject.map.picture.y}});
  narrator.paper(36, 24);
  narrator.legend({Role::current,
                   Role::accepted,
                   Role::measure,
                   {Role::rejected, clamps ? "moved" : "rejected"},
                   {Role::candidate, clamps ? "true_line" : "candidate"},
                   Role::past,
                   Role::result,
                   Role::input});
  narrator.trace().legend.front().sample = Sample::dot;    // its way has an arrow, too
  if (clamps || count == 1) narrator.telling({count, 0});  // what lies outside stands last, as a rule
  narrator.tell_each(story, subject.points.size(),
                     [&](std::size_t i, const auto& watch) { take(subject.points[i], watch); });
  for (const Fate& fate : story.fates()) {
    if (fate.pixel) narrator.trace().pixels.push_back(*fate.pixel);
  }
  narrator.result({{"points", count}, {"pixels", count - story.outside()}});
}

/// What the steps of rasterize hold.
struct Numbers {
  template <class T>
  void operator()(NumericStep<T>& to, const Measured<T>& m) const {
    to.point("fraction", m.fraction);
  }
  template <class T>
  void operator()(NumericStep<T>& to, const Placed<T>& p) const {
    to.point("place", p.place);
  }
  template <class T>
  void operator()(NumericStep<T>&, const Outside<T>&) const {}
  template <class T>
  void operator()(NumericStep<T>& to, const Rounded<T>& r) const {
    to.decision(r.pixel.x);
    to.decision(r.pixel.y);
  }
};

/// The function that rounds by a rule.
constexpr std::string_view function_of(Rounding rounding) {
  return rounding == Rounding::floor     ? "by_floor"
         : rounding == Rounding::half_up ? "by_half_up"
                                         : "by_half_even";
}

template <Rounding rounding>
void tell_rounding(Narrator& narrator) {
  narrator.list(function_of(rounding));
  narrator.list_below("rasterize");
  const Subject subject = subject_of(narrator.arguments(), rounding);
  tell_points(narrator, subject, false,
              [&](dvec2 point, const auto& watch) { rasterize(subject.map, point, rounding, watch); });
  tell_side_by_side<Numbers>(narrator, [subject]<class T>(T, const auto& observer) {
    const auto rectangle = [](const Rectangle<double>& r) {
      return Rectangle<T>{in_scalar<T>(r.lower), in_scalar<T>(r.upper)};
    };
    const auto& [window, viewport, picture, row_zero] = subject.map;
    const Mapping<T> map{rectangle(window), rectangle(viewport), picture, row_zero};
    for (const dvec2 point : subject.points) rasterize(map, in_scalar<T>(point), rounding, observer);
  });
}

void tell_clamped(Narrator& narrator) {
  const Subject subject = subject_of(narrator.arguments(), Rounding::half_even);
  tell_points(narrator, subject, true,
              [&](dvec2 point, const auto& watch) { clamped(subject.map, point, subject.rounding, watch); });
}

/// A pixel for each point that has one.
const Checking& checking() {
  static const Checking known{.asked = {pixels_that_are(SameList::order)}};
  return known;
}

/// Of points and windows: then fractions of the one in the other neither overflow nor underflow.
constexpr Sizes sizes{1e-100, 1e100};

}  // namespace

const TopicEntry& entry() {  // the catalogue asks for it by this name
  using namespace parameters;
  const auto rounding = [](std::string name, Standing standing, void (*tell)(Narrator&)) {
    return Method{
        .name = std::move(name), .standing = standing, .tell = tell, .function = "rasterize", .exact = true};
  };
  static const TopicEntry topic = completed<entry>(
      {.name = "viewport",
       .chapter = "projection",
       .aliases = {"window to viewport", "rasterize", "screen coordinates"},
       .summary = "from a window on the camera plane to the pixels of a picture",
       .methods = {rounding("floor", Standing::taught, tell_rounding<Rounding::floor>),
                   rounding("half_up", Standing::plain, tell_rounding<Rounding::half_up>),
                   rounding("half_even", Standing::plain, tell_rounding<Rounding::half_even>),
                   {.name = "clamped", .standing = Standing::faulty, .tell = tell_clamped}},
       .columns = {{"point", false}, {"px"}, {"py"}, {"pixel", false}},
       .parameters = {points(1, 26, "points", "0.3,0.4 -0.6,-0.2 0.95,0.7 1.3,0.5", "0,0 0.5,0.3 2,1",
                             "points on the camera plane: x,y in its units, y up", xy, sizes),
                      bounds("window", "-1,-0.75,1,0.75", "-1,-1,1,1",
                             "what is seen of the plane: xmin,ymin,xmax,ymax",
                             {"xmin", "ymin", "xmax", "ymax"}, sizes),
                      {"resolution", ParameterType::cell, "8,6", "640,480",
                       "width and height of the picture in pixels", 1, 10'000},
                      choice("fit", {"stretch", "letterbox"}, "stretch", "letterbox",
                             "fill the picture, or keep the window's shape and leave bars"),
                      choice("row_zero", {"top", "bottom"}, "top", "bottom",
                             "where row 0 is: at the top, as in picture files, or at the bottom"),
                      exact_parameter()},
       .examples = {"--points '0.3,0.4 1.3,0.5' --resolution 8,6",
                    "--window -1,-1,1,1 --resolution 8,6 --fit letterbox",
                    "--points '0,0 2,1' --method clamped"},
       .checking = &checking()});
  return topic;
}

}  // namespace gradus::viewport
