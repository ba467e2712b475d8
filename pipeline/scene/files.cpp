#include "scene/files.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <utility>

#include "core/refusal.hpp"
#include "core/shown.hpp"
#include "scene/models/model_formats.hpp"

namespace gradus::pipeline {
namespace {

namespace fs = std::filesystem;

class OpenFile {
 public:
  // Opening a pipe does not wait for who writes into it
  explicit OpenFile(const std::string& path)
      : number_(open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NOCTTY | O_NONBLOCK)) {}
  ~OpenFile() {
    if (number_ >= 0) close(number_);
  }
  OpenFile(const OpenFile&) = delete;
  OpenFile& operator=(const OpenFile&) = delete;
  int number() const { return number_; }

 private:
  int number_;
};

std::string_view kind_of(mode_t mode) {
  if (S_ISDIR(mode)) return "the folder";
  if (S_ISFIFO(mode)) return "the pipe";
  if (S_ISSOCK(mode)) return "the socket";
  return "the device";
}

FileRead unreadable(const std::string& path) {
  const int reason = errno;
  return {"", fmt::format("expected a readable file, found {} ({})", shown(path), std::strerror(reason))};
}

/// The system would take such a name for what stands before.
bool has_nul(const std::string& path) { return path.find('\0') != std::string::npos; }

FileRead irregular(const std::string& path, mode_t mode) {
  return {"", fmt::format("expected a regular file, found {} {}", kind_of(mode), shown(path))};
}

FileRead too_large(const std::string& path, std::size_t most) {
  return {"", fmt::format("expected a file of at most {} MiB, found {}", most >> 20, shown(path))};
}

/// Where a name leads from a folder: as it says, else to its last part there; nothing where no file is.
std::optional<fs::path> place_of(const fs::path& folder, std::string name) {
  if (has_nul(name)) return std::nullopt;
  std::ranges::replace(name, '\\', '/');
  for (const fs::path& candidate : {folder / name, folder / fs::path(name).filename()}) {
    std::error_code error;
    if (fs::exists(candidate, error) && !fs::is_directory(candidate, error)) return candidate;
  }
  return std::nullopt;
}

/// The file at a place that a name leads to from a folder.
LibraryText text_at(const fs::path& place, const fs::path& folder, const std::string& name, std::size_t most,
                    const Took& took) {
  LibraryText text;
  FileRead file = read_regular_file(place.string(), most);
  text.text = std::move(file.bytes);
  text.problem = std::move(file.problem);
  text.quotable = lies_in(folder, place);
  if (took && text.problem.empty()) took(name, place.string(), text);
  return text;
}

}  // namespace

FileRead read_regular_file(const std::string& path, std::size_t most) {
  struct stat known{};
  if (has_nul(path)) return {"", fmt::format("expected a file's name without NUL, found {}", shown(path))};
  if (stat(path.c_str(), &known) != 0) return unreadable(path);
  if (!S_ISREG(known.st_mode)) return irregular(path, known.st_mode);
  const OpenFile file(path);
  if (file.number() < 0 || fstat(file.number(), &known) != 0) return unreadable(path);
  if (!S_ISREG(known.st_mode)) return irregular(path, known.st_mode);  // another one by now
  if (static_cast<std::uintmax_t>(known.st_size) > most) return too_large(path, most);
  FileRead result;
  result.bytes.reserve(static_cast<std::size_t>(known.st_size));
  char block[1 << 16];
  while (true) {
    const ssize_t count = read(file.number(), block, sizeof block);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return unreadable(path);
    if (count == 0) return result;
    // It may grow meanwhile, and files of /proc say that they have no size
    if (result.bytes.size() + static_cast<std::size_t>(count) > most) return too_large(path, most);
    result.bytes.append(block, static_cast<std::size_t>(count));
  }
}

bool lies_in(const fs::path& folder, const fs::path& file) {
  std::error_code error;
  const fs::path whole = fs::canonical(folder.empty() ? "." : folder, error);
  if (error) return false;
  const fs::path place = fs::canonical(file, error);
  return !error && std::ranges::mismatch(whole, place).in1 == whole.end();
}

FileReader libraries_beside(const std::string& model, Took took) {
  const fs::path folder = fs::path(model).parent_path();
  const std::size_t most = is_other_format(model) ? most_file_bytes : most_library_bytes;
  return [folder, most, took = std::move(took)](const std::string& name) -> std::optional<LibraryText> {
    const std::optional<fs::path> place = place_of(folder, name);
    if (!place) return std::nullopt;
    return text_at(*place, folder, name, most, took);
  };
}

ModelFinder models_beside(const std::string& scene, const Took& took) {
  const fs::path folder = fs::path(scene).parent_path();
  return [folder, took](const std::string& name) -> std::optional<FoundModel> {
    const std::optional<fs::path> place = place_of(folder, name);
    if (!place) return std::nullopt;
    LibraryText text = text_at(*place, folder, name, most_file_bytes, took);
    return FoundModel{std::move(text), place->string(), libraries_beside(place->string(), took)};
  };
}

SceneFile load_scene(const std::string& path, const PictureDecoder& decode) {
  const FileRead file = read_regular_file(path);
  if (!file.problem.empty()) refuse_input(file.problem);
  return parse_scene(file.bytes, path, models_beside(path), decode);
}

ModelFile load_obj(const std::string& path) {
  const FileRead file = read_regular_file(path);
  if (!file.problem.empty()) refuse_input(file.problem);
  return parse_obj(file.bytes, path, libraries_beside(path));
}

}  // namespace gradus::pipeline
