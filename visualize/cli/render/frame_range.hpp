#pragma once
// Which frames of a camera path are rendered, and what their files are called.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "cli/render/render_choices.hpp"
#include "scene/camera/camera_path.hpp"

namespace gradus::cli {

/// Where a frame's number goes in a file's name.
inline constexpr std::string_view frame_mark = "{frame}";

/// first, first + step, … up to last; 0 <= first <= last, step >= 1.
struct FrameRange {
  int first = 0, last = 0, step = 1;

  bool is_one() const { return first == last; }
};
/// "0-124", "17", "0-124/5".
std::string text_of(const FrameRange& range);

/// --frames; nothing where it is not given. Throws UsageError for what is no range.
std::optional<FrameRange> read_frames(const Flags& flags);
/// Throws UsageError for frames beyond the path, and where there is none. scene: what it is called.
void check_frames(const FrameRange& range, const std::optional<pipeline::CameraPath>& path,
                  const std::string& scene);

/// One of several parts of the frames, counted from 1.
struct ArrayPart {
  int number = 1, of = 1;
};
/// --array K/N; the whole where it is not given. Throws UsageError.
ArrayPart read_array(const Flags& flags);

/// Every N-th frame of the range, from its K-th on: all parts together have each frame once.
std::vector<int> frames_of(const FrameRange& range, const ArrayPart& part);

/// The name with the frame's number in it, with as many digits as the path's last frame has, at least three.
std::string frame_name(std::string output, int frame, const pipeline::CameraPath& path);

}  // namespace gradus::cli
