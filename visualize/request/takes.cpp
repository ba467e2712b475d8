#include "request/takes.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "figure/which_steps.hpp"
#include "request/names.hpp"
#include "stories/point_text.hpp"

namespace gradus {
namespace {

/// Far steps are recorded in blocks that begin at multiples of this, with some steps before for the table.
constexpr std::int64_t block = 4096;
constexpr std::int64_t lead_in = 64;

std::optional<std::int64_t> natural(std::string_view text) {
  constexpr std::int64_t most = 1'000'000'000'000'000;  // no run is longer, and sums of these don't overflow
  text = trimmed(text);
  if (text.empty() || text.find_first_not_of("0123456789") != std::string_view::npos) return std::nullopt;
  const auto value = whole_number(text);
  return value && *value <= most ? value : std::nullopt;
}

std::optional<StepNumber> step_in(std::string_view text) {
  const std::size_t dot = text.find('.');
  const auto step = natural(text.substr(0, dot));
  if (!step) return std::nullopt;
  if (dot == std::string_view::npos) return StepNumber{*step, 0};
  const auto fine = natural(text.substr(dot + 1));
  if (!fine || *fine < 1 || *fine > INT32_MAX) return std::nullopt;
  return StepNumber{*step, static_cast<int>(*fine)};
}

/// "9", "3-9", "0-100/5"; a range can't begin or end between steps.
std::optional<StepRange> range_in(std::string_view text) {
  const std::size_t hyphen = text.find('-');
  if (hyphen == std::string_view::npos) {
    const auto step = step_in(text);
    return step ? std::optional(StepRange{*step, *step}) : std::nullopt;
  }
  const std::size_t slash = text.find('/', hyphen);
  const auto first = natural(text.substr(0, hyphen)),
             last = natural(text.substr(hyphen + 1, slash - hyphen - 1));
  const auto stride = slash == std::string_view::npos ? 1 : natural(text.substr(slash + 1));
  if (!first || !last || !stride || *first > *last || *stride < 1) return std::nullopt;
  return StepRange{{*first, 0}, {*last, 0}, *stride};
}

std::int64_t count_in(const StepRange& range) {
  return (range.last.step - range.first.step) / range.stride + 1;
}

}  // namespace

StepNumber read_step(std::string_view text, std::string_view flag) {
  if (folded(trimmed(text)) == "last") return last_step;
  const auto step = step_in(trimmed(text));
  if (!step) {
    refuse_usage(fmt::format("{}: expected a step like 4 or 4.1, or last, found {}", flag, shown(text)));
  }
  return *step;
}

bool StepRange::holds(StepNumber number) const {
  if (first.fine != 0) return number == first;
  return first.step <= number.step && number.step <= last.step && (number.step - first.step) % stride == 0;
}

std::vector<StepRange> read_steps(std::string_view text, std::string_view flag) {
  std::vector<StepRange> ranges;
  for (std::size_t at = 0; at <= text.size();) {
    const std::size_t end = std::min(text.find(',', at), text.size());
    const auto range = range_in(trimmed(text.substr(at, end - at)));
    if (!range)
      refuse_usage(fmt::format("{}: expected steps like 3-9 or 1,4,9-12, found {}", flag, shown(text)));
    ranges.push_back(*range);
    at = end + 1;
  }
  return ranges;
}

std::string text_of(const std::vector<StepRange>& ranges) {
  std::string text;
  for (const StepRange& range : ranges) {
    text += (text.empty() ? "" : ",") + text_of(range.first);
    if (range.first != range.last) text += "-" + text_of(range.last);
    if (range.stride != 1) text += fmt::format("/{}", range.stride);
  }
  return text;
}

std::vector<StepNumber> numbers_in(const std::vector<StepRange>& ranges) {
  std::vector<StepNumber> numbers;
  for (const StepRange& range : ranges) {
    for (std::int64_t i = 0; i < count_in(range); ++i) {
      numbers.push_back({range.first.step + i * range.stride, range.first.fine});
    }
  }
  return numbers;
}

std::int64_t count_in(const std::vector<StepRange>& ranges) {
  std::int64_t count = 0;
  for (const StepRange& range : ranges) count = std::min(count + count_in(range), INT64_MAX / 2);
  return count;
}

std::string choose_step(StepChoice& choice, std::string_view text) {
  choice = {.step = read_step(text)};
  return *choice.step == last_step ? "last" : text_of(*choice.step);
}

std::string choose_steps(StepChoice& choice, std::string_view text) {
  const bool milestones = folded(trimmed(text)) == "auto";
  choice = {.steps = milestones ? std::vector<StepRange>{} : read_steps(text), .milestones = milestones};
  return milestones ? "auto" : text_of(choice.steps);
}

Takes::Takes(const TopicEntry& topic, const Arguments& arguments, Wording wording, ListingForm listing,
             const OtherSide* beside)
    : Takes(topic, arguments, std::move(wording), listing, beside, nullptr) {}

Takes::Takes(const TopicEntry& topic, const Arguments& arguments, Wording wording, ListingForm listing,
             const OtherSide* beside, const Trace* given)
    : topic_(topic),
      arguments_(arguments),
      wording_(std::move(wording)),
      listing_(listing),
      given_(given),
      opening_(std::make_unique<Trace>(record(0))),
      current_(nullptr) {
  if (!beside) return;
  const Trace* other = beside->given ? &beside->given->trace : nullptr;
  beside_.reset(new Takes(*beside->topic, beside->arguments, wording_, listing_, nullptr, other));
  alignment_ = other ? beside->given->alignment : align(*opening_, beside_->opening());
}

Trace Takes::record(std::int64_t first) const {
  if (given_) return *given_;
  Trace trace = topic_.run(arguments_, {.first = std::max<std::int64_t>(first, 0), .wording = wording_});
  if (listing_ == ListingForm::pseudo) write_pseudocode(trace);
  return trace;
}

void Takes::check(StepNumber number, std::string_view flag, std::string_view text) const {
  if (number.step < 0 || number.step > last()) {
    refuse_usage(fmt::format("{} {}: {} has steps 0..{} for this input", flag, text, topic_.name, last()));
  }
  if (number.fine == 0 || has_step(*opening_, number)) return;
  const Trace around = record(number.step);
  if (has_step(around, number)) return;
  const auto events = std::ranges::count_if(around.steps, [number](const TraceStep& step) {
    return step.number.step == number.step && step.number.fine > 0;
  });
  const std::string there =
      events == 0 ? "no finer events" : fmt::format("{0}.1..{0}.{1}", number.step, events);
  refuse_usage(fmt::format("{} {}: {} has {} after step {} for this input", flag, text, topic_.name, there,
                           number.step));
}

StepNumber Takes::named(StepNumber step) const {
  if (step == last_step) return {last(), 0};
  check(step, "--step", text_of(step));
  return step;
}

void Takes::take(std::int64_t first) {
  playhead_.reset();
  other_ = std::make_unique<Trace>(record(first));
  current_ = other_.get();
}

void Takes::record_around(StepNumber number) {
  if (has_step(*opening_, number)) {
    if (current_ == opening_.get()) return;
    current_ = opening_.get();
  } else {
    // Steps from the block's start on are kept, unless finer events, or what they change, fill the recording
    // before the wanted step comes
    const std::int64_t start = number.step / block * block - lead_in;
    const bool same_block = other_ && !other_->steps.empty() && has_step(*other_, number) &&
                            current_ == other_.get() &&
                            other_->steps.front().number.step == std::max<std::int64_t>(start, 0);
    if (same_block) return;
    take(start);
    if (!has_step(*current_, number)) take(number.step - lead_in);
    if (!has_step(*current_, number)) take(number.step);
  }
  playhead_ = std::make_unique<Playhead>(*current_);
}

Figure Takes::figure(StepNumber number) {
  record_around(number);
  return figure_of(*current_, *playhead_, number);
}

Trace Takes::part(const std::vector<StepRange>& ranges) const {
  std::int64_t first = INT64_MAX, last = 0;
  for (const StepRange& range : ranges) {
    first = std::min(first, range.first.step);
    last = std::max(last, range.last.step);
  }
  Trace trace = first <= 0 ? *opening_ : record(first);
  const auto held = [&ranges](const TraceStep& step) {
    return std::ranges::any_of(ranges, [&step](const StepRange& range) { return range.holds(step.number); });
  };
  // A test that was read in a row left out completes no other row
  bool has_row = false;
  for (TraceStep& step : trace.steps) {
    if (!has_row) step.read.clear();
    if (!step.row.empty()) has_row = held(step);
  }
  std::erase_if(trace.steps, [&held](const TraceStep& step) { return !held(step); });
  return trace;
}

std::vector<StepRange> chosen_ranges(const StepChoice& choice, const Takes& takes) {
  std::vector<StepRange> ranges = choice.steps;
  if (choice.step) {
    const StepNumber step = takes.named(*choice.step);
    ranges = {{step, step}};
  }
  if (choice.milestones) {
    for (const StepNumber step : milestones_of(takes.opening())) ranges.push_back({step, step});
  }
  for (const StepRange& range : ranges) {
    for (const StepNumber end : {range.first, range.last}) takes.check(end, "--steps", text_of(choice.steps));
  }
  return ranges;
}

Trace chosen_part(const StepChoice& choice, const Takes& takes) {
  const std::vector<StepRange> ranges = chosen_ranges(choice, takes);
  return ranges.empty() ? takes.opening() : takes.part(ranges);
}

std::string cut_remark(const Trace& trace) {
  if (trace.whole()) return "";
  const auto recorded =
      std::ranges::count_if(trace.steps, [](const TraceStep& s) { return s.number.fine == 0; });
  return fmt::format("recorded {} of {} steps; --steps A-B takes a range", recorded, trace.last + 1);
}

}  // namespace gradus
