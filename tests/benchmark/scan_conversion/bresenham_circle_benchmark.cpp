// Circles drawn into a picture by every method, beside those of OpenCV, Cairo and AGG.

#include <map>
#include <random>

#include "benchmark/scan_conversion/drawings.hpp"
#include "benchmark/scan_conversion/peers.hpp"
#include "scan_conversion/bresenham_circle/bresenham_circle.hpp"
#include "scan_conversion/bresenham_circle/bresenham_circle_batch.hpp"
#include "scan_conversion/bresenham_circle/bresenham_circle_notes.hpp"
#include "scan_conversion/bresenham_circle/bresenham_circle_window.hpp"
#include "stress/scan_conversion/nearest_pixels.hpp"

#ifdef GRADUS_HAS_OPENCV
#include <opencv2/imgproc.hpp>
#endif

namespace gradus::bench {
namespace {

using namespace drawings;
using PixelCircle = Circle<int>;

constexpr int side = 1024;

/// 100 circles inside the picture with radii from `least` to `most`, or anywhere, cut by its border.
std::vector<PixelCircle> circles(int least, int most, bool cut = false) {
  std::mt19937_64 random(1);
  const auto below = [&](int n) { return static_cast<int>(random() % static_cast<std::uint64_t>(n)); };
  std::vector<PixelCircle> set;
  for (int i = 0; i < 100; ++i) {
    const int radius = least + below(most - least + 1);
    const int room = cut ? side : side - 2 * radius, first = cut ? 0 : radius;
    const int x = first + below(room);
    set.push_back({{x, first + below(room)}, radius});
  }
  return set;
}

void taught(Canvas& canvas, const PixelCircle& circle) {
  bresenham_circle::decision_parameter(circle.centre, circle.radius, [&](ivec2 p) {
    if (canvas.contains(p)) canvas[p] = 1;
  });
}

/// In every column of the first octant the pixel that the definition takes, and its mirror images.
void by_definition(Canvas& canvas, const PixelCircle& circle) {
  const auto& [centre, radius] = circle;
  for (int x = 0; x <= radius; ++x) {
    const int y = static_cast<int>(std::lround(std::sqrt(1.0 * radius * radius - 1.0 * x * x)));
    if (x > y || !stress::is_height(radius, x, y)) continue;
    for (const ivec2 at : {ivec2{x, y}, {-x, y}, {x, -y}, {-x, -y}, {y, x}, {-y, x}, {y, -x}, {-y, -x}}) {
      if (canvas.contains(centre + at)) canvas[centre + at] = 1;
    }
  }
}
double off(const PixelCircle& circle, ivec2 p) { return stress::off_circle(circle.centre, circle.radius, p); }

Window round(const PixelCircle& circle) {
  return {circle.centre - circle.radius - 3, circle.centre + circle.radius + 3};
}

void add_cases(std::vector<Case>& cases, const std::vector<PixelCircle>& set, const Workload& workload,
               bool cut) {
  const Figures<PixelCircle> figures{by_definition, round, off};
  const Window whole{{0, 0}, {side - 1, side - 1}};
  std::int64_t pixels = 0;
  for (const PixelCircle& circle : set) {
    bresenham_circle::decision_parameter(circle.centre, circle.radius,
                                         [&](ivec2 p) { pixels += whole.contains(p) ? 1 : 0; });
  }
  const auto add = [&](const char* name, Standing standing, auto draw) {
    cases.push_back(case_of(name, standing, draw, set, side, pixels, figures, workload));
  };
  if (cut) {
    add("decision_parameter, asking each pixel", Standing::taught, taught);
  } else {
    add("decision_parameter", Standing::taught, [](Canvas& canvas, const PixelCircle& circle) {
      bresenham_circle::decision_parameter(circle.centre, circle.radius, [&](ivec2 p) { canvas[p] = 1; });
    });
    add("late_update", Standing::faulty, [](Canvas& canvas, const PixelCircle& circle) {
      bresenham_circle::late_update(circle.centre, circle.radius, [&](ivec2 p) {
        if (canvas.contains(p)) canvas[p] = 1;
      });
    });
  }
  add("in_window", Standing::robust, [](Canvas& canvas, const PixelCircle& circle) {
    bresenham_circle::in_window(circle.centre, circle.radius, canvas.window(),
                                [&](ivec2 p) { canvas[p] = 1; });
  });
  add("draw", Standing::batch, [](Canvas& canvas, const PixelCircle& circle) {
    bresenham_circle::draw(canvas, circle.centre, circle.radius, std::uint8_t{1});
  });
#ifdef GRADUS_HAS_OPENCV
  add("OpenCV circle", Standing::peer, [](Canvas& canvas, const PixelCircle& circle) {
    cv::Mat picture(canvas.height(), canvas.width(), CV_8UC1, canvas.cells().data());
    cv::circle(picture, {circle.centre.x, circle.centre.y}, circle.radius, 1);
  });
#endif
  cases.push_back(case_of_all(
      "Cairo stroke", Standing::peer,
      [](Canvas& canvas, const std::vector<PixelCircle>& all) {
        peers::CairoPen pen(canvas);
        for (const PixelCircle& circle : all) pen.circle(circle.centre, circle.radius);
      },
      [](Canvas& canvas, const PixelCircle& circle) {
        peers::CairoPen(canvas).circle(circle.centre, circle.radius);
      },
      set, side, pixels, figures, workload));
#ifdef GRADUS_HAS_AGG
  add("AGG ellipse", Standing::peer, [](Canvas& canvas, const PixelCircle& circle) {
    peers::AggPen(canvas).circle(circle.centre, circle.radius);
  });
#endif
}

std::vector<Case> cases() {
  static std::map<std::string, std::vector<PixelCircle>> sets;
  std::vector<Case> all;
  add_cases(all, sets["all radii"] = circles(1, 510), {"all radii"}, false);
  add_cases(all, sets["radius 5 to 14"] = circles(5, 14), {"radius 5 to 14"}, false);
  add_cases(all, sets["cut by the border"] = circles(side / 4, side / 4 + side, true), {"cut by the border"},
            true);
  for (const int radius : {4, 16, 64, 256, 511}) {
    const std::string name = fmt::format("radius {}", radius);
    add_cases(all, sets[name] = circles(radius, radius), {name, static_cast<double>(radius)}, false);
  }
  return all;
}

}  // namespace

Subject bresenham_circle() {
  return {.topic = "bresenham_circle",
          .title = "Circles into a picture",
          .item = "pixel",
          .unit = "pixels",
          .measure = "radius; 100 circles per run",
          .telling = "all radii",
          .cases = cases,
          .choice = {"draw", "every pixel the nearest, in the least time"}};
}

}  // namespace gradus::bench
