#include "cli/figures/panel_sheets.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "cli/command_line/errors.hpp"
#include "figure/panels.hpp"
#include "figure/which_steps.hpp"
#include "request/names.hpp"

namespace gradus::cli {
namespace {

using fmt::arg;

/// What is said of the run as a whole.
Trace banner_of(const Trace& trace) {
  Trace banner;
  banner.topic = trace.topic;
  banner.title = trace.title;
  banner.subtitle = trace.subtitle;
  banner.method_title = trace.method_title;
  banner.faulty = trace.faulty;
  banner.wording = trace.wording;
  banner.legend = trace.legend;
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

/// "2 right border"; a phase that has its number already keeps it.
std::string numbered(const std::string& phase, const std::vector<std::string>& phases) {
  if (std::string_view("0123456789").find(phase.front()) != std::string_view::npos) return phase;
  return fmt::format("{} {}", std::ranges::find(phases, phase) - phases.begin() + 1, phase);
}

/// What the step says of its effect, else what is new in its row: "code_b = 0000".
std::string note_of(const Figure& figure) {
  const TraceStep& step = told_step(figure);
  if (!step.note.empty()) return step.note;
  if (figure.rows.empty() || step.row.empty()) return "";
  const Figure::TableRow& row = figure.rows.back();
  std::string note;
  for (std::size_t c = 0, told = 0; c < row.changed.size() && told < 2; ++c) {
    if (!row.changed[c]) continue;
    note += (told++ == 0 ? "" : ", ") + figure.trace->wording.say("figure.panel_value",
                                                                  arg("name", figure.trace->columns[c].name),
                                                                  arg("value", row.cells[c]));
  }
  return note;
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

/// Where it is seen that a step tells of something else than the other: on a grid at its cell, on paper at
/// the best of its marks that the other one has not.
std::optional<dvec2> place_of_difference(const Trace& trace, const TraceStep& step, const TraceStep& other) {
  if (trace.grid.axes) return dvec2(step.focus);
  std::optional<std::pair<int, dvec2>> best;
  for (const Mark& mark : step.delta.set) {
    const bool in_both = std::ranges::find(other.delta.set, mark) != other.delta.set.end();
    const auto place = in_both ? std::nullopt : place_of(mark);
    if (place && (!best || place->first > best->first)) best = place;
  }
  return best ? std::optional(best->second) : std::nullopt;
}

std::string joined(const Wording& wording, const std::string& a, const std::string& b) {
  return a == b ? a : wording.say("figure.compared", arg("a", a), arg("b", b));
}

Trace banner_of(const Trace& a, const Trace& b) {
  Trace banner = banner_of(a);
  banner.title = joined(a.wording, a.title, b.title);
  // Topics word the same input each in its own way
  if (a.topic == b.topic) banner.subtitle = joined(a.wording, a.subtitle, b.subtitle);
  const bool same_method = a.topic == b.topic && a.method_title == b.method_title;
  if (!same_method) banner.method_title.clear();
  banner.faulty = a.faulty.empty() ? b.faulty : a.faulty;
  return banner;
}

StepPair pair_at(const Takes& takes, StepNumber step) {
  StepPair pair = pair_with(takes.alignment(), {step.step, 0});
  pair.a = step;
  return pair;
}

bool is_parting(const Takes& takes, StepNumber step) { return parting_step(takes) == step; }

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
  const PanelBand band{banner_of(trace), panels_text(spec, takes), trace.goal};
  return lay_out_panels(runs, band, look, [&](std::size_t i) {
    const Figure figure = takes.figure(steps[i]);
    const std::string heading = by_phase
                                    ? numbered(figure.phase, phases)
                                    : trace.wording.say("figure.panel", arg("number", text_of(steps[i])));
    return SheetPanel{.figure = figure, .heading = heading, .note = note_of(figure), .ring = {}};
  });
}

std::optional<StepNumber> parting_step(const Takes& takes) {
  const Alignment& alignment = takes.alignment();
  if (!alignment.parting) return std::nullopt;
  return alignment.pairs[*alignment.parting].a;
}

Sheet compared_sheet(const FigureSpec&, Takes& takes, StepNumber step, const Look& look) {
  const StepPair pair = pair_at(takes, step);
  const Figure a = takes.figure(pair.a), b = takes.beside()->figure(pair.b);
  const Trace &of_a = *a.trace, &of_b = *b.trace;
  const std::array runs{&of_a, &of_b};
  const Wording& wording = of_a.wording;
  const bool parts = is_parting(takes, step);
  const PanelBand band{banner_of(of_a, of_b), joined(wording, a.position, b.position), ""};
  const auto side = [&](const Figure& figure, const Figure& other) {
    const std::string note = parts ? wording.say("figure.parting")
                                   : wording.say("figure.panel", arg("number", text_of(figure.number)));
    return SheetPanel{.figure = figure,
                      .heading = name_beside(*figure.trace, *other.trace),
                      .note = note,
                      .faulty = !figure.trace->faulty.empty(),
                      .parts = parts,
                      .ring = parts ? place_of_difference(*figure.trace, told_step(figure), told_step(other))
                                    : std::optional<dvec2>()};
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
