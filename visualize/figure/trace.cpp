#include "figure/trace.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "core/contract.hpp"
#include "figure/sheet.hpp"

namespace gradus {
namespace {

auto position(const Trace& trace, StepNumber number) {
  return std::ranges::lower_bound(trace.steps, number, {}, &TraceStep::number);
}

}  // namespace

std::vector<SourceLine> shown_listing(const Trace& trace) {
  if (trace.struck.empty()) return trace.listing;
  std::vector<SourceLine> lines;
  std::ranges::merge(trace.listing, trace.struck, std::back_inserter(lines), {}, &SourceLine::number,
                     &SourceLine::number);
  return lines;
}

std::optional<int> color_of_quantity(const Trace& trace, std::string_view symbol) {
  const auto found = std::ranges::find(trace.quantities, symbol);
  const auto number = found - trace.quantities.begin();
  if (symbol.empty() || found == trace.quantities.end() || number >= quantity_colors) return std::nullopt;
  return static_cast<int>(number);
}

std::optional<int> color_of_quantity(const Trace& trace, const Column& column) {
  return color_of_quantity(trace, column.quantity.empty() ? column.id : column.quantity);
}

std::string text_of(StepNumber number) {
  return number.fine == 0 ? fmt::format("{}", number.step) : fmt::format("{}.{}", number.step, number.fine);
}

bool Trace::whole() const {
  return !steps.empty() && steps.front().number == StepNumber{} && steps.back().number.step == last;
}

bool has_step(const Trace& trace, StepNumber number) {
  const auto found = position(trace, number);
  return found != trace.steps.end() && found->number == number;
}

std::size_t index_of(const Trace& trace, StepNumber number) {
  expects(has_step(trace, number), "{} has no recorded step {}", trace.topic, text_of(number));
  return static_cast<std::size_t>(position(trace, number) - trace.steps.begin());
}

Playhead::Playhead(const Trace& trace) : trace_(trace), position_(0), canvas_(trace.before) {
  // A keyframe whenever as much has changed as a copy costs: memory stays linear, and so does a jump
  Canvas canvas = trace.before;
  std::size_t changed = 0;
  for (std::size_t i = 0; i < trace.steps.size(); ++i) {
    canvas.apply(trace.steps[i].delta);
    changed += trace.steps[i].delta.size();
    if (changed < std::max<std::size_t>(canvas.size(), 256)) continue;
    keyframes_.emplace_back(i + 1, canvas);
    changed = 0;
  }
}

const Canvas& Playhead::at(std::size_t index) {
  expects(index < trace_.steps.size(), "the trace has {} steps, not one at {}", trace_.steps.size(), index);
  const std::size_t wanted = index + 1;
  const auto after = std::ranges::upper_bound(keyframes_, wanted, {}, &std::pair<std::size_t, Canvas>::first);
  const std::size_t nearest = after == keyframes_.begin() ? 0 : std::prev(after)->first;
  if (wanted < position_ || nearest > position_) {
    canvas_ = nearest == 0 ? trace_.before : std::prev(after)->second;
    position_ = nearest;
  }
  for (; position_ < wanted; ++position_) canvas_.apply(trace_.steps[position_].delta);
  return canvas_;
}

}  // namespace gradus
