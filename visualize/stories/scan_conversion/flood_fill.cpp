// The story of a fill: which pixel is painted next, and what still waits.

#include "scan_conversion/flood_fill/flood_fill.hpp"

#include <algorithm>

#include "core/shown.hpp"
#include "scan_conversion/flood_fill/maze.hpp"
#include "stories/topic.hpp"
#include "stories/words.hpp"

namespace gradus::flood_fill {
namespace {

using fmt::arg;

constexpr std::string_view source = "algorithms/scan_conversion/flood_fill/flood_fill.hpp";

/// A small maze with a corner to turn, a dead end and a diagonal gap: 4- and 8-connected fills differ.
constexpr std::string_view example_maze =
    "##########/#....#...#/#.##.#.#.#/#.#....#.#/#.#.####.#/#...#..#.#/##########";

/// What is filled: an image, or the letters of a maze.
struct Subject {
  Image image;  ///< the picture to fill; for a maze: one colour a kind of cell
  bool is_maze = false;
  Maze maze;
};

constexpr Rgba8 default_color{0, 0x72, 0xb2, 255};
constexpr char default_letter = 'x';

Rgba8 maze_color(char cell) {
  // Only equality matters to the fill: every kind of cell gets a colour of its own
  const auto code = static_cast<std::uint8_t>(cell);
  return {code, code, code, 255};
}

Subject subject_of(const Arguments& arguments) {
  Subject subject;
  if (arguments.has("image") && !arguments.text("image").empty()) {
    subject.image = arguments.entry("image").image.value();
    return subject;
  }
  const Arguments::Entry& entry = arguments.entry("maze");
  const auto parsed = parse_maze(entry.content, entry.hash.empty() ? "--maze" : shown_name(entry.text));
  if (const MazeError* error = std::get_if<MazeError>(&parsed)) throw InputError(error->what);
  subject.is_maze = true;
  subject.maze = std::get<Maze>(parsed);
  subject.image = Image(subject.maze.width(), subject.maze.height());
  for (int y = 0; y < subject.maze.height(); ++y) {
    for (int x = 0; x < subject.maze.width(); ++x) subject.image[{x, y}] = maze_color(subject.maze[{x, y}]);
  }
  return subject;
}

/// What a maze shows behind all steps: its walls and letters.
Delta maze_cells(const Maze& maze) {
  Delta delta;
  for (int y = 0; y < maze.height(); ++y) {
    for (int x = 0; x < maze.width(); ++x) {
      const char cell = maze[{x, y}];
      if (cell == wall) delta.cells.push_back({{x, y}, CellLook{Role::boundary, ""}});
      if (is_color(cell)) delta.cells.push_back({{x, y}, CellLook{Role::input, std::string(1, cell)}});
    }
  }
  return delta;
}

/// The outline of a window's cells.
Path border(const Window& w) {
  const double left = w.lower.x - 0.5, right = w.upper.x + 0.5, top = w.lower.y - 0.5,
               bottom = w.upper.y + 0.5;
  return {{{left, top}, {right, top}, {right, bottom}, {left, bottom}}, true};
}

/// "above (3, 4)": where a neighbour lies, rows counting downwards.
std::string place(const Wording& words, ivec2 from, ivec2 to) {
  constexpr std::string_view keys[3][3] = {
      {"flood_fill.place.above_left", "flood_fill.place.above", "flood_fill.place.above_right"},
      {"flood_fill.place.left", "flood_fill.place.same", "flood_fill.place.right"},
      {"flood_fill.place.below_left", "flood_fill.place.below", "flood_fill.place.below_right"}};
  const ivec2 way{std::clamp(to.x - from.x, -1, 1), std::clamp(to.y - from.y, -1, 1)};
  return words.say(keys[way.y + 1][way.x + 1], arg("pixel", figure_point(from)));
}

/// Tells the steps of all three methods. A pixel painted is a milestone, as is a span; looking is finer.
class FillTeller {
 public:
  FillTeller(TraceWriter& writer, const Subject& subject, std::string_view method,
             std::optional<Window> window)
      : writer_(writer), words_(writer.wording()), subject_(subject), method_(method), window_(window) {
    const std::string waiting = method == "depth_first" ? "path" : "queue";
    writer.trace().columns = {{"n"}, {"column"}, {"row"}, {"from", false}, {waiting}, {"painted"}};
    if (method == "span") {
      writer.trace().columns = {{"n"}, {"row"}, {"left"}, {"right"}, {"pixels"}, {"painted"}};
    }
  }

