// The story of a fill: by which methods what is filled.

#include "scan_conversion/flood_fill/flood_fill.hpp"

#include "scan_conversion/flood_fill/flood_fill_notes.hpp"
#include "stories/checking.hpp"
#include "stories/parameters.hpp"
#include "stories/scan_conversion/flood_fill/fill_story.hpp"
#include "stories/scan_conversion/flood_fill/subject.hpp"

namespace gradus::flood_fill {
namespace {

/// Cells that the notes' recursion may fill here: what it leaves of the machine's
/// stack is enough on every machine.
constexpr std::int64_t most_recursive_cells = 1024;

/// Pixels of a picture: 256 MiB each of the few copies that a fill needs.
constexpr std::int64_t most_pixels = std::int64_t{1} << 26;

/// A small maze with a corner to turn, a dead end and a diagonal gap: 4- and 8-connected fills differ.
constexpr std::string_view example_maze =
    "##########/#....#...#/#.##.#.#.#/#.#....#.#/#.#..###.#/#...#..#.#/##########";

/// What stands unchanged behind all steps, and around them.
void set_scene(Narrator& narrator, const Subject& subject, const Way& way, Rgba8 paint) {
  const Words& words = narrator.words();
  narrator.subtitle(
      subject.is_maze ? "subtitle.maze" : "subtitle.image",
      {{"width", subject.image().width()}, {"height", subject.image().height()}, {"seed", subject.seed}});
  narrator.trace().method_title =
      words.say("connected", {{"method", narrator.trace().method_title},
                              {"connectivity", narrator.arguments().text("connectivity")}});
  const Window shown = shown_cells(subject);
  constexpr std::int64_t small = 12;  // columns and rows that a panel shows, too
  narrator.trace().grid = {.cells = shown,
                           .y_up = false,
                           .x_name = words.say("column.column"),
                           .y_name = words.say("column.row"),
                           .whole = subject.is_maze && shown.width() <= small && shown.height() <= small,
                           .shelf = shelf_rows(subject),
                           .picture = subject.is_maze ? nullptr : subject.picture};
  for (const std::string_view cells : {"at", "window"})
    narrator.handles(cells, as_it_is_in(narrator.trace().grid.own()));
  if (!way.column.empty()) {
    std::vector<Column> columns{{"n"}, {"column"}, {"row"}, {"from", false}};
    if (way.queue() && subject.is_maze) columns.push_back({"distance"});
    columns.push_back({std::string(way.column)});
    narrator.columns(std::move(columns));
  }
  const std::string_view counts = way.column.empty() ? "runs" : name_of(way.counts);
  const std::string past = subject.is_maze             ? fmt::format("past.{}", counts)
                           : shows_waves(subject, way) ? "past.waves"
                                                       : "past";
  narrator.legend({{Role::input, "seed"},
                   Role::current,
                   {Role::candidate, fmt::format("candidate.{}", way.waiting)},
                   {Role::past, past},
                   Role::accepted,
                   Role::rejected,
                   Role::result,
                   Role::boundary,
                   {Role::measure, way.framed}});
  if (subject.is_maze) return;
  for (LegendEntry& entry : narrator.trace().legend) {
    if (entry.role == Role::past) entry.color = paint;  // as the pixels have it
  }
}

/// What the run leaves behind: its pixels, what it counted, and a maze as painted.
void finish(Narrator& narrator, const Story& story, const Image& painted, std::vector<Field> counts) {
  narrator.trace().pixels = story.pixels();
  if (story.subject().is_maze) counts.push_back({"maze", filled_maze(painted)});
  narrator.result(std::move(counts));
}

/// The methods that are right.
void tell_rightly(Narrator& narrator, Method method, const Way& way) {
  const Subject subject = subject_of(narrator.arguments());
  require_inside(subject);
  const Rgba8 color = paint_of(subject, narrator.arguments(), subject.seed);
  set_scene(narrator, subject, way, color);
  const Options options{subject.tolerance, subject.connectivity, method};
  Image image = subject.image();
  Story story(narrator.words(), subject, way, color);
  const auto watcher = narrator.watcher(story);
  const auto fill_in_window = [&](auto& inside, auto& paint) {
    return in_window(method, subject.seed, within_room(*subject.window), inside, paint, subject.connectivity,
                     watcher);
  };
  const Filled done = !subject.window || nothing_to_do(subject, color)
                          ? fill_image(image, subject.seed, color, options, watcher)
                          : fill_masked(image, subject, color, within_room(*subject.window), fill_in_window);
  finish(narrator, story, image,
         {{"painted", done.painted},
          {"peak_waiting", std::int64_t(done.peak_waiting)},
          {"peak_bytes", std::int64_t(done.peak_bytes)},
          {"mask_bytes", std::int64_t(done.mask_bytes)}});
}
void tell_depth_first(Narrator& narrator) { tell_rightly(narrator, Method::depth_first, on_path); }
void tell_breadth_first(Narrator& narrator) { tell_rightly(narrator, Method::breadth_first, in_queue); }
void tell_spans(Narrator& narrator) { tell_rightly(narrator, Method::span, as_spans); }

/// The notes' recursion. Refused by name for pictures that are too large for it.
void tell_recursive(Narrator& narrator) {
  const Subject subject = subject_of(narrator.arguments());
  require_inside(subject);
  const Window picture = subject.image().window();
  const Window cells = intersection(subject.window.value_or(picture), picture);
  const std::int64_t count = cells.empty() ? 0 : cells.width() * cells.height();
  if (count > most_recursive_cells) {
    refuse(subject.is_maze ? "maze" : "image",
           "method recursive keeps a call open for every pixel of its path, so at most {} cells: found {}",
           most_recursive_cells, count);
  }
  const Rgba8 color = paint_of(subject, narrator.arguments(), subject.seed);
  set_scene(narrator, subject, as_calls, color);
  Image image = subject.image();
  Story story(narrator.words(), subject, as_calls, color);
  const auto watcher = narrator.watcher(story);
  const Depth depth =
      fill_masked(image, subject, color, nothing_to_do(subject, color) ? Window{} : cells,
                  [&](auto& inside, auto& paint) {
                    return recursive(subject.seed, inside, paint, subject.connectivity, watcher);
                  });
  finish(narrator, story, image, {{"painted", depth.painted}, {"peak_calls", depth.peak}});
}

/// The notes' listing that reads the seed wherever it lies.
void tell_unchecked(Narrator& narrator) {
  const Subject subject = subject_of(narrator.arguments());
  if (subject.tolerance != 0) refuse("tolerance", "method unchecked_seed takes none");
  if (!room.contains(subject.seed)) refuse("at", "expected a cell two away from the ends of int32");
  Image image = subject.image();
  const std::int64_t index = row_major(image, subject.seed);
  const auto lands = cell_at(image, index);
  const Rgba8 color = lands ? paint_of(subject, narrator.arguments(), *lands) : default_color;
  set_scene(narrator, subject, unchecked, color);
  Story story(narrator.words(), subject, unchecked, color);
  const auto done = unchecked_seed(image, subject.seed, color, subject.connectivity, narrator.watcher(story));
  finish(narrator, story, image,
         {{"painted", done ? done->painted : 0}, {"index", index}, {"in_memory", lands.has_value()}});
}

const Checking& checking() {
  static const Checking known{.asked = {pixels_that_are(SameList::set)}};
  return known;
}

}  // namespace

const TopicEntry& entry() {  // the catalogue asks for it by this name
  using namespace parameters;
  static const TopicEntry topic = completed<entry>(
      {.name = "flood_fill",
       .chapter = "scan_conversion",
       .aliases = {"fill", "bucket fill", "seed fill", "paint bucket"},
       .summary = "paint everything that is connected to a seed",
       .methods = {{.name = "depth_first", .standing = Standing::taught, .tell = tell_depth_first},
                   {.name = "breadth_first", .tell = tell_breadth_first},
                   {.name = "span", .standing = Standing::fast, .tell = tell_spans},
                   {.name = "recursive",
                    .standing = Standing::faulty,
                    .tell = tell_recursive,
                    .function = "recurse"},
                   {.name = "unchecked_seed",
                    .standing = Standing::faulty,
                    .tell = tell_unchecked,
                    .without = {"window"},
                    .why_without = ""}},
       .default_method = "span",
       .columns = {{"n"}, {"row"}, {"left"}, {"right"}, {"pixels"}, {"painted"}},
       .counts = {"Painted", "SpanFilled", "Examined"},
       .parameters =
           {{"maze", ParameterType::maze, std::string(example_maze), "maze.txt",
             "what to fill: a text file, - or rows joined by /; # wall, . free, letters are colours"},
            {.name = "image",
             .type = ParameterType::picture,
             .default_value = "",
             .example = "photo.png",
             .help =
                 fmt::format("what to fill instead: a PNG or JPEG file of at most {} pixels", most_pixels),
             .most = most_pixels,
             .instead_of = "maze"},
            {"at", ParameterType::cell, "1,1", "3,4", "seed: column,row from the top left"},
            {"paint", ParameterType::paint, "", "#d55e00",
             "what to paint with: a colour, #0072b2 if not given; in a maze a letter, x if not given"},
            integer(0, 255, "tolerance", "0", "12",
                    "by how much each channel may differ from the seed's, 0 to 255"),
            choice("connectivity", {"4", "8"}, "4", "8", "neighbours of a pixel: 4 or 8"),
            {"window", ParameterType::window, "", "2,1,6,5",
             "fill only what lies in these cells: xmin,ymin,xmax,ymax, both corners included"}},
       .examples = {"--at 1,1 --method depth_first", "--maze '#####/#...#/#.#.#/#...#/#####' --at 2,1",
                    "--image photo.png --at 40,30 --paint '#d55e00' --tolerance 12"},
       .checking = &checking()});
  return topic;
}

}  // namespace gradus::flood_fill
