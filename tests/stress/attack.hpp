#pragma once
// Attacks promises: generates, measures, and makes the worst input small.

#include <functional>
#include <map>
#include <optional>

#include "stress/domain.hpp"

namespace gradus::stress {

/// What an attack on a property has found.
struct Finding {
  const Property* property = nullptr;
  std::uint64_t cases = 0;
  std::map<Kind, std::uint64_t> by_kind;
  std::vector<std::uint64_t> by_share;  ///< generated cases in each of the property's shares
  double worst = 0;
  Input input;         ///< with the worst error; empty when every error was 0
  std::string origin;  ///< "grazing, case 1234", or a trap's name
  bool broken() const { return worst > property->bound; }
};

/// Attacks a property with its traps and then so many cases, kinds in turn. Case i is a pure function of the
/// seed, the property's name and i. `more` is asked before each case.
Finding attack(const Property& property, std::uint64_t seed, const std::function<bool(std::uint64_t)>& more);

/// A simpler input whose error is still above `least`: numbers are replaced by 0, by whole numbers, and by
/// ones with fewer digits and smaller exponents, as long as that goes. Deterministic.
Input shrunk(const Property& property, Input input, double least);

/// The numbers as text that reads back to the same bits, "-0x1.8p+3,0".
std::string text_of(const Input& input);
/// Nothing for a text that is no list of numbers; "nan" and "inf" are numbers here.
std::optional<Input> input_in(std::string_view text);

}  // namespace gradus::stress
