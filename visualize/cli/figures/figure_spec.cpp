#include "cli/figures/figure_spec.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <numeric>

#include "cli/command_line/errors.hpp"
#include "cli/command_line/inputs.hpp"
#include "cli/figures/figure_size.hpp"
#include "cli/files/notation_file.hpp"
#include "figure/text/metrics.hpp"
#include "request/names.hpp"
#include "request/words.hpp"
#include "stories/point_text.hpp"

namespace gradus::cli {
namespace {

using Texts = std::vector<std::string>;

/// The one of these names that is meant.
std::size_t chosen(std::string_view flag, std::string_view text, const Texts& names) {
  return choose_value(flag, text, names);
}

// --- Which steps -------------------------------------------------------------------------------------------

/// One step per sheet after all.
void leave_panels(FigureSpec& spec) {
  spec.panels.reset();
  spec.said.erase("panels");
}

std::string read_step_flag(FigureSpec& spec, const std::string& text) {
  std::string canonical = choose_step(spec, text);
  spec.said.erase("steps");
  leave_panels(spec);
  return canonical;
}

std::string read_steps_flag(FigureSpec& spec, const std::string& text) {
  std::string canonical = choose_steps(spec, text);
  spec.said.erase("step");
  leave_panels(spec);
  return canonical;
}

std::string read_panels(FigureSpec& spec, const std::string& text) {
  PanelChoice choice;
  choice.phases = folded(trimmed(text)) == "phases";
  std::vector<StepRange> ranges;
  if (!choice.phases) {
    const bool has_number = text.find_first_of("0123456789") != std::string::npos;
    if (has_number) ranges = read_steps(text, "--panels");
    const std::int64_t count = count_in(ranges);
    if (!has_number || count < std::int64_t{PanelChoice::least} || count > std::int64_t{PanelChoice::most}) {
      refuse_flag("panels",
                  fmt::format("phases, or {} to {} steps like 1,4,9", PanelChoice::least, PanelChoice::most),
                  shown(text));
    }
    choice.steps = numbers_in(ranges);
  }
  static_cast<StepChoice&>(spec) = {};
  spec.compare.reset();
  for (const char* flag : {"step", "steps", "compare", "trace"}) spec.said.erase(flag);
  spec.panels = choice;
  return choice.phases ? "phases" : text_of(ranges);
}

std::string read_compare(FigureSpec& spec, const std::string& text) {
  if (!spec.topic) return "";
  leave_panels(spec);
  spec.said.erase("trace");
  spec.compare = other_side(*spec.topic, spec.arguments, text);
  return spec.compare->text;
}

/// What it names is read once all is known of how it is told: see set_beside.
std::string read_trace(FigureSpec& spec, const std::string& text) {
  leave_panels(spec);
  spec.compare.reset();
  spec.said.erase("compare");
  return text;
}

// --- What of it ------------------------------------------------------------------------------------------

std::string slots_text(const std::set<Slot>& slots) {
  if (slots == Look{}.slots) return "";
  Texts names;
  for (const Slot slot : slots) names.emplace_back(name_of(slot));
  return fmt::format("{}", fmt::join(names, ","));
}

std::string read_slots(FigureSpec& spec, const std::string& text) {
  Texts names;
  for (const Slot slot : all_slots) names.emplace_back(name_of(slot));
  std::set<Slot> slots;
  for (std::size_t at = 0; at <= text.size();) {
    const std::size_t end = std::min(text.find(',', at), text.size());
    slots.insert(all_slots[chosen("slots", text.substr(at, end - at), names)]);
    at = end + 1;
  }
  spec.look.slots = slots;
  return slots_text(slots);
}

std::string read_no_title(FigureSpec& spec, const std::string&) {
  spec.look.slots.erase(Slot::title);
  if (spec.look.slots.empty()) refuse_flag("no-title", "another slot beside the title", "'none'");
  spec.said["slots"] = slots_text(spec.look.slots);
  return "";
}

std::string read_crop(FigureSpec& spec, const std::string&) {
  spec.look.crop = true;
  return "yes";
}

std::string read_layout(FigureSpec& spec, const std::string& text) {
  spec.look.layout = static_cast<Layout>(chosen("layout", text, {"slide", "handout"}));
  return spec.look.layout == Layout::slide ? "" : "handout";
}

std::string read_listing(FigureSpec& spec, const std::string& text) {
  spec.listing = static_cast<ListingForm>(chosen("listing", text, {"source", "pseudo"}));
  return spec.listing == ListingForm::source ? "" : "pseudo";
}

std::string read_line_numbers(FigureSpec& spec, const std::string& text) {
  const Texts names{"listing", "source", "none"};
  spec.look.line_numbers = static_cast<LineNumbers>(chosen("line-numbers", text, names));
  return spec.look.line_numbers == LineNumbers::listing
             ? ""
             : names[static_cast<std::size_t>(spec.look.line_numbers)];
}

std::string read_y(FigureSpec& spec, const std::string& text) {
  const bool up = chosen("y", text, {"up", "down"}) == 0;
  spec.look.y_up = up;
  return up ? "up" : "down";
}

std::string read_view(FigureSpec& spec, const std::string& text) {
  const Parameter window{"view", ParameterType::window, "", "", ""};
  const Arguments::Entry read = read_argument(window, text);
  spec.look.view = std::get<Window>(read.value);
  return read.text;
}

// --- Its colours -----------------------------------------------------------------------------------------

std::string read_theme(FigureSpec& spec, const std::string& text) {
  Texts names;
  for (const Theme& theme : themes()) names.push_back(theme.name);
  spec.theme = &themes()[chosen("theme", text, names)];
  return spec.theme == &themes().front() ? "" : spec.theme->name;
}

std::string read_background(FigureSpec& spec, const std::string& text) {
  spec.transparent = folded(trimmed(text)) == "none";
  spec.ground.reset();
  if (spec.transparent) return "none";
  const Parameter parameter{"background", ParameterType::color, "", "", ""};
  const std::string color = canonical(parameter, text);
  spec.ground = Rgb{static_cast<std::uint32_t>(std::stoul(color.substr(1), nullptr, 16))};
  return color;
}

/// Texts and marks must stay legible on a ground of one's own.
void check_ground(const FigureSpec& spec) {
  if (!spec.ground) return;
  const auto low = low_contrast(with_paper(*spec.theme, *spec.ground));
  if (!low) return;
  throw UsageError(fmt::format(
      "--background: expected a ground on which the {} of theme {} keep {}:1, found '#{:06x}' with {:.1f}:1",
      low->what, spec.theme->name, low->least, spec.ground->hex, low->found));
}

/// A picture of this size takes a gigabyte, and H.264 knows no larger one.
void check_pixels(const FigureSpec& spec) {
  constexpr double most_pixels = 16'384;
  const double width = spec.look.width * spec.scale, height = spec.look.height * spec.scale;
  if (std::max(width, height) <= most_pixels) return;
  throw UsageError(fmt::format("--scale: expected at most {} pixels per side, found {:.0f} x {:.0f}",
                               most_pixels, width, height));
}

std::string read_svg_text(FigureSpec& spec, const std::string& text) {
  spec.svg_text = static_cast<SvgText>(chosen("svg-text", text, {"outlines", "text"}));
  return spec.svg_text == SvgText::outlines ? "" : "text";
}

// --- On which paper, as which film ------------------------------------------------------------------------

std::string read_handout(FigureSpec& spec, const std::string& text) {
  const std::string word = folded(trimmed(text));
  const std::size_t cross = word.find('x');
  const auto columns = whole_number(std::string_view(word).substr(0, cross));
  const auto rows =
      cross == std::string::npos ? std::nullopt : whole_number(std::string_view(word).substr(cross + 1));
  const auto fits = [](const auto& n, int most) { return n && 1 <= *n && *n <= most; };
  if (!fits(columns, PageGrid::most_columns) || !fits(rows, PageGrid::most_rows)) {
    refuse_flag("handout",
                fmt::format("columns and rows of a page like 2x3, at most {}x{}", PageGrid::most_columns,
                            PageGrid::most_rows),
                shown(text));
  }
  spec.handout = {static_cast<int>(*columns), static_cast<int>(*rows)};
  return fmt::format("{}x{}", *columns, *rows);
}

std::string read_paper(FigureSpec& spec, const std::string& text) {
  Texts names;
  for (const Paper& paper : papers()) names.emplace_back(paper.name);
  spec.paper = papers()[chosen("paper", text, names)];
  return spec.paper.name == papers().front().name ? "" : std::string(spec.paper.name);
}

/// Seconds of a film; `standard` is what nobody needs to say.
std::string read_seconds(std::string_view flag, double& seconds, double standard, double most,
                         const std::string& text) {
  const auto value = decimal(text, 0.04, most);
  if (!value) refuse_flag(flag, fmt::format("seconds from 0.04 to {}", most), shown(text));
  seconds = *value;
  return *value == standard ? "" : fmt::format("{}", *value);
}

std::string read_seconds_per_step(FigureSpec& spec, const std::string& text) {
  return read_seconds("seconds-per-step", spec.film.seconds_per_step, FilmOptions{}.seconds_per_step, 60,
                      text);
}

std::string read_hold_last(FigureSpec& spec, const std::string& text) {
  return read_seconds("hold-last", spec.film.hold_last, FilmOptions{}.hold_last, 600, text);
}

std::string read_transition(FigureSpec& spec, const std::string& text) {
  const auto seconds = folded(trimmed(text)) == "none" ? 0 : decimal(text, 0.04, 10);
  if (!seconds) refuse_flag("transition", "none, or seconds from 0.04 to 10", shown(text));
  spec.film.transition = seconds;
  return *seconds == 0 ? "none" : fmt::format("{}", *seconds);
}

std::string read_count(std::string_view flag, int& count, int least, int most, const std::string& text) {
  const auto value = whole_number(text);
  if (!value || *value < least || *value > most) {
    refuse_flag(flag, fmt::format("a whole number from {} to {}", least, most), shown(text));
  }
  const int standard = count;
  count = static_cast<int>(*value);
  return count == standard ? "" : fmt::format("{}", count);
}

std::string read_fps(FigureSpec& spec, const std::string& text) {
  spec.film.fps = FilmOptions{}.fps;
  return read_count("fps", spec.film.fps, 1, 60, text);
}

std::string read_loop(FigureSpec& spec, const std::string& text) {
  spec.film.loop = FilmOptions{}.loop;
  return read_count("loop", spec.film.loop, 0, 65'535, text);
}

// --- In whose words --------------------------------------------------------------------------------------

std::string read_title(FigureSpec& spec, const std::string& text) {
  spec.look.title = drawable("title", text, Face::bold);
  return spec.look.title;
}

std::string read_caption(FigureSpec& spec, const std::string& text) {
  spec.caption = drawable("caption", text, Face::sans);
  return spec.caption;
}

std::string read_language_flag(FigureSpec& spec, const std::string& text) {
  return read_language(spec.wording, text);
}

std::string read_numbers_flag(FigureSpec& spec, const std::string& text) {
  return read_numbers(spec.wording, text);
}

std::string read_notation_flag(FigureSpec& spec, const std::string& text) {
  spec.wording = spec.wording.with(read_notation(text));
  return spec.wording.notation().name;
}

// --- All of it -------------------------------------------------------------------------------------------

/// Takes one flag's value; returns what the canonical command says of it, nothing for the default.
struct FlagReader {
  const char* name;
  std::string (*read)(FigureSpec& spec, const std::string& text);
};
/// In the order in which the canonical command names them.
constexpr FlagReader readers[] = {
    {"step", read_step_flag},
    {"steps", read_steps_flag},
    {"panels", read_panels},
    {"compare", read_compare},
    {"trace", read_trace},
    {"slots", read_slots},
    {"no-title", read_no_title},
    {"theme", read_theme},
    {"size", read_size},
    {"layout", read_layout},
    {"listing", read_listing},
    {"line-numbers", read_line_numbers},
    {"crop", read_crop},
    {"view", read_view},
    {"y", read_y},
    {"background", read_background},
    {"scale", read_scale},
    {"svg-text", read_svg_text},
    {"language", read_language_flag},
    {"numbers", read_numbers_flag},
    {"notation", read_notation_flag},
    {"title", read_title},
    {"caption", read_caption},
    {"handout", read_handout},
    {"paper", read_paper},
    {"seconds-per-step", read_seconds_per_step},
    {"hold-last", read_hold_last},
    {"transition", read_transition},
    {"fps", read_fps},
    {"loop", read_loop},
};

bool is_switch(const std::string& name) { return name == "crop"; }

}  // namespace

void apply_flags(FigureSpec& spec, const Request& request) {
  constexpr std::pair<const char*, const char*> rivals[] = {{"step", "steps"},   {"panels", "step"},
                                                            {"panels", "steps"}, {"panels", "compare"},
                                                            {"panels", "trace"}, {"compare", "trace"}};
  for (const auto& [one, other] : rivals) {
    if (request.has(one) && request.has(other))
      throw UsageError(fmt::format("--{}: expected either this or --{}, found both", one, other));
  }
  for (const FlagReader& reader : readers) {
    const auto given = request.flags.find(reader.name);
    if (given == request.flags.end()) continue;
    const std::string canonical = reader.read(spec, given->second);
    spec.said.erase(reader.name);
    if (!canonical.empty()) spec.said[reader.name] = canonical;
  }
  check_ground(spec);
  check_pixels(spec);
  apply_labels(spec.wording, spec.topic ? spec.topic->name : "", request.labels);
}

FigureSpec read_spec(const Request& request, const Arguments& arguments) {
  FigureSpec spec;
  spec.topic = request.topic;
  spec.arguments = arguments;
  spec.theme = &themes().front();
  apply_flags(spec, request);
  return spec;
}

std::string command_of(const FigureSpec& spec) {
  std::string line = command_of("figure", *spec.topic, spec.arguments);
  for (const FlagReader& reader : readers) {
    const auto said = spec.said.find(reader.name);
    if (said == spec.said.end()) continue;
    line += " ";
    line += is_switch(reader.name) ? fmt::format("--{}", reader.name) : flag_with(reader.name, said->second);
  }
  for (const SymbolLabel& label : spec.wording.labels()) {
    line += " --label " + shell_quoted(fmt::format("{}={}", label.symbol, label.text));
  }
  return line;
}

FigureSpec at_step(FigureSpec spec, StepNumber step) {
  if (spec.panels) return spec;  // they are all on one sheet
  const std::string canonical = read_step_flag(spec, text_of(step));
  spec.said["step"] = canonical;
  return spec;
}

FigureSpec with_steps(FigureSpec spec, const std::vector<StepRange>& steps) {
  spec.said["steps"] = read_steps_flag(spec, text_of(steps));
  return spec;
}

Finish finish_of(const FigureSpec& spec) {
  Finish finish(*spec.theme);
  if (spec.ground) finish.theme = with_paper(finish.theme, *spec.ground);
  finish.transparent = spec.transparent;
  finish.scale = spec.scale;
  finish.svg_text = spec.svg_text;
  return finish;
}

}  // namespace gradus::cli
