#include "cli/film/film_file.hpp"

#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

#include "cli/command_line/errors.hpp"

namespace gradus::cli {
namespace {

/// A stretch of the file: a GIF block, a WebP chunk or an MP4 box, without what says its kind and length.
struct Part {
  std::string_view kind;
  std::size_t start = 0, end = 0;
};
using Parts = std::vector<Part>;

std::uint8_t byte_at(std::string_view bytes, std::size_t at) { return static_cast<std::uint8_t>(bytes[at]); }

std::size_t big_endian(std::string_view bytes, std::size_t at) {
  std::size_t value = 0;
  for (std::size_t i = 0; i < 4; ++i) value = value << 8 | byte_at(bytes, at + i);
  return value;
}

std::size_t little_endian(std::string_view bytes, std::size_t at) {
  std::size_t value = 0;
  for (std::size_t i = 4; i-- > 0;) value = value << 8 | byte_at(bytes, at + i);
  return value;
}

void put_little_endian(std::string& bytes, std::size_t at, std::size_t value, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) bytes[at + i] = static_cast<char>(value >> 8 * i & 255);
}

// --- GIF: blocks of sub-blocks, each with its length before it -------------------------------------------

constexpr std::string_view gif_image = ",", gif_timing = "!\xf9", gif_trailer = ";";

std::size_t color_table_size(std::uint8_t flags) { return flags & 0x80 ? std::size_t{6} << (flags & 7) : 0; }

/// Past the sub-blocks that begin here, or nothing when the file ends in them.
std::optional<std::size_t> past_sub_blocks(std::string_view film, std::size_t at) {
  while (at < film.size()) {
    const std::size_t length = byte_at(film, at++);
    if (length == 0) return at;
    at += length;
  }
  return std::nullopt;
}

/// Images, extensions and the trailer; nothing when the file is cut off.
std::optional<Parts> gif_parts(std::string_view film) {
  if (!film.starts_with("GIF8") || film.size() < 13) return std::nullopt;
  Parts parts;
  std::size_t at = 13 + color_table_size(byte_at(film, 10));
  while (at < film.size()) {
    const bool extension = film[at] == '!';
    const std::string_view kind = film.substr(at, extension ? 2 : 1);
    std::size_t inside = at + kind.size();
    if (kind == gif_trailer) {
      parts.push_back({kind, at, inside});
      return parts;
    }
    if (kind == gif_image) {
      if (at + 10 > film.size()) return std::nullopt;
      inside = at + 10 + color_table_size(byte_at(film, at + 9)) + 1;
    } else if (!extension) {
      return std::nullopt;
    }
    const auto end = past_sub_blocks(film, inside);
    if (!end) return std::nullopt;
    parts.push_back({kind, inside, *end});
    at = *end;
  }
  return std::nullopt;
}

// --- WebP: chunks in a RIFF file --------------------------------------------------------------------------

std::optional<Parts> webp_parts(std::string_view film) {
  if (film.size() < 12 || !film.starts_with("RIFF") || film.substr(8, 4) != "WEBP") return std::nullopt;
  if (little_endian(film, 4) + 8 != film.size()) return std::nullopt;
  Parts parts;
  for (std::size_t at = 12; at < film.size();) {
    if (at + 8 > film.size()) return std::nullopt;
    const std::size_t length = little_endian(film, at + 4), next = at + 8 + length + length % 2;
    if (next > film.size()) return std::nullopt;
    parts.push_back({film.substr(at, 4), at + 8, at + 8 + length});
    at = next;
  }
  return parts;
}

// --- MP4: boxes in boxes ----------------------------------------------------------------------------------

std::optional<Parts> mp4_boxes(std::string_view film, std::size_t from, std::size_t to) {
  Parts boxes;
  for (std::size_t at = from; at < to;) {
    const std::size_t length = at + 8 <= to ? big_endian(film, at) : 0;
    if (length < 8 || length > to - at) return std::nullopt;
    boxes.push_back({film.substr(at + 4, 4), at + 8, at + length});
    at += length;
  }
  return boxes;
}

/// The samples of the only track. A box beyond 4 GiB, which no film of ours has, is not read.
std::size_t mp4_samples(std::string_view film) {
  constexpr std::array<std::string_view, 6> way{"moov", "trak", "mdia", "minf", "stbl", "stsz"};
  Part box{"", 0, film.size()};
  for (const std::string_view kind : way) {
    const auto boxes = mp4_boxes(film, box.start, box.end);
    if (!boxes) return 0;
    box.kind = "";
    for (const Part& inner : *boxes) {
      if (inner.kind == kind) box = inner;
    }
    if (box.kind != kind) return 0;
  }
  return box.end - box.start < 12 ? 0 : big_endian(film, box.start + 8);
}

// --- Either -----------------------------------------------------------------------------------------------

std::optional<Parts> parts_of(FilmFormat format, std::string_view film) {
  return format == FilmFormat::gif ? gif_parts(film) : webp_parts(film);
}

Parts parts_of(FilmFormat format, std::string_view film, std::string_view kind) {
  Parts parts = parts_of(format, film).value_or(Parts{});
  std::erase_if(parts, [kind](const Part& part) { return part.kind != kind; });
  return parts;
}

std::string gif_with_xmp(std::string film, std::string_view xmp) {
  // The text stands there as it is, its letters taken for lengths. Wherever the last of these ends in the
  // falling row, it leads to the zero after it
  std::string block = "!\xff\x0bXMP DataXMP" + std::string(xmp) + "\x01";
  for (int i = 255; i >= 0; --i) block += static_cast<char>(i);
  block += '\0';
  const Parts trailer = parts_of(FilmFormat::gif, film, gif_trailer);
  if (trailer.empty()) return film;
  return film.insert(trailer[0].start, block);
}

std::string webp_with_xmp(std::string film, std::string_view xmp) {
  const Parts header = parts_of(FilmFormat::webp, film, "VP8X");
  if (header.empty()) return film;
  constexpr int has_xmp = 4;
  film[header[0].start] = static_cast<char>(film[header[0].start] | has_xmp);
  const std::size_t at = film.size();
  film += "XMP " + std::string(4, '\0') + std::string(xmp);
  put_little_endian(film, at + 4, xmp.size(), 4);
  if (xmp.size() % 2 != 0) film += '\0';
  put_little_endian(film, 4, film.size() - 8, 4);
  return film;
}

}  // namespace

