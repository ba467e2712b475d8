#include "cli/gallery/gallery_steps.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "cli/command_line/errors.hpp"

namespace gradus::cli {

namespace {

/// Every stride-th step, and the last: at most so many.
std::vector<StepRange> spaced_steps(std::int64_t last, std::int64_t most) {
  const std::int64_t stride = (last + most - 2) / (most - 1);
  if (stride <= 1) return {};
  const std::int64_t end = last / stride * stride;
  std::vector<StepRange> ranges{{{0, 0}, {end, 0}, stride}};
  if (end != last) ranges.push_back({{last, 0}, {last, 0}});
  return ranges;
}

/// The steps that the lecture chose, each of which must exist.
std::vector<StepNumber> chosen_steps(const FigureSpec& spec, const Takes& takes) {
  // Before they are listed: a range may be as long as its numbers are large
  if (count_in(spec.steps) > most_pages) {
    throw UsageError(
        fmt::format("--steps: expected at most {} steps, found {}", most_pages, count_in(spec.steps)));
  }
  return shown_steps(spec, takes);
}

}  // namespace

bool is_cut(std::int64_t last) { return last + 1 > most_gallery_pages; }

std::int64_t last_page(const Takes& takes) { return takes.opening().steps.back().number.step; }

std::vector<StepNumber> picture_steps(const FigureSpec& spec, const Takes& takes) {
  if (!spec.chooses_steps()) return {shown_step(spec, takes)};
  std::vector<StepNumber> steps = chosen_steps(spec, takes);
  std::set<StepNumber> seen;
  std::erase_if(steps, [&seen](StepNumber step) { return !seen.insert(step).second; });
  return steps;
}

FigureSpec paged(const FigureSpec& spec, const Takes& takes, std::int64_t most) {
  const std::vector<StepRange> spaced =
      spec.chooses_steps() ? std::vector<StepRange>{} : spaced_steps(last_page(takes), most);
  return spaced.empty() ? spec : with_steps(spec, spaced);
}

std::vector<StepNumber> page_steps(const FigureSpec& pages, const Takes& takes) {
  return pages.chooses_steps() ? chosen_steps(pages, takes) : shown_steps(pages, takes);
}

FigureSpec told(const FigureSpec& spec, const Takes& takes, Format format) {
  if (format != Format::html || !spec.chooses_steps()) return spec;
  const std::vector<StepNumber> steps = chosen_steps(spec, takes);
  const auto [first, last] = std::ranges::minmax(steps);
  // One step is nothing to play: it is shown among all others
  const bool among_others = first == last && has_step(takes.opening(), last);
  return with_steps(spec, {among_others ? StepRange{{0, 0}, {last_page(takes), 0}}
                                        : StepRange{{first.step, 0}, {last.step, 0}}});
}

StepNumber thumbnail_step(const FigureSpec& spec, const Takes& takes) {
  const std::vector<StepNumber> steps = picture_steps(spec, takes);
  const StepNumber telling = telling_step(takes);
  return std::ranges::find(steps, telling) != steps.end() ? telling : steps.back();
}

}  // namespace gradus::cli
