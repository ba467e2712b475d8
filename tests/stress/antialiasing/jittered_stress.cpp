// The promises of patterns: how many samples each cell, row, column and box has, in exact arithmetic, and
// what the mean over them is.

#include "antialiasing/jittered/jittered.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <vector>

#include "antialiasing/jittered/jittered_notes.hpp"
#include "stress/numbers.hpp"

namespace gradus::stress {
namespace {

using jittered::Pattern;

constexpr double most = 4096;  // samples of a case: enough for every law, quick enough for many cases

// --- Inputs: count, seed, the pixel's column and row

double count_of_kind(Kind kind, Random& random) {
  const auto whole = [&](double from, double to) { return std::floor(random.uniform(from, to + 1)); };
  switch (kind) {
    case Kind::tiny:
      return whole(1, 9);
    case Kind::ties: {  // squares, and their neighbours
      const double root = whole(1, 20);
      return std::max(1.0, root * root + whole(-1, 1));
    }
    case Kind::extremes:  // powers of two
      return std::ldexp(1, static_cast<int>(random.uniform_int(0, 10)));
    case Kind::huge:
      return whole(1000, 2000);
    case Kind::refused:
      return random.unit() < 0.5 ? 0 : jittered::most_samples + 1;
    default:
      return whole(1, 300);
  }
}
Input pattern_input(Kind kind, Random& random) {
  const double farthest = kind == Kind::extremes ? 2147483647 : 10'000;
  const auto coordinate = [&] { return std::floor(random.uniform(-farthest, farthest + 1)); };
  const double count = count_of_kind(kind, random);
  return {count, std::floor(random.uniform(0, 1e9)), coordinate(), coordinate()};
}
bool is_whole(double x, double least, double largest) {
  return x == std::floor(x) && least <= x && x <= largest;
}
bool is_pattern_input(const Input& i) {
  const bool refused = i[0] == 0 || i[0] == jittered::most_samples + 1;
  return (refused || is_whole(i[0], 1, most)) && is_whole(i[1], 0, 1e9) &&
         is_whole(i[2], -2147483648.0, 2147483647) && is_whole(i[3], -2147483648.0, 2147483647);
}
bool is_power(double count) { return (static_cast<int>(count) & (static_cast<int>(count) - 1)) == 0; }

/// The samples; none where the pattern refuses them.
std::vector<dvec2> samples_of(Pattern pattern, const Input& i) {
  std::vector<dvec2> samples(static_cast<std::size_t>(i[0]));
  const Random random = jittered::numbers_of(static_cast<std::uint64_t>(i[1]),
                                             {static_cast<int>(i[2]), static_cast<int>(i[3])});
  try {
    jittered::put(pattern, samples, random);
    return samples;
  } catch (const ContractViolation&) {
    return {};
  }
}

// --- The oracle: which of `parts` equal parts of [0, 1) a coordinate lies in

/// The part's number; -1 outside, and on a border. fma rounds once, so its sign is that of the exact number.
int part_of(double x, int parts) {
  const double part = std::floor(x * parts);
  for (const double k : {part - 1, part, part + 1}) {
    if (k >= 0 && k < parts && std::fma(x, parts, -k) > 0 && std::fma(x, parts, -(k + 1)) < 0)
      return static_cast<int>(k);
  }
  return -1;
}

/// How many of columns x rows boxes do not have from `least` to `most_in_one` samples, and how many samples
/// lie in none.
double off_boxes(const std::vector<dvec2>& samples, int columns, int rows, int least, int most_in_one = 1) {
  std::vector<int> found(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows));
  double off = 0;
  for (const dvec2 s : samples) {
    const int x = part_of(s.x, columns), y = part_of(s.y, rows);
    if (x < 0 || y < 0) {
      ++off;
      continue;
    }
    ++found[static_cast<std::size_t>(y) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(x)];
  }
  for (const int n : found) off += n < least || n > most_in_one;
  return off;
}

/// The laws of a pattern that is not refused: `boxes_off(samples, count)`.
template <class Law>
double error_of(Pattern pattern, const Input& i, const Law& boxes_off) {
  if (!is_pattern_input(i)) return 0;
  const int count = static_cast<int>(i[0]);
  const bool taken = 1 <= count && count <= most && (pattern != Pattern::sobol || is_power(i[0]));
  const std::vector<dvec2> samples = samples_of(pattern, i);
  if (!taken) return samples.empty() ? 0 : wrong;
  if (samples.empty() || samples != samples_of(pattern, i)) return wrong;
  return boxes_off(samples, count);
}

double cells_error(const Input& i) {
  const auto law = [](const std::vector<dvec2>& samples, int count) {
    const ivec2 grid = jittered::grid_of(count);
    return off_boxes(samples, grid.x, grid.y, 1);
  };
  return error_of(Pattern::jittered, i, law) + error_of(Pattern::regular, i, law) +
         error_of(Pattern::uniform, i, [](const std::vector<dvec2>& samples, int count) {
           return off_boxes(samples, 1, 1, count, count);
         });
}
double rooks_error(const Input& i) {
  return error_of(Pattern::n_rooks, i, [](const std::vector<dvec2>& samples, int count) {
    return off_boxes(samples, count, 1, 1) + off_boxes(samples, 1, count, 1);
  });
}
/// Strips are m rows high, and the last one is what is left of them.
double correlated_error(const Input& i) {
  return error_of(Pattern::correlated_multi_jittered, i, [](const std::vector<dvec2>& samples, int count) {
    const int m = static_cast<int>(std::floor(std::sqrt(count))), n = (count + m - 1) / m;
    const bool full = m * n == count;
    double off = off_boxes(samples, 1, count, 1) + off_boxes(samples, m * n, 1, full ? 1 : 0);
    std::vector<int> cells(static_cast<std::size_t>(m * n));
    for (const dvec2 s : samples) {
      const int column = part_of(s.x, m), row = part_of(s.y, count);
      if (column < 0 || row < 0) return wrong;
      ++cells[static_cast<std::size_t>(row / m * m + column)];
    }
    for (const int found : cells) off += found > 1 || (full && found == 0);
    return off;
  });
}
double boxes_error(const Input& i) {
  return error_of(Pattern::sobol, i, [](const std::vector<dvec2>& samples, int count) {
    double off = 0;
    for (int columns = 1; columns <= count; columns *= 2)
      off += off_boxes(samples, columns, count / columns, 1);
    return off;
  });
}

/// A white scene is white by every pattern and every count; the notes' exhibits keep their own laws.
double white_error(const Input& i) {
  if (!is_pattern_input(i) || i[0] < 1 || i[0] > most) return 0;
  const ivec2 pixel(static_cast<int>(i[2]), static_cast<int>(i[3]));
  const auto white = [](auto) { return 1.0; };
  double worst = 0;
  for (const Pattern pattern : {Pattern::regular, Pattern::uniform, Pattern::jittered, Pattern::n_rooks,
                                Pattern::correlated_multi_jittered}) {
    const std::vector<dvec2> samples = samples_of(pattern, i);
    worst = std::max(worst, std::abs(jittered::sample_pixel(pixel, samples, white) - 1));
  }
  const int asked = static_cast<int>(i[0]), side = static_cast<int>(std::floor(std::sqrt(i[0])));
  const Random random = jittered::numbers_of(static_cast<std::uint64_t>(i[1]), pixel);
  const double gain = jittered::divided_by_asked(pixel, asked, random, white);
  return gain == double{1} * side * side / asked ? worst : wrong;
}

std::vector<std::pair<std::string, std::string>> arguments(const Input& i, const char* method) {
  if (!is_pattern_input(i) || i[0] < 1 || i[0] > 64 || i[1] > 1e6) return {};
  if (std::abs(i[2]) > 1000 || std::abs(i[3]) > 1000) return {};
  return {{"method", method},
          {"samples", fmt::format("{}", i[0])},
          {"seed", fmt::format("{}", i[1])},
          {"pixel", fmt::format("{},{}", i[2], i[3])}};
}

Property property(const char* name, const char* method, const char* states, double (*error)(const Input&)) {
  return {.name = name,
          .states = states,
          .unit = "boxes",
          .bound = 0,
          .numbers = 4,
          .kinds = {Kind::random, Kind::tiny, Kind::ties, Kind::huge, Kind::extremes, Kind::refused},
          .generate = pattern_input,
          .error = error,
          .arguments = [method](const Input& i) { return arguments(i, method); },
          .traps = {{"one sample", {1, 1, 0, 0}},
                    {"a prime number of samples", {13, 1, 0, 0}},
                    {"one more than a square", {17, 1, 0, 0}},
                    {"two samples", {2, 1, 3, 4}},
                    {"the last pixel of all", {16, 1, 2147483647, 2147483647}},
                    {"4096 samples", {4096, 1, 0, 0}},
                    {"no sample", {0, 1, 0, 0}},
                    {"more samples than a pattern has", {65537, 1, 0, 0}}},
          .cases = 600};
}

}  // namespace

