#include "scene/models/obj.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <unordered_map>
#include <utility>

#include "core/refusal.hpp"
#include "core/shown.hpp"
#include "scene/models/materials.hpp"
#include "scene/models/statements.hpp"

namespace gradus::pipeline {
namespace {

/// The arrays an index may refer to.
enum Array { position, texture, normal };
constexpr std::array<const char*, 3> array_name{"vertex", "texture coordinate", "normal"};
constexpr std::array<const char*, 3> statement_name{"v", "vt", "vn"};

class ObjReader {
 public:
  ObjReader(const TextFile& file, const FileReader& open) : file_(file), open_(open) {
    model_.mesh.files.push_back(file.name);
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
      check_left_out(s, key);
      unknown_.add(s, key);
    }
  }

  ModelFile finish() {
    Mesh& mesh = model_.mesh;
    if (mesh.faces.empty()) {
      refuse_input(
          fmt::format("{}: expected at least one face, found none ({} vertices, {} points, {} lines)",
                      shown_name(file_.name), mesh.positions.size(), model_.points, model_.lines));
    }
    leave_out(texture, &Corner::texture);
    leave_out(normal, &Corner::normal);
    check_indices();
    lay_textures();
    if (coloured_ > 0) {
      model_.notes.push_back(
          fmt::format("{}:{}: colours of vertices are not used", shown_name(file_.name), coloured_));
    }
    for (const auto& [material, note] : missing_) model_.notes.push_back(note);
    for (std::string& note : unknown_.notes("an OBJ file")) model_.notes.push_back(std::move(note));
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

  /// x y z, x y z w, x y z r g b, or x y z w r g b. A weight is for curves, colours are told and not
  /// used.
  void vertex(Statement& s) {
    const dvec3 at = triple(s, "the vertex");
    int more = 0;
    for (; s.more(); ++more) s.number("the vertex");
    if (more != 0 && more != 1 && more != 3 && more != 4) {
      s.fail(fmt::format("expected a vertex of 3, 4, 6 or 7 numbers, found {}", 3 + more));
    }
    if (more >= 3 && coloured_ == 0) coloured_ = s.line();
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
    s.fail(fmt::format("expected a corner v, v/vt, v//vn or v/vt/vn of whole numbers, found {}",
                       s.quoted(word)));
  }

  /// One number of a corner as a place in its array, from 0; it is moved past. A positive one is checked at
  /// the end.
  int index(Statement& s, const char*& at, const char* end, Array array, std::string_view word) {
    if (at != end && *at == '+') ++at;
    int number = 0;
    const auto [stopped, error] = std::from_chars(at, end, number);
    if (error == std::errc::result_out_of_range || number > most || number < -most) {
      s.fail(fmt::format("expected a {} index from {} to {}, found {}", array_name[array], -most, most,
                         s.quoted(word)));
    }
    if (error != std::errc{} || (stopped != end && *stopped != '/')) {
      no_corner(s, word);
    }
    at = stopped;
    if (number > 0) return number - 1;
    if (number == 0)
      s.fail(fmt::format("expected a {} index that counts from 1, or from -1 backwards, found 0 in {}",
                         array_name[array], s.quoted(word)));
    const auto size = static_cast<std::int64_t>(size_of(array));
    if (size + number < 0) {
      const std::string problem =
          s.place(fmt::format("expected one of the {} so far ({}), found {} in {}", counted(array, size),
                              statement_name[array], s.quoted(number), s.quoted(word)));
      // No index can mean what the whole file lacks
      if (size > 0 || array == position) refuse_input(problem);
      if (too_early_[array].empty()) too_early_[array] = problem;
      return 0;
    }
    return static_cast<int>(size + number);
  }

  /// v, v/vt, v//vn or v/vt/vn; behind the last number slashes may follow, as some programs write them.
  Corner corner(Statement& s, std::string_view word) {
    const char* at = word.data();
    const char* end = at + word.size();
    Corner corner{index(s, at, end, position, word), -1, -1};
    const auto optional = [&](Array array) {
      if (at == end) return -1;
      ++at;  // the slash
      return at == end || *at == '/' ? -1 : index(s, at, end, array, word);
    };
    corner.texture = optional(texture);
    corner.normal = optional(normal);
    if (at != end) no_corner(s, word);
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
                           corners_.size(), s.quoted(word)));
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
    missing_.emplace(next, s.place(fmt::format("no material {} was read: it is drawn like the default",
                                               file_.quotable ? shown(name) : "of this name")));
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
        s.fail(fmt::format("expected a smoothing group, a whole number or off, found {}", s.quoted(word)));
      }
    }
    s.end("a smoothing group");
    groups_told_ = true;
  }

  /// One name that may hold blanks, or several.
  void library(Statement& s) {
    const std::string all(s.rest());
    if (all.empty()) s.fail("expected a file's name after mtllib, found none");
    if (add_library(s, all) || (unescaped(all) != all && add_library(s, unescaped(all)))) return;
    for (const std::string& name : names_in(all)) {
      if (name != unescaped(all) && add_library(s, name)) continue;
      model_.notes.push_back(s.place(fmt::format("no file {}: its materials are the default",
                                                 file_.quotable ? shown(name) : "of this name")));
    }
  }

  /// "a\ b.mtl" is a name with a blank.
  static std::string unescaped(std::string_view name) {
    std::string plain;
    for (std::size_t i = 0; i < name.size(); ++i) {
      const bool escape = name[i] == '\\' && i + 1 < name.size() && is_blank(name[i + 1]);
      if (!escape) plain += name[i];
    }
    return plain;
  }

  /// The names that stand apart, by blanks that are not escaped.
  static std::vector<std::string> names_in(const std::string& all) {
    std::vector<std::string> names;
    bool inside = false;
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (is_blank(all[i]) && (i == 0 || all[i - 1] != '\\')) {
        inside = false;
        continue;
      }
      if (!inside) names.emplace_back();
      inside = true;
      names.back() += all[i];
    }
    for (std::string& name : names) name = unescaped(name);
    return names;
  }

  static bool is_blank(char c) { return c == ' ' || c == '\t'; }

  bool add_library(Statement& s, const std::string& name) {
    if (std::ranges::find(libraries_, name) != libraries_.end()) return true;
    const std::optional<LibraryText> found = open_(name);
    if (!found) return false;
    if (!found->problem.empty())
      s.fail(file_.quotable ? found->problem : "expected a library that can be read");
    if (libraries_.size() == most_libraries)
      s.fail(fmt::format("expected at most {} material libraries, found one more", most_libraries));
    libraries_.push_back(name);
    const TextFile file{file_.quotable ? name : fmt::format("{}:{}: its library", file_.name, s.line()),
                        found->quotable && file_.quotable};
    for (LibraryMaterial& material : parse_mtl(found->text, file, model_.notes))
      add_material(std::move(material));
    return true;
  }

  /// The first definition of a name counts, also when it comes after the first use.
  void add_material(LibraryMaterial material) {
    std::vector<Material>& materials = model_.mesh.materials;
    const TexturePlacement placement = material.placement;
    const auto next = static_cast<int>(materials.size());
    const auto [found, is_new] = material_of_.try_emplace(material.name, next);
    if (is_new) {
      materials.push_back(std::move(material));
    } else if (missing_.erase(found->second) > 0) {
      materials[static_cast<std::size_t>(found->second)] = std::move(material);
    } else {
      return;
    }
    if (placement != TexturePlacement()) placements_.emplace(found->second, placement);
  }

  /// Gives faces whose texture is laid on in its own way texture coordinates of their own, for those of the
  /// file may be those of other materials, too.
  void lay_textures() {
    Mesh& mesh = model_.mesh;
    std::map<std::pair<int, int>, int> laid;  // of each material and texture coordinate
    for (const MeshFace& face : mesh.faces) {
      const auto placement = placements_.find(face.material);
      if (placement == placements_.end()) continue;
      for (std::int64_t i = face.first; i < face.first + face.count; ++i) {
        int& index = mesh.corners[static_cast<std::size_t>(i)].texture;
        if (index < 0) continue;
        const auto next = static_cast<int>(mesh.textures.size());
        const auto [found, is_new] = laid.try_emplace({face.material, index}, next);
        const dvec2 at = mesh.textures[static_cast<std::size_t>(index)];
        if (is_new) mesh.textures.push_back(placement->second.scale * at + placement->second.offset);
        index = found->second;
      }
    }
  }

  static bool for_display(std::string_view key) {
    constexpr std::array keys{"mg",     "bevel",      "c_interp",  "d_interp", "lod",  "usemap",
                              "maplib", "shadow_obj", "trace_obj", "ctech",    "stech"};
    return std::ranges::find(keys, key) != keys.end();
  }

  /// What can't be left out, for more would be seen with it.
  static void check_left_out(const Statement& s, std::string_view key) {
    constexpr std::array free_form{"vp",   "cstype", "deg",  "bmat", "step", "curv", "curv2",
                                   "surf", "parm",   "trim", "hole", "scrv", "sp",   "end",
                                   "con",  "bzp",    "bsp",  "cdc",  "cdp",  "res"};
    if (std::ranges::find(free_form, key) != free_form.end()) {
      s.fail(fmt::format("expected faces alone, found {} of a free-form curve or surface", s.quoted(key)));
    }
    if (key == "call" || key == "csh") {
      s.fail(fmt::format("expected a model in one file, found {} of another file", s.quoted(key)));
    }
  }

  /// Indices into data that the file lacks altogether mean nothing.
  void leave_out(Array array, int Corner::* member) {
    if (size_of(array) > 0) {
      if (!too_early_[array].empty()) refuse_input(too_early_[array]);
      return;
    }
    int first_line = 0;
    for (const MeshFace& face : model_.mesh.faces) {
      for (std::int64_t i = face.first; i < face.first + face.count; ++i) {
        int& index = model_.mesh.corners[static_cast<std::size_t>(i)].*member;
        if (index >= 0 && first_line == 0) first_line = face.line;
        index = -1;
      }
    }
    if (first_line > 0) {
      model_.notes.push_back(
          fmt::format("{}:{}: there are no {}s ({}) in the file: their indices are left out",
                      shown_name(file_.name), first_line, array_name[array], statement_name[array]));
    }
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
    refuse_input(fmt::format("{}:{}: expected one of the {} of the file ({}), found {}",
                             shown_name(file_.name), line,
                             counted(array, static_cast<std::int64_t>(size_of(array))), statement_name[array],
                             file_.quotable ? fmt::format("{}", index + 1) : "another"));
  }

  const TextFile& file_;
  const FileReader& open_;
  ModelFile model_;
  std::vector<Corner> corners_;  ///< of the face being read
  std::vector<int> groups_;      ///< the smoothing group of each face
  int group_ = 0;
  bool groups_told_ = false;
  int material_ = 0;
  std::unordered_map<std::string, int> material_of_;
  std::map<int, std::string> missing_;    ///< materials that were used but not read, and what to say
  std::array<std::string, 3> too_early_;  ///< for each array: the first index back into it while it was empty
  std::map<int, TexturePlacement> placements_;  ///< of materials that have their own
  int coloured_ = 0;                            ///< the first line with a vertex's colour
  UnknownStatements unknown_;
  std::vector<std::string> libraries_;
  std::vector<std::pair<int, int>>
      loose_;  ///< indices of points and lines into what was not yet there, and their lines
};

}  // namespace

ModelFile parse_obj(std::string_view text, const TextFile& file, const FileReader& open) {
  Statements statements(text, file);
  ObjReader reader(file, open);
  while (std::optional<Statement> s = statements.next()) reader.read(*s);
  return reader.finish();
}

}  // namespace gradus::pipeline
