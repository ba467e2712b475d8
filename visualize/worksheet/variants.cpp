#include "worksheet/variants.hpp"

#include <algorithm>
#include <exception>
#include <optional>
#include <set>
#include <utility>

#include "worksheet/similar_input.hpp"

namespace gradus::worksheet {
namespace {

/// Runs longer than this are told as far as here: a sheet holds a dozen rows.
constexpr std::int64_t most_steps = 4000;

Exercise exercise_on(const TopicEntry& topic, const Arguments& arguments, const Search& search,
                     const Exercise* model) {
  auto trace = std::make_shared<const Trace>(topic.run(arguments, {0, most_steps, search.wording}));
  return exercise_of(std::move(trace), search.most_rows, model);
}

/// The same where the topic may refuse the input.
std::optional<Exercise> exercise_if_any(const TopicEntry& topic, const Arguments& arguments,
                                        const Search& search, const Exercise& model) {
  try {
    return exercise_on(topic, arguments, search, &model);
  } catch (const std::exception&) {
    return std::nullopt;
  }
}

bool numbers_can_be_had(const Exercise& exercise, Reckoning reckoning) {
  return std::ranges::all_of(exercise.rows, [reckoning](const ExerciseRow& row) {
    return std::ranges::all_of(row.cells,
                               [reckoning](const std::string& cell) { return can_be_had(cell, reckoning); });
  });
}

/// The topic's name makes its inputs differ from another's.
std::uint64_t stream_of(const TopicEntry& topic) {
  std::uint64_t stream = 0;
  for (const char c : topic.name) stream = 31 * stream + static_cast<unsigned char>(c);
  return stream;
}

}  // namespace

Variants variants_of(const TopicEntry& topic, const Arguments& model, const Search& search) {
  Variants variants;
  variants.model = exercise_on(topic, model, search, nullptr);
  SimilarInputs inputs(topic, model, Random(search.seed, stream_of(topic)));
  if (variants.model.rows.size() < 2 || variants.model.blanks() == 0 || !inputs.any()) return variants;
  std::set<std::string> known{variants.model.answers()};
  const auto look_for = [&](const Search& how, bool beginnings) {
    for (std::size_t left = how.tries(); left > 0 && variants.found.size() < search.wanted; --left) {
      ++variants.tried;
      std::optional<Arguments> drawn = inputs.next();
      if (!drawn) continue;
      std::optional<Exercise> exercise = exercise_if_any(topic, *drawn, how, variants.model);
      if (!exercise || !are_alike(*exercise, variants.model, beginnings)) continue;
      if (!numbers_can_be_had(*exercise, how.reckoning)) continue;
      if (exercise->blanks() == 0 || !known.insert(exercise->answers()).second) continue;
      variants.found.push_back({std::move(*drawn), std::move(*exercise)});
    }
  };
  look_for(search, false);
  Search of_beginnings = search;
  of_beginnings.most_rows = variants.model.rows.size();
  if (variants.model.whole()) look_for(of_beginnings, true);
  return variants;
}

}  // namespace gradus::worksheet
