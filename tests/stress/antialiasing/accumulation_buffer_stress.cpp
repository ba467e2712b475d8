// The promises of the accumulation buffer: sums of up to 2^20 passes against 128-bit integers, one pass with
// as many samples bit for bit, bytes without error, places on time and lens against exact rationals.

#include "antialiasing/accumulation_buffer/accumulation_buffer.hpp"

#include <fmt/format.h>

#include <cmath>
#include <vector>

#include "core/arithmetic/exact_scalar.hpp"
#include "stress/numbers.hpp"

namespace gradus::stress {
namespace {

using namespace accumulation_buffer;

__extension__ typedef __int128 Wide;

constexpr double unit = 0x1p-53;

bool is_whole(double x, double least, double most) { return least <= x && x <= most && x == std::floor(x); }
double whole(Random& random, int least, int most) {
  return static_cast<double>(random.uniform_int(least, most));
}

// --- Sums

/// How many passes, how the values are signed (0: none below 0, 1: both, 2: they cancel), their exponent, and
/// the seed of the values.
Input passes(Kind kind, Random& random) {
  Input input{whole(random, 1, 300), whole(random, 0, 2), whole(random, -60, 60), whole(random, 0, 1 << 30)};
  if (kind == Kind::ties) input[0] = std::ldexp(1, static_cast<int>(random.uniform_int(0, 8)));
  if (kind == Kind::extremes) input[0] = whole(random, 1 << 12, 1 << 14);
  if (kind == Kind::near_degenerate) input[1] = 2;
  if (kind == Kind::huge) input[2] = 940;
  if (kind == Kind::tiny) input[2] = -1000;
  return input;
}
bool are_passes(const Input& i) {
  return is_whole(i[0], 1, most_passes) && is_whole(i[1], 0, 2) && is_whole(i[2], -1000, 940) &&
         is_whole(i[3], 0, 1 << 30);
}

/// The values as integers of up to `bits` bits, which `exponent` scales: their sum is known without rounding.
class Values {
 public:
  Values(const Input& i, int bits) : random_(static_cast<std::uint64_t>(i[3])), sign_(i[1]), bits_(bits) {}

  std::int64_t next() {
    const auto size = static_cast<int>(random_.uniform_int(1, bits_));
    std::int64_t value = random_.uniform_int(0, (std::int64_t{1} << size) - 1);
    if (sign_ == 1 && random_.unit() < 0.5) value = -value;
    // Every second value takes the one before away
    if (sign_ == 2 && last_ != 0) {
      value = -std::exchange(last_, 0);
    } else if (sign_ == 2) {
      last_ = value;
    }
    sum_ += value;
    sizes_ += value < 0 ? -value : value;
    return value;
  }
  Exact sum() const { return exact(sum_); }
  Exact sizes() const { return exact(sizes_); }

 private:
  static Exact exact(Wide x) {
    const bool negative = x < 0;
    if (negative) x = -x;
    const Exact high(static_cast<std::int64_t>(x >> 62)),
        low(static_cast<std::int64_t>(x & ((Wide{1} << 62) - 1)));
    const Exact size = high * Exact(0x1p62) + low;
    return negative ? Exact(0) - size : size;
  }

