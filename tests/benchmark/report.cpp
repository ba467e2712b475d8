#include "benchmark/report.hpp"

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <set>
#include <sstream>
#include <thread>

#include "figure/colophon.hpp"

namespace gradus::bench {
namespace {

/// Four digits or so, without an exponent for what people say in words.
std::string number(double value) {
  if (value == 0) return "0";
  if (std::abs(value) >= 1e6 || std::abs(value) < 1e-3) return fmt::format("{:.2e}", value);
  return fmt::format("{:.4g}", value);
}

Role role_of(Standing standing) {
  switch (standing) {
    case Standing::taught:
      return Role::current;
    case Standing::faulty:
      return Role::rejected;
    case Standing::robust:
      return Role::accepted;
    case Standing::batch:
      return Role::candidate;
    case Standing::peer:
      return Role::past;
  }
  return Role::current;
}

/// The workloads in the order in which they come.
std::vector<std::string> workloads_of(const Findings& findings) {
  std::vector<std::string> names;
  for (const Result& result : findings.results) {
    if (std::ranges::find(names, result.of.workload.name) == names.end()) {
      names.push_back(result.of.workload.name);
    }
  }
  return names;
}

std::vector<std::pair<Role, std::string>> legend_of(std::span<const Result> results) {
  std::vector<std::pair<Role, std::string>> legend;
  for (const Standing standing :
       {Standing::taught, Standing::robust, Standing::batch, Standing::peer, Standing::faulty}) {
    if (std::ranges::any_of(results, [&](const Result& r) { return r.of.standing == standing; })) {
      legend.push_back({role_of(standing), std::string(name_of(standing))});
    }
  }
  return legend;
}

bool beats(const Result& a, const Result& b) {
  const Error x = a.of.error.value_or(Error{}), y = b.of.error.value_or(Error{});
  const bool no_worse = a.nanoseconds <= b.nanoseconds && x.max <= y.max && x.wrong <= y.wrong;
  return no_worse && (a.nanoseconds < b.nanoseconds || x.max < y.max || x.wrong < y.wrong);
}

std::string duels_table(const Findings& findings) {
  const Subject& subject = *findings.subject;
  const std::string peer = findings.peer.empty() ? "the peer is not there" : "beside " + findings.peer;
  std::string text = fmt::format("{}: {}, {}\n\n  {:<62} {:>9} {:>9} {:>6} {:>8} {:>8}\n", subject.topic,
                                 subject.title, peer, "", "ms", "peer ms", "ratio", "max diff", "off by 2");
  for (const Duel& duel : findings.duels) {
    text += fmt::format("  {:<62} {:>9.2f}", duel.workload, duel.ms);
    if (duel.peer_ms) {
      text += fmt::format(" {:>9.2f} {:>6.2f} {:>8} {:>8}", *duel.peer_ms, *duel.ratio(),
                          duel.max_pixel_difference, duel.pixels_off);
    }
    text += '\n';
  }
  return text;
}

benchmark::BenchmarkReporter::Run run_of(const Subject& subject, const Duel& duel) {
  using Run = benchmark::BenchmarkReporter::Run;
  Run run;
  run.run_name.function_name = fmt::format("{}/{}", subject.topic, duel.workload);
  run.run_type = Run::RT_Aggregate;
  run.aggregate_name = "median";
  run.aggregate_unit = benchmark::StatisticUnit::kTime;
  run.threads = 1;
  run.repetitions = 1;
  run.iterations = 1;
  run.real_accumulated_time = run.cpu_accumulated_time = 1e-3 * duel.ms;
  run.time_unit = benchmark::kMillisecond;
  run.counters["ms"] = duel.ms;
  if (!duel.peer_ms) return run;
  run.counters["peer_ms"] = *duel.peer_ms;
  run.counters["ratio"] = *duel.ratio();
  run.counters["max_pixel_difference"] = duel.max_pixel_difference;
  run.counters["pixels_off"] = static_cast<double>(duel.pixels_off);
  return run;
}

}  // namespace

std::vector<bool> pareto_optimal(std::span<const Result> results) {
  std::vector<bool> kept;
  for (const Result& result : results) {
    kept.push_back(std::ranges::none_of(results, [&](const Result& other) {
      return other.of.workload.name == result.of.workload.name && beats(other, result);
    }));
  }
  return kept;
}

std::string table_of(const Findings& findings) {
  if (!findings.duels.empty()) return duels_table(findings);
  const Subject& subject = *findings.subject;
  const std::vector<bool> best = pareto_optimal(findings.results);
  std::size_t wide = 34;
  for (const Result& r : findings.results)
    wide = std::max({wide, r.of.workload.name.size(), r.of.method.size()});
  std::string text = fmt::format("{}: {}, times per {}\n", subject.topic, subject.title, subject.item);
  for (const std::string& workload : workloads_of(findings)) {
    text += fmt::format("\n  {:<{}} {:<7} {:>9} {:>9} {:>8} {:>10} {:>10} {:>7}\n", workload, wide, "", "ns",
                        "M/s", "spread", "max " + subject.unit, "rms " + subject.unit, "wrong");
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < findings.results.size(); ++i) {
      if (findings.results[i].of.workload.name == workload) order.push_back(i);
    }
    std::ranges::sort(order, {}, [&](std::size_t i) { return findings.results[i].nanoseconds; });
    for (const std::size_t i : order) {
      const Result& r = findings.results[i];
      const auto& error = r.of.error;
      text += fmt::format("{} {:<{}} {:<7} {:>9} {:>9} {:>7.0f}% {:>10} {:>10} {:>7}\n", best[i] ? '*' : ' ',
                          r.of.method, wide, name_of(r.of.standing), number(r.nanoseconds),
                          number(1000 / r.nanoseconds), 100 * r.spread, error ? number(error->max) : "",
                          error ? number(error->rms) : "", error ? fmt::format("{}", error->wrong) : "");
    }
  }
  return text;
}

