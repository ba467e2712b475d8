#pragma once
// What all stories of point trees draw: points with their lines in the plane, and the tree beside them.

#include <bit>

#include "core/arithmetic/elementary.hpp"
#include "modeling/kd_tree/kd_tree.hpp"
#include "stories/telling.hpp"

namespace gradus::kd_tree {

using PlaneTree = Tree<2, double>;
using PlaneCell = Cell<2, double>;

constexpr int paper_width = 36, paper_height = 24;
constexpr Extent beside_tree{{1.6, 1.8}, {19.6, 23.4}}, of_tree{{20.9, 3}, {35.2, 23}},
    whole_paper{{3, 1.8}, {33, 23.4}};

/// What a run is about. Its tree refers to its points.
struct Subject {
  std::vector<dvec2> points;
  dvec2 query;
  std::size_t k;
  PlaneTree tree;
};

/// What a point is called.
inline std::string name_of(Index point) { return letter(point); }

/// A role for each point.
using Roles = std::vector<Role>;

/// Points, lines, cells and circles in the plane.
class PlaneDrawing {
 public:
  PlaneDrawing(const Subject& subject, const Extent& place, bool with_query)
      : subject_(subject), panel_(place, {}) {
    for (const dvec2 p : subject.points) held_.add(p);
    if (with_query) held_.add(subject.query);
    panel_ = Panel(place, widened(held_, 0.02));
  }

  const Panel& panel() const { return panel_; }
  dvec2 at(dvec2 p) const { return panel_.at(p); }
  std::vector<dvec2> corners_of(const PlaneCell& cell) const {
    return panel_.at(Extent{cell.box.lower, cell.box.upper}.corners());
  }

  void add_points(View& view, const Roles& roles) const {
    for (Index i = 0; i < roles.size(); ++i)
      view.add_named(fmt::format("p {:02}", i), roles[i], at(subject_.points[i]), name_of(i));
  }
  void add_query(View& view, const std::string& symbol) const {
    view.add_named("q", Role::measure, at(subject_.query), symbol);
  }
  /// The line through a cell's middle point, as far as the cell goes.
  void add_line(View& view, const PlaneCell& cell, Role role) const {
    const Index m = cell.middle();
    const int axis = subject_.tree.nodes[m].axis;
    dvec2 from = cell.box.lower, to = cell.box.upper;
    from[axis] = to[axis] = subject_.tree.at(m)[axis];
    view.add(
        {fmt::format("l {:02}", m), role, Stroke{at(from), at(to), false, false, role == Role::boundary}});
  }
  void add_cell(View& view, const std::string& id, const PlaneCell& cell, Role role, bool outlined) const {
    view.add({id + " inside", role, Area{{corners_of(cell)}, role == Role::rejected ? 0 : 1}});
    if (outlined) view.add({id, role, Path{corners_of(cell), true}});
  }
  /// The box of all points, and scales along it.
  void add_border(View& view) const {
    view.add({"k border", Role::boundary, Path{corners_of(subject_.tree.whole()), true}});
    add_axes(view, panel_, "x");
  }
  void add_scales(View& view) const { add_axes(view, panel_, "x"); }
  /// A circle round q; in the tree's box as far as that goes.
  void add_circle(View& view, double radius, bool in_box) const {
    const Extent frame = in_box ? held_ : panel_.shown();
    constexpr int pieces = 360;
    std::vector<dvec2> arc;
    int arcs = 0;
    const auto end_arc = [&] {
      if (arc.size() > 1) view.add({fmt::format("m circle {:02}", arcs++), Role::result, Path{arc}});
      arc.clear();
    };
    for (int i = 0; i <= pieces; ++i) {
      const double turn = 2 * 3.14159265358979 * i / pieces;
      const dvec2 place = subject_.query + radius * dvec2{gradus::cos(turn), gradus::sin(turn)};
      if (frame.holds(place))
        arc.push_back(at(place));
      else
        end_arc();
    }
    end_arc();
  }
  void add_ray(View& view, Index point, Role role) const {
    view.add({fmt::format("g ray {:02}", point), role,
              Stroke{at(subject_.query), at(subject_.points[point]), false, false, true}});
  }
  /// From q to a place, with how far that is.
  void add_distance(View& view, dvec2 to) const {
    if (to == subject_.query) return;
    const dvec2 a = at(subject_.query), b = at(to);
    view.add({"n way", Role::measure, Stroke{a, b, true}});
    view.add({"n way length", Role::measure,
              Label{0.5 * (a + b), figure_real(length_between(to, subject_.query))}});
  }

