#include "scene/models/ply.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include "core/refusal.hpp"
#include "core/shown.hpp"
#include "scene/models/faces_by_place.hpp"
#include "scene/models/ply_header.hpp"
#include "scene/models/ply_rows.hpp"

namespace gradus::pipeline {
namespace {

class PlyReader {
 public:
  PlyReader(std::string_view bytes, const TextFile& file)
      : file_(file), header_(read_ply_header(bytes, file)), rows_(rows_of(bytes, header_, file)) {
    model_.mesh.files.push_back(file.name);
    if (header_.picture.empty()) return;
    Material& pictured = model_.mesh.materials.emplace_back();
    pictured.name = "TextureFile";
    pictured.diffuse = pictured.ambient = LinearRgb{1};  // the picture alone
    pictured.diffuse_map = {header_.picture, {}, header_.picture_place, file.quotable};
    material_ = static_cast<int>(model_.mesh.materials.size()) - 1;
  }

  ModelFile read() {
    for (const PlyElement& element : header_.elements)
      if (element.name == "vertex") prepare_vertices(element);
    if (vertices_ < 0) refuse("expected an element vertex, found none");
    for (const PlyElement& element : header_.elements) read(element);
    model_.mesh.textures = std::move(textures_);
    model_.mesh.textures.insert(model_.mesh.textures.end(), wedges_.begin(), wedges_.end());
    const std::string left = rows_->what_is_left();
    add_notes();
    if (!left.empty()) model_.notes.push_back(left);
    // Faces may stand before the vertices
    for (Corner& corner : model_.mesh.corners)
      corner.position = positions_[static_cast<std::size_t>(corner.position)];
    return finished(std::move(model_), file_);
  }

 private:
  static constexpr std::int64_t largest_count = std::int64_t{1}
                                                << 28;  // more corners than the largest file has

  /// What a property of a vertex is for.
  enum Role { x, y, z, nx, ny, nz, u, v, roles, nothing = roles };

  static Role role_of(const PlyProperty& property) {
    constexpr std::array<std::pair<std::string_view, Role>, 14> names{{{"x", x},
                                                                       {"y", y},
                                                                       {"z", z},
                                                                       {"nx", nx},
                                                                       {"ny", ny},
                                                                       {"nz", nz},
                                                                       {"u", u},
                                                                       {"v", v},
                                                                       {"s", u},
                                                                       {"t", v},
                                                                       {"texture_u", u},
                                                                       {"texture_v", v},
                                                                       {"texture_s", u},
                                                                       {"texture_t", v}}};
    const auto found =
        std::ranges::find(names, std::string_view(property.name), &decltype(names)::value_type::first);
    return property.count || found == names.end() ? nothing : found->second;
  }

  static bool is_colour(const PlyProperty& property) {
    constexpr std::array<std::string_view, 4> ends{"red", "green", "blue", "alpha"};
    return std::ranges::any_of(ends, [&](std::string_view end) { return property.name.ends_with(end); });
  }

  static bool is_indices(const PlyProperty& p) {
    return p.count && (p.name == "vertex_indices" || p.name == "vertex_index");
  }

  [[noreturn]] void refuse(std::string_view what) const {
    refuse_input(fmt::format("{}: {}", shown_name(file_.name), what));
  }

  void prepare_vertices(const PlyElement& element) {
    if (vertices_ >= 0) refuse("expected one element vertex, found two");
    if (element.rows > largest_count)
      refuse(fmt::format("expected at most {} vertices, found more", largest_count));
    vertices_ = element.rows;
    std::array<bool, roles + 1> has{};
    for (const PlyProperty& property : element.properties) has[roles_.emplace_back(role_of(property))] = true;
    if (!has[x] || !has[y] || !has[z])
      refuse("expected the properties x, y and z of vertex, found less than these");
    has_normals_ = has[nx] && has[ny] && has[nz];
    has_textures_ = has[u] && has[v];
  }

