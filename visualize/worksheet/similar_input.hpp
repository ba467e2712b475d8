#pragma once
// Inputs like another one: what a second student is given.

#include <optional>
#include <string>
#include <vector>

#include "core/random.hpp"
#include "stories/topic.hpp"

namespace gradus::worksheet {

/// Draws inputs near a given one, by the kinds of the topic's parameters alone: numbers move by a little,
/// points are mirrored, moved and scaled together, rows of a maze lose and get walls. Whole numbers stay
/// whole, others keep at most as many decimals, or become halves.
///
/// Changed is what somebody could write down: no choices, colours, files, flags and orders. The same seed
/// draws the same inputs, one after the other.
class SimilarInputs {
 public:
  /// parameters: those that may change; what of them can't be written down stays. They must live as long.
  SimilarInputs(const std::vector<const Parameter*>& parameters, const Arguments& model, Random random);

  /// Whether there is anything to change.
  bool any() const { return !changed_.empty(); }
  /// The next input, near this one, which has the model's method; nothing where what was drawn is none that
  /// the parameters take. Whether the topic runs on it is not known yet. Must not be called where there is
  /// nothing to change.
  std::optional<Arguments> next(const Arguments& near);
  /// A whole number up to `most`, from the same stream.
  std::size_t choice(std::size_t most);

 private:
  std::vector<const Parameter*> changed_;
  Random random_;
};

/// The parameters that the arguments' method takes notice of and that have a value, in the topic's order.
std::vector<const Parameter*> read_parameters(const TopicEntry& topic, const Arguments& arguments);

/// The topic's method of these arguments.
const Method& method_of(const TopicEntry& topic, const Arguments& arguments);

}  // namespace gradus::worksheet
