#include "scene/obj.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <unordered_map>
#include <utility>

#include "core/image.hpp"
#include "core/shown.hpp"
#include "scene/materials.hpp"
#include "scene/statements.hpp"

namespace gradus::pipeline {
namespace {

/// The arrays an index may refer to.
enum Array { position, texture, normal };
constexpr std::array<const char*, 3> array_name{"vertex", "texture coordinate", "normal"};
constexpr std::array<const char*, 3> statement_name{"v", "vt", "vn"};

class Reader {
 public:
  Reader(const std::string& file, const FileReader& open) : file_(file), open_(open) {
    model_.mesh.files.push_back(file);
    material_of_[""] = 0;
  }

  void read(Statement& s) {
    const std::string_view key = s.word();
    if (key == "v") {
      vertex(s);
    } else if (key == "f") {
      face(s);
    } else if (key == "vn") {
      const dvec3 n = triple(s, "the normal");
      s.end("a normal");
      model_.mesh.normals.push_back(unit_vector(n));
    } else if (key == "vt") {
      texture_coordinates(s);
    } else if (key == "usemtl") {
      use(s);
    } else if (key == "s") {
      smoothing(s);
    } else if (key == "mtllib") {
      library(s);
    } else if (key == "p") {
      model_.points += 1;
      element(s, 1, "a point");
    } else if (key == "l") {
      model_.lines += 1;
      element(s, 2, "a line");
    } else if (key != "o" && key != "g" && !for_display(key)) {
      unknown(s, key);
    }
  }

  ModelFile finish() {
    Mesh& mesh = model_.mesh;
    if (mesh.faces.empty()) {
      throw InputError(
          fmt::format("{}: expected at least one face, found none ({} vertices, {} points, {} lines)",
                      shown_name(file_), mesh.positions.size(), model_.points, model_.lines));
    }
    check_indices();
    for (const auto& [material, note] : missing_) model_.notes.push_back(note);
    model_.normals_in_file = static_cast<std::int64_t>(mesh.normals.size());
    add_missing_normals(mesh, groups_told_ ? std::span<const int>(groups_) : std::span<const int>());
    return std::move(model_);
  }

 private:
  static constexpr int most = std::numeric_limits<int>::max() / 2;  // of anything that has a number

  static dvec3 triple(Statement& s, std::string_view what) {
    const double x = s.number(what);
    const double y = s.number(what);
    const double z = s.number(what);
    return {x, y, z};
  }

  /// x y z, x y z w, x y z r g b, or x y z w r g b. A weight is for curves, colours are not used.
  void vertex(Statement& s) {
    const dvec3 at = triple(s, "the vertex");
    int more = 0;
    for (; s.more(); ++more) s.number("the vertex");
    if (more != 0 && more != 1 && more != 3 && more != 4) {
      s.fail(fmt::format("expected a vertex of 3, 4, 6 or 7 numbers, found {}", 3 + more));
    }
    model_.mesh.positions.push_back(at);
    check_count(s, model_.mesh.positions.size());
  }

  void texture_coordinates(Statement& s) {
    const double u = s.number("the texture coordinate");
    const double v = s.more() ? s.number("the texture coordinate") : 0;
    if (s.more()) s.number("the texture coordinate");
    s.end("a texture coordinate");
    model_.mesh.textures.emplace_back(u, v);
    check_count(s, model_.mesh.textures.size());
  }

  static void check_count(Statement& s, std::size_t count) {
    if (count > static_cast<std::size_t>(most))
      s.fail(fmt::format("expected at most {} of them, found one more", most));
  }

  std::size_t size_of(Array array) const {
    const Mesh& mesh = model_.mesh;
    return array == position  ? mesh.positions.size()
           : array == texture ? mesh.textures.size()
                              : mesh.normals.size();
  }

  /// "3 vertices"
  static std::string counted(Array array, std::int64_t count) {
    const std::string_view one = array_name[array];
    return count == 1          ? fmt::format("1 {}", one)
           : array == position ? fmt::format("{} vertices", count)
                               : fmt::format("{} {}s", count, one);
  }

  [[noreturn]] static void no_corner(Statement& s, std::string_view word) {
    s.fail(
        fmt::format("expected a corner v, v/vt, v//vn or v/vt/vn of whole numbers, found {}", shown(word)));
  }

