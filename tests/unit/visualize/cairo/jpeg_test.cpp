// JPEG files: what TurboJPEG packs comes back, as it reads it itself, and what is no whole picture in RGB is
// refused.

#include "cairo/jpeg.hpp"

#include <gtest/gtest.h>
#include <turbojpeg.h>

#include <algorithm>
#include <cstdlib>
#include <functional>
#include <string>
#include <vector>

#include "cairo/image_file.hpp"
#include "core/random.hpp"

namespace gradus {
namespace {

using Bytes = std::vector<std::uint8_t>;

/// Slow changes of all three colours, which a JPEG of quality 100 hardly changes.
Image slopes(int width, int height) {
  Image image(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      image[{x, y}] = {static_cast<std::uint8_t>(255 * x / width),
                       static_cast<std::uint8_t>(255 * y / height),
                       static_cast<std::uint8_t>(255 * (x + y) / (width + height))};
  return image;
}

/// A file made by the library itself. format: of the pixels, TJPF_CMYK takes their four bytes for inks.
Bytes packed(const Image& image, int subsampling, int format = TJPF_RGBA, int flags = 0) {
  const tjhandle jpeg = tjInitCompress();
  unsigned char* data = nullptr;
  unsigned long size = 0;
  EXPECT_EQ(tjCompress2(jpeg, reinterpret_cast<const unsigned char*>(image.cells().data()), image.width(), 0,
                        image.height(), format, &data, &size, subsampling, 100, flags),
            0);
  const Bytes bytes(data, data + size);
  tjFree(data);
  tjDestroy(jpeg);
  return bytes;
}

/// What is wrong with it; empty when nothing is.
std::string problem_of(const std::function<void()>& call) {
  try {
    call();
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

std::string complaint_about(const Bytes& bytes, std::int64_t most = 1 << 20) {
  return problem_of([&] { decode_jpeg(bytes, "x.jpg", most); });
}

/// The largest difference of a channel.
int difference(const Image& a, const Image& b) {
  int most = 0;
  for (std::size_t i = 0; i < a.cells().size(); ++i) {
    const Rgba8 p = a.cells()[i], q = b.cells()[i];
    most = std::max({most, std::abs(p.r - q.r), std::abs(p.g - q.g), std::abs(p.b - q.b)});
    EXPECT_EQ(q.a, 255);
  }
  return most;
}

TEST(Jpeg, ColoursComeBack) {
  for (const auto& [width, height] : {std::pair{64, 48}, {1, 1}, {17, 5}, {3, 200}}) {
    const Image image = slopes(width, height);
    for (const int flags : {0, TJFLAG_PROGRESSIVE}) {
      const Image read = decode_jpeg(packed(image, TJSAMP_444, TJPF_RGBA, flags), "x.jpg", 1 << 20);
      ASSERT_EQ(read.width(), width);
      ASSERT_EQ(read.height(), height);
      EXPECT_LE(difference(image, read), 3) << width << " x " << height;
    }
  }
  EXPECT_LE(difference(slopes(64, 48), decode_jpeg(packed(slopes(64, 48), TJSAMP_420), "x.jpg", 1 << 20)), 16)
      << "with colours of half the resolution";
}

TEST(Jpeg, GreyIsGrey) {
  Image image(40, 30);
  for (int y = 0; y < 30; ++y)
    for (int x = 0; x < 40; ++x) {
      const auto grey = static_cast<std::uint8_t>(3 * (x + y));
      image[{x, y}] = {grey, grey, grey};
    }
  const Image read = decode_jpeg(packed(image, TJSAMP_GRAY), "x.jpg", 1 << 20);
  EXPECT_LE(difference(image, read), 2);
  EXPECT_TRUE(std::ranges::all_of(read.cells(), [](Rgba8 c) { return c.r == c.g && c.g == c.b; }));
}

TEST(Jpeg, RefusesInksAndWhatIsTooLarge) {
  EXPECT_EQ(complaint_about(packed(slopes(16, 16), TJSAMP_444, TJPF_CMYK)),
            "x.jpg: expected a JPEG file in grey or in red, green and blue, found one in a printer's inks");
  const Bytes bytes = packed(slopes(16, 20), TJSAMP_444);
  EXPECT_EQ(complaint_about(bytes, 319), "x.jpg: expected at most 319 pixels, found 16 x 20");
  EXPECT_EQ(complaint_about(bytes, 320), "");
}

TEST(Jpeg, AnyPartIsNoWholeFile) {
  for (const int flags : {0, TJFLAG_PROGRESSIVE}) {
    const Bytes bytes = packed(slopes(40, 40), TJSAMP_420, TJPF_RGBA, flags);
    for (std::size_t size = 0; size + 2 < bytes.size(); size += size < 700 ? 1 : 37) {
      const std::string problem =
          complaint_about(Bytes(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(size)));
      EXPECT_TRUE(problem.starts_with("x.jpg: expected a whole JPEG file, found a damaged one ("))
          << size << ": " << problem;
      EXPECT_EQ(problem.find('\n'), std::string::npos);
    }
  }
}

/// The picture as TurboJPEG reads it.
Image by_turbojpeg(const Bytes& bytes, int width, int height) {
  Image image(width, height);
  const tjhandle jpeg = tjInitDecompress();
  EXPECT_EQ(
      tjDecompress2(jpeg, bytes.data(), bytes.size(), reinterpret_cast<unsigned char*>(image.row(0).data()),
                    width, 0, height, TJPF_RGBA, TJFLAG_ACCURATEDCT),
      0);
  tjDestroy(jpeg);
  return image;
}

/// Where a marker stands first from a place on; the end where it does not.
std::size_t marker_in(const Bytes& bytes, std::uint8_t marker, std::size_t from = 0) {
  const std::vector<std::uint8_t> wanted{0xff, marker};
  const auto found = std::search(bytes.begin() + static_cast<std::ptrdiff_t>(from), bytes.end(),
                                 wanted.begin(), wanted.end());
  return static_cast<std::size_t>(found - bytes.begin());
}

constexpr std::uint8_t table = 0xdb, scan = 0xda, end_of_image = 0xd9;

TEST(Jpeg, WithoutItsEndAndWithExtraBytesItIsDrawnWhole) {
  for (const int flags : {0, TJFLAG_PROGRESSIVE}) {
    const Bytes bytes = packed(slopes(40, 30), TJSAMP_420, TJPF_RGBA, flags);
    const Image whole = by_turbojpeg(bytes, 40, 30);
    EXPECT_EQ(decode_jpeg(bytes, "x.jpg", 1 << 20), whole);
    EXPECT_EQ(decode_jpeg(Bytes(bytes.begin(), bytes.end() - 2), "x.jpg", 1 << 20), whole);
    for (const std::uint8_t marker : {table, end_of_image}) {
      Bytes longer = bytes;
      const std::vector<std::uint8_t> extra{0, 1, 2, 0, 0};
      longer.insert(longer.begin() + static_cast<std::ptrdiff_t>(marker_in(bytes, marker)), extra.begin(),
                    extra.end());
      EXPECT_EQ(decode_jpeg(longer, "x.jpg", 1 << 20), whole) << int{marker};
    }
    Bytes behind = bytes;
    behind.insert(behind.end(), 9, 'x');
    EXPECT_EQ(decode_jpeg(behind, "x.jpg", 1 << 20), whole);
  }
}

TEST(Jpeg, EndingBetweenTwoScansItIsNotWhole) {
  const Bytes bytes = packed(slopes(40, 40), TJSAMP_420, TJPF_RGBA, TJFLAG_PROGRESSIVE);
  int cuts = 0;
  for (std::size_t at = marker_in(bytes, scan); at < bytes.size(); at = marker_in(bytes, scan, at + 1)) {
    const Bytes cut(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(at));
    EXPECT_EQ(complaint_about(cut),
              "x.jpg: expected a whole JPEG file, found a damaged one (Premature end of JPEG file)");
    ++cuts;
  }
  EXPECT_GE(cuts, 3);
}

TEST(Jpeg, DataThatAreNotThereAreRefusedAlsoWithTheirEnd) {
  Bytes bytes = packed(slopes(40, 40), TJSAMP_420);
  bytes.erase(bytes.end() - 102, bytes.end() - 2);
  EXPECT_EQ(
      complaint_about(bytes),
      "x.jpg: expected a whole JPEG file, found a damaged one (Corrupt JPEG data: premature end of data "
      "segment)");
}

/// Wrong bytes give a picture or a refusal.
TEST(Jpeg, WrongBytesDoNoHarm) {
  Random draw(20261125);
  const Bytes bytes = packed(slopes(24, 24), TJSAMP_420, TJPF_RGBA, TJFLAG_PROGRESSIVE);
  int refused = 0;
  for (int i = 0; i < 2000; ++i) {
    Bytes wrong = bytes;
    for (int k = 0; k < 3; ++k) {
      const auto at = static_cast<std::size_t>(draw.uniform_int(0, std::ssize(wrong) - 1));
      wrong[at] = static_cast<std::uint8_t>(draw.uniform_int(0, 255));
    }
    refused += !complaint_about(wrong).empty();
  }
  EXPECT_GT(refused, 500);
}

TEST(Jpeg, PicturesAreToldByTheirFirstBytes) {
  const Bytes bytes = packed(slopes(8, 8), TJSAMP_444), png = encode_png(slopes(8, 8));
  const auto picture = [](const Bytes& file) {
    return decode_picture({reinterpret_cast<const char*>(file.data()), file.size()}, "x");
  };
  EXPECT_EQ(picture(bytes), decode_jpeg(bytes, "x", 64));
  EXPECT_EQ(picture(png), slopes(8, 8));
  EXPECT_EQ(problem_of([&] { picture({}); }), "x: expected a PNG or JPEG file, found an empty one");
  EXPECT_EQ(problem_of([&] { picture({'G', 'I', 'F'}); }),
            "x: expected a PNG or JPEG file, found something else");
  EXPECT_FALSE(begins_as_jpeg(png));
}

}  // namespace
}  // namespace gradus