  void operator()(const Started& s, int line = __builtin_LINE(), const char* = nullptr) {
    Delta delta = subject_.is_maze ? maze_cells(subject_.maze) : Delta{};
    if (window_) delta.set.push_back({"window", Role::measure, border(*window_)});
    delta.set.push_back({"seed", Role::input, Dot{{s.seed.x, s.seed.y}}});
    delta.set.push_back(
        {"seed name", Role::input, Label{{s.seed.x, s.seed.y}, words_.say("flood_fill.seed")}});
    focus_ = s.seed;
    writer_.step(std::move(delta), s.seed, line, [&](TraceStep& step) {
      step.type = "Started";
      step.phase = words_.say("words.set_up");
      step.key = pixel_key(s.seed);
      step.fields = {{"seed", s.seed},
                     {"connectivity", std::int64_t{static_cast<int>(s.connectivity)}},
                     {"inside", s.inside}};
      step.sentence = words_.say(s.inside ? "flood_fill.started" : "flood_fill.nothing_to_do",
                                 arg("seed", figure_point(s.seed)),
                                 arg("connectivity", static_cast<int>(s.connectivity)));
    });
  }

  void operator()(const Painted& p, int line = __builtin_LINE(), const char* = nullptr) {
    Delta delta = cleared();
    if (painted_ == 0) delta.removed.push_back("seed name");
    retire(delta);
    make_current(delta, p.pixel);
    ++painted_;
    note(p.pixel);
    writer_.step(std::move(delta), p.pixel, line, [&](TraceStep& step) {
      step.type = "Painted";
      step.phase = words_.say("flood_fill.filling");
      step.key = pixel_key(p.pixel);
      step.fields = {{"from", p.from}, {"pixel", p.pixel}, {"waiting", std::int64_t(p.waiting)}};
      const bool seed = p.from == p.pixel;
      step.sentence = words_.say(
          seed ? "flood_fill.painted.seed" : "flood_fill.painted.next", arg("pixel", figure_point(p.pixel)),
          arg("place", place(words_, p.from, p.pixel)), arg("holds", holds(p.waiting)));
      step.row = {figure_number(painted_),
                  figure_number(p.pixel.x),
                  figure_number(p.pixel.y),
                  seed ? words_.say("flood_fill.seed") : figure_point(p.from),
                  figure_number(std::int64_t(p.waiting)),
                  figure_number(painted_)};
    });
  }

  void operator()(const Examined& e, int line = __builtin_LINE(), const char* = nullptr) {
    Delta delta = cleared();
    point_at(delta, e.pixel, e.inside);
    writer_.fine(std::move(delta), e.from, line, [&](TraceStep& step) {
      step.type = "Examined";
      step.phase = words_.say("flood_fill.filling");
      step.key = pixel_key(e.pixel);
      step.fields = {{"from", e.from}, {"pixel", e.pixel}, {"inside", e.inside}};
      step.sentence =
          words_.say("flood_fill.examined." + (e.inside ? "free" : why_not(e.pixel)),
                     arg("pixel", figure_point(e.pixel)), arg("place", place(words_, e.from, e.pixel)));
    });
  }

  void operator()(const Retreated& r, int line = __builtin_LINE(), const char* = nullptr) {
    Delta delta = cleared();
    put(delta, r.pixel, Role::past);
    if (current_ == r.pixel) current_.reset();
    writer_.fine(std::move(delta), r.pixel, line, [&](TraceStep& step) {
      step.type = "Retreated";
      step.phase = words_.say("flood_fill.filling");
      step.key = pixel_key(r.pixel);
      step.fields = {{"pixel", r.pixel}, {"waiting", std::int64_t(r.waiting)}};
      step.sentence = words_.say("flood_fill.retreated", arg("pixel", figure_point(r.pixel)),
                                 arg("holds", holds(r.waiting)));
    });
  }

