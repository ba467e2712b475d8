// `gradus explain`: what a scene needs, before it is rendered.

#include "cli/commands/explain.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <vector>

#include "cairo/cairo_output.hpp"
#include "cli/command_line/errors.hpp"
#include "cli/commands/commands.hpp"
#include "cli/commands/render.hpp"
#include "cli/files/files.hpp"
#include "core/mesh.hpp"
#include "core/shown.hpp"
#include "pipeline.hpp"
#include "plan/decisions.hpp"
#include "plan/levels.hpp"
#include "plan/planned.hpp"
#include "plan/spared.hpp"
#include "plot/heat_map.hpp"
#include "request/names.hpp"
#include "request/written_json.hpp"
#include "text/table.hpp"
#include "theme/theme.hpp"

namespace gradus::cli {
namespace {

using pipeline::Decision;
using pipeline::Ledger;
using pipeline::LedgerRow;
using pipeline::Plan;
using pipeline::Scene;
using pipeline::Work;

using TextRow = std::vector<std::string>;

// --- The plan --------------------------------------------------------------------------------------

/// Objects that are treated alike.
struct Alike {
  std::int64_t objects = 0, triangles = 0;
  std::string first;     ///< the name of the first of them
  bool skipped = false;  ///< they are left out whole
};

/// What is done with an object, a line for stages that do the same.
std::string treatment(const std::vector<Decision>& decisions) {
  std::vector<TextRow> rows;
  for (std::size_t i = 0; i < decisions.size();) {
    const auto& [first, work, why] = decisions[i];
    std::size_t end = i + 1;
    while (end < decisions.size() && decisions[end].work == work && decisions[end].why == why) ++end;
    const int last = decisions[end - 1].stage;
    rows.push_back({first == last ? fmt::format("    {}", first) : fmt::format("    {} to {}", first, last),
                    std::string(name_of(work)), why});
    i = end;
  }
  return table_of(rows, {false, false, false});
}

std::vector<std::pair<std::string, Alike>> by_treatment(const Scene& scene, const Plan& plan) {
  std::vector<std::pair<std::string, Alike>> groups;
  std::map<std::string, std::size_t> known;
  for (int number = 0; number < std::ssize(scene.objects); ++number) {
    const bool skipped = !plan.draws(number);
    const std::string how = treatment(decisions_on(scene, plan, number));
    const auto [place, is_new] = known.try_emplace(how, groups.size());
    if (is_new) groups.push_back({how, {0, 0, object_at(scene, number).name, skipped}});
    Alike& alike = groups[place->second].second;
    ++alike.objects;
    alike.triangles += triangle_count(*object_at(scene, number).mesh);
  }
  std::ranges::stable_sort(groups, {}, [](const auto& group) { return group.second.skipped; });
  return groups;
}

/// Over the objects: how many run, run on a part and are left out, at each stage.
std::array<std::array<std::int64_t, 3>, pipeline::object_stages> works_of(const Scene& scene,
                                                                          const Plan& plan) {
  std::array<std::array<std::int64_t, 3>, pipeline::object_stages> counts{};
  for (int number = 0; number < std::ssize(scene.objects); ++number) {
    for (const Decision& decision : decisions_on(scene, plan, number))
      ++counts[static_cast<std::size_t>(decision.stage - 1)][static_cast<std::size_t>(decision.work)];
  }
  return counts;
}

/// Frames one after the other, each with the last of them: {65, 74}.
std::vector<std::pair<int, int>> runs_of(const std::vector<int>& frames) {
  std::vector<std::pair<int, int>> runs;
  for (const int frame : frames) {
    if (runs.empty() || runs.back().second + 1 != frame) runs.emplace_back(frame, frame);
    runs.back().second = frame;
  }
  return runs;
}

/// "frame 0 of 0 to 124; unchanged since the one before: 65 to 74".
std::string path_line(const PathFacts& path) {
  std::vector<std::string> runs;
  for (const auto& [first, last] : runs_of(path.unchanged))
    runs.push_back(first == last ? fmt::format("{}", first) : fmt::format("{} to {}", first, last));
  return fmt::format("frame {} of {} to {}; {}\n", path.shown, path.first, path.last,
                     runs.empty() ? "every frame is rendered anew"
                                  : fmt::format("unchanged since the one before: {}", fmt::join(runs, ", ")));
}

std::string head_of(const std::string& name, const Scene& scene, const Plan& plan) {
  std::int64_t triangles = 0;
  for (const pipeline::Object& object : scene.objects) triangles += triangle_count(*object.mesh);
  return fmt::format("{}: {}, {}, {} x {} of {} x {} pixels\n", visible(name),
                     counted(std::ssize(scene.objects), "object"), counted(triangles, "triangle"),
                     plan.window.width(), plan.window.height(), plan.size.width, plan.size.height) +
         order_text(scene);
}

}  // namespace

std::string plan_text(const std::string& name, const Scene& scene, const Plan& plan,
                      const std::optional<PathFacts>& path) {
  std::vector<TextRow> stages{{"stage", "run", "part", "skip"}};
  const auto works = works_of(scene, plan);
  for (std::size_t i = 0; i < works.size(); ++i) {
    const auto& [run, part, skip] = works[i];
    stages.push_back({fmt::format("{} {}", i + 1, pipeline::stage_names[i]), fmt::format("{}", run),
                      fmt::format("{}", part), fmt::format("{}", skip)});
  }
  std::string text = head_of(name, scene, plan) + (path ? path_line(*path) : "") + "\n" +
                     table_of(stages, {false, true, true, true});
  for (const auto& [how, alike] : by_treatment(scene, plan)) {
    const std::string first = visible(alike.first);
    text += fmt::format("\n{}, {}: {}\n{}", counted(alike.objects, "object"),
                        counted(alike.triangles, "triangle"),
                        alike.objects == 1 ? first : first + " and others", how);
  }
  return text;
}

std::string plan_json(const std::string& name, const Scene& scene, const Plan& plan,
                      const std::optional<PathFacts>& path) {
  const auto number = [](auto value) { return json_number(fmt::format("{}", value)); };
  std::vector<JsonNode> objects;
  for (int i = 0; i < std::ssize(scene.objects); ++i) {
    std::vector<JsonNode> stages;
    for (const Decision& decision : decisions_on(scene, plan, i)) {
      stages.push_back(json_object({{"stage", 0, number(decision.stage)},
                                    {"work", 0, json_text(name_of(decision.work))},
                                    {"why", 0, json_text(decision.why)}}));
    }
    std::vector<JsonNode> lights;
    for (int light : plan.of(i).lights) lights.push_back(number(light));
    objects.push_back(json_object({{"number", 0, number(i)},
                                   {"name", 0, json_text(object_at(scene, i).name)},
                                   {"triangles", 0, number(triangle_count(*object_at(scene, i).mesh))},
                                   {"level", 0, number(pipeline::level_of(object_at(scene, i)))},
                                   {"lights", 0, json_list(std::move(lights))},
                                   {"stages", 0, json_list(std::move(stages))}}));
  }
  const auto& [lower, upper] = plan.window;
  std::vector<JsonMember> members{{"scene", 0, json_text(name)},
                                  {"width", 0, number(plan.size.width)},
                                  {"height", 0, number(plan.size.height)},
                                  {"part", 0,
                                   json_list({number(lower.x), number(lower.y), number(plan.window.width()),
                                              number(plan.window.height())})}};
  if (path) {
    std::vector<JsonNode> unchanged;
    for (const int frame : path->unchanged) unchanged.push_back(number(frame));
    members.push_back({"frames", 0,
                       json_object({{"first", 0, number(path->first)},
                                    {"last", 0, number(path->last)},
                                    {"shown", 0, number(path->shown)},
                                    {"unchanged", 0, json_list(std::move(unchanged))}})});
  }
  members.push_back({"objects", 0, json_list(std::move(objects))});
  return write_json(json_object(std::move(members)));
}

std::string ledger_text(const std::string& name, const Ledger& ledger, std::string_view drawn_by) {
  std::vector<TextRow> rows{{"stage", "of", "total", "done", "left out", "why"}};
  for (const LedgerRow* row : ledger.rows()) {
    std::vector<std::string> why;
    for (const pipeline::Skipped& part : row->skipped)
      why.push_back(fmt::format("{} {}", part.why, part.count));
    rows.push_back({fmt::format("{} {}", row->stage, row->name), std::string(row->unit),
                    fmt::format("{}", row->total), fmt::format("{}", row->done),
                    fmt::format("{}", row->skipped_in_all()), fmt::format("{}", fmt::join(why, ", "))});
  }
  const auto ms = [](double seconds) { return fmt::format("{:.1f} ms", 1000 * seconds); };
  return fmt::format("{}: done and left out\n\n", visible(name)) +
         table_of(rows, {false, false, true, true, true, false}) +
         fmt::format(
             "\ndrawn by {}\nreading {}, mip maps and buffers {}, planning {}, stages 1 to 5 {}, 6 and 7 {}, "
             "8 {}, "
             "the file {}\n",
             drawn_by, ms(ledger.reading), ms(ledger.preparing), ms(ledger.planning), ms(ledger.geometry),
             ms(ledger.pixels), ms(ledger.writing), ms(ledger.encoding));
}

namespace {

// --- The heat map ----------------------------------------------------------------------------------

/// "1134 of 1391 objects are left out: 914 outside, 220 hidden."
std::string left_out_sentence(const Plan& plan) {
  std::map<pipeline::Rule, std::int64_t> counts;
  std::int64_t all = 0;
  for (const pipeline::ObjectPlan& object : plan.objects) {
    if (!object.skipped) continue;
    ++counts[*object.skipped];
    ++all;
  }
  std::vector<std::string> parts;
  for (const auto& [rule, count] : counts)
    parts.push_back(fmt::format(
        "{} {}", count, rule == pipeline::Rule::area_of_interest ? "beside the part" : name_of(rule)));
  const std::string objects = counted(std::ssize(plan.objects), "object");
  if (all == 0) return "No object is left out as a whole; backs, lamps and highlights are.";
  return fmt::format("{} of {} {} left out: {}.", all, objects, all == 1 ? "is" : "are",
                     fmt::join(parts, ", "));
}

plot::HeatMap heat_map_of(const RenderJob& job, Plan& plan) {
  plot::HeatMap map;
  map.title = fmt::format("{}: what rendering it leaves out", visible(scene_name(job.brief)));
  map.subtitle =
      "fragments, lamps and highlights of a pixel's centre that are never computed; the picture is the same";
  map.amounts = work_spared(job.scene, plan);
  map.picture = render(job.scene, job.size);
  map.unit = "left out";
  map.sentence = left_out_sentence(plan);
  return map;
}

/// Writes the heat map as its name's ending says.
void write_heat_map(const RenderJob& job, Plan& plan, const std::string& output, Replace replace) {
  const plot::HeatMap map = heat_map_of(job, plan);
  const Sheet sheet = plot::sheet_of(map);
  const Colophon colophon{map.title, map.subtitle + ". " + map.sentence, job.brief.colophon.command,
                          job.brief.colophon.input_hash};
  const bool svg = folded(std::filesystem::path(output).extension().string()) == ".svg";
  write_output(output,
               svg ? svg_of(sheet, themes().front(), colophon) : png_of(sheet, themes().front(), colophon),
               replace);
}

void check_heat_map_output(const std::string& output, const RenderBrief& brief, Replace replace) {
  const std::string ending = folded(std::filesystem::path(output).extension().string());
  if (ending != ".png" && ending != ".svg")
    throw UsageError(fmt::format("-o: expected a name that ends in .png or .svg, found {}", shown(output)));
  check_output(output, brief.files, replace);
}

}  // namespace

int explain(const Request& request) {
  RenderJob job = render_job(request);
  const auto output = request.flags.find("output");
  const Replace replace = replaces(request.has("force"));
  if (output != request.flags.end() && request.has("json"))
    throw UsageError("--json: expected alone, without -o: it prints, found -o");
  if (output != request.flags.end()) check_heat_map_output(output->second, job.brief, replace);
  if (!request.quiet())
    for (const std::string& remark : job.brief.remarks) note(remark);
  Plan plan = plan_of(job.scene, job.size, job.plan.rules, job.plan.part);
  if (output != request.flags.end()) {
    write_heat_map(job, plan, output->second, replace);
    if (!request.quiet()) note(shown_name(output->second));
    return 0;
  }
  Ledger ledger;
  geometry(job.scene, plan, ledger);  // finds what is hidden
  const std::string name = scene_name(job.brief);
  const bool json = request.has("json");
  write_stream(Stream::out, json ? plan_json(name, job.scene, plan, job.path)
                                 : plan_text(name, job.scene, plan, job.path));
  return 0;
}

}  // namespace gradus::cli
