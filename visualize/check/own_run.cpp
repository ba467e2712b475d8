#include "check/own_run.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>

#include "check/lists.hpp"
#include "figure/recording.hpp"

namespace gradus::check {
namespace {

using fmt::arg;

/// A wider grid than this is not drawn for the sake of a wrong cell.
constexpr int most_wider = 64;

/// As figures have it: numbers with the typographic minus.
std::string drawn_text(const Value& value) {
  std::string text = text_of(value);
  if (std::holds_alternative<std::string>(value)) return text;
  for (std::size_t at = text.find('-'); at != std::string::npos; at = text.find('-', at))
    text.replace(at, 1, "−");
  return text;
}
std::string drawn_text(const Element& element) {
  std::string all;
  for (const Value& value : element) all += (all.empty() ? "" : ", ") + drawn_text(value);
  return all;
}

class OwnRunWriter {
 public:
  OwnRunWriter(const Task& task, const Expected& expected, const Translated& theirs,
               const Judgement& judgement, double tolerance)
      : ours_(task.ours),
        expected_(expected),
        theirs_(theirs),
        judgement_(judgement),
        tolerance_(tolerance),
        cells_(expected.steps.size()),
        values_(expected.steps.size()) {
    for (const Translated::List& list : theirs.lists) take(list);
    for (const Translated::Step& step : theirs.steps) {
      if (step.stands_for)
        values_[*step.stands_for].insert(values_[*step.stands_for].end(), step.values.begin(),
                                         step.values.end());
    }
    for (const ivec2 cell : judgement.wrong_cells) wrong_.insert({cell.x, cell.y});
  }

  Trace write() {
    Trace trace = frame();
    for (std::size_t place = 0; place < expected_.steps.size(); ++place) trace.steps.push_back(step(place));
    trace.last = ours_.last;
    measure_texts(trace);
    trace.telling = trace.steps.back().number;
    return trace;
  }

 private:
  bool on_cells() const { return ours_.grid.axes && has_cells_; }
  bool last(std::size_t place) const { return place + 1 == expected_.steps.size(); }
  bool wrong(ivec2 cell) const { return wrong_.contains({cell.x, cell.y}); }

  void take(const Translated::List& list) {
    if (!list.ours->cells()) {
      lists_.push_back(beside(list));
      return;
    }
    has_cells_ = true;
    const auto places = steps_of(list, expected_);
    for (std::size_t i = 0; i < places.size(); ++i) cells_[places[i]].push_back(cell_of(list.elements[i]));
  }

  /// A list, and ours as it stands beside that.
  struct Beside {
    std::string name;
    std::vector<ExpectedElement> ours;
    std::vector<Element> theirs;
  };
  Beside beside(const Translated::List& list) const {
    Beside lists{list.ours->name, list.ours->elements, list.elements};
    if (list.ours->same == SameList::ring) {
      RingsBeside rings = rings_beside(*list.ours, list.elements, tolerance_);
      lists = {list.ours->name, std::move(rings.ours), std::move(rings.theirs)};
    }
    if (list.ours->same == SameList::segments)
      turn_segments(elements_of(*list.ours), lists.theirs, tolerance_);
    return lists;
  }

  /// What is said of the run as a whole.
  Trace frame() {
    Trace trace;
    trace.topic = ours_.topic;
    trace.title = ours_.title;
    trace.subtitle = ours_.subtitle;
    trace.method = ours_.method;
    trace.method_title = ours_.wording.say("check.own_answer");
    if (judgement_.verdict == Verdict::wrong && judgement_.step)
      trace.faulty = ours_.wording.say("check.wrong_from", arg("number", *judgement_.step));
    else if (judgement_.verdict == Verdict::wrong)
      trace.faulty = ours_.wording.say("check.wrong");
    trace.goal = ours_.goal;
    trace.wording = ours_.wording;
    trace.arguments = ours_.arguments;
    trace.legend = ours_.legend;
    trace.grid = ours_.grid;
    if (on_cells()) {
      trace.backdrop = ours_.backdrop;
      widen(trace.grid.cells);
    }
    trace.before = Canvas(trace.grid.cells);
    return trace;
  }
  void widen(Window& window) const {
    const Window room{window.lower - most_wider, window.upper + most_wider};
    for (const auto& group : cells_) {
      for (const ivec2 cell : group) {
        if (!room.contains(cell)) continue;
        window = {glm::min(window.lower, cell), glm::max(window.upper, cell)};
      }
    }
  }

  TraceStep step(std::size_t place) {
    const TraceStep& ours = *expected_.steps[place];
    TraceStep step;
    step.number = ours.number;
    step.phase = ours.phase;
    step.type = "Answered";
    step.focus = ours.focus;
    if (on_cells())
      draw_cells(step, place);
    else
      write_values(step, place);
    step.sentence = sentence(place);
    return step;
  }

