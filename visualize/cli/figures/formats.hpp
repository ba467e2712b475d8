#pragma once
// The formats of figures: what each one is, and which of them a name or a file's bytes say.

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace gradus::cli {

enum class Format { svg, png, pdf, html, csv, md, tex, json, txt, gif, mp4, webp, pptx, obj, ply, stl };

/// What a file of a format holds.
enum class FormatKind {
  picture,   ///< one step, drawn
  document,  ///< a page or slide per step
  film,      ///< a frame per step, and what moves between them
  player,    ///< the run, to be played
  text,      ///< the run, as a table or as data
  model,     ///< the surface that the run has made
};

struct FormatFacts {
  std::string_view name;  ///< and the ending of its files
  FormatKind kind;
  bool pixels;             ///< it is made of pixels, not of vectors or letters
  std::string_view label;  ///< of a link to such a file
};

const FormatFacts& facts_of(Format format);
/// The names of all formats, in their order.
std::span<const std::string> format_names();
/// By the file name's ending; nothing for an unknown one.
std::optional<Format> format_by_ending(std::string_view path);
/// By the file's first bytes; nothing for a file that holds no command.
std::optional<Format> format_by_content(std::string_view bytes);

inline std::string_view name_of(Format format) { return facts_of(format).name; }
inline bool is_picture(Format format) { return facts_of(format).kind == FormatKind::picture; }
inline bool is_document(Format format) { return facts_of(format).kind == FormatKind::document; }
inline bool is_film(Format format) { return facts_of(format).kind == FormatKind::film; }
inline bool is_model(Format format) { return facts_of(format).kind == FormatKind::model; }
/// Steps as pictures: all but a player, texts and models.
inline bool is_drawn(Format format) { return is_picture(format) || is_document(format) || is_film(format); }

}  // namespace gradus::cli
