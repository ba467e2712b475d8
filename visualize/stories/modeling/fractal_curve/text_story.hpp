#pragma once
// Texts that grow and the turtle that reads them: the text before and behind, symbol above symbols, and what
// each of them draws.

#include "stories/modeling/fractal_curve/subject.hpp"

namespace gradus::fractal_curve {

struct TextSubject {
  System system;
  int level;
  bool in_turn = false;  ///< as the exhibit has it

  std::string text(int generation) const {
    const std::string axiom(system.axiom);
    return in_turn ? rule_after_rule(axiom, system.rules, generation)
                   : rewrite(axiom, system.rules, generation);
  }
  bool has_rule(char symbol) const {
    return std::ranges::any_of(system.rules, [&](const Rule& rule) { return rule.symbol == symbol; });
  }
  bool tells_symbols(int generation) const {
    constexpr std::ptrdiff_t most_told = 40;
    return std::ranges::count_if(text(generation - 1), [&](char s) { return has_rule(s); }) <= most_told;
  }
  auto way() const {
    return [this](std::int64_t turns) { return plane_way(turns, system.degrees); };
  }
};

/// A step that a symbol draws.
struct Drawn {
  Index at;
  dvec2 from, to;
};

/// All of them, and where the turtle stands behind each symbol.
struct Walked {
  std::vector<Drawn> steps{};
  std::vector<dvec2> stands{};
};
inline Walked walked(const TextSubject& subject, const std::string& text) {
  Walked all;
  turtle<dvec2>(
      text, subject.way(), [](dvec2, dvec2) {},
      [&]<class Step>(const Step& read) {
        if constexpr (std::same_as<Step, SymbolRead<dvec2>>) {
          if (draws(read.symbol)) all.steps.push_back({read.at, read.from, read.now.at});
          all.stands.push_back(read.now.at);
        }
      });
  return all;
}

/// One line of symbols, each at a place of its own; of long texts the part round one of them, so much apart
/// that signs keep their places beside another drawing.
class TextLine {
 public:
  TextLine(std::string_view text, double y, Index round) : text_(text), y_(y) {
    count_ = text.size() <= most ? text.size() : part;
    first_ = std::min(round - std::min(round, count_ / 2), text.size() - count_);
    apart_ = std::min(1.2, 33.4 / static_cast<double>(std::max<Index>(count_, 1)));
  }

  dvec2 at(Index i) const {
    const double k = std::clamp(static_cast<double>(i) - static_cast<double>(first_), -0.5,
                                static_cast<double>(count_) - 0.5);
    return {18 + (k - (static_cast<double>(count_) - 1) / 2) * apart_, y_};
  }
  template <class RoleOf>
  void add_to(View& view, const std::string& id, const RoleOf& role_of) const {
    for (Index i = first_; i < first_ + count_; ++i)
      view.add({fmt::format("{} {:05}", id, i), role_of(i), Text{at(i), shown(text_.substr(i, 1))}});
    if (first_ > 0) view.add({id + " before", Role::guide, Text{{0.7, y_}, "…"}});
    if (first_ + count_ < text_.size()) view.add({id + " behind", Role::guide, Text{{35.3, y_}, "…"}});
  }

 private:
  static constexpr Index most = 36, part = 28;

