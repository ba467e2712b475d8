#include "core/image.hpp"

#include <fmt/format.h>
#include <png.h>

#include <algorithm>
#include <cerrno>
#include <csetjmp>
#include <cstdio>
#include <cstring>
#include <memory>
#include <new>
#include <optional>
#include <utility>

#include "core/shown.hpp"

// libpng reports an error by longjmp, which runs no destructors. So whatever owns memory (the file's bytes,
// the picture, the libpng handle) stands outside, and what is called inside `guarded` has only plain
// locals.

namespace gradus {
namespace {

static_assert(sizeof(Rgba8) == 4, "rows of an Image are handed to libpng as bytes");

/// libpng's own limit would be a million; the number of pixels is what matters here.
constexpr png_uint_32 longest_side = 0x7fffffff;

/// Deflate can't shrink by more than this, so a file that claims to hold more is cut short.
constexpr std::int64_t best_compression = 1032;

/// The text of libpng's last error: it must outlive the jump.
struct Complaint {
  char text[160] = "";
};

[[noreturn]] void on_error(png_structp png, png_const_charp text) {
  auto* complaint = static_cast<Complaint*>(png_get_error_ptr(png));
  std::snprintf(complaint->text, sizeof complaint->text, "%s", text);
  png_longjmp(png, 1);
}

void on_warning(png_structp, png_const_charp) {}

/// Runs libpng calls; false when one of them failed. `body` must own nothing that needs a destructor.
template <class Body>
bool guarded(png_structp png, Body body) {
  static_assert(std::is_trivially_destructible_v<Body>);
  if (setjmp(png_jmpbuf(png)) != 0) return false;
  body();
  return true;
}

// --- Reading ----------------------------------------------------------------------------------------------

struct Source {
  std::span<const std::uint8_t> bytes;
  std::size_t position = 0;
};

void take_bytes(png_structp png, png_bytep to, std::size_t count) {
  auto* source = static_cast<Source*>(png_get_io_ptr(png));
  if (count > source->bytes.size() - source->position) png_error(png, "the file ends too early");
  std::memcpy(to, source->bytes.data() + source->position, count);
  source->position += count;
}

class PngReader {
 public:
  PngReader(std::span<const std::uint8_t> bytes, const std::string& name, std::int64_t most_pixels)
      : source_{bytes}, name_(name), most_pixels_(most_pixels) {
    constexpr std::size_t signature = 8;
    if (bytes.size() < signature || png_sig_cmp(bytes.data(), 0, signature) != 0) {
      throw InputError(fmt::format("{}: expected a PNG file, found {}", shown_name(name),
                                   bytes.empty() ? "an empty one" : "something else"));
    }
    png_ = png_create_read_struct(PNG_LIBPNG_VER_STRING, &complaint_, on_error, on_warning);
    if (png_) info_ = png_create_info_struct(png_);
    if (!info_) {
      png_destroy_read_struct(&png_, nullptr, nullptr);
      throw std::bad_alloc();
    }
    png_set_read_fn(png_, &source_, take_bytes);
  }
  ~PngReader() { png_destroy_read_struct(&png_, &info_, nullptr); }
  PngReader(const PngReader&) = delete;
  PngReader& operator=(const PngReader&) = delete;

  Image picture() {
    read_header();
    Image image(static_cast<int>(png_get_image_width(png_, info_)),
                static_cast<int>(png_get_image_height(png_, info_)));
    read_rows(image);
    return image;
  }

  /// To be called after picture(): texts may stand behind the pixels.
  std::vector<PngText> texts() const;

 private:
  [[noreturn]] void refuse() const {
    throw InputError(fmt::format("{}: expected a whole PNG file, found a damaged one ({})", shown_name(name_),
                                 complaint_.text));
  }
  void read_header();
  void read_rows(Image& image);

