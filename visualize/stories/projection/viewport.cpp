// The story of a window on the camera plane: which pixel of the picture each point gets, or that it gets
// none.

#include "projection/viewport/viewport.hpp"

#include <algorithm>
#include <cmath>

#include "projection/viewport/viewport_notes.hpp"
#include "stories/paper.hpp"
#include "stories/side_by_side.hpp"
#include "stories/topic.hpp"
#include "stories/words.hpp"

namespace gradus::viewport {
namespace {

using fmt::arg;

constexpr std::string_view folder = "algorithms/projection/viewport/";

/// Two panels on a paper of 36 x 27: the camera plane, and the picture.
const Extent plane_place{{3.2, 6}, {17, 19.8}};
const Extent picture_place{{20.2, 6}, {35.3, 19.8}};
/// Of points and windows: then fractions of the one in the other neither overflow nor underflow.
constexpr Sizes sizes{1e-100, 1e100};
/// Up to so many lines the whole grid of pixels is drawn.
constexpr int most_lines = 40;

struct Input {
  Mapping<double> map;
  std::vector<dvec2> points;
  Rounding rounding;
  bool boxed;
};

Input input_of(const Arguments& arguments, Rounding rounding) {
  const std::vector<double> bounds = arguments.numbers("window");
  const Rectangle<double> window{{bounds[0], bounds[1]}, {bounds[2], bounds[3]}};
  if (!(window.lower.x < window.upper.x && window.lower.y < window.upper.y)) {
    refuse(arguments, {"window"},
           fmt::format("a window with an inside expected, found {}", arguments.text("window")));
  }
  const RowZero row_zero = arguments.text("row_zero") == "top" ? RowZero::top : RowZero::bottom;
  const bool boxed = arguments.text("fit") == "letterbox";
  const ivec2 picture = arguments.cell("resolution");
  Input input{boxed ? letterboxed(window, picture, row_zero) : stretched(window, picture, row_zero),
              arguments.points("points"), rounding, boxed};
  const dvec2 room = input.map.viewport.upper - input.map.viewport.lower;
  if (std::min(room.x, room.y) < 1e-3) {
    refuse(arguments, {"window", "resolution", "fit"},
           fmt::format("expected a window of a shape that leaves more than a thousandth of a pixel between "
                       "the bars, found {}",
                       arguments.text("window")));
  }
  return input;
}

std::string name_of(std::size_t point) { return std::string(1, static_cast<char>('A' + point)); }

/// What is known of a point so far.
struct Fate {
  std::optional<dvec2> fraction{}, place{};
  std::optional<ivec2> nearest{};  ///< before it was moved
  std::optional<ivec2> pixel{};
  bool outside = false;
};

dvec2 centre(ivec2 pixel) { return dvec2(pixel) + 0.5; }

class Drawing {
 public:
  Drawing(const Input& input, const Wording& words)
      : input_(input),
        words_(words),
        plane_(plane_place, plane_extent(input)),
        picture_(picture_place, picture_extent(input)) {}

  /// current: the point of this step; points.size(): none. done: all pixels are results.
  View view(const std::vector<Fate>& fates, std::size_t current, bool done, bool faulty) const {
    View view;
    add_plane(view, fates, current);
    add_grid(view);
    if (faulty) add_lines(view, fates);
    for (std::size_t i = 0; i < fates.size(); ++i) add_fate(view, fates[i], i, i == current, done);
    return view;
  }
  const Panel& plane() const { return plane_; }

 private:
  static Extent plane_extent(const Input& input) {
    const auto& [lower, upper] = input.map.window;
    const dvec2 margin = (upper - lower) * 0.2;
    return {lower - margin, upper + margin};
  }
  static Extent picture_extent(const Input& input) {
    const dvec2 size(input.map.picture);
    const double margin = 0.18 * std::max(size.x, size.y);
    const dvec2 lower{-margin, input.map.row_zero == RowZero::top ? -size.y - margin : -margin};
    return {lower, lower + size + 2 * margin};
  }
  /// A place of the picture on the paper: rows are counted down where row 0 is at the top.
  dvec2 on_paper(dvec2 place) const {
    return picture_.at({place.x, input_.map.row_zero == RowZero::top ? -place.y : place.y});
  }
  std::vector<dvec2> box_on_paper(dvec2 lower, dvec2 upper) const {
    return {on_paper(lower), on_paper({upper.x, lower.y}), on_paper(upper), on_paper({lower.x, upper.y})};
  }

