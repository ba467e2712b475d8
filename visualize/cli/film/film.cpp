#include "cli/film/film.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "cairo/cairo_output.hpp"
#include "cairo/colophon_markup.hpp"
#include "cli/command_line/errors.hpp"
#include "cli/film/ffmpeg.hpp"

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
       const FilmOptions& options, const Colophon& colophon,
       const std::function<Image(std::size_t, double)>& between)
      : format_(format),
        count_(frames),
        between_count_(between ? pictures_between(format, frames, options) : 0),
        frame_(frame),
        between_(between),
        options_(options),
        colophon_(colophon) {}

  std::string bytes() {
    const Image first = drawn(frame_(0));
    width_ = first.width();
    height_ = first.height();
    transparent_ = !is_opaque(first);
    check_film(format_, options_, transparent_);
    Descriptor palette;
    if (format_ == FilmFormat::gif) palette = nameless_file(run(chosen_colors(), Descriptor(), 0));
    std::string film = run(encoding(), palette, between_count_);
    check_count(film);
    if (format_ == FilmFormat::mp4) return film;
    set_delays(format_, film, seconds_);
    return with_xmp(
        format_, std::move(film),
        fmt::format("<x:xmpmeta xmlns:x=\"adobe:ns:meta/\">{}</x:xmpmeta>", markup_of(colophon_)));
  }

 private:
  Image drawn(Image image) const {
    return format_ == FilmFormat::mp4 ? evened(std::move(image)) : std::move(image);
  }

  /// Hands all pictures to ffmpeg, so many between two steps.
  std::string run(const std::vector<std::string>& words, const Descriptor& palette, std::size_t between) {
    Ffmpeg ffmpeg(joined({input(), words, {std::string(Ffmpeg::output)}}), palette);
    seconds_.clear();
    before_ = Image();
    for (std::size_t i = 0; i < count_; ++i) {
      const bool last = i + 1 == count_;
      const double moving = last ? 0 : static_cast<double>(between) / moving_fps;
      hand(ffmpeg, frame_(i), (last ? options_.hold_last : options_.seconds_per_step) - moving);
      for (std::size_t n = 1; n <= between && !last; ++n)
        hand(ffmpeg, between_(i, static_cast<double>(n) / static_cast<double>(between + 1)),
             1.0 / moving_fps);
    }
    if (between > 0) hand(ffmpeg, Image(before_), 0);  // so that nobody has to guess how long it stays
    return ffmpeg.finish();
  }

  /// One picture, which GIF and WebP show for so long.
  void hand(Ffmpeg& ffmpeg, Image image, double seconds) {
    Image now = drawn(std::move(image));
    if (now.width() != width_ || now.height() != height_) {
      throw WorkError(fmt::format("film: expected frames of {} x {}, found one of {} x {}", width_, height_,
                                  now.width(), now.height()));
    }
    // Encoders treat a frame without news each in its own way: it makes the one before last longer
    if (format_ != FilmFormat::mp4 && now == before_) {
      seconds_.back() += seconds;
      return;
    }
    seconds_.push_back(seconds);
    if (!ffmpeg.take(bytes_of(now))) {
      ffmpeg.finish();  // which may know the reason
      throw WorkError(
          fmt::format("film: expected ffmpeg to take {} frames, found that it stopped early", count_));
    }
    before_ = std::move(now);
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
            movie ? between_count_ > 0 ? fmt::to_string(options_.fps)
                                       : fmt::format("{}/{}", options_.fps, repeats())
                  : "10",
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

  /// Colours are converted once per picture, then it is repeated for as long as it lasts, the last one longer
  /// or shorter.
  std::string movie_filter() const {
    const std::string colors = "scale=out_color_matrix=bt709:out_range=tv,format=yuv420p";
    const std::string steady = fmt::format(",fps={}", options_.fps);
    if (between_count_ > 0) return colors + ",setpts=" + moment_of_picture() + steady + trim();
    if (last_repeats() > repeats())
      return colors + steady + fmt::format(",tpad=stop={}:stop_mode=clone", last_repeats() - repeats());
    return last_repeats() < repeats() ? colors + steady + trim() : colors + steady;
  }
  std::string trim() const { return fmt::format(",trim=end_frame={}", expected_frames()); }

  /// Of the N-th picture that is sent, in film frames: every step begins `repeats` after the one before, and
  /// what stands between comes last. The very last picture is the film's end.
  std::string moment_of_picture() const {
    const std::size_t sent = between_count_ + 1, end = (count_ - 1) * sent + 1;
    return fmt::format("'if(eq(N,{0}),{1},floor(N/{2})*{3}+if(mod(N,{2}),mod(N,{2})+{4},0))'", end,
                       expected_frames(), sent, repeats(), repeats() - sent);
  }

  // --- Time ------------------------------------------------------------------------------------------------

  std::size_t in_frames(double seconds) const {
    return static_cast<std::size_t>(std::max(1ll, std::llround(seconds * options_.fps)));
  }
  std::size_t repeats() const { return in_frames(options_.seconds_per_step); }
  std::size_t last_repeats() const { return in_frames(options_.hold_last); }

  std::size_t expected_frames() const {
    return format_ == FilmFormat::mp4 ? (count_ - 1) * repeats() + last_repeats() : seconds_.size();
  }

  /// ffmpeg takes a pipe that ends early for the end of the film, and calls it success.
  void check_count(std::string_view film) const {
    const std::size_t found = frames_in(format_, film);
    if (found == expected_frames()) return;
    throw WorkError(fmt::format("film: expected {} frames in the finished {}, found {}: ffmpeg stopped early",
                                expected_frames(), name_of(format_), found));
  }

  FilmFormat format_;
  std::size_t count_, between_count_;
  const std::function<Image(std::size_t)>& frame_;
  const std::function<Image(std::size_t, double)>& between_;
  const FilmOptions& options_;
  const Colophon& colophon_;
  int width_ = 0, height_ = 0;
  bool transparent_ = false;
  std::vector<double> seconds_;  ///< of the pictures sent: how long each stays
  Image before_;                 ///< the last one of them
};