  Source source_;
  const std::string& name_;
  std::int64_t most_pixels_;
  Complaint complaint_;
  png_structp png_ = nullptr;
  png_infop info_ = nullptr;
};

void PngReader::read_header() {
  const bool readable = guarded(png_, [this] {
    png_set_user_limits(png_, longest_side, longest_side);
    png_read_info(png_, info_);
  });
  if (!readable) refuse();
  const std::int64_t width = png_get_image_width(png_, info_), height = png_get_image_height(png_, info_);
  if (width > most_pixels_ / height) {
    throw InputError(fmt::format("{}: expected at most {} pixels, found {} x {}", shown_name(name_),
                                 most_pixels_, width, height));
  }
  // Before memory is asked for: can these few bytes hold so many pixels at all?
  const auto row_bytes = static_cast<std::int64_t>(png_get_rowbytes(png_, info_));
  if (row_bytes * height / best_compression > static_cast<std::int64_t>(source_.bytes.size())) {
    throw InputError(fmt::format("{}: expected a whole PNG file, found {} bytes for {} x {} pixels",
                                 shown_name(name_), source_.bytes.size(), width, height));
  }
}

void PngReader::read_rows(Image& image) {
  const bool readable = guarded(png_, [this, &image] {
    png_set_expand(png_);  // palette -> RGB, 1, 2, 4 bits -> 8, a transparent colour -> alpha
    png_set_scale_16(png_);
    png_set_gray_to_rgb(png_);
    png_set_add_alpha(png_, 0xff, PNG_FILLER_AFTER);
    const int passes = png_set_interlace_handling(png_);
    png_read_update_info(png_, info_);
    for (int pass = 0; pass < passes; ++pass) {
      for (int y = 0; y < image.height(); ++y) {
        png_read_row(png_, reinterpret_cast<png_bytep>(image.row(y).data()), nullptr);
      }
    }
    png_read_end(png_, info_);
  });
  if (!readable) refuse();
}

std::string utf8_from_latin1(std::string_view text) {
  std::string utf8;
  for (const char c : text) {
    const auto code = static_cast<unsigned char>(c);
    if (code < 0x80) {
      utf8 += c;
    } else {
      utf8 += static_cast<char>(0xc0 | (code >> 6));
      utf8 += static_cast<char>(0x80 | (code & 0x3f));
    }
  }
  return utf8;
}

/// Where the text begins in the chunk of one, after its key and what else ends at a NUL; nothing for one that
/// is packed.
std::optional<std::size_t> begin_of_text(std::string_view type, std::string_view data) {
  if (type != "tEXt" && type != "iTXt") return {};
  std::size_t at = data.find('\0') + 1;
  if (type == "tEXt") return at;
  if (data.substr(at, 1) != std::string_view("\0", 1)) return {};
  at = data.find('\0', at + 2) + 1;  // behind the language
  return data.find('\0', at) + 1;    // and the key in it
}

/// Refuses texts with a NUL, which libpng would cut there.
/// bytes: of a PNG that it has read.
void refuse_cut_texts(std::string_view bytes, const std::string& name) {
  constexpr std::size_t before_data = 8, after_data = 4;
  for (std::size_t at = 8; at + before_data <= bytes.size();) {
    std::size_t length = 0;
    for (const char c : bytes.substr(at, 4)) length = length << 8 | static_cast<unsigned char>(c);
    const std::string_view type = bytes.substr(at + 4, 4), data = bytes.substr(at + before_data, length);
    const auto begin = begin_of_text(type, data);
    if (begin && data.find('\0', *begin) != std::string_view::npos)
      throw InputError(fmt::format("{}: expected a text without NUL, found one in the text '{}'",
                                   shown_name(name), shown_name(data.substr(0, data.find('\0')))));
    at += before_data + length + after_data;
  }
}

std::vector<PngText> PngReader::texts() const {
  png_textp entries = nullptr;
  int count = 0;
  png_get_text(png_, info_, &entries, &count);
  std::vector<PngText> texts;
  for (const png_text& entry : std::span(entries, static_cast<std::size_t>(count))) {
    const bool utf8 = entry.compression >= PNG_ITXT_COMPRESSION_NONE;
    const std::string_view text = utf8 ? std::string_view(entry.text, entry.itxt_length)
                                       : std::string_view(entry.text, entry.text_length);
    texts.push_back({entry.key, utf8 ? std::string(text) : utf8_from_latin1(text)});
  }
  return texts;
}

// --- Writing ----------------------------------------------------------------------------------------------

bool append(std::vector<std::uint8_t>& to, png_const_bytep bytes, std::size_t count) noexcept {
  try {
    to.insert(to.end(), bytes, bytes + count);
    return true;
  } catch (const std::bad_alloc&) {
    return false;
  }
}

void give_bytes(png_structp png, png_bytep bytes, std::size_t count) {
  auto* to = static_cast<std::vector<std::uint8_t>*>(png_get_io_ptr(png));
  if (!append(*to, bytes, count)) png_error(png, "out of memory");
}

void flush_nothing(png_structp) {}

/// libpng's form of the texts; it points into them and does not change them.
std::vector<png_text> libpng_texts(std::span<const PngText> texts) {
  std::vector<png_text> entries;
  for (const PngText& text : texts) {
    expects(!text.key.empty() && text.key.size() < 80, "a PNG text's key has 1 to 79 letters, not {}",
            text.key.size());
    png_text entry{};
    entry.compression = PNG_ITXT_COMPRESSION_NONE;
    entry.key = const_cast<char*>(text.key.c_str());
    entry.text = const_cast<char*>(text.text.c_str());
    entry.itxt_length = text.text.size();
    entries.push_back(entry);
  }
  return entries;
}

class PngWriter {
 public:
  PngWriter() {
    png_ = png_create_write_struct(PNG_LIBPNG_VER_STRING, &complaint_, on_error, on_warning);
    if (png_) info_ = png_create_info_struct(png_);
    if (!info_) {
      png_destroy_write_struct(&png_, nullptr);
      throw std::bad_alloc();
    }
    png_set_write_fn(png_, &bytes_, give_bytes, flush_nothing);
  }
  ~PngWriter() { png_destroy_write_struct(&png_, &info_); }
  PngWriter(const PngWriter&) = delete;
  PngWriter& operator=(const PngWriter&) = delete;

