#pragma once
// What a live page asks, and what it is answered: the texts that the gradus command writes, by the code that
// writes them there. docs/live.md explains it to authors of pages.
//
//   {"want": "run", "topic": "bresenham_line", "arguments": {"from": "0,0", "to": "7,3"}, "language": "de"}

#include <string>
#include <string_view>

#include "request/inputs.hpp"

namespace gradus::live {

/// Answers a request, one object of JSON with these members; a run and a trace need a topic, all else may be
/// left out:
///
///   want       "run": what `gradus run TOPIC --json` writes; "trace": the same run as the player's page
///              holds it (trace_json), so many of its first steps as one plays where none are asked for;
///              "remarks": what the command remarks on files that are read, a list of lines; "list": what
///              `gradus list --json` writes, for which no other member is asked
///   topic      its name or alias; a unique beginning is enough
///   arguments  an object: of the topic's parameters by their names, and "method", the texts that the flags
///              take; "yes" for a flag that takes none
///   beside     for a trace: another method on the same input; then the answer holds the first steps of both,
///              and how they stand side by side: {"trace": …, "beside": …, "alignment": alignment_json}
///   step, steps, language, numbers, notation
///              texts, as the flags of those names take them. A notation is named or written on the spot
///   labels     a list of texts like "p=d"
///
/// files: those that arguments name. Refuses what the command refuses, in its words (complaint_of): unknown
/// names, values that are none, runs that can't be. Where the command speaks of a flag that it does not know,
/// "--to: viewing has no such parameter". Cost: the run's, and 100,000 steps are kept at most.
std::string answer(std::string_view request, Files& files);

}  // namespace gradus::live