  void operator()(const Dequeued& d, int line = __builtin_LINE(), const char* = nullptr) {
    Delta delta = cleared();
    retire(delta);
    put(delta, d.pixel, Role::current);
    current_ = d.pixel;
    current_waits_ = false;
    writer_.fine(std::move(delta), d.pixel, line, [&](TraceStep& step) {
      step.type = "Dequeued";
      step.phase = words_.say("flood_fill.filling");
      step.key = pixel_key(d.pixel);
      step.fields = {{"pixel", d.pixel}, {"waiting", std::int64_t(d.waiting)}};
      step.sentence = words_.count("flood_fill.dequeued", static_cast<std::int64_t>(d.waiting),
                                   arg("pixel", figure_point(d.pixel)));
    });
  }

  void operator()(const SpanFilled& s, int line = __builtin_LINE(), const char* = nullptr) {
    Delta delta = cleared();
    if (painted_ == 0) delta.removed.push_back("seed name");
    for (const ivec2 p : run_) put(delta, p, Role::past);
    run_.clear();
    for (int x = s.span.left; x <= s.span.right; ++x) {
      run_.push_back({x, s.span.row});
      note(run_.back());
      put(delta, run_.back(), Role::current);
    }
    painted_ += s.span.length();
    ++spans_;
    focus_ = s.found;
    writer_.step(std::move(delta), s.found, line, [&](TraceStep& step) {
      step.type = "SpanFilled";
      step.phase = words_.say("flood_fill.filling");
      step.key = pixel_key(s.found);
      step.fields = {{"row", std::int64_t{s.span.row}},
                     {"left", std::int64_t{s.span.left}},
                     {"right", std::int64_t{s.span.right}},
                     {"found", s.found}};
      step.sentence =
          words_.say("flood_fill.span_filled", arg("found", figure_point(s.found)), arg("row", s.span.row),
                     arg("left", s.span.left), arg("right", s.span.right));
      step.row = {figure_number(spans_),       figure_number(s.span.row),      figure_number(s.span.left),
                  figure_number(s.span.right), figure_number(s.span.length()), figure_number(painted_)};
    });
  }

  void operator()(const SpanQueued& s, int line = __builtin_LINE(), const char* = nullptr) {
    Delta delta = cleared();
    arrow(delta, "waiting span", Role::candidate, s.span);
    writer_.fine(std::move(delta), {s.span.left, s.span.row}, line, [&](TraceStep& step) {
      step.type = "SpanQueued";
      step.phase = words_.say("flood_fill.filling");
      step.key = pixel_key({s.span.left, s.span.row});
      step.fields = span_fields(s.span, s.waiting);
      step.sentence =
          words_.say("flood_fill.span_queued", arg("row", s.span.row + s.span.way), arg("left", s.span.left),
                     arg("right", s.span.right), arg("holds", holds(s.waiting)));
    });
  }

  void operator()(const SpanTaken& s, int line = __builtin_LINE(), const char* = nullptr) {
    Delta delta = cleared();
    for (const ivec2 p : run_) put(delta, p, Role::past);
    run_.clear();
    arrow(delta, "taken span", Role::current, s.span);
    taken_ = true;
    writer_.fine(std::move(delta), {s.span.left, s.span.row}, line, [&](TraceStep& step) {
      step.type = "SpanTaken";
      step.phase = words_.say("flood_fill.filling");
      step.key = pixel_key({s.span.left, s.span.row});
      step.fields = span_fields(s.span, s.waiting);
      step.sentence = words_.count("flood_fill.span_taken", static_cast<std::int64_t>(s.waiting),
                                   arg("row", s.span.row + s.span.way), arg("left", s.span.left),
                                   arg("right", s.span.right));
    });
  }

