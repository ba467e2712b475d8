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

/// Every topic's run on its usual input, in every language.
std::string recorded_runs() {
  std::vector<std::string> by_language;
  for (const Language& language : languages()) {
    std::vector<std::string> runs;
    for (const TopicEntry* topic : catalogue()) {
      const Trace trace = trace_of(*topic, {}, {.wording = Wording(language)});
      runs.push_back(fmt::format("{}:{}", json_quoted(topic->name), trace_json(trace)));
    }
    by_language.push_back(fmt::format("{}:{{{}}}", json_quoted(language.code()), fmt::join(runs, ",")));
  }
  return fmt::format("{{{}}}", fmt::join(by_language, ","));
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