std::string json_of(std::span<const Findings> findings) {
  using Run = benchmark::BenchmarkReporter::Run;
  std::vector<Run> runs;
  for (const Findings& found : findings) {
    for (const Duel& duel : found.duels) runs.push_back(run_of(*found.subject, duel));
    for (const Result& result : found.results) {
      Run run;
      run.run_name.function_name =
          fmt::format("{}/{}/{}", found.subject->topic, result.of.workload.name, result.of.method);
      run.run_type = Run::RT_Aggregate;
      run.aggregate_name = "median";
      run.aggregate_unit = benchmark::StatisticUnit::kTime;
      run.threads = 1;
      run.repetitions = result.repetitions;
      run.iterations = 1;
      run.real_accumulated_time = 1e-9 * result.nanoseconds;
      run.cpu_accumulated_time = 1e-9 * result.cpu_nanoseconds;
      run.time_unit = benchmark::kNanosecond;
      run.report_label = std::string(name_of(result.of.standing));
      run.counters["items_per_second"] = 1e9 / result.nanoseconds;
      run.counters["spread"] = result.spread;
      if (result.of.workload.size > 0) run.counters["size"] = result.of.workload.size;
      if (const auto& error = result.of.error) {
        run.counters["error_max"] = error->max;
        run.counters["error_rms"] = error->rms;
        run.counters["error_wrong"] = static_cast<double>(error->wrong);
      }
      runs.push_back(std::move(run));
    }
  }
  // By this a file is known as ours
  [[maybe_unused]] static const bool marked = [] {
    benchmark::AddCustomContext("gradus", std::string(release_version));
    return true;
  }();
  std::ostringstream text;
  benchmark::JSONReporter reporter;
  reporter.SetOutputStream(&text);
  reporter.SetErrorStream(&text);
  reporter.ReportContext({});
  reporter.ReportRuns(runs);
  reporter.Finalize();
  return text.str();
}

std::optional<plot::Chart> error_chart(const Findings& findings) {
  const Subject& subject = *findings.subject;
  std::vector<Result> compared;
  for (const Result& result : findings.results) {
    if (result.of.workload.name == subject.telling && result.of.error) compared.push_back(result);
  }
  if (compared.empty()) return std::nullopt;
  const std::vector<bool> best = pareto_optimal(compared);
  plot::Chart chart;
  chart.title = subject.title;
  chart.subtitle = fmt::format("{} · worst error against time per {}, less is better in both",
                               subject.telling, subject.item);
  chart.x = {fmt::format("nanoseconds per {}", subject.item)};
  chart.y = {fmt::format("worst error in {}", subject.unit), "0"};
  for (std::size_t i = 0; i < compared.size(); ++i) {
    const Case& of = compared[i].of;
    std::string name = of.method;
    if (of.error->wrong > 0) name += fmt::format(", {} wrong", of.error->wrong);
    chart.dots.push_back({name, {compared[i].nanoseconds, of.error->max}, role_of(of.standing), best[i]});
  }
  chart.legend = legend_of(compared);
  chart.footer = machine();
  return chart;
}

