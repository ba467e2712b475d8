#pragma once
// What was measured, for reading, for other programs, and for slides.

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "benchmark/measure.hpp"
#include "plot/chart.hpp"

namespace gradus::bench {

/// The machine and the compiler, in a few words.
std::string machine();

/// A subject and all that was measured of it.
struct Findings {
  const Subject* subject = nullptr;
  std::vector<Result> results;
  std::vector<Duel> duels{};
  std::string peer{};  ///< whom the duels are against; empty when it is not there
  std::string machine = bench::machine();
};

/// Which results no other method beats on the same workload: none is as fast, as accurate and as often right,
/// and better in one of them.
std::vector<bool> pareto_optimal(std::span<const Result> results);

/// The table: a block per workload, its methods by time, the Pareto-optimal ones marked; a line per duel.
std::string table_of(const Findings& findings);

/// In Google Benchmark's layout: benchmarks[].name is topic/workload/method, times are those of an item, of
/// which a run works off `items`; beside them error_max, error_rms and error_wrong where there is an oracle.
/// Of duels topic/workload, the time of a picture, and ms, peer_ms, ratio, max_pixel_difference and
/// pixels_off; without a peer ms alone.
std::string json_of(std::span<const Findings> findings);
/// What json_of was given, as far as tables and charts show it, of these subjects.
/// Throws std::invalid_argument, with the reason, where the text is no such JSON.
std::vector<Findings> findings_in(std::string_view json, std::span<const Subject> subjects);

/// Time against error of the methods on the subject's telling workload, with the front. In all charts of a
/// subject a method has the same colour and marker, and the one to choose is marked.
/// Nothing when no method there was compared with an oracle.
std::optional<plot::Chart> error_chart(const Findings& findings);
/// Time against size of the methods on the series, with the slopes. Nothing when there is no series.
std::optional<plot::Chart> size_chart(const Findings& findings);
/// Error against time along the series of a refined subject: a curve per method, the sizes of its ends named.
std::optional<plot::Chart> refinement_chart(const Findings& findings);

}  // namespace gradus::bench
