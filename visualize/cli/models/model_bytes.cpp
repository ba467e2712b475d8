#include "cli/models/model_bytes.hpp"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <type_traits>
#include <utility>

namespace gradus::cli {
namespace {

class ModelWriter {
 public:
  template <class T>
    requires std::is_trivially_copyable_v<T>
  void operator()(const T& value) {
    bytes_.append(reinterpret_cast<const char*>(&value), sizeof value);
  }
  void operator()(const std::string& text) {
    (*this)(text.size());
    bytes_ += text;
  }
  template <class T>
  void operator()(const std::vector<T>& values) {
    (*this)(values.size());
    if constexpr (std::is_trivially_copyable_v<T>) {
      bytes_.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T));
    } else {
      for (const T& value : values) fields(*this, value);
    }
  }
  std::string take() { return std::move(bytes_); }

 private:
  std::string bytes_;
};

class ModelReader {
 public:
  explicit ModelReader(std::string_view bytes) : rest_(bytes) {}

  template <class T>
    requires std::is_trivially_copyable_v<T>
  void operator()(T& value) {
    if (const char* from = taken(sizeof value)) std::memcpy(&value, from, sizeof value);
  }
  void operator()(std::string& text) {
    std::size_t size = 0;
    (*this)(size);
    if (const char* from = taken(size)) text.assign(from, size);
  }
  template <class T>
  void operator()(std::vector<T>& values) {
    std::size_t count = 0;
    (*this)(count);
    values.clear();
    if constexpr (std::is_trivially_copyable_v<T>) {
      if (count > rest_.size() / sizeof(T)) return fail();
      values.resize(count);
      const char* from = taken(count * sizeof(T));
      if (count > 0) std::memcpy(values.data(), from, count * sizeof(T));
    } else {
      for (; count > 0 && whole_; --count) fields(*this, values.emplace_back());
    }
  }
  /// Whether all bytes have been read, and no more.
  bool whole() const { return whole_ && rest_.empty(); }

 private:
  void fail() { whole_ = false, rest_ = {}; }
  /// The next bytes; nullptr where there are not so many.
  const char* taken(std::size_t size) {
    if (size > rest_.size()) {
      fail();
      return nullptr;
    }
    const char* from = rest_.data();
    rest_.remove_prefix(size);
    return from;
  }

  std::string_view rest_;
  bool whole_ = true;
};

/// What crosses, the same list both ways.
template <class Wire, class T>
  requires std::same_as<std::remove_const_t<T>, std::string>
void fields(Wire& wire, T& text) {
  wire(text);
}
template <class Wire, class T>
  requires std::same_as<std::remove_const_t<T>, Material>
void fields(Wire& wire, T& m) {
  wire(m.name), wire(m.ambient), wire(m.diffuse), wire(m.specular), wire(m.shininess), wire(m.emission),
      wire(m.opacity);
  wire(m.diffuse_map.file), wire(m.diffuse_map.place), wire(m.diffuse_map.quotable);
}
template <class Wire, class T>
  requires std::same_as<std::remove_const_t<T>, Mesh>
void fields(Wire& wire, T& mesh) {
  wire(mesh.positions), wire(mesh.normals), wire(mesh.textures), wire(mesh.corners), wire(mesh.faces);
  wire(mesh.materials), wire(mesh.files);
}

using PictureFile = std::pair<std::string, std::string>;
template <class Wire, class T>
  requires std::same_as<std::remove_const_t<T>, PictureFile>
void fields(Wire& wire, T& picture) {
  wire(picture.first), wire(picture.second);
}

bool is_sound(const Mesh& mesh) {
  const auto among = [](int number, const auto& list) { return number < std::ssize(list); };
  const auto corner = [&](const Corner& c) {
    return c.position >= 0 && among(c.position, mesh.positions) && c.texture >= -1 &&
           among(c.texture, mesh.textures) && c.normal >= -1 && among(c.normal, mesh.normals);
  };
  const auto face = [&](const MeshFace& f) {
    return f.count >= 3 && f.first >= 0 && f.first <= std::ssize(mesh.corners) - f.count && f.material >= 0 &&
           among(f.material, mesh.materials) && f.file >= -1 && among(f.file, mesh.files);
  };
  return std::ranges::all_of(mesh.corners, corner) && std::ranges::all_of(mesh.faces, face);
}

}  // namespace

std::string bytes_of(const pipeline::ModelFile& model) {
  ModelWriter wire;
  fields(wire, model.mesh);
  wire(model.normals_in_file), wire(model.points), wire(model.lines), wire(model.notes);
  wire(std::vector<PictureFile>(model.pictures.begin(), model.pictures.end()));
  return wire.take();
}

std::optional<pipeline::ModelFile> model_in_bytes(std::string_view bytes) {
  ModelReader wire(bytes);
  pipeline::ModelFile model;
  std::vector<PictureFile> pictures;
  fields(wire, model.mesh);
  wire(model.normals_in_file), wire(model.points), wire(model.lines), wire(model.notes);
  wire(pictures);
  if (!wire.whole() || !is_sound(model.mesh)) return std::nullopt;
  for (PictureFile& picture : pictures) model.pictures.insert(std::move(picture));
  return model;
}

}  // namespace gradus::cli
