#include "cli/models/gltf_data.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "cli/models/gltf_json.hpp"
#include "cli/models/imported_model.hpp"
#include "scene/models/little_endian.hpp"

namespace gradus::cli {
namespace {

using pipeline::JsonNode;

constexpr std::size_t most_gltf_bytes = std::size_t{1} << 40;  // sums of such numbers don't overflow

/// The bytes of a text in Base64, up to its end or padding; nothing where another letter stands.
std::optional<std::string> from_base64(std::string_view text) {
  std::string bytes;
  std::uint32_t bits = 0;
  int count = 0;
  for (const char c : text.substr(0, text.find('='))) {
    const int value = 'A' <= c && c <= 'Z'   ? c - 'A'
                      : 'a' <= c && c <= 'z' ? c - 'a' + 26
                      : '0' <= c && c <= '9' ? c - '0' + 52
                      : c == '+' || c == '-' ? 62
                      : c == '/' || c == '_' ? 63
                                             : -1;
    if (value < 0) return std::nullopt;
    bits = bits << 6 | static_cast<std::uint32_t>(value);
    count += 6;
    if (count < 8) continue;
    count -= 8;
    bytes += static_cast<char>(bits >> count & 0xff);
  }
  return bytes;
}

class DataCheck : GltfJson {
 public:
  DataCheck(const JsonNode& root, const std::string& file, std::optional<std::string_view> binary,
            const pipeline::FileReader& open)
      : GltfJson(file), root_(root), binary_(binary), open_(open) {}

  void check() {
    for (const JsonNode& buffer : list_of(root_, "buffers")) take_buffer(buffer);
    for (const JsonNode& view : list_of(root_, "bufferViews")) check_view(view);
    for (const JsonNode& accessor : list_of(root_, "accessors")) check_accessor(accessor);
    for (const JsonNode& mesh : list_of(root_, "meshes"))
      for (const JsonNode& primitive : list_of(mesh, "primitives")) check_primitive(primitive);
    for (const JsonNode& image : list_of(root_, "images")) check_image(image);
  }

 private:
  /// The bytes that a data URI holds, where this is one.
  std::optional<std::string> data_in(const JsonNode& uri) const {
    if (!uri.text.starts_with("data:")) return std::nullopt;
    constexpr std::string_view mark = ";base64,";
    const std::size_t at = uri.text.find(mark);
    const auto bytes = at == std::string::npos
                           ? std::nullopt
                           : from_base64(std::string_view(uri.text).substr(at + mark.size()));
    if (!bytes) refuse(uri, "data in Base64", "others");
    return bytes;
  }

  /// The bytes of a buffer, where they are at hand.
  std::optional<pipeline::LibraryText> bytes_of(const JsonNode& buffer) const {
    const auto* const uri = buffer.member("uri");
    if (!uri) return buffers_.empty() && binary_ ? std::optional(std::string(*binary_)) : std::nullopt;
    if (auto data = data_in(uri->value)) return *std::move(data);
    for (const std::string& name : {uri->value.text, name_in_uri(uri->value.text)}) {
      auto found = open_(name);
      if (found && found->problem.empty()) return found;
    }
    return std::nullopt;
  }

  void take_buffer(const JsonNode& buffer) {
    auto bytes = bytes_of(buffer);
    const std::size_t length = number_of(buffer, "byteLength", most_gltf_bytes);
    if (bytes && bytes->text.size() < length)
      refuse(buffer, fmt::format("a buffer of {} bytes", length),
             bytes->quotable ? fmt::format("one of {}", bytes->text.size()) : "a shorter file");
    buffers_.push_back(std::move(bytes));
  }

  void check_view(const JsonNode& view) const {
    const JsonNode* const buffer = named_by(view, "buffer", list_of(root_, "buffers"), "buffers");
    if (!buffer) return;
    const std::size_t end =
        number_of(view, "byteOffset", most_gltf_bytes) + number_of(view, "byteLength", most_gltf_bytes);
    const std::size_t length = number_of(*buffer, "byteLength", most_gltf_bytes);
    if (end > length)
      refuse(view, fmt::format("a view within the {} bytes of its buffer", length),
             fmt::format("one that ends at {}", end));
  }

  /// The bytes of a number of this componentType.
  std::size_t size_of(const JsonNode& accessor) const {
    switch (number_of(accessor, "componentType", 1 << 16)) {
      case 5120:
      case 5121:
        return 1;
      case 5122:
      case 5123:
        return 2;
      case 5125:
      case 5126:
        return 4;
      default:
        refuse(accessor, "a componentType of glTF 2.0", "another");
    }
  }

  std::size_t numbers_in(const JsonNode& accessor) const {
    static constexpr std::array<std::pair<std::string_view, std::size_t>, 7> types{
        {{"SCALAR", 1}, {"VEC2", 2}, {"VEC3", 3}, {"VEC4", 4}, {"MAT2", 4}, {"MAT3", 9}, {"MAT4", 16}}};
    const auto* const type = accessor.member("type");
    const auto* const found = std::ranges::find(types, type ? std::string_view(type->value.text) : "",
                                                &std::pair<std::string_view, std::size_t>::first);
    if (found == types.end()) refuse(accessor, "a type of glTF 2.0", "another");
    return found->second;
  }

