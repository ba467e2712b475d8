#pragma once
// What a card says of a figure or a render and of the files that it has.

#include <string>
#include <vector>

#include "cli/gallery/gallery.hpp"

namespace gradus::cli {

/// "Flood fill: breadth first, queue", and what is wrong where something is.
std::string title_of(const LectureFigure& figure);

/// The shortest command for the same figure: what the lecture says of it. Files go without their folders, as
/// they lie beside the figure.
std::string short_command(const LectureFigure& figure);

std::string base_of(const std::string& path);

/// The names of the copies of its inputs.
std::vector<std::string> copied_names(const LecturePart& part);

/// Whether all steps come as pictures of both kinds.
bool has_zip(const LectureFigure& figure);

/// Larger pictures have a smaller one for their card.
constexpr int largest_thumbnail = 1280;

bool has_thumbnail(const LectureRender& render);

std::string thumbnail_name(const LectureRender& render);

}  // namespace gradus::cli
