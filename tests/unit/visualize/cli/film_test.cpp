// Films: whole, exact where the format allows it, and honest about what went wrong.

#include "cli/film/film.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <array>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <map>

#include "cairo/cairo_output.hpp"
#include "cairo/colophon_markup.hpp"
#include "cli/command_line/errors.hpp"
#include "figure/figure.hpp"
#include "support/example_traces.hpp"
#include "support/share.hpp"
#include "unit/visualize/cli/films.hpp"

namespace gradus::cli {
namespace {

using testing::HasSubstr;
namespace fs = std::filesystem;

constexpr std::array formats{FilmFormat::gif, FilmFormat::mp4, FilmFormat::webp};
const Colophon colophon{"Film \"<&>\" − 1", "What is seen",
                        "gradus figure flood_fill --maze '#.#/[x]' --x \"<s>\" %41 é",
                        "fnv1a:0123456789abcdef"};

Image square_at(int step, int width = 90, int height = 62, Rgba8 ground = {255, 255, 255, 255}) {
  Image image(width, height, ground);
  for (int y = 10; y < 50; ++y) {
    for (int x = 0; x < 24; ++x) image[{(6 * step + x) % width, y}] = Rgba8{0, 114, 178, 255};
  }
  for (int x = 0; x < width; ++x) image[{x, 55}] = Rgba8{27, 31, 36, 255};
  return image;
}

std::string film(FilmFormat format, std::size_t frames, const FilmOptions& options = {}, int width = 90,
                 int height = 62) {
  return film_bytes(
      format, frames, [&](std::size_t i) { return square_at(static_cast<int>(i), width, height); }, options,
      colophon);
}

class OtherPath {
 public:
  explicit OtherPath(const std::string& path) : before_(std::getenv("PATH")) {
    setenv("PATH", path.c_str(), 1);
  }
  ~OtherPath() { setenv("PATH", before_.c_str(), 1); }
  OtherPath(const OtherPath&) = delete;
  OtherPath& operator=(const OtherPath&) = delete;

