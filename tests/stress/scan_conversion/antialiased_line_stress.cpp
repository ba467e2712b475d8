// The promises of antialiased lines: Wu's columns anywhere in the plane of 32-bit integers, the cone's part
// of each pixel, and the line's area in it.

#include "scan_conversion/antialiased_line/antialiased_line.hpp"

#include <fmt/format.h>

#include <map>
#include <vector>

#include "stress/scan_conversion/line_light.hpp"
#include "stress/scan_conversion/nearest_pixels.hpp"
#include "stress/scan_conversion/whole_numbers.hpp"

namespace gradus::stress {
namespace {

using namespace antialiased_line;

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
/// The ends of a line; nearly level, upright or diagonal ones among them.
Input line(Kind kind, Random& random) {
  Input input;
  for (int i = 0; i < 4; ++i) input.push_back(coordinate(kind, random));
  if (kind != Kind::near_degenerate) return input;
  const auto nearly = [&](double x) { return x + whole(random, -1, 1); };
  const std::int64_t way = random.uniform_int(0, 2);
  if (way != 1) input[3] = nearly(way == 2 ? input[1] + (input[2] - input[0]) : input[1]);
  if (way == 1) input[2] = nearly(input[0]);
  return input;
}
/// The same, and which column of it: its number as a part of the line, 0 to 1.
Input line_and_part(Kind kind, Random& random) {
  Input input = line(kind, random);
  input.push_back(random.unit());
  return input;
}
Input short_line(Kind kind, Random& random) {
  const int reach = kind == Kind::ties ? 3 : 12;
  Input input{0, 0, 0, 0};
  input[2] = whole(random, -reach, reach);
  input[3] = kind == Kind::near_degenerate ? whole(random, -1, 1) : whole(random, -reach, reach);
  return input;
}

struct Line {
  ivec2 from, to;
  std::int64_t last() const { return last_of_line(from, to); }
};
Line line_of(const Input& i) { return {pixel(i, 0), pixel(i, 2)}; }
std::pair<int, int> key(ivec2 p) { return {p.x, p.y}; }

// --- Wu

/// What a column has, without pixels that get nothing.
std::map<std::pair<int, int>, int> column(const Line& line, std::int64_t k) {
  const Pair pair = pair_at(line.from, line.to, k);
  std::map<std::pair<int, int>, int> pixels;
  if (pair.far < 255) pixels[key(pair.pixel)] = 255 - pair.far;
  if (pair.far > 0) pixels[key(pair.pixel + pair.aside)] = pair.far;
  return pixels;
}
/// How far the centre of what a column has is from the line, along the axis that does not lead.
double column_error(const Input& i) {
  if (!are_whole(i, 4) || !(0 <= i[4] && i[4] <= 1)) return 0;
  const Line line = line_of(i);
  const LineWays ways(line.from, line.to);
  const Wide length = absolute(ways.along);
  const auto at = static_cast<std::int64_t>(std::llround(i[4] * static_cast<double>(line.last())));
  double worst = 0;
  for (const std::int64_t k :
       {std::min(at, line.last()), std::int64_t{0}, line.last(), line.last() / 2, (line.last() + 1) / 2}) {
    const auto pixels = column(line, k);
    if (pixels != column({line.to, line.from}, line.last() - k)) return wrong;
    const std::int64_t forward = ways.along < 0 ? -k : k;
    Wide weighted = 0, sum = 0;
    for (const auto& [p, intensity] : pixels) {
      const Wide x = Wide{p.first} - line.from.x, y = Wide{p.second} - line.from.y;
      if ((ways.steep ? y : x) != forward) return wrong;
      weighted += intensity * (ways.steep ? x : y);
      sum += intensity;
    }
    if (sum != 255) return wrong;
    if (length == 0) return pixels.contains(key(line.from)) ? 0 : wrong;
    const Wide miss = absolute(weighted * length - 255 * ways.aside * k);
    worst = std::max(worst, static_cast<double>(miss) / (255 * static_cast<double>(length)));
  }
  return worst;
}

/// All columns of a short line, watched and not.
double steps_error(const Input& i) {
  if (!are_whole(i, 4) || line_of(i).last() > 1000) return 0;
  const Line line = line_of(i);
  std::map<std::pair<int, int>, int> plotted, unwatched, expected;
  std::int64_t k = 0;
  bool right = true;
  const auto watch = [&]<class Step>(const Step& s) {
    if constexpr (std::same_as<Step, Paired>) {
      ++k;
      right = right && s.k == k && s.near + s.far == 255 && 0 <= s.place && s.place < one &&
              s.over == (s.place < s.before || slope_of(extent(line.from, line.to)) == one);
    } else if constexpr (std::same_as<Step, Finished>) {
      right = right && s.columns == line.last() + 1 && k == line.last() / 2;
    }
  };
  const auto into = [](auto& picture) {
    return [&picture](ivec2 p, int intensity) {
      if (intensity > 0) picture[key(p)] += intensity;
    };
  };
  wu(line.from, line.to, into(plotted), watch);
  wu(line.from, line.to, into(unwatched));
  for (std::int64_t c = 0; c <= line.last(); ++c) expected.merge(column(line, c));
  return right && plotted == expected && unwatched == expected ? 0 : wrong;
}

// --- The cone

bool has_little(const Input& i) {
  return are_whole(i, 4) && line_of(i).last() <= 1000 && has_room(pixel(i, 0), pixel(i, 2));
}
/// How far the bytes of all pixels about a line are from the cone's part within it.
double cone_error(const Input& i) {
  if (!has_little(i)) return 0;
  const auto [from, to] = line_of(i);
  const LineWays ways(from, to);
  std::map<std::pair<int, int>, int> picture, backwards;
  const auto into = [](auto& all) { return [&all](ivec2 p, int intensity) { all[key(p)] += intensity; }; };
  gupta_sproull(from, to, into(picture));
  gupta_sproull(to, from, into(backwards));
  if (picture != backwards) return wrong;
  const double length =
      std::max(1.0, std::hypot(static_cast<double>(ways.along), static_cast<double>(ways.aside)));
  double worst = 0;
  std::size_t seen = 0;
  for (std::int64_t k = 0; k <= last_of_line(from, to); ++k) {
    const ivec2 middle = pixel_of_line(from, to, k);
    for (int row = -5; row <= 5; ++row) {
      const ivec2 p = middle + (ways.steep ? ivec2{row, 0} : ivec2{0, row});
      const Wide x = Wide{p.x} - from.x, y = Wide{p.y} - from.y;
      const Wide cross = absolute((Wide{to.x} - from.x) * y - (Wide{to.y} - from.y) * x);
      const double away = ways.along == 0 ? std::abs(row) : static_cast<double>(cross) / length;
      const auto found = picture.find(key(p));
      seen += found != picture.end();
      const double has = found == picture.end() ? 0 : found->second;
      worst = std::max(worst, std::abs(has - 255 * cone_looked_up(away)));
    }
  }
  return seen == picture.size() ? worst : wrong;
}

// --- The area

/// The areas of all pixels about a line against those in rationals and the root of its length.
double area_error(const Input& i) {
  if (!are_whole(i, 4) || line_of(i).last() > 40 || !has_room(pixel(i, 0), pixel(i, 2))) return 0;
  const auto [from, to] = line_of(i);
  std::map<std::pair<int, int>, double> areas;
  exact_area(from, to, [&](ivec2 p, double area) { areas[key(p - from)] += area; });
  if (from == to) return areas.empty() ? 0 : wrong;
  const ExactScope scope;
  const ExactLine exact(to - from);
  const LineWays ways(from, to);
  double worst = 0;
  std::size_t seen = 0;
  for (std::int64_t k = -1; k <= last_of_line(from, to) + 1; ++k) {
    const std::int64_t in = std::clamp<std::int64_t>(k, 0, last_of_line(from, to));
    const int beyond = static_cast<int>(ways.along < 0 ? in - k : k - in);
    const ivec2 middle =
        pixel_of_line(from, to, in) - from + (ways.steep ? ivec2{0, beyond} : ivec2{beyond, 0});
    for (int row = -4; row <= 4; ++row) {
      const ivec2 p = middle + (ways.steep ? ivec2{row, 0} : ivec2{0, row});
      const ExactScope one_pixel;
      const auto found = areas.find(key(p));
      seen += found != areas.end();
      const double has = found == areas.end() ? 0 : found->second;
      worst = std::max(worst, std::abs(has - exact.area(p).value()));
    }
  }
  return seen == areas.size() ? worst : wrong;
}
/// How far the sum of all areas is from the line's length, as a part of it.
double sum_error(const Input& i) {
  if (!has_little(i)) return 0;
  const auto [from, to] = line_of(i);
  double sum = 0;
  exact_area(from, to, [&](ivec2, double area) { sum += area; });
  const LineWays ways(from, to);
  const double length = std::hypot(static_cast<double>(ways.along), static_cast<double>(ways.aside));
  return length == 0 ? sum : std::abs(sum / length - 1);
}

using Given = std::vector<std::pair<std::string, std::string>>;
Given arguments(const Input& i) {
  return {{"from", fmt::format("{},{}", i[0], i[1])}, {"to", fmt::format("{},{}", i[2], i[3])}};
}

const std::vector<Trap> short_traps{
    {"a point", {3, 4, 3, 4}},          {"two pixels", {0, 0, 1, 0}},
    {"level", {-5, 2, 7, 2}},           {"upright", {2, 7, 2, -5}},
    {"diagonal", {0, 0, -9, 9}},        {"midway between two pixels", {0, 0, 2, 1}},
    {"a whole length", {0, 0, 12, 5}},  {"nearly level", {0, 0, 12, 1}},
    {"nearly diagonal", {0, 0, 12, 11}}};
/// The same at the border of the plane, as near to it as may be.
std::vector<Trap> traps_with_room() {
  std::vector<Trap> all = short_traps;
  all.push_back({"at the border", {INT_MAX - 3.0, INT_MIN + 3.0, INT_MAX - 13.0, INT_MIN + 8.0}});
  return all;
}
std::vector<Trap> wu_traps() {
  std::vector<Trap> all{
      {"the slope is 1 and 2^32 columns long", {INT_MIN, INT_MIN, INT_MAX, INT_MAX, 0.5}},
      {"2^32 - 1 wide and 1 high", {INT_MIN, 0, INT_MAX - 1, 1, 0.5}},
      {"the neighbour aside is not in the plane", {0, INT_MAX, 9, INT_MAX, 0.5}},
      {"2^31 additions of a slope rounded up", {INT_MIN, 0, INT_MAX, 1'431'655'765, 0.4999}}};
  for (Trap trap : short_traps) {
    trap.input.push_back(0.5);
    all.push_back(std::move(trap));
  }
  return all;
}

}  // namespace

Domain antialiased_line() {
  const std::vector<Kind> kinds{Kind::random, Kind::near_degenerate, Kind::ties, Kind::huge, Kind::extremes};
  const std::vector<Kind> few{Kind::random, Kind::near_degenerate, Kind::ties};
  return {
      "antialiased_line",
      {{.name = "wu",
        .states = "two intensities per column that add up to 255, whose centre is on the line to 1/256 + "
                  "2^-31, the same from both ends",
        .unit = "pixels",
        .bound = 1.0 / 256 + 0x1p-31,
        .numbers = 5,
        .kinds = kinds,
        .generate = line_and_part,
        .error = column_error,
        .arguments = arguments,
        .traps = wu_traps(),
        .shares = {{"is steep", 0.25,
                    [](const Input& i) { return LineWays(pixel(i, 0), pixel(i, 2)).steep; }},
                   {"is longer than 2^31", 0.1, [](const Input& i) { return line_of(i).last() > INT_MAX; }}}},
       {.name = "steps",
        .states = "every step holds, and all columns are those that are found one by one",
        .unit = "lines",
        .bound = 0,
        .numbers = 4,
        .kinds = few,
        .generate = line,
        .error = steps_error,
        .arguments = arguments,
        .traps = short_traps,
        .cases = 3'000},
       {.name = "gupta_sproull",
        .states = "each byte is within 1 of 255 times the cone's part within the line, none is left out, the "
                  "same from both ends",
        .unit = "of 255",
        .bound = 1,
        .numbers = 4,
        .kinds = few,
        .generate = line,
        .error = cone_error,
        .arguments = arguments,
        .traps = traps_with_room(),
        .cases = 1'000},
       {.name = "exact_area",
        .states = "the line's area in each pixel, against rationals and the root of its length",
        .unit = "pixels",
        .bound = 1e-14,
        .numbers = 4,
        .kinds = few,
        .generate = short_line,
        .error = area_error,
        .arguments = arguments,
        .traps = traps_with_room(),
        .cases = 100},  // of rationals
       {.name = "sum_of_areas",
        .states = "the areas add up to the line's length",
        .unit = "of it",
        .bound = 1e-12,
        .numbers = 4,
        .kinds = few,
        .generate = line,
        .error = sum_error,
        .traps = traps_with_room(),
        .cases = 1'000}}};
}

}  // namespace gradus::stress
