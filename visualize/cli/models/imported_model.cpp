#include "cli/models/imported_model.hpp"

#include <assimp/cfileio.h>
#include <assimp/config.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "cli/models/gltf_check.hpp"
#include "cli/models/gltf_data.hpp"
#include "cli/models/imported_library.hpp"
#include "cli/models/imported_scene.hpp"
#include "cli/models/model_bytes.hpp"
#include "cli/system/own_process.hpp"
#include "core/refusal.hpp"
#include "core/shown.hpp"

namespace gradus::cli {
namespace {

using pipeline::LibraryText;

constexpr std::string_view no_model = "expected a model of this format, found another or a damaged one";

/// A file that Assimp has open: first what it calls, so that a pointer to one is a pointer to the other.
struct OpenFile {
  aiFile calls;
  std::string_view bytes;
  std::size_t at = 0;

  explicit OpenFile(std::string_view all)
      : calls{read, nullptr, tell, size, seek, nullptr, nullptr}, bytes(all) {}

  static OpenFile& of(aiFile* file) { return *reinterpret_cast<OpenFile*>(file); }
  static std::size_t read(aiFile* from, char* to, std::size_t item, std::size_t count) {
    OpenFile& file = of(from);
    if (item == 0) return 0;
    const std::size_t items = std::min(count, (file.bytes.size() - file.at) / item);
    file.at += file.bytes.copy(to, items * item, file.at);
    return items;
  }
  static std::size_t tell(aiFile* file) { return of(file).at; }
  static std::size_t size(aiFile* file) { return of(file).bytes.size(); }
  static aiReturn seek(aiFile* in, std::size_t offset, aiOrigin origin) {
    OpenFile& file = of(in);
    const std::size_t end = file.bytes.size();
    const std::size_t from = origin == aiOrigin_CUR ? file.at : 0;
    if (offset > end - from) return aiReturn_FAILURE;
    file.at = origin == aiOrigin_END ? end - offset : from + offset;  // counted back, as Assimp has it
    return aiReturn_SUCCESS;
  }
};

/// The files that Assimp gets to see: the model, which has been read, and what a FileReader finds beside it.
/// Nothing is written.
class FilesBeside {
 public:
  FilesBeside(std::string name, std::string_view model, const pipeline::FileReader& open)
      : name_(std::move(name)), model_(model), open_(open) {}

  aiFileIO calls() { return {open, close, reinterpret_cast<char*>(this)}; }

  /// Why the last file that was asked for and not given was not: "expected …, found …"; empty when all were.
  std::string problem(bool quotable) const {
    if (missed_.empty()) return "";
    if (!quotable) return "expected a model whose other files can be read";
    const auto found = beside_.find(missed_);
    if (found == beside_.end() || !found->second)
      return fmt::format("expected the file {} beside it, found none", shown(missed_));
    return found->second->problem;
  }

  /// Whether messages may show what stands in the files that were read.
  bool quotable() const {
    return std::ranges::all_of(beside_,
                               [](const auto& file) { return !file.second || file.second->quotable; });
  }
  /// The names of the files beside the model that were read.
  std::vector<std::string> asked() const { return asked_; }

 private:
  static aiFile* open(aiFileIO* io, const char* path, const char* mode) {
    auto& files = *reinterpret_cast<FilesBeside*>(io->UserData);
    const auto bytes = *mode == 'r' ? files.bytes_of(path) : std::nullopt;
    if (bytes) return &(new OpenFile(*bytes))->calls;
    files.missed_ = path;
    return nullptr;
  }
  static void close(aiFileIO* /*io*/, aiFile* file) { delete &OpenFile::of(file); }

  std::optional<std::string_view> bytes_of(const std::string& path) {
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
  std::map<std::string, std::optional<LibraryText>> beside_;
  std::vector<std::string> asked_;
};

/// A text of Assimp's: its first line, shortened.
std::string line_of(std::string_view text) {
  return visible(text.substr(0, std::min<std::size_t>(text.find('\n'), 200)));
}

/// What Assimp says of a file while it reads it.
class Complaints {
 public:
  aiLogStream stream() { return {take, reinterpret_cast<char*>(this)}; }