  std::string_view text_;
  double y_, apart_ = 1;
  Index first_ = 0, count_ = 0;
};

constexpr double upper_line = 25.2, lower_line = 21.7;
constexpr Extent below_text{{0.2, 1.2}, {35.8, 24}};

/// Steps of these symbols, in as few marks as they hang together.
inline void add_steps(View& view, const std::string& id, Role role, const Panel& panel,
                      const std::vector<Drawn>& steps, Index from, Index to) {
  Way way;
  int pieces = 0;
  const auto finish = [&] {
    if (!way.empty()) view.add({fmt::format("{} {:04}", id, pieces++), role, Path{panel.at(way)}});
    way.clear();
  };
  for (const Drawn& step : steps) {
    if (step.at < from || to <= step.at) continue;
    if (way.empty() || way.back() != step.from) finish(), way.push_back(step.from);
    way.push_back(step.to);
  }
  finish();
}

/// Whether a walk is much wider than it is high.
inline bool is_wide(const Walked& walk) {
  Extent extent;
  for (const Drawn& step : walk.steps) extent.add(step.from), extent.add(step.to);
  return !walk.steps.empty() && extent.size().x > 2.5 * extent.size().y;
}

inline Panel panel_of(const Walked& walk, const Extent& place) {
  Extent extent;
  extent.add({0, 0});
  for (const Drawn& step : walk.steps) extent.add(step.from), extent.add(step.to);
  // Without a step the turtle stands in the middle
  if (walk.steps.empty()) extent.add({-1, -1}), extent.add({1, 1});
  return {place, extent};
}

// --- Rewriting

class RewriteStory : public Past<steps::Started, SymbolReplaced, GenerationDone, TextFinished> {
 public:
  RewriteStory(const Words& words, const TextSubject& subject) : words_(words), subject_(subject) {
    for (int g = 0; g <= subject.level; ++g) {
      texts_.push_back(subject.text(g));
      walks_.push_back(walked(subject, texts_.back()));
    }
  }

  std::int64_t steps(int generation) const { return std::ssize(walk(generation).steps); }

  Event say(const steps::Started&) const {
    return {.text = "text.started", .words = {{"axiom", texts_[0]}}, .row = row(0)};
  }
  Event say(const SymbolReplaced& s) const {
    const std::string symbol = shown({&s.symbol, 1}), to = shown(s.to);
    return {.text = is_wrong(s) ? "symbol_replaced.in_turn" : "symbol_replaced",
            .facts = {{"generation", s.generation}, {"symbol", std::string(1, s.symbol)}, {"to", s.to}},
            .words = {{"symbol", symbol}, {"number", s.at + 1}, {"becomes", to}},
            .key = fmt::format("{}.{}", s.generation, s.at + 1),
            .phase = phase(s.generation),
            .decides = what_becomes(s)};
  }
  Event say(const GenerationDone& d) const {
    return {.text = "generation_done",
            .facts = {{"generation", d.generation}, {"symbols", d.symbols}, {"steps", steps(d.generation)}},
            .row = row(d.generation),
            .key = fmt::format("{}", d.generation),
            .phase = phase(d.generation)};
  }
  Event say(const TextFinished& f) const {
    return {.text = subject_.in_turn ? "text.finished.in_turn" : "text.finished",
            .facts = {{"symbols", f.symbols}},
            .words = {{"steps", steps(subject_.level)}, {"right", right_steps()}},
            .ends = true};
  }

  /// A symbol in the middle of the last generation that is told.
  double tells(const auto& step) const {
    if constexpr (std::same_as<std::decay_t<decltype(step)>, SymbolReplaced>) {
      const Index size = text(step.generation - 1).size();
      const double far = static_cast<double>(step.at) / static_cast<double>(size);
      return step.generation + (is_wrong(step) ? 0.5 + far / 2 : 2 * step.at >= size ? 0.25 : 0);
    }
    return 0;
  }

  View draw() const {
    View view;
    if (const auto* s = now<SymbolReplaced>()) {
      add_replaced(view, *s);
      return view;
    }
    const int generation = last<GenerationDone>() ? last<GenerationDone>()->generation : 0;
    const Role role = generation == 0 ? Role::past : Role::result;
    TextLine(text(generation), upper_line, 0).add_to(view, "a text", [&](Index) { return role; });
    const Panel panel = panel_of(walk(generation), below_text);
    add_steps(view, "b steps", role, panel, walk(generation).steps, 0, text(generation).size());
    if (walk(generation).steps.empty()) view.add({"b stand", role, Dot{panel.at({0, 0})}});
    return view;
  }

