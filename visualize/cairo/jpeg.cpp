#include "cairo/jpeg.hpp"

#include <fmt/format.h>
#include <turbojpeg.h>

#include <memory>
#include <new>
#include <string_view>

#include "core/shown.hpp"

namespace gradus {
namespace {

static_assert(sizeof(Rgba8) == 4, "rows of an Image are handed to TurboJPEG as bytes");

struct EndDecompression {
  void operator()(void* jpeg) const { tjDestroy(jpeg); }
};
using Decompressor = std::unique_ptr<void, EndDecompression>;

class JpegReader {
 public:
  JpegReader(std::span<const std::uint8_t> bytes, const std::string& name)
      : bytes_(bytes), name_(name), jpeg_(tjInitDecompress()) {
    if (!jpeg_) throw std::bad_alloc();
  }

  Image picture(std::int64_t most_pixels) const {
    int width = 0, height = 0, subsampling = 0, colours = 0;
    if (tjDecompressHeader3(jpeg_.get(), bytes_.data(), bytes_.size(), &width, &height, &subsampling,
                            &colours) != 0)
      refuse_damaged(tjGetErrorStr2(jpeg_.get()));
    if (width < 1 || height < 1) refuse_damaged("no picture in it");  // tables alone
    if (width > most_pixels / height)
      refuse(fmt::format("expected at most {} pixels, found {} x {}", most_pixels, width, height));
    if (colours == TJCS_CMYK || colours == TJCS_YCCK)
      refuse("expected a JPEG file in grey or in red, green and blue, found one in a printer's inks");
    Image image(width, height);
    auto* const pixels = reinterpret_cast<unsigned char*>(image.row(0).data());
    // A warning tells of data that are not there; a file of thousands of scans would take minutes
    constexpr int strictly = TJFLAG_ACCURATEDCT | TJFLAG_STOPONWARNING | TJFLAG_LIMITSCANS;
    if (tjDecompress2(jpeg_.get(), bytes_.data(), bytes_.size(), pixels, width, 0, height, TJPF_RGBA,
                      strictly) != 0)
      refuse_damaged(tjGetErrorStr2(jpeg_.get()));
    return image;
  }

 private:
  [[noreturn]] void refuse(std::string_view what) const {
    throw InputError(fmt::format("{}: {}", shown_name(name_), what));
  }
  [[noreturn]] void refuse_damaged(std::string_view why) const {
    refuse(fmt::format("expected a whole JPEG file, found a damaged one ({})", visible(why)));
  }

  std::span<const std::uint8_t> bytes_;
  const std::string& name_;
  Decompressor jpeg_;
};

}  // namespace

bool begins_as_jpeg(std::span<const std::uint8_t> bytes) {
  return bytes.size() >= 3 && bytes[0] == 0xff && bytes[1] == 0xd8 && bytes[2] == 0xff;
}

Image decode_jpeg(std::span<const std::uint8_t> bytes, const std::string& name, std::int64_t most_pixels) {
  return JpegReader(bytes, name).picture(most_pixels);
}

}  // namespace gradus