  void read(const PlyElement& element) {
    const auto all = [&](auto row) {
      for (std::int64_t i = 0; i < element.rows; ++i) {
        rows_->begin(element, i);
        row();
        rows_->end();
      }
    };
    if (element.name == "vertex") {
      for (const PlyProperty& property : element.properties)
        if (role_of(property) == nothing) leave_out(element, property);
      all([&] { vertex(element); });
      return;
    }
    if (element.name == "edge") model_.lines += element.rows;
    const bool faces = element.name == "face", strips = element.name == "tristrips";
    if (!faces && !strips) {
      // Rows of nothing would have no end
      if (!element.properties.empty()) all([&] { skip(element.properties); });
      if (element.name != "edge" && element.rows > 0)
        not_used_.push_back(fmt::format("element {}", called(element.name)));
      return;
    }
    if (element.rows > 0 && std::ranges::none_of(element.properties, is_indices))
      refuse(fmt::format("expected the list vertex_indices of {}, found none", element.name));
    for (const PlyProperty& property : element.properties)
      if (!is_indices(property) && !(faces && is_texcoord(property))) leave_out(element, property);
    all([&] { faces ? face(element) : strip(element); });
  }

  std::string called(std::string_view name) const { return file_.quotable ? shown(name) : "of another name"; }

  /// Remembers what will be told: all colours of an element as one.
  void leave_out(const PlyElement& element, const PlyProperty& property) {
    std::string what = is_colour(property) ? fmt::format("colours of {}", plural(element))
                                           : fmt::format("{} of {}", called(property.name), plural(element));
    if (std::ranges::find(not_used_, what) == not_used_.end()) not_used_.push_back(std::move(what));
  }

  static std::string_view plural(const PlyElement& element) {
    return element.name == "vertex" ? "vertices" : element.name == "face" ? "faces" : "strips";
  }

  /// One remark for all of them.
  void add_notes() {
    if (not_used_.empty()) return;
    constexpr std::size_t told = 8;
    const std::size_t all = not_used_.size();
    not_used_.resize(std::min(all, told));
    const std::string more = all > told ? fmt::format(" and {} more", all - told) : "";
    const bool one = all == 1 && !not_used_.front().starts_with("colours");
    model_.notes.push_back(fmt::format("{}: {}{} {} not used", shown_name(file_.name),
                                       fmt::join(not_used_, ", "), more, one ? "is" : "are"));
  }

  void skip(const PlyProperty& property) {
    const std::int64_t count =
        property.count ? rows_->whole(*property.count, "the length of a list", 0, largest_count) : 1;
    for (std::int64_t i = 0; i < count; ++i) rows_->skip(property.type);
  }
  void skip(const std::vector<PlyProperty>& properties) {
    for (const PlyProperty& property : properties) skip(property);
  }

  void vertex(const PlyElement& element) {
    std::array<double, roles> value{};
    for (std::size_t i = 0; i < roles_.size(); ++i) {
      const PlyProperty& property = element.properties[i];
      const Role role = roles_[i];
      if (role == nothing)
        skip(property);
      else if (nx <= role && role <= nz)
        value[role] = rows_->any_number(property.type, property.name);
      else
        value[role] = rows_->number(property.type, property.name);
    }
    positions_.push_back(places_.number_of({value[x], value[y], value[z]}));
    if (has_textures_) textures_.emplace_back(value[u], value[v]);
    if (!has_normals_) return;
    // Programs write nan where a vertex has no face: such a normal is made
    const dvec3 normal{value[nx], value[ny], value[nz]};
    const auto sound = [](double part) { return std::abs(part) <= Statement::largest; };
    const bool is_one = sound(normal.x) && sound(normal.y) && sound(normal.z);
    model_.mesh.normals.push_back(is_one ? unit_vector(normal) : dvec3{0});
  }

  static bool is_texcoord(const PlyProperty& p) { return p.count && p.name == "texcoord"; }

  int index(const PlyType& type, std::int64_t least = 0) {
    return static_cast<int>(rows_->whole(type, "the number of a vertex", least, vertices_ - 1));
  }