 private:
  const std::string& text(int generation) const { return texts_[static_cast<Index>(generation)]; }
  const Walked& walk(int generation) const { return walks_[static_cast<Index>(generation)]; }
  std::int64_t right_steps() const {
    return std::ranges::count_if(
        rewrite(std::string(subject_.system.axiom), subject_.system.rules, subject_.level), draws);
  }
  std::string phase(int generation) const {
    return words_.say("phase.generation", {{"generation", generation}});
  }
  std::vector<Said> row(int generation) const {
    return {generation, std::ssize(text(generation)), steps(generation)};
  }
  /// What the rules write, or the symbol as it is.
  Decision what_becomes(const SymbolReplaced& s) const {
    std::vector<std::string> answers;
    for (const Rule& rule : subject_.system.rules) {
      if (rule.symbol != 0) answers.push_back(shown(rule.to));
    }
    answers.push_back(shown({&s.symbol, 1}));
    const std::string given = shown(s.to);
    if (std::ranges::find(answers, given) == answers.end()) answers.push_back(given);
    const auto answer = std::ranges::find(answers, given) - answers.begin();
    return {words_.say("question.becomes", {{"symbol", shown({&s.symbol, 1})}}), answers,
            static_cast<std::size_t>(answer), is_wrong(s) ? "in turn" : "by its rule"};
  }
  /// More than one rule was applied.
  bool is_wrong(const SymbolReplaced& s) const { return s.to != by(subject_.system.rules, s.symbol); }
  void add_replaced(View& view, const SymbolReplaced& s) const {
    const Index end = s.begins + s.to.size();
    const TextLine before(text(s.generation - 1), upper_line, s.at);
    const TextLine after(std::string_view(text(s.generation)).substr(0, end), lower_line, end);
    before.add_to(view, "a before", [&](Index i) { return i == s.at ? Role::current : Role::past; });
    after.add_to(view, "b after", [&](Index i) { return i < s.begins ? Role::accepted : Role::current; });
    // From the symbol down to the first and the last of what it becomes
    const dvec2 from = before.at(s.at) - dvec2{0, 0.9};
    view.add(
        {"c first", Role::measure, Stroke{from, after.at(s.begins) + dvec2{0, 0.9}, false, false, true}});
    view.add({"c last", Role::measure, Stroke{from, after.at(end - 1) + dvec2{0, 0.9}, false, false, true}});
    const std::array<Extent, 2> places = places_of(walk(s.generation));
    add_walk(view, "d before", s.generation - 1, places[0], Role::past, s.at, s.at + 1,
             text(s.generation - 1).size());
    add_walk(view, "e after", s.generation, places[1], Role::accepted, s.begins, end, end);
    for (const Index which : {Index{0}, Index{1}})
      view.add({fmt::format("f heading {}", which), Role::guide,
                Text{{places[which].centre().x, places[which].upper.y + 1.3},
                     phase(s.generation - 1 + static_cast<int>(which))}});
  }
  /// Beside each other, or what is wide one above the other.
  static std::array<Extent, 2> places_of(const Walked& after) {
    if (is_wide(after)) return {Extent{{3, 11.4}, {33, 18}}, Extent{{3, 1.2}, {33, 8.6}}};
    return {Extent{{1.5, 1.2}, {17, 17.6}}, Extent{{19, 1.2}, {34.5, 17.6}}};
  }
  /// What the symbols up to `end` draw, those at hand in the light; where they draw nothing, the turtle.
  void add_walk(View& view, const std::string& id, int generation, const Extent& place, Role role,
                Index first, Index last, Index end) const {
    const Walked& all = walk(generation);
    const Panel panel = panel_of(all, place);
    add_steps(view, id + " a", role, panel, all.steps, 0, first);
    add_steps(view, id + " b", role, panel, all.steps, last, end);
    add_steps(view, id + " c", Role::current, panel, all.steps, first, last);
    const bool none = std::ranges::none_of(
        all.steps, [&](const Drawn& step) { return first <= step.at && step.at < last; });
    if (none) view.add({id + " d stand", Role::current, Dot{panel.at(all.stands[last - 1])}});
  }

  const Words& words_;
  const TextSubject& subject_;
  std::vector<std::string> texts_{};
  std::vector<Walked> walks_{};
};

// --- Reading

class TurtleStory : public Past<steps::Started, SymbolRead<dvec2>, WalkFinished> {
 public:
  explicit TurtleStory(const TextSubject& subject)
      : subject_(subject),
        text_(subject.text(subject.level)),
        all_(walked(subject, text_)),
        panel_(panel_of(all_, below_text)) {}

