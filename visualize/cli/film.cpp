#include "cli/film.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "cairo/cairo_output.hpp"
#include "cairo/colophon_markup.hpp"
#include "cli/errors.hpp"
#include "cli/ffmpeg.hpp"

namespace gradus::cli {
namespace {

std::span<const std::uint8_t> bytes_of(const Image& image) {
  const auto cells = image.cells();
  return {reinterpret_cast<const std::uint8_t*>(cells.data()), cells.size_bytes()};
}

/// H.264 halves the resolution of colours: sides are even.
Image evened(Image image) {
  const int width = (image.width() + 1) / 2 * 2, height = (image.height() + 1) / 2 * 2;
  if (width == image.width() && height == image.height()) return image;
  Image even(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      even[{x, y}] = image[{std::min(x, image.width() - 1), std::min(y, image.height() - 1)}];
    }
  }
  return even;
}

bool is_opaque(const Image& image) {
  return std::ranges::all_of(image.cells(), [](const Rgba8& c) { return c.a == 255; });
}

std::vector<std::string> joined(std::initializer_list<std::vector<std::string>> parts) {
  std::vector<std::string> all;
  for (const auto& part : parts) all.insert(all.end(), part.begin(), part.end());
  return all;
}

/// The whole job, from drawing frames to the file's bytes.
class Film {
 public:
  Film(FilmFormat format, std::size_t frames, const std::function<Image(std::size_t)>& frame,
       const FilmOptions& options, const Colophon& colophon)
      : format_(format), count_(frames), frame_(frame), options_(options), colophon_(colophon) {}

  std::string bytes() {
    const Image first = drawn(0);
    width_ = first.width();
    height_ = first.height();
    transparent_ = !is_opaque(first);
    check_film(format_, options_, transparent_);
    Descriptor palette;
    if (format_ == FilmFormat::gif) palette = nameless_file(run(chosen_colors(), Descriptor()));
    std::string film = run(encoding(), palette);
    check_count(film);
    if (format_ == FilmFormat::mp4) return film;
    set_delays(format_, film, delays());
    return with_xmp(
        format_, std::move(film),
        fmt::format("<x:xmpmeta xmlns:x=\"adobe:ns:meta/\">{}</x:xmpmeta>", markup_of(colophon_)));
  }

 private:
  Image drawn(std::size_t i) const { return format_ == FilmFormat::mp4 ? evened(frame_(i)) : frame_(i); }

  /// Hands all frames to ffmpeg.
  std::string run(const std::vector<std::string>& words, const Descriptor& palette) {
    Ffmpeg ffmpeg(joined({input(), words, {std::string(Ffmpeg::output)}}), palette);
    held_.clear();
    Image before;
    for (std::size_t i = 0; i < count_; ++i) {
      Image now = drawn(i);
      if (now.width() != width_ || now.height() != height_) {
        throw WorkError(fmt::format("film: expected frames of {} x {}, found one of {} x {}", width_, height_,
                                    now.width(), now.height()));
      }
      // Encoders treat a frame without news each in its own way: it makes the one before last longer
      if (format_ != FilmFormat::mp4 && i > 0 && now == before) {
        ++held_.back();
        continue;
      }
      held_.push_back(1);
      if (!ffmpeg.take(bytes_of(now))) {
        ffmpeg.finish();  // which may know the reason
        throw WorkError(
            fmt::format("film: expected ffmpeg to take {} frames, found that it stopped early", count_));
      }
      before = std::move(now);
    }
    return ffmpeg.finish();
  }

  // --- What ffmpeg is told ---------------------------------------------------------------------------------

  std::vector<std::string> input() const {
    // GIF and WebP get their delays afterwards; here a frame lasts what both can say exactly
    const bool movie = format_ == FilmFormat::mp4;
    return {"-f",
            "rawvideo",
            "-pixel_format",
            "rgba",
            "-video_size",
            fmt::format("{}x{}", width_, height_),
            "-framerate",
            movie ? fmt::format("{}/{}", options_.fps, repeats()) : "10",
            "-i",
            std::string(Ffmpeg::input)};
  }

  static std::vector<std::string> chosen_colors() {
    return {"-vf", "palettegen=max_colors=256:reserve_transparent=1", "-pix_fmt", "rgba", "-f", "rawvideo"};
  }

