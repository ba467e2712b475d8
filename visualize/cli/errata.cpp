#include "cli/errata.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>

#include "cairo/cairo_output.hpp"
#include "cli/errors.hpp"
#include "cli/inputs.hpp"
#include "cli/located_json.hpp"
#include "figure/figure.hpp"
#include "stories/topic.hpp"
#include "text/text_output.hpp"
#include "theme/theme.hpp"

namespace gradus {

std::string_view example_text(std::string_view path);  // embedded by the build

namespace cli {
namespace {

/// A method on the exhibit's input.
struct Side {
  Arguments arguments;
  Trace trace;
  std::string refusal{};  ///< why it does not take this input, as the command says it; empty: it does
};

Side side_of(const TopicEntry& topic, std::map<std::string, std::string> given, const std::string& method) {
  given["method"] = method;
  Side side{read_inputs(topic, given).arguments, {}};
  try {
    side.trace = topic.run(side.arguments, {});
  } catch (const ArgumentError& error) {
    side.refusal = complaint_of(error);
  }
  return side;
}

/// The trace's steps without the finer events.
std::vector<const TraceStep*> whole_steps(const Trace& trace) {
  std::vector<const TraceStep*> steps;
  for (const TraceStep& step : trace.steps) {
    if (step.number.fine == 0) steps.push_back(&step);
  }
  return steps;
}

/// What the first list's fields say otherwise than those of the same name in the second: "p = 3 for -1".
std::string differences(const std::vector<Field>& wrong, const std::vector<Field>& right) {
  std::vector<std::string> found;
  for (const Field& field : wrong) {
    const auto other = std::ranges::find(right, field.name, &Field::name);
    if (other == right.end() || other->value == field.value) continue;
    found.push_back(
        fmt::format("{} = {} for {}", field.name, value_text(field.value), value_text(other->value)));
  }
  return fmt::format("{}", fmt::join(found, ", "));
}

bool has_type(const std::vector<const TraceStep*>& steps, const std::string& type) {
  return std::ranges::any_of(steps, [&](const TraceStep* step) { return step->type == type; });
}

std::string parting_of(const Trace& wrong, const Trace& right) {
  const auto steps = whole_steps(wrong), others = whole_steps(right);
  for (std::size_t i = 0; i < std::min(steps.size(), others.size()); ++i) {
    const TraceStep &step = *steps[i], &other = *others[i];
    if (step.type != other.type) {
      const bool same_kind = has_type(steps, other.type) || has_type(others, step.type);
      if (same_kind) return fmt::format("First different step: {}, {} for {}.", i, step.type, other.type);
      return fmt::format("From step {} on each has its own: {}, {}.", i, step.type, other.type);
    }
    const std::string difference = differences(step.fields, other.fields);
    if (!difference.empty()) return fmt::format("First different step: {}, {}.", i, difference);
  }
  if (steps.size() == others.size()) return "Every step is the same.";
  return fmt::format("The same steps, but it ends after {}, not {}.", steps.size() - 1, others.size() - 1);
}

/// The fields that only the first list has: "peak_calls = 64".
std::string surplus(const std::vector<Field>& wrong, const std::vector<Field>& right) {
  std::vector<std::string> found;
  for (const Field& field : wrong) {
    if (std::ranges::find(right, field.name, &Field::name) != right.end()) continue;
    found.push_back(fmt::format("{} = {}", field.name, value_text(field.value)));
  }
  return fmt::format("{}", fmt::join(found, ", "));
}

std::string outcome_of(const Trace& wrong, const Trace& right) {
  const std::string difference = differences(wrong.result, right.result);
  if (!difference.empty()) return fmt::format("Result: {}.", difference);
  const std::string more = surplus(wrong.result, right.result);
  return more.empty() ? "" : fmt::format("The same result, but {}.", more);
}

std::set<std::pair<int, int>> pixel_set(const Trace& trace) {
  std::set<std::pair<int, int>> pixels;
  for (const ivec2 p : trace.pixels) pixels.emplace(p.x, p.y);
  return pixels;
}

/// How many of the first are not among the second.
template <class Set>
std::ptrdiff_t missing(const Set& first, const Set& second) {
  return std::ranges::count_if(first, [&](const auto& element) { return !second.contains(element); });
}

/// The drawing alone, after the last step.
Sheet drawing_of(const Trace& trace) {
  Playhead playhead(trace);
  Look look;
  look.width = 480;
  look.height = 360;
  look.slots = {Slot::drawing};
  return lay_out(figure_of(trace, playhead, trace.steps.back().number), look);
}

std::string in_pixels(const Trace& wrong, const Trace& right, const Finish& finish) {
  if (!wrong.pixels.empty() && !right.pixels.empty()) {
    const auto a = pixel_set(wrong), b = pixel_set(right);
    const auto twice = static_cast<std::ptrdiff_t>(wrong.pixels.size() - a.size());
    const std::string again = twice > 0 ? fmt::format("; {} set more than once", twice) : "";
    return fmt::format("Pixels: {}, of which {} wrong; {} of the right ones missing{}.", a.size(),
                       missing(a, b), missing(b, a), again);
  }
  const Image a = image_of(drawing_of(wrong), finish), b = image_of(drawing_of(right), finish);
  std::int64_t different = 0;
  for (int y = 0; y < std::min(a.height(), b.height()); ++y) {
    const auto p = a.row(y), q = b.row(y);
    for (std::size_t x = 0; x < std::min(p.size(), q.size()); ++x) different += p[x] != q[x];
  }
  return fmt::format("The last drawings, of {} x {} pixels, differ in {}.", a.width(), a.height(), different);
}

/// What is drawn where nothing may be.
std::string in_vain(const Trace& wrong) {
  return wrong.pixels.empty() ? "" : fmt::format("Pixels: {}, all of them wrong.", pixel_set(wrong).size());
}

Exhibit exhibit_of(const JsonNode& entry) {
  const auto text = [&](std::string_view key) -> std::string {
    const JsonMember* member = entry.member(key);
    return member ? member->value.text : "";
  };
  const TopicEntry& topic = *find_entry(text("topic"));
  std::map<std::string, std::string> given;
  for (const JsonMember& input : entry.member("input")->value.members) given[input.key] = input.value.text;
  const std::string right_name = text("right").empty() ? topic.default_method : text("right");
  const Side wrong = side_of(topic, given, text("wrong")), right = side_of(topic, given, right_name);
  if (!wrong.refusal.empty()) throw WorkError(fmt::format("{}: {}", text("id"), wrong.refusal));
  const bool refused = !right.refusal.empty();
  const Finish finish(*find_theme("light"));
  return {.id = text("id"),
          .title = fmt::format("{}, {}", topic.title, wrong.trace.subtitle),
          .wrong_name = text("wrong"),
          .right_name = right_name,
          .wrong_picture = svg_of(drawing_of(wrong.trace), finish, {}),
          .right_picture = refused ? "" : svg_of(drawing_of(right.trace), finish, {}),
          .wrong_command = command_of("figure", topic, wrong.arguments) + " -o wrong.svg",
          .right_command = command_of("figure", topic, right.arguments) + " -o right.svg",
          .refusal = right.refusal,
          .parting = refused ? "The right one refuses this input by name, before its first step."
                             : parting_of(wrong.trace, right.trace),
          .outcome = refused ? "" : outcome_of(wrong.trace, right.trace),
          .difference = refused ? in_vain(wrong.trace) : in_pixels(wrong.trace, right.trace, finish)};
}

}  // namespace

std::vector<Exhibit> run_exhibits() {
  std::vector<Exhibit> exhibits;
  const JsonNode list = read_json(example_text("errata.json"), "examples/errata.json");
  for (const JsonNode& entry : list.elements) exhibits.push_back(exhibit_of(entry));
  return exhibits;
}

std::string errata_gallery() { return errata_page(wrong_and_fragile(), run_exhibits()); }

}  // namespace cli
}  // namespace gradus