  /// More are read, but not told.
  static constexpr Index most_told = 200;
  const std::string& text() const { return text_; }
  std::int64_t steps() const { return std::ssize(all_.steps); }

  Event say(const steps::Started&) const {
    return {.text = "turtle.started", .words = {{"symbols", text_.size()}}};
  }
  Event say(const SymbolRead<dvec2>& r) const {
    const char s = r.symbol;
    return {.text = walks(s)   ? "read.step"
                    : s == '+' ? "read.left"
                    : s == '-' ? "read.right"
                    : s == '[' ? "read.keep"
                    : s == ']' ? "read.restore"
                               : "read.nothing",
            .facts = {{"at", static_cast<std::int64_t>(r.at)}, {"x", r.now.at.x}, {"y", r.now.at.y}},
            .words = {{"symbol", shown({&s, 1})},
                      {"from", near(r.from)},
                      {"place", near(r.now.at)},
                      {"angle", subject_.system.degrees},
                      {"degrees", heading(r)},
                      {"kept", r.kept}},
            .row = {r.at + 1, shown({&s, 1}), near(r.now.at), heading(r), r.kept},
            .key = fmt::format("{}", r.at + 1)};
  }
  Event say(const WalkFinished& f) const {
    return {.text = "turtle.finished",
            .facts = {{"symbols", f.symbols}},
            .words = {{"steps", steps()}},
            .ends = true};
  }

  /// The bracket that brings the turtle back furthest, or a step in the middle.
  double tells(const auto& step) const {
    if constexpr (std::same_as<std::decay_t<decltype(step)>, SymbolRead<dvec2>>) {
      const double back = length_between(step.from, step.now.at);
      if (step.symbol == ']') return back > 0 ? 1 + back : 0;
      return draws(step.symbol) && 2 * step.at >= text_.size() ? 1 : 0;
    }
    return 0;
  }

  View draw() const {
    View view;
    const auto* r = now<SymbolRead<dvec2>>();
    const Index read = now<WalkFinished>() ? text_.size() : r ? r->at : 0;
    const Role so_far = r ? Role::accepted : Role::result;
    TextLine(text_, upper_line, read).add_to(view, "a text", [&](Index i) {
      return r && i == r->at ? Role::current : i >= read ? Role::past : so_far;
    });
    add_steps(view, "b to come", Role::past, panel_, all_.steps, read, text_.size());
    add_steps(view, "c drawn", so_far, panel_, all_.steps, 0, read);
    if (r) add_turtle(view, *r);
    return view;
  }

 private:
  /// What is 0 but for roundings is 0.
  static dvec2 near(dvec2 p) {
    constexpr double noise = 1e-9;
    return {std::abs(p.x) < noise ? 0 : p.x, std::abs(p.y) < noise ? 0 : p.y};
  }
  /// From 0 to below 360.
  double heading(const SymbolRead<dvec2>& r) const {
    const double degrees = std::fmod(static_cast<double>(r.now.turn) * subject_.system.degrees, 360);
    return degrees < 0 ? degrees + 360 : degrees;
  }
  void add_turtle(View& view, const SymbolRead<dvec2>& r) const {
    const dvec2 from = panel_.at(r.from), at = panel_.at(r.now.at);
    if (draws(r.symbol)) view.add({"d step", Role::current, Stroke{from, at}});
    const dvec2 way = plane_way(r.now.turn, subject_.system.degrees);
    constexpr double long_enough = 2;
    // It looks much the way that it comes back: one arrow of the two
    if (r.symbol == ']' && from != at)
      view.add({"d back", Role::measure, Stroke{from, at, true, true}});
    else
      view.add({"e looks", Role::measure, Stroke{at, at + long_enough * way, true}});
    view.add({"f turtle", Role::current, Dot{at}});
  }

  const TextSubject& subject_;
  const std::string text_;
  const Walked all_;
  const Panel panel_;
};

}  // namespace gradus::fractal_curve