/// A number in its range, or one line that says what was expected.
template <class Number>
void expect_between(std::string_view flag, Number least, Number most, Number found) {
  if (least <= found && found <= most) return;
  throw UsageError(fmt::format("--{}: expected {} to {}, found {}", flag, least, most, found));
}

}  // namespace

void check_film(FilmFormat format, const FilmOptions& options, bool transparent) {
  // A frame of a faster film lasts less
  const double least = format == FilmFormat::mp4 ? std::min(0.04, 1.0 / std::max(options.fps, 1)) : 0.04;
  expect_between("seconds-per-step", least, 60.0, options.seconds_per_step);
  expect_between("hold-last", least, 600.0, options.hold_last);
  expect_between("transition", 0.0, 10.0, options.transition.value_or(0));
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

std::size_t pictures_between(FilmFormat format, std::size_t steps, const FilmOptions& options) {
  const double unasked = steps <= most_moving ? usual_transition : 0;
  const double seconds = std::min(options.transition.value_or(unasked), options.seconds_per_step / 3);
  const int fps = format == FilmFormat::mp4 ? options.fps : moving_fps;
  return static_cast<std::size_t>(seconds * fps + 1e-9);
}

std::size_t pictures_drawn(FilmFormat format, std::size_t steps, const FilmOptions& options) {
  const std::size_t all = steps + (steps - 1) * pictures_between(format, steps, options);
  // The first one more: it tells the size and whether there is transparency
  return 1 + all + (format == FilmFormat::gif ? steps : 0);
}

std::string film_bytes(FilmFormat format, std::size_t frames, const std::function<Image(std::size_t)>& frame,
                       const FilmOptions& options, const Colophon& colophon,
                       const std::function<Image(std::size_t, double)>& between) {
  if (frames == 0) throw WorkError("film: expected at least one frame, found none");
  return Film(format, frames, frame, options, colophon, between).bytes();
}

}  // namespace gradus::cli