  std::size_t count_of(const JsonNode& accessor) const {
    return number_of(accessor, "count", most_imported_corners);
  }
  const JsonNode* view_of(const JsonNode& accessor) const {
    return named_by(accessor, "bufferView", list_of(root_, "bufferViews"), "bufferViews");
  }
  /// From one element to the next, which may not lie in each other; 0 is taken for no byteStride.
  std::size_t stride_of(const JsonNode& accessor, const JsonNode& view) const {
    const std::size_t size = size_of(accessor) * numbers_in(accessor),
                      stride = number_of(view, "byteStride", 252);
    if (stride == 0) return size;
    if (stride < size)
      refuse(view, fmt::format("a byteStride of at least {}, the bytes of an element", size),
             std::to_string(stride));
    return stride;
  }

  void check_accessor(const JsonNode& accessor) const {
    const std::size_t count = count_of(accessor);
    const JsonNode* const view = view_of(accessor);
    if (!view || count == 0) return;
    const std::size_t end = number_of(accessor, "byteOffset", most_gltf_bytes) +
                            (count - 1) * stride_of(accessor, *view) +
                            size_of(accessor) * numbers_in(accessor);
    const std::size_t length = number_of(*view, "byteLength", most_gltf_bytes);
    if (end > length)
      refuse(accessor, fmt::format("an accessor within the {} bytes of its bufferView", length),
             fmt::format("one that ends at {}", end));
  }

  const JsonNode* accessor_of(const JsonNode& object, std::string_view key) const {
    return named_by(object, key, list_of(root_, "accessors"), "accessors");
  }

  /// Places and normals are three floats each, texture coordinates two numbers.
  void check_type(std::string_view attribute, const JsonNode& accessor) const {
    constexpr std::size_t single = 5126;
    const bool in_space = attribute == "POSITION" || attribute == "NORMAL";
    const bool on_pictures = attribute.starts_with("TEXCOORD_");
    if (in_space && (numbers_in(accessor) != 3 || number_of(accessor, "componentType", 1 << 16) != single))
      refuse(accessor, fmt::format("three floats for {} (VEC3 of 5126)", attribute), "others");
    if (on_pictures && numbers_in(accessor) != 2)
      refuse(accessor, fmt::format("two numbers for {} (VEC2)", attribute), "others");
  }

  void check_primitive(const JsonNode& primitive) {
    number_of(primitive, "mode", 6);
    const auto* const attributes = primitive.member("attributes");
    if (!attributes) return;
    const JsonNode* const places = accessor_of(attributes->value, "POSITION");
    if (!places) return;
    const std::size_t vertices = count_of(*places);
    for (const auto& [name, line, number] : attributes->value.members) {
      const JsonNode* const accessor = accessor_of(attributes->value, name);
      if (count_of(*accessor) != vertices)
        refuse(number, fmt::format("an accessor of {} vertices, as POSITION has them", vertices),
               fmt::format("one of {}", count_of(*accessor)));
      check_type(name, *accessor);
    }
    const JsonNode* const indices = accessor_of(primitive, "indices");
    if (!indices) return;
    // Few bytes can ask for the same numbers again and again
    corners_ += count_of(*indices);
    if (corners_ > most_imported_corners)
      refuse(primitive, fmt::format("at most {} indices in all", most_imported_corners), "more");
    check_indices(*indices, vertices);
  }

  void check_indices(const JsonNode& indices, std::size_t vertices) const {
    const JsonNode* const view = view_of(indices);
    if (!view || !view->member("buffer")) return;
    const auto& buffer = buffers_[*number_below(view->member("buffer")->value, buffers_.size())];
    if (!buffer) return;
    const std::size_t size = size_of(indices), stride = stride_of(indices, *view);
    const std::size_t first =
        number_of(*view, "byteOffset", most_gltf_bytes) + number_of(indices, "byteOffset", most_gltf_bytes);
    for (std::size_t i = 0; i < count_of(indices); ++i) {
      const std::uint64_t index = pipeline::whole_at(buffer->text, first + i * stride, size);
      if (index >= vertices)
        refuse(indices, fmt::format("indices of the {} vertices, from 0", vertices),
               fmt::format("{} at index {}", buffer->quotable ? fmt::format("{}", index) : "another", i));
    }
  }

  void check_image(const JsonNode& image) const {
    named_by(image, "bufferView", list_of(root_, "bufferViews"), "bufferViews");
    const auto* const uri = image.member("uri");
    if (!uri) return;
    const auto bytes = data_in(uri->value);
    if (bytes && bytes->empty()) refuse(uri->value, "a picture", "empty data");
  }

  const JsonNode& root_;
  std::optional<std::string_view> binary_;
  const pipeline::FileReader& open_;
  std::size_t corners_ = 0;
  std::vector<std::optional<pipeline::LibraryText>> buffers_;  ///< of each the bytes that are at hand
};

}  // namespace

void check_gltf_data(const JsonNode& root, const std::string& file, std::optional<std::string_view> binary,
                     const pipeline::FileReader& open) {
  DataCheck(root, file, binary, open).check();
}

std::string name_in_uri(std::string_view uri) {
  std::string name;
  for (std::size_t i = 0; i < uri.size(); ++i) {
    unsigned code = 0;
    const char* const end = uri.data() + std::min(i + 3, uri.size());
    if (uri[i] == '%' && i + 2 < uri.size() &&
        std::from_chars(uri.data() + i + 1, end, code, 16).ptr == end && code >= 0x20) {
      name += static_cast<char>(code);
      i += 2;
    } else {
      name += uri[i];
    }
  }
  return name;
}

}  // namespace gradus::cli