  void caption(View& view, std::string_view key, double x) const {
    view.add({fmt::format("caption {}", key), Role::guide,
              Text{{x, 23}, words_.say("viewport.caption." + std::string(key))}});
  }

  void add_plane(View& view, const std::vector<Fate>& fates, std::size_t current) const {
    caption(view, "plane", plane_place.centre().x);
    add_axes(view, plane_, "plane", {words_.symbol("x"), words_.symbol("y")}, 4);
    const auto& [lower, upper] = input_.map.window;
    const std::vector<dvec2> corners{lower, {upper.x, lower.y}, upper, {lower.x, upper.y}};
    view.add({"window", Role::boundary, Path{plane_.at(corners), true}});
    const Extent shown = plane_.shown();
    for (std::size_t i = 0; i < input_.points.size(); ++i) {
      const dvec2 p = input_.points[i];
      const bool here =
          shown.lower.x <= p.x && p.x <= shown.upper.x && shown.lower.y <= p.y && p.y <= shown.upper.y;
      const dvec2 at = plane_.at(here ? p : glm::clamp(p, shown.lower, shown.upper));
      const Role role = i == current ? Role::current : fates[i].outside ? Role::rejected : Role::input;
      if (here) {
        view.add({"point " + name_of(i), role, Dot{at}});
      } else {
        const dvec2 inwards = glm::normalize(plane_place.centre() - at);
        view.add({"point " + name_of(i), role, Stroke{at + 1.6 * inwards, at, true}});
      }
      view.add({"point name " + name_of(i), role, Label{at, name_of(i)}});
    }
    if (current >= fates.size() || !fates[current].fraction || fates[current].place) return;
    const dvec2 p = input_.points[current], fraction = *fates[current].fraction;
    const bool top = input_.map.row_zero == RowZero::top;
    const dvec2 side{lower.x, p.y}, end{p.x, top ? upper.y : lower.y};
    const auto measure = [&](std::string id, dvec2 from, double value) {
      view.add({id, Role::measure, Stroke{plane_.at(from), plane_.at(p)}});
      view.add({id + " name", Role::measure, Label{plane_.at((from + p) * 0.5), figure_real(value)}});
    };
    if (!(std::abs(fraction.x) < 3 && std::abs(fraction.y) < 3)) return;
    measure("across", side, fraction.x);
    measure("down", end, fraction.y);
  }

  void add_grid(View& view) const {
    caption(view, input_.map.row_zero == RowZero::top ? "rows_down" : "rows_up", picture_place.centre().x);
    const ivec2 size = input_.map.picture;
    const auto lines = [&](int axis) {
      const int count = size[axis];
      const int step = count <= most_lines ? 1 : std::max(1, static_cast<int>(tick_distance(count, 8)));
      const int labels = std::max(step, static_cast<int>(std::ceil(tick_distance(count, 8))));
      for (int i = 0; i <= count; i += step) {
        dvec2 a{0, 0}, b(size);
        a[axis] = b[axis] = i;
        view.add({fmt::format("grid {} {:05}", axis ? "row" : "column", i), Role::guide,
                  Stroke{on_paper(a), on_paper(b)}});
        if (i % labels != 0) continue;
        const bool top = input_.map.row_zero == RowZero::top;
        const dvec2 beside = axis ? dvec2{-0.7, 0} : dvec2{0, top ? 1.1 : -1.2};
        view.add({fmt::format("grid value {} {:05}", axis ? "row" : "column", i), Role::guide,
                  Text{on_paper(a) + beside, figure_real(i), axis ? Align::right : Align::centre}});
      }
    };
    lines(0);
    lines(1);
    view.add({"picture", Role::boundary, Path{box_on_paper({0, 0}, dvec2(size)), true}});
    if (!input_.boxed) return;
    const auto& [lower, upper] = input_.map.viewport;
    view.add({"viewport", Role::boundary, Path{box_on_paper(lower, upper), true, true}});
  }

  void add_cell(View& view, const std::string& id, Role role, ivec2 pixel) const {
    const std::vector<dvec2> box = box_on_paper(dvec2(pixel), dvec2(pixel) + 1.0);
    view.add({id, role, gradus::Area{{box}}});
    view.add({id + " outline", role, Path{box, true}});
  }

