#include "benchmark/report.hpp"

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <set>
#include <sstream>
#include <thread>
#include <utility>

#include "core/contract.hpp"
#include "figure/colophon.hpp"

namespace gradus::bench {
namespace {

/// Four digits or so, without an exponent for what people say in words.
std::string number(double value) {
  if (value == 0) return "0";
  if (std::abs(value) >= 1e6 || std::abs(value) < 1e-3) return fmt::format("{:.2e}", value);
  return fmt::format("{:.4g}", value);
}

/// "adaptive" of "adaptive 16": what takes a number of samples, say, is one method with several points.
std::string without_number(const std::string& method) {
  const std::size_t digits = method.find_last_not_of("0123456789") + 1;
  return digits < method.size() && digits > 1 && method[digits - 1] == ' ' ? method.substr(0, digits - 1)
                                                                           : method;
}

int number_of(const std::string& method) { return std::stoi(method.substr(without_number(method).size())); }

/// The family of each method: itself, or what it shares with others but for their numbers.
std::map<std::string, std::string> families_of(const Findings& findings) {
  std::map<std::string, std::set<std::string>> members;
  for (const Result& result : findings.results)
    members[without_number(result.of.method)].insert(result.of.method);
  std::map<std::string, std::string> families;
  for (const auto& [family, methods] : members) {
    for (const std::string& method : methods) families[method] = methods.size() > 1 ? family : method;
  }
  return families;
}

/// What each method looks like, by its name: the same in all charts of the subject, and in its family.
std::map<std::string, plot::Style> styles_of(const Findings& findings) {
  const std::string& chosen = findings.subject->choice.method;
  const std::map<std::string, std::string> families = families_of(findings);
  std::vector<std::string> names;
  std::vector<plot::Kind> kinds;
  for (const Result& result : findings.results) {
    const std::string& family = families.at(result.of.method);
    if (std::ranges::find(names, family) != names.end()) continue;
    names.push_back(family);
    const bool faulty = result.of.standing == Standing::faulty;
    kinds.push_back(family == chosen ? plot::Kind::chosen : faulty ? plot::Kind::faulty : plot::Kind::usual);
  }
  expects(chosen.empty() || std::ranges::find(names, chosen) != names.end(), "{} has no method {} to choose",
          findings.subject->topic, chosen);
  const std::vector<plot::Style> styles = plot::styles_of(kinds);
  std::map<std::string, plot::Style> by_method;
  for (const auto& [method, family] : families)
    by_method[method] = styles[static_cast<std::size_t>(std::ranges::find(names, family) - names.begin())];
  return by_method;
}

/// A chart with what all charts of a subject say.
plot::Chart chart_of(const Findings& findings, std::string subtitle) {
  const Subject& subject = *findings.subject;
  plot::Chart chart;
  chart.title = subject.title;
  chart.subtitle = std::move(subtitle);
  if (!subject.choice.method.empty()) {
    chart.advice = fmt::format("Choose {}: {}.", subject.choice.method, subject.choice.why);
    expects(plot::has_room_for(chart.advice), "no room for '{}'", chart.advice);
  }
  chart.footer = findings.machine;
  return chart;
}

/// "a pixel", "an edge".
std::string one(const std::string& item) {
  return (std::string_view("aeiou").find(item.front()) != std::string_view::npos ? "an " : "a ") + item;
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

/// The curve of a method, a new one where there is none yet.
plot::Curve& curve_of(plot::Chart& chart, const std::string& method,
                      const std::map<std::string, plot::Style>& styles) {
  const auto curve = std::ranges::find(chart.curves, method, &plot::Curve::name);
  if (curve != chart.curves.end()) return *curve;
  chart.curves.push_back({method, {}, styles.at(method)});
  return chart.curves.back();
}

std::string error_label(const Subject& subject) {
  return subject.unit.empty() ? "worst error" : "worst error, in " + subject.unit;
}

/// Joins the dots of each family; the last is named whole, the others by their numbers alone.
void join_families(plot::Chart& chart, const Findings& findings) {
  const std::map<std::string, std::string> families = families_of(findings);
  std::map<std::string, std::map<int, plot::Dot*>> members;
  for (plot::Dot& dot : chart.dots) {
    const auto family = families.find(dot.name);
    if (family != families.end() && family->second != dot.name)
      members[family->second][number_of(dot.name)] = &dot;
  }
  for (const auto& [family, dots] : members) {
    plot::Curve curve{"", {}, dots.begin()->second->style};
    for (const auto& [number, dot] : dots) {
      if (dot->at.y > 0) curve.points.push_back(dot->at);
      if (number != dots.rbegin()->first) dot->name = fmt::format("{}", number);
    }
    chart.curves.push_back(std::move(curve));
  }
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

benchmark::BenchmarkReporter::Run run_of(const Subject& subject, const Duel& duel, const std::string& peer) {
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
  run.report_label = peer;
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
    for (const Duel& duel : found.duels) runs.push_back(run_of(*found.subject, duel, found.peer));
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
      run.counters["items"] = static_cast<double>(result.of.items);
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
    benchmark::AddCustomContext("machine", machine());
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
  // Where answers are right or wrong and nothing between, how many are wrong
  const auto is_exact = [](const Result& r) { return r.of.error->max == 0; };
  const auto is_right = [](const Result& r) { return r.of.error->wrong == 0; };
  const bool counted = std::ranges::all_of(compared, is_exact) && !std::ranges::all_of(compared, is_right);
  const std::vector<bool> best = pareto_optimal(compared);
  const auto styles = styles_of(findings);
  plot::Chart chart = chart_of(
      findings,
      fmt::format("{} · low and left is better; no method beats a ringed one in both", subject.telling));
  chart.x = {fmt::format("time {}, in ns", one(subject.item))};
  chart.y = {counted ? "number of " + subject.unit : error_label(subject), "0"};
  for (std::size_t i = 0; i < compared.size(); ++i) {
    const Case& of = compared[i].of;
    const double error = counted ? static_cast<double>(of.error->wrong) : of.error->max;
    std::string name = of.method;
    if (of.error->wrong > 0 && !counted)
      name += fmt::format(", {} wrong", fmt::group_digits(of.error->wrong));
    chart.dots.push_back({name, {compared[i].nanoseconds, error}, styles.at(of.method), best[i]});
  }
  join_families(chart, findings);
  return chart;
}

std::optional<plot::Chart> size_chart(const Findings& findings) {
  const Subject& subject = *findings.subject;
  const auto styles = styles_of(findings);
  plot::Chart chart =
      chart_of(findings, "time against size · slope 1: in proportion, slope 2: as its square");
  // By method; a run is what takes longer as the size grows
  for (const Result& result : findings.results) {
    const Case& of = result.of;
    if (of.workload.size <= 0) continue;
    curve_of(chart, of.method, styles)
        .points.push_back({of.workload.size, result.nanoseconds * static_cast<double>(of.items) * 1e-3});
  }
  if (chart.curves.empty()) return std::nullopt;
  for (plot::Curve& curve : chart.curves) {
    std::ranges::sort(curve.points, {}, &dvec2::x);
    if (const auto exponent = plot::slope(curve.points))
      curve.name += fmt::format(", slope {}{:.2f}", *exponent <= -0.005 ? "−" : "", std::abs(*exponent));
  }
  chart.x = {fmt::format("n: {}", subject.measure)};
  chart.y = {"time a run, in µs"};
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
  std::ranges::sort(series, {}, [](const Result& r) { return r.of.workload.size; });
  const auto styles = styles_of(findings);
  plot::Chart chart = chart_of(findings, fmt::format("each line from {} {} to {} · low and left is better",
                                                     series.front().of.workload.size, subject.measure,
                                                     series.back().of.workload.size));
  chart.x = {fmt::format("time {}, in ns", one(subject.item))};
  chart.y = {error_label(subject), "0"};
  for (const Result& result : series) {
    const dvec2 at{result.nanoseconds, result.of.error->max};
    curve_of(chart, result.of.method, styles).points.push_back(at);
  }
  // Named beside their last points, wherever those are
  for (plot::Curve& curve : chart.curves) {
    chart.dots.push_back({std::exchange(curve.name, ""), curve.points.back(), curve.style});
  }
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