  /// One number of a corner as a place in its array, from 0; it is moved past. A positive one is checked at
  /// the end.
  int index(Statement& s, const char*& at, const char* end, Array array, std::string_view word) const {
    if (at != end && *at == '+') ++at;
    int number = 0;
    const auto [stopped, error] = std::from_chars(at, end, number);
    if (error == std::errc::result_out_of_range || number > most || number < -most) {
      s.fail(fmt::format("expected a {} index from {} to {}, found {}", array_name[array], -most, most,
                         shown(word)));
    }
    if (error != std::errc{} || (stopped != end && *stopped != '/')) {
      no_corner(s, word);
    }
    at = stopped;
    if (number > 0) return number - 1;
    if (number == 0)
      s.fail(fmt::format("expected a {} index that counts from 1, or from -1 backwards, found 0 in {}",
                         array_name[array], shown(word)));
    const auto size = static_cast<std::int64_t>(size_of(array));
    if (size + number < 0) {
      s.fail(fmt::format("expected one of the {} so far ({}), found {} in {}", counted(array, size),
                         statement_name[array], number, shown(word)));
    }
    return static_cast<int>(size + number);
  }

  Corner corner(Statement& s, std::string_view word) const {
    const char* at = word.data();
    const char* end = at + word.size();
    Corner corner{index(s, at, end, position, word), -1, -1};
    if (at == end) return corner;
    ++at;  // the first slash
    if (at != end && *at != '/') corner.texture = index(s, at, end, texture, word);
    if (at != end) {
      ++at;  // the second
      corner.normal = index(s, at, end, normal, word);
    }
    if (at != end || word.back() == '/') {
      no_corner(s, word);
    }
    return corner;
  }

  void face(Statement& s) {
    corners_.clear();
    while (s.more()) {
      const std::string_view word = s.word();
      corners_.push_back(corner(s, word));
      const Corner &first = corners_.front(), &last = corners_.back();
      if ((first.texture < 0) != (last.texture < 0) || (first.normal < 0) != (last.normal < 0)) {
        s.fail(fmt::format("expected corner {} of the face in the form of the first, found {}",
                           corners_.size(), shown(word)));
      }
    }
    if (corners_.size() < 3)
      s.fail(fmt::format("expected a face of at least 3 corners, found {}", corners_.size()));
    add_face(model_.mesh, corners_, material_, 0, s.line());
    groups_.push_back(group_);
    check_count(s, model_.mesh.faces.size());
  }

  /// Points and lines: their indices are looked at, and that is all.
  void element(Statement& s, int least, std::string_view what) {
    int count = 0;
    for (; s.more(); ++count) {
      const Corner c = corner(s, s.word());
      if (static_cast<std::size_t>(c.position) >= size_of(position)) {
        loose_.push_back({c.position, s.line()});
      }
    }
    if (count < least)
      s.fail(fmt::format("expected {} of at least {} vertices, found {}", what, least, count));
  }

  /// A material that is not known yet looks like the default one, and is completed when its library comes.
  void use(Statement& s) {
    const std::string name(s.rest());
    const auto next = static_cast<int>(model_.mesh.materials.size());
    const auto [found, is_new] = material_of_.try_emplace(name, next);
    material_ = found->second;
    if (!is_new) return;
    model_.mesh.materials.emplace_back().name = name;
    missing_.push_back(
        {next, s.place(fmt::format("no material {} was read: it is drawn like the default", shown(name)))});
  }

  void smoothing(Statement& s) {
    const std::string_view word = s.word();
    if (word == "off") {
      group_ = 0;
    } else if (word == "on") {
      group_ = 1;
    } else {
      const auto [stopped, error] = std::from_chars(word.data(), word.data() + word.size(), group_);
      if (error != std::errc{} || stopped != word.data() + word.size() || group_ < 0) {
        s.fail(fmt::format("expected a smoothing group, a whole number or off, found {}", shown(word)));
      }
    }
    s.end("a smoothing group");
    groups_told_ = true;
  }

  /// One name that may hold blanks, or several.
  void library(Statement& s) {
    const std::string all(s.rest());
    if (all.empty()) s.fail("expected a file's name after mtllib, found none");
    if (add_library(all)) return;
    bool several = false;
    for (std::size_t at = 0; at < all.size();) {
      const std::size_t begin = all.find_first_not_of(" \t", at);
      if (begin == std::string::npos) break;
      at = std::min(all.find_first_of(" \t", begin), all.size());
      const std::string name = all.substr(begin, at - begin);
      several = several || name.size() < all.size();
      if (!several || !add_library(name))
        model_.notes.push_back(
            s.place(fmt::format("no file {}: its materials are the default", shown(name))));
    }
  }

  bool add_library(const std::string& name) {
    if (std::ranges::find(libraries_, name) != libraries_.end()) return true;
    const std::optional<std::string> text = open_(name);
    if (!text) return false;
    libraries_.push_back(name);
    for (Material& material : parse_mtl(*text, name, model_.notes)) add_material(std::move(material));
    return true;
  }

