#include "cli/lecture/lecture.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "cli/command_line/errors.hpp"
#include "cli/files/files.hpp"
#include "cli/files/shipped.hpp"
#include "request/fingerprint.hpp"
#include "request/names.hpp"
#include "scene/files.hpp"

namespace gradus {

std::string_view example_text(std::string_view path);  // embedded by the build

namespace cli {
namespace {

namespace fs = std::filesystem;

/// Beside the lecture; else one of those that come with the program, so that a copy of the built-in gallery
/// works as it is. The lecture may be somebody else's: of files elsewhere nothing is quoted.
FoundFile find_beside(const fs::path& folder, const std::string& name) {
  std::error_code error;
  const fs::path beside = folder / name;
  if (!fs::is_regular_file(beside, error) && name.find("..") == std::string::npos) {
    if (std::string path = shipped("examples/" + name); !path.empty()) return path;
    if (std::string path = shipped_example(name); !path.empty()) return path;
  }
  return {beside.string(), pipeline::lies_in(folder, beside)};
}

}  // namespace

LectureFile lecture_at(const std::string& path) {
  LectureFile file;
  file.text = read_input(path, "LECTURE");
  file.name = path == dash ? "standard input" : shown_name(path);
  const fs::path folder = path == dash ? fs::path() : fs::path(path).parent_path();
  std::error_code error;
  const fs::path place = fs::canonical(path == dash ? fs::path(".") : fs::path(path), error);
  // The name for people; the fingerprint tells files of one name in two folders apart
  file.owner = fmt::format("{} {}", path == dash ? file.name : shown_name(fs::path(path).filename().string()),
                           fingerprint(place.string()));
  file.find = [folder](const std::string& name, const std::string&) { return find_beside(folder, name); };
  return file;
}

LectureFile gallery_lecture() {
  const std::string folder = "examples/";
  return {folder + "gallery.json", std::string(example_text("gallery.json")), "",
          [folder](const std::string& name, const std::string& flag) -> FoundFile {
            const std::string path = shipped(folder + name);
            if (!path.empty()) return path;
            throw WorkError(
                fmt::format("{}: expected the file {} here or in a folder above the program, found none",
                            flag, shown(folder + name)));
          }};
}

std::string LectureFigure::contents() const {
  std::string text =
      fmt::format("{}\n{}\n{}\n{}\n", name, caption, command_of(spec), input_hash(spec.arguments));
  for (const Format format : outputs) text += fmt::format("{} ", name_of(format));
  for (const auto& [flag, value] : request.flags) text += fmt::format("\n--{} {}", flag, shell_quoted(value));
  for (const std::string& label : request.labels) text += fmt::format("\n--label {}", shell_quoted(label));
  return text;
}

std::string LectureRender::contents() const {
  return fmt::format("{}\n{}\n{}\n{}\n{}", name, title, caption, brief.colophon.command,
                     brief.colophon.input_hash);
}

const LecturePart& part_of(const AnyPart& any) {
  return std::visit([](const auto* part) -> const LecturePart& { return *part; }, any);
}

std::vector<AnyPart> Lecture::parts() const {
  std::vector<AnyPart> all;
  for (const LectureFigure& figure : figures) all.emplace_back(&figure);
  for (const LectureRender& render : renders) all.emplace_back(&render);
  return all;
}

}  // namespace cli
}  // namespace gradus
