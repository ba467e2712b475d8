#include "stress/attack.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>

namespace gradus::stress {
namespace {

/// A number of its own for each name, the same everywhere (FNV-1a).
std::uint64_t number_of(std::string_view name) {
  std::uint64_t hash = 0xcbf29ce484222325;
  for (const char c : name) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3;
  return hash;
}

/// What a number might be replaced by, the simplest first.
std::vector<double> simpler(double x) {
  std::vector<double> candidates{0, 1, -1};
  if (!std::isfinite(x)) return candidates;
  candidates.push_back(std::round(x));
  // Fewer digits
  int exponent = 0;
  const double mantissa = std::frexp(x, &exponent);
  for (const int bits : {1, 2, 4, 8, 16, 24, 32, 40, 48}) {
    candidates.push_back(std::ldexp(std::round(std::ldexp(mantissa, bits)), exponent - bits));
  }
  // A smaller exponent
  for (const int part : {2, 4, 8}) candidates.push_back(std::ldexp(mantissa, exponent - exponent / part));
  return candidates;
}

/// Fewer digits and smaller exponents are simpler.
int complexity(double x) {
  if (x == 0) return 0;
  if (!std::isfinite(x)) return 1;
  int exponent = 0;
  double mantissa = std::abs(std::frexp(x, &exponent));
  int bits = 0;
  for (; mantissa != 0; ++bits) mantissa = 2 * mantissa - std::floor(2 * mantissa);
  return 2 + bits + std::abs(exponent) / 4 + (x < 0 ? 1 : 0);
}

}  // namespace

Finding attack(const Property& property, std::uint64_t seed, const std::function<bool(std::uint64_t)>& more) {
  Finding finding;
  finding.property = &property;
  const auto look_at = [&](Input input, const std::function<std::string()>& origin) {
    const double error = property.error(input);
    ++finding.cases;
    // A NaN is as wrong as can be
    if (error <= finding.worst) return;
    finding.worst = std::isnan(error) ? wrong : error;
    finding.input = std::move(input);
    finding.origin = origin();
  };
  for (const Trap& trap : property.traps) {
    look_at(trap.input, [&] { return trap.name; });
  }
  const std::uint64_t stream = number_of(property.name);
  finding.by_share.resize(property.shares.size());
  for (std::uint64_t i = 0; more(i) && !std::isinf(finding.worst); ++i) {
    const Kind kind = property.kinds[i % property.kinds.size()];
    Random random(seed, stream);
    random.seek(i << 8);
    ++finding.by_kind[kind];
    Input input = property.generate(kind, random);
    for (std::size_t s = 0; s < property.shares.size(); ++s) {
      finding.by_share[s] += property.shares[s].holds(input) ? 1u : 0u;
    }
    look_at(std::move(input), [&] { return fmt::format("{}, case {}", name_of(kind), i); });
  }
  return finding;
}

Input shrunk(const Property& property, Input input, double least) {
  for (bool changed = true; changed;) {
    changed = false;
    for (double& x : input) {
      const double before = x;
      for (const double candidate : simpler(before)) {
        if (complexity(candidate) >= complexity(before)) continue;
        x = candidate;
        if (property.error(input) >= least) break;
        x = before;
      }
      changed |= x != before && !(std::isnan(x) && std::isnan(before));
    }
  }
  return input;
}

std::string text_of(const Input& input) {
  std::string text;
  for (const double x : input) text += fmt::format("{}{:a}", text.empty() ? "" : ",", x);
  return text;
}

std::optional<Input> input_in(std::string_view text) {
  Input input;
  std::string rest(text);
  const char* at = rest.c_str();
  for (;;) {
    char* end = nullptr;
    input.push_back(std::strtod(at, &end));
    if (end == at) return std::nullopt;
    if (*end == '\0') return input;
    if (*end != ',') return std::nullopt;
    at = end + 1;
  }
}

}  // namespace gradus::stress
