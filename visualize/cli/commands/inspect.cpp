// `gradus inspect`: what stands in a file of data for `gradus demo`.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <filesystem>

#include "cli/command_line/inputs.hpp"
#include "cli/commands/commands.hpp"
#include "cli/files/files.hpp"
#include "request/written_json.hpp"
#include "scene/road/road_demo.hpp"
#include "text/table.hpp"
#include "text/wrap.hpp"

namespace gradus::cli {
namespace {

using pipeline::DataEntry;
using pipeline::RoadDemo;

std::string type_of(const DataEntry& entry) { return entry.whole ? "int" : "float"; }

/// "3 x 16", "3", or nothing for a single number.
std::string shape_of(const DataEntry& entry) { return fmt::format("{}", fmt::join(entry.shape, " x ")); }

std::string table(const RoadDemo& demo) {
  std::vector<std::vector<std::string>> rows{{"key", "type", "shape", "what it is"}};
  for (const DataEntry& e : demo.entries)
    rows.push_back({std::string(e.key), type_of(e), shape_of(e), std::string(e.meaning)});
  return table_of(rows, {false, false, false, false});
}

std::string summary(const RoadDemo& demo, const std::string& name) {
  return fmt::format("{}: {} keys; {} vertices, {} triangles; {} frames in {} s\n\n", name,
                     demo.entries.size(), demo.positions.size(), demo.triangles.size(), frame_count(demo),
                     demo.seconds);
}

std::string as_json(const RoadDemo& demo, const std::string& name) {
  const auto count = [](std::size_t n) { return json_number(fmt::format("{}", n)); };
  std::vector<JsonNode> keys;
  for (const DataEntry& e : demo.entries) {
    std::vector<JsonNode> shape;
    for (const std::size_t n : e.shape) shape.push_back(count(n));
    keys.push_back(json_object({{"key", 0, json_text(e.key)},
                                {"type", 0, json_text(type_of(e))},
                                {"shape", 0, json_list(std::move(shape))},
                                {"meaning", 0, json_text(e.meaning)}}));
  }
  return write_json(json_object({{"file", 0, json_text(name)},
                                 {"keys", 0, json_list(std::move(keys))},
                                 {"vertices", 0, count(demo.positions.size())},
                                 {"triangles", 0, count(demo.triangles.size())},
                                 {"frames", 0, count(static_cast<std::size_t>(frame_count(demo)))}}));
}

}  // namespace

int inspect(const Request& request) {
  const std::string& operand = request.operands.at(0);
  const bool from_stdin = operand == dash;
  const std::string path = from_stdin ? operand : as_named(operand, "FILE").path;
  const RoadDemo demo =
      pipeline::parse_road_demo(read_input(path, "FILE"), from_stdin ? "standard input" : path);
  const std::string name = from_stdin ? operand : std::filesystem::path(operand).filename().string();
  write_stream(Stream::out, request.has("json")
                                ? as_json(demo, name)
                                : wrapped(summary(demo, name) + table(demo), request.width()));
  return 0;
}

}  // namespace gradus::cli
