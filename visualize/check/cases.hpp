#pragma once
// Inputs on which somebody's own program can be tried: easy, typical, nasty ones, and ties.

#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "request/inputs.hpp"

namespace gradus::check {

enum class CaseKind : std::uint8_t { easy, typical, nasty, ties };
inline constexpr std::array case_kinds{CaseKind::easy, CaseKind::typical, CaseKind::nasty, CaseKind::ties};
std::string_view name_of(CaseKind kind);

struct Case {
  std::string id;  ///< "ties-2"
  CaseKind kind = CaseKind::easy;
  GivenTexts arguments;  ///< what is not the default
};

/// Reads arguments as flags are read; throws as read_inputs does.
using ReadArguments = std::function<Arguments(const GivenTexts& given)>;

/// Runs are whole up to so many events; longer ones make no cases.
inline constexpr std::int64_t most_case_events = 5000;
/// A kind has at most so many cases.
inline constexpr std::int64_t most_cases = 50;

/// Draws cases of a topic. A case depends on seed, kind and its number alone, not on how many are asked for.
/// `fixed` stays as it is in every case. Every case runs. A kind of which none is found has fewer, or none:
/// not every topic has ties. Cost: up to some hundred runs per kind.
class Cases {
 public:
  Cases(const TopicEntry& topic, GivenTexts fixed, std::uint64_t seed, ReadArguments read)
      : topic_(topic), fixed_(std::move(fixed)), seed_(seed), read_(std::move(read)) {}

  std::vector<Case> of_kind(CaseKind kind, std::size_t count);
  /// The case of this name; nothing: there is none.
  std::optional<Case> find(std::string_view id);

 private:
  std::optional<Trace> run(const GivenTexts& given) const;
  bool has_ties(const Trace& trace, const Arguments& arguments) const;
  GivenTexts drawn(CaseKind kind, std::size_t draw) const;
  bool varies(const Parameter& parameter, const Method& method) const;
  const Method& method() const;

  const TopicEntry& topic_;
  const GivenTexts fixed_;
  const std::uint64_t seed_;
  const ReadArguments read_;
  /// What has been drawn of a kind so far.
  struct Drawn {
    std::vector<Case> cases;
    std::size_t draws = 0;
    std::set<std::vector<std::string>> known;  ///< their canonical arguments
  };
  std::array<Drawn, case_kinds.size()> drawn_;
};

}  // namespace gradus::check