std::optional<plot::Chart> size_chart(const Findings& findings) {
  const Subject& subject = *findings.subject;
  // By method; a run is what takes longer as the size grows
  std::vector<plot::Curve> curves;
  std::vector<Result> shown;
  for (const Result& result : findings.results) {
    if (result.of.workload.size <= 0) continue;
    shown.push_back(result);
    auto curve = std::ranges::find(curves, result.of.method, &plot::Curve::name);
    if (curve == curves.end()) {
      curves.push_back({result.of.method, {}, role_of(result.of.standing)});
      curve = curves.end() - 1;
    }
    curve->points.push_back(
        {result.of.workload.size, result.nanoseconds * static_cast<double>(result.of.items) * 1e-3});
  }
  if (curves.empty()) return std::nullopt;
  for (plot::Curve& curve : curves) {
    std::ranges::sort(curve.points, {}, &dvec2::x);
    if (const auto exponent = plot::slope(curve.points))
      curve.name += fmt::format(", slope {:.2f}", *exponent);
  }
  plot::Chart chart;
  chart.title = subject.title;
  chart.subtitle = "time against size: slope 1 is time in proportion, 2 its square";
  chart.x = {fmt::format("n: {}", subject.measure)};
  chart.y = {"microseconds per run"};
  chart.curves = std::move(curves);
  chart.legend = legend_of(shown);
  chart.footer = machine();
  return chart;
}

std::optional<plot::Chart> refinement_chart(const Findings& findings) {
  const Subject& subject = *findings.subject;
  if (!subject.refined) return std::nullopt;
  std::vector<Result> series;
  for (const Result& result : findings.results) {
    if (result.of.workload.size > 0 && result.of.error && result.of.error->max > 0) series.push_back(result);
  }
  if (series.empty()) return std::nullopt;
  std::ranges::sort(series, {}, [](const Result& r) { return std::pair(r.of.workload.size, r.of.method); });
  const double least = series.front().of.workload.size, most = series.back().of.workload.size;
  plot::Chart chart;
  for (const Result& result : series) {
    const Case& of = result.of;
    const dvec2 at{result.nanoseconds, of.error->max};
    auto curve = std::ranges::find(chart.curves, of.method, &plot::Curve::name);
    if (curve == chart.curves.end()) {
      chart.curves.push_back({of.method, {}, role_of(of.standing)});
      curve = chart.curves.end() - 1;
    }
    curve->points.push_back(at);
    std::string name;
    if (of.workload.size == least) name = fmt::format("{}, {}", of.method, of.workload.name);
    if (of.workload.size == most) name = of.workload.name;
    chart.dots.push_back({name, at, role_of(of.standing)});
  }
  for (plot::Curve& curve : chart.curves) curve.name.clear();
  chart.title = subject.title;
  chart.subtitle = fmt::format("worst error against time per {}, from {} {} to {}", subject.item, least,
                               subject.measure, most);
  chart.x = {fmt::format("nanoseconds per {}", subject.item)};
  chart.y = {fmt::format("worst error in {}", subject.unit), "0"};
  chart.legend = legend_of(series);
  chart.footer = machine();
  return chart;
}

std::string machine() {
  std::string model = "unknown processor";
  std::ifstream cpus("/proc/cpuinfo");
  for (std::string line; std::getline(cpus, line);) {
    if (!line.starts_with("model name")) continue;
    model = line.substr(line.find(':') + 2);
    break;
  }
#if defined(__clang__)
  const std::string compiler = fmt::format("Clang {}.{}", __clang_major__, __clang_minor__);
#else
  const std::string compiler = fmt::format("GCC {}.{}", __GNUC__, __GNUC_MINOR__);
#endif
#ifdef GRADUS_FOR_TESTS
  const char* build = ", compiled for tests, not to measure";
#else
  const char* build = "";
#endif
  return fmt::format("{}, {} cores, one used; {}{}", model, std::thread::hardware_concurrency(), compiler,
                     build);
}

}  // namespace gradus::bench
