#pragma once
// JSON in and out. The library behind it stays inside json.cpp.

#include <cstdint>
#include <map>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "figure/alignment.hpp"
#include "figure/sheet.hpp"
#include "figure/trace.hpp"
#include "stories/topic.hpp"

namespace gradus {

/// The trace, schema `trace_schema`: what the player loads. With fewer `slots`, what only the others show is
/// left out and the member "slots" names those that stay. Places in drawings are rounded to a ten-thousandth
/// of a cell.
std::string trace_json(const Trace& trace,
                       const std::set<Slot>& slots = {all_slots.begin(), all_slots.end()});

/// How the steps of two runs stand side by side: {"pairs": [["0","0"],["1","2"]], "parting": "1"}, the last
/// being the first run's step with which they part, or null.
std::string alignment_json(const Alignment& alignment);

/// What `gradus run --json` prints: topic, method, faulty where so, input, steps (number, type, line,
/// fields), result.
std::string run_json(const Trace& trace);

/// What `gradus list --json` prints.
std::string list_json(std::span<const TopicEntry* const> topics);

/// A text as a JSON string literal that is safe inside a <script> element too.
std::string json_quoted(std::string_view text);

/// What `gradus figures` remembers of an earlier run, to redo only what changed.
struct ManifestFile {
  std::string path;  ///< below the output folder
  std::uint64_t size;
  std::int64_t modified;  ///< nanoseconds
};
struct Manifest {
  std::string owner;  ///< whose figures these are: empty for the built-in gallery
  std::map<std::string, std::pair<std::string, std::vector<ManifestFile>>> jobs;  ///< slug -> (key, files)
};
std::string manifest_json(const Manifest& manifest);
/// An unreadable text is an empty manifest: then everything is made anew.
Manifest parse_manifest(std::string_view text);

}  // namespace gradus
