#pragma once
// A BSP tree as it grows: the polygons in space, the plane at hand seen edge-on, and the tree.

#include <functional>
#include <map>

#include "core/arithmetic/elementary.hpp"
#include "stories/visibility/faces_picture.hpp"
#include "visibility/bsp_tree/bsp_tree.hpp"

namespace gradus::bsp_tree {

using DPolygon = Polygon<double>;
using DTree = Tree<double>;

inline constexpr int paper_width = 36, paper_height = 24;

/// Whether both are the same part of the same face: another face may lie in the same place.
inline bool same(const DPolygon& a, const DPolygon& b) { return a.face == b.face && a.corners == b.corners; }
inline auto same_as(const DPolygon& polygon) {
  return [&polygon](const DPolygon& other) { return same(other, polygon); };
}

/// What a run is about: polygons, which are parts of the faces given.
struct Polygons {
  std::vector<faces_subject::NamedPart> parts;
  std::vector<DPolygon> polygons{};
  std::vector<dvec3> points{};  ///< all corners
};
inline Polygons polygons_of(const Arguments& arguments) {
  Polygons all{faces_subject::parts_of(faces_subject::faces_of(arguments))};
  for (std::size_t i = 0; i < all.parts.size(); ++i) {
    const Ring& ring = all.parts[i].ring;
    all.polygons.push_back({ring, i});
    all.points.insert(all.points.end(), ring.begin(), ring.end());
  }
  return all;
}

/// What the polygons are called. Parts are told by their face and their corners, which are just those that
/// were reported.
class PartNames {
 public:
  explicit PartNames(const std::vector<faces_subject::NamedPart>& parts) {
    for (std::size_t i = 0; i < parts.size(); ++i) names_[text_of(parts[i].ring, i)] = parts[i].name;
  }
  const std::string& operator()(const DPolygon& polygon) const { return names_.at(text_of(polygon)); }
  /// The parts of one that was cut.
  void cut(const DPolygon& whole, const DPolygon& in_front, const DPolygon& behind) {
    const std::string name = (*this)(whole);
    names_[text_of(in_front)] = faces_subject::part_name(name, 0);
    names_[text_of(behind)] = faces_subject::part_name(name, 1);
  }

 private:
  static std::string text_of(const DPolygon& polygon) { return text_of(polygon.corners, polygon.face); }
  static std::string text_of(const std::vector<dvec3>& ring, std::size_t face) {
    std::string text = fmt::format("{};", face);
    for (const dvec3 p : ring) text += fmt::format("{},{},{};", p.x, p.y, p.z);
    return text;
  }
  std::map<std::string, std::string> names_;
};

// --- The tree

/// Where each node of a whole tree stands: what lies behind to the left, what lies in front to the right.
class TreeDrawing {
 public:
  TreeDrawing(const DTree& tree, const Extent& place) : at_(tree.size()) {
    std::size_t rank = 0, deepest = 0;
    std::vector<std::size_t> ranks(tree.size()), depths(tree.size());
    const std::function<void(std::size_t, std::size_t)> walk = [&](std::size_t node, std::size_t depth) {
      if (node == none) return;
      walk(tree[node].behind, depth + 1);
      if (tree[node].behind == none) leaves_.emplace_back(node, false);
      ranks[node] = rank++;
      depths[node] = depth;
      deepest = std::max(deepest, depth);
      walk(tree[node].in_front, depth + 1);
      if (tree[node].in_front == none) leaves_.emplace_back(node, true);
    };
    if (!tree.empty()) walk(0, 0);
    const double across =
        (place.size().x - 2 * radius) / static_cast<double>(std::max<std::size_t>(rank, 2) - 1);
    const double down =
        std::min(6.0, (place.size().y - 2 * radius) / static_cast<double>(std::max<std::size_t>(deepest, 1)));
    // Neighbours of one depth are two ranks apart
    left_ = place.lower.x;
    right_ = place.upper.x;
    widest_ = std::max(0.95 * across, 0.5);
    height_ = std::min(radius, 0.36 * down);
    to_leaf_ = {std::min(0.5 * across, 1.5), std::min(0.65 * down, 3.0)};
    for (std::size_t i = 0; i < tree.size(); ++i) {
      const double x =
          rank == 1 ? place.centre().x : place.lower.x + radius + across * static_cast<double>(ranks[i]);
      at_[i] = {x, place.upper.y - radius - down * static_cast<double>(depths[i])};
    }
  }

  /// A node with its text, as wide as that.
  void add_node(View& view, std::size_t node, Role role, const std::string& text) const {
    constexpr int corners = 28;
    Ring2 circle;
    for (int i = 0; i < corners; ++i) {
      const double turn = 2 * 3.14159265358979 * i / corners;
      circle.push_back(at_[node] + half_size(text) * dvec2{gradus::cos(turn), gradus::sin(turn)});
    }
    const std::string id = fmt::format("t node {:02}", node);
    add_ring(view, id, role, circle);
    view.add({id + " text", role, Text{at_[node], text}});
  }
  /// The names of what will be below a branch.
  void add_waiting(View& view, std::size_t node, Role role, const std::vector<std::string>& names) const {
    constexpr std::size_t most = 3;
    std::string text = fmt::format("{}", fmt::join(names | std::views::take(most), ", "));
    if (names.size() > most) text += ", …";
    const double half = 0.3 * static_cast<double>(text.size());
    const double x = std::clamp(at_[node].x, left_ + half, std::max(right_ - half, left_ + half));
    view.add({fmt::format("t node {:02} text", node), role, Text{{x, at_[node].y}, text}});
  }
  /// The branch from a node to its parent, "+" where it leads in front of the parent's plane.
  void add_branch(View& view, std::size_t parent, std::size_t node, bool in_front, Role role) const {
    const dvec2 from = at_[parent], to = at_[node], way = (to - from) / glm::length(to - from);
    view.add({fmt::format("s branch {:02}", node), role, Stroke{from + height_ * way, to - height_ * way}});
    const dvec2 aside = in_front ? dvec2{1.35, 0.45} : dvec2{-1.35, 0.45};
    view.add({fmt::format("s side {:02}", node), Role::guide,
              Text{0.5 * (from + to) + aside, in_front ? "+" : "−"}});
  }

