// Writes the live page twice: as one file with the module in it, and as a site that loads the module.
//
//   gradus-live-pages MODULE FOLDER     (./bootstrap live)

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>

#include "json/json.hpp"
#include "request/notation_reader.hpp"
#include "stories/topic.hpp"
#include "web/live_page.hpp"

namespace {

using namespace gradus;

std::string bytes_of(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::string bytes{std::istreambuf_iterator<char>(file), {}};
  if (!file || bytes.empty())
    throw std::runtime_error(fmt::format("{}: expected a module, found nothing", path.string()));
  return bytes;
}

void write(const std::filesystem::path& path, const std::string& text) {
  std::ofstream file(path, std::ios::binary);
  file << text;
  if (!file.flush()) throw std::runtime_error(fmt::format("{}: cannot be written", path.string()));
}

/// Every topic's run on its usual input: in English, which is there without the module, and no more than what
/// tells how it goes.
std::string recorded_runs() {
  constexpr std::int64_t most = 40;
  std::vector<std::string> runs;
  for (const TopicEntry* topic : catalogue())
    runs.push_back(
        fmt::format("{}:{}", json_quoted(topic->name), trace_json(trace_of(*topic, {}, {.most = most}))));
  return fmt::format("{{\"en\":{{{}}}}}", fmt::join(runs, ","));
}

}  // namespace

int main(int count, char** arguments) try {
  if (count != 3) throw std::runtime_error("usage: gradus-live-pages MODULE FOLDER");
  const std::filesystem::path folder = arguments[2];
  const std::string module = bytes_of(arguments[1]);
  const LiveContent content{list_json(catalogue()), notation_names(), recorded_runs()};
  std::filesystem::create_directories(folder);
  write(folder / "gradus.html", live_page(content, module));
  write(folder / "index.html", live_page(content, ""));
  write(folder / "gradus.wasm", module);
} catch (const std::exception& error) {
  std::cerr << "gradus-live-pages: " << error.what() << '\n';
  return 1;
}
