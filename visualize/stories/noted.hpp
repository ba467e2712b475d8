#pragma once
// Inputs whose default a reader's notation may have otherwise (Parameter::noted).

#include <string>

#include "stories/topic.hpp"

namespace gradus {

/// What such an input says: what was given, were it the default, else what the notation has.
inline const std::string& noted_text(const Arguments::Entry& entry, const std::string& of_notation) {
  return entry.given || of_notation.empty() ? entry.text : of_notation;
}

}  // namespace gradus
