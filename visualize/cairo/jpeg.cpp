#include "cairo/jpeg.hpp"

#include <fmt/format.h>

#include <csetjmp>
#include <cstdio>  // what jpeglib.h needs and doesn't include
#include <string_view>

#include <jerror.h>
#include <jpeglib.h>

#include "cairo/library_on_demand.hpp"
#include "core/shown.hpp"

namespace gradus {
namespace {

static_assert(sizeof(Rgba8) == 4, "rows of an Image are handed to libjpeg as bytes");

/// libjpeg's functions, loaded by the first such picture.
struct JpegLibrary {
  LibraryOnDemand library{GRADUS_JPEG, "JPEG pictures"};
  GRADUS_ON_DEMAND(jpeg_CreateDecompress);  // what jpeg_create_decompress calls
  GRADUS_ON_DEMAND(jpeg_destroy_decompress);
  GRADUS_ON_DEMAND(jpeg_finish_decompress);
  GRADUS_ON_DEMAND(jpeg_mem_src);
  GRADUS_ON_DEMAND(jpeg_read_header);
  GRADUS_ON_DEMAND(jpeg_read_scanlines);
  GRADUS_ON_DEMAND(jpeg_start_decompress);
  GRADUS_ON_DEMAND(jpeg_std_error);
};

const JpegLibrary& jpeg() {
  static const JpegLibrary functions;
  return functions;
}

/// libjpeg reading one file. Its functions tell of errors by a call that must not return: here that is a jump
/// back to where this class called them, so that no function that makes such calls has anything to clean up.
class Decompression {
 public:
  explicit Decompression(std::span<const std::uint8_t> bytes) {
    info_.err = jpeg_.jpeg_std_error(&errors_);
    errors_.error_exit = [](j_common_ptr info) { of(info).stop(); };
    errors_.emit_message = [](j_common_ptr info, int level) { of(info).take(level); };
    progress_.progress_monitor = [](j_common_ptr info) { of(info).check_scans(); };
    info_.client_data = this;
    if (setjmp(escape_) != 0) return;
    jpeg_.jpeg_create_decompress(&info_);
    info_.client_data = this;  // which creation forgets
    info_.progress = &progress_;
    jpeg_.jpeg_mem_src(&info_, bytes.data(), static_cast<unsigned long>(bytes.size()));
    ready_ = true;
  }
  ~Decompression() { jpeg_.jpeg_destroy_decompress(&info_); }
  Decompression(const Decompression&) = delete;
  Decompression& operator=(const Decompression&) = delete;

  /// Reads up to the picture: its size and colours are known then. Each of these says whether it went well.
  bool read_header() {
    if (!ready_ || setjmp(escape_) != 0) return false;
    jpeg_.jpeg_read_header(&info_, TRUE);
    return true;
  }
  bool read_pixels(Image& image) {
    if (setjmp(escape_) != 0) return false;
    info_.out_color_space = JCS_EXT_RGBA;
    jpeg_.jpeg_start_decompress(&info_);
    while (info_.output_scanline < info_.output_height) {
      auto* row = reinterpret_cast<JSAMPLE*>(image.row(static_cast<int>(info_.output_scanline)).data());
      jpeg_.jpeg_read_scanlines(&info_, &row, 1);
    }
    const bool all = has_all_scans();
    jpeg_.jpeg_finish_decompress(&info_);
    return all || !ended_early_;
  }

  int width() const { return static_cast<int>(info_.image_width); }
  int height() const { return static_cast<int>(info_.image_height); }
  bool is_in_inks() const { return info_.jpeg_color_space == JCS_CMYK || info_.jpeg_color_space == JCS_YCCK; }
  /// Why it did not go well.
  const char* problem() const { return problem_; }

 private:
  static Decompression& of(j_common_ptr info) { return *static_cast<Decompression*>(info->client_data); }

  void keep_problem() { errors_.format_message(reinterpret_cast<j_common_ptr>(&info_), problem_); }

  [[noreturn]] void stop() {
    if (!ended_early_) keep_problem();  // else all that follows comes of that
    std::longjmp(escape_, 1);
  }

  /// level: below 0 for a warning. Data that are wrong or not there end it. Bytes that are too many don't,
  /// nor a file that ends behind its last datum: phones write such files, and nothing of the picture is lost.
  void take(int level) {
    if (level >= 0) return;
    const int what = errors_.msg_code;
    if (what == JWRN_EXTRANEOUS_DATA || what == JWRN_JFIF_MAJOR) return;
    if (what != JWRN_JPEG_EOF) stop();
    if (!ended_early_) keep_problem();
    ended_early_ = true;
  }

  /// A file of thousands of scans would take minutes.
  void check_scans() {
    constexpr int most = 500;
    if (info_.input_scan_number <= most) return;
    std::snprintf(problem_, sizeof problem_, "more than %d scans", most);
    std::longjmp(escape_, 1);
  }

  /// Whether every coefficient of every component came in some scan: a file of several may end between two.
  bool has_all_scans() const {
    for (int i = 0; i < info_.num_components; ++i) {
      if (info_.comp_info[i].quant_table == nullptr) return false;
      if (info_.coef_bits == nullptr) continue;
      for (const int missing_bits : info_.coef_bits[i])
        if (missing_bits != 0) return false;
    }
    return true;
  }

  const JpegLibrary& jpeg_ = jpeg();
  jpeg_decompress_struct info_{};
  jpeg_error_mgr errors_{};
  jpeg_progress_mgr progress_{};
  std::jmp_buf escape_{};
  char problem_[JMSG_LENGTH_MAX]{};
  bool ready_ = false, ended_early_ = false;
};

}  // namespace

bool begins_as_jpeg(std::span<const std::uint8_t> bytes) {
  return bytes.size() >= 3 && bytes[0] == 0xff && bytes[1] == 0xd8 && bytes[2] == 0xff;
}

Image decode_jpeg(std::span<const std::uint8_t> bytes, const std::string& name, std::int64_t most_pixels) {
  const auto refuse = [&name](std::string_view what) {
    throw InputError(fmt::format("{}: {}", shown_name(name), what));
  };
  Decompression file(bytes);
  const auto refuse_damaged = [&] {
    refuse(fmt::format("expected a whole JPEG file, found a damaged one ({})", visible(file.problem())));
  };
  if (!file.read_header()) refuse_damaged();
  if (file.width() > most_pixels / file.height())
    refuse(
        fmt::format("expected at most {} pixels, found {} x {}", most_pixels, file.width(), file.height()));
  if (file.is_in_inks())
    refuse("expected a JPEG file in grey or in red, green and blue, found one in a printer's inks");
  Image image(file.width(), file.height());
  if (!file.read_pixels(image)) refuse_damaged();
  return image;
}

}  // namespace gradus
