// What sampling promises: the alias exactly, the wheel's direction always, and back every curve that samples
// tell.

#include "antialiasing/sampling_theorem/sampling_theorem.hpp"

#include <fmt/format.h>

#include <cmath>
#include <vector>

#include "stress/numbers.hpp"

namespace gradus::stress {
namespace {

using namespace sampling_theorem;

/// Rationals of numbers so far apart have quotients beyond 64 bits.
constexpr double largest_quotient = 0x1p61;

bool is_rate(double fs) { return std::isfinite(fs) && fs > 0; }

// --- The alias: f, fs

Input two_rates(Kind kind, Random& random) {
  const double f = number(kind, random), fs = std::abs(number(kind, random));
  if (kind == Kind::grazing) {
    // About the middle between two multiples
    return {nudged(fs * (static_cast<double>(random.uniform_int(-4, 4)) + 0.5), random), fs};
  }
  return {f, fs};
}

double alias_error(const Input& i) {
  const double f = i[0], fs = i[1];
  if (!std::isfinite(f) || !is_rate(fs)) return 0;
  const double found = alias_of(f, fs);
  if (!(std::abs(f) / fs < largest_quotient)) return 2 * std::abs(found) <= fs ? 0 : wrong;
  ExactScope scope;
  return alias_of(Exact(f), Exact(fs)) == Exact(found) ? 0 : wrong;
}

// --- The wheel: revolutions, frames, spokes

Input wheel(Kind kind, Random& random) {
  const auto n = static_cast<double>(random.uniform_int(1, 100));
  Input two = two_rates(kind, random);
  // About half a spoke's distance per frame
  if (kind == Kind::near_degenerate)
    two[0] = nudged(two[1] * (static_cast<double>(random.uniform_int(-9, 9)) + 0.5) / n, random);
  return {two[0], two[1], n};
}

/// In units of 2^-53 of frames / spokes.
double wheel_error(const Input& i) {
  const double f = i[0], fps = i[1], n = i[2];
  const bool known = std::isfinite(f) && is_rate(fps) && 0x1p-900 <= fps && fps <= 0x1p900 && 1 <= n &&
                     n <= 0x1p30 && n == std::floor(n) && std::abs(f) / fps * n < largest_quotient &&
                     (f == 0 || std::abs(f) >= 0x1p-900);
  if (!known) return 0;
  const auto spokes = static_cast<std::int64_t>(n);
  const double found = apparent_speed(f, fps, spokes);
  ExactScope scope;
  const Exact right = apparent_speed(Exact(f), Exact(fps), spokes);
  if (sign(right) != (found > 0) - (found < 0)) return wrong;
  return to_double(size(Exact(found) - right) * Exact(n) / Exact(fps)) * 0x1p53;
}

// --- The curve: samples in a period, cycles in it, phase, place

Input curve(Kind kind, Random& random) {
  const double n = static_cast<double>(random.uniform_int(1, 64));
  const double cycles =
      kind == Kind::ties ? std::floor(n / 2) : static_cast<double>(random.uniform_int(0, 200));
  double x = random.uniform(0, n);
  if (kind == Kind::grazing) x = std::clamp(nudged(std::floor(x), random), 0.0, n);
  if (kind == Kind::tiny) x = std::abs(sized(random, -1074, -20));
  return {n, cycles, kind == Kind::ties ? 0 : random.uniform(0, 1), x};
}

/// What comes back is the curve of the alias; at exactly half the rate what the samples have of it. In units
/// of n 2^-48.
double curve_error(const Input& i) {
  const double n = i[0], cycles = i[1], phase = i[2], x = i[3];
  const bool known = 1 <= n && n <= 64 && n == std::floor(n) && 0 <= cycles && cycles <= 200 &&
                     cycles == std::floor(cycles) && 0 <= phase && phase <= 1 && 0 <= x && x <= n;
  if (!known) return 0;
  std::vector<double> samples(static_cast<std::size_t>(n));
  const auto wave = [&](double t) {
    // Whole cycles are taken away before anything is rounded
    const double turns = std::remainder(cycles * std::round(t * n), n) / n;
    return sin_cos_half_turns(2 * (turns + phase)).sin;
  };
  sample(wave, n, std::span(samples));
  const double found = reconstruct(std::span<const double>(samples), x, Dirichlet{std::ssize(samples)});
  const long double pi = 3.14159265358979323846264338327950288L, alias = alias_of(cycles, n);
  long double right = std::sin(2 * pi * (alias * x / n + phase));
  if (2 * alias == n) right = std::sin(2 * pi * phase) * std::cos(pi * x);
  return static_cast<double>(std::abs(found - right)) / (n * 0x1p-48);
}

std::vector<std::pair<std::string, std::string>> wheel_arguments(const Input& i) {
  const bool drawn = std::abs(i[0]) <= 200 && 1 <= i[1] && i[1] <= 200 && 1 <= i[2] && i[2] <= 24 &&
                     i[2] == std::floor(i[2]) && std::abs(i[0]) > 1e-3;
  if (!drawn) return {};
  return {{"method", "wagon_wheel"},
          {"revolutions", fmt::format("{}", i[0])},
          {"frames", fmt::format("{}", i[1])},
          {"spokes", fmt::format("{}", i[2])}};
}

}  // namespace

Domain sampling_theorem() {
  return {"sampling_theorem",
          {{.name = "alias",
            .states = "the frequency nearest to 0 that has the same samples, exactly",
            .unit = "wrong results",
            .bound = 0,
            .numbers = 2,
            .generate = two_rates,
            .error = alias_error,
            .traps = {{"exactly half the rate", {5, 10}},
                      {"half the rate, backwards", {-5, 10}},
                      {"one rounding above half the rate", {5.000000000000001, 10}},
                      {"a tenth and three", {0.1, 0.3}},
                      {"huge against the rate", {1e300, 3}},
                      {"the smallest numbers", {1.5e-323, 1e-323}}}},
           {.name = "wheel",
            .states = "the direction is right, and the speed within 2 roundings of frames / spokes",
            .unit = "2^-53 of frames / spokes",
            .bound = 2,
            .numbers = 3,
            .generate = wheel,
            .error = wheel_error,
            .arguments = wheel_arguments,
            .traps = {{"30 revolutions at 24 frames", {30, 24, 1}},
                      {"eight spokes at 2", {2, 24, 8}},
                      {"half a spoke per frame", {1.5, 24, 8}},
                      {"a product that is rounded to the middle", {1.1666666666666667, 7, 3}}}},
           {.name = "curve",
            .states = "back comes the sine of the alias: below half the rate the signal itself",
            .unit = "n 2^-48 of the size",
            .bound = 1,
            .numbers = 4,
            .kinds = {Kind::random, Kind::grazing, Kind::tiny, Kind::ties},
            .generate = curve,
            .error = curve_error,
            .traps = {{"exactly half the rate at phase 0", {10, 5, 0, 0.5}},
                      {"9 Hz at 10", {10, 9, 0, 2.5}},
                      {"one sample", {1, 7, 0.25, 0.5}},
                      {"beside a sample", {12, 5, 0.1, 3.0000000000000004}},
                      {"the smallest place", {3, 1, 0.125, 5e-324}}}}}};
}

}  // namespace gradus::stress
