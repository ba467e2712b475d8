#pragma once
// Runs of the tour through the textbook chain, and what they show.

#include <map>
#include <string>

#include "stories/pipeline/textbook_chain/run.hpp"
#include "support/example_traces.hpp"

namespace gradus::test::tours {

/// Parameters that are given.
using Given = std::map<std::string, std::string>;

inline Trace tour(const Given& given) { return trace_of("pipeline", given); }

inline pipeline::Scene scene(const Given& given) {
  return textbook_chain::scene_of(complete(topic("pipeline"), given));
}

inline pipeline::Size size(const Given& given) {
  const Arguments arguments = complete(topic("pipeline"), given);
  return {static_cast<int>(arguments.integer("columns")), static_cast<int>(arguments.integer("rows"))};
}

}  // namespace gradus::test::tours
