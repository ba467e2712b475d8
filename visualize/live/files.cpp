#include "live/files.hpp"

#include <fmt/format.h>

#include <utility>

#include "core/shown.hpp"
#include "request/complaint.hpp"

namespace gradus::live {
namespace {

std::string last_part(const std::string& name) { return name.substr(name.find_last_of("/\\") + 1); }

}  // namespace

void OpenedFiles::keep(const std::string& name, std::string bytes) {
  kept_.insert_or_assign(last_part(name), Kept{std::move(bytes)});
}

void OpenedFiles::keep_picture(const std::string& name, Image picture) {
  const auto file = kept_.find(last_part(name));
  if (file == kept_.end())
    refuse_usage(fmt::format("expected the picture of a file that is open here, found {}", shown(name)));
  file->second.picture = std::move(picture);
}

std::optional<std::string> OpenedFiles::bytes_of(const std::string& name) const {
  if (const auto file = kept_.find(name); file != kept_.end()) return file->second.bytes;
  const std::string_view shipped = shipped_model(name);
  return shipped.empty() ? std::nullopt : std::optional<std::string>(shipped);
}

GivenFile OpenedFiles::open(const std::string& name, const std::string& flag) {
  const std::string path = last_part(file_name_in(name));
  std::optional<std::string> bytes = bytes_of(path);
  if (!bytes) refuse_usage(fmt::format("{}: expected a file that is open here, found {}", flag, shown(path)));
  return {path, *std::move(bytes)};
}

pipeline::FileReader OpenedFiles::beside(const GivenFile&, Took took) {
  return [this, took = std::move(took)](const std::string& name) -> std::optional<pipeline::LibraryText> {
    const std::string path = last_part(name);
    std::optional<std::string> bytes = bytes_of(path);
    if (!bytes) return std::nullopt;
    pipeline::LibraryText text(*std::move(bytes));
    if (took) took(name, path, text);
    return text;
  };
}

Image OpenedFiles::picture(const GivenFile& file, const std::string& called, std::int64_t most_pixels) {
  const auto kept = kept_.find(file.path);
  if (kept == kept_.end() || !kept->second.picture)
    refuse_usage(fmt::format("{}: expected a file with its picture decoded", called));
  const Image& picture = *kept->second.picture;
  if (std::ssize(picture.cells()) > most_pixels) {
    refuse_input(fmt::format("{}: expected at most {} pixels, found {} x {}", shown_name(called), most_pixels,
                             picture.width(), picture.height()));
  }
  return picture;
}

}  // namespace gradus::live
