#pragma once
// Errata about reading: what has no steps to show. A text, what a reader of lecture notes makes of it, and
// what the project's own makes of it.

#include <string>
#include <string_view>

namespace gradus {

/// What a reader is given.
struct ReadingInput {
  std::string text;
  std::string library{};  ///< of materials; empty: none
};

/// Readers of the same text, one of them faulty.
struct Readers {
  std::string_view name;                      ///< of the faulty function: "notes_faces"
  std::string (*wrong)(const ReadingInput&);  ///< what it makes of the last thing in the text, in a line
  std::string (*right)(const ReadingInput&);  ///< the same of the project's reader; it may refuse
};

/// The readers of this name; nullptr where there are none.
const Readers* find_readers(std::string_view name);

}  // namespace gradus
