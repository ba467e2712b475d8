// PNG files: a picture or a refusal, never more memory than the file can fill. Checksums are made right, else
// no mutation would get past them.

#include <png.h>
#include <zlib.h>

#include <algorithm>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/image.hpp"
#include "support/fuzz_input.hpp"

using namespace gradus;
using gradus::test::require;

namespace {

using Bytes = std::vector<std::uint8_t>;

std::uint32_t big_endian(const std::uint8_t* at) {
  return std::uint32_t{at[0]} << 24 | std::uint32_t{at[1]} << 16 | std::uint32_t{at[2]} << 8 | at[3];
}
void put_big_endian(std::uint8_t* at, std::uint32_t value) {
  for (int i = 0; i < 4; ++i) at[i] = static_cast<std::uint8_t>(value >> (24 - 8 * i));
}

/// Writes the right checksum behind every chunk that is there whole.
void mend(Bytes& file) {
  constexpr std::size_t signature = 8, frame = 12;
  for (std::size_t at = signature; at + frame <= file.size();) {
    const std::size_t length = big_endian(file.data() + at);
    if (length > file.size() - at - frame) return;
    const auto sum = crc32(0, file.data() + at + 4, static_cast<uInt>(length + 4));
    put_big_endian(file.data() + at + 8 + length, static_cast<std::uint32_t>(sum));
    at += length + frame;
  }
}

void add_chunk(Bytes& file, const char* name, std::span<const std::uint8_t> data) {
  const std::size_t at = file.size();
  file.resize(at + 8);
  put_big_endian(file.data() + at, static_cast<std::uint32_t>(data.size()));
  std::copy(name, name + 4, file.begin() + static_cast<std::ptrdiff_t>(at + 4));
  file.insert(file.end(), data.begin(), data.end());
  file.insert(file.end(), 4, 0);
}

/// A file whose header and rows come from the input, packed as they should be.
Bytes packed(test::FuzzInput input) {
  static constexpr std::uint8_t depths[]{1, 2, 4, 8, 16, 3}, colours[]{0, 2, 3, 4, 6, 5};
  Bytes file{0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
  std::uint8_t header[13]{};
  put_big_endian(header, static_cast<std::uint32_t>(input.below(40)));
  put_big_endian(header + 4, static_cast<std::uint32_t>(input.below(40)));
  header[8] = depths[input.below(6)];
  header[9] = colours[input.below(6)];
  header[12] = static_cast<std::uint8_t>(input.below(3));
  add_chunk(file, "IHDR", header);
  Bytes palette(static_cast<std::size_t>(3 * input.below(20)));
  for (std::uint8_t& part : palette) part = input.byte();
  if (!palette.empty()) add_chunk(file, "PLTE", palette);
  Bytes clear(static_cast<std::size_t>(input.below(8)));
  for (std::uint8_t& part : clear) part = input.byte();
  if (!clear.empty()) add_chunk(file, "tRNS", clear);
  // Rows that come again, so that small inputs fill pictures
  const std::string_view rest = input.rest();
  Bytes rows(4000);
  for (std::size_t i = 0; i < rows.size() && !rest.empty(); ++i) {
    rows[i] = static_cast<std::uint8_t>(rest[i % rest.size()]);
  }
  uLongf length = compressBound(static_cast<uLong>(rows.size()));
  Bytes small(length);
  compress(small.data(), &length, rows.data(), static_cast<uLong>(rows.size()));
  small.resize(length);
  add_chunk(file, "IDAT", small);
  add_chunk(file, "IEND", {});
  mend(file);
  return file;
}

void decode(const Bytes& file) {
  try {
    const Image image = decode_png(file, "p.png");
    require(image.width() > 0 && image.height() > 0, "a picture has pixels");
    const Bytes again = encode_png(image);
    require(decode_png(again, "again.png") == image, "what is written is read back");
    static_cast<void>(png_texts(file, "p.png"));
  } catch (const InputError& error) {
    require(test::harmless(error.what()), "an error is safe to show");
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  Bytes file(data + 1, data + size);
  if (data[0] % 3 == 0) decode(file);
  if (data[0] % 3 == 1) {
    mend(file);
    decode(file);
  }
  if (data[0] % 3 == 2) decode(packed({data + 1, size - 1}));
  return 0;
}
