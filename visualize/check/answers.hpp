#pragma once
// What somebody's own program answered: a JSON file of one or more answers, or a table of one.

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "check/conventions.hpp"
#include "request/written_json.hpp"

namespace gradus::check {

/// The version of the form of cases and answers; raised when a reader of the old one would go wrong.
inline constexpr int check_schema = 1;

/// The answer to one case.
struct OwnAnswer {
  std::string id;        ///< what reports call it: the case's, else its number in the file
  int line = 1;          ///< where it begins
  bool is_case = false;  ///< `id` is a case's, whose arguments are meant
  std::map<std::string, std::string> arguments{};  ///< of the run, as flags would say them
  std::vector<JsonMember> result{};                ///< as in `gradus run --json`, as far as it is given
  std::vector<JsonNode> steps{};                   ///< objects
};

struct OwnAnswers {
  std::string file;     ///< how errors call it
  std::string topic{};  ///< empty: not said
  std::string method{};
  std::uint64_t seed = 1;
  Conventions conventions{};
  std::vector<OwnAnswer> answers{};  ///< at least one
};

/// Reads either form. JSON: {"topic": …, "method": …, "seed": …, "conventions": {…}, "answers": [{"case": …
/// or "arguments": {…}, "result": {…}, "steps": [{…}]}]}. A table: values with commas (or semicolons, tabs,
/// blanks) between them, a line per step, "#" before comments; its first line may name them, else they are x
/// and y. Columns x and y are the result's pixels, all columns are the steps' values.
/// Errors: InputError "file:line: expected …, found …".
OwnAnswers read_answers(const TopicEntry& topic, std::string_view text, const std::string& file);

/// Ends reading: "file:line: expected …, found …".
[[noreturn]] void refuse_answer(const OwnAnswers& answers, int line, std::string_view where,
                                std::string_view expected, std::string_view found);

/// A value of the kind that ours has, as somebody wrote it: a cell, a number, a truth, a text; codes may be
/// texts of digits 0 and 1. A whole number stands for a real one, and a real one for a whole one, which it
/// then is not. Nothing for what is of another kind.
std::optional<Value> read_value(const JsonNode& node, const Value& ours);
/// "two whole numbers", "a number".
std::string_view kind_of(const Value& ours);

}  // namespace gradus::check
