// Lectures: every problem is told with its line, and what is whole can be said again as a command.

#include <cstdint>
#include <string>
#include <string_view>

#include "cli/command_line/errors.hpp"
#include "cli/lecture/lecture.hpp"
#include "core/image.hpp"
#include "support/fuzz_input.hpp"

using namespace gradus;
using gradus::test::require;

namespace {

/// Two files are there; all other names lead nowhere.
std::string find(const std::string& name, const std::string& flag) {
  for (const char* known : {"examples/models/letter_f.obj", "examples/images/camera.png"}) {
    if (std::string_view(known).ends_with("/" + name)) return std::string(GRADUS_SOURCE_DIR) + "/" + known;
  }
  throw UsageError(flag + ": expected a file, found none");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  cli::LectureFile file;
  file.name = "l.json";
  file.text = std::string(reinterpret_cast<const char*>(data), size);
  file.find = find;
  cli::Lecture lecture;
  try {
    lecture = cli::read_lecture(file);
  } catch (const InputError& error) {
    require(test::harmless(error.what()), "an error is safe to show");
    return 0;
  }
  for (const cli::Problem& problem : lecture.problems) {
    require(problem.text.starts_with("l.json:"), "a problem names its file");
    require(test::harmless(problem.text), "a problem is safe to show");
  }
  if (!lecture.problems.empty()) return 0;
  for (const cli::LectureFigure& figure : lecture.figures) {
    require(figure.spec.topic != nullptr, "a figure has a topic");
    require(!cli::command_of(figure.spec).empty() && !figure.contents().empty(), "a figure can be said");
  }
  for (const cli::LectureRender& render : lecture.renders) {
    require(render.brief.width > 0 && render.brief.height > 0, "a render has a size");
  }
  return 0;
}
