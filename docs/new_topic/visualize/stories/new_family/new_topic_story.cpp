// FILL IN: the story's subject. Until then: which pixel a walk visits next, and why.

#include "new_family/new_topic/new_topic.hpp"

#include "stories/parameters.hpp"
#include "stories/telling.hpp"

namespace gradus::new_topic {
namespace {

constexpr auto drop = [](ivec2) {};

// FILL IN: for each step type what it changes in the drawing (show), and what is told of it (say).
class Story {
 public:
  explicit Story(const Words& words) : words_(words) {}

  void show(Board& board, const Started& s) {
    at_ = s.from;
    to_ = s.to;
    board.milestone(s.from);
    board.plot(s.from, Role::current);
  }
  Event say(const Started& s) const {
    return standing({.text = "started", .facts = {{"from", s.from}, {"to", s.to}}});
  }

  void show(Board& board, const Stepped& s) {
    ++k_;
    before_ = at_;
    at_ = s.pixel;
    board.milestone(s.pixel);
    board.plot(s.pixel, Role::current);
  }
  Event say(const Stepped& s) const {
    const bool along_y = s.column_reached;
    return standing(
        {.text = along_y ? "stepped.along_y" : "stepped.along_x",
         .facts = {{"pixel", s.pixel}, {"column_reached", s.column_reached}},
         .words = {{"x", before_.x}, {"to", to_}},
         .read = {k_ - 1, before_.x, before_.y, words_.say(along_y ? "step.along_y" : "step.along_x")},
         .decides = decision(s)});
  }

  void show(Board& board, const Finished&) {
    board.detail(to_);
    board.all_plotted(Role::result);
  }
  Event say(const Finished& f) const { return {.text = "done", .facts = {{"pixels", f.pixels}}}; }

 private:
  /// Where the walk stands now: what the step is about, and a row of its own.
  Event standing(Event event) const {
    event.key = pixel_key(at_);
    event.row = {k_, at_.x, at_.y};
    return event;
  }
  Decision decision(const Stepped& s) const {
    return yes_or_no(words_, "question", {{"x", before_.x}, {"to", to_}}, s.column_reached, "along y",
                     "along x");
  }

  const Words& words_;
  ivec2 before_{}, at_{}, to_{};
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
       .parameters = {parameters::integer(0, 40, "columns", "12", "5",
                                          "how far to the right the walk ends, in pixels"),
                      parameters::integer(0, 40, "rows", "7", "2", "how far up it ends, in pixels")},
       .examples = {"--columns 5 --rows 2", "--columns 0 --rows 4", "--columns 9 --rows 0"}});
  return topic;
}

}  // namespace gradus::new_topic