  void draw_cells(TraceStep& step, std::size_t place) {
    for (const ivec2 cell : now_) step.delta.cells.push_back({cell, CellLook{Role::past, ""}});
    now_.clear();
    for (const ivec2 cell : cells_[place]) {
      drawn_.push_back(cell);
      if (!wrong(cell)) now_.push_back(cell);
      step.delta.cells.push_back({cell, CellLook{wrong(cell) ? Role::rejected : Role::current, ""}});
    }
    const auto first_wrong = std::ranges::find_if(cells_[place], [this](ivec2 cell) { return wrong(cell); });
    if (!cells_[place].empty())
      step.focus = first_wrong == cells_[place].end() ? cells_[place].front() : *first_wrong;
    if (!cells_[place].empty()) step.key = fmt::format("{},{}", step.focus.x, step.focus.y);
    const bool before_the_result = !last(place);
    if (before_the_result) return;
    for (const ivec2 cell : drawn_) {
      if (!wrong(cell)) step.delta.cells.push_back({cell, CellLook{Role::result, ""}});
    }
  }

  /// "x = 2.5", and of those that differ "x = 2.5 ≠ 2".
  struct Line {
    std::string text;
    bool wrong = false;
  };
  std::vector<Line> lines_of(std::size_t place) const {
    std::vector<Line> lines;
    const Values ours = values_of(*expected_.steps[place]);
    for (const Field& field : values_[place]) lines.push_back(line(field, value_of(ours, field.name)));
    if (!last(place)) return lines;
    for (const Field& field : theirs_.values)
      lines.push_back(line(field, value_of(expected_.values, field.name)));
    for (const auto& [name, all, theirs] : lists_) {
      for (std::size_t i = 0; i < theirs.size(); ++i) {
        const bool same = i < all.size() && agree(all[i].values, theirs[i], tolerance_);
        lines.push_back({fmt::format("{} {}: {}", name, i + 1, drawn_text(theirs[i])), !same});
      }
    }
    return lines;
  }
  static Line line(const Field& field, const Value* ours) {
    const std::string theirs = drawn_text(field.value);
    const bool same = ours && (drawn_text(*ours) == theirs || agree(*ours, field.value, 1e-6));
    return {fmt::format("{} = {}{}", field.name, theirs, same || !ours ? "" : " ≠ " + drawn_text(*ours)),
            !same};
  }
  void write_values(TraceStep& step, std::size_t place) {
    constexpr std::size_t most_lines = 12;
    std::vector<Line> lines = lines_of(place);
    if (lines.size() > most_lines) {
      // Those that differ before those that do not
      std::ranges::stable_sort(lines, {}, [](const Line& l) { return !l.wrong; });
      lines.resize(most_lines);
    }
    const dvec2 lower(ours_.grid.cells.lower), upper(ours_.grid.cells.upper);
    const double height = (upper.y - lower.y) / (most_lines + 1);
    for (std::size_t i = written_; i > lines.size(); --i)
      step.delta.removed.push_back(fmt::format("line {:02}", i - 1));
    for (std::size_t i = 0; i < lines.size(); ++i) {
      const double down = height * static_cast<double>(i + 1);
      const dvec2 at{lower.x + (upper.x - lower.x) / 12, ours_.grid.y_up ? upper.y - down : lower.y + down};
      step.delta.set.push_back({fmt::format("line {:02}", i), lines[i].wrong ? Role::rejected : Role::result,
                                Text{at, lines[i].text, Align::left}});
    }
    written_ = lines.size();
    step.delta.plane = true;
  }

  std::string sentence(std::size_t place) const {
    const Wording& wording = ours_.wording;
    std::vector<std::string> texts;
    if (on_cells()) {
      for (const ivec2 cell : cells_[place]) texts.push_back(drawn_text(Value(cell)));
    }
    for (const Line& line : lines_of(place)) texts.push_back(line.text);
    if (texts.empty()) return wording.say("check.nothing");
    constexpr std::size_t most = 8;
    const bool more = texts.size() > most;
    if (more) texts.resize(most);
    return wording.say("check.answered",
                       arg("values", fmt::format("{}{}", fmt::join(texts, ", "), more ? ", …" : "")));
  }

  const Trace& ours_;
  const Expected& expected_;
  const Translated& theirs_;
  const Judgement& judgement_;
  const double tolerance_;
  std::vector<std::vector<ivec2>> cells_;  ///< theirs, by the step of ours that they belong to
  std::vector<Values> values_;             ///< the same
  std::vector<Beside> lists_;
  std::set<std::pair<int, int>> wrong_;
  std::vector<ivec2> now_, drawn_;
  std::size_t written_ = 0;
  bool has_cells_ = false;
};

Alignment side_by_side(const Expected& expected, const Judgement& judgement) {
  Alignment alignment;
  const bool parts = judgement.verdict == Verdict::wrong;
  const std::int64_t first = judgement.step.value_or(expected.steps.back()->number.step);
  for (const TraceStep* step : expected.steps) {
    if (parts && !alignment.parting && step->number.step >= first) alignment.parting = alignment.pairs.size();
    alignment.pairs.push_back({step->number, step->number});
  }
  return alignment;
}

}  // namespace

GivenRun own_run(const Task& task, const OwnAnswers& answers, const OwnAnswer& answer) {
  const Expected expected = expected_of(task.topic, task.ours);
  const Translated theirs = translated(task.topic, task.ours, expected, answers, answer, answers.conventions);
  const Judgement judgement = judge(task, answers, answer);
  const double tolerance = tolerance_of(task, answers);
  return {OwnRunWriter(task, expected, theirs, judgement, tolerance).write(),
          side_by_side(expected, judgement)};
}

}  // namespace gradus::check
