// FILL IN: the story's subject. Until then: which pixel a walk visits next, and why.

#include "new_family/new_topic/new_topic.hpp"

#include "stories/telling.hpp"

namespace gradus::new_topic {
namespace {

constexpr auto drop = [](ivec2) {};

// FILL IN: for each step type what it changes in the drawing (show), and what is told of it (say).
class Story {
 public:
  explicit Story(const Words& words) : words_(words) {}

  void show(Board& board, const Started& s) {
    to_ = s.to;
    board.milestone(s.from);
    board.plot(s.from, Role::current);
  }
  Event say(const Started& s) const {
    return standing({.text = "started", .facts = {{"from", s.from}, {"to", s.to}}}, s.from);
  }

  void show(Board& board, const Stepped& s) {
    ++k_;
    board.milestone(s.pixel);
    board.plot(s.pixel, Role::current);
  }
  Event say(const Stepped& s) const {
    const std::string_view way = s.column_reached ? "along_y" : "along_x";
    return standing(
        {.text = s.column_reached ? "stepped.along_y" : "stepped.along_x",
         .facts = {{"from", s.from, "pixel"}, {"pixel", s.pixel}, {"column_reached", s.column_reached}},
         .words = {{"x", s.from.x}, {"to", to_}},
         .read = {k_ - 1, s.from.x, s.from.y, words_.say(fmt::format("step.{}", way))},
         .decides = yes_or_no(words_, words_.say("question", {{"x", s.from.x}, {"to", to_}}),
                              s.column_reached, s.column_reached ? "along y" : "along x")},
        s.pixel);
  }

  void show(Board& board, const Finished&) {
    board.detail(to_);
    board.all_plotted(Role::result);
  }
  Event say(const Finished& f) const { return {.text = "done", .facts = {{"pixels", f.pixels}}}; }

 private:
  /// Where the walk stands now: what the step is about, and a row of its own.
  Event standing(Event event, ivec2 pixel) const {
    event.key = pixel_key(pixel);
    event.row = {k_, pixel.x, pixel.y};
    return event;
  }

  const Words& words_;
  ivec2 to_{};
  std::int64_t k_ = 0;
};

// --- The methods

void tell_walk(Narrator& narrator) {
  const Arguments& given = narrator.arguments();
  const ivec2 from{0, 0};
  const ivec2 to(given.integer("columns"), given.integer("rows"));
  narrator.grid({from, to});
  narrator.subtitle("subtitle", {{"from", from}, {"to", to}});
  narrator.backdrop("end", Role::input, Dot{dvec2(to), true});
  narrator.legend(
      {{Role::input, "end"}, {Role::past, "past"}, {Role::current, "current"}, {Role::result, "result"}});
  Story story(narrator.words());
  walk(from, to, drop, narrator.watcher(story));
  narrator.result({{"pixels", narrator.board().plotted()}});
}

}  // namespace

// FILL IN: names to look for, methods, columns, parameters with unit, range, default and example.
const TopicEntry& entry();  // the catalogue asks for it by this name
const TopicEntry& entry() {
  static const TopicEntry topic = completed<entry>(
      {.name = "new_topic",
       .chapter = "new_family",
       .aliases = {},
       .summary = "FILL IN: what it does, in a line",
       .methods = {{.name = "walk", .standing = Standing::taught, .tell = tell_walk}},
       .columns = {{"k"}, {"x"}, {"y"}, {"step", false}},
       .parameters = {{.name = "columns",
                       .type = ParameterType::integer,
                       .default_value = "12",
                       .example = "5",
                       .help = "how far to the right the walk ends, in pixels",
                       .least = 0,
                       .most = 40},
                      {.name = "rows",
                       .type = ParameterType::integer,
                       .default_value = "7",
                       .example = "2",
                       .help = "how far up it ends, in pixels",
                       .least = 0,
                       .most = 40}},
       .examples = {"--columns 5 --rows 2", "--columns 0 --rows 4", "--columns 9 --rows 0"}});
  return topic;
}

}  // namespace gradus::new_topic