  /// The regions that are parted no more, from left to right: the node above, and on which side of it.
  const std::vector<std::pair<std::size_t, bool>>& leaves() const { return leaves_; }
  /// A leaf with the name of its region, where leaves have room.
  void add_leaf(View& view, std::size_t leaf, Role role, const std::string& name) const {
    const auto& [node, in_front] = leaves_[leaf];
    if (to_leaf_.x < 0.7) return;
    const dvec2 from = at_[node], to = from + dvec2{in_front ? to_leaf_.x : -to_leaf_.x, -to_leaf_.y};
    const dvec2 way = glm::normalize(to - from), half(std::min(0.8, 0.8 * to_leaf_.x));
    const std::string id = fmt::format("t leaf {:02}", leaf);
    view.add({id + " branch", role, Stroke{from + height_ * way, to - 0.8 * way}});
    add_ring(view, id, role, Extent{to - half, to + half}.corners());
    view.add({id + " name", role, Text{to, name}});
  }

  /// Its turn in the order, beside a node.
  void add_number(View& view, std::size_t node, std::size_t number) const {
    view.add({fmt::format("t node {:02} turn", node), Role::result,
              Text{at_[node] + dvec2{0, -height_ - 1.1}, fmt::format("{}.", number)}});
  }

  static constexpr double radius = 1.4;

 private:
  dvec2 half_size(const std::string& text) const {
    return {std::clamp(0.5 * static_cast<double>(text.size()) + 0.85, height_, std::max(widest_, height_)),
            height_};
  }

  std::vector<dvec2> at_;
  std::vector<std::pair<std::size_t, bool>> leaves_;
  dvec2 to_leaf_{};
  double left_ = 0, right_ = 0, widest_ = radius, height_ = radius;
};

// --- The plane at hand, edge-on

/// Polygons seen along a plane: it is a straight line, above which is what lies in front of it.
class EdgeOnPicture {
 public:
  EdgeOnPicture(const Extent& place, const Plane<double>& plane, const faces_subject::Reader& reader,
                const std::vector<DPolygon>& polygons)
      : place_(place),
        origin_(plane.a),
        normal_(unit_vector(glm::cross(plane.b - plane.a, plane.c - plane.a))) {
    // Along the reader's right as far as it runs in the plane, so that both pictures are read alike
    const dvec3 right = reader.right - glm::dot(reader.right, normal_) * normal_;
    const dvec3 up = reader.up - glm::dot(reader.up, normal_) * normal_;
    along_ = unit_vector(glm::length(right) > 0.3 ? right : up);
    Extent extent;
    for (const DPolygon& polygon : polygons) {
      for (const dvec3 p : polygon.corners) extent.add(flat(p));
    }
    // The line in the middle; heights are stretched, for only their signs count
    const double half = std::max({extent.upper.y, -extent.lower.y, 0.05 * extent.size().x, 1e-9});
    extent.add({extent.centre().x, 1.1 * half});
    extent.add({extent.centre().x, -1.1 * half});
    panel_ = Panel(place, extent, Panel::Fit::stretched);
  }

  /// The plane with the name of its polygon, and the signs of its sides.
  void add_plane(View& view, const std::string& name) const {
    const double y = panel_.at({0, 0}).y, left = place_.lower.x - 0.8;
    view.add({"e plane", Role::boundary, Stroke{{place_.lower.x, y}, {place_.upper.x, y}}});
    view.add({"e plane name", Role::boundary, Label{{place_.upper.x - 0.6, y}, name}});
    view.add({"e front", Role::guide, Text{{left, 0.5 * (y + place_.upper.y)}, "+"}});
    view.add({"e behind", Role::guide, Text{{left, 0.5 * (y + place_.lower.y)}, "−"}});
  }
  void add_polygon(View& view, const DPolygon& polygon, Role role, const std::string& name,
                   bool corners) const {
    const Ring2 ring = mapped(polygon.corners, [&](dvec3 p) { return panel_.at(flat(p)); });
    add_ring(view, "f " + name, role, ring);
    for (std::size_t i = 0; corners && i < ring.size(); ++i)
      view.add({fmt::format("g {} corner {:02}", name, i), role, Dot{ring[i]}});
    view.add({"h " + name, role, Label{middle_of(ring), name}});
  }
  /// Where a cut goes through.
  void add_cut(View& view, dvec3 a, dvec3 b) const {
    view.add({"g cut a", Role::measure, Dot{panel_.at(flat(a))}});
    view.add({"g cut b", Role::measure, Dot{panel_.at(flat(b))}});
  }

 private:
  dvec2 flat(dvec3 p) const { return {glm::dot(p - origin_, along_), glm::dot(p - origin_, normal_)}; }

  Extent place_;
  dvec3 origin_, normal_, along_{};
  Panel panel_{{{0, 0}, {1, 1}}, {{0, 0}, {1, 1}}};
};

}  // namespace gradus::bsp_tree
