#pragma once
// What a topic promises, as something to attack: a generator of hard inputs, the oracle's error of an input,
// and the bound that the header's Accuracy line states. The test promises_T keeps each with seeded cases,
// gradus-stress attacks them for as long as one likes, and the fuzz driver feeds them bytes.

#include <array>
#include <cstdint>
#include <functional>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/random.hpp"

namespace gradus::stress {

/// An input as plain numbers: shrinking makes them simpler without knowing what they mean.
using Input = std::vector<double>;

/// What makes inputs hard.
enum class Kind : std::uint8_t {
  random,           ///< of all sizes
  near_degenerate,  ///< a little beside parallel, zero length, one point
  grazing,          ///< touching a corner or a rim, or missing it by a few units in the last place
  huge,
  tiny,
  ties,      ///< small whole numbers: exactly through corners and half way between pixels
  denormal,  ///< below the smallest normal number
  extremes,  ///< the largest and smallest numbers there are
  refused,   ///< NaN, infinity, inside out: what the contract refuses
};
inline constexpr std::array all_kinds{
    Kind::random, Kind::near_degenerate, Kind::grazing,  Kind::huge,   Kind::tiny,
    Kind::ties,   Kind::denormal,        Kind::extremes, Kind::refused};
constexpr std::string_view name_of(Kind kind) {
  constexpr std::string_view names[] = {"random", "near-degenerate", "grazing",  "huge",   "tiny",
                                        "ties",   "denormal",        "extremes", "refused"};
  return names[static_cast<std::size_t>(kind)];
}

/// The error of a wrong decision, of a result where there must be none, of an input that should be refused.
inline constexpr double wrong = std::numeric_limits<double>::infinity();

/// An input with a name: a trap that somebody has fallen into.
struct Trap {
  std::string name;
  Input input;
};

/// A situation that at least this share of the cases must be in: a promise that is never put to the test is
/// kept easily.
struct Share {
  std::string of;  ///< "needs exact arithmetic"
  double least = 0;
  std::function<bool(const Input&)> holds;
};

/// One promise, or a relation that always holds (its error is 0 or `wrong`).
struct Property {
  std::string name;         ///< "correctly_rounded"
  std::string states;       ///< "every end is the nearest double"
  std::string unit;         ///< of errors
  double bound = 0;         ///< the largest error that keeps the promise; infinite: measured only
  std::size_t numbers = 0;  ///< how many an input has
  std::vector<Kind> kinds{all_kinds.begin(), all_kinds.end()};
  /// An input of a kind.
  std::function<Input(Kind, Random&)> generate;
  /// The error of any numbers at all; 0 where the promise says nothing of them. Throws only what shows a
  /// fault.
  std::function<double(const Input&)> error;
  /// The flags with which `gradus figure TOPIC` draws the input; empty where it can't.
  std::function<std::vector<std::pair<std::string, std::string>>(const Input&)> arguments{};
  std::vector<Trap> traps{};
  std::vector<Share> shares{};
  std::int64_t cases = 10'000;  ///< seeded ones in every run of the tests; fewer where one takes milliseconds
};

/// A topic's promises.
struct Domain {
  std::string topic;
  std::vector<Property> properties;
};

/// Those of the program's topics, in the catalogue's order.
std::span<const Domain> domains();

}  // namespace gradus::stress
