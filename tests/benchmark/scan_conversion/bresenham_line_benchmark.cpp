// Lines drawn into a picture by every method, beside those of OpenCV, Cairo, AGG and Mesa.

#include <array>
#include <map>
#include <random>

#include "benchmark/scan_conversion/drawings.hpp"
#include "benchmark/scan_conversion/peers.hpp"
#include "scan_conversion/bresenham_line/bresenham_line.hpp"
#include "scan_conversion/bresenham_line/bresenham_line_batch.hpp"
#include "scan_conversion/bresenham_line/bresenham_line_notes.hpp"
#include "stress/scan_conversion/nearest_pixels.hpp"

#ifdef GRADUS_HAS_OPENCV
#include <opencv2/imgproc.hpp>
#endif

namespace gradus::bench {
namespace {

using namespace drawings;
using Line = Segment<2, int>;

constexpr int side = 1024;

/// Random numbers that are the same on every machine.
class Random {
 public:
  int below(int n) { return static_cast<int>(engine_() % static_cast<std::uint64_t>(n)); }

 private:
  std::mt19937_64 engine_{1};
};

/// 200 lines inside the picture, of all directions, nearly level, or short.
std::vector<Line> mix(const std::string& name) {
  Random random;
  std::vector<Line> lines;
  for (int i = 0; i < 200; ++i) {
    const int x = random.below(side), y = random.below(side);
    const int level = 20 + random.below(side - 40);
    const int a = 20 + random.below(side - 40), b = 20 + random.below(side - 40);
    if (name == "all directions") {
      lines.push_back({{x, y}, {random.below(side), random.below(side)}});
    } else if (name == "nearly level") {
      lines.push_back(
          {{random.below(100), level}, {side - 1 - random.below(100), level + random.below(41) - 20}});
    } else {
      lines.push_back({{a, b}, {a + random.below(41) - 20, b + random.below(41) - 20}});
    }
  }
  return lines;
}

/// 100 lines of so many pixels.
std::vector<Line> of_length(int pixels) {
  Random random;
  std::vector<Line> lines;
  for (int i = 0; i < 100; ++i) {
    const int minor = random.below(pixels), x = random.below(side - pixels + 1);
    const int y = random.below(side - minor);
    const ivec2 from{x, y}, to{x + pixels - 1, y + minor};
    // Every other one steep
    if (i % 2 == 0) {
      lines.push_back({from, to});
    } else {
      lines.push_back({{from.y, from.x}, {to.y, to.x}});
    }
  }
  return lines;
}

std::int64_t pixels_of(const std::vector<Line>& lines) {
  std::int64_t pixels = 0;
  for (const Line& line : lines) pixels += bresenham_line::pixel_count(line.a, line.b);
  return pixels;
}

void taught(Canvas& canvas, const Line& line) {
  bresenham_line::decision_parameter(line.a, line.b, [&](ivec2 p) { canvas[p] = 1; });
}

void by_definition(Canvas& canvas, const Line& line) {
  for (std::int64_t k = 0; k <= stress::last_of_line(line.a, line.b); ++k) {
    canvas[stress::pixel_of_line(line.a, line.b, k)] = 1;
  }
}
double off(const Line& line, ivec2 p) { return stress::off_line(line.a, line.b, p); }

Window round(const Line& line) { return {glm::min(line.a, line.b) - 2, glm::max(line.a, line.b) + 2}; }

/// Every method on the lines.
void add_cases(std::vector<Case>& cases, const std::vector<Line>& lines, const Workload& workload) {
  const Figures<Line> figures{by_definition, round, off};
  const std::int64_t pixels = pixels_of(lines);
  const auto add = [&](const char* name, Standing standing, auto draw) {
    cases.push_back(case_of(name, standing, draw, lines, side, pixels, figures, workload));
  };
  add("decision_parameter", Standing::taught, taught);
  add("dda<float>", Standing::taught, [](Canvas& canvas, const Line& line) {
    bresenham_line::dda<float>(line.a, line.b, [&](ivec2 p) { canvas[p] = 1; });
  });
  add("run_length", Standing::robust, [](Canvas& canvas, const Line& line) {
    const ivec2 step = bresenham_line::moves(line.a, line.b).straight;
    bresenham_line::run_length(line.a, line.b, [&](ivec2 start, std::int64_t count) {
      for (; count > 0; --count, start += step) canvas[start] = 1;
    });
  });
  add("draw", Standing::batch, [](Canvas& canvas, const Line& line) {
    bresenham_line::draw(canvas, line.a, line.b, std::uint8_t{1});
  });
  add("first_octant", Standing::faulty, [](Canvas& canvas, const Line& line) {
    bresenham_line::first_octant(line.a, line.b, [&](ivec2 p) {
      if (canvas.contains(p)) canvas[p] = 1;
    });
  });
#ifdef GRADUS_HAS_OPENCV
  add("OpenCV line", Standing::peer, [](Canvas& canvas, const Line& line) {
    cv::Mat picture(canvas.height(), canvas.width(), CV_8UC1, canvas.cells().data());
    cv::line(picture, {line.a.x, line.a.y}, {line.b.x, line.b.y}, 1);
  });
#endif
  const auto add_all = [&](const char* name, auto all, auto one) {
    cases.push_back(case_of_all(name, Standing::peer, all, one, lines, side, pixels, figures, workload));
  };
  add_all(
      "Cairo stroke",
      [](Canvas& canvas, const std::vector<Line>& set) {
        peers::CairoPen pen(canvas);
        for (const Line& line : set) pen.line(line.a, line.b);
      },
      [](Canvas& canvas, const Line& line) { peers::CairoPen(canvas).line(line.a, line.b); });
#ifdef GRADUS_HAS_AGG
  add("AGG line", Standing::peer,
      [](Canvas& canvas, const Line& line) { peers::AggPen(canvas).line(line.a, line.b); });
#endif
#ifdef GRADUS_HAS_OSMESA
  static peers::MesaPicture mesa(side);
  add_all(
      "Mesa GL_LINES", [](Canvas&, const std::vector<Line>& set) { mesa.lines(set); },
      [](Canvas& canvas, const Line& line) {
        mesa.lines(std::array{line});
        mesa.give_to(canvas, round(line));
      });
#endif
}

std::vector<Case> cases() {
  static std::map<std::string, std::vector<Line>> sets;
  std::vector<Case> all;
  for (const char* name : {"all directions", "nearly level", "20 pixels"}) {
    add_cases(all, sets[name] = mix(name), {name});
  }
  for (const int length : {8, 32, 128, 512}) {
    const std::string name = fmt::format("{} pixels each", length);
    add_cases(all, sets[name] = of_length(length), {name, static_cast<double>(length)});
  }
  return all;
}

}  // namespace

Subject bresenham_line() {
  return {.topic = "bresenham_line",
          .title = "Lines into a picture",
          .item = "pixel",
          .unit = "pixels",
          .measure = "pixels of a line; 100 lines per run",
          .telling = "all directions",
          .cases = cases,
          .choice = {"draw", "every pixel the nearest, in the least time"}};
}

}  // namespace gradus::bench
