// The promises of lines: the nearest pixel in every column, anywhere in the plane of 32-bit integers, and the
// same pixels by every method.

#include "scan_conversion/bresenham_line/bresenham_line.hpp"

#include <fmt/format.h>

#include <vector>

#include "core/arithmetic/exact_scalar.hpp"
#include "scan_conversion/bresenham_line/bresenham_line_batch.hpp"
#include "scan_conversion/bresenham_line/bresenham_line_window.hpp"
#include "stress/scan_conversion/nearest_pixels.hpp"
#include "stress/scan_conversion/whole_numbers.hpp"

namespace gradus::stress {
namespace {

using namespace bresenham_line;
using Pixels = std::vector<ivec2>;

double coordinate(Kind kind, Random& random) {
  switch (kind) {
    case Kind::huge:
      return whole(random, INT_MIN, INT_MAX);
    case Kind::extremes: {
      const double some[] = {INT_MIN, INT_MIN + 1.0, INT_MAX, INT_MAX - 1, -1, 0, 1, 1'500'000'000};
      return some[random.uniform_int(0, 7)];
    }
    case Kind::ties:
      return whole(random, -4, 4);
    default:
      return whole(random, -300, 300);
  }
}

/// The ends of a line.
Input line(Kind kind, Random& random) {
  Input input;
  for (int i = 0; i < 4; ++i) input.push_back(coordinate(kind, random));
  const bool large = kind == Kind::huge || kind == Kind::extremes;
  if (kind == Kind::near_degenerate) {
    // Nearly level, upright or diagonal
    const auto nearly = [&](double x) { return x + whole(random, -1, 1); };
    const std::int64_t way = random.uniform_int(0, 2);
    if (way != 1) input[3] = nearly(way == 2 ? input[1] + (input[2] - input[0]) : input[1]);
    if (way == 1) input[2] = nearly(input[0]);
  } else if (large && random.unit() < 0.3) {
    // Few runs
    input[3] = bounded(std::llround(input[1] + whole(random, -150, 150)));
  } else if (large && random.unit() < 0.2) {
    // A tie in the middle
    input[2] = static_cast<int>(input[0]) ^ 2, input[3] = input[1];
  }
  return input;
}
/// The same, and which pixel of it: its number as a part of the line, 0 to 1.
Input line_and_part(Kind kind, Random& random) {
  Input input = line(kind, random);
  input.push_back(random.unit());
  return input;
}

struct Line {
  ivec2 from, to;

  std::int64_t last() const { return last_of_line(from, to); }
  ivec2 exact(std::int64_t k) const { return pixel_of_line(from, to, k); }
  /// The pixel that lies at this part of the line.
  std::int64_t at(double part) const {
    return std::min(last(), static_cast<std::int64_t>(std::llround(part * static_cast<double>(last()))));
  }
};
Line line_of(const Input& i) { return {pixel(i, 0), pixel(i, 2)}; }
bool has_part(const Input& i) { return are_whole(i, 4) && 0 <= i[4] && i[4] <= 1; }

/// The pixel of a part of the line, and those at its ends and in its middle; the distance of the first.
double pixel_error(const Input& i) {
  if (!has_part(i)) return 0;
  const Line line = line_of(i);
  const auto& [from, to] = line;
  const std::int64_t last = line.last(), at = line.at(i[4]);
  if (pixel_count(from, to) != last + 1) return wrong;
  for (const std::int64_t k : {at, std::int64_t{0}, last, last / 2, (last + 1) / 2}) {
    const ivec2 p = pixel_at(from, to, k);
    if (p != line.exact(k) || p != pixel_at(to, from, last - k)) return wrong;
  }
  return off_line(from, to, line.exact(at));
}

void add_run(Pixels& pixels, const Line& line, ivec2 start, std::int64_t count) {
  for (std::int64_t j = 0; j < count; ++j) pixels.push_back(place(start, moves(line.from, line.to), j, 0));
}

/// A line, a pixel of it, and how far a window reaches to the left of it, down, right and up.
Input line_and_window(Kind kind, Random& random) {
  Input input = line_and_part(kind, random);
  for (int i = 0; i < 4; ++i) input.push_back(whole(random, -3, 12));
  return input;
}
Window window_of(const Input& i) {
  const Line line = line_of(i);
  const ivec2 middle = line.exact(line.at(i[4]));
  const auto beside = [](int x, double by) { return bounded(x + std::llround(by)); };
  return {{beside(middle.x, -i[5]), beside(middle.y, -i[6])},
          {beside(middle.x, i[7]), beside(middle.y, i[8])}};
}
bool has_window(const Input& i) {
  return has_part(i) && std::all_of(i.begin() + 5, i.end(), [](double x) { return is_whole(x, -20, 20); });
}

/// Watches a whole line: its grammar, its recurrence, and that p is the exact line's height above the middle
/// of the two candidates, times 2 dx.
struct Watch {
  Line line;
  Pixels& plotted;
  std::int64_t dx = extent(line.from, line.to).dx, dy = extent(line.from, line.to).dy, k = 0;
  enum { before, between, in_step, after } phase = before;
  bool right = true;

  void want(bool holds) { right = right && holds; }
  /// dx times the height above the line, up to the sign, of the pixel that a move leads to
  /// (which may lie beyond the plane).
  Wide above(ivec2 pixel, ivec2 move) const {
    const auto& [from, to] = line;
    const Wide x = Wide{pixel.x} + move.x - from.x, y = Wide{pixel.y} + move.y - from.y;
    return (Wide{to.x} - from.x) * y - (Wide{to.y} - from.y) * x;
  }
  void operator()(const Started& s) {
    want(phase == before && plotted.empty() && s.p == 2 * dy - dx);
    phase = between;
  }
  void operator()(const Jumped& j) {
    want(phase == between && plotted.empty() && j.pixel == line.exact(j.shown.first));
    k = j.shown.first;
  }
  void operator()(const Compared& c) {
    want(phase == between && c.pixel == plotted.back());
    phase = in_step;
    const auto [straight, diagonal, tie] = c.moves;
    const Wide near = above(c.pixel, straight), far = above(c.pixel, diagonal);
    want(c.p == (far > near ? -near - far : near + far) && 2 * (dy - dx) <= c.p && c.p <= 2 * dy);
    // They differ in one coordinate; midway the smaller one wins
    const bool low = straight.x + straight.y < diagonal.x + diagonal.y;
    want(tie == low && c.straight == (c.p < 0 || (c.p == 0 && low)));
  }
  void operator()(const Stepped& s) {
    want(phase == in_step && s.from == plotted.back() && s.pixel == line.exact(++k));
    phase = between;
    want(s.p - s.p_before == (s.straight ? 2 * dy : 2 * (dy - dx)));
  }
  void operator()(const Finished& f) {
    want(phase == between && f.pixels == static_cast<std::int64_t>(plotted.size()));
    phase = after;
  }
};

double window_error(const Input& i) {
  if (!has_window(i)) return 0;
  const Line line = line_of(i);
  const Window window = window_of(i);
  Pixels expected, shown, runs;
  const std::int64_t middle = line.at(i[4]);
  for (std::int64_t k = std::max<std::int64_t>(0, middle - 60); k <= std::min(line.last(), middle + 60);
       ++k) {
    if (window.contains(line.exact(k))) expected.push_back(line.exact(k));
  }
  Watch watch{line, shown};
  in_window(line.from, line.to, window, [&](ivec2 p) { shown.push_back(p); }, watch);
  run_length_in_window(line.from, line.to, window,
                       [&](ivec2 start, std::int64_t count) { add_run(runs, line, start, count); });
  const Stretch stretch = visible(line.from, line.to, window);
  const auto count = static_cast<std::int64_t>(expected.size());
  const bool counted = std::max<std::int64_t>(0, stretch.last - stretch.first + 1) == count &&
                       (count == 0 || line.exact(stretch.first) == expected.front());
  return watch.right && watch.phase == Watch::after && shown == expected && runs == expected && counted
             ? 0
             : wrong;
}

/// All pixels of a short line, watched and not, and of its runs.
double steps_error(const Input& i) {
  if (!are_whole(i, 4) || line_of(i).last() > 3000) return 0;
  const Line line = line_of(i);
  Pixels pixels, unobserved, runs;
  Watch watch{line, pixels};
  decision_parameter(line.from, line.to, [&](ivec2 p) { pixels.push_back(p); }, watch);
  decision_parameter(line.from, line.to, [&](ivec2 p) { unobserved.push_back(p); });
  run_length(line.from, line.to, [&](ivec2 start, std::int64_t count) { add_run(runs, line, start, count); });
  const bool whole = pixels.front() == line.from && pixels.back() == line.to &&
                     static_cast<std::int64_t>(pixels.size()) == line.last() + 1;
  return watch.right && watch.phase == Watch::after && whole && pixels == unobserved && pixels == runs
             ? 0
             : wrong;
}

/// The first and the last pixel of every run, of lines that have few.
double runs_error(const Input& i) {
  if (!are_whole(i, 4)) return 0;
  const Line line = line_of(i);
  if (extent(line.from, line.to).dy > 300) return 0;
  std::int64_t k = 0;
  bool right = true;
  run_length(line.from, line.to, [&](ivec2 start, std::int64_t count) {
    right = right && count > 0 && start == line.exact(k) &&
            place(start, moves(line.from, line.to), count - 1, 0) == line.exact(k + count - 1);
    k += count;
  });
  return right && k == line.last() + 1 ? 0 : wrong;
}

/// A line and the size of a raster; most lines of moderate size pass near it.
Input line_and_raster(Kind kind, Random& random) {
  Input input = line(kind, random);
  if ((kind == Kind::random || kind == Kind::near_degenerate) && random.unit() < 0.8) {
    for (double& x : input) x = std::trunc(x / 6) + 15;
  }
  input.push_back(whole(random, 0, 40));
  input.push_back(whole(random, 1, 30));
  return input;
}
double drawing_error(const Input& i) {
  if (!are_whole(i, 4) || !is_whole(i[4], 0, 64) || !is_whole(i[5], 0, 64)) return 0;
  const Line line = line_of(i);
  const ivec2 size = pixel(i, 4);
  Raster<std::uint8_t> raster(size.x, size.y);
  draw(raster, line.from, line.to, std::uint8_t{1});
  double error = 0;
  for (int y = 0; y < size.y; ++y) {
    for (int x = 0; x < size.x; ++x) error += (raster[{x, y}] == 1) != on_line(line.from, line.to, {x, y});
  }
  return error;
}
bool is_cut(const Input& i) {
  const Window window{{0, 0}, {static_cast<int>(i[4]) - 1, static_cast<int>(i[5]) - 1}};
  const Line line = line_of(i);
  const Stretch shown = visible(line.from, line.to, window);
  return shown.first <= shown.last && shown.last - shown.first < line.last();
}

// --- The rival with fractions ---

bool takes_dda(const Input& i, std::int64_t longest) {
  return are_whole(i, 4) && line_of(i).last() <= longest && room_to_stray(pixel(i, 0), pixel(i, 2));
}
/// Rationals stay on the line.
double exact_dda_error(const Input& i) {
  if (!takes_dda(i, 1000)) return 0;
  const Line line = line_of(i);
  const ExactScope scope;
  std::int64_t k = 0;
  bool right = true;
  dda<Exact>(line.from, line.to, [&](ivec2 p) { right = p == line.exact(k++) && right; });
  return right && k == line.last() + 1 ? 0 : wrong;
}
/// Pixel k is off by no more than 1/2 + e k (k + 3): the largest part of that.
template <class T>
double drift(const Line& line) {
  constexpr double e = std::numeric_limits<T>::epsilon() / 2.0;
  double k = 0, worst = 0;
  dda<T>(line.from, line.to, [&](ivec2 p) {
    worst = std::max(worst, off_line(line.from, line.to, p) / (0.5 + e * k * (k + 3)));
    ++k;
  });
  return worst;
}
double dda_error(const Input& i) {
  return takes_dda(i, 100'000) ? std::max(drift<float>(line_of(i)), drift<double>(line_of(i))) : 0;
}
bool goes_astray(const Input& i) {
  std::int64_t k = 0;
  bool astray = false;
  const Line line = line_of(i);
  dda<float>(line.from, line.to, [&](ivec2 p) { astray = p != line.exact(k++) || astray; });
  return astray;
}
Input short_line(Kind, Random& random) {
  Input input(4);
  for (double& x : input) x = whole(random, -50, 50);
  return input;
}
Input long_line(Kind kind, Random& random) {
  if (kind == Kind::random) return line(kind, random);
  const std::int64_t dx = random.uniform_int(3, 60'000);
  return {0, 0, static_cast<double>(dx), whole(random, 0, dx)};
}

using Arguments = std::vector<std::pair<std::string, std::string>>;
Arguments arguments(const Input& i) {
  return {{"from", fmt::format("{},{}", i[0], i[1])}, {"to", fmt::format("{},{}", i[2], i[3])}};
}

/// Traps with more numbers behind them.
std::vector<Trap> traps(const Input& more, bool with_part = true) {
  std::vector<Trap> all{{"2 dy - 2 dx wraps", {0, 0, 1'500'000'000, 1'200'000'000, 0.7}},
                        {"dy = 0 and the increment wraps", {0, 0, 1'500'000'000, 0, 0.9}},
                        {"dx wraps", {-1'500'000'000, 0, 1'500'000'000, 1'000'000, 0.5}},
                        {"p is 1", {0, 0, 2'147'483'647, 1'073'741'824, 1}},
                        {"zero length", {3, 4, 3, 4, 0}},
                        {"the most negative integer", {INT_MIN, INT_MIN, INT_MAX, INT_MAX, 0.5}},
                        {"half way between two pixels", {0, 0, 2, 1, 0.5}},
                        {"a line 2^32 - 1 wide and 1 high", {INT_MIN, 0, INT_MAX - 1, 1, 0.5}},
                        {"91 million pixels to jump over", {91'618'510, -54'756'195, 262, 23, 1}}};
  for (Trap& trap : all) {
    if (!with_part) trap.input.pop_back();
    trap.input.insert(trap.input.end(), more.begin(), more.end());
  }
  return all;
}

}  // namespace

Domain bresenham_line() {
  const std::vector<Kind> kinds{Kind::random, Kind::near_degenerate, Kind::ties, Kind::huge, Kind::extremes};
  const auto tie_in_the_middle = [](const Input& i) {
    const auto [dx, dy] = extent(pixel(i, 0), pixel(i, 2));
    return dx > 0 && dx % 2 == 0 && dy % 2 == 1;
  };
  return {
      "bresenham_line",
      {{.name = "pixel_at",
        .states = "the pixel of each column is the nearest to the line, midway the smaller coordinate, from "
                  "both ends",
        .unit = "pixels",
        .bound = 0.5,
        .numbers = 5,
        .kinds = kinds,
        .generate = line_and_part,
        .error = pixel_error,
        .arguments = arguments,
        .traps = traps({}),
        .shares = {{"has a tie in its middle", 0.1, tie_in_the_middle},
                   {"is steep", 0.25, [](const Input& i) { return steep(pixel(i, 0), pixel(i, 2)); }},
                   {"is longer than 2^31", 0.1, [](const Input& i) { return line_of(i).last() > INT_MAX; }}}},
       {.name = "in_window",
        .states =
            "the pixels of the whole line that lie in the window, in their order, step by step and by runs",
        .unit = "pixels",
        .bound = 0,
        .numbers = 9,
        .kinds = kinds,
        .generate = line_and_window,
        .error = window_error,
        .traps = traps({2, 2, 2, 2}),
        .shares = {{"nothing is shown", 0.01,
                    [](const Input& i) {
                      const Stretch shown = visible(pixel(i, 0), pixel(i, 2), window_of(i));
                      return shown.last < shown.first;
                    }}},
        .cases = 40'000},
       {.name = "steps",
        .states = "every step holds, and runs and unwatched lines have the same pixels",
        .unit = "lines",
        .bound = 0,
        .numbers = 4,
        .kinds = {Kind::random, Kind::near_degenerate, Kind::ties},
        .generate = line,
        .error = steps_error,
        .arguments = arguments,
        .traps = {{"zero length", {3, 4, 3, 4}}, {"half way between two pixels", {0, 0, 2, 1}}}},
       {.name = "runs",
        .states = "each run begins and ends on the line's pixels, of any length",
        .unit = "lines",
        .bound = 0,
        .numbers = 4,
        .kinds = kinds,
        .generate = line,
        .error = runs_error,
        .traps = traps({}, false)},
       {.name = "drawing",
        .states = "the cells of a raster that are pixels of the line",
        .unit = "cells",
        .bound = 0,
        .numbers = 6,
        .kinds = kinds,
        .generate = line_and_raster,
        .error = drawing_error,
        .traps = traps({40, 30}, false),
        .shares = {{"the raster's border cuts the line", 0.15, is_cut}},
        .cases = 20'000},
       {.name = "exact_dda",
        .states = "adding the slope as a rational gives the line's pixels",
        .unit = "lines",
        .bound = 0,
        .numbers = 4,
        .kinds = {Kind::random},
        .generate = short_line,
        .error = exact_dda_error,
        .cases = 2'000},  // of rationals
       {.name = "dda",
        .states = "adding the slope in float or double, pixel k is off by 1/2 + e k (k + 3) at most",
        .unit = "of that",
        .bound = 1,
        .numbers = 4,
        .kinds = {Kind::random, Kind::huge},
        .generate = long_line,
        .error = dda_error,
        .shares = {{"goes astray in float", 0.2, goes_astray}},
        .cases = 1'000}}};  // of up to 60,000 pixels
}

}  // namespace gradus::stress