  std::vector<std::uint8_t> bytes_of(const Image& image, std::span<const png_text> texts) {
    std::uint8_t alphas = 255;  // without a branch per pixel this takes a tenth of the time
    for (const Rgba8& c : image.cells()) alphas &= c.a;
    const bool opaque = alphas == 255;
    const bool written = guarded(png_, [this, &image, texts, opaque] {
      write_header(image, texts, opaque);
      for (int y = 0; y < image.height(); ++y) {
        png_write_row(png_, reinterpret_cast<png_const_bytep>(image.row(y).data()));
      }
      png_write_end(png_, info_);
    });
    if (!written) throw std::runtime_error(fmt::format("can't make a PNG: {}", complaint_.text));
    return std::move(bytes_);
  }

 private:
  void write_header(const Image& image, std::span<const png_text> texts, bool opaque) {
    constexpr int fast = 3;
    png_set_user_limits(png_, longest_side, longest_side);
    png_set_compression_level(png_, fast);
    png_set_filter(png_, PNG_FILTER_TYPE_BASE, PNG_FILTER_NONE);
    png_set_IHDR(png_, info_, static_cast<png_uint_32>(image.width()),
                 static_cast<png_uint_32>(image.height()), 8,
                 opaque ? PNG_COLOR_TYPE_RGB : PNG_COLOR_TYPE_RGB_ALPHA, PNG_INTERLACE_NONE,
                 PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    png_set_text(png_, info_, texts.data(), static_cast<int>(texts.size()));
    png_write_info(png_, info_);
    if (opaque) png_set_filler(png_, 0, PNG_FILLER_AFTER);  // rows have four bytes per pixel, the file three
  }

  std::vector<std::uint8_t> bytes_;
  Complaint complaint_;
  png_structp png_ = nullptr;
  png_infop info_ = nullptr;
};

// --- Files ------------------------------------------------------------------------------------------------

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};

std::vector<std::uint8_t> file_bytes(const std::string& path) {
  const auto refuse = [&path] {
    throw InputError(
        fmt::format("{}: expected a readable file, found none ({})", shown_name(path), std::strerror(errno)));
  };
  const std::unique_ptr<std::FILE, CloseFile> file(std::fopen(path.c_str(), "rb"));
  if (!file) refuse();
  std::vector<std::uint8_t> bytes;
  std::uint8_t block[1 << 16];
  while (const std::size_t count = std::fread(block, 1, sizeof block, file.get())) {
    bytes.insert(bytes.end(), block, block + count);
  }
  if (std::ferror(file.get())) refuse();
  return bytes;
}

}  // namespace

Image decode_png(std::span<const std::uint8_t> bytes, const std::string& name, std::int64_t most_pixels) {
  return PngReader(bytes, name, most_pixels).picture();
}

std::vector<PngText> png_texts(std::span<const std::uint8_t> bytes, const std::string& name) {
  PngReader reader(bytes, name, most_png_pixels);
  reader.picture();
  refuse_cut_texts({reinterpret_cast<const char*>(bytes.data()), bytes.size()}, name);
  return reader.texts();
}

std::vector<std::uint8_t> encode_png(const Image& image, std::span<const PngText> texts) {
  expects(image.width() > 0 && image.height() > 0, "a PNG has at least one pixel, not {} x {}", image.width(),
          image.height());
  return PngWriter().bytes_of(image, libpng_texts(texts));
}

Image read_png(const std::string& path) { return decode_png(file_bytes(path), path); }

}  // namespace gradus
