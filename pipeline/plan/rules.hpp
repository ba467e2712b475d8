#pragma once
// By what rules work is left out. None of them changes a pixel: each only finds sooner what a later stage
// would find anyway.

#include <array>
#include <bitset>
#include <cstddef>
#include <string_view>

namespace gradus::pipeline {

/// Why work can be left out.
enum class Rule {
  outside,  ///< the object lies wholly beyond a side of the picture, before its near or behind its far plane
  area_of_interest,  ///< it lies wholly beside the part of the picture that is asked for
  hidden,            ///< it lies wholly behind nearer faces
  inside,            ///< it lies wholly between the planes: nothing of it is cut
  out_of_range,      ///< the light's range ends before the object
  no_highlight,      ///< k_s = 0: the material has no highlight
  unchanged,         ///< of a film's frames: nothing has changed since the one before
};

inline constexpr std::size_t rule_count = 7;
inline constexpr std::array<Rule, rule_count> all_rules{
    Rule::outside,      Rule::area_of_interest, Rule::hidden,   Rule::inside,
    Rule::out_of_range, Rule::no_highlight,     Rule::unchanged};
/// As the command spells them, in the order of the enumeration.
inline constexpr std::array<std::string_view, rule_count> rule_names{
    "outside", "area_of_interest", "hidden", "inside", "out_of_range", "no_highlight", "unchanged"};

inline constexpr std::string_view name_of(Rule rule) { return rule_names[static_cast<std::size_t>(rule)]; }

/// Some of them.
class Rules {
 public:
  static Rules all() { return Rules(std::bitset<rule_count>().set()); }
  static Rules none() { return Rules({}); }

  bool has(Rule rule) const { return set_[static_cast<std::size_t>(rule)]; }
  Rules without(Rule rule) const {
    Rules rest = *this;
    rest.set_.reset(static_cast<std::size_t>(rule));
    return rest;
  }
  Rules with(Rule rule) const {
    Rules more = *this;
    more.set_.set(static_cast<std::size_t>(rule));
    return more;
  }

 private:
  explicit Rules(std::bitset<rule_count> set) : set_(set) {}

  std::bitset<rule_count> set_;
};

}  // namespace gradus::pipeline