  /// Whether the panel shows this place, and where; of others the nearest place that it shows.
  std::pair<bool, dvec2> shown_at(dvec2 place) const {
    const dvec2 at = on_paper(place);
    const dvec2 lower = picture_place.lower + 0.3, upper = picture_place.upper - 0.3;
    const bool inside = lower.x <= at.x && at.x <= upper.x && lower.y <= at.y && at.y <= upper.y;
    return {inside, glm::clamp(at, lower, upper)};
  }

  void add_fate(View& view, const Fate& fate, std::size_t i, bool current, bool done) const {
    const std::string name = name_of(i);
    if (fate.pixel) {
      const bool moved = fate.nearest && *fate.nearest != *fate.pixel;
      const Role role = moved ? Role::rejected : done ? Role::result : current ? Role::accepted : Role::past;
      add_cell(view, "pixel " + name, role, *fate.pixel);
      if (current || done) {
        view.add({"pixel name " + name, role, Label{on_paper(centre(*fate.pixel)), name}});
      }
      if (moved && current) {
        const auto [inside, from] = shown_at(dvec2(*fate.nearest));
        view.add({"moved " + name, Role::rejected, Stroke{from, on_paper(centre(*fate.pixel)), true, true}});
      }
    }
    if (!fate.place) return;
    const auto [inside, at] = shown_at(*fate.place);
    const Role role = fate.outside ? Role::rejected : current ? Role::current : Role::input;
    if (inside) {
      view.add({"place " + name, role, Dot{at}});
    } else {
      const dvec2 inwards = glm::normalize(picture_place.centre() - at);
      view.add({"place " + name, role, Stroke{at + 1.6 * inwards, at, true}});
    }
    if (current && fate.pixel && input_.rounding != Rounding::floor && inside) {
      const auto [there, corner] = shown_at(dvec2(fate.nearest.value_or(*fate.pixel)));
      if (there) view.add({"rounding " + name, Role::measure, Stroke{at, corner, true}});
    }
    if (fate.outside) {
      view.add({"place name " + name, role, Label{at, name}});
    } else if (!fate.pixel) {
      view.add({"place name " + name, role, Label{at, name}});
    }
  }

  /// The line through the points as it is (dashed), and as it comes out between moved pixels.
  void add_lines(View& view, const std::vector<Fate>& fates) const {
    for (std::size_t i = 1; i < fates.size(); ++i) {
      if (!fates[i - 1].pixel || !fates[i].pixel) continue;
      const auto [in, a] = shown_at(*fates[i - 1].place);
      dvec2 b = on_paper(*fates[i].place);
      // Only as far as the panel shows it
      const dvec2 lower = picture_place.lower + 0.3, upper = picture_place.upper - 0.3, way = b - a;
      double most = 1;
      for (const int axis : {0, 1}) {
        if (way[axis] > 0) most = std::min(most, (upper[axis] - a[axis]) / way[axis]);
        if (way[axis] < 0) most = std::min(most, (lower[axis] - a[axis]) / way[axis]);
      }
      const std::string names = name_of(i - 1) + name_of(i);
      if (in && most > 0) {
        view.add({"line " + names, Role::measure, Stroke{a, a + most * way, false, true}});
      }
      const dvec2 from = on_paper(centre(*fates[i - 1].pixel)), to = on_paper(centre(*fates[i].pixel));
      view.add({"drawn " + names, Role::rejected, Stroke{from, to}});
    }
  }

  const Input& input_;
  const Wording& words_;
  Panel plane_, picture_;
};

class Teller {
 public:
  Teller(TraceWriter& writer, const Input& input, bool faulty)
      : writer_(writer),
        words_(writer.wording()),
        input_(input),
        faulty_(faulty),
        drawing_(input, words_),
        fates_(input.points.size()),
        current_(input.points.size()) {
    writer.trace().columns = {{"point", false}, {"px"}, {"py"}, {"pixel", false}};
  }

  void input() {
    const auto& [lower, upper] = input_.map.window;
    const bool top = input_.map.row_zero == RowZero::top;
    tell(false, 0, "Input", "words.set_up",
         words_.say(input_.boxed ? "viewport.input_boxed" : "viewport.input",
                    arg("lower", figure_place(lower)), arg("upper", figure_place(upper)),
                    arg("width", figure_number(input_.map.picture.x)),
                    arg("height", figure_number(input_.map.picture.y)),
                    arg("side", words_.say(top ? "viewport.top" : "viewport.bottom"))),
         {}, {});
  }
  void begin(std::size_t point) { current_ = point; }

