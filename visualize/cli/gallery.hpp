#pragma once
// The figures that the topics themselves propose: one folder each, and a card on the gallery page.

#include <filesystem>
#include <string>
#include <vector>

#include "cli/inputs.hpp"
#include "stories/topic.hpp"
#include "web/gallery_page.hpp"
#include "web/json.hpp"

namespace gradus::cli {

/// A figure of the gallery, with its input read.
struct Job {
  const TopicEntry* topic = nullptr;
  const Showcase* showcase = nullptr;
  Inputs inputs;
  std::string key;  ///< differs when the program, the input or the description does
};

/// Every figure there is, by topic. `program` is the fingerprint of the program that draws them.
std::vector<Job> gallery_jobs(const std::string& program);

/// The fingerprint of this program's own bytes.
std::string program_fingerprint();

/// Draws the job's files into out/<slug>/ and tells what they are. Everything appears or nothing.
std::vector<ManifestFile> draw(const Job& job, const std::filesystem::path& out);

/// Its card. `last`: the number of the run's last step.
Card card_of(const Job& job, std::int64_t last);

/// Size and time of a file below `out`, as the manifest keeps them; size 2^64 - 1 when there is none.
ManifestFile file_state(const std::filesystem::path& out, const std::string& path);

}  // namespace gradus::cli
