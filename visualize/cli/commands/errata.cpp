#include "cli/commands/errata.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>

#include "cairo/cairo_output.hpp"
#include "cli/command_line/errors.hpp"
#include "cli/command_line/inputs.hpp"
#include "cli/files/shipped.hpp"
#include "core/refusal.hpp"
#include "figure/alignment.hpp"
#include "figure/figure.hpp"
#include "request/written_json.hpp"
#include "stories/pipeline/textbook_chain/readings.hpp"
#include "stories/topic.hpp"
#include "text/text_output.hpp"
#include "theme/theme.hpp"

namespace gradus {

std::string_view exhibit_text(std::string_view path);  // embedded by the build

namespace cli {
namespace {

/// A method on the exhibit's input.
struct Side {
  Arguments arguments;
  Trace trace;
  std::string refusal{};  ///< why it does not take this input, as the command says it; empty: it does
};

/// A file of examples, whatever lies in the current folder.
FoundFile as_shipped(const std::string& name, const std::string&) { return shipped_example(name); }

Side side_of(const TopicEntry& topic, std::map<std::string, std::string> given, const std::string& method) {
  given["method"] = method;
  Side side{read_inputs(topic, given, as_shipped).arguments, {}};
  try {
    side.trace = topic.run(side.arguments, {});
  } catch (const ArgumentError& error) {
    side.refusal = complaint_of(error);
  }
  return side;
}

/// Real numbers on the page have so many digits, unless it takes more to tell two of them apart.
constexpr int few_digits = 4, all_digits = 17;

/// A number that nobody reads digit by digit.
std::string short_text(const Value& value, int digits = few_digits) {
  if (const double* real = std::get_if<double>(&value)) return fmt::format("{:.{}g}", *real, digits);
  const auto* whole = std::get_if<std::int64_t>(&value);
  constexpr std::int64_t long_number = 1'000'000'000;
  const bool is_long = whole && (*whole >= long_number || *whole <= -long_number);
  return is_long ? fmt::format("about {:.1e}", static_cast<double>(*whole)) : value_text(value);
}

/// "3 for -1": two different values, with no more digits than that takes.
std::string one_for_another(const Value& wrong, const Value& right) {
  int digits = few_digits;
  while (digits < all_digits && short_text(wrong, digits) == short_text(right, digits)) ++digits;
  return fmt::format("{} for {}", short_text(wrong, digits), short_text(right, digits));
}

/// A field's name as words: "peak_calls" is "peak calls".
std::string words_of(std::string name) {
  std::ranges::replace(name, '_', ' ');
  return name;
}

/// What the first list's fields say otherwise than those of the same name in the second: "p = 3 for -1".
std::string differences(const std::vector<Field>& wrong, const std::vector<Field>& right) {
  std::vector<std::string> found;
  for (const Field& field : wrong) {
    const auto other = std::ranges::find(right, field.name, &Field::name);
    if (other == right.end() || other->value == field.value) continue;
    found.push_back(fmt::format("{} = {}", words_of(field.name), one_for_another(field.value, other->value)));
  }
  return fmt::format("{}", fmt::join(found, ", "));
}

/// The steps at which the runs are shown: where they part, else their last.
StepPair shown_pair(const Trace& wrong, const Trace& right, const Alignment& alignment) {
  if (alignment.parting) return alignment.pairs[*alignment.parting];
  return {wrong.steps.back().number, right.steps.back().number};
}

std::string parting_of(const Alignment& alignment, StepPair shown) {
  if (!alignment.parting) return "Every step tells the same; the results are shown.";
  if (shown.a == shown.b) return fmt::format("The runs part at step {}.", text_of(shown.a));
  return fmt::format("The runs part at step {} of the wrong one, {} of the right one.", text_of(shown.a),
                     text_of(shown.b));
}

/// The lines of the wrong form round the one to blame, which the entry names: where runs part is where the
/// fault is seen, not where it is.
std::vector<ExhibitLine> culprit_of(const Trace& trace, const std::string& id, const std::string& named) {
  constexpr std::size_t around = 3;
  const std::vector<SourceLine> listing = shown_listing(trace);
  const auto is_named = [&](const SourceLine& line) {
    return line.change != Change::struck && line.text.find(named) != std::string::npos;
  };
  if (named.empty() || std::ranges::count_if(listing, is_named) != 1)
    throw WorkError(fmt::format("{}: the culprit '{}' isn't one line of {}", id, named, trace.method));
  const auto at = static_cast<std::size_t>(std::ranges::find_if(listing, is_named) - listing.begin());
  std::size_t first = at - std::min(at, around), last = std::min(at + around, listing.size());
  // A change is shown whole
  while (first > 0 && listing[first].change != Change::none && listing[first - 1].change != Change::none)
    --first;
  while (last < listing.size() && listing[last - 1].change != Change::none &&
         listing[last].change != Change::none)
    ++last;
  std::vector<ExhibitLine> lines;
  for (std::size_t i = first; i < last; ++i) lines.push_back({listing[i].text, i == at, listing[i].change});
  return lines;
}

/// The fields that only the first list has: "peak calls = 64".
std::string surplus(const std::vector<Field>& wrong, const std::vector<Field>& right) {
  std::vector<std::string> found;
  for (const Field& field : wrong) {
    if (std::ranges::find(right, field.name, &Field::name) != right.end()) continue;
    found.push_back(fmt::format("{} = {}", words_of(field.name), short_text(field.value)));
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

/// The drawing alone, after a step.
Sheet drawing_of(const Trace& trace, StepNumber step) {
  Playhead playhead(trace);
  Look look;
  look.width = 480;
  look.height = 360;
  look.slots = {Slot::drawing};
  return lay_out(figure_of(trace, playhead, step), look);
}

std::string picture_of(const Trace& trace, StepNumber step, const Finish& finish) {
  return svg_of(drawing_of(trace, step), finish, {});
}

/// The last drawing without its words: a label that stands elsewhere is no difference.
Image wordless_drawing(const Trace& trace, const Finish& finish) {
  Sheet sheet = drawing_of(trace, trace.steps.back().number);
  std::erase_if(sheet.shapes,
                [](const Shape& shape) { return std::holds_alternative<TextShape>(shape.what); });
  return image_of(sheet, finish);
}

std::string in_pixels(const Trace& wrong, const Trace& right, const Finish& finish) {
  if (!wrong.pixels.empty() && !right.pixels.empty()) {
    const auto a = pixel_set(wrong), b = pixel_set(right);
    return fmt::format("Pixels: {}, of which {} wrong; {} of the right ones missing.", a.size(),
                       missing(a, b), missing(b, a));
  }
  const Image a = wordless_drawing(wrong, finish), b = wordless_drawing(right, finish);
  std::int64_t different = 0;
  for (int y = 0; y < std::min(a.height(), b.height()); ++y) {
    const auto p = a.row(y), q = b.row(y);
    for (std::size_t x = 0; x < std::min(p.size(), q.size()); ++x) different += p[x] != q[x];
  }
  const double share = 100.0 * static_cast<double>(different) / (1.0 * a.width() * a.height());
  return fmt::format("The results' marks differ in {} pixels, {:.1f} % of the drawing.", different, share);
}

/// What is drawn where nothing may be.
std::string in_vain(const Trace& wrong) {
  return wrong.pixels.empty() ? "" : fmt::format("Pixels: {}, all of them wrong.", pixel_set(wrong).size());
}

/// A text of an entry; empty where this key is missing.
std::string text_in(const JsonNode& entry, std::string_view key) {
  const JsonMember* member = entry.member(key);
  return member ? member->value.text : "";
}

Exhibit exhibit_of(const JsonNode& entry) {
  const auto text = [&](std::string_view key) { return text_in(entry, key); };
  const TopicEntry& topic = *find_entry(text("topic"));
  std::map<std::string, std::string> given;
  for (const JsonMember& input : entry.member("input")->value.members) given[input.key] = input.value.text;
  const std::string right_name = text("right").empty() ? topic.default_method : text("right");
  const Side wrong = side_of(topic, given, text("wrong")), right = side_of(topic, given, right_name);
  if (!wrong.refusal.empty()) throw WorkError(fmt::format("{}: {}", text("id"), wrong.refusal));
  const Finish finish(*find_theme("light"));
  const auto shown_side = [&](const Side& side, const std::string& name, StepNumber step) {
    const auto method = std::ranges::find(topic.methods, name, &Method::name);
    return ExhibitSide{name, method->title, picture_of(side.trace, step, finish),
                       side.trace.steps[index_of(side.trace, step)].sentence,
                       fmt::format("{} --step {} -o {}.svg", command_of("figure", topic, side.arguments),
                                   text_of(step), &side == &wrong ? "wrong" : "right")};
  };
  Exhibit exhibit;
  exhibit.id = text("id");
  exhibit.title = fmt::format("{}, {}", topic.title, wrong.trace.subtitle);
  if (!right.refusal.empty()) {
    const StepNumber last = wrong.trace.steps.back().number;
    exhibit.wrong = shown_side(wrong, text("wrong"), last);
    exhibit.right = {right_name, std::ranges::find(topic.methods, right_name, &Method::name)->title, "", "",
                     command_of("figure", topic, right.arguments) + " -o right.svg"};
    exhibit.source = culprit_of(wrong.trace, exhibit.id, text("culprit"));
    exhibit.refusal = right.refusal;
    exhibit.parting = "The right one refuses this input by name, before its first step.";
    exhibit.difference = in_vain(wrong.trace);
    return exhibit;
  }
  const Alignment alignment = align(wrong.trace, right.trace);
  const StepPair pair = shown_pair(wrong.trace, right.trace, alignment);
  exhibit.wrong = shown_side(wrong, text("wrong"), pair.a);
  exhibit.right = shown_side(right, right_name, pair.b);
  if (exhibit.wrong.picture == exhibit.right.picture) {  // what has gone wrong is not seen yet
    exhibit.wrong.picture = picture_of(wrong.trace, wrong.trace.steps.back().number, finish);
    exhibit.right.picture = picture_of(right.trace, right.trace.steps.back().number, finish);
  }
  exhibit.source = culprit_of(wrong.trace, exhibit.id, text("culprit"));
  exhibit.parting = parting_of(alignment, pair);
  exhibit.outcome = outcome_of(wrong.trace, right.trace);
  exhibit.difference = in_pixels(wrong.trace, right.trace, finish);
  return exhibit;
}

/// Blanks at the ends of lines, which matter here, as the sign for a blank.
std::string with_visible_blanks(std::string text) {
  for (std::size_t at; (at = text.find(" \n")) != std::string::npos;) text.replace(at, 1, "␣");
  return text;
}

/// What the project's reader makes of it, or why it refuses.
std::string right_reading(const Readers& readers, const ReadingInput& input) {
  try {
    return readers.right(input);
  } catch (const InputError& error) {
    return fmt::format("refused: {}", error.what());
  }
}

Reading reading_of(const JsonNode& entry) {
  const Readers& readers = *find_readers(text_in(entry, "reader"));
  Reading reading{.id = text_in(entry, "id"),
                  .reader = std::string(readers.name),
                  .title = text_in(entry, "title"),
                  .frame = text_in(entry, "before"),
                  .wrong_head = "the notes' reader",
                  .right_head = "Gradus",
                  .rows = {}};
  const std::string library = text_in(entry, "library");
  const std::string file = text_in(entry, "before");
  if (!library.empty()) reading.frame = "# model.obj\n" + file + "\n# model.mtl\n" + library;
  for (const JsonNode& input : entry.member("inputs")->value.elements) {
    const ReadingInput given{file + input.text, library};
    reading.rows.push_back(
        {with_visible_blanks(input.text), readers.wrong(given), right_reading(readers, given)});
  }
  return reading;
}

JsonNode listed() { return read_json(exhibit_text("errata.json"), "examples/errata.json"); }

}  // namespace

std::vector<Exhibit> run_exhibits() {
  std::vector<Exhibit> exhibits;
  for (const JsonNode& entry : listed().elements) {
    if (entry.member("topic")) exhibits.push_back(exhibit_of(entry));
  }
  return exhibits;
}

std::vector<Reading> run_readings() {
  std::vector<Reading> readings;
  for (const JsonNode& entry : listed().elements) {
    if (entry.member("reader")) readings.push_back(reading_of(entry));
  }
  return readings;
}

std::string errata_gallery() { return errata_page(wrong_and_fragile(), run_exhibits(), run_readings()); }

}  // namespace cli
}  // namespace gradus
