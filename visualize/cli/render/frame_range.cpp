#include "cli/render/frame_range.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>

#include "cli/command_line/errors.hpp"
#include "core/shown.hpp"
#include "request/names.hpp"
#include "stories/point_text.hpp"

namespace gradus::cli {
namespace {

constexpr int most_parts = 1'000'000;

/// A whole number from least to most.
std::optional<int> count_in(std::string_view text, int least, int most) {
  const auto number = whole_number(text);
  if (!number || *number < least || *number > most) return std::nullopt;
  return static_cast<int>(*number);
}

/// What stands before and behind a sign; behind is nothing where there is none.
std::pair<std::string_view, std::optional<std::string_view>> cut(std::string_view text, char sign) {
  const std::size_t at = text.find(sign);
  if (at == std::string_view::npos) return {text, std::nullopt};
  return {text.substr(0, at), text.substr(at + 1)};
}

std::optional<FrameRange> range_in(std::string_view text) {
  const auto [ends, step_text] = cut(trimmed(text), '/');
  const auto [first_text, last_text] = cut(ends, '-');
  const auto first = count_in(first_text, 0, pipeline::most_frame);
  const auto last = last_text ? count_in(*last_text, 0, pipeline::most_frame) : first;
  const auto step = step_text ? count_in(*step_text, 1, pipeline::most_frame) : 1;
  if (!first || !last || !step || *last < *first) return std::nullopt;
  return FrameRange{*first, *last, *step};
}

}  // namespace

std::string text_of(const FrameRange& range) {
  if (range.is_one()) return fmt::format("{}", range.first);
  return fmt::format("{}-{}{}", range.first, range.last,
                     range.step == 1 ? "" : fmt::format("/{}", range.step));
}

std::optional<FrameRange> read_frames(const Flags& flags) {
  const std::string* text = given(flags, "frames");
  if (!text) return std::nullopt;
  const auto range = range_in(*text);
  if (!range) refuse_flag("frames", "frames like 0-124, 17 or 0-124/5", shown(*text));
  return range;
}

void check_frames(const FrameRange& range, const std::optional<pipeline::CameraPath>& path,
                  const std::string& scene) {
  if (!path) refuse_flag("frames", "a scene whose camera has a path", shown(scene) + " without one");
  if (range.first < path->first || path->last < range.last) {
    refuse_flag("frames", fmt::format("frames of the path, which has {} to {}", path->first, path->last),
                shown(text_of(range)));
  }
}

ArrayPart read_array(const Flags& flags) {
  const std::string* text = given(flags, "array");
  if (!text) return {};
  const auto [number_text, of_text] = cut(trimmed(*text), '/');
  const auto of = of_text ? count_in(*of_text, 1, most_parts) : std::nullopt;
  const auto number = count_in(number_text, 1, of.value_or(0));
  if (!number || !of) refuse_flag("array", "one of so many parts like 1/4, counted from 1", shown(*text));
  return {*number, *of};
}

std::vector<int> frames_of(const FrameRange& range, const ArrayPart& part) {
  std::vector<int> frames;
  const std::int64_t stride = std::int64_t{range.step} * part.of;
  for (std::int64_t frame = range.first + std::int64_t{range.step} * (part.number - 1); frame <= range.last;
       frame += stride)
    frames.push_back(static_cast<int>(frame));
  return frames;
}

std::string frame_name(std::string output, int frame, const pipeline::CameraPath& path) {
  const std::size_t digits = std::max<std::size_t>(fmt::formatted_size("{}", path.last), 3);
  const std::string number = fmt::format("{:0{}}", frame, digits);
  for (std::size_t at = output.find(frame_mark); at != std::string::npos; at = output.find(frame_mark, at))
    output.replace(at, frame_mark.size(), number);
  return output;
}

}  // namespace gradus::cli
