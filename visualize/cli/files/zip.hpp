#pragma once
// Zip files, for taking all steps at once or uploading a whole gallery to a learning platform.

#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "cli/files/files.hpp"
#include "figure/trace.hpp"

namespace gradus::cli {

struct ZipEntry {
  std::string name;  ///< path inside the zip, UTF-8, with forward slashes
  std::string bytes;
  bool stored = false;  ///< not deflated
};

/// The entries in their order, deflated unless they say otherwise. The same entries give the same bytes,
/// anywhere and at any time; the zip's comment says that Gradus packed them. Throws WorkError.
std::string zip_of(std::span<const ZipEntry> entries);

/// Packs files below `folder` (relative paths) into the zip `output`, under the same paths: with an
/// index.html at its root it can be uploaded as a web page. Pictures and documents that are packed already
/// are stored. Throws UsageError for a file that can't be read.
void zip_folder(const std::filesystem::path& folder, const std::vector<std::string>& files,
                const std::string& output, Replace replace = Replace::own);

/// One step as a picture: its bytes as SVG, as PNG.
struct StepPicture {
  std::string svg, png;
};

/// A figure's steps as files, "line-03.svg" and "line-03.png" with numbers that sort, and a README.txt that
/// says what they are: the title, the command, and which steps these are of how many.
std::vector<ZipEntry> step_entries(std::string_view slug, std::string_view title, std::string_view command,
                                   std::span<const StepNumber> steps, StepNumber last,
                                   const std::function<StepPicture(StepNumber)>& draw);

}  // namespace gradus::cli
