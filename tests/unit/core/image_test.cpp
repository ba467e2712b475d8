#include "core/image.hpp"

#include <gtest/gtest.h>
#include <png.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <functional>
#include <random>

#ifndef GRADUS_SOURCE_DIR
#define GRADUS_SOURCE_DIR "."
#endif

namespace gradus {
namespace {

using Bytes = std::vector<std::uint8_t>;

Bytes bytes_of_file(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return Bytes(std::istreambuf_iterator<char>(file), {});
}

std::string data(const std::string& name) {
  return std::string(GRADUS_SOURCE_DIR) + "/examples/images/" + name;
}

std::string complaint(const std::function<void()>& call) {
  try {
    call();
  } catch (const InputError& error) {
    return error.what();
  }
  return "(no InputError)";
}

std::string complaint(const Bytes& bytes) {
  return complaint([&bytes] { decode_png(bytes, "x.png"); });
}

void append_bytes(png_structp png, png_bytep bytes, std::size_t count) {
  auto* to = static_cast<Bytes*>(png_get_io_ptr(png));
  to->insert(to->end(), bytes, bytes + count);
}

/// A file made by libpng itself, in any colour type and depth: the oracle's side of decode_png.
struct Sample {
  int width = 5, height = 3, depth = 8, color_type = PNG_COLOR_TYPE_RGB;
  bool interlaced = false;
  bool transparent = false;  ///< with a tRNS chunk
  Bytes row;                 ///< the same for every row
};

constexpr int palette_size = 4;
constexpr png_color palette[palette_size] = {{10, 20, 30}, {255, 0, 0}, {0, 255, 0}, {1, 2, 3}};

void set_transparency(png_structp png, png_infop info, int color_type) {
  png_byte alphas[] = {255, 128};
  png_color_16 key{};
  key.gray = 1;
  key.red = 9, key.green = 8, key.blue = 7;
  const bool indexed = color_type == PNG_COLOR_TYPE_PALETTE;
  png_set_tRNS(png, info, indexed ? alphas : nullptr, indexed ? 2 : 0, indexed ? nullptr : &key);
}

Bytes make(const Sample& sample) {
  Bytes bytes;
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  png_infop info = png_create_info_struct(png);
  png_set_write_fn(png, &bytes, append_bytes, [](png_structp) {});
  png_set_IHDR(png, info, static_cast<png_uint_32>(sample.width), static_cast<png_uint_32>(sample.height),
               sample.depth, sample.color_type, sample.interlaced ? PNG_INTERLACE_ADAM7 : PNG_INTERLACE_NONE,
               PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  if (sample.color_type == PNG_COLOR_TYPE_PALETTE) {
    png_set_PLTE(png, info, palette, sample.depth == 1 ? 2 : palette_size);
  }
  if (sample.transparent) set_transparency(png, info, sample.color_type);
  png_write_info(png, info);
  const int passes = png_set_interlace_handling(png);
  for (int pass = 0; pass < passes; ++pass) {
    for (int y = 0; y < sample.height; ++y) png_write_row(png, sample.row.data());
  }
  png_write_end(png, info);
  png_destroy_write_struct(&png, &info);
  return bytes;
}

/// Decodes the sample, plain and interlaced, and expects every row to be this.
void expect_row(Sample sample, const std::vector<Rgba8>& expected) {
  for (const bool interlaced : {false, true}) {
    sample.interlaced = interlaced;
    sample.width = static_cast<int>(expected.size());
    const Image image = decode_png(make(sample), "sample.png");
    ASSERT_EQ(image.width(), sample.width);
    ASSERT_EQ(image.height(), sample.height);
    for (int y = 0; y < image.height(); ++y) {
      for (int x = 0; x < image.width(); ++x) {
        EXPECT_EQ((image[{x, y}]), expected[static_cast<std::size_t>(x)])
            << "at " << x << "," << y << (interlaced ? " interlaced" : "");
      }
    }
  }
}

Rgba8 gray(int v, int alpha = 255) {
  const auto level = static_cast<std::uint8_t>(v);
  return {level, level, level, static_cast<std::uint8_t>(alpha)};
}

TEST(Png, GrayOfEveryDepth) {
  expect_row({.depth = 1, .color_type = PNG_COLOR_TYPE_GRAY, .row = {0b01011000}},
             {gray(0), gray(255), gray(0), gray(255), gray(255)});
  expect_row({.depth = 2, .color_type = PNG_COLOR_TYPE_GRAY, .row = {0b00011011, 0b10000000}},
             {gray(0), gray(85), gray(170), gray(255), gray(170)});
  expect_row({.depth = 4, .color_type = PNG_COLOR_TYPE_GRAY, .row = {0x0f, 0x31}},
             {gray(0), gray(255), gray(51), gray(17)});
  expect_row({.depth = 8, .color_type = PNG_COLOR_TYPE_GRAY, .row = {0, 127, 255}},
             {gray(0), gray(127), gray(255)});
  // 16 bits: the nearest of 256 levels
  expect_row(
      {.depth = 16, .color_type = PNG_COLOR_TYPE_GRAY, .row = {0, 0, 0xff, 0xff, 0x80, 0x00, 0x00, 0xff}},
      {gray(0), gray(255), gray(128), gray(1)});
}

TEST(Png, GrayWithAlpha) {
  expect_row({.depth = 8, .color_type = PNG_COLOR_TYPE_GRAY_ALPHA, .row = {7, 0, 9, 200}},
             {gray(7, 0), gray(9, 200)});
  expect_row({.depth = 16, .color_type = PNG_COLOR_TYPE_GRAY_ALPHA, .row = {255, 255, 128, 0}},
             {gray(255, 128)});
  expect_row({.depth = 8, .color_type = PNG_COLOR_TYPE_GRAY, .transparent = true, .row = {0, 1, 2}},
             {gray(0), gray(1, 0), gray(2)});
}

TEST(Png, Rgb) {
  expect_row({.depth = 8, .color_type = PNG_COLOR_TYPE_RGB, .row = {1, 2, 3, 255, 0, 9}},
             {{1, 2, 3}, {255, 0, 9}});
  expect_row({.depth = 16, .color_type = PNG_COLOR_TYPE_RGB, .row = {1, 1, 2, 2, 3, 3}}, {{1, 2, 3}});
  expect_row({.depth = 8, .color_type = PNG_COLOR_TYPE_RGB, .transparent = true, .row = {9, 8, 7, 9, 8, 6}},
             {{9, 8, 7, 0}, {9, 8, 6}});
}

TEST(Png, RgbWithAlpha) {
  expect_row({.depth = 8, .color_type = PNG_COLOR_TYPE_RGB_ALPHA, .row = {1, 2, 3, 4, 5, 6, 7, 255}},
             {{1, 2, 3, 4}, {5, 6, 7}});
  expect_row({.depth = 16, .color_type = PNG_COLOR_TYPE_RGB_ALPHA, .row = {1, 1, 2, 2, 3, 3, 4, 4}},
             {{1, 2, 3, 4}});
}

TEST(Png, PaletteOfEveryDepth) {
  const Rgba8 first{10, 20, 30}, red{255, 0, 0}, green{0, 255, 0}, last{1, 2, 3};
  expect_row({.depth = 1, .color_type = PNG_COLOR_TYPE_PALETTE, .row = {0b01100000}}, {first, red, red});
  expect_row({.depth = 2, .color_type = PNG_COLOR_TYPE_PALETTE, .row = {0b11100100}},
             {last, green, red, first});
  expect_row({.depth = 4, .color_type = PNG_COLOR_TYPE_PALETTE, .row = {0x30, 0x12}},
             {last, first, red, green});
  expect_row({.depth = 8, .color_type = PNG_COLOR_TYPE_PALETTE, .row = {3, 2, 1}}, {last, green, red});
  expect_row({.depth = 8, .color_type = PNG_COLOR_TYPE_PALETTE, .transparent = true, .row = {0, 1, 2}},
             {first, {255, 0, 0, 128}, green});
}

Image noise(int width, int height, bool opaque) {
  std::mt19937 random(7);
  Image image(width, height);
  for (Rgba8& c : image.cells()) {
    const std::uint32_t bits = static_cast<std::uint32_t>(random());
    c = {static_cast<std::uint8_t>(bits), static_cast<std::uint8_t>(bits >> 8),
         static_cast<std::uint8_t>(bits >> 16),
         opaque ? std::uint8_t{255} : static_cast<std::uint8_t>(bits >> 24)};
  }
  return image;
}

TEST(Png, RoundTrip) {
  int tried = 0;
  for (const bool opaque : {true, false}) {
    for (const auto& [width, height] : {std::pair{1, 1}, {1, 300}, {300, 1}, {17, 31}, {640, 3}}) {
      const Image image = noise(width, height, opaque);
      const Bytes bytes = encode_png(image);
      EXPECT_EQ(bytes[25], opaque ? PNG_COLOR_TYPE_RGB : PNG_COLOR_TYPE_RGB_ALPHA);
      EXPECT_EQ(decode_png(bytes, "round.png"), image);
      EXPECT_EQ(encode_png(image), bytes) << "the same picture gives the same bytes";
      ++tried;
    }
  }
  EXPECT_EQ(tried, 10);
}

TEST(Png, TextsRoundTrip) {
  const std::vector<PngText> texts{
      {"Title", "Linie — p = 2·dy − dx"}, {"Empty", ""}, {"gradus", "run --from -5,8\n"}};
  const auto found = png_texts(encode_png(Image(2, 2), texts), "t.png");
  ASSERT_EQ(found.size(), texts.size());
  for (std::size_t i = 0; i < texts.size(); ++i) {
    EXPECT_EQ(found[i].key, texts[i].key);
    EXPECT_EQ(found[i].text, texts[i].text);
  }
}

void append_number(Bytes& to, std::uint32_t number) {
  for (const int shift : {24, 16, 8, 0}) to.push_back(static_cast<std::uint8_t>(number >> shift));
}

/// Of a PNG: its length, its name and body, and their checksum.
Bytes chunk(const Bytes& name_and_body) {
  std::uint32_t crc = 0xffffffffu;
  for (const std::uint8_t byte : name_and_body) {
    crc ^= byte;
    for (int bit = 0; bit < 8; ++bit) crc = (crc >> 1) ^ ((crc & 1) ? 0xedb88320u : 0u);
  }
  Bytes bytes;
  append_number(bytes, static_cast<std::uint32_t>(name_and_body.size() - 4));
  bytes.insert(bytes.end(), name_and_body.begin(), name_and_body.end());
  append_number(bytes, ~crc);
  return bytes;
}

TEST(Png, Latin1TextsBecomeUtf8) {
  Bytes bytes = encode_png(Image(1, 1));
  // tEXt "k\0é", put right behind IHDR
  const Bytes text = chunk({'t', 'E', 'X', 't', 'k', 0, 0xe9});
  bytes.insert(bytes.begin() + 33, text.begin(), text.end());
  const auto texts = png_texts(bytes, "t.png");
  ASSERT_EQ(texts.size(), 1u);
  EXPECT_EQ(texts[0].key, "k");
  EXPECT_EQ(texts[0].text, "é");
}

TEST(Png, ATextWithNulIsRefusedNotCut) {
  const auto read = [](const Bytes& body) {
    Bytes bytes = encode_png(Image(1, 1));
    const Bytes text = chunk(body);
    bytes.insert(bytes.begin() + 33, text.begin(), text.end());
    return png_texts(bytes, "t.png");
  };
  EXPECT_THROW(read({'t', 'E', 'X', 't', 'k', 0, 'a', 0, 'b'}), InputError);
  EXPECT_THROW(read({'i', 'T', 'X', 't', 'k', 0, 0, 0, 'd', 'e', 0, 0, 'a', 0, 'b'}), InputError);
  const auto whole = read({'i', 'T', 'X', 't', 'k', 0, 0, 0, 'd', 'e', 0, 0, 'a', 'b'});
  ASSERT_EQ(whole.size(), 1u);
  EXPECT_EQ(whole[0].text, "ab");
}

TEST(Png, AnEmptyPictureIsNoPng) { EXPECT_THROW(encode_png(Image(0, 4)), ContractViolation); }

TEST(Png, KeysHaveOneTo79Letters) {
  const std::vector<PngText> empty{{"", "x"}}, longest{{std::string(79, 'k'), "x"}},
      longer{{std::string(80, 'k'), "x"}};
  EXPECT_THROW(encode_png(Image(1, 1), empty), ContractViolation);
  EXPECT_EQ(png_texts(encode_png(Image(1, 1), longest), "t.png").size(), 1u);
  EXPECT_THROW(encode_png(Image(1, 1), longer), ContractViolation);
}

TEST(Png, SomethingElseIsRefused) {
  EXPECT_EQ(complaint(Bytes{}), "x.png: expected a PNG file, found an empty one");
  EXPECT_EQ(complaint(Bytes{'G', 'I', 'F', '8', '9', 'a', 0, 0, 0}),
            "x.png: expected a PNG file, found something else");
}

TEST(Png, EveryTruncationIsRefused) {
  const Bytes whole = encode_png(noise(9, 7, false));
  int refused = 0;
  for (std::size_t size = 0; size < whole.size(); ++size) {
    const Bytes cut(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size));
    refused += complaint(cut).starts_with("x.png: expected a ");
  }
  EXPECT_EQ(refused, static_cast<int>(whole.size()));
}

TEST(Png, DamageIsRefusedOrHarmless) {
  const Bytes whole = encode_png(noise(9, 7, true));
  int refused = 0;
  for (std::size_t at = 0; at < whole.size(); ++at) {
    Bytes bytes = whole;
    bytes[at] = static_cast<std::uint8_t>(bytes[at] ^ 0x55);
    refused += complaint(bytes) != "(no InputError)";
  }
  EXPECT_EQ(refused, static_cast<int>(whole.size())) << "every byte here is under a checksum or in the frame";
}

/// A file of this size in its header, with a right checksum, and no pixels to speak of.
Bytes with_header(std::uint32_t width, std::uint32_t height) {
  Bytes bytes = encode_png(Image(1, 1));
  Bytes header{'I', 'H', 'D', 'R'};
  append_number(header, width);
  append_number(header, height);
  header.insert(header.end(), bytes.begin() + 24, bytes.begin() + 29);
  std::ranges::copy(chunk(header), bytes.begin() + 8);
  return bytes;
}

TEST(Png, HostileSizesAskForNoMemory) {
  EXPECT_EQ(decode_png(with_header(1, 1), "x.png").width(), 1) << "the helper's checksum is right";
  EXPECT_NE(complaint(with_header(0, 1)).find("x.png: expected a whole PNG file"), std::string::npos);
  EXPECT_NE(complaint(with_header(1, 0)).find("x.png: expected a whole PNG file"), std::string::npos);
  EXPECT_EQ(complaint(with_header(0x7fffffff, 0x7fffffff)),
            "x.png: expected at most 268435456 pixels, found 2147483647 x 2147483647");
  EXPECT_EQ(complaint(with_header(16384, 16385)),
            "x.png: expected at most 268435456 pixels, found 16384 x 16385");
  // Within the limit, but a few dozen bytes can't hold it: refused before a gigabyte is asked for
  const std::string cut = complaint(with_header(16384, 16384));
  EXPECT_TRUE(cut.starts_with("x.png: expected a whole PNG file, found ")) << cut;
  EXPECT_TRUE(cut.ends_with(" bytes for 16384 x 16384 pixels")) << cut;
}

TEST(Png, MissingFilesAreNamed) {
  EXPECT_EQ(complaint([] { read_png("/nowhere/a.png"); }),
            "/nowhere/a.png: expected a readable file, found none (No such file or directory)");
  EXPECT_EQ(complaint([] { read_png("/"); }), "/: expected a readable file, found none (Is a directory)");
}

TEST(Png, RealPictures) {
  const Image camera = read_png(data("camera.png"));
  EXPECT_EQ(camera.window(), (Window{{0, 0}, {511, 511}}));
  EXPECT_EQ((camera[{0, 0}]), gray(200)) << "compared with another reader (Python)";
  EXPECT_EQ((camera[{511, 511}]), gray(149));
  const Image horse = read_png(data("horse.png"));
  EXPECT_EQ(horse.window(), (Window{{0, 0}, {399, 327}}));
  EXPECT_EQ((horse[{0, 0}]), gray(255, 110));
  EXPECT_EQ((horse[{200, 160}]), gray(0));
  for (const char* name : {"camera.png", "horse.png"}) {
    const Image image = read_png(data(name));
    EXPECT_EQ(decode_png(encode_png(image), name), image);
  }
  EXPECT_FALSE(png_texts(bytes_of_file(data("horse.png")), "horse.png").empty());
}

}  // namespace
}  // namespace gradus