  Random random_;
  double sign_;
  int bits_;
  std::int64_t last_ = 0;
  Wide sum_ = 0, sizes_ = 0;
};

/// How far the mean is off, in (passes + 1) u times the mean of what the values are in size.
template <class Real>
double sum_error(const Input& i, int bits, int exponent, double u) {
  const auto n = static_cast<int>(i[0]);
  Values values(i, bits);
  Real mean = 0;
  const auto render = [&](double, const Sums<Real>& plot) {
    plot({0, 0}, static_cast<Real>(std::ldexp(static_cast<double>(values.next()), exponent)));
  };
  motion_blur(n, {0, 1}, render, Sums<Real>({&mean, 1}, {1, 1}));
  const ExactScope scope;
  if (to_double(values.sizes()) == 0) return mean == 0 ? 0 : wrong;
  // By parts, for doubles do not reach as far as the exponents together
  const Exact scale = Exact(std::ldexp(1.0, exponent / 2)) * Exact(std::ldexp(1.0, exponent - exponent / 2));
  const Exact off = Exact(mean) * Exact(n) / scale - values.sum();
  return std::abs(to_double(off / values.sizes())) / ((n + 1.0) * u);
}
double double_error(const Input& i) {
  if (!are_passes(i)) return 0;
  return sum_error<double>(i, 53, static_cast<int>(i[2]), unit);
}
double float_error(const Input& i) {
  if (!are_passes(i)) return 0;
  return sum_error<float>(i, 24, static_cast<int>(i[2]) / 13, 0x1p-24);
}

/// Bytes as doubles: the nearest double to the true mean, for every number of passes.
double bytes_error(const Input& i) {
  if (!are_passes(i)) return 0;
  Random random(static_cast<std::uint64_t>(i[3]));
  std::int64_t sum = 0;
  double mean = 0;
  const auto render = [&](double, const Sums<double>& plot) {
    const std::int64_t byte = i[1] == 2 ? 255 : random.uniform_int(0, 255);
    sum += byte;
    plot({0, 0}, static_cast<double>(byte));
  };
  motion_blur(static_cast<int>(i[0]), {0, 1}, render, Sums<double>({&mean, 1}, {1, 1}));
  return mean == static_cast<double>(sum) / i[0] ? 0 : wrong;
}

// --- One pass with as many samples

/// Columns and rows of places, and the seed of a picture of noise.
Input grid(Kind kind, Random& random) {
  Input input{whole(random, 1, 12), whole(random, 1, 12), whole(random, 0, 1 << 30)};
  if (kind == Kind::ties)
    for (const std::size_t k : {0U, 1U}) input[k] = std::ldexp(1, static_cast<int>(random.uniform_int(0, 4)));
  if (kind == Kind::extremes) input[random.unit() < 0.5 ? 0 : 1] = whole(random, 100, 1000);
  return input;
}
double one_pass_error(const Input& i) {
  if (!is_whole(i[0], 1, 1024) || !is_whole(i[1], 1, 1024) || !is_whole(i[2], 0, 1 << 30)) return 0;
  const ivec2 places(static_cast<int>(i[0]), static_cast<int>(i[1])), size{3, 2};
  // Noise that is a function of the place
  const Random noise(static_cast<std::uint64_t>(i[2]));
  const auto colour = [&](dvec2 p) {
    return noise.unit_at(static_cast<std::uint64_t>(p.x * 9973) * 65536 +
                         static_cast<std::uint64_t>(p.y * 7919));
  };
  std::vector<double> means(6);
  const auto render = [&](dvec2 place, const Sums<double>& plot) {
    for (int x = 0; x < size.x; ++x)
      for (int y = 0; y < size.y; ++y) plot({x, y}, colour(dvec2(x, y) + place));
  };
  accumulate(places, render, Sums<double>(means, size));
  for (std::size_t k = 0; k < means.size(); ++k) {
    const dvec2 pixel(static_cast<double>(k % 3), static_cast<double>(k / 3));
    double sum = 0;
    for (int j = 0; j < places.y; ++j)
      for (int x = 0; x < places.x; ++x)
        sum += colour(pixel + dvec2((x + 0.5) / places.x, (j + 0.5) / places.y));
    if (means[k] != sum / (places.x * places.y)) return wrong;
  }
  return 0;
}

// --- Time

/// When the shutter opens and closes, the part, and of how many.
Input shutter(Kind kind, Random& random) {
  const double n = kind == Kind::extremes ? whole(random, 1, most_passes) : whole(random, 1, 64);
  Input input{random.uniform(-10, 10), 0, std::floor(random.uniform(0, n)), n};
  input[1] = kind == Kind::near_degenerate ? nudged(input[0], random) : random.uniform(-10, 10);
  if (kind == Kind::huge) input[1] = input[0] + sized(random, 40, 60);
  if (kind == Kind::ties)
    for (const std::size_t k : {0U, 1U}) input[k] = whole(random, -8, 8);
  if (input[0] > input[1]) std::swap(input[0], input[1]);
  return input;
}
/// In 2^-53 of the larger of the two times.
double moment_error(const Input& i) {
  const bool taken = is_whole(i[3], 1, most_passes) && is_whole(i[2], 0, i[3] - 1) && i[0] <= i[1] &&
                     std::abs(i[0]) <= 0x1p100 && std::abs(i[1]) <= 0x1p100;
  const double size = std::max(std::abs(i[0]), std::abs(i[1]));
  if (!taken || size < 0x1p-100) return 0;
  const ExactScope scope;
  const double found = Shutter{i[0], i[1]}.moment(static_cast<int>(i[2]), static_cast<int>(i[3]));
  const Exact right =
      Exact(i[0]) + (Exact(i[1]) - Exact(i[0])) * (Exact(2 * i[2]) + Exact(1)) / Exact(2 * i[3]);
  return std::abs(to_double(Exact(found) - right)) / (unit * size);
}

// --- Lens

/// A point, an eye, and the depth of focus.
Input sight(Kind kind, Random& random) {
  Input input{random.uniform(-9, 9), random.uniform(-9, 9), random.uniform(0.1, 50),
              random.uniform(-2, 2), random.uniform(-2, 2), random.uniform(0.1, 50)};
  if (kind == Kind::grazing) input[5] = nudged(input[2], random);
  if (kind == Kind::huge) input[2] = std::abs(sized(random, 20, 90));
  if (kind == Kind::tiny) input[2] = std::abs(sized(random, -90, -20));
  if (kind == Kind::ties) {
    for (double& x : input) x = std::ceil(x);
    input[2] = std::max(input[2], 1.0);
    input[5] = random.unit() < 0.5 ? input[2] : std::max(input[5], 1.0);
  }
  return input;
}
bool is_sight(const Input& i) {
  for (const double x : i)
    if (!(std::abs(x) <= 0x1p100)) return false;
  return i[2] >= 0x1p-100 && i[5] >= 0x1p-100;
}
/// In 2^-53 of |point / z| + |eye| (1/focus + 1/z); wrong where what is in focus moves.
double seen_error(const Input& i) {
  if (!is_sight(i)) return 0;
  const dvec3 point{i[0], i[1], i[2]};
  const dvec2 eye{i[3], i[4]};
  const dvec3 in_focus{i[0], i[1], i[5]};
  if (seen(in_focus, eye, i[5]) != seen(in_focus, dvec2{0}, i[5])) return wrong;
  const ExactScope scope;
  const dvec2 found = seen(point, eye, i[5]);
  const auto right = seen(glm::vec<3, Exact>{Exact(i[0]), Exact(i[1]), Exact(i[2])},
                          glm::vec<2, Exact>{Exact(i[3]), Exact(i[4])}, Exact(i[5]));
  double worst = 0;
  for (const int axis : {0, 1}) {
    const double size = std::abs(point[axis] / point.z) + std::abs(eye[axis]) * (1 / i[5] + 1 / point.z);
    const double off = std::abs(to_double(Exact(found[axis]) - right[axis]));
    if (off > 0) worst = std::max(worst, size < 0x1p-900 ? 0 : off / (unit * size));
  }
  return worst;
}
/// In 2^-53 of 2 r (1/f + 1/z), against aperture |z - f| / (z f).
double confusion_error(const Input& i) {
  if (!is_sight(i)) return 0;
  const double radius = std::abs(i[3]), size = 2 * radius * (1 / i[5] + 1 / i[2]);
  if (radius < 0x1p-100) return 0;
  const ExactScope scope;
  const Exact z(i[2]), f(i[5]), off = z < f ? f - z : z - f;
  const Exact right = Exact(2) * Exact(radius) * off / (z * f);
  return std::abs(to_double(Exact(circle_of_confusion(radius, i[5], i[2])) - right)) / (unit * size);
}

Input square(Kind kind, Random& random) {
  Input input{random.uniform(-1, 1), random.uniform(-1, 1)};
  if (kind == Kind::grazing) input[1] = nudged(random.unit() < 0.5 ? input[0] : -input[0], random);
  if (kind == Kind::ties)
    for (double& x : input) x = whole(random, -2, 2) / 2;
  if (kind == Kind::tiny)
    for (double& x : input) x = sized(random, -300, -20);
  return input;
}
/// How far a place of the square comes from its own on the disc, in 2^-53 of its ring; wrong where mirrored
/// places are not mirrored.
double concentric_error(const Input& i) {
  const dvec2 p{i[0], i[1]};
  const double ring = std::max(std::abs(p.x), std::abs(p.y));
  if (!(0x1p-400 <= ring && ring <= 1)) return 0;
  const dvec2 found = concentric(p);
  const bool mirrored = concentric({-p.x, p.y}) == dvec2{-found.x, found.y} &&
                        (std::abs(p.x) == std::abs(p.y) || concentric({p.y, p.x}) == dvec2{found.y, found.x});
  if (!mirrored) return wrong;
  const long double u = p.x, v = p.y, eighth = 0.785398163397448309615660845819875721L;
  const bool wide = std::abs(p.x) > std::abs(p.y);
  const long double turn = eighth * (wide ? v / u : u / v), r = wide ? u : v;
  const long double x = r * (wide ? std::cos(turn) : std::sin(turn));
  const long double y = r * (wide ? std::sin(turn) : std::cos(turn));
  return static_cast<double>(std::max(std::abs(found.x - x), std::abs(found.y - y)) / ring) / unit;
}

}  // namespace

Domain accumulation_buffer() {
  return {
      "accumulation_buffer",
      {{.name = "sum",
        .states = "the mean of n passes is off by at most (n + 1) u times the mean of the sizes",
        .unit = "(n + 1) u",
        .bound = 1,
        .numbers = 4,
        .kinds = {Kind::random, Kind::near_degenerate, Kind::huge, Kind::tiny, Kind::ties, Kind::extremes},
        .generate = passes,
        .error = double_error,
        .traps = {{"2^20 passes", {most_passes, 0, 0, 1}},
                  {"2^20 passes of both signs", {most_passes, 1, 0, 2}},
                  {"2^20 passes that cancel", {most_passes, 2, 0, 3}},
                  {"2^20 of the largest values", {most_passes, 0, 940, 4}},
                  {"one pass", {1, 1, 0, 5}}},
        .shares = {{"has more than 4000 passes", 0.1, [](const Input& i) { return i[0] > 4000; }}},
        .cases = 2000},
       {.name = "sum_in_float",
        .states = "the same in float, with its u",
        .unit = "(n + 1) u",
        .bound = 1,
        .numbers = 4,
        .kinds = {Kind::random, Kind::near_degenerate, Kind::huge, Kind::tiny, Kind::ties, Kind::extremes},
        .generate = passes,
        .error = float_error,
        .traps = {{"2^20 passes", {most_passes, 0, 0, 1}},
                  {"2^20 passes of both signs", {most_passes, 1, 0, 2}}},
        .cases = 2000},
       {.name = "bytes",
        .states = "bytes as doubles: the correctly rounded mean",
        .unit = "means",
        .bound = 0,
        .numbers = 4,
        .kinds = {Kind::random, Kind::ties, Kind::extremes},
        .generate = passes,
        .error = bytes_error,
        .traps = {{"2^20 passes of 255", {most_passes, 2, 0, 0}}, {"four passes", {4, 0, 0, 1}}},
        .cases = 2000},
       {.name = "one_pass",
        .states = "a x b passes are one pass with a x b samples per pixel, bit for bit",
        .unit = "pictures",
        .bound = 0,
        .numbers = 3,
        .kinds = {Kind::random, Kind::ties, Kind::extremes},
        .generate = grid,
        .error = one_pass_error,
        .arguments = [](const Input& i) -> std::vector<std::pair<std::string, std::string>> {
          if (!is_whole(i[0], 1, 8) || !is_whole(i[1], 1, 8)) return {};
          return {{"a", fmt::format("{}", i[0])}, {"b", fmt::format("{}", i[1])}};
        },
        .traps = {{"one place", {1, 1, 0}}, {"thirds", {3, 3, 1}}, {"1024 x 1024", {1024, 1024, 2}}},
        .cases = 500},
       {.name = "moment",
        .states = "the middle of a part of the shutter's time, to 6 u of the larger time",
        .unit = "u",
        .bound = 6,
        .numbers = 4,
        .kinds = {Kind::random, Kind::near_degenerate, Kind::huge, Kind::ties, Kind::extremes},
        .generate = shutter,
        .error = moment_error,
        .traps = {{"thirds", {0, 1, 1, 3}}, {"no time", {2, 2, 1, 3}}}},
       {.name = "seen",
        .states = "5 u of exact rationals; what is in focus keeps its place from every eye, bit for bit",
        .unit = "u",
        .bound = 5,
        .numbers = 6,
        .kinds = {Kind::random, Kind::grazing, Kind::huge, Kind::tiny, Kind::ties},
        .generate = sight,
        .error = seen_error,
        .traps = {{"at the focus", {1, 2, 3, 0.5, 0.25, 3}},
                  {"a thirtieth beside it", {1, 2, 3, 0.5, 0.25, 3.1}}}},
       {.name = "circle_of_confusion",
        .states = "aperture |z - f| / (z f) to 4 u of aperture (1/f + 1/z)",
        .unit = "u",
        .bound = 4,
        .numbers = 6,
        .kinds = {Kind::random, Kind::grazing, Kind::huge, Kind::tiny, Kind::ties},
        .generate = sight,
        .error = confusion_error,
        .traps = {{"at the focus", {1, 2, 3, 0.5, 0.25, 3}}}},
       {.name = "concentric",
        .states = "a square's places on the disc to 4 u of their ring, mirrored bit for bit",
        .unit = "u",
        .bound = 4,
        .numbers = 2,
        .kinds = {Kind::random, Kind::grazing, Kind::tiny, Kind::ties},
        .generate = square,
        .error = concentric_error,
        .traps = {{"the corner", {1, 1}}, {"on a diagonal", {-0.5, 0.5}}}}}};
}

}  // namespace gradus::stress