 private:
  const Subject& subject_;
  Extent held_{};
  Panel panel_;
};

/// The nodes from left to right as they stand in their array, each below its parent.
class TreeDrawing {
 public:
  explicit TreeDrawing(const Subject& subject) : subject_(subject) {
    const Index count = static_cast<Index>(subject.tree.nodes.size());
    const Index levels = static_cast<Index>(std::bit_width(count));
    across_ = (of_tree.size().x - 2 * radius) / std::max(count - 1.0, 1.0);
    down_ = std::min(4.6, (of_tree.size().y - 2 * radius) / std::max(levels - 1.0, 1.0));
    at_.resize(count);
    parents_.resize(count, none);
    place(subject.tree.whole(), 0);
  }

  /// roles: of each node. Those that are still to come are small, while a tree is built also those of a cell.
  void add(View& view, const Roles& roles, bool building) const {
    const auto reach = [&](Index node) { return has_letter(roles[node], building) ? radius : small; };
    for (Index node = 0; node < at_.size(); ++node) {
      add_node(view, node, roles[node], building);
      if (parents_[node] == none) continue;
      const dvec2 from = at_[parents_[node]], to = at_[node], way = (to - from) / glm::length(to - from);
      view.add({fmt::format("s branch {:02}", node), roles[node],
                Stroke{from + reach(parents_[node]) * way, to - reach(node) * way, false, false, true}});
    }
  }
  /// Lines of text below the tree.
  void add_texts(View& view, const std::vector<std::string>& texts) const {
    for (std::size_t i = 0; i < texts.size(); ++i)
      view.add({fmt::format("u text {}", i), Role::guide,
                Text{{of_tree.lower.x, 2.6}, texts[i], Align::left, false, static_cast<int>(i)}});
  }
  /// The points of a cell as they follow each other along the axis that parts it, below the tree.
  void add_order(View& view, const PlaneCell& cell, const std::string& caption) const {
    const auto& nodes = subject_.tree.nodes;
    const int axis = nodes[cell.middle()].axis;
    std::vector<Index> order;
    for (Index node = cell.first; node < cell.last; ++node) order.push_back(nodes[node].point);
    std::ranges::sort(order, {}, [&](Index i) { return std::pair(subject_.points[i][axis], i); });
    if (order.size() > most_named) return;
    const Extent& place = of_tree;
    add_texts(view, {caption});
    const double apart = std::min(1.6, place.size().x / static_cast<double>(order.size()));
    for (std::size_t i = 0; i < order.size(); ++i) {
      const std::size_t m = cell.middle() - cell.first;
      const Role role = i < m ? Role::accepted : i == m ? Role::current : Role::candidate;
      view.add({fmt::format("u order {:02}", i), role,
                Text{{place.lower.x + apart * (static_cast<double>(i) + 0.5), 1}, name_of(order[i])}});
    }
  }

 private:
  static constexpr double radius = 1;
  /// With more there is no room for letters.
  static constexpr std::size_t most_named = 16;

  static constexpr double small = 0.3;

  /// In the colours of a step that was made.
  static bool is_done(Role role) {
    return role == Role::past || role == Role::current || role == Role::result;
  }
  bool has_letter(Role role, bool building) const {
    return at_.size() <= most_named && role != Role::guide && (is_done(role) || !building);
  }

  void place(const PlaneCell& cell, int depth) {
    if (cell.empty()) return;
    const Index m = cell.middle();
    at_[m] = {of_tree.lower.x + radius + across_ * m, of_tree.upper.y - radius - down_ * depth};
    parents_[m] = cell.parent;
    place(below(subject_.tree, cell), depth + 1);
    place(above(subject_.tree, cell), depth + 1);
  }
  void add_node(View& view, Index node, Role role, bool building) const {
    const std::string id = fmt::format("t node {:02}", node);
    if (!has_letter(role, building)) return view.add({id, role, Dot{at_[node], !is_done(role)}});
    view.add({id + " name", role, Text{at_[node], name_of(subject_.tree.nodes[node].point)}});
    constexpr int corners = 28;
    std::vector<dvec2> circle;
    for (int i = 0; i < corners; ++i) {
      const double turn = 2 * 3.14159265358979 * i / corners;
      circle.push_back(at_[node] + radius * dvec2{gradus::cos(turn), gradus::sin(turn)});
    }
    view.add({id + " inside", role, Area{{circle}, role == Role::rejected ? 0 : 1}});
    view.add({id, role, Path{circle, true}});
  }

  const Subject& subject_;
  double across_ = 1, down_ = 1;
  std::vector<dvec2> at_{};
  std::vector<Index> parents_{};
};

}  // namespace gradus::kd_tree
