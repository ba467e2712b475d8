#include "cli/film/road_film.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>
#include <vector>

#include "cli/film/film.hpp"
#include "cli/film/frames_ahead.hpp"

namespace gradus::cli {
namespace {

TEST(FramesAhead, EachFrameIsDrawnOnceWhenAskedForInOrder) {
  for (const std::size_t threads : {1u, 2u, 7u}) {
    for (const std::size_t count : {1u, 4u, 30u}) {
      std::vector<std::atomic<int>> drawn(count);
      FramesAhead<std::size_t> frames(count, threads, [&drawn](std::size_t i) {
        ++drawn[i];
        return 10 * i;
      });
      EXPECT_EQ(frames.at(0), 0u) << "a film asks for the first one twice";
      for (std::size_t i = 0; i < count; ++i) EXPECT_EQ(frames.at(i), 10 * i);
      for (const auto& times : drawn) EXPECT_EQ(times, 1);
    }
  }
}

TEST(FramesAhead, WhatGoesWrongOnAThreadIsThrownToWhoAsks) {
  FramesAhead<int> frames(40, 3, [](std::size_t i) {
    if (i == 17) throw std::runtime_error("frame 17");
    return static_cast<int>(i);
  });
  EXPECT_EQ(frames.at(0), 0);
  EXPECT_THROW(
      {
        for (std::size_t i = 0; i < 40; ++i) frames.at(i);
      },
      std::runtime_error);
}

TEST(RoadFilm, WithoutARateThereAre25FramesASecond) {
  const FilmOptions usual;
  EXPECT_EQ(usual.fps, 25);
  // 50 frames, each as long as a frame of that rate lasts
  FilmOptions options;
  options.seconds_per_step = options.hold_last = 1.0 / usual.fps;
  options.transition = 0;
  const auto frame = [](std::size_t i) { return Image(16, 16, {static_cast<std::uint8_t>(5 * i), 0, 0}); };
  const std::string film = film_bytes(FilmFormat::mp4, 50, frame, options, {});
  EXPECT_EQ(frames_in(FilmFormat::mp4, film), 50u) << "two seconds";
}

TEST(RoadFilm, AStripHasFiveFramesFromTheFirstToTheLast) {
  EXPECT_EQ(frames_in_strip(125), (std::vector<std::size_t>{0, 31, 62, 93, 124}));
  EXPECT_EQ(frames_in_strip(1), (std::vector<std::size_t>{0, 0, 0, 0, 0}));
  const std::vector<Image> frames(5, Image(512, 512, {10, 20, 30}));
  const Image strip = strip_of(frames, false);
  EXPECT_EQ(strip.width(), 5 * 256 + 4 * 8);
  EXPECT_EQ(strip.height(), 256);
  EXPECT_EQ((strip[{100, 100}]), (Rgba8{10, 20, 30}));
  EXPECT_EQ((strip[{260, 100}]), (Rgba8{255, 255, 255}));
}

}  // namespace
}  // namespace gradus::cli
