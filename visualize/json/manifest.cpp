// What `gradus figures` remembers of an earlier run.

#include <nlohmann/json.hpp>

#include "json/json.hpp"

namespace gradus {
namespace {

/// Finds a member in logarithmic time: a manifest may have thousands of jobs.
using SortedJson = nlohmann::json;

}  // namespace

std::string manifest_json(const Manifest& manifest) {
  SortedJson jobs = SortedJson::object();
  for (const auto& [slug, job] : manifest.jobs) {
    SortedJson files = SortedJson::array();
    for (const ManifestFile& f : job.second)
      files.push_back({{"path", f.path}, {"size", f.size}, {"modified", f.modified}});
    jobs[slug] = {{"key", job.first}, {"files", std::move(files)}};
  }
  const SortedJson all{{"owner", manifest.owner}, {"jobs", std::move(jobs)}};
  return all.dump(1, ' ', false, SortedJson::error_handler_t::replace) + "\n";
}

Manifest parse_manifest(std::string_view text) {
  const SortedJson json = SortedJson::parse(text, nullptr, false);
  Manifest out;
  if (!json.is_object() || !json.contains("jobs") || !json["jobs"].is_object()) return out;
  if (json.contains("owner") && json["owner"].is_string()) out.owner = json["owner"].get<std::string>();
  const auto is_file = [](const SortedJson& f) {
    return f.is_object() && f.contains("path") && f["path"].is_string() && f.contains("size") &&
           f["size"].is_number_unsigned() && f.contains("modified") && f["modified"].is_number_integer();
  };
  // A job that can't be read in full is left out: it is made anew.
  for (const auto& [slug, job] : json["jobs"].items()) {
    if (!job.is_object() || !job.contains("key") || !job["key"].is_string()) continue;
    if (!job.contains("files") || !job["files"].is_array()) continue;
    if (!std::ranges::all_of(job["files"], is_file)) continue;
    auto& [key, files] = out.jobs[slug];
    key = job["key"].get<std::string>();
    for (const SortedJson& f : job["files"]) {
      files.push_back(
          {f["path"].get<std::string>(), f["size"].get<std::uint64_t>(), f["modified"].get<std::int64_t>()});
    }
  }
  return out;
}

}  // namespace gradus