  void operator()(const Measured<double>& m, int line = __builtin_LINE(), const char* = nullptr) {
    fate().fraction = m.fraction;
    const auto& [lower, upper] = input_.map.window;
    const bool top = input_.map.row_zero == RowZero::top;
    tell(true, line, "Measured", "words.main_loop",
         words_.say(
             top ? "viewport.measured_from_top" : "viewport.measured_from_bottom",
             arg("name", name_of(current_)), arg("u", figure_real(m.fraction.x)),
             arg("v", figure_real(m.fraction.y)), arg("across", difference_text(m.point.x, lower.x)),
             arg("width", figure_real(upper.x - lower.x)),
             arg("along", top ? difference_text(upper.y, m.point.y) : difference_text(m.point.y, lower.y)),
             arg("height", figure_real(upper.y - lower.y))),
         {{"u", m.fraction.x}, {"v", m.fraction.y}}, {});
  }
  void operator()(const Placed<double>& p, int line = __builtin_LINE(), const char* = nullptr) {
    fate().place = p.place;
    const auto& [lower, upper] = input_.map.viewport;
    const auto along = [&](int axis) {
      const std::string size = figure_real(upper[axis] - lower[axis]), start = figure_real(lower[axis]);
      return fmt::format("{}{}·{} = {}", lower[axis] == 0 ? "" : start + " + ", factor(p.fraction[axis]),
                         size, figure_real(p.place[axis]));
    };
    tell(true, line, "Placed", "words.main_loop",
         words_.say("viewport.placed", arg("across", along(0)), arg("along", along(1)),
                    arg("name", name_of(current_)), arg("place", figure_place(p.place))),
         {{"x", p.place.x}, {"y", p.place.y}}, {});
  }
  void operator()(const Rounded<double>& r, int line = __builtin_LINE(), const char* = nullptr) {
    line_ = line;
    fate().nearest = r.pixel;
    fate().outside = !faulty_ && !r.there;
    if (!faulty_ && r.there) fate().pixel = r.pixel;
  }
  void operator()(const Outside<double>&, int line = __builtin_LINE(), const char* = nullptr) {
    line_ = line;
    fate().outside = true;
  }
  void operator()(const Clamped& c, int line = __builtin_LINE(), const char* = nullptr) {
    line_ = line;
    fate().pixel = c.pixel;
  }

  /// The point has its pixel or is known to be outside: the milestone.
  void landed() {
    Fate& now = fate();
    if (faulty_ && !now.pixel) now.pixel = now.nearest;
    const std::string outcome = now.pixel ? figure_point(*now.pixel) : words_.say("viewport.outside");
    std::vector<Field> fields{{"outside", now.outside}};
    if (now.pixel) fields.push_back({"pixel", *now.pixel});
    tell(false, line_, now.outside ? "Outside" : "Rounded", "words.main_loop", sentence(), std::move(fields),
         {name_of(current_), figure_real(now.place->x), figure_real(now.place->y), outcome});
    if (now.pixel) writer_.trace().pixels.push_back(*now.pixel);
  }

  void finish() {
    const auto outside = std::ranges::count_if(fates_, [](const Fate& f) { return f.outside; });
    const auto moved =
        std::ranges::count_if(fates_, [](const Fate& f) { return f.nearest && f.pixel != f.nearest; });
    const std::size_t points = fates_.size();
    current_ = points;
    done_ = true;
    tell(true, 0, "Finished", "words.result",
         faulty_ ? words_.count("viewport.done_clamped", moved, arg("points", points))
                 : words_.count("viewport.done", outside, arg("points", points)),
         {{"outside", std::int64_t{outside}}}, {});
    writer_.trace().result = {{"points", static_cast<std::int64_t>(points)},
                              {"pixels", static_cast<std::int64_t>(points) - outside}};
  }

 private:
  Fate& fate() { return fates_[current_]; }
  static std::string factor(double x) { return x < 0 ? "(" + figure_real(x) + ")" : figure_real(x); }
  static std::string difference_text(double a, double b) { return figure_real(a) + " − " + factor(b); }

