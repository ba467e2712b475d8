#pragma once
// Moving pictures: GIF, MP4 and animated WebP. The program ffmpeg makes them from frames it gets through a
// pipe.

#include <cstddef>
#include <functional>
#include <optional>
#include <string>

#include "cli/film/film_file.hpp"
#include "core/image.hpp"
#include "figure/colophon.hpp"

namespace gradus::cli {

struct FilmOptions {
  double seconds_per_step = 1.5;  ///< how long a frame stays: 0.04 (MP4: 1 / fps) to 60
  double hold_last = 3;           ///< the same for the last one: 0.04 to 600
  int fps = 25;                   ///< MP4: frames a second, 1 to 60; the others hold each frame but once
  int loop = 0;                   ///< GIF, WebP: how often it plays, to 65535; 0: for ever
  /// How long marks move from one step to the next, in seconds to 10, 0: not at all; never longer than a
  /// third of a step. Unsaid: usual_transition in films of at most `most_moving` steps, else not at all.
  std::optional<double> transition;
};
inline constexpr double usual_transition = 0.3;
inline constexpr std::size_t most_moving = 100;
/// Pictures a second while marks move in GIF and WebP; MP4 has its fps.
inline constexpr int moving_fps = 20;

/// Throws UsageError naming the flag (--seconds-per-step, --hold-last, --fps, --loop, --background) when an
/// option is out of its range, or the format knows no transparency.
void check_film(FilmFormat format, const FilmOptions& options, bool transparent);

/// How many pictures stand between two steps of a film of so many.
std::size_t pictures_between(FilmFormat format, std::size_t steps, const FilmOptions& options);

/// How often film_bytes asks for a picture, for a film of so many steps.
std::size_t pictures_drawn(FilmFormat format, std::size_t steps, const FilmOptions& options);

/// A film of frame(0), frame(1), … frame(frames - 1), all of one size, drawn one at a time as ffmpeg takes
/// them; GIF asks for each twice, first to choose its 256 colours. The same frames give the same bytes.
///
/// `between(i, share)`, where there is one, are pictures on the way from frame i to the next, 0 < share < 1.
/// They take their time from the end of frame i, so that frame i + 1 begins when it would without them, and
/// GIF paints them in the frames' colours.
///
/// MP4: H.264, yuv420p; an odd side is made even by repeating its last pixels. WebP is exact; GIF has the
/// frames' most frequent colours exactly and is transparent where alpha is below one half. The file carries
/// the colophon, for `colophon_in`. What ffmpeg has written is counted: it may stop early and call it
/// success.
///
/// Throws WorkError when there is no ffmpeg, it fails, or frames are missing; what frame() throws passes
/// through. SIGPIPE must be ignored. Nothing is left in any folder, whenever the program is stopped.
std::string film_bytes(FilmFormat format, std::size_t frames, const std::function<Image(std::size_t)>& frame,
                       const FilmOptions& options, const Colophon& colophon,
                       const std::function<Image(std::size_t, double)>& between = {});

}  // namespace gradus::cli