  /// One remark, nothing where there is nothing to say.
  std::optional<std::string> remark(bool quotable) const {
    if (known_.empty()) return std::nullopt;
    if (!quotable) return fmt::format("Assimp has {} warnings", known_.size());
    const std::string more =
        known_.size() > told_.size() ? fmt::format("; and {} more", known_.size() - told_.size()) : "";
    return fmt::format("Assimp warns: {}{}", fmt::join(told_, "; "), more);
  }

 private:
  static constexpr std::size_t most_told = 3;

  /// "Warn,  T0: what" or "Error, T0: what"; everything else is about its work.
  static void take(const char* message, char* user) {
    std::string_view text = message;
    if (!text.starts_with("Warn") && !text.starts_with("Error")) return;
    text.remove_prefix(std::min(text.find(": ") + 2, text.size()));
    auto& said = *reinterpret_cast<Complaints*>(user);
    const auto [line, is_new] = said.known_.insert(line_of(text));
    if (is_new && said.told_.size() < most_told) said.told_.push_back(*line);
  }

  std::set<std::string> known_;
  std::vector<std::string> told_;  ///< the first of them
};

/// The model in a scene, or why there is none, with what Assimp has said of the file.
pipeline::ModelFile told_of(const aiScene& scene, const pipeline::TextFile& file,
                            const ImportedFormat& format, const std::optional<std::string>& remark) {
  try {
    pipeline::ModelFile model = model_of(scene, file, format);
    if (remark) model.notes.push_back(fmt::format("{}: {}", shown_name(file.name), *remark));
    return model;
  } catch (const InputError& error) {
    refuse_input(remark ? fmt::format("{} ({})", error.what(), *remark) : error.what());
  }
}

/// Reads a model within the process that may be lost. asked: gets the names of the files beside it that were
/// read.
pipeline::ModelFile read_by_assimp(std::string_view bytes, const pipeline::TextFile& file,
                                   const pipeline::FileReader& open, std::vector<std::string>& asked) {
  const std::string ending = pipeline::ending_of(file.name);
  const bool gltf = ending == "gltf" || ending == "glb";
  const std::string name = std::filesystem::path(file.name).filename().string();
  FilesBeside files(name, bytes, open);
  aiFileIO calls = files.calls();
  Complaints complaints;
  const aiLogStream log = complaints.stream();
  assimp().aiAttachLogStream(&log);
  aiPropertyStore* const properties = assimp().aiCreatePropertyStore();
  assimp().aiSetImportPropertyInteger(properties, AI_CONFIG_IMPORT_NO_SKELETON_MESHES, 1);
  // Neither is given back: this process ends
  const aiScene* const scene = assimp().aiImportFileExWithProperties(name.c_str(), 0, &calls, properties);
  asked = files.asked();
  // What Assimp tells, and numbers of the scene, may come from any of the files
  const pipeline::TextFile all{file.name, file.quotable && files.quotable()};
  if (scene) return told_of(*scene, all, {.flat = gltf, .uris = gltf}, complaints.remark(all.quotable));
  std::string problem = files.problem(file.quotable);
  if (problem.empty()) {
    problem = no_model;
    if (all.quotable) problem += fmt::format(" ({})", line_of(assimp().aiGetErrorString()));
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
  assimp();  // before there are two processes: without it nothing can be read
  const ProcessResult result =
      in_own_process([&] { return answer_of(bytes, file, open); }, limits_for(bytes.size()));
  if (result.end == ProcessResult::End::too_much)
    refuse(fmt::format("{} (Assimp does not come to an end)", no_model));
  if (result.end == ProcessResult::End::crashed) refuse(fmt::format("{} (Assimp has crashed)", no_model));
  std::string_view answer = result.bytes;
  // The process that reads files for us says here what it has read
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