  /// The first definition of a name counts, also when it comes after the first use.
  void add_material(Material material) {
    std::vector<Material>& materials = model_.mesh.materials;
    const auto next = static_cast<int>(materials.size());
    const auto [found, is_new] = material_of_.try_emplace(material.name, next);
    if (is_new) {
      materials.push_back(std::move(material));
    } else if (std::erase_if(missing_, [&](const auto& m) { return m.first == found->second; }) > 0) {
      materials[static_cast<std::size_t>(found->second)] = std::move(material);
    }
  }

  static bool for_display(std::string_view key) {
    constexpr std::array keys{"mg",     "bevel",      "c_interp",  "d_interp", "lod",  "usemap",
                              "maplib", "shadow_obj", "trace_obj", "ctech",    "stech"};
    return std::ranges::find(keys, key) != keys.end();
  }

  [[noreturn]] static void unknown(Statement& s, std::string_view key) {
    constexpr std::array free_form{"vp",   "cstype", "deg",  "bmat", "step", "curv", "curv2",
                                   "surf", "parm",   "trim", "hole", "scrv", "sp",   "end",
                                   "con",  "bzp",    "bsp",  "cdc",  "cdp",  "res"};
    if (std::ranges::find(free_form, key) != free_form.end()) {
      s.fail(fmt::format("expected faces alone, found {} of a free-form curve or surface", shown(key)));
    }
    s.fail(fmt::format("expected a statement of an OBJ file, found {}", shown(key)));
  }

  void check_indices() const {
    const Mesh& mesh = model_.mesh;
    for (const MeshFace& face : mesh.faces) {
      for (const Corner& corner : corners_of(mesh, face)) {
        check_index(corner.position, position, face.line);
        check_index(corner.texture, texture, face.line);
        check_index(corner.normal, normal, face.line);
      }
    }
    for (const auto& [index, line] : loose_) check_index(index, position, line);
  }

  void check_index(int index, Array array, int line) const {
    if (index < static_cast<std::int64_t>(size_of(array))) return;
    throw InputError(fmt::format(
        "{}:{}: expected one of the {} of the file ({}), found {}", shown_name(file_), line,
        counted(array, static_cast<std::int64_t>(size_of(array))), statement_name[array], index + 1));
  }

  const std::string& file_;
  const FileReader& open_;
  ModelFile model_;
  std::vector<Corner> corners_;  ///< of the face being read
  std::vector<int> groups_;      ///< the smoothing group of each face
  int group_ = 0;
  bool groups_told_ = false;
  int material_ = 0;
  std::unordered_map<std::string, int> material_of_;
  std::vector<std::pair<int, std::string>>
      missing_;  ///< materials that were used but not read, and what to say
  std::vector<std::string> libraries_;
  std::vector<std::pair<int, int>>
      loose_;  ///< indices of points and lines into what was not yet there, and their lines
};

std::optional<std::string> contents(const std::filesystem::path& path) {
  std::error_code ignored;
  if (!std::filesystem::exists(path, ignored)) return std::nullopt;
  if (std::filesystem::is_directory(path, ignored))
    throw InputError(fmt::format("{}: expected a file, found a folder", shown_name(path.string())));
  std::ifstream file(path, std::ios::binary);
  std::string text;
  // In large pieces: pipes don't know their size beforehand
  constexpr std::size_t piece = 1 << 20;
  while (file) {
    const std::size_t have = text.size();
    text.resize(have + piece);
    file.read(text.data() + have, piece);
    text.resize(have + static_cast<std::size_t>(file.gcount()));
    if (file.gcount() == 0) break;
  }
  if (!file.eof()) throw InputError(fmt::format("{}: can't be read", shown_name(path.string())));
  return text;
}

}  // namespace

ModelFile parse_obj(std::string_view text, const std::string& file, const FileReader& open) {
  Statements statements(text, file);
  Reader reader(file, open);
  while (std::optional<Statement> s = statements.next()) reader.read(*s);
  return reader.finish();
}

ModelFile load_obj(const std::string& path) {
  const std::optional<std::string> text = contents(path);
  if (!text) throw InputError(fmt::format("{}: there is no such file", shown_name(path)));
  const std::filesystem::path folder = std::filesystem::path(path).parent_path();
  return parse_obj(*text, path, [&folder](const std::string& name) {
    std::string native = name;
    std::ranges::replace(native, '\\', '/');  // written on Windows
    return contents(folder / native);
  });
}

}  // namespace gradus::pipeline