Domain jittered() {
  Property boxes = property("boxes", "sobol", "a sample in each box of one sample's area", boxes_error);
  boxes.shares = {{"powers of two", 0.15, [](const Input& i) { return i[0] > 0 && is_power(i[0]); }}};
  boxes.traps.push_back({"no power of two", {12, 1, 0, 0}});
  boxes.traps.push_back({"1024 samples", {1024, 1, 0, 0}});
  return {"jittered",
          {property("cells", "jittered", "a sample in each cell, none on a border", cells_error),
           property("rooks", "n_rooks", "a sample in each row and each column", rooks_error),
           property("correlated", "correlated_multi_jittered",
                    "a sample in each cell, in each row and each column", correlated_error),
           boxes,
           {.name = "white",
            .states = "a white scene is white, whatever the count",
            .unit = "",
            .bound = 0,
            .numbers = 4,
            .kinds = {Kind::random, Kind::tiny, Kind::ties, Kind::huge, Kind::extremes},
            .generate = pattern_input,
            .error = white_error,
            .traps = {{"two samples, where dividing by what was asked darkens", {2, 1, 0, 0}},
                      {"three samples", {3, 1, 0, 0}},
                      {"eight samples", {8, 1, 0, 0}}},
            .cases = 600}}};
}

}  // namespace gradus::stress