 private:
  std::string before_;
};

/// A program called ffmpeg that is none.
void make_ffmpeg(const Folder& folder, const std::string& script) {
  write_film(folder / "ffmpeg", "#!/bin/sh\n" + script + "\n");
  fs::permissions(folder / "ffmpeg", fs::perms::owner_all);
}

template <class Error>
std::string error_of(const std::function<void()>& job) {
  try {
    job();
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
}

class Film : public testing::Test {
 protected:
  void SetUp() override { std::signal(SIGPIPE, SIG_IGN); }
  /// No child is left behind, running or dead.
  void TearDown() override {
    EXPECT_EQ(waitpid(-1, nullptr, WNOHANG), -1);
    EXPECT_EQ(errno, ECHILD);
  }
};

TEST_F(Film, Mp4IsWhatEveryPlayerPlays) {
  const std::string bytes =
      film(FilmFormat::mp4, 6, {.seconds_per_step = 0.5, .hold_last = 1.2, .fps = 20}, 91, 63);
  const auto stream = probed(bytes, "mp4");
  EXPECT_EQ(stream.at("codec_name"), "h264");
  EXPECT_EQ(stream.at("pix_fmt"), "yuv420p");
  EXPECT_EQ(stream.at("width"), "92");
  EXPECT_EQ(stream.at("height"), "64");
  EXPECT_EQ(stream.at("avg_frame_rate"), "20/1");
  EXPECT_EQ(stream.at("nb_read_frames"), "74") << "5 x 10 + 24";
  EXPECT_EQ(frames_in(FilmFormat::mp4, bytes), 74u);
  EXPECT_NEAR(std::stod(stream.at("duration")), 3.7, 1e-6);
  const auto images = decoded(bytes, "mp4", 92, 64);
  ASSERT_EQ(images.size(), 74u);
  for (std::size_t i = 0; i < images.size(); ++i) {
    const Image sent = square_at(static_cast<int>(std::min<std::size_t>(i / 10, 5)), 92, 64);
    EXPECT_GT(signal_to_noise(images[i], sent), 30) << i;
  }
  EXPECT_LT(signal_to_noise(images[0], square_at(5, 92, 64)), 20) << "the test can tell frames apart";
}

TEST_F(Film, Mp4LastFrameMayBeShort) {
  const FilmOptions options{.seconds_per_step = 1, .hold_last = 0.2, .fps = 10};
  EXPECT_EQ(probed(film(FilmFormat::mp4, 3, options), "mp4").at("nb_read_frames"), "22");
  EXPECT_EQ(probed(film(FilmFormat::mp4, 1, options), "mp4").at("nb_read_frames"), "2");
  EXPECT_EQ(probed(film(FilmFormat::mp4, 1), "mp4").at("nb_read_frames"), "75");
}

/// The square of a step with a bar above it that says how much of the way to the next one is done.
Image square_between(std::size_t i, double share) {
  Image image = square_at(static_cast<int>(i));
  const auto green = static_cast<std::uint8_t>(100 + std::lround(100 * share));
  for (int y = 0; y < 5; ++y) {
    for (int x = 0; x < 90; ++x) image[{x, y}] = {0, green, 0, 255};
  }
  return image;
}
/// The share that such a picture shows, or 0 for a still.
double share_in(const Image& image) {
  const Rgba8 corner = image[{2, 2}];
  return corner.r > 128 ? 0 : (corner.g - 100) / 100.0;
}
std::string moving_film(FilmFormat format, std::size_t frames, const FilmOptions& options) {
  return film_bytes(
      format, frames, [](std::size_t i) { return square_at(static_cast<int>(i)); }, options, colophon,
      square_between);
}

TEST_F(Film, MovesBetweenStepsInTheSameTime) {
  // 0.25 s at 25 pictures a second: 6 of a step's 20
  const FilmOptions options{.seconds_per_step = 0.8, .hold_last = 1.2, .fps = 25, .transition = 0.25};
  const std::string movie = moving_film(FilmFormat::mp4, 4, options);
  EXPECT_NEAR(std::stod(probed(movie, "mp4").at("duration")), 3 * 0.8 + 1.2, 1e-6);
  const auto images = decoded(movie, "mp4", 90, 62);
  ASSERT_EQ(images.size(), 3u * 20 + 30);
  for (std::size_t i = 0; i < images.size(); ++i) {
    const std::size_t step = std::min<std::size_t>(i / 20, 3), within = i - 20 * step;
    if (step == 3 || within < 14) {
      EXPECT_GT(signal_to_noise(images[i], square_at(static_cast<int>(step))), 30) << "a still: " << i;
    } else {
      // H.264 is not exact; two neighbours are 0.14 apart
      EXPECT_NEAR(share_in(images[i]), static_cast<double>(within - 13) / 7, 0.12) << i;
    }
  }

  const FilmOptions timing{.seconds_per_step = 0.5, .hold_last = 2, .transition = 0.15};
  const auto frames = webp_frames(moving_film(FilmFormat::webp, 3, timing));
  std::vector<std::size_t> delays;
  for (const WebpFrame& frame : frames) delays.push_back(frame.milliseconds);
  EXPECT_EQ(delays, (std::vector<std::size_t>{350, 50, 50, 50, 350, 50, 50, 50, 2000}));
  const auto webp = shown(frames, 90, 62);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(webp[4 * i], square_at(static_cast<int>(i))) << "stills are exact";
    if (i < 2) EXPECT_NEAR(share_in(webp[4 * i + 2]), 0.5, 0.01);
  }

  const std::string gif = moving_film(FilmFormat::gif, 3, timing);
  EXPECT_NEAR(std::stod(probed(gif, "gif").at("duration")), 2 * 0.5 + 2, 0.005);
  const auto pictures = decoded(gif, "gif", 90, 62);
  ASSERT_EQ(pictures.size(), frames.size());
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(pictures[4 * i], square_at(static_cast<int>(i))) << i;
}

TEST_F(Film, EveryTimingLastsAsAsked) {
  const std::pair<double, double> timings[] = {{0.04, 0.7},   {0.1, 0.04}, {0.29, 0.7},
                                               {0.333, 0.04}, {1, 0.7},    {1.5, 0.04}};
  std::size_t next = 0;
  for (const auto& [step, last] : timings) {
    if (!test::in_share(next++, 3)) continue;
    const FilmOptions options{.seconds_per_step = step, .hold_last = last, .fps = 30};
    const auto frames_of = [](double seconds) { return std::max(1l, std::lround(seconds * 30)); };
    EXPECT_EQ(frames_in(FilmFormat::mp4, moving_film(FilmFormat::mp4, 5, options)),
              static_cast<std::size_t>(4 * frames_of(step) + frames_of(last)))
        << step << " " << last;
    std::size_t milliseconds = 0;
    for (const WebpFrame& frame : webp_frames(moving_film(FilmFormat::webp, 5, options)))
      milliseconds += frame.milliseconds;
    EXPECT_EQ(milliseconds, static_cast<std::size_t>(std::lround(1000 * (4 * step + last)))) << step;
  }
}

TEST_F(Film, MovesForAThirdOfAStepAtMost) {
  const auto between = [](FilmFormat format, const FilmOptions& options, std::size_t steps = 10) {
    return pictures_between(format, steps, options);
  };
  EXPECT_EQ(between(FilmFormat::gif, {}), 6u) << "0.3 s at 20 a second";
  EXPECT_EQ(between(FilmFormat::mp4, {}), 7u) << "at 25";
  EXPECT_EQ(between(FilmFormat::mp4, {.fps = 60}), 18u);
  EXPECT_EQ(between(FilmFormat::gif, {.seconds_per_step = 0.45}), 3u);
  EXPECT_EQ(between(FilmFormat::webp, {.seconds_per_step = 0.1}), 0u);
  EXPECT_EQ(between(FilmFormat::webp, {.seconds_per_step = 3, .transition = 5}), 20u);
  EXPECT_EQ(between(FilmFormat::gif, {.transition = 0}), 0u);
  EXPECT_EQ(between(FilmFormat::gif, {}, most_moving), 6u);
  EXPECT_EQ(between(FilmFormat::gif, {}, most_moving + 1), 0u) << "long films would become large";
  EXPECT_EQ(between(FilmFormat::gif, {.transition = 0.3}, most_moving + 1), 6u) << "unless asked for";
}

TEST_F(Film, TellsHowManyPicturesItDraws) {
  for (const FilmFormat format : formats) {
    for (const FilmOptions& options : {FilmOptions{}, FilmOptions{.transition = 0}}) {
      std::size_t drawn = 0;
      const auto frame = [&](std::size_t i) { return ++drawn, square_at(static_cast<int>(i)); };
      const auto between = [&](std::size_t i, double share) { return ++drawn, square_between(i, share); };
      film_bytes(format, 4, frame, options, colophon, between);
      EXPECT_EQ(drawn, pictures_drawn(format, 4, options)) << name_of(format);
    }
  }
}

TEST_F(Film, GifIsExactWithFewColours) {
  const std::string bytes = film(FilmFormat::gif, 7, {.seconds_per_step = 0.25, .hold_last = 2});
  const auto images = decoded(bytes, "gif", 90, 62);
  ASSERT_EQ(images.size(), 7u);
  for (int i = 0; i < 7; ++i) EXPECT_EQ(images[static_cast<std::size_t>(i)], square_at(i)) << i;
  EXPECT_EQ(frames_in(FilmFormat::gif, bytes), 7u);
  EXPECT_NEAR(std::stod(probed(bytes, "gif").at("duration")), 6 * 0.25 + 2, 0.005);
}

TEST_F(Film, GifIsTransparentWhereNothingIsPainted) {
  const Rgba8 nothing{0, 0, 0, 0};
  const auto frame = [&](std::size_t i) { return square_at(static_cast<int>(i), 90, 62, nothing); };
  const std::string bytes = film_bytes(FilmFormat::gif, 4, frame, {}, colophon);
  const auto images = decoded(bytes, "gif", 90, 62);
  ASSERT_EQ(images.size(), 4u);
  for (std::size_t i = 0; i < 4; ++i)
    EXPECT_TRUE(same_seen(images[i], frame(i))) << "nothing of a frame stays: " << i;
}

TEST_F(Film, WebpIsExact) {
  for (const Rgba8 ground : {Rgba8{250, 251, 252, 255}, Rgba8{0, 0, 0, 0}}) {
    const auto frame = [&](std::size_t i) { return square_at(static_cast<int>(i), 90, 62, ground); };
    const std::string bytes = film_bytes(FilmFormat::webp, 6, frame,
                                         {.seconds_per_step = 0.333, .hold_last = 2.5, .loop = 3}, colophon);
    const auto frames = webp_frames(bytes);
    const auto images = shown(frames, 90, 62);
    ASSERT_EQ(images.size(), 6u);
    for (std::size_t i = 0; i < 6; ++i) {
      EXPECT_TRUE(same_seen(images[i], frame(i))) << i;
      EXPECT_EQ(frames[i].milliseconds, i < 5 ? 333u : 2500u);
    }
    EXPECT_EQ(number_at(bytes, bytes.find("ANIM") + 12, 2), 3u);
  }
}

TEST_F(Film, LoopsAsOftenAsAsked) {
  const auto loop_of = [](int loop) -> int {
    const std::string bytes = film(FilmFormat::gif, 2, {.loop = loop});
    const std::size_t at = bytes.find("NETSCAPE2.0");
    return at == std::string::npos ? -1 : static_cast<int>(number_at(bytes, at + 13, 2));
  };
  EXPECT_EQ(loop_of(0), 0) << "for ever";
  EXPECT_EQ(loop_of(1), -1) << "once: no repetition";
  EXPECT_EQ(loop_of(5), 4) << "four repetitions";
}

TEST_F(Film, FramesWithoutNewsOnlyLast) {
  const auto frame = [](std::size_t i) { return square_at(static_cast<int>(i / 3)); };
  const FilmOptions options{.seconds_per_step = 0.2, .hold_last = 1};
  const std::string webp = film_bytes(FilmFormat::webp, 6, frame, options, colophon);
  const auto frames = webp_frames(webp);
  ASSERT_EQ(frames.size(), 2u);
  EXPECT_EQ(frames[0].milliseconds, 600u);
  EXPECT_EQ(frames[1].milliseconds, 1400u);
  const std::string gif = film_bytes(FilmFormat::gif, 6, frame, options, colophon);
  EXPECT_EQ(decoded(gif, "gif", 90, 62).size(), 2u);
  EXPECT_NEAR(std::stod(probed(gif, "gif").at("duration")), 2, 0.005);
  for (const FilmFormat format : {FilmFormat::gif, FilmFormat::webp}) {
    const auto still = [](std::size_t) { return square_at(1); };
    EXPECT_EQ(frames_in(format, film_bytes(format, 5, still, {}, colophon)), 1u) << name_of(format);
  }
}

TEST_F(Film, FiguresKeepTheirColours) {
  const Trace trace = test::trace_of("bresenham_line");
  Finish finish(*find_theme("dark"));
  finish.scale = 0.5;
  const auto frame = [&](std::size_t i) {
    Playhead playhead(trace);
    return image_of(lay_out(figure_of(trace, playhead, {static_cast<int>(i), 0}), {}), finish);
  };
  const Image sent = frame(2);
  const auto gif = decoded(film_bytes(FilmFormat::gif, 4, frame, {}, colophon), "gif", 640, 360);
  ASSERT_EQ(gif.size(), 4u);
  // What fills an area keeps the theme's colour to one level; rims of letters and hatches are mixed from
  // several
  std::map<std::uint32_t, std::size_t> fills;
  const auto hex_of = [](Rgba8 c) { return static_cast<std::uint32_t>(c.r << 16 | c.g << 8 | c.b); };
  for (const Rgba8 q : sent.cells()) ++fills[hex_of(q)];
  std::erase_if(fills, [&](const auto& fill) {
    return fill.second < 1000 ||
           std::ranges::find(finish.theme.tone, Rgb{fill.first}) == finish.theme.tone.end();
  });
  std::size_t filled = 0, far = 0;
  for (std::size_t i = 0; i < sent.cells().size(); ++i) {
    const Rgba8 p = gif[2].cells()[i], q = sent.cells()[i];
    const int off = std::max({std::abs(p.r - q.r), std::abs(p.g - q.g), std::abs(p.b - q.b)});
    far += off > 24;
    if (!fills.contains(hex_of(q))) continue;
    ++filled;
    ASSERT_LE(off, 1) << fmt::format("{:06x} became {:06x}", hex_of(q), hex_of(p));
  }
  const auto pixels = static_cast<double>(sent.cells().size());
  EXPECT_GT(static_cast<double>(filled), 0.8 * pixels);
  EXPECT_LT(static_cast<double>(far), 0.002 * pixels);
  EXPECT_GT(signal_to_noise(gif[2], sent), 40);
  const auto webp = shown(webp_frames(film_bytes(FilmFormat::webp, 4, frame, {}, colophon)), 640, 360);
  ASSERT_EQ(webp.size(), 4u);
  EXPECT_EQ(webp[2], sent);
}

TEST_F(Film, SameFramesSameBytes) {
  for (const FilmFormat format : formats) EXPECT_EQ(film(format, 4), film(format, 4)) << name_of(format);
}

TEST_F(Film, SaysHowItWasMade) {
  for (const FilmFormat format : formats) {
    const auto found = colophon_in(film(format, 3));
    ASSERT_TRUE(found) << name_of(format);
    EXPECT_EQ(found->command, colophon.command);
    EXPECT_EQ(found->input_hash, colophon.input_hash);
    EXPECT_EQ(found->title, colophon.title);
    EXPECT_EQ(found->description, colophon.description);
  }
}

TEST_F(Film, CutOffFilesHaveNoFrames) {
  for (const FilmFormat format : formats) {
    const std::string whole = film(format, 5);
    EXPECT_GT(frames_in(format, whole), 0u);
    std::size_t cuts = 0;
    for (std::size_t size = 0; size < whole.size(); size += 1 + whole.size() / 200, ++cuts) {
      EXPECT_EQ(frames_in(format, std::string_view(whole).substr(0, size)), 0u)
          << name_of(format) << " " << size;
    }
    EXPECT_GT(cuts, 100u);
  }
}

TEST_F(Film, NoticesAPipeThatEndsEarly) {
  // The real ffmpeg gets five frames, finds that they were all, and calls it success
  const Folder folder;
  const std::string path = std::getenv("PATH");
  const std::string five = fmt::format("head -c {} | PATH='{}' ffmpeg \"$@\"", 5 * 90 * 62 * 4, path);
  const OtherPath other((folder / "") + ":" + path);
  for (const FilmFormat format : formats) {
    const bool movie = format == FilmFormat::mp4;
    make_ffmpeg(folder, five + "; cat > /dev/null; exit 0");  // nothing to see but the number of frames
    EXPECT_EQ(error_of<WorkError>([&] { film(format, 10, {.hold_last = 1}); }),
              fmt::format("film: expected {} frames in the finished {}, found {}: ffmpeg stopped early",
                          movie ? 9 * 38 + 25 : 10, name_of(format), movie ? 5 * 38 : 5));
    make_ffmpeg(folder, five + "; exit 0");  // the pipe breaks
    EXPECT_EQ(error_of<WorkError>([&] { film(format, 60); }),
              "film: expected ffmpeg to take 60 frames, found that it stopped early");
  }
}

TEST_F(Film, NoticesAnFfmpegThatWritesNothing) {
  const Folder folder;
  make_ffmpeg(folder, "exit 0");
  const OtherPath other((folder / "") + ":" + std::getenv("PATH"));
  for (const FilmFormat format : formats) {
    EXPECT_THAT(error_of<WorkError>([&] { film(format, 300); }),
                testing::AnyOf(HasSubstr("found 0"), HasSubstr("stopped early")))
        << name_of(format);
  }
}

TEST_F(Film, WithoutFfmpegOneClearLine) {
  const Folder empty;
  const OtherPath other(empty / "");
  for (const FilmFormat format : formats) {
    EXPECT_EQ(error_of<WorkError>([&] { film(format, 3); }),
              "film: expected the program ffmpeg on the PATH (Debian: apt install ffmpeg), found none");
  }
}

TEST_F(Film, HandsOnWhatFfmpegComplainsOf) {
  const Folder folder;
  make_ffmpeg(folder, "echo \"Unknown encoder 'libx264'\" >&2; echo more >&2; exit 3");
  {
    const OtherPath other((folder / "") + ":" + std::getenv("PATH"));
    EXPECT_EQ(error_of<WorkError>([] { film(FilmFormat::mp4, 3); }),
              "film: ffmpeg failed: Unknown encoder 'libx264'");
  }
  make_ffmpeg(folder, "kill -9 $$");
  const OtherPath other((folder / "") + ":" + std::getenv("PATH"));
  EXPECT_EQ(error_of<WorkError>([] { film(FilmFormat::webp, 3); }),
            "film: ffmpeg failed: stopped by signal 9");
}

TEST_F(Film, WhatDrawingThrowsPassesThrough) {
  const auto frame = [](std::size_t i) {
    if (i == 3) throw std::range_error("no such step");
    return square_at(static_cast<int>(i));
  };
  for (const FilmFormat format : formats) {
    EXPECT_EQ(error_of<std::range_error>([&] { film_bytes(format, 9, frame, {}, colophon); }),
              "no such step");
  }
  const auto growing = [](std::size_t i) { return square_at(0, 90 + static_cast<int>(i), 62); };
  EXPECT_THAT(error_of<WorkError>([&] { film_bytes(FilmFormat::gif, 3, growing, {}, colophon); }),
              HasSubstr("expected frames of 90 x 62, found one of 91 x 62"));
}

TEST_F(Film, RefusesWhatNoFilmCanHave) {
  const auto error = [](FilmFormat format, const FilmOptions& options, bool transparent = false) {
    return error_of<UsageError>([&] { check_film(format, options, transparent); });
  };
  for (const FilmFormat format : formats) EXPECT_EQ(error(format, {}), "no error");
  EXPECT_EQ(error(FilmFormat::gif, {}, true), "no error");
  EXPECT_EQ(error(FilmFormat::gif, {.seconds_per_step = 0}),
            "--seconds-per-step: expected 0.04 to 60, found 0");
  EXPECT_EQ(error(FilmFormat::gif, {.seconds_per_step = std::nan("")}),
            "--seconds-per-step: expected 0.04 to 60, found nan");
  EXPECT_EQ(error(FilmFormat::gif, {.hold_last = 601}), "--hold-last: expected 0.04 to 600, found 601");
  EXPECT_EQ(error(FilmFormat::mp4, {.fps = 61}), "--fps: expected 1 to 60, found 61");
  EXPECT_EQ(error(FilmFormat::webp, {.loop = -1}), "--loop: expected 0 to 65535, found -1");
  EXPECT_EQ(error(FilmFormat::gif, {.transition = 10.5}), "--transition: expected 0 to 10, found 10.5");
  EXPECT_THAT(error(FilmFormat::mp4, {.seconds_per_step = 0.1, .fps = 5}),
              HasSubstr("1/5 s at --fps 5, found 0.1"));
  EXPECT_THAT(error(FilmFormat::mp4, {}, true), HasSubstr("--background: expected a ground for mp4"));
  const auto clear = [](std::size_t) { return square_at(0, 90, 62, {0, 0, 0, 0}); };
  EXPECT_THAT(error_of<UsageError>([&] { film_bytes(FilmFormat::mp4, 2, clear, {}, colophon); }),
              HasSubstr("--background"));
}

}  // namespace
}  // namespace gradus::cli
