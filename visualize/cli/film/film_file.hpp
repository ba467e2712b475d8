#pragma once
// Inside the files of films: counting and timing their frames, and a text to say how they were made.

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace gradus::cli {

enum class FilmFormat { gif, mp4, webp };
std::string_view name_of(FilmFormat format);

/// How many frames a finished film has; 0 when these bytes are none, or are cut off.
std::size_t frames_in(FilmFormat format, std::string_view film);

/// GIF and WebP: how long each of its frames stays, in seconds. Domain: as many as frames_in says.
void set_delays(FilmFormat format, std::string& film, std::span<const double> seconds);

/// GIF and WebP: the film with an XMP text, kept in one piece as both formats ask. (A WebP of one frame is no
/// film and stays as it is.)
std::string with_xmp(FilmFormat format, std::string film, std::string_view xmp);

}  // namespace gradus::cli
