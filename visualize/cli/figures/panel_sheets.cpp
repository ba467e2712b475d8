#include "cli/figures/panel_sheets.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <set>
#include <span>

#include "cli/command_line/errors.hpp"
#include "figure/legend.hpp"
#include "figure/panels.hpp"
#include "figure/which_steps.hpp"
#include "request/names.hpp"

namespace gradus::cli {
namespace {

using fmt::arg;

/// What is said of the run as a whole, where these of its steps are shown.
Trace banner_of(const Trace& trace, std::span<const StepNumber> steps) {
  Trace banner;
  banner.topic = trace.topic;
  banner.title = trace.title;
  banner.subtitle = trace.subtitle;
  banner.method_title = trace.method_title;
  banner.faulty = trace.faulty;
  banner.wording = trace.wording;
  banner.legend = legend_at(trace, steps);
  banner.longest_sentence = trace.goal;
  return banner;
}

const TraceStep& told_step(const Figure& figure) {
  return figure.trace->steps[index_of(*figure.trace, figure.number)];
}

// --- Steps of one run --------------------------------------------------------------------------------------

/// The phases between the input and the result, in their order.
std::vector<std::string> phases_of(const Trace& trace) {
  std::vector<std::string> phases;
  for (const TraceStep& step : trace.steps) {
    const bool at_an_end =
        step.phase == trace.wording.say("words.set_up") || step.phase == trace.wording.say("words.result");
    if (step.number.fine == 0 && !at_an_end && std::ranges::find(phases, step.phase) == phases.end())
      phases.push_back(step.phase);
  }
  return phases;
}

/// Whether each drawing stands for a phase of its own.
bool shows_phases(const FigureSpec& spec, const Takes& takes) {
  return spec.panels->phases && phases_of(takes.opening()).size() > 1;
}

/// "2. right border"; a phase that has its number already keeps it.
std::string numbered(const std::string& phase, const std::vector<std::string>& phases) {
  if (phase.find_first_of("0123456789") != phase.npos) return phase;
  return fmt::format("{}. {}", std::ranges::find(phases, phase) - phases.begin() + 1, phase);
}

/// Whether a column is named by a word and not by a symbol as formulas have it.
bool is_word(std::string_view name) {
  // In UTF-8 letters like ö begin with this byte, Greek ones and signs with others
  constexpr char accented = '\xc3';
  std::string leading(name);
  std::erase_if(leading, [](char c) { return (static_cast<unsigned char>(c) & 0xc0) == 0x80; });
  const auto is_letter = [](char c) {
    return c == accented || std::isalpha(static_cast<unsigned char>(c)) != 0;
  };
  return !std::ranges::search_n(leading, 3, true, {}, is_letter).empty();
}

/// What is new in the step's row: "t = 0.5", "corners: 4".
std::string news_of(const Figure& figure) {
  const TraceStep& step = told_step(figure);
  if (figure.rows.empty() || step.row.empty()) return "";
  const Figure::TableRow& row = figure.rows.back();
  std::string note;
  for (std::size_t c = 0, told = 0; c < row.changed.size() && told < 2; ++c) {
    if (!row.changed[c]) continue;
    const std::string& name = figure.trace->columns[c].name;
    note += (told++ == 0 ? "" : ", ") +
            figure.trace->wording.say(is_word(name) ? "figure.panel_word" : "figure.panel_value",
                                      arg("name", name), arg("value", row.cells[c]));
  }
  return note;
}

/// What the step says of its effect, else what is new in its row.
std::string note_of(const Figure& figure) {
  const std::string& note = told_step(figure).note;
  return note.empty() ? news_of(figure) : note;
}

/// What tells the panels apart; empty where that is not known of each.
using Names = std::vector<std::string>;

bool all_differ(const Names& names) {
  const std::set<std::string> known(names.begin(), names.end());
  return known.size() == names.size() && !known.contains("");
}

/// Names of steps, each another one: their phases, else what they say of their effects. None: there are none.
Names names_of(std::span<const TraceStep> steps) {
  for (const auto& member : {&TraceStep::phase, &TraceStep::note}) {
    Names names;
    for (const TraceStep& step : steps) names.push_back(step.*member);
    if (all_differ(names)) return names;
  }
  return {};
}

// --- Two runs ----------------------------------------------------------------------------------------------

/// The inputs in which a run differs from another one of its topic and method: "receding 45,1".
std::string own_inputs(const Trace& trace, const Trace& other) {
  std::string text;
  for (const Argument& argument : trace.arguments) {
    const auto same = std::ranges::find(other.arguments, argument.name, &Argument::name);
    if (same != other.arguments.end() && same->value == argument.value) continue;
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", hyphened(argument.name), argument.value);
  }
  return text;
}

/// What tells a side from the other.
std::string name_beside(const Trace& trace, const Trace& other) {
  if (trace.topic != other.topic) return trace.title;
  if (trace.method_title != other.method_title) return trace.method_title;
  const std::string inputs = own_inputs(trace, other);
  return inputs.empty() ? trace.method_title : inputs;
}

/// Where a mark is looked at, and how much it is worth a look: dots before strokes, what is current or a
/// result before all else.
std::optional<std::pair<int, dvec2>> place_of(const Mark& mark) {
  const int current = mark.role == Role::current || mark.role == Role::result ? 2 : 0;
  if (const Dot* dot = std::get_if<Dot>(&mark.shape)) return std::pair{current + 1, dot->at};
  if (const Stroke* stroke = std::get_if<Stroke>(&mark.shape)) return std::pair{current, stroke->b};
  return std::nullopt;
}

/// The cell in which the drawings differ that a step of either has just changed, the one it looks at first.
std::optional<dvec2> differing_cell(const Figure& a, const Figure& b) {
  std::vector<ivec2> cells{a.focus, b.focus};
  for (const Figure* figure : {&a, &b}) {
    for (const CellChange& change : told_step(*figure).delta.cells) cells.push_back(change.at);
  }
  const auto differs = [&](ivec2 p) {
    return a.trace->grid.own().contains(p) && a.canvas->at(p) != b.canvas->at(p);
  };
  const auto found = std::ranges::find_if(cells, differs);
  return found == cells.end() ? std::nullopt : std::optional(dvec2(*found));
}

/// The best of the marks that the step has drawn and the other drawing has not.
std::optional<dvec2> differing_mark(const Figure& figure, const Figure& other) {
  std::optional<std::pair<int, dvec2>> best;
  for (const Mark& mark : told_step(figure).delta.set) {
    const bool in_both = std::ranges::any_of(other.canvas->marks(), [&](const auto& theirs) {
      return theirs.second.role == mark.role && theirs.second.shape == mark.shape;
    });
    const auto place = in_both ? std::nullopt : place_of(mark);
    if (place && (!best || place->first > best->first)) best = place;
  }
  return best ? std::optional(best->second) : std::nullopt;
}

/// Where it is seen in a figure that its step differs from the other's; nothing: it is not.
std::optional<dvec2> place_of_difference(const Figure& figure, const Figure& other) {
  if (const auto cell = differing_cell(figure, other)) return cell;
  return differing_mark(figure, other);
}

/// How many pairs of steps are looked at for a difference that can be seen.
constexpr std::size_t most_pairs = 500;

/// Whether there is nothing wrong with either run: then it is what they come to that is of interest.
bool both_right(const FigureSpec& spec, const Takes& takes) {
  return !spec.compare->given && takes.opening().faulty.empty() && takes.beside()->opening().faulty.empty();
}

/// The first steps at which the runs part and it is seen, or at which they part.
std::optional<StepPair> parting_pair(const Takes& takes) {
  const Alignment& alignment = takes.alignment();
  if (!alignment.parting) return std::nullopt;
  const std::size_t first = *alignment.parting, end = std::min(alignment.pairs.size(), first + most_pairs);
  const Trace &of_a = takes.opening(), &of_b = takes.beside()->opening();
  Playhead head_a(of_a), head_b(of_b);
  for (std::size_t i = first; i < end; ++i) {
    const Figure a = figure_of(of_a, head_a, alignment.pairs[i].a),
                 b = figure_of(of_b, head_b, alignment.pairs[i].b);
    if (place_of_difference(a, b) || place_of_difference(b, a)) return alignment.pairs[i];
  }
  return alignment.pairs[first];
}

std::string joined(const Wording& wording, const std::string& a, const std::string& b) {
  return a == b ? a : wording.say("figure.compared", arg("a", a), arg("b", b));
}

/// Of two legends what either has, each entry behind those that are before it in its own.
std::vector<LegendEntry> merged(std::vector<LegendEntry> all, const std::vector<LegendEntry>& others) {
  auto at = all.begin();
  for (const LegendEntry& entry : others) {
    const auto same = std::ranges::find(all, entry.text, &LegendEntry::text);
    at = std::next(same != all.end() ? same : all.insert(at, entry));
  }
  return all;
}

Trace banner_of(const Figure& of_a, const Figure& of_b) {
  const Trace &a = *of_a.trace, &b = *of_b.trace;
  Trace banner = banner_of(a, {&of_a.number, 1});
  banner.legend = merged(std::move(banner.legend), legend_at(b, {&of_b.number, 1}));
  banner.title = joined(a.wording, a.title, b.title);
  // Topics word the same input each in its own way
  if (a.topic == b.topic) banner.subtitle = joined(a.wording, a.subtitle, b.subtitle);
  const bool same_method = a.topic == b.topic && a.method_title == b.method_title;
  if (!same_method) banner.method_title.clear();
  banner.faulty = a.faulty.empty() ? b.faulty : a.faulty;
  return banner;
}

using Counts = std::vector<std::pair<std::string, std::string>>;

/// "cuts: 4" as its two parts.
Counts counts_of(const Trace& trace) {
  Counts counts;
  for (const std::string& count : trace.counts) {
    const std::size_t colon = std::min(count.find(": "), count.size());
    counts.emplace_back(count.substr(0, colon), count.substr(std::min(colon + 2, count.size())));
  }
  return counts;
}

StepPair pair_at(const Takes& takes, StepNumber step) {
  StepPair pair = pair_with(takes.alignment(), {step.step, 0});
  pair.a = step;
  return pair;
}

}  // namespace

std::vector<StepNumber> panel_steps(const FigureSpec& spec, const Takes& takes) {
  const PanelChoice& choice = *spec.panels;
  if (choice.phases) {
    std::vector<StepNumber> steps = phase_steps(takes.opening(), PanelChoice::most);
    if (steps.size() >= PanelChoice::least) return steps;
    throw UsageError(fmt::format("--panels: expected a run of {} steps or more, found {}", PanelChoice::least,
                                 steps.size()));
  }
  for (const StepNumber step : choice.steps) takes.check(step, "--panels", spec.said.at("panels"));
  return choice.steps;
}

std::string panels_text(const FigureSpec& spec, const Takes& takes) {
  const Trace& trace = takes.opening();
  return trace.wording.say(shows_phases(spec, takes) ? "figure.panels_phases" : "figure.panels",
                           arg("number", panel_steps(spec, takes).size()), arg("last", trace.last));
}

Sheet panels_sheet(const FigureSpec& spec, Takes& takes, const Look& look) {
  const Trace& trace = takes.opening();
  const std::vector<StepNumber> steps = panel_steps(spec, takes);
  const std::vector<const Trace*> runs(steps.size(), &trace);
  const std::vector<std::string> phases = phases_of(trace);
  const bool by_phase = shows_phases(spec, takes);
  std::vector<TraceStep> told;
  for (const StepNumber step : steps) told.push_back(told_step(takes.figure(step)));
  const Names names = names_of(told);
  PanelBand band{banner_of(trace, steps), panels_text(spec, takes), trace.goal};
  for (const StepNumber step : steps) band.own_sentences.push_back(takes.figure(step).sentence);
  return lay_out_panels(runs, band, look, [&](std::size_t i) {
    const Figure figure = takes.figure(steps[i]);
    const std::string number = trace.wording.say("figure.panel", arg("number", text_of(steps[i])));
    std::string note = note_of(figure);
    std::string heading = number;
    if (by_phase) {
      heading = numbered(figure.phase, phases);
    } else if (!names.empty()) {
      const bool has_values = names[i].find('=') != std::string::npos;
      if (note == names[i]) note = has_values ? "" : news_of(figure);
      note = note.empty() ? number : number + ", " + note;
      heading = names[i];
    } else if (!told[i].note.empty()) {
      heading = number + ": " + note;
      note = news_of(figure);
    }
    return SheetPanel{.figure = figure, .heading = std::move(heading), .note = std::move(note), .ring = {}};
  });
}

StepNumber compared_step(const FigureSpec& spec, const Takes& takes) {
  if (both_right(spec, takes)) return {takes.last(), 0};
  const auto parting = parting_pair(takes);
  return parting ? parting->a : takes.opening().telling;
}

Sheet compared_sheet(const FigureSpec& spec, Takes& takes, StepNumber step, const Look& look) {
  const auto parting = both_right(spec, takes) ? std::nullopt : parting_pair(takes);
  const bool parts = parting && parting->a == step;
  // Beside the last step before a run ends early, the other's next one
  const StepPair pair = parts ? *parting : pair_at(takes, step);
  const Figure a = takes.figure(pair.a), b = takes.beside()->figure(pair.b);
  const Trace &of_a = *a.trace, &of_b = *b.trace;
  const std::array runs{&of_a, &of_b};
  const Wording& wording = of_a.wording;
  const bool results = both_right(spec, takes) && step == StepNumber{takes.last(), 0};
  const PanelBand band{.banner = banner_of(a, b),
                       .position = joined(wording, a.position, b.position),
                       .sentence = "",
                       .own_sentences = {of_a.longest_sentence, of_b.longest_sentence},
                       .counted = results && !(of_a.counts.empty() && of_b.counts.empty())};
  const auto side = [&](const Figure& figure, const Figure& other) {
    const auto ring = parts ? place_of_difference(figure, other) : std::nullopt;
    const std::string own = told_step(figure).note;
    const std::string number = wording.say("figure.panel", arg("number", text_of(figure.number)));
    const std::string note = ring                           ? wording.say("figure.parting")
                             : !own.empty() || band.counted ? own
                                                            : number;
    return SheetPanel{.figure = figure,
                      .heading = name_beside(*figure.trace, *other.trace),
                      .note = note,
                      .faulty = !figure.trace->faulty.empty(),
                      .parts = ring.has_value(),
                      .ring = ring,
                      .counts = results ? counts_of(*figure.trace) : Counts{}};
  };
  return lay_out_panels(runs, band, look, [&](std::size_t i) { return i == 0 ? side(a, b) : side(b, a); });
}

std::string compared_caption(Takes& takes, StepNumber step) {
  const StepPair pair = pair_at(takes, step);
  const Figure a = takes.figure(pair.a), b = takes.beside()->figure(pair.b);
  const Wording& wording = a.trace->wording;
  return wording.say("figure.compared_caption", arg("title", joined(wording, a.trace->title, b.trace->title)),
                     arg("a", name_beside(*a.trace, *b.trace)), arg("b", name_beside(*b.trace, *a.trace)),
                     arg("steps", steps_text(*a.trace, {&step, 1})),
                     arg("sentence", joined(wording, a.sentence, b.sentence)),
                     arg("input", a.trace->subtitle));
}

}  // namespace gradus::cli
