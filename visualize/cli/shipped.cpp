#include "cli/shipped.hpp"

#include <filesystem>
#include <string>

namespace gradus::cli {

namespace fs = std::filesystem;

std::string shipped(const std::string& name) {
  std::error_code error;
  if (fs::is_regular_file(name, error)) return name;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  for (fs::path folder = program.parent_path(); !folder.empty(); folder = folder.parent_path()) {
    for (const fs::path& candidate : {folder / name, folder / "share" / "gradus" / name}) {
      if (fs::is_regular_file(candidate, error)) return candidate.string();
    }
    if (folder == folder.root_path()) break;
  }
  return "";
}

std::string shipped_example(std::string_view name) {
  if (name.empty() || name.front() == '.' || name.find('/') != std::string_view::npos) return "";
  for (const char* const folder : {"examples/models/", "examples/images/"}) {
    for (const char* const ending : {"", ".obj", ".png"}) {
      if (std::string path = shipped(folder + std::string(name) + ending); !path.empty()) return path;
    }
  }
  return "";
}

}  // namespace gradus::cli