  std::vector<std::string> encoding() const {
    const std::vector<std::string> same_bytes{"-map_metadata", "-1",        "-threads", "1",
                                              "-fflags",       "+bitexact", "-flags:v", "+bitexact"};
    switch (format_) {
      case FilmFormat::gif:
        // With transparent frames ffmpeg 5.1 cuts off what it should keep: there they are stored whole
        return joined({{"-f", "rawvideo", "-pixel_format", "rgba", "-video_size", "16x16", "-i",
                        std::string(Ffmpeg::palette), "-lavfi",
                        "[0:v][1:v]paletteuse=dither=none:diff_mode=rectangle:alpha_threshold=128"},
                       same_bytes,
                       {"-gifflags", transparent_ ? "0" : "+offsetting+transdiff", "-loop",
                        std::to_string(gif_loop()), "-f", "gif"}});
      case FilmFormat::webp:
        return joined({same_bytes,
                       {"-c:v", "libwebp_anim", "-lossless", "1", "-compression_level", "4", "-quality", "70",
                        "-pix_fmt", "bgra", "-loop", std::to_string(options_.loop), "-f", "webp"}});
      case FilmFormat::mp4:
        break;
    }
    return joined(
        {{"-vf", movie_filter(), "-c:v", "libx264", "-preset", "veryfast", "-crf", "17", "-colorspace",
          "bt709", "-color_primaries", "bt709", "-color_trc", "bt709", "-color_range", "tv"},
         same_bytes,
         {"-metadata", "title=" + colophon_.title, "-metadata", "comment=" + markup_of(colophon_),
          "-movflags", "+faststart", "-f", "mp4"}});
  }

  /// GIF counts repetitions after the first time, and -1 is none.
  int gif_loop() const { return options_.loop == 0 ? 0 : options_.loop == 1 ? -1 : options_.loop - 1; }

  /// Colours are converted once a step, then each frame is repeated for as long as it lasts, the last one
  /// longer or shorter.
  std::string movie_filter() const {
    std::string filter =
        fmt::format("scale=out_color_matrix=bt709:out_range=tv,format=yuv420p,fps={}", options_.fps);
    if (last_repeats() > repeats())
      filter += fmt::format(",tpad=stop={}:stop_mode=clone", last_repeats() - repeats());
    if (last_repeats() < repeats()) filter += fmt::format(",trim=end_frame={}", expected_frames());
    return filter;
  }

  // --- Time ------------------------------------------------------------------------------------------------

  std::size_t in_frames(double seconds) const {
    return static_cast<std::size_t>(std::max(1ll, std::llround(seconds * options_.fps)));
  }
  std::size_t repeats() const { return in_frames(options_.seconds_per_step); }
  std::size_t last_repeats() const { return in_frames(options_.hold_last); }

  std::size_t expected_frames() const {
    return format_ == FilmFormat::mp4 ? (count_ - 1) * repeats() + last_repeats() : held_.size();
  }

  std::vector<double> delays() const {
    std::vector<double> seconds;
    for (const std::size_t steps : held_)
      seconds.push_back(options_.seconds_per_step * static_cast<double>(steps));
    seconds.back() += options_.hold_last - options_.seconds_per_step;
    return seconds;
  }

  /// ffmpeg takes a pipe that ends early for the end of the film, and calls it success.
  void check_count(std::string_view film) const {
    const std::size_t found = frames_in(format_, film);
    if (found == expected_frames()) return;
    throw WorkError(fmt::format("film: expected {} frames in the finished {}, found {}: ffmpeg stopped early",
                                expected_frames(), name_of(format_), found));
  }

  FilmFormat format_;
  std::size_t count_;
  const std::function<Image(std::size_t)>& frame_;
  const FilmOptions& options_;
  const Colophon& colophon_;
  int width_ = 0, height_ = 0;
  bool transparent_ = false;
  std::vector<std::size_t> held_;  ///< of the frames sent: how many steps each stands for
};

/// A number in its range, or one line that says what was expected.
template <class Number>
void expect_between(std::string_view flag, Number least, Number most, Number found) {
  if (least <= found && found <= most) return;
  throw UsageError(fmt::format("--{}: expected {} to {}, found {}", flag, least, most, found));
}

}  // namespace

void check_film(FilmFormat format, const FilmOptions& options, bool transparent) {
  expect_between("seconds-per-step", 0.04, 60.0, options.seconds_per_step);
  expect_between("hold-last", 0.04, 600.0, options.hold_last);
  expect_between("fps", 1, 60, options.fps);
  expect_between("loop", 0, 65535, options.loop);
  if (format != FilmFormat::mp4) return;
  if (options.seconds_per_step * options.fps < 1) {
    throw UsageError(
        fmt::format("--seconds-per-step: expected at least one frame, 1/{} s at --fps {}, found {}",
                    options.fps, options.fps, options.seconds_per_step));
  }
  if (transparent) {
    throw UsageError(
        "--background: expected a ground for mp4, which has no transparency (gif, webp), found none");
  }
}

std::size_t frames_drawn(FilmFormat format, std::size_t frames) {
  // The first one more: it tells the size and whether there is transparency
  return 1 + (format == FilmFormat::gif ? 2 * frames : frames);
}

std::string film_bytes(FilmFormat format, std::size_t frames, const std::function<Image(std::size_t)>& frame,
                       const FilmOptions& options, const Colophon& colophon) {
  if (frames == 0) throw WorkError("film: expected at least one frame, found none");
  return Film(format, frames, frame, options, colophon).bytes();
}

}  // namespace gradus::cli
