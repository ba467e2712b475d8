#pragma once
// The same exercise with other numbers: one for each student.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "stories/topic.hpp"
#include "worksheet/exercise.hpp"

namespace gradus::worksheet {

/// An input and the exercise it makes.
struct Variant {
  Arguments arguments;
  Exercise exercise;
};

/// What is looked for, and how long.
struct Search {
  std::uint64_t seed = 1;
  std::size_t wanted = 1;
  std::size_t most_rows = 12;  ///< of the table; at least 2
  Reckoning reckoning = Reckoning::by_hand;
  Wording wording{};

  /// Inputs that are tried before it is given up; as many are tried in vain.
  std::size_t tries() const { return std::min(patience, 160 + 40 * wanted); }
  std::size_t patience = SIZE_MAX;  ///< for who has little time
};

struct Variants {
  /// Fit ones, in the order in which they were found: those of fewer students are the first of more. No two
  /// have the same answers, and none those of the model.
  std::vector<Variant> found;
  std::size_t tried = 0;
  Exercise model;
  /// What the exercise depends on, in the topic's order: without numbers whose change changes nothing.
  std::vector<const Parameter*> parameters;
};

/// Inputs near `model` whose exercises are like the model's (see are_alike) and whose numbers can all be had
/// as `search` says. Where whole runs of that length are too few (circles: their radius alone decides), the
/// beginnings of longer ones serve, too: as many rows of them are asked for as of all others. There is
/// nothing to search for, and `tried` is 0, where the model's table has fewer than two rows or no blank, or
/// where no parameter that the method reads has a number to change. Cost: a run per input tried. Throws what
/// the topic throws for the model itself.
Variants variants_of(const TopicEntry& topic, const Arguments& model, const Search& search);

}  // namespace gradus::worksheet
