#include "cli/files/shipped.hpp"

#include <algorithm>
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
  for (const char* const folder :
       {"examples/models/", "examples/images/", "examples/scenes/", "examples/demos/"}) {
    for (const char* const ending : {"", ".obj", ".png", ".json"}) {
      if (std::string path = shipped(folder + std::string(name) + ending); !path.empty()) return path;
    }
  }
  return "";
}

std::vector<std::string> shipped_examples(std::string_view ending) {
  std::vector<std::string> names;
  const fs::path examples = fs::path(shipped("examples/gallery.json")).parent_path();
  std::error_code error;
  for (const char* const folder : {"models", "images", "scenes"}) {
    // Scenes lie beside models that are only parts of them
    if ((ending == ".json") != (folder == std::string_view("scenes"))) continue;
    for (const fs::directory_entry& entry : fs::directory_iterator(examples / folder, error)) {
      if (entry.path().extension() == ending) names.push_back(entry.path().filename().string());
    }
  }
  std::ranges::sort(names);
  return names;
}

}  // namespace gradus::cli
