// Reads again what json_of has written: charts in a new style need no new measurement.

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "benchmark/report.hpp"

namespace gradus::bench {
namespace {

using Json = nlohmann::json;

Standing standing_named(const std::string& name) {
  for (const Standing standing :
       {Standing::taught, Standing::faulty, Standing::robust, Standing::batch, Standing::peer}) {
    if (name_of(standing) == name) return standing;
  }
  throw std::invalid_argument(fmt::format("no method is '{}'", name));
}

Result result_of(const Json& run, std::string workload, std::string method) {
  Result result;
  result.of.method = std::move(method);
  result.of.standing = standing_named(run.at("label"));
  result.of.workload = {std::move(workload), run.value("size", 0.0)};
  result.of.items = static_cast<std::int64_t>(run.at("items").get<double>());
  if (run.contains("error_max")) {
    const auto wrong = static_cast<std::int64_t>(run.at("error_wrong").get<double>());
    result.of.error = {run.at("error_max"), run.at("error_rms"), wrong};
  }
  result.nanoseconds = run.at("real_time");
  result.cpu_nanoseconds = run.at("cpu_time");
  result.spread = run.at("spread");
  result.repetitions = run.at("repetitions");
  return result;
}

Duel duel_of(const Json& run, std::string workload) {
  Duel duel{std::move(workload), run.at("ms")};
  if (!run.contains("peer_ms")) return duel;
  duel.peer_ms = run.at("peer_ms").get<double>();
  duel.max_pixel_difference = static_cast<int>(run.at("max_pixel_difference").get<double>());
  duel.pixels_off = static_cast<std::int64_t>(run.at("pixels_off").get<double>());
  return duel;
}

/// Adds a run to the findings of its subject, topic/workload/method or topic/workload.
void add(std::vector<Findings>& all, const Json& run, std::span<const Subject> subjects,
         const std::string& machine) {
  const std::string name = run.at("run_name");
  const std::size_t first = name.find('/'), last = name.rfind('/');
  const auto subject = std::ranges::find(subjects, name.substr(0, first), &Subject::topic);
  if (subject == subjects.end() || first == std::string::npos)
    throw std::invalid_argument(fmt::format("'{}' is of no subject that is measured here", name));
  if (all.empty() || all.back().subject != &*subject) all.push_back({&*subject, {}, {}, {}, machine});
  Findings& found = all.back();
  if (run.contains("ms")) {
    found.duels.push_back(duel_of(run, name.substr(first + 1)));
    found.peer = run.value("label", "");
  } else {
    found.results.push_back(result_of(run, name.substr(first + 1, last - first - 1), name.substr(last + 1)));
  }
}

}  // namespace

std::vector<Findings> findings_in(std::string_view json, std::span<const Subject> subjects) {
  std::vector<Findings> all;
  try {
    const Json whole = Json::parse(json);
    const std::string machine = whole.at("context").at("machine");
    for (const Json& run : whole.at("benchmarks")) add(all, run, subjects, machine);
  } catch (const Json::exception& error) {
    throw std::invalid_argument(error.what());
  }
  return all;
}

}  // namespace gradus::bench