std::string_view name_of(FilmFormat format) {
  constexpr std::array<std::string_view, 3> names{"gif", "mp4", "webp"};
  return names[static_cast<std::size_t>(format)];
}

std::size_t frames_in(FilmFormat format, std::string_view film) {
  switch (format) {
    case FilmFormat::gif:
      return parts_of(format, film, gif_image).size();
    case FilmFormat::webp:
      if (const std::size_t frames = parts_of(format, film, "ANMF").size(); frames > 0) return frames;
      return parts_of(format, film, "VP8L").size();  // a single frame is an ordinary picture
    case FilmFormat::mp4:
      break;
  }
  return mp4_samples(film);
}

void set_delays(FilmFormat format, std::string& film, std::span<const double> seconds) {
  const bool gif = format == FilmFormat::gif;
  const Parts frames = parts_of(format, film, gif ? gif_timing : "ANMF");
  if (frames.empty() && seconds.size() == 1) return;
  if (frames.size() != seconds.size())
    throw WorkError("film: expected a delay for every frame, found others");
  // GIF counts hundredths of a second, WebP thousandths. Ends are rounded, not delays: these add up
  const double unit = gif ? 0.01 : 0.001;
  const std::size_t offset = gif ? 2 : 12, size = gif ? 2 : 3, most = gif ? 0xffff : 0xffffff;
  double end = 0;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const auto start = std::llround(end / unit);
    end += seconds[i];
    const auto delay = static_cast<std::size_t>(std::llround(end / unit) - start);
    put_little_endian(film, frames[i].start + offset, std::min(delay, most), size);
  }
}

std::string with_xmp(FilmFormat format, std::string film, std::string_view xmp) {
  return format == FilmFormat::gif ? gif_with_xmp(std::move(film), xmp) : webp_with_xmp(std::move(film), xmp);
}

}  // namespace gradus::cli
