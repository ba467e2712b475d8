#pragma once
// Films as other programs see them: what ffmpeg decodes, ffprobe says, and the frames of a WebP.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "cli/film/film.hpp"
#include "figure/figure.hpp"

namespace gradus::cli {

namespace fs = std::filesystem;

/// A folder that goes away with the test.
class Folder {
 public:
  Folder() {
    std::string name = (fs::temp_directory_path() / "gradus_film_XXXXXX").string();
    path_ = mkdtemp(name.data());
  }
  ~Folder() { fs::remove_all(path_); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  std::string operator/(const std::string& name) const { return path_ / name; }

 private:
  fs::path path_;
};

inline void write_film(const std::string& path, const std::string& bytes) {
  std::ofstream(path, std::ios::binary) << bytes;
}

inline std::string output_of(const std::string& command) {
  std::string text;
  std::FILE* pipe = popen(command.c_str(), "r");
  char block[4096];
  for (std::size_t count; (count = std::fread(block, 1, sizeof block, pipe)) > 0;) text.append(block, count);
  EXPECT_EQ(pclose(pipe), 0) << command;
  return text;
}

/// Few colours, a square that moves: what figures are like.

/// The film's pictures as ffmpeg decodes them.
inline std::vector<Image> decoded(const std::string& film, const std::string& ending, int width, int height) {
  const Folder folder;
  write_film(folder / ("film." + ending), film);
  const std::string raw = output_of("ffmpeg -v error -i " + (folder / ("film." + ending)) +
                                    " -vsync passthrough -f rawvideo -pix_fmt rgba -");
  std::vector<Image> images;
  const std::size_t size = static_cast<std::size_t>(width * height) * 4;
  EXPECT_EQ(raw.size() % size, 0u);
  for (std::size_t at = 0; at + size <= raw.size(); at += size) {
    Image image(width, height);
    std::memcpy(image.cells().data(), raw.data() + at, size);
    images.push_back(std::move(image));
  }
  return images;
}

inline double signal_to_noise(const Image& a, const Image& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.cells().size(); ++i) {
    const Rgba8 p = a.cells()[i], q = b.cells()[i];
    sum += std::pow(p.r - q.r, 2) + std::pow(p.g - q.g, 2) + std::pow(p.b - q.b, 2);
  }
  return 10 * std::log10(255 * 255 / (sum / 3 / static_cast<double>(a.cells().size())));
}

inline std::size_t number_at(std::string_view bytes, std::size_t at, std::size_t count) {
  std::size_t value = 0;
  for (std::size_t i = count; i-- > 0;) value = value << 8 | static_cast<std::uint8_t>(bytes[at + i]);
  return value;
}

struct WebpFrame {
  int x, y;
  std::size_t milliseconds;
  bool blends, disposes;
  Image image;
};

/// An animated WebP taken apart: each frame put into a file of its own, which ffmpeg can decode.
inline std::vector<WebpFrame> webp_frames(const std::string& film) {
  std::vector<WebpFrame> frames;
  for (std::size_t at = 12; at < film.size();) {
    const std::size_t length = number_at(film, at + 4, 4), start = at + 8;
    if (film.substr(at, 4) == "ANMF") {
      const int width = static_cast<int>(number_at(film, start + 6, 3)) + 1,
                height = static_cast<int>(number_at(film, start + 9, 3)) + 1;
      std::string still = film.substr(start + 16, length - 16);
      if (still.substr(0, 4) != "VP8L") ADD_FAILURE() << "expected a lossless frame";
      std::string size(4, '\0');
      for (std::size_t i = 0; i < 4; ++i) size[i] = static_cast<char>((still.size() + 4) >> 8 * i);
      const auto flags = static_cast<std::uint8_t>(film[start + 15]);
      frames.push_back({2 * static_cast<int>(number_at(film, start, 3)),
                        2 * static_cast<int>(number_at(film, start + 3, 3)), number_at(film, start + 12, 3),
                        (flags & 2) == 0, (flags & 1) != 0,
                        decoded("RIFF" + size + "WEBP" + still, "webp", width, height).at(0)});
    }
    at = start + length + length % 2;
  }
  return frames;
}

/// What a viewer shows after each frame.
inline std::vector<Image> shown(const std::vector<WebpFrame>& frames, int width, int height) {
  std::vector<Image> images;
  Image canvas(width, height, Rgba8{0, 0, 0, 0});
  for (const WebpFrame& frame : frames) {
    for (int y = 0; y < frame.image.height(); ++y) {
      for (int x = 0; x < frame.image.width(); ++x) {
        const Rgba8 c = frame.image[{x, y}];
        EXPECT_TRUE(c.a == 0 || c.a == 255);
        if (!frame.blends || c.a == 255) canvas[{frame.x + x, frame.y + y}] = c;
      }
    }
    images.push_back(canvas);
    if (!frame.disposes) continue;
    for (int y = 0; y < frame.image.height(); ++y) {
      for (int x = 0; x < frame.image.width(); ++x) canvas[{frame.x + x, frame.y + y}] = {0, 0, 0, 0};
    }
  }
  return images;
}

inline bool same_seen(const Image& a, const Image& b) {
  for (std::size_t i = 0; i < a.cells().size(); ++i) {
    const Rgba8 p = a.cells()[i], q = b.cells()[i];
    if (p != q && (p.a != 0 || q.a != 0)) return false;
  }
  return a.width() == b.width() && a.height() == b.height();
}

/// "key=value" lines of ffprobe about the only stream.
inline std::map<std::string, std::string> probed(const std::string& film, const std::string& ending) {
  const Folder folder;
  write_film(folder / ("film." + ending), film);
  std::map<std::string, std::string> found;
  std::istringstream lines(
      output_of("ffprobe -v error -count_frames -show_streams " + (folder / ("film." + ending))));
  for (std::string line; std::getline(lines, line);) {
    if (const auto at = line.find('='); at != std::string::npos)
      found[line.substr(0, at)] = line.substr(at + 1);
  }
  return found;
}

/// A folder at the head of the PATH, alone or before what was there.

}  // namespace gradus::cli
