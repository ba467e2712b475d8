#pragma once
// The figures of a lecture as files: one folder each, and a card on the page of all figures.

#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "cli/files/files.hpp"
#include "cli/lecture/lecture.hpp"
#include "json/json.hpp"
#include "web/gallery_page.hpp"

namespace gradus::cli {

/// A file to be written.
struct OutputFile {
  std::string name, bytes;
};

/// The files of a figure in one format: the only place that knows which those are. Pictures show the most
/// telling step, "<stem>.svg"; of several chosen steps there is one file each, "<stem>-4.svg". A PDF has a
/// page per step; a player plays the stretch that the chosen steps span. Throws UsageError for steps that the
/// run has not.
std::vector<OutputFile> output_files(const FigureSpec& spec, Takes& takes, Format format,
                                     const std::string& stem);

/// Does all that draw() does short of drawing. Throws what draw() would, as far as it can be known. What
/// there is to know of a render is known when its lecture is read.
void rehearse(const LectureFigure& figure);
void rehearse(const LectureRender& render);

/// What came of drawing.
struct Drawn {
  std::vector<ManifestFile> files;
  std::vector<std::string> remarks;  ///< a line each
};

/// What a file at this path, below the output folder, may take the place of.
using ReplaceAt = std::function<Replace(const std::string& path)>;

/// Draws the files into out/<name>/ and tells what they are. Everything appears or nothing. Throws UsageError
/// where a file must not be replaced.
Drawn draw(const LectureFigure& figure, const std::filesystem::path& out, const ReplaceAt& replace);
Drawn draw(const LectureRender& render, const std::filesystem::path& out, const ReplaceAt& replace);

/// Its card. `files`: those that draw() made.
Card card_of(const LectureFigure& figure, std::span<const ManifestFile> files, const Takes& takes);
Card card_of(const LectureRender& render);

/// The fingerprint of this program's own bytes.
std::string program_fingerprint();

/// Size and time of a file below `out`, as the manifest keeps them; size 2^64 - 1 when there is none.
ManifestFile file_state(const std::filesystem::path& out, const std::string& path);

}  // namespace gradus::cli