  Corner corner_of(int vertex) const {
    return {vertex, has_textures_ ? vertex : -1, has_normals_ ? vertex : -1};
  }

  void face(const PlyElement& element) {
    std::vector<Corner> corners;
    std::vector<dvec2> textures;
    for (const PlyProperty& property : element.properties) {
      if (is_indices(property)) {
        const auto count = rows_->whole(*property.count, "the number of corners", 1, largest_count);
        for (std::int64_t i = 0; i < count; ++i) corners.push_back(corner_of(index(property.type)));
      } else if (is_texcoord(property)) {
        textures = texcoord(property);
      } else {
        skip(property);
      }
    }
    if (!textures.empty()) lay_on(corners, textures);
    add(corners);
  }

  std::vector<dvec2> texcoord(const PlyProperty& property) {
    const auto count = rows_->whole(*property.count, "the length of texcoord", 0, largest_count);
    std::vector<dvec2> textures;
    for (std::int64_t i = 0; i + 1 < count; i += 2) {
      const double first = rows_->number(property.type, property.name);
      textures.emplace_back(first, rows_->number(property.type, property.name));
    }
    if (count % 2 != 0) rows_->fail(fmt::format("expected texcoord of pairs, found {} numbers", count));
    return textures;
  }

  void lay_on(std::vector<Corner>& corners, const std::vector<dvec2>& textures) {
    if (textures.size() != corners.size())
      rows_->fail(fmt::format("expected texcoord of {} pairs, found {}", corners.size(), textures.size()));
    // Behind those of the vertices, of which there may not be all yet
    const std::int64_t first = has_textures_ ? vertices_ : 0;
    for (std::size_t i = 0; i < corners.size(); ++i)
      corners[i].texture = static_cast<int>(first + std::ssize(wedges_) + static_cast<std::int64_t>(i));
    wedges_.insert(wedges_.end(), textures.begin(), textures.end());
  }

  /// Triangles that share two corners with the next one, turned round every second time; -1 ends a strip.
  void strip(const PlyElement& element) {
    for (const PlyProperty& property : element.properties) {
      if (!is_indices(property)) {
        skip(property);
        continue;
      }
      const auto count = rows_->whole(*property.count, "the length of a strip", 0, largest_count);
      std::vector<int> run;
      for (std::int64_t i = 0; i < count; ++i) {
        const int next = index(property.type, -1);
        if (next < 0)
          run.clear();
        else
          run.push_back(next);
        if (run.size() >= 3) triangle(run);
      }
    }
  }

  void triangle(const std::vector<int>& run) {
    int a = run[run.size() - 3], b = run[run.size() - 2];
    const int c = run.back();
    if (a == b || b == c || a == c) return;  // it leads to the next one
    if (run.size() % 2 == 0) std::swap(a, b);
    add({corner_of(a), corner_of(b), corner_of(c)});
  }

  void add(const std::vector<Corner>& corners) {
    if (corners.size() < 3)
      (corners.size() == 2 ? model_.lines : model_.points) += 1;
    else
      add_face(model_.mesh, corners, material_, 0, rows_->line());
  }

  const TextFile& file_;
  PlyHeader header_;
  std::unique_ptr<PlyRows> rows_;
  ModelFile model_;
  Places places_{model_.mesh};
  std::vector<Role> roles_;      ///< of a vertex's properties
  std::vector<int> positions_;   ///< of each vertex
  std::vector<dvec2> textures_;  ///< of each vertex
  std::vector<dvec2> wedges_;    ///< of single corners, numbered behind those
  std::int64_t vertices_ = -1;
  int material_ = 0;
  bool has_normals_ = false, has_textures_ = false;
  std::vector<std::string> not_used_;
};

}  // namespace

ModelFile parse_ply(std::string_view bytes, const TextFile& file) { return PlyReader(bytes, file).read(); }

}  // namespace gradus::pipeline