  std::string sentence() {
    const Fate& now = fate();
    const std::string name = name_of(current_), place = figure_place(*now.place);
    const auto width = arg("width", input_.map.picture.x), height = arg("height", input_.map.picture.y);
    if (now.outside) {
      const bool in_viewport = holds(input_.map.viewport, *now.place);
      if (!in_viewport) {
        return words_.say(input_.boxed ? "viewport.not_in_viewport" : "viewport.not_in_picture",
                          arg("place", place), arg("name", name), width, height);
      }
      return words_.say("viewport.no_pixel", arg("name", name), arg("place", place),
                        arg("pixel", figure_point(rounded(*now.place, input_.rounding))), width, height);
    }
    const std::string pixel = figure_point(*now.pixel);
    if (now.nearest != now.pixel) {
      return words_.say("viewport.clamped", arg("nearest", figure_point(*now.nearest)), arg("pixel", pixel),
                        arg("name", name));
    }
    if (input_.rounding == Rounding::floor) {
      return words_.say("viewport.floored", arg("px", figure_real(now.place->x)),
                        arg("py", figure_real(now.place->y)), arg("column", now.pixel->x),
                        arg("row", now.pixel->y), arg("name", name), arg("pixel", pixel));
    }
    const ivec2 own = rounded(*now.place, Rounding::floor);
    if (own == *now.pixel) {
      return words_.say("viewport.rounded_to_own", arg("place", place), arg("name", name),
                        arg("pixel", pixel));
    }
    return words_.say("viewport.rounded_away", arg("place", place), arg("name", name), arg("pixel", pixel),
                      arg("own", figure_point(own)));
  }

  void tell(bool fine, int line, std::string type, std::string_view phase, std::string text,
            std::vector<Field> fields, Row row) {
    View view = drawing_.view(fates_, current_, done_, faulty_);
    Delta delta = shown_.change_to(std::move(view));
    const auto describe = [&](TraceStep& step) {
      step.type = std::move(type);
      step.phase = words_.say(phase);
      step.key = current_ < fates_.size() ? name_of(current_) : "";
      if (done_) step.level = Level::idea;
      step.sentence = std::move(text);
      step.fields = std::move(fields);
      step.row = std::move(row);
    };
    if (fine) {
      writer_.fine(std::move(delta), {0, 0}, line, describe);
    } else {
      writer_.step(std::move(delta), {0, 0}, line, describe);
    }
  }