  void operator()(const Finished& f, int line = __builtin_LINE(), const char* = nullptr) {
    Delta delta = cleared();
    delta.removed.push_back("taken span");
    if (painted_ <= Recording::default_most) {
      for (const ivec2 p : writer_.trace().pixels) put(delta, p, Role::result);
    }
    writer_.fine(std::move(delta), focus_, line, [&](TraceStep& step) {
      step.type = "Finished";
      step.phase = words_.say("words.result");
      step.level = Level::idea;
      step.fields = {{"painted", f.filled.painted},
                     {"peak_waiting", std::int64_t(f.filled.peak_waiting)},
                     {"peak_bytes", std::int64_t(f.filled.peak_bytes)}};
      step.sentence = words_.count(
          "flood_fill.finished", f.filled.painted,
          arg("held", words_.say("flood_fill.held." + method_, arg("most", f.filled.peak_waiting))),
          arg("bytes", f.filled.peak_bytes));
    });
  }

 private:
  static std::vector<Field> span_fields(const Span& s, std::size_t waiting) {
    return {{"row", std::int64_t{s.row}},
            {"left", std::int64_t{s.left}},
            {"right", std::int64_t{s.right}},
            {"way", std::int64_t{s.way}},
            {"waiting", std::int64_t(waiting)}};
  }

  /// Keeps the pixels in order, as far as a trace keeps steps.
  void note(ivec2 p) {
    auto& pixels = writer_.trace().pixels;
    if (static_cast<std::int64_t>(pixels.size()) < Recording::default_most) pixels.push_back(p);
  }

  bool on_grid(ivec2 p) const { return subject_.image.contains(p); }

  void put(Delta& delta, ivec2 p, Role role) { delta.cells.push_back({p, CellLook{role, ""}}); }

  /// The pixel painted last is one of those that wait, from now on.
  void retire(Delta& delta) {
    if (current_) put(delta, *current_, current_waits_ ? Role::candidate : Role::past);
  }
  void make_current(Delta& delta, ivec2 p) {
    put(delta, p, Role::current);
    current_ = p;
    current_waits_ = true;
  }

  /// What holds the pixels that wait, and how many.
  std::string holds(std::size_t waiting) const {
    return words_.say("flood_fill.holds." + method_, arg("waiting", waiting));
  }
  std::string why_not(ivec2 p) const {
    if (!on_grid(p)) return "outside";
    return subject_.is_maze && subject_.maze[p] == wall ? "wall" : "other";
  }

  /// Shows what was looked at without changing how its cell looks.
  void point_at(Delta& delta, ivec2 p, bool free) {
    if (!on_grid(p)) return;
    const dvec2 at{p.x, p.y};
    if (free) {
      delta.set.push_back({"looked at", Role::accepted, Dot{at, true}});
      return;
    }
    delta.set.push_back(
        {"looked at", Role::rejected, Stroke{at - dvec2{0.25, 0.25}, at + dvec2{0.25, 0.25}}});
    delta.set.push_back(
        {"looked at too", Role::rejected, Stroke{at + dvec2{-0.25, 0.25}, at + dvec2{0.25, -0.25}}});
  }

  void arrow(Delta& delta, std::string id, Role role, const Span& s) {
    const double middle = (s.left + s.right) / 2.0;
    delta.set.push_back(
        {std::move(id), role, Stroke{{middle, double(s.row)}, {middle, s.row + 0.75 * s.way}, true}});
  }

  Delta cleared() {
    Delta delta;
    delta.removed = {"looked at", "looked at too", "waiting span"};
    if (taken_) delta.removed.push_back("taken span");
    taken_ = false;
    return delta;
  }

