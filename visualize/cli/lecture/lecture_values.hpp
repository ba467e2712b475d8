#pragma once
// The single values of a lecture: each is read as its key takes it, or complained of.

#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "cli/lecture/lecture.hpp"
#include "request/written_json.hpp"

namespace gradus::cli {

/// Beside the figures' folders.
constexpr std::string_view pages_folder = "topics";

/// Whether it can name a folder and files.
bool is_name(std::string_view text);

/// What reading collects, and the readers of single values.
class LectureValues {
 protected:
  using Texts = std::vector<std::string>;

  explicit LectureValues(const std::string& file) { lecture_.file = file; }

  void note(Problem problem);
  void complain(const Place& place, const std::string& what);
  void complain(const Place& place, std::string_view expected, const JsonNode& found);

  bool is_object(const JsonNode& node, const Place& place, std::string_view expected);
  std::optional<std::string> text_of(const JsonNode& node, const Place& place);
  std::optional<std::string> line_of_text(const JsonNode& node, const Place& place);
  std::optional<std::string> number_or_text(const JsonNode& node, const Place& place,
                                            std::string_view expected);

  /// [0, 9] is "0,9".
  std::optional<std::string> joined(const JsonNode& node, const Place& place, std::string_view separator,
                                    std::string_view expected);

  /// [[0, 0], [6, 3]] is "0,0 6,3".
  std::optional<std::string> joined_points(const JsonNode& node, const Place& place,
                                           const Parameter& parameter);

  /// [[[0, 0], [6, 0], [6, 3]], [[8, 1], [9, 1], [9, 2]]] is "0,0 6,0 6,3; 8,1 9,1 9,2"; a single ring may
  /// stand alone.
  std::optional<std::string> joined_rings(const JsonNode& node, const Place& place,
                                          const Parameter& parameter);

  /// The value as its flag takes it; nothing for a switch that is off.
  std::optional<std::string> flag_value(const LectureKey& key, const JsonNode& node, const Place& place);

  /// A name in full: a beginning that is unique today need not be so when the lecture is given again.
  std::optional<std::size_t> whole_name(const std::string& word, const Texts& names, const Place& place);

  std::optional<std::string> safe_name(const JsonNode& node, const Place& place);
  std::optional<std::string> file_name(const JsonNode& node, const Place& place);

  std::optional<std::string> input_value(const Parameter& parameter, const JsonNode& node,
                                         const Place& place);

  static bool has_symbol(const TopicEntry* topic, const std::string& symbol);
  /// What the lecture, or one of its figures, calls a symbol must be of use to one of these topics: of
  /// `label`, and of all symbols in an own notation that stands on the spot.
  using Topics = std::set<const TopicEntry*>;
  void require_symbol(const std::string& symbol, const Place& place, const Topics& topics);
  void require_symbols(const JsonNode& part, const std::string& path, const Topics& topics);

  Lecture lecture_;

 private:
  std::set<Problem> known_problems_;
};

}  // namespace gradus::cli