  TraceWriter& writer_;
  const Wording& words_;
  const Input& input_;
  bool faulty_;
  Drawing drawing_;
  std::vector<Fate> fates_;
  std::size_t current_;
  int line_ = 0;
  bool done_ = false;
  Shown shown_;
};

const std::vector<Method>& all_methods() {
  const auto method = [](std::string name, Standing standing) {
    return method_in_english("viewport", std::move(name), standing);
  };
  static const std::vector<Method> methods{
      method("floor", Standing::taught), method("half_up", Standing::plain),
      method("half_even", Standing::plain), method("clamped", Standing::faulty)};
  return methods;
}

const Method& method_named(std::string_view name) {
  for (const Method& method : all_methods()) {
    if (method.name == name) return method;
  }
  throw ArgumentError("method", "a method of viewport expected");
}

/// What the steps of rasterize hold.
struct Numbers {
  template <class T>
  void operator()(NumericStep<T>& to, const Measured<T>& m) const {
    to.type = "Measured";
    to.point("fraction", m.fraction);
  }
  template <class T>
  void operator()(NumericStep<T>& to, const Placed<T>& p) const {
    to.type = "Placed";
    to.point("place", p.place);
  }
  template <class T>
  void operator()(NumericStep<T>& to, const Outside<T>&) const {
    to.type = "Outside";
  }
  template <class T>
  void operator()(NumericStep<T>& to, const Rounded<T>& r) const {
    to.type = "Rounded";
    to.decision(r.pixel.x);
    to.decision(r.pixel.y);
  }
};

void put_side_by_side(Trace& trace, const Input& input) {
  show_side_by_side<Numbers>(trace, [&]<class T>(T, const auto& observer) {
    const auto rectangle = [](const Rectangle<double>& r) {
      return Rectangle<T>{in_scalar<T>(r.lower), in_scalar<T>(r.upper)};
    };
    const auto& [window, viewport, picture, row_zero] = input.map;
    const Mapping<T> map{rectangle(window), rectangle(viewport), picture, row_zero};
    for (const dvec2 point : input.points) rasterize(map, in_scalar<T>(point), input.rounding, observer);
  });
}

Trace run(const Arguments& arguments, Recording recording) {
  const Method& method = method_named(arguments.text("method"));
  const bool faulty = method.standing == Standing::faulty;
  const Rounding rounding = method.name == "floor"     ? Rounding::floor
                            : method.name == "half_up" ? Rounding::half_up
                                                       : Rounding::half_even;
  const Input input = input_of(arguments, rounding);
  require_scale(Drawing(input, {}).plane(), arguments, {"window"});
  TraceWriter writer(recording);
  Trace& trace = writer.trace();
  const Wording& words = trace.wording;
  introduce(trace, "viewport", arguments, faulty);
  trace.subtitle = words.count("viewport.subtitle", static_cast<long long>(input.points.size()),
                               arg("width", input.map.picture.x), arg("height", input.map.picture.y));
  trace.grid = paper_grid(36, 27);
  trace.legend = {{Role::input, words.say("viewport.legend.input")},
                  {Role::current, words.say("viewport.legend.current")},
                  {Role::measure, words.say(faulty ? "viewport.true_line" : "viewport.legend.measure")},
                  {Role::rejected, words.say(faulty ? "viewport.legend.moved" : "viewport.legend.rejected")},
                  {Role::result, words.say("viewport.legend.result")}};
  trace.source_file = std::string(folder) + (faulty ? "viewport_notes.hpp" : "viewport.hpp");
  trace.listing = listing_of(source_text(trace.source_file), faulty ? "clamped" : "rasterize");

  Teller teller(writer, input, faulty);
  teller.input();
  for (std::size_t i = 0; i < input.points.size(); ++i) {
    teller.begin(i);
    if (faulty) {
      clamped(input.map, input.points[i], rounding, teller);
    } else {
      rasterize(input.map, input.points[i], rounding, teller);
    }
    teller.landed();
  }
  teller.finish();
  Trace done = std::move(writer).finish();
  done.telling = faulty ? StepNumber{done.last, 0} : middle_step(done);
  if (side_by_side(arguments)) {
    require_method(arguments, {"floor", "half_up", "half_even"});
    put_side_by_side(done, input);
  }
  return done;
}

}  // namespace

const TopicEntry& entry();  // the catalogue asks for it by this name
const TopicEntry& entry() {
  static const TopicEntry topic = [] {
    Parameter points{"points", ParameterType::points, "0.3,0.4 -0.6,-0.2 0.95,0.7 1.3,0.5", "0,0 0.5,0.3 2,1",
                     "points on the camera plane: x,y in its units, y up"};
    points.parts = {"x", "y"};
    points.least = 1;
    points.most = 26;
    points.sizes = sizes;
    Parameter window{"window", ParameterType::bounds, "-1,-0.75,1,0.75", "-1,-1,1,1",
                     "what is seen of the plane: xmin,ymin,xmax,ymax"};
    window.parts = {"xmin", "ymin", "xmax", "ymax"};
    window.sizes = sizes;
    Parameter resolution{
        "resolution", ParameterType::cell, "8,6", "640,480", "width and height of the picture in pixels", 1,
        10'000};
    Parameter fit{"fit", ParameterType::choice, "stretch", "letterbox",
                  "fill the picture, or keep the window's shape and leave bars"};
    fit.choices = {"stretch", "letterbox"};
    Parameter row_zero{"row_zero", ParameterType::choice, "top", "bottom",
                       "where row 0 is: at the top, as in picture files, or at the bottom"};
    row_zero.choices = {"top", "bottom"};
    return TopicEntry{.name = "viewport",
                      .title = Wording().say("viewport.title"),
                      .chapter = "projection",
                      .aliases = {"window to viewport", "rasterize", "screen coordinates"},
                      .summary = "from a window on the camera plane to the pixels of a picture",
                      .methods = all_methods(),
                      .default_method = "floor",
                      .parameters = {points, window, resolution, fit, row_zero, exact_parameter()},
                      .examples = {"--points '0.3,0.4 1.3,0.5' --resolution 8,6",
                                   "--window -1,-1,1,1 --resolution 8,6 --fit letterbox",
                                   "--points '0,0 2,1' --method clamped"},
                      .run = run};
  }();
  return topic;
}

}  // namespace gradus::viewport
