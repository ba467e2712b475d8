// The story of fractal curves: Koch's segments replaced by four, a curve as a text that grows and is walked,
// and a dimension measured by counting boxes.

#include "modeling/fractal_curve/fractal_curve.hpp"

#include "stories/modeling/fractal_curve/box_story.hpp"
#include "stories/modeling/fractal_curve/checking.hpp"
#include "stories/modeling/fractal_curve/koch_story.hpp"
#include "stories/modeling/fractal_curve/text_story.hpp"
#include "stories/parameters.hpp"
#include "stories/some_steps.hpp"

namespace gradus::fractal_curve {
namespace {

constexpr Extent whole_paper{{2, 1.5}, {34, 25.5}}, above_chart{{2, 16}, {34, 26}},
    beside_chart{{1, 2}, {20.5, 25}};

// --- Koch's curve

void set_up(Narrator& narrator, const Subject& subject, const Panel& panel) {
  require_scale(panel, narrator.arguments(), {"base"});
  narrator.paper(paper_width, paper_height);
  narrator.subtitle(subject.closed() ? "subtitle.snowflake" : "subtitle.curve", {{"level", subject.level}});
  narrator.handles("base", shown_in(panel));
}

template <bool inward>
void tell_koch(Narrator& narrator) {
  const Subject subject = subject_of(narrator.arguments(), inward);
  Extent extent = extent_of(subject.right_way());
  // A side that only looks inwards: its ends are its lowest points
  for (const dvec2 p : subject.way(subject.level)) extent.add(p);
  const Panel panel(whole_paper, extent);
  set_up(narrator, subject, panel);
  narrator.columns({{"level"}, {"segments"}, {"length"}, {"area"}});
  narrator.legend({{Role::input, "base"},
                   {Role::past, "before"},
                   {Role::rejected, "old"},
                   {Role::current, "parts"},
                   {Role::accepted, "so_far"},
                   {Role::result, "after"}});
  if (inward) narrator.add_to_legend(Role::candidate, "right");
  KochStory story(narrator.words(), subject, panel);
  const auto watch = narrator.watcher(story);
  watch(steps::Started{}, 0);
  const auto tells = [&]<class Step>(const Step& step) {
    if constexpr (std::same_as<Step, Replaced>) return subject.tells_segments(step.level);
    return true;
  };
  Corners way;
  if constexpr (inward)
    way = inside(base_of(subject.shape), subject.level, some_steps(watch, tells));
  else
    way = koch(base_of(subject.shape), subject.level, some_steps(watch, tells));
  const auto share = [&](std::int64_t above, int below) {
    return static_cast<double>(above) / static_cast<double>(power(below, subject.level));
  };
  narrator.result({{"segments", std::ssize(way) - 1},
                   {"length", share(power(4, subject.level), 3)},
                   {"area", share(triangles_of(way), 9)}});
}

// --- Texts

TextSubject text_of(const Arguments& arguments, bool in_turn = false) {
  const std::string& name = arguments.text("system");
  const System& system = name == "koch"        ? koch_system
                         : name == "dragon"    ? dragon_system
                         : name == "hilbert"   ? hilbert_system
                         : name == "arrowhead" ? arrowhead_system
                                               : plant_system;
  return {system, static_cast<int>(arguments.integer("level")), in_turn};
}

void set_up(Narrator& narrator, const TextSubject& subject) {
  narrator.paper(paper_width, paper_height);
  std::string rules;
  for (const Rule& rule : subject.system.rules) {
    if (rule.symbol != 0)
      rules += fmt::format("{}{} → {}", rules.empty() ? "" : ", ", rule.symbol, shown(rule.to));
  }
  narrator.subtitle("subtitle.text", {{"rules", rules}, {"degrees", subject.system.degrees}});
}

template <bool in_turn>
void tell_rewrite(Narrator& narrator) {
  const TextSubject subject = text_of(narrator.arguments(), in_turn);
  set_up(narrator, subject);
  narrator.columns({{"generation"}, {"symbols"}, {"steps"}});
  narrator.legend({{Role::past, "text"},
                   {Role::current, "symbol"},
                   {Role::measure, "becomes"},
                   {Role::accepted, "so_far"},
                   {Role::result, "new_text"}});
  RewriteStory story(narrator.words(), subject);
  const auto watch = narrator.watcher(story);
  watch(steps::Started{}, 0);
  const auto tells = [&]<class Step>(const Step& step) {
    if constexpr (std::same_as<Step, SymbolReplaced>)
      return subject.has_rule(step.symbol) && subject.tells_symbols(step.generation);
    return true;
  };
  const std::string axiom(subject.system.axiom);
  std::string text;
  if constexpr (in_turn)
    text = rule_after_rule(axiom, subject.system.rules, subject.level, some_steps(watch, tells));
  else
    text = rewrite(axiom, subject.system.rules, subject.level, some_steps(watch, tells));
  narrator.result({{"symbols", std::ssize(text)}, {"steps", story.steps(subject.level)}});
}

void tell_turtle(Narrator& narrator) {
  const TextSubject subject = text_of(narrator.arguments());
  set_up(narrator, subject);
  narrator.columns({{"at"}, {"symbol", false}, {"place", false}, {"heading"}, {"kept"}});
  narrator.legend({{Role::past, "to_come"},
                   {Role::current, "turtle"},
                   {Role::measure, "looks"},
                   {Role::accepted, "so_far"},
                   {Role::result, "drawn"}});
  TurtleStory story(subject);
  const auto watch = narrator.watcher(story);
  watch(steps::Started{}, 0);
  const auto tells = [&]<class Step>(const Step& step) {
    if constexpr (std::same_as<Step, SymbolRead<dvec2>>) return step.at < TurtleStory::most_told;
    return true;
  };
  turtle<dvec2>(story.text(), subject.way(), [](dvec2, dvec2) {}, some_steps(watch, tells));
  narrator.result({{"symbols", std::ssize(story.text())}, {"steps", story.steps()}});
}

// --- Boxes

void tell_boxes(Narrator& narrator) {
  const Subject subject = subject_of(narrator.arguments());
  const Measured measured(subject, static_cast<int>(narrator.arguments().integer("divide")));
  const Panel panel(subject.closed() ? beside_chart : above_chart, measured.shown);
  set_up(narrator, subject, panel);
  narrator.columns({{"side", false}, {"boxes"}, {"size"}, {"growth"}});
  narrator.legend({{Role::input, "curve"},
                   {Role::accepted, "boxes"},
                   {Role::current, "count"},
                   {Role::measure, "counts"},
                   {Role::result, "line"}});
  BoxStory story(narrator.words(), subject, measured, panel);
  const auto watch = narrator.watcher(story);
  watch(steps::Started{}, 0);
  box_count(measured.lines, measured.sides, watch);
  const Fit fit = story.fit();
  narrator.result({{"dimension", fit.slope}, {"error", fit.error}});
}

}  // namespace

const TopicEntry& entry();  // the catalogue asks for it by this name
const TopicEntry& entry() {
  using namespace parameters;
  const Names of_text{"shape", "base", "divide"};
  static const TopicEntry topic = completed<entry>(
      {.name = "fractal_curve",
       .chapter = "modeling",
       .aliases = {"koch", "snowflake", "l-system", "turtle", "box counting", "dragon curve",
                   "hilbert curve"},
       .summary =
           "a rule applied again and again: Koch's curve, texts that a turtle walks, measured dimension",
       .methods = {{.name = "koch",
                    .standing = Standing::taught,
                    .tell = tell_koch<false>,
                    .unread = {"system", "divide"}},
                   {.name = "l_system",
                    .tell = tell_rewrite<false>,
                    .function = "rewrite",
                    .file = "l_system.hpp",
                    .unread = of_text},
                   {.name = "turtle",
                    .tell = tell_turtle,
                    .file = "l_system.hpp",
                    .unread = of_text,
                    .opening = {{"system", "plant"}, {"level", "3"}}},
                   {.name = "box_count",
                    .tell = tell_boxes,
                    .file = "box_count.hpp",
                    .unread = {"system"},
                    .opening = {{"shape", "curve"}, {"level", "4"}}},
                   {.name = "inside",
                    .standing = Standing::faulty,
                    .tell = tell_koch<true>,
                    .unread = {"shape", "system", "divide"}},
                   {.name = "rule_after_rule",
                    .standing = Standing::faulty,
                    .tell = tell_rewrite<true>,
                    .unread = of_text,
                    .opening = {{"system", "dragon"}}}},
       .parameters = {choice("shape", {"snowflake", "curve"}, "snowflake", "curve",
                             "three sides of a triangle, or one segment"),
                      integer(1, 5, "level", "2", "3", "how often everything is replaced"),
                      points(2, 2, "base", "0,0 9,0", "1,2 7,5",
                             "the ends of the segment, or of the triangle's lower side", xy, {1e-12, 1e12}),
                      choice("system", {"koch", "dragon", "hilbert", "arrowhead", "plant"}, "koch", "dragon",
                             "the rules of a text"),
                      integer(2, 3, "divide", "3", "2", "how many smaller boxes lie along a box")},
       .examples = {"--shape curve --level 3", "--method l_system --system dragon --level 3",
                    "--method box_count --shape curve --level 4"},
       .checking = &checking()});
  return topic;
}

}  // namespace gradus::fractal_curve