  TraceWriter& writer_;
  const Wording& words_;
  const Subject& subject_;
  std::string method_;
  std::optional<Window> window_;
  std::int64_t painted_ = 0, spans_ = 0;
  ivec2 focus_{0, 0};
  std::optional<ivec2> current_;
  bool current_waits_ = true;
  bool taken_ = false;
  std::vector<ivec2> run_;
};

Connectivity connectivity_of(const Arguments& arguments) {
  return arguments.text("connectivity") == "8" ? Connectivity::eight : Connectivity::four;
}

const std::vector<gradus::Method>& all_methods() {
  static const std::vector<gradus::Method> methods{
      method_in_english("flood_fill", "depth_first", Standing::taught),
      method_in_english("flood_fill", "breadth_first", Standing::plain),
      method_in_english("flood_fill", "span", Standing::fast)};
  return methods;
}

void describe(Trace& trace, const Subject& subject, const Arguments& arguments) {
  const std::string& method = arguments.text("method");
  const ivec2 seed = arguments.cell("at");
  introduce(trace, "flood_fill", arguments, false);
  const Wording& words = trace.wording;
  trace.subtitle = words.say(subject.is_maze ? "flood_fill.subtitle.maze" : "flood_fill.subtitle.image",
                             arg("width", subject.image.width()), arg("height", subject.image.height()),
                             arg("seed", figure_point(seed)));
  trace.method_title =
      words.say("flood_fill.connected", arg("method", words.say("flood_fill.method." + method)),
                arg("connectivity", arguments.text("connectivity")));
  trace.source_file = std::string(source);
  trace.listing = listing_of(source_text(source), method);
  trace.grid.cells = subject.image.window();
  trace.grid.y_up = false;
  trace.grid.x_name = words.say("flood_fill.column.column");
  trace.grid.y_name = words.say("flood_fill.column.row");
  if (!subject.is_maze) trace.grid.picture = subject.image;
  trace.legend = {{Role::current, words.say("flood_fill.legend.current")},
                  {Role::candidate, words.say("flood_fill.legend.candidate." + method)},
                  {Role::past, words.say("flood_fill.legend.past")},
                  {Role::accepted, words.say("flood_fill.legend.accepted")},
                  {Role::rejected, words.say("flood_fill.legend.rejected")},
                  {Role::result, words.say("flood_fill.legend.result")},
                  {Role::boundary, words.say("flood_fill.legend.boundary")},
                  {Role::measure, words.say("flood_fill.legend.measure")}};
}

gradus::flood_fill::Method method_of(const Arguments& arguments) {
  const std::string& name = arguments.text("method");
  if (name == "depth_first") return Method::depth_first;
  return name == "breadth_first" ? Method::breadth_first : Method::span;
}

/// The picture's fill cut to a window; a mask keeps what is painted, whatever the new colour.
Filled fill_in_window(Image& image, ivec2 seed, Rgba8 color, const Window& window, const Options& options,
                      FillTeller& teller) {
  const Rgba8 old = image[seed];
  Raster<std::uint8_t> visited(image.width(), image.height());
  const auto inside = [&](ivec2 p) {
    return image.contains(p) && !visited[p] && alike(image[p], old, options.tolerance);
  };
  const auto paint = [&](ivec2 p) {
    visited[p] = 1;
    image[p] = color;
  };
  return in_window(options.method, seed, window, inside, paint, options.connectivity, teller);
}

/// What pixels are painted with. A maze's walls stay; its other cells become a letter.
Rgba8 paint_of(const Subject& subject, const Arguments& arguments, ivec2 seed) {
  const std::string& given = arguments.has("color") ? arguments.text("color") : "";
  const bool letter = given.size() == 1;
  if (!subject.is_maze) {
    if (letter)
      throw ArgumentError("color", fmt::format("expected a colour for an image, found '{}'", given));
    return given.empty() ? default_color : arguments.color("color");
  }
  if (!given.empty() && !letter) {
    throw ArgumentError("color", fmt::format("expected a letter for a maze, found '{}'", given));
  }
  if (subject.maze[seed] == wall) return maze_color(wall);
  return maze_color(letter ? given[0] : default_letter);
}

Filled fill_subject(Subject& subject, const Arguments& arguments, FillTeller& teller) {
  Options options{static_cast<int>(arguments.integer("tolerance")), connectivity_of(arguments),
                  method_of(arguments)};
  const ivec2 seed = arguments.cell("at");
  const auto window = arguments.window("window");
  if (subject.is_maze) options.tolerance = 0;
  const Rgba8 color = paint_of(subject, arguments, seed);
  const bool nothing_to_do = options.tolerance == 0 && color == subject.image[seed];
  if (!window || nothing_to_do) return fill_image(subject.image, seed, color, options, teller);
  return fill_in_window(subject.image, seed, color, *window, options, teller);
}

/// The maze after the fill, its rows joined by "/".
std::string filled_maze(const Image& image) {
  std::string rows;
  for (int y = 0; y < image.height(); ++y) {
    if (y > 0) rows += '/';
    for (const Rgba8& cell : image.row(y)) rows += static_cast<char>(cell.r);
  }
  return rows;
}

Trace run(const Arguments& arguments, Recording recording) {
  const Subject subject = subject_of(arguments);
  const ivec2 seed = arguments.cell("at");
  if (!subject.image.contains(seed)) {
    throw ArgumentError(
        "at", fmt::format("expected a pixel inside the {} × {} picture (columns 0 to {}, rows 0 to {}), "
                          "found {},{}",
                          subject.image.width(), subject.image.height(), subject.image.width() - 1,
                          subject.image.height() - 1, seed.x, seed.y));
  }
  TraceWriter writer(recording);
  describe(writer.trace(), subject, arguments);
  FillTeller teller(writer, subject, arguments.text("method"), arguments.window("window"));
  Subject filled = subject;
  const Filled done = fill_subject(filled, arguments, teller);
  Trace trace = std::move(writer).finish();
  trace.result = {{"painted", done.painted},
                  {"peak_waiting", std::int64_t(done.peak_waiting)},
                  {"peak_bytes", std::int64_t(done.peak_bytes)},
                  {"mask_bytes", std::int64_t(done.mask_bytes)}};
  if (subject.is_maze) trace.result.push_back({"maze", filled_maze(filled.image)});
  trace.telling = middle_step(trace);
  return trace;
}

}  // namespace

const TopicEntry& entry();  // the catalogue asks for it by this name
const TopicEntry& entry() {
  static const TopicEntry topic{
      .name = "flood_fill",
      .title = Wording().say("flood_fill.title"),
      .chapter = "scan_conversion",
      .aliases = {"fill", "bucket fill", "seed fill", "paint bucket"},
      .summary = "paint everything that is connected to a seed",
      .methods = all_methods(),
      .default_method = "span",
      .parameters =
          {{"maze", ParameterType::maze, std::string(example_maze), "maze.txt",
            "what to fill: a text file, - or rows joined by /; # wall, . free, letters are colours"},
           {.name = "image",
            .type = ParameterType::picture,
            .default_value = "",
            .example = "photo.png",
            .help = "what to fill instead: a PNG file",
            .instead_of = "maze"},
           {"at", ParameterType::cell, "1,1", "3,4", "seed: column,row from the top left"},
           {"color", ParameterType::paint, "", "#d55e00",
            "what to paint with: a colour, #0072b2 if not given; in a maze a letter, x if not given"},
           {"tolerance", ParameterType::integer, "0", "12",
            "by how much each channel may differ from the seed's, 0 to 255", 0, 255},
           {"connectivity",
            ParameterType::choice,
            "4",
            "8",
            "neighbours of a pixel: 4 or 8",
            INT32_MIN,
            INT32_MAX,
            {"4", "8"}},
           {"window", ParameterType::window, "", "2,1,6,5",
            "fill only what lies in these cells: xmin,ymin,xmax,ymax, both corners included"}},
      .examples = {"--at 1,1 --method depth_first", "--maze '#####/#...#/#.#.#/#...#/#####' --at 2,1",
                   "--image photo.png --at 40,30 --color '#d55e00' --tolerance 12"},
      .run = run};
  return topic;
}

}  // namespace gradus::flood_fill
