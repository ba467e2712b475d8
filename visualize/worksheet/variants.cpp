#include "worksheet/variants.hpp"

#include <algorithm>
#include <exception>
#include <optional>
#include <set>
#include <string>
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

/// Cells whose numbers can't be had so, and of rounded ones a row each.
std::size_t unfit_cells(const Exercise& exercise, Reckoning reckoning) {
  std::size_t count = 0;
  for (const ExerciseRow& row : exercise.rows) {
    for (const std::string& cell : row.cells) count += !can_be_had(cell, reckoning);
    count += row.rounded && reckoning == Reckoning::by_hand;
  }
  return count;
}

/// Zeros are no work.
std::int64_t zeros_in(const Exercise& exercise) {
  std::int64_t zeros = 0;
  for (const ExerciseRow& row : exercise.rows) zeros += std::ranges::count(row.cells, "0");
  return zeros;
}

/// The topic's name makes its inputs differ from another's.
std::uint64_t stream_of(const TopicEntry& topic) {
  std::uint64_t stream = 0;
  for (const char c : topic.name) stream = 31 * stream + static_cast<unsigned char>(c);
  return stream;
}

/// All that a run says.
std::string told_by(const Trace& trace) {
  std::string text = trace.subtitle;
  for (const TraceStep& step : trace.steps) {
    text += "\n" + step.sentence;
    for (const Row* row : {&step.read, &step.row}) {
      for (const std::string& cell : *row) text += "\t" + cell;
    }
  }
  return text;
}

/// Of the parameters that the method may read those that tell in this run: others of a topic with many
/// methods would only confuse. Whether a number tells is tried out.
std::vector<const Parameter*> telling_parameters(const TopicEntry& topic, const Arguments& model,
                                                 const Search& search, const Trace& trace) {
  constexpr int tries = 4;
  const std::string told = told_by(trace);
  const auto tells = [&](const Parameter* parameter) {
    SimilarInputs inputs({parameter}, model, Random(0, stream_of(topic)));
    if (!inputs.any()) return true;
    for (int i = 0; i < tries; ++i) {
      const std::optional<Arguments> drawn = inputs.next(model);
      if (!drawn) continue;
      try {
        if (told_by(topic.run(*drawn, {0, most_steps, search.wording})) != told) return true;
      } catch (const std::exception&) {
        return true;
      }
    }
    return false;
  };
  std::vector<const Parameter*> telling = read_parameters(topic, model);
  std::erase_if(telling, [&](const Parameter* parameter) { return !tells(parameter); });
  return telling;
}

}  // namespace

Variants variants_of(const TopicEntry& topic, const Arguments& model, const Search& search) {
  Variants variants;
  variants.model = exercise_on(topic, model, search, nullptr);
  if (variants.model.rows.size() < 2 || variants.model.blanks() == 0) return variants;
  variants.parameters = telling_parameters(topic, model, search, *variants.model.trace);
  SimilarInputs inputs(variants.parameters, model, Random(search.seed, stream_of(topic)));
  if (!inputs.any()) return variants;
  const std::int64_t most_zeros = zeros_in(variants.model) + 1;
  std::set<std::string> known{variants.model.answers()};
  // An input that is nearly fit, or one that was found, is a good place to look on from
  std::optional<Arguments> best;
  std::size_t least_unfit = unfit_cells(variants.model, search.reckoning);
  const auto near = [&]() -> const Arguments& {
    const std::size_t choice = inputs.choice(2);
    if (choice == 1 && best) return *best;
    if (choice == 2 && !variants.found.empty()) {
      return variants.found[inputs.choice(variants.found.size() - 1)].arguments;
    }
    return model;
  };
  const auto look_for = [&](const Search& how, bool beginnings) {
    for (std::size_t left = how.tries(); left > 0 && variants.found.size() < search.wanted; --left) {
      ++variants.tried;
      std::optional<Arguments> drawn = inputs.next(near());
      if (!drawn) continue;
      std::optional<Exercise> exercise = exercise_if_any(topic, *drawn, how, variants.model);
      if (!exercise || !are_alike(*exercise, variants.model, beginnings)) continue;
      if (exercise->blanks() == 0 || zeros_in(*exercise) > most_zeros) continue;
      if (const std::size_t unfit = unfit_cells(*exercise, how.reckoning); unfit > 0) {
        if (unfit < least_unfit) best = *drawn;
        least_unfit = std::min(least_unfit, unfit);
      } else if (known.insert(exercise->answers()).second) {
        variants.found.push_back({std::move(*drawn), std::move(*exercise)});
      }
    }
  };
  look_for(search, false);
  Search of_beginnings = search;
  of_beginnings.most_rows = variants.model.rows.size();
  if (variants.model.whole()) look_for(of_beginnings, true);
  return variants;
}

}  // namespace gradus::worksheet
