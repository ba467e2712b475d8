#include "cli/imported_model.hpp"

#include <assimp/MemoryIOWrapper.h>
#include <assimp/config.h>

#include <assimp/IOSystem.hpp>
#include <assimp/Importer.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cli/gltf_check.hpp"
#include "cli/gltf_data.hpp"
#include "cli/imported_scene.hpp"
#include "cli/model_bytes.hpp"
#include "cli/own_process.hpp"
#include "core/refusal.hpp"
#include "core/shown.hpp"

namespace gradus::cli {
namespace {

using pipeline::LibraryText;

constexpr std::string_view no_model = "expected a model of this format, found another or a damaged one";

/// The files that Assimp gets to see: the model, which has been read, and what a FileReader finds beside it.
/// Nothing is written.
class FilesBeside : public Assimp::IOSystem {
 public:
  FilesBeside(std::string name, std::string_view model, const pipeline::FileReader& open)
      : name_(std::move(name)), model_(model), open_(open) {}

  bool Exists(const char* path) const override { return bytes_of(path).has_value(); }
  char getOsSeparator() const override { return '/'; }
  Assimp::IOStream* Open(const char* path, const char* mode) override {
    const auto bytes = *mode == 'r' ? bytes_of(path) : std::nullopt;
    if (!bytes) {
      missed_ = path;
      return nullptr;
    }
    return new Assimp::MemoryIOStream(reinterpret_cast<const std::uint8_t*>(bytes->data()), bytes->size());
  }
  void Close(Assimp::IOStream* stream) override { delete stream; }
  bool ComparePaths(const char* one, const char* other) const override {
    return std::string_view(one) == other;
  }
  bool CreateDirectory(const std::string&) override { return false; }
  bool ChangeDirectory(const std::string&) override { return false; }
  bool DeleteFile(const std::string&) override { return false; }

  /// Why the last file that was asked for and not given was not: "expected …, found …"; empty when all were.
  std::string problem(bool quotable) const {
    if (missed_.empty()) return "";
    if (!quotable) return "expected a model whose other files can be read";
    const auto found = beside_.find(missed_);
    if (found == beside_.end() || !found->second)
      return fmt::format("expected the file {} beside it, found none", shown(missed_));
    return found->second->problem;
  }

  /// The names of the files beside the model that were read.
  std::vector<std::string> asked() const { return asked_; }

 private:
  std::optional<std::string_view> bytes_of(const std::string& path) const {
    if (path == name_) return model_;
    auto [found, is_new] = beside_.try_emplace(path);
    if (is_new) {
      for (const std::string& name : {path, name_in_uri(path)}) {
        if (found->second) continue;
        found->second = open_(name);
        if (found->second) asked_.push_back(name);
      }
    }
    if (!found->second || !found->second->problem.empty()) return std::nullopt;
    return found->second->text;
  }

  std::string name_;
  std::string_view model_;
  const pipeline::FileReader& open_;
  std::string missed_;
  mutable std::map<std::string, std::optional<LibraryText>> beside_;
  mutable std::vector<std::string> asked_;
};

/// The first line of what Assimp says.
std::string complaint_of(const Assimp::Importer& importer) {
  const std::string_view text = importer.GetErrorString();
  return visible(text.substr(0, std::min<std::size_t>(text.find('\n'), 200)));
}

/// Reads a model within the process that may be lost. asked: gets the names of the files beside it that were
/// read.
pipeline::ModelFile read_by_assimp(std::string_view bytes, const pipeline::TextFile& file,
                                   const pipeline::FileReader& open, std::vector<std::string>& asked) {
  const std::string ending = pipeline::ending_of(file.name);
  const bool gltf = ending == "gltf" || ending == "glb";
  const std::string name = std::filesystem::path(file.name).filename().string();
  Assimp::Importer importer;
  auto* const files = new FilesBeside(name, bytes, open);
  importer.SetIOHandler(files);  // which owns them from now on
  importer.SetPropertyBool(AI_CONFIG_IMPORT_NO_SKELETON_MESHES, true);
  const aiScene* scene = importer.ReadFile(name, 0);
  asked = files->asked();
  if (scene) return model_of(*scene, file, {.flat = gltf, .uris = gltf});
  std::string problem = files->problem(file.quotable);
  if (problem.empty()) {
    problem = no_model;
    if (file.quotable) problem += fmt::format(" ({})", complaint_of(importer));
  }
  refuse_input(fmt::format("{}: {}", shown_name(file.name), problem));
}

/// What crosses from that process: names, each with a zero behind it, one more zero, how it went, and the
/// model or the refusal.
constexpr char went_well = 'm', was_refused = 'r';

std::string answer_of(std::string_view bytes, const pipeline::TextFile& file,
                      const pipeline::FileReader& open) {
  std::vector<std::string> asked;
  std::string result;
  try {
    result = went_well + bytes_of(read_by_assimp(bytes, file, open, asked));
  } catch (const InputError& error) {
    result = was_refused + std::string(error.what());
  }
  std::string names;
  for (const std::string& name : asked) names += name + '\0';
  return names + '\0' + result;
}

/// Takes the names from the front of an answer.
std::vector<std::string> take_names(std::string_view& answer) {
  std::vector<std::string> names;
  while (!answer.empty()) {
    const std::string_view name = answer.substr(0, answer.find('\0'));
    answer.remove_prefix(std::min(name.size() + 1, answer.size()));
    if (name.empty()) break;
    names.emplace_back(name);
  }
  return names;
}

/// Many times what a model of so many bytes takes that is what it seems to be.
ProcessLimits limits_for(std::size_t bytes) {
  constexpr std::size_t mib = std::size_t{1} << 20, gib = std::size_t{1} << 30;
  return {.seconds = 10 + bytes / mib, .bytes = gib + 64 * bytes};
}

/// Assimp was not made for files that want to do harm, and some that are merely damaged make it crash.
pipeline::ModelFile import_model(std::string_view bytes, const pipeline::TextFile& file,
                                 const pipeline::FileReader& read) {
  const std::string ending = pipeline::ending_of(file.name);
  std::map<std::string, std::optional<LibraryText>> known;  // so that no file is read twice
  const pipeline::FileReader open = [&](const std::string& name) {
    const auto [found, is_new] = known.try_emplace(name);
    if (is_new) found->second = read(name);
    return found->second;
  };
  if (ending == "gltf" || ending == "glb") check_gltf(bytes, file, open);
  const auto refuse = [&file](std::string_view what) {
    refuse_input(fmt::format("{}: {}", shown_name(file.name), what));
  };
  const ProcessResult result =
      in_own_process([&] { return answer_of(bytes, file, open); }, limits_for(bytes.size()));
  if (result.end == ProcessResult::End::too_much)
    refuse(fmt::format("{} (Assimp does not come to an end)", no_model));
  if (result.end == ProcessResult::End::crashed) refuse(fmt::format("{} (Assimp has crashed)", no_model));
  std::string_view answer = result.bytes;
  // Whoever reads files for us is told here what has been read there
  for (const std::string& name : take_names(answer)) open(name);
  if (answer.starts_with(was_refused)) refuse_input(std::string(answer.substr(1)));
  std::optional<pipeline::ModelFile> model =
      model_in_bytes(answer.substr(std::min<std::size_t>(1, answer.size())));
  if (!model) refuse(no_model);
  return *std::move(model);
}

}  // namespace

pipeline::ModelImporter model_importer() { return import_model; }

}  // namespace gradus::cli
