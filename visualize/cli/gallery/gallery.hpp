#pragma once
// The figures of a lecture as files: one folder each, and a card on the page of all figures.

#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "cli/files/files.hpp"
#include "cli/gallery/topic_pages.hpp"
#include "cli/lecture/lecture.hpp"
#include "json/json.hpp"
#include "web/gallery_page.hpp"

namespace gradus::cli {

/// Does all that draw() does short of drawing. Throws what draw() would, as far as it can be known. What
/// there is to know of a render is known when its lecture is read.
void rehearse(const LectureFigure& figure);
void rehearse(const LectureRender& render);

/// What the page of all figures says of one, or of a render.
struct GalleryEntry {
  Card card;
  std::optional<TopicFigure> topic_figure;  ///< what its topic's page links to
};

/// What came of drawing.
struct Drawn {
  std::vector<ManifestFile> files;
  std::vector<std::string> remarks;  ///< a line each
  GalleryEntry entry;
};

/// What a file at this path, below the output folder, may take the place of.
using ReplaceAt = std::function<Replace(const std::string& path)>;

/// Draws the files into out/<name>/ and tells what they are. Everything appears or nothing. Throws UsageError
/// where a file must not be replaced.
Drawn draw(const LectureFigure& figure, const std::filesystem::path& out, const ReplaceAt& replace);
Drawn draw(const LectureRender& render, const std::filesystem::path& out, const ReplaceAt& replace);

/// As in Drawn. `files`: those that draw() made.
GalleryEntry entry_of(const LectureFigure& figure, std::span<const ManifestFile> files, const Takes& takes);
/// The same of a figure that was drawn earlier.
GalleryEntry entry_of(const LectureFigure& figure, std::span<const ManifestFile> files);
GalleryEntry entry_of(const LectureRender& render);

/// The fingerprint of this program's own bytes.
std::string program_fingerprint();

/// Size and time of a file below `out`, as the manifest keeps them; size 2^64 - 1 when there is none.
ManifestFile file_state(const std::filesystem::path& out, const std::string& path);

}  // namespace gradus::cli
